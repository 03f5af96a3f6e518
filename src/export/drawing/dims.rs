//! Dimension chains, levels, and the module grid with its bubbles.

use super::pens::{DIM, FINE, GRID};
use super::sheet::{Hold, QUIET, Sheet, TEXT, width};

/// Size of figures, mm.
const FIGURES: f64 = 2.3;

/// Along which edge of the drawing a chain runs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Side {
    /// Below the drawing.
    Below,
    /// Above it.
    Above,
    /// Left of it.
    Left,
    /// Right of it.
    Right,
}

impl Side {
    /// Whether a chain on this side measures to the right (and not upwards).
    pub fn is_level(self) -> bool {
        matches!(self, Side::Below | Side::Above)
    }
}

/// A length in whole millimetres as dimensions state it.
pub fn millimetres(metres: f64) -> String {
    format!("{:.0}", metres * 1e3)
}

/// A level in metres with its sign: `±0.00`, `+3.24`, `-0.15`.
pub fn level(metres: f64) -> String {
    let rounded = (metres * 100.0).round() / 100.0;
    if rounded == 0.0 { "±0.00".into() } else { format!("{rounded:+.2}").replace('-', "−") }
}

/// Dimensions between marks along one side, `away` mm from the drawing's edge at `edge` (up or right, m). Marks closer than a
/// millimetre are one.
pub fn chain(sheet: &mut Sheet, side: Side, edge: f64, away: f64, marks: &[f64]) {
    let mut marks: Vec<f64> = marks.to_vec();
    marks.sort_by(f64::total_cmp);
    marks.dedup_by(|a, b| (*a - *b).abs() < 1e-3);
    if marks.len() < 2 {
        return;
    }
    let line = match side {
        Side::Below => sheet.at([0.0, edge])[1] + away,
        Side::Above => sheet.at([0.0, edge])[1] - away,
        Side::Left => sheet.at([edge, 0.0])[0] - away,
        Side::Right => sheet.at([edge, 0.0])[0] + away,
    };
    let place = |m: f64| if side.is_level() { sheet.at([m, 0.0])[0] } else { sheet.at([0.0, m])[1] };
    let point = |along: f64, across: f64| if side.is_level() { [along, line + across] } else { [line + across, along] };
    let places: Vec<f64> = marks.iter().map(|m| place(*m)).collect();
    let (first, last) = (places[0], places[places.len() - 1]);
    let over = 1.4 * (last - first).signum();
    let mut lines = vec![vec![point(first - over, 0.0), point(last + over, 0.0)]];
    for &p in &places {
        lines.push(vec![point(p, -1.6), point(p, 1.6)]);
        lines.push(vec![point(p - 0.8, 0.8), point(p + 0.8, -0.8)]);
    }
    sheet.open("dimension");
    sheet.paths(DIM, &lines, false, "none");
    let mut raised = false;
    for n in 0..marks.len() - 1 {
        let words = millimetres(marks[n + 1] - marks[n]);
        let (middle, room) = (0.5 * (places[n] + places[n + 1]), (places[n + 1] - places[n]).abs());
        // Figures that do not fit between their marks stand a line higher, every other one.
        raised = width(&words, FIGURES) + 0.6 > room && !raised;
        let lift = if raised { -3.4 } else { -0.9 };
        let at = point(middle, lift);
        let turn = format!(" transform=\"rotate(-90 {:.2} {:.2})\"", at[0], at[1]);
        sheet.write(&words, at, FIGURES, Hold::Middle, TEXT, if side.is_level() { "" } else { &turn });
    }
    sheet.close();
}

