//! What the run found out beside its houses: groups by look, what keeps the front from being better, what a change does.

use serde::Serialize;
use serde_json::Value;

use super::house::cell;
use super::{Folder, ReportError, Rows};

/// A table of the folder as the page shows it.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct Table {
    /// Names of the columns.
    pub header: Vec<String>,
    /// Cells, row by row.
    pub rows: Vec<Vec<Value>>,
}

/// Tables and sentences.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct Findings {
    /// `clusters.csv`: a row for each house of the front.
    pub looks: Option<Table>,
    /// `whynot.csv`: a row for each constraint.
    pub why_not: Option<Table>,
    /// Why not, in words; none without `summary.json`.
    pub why_not_words: Vec<String>,
    /// `sensitivity.csv`: for each named house and kind of change a row for each objective.
    pub changes: Option<Table>,
    /// `moves.csv`: what became of the draws of each move.
    pub moves: Option<Table>,
}

/// Reads what there is of it.
///
/// # Errors
/// [`ReportError`]: a table that cannot be read.
pub fn read(folder: &Folder, summary: &Value) -> Result<Findings, ReportError> {
    let table = |name: &str| -> Result<Option<Table>, ReportError> {
        let Some(bytes) = (folder.read)(name)? else { return Ok(None) };
        let rows = Rows::read(name, &bytes)?;
        let row = |row: usize| (0..rows.header.len()).map(|column| cell(rows.cell(row, column))).collect();
        Ok(Some(Table { rows: (0..rows.count()).map(row).collect(), header: rows.header.clone() }))
    };
    let words = summary["why_not_words"].as_array().into_iter().flatten();
    Ok(Findings {
        looks: table("clusters.csv")?,
        why_not: table("whynot.csv")?,
        why_not_words: words.filter_map(|word| word.as_str().map(str::to_owned)).collect(),
        changes: table("sensitivity.csv")?,
        moves: table("moves.csv")?,
    })
}
