//! Every evaluated design as columns of numbers: what the plots of the page draw.
//!
//! A column is the bytes of a little-endian typed array in base64: the narrowest of `u8`, `u16`, `u32` that holds whole numbers, else
//! `f32` (seven digits, finer than a pixel; the front's own figures are written exactly beside it). Text becomes codes and a list of words.

use base64::prelude::{BASE64_STANDARD, Engine};
use serde::Serialize;

use super::Rows;

/// Designs that the plots show at most: a plot of more looks the same and answers later.
pub const MOST_DESIGNS: usize = 20_000;

/// What a column of a table is about.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Dimension {
    /// Name of the column in the tables.
    pub key: String,
    /// What a person calls it.
    pub title: String,
    /// Unit; empty for a plain number or a word.
    pub unit: String,
    /// Which way is better; `None` for a design variable.
    pub maximise: Option<bool>,
    /// The words of a column of text, in the order of their codes; empty for numbers.
    pub words: Vec<String>,
}

/// One column.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Column {
    /// Name of the column in the tables.
    pub key: String,
    /// `u8`, `u16`, `u32` or `f32`.
    pub kind: &'static str,
    /// Base64 of the typed array.
    pub data: String,
}

/// The designs of a run.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct Cloud {
    /// Rows of the table.
    pub total: usize,
    /// Rows in the columns.
    pub shown: usize,
    /// Columns; the first is `id`.
    pub columns: Vec<Column>,
}

/// Rows that are shown: all, or evenly many with every house of the front among them.
pub fn shown_rows(ids: &[u64], front: &[u64], most: usize) -> Vec<usize> {
    if ids.len() <= most {
        return (0..ids.len()).collect();
    }
    let mut kept: Vec<usize> = (0..most).map(|n| n * ids.len() / most).collect();
    let front: std::collections::BTreeSet<u64> = front.iter().copied().collect();
    kept.extend((0..ids.len()).filter(|&row| front.contains(&ids[row])));
    kept.sort_unstable();
    kept.dedup();
    kept
}

/// The words of a column, sorted; `None` where every cell that is not empty is a number.
pub fn words(rows: &Rows, column: usize) -> Option<Vec<String>> {
    let cells = || (0..rows.count()).map(|row| rows.cell(row, column)).filter(|cell| !cell.is_empty());
    if cells().all(|cell| cell.parse::<f64>().is_ok()) {
        return None;
    }
    let words: std::collections::BTreeSet<&str> = cells().collect();
    Some(words.into_iter().map(str::to_owned).collect())
}

/// A cell as the page counts it: a number, `true` as 1, a word as its code, NaN for nothing.
pub fn value(cell: &str, words: &[String]) -> f64 {
    match cell {
        "true" => 1.0,
        "false" => 0.0,
        _ if words.is_empty() => cell.parse().unwrap_or(f64::NAN),
        _ => words.iter().position(|w| w == cell).map_or(f64::NAN, |code| code as f64),
    }
}

/// The designs of a table.
pub fn cloud(rows: &Rows, dimensions: &[Dimension], ids: &[u64], front: &[u64]) -> Cloud {
    let shown = shown_rows(ids, front, MOST_DESIGNS);
    let keys = ["id", "generation", "feasible", "violation"].into_iter().map(|key| (key, &[][..]));
    let keys = keys.chain(dimensions.iter().map(|d| (d.key.as_str(), d.words.as_slice())));
    let columns = keys.filter_map(|(key, words)| {
        let column = rows.column(key)?;
        let values: Vec<f64> = shown.iter().map(|&row| value(rows.cell(row, column), words)).collect();
        Some(packed(key, &values))
    });
    Cloud { total: rows.count(), shown: shown.len(), columns: columns.collect() }
}

/// A column in the narrowest form that holds it.
pub fn packed(key: &str, values: &[f64]) -> Column {
    let whole = values.iter().all(|v| v.fract() == 0.0 && (0.0..=f64::from(u32::MAX)).contains(v));
    let most = values.iter().copied().fold(0.0, f64::max);
    let (kind, bytes): (_, Vec<u8>) = match whole {
        true if most <= 255.0 => ("u8", values.iter().map(|&v| v as u8).collect()),
        true if most <= 65535.0 => ("u16", values.iter().flat_map(|&v| (v as u16).to_le_bytes()).collect()),
        true => ("u32", values.iter().flat_map(|&v| (v as u32).to_le_bytes()).collect()),
        false => ("f32", values.iter().flat_map(|&v| (v as f32).to_le_bytes()).collect()),
    };
    Column { key: key.to_owned(), kind, data: BASE64_STANDARD.encode(bytes) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn columns_are_as_narrow_as_they_hold() {
        let of = |values: &[f64]| {
            let column = packed("a", values);
            (column.kind, BASE64_STANDARD.decode(column.data).unwrap())
        };
        assert_eq!(of(&[1.0, 255.0]), ("u8", vec![1, 255]));
        assert_eq!(of(&[256.0]), ("u16", vec![0, 1]));
        assert_eq!(of(&[65536.0]), ("u32", vec![0, 0, 1, 0]));
        assert_eq!(of(&[0.5]), ("f32", 0.5f32.to_le_bytes().to_vec()));
        assert_eq!(of(&[1.0, f64::NAN]).0, "f32");
    }

    #[test]
    fn a_large_cloud_is_thinned_evenly_and_keeps_the_front() {
        let ids: Vec<u64> = (0..1000).collect();
        let kept = shown_rows(&ids, &[7, 999], 100);
        assert_eq!(kept.len(), 102);
        assert!(kept.contains(&7) && kept.contains(&999) && kept.contains(&0));
        assert!(kept.windows(2).all(|w| w[1] > w[0] && w[1] - w[0] <= 10), "no gap");
        assert_eq!(shown_rows(&ids, &[], 1000).len(), 1000);
    }
}
