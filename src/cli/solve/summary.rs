//! A solved frame in a few lines.

use houscaper::analysis::file::FrameFile;
use houscaper::analysis::{Solution, Status};

use super::expected;
use super::numbers::Numbers;
use crate::cli::check::plural;
use crate::cli::output::say;

/// Most idle directions and disagreements listed.
const MOST_LISTED: usize = 8;

/// Status, extremes, balance and agreement, in the file's own units.
pub fn print(name: &str, file: &FrameFile, solution: &Solution, results: &[Numbers]) {
    let model = &file.model;
    let title = if file.name.is_empty() { String::new() } else { format!(" ({})", file.name) };
    say!("{name}{title}");
    say!(
        "{} nodes, {} members, {} supports, {} load case{}, {} combination{}{}",
        model.nodes.len(),
        model.members.len(),
        model.supports.len(),
        file.cases.len(),
        plural(file.cases.len()),
        file.combinations.len(),
        plural(file.combinations.len()),
        if file.units.is_empty() { String::new() } else { format!("; units {}", file.units) },
    );
    status(&solution.status);
    idle(solution);
    results.iter().for_each(case);
    if !file.expected.is_empty() && !results.is_empty() {
        agreement(&expected::compare(file, results));
    }
}

fn status(status: &Status) {
    match status {
        Status::Solved { residual, .. } => say!("solved: largest residual {residual:.1e}"),
        Status::NearlySingular { condition, weakest, .. } => say!(
            "nearly singular: condition {condition:.1e}; the numbers below cannot be relied on. Weakest motion: {weakest}"
        ),
        Status::Unstable(mechanism) => {
            say!("unstable: {mechanism}");
            say!("no displacements exist; add supports, braces or rigid joints that hold these nodes");
        }
        Status::Empty => say!("empty: nothing to solve"),
    }
}

fn idle(solution: &Solution) {
    if solution.idle.is_empty() {
        return;
    }
    let names: Vec<String> = solution.idle.iter().take(MOST_LISTED).map(|i| i.node.to_string()).collect();
    say!(
        "taken out, because nothing resists and nothing loads them: {} direction{} at nodes {}{}",
        solution.idle.len(),
        plural(solution.idle.len()),
        names.join(", "),
        if solution.idle.len() > MOST_LISTED { ", ..." } else { "" }
    );
}

fn case(numbers: &Numbers) {
    say!("\n{}", numbers.name);
    for (range, what) in [(0..3, "displacement"), (3..6, "rotation")] {
        if let Some((node, value, d)) = extreme(&numbers.disp, range) {
            say!("  largest {what:<12} {value:>13.5e} {} at node {node}", ["x", "y", "z"][d % 3]);
        }
    }
    for (kind, name) in ["axial force", "shear", "shear", "torsion", "bending", "bending"].into_iter().enumerate() {
        let axis = ["", " y", " z", "", " y", " z"][kind];
        let ends: Vec<[f64; 2]> = numbers.endf.iter().map(|e| [e[kind], e[kind + 6]]).collect();
        if let Some((member, value, end)) = extreme(&ends, 0..2) {
            say!(
                "  largest {:<12} {value:>13.5e} at end {} of member {member}",
                format!("{name}{axis}"),
                ["i", "j"][end]
            );
        }
    }
    let (load, reaction) = (numbers.load, numbers.reaction());
    let size = load.iter().chain(&reaction).fold(0.0f64, |m, v| m.max(v.abs()));
    let open = (0..3).map(|d| (load[d] + reaction[d]).abs()).fold(0.0, f64::max);
    say!("  loads        {}", vector(load));
    say!("  reactions    {}", vector(reaction));
    say!("  out of balance {:.1e} of the largest", if size > 0.0 { open / size } else { 0.0 });
}

/// The entry of largest magnitude in some columns: row, value, column. `None` when all are zero.
fn extreme<const N: usize>(rows: &[[f64; N]], columns: std::ops::Range<usize>) -> Option<(usize, f64, usize)> {
    let mut best: Option<(usize, f64, usize)> = None;
    for (row, values) in rows.iter().enumerate() {
        for column in columns.clone() {
            let value = values[column];
            if value != 0.0 && best.is_none_or(|(_, b, _)| value.abs() > b.abs()) {
                best = Some((row, value, column));
            }
        }
    }
    best
}

fn vector(v: [f64; 3]) -> String {
    v.map(|x| format!("{x:>13.5e}")).join(" ")
}

fn agreement(found: &expected::Agreement) {
    let good = found.compared - found.off.len();
    say!("\npublished values: {good} of {} agree", found.compared);
    for sentence in found.off.iter().take(MOST_LISTED) {
        say!("  {sentence}");
    }
    if found.off.len() > MOST_LISTED {
        say!("  and {} more", found.off.len() - MOST_LISTED);
    }
}
