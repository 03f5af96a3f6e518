//! One entity of a STEP file as text: attributes in the order of the schema.

use std::fmt::Write;

/// Number of an entity in its file.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Id(pub(super) u32);

/// A value whose type is written with it, as a SELECT asks.
#[derive(Clone, Debug, PartialEq)]
pub enum Value {
    /// A text type, such as `IFCLABEL`.
    Text(&'static str, String),
    /// A number type, such as `IFCAREAMEASURE`.
    Real(&'static str, f64),
    /// A whole number type, such as `IFCINTEGER`.
    Count(&'static str, i64),
    /// `IFCBOOLEAN`.
    Flag(bool),
}

/// One entity while its attributes are written, in the order of the schema.
#[derive(Clone, Debug)]
pub struct Record {
    pub(super) text: String,
    /// Whether a number was infinite or none: such an entity has no STEP text.
    pub(super) broken: bool,
}

impl Record {
    /// Begins an entity; `name` in capitals.
    pub fn new(name: &str) -> Record {
        Record { text: format!("{name}("), broken: false }
    }

    fn begin(&mut self) {
        if !self.text.ends_with('(') {
            self.text.push(',');
        }
    }

    /// A token as it stands in the file.
    pub(super) fn raw(mut self, token: &str) -> Record {
        self.begin();
        self.text.push_str(token);
        self
    }

    /// An attribute without value.
    pub fn none(self) -> Record {
        self.raw("$")
    }

    /// An attribute that follows from others.
    pub fn derived(self) -> Record {
        self.raw("*")
    }

    /// So many attributes without value.
    pub fn nones(self, count: usize) -> Record {
        (0..count).fold(self, |record, _| record.none())
    }

    /// A text.
    pub fn text(mut self, text: &str) -> Record {
        self.begin();
        push_text(&mut self.text, text);
        self
    }

    /// A text, or none.
    pub fn maybe_text(self, text: Option<&str>) -> Record {
        match text {
            Some(text) => self.text(text),
            None => self.none(),
        }
    }

    /// An item of an enumeration, without dots.
    pub fn word(self, word: &str) -> Record {
        self.raw(&format!(".{word}."))
    }

    /// True or false.
    pub fn flag(self, flag: bool) -> Record {
        self.word(if flag { "T" } else { "F" })
    }

    /// A whole number.
    pub fn int(self, number: i64) -> Record {
        self.raw(&number.to_string())
    }

    /// A real number.
    pub fn real(mut self, number: f64) -> Record {
        self.begin();
        self.push_real(number);
        self
    }

    /// A real number, or none.
    pub fn maybe_real(self, number: Option<f64>) -> Record {
        match number {
            Some(number) => self.real(number),
            None => self.none(),
        }
    }

    /// Real numbers as a list.
    pub fn reals(mut self, numbers: &[f64]) -> Record {
        self.begin();
        self.push_reals(numbers);
        self
    }

    /// Points as a list of lists.
    pub fn points(mut self, points: &[[f64; 3]]) -> Record {
        self.begin();
        self.text.push('(');
        for (n, point) in points.iter().enumerate() {
            if n > 0 {
                self.text.push(',');
            }
            self.push_reals(point);
        }
        self.text.push(')');
        self
    }

    /// Triangles as a list of lists; indices count from 1 in the file.
    pub fn triangles(mut self, triangles: &[[u32; 3]]) -> Record {
        self.begin();
        self.text.push('(');
        for (n, t) in triangles.iter().enumerate() {
            let comma = if n > 0 { "," } else { "" };
            let _ = write!(self.text, "{comma}({},{},{})", t[0] + 1, t[1] + 1, t[2] + 1);
        }
        self.text.push(')');
        self
    }

    /// Another entity.
    pub fn id(self, id: Id) -> Record {
        self.raw(&format!("#{}", id.0))
    }

    /// Another entity, or none.
    pub fn maybe_id(self, id: Option<Id>) -> Record {
        match id {
            Some(id) => self.id(id),
            None => self.none(),
        }
    }

    /// Other entities as a list or set.
    pub fn ids(mut self, ids: &[Id]) -> Record {
        self.begin();
        self.text.push('(');
        for (n, id) in ids.iter().enumerate() {
            let comma = if n > 0 { "," } else { "" };
            let _ = write!(self.text, "{comma}#{}", id.0);
        }
        self.text.push(')');
        self
    }

    /// A value with its type.
    pub fn value(mut self, value: &Value) -> Record {
        self.begin();
        match value {
            Value::Text(name, text) => {
                let _ = write!(self.text, "{name}(");
                push_text(&mut self.text, text);
            }
            Value::Real(name, number) => {
                let _ = write!(self.text, "{name}(");
                self.push_real(*number);
            }
            Value::Count(name, number) => {
                let _ = write!(self.text, "{name}({number}");
            }
            Value::Flag(flag) => {
                let _ = write!(self.text, "IFCBOOLEAN(.{}.", if *flag { "T" } else { "F" });
            }
        }
        self.text.push(')');
        self
    }

    fn push_reals(&mut self, numbers: &[f64]) {
        self.text.push('(');
        for (n, number) in numbers.iter().enumerate() {
            if n > 0 {
                self.text.push(',');
            }
            self.push_real(*number);
        }
        self.text.push(')');
    }

    /// The shortest digits that read back as the same number, with the point that STEP asks for.
    fn push_real(&mut self, number: f64) {
        self.broken |= !number.is_finite();
        // No sign on zero.
        let digits = format!("{:?}", number + 0.0);
        let (mantissa, exponent) = digits.split_once('e').map_or((digits.as_str(), None), |(m, e)| (m, Some(e)));
        self.text.push_str(mantissa.strip_suffix('0').filter(|m| m.ends_with('.')).unwrap_or(mantissa));
        if !mantissa.contains('.') {
            self.text.push('.');
        }
        if let Some(exponent) = exponent {
            let _ = write!(self.text, "E{exponent}");
        }
    }
}

/// A text in quotes: printable ASCII as it is, quotes and backslashes doubled, all else as `\X2\` (UTF-16 of the basic plane) or `\X4\`.
pub(super) fn push_text(out: &mut String, text: &str) {
    out.push('\'');
    let mut open = None;
    for c in text.chars() {
        let wide = match u32::from(c) {
            0x20..=0x7e => None,
            0..=0xffff => Some(2),
            _ => Some(4),
        };
        if wide != open {
            if open.is_some() {
                out.push_str("\\X0\\");
            }
            if let Some(width) = wide {
                let _ = write!(out, "\\X{width}\\");
            }
            open = wide;
        }
        match (wide, c) {
            (Some(2), _) => _ = write!(out, "{:04X}", u32::from(c)),
            (Some(_), _) => _ = write!(out, "{:08X}", u32::from(c)),
            (None, '\'') => out.push_str("''"),
            (None, '\\') => out.push_str("\\\\"),
            (None, _) => out.push(c),
        }
    }
    if open.is_some() {
        out.push_str("\\X0\\");
    }
    out.push('\'');
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Examples of ISO 10303-21, 6.4.3: real numbers have a point and a capital E.
    #[test]
    fn numbers_have_a_point() {
        let text = |v: f64| Record::new("A").real(v).text;
        for (v, expected) in [
            (0.0, "A(0."),
            (-0.0, "A(0."),
            (1.0, "A(1."),
            (10.0, "A(10."),
            (-0.45, "A(-0.45"),
            (1e-7, "A(1.E-7"),
            (2.5e-9, "A(2.5E-9"),
            (1e21, "A(1.E21"),
        ] {
            assert_eq!(text(v), expected);
        }
    }

    /// ISO 10303-21, 6.4.3.3: doubled quotes and backslashes, `\X2\` for the basic plane, `\X4\` beyond.
    #[test]
    fn texts_are_encoded() {
        let text = |t: &str| Record::new("A").text(t).text;
        assert_eq!(text("it's 1\\2"), "A('it''s 1\\\\2'");
        assert_eq!(text("m² über"), "A('m\\X2\\00B2\\X0\\ \\X2\\00FC\\X0\\ber'");
        assert_eq!(text("é\u{1F3E0}!"), "A('\\X2\\00E9\\X0\\\\X4\\0001F3E0\\X0\\!'");
        assert_eq!(text("a\nb"), "A('a\\X2\\000A\\X0\\b'");
    }
}
