//! Published values of a reference file against what was found.

use houscaper::analysis::file::{Expected, FrameFile, Quantity};

use super::numbers::Numbers;

/// How a solution agrees with the published values of its file.
pub struct Agreement {
    /// Values compared.
    pub compared: usize,
    /// One sentence for each that is off.
    pub off: Vec<String>,
}

/// Compares every published value.
pub fn compare(file: &FrameFile, results: &[Numbers]) -> Agreement {
    let mut off = Vec::new();
    for expected in &file.expected {
        match found(expected, results) {
            Some(value) if (value - expected.value).abs() <= expected.tolerance => {}
            Some(value) => off.push(format!(
                "{}: found {value:.6e}, published {} (tolerance {:.1e})",
                place(expected, file),
                expected.value,
                expected.tolerance
            )),
            None => off.push(format!("{}: no such case, node, member or component", place(expected, file))),
        }
    }
    Agreement { compared: file.expected.len(), off }
}

fn found(expected: &Expected, results: &[Numbers]) -> Option<f64> {
    let case = results.get(expected.case)?;
    let row: &[f64] = match expected.quantity {
        Quantity::Displacement { node } => case.disp.get(node)?,
        Quantity::Reaction { node } => case.reac.get(node)?,
        Quantity::EndForce { member } => case.endf.get(member)?,
    };
    row.get(expected.component).copied()
}

fn place(expected: &Expected, file: &FrameFile) -> String {
    let case = file.cases.get(expected.case).map_or("?", |c| c.name.as_str());
    let what = match expected.quantity {
        Quantity::Displacement { node } => format!("displacement of node {node}"),
        Quantity::Reaction { node } => format!("reaction of node {node}"),
        Quantity::EndForce { member } => format!("end force of member {member}"),
    };
    format!("case {case}, {what}, component {}", expected.component)
}
