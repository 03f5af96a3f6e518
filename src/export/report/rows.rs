//! Tables of a run folder read back: RFC 4180 CSV with a header.

use super::ReportError;

/// A table as text cells.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Rows {
    /// Name of the file, for messages.
    file: String,
    /// Names of the columns.
    pub header: Vec<String>,
    /// Cells row by row, each row as long as the header.
    cells: Vec<String>,
}

impl Rows {
    /// Reads a table.
    ///
    /// # Errors
    /// [`ReportError::Table`]: text that is not UTF-8, a quote that is not closed, or a row whose length differs from the header's.
    pub fn read(file: &str, bytes: &[u8]) -> Result<Rows, ReportError> {
        let wrong = |line: usize, found: String, expected: &str| ReportError::Table {
            file: file.to_owned(),
            line,
            found,
            expected: expected.to_owned(),
        };
        let text = std::str::from_utf8(bytes).map_err(|e| wrong(1, e.to_string(), "UTF-8 text"))?;
        let text = text.strip_prefix('\u{feff}').unwrap_or(text);
        let mut table = Rows { file: file.to_owned(), ..Rows::default() };
        let mut row: Vec<String> = Vec::new();
        let (mut cell, mut quoted, mut line) = (String::new(), false, 1);
        let mut letters = text.chars().peekable();
        loop {
            let Some(letter) = letters.next() else {
                if quoted {
                    return Err(wrong(line, "a quote that is not closed".into(), "a closing \""));
                }
                if !(row.is_empty() && cell.is_empty()) {
                    row.push(cell);
                    table.push(row, line)?;
                }
                return Ok(table);
            };
            match letter {
                '"' if quoted && letters.peek() == Some(&'"') => {
                    letters.next();
                    cell.push('"');
                }
                '"' if quoted || cell.is_empty() => quoted = !quoted,
                ',' if !quoted => row.push(std::mem::take(&mut cell)),
                '\r' if !quoted && letters.peek() == Some(&'\n') => {}
                '\n' if !quoted => {
                    row.push(std::mem::take(&mut cell));
                    table.push(std::mem::take(&mut row), line)?;
                    line += 1;
                }
                other => {
                    line += usize::from(other == '\n');
                    cell.push(other);
                }
            }
        }
    }

    fn push(&mut self, row: Vec<String>, line: usize) -> Result<(), ReportError> {
        if self.header.is_empty() {
            self.header = row;
            return Ok(());
        }
        if row.len() != self.header.len() {
            return Err(ReportError::Table {
                file: self.file.clone(),
                line,
                found: format!("{} cells", row.len()),
                expected: format!("{}, as the header has", self.header.len()),
            });
        }
        self.cells.extend(row);
        Ok(())
    }

    /// Number of rows below the header.
    pub fn count(&self) -> usize {
        self.cells.len() / self.header.len().max(1)
    }

    /// Place of a column.
    pub fn column(&self, name: &str) -> Option<usize> {
        self.header.iter().position(|h| h == name)
    }

    /// A cell; empty outside.
    pub fn cell(&self, row: usize, column: usize) -> &str {
        self.cells
            .get(row * self.header.len() + column)
            .filter(|_| column < self.header.len())
            .map_or("", String::as_str)
    }

    /// A cell by the name of its column; empty where there is none.
    pub fn text(&self, row: usize, name: &str) -> &str {
        self.column(name).map_or("", |column| self.cell(row, column))
    }

    /// A cell as a number; `None` where it is empty or no number.
    pub fn number(&self, row: usize, name: &str) -> Option<f64> {
        self.text(row, name).parse().ok().filter(|v: &f64| v.is_finite())
    }

    /// The column `id` as whole numbers.
    ///
    /// # Errors
    /// [`ReportError::Table`] with the first row whose id is none.
    pub fn ids(&self) -> Result<Vec<u64>, ReportError> {
        let one = |row: usize| {
            let text = self.text(row, "id");
            text.parse().map_err(|_| ReportError::Table {
                file: self.file.clone(),
                line: row + 2,
                found: format!("id '{text}'"),
                expected: "the number of an evaluation".into(),
            })
        };
        (0..self.count()).map(one).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_written_reads_back() {
        let text = "id,name\r\n1,\"a, \"\"b\"\"\nc\"\n2,\n";
        let rows = Rows::read("t.csv", text.as_bytes()).unwrap();
        assert_eq!((rows.count(), rows.ids().unwrap()), (2, vec![1, 2]));
        assert_eq!((rows.text(0, "name"), rows.text(1, "name"), rows.text(0, "none")), ("a, \"b\"\nc", "", ""));
    }

    #[test]
    fn what_is_wrong_is_named() {
        let error = |text: &[u8]| Rows::read("t.csv", text).unwrap_err().to_string();
        assert_eq!(error(b"id,a\n1\n"), "t.csv, line 2: 1 cells; expected 2, as the header has");
        assert!(error(b"id\n\"1\n").contains("not closed"));
        assert!(error(b"id\n\xff\n").contains("UTF-8"));
        let rows = Rows::read("t.csv", b"id\nx\n").unwrap();
        assert_eq!(rows.ids().unwrap_err().to_string(), "t.csv, line 2: id 'x'; expected the number of an evaluation");
    }
}
