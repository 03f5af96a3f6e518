//! One line of a batch: what a candidate must look like.

use houscaper::score::Evaluator;
use houscaper::voxels::{Choices, Label, VoxelArray};
use serde::Deserialize;
use serde_json::{Map, Value};

/// A line as a program writes it. Keys beside these are errors.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Request {
    #[serde(rename = "id")]
    _id: Value,
    shape: [usize; 3],
    labels: Vec<u8>,
    #[serde(default)]
    choices: Option<Map<String, Value>>,
}

/// A candidate that can be evaluated.
pub struct Candidate {
    /// Its labels on the plot.
    pub voxels: VoxelArray,
    /// Its sections and joist directions.
    pub choices: Choices,
}

/// A line read as far as it could be: its id, and the candidate or what is wrong with it.
pub struct Line {
    /// As given; null where there is none.
    pub id: Value,
    /// The candidate.
    pub candidate: Result<Candidate, String>,
}

/// Reads one line; `number` counts the lines of the input from 1. `genome` says whether choices may be given.
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

fn candidate(request: Request, genome: bool, evaluator: &Evaluator) -> Result<Candidate, String> {
    let plot = evaluator.brief.plot.modules;
    if request.shape != plot {
        return Err(format!("shape is {:?}, expected {plot:?} as in plot.modules of the brief", request.shape));
    }
    let labels = request
        .labels
        .iter()
        .enumerate()
        .map(|(n, &code)| {
            Label::from_code(code).ok_or_else(|| format!("labels[{n}] is {code}, expected a label from 0 to 5"))
        })
        .collect::<Result<Vec<Label>, String>>()?;
    let (found, expected) = (labels.len(), plot.iter().product::<usize>());
    let mut voxels = VoxelArray::from_labels(plot, labels)
        .ok_or_else(|| format!("{found} labels, expected {expected} for shape {plot:?}"))?;
    voxels.module.size_m = evaluator.brief.plot.module_m;
    let choices = match request.choices {
        Some(_) if !genome => return Err("`choices` is given, but the command was started without --genome".into()),
        Some(choices) => crate::cli::choices::read(&choices, evaluator)?,
        None => Choices::default(),
    };
    Ok(Candidate { voxels, choices })
}
