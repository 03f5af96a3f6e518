//! One line of a batch: what a candidate must look like.

use houscaper::score::Evaluator;
use houscaper::voxels::{Choices, House};
use serde::Deserialize;
use serde_json::Value;

use crate::cli::genome::{self, Written};

/// A line as a program writes it. Keys beside these are errors.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Request {
    #[serde(rename = "id")]
    _id: Value,
    shape: [usize; 3],
    labels: Vec<u8>,
    #[serde(default)]
    stairs: Option<Value>,
    #[serde(default)]
    choices: Option<Value>,
    /// What made the candidate: an answer of `vary` is a candidate as it is.
    #[serde(default)]
    operator: Option<Value>,
}

/// A line read as far as it could be: its id, and the candidate or what is wrong with it.
pub struct Line {
    /// As given; null where there is none.
    pub id: Value,
    /// The candidate.
    pub candidate: Result<(House, Choices), String>,
}

/// Reads one line; `number` counts the lines of the input from 1. `genome` says whether stairs and choices may be given.
pub fn read(bytes: &[u8], number: usize, genome: bool, evaluator: &Evaluator) -> Line {
    let value: Value = match serde_json::from_slice(bytes) {
        Ok(value) => value,
        Err(error) => {
            let candidate = Err(format!("line {number}: no JSON: {error}; write {EXAMPLE}"));
            return Line { id: Value::Null, candidate };
        }
    };
    let id = value.get("id").cloned().unwrap_or(Value::Null);
    let candidate = serde_json::from_value::<Request>(value)
        .map_err(|error| format!("{error}; write {EXAMPLE}"))
        .and_then(|request| candidate(request, genome, evaluator))
        .map_err(|error| format!("line {number}: {error}"));
    Line { id, candidate }
}

const EXAMPLE: &str =
    "{\"id\": 17, \"shape\": [nx, ny, nz], \"labels\": [...]} with labels 0 to 5, x fastest, then y, then z";

fn candidate(request: Request, genome: bool, evaluator: &Evaluator) -> Result<(House, Choices), String> {
    let Request { shape, labels, stairs, choices, operator, .. } = request;
    let more = [("choices", choices.is_some()), ("stairs", stairs.is_some()), ("operator", operator.is_some())];
    let unasked = more.into_iter().find(|(_, given)| *given && !genome);
    let read = |what: &str, error: serde_json::Error| format!("{what}: {error}");
    let stairs = stairs.map(serde_json::from_value).transpose().map_err(|e| read("stairs", e))?;
    let choices = choices.map(serde_json::from_value).transpose().map_err(|e| read("choices", e))?;
    let candidate = genome::read(Written { shape, labels, stairs, choices }, evaluator)?;
    match unasked {
        Some((key, _)) => Err(format!("`{key}` is given, but the command was started without --genome")),
        None => Ok(candidate),
    }
}