/// Level marks right of `edge` (m), each with its words; marks that would overlap are moved apart.
pub fn levels(sheet: &mut Sheet, edge: f64, away: f64, marks: &[(f64, String)]) {
    let x = sheet.at([edge, 0.0])[0] + away;
    let mut marks: Vec<(f64, &str)> = marks.iter().map(|(m, w)| (*m, w.as_str())).collect();
    marks.sort_by(|a, b| b.0.total_cmp(&a.0));
    marks.dedup_by(|a, b| (a.0 - b.0).abs() < 5e-3);
    let places: Vec<f64> = marks.iter().map(|(m, _)| sheet.at([0.0, *m])[1]).collect();
    let texts = apart(&places, 3.6);
    sheet.open("levels");
    for (((metres, words), y), text) in marks.iter().zip(&places).zip(&texts) {
        sheet.paths(FINE, &[vec![[x - 3.0, *y], [x + 2.0, *y], [x + 4.0, *text], [x + 23.0, *text]]], false, "none");
        sheet.paths(FINE, &[vec![[x, *y], [x - 1.2, *y - 1.7], [x + 1.2, *y - 1.7]]], true, "#fff");
        sheet.text(&level(*metres), [x + 5.0, *text - 0.7], FIGURES, Hold::Start, TEXT);
        sheet.text(words, [x + 13.0, *text - 0.7], 1.9, Hold::Start, QUIET);
    }
    sheet.close();
}

/// Ascending places moved so that each is at least `gap` from the next, as little as that takes.
fn apart(places: &[f64], gap: f64) -> Vec<f64> {
    let mut moved = places.to_vec();
    for _ in 0..40 {
        for n in 1..moved.len() {
            let short = gap - (moved[n] - moved[n - 1]);
            if short > 1e-6 {
                moved[n - 1] -= 0.5 * short;
                moved[n] += 0.5 * short;
            }
        }
    }
    moved
}

/// Grid lines across the drawing with a bubble at one end: `lines` are places (m) with their names, `span` is what they cross (m).
pub fn grid(sheet: &mut Sheet, side: Side, lines: &[(f64, String)], span: [f64; 2], away: f64) {
    let radius = 2.3;
    let pitch = lines.windows(2).map(|w| sheet.mm((w[1].0 - w[0].0).abs())).fold(f64::MAX, f64::min);
    // Bubbles need their width: of a fine grid every second, fourth line is named.
    let every = [1, 2, 4, 8, 16, 32].into_iter().find(|e| f64::from(*e) * pitch > 2.0 * radius + 0.6).unwrap_or(64);
    sheet.open("grid");
    for (n, (at, name)) in lines.iter().enumerate() {
        let ends = if side.is_level() { [[*at, span[0]], [*at, span[1]]] } else { [[span[0], *at], [span[1], *at]] };
        let [mut a, mut b] = ends.map(|p| sheet.at(p));
        let bubble = n % every as usize == 0;
        let reach = if bubble { away } else { 1.0 };
        let centre = match side {
            Side::Below => {
                a[1] += reach;
                b[1] -= 1.0;
                [a[0], a[1] + radius]
            }
            Side::Above => {
                b[1] -= reach;
                a[1] += 1.0;
                [b[0], b[1] - radius]
            }
            Side::Left => {
                a[0] -= reach;
                b[0] += 1.0;
                [a[0] - radius, a[1]]
            }
            Side::Right => {
                b[0] += reach;
                a[0] -= 1.0;
                [b[0] + radius, b[1]]
            }
        };
        sheet.paths(GRID, &[vec![a, b]], false, "none");
        if bubble {
            sheet.circle(FINE, centre, radius, "#fff");
            sheet.text(name, [centre[0], centre[1] + 0.78], 2.2, Hold::Middle, QUIET);
        }
    }
    sheet.close();
}

/// The name of the n-th line of the axis that has letters: A to Z, then AA.
pub fn letter(n: usize) -> String {
    let one = |n: usize| char::from(b'A' + (n % 26) as u8);
    if n < 26 { one(n).to_string() } else { [one(n / 26 - 1), one(n)].iter().collect() }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn levels_and_lengths_as_drawings_state_them() {
        assert_eq!([level(0.001), level(3.24), level(-0.15)], ["±0.00", "+3.24", "−0.15"]);
        assert_eq!(millimetres(8.1), "8100");
        assert_eq!([letter(0), letter(25), letter(26)], ["A", "Z", "AA"]);
        let moved = apart(&[0.0, 1.0, 20.0], 5.0);
        assert!(moved[1] - moved[0] > 4.99 && moved[2] == 20.0);
    }
}
