//! `houscaper solve`: linear analysis of any frame file.

mod along;
mod balance;
mod expected;
mod numbers;
mod object;
mod summary;

use anyhow::Context;
use houscaper::analysis::file::{self, FrameFile};
use houscaper::analysis::{Buckler, BucklingAnswer, InputError, Phases, Size, Solution, Solver, Status};

use super::args::Solve;
use super::failure::{Blame, Outcome};
use super::input;
use super::output::say;
use numbers::Numbers;

/// What the solve took, and how many digits it may lose.
struct Cost {
    size: Size,
    phases: Phases,
    /// `None` for a mechanism.
    condition: Option<f64>,
}

/// A frame that moves is a status, not an error: exit code 2 is kept for files that describe no frame.
pub fn run(args: Solve, as_json: bool) -> Outcome {
    let name = args.frame.display().to_string();
    let file = file::read(&input::bytes(&args.frame)?, &name).input()?;
    let mut solver = Solver::new();
    let mut solution = solver.solve(&file.model, &file.cases).context(name.clone()).input()?;
    let mut phases = solver.phases();
    for _ in 1..args.repeat {
        solver.solve_into(&file.model, &file.cases, &mut solution).context(name.clone()).input()?;
        phases = if solver.phases().total() < phases.total() { solver.phases() } else { phases };
    }
    let results = match solution.status {
        Status::Solved { .. } | Status::NearlySingular { .. } => numbers::all(&file, &solution),
        Status::Unstable(_) | Status::Empty => Vec::new(),
    };
    let buckling = buckling(&args, &file, &solution, &results).context(name.clone()).input()?;
    let cost = Cost { size: solver.size(), phases, condition: solver.condition() };
    if as_json {
        say!("{}", object::answer(&file, &cost, &solution, &results, &buckling, args.stations));
    } else {
        summary::print(&name, &file, &cost, &solution, &results, &buckling);
    }
    Ok(())
}

/// First buckling loads of all cases and combinations, where they are asked for and the frame is solved.
fn buckling(
    args: &Solve,
    file: &FrameFile,
    solution: &Solution,
    results: &[Numbers],
) -> Result<Vec<BucklingAnswer>, InputError> {
    let Some(pieces) = args.buckling.filter(|_| solution.status.is_solved()) else { return Ok(Vec::new()) };
    let mut buckler = Buckler::new(&file.model, &[usize::from(pieces)])?;
    Ok(results.iter().map(|r| buckler.first(solution, &r.factors)).collect())
}

fn word(status: &Status) -> &'static str {
    match status {
        Status::Solved { .. } => "solved",
        Status::NearlySingular { .. } => "nearly singular",
        Status::Unstable(_) => "unstable",
        Status::Empty => "empty",
    }
}
