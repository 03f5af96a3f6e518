//! One line of a batch: what a candidate must look like.

use houscaper::score::Evaluator;
use houscaper::voxels::{Choice, Choices, Label, VoxelArray};
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
        Some(choices) => read_choices(&choices, evaluator)?,
        None => Choices::default(),
    };
    Ok(Candidate { voxels, choices })
}

/// Choices by name; what is not named takes the first option.
pub fn read_choices(map: &Map<String, Value>, evaluator: &Evaluator) -> Result<Choices, String> {
    let mut choices = Choices::default();
    for (key, value) in map {
        let Some(choice) = Choice::ALL.into_iter().find(|c| c.name() == key) else {
            let names = Choice::ALL.map(Choice::name).join(", ");
            return Err(format!("choices.{key}: unknown; expected one of {names}"));
        };
        choices.0[choice as usize] = match choice {
            Choice::Joists => bits(value)?,
            Choice::Wall | Choice::Floor | Choice::Beam | Choice::Roof => option(choice, value, evaluator)?,
        };
    }
    Ok(choices)
}

fn bits(value: &Value) -> Result<u16, String> {
    let bits = value.as_u64().and_then(|b| u16::try_from(b).ok());
    bits.ok_or_else(|| {
        format!("choices.joist_axes is {value}, expected 0 to 65535: bit p is set when plate p spans along y")
    })
}

/// The index of an option given by its name or by its index.
fn option(choice: Choice, value: &Value, evaluator: &Evaluator) -> Result<u16, String> {
    let options = &evaluator.options[choice as usize];
    let names = || options.iter().map(|o| evaluator.catalogue.option_name(*o));
    let index = match value {
        Value::String(name) => names().position(|n| n == *name),
        _ => value.as_u64().and_then(|n| usize::try_from(n).ok()).filter(|n| *n < options.len()),
    };
    index.and_then(|n| u16::try_from(n).ok()).ok_or_else(|| {
        let names: Vec<String> = names().collect();
        format!(
            "choices.{} is {value}, expected an index below {} or one of {}",
            choice.name(),
            names.len(),
            names.join(", ")
        )
    })
}
