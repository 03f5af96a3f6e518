//! One line of `vary`: what is asked for.

use serde::Deserialize;
use serde_json::Value;

use crate::cli::genome::Written;

/// Most moves of one request.
pub const MOST_STEPS: usize = 16;

/// A line as a program writes it. Keys beside these are errors.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Request {
    #[serde(default, rename = "id")]
    _id: Value,
    op: String,
    #[serde(default)]
    seed: Option<u64>,
    #[serde(default)]
    stream: Option<u64>,
    #[serde(default)]
    parents: Option<Vec<Written>>,
    #[serde(default, rename = "move")]
    named: Option<String>,
    #[serde(default)]
    steps: Option<usize>,
    #[serde(default)]
    goal: Option<String>,
}

/// What is asked for.
pub enum Task {
    /// A new house.
    Start {
        /// Seed.
        seed: u64,
        /// Stream of the seed.
        stream: u64,
    },
    /// One or more moves.
    Move {
        /// The parent.
        parent: Written,
        /// Seed.
        seed: u64,
        /// The move by name; drawn by weight when `None`.
        named: Option<String>,
        /// Moves one after the other, 1 to [`MOST_STEPS`].
        steps: usize,
    },
    /// A crossover.
    Crossover {
        /// Both parents.
        parents: [Written; 2],
        /// Seed.
        seed: u64,
    },
    /// Other sections.
    Size {
        /// The parent.
        parent: Written,
        /// Name of the goal; the first when `None`.
        goal: Option<String>,
    },
    /// The nearest house.
    Repair {
        /// The voxels.
        parent: Written,
    },
    /// What there is to vary.
    Space,
}

/// A line read as far as it could be.
pub struct Line {
    /// Its number in the input, from 1.
    pub number: usize,
    /// As given; null where there is none.
    pub id: Value,
    /// What is asked for, or what is wrong with the line.
    pub task: Result<Task, String>,
}

/// Reads one line; `number` counts the lines of the input from 1.
pub fn read(bytes: &[u8], number: usize) -> Line {
    let (id, task) = match serde_json::from_slice::<Value>(bytes) {
        Ok(value) => {
            let id = value.get("id").cloned().unwrap_or(Value::Null);
            let request = serde_json::from_value::<Request>(value).map_err(|error| format!("{error}; {EXAMPLE}"));
            (id, request.and_then(task))
        }
        Err(error) => (Value::Null, Err(format!("no JSON: {error}; {EXAMPLE}"))),
    };
    Line { number, id, task }
}

const EXAMPLE: &str =
    "write e.g. {\"id\": 1, \"op\": \"start\", \"seed\": 7}; `houscaper vary --help` lists all requests";

fn task(request: Request) -> Result<Task, String> {
    let Request { op, seed, stream, parents, named, steps, goal, .. } = request;
    // Keys that an operator does not read are errors, as unknown ones are.
    let given = [
        ("seed", seed.is_some()),
        ("stream", stream.is_some()),
        ("parents", parents.is_some()),
        ("move", named.is_some()),
        ("steps", steps.is_some()),
        ("goal", goal.is_some()),
    ];
    let only = |known: &[&str]| match given.iter().find(|(key, there)| *there && !known.contains(key)) {
        Some((key, _)) => Err(format!("`{key}` is given, but op \"{op}\" takes {}", list(known))),
        None => Ok(()),
    };
    let seeded = || seed.ok_or_else(|| format!("op \"{op}\" needs `seed`, a whole number from 0"));
    match op.as_str() {
        "start" => {
            only(&["seed", "stream"])?;
            Ok(Task::Start { seed: seeded()?, stream: stream.unwrap_or(0) })
        }
        "move" => {
            only(&["seed", "parents", "move", "steps"])?;
            let steps = steps.unwrap_or(1);
            if !(1..=MOST_STEPS).contains(&steps) {
                return Err(format!("steps is {steps}, expected 1 to {MOST_STEPS}"));
            }
            let [parent] = exactly(parents, &op)?;
            Ok(Task::Move { parent, seed: seeded()?, named, steps })
        }
        "crossover" => {
            only(&["seed", "parents"])?;
            Ok(Task::Crossover { seed: seeded()?, parents: exactly(parents, &op)? })
        }
        "size" => {
            only(&["parents", "goal"])?;
            let [parent] = exactly(parents, &op)?;
            Ok(Task::Size { parent, goal })
        }
        "repair" => {
            only(&["parents"])?;
            let [parent] = exactly(parents, &op)?;
            Ok(Task::Repair { parent })
        }
        "space" => {
            only(&[])?;
            Ok(Task::Space)
        }
        _ => Err(format!("op is \"{op}\", expected start, move, crossover, size, repair or space")),
    }
}

fn list(keys: &[&str]) -> String {
    match keys {
        [] => "no other keys".into(),
        keys => keys.iter().map(|k| format!("`{k}`")).collect::<Vec<_>>().join(", "),
    }
}

fn exactly<const N: usize>(parents: Option<Vec<Written>>, op: &str) -> Result<[Written; N], String> {
    let parents = parents.unwrap_or_default();
    let found = parents.len();
    parents.try_into().map_err(|_| format!("{found} parents, expected {N} for op \"{op}\""))
}
