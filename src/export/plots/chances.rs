//! Chances between houses as a matrix.

use super::canvas::{Align, PlotError, QUIET, TEXT, svg, width};

/// The chance that each house (row) costs less than each other (column), in percent, darker for more; on the left the chance that it is
/// the cheapest of these.
///
/// # Errors
/// When drawing fails.
pub fn chances(title: &str, names: &[String], below: &[Vec<f64>], cheapest: &[f64]) -> Result<String, PlotError> {
    let left = names.iter().map(|n| width(n, 14.0)).fold(90.0, f64::max) + 36.0;
    let (first, top, cell) = (left + 116.0, 132.0, [104.0, 38.0]);
    let right = first + cell[0] * names.len() as f64;
    let bottom = top + cell[1] * names.len() as f64;
    svg([(right + 40.0).max(760.0) as u32, bottom as u32 + 52], |c| {
        c.text(title, [24.0, 30.0], 20.0, TEXT, Align::Left)?;
        let note = "chance that the house of the row costs less than that of the column, %";
        c.text(note, [24.0, 56.0], 13.0, QUIET, Align::Left)?;
        c.text("cheapest", [left + 48.0, top - 34.0], 13.0, TEXT, Align::Middle)?;
        c.text("of these, %", [left + 48.0, top - 16.0], 13.0, TEXT, Align::Middle)?;
        for (n, name) in names.iter().enumerate() {
            let middle = first + cell[0] * (n as f64 + 0.5);
            for (row, word) in wrapped(name).iter().enumerate() {
                c.text(word, [middle, top - 34.0 + 18.0 * row as f64], 12.0, TEXT, Align::Middle)?;
            }
        }
        for (n, (name, row)) in names.iter().zip(below).enumerate() {
            let y = top + cell[1] * n as f64;
            let v = y + cell[1] / 2.0;
            c.text(name, [left - 12.0, v], 14.0, TEXT, Align::Right)?;
            let own = cheapest.get(n).copied().unwrap_or(0.0);
            c.rect([left, y + 2.0], [left + 96.0, y + cell[1] - 2.0], shade(own), 1.0)?;
            c.text(&percent(own), [left + 48.0, v], 15.0, ink(own), Align::Middle)?;
            for (m, &chance) in row.iter().enumerate() {
                let x = first + cell[0] * m as f64;
                if m == n {
                    c.text("\u{2013}", [x + cell[0] / 2.0, v], 14.0, QUIET, Align::Middle)?;
                    continue;
                }
                c.rect([x + 2.0, y + 2.0], [x + cell[0] - 2.0, y + cell[1] - 2.0], shade(chance), 1.0)?;
                c.text(&percent(chance), [x + cell[0] / 2.0, v], 14.0, ink(chance), Align::Middle)?;
            }
        }
        c.text(
            "rates drawn from the triangles of the price book, each draw the same for all houses",
            [24.0, bottom + 26.0],
            12.0,
            QUIET,
            Align::Left,
        )
    })
}

/// A name in two rows at most, broken at the space nearest to its middle.
fn wrapped(name: &str) -> Vec<String> {
    let half = name.len() as isize / 2;
    let nearest = name.char_indices().filter(|(_, c)| *c == ' ').min_by_key(|(at, _)| (*at as isize - half).abs());
    match nearest.filter(|_| width(name, 12.0) > 96.0) {
        Some((at, _)) => vec![name[..at].to_owned(), name[at + 1..].to_owned()],
        None => vec![String::new(), name.to_owned()],
    }
}

fn percent(chance: f64) -> String {
    match chance {
        c if c > 0.0 && c < 0.005 => "< 1".to_owned(),
        c if c < 1.0 && c > 0.995 => "> 99".to_owned(),
        c => format!("{:.0}", 100.0 * c),
    }
}

/// From paper to dark blue.
fn shade(chance: f64) -> u32 {
    let mix = |from: f64, to: f64| (from + (to - from) * chance.clamp(0.0, 1.0)).round() as u32;
    mix(244.0, 0.0) << 16 | mix(246.0, 74.0) << 8 | mix(248.0, 128.0)
}

fn ink(chance: f64) -> u32 {
    if chance > 0.5 { 0xFFFFFF } else { TEXT }
}
