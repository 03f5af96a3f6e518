//! `houscaper solve`: linear analysis of any frame file.

mod along;
mod balance;
mod expected;
mod numbers;
mod object;
mod summary;

use anyhow::Context;
use houscaper::analysis::file;
use houscaper::analysis::{Solver, Status};

use super::args::Solve;
use super::failure::{Blame, Outcome};
use super::input;
use super::output::say;

/// A frame that moves is a status, not an error: exit code 2 is kept for files that describe no frame.
pub fn run(args: Solve, as_json: bool) -> Outcome {
    let name = args.frame.display().to_string();
    let file = file::read(&input::bytes(&args.frame)?, &name).input()?;
    let mut solver = Solver::new();
    let solution = solver.solve(&file.model, &file.cases).context(name.clone()).input()?;
    let results = match solution.status {
        Status::Solved { .. } | Status::NearlySingular { .. } => numbers::all(&file, &solution),
        Status::Unstable(_) | Status::Empty => Vec::new(),
    };
    let condition = solver.condition();
    if as_json {
        say!("{}", object::answer(&file, &solver, condition, &solution, &results, args.stations));
    } else {
        summary::print(&name, &file, &solver, condition, &solution, &results);
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
