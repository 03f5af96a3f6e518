//! `houscaper vary`: the search's starts, moves, crossover, sizing and repair over JSON lines, for optimizers outside.
//!
//! An answer is a pure function of its line and the brief: each line has its own seed, nothing is kept from line to line, so the
//! order of lines, the batches they come in and the number of threads do not matter. `vary/protocol.txt` describes the lines; an
//! answer is a candidate of `evaluate --batch --genome` as it is.

mod answer;
mod request;

use std::path::{Path, PathBuf};

use clap::Args;
use houscaper::score::SizingGoal;
use houscaper::search::houses::Houses;
use houscaper::voxels::{Choices, House};

use super::check::Asked;
use super::failure::Outcome;
use super::lines::answer_batches;
use super::space;
use answer::Workshop;

/// What the lines look like.
const PROTOCOL: &str = include_str!("vary/protocol.txt");

#[derive(Args)]
#[command(after_long_help = PROTOCOL)]
pub struct Vary {
    /// Brief.
    #[arg(long)]
    pub brief: PathBuf,
    /// Price book instead of the brief's; one that "extends" another replaces or adds single rates.
    #[arg(long, value_name = "FILE")]
    pub prices: Option<PathBuf>,
}

pub fn run(args: Vary) -> Outcome {
    let asked = Asked::load(&args.brief, args.prices.as_deref())?;
    let evaluator = &asked.evaluator;
    let space = space::of(evaluator, args.brief.parent().unwrap_or(Path::new("")))?;
    let rules = |house: &House| evaluator.broken_rule(house);
    let goals = SizingGoal::of_brief(&evaluator.brief);
    let size = |house: &House, choices: &Choices, goal: usize| evaluator.resize(house, choices, goals[goal]);
    let houses = Houses::new(&space, Some(&rules)).sized_by(&size, goals.len());
    let workshop = Workshop { evaluator, houses, goals: &goals };
    let (lines, answers) = (std::io::stdin().lock(), std::io::stdout().lock());
    answer_batches(lines, answers, request::read, |line| workshop.answer(line))
}
