//! Writes lattice CSV in the style in which it was read.

use super::number::spell;
use super::{Lattice, Values, cell_of_row};

/// The bytes of a lattice. A lattice that was read and not changed gives the same bytes; a changed value is spelled anew.
pub fn write_lattice(lattice: &Lattice) -> Vec<u8> {
    let style = &lattice.style;
    let mut lines = Lines { text: String::new(), endings: &style.endings, run: 0, used: 0 };
    if style.metadata {
        lines.push("minbound,shape,unit");
        for a in 0..3 {
            let numbers = [lattice.minbound[a], lattice.shape[a] as f64, lattice.unit[a]];
            let cells: Vec<String> = (0..3).map(|c| spelled(numbers[c], &style.spelled_meta, 3 * a + c)).collect();
            lines.push(&cells.join(","));
        }
        lines.push("");
    }
    lines.push(&format!("IX,IY,IZ,{}", style.value_column));
    let [nx, ny, _] = lattice.shape;
    let mut spellings = style.spelled.as_slice();
    for n in 0..lattice.shape.iter().product() {
        let cell @ [x, y, z] = cell_of_row(n, lattice.shape, style.order);
        let at = cell[0] + nx * (cell[1] + ny * cell[2]);
        let value = match &lattice.values {
            Values::Bool(v) => (if v[at] { "True" } else { "False" }).to_string(),
            Values::Number(v) => spelled(v[at], &spellings[..spellings.len().min(1)], n),
        };
        if spellings.first().is_some_and(|(m, _)| *m == n) {
            spellings = &spellings[1..];
        }
        lines.push(&format!("{x},{y},{z},{value}"));
    }
    (0..style.trailing_blank).for_each(|_| lines.push(""));
    let mut text = lines.text;
    if !style.final_newline {
        text.pop();
        text.truncate(text.trim_end_matches('\r').len());
    }
    text.into_bytes()
}

/// The remembered spelling of a number, as long as it still is that number.
fn spelled(value: f64, remembered: &[(usize, String)], at: usize) -> String {
    let text = remembered.iter().find(|(n, _)| *n == at).map(|(_, text)| text);
    match text {
        Some(text) if text.trim().parse() == Ok(value) => text.clone(),
        _ => spell(value),
    }
}

/// Lines with the endings of the file they came from.
struct Lines<'s> {
    text: String,
    endings: &'s [(u8, usize)],
    run: usize,
    used: usize,
}

impl Lines<'_> {
    fn push(&mut self, line: &str) {
        self.text.push_str(line);
        while self.run + 1 < self.endings.len() && self.used >= self.endings[self.run].1 {
            self.run += 1;
            self.used = 0;
        }
        let returns = self.endings.get(self.run).map_or(0, |e| e.0);
        self.used += 1;
        self.text.extend((0..returns).map(|_| '\r'));
        self.text.push('\n');
    }
}
