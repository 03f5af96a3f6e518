//! The batch protocol: a line per candidate in, an empty line closes the batch, a line per candidate out.

use std::io::{BufRead, Write};

use anyhow::Context;
use houscaper::voxels::{House, infer_stairs};
use rayon::prelude::*;
use serde_json::{Value, json};

use super::request::{self, Candidate, Line};
use crate::cli::check::Asked;
use crate::cli::failure::{Blame, Outcome};

/// Stands for an objective that could not be found: of a house that breaks rules, or moves. Its `cv` is above 0.
const UNKNOWN: f64 = 1e9;

/// Answers batches until the input ends; what stands in front of the end is a batch too.
pub fn run(asked: &Asked, genome: bool, mut lines: impl BufRead, mut answers: impl Write) -> Outcome {
    let mut batch: Vec<Line> = Vec::new();
    let mut bytes = Vec::new();
    for number in 1.. {
        bytes.clear();
        let ended = lines.read_until(b'\n', &mut bytes).context("cannot read candidates").run()? == 0;
        let line = bytes.trim_ascii();
        if !line.is_empty() {
            batch.push(request::read(line, number, genome, &asked.evaluator));
            continue;
        }
        answer(&mut batch, asked, &mut answers)?;
        if ended {
            break;
        }
    }
    Ok(())
}

/// Evaluates a batch in parallel and answers in its order.
fn answer(batch: &mut Vec<Line>, asked: &Asked, answers: &mut impl Write) -> Outcome {
    let rows: Vec<Value> = std::mem::take(batch).into_par_iter().map(|line| row(line, asked)).collect();
    rows.iter()
        .try_for_each(|row| writeln!(answers, "{row}"))
        .and_then(|()| answers.flush())
        .context("cannot write answers")
        .run()
}

fn row(line: Line, asked: &Asked) -> Value {
    match line.candidate {
        Ok(candidate) => score(line.id, candidate, asked),
        Err(error) => json!({"id": line.id, "error": error}),
    }
}

fn score(id: Value, candidate: Candidate, asked: &Asked) -> Value {
    let Candidate { voxels, choices } = candidate;
    let house = House { stairs: infer_stairs(&voxels), ..House::new(voxels) };
    let evaluation = asked.evaluator.evaluate(&house, &choices);
    let goals = &asked.evaluator.brief.objectives;
    let mut f = evaluation.minimised(goals);
    f.resize(goals.len(), UNKNOWN);
    for value in f.iter_mut().filter(|v| !v.is_finite()) {
        *value = UNKNOWN;
    }
    let cv = evaluation.violation + asked.site.violation(&house);
    json!({"id": id, "f": f, "cv": if cv.is_finite() { cv } else { UNKNOWN }})
}
