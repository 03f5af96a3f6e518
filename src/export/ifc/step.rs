//! STEP physical files (ISO 10303-21): entities numbered in the order in which they are added.

use std::collections::BTreeMap;
use std::fmt::Write;

use super::record::{Id, Record, push_text};

/// What stands above the entities.
#[derive(Clone, Debug, PartialEq)]
pub struct Header<'a> {
    /// Name of the file.
    pub name: &'a str,
    /// ISO 8601 time.
    pub time: &'a str,
    /// What the file holds.
    pub description: &'a str,
    /// Program that wrote it.
    pub program: &'a str,
    /// Schema, such as `IFC4`.
    pub schema: &'a str,
}

/// The entities of a file.
#[derive(Clone, Debug, Default)]
pub struct Step {
    data: String,
    count: u32,
    shared: BTreeMap<String, Id>,
    broken: Option<String>,
}

impl Step {
    /// Adds an entity.
    pub fn add(&mut self, record: Record) -> Id {
        if record.broken && self.broken.is_none() {
            self.broken = Some(record.text.chars().take(60).collect());
        }
        self.count += 1;
        let _ = writeln!(self.data, "#{}={});", self.count, record.text);
        Id(self.count)
    }

    /// Adds an entity that others may refer to as well: one of equal text is there once.
    pub fn share(&mut self, record: Record) -> Id {
        if let Some(id) = self.shared.get(&record.text) {
            return *id;
        }
        let text = record.text.clone();
        let id = self.add(record);
        self.shared.insert(text, id);
        id
    }

    /// The file.
    ///
    /// # Errors
    /// The beginning of the first entity that holds an infinite number or none.
    pub fn finish(self, header: &Header) -> Result<Vec<u8>, String> {
        if let Some(broken) = self.broken {
            return Err(broken);
        }
        let texts = |list: &[&str]| {
            let mut out = String::from("(");
            for (n, text) in list.iter().enumerate() {
                out.push_str(if n > 0 { "," } else { "" });
                push_text(&mut out, text);
            }
            out + ")"
        };
        let name = Record::new("FILE_NAME").text(header.name).text(header.time).raw("('')").raw("('')");
        let name = name.text(header.program).text(header.program).text("").text;
        let out = format!(
            "ISO-10303-21;\nHEADER;\nFILE_DESCRIPTION({},'2;1');\n{name});\nFILE_SCHEMA({});\nENDSEC;\nDATA;\n{}ENDSEC;\nEND-ISO-10303-21;\n",
            texts(&[header.description]),
            texts(&[header.schema]),
            self.data
        );
        Ok(out.into_bytes())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn equal_entities_are_shared_and_broken_ones_found() {
        let mut step = Step::default();
        let point = || Record::new("IFCDIRECTION").reals(&[0.0, 0.0, 1.0]);
        assert_eq!(step.share(point()), step.share(point()));
        assert_ne!(step.add(point()), step.add(point()));
        step.add(Record::new("IFCREAL").real(f64::NAN));
        let header = Header { name: "n", time: "t", description: "d", program: "p", schema: "IFC4" };
        assert!(step.finish(&header).is_err_and(|e| e.starts_with("IFCREAL")));
    }
}
