//! The batch protocol: a line per candidate in, an empty line closes the batch, a line per candidate out.

use std::io::{BufRead, Write};

use houscaper::voxels::House;
use serde_json::{Value, json};

use super::request::{self, Line};
use crate::cli::check::Asked;
use crate::cli::failure::Outcome;
use crate::cli::lines::answer_batches;
use houscaper::voxels::Choices;

/// Stands for an objective that could not be found: of a house that breaks rules, or moves. Its `cv` is above 0.
const UNKNOWN: f64 = 1e9;

/// Answers batches until the input ends. `genome` says whether stairs and choices may be given.
pub fn run(asked: &Asked, genome: bool, lines: impl BufRead, answers: impl Write) -> Outcome {
    let read = |bytes: &[u8], number| request::read(bytes, number, genome, &asked.evaluator);
    answer_batches(lines, answers, read, |line: Line| match line.candidate {
        Ok((house, choices)) => score(line.id, &house, &choices, asked),
        Err(error) => json!({"id": line.id, "error": error}),
    })
}

fn score(id: Value, house: &House, choices: &Choices, asked: &Asked) -> Value {
    let evaluation = asked.evaluator.evaluate(house, choices);
    let goals = &asked.evaluator.brief.objectives;
    let mut f = evaluation.minimised(goals);
    f.resize(goals.len(), UNKNOWN);
    for value in f.iter_mut().filter(|v| !v.is_finite()) {
        *value = UNKNOWN;
    }
    let cv = evaluation.violation + asked.site.violation(house);
    json!({"id": id, "f": f, "cv": if cv.is_finite() { cv } else { UNKNOWN }})
}
