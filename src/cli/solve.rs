//! `houscaper solve`: linear analysis of any frame file.

mod expected;
mod numbers;
mod summary;

use anyhow::Context;
use houscaper::analysis::file;
use houscaper::analysis::{Solution, Status, solve};
use serde_json::json;

use super::args::Solve;
use super::failure::{Blame, Outcome};
use super::input;
use super::output::say;
use numbers::Numbers;

/// A frame that moves is a status, not an error: exit code 2 is kept for files that describe no frame.
pub fn run(args: Solve, as_json: bool) -> Outcome {
    let name = args.frame.display().to_string();
    let file = file::read(&input::bytes(&args.frame)?, &name).input()?;
    let solution = solve(&file.model, &file.cases).context(name.clone()).input()?;
    let results = match solution.status {
        Status::Solved { .. } | Status::NearlySingular { .. } => numbers::all(&file, &solution),
        Status::Unstable(_) | Status::Empty => Vec::new(),
    };
    if as_json {
        say!("{}", as_object(&solution, &results));
    } else {
        summary::print(&name, &file, &solution, &results);
    }
    Ok(())
}

fn word(status: &Status) -> &'static str {
    match status {
        Status::Solved { .. } => "solved",
        Status::NearlySingular { .. } => "nearly singular",
        Status::Unstable(_) => "unstable",
        Status::Empty => "empty",
    }
}

/// Displacements by node, reactions by node (zero where nothing is supported), end forces by member; no cases for a mechanism.
fn as_object(solution: &Solution, results: &[Numbers]) -> serde_json::Value {
    let cases: Vec<_> = results
        .iter()
        .map(|r| {
            let ends: Vec<&[f64]> = r.endf.iter().map(|e| e.as_slice()).collect();
            json!({"name": r.name, "disp": r.disp, "reac": r.reac, "endf": ends})
        })
        .collect();
    let mut object = json!({"cases": cases, "status": word(&solution.status)});
    let mechanism = match &solution.status {
        Status::Unstable(m) | Status::NearlySingular { weakest: m, .. } => m,
        Status::Solved { .. } | Status::Empty => return object,
    };
    let motions: Vec<_> = mechanism.motions.iter().map(|m| json!({"node": m.node, "direction": m.direction})).collect();
    object["mechanism"] = json!({"message": mechanism.to_string(), "nodes": motions});
    object
}
