//! Commands of the search: `optimize`, `worker`, `resume`, `merge`, `report`.

use std::path::PathBuf;

use clap::{Args, ValueEnum};
use houscaper::brief::Algorithm;
use serde::{Deserialize, Serialize};

/// Nodes of models.
#[derive(Clone, Copy, Default, PartialEq, Eq, Debug, ValueEnum, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum GlbParts {
    /// house.glb with a node for each layer, merged over all cubes.
    #[default]
    Layers,
    /// The same, and tiles.glb with a node for each cube and stair.
    Tiles,
}

#[derive(Args)]
pub struct Optimize {
    /// The brief, e.g. configs/starter.json.
    pub brief: PathBuf,
    /// Run folder [default: results/<name>-seed<seed>].
    #[arg(long)]
    pub out: Option<PathBuf>,
    /// Seed instead of the brief's.
    #[arg(long)]
    pub seed: Option<u64>,
    /// Evaluations instead of the brief's.
    #[arg(long)]
    pub evaluations: Option<usize>,
    /// Stop after this many seconds (such a run is not reproducible byte for byte).
    #[arg(long, value_name = "S")]
    pub time_limit: Option<f64>,
    /// Stop after so many evaluations without a gain worth naming (a thousandth of the hypervolume), instead of the brief's.
    #[arg(long, value_name = "N")]
    pub stagnation: Option<u64>,
    /// Worker threads; the result does not depend on it [default: all cores].
    #[arg(long)]
    pub threads: Option<usize>,
    /// Search algorithm instead of the brief's; `random` is the baseline with the same moves and no selection.
    #[arg(long, value_enum)]
    pub method: Option<Method>,
    /// Price book instead of the brief's; one that "extends" another replaces or adds single rates.
    #[arg(long, value_name = "FILE")]
    pub prices: Option<PathBuf>,
    /// `tiles` adds tiles.glb to each house of the front: a node for each cube, equal tiles sharing their mesh.
    #[arg(long, value_enum, default_value_t = GlbParts::Layers)]
    pub glb_parts: GlbParts,
    /// Also run a random search with the same moves and show it in the hypervolume plot.
    #[arg(long)]
    pub baseline: bool,
    /// Write tables and plots only, no houses.
    #[arg(long)]
    pub tables_only: bool,
    /// Also write every house of the front as IFC4 (`house.ifc`, with `takeoff.json` beside it).
    #[arg(long)]
    pub ifc: bool,
    /// Let `houscaper worker`s evaluate, through the NATS server at this address, e.g. nats://host:4222; the bytes stay the same.
    #[arg(long, value_name = "URL")]
    pub queue: Option<String>,
    /// Houses in one message of the queue.
    #[arg(long, value_name = "N", requires = "queue", default_value_t = houscaper::run::queue::PER_QUESTION, value_parser = per_question())]
    pub per_question: usize,
}

/// What `--per-question` may be.
fn per_question() -> clap::builder::RangedU64ValueParser<usize> {
    clap::builder::RangedU64ValueParser::new().range(1..=houscaper::run::queue::wire::MOST_HOUSES as u64)
}

#[derive(Args)]
pub struct Worker {
    /// The NATS server, e.g. nats://host:4222 (user and password or a token before an @).
    pub url: String,
    /// Evaluations at a time [default: all cores].
    #[arg(long)]
    pub threads: Option<usize>,
    /// End after so many seconds without a house to evaluate.
    #[arg(long, value_name = "S")]
    pub idle_exit: Option<f64>,
}

#[derive(Args)]
pub struct Resume {
    /// The run folder.
    pub run: PathBuf,
    /// Evaluations instead of the run's, to let it go further.
    #[arg(long)]
    pub evaluations: Option<usize>,
    /// Stop after this many seconds more.
    #[arg(long, value_name = "S")]
    pub time_limit: Option<f64>,
    /// Worker threads; the result does not depend on it [default: all cores].
    #[arg(long)]
    pub threads: Option<usize>,
    /// Also write every house of the front as IFC4 (`house.ifc`, with `takeoff.json` beside it).
    #[arg(long)]
    pub ifc: bool,
    /// Let `houscaper worker`s evaluate, through the NATS server at this address.
    #[arg(long, value_name = "URL")]
    pub queue: Option<String>,
    /// Houses in one message of the queue.
    #[arg(long, value_name = "N", requires = "queue", default_value_t = houscaper::run::queue::PER_QUESTION, value_parser = per_question())]
    pub per_question: usize,
}

#[derive(Args)]
pub struct Merge {
    /// Run folders of one brief; search settings may differ.
    #[arg(required = true)]
    pub runs: Vec<PathBuf>,
    /// Folder of the merged run.
    #[arg(long)]
    pub out: PathBuf,
    /// Write tables and plots only, no houses.
    #[arg(long)]
    pub tables_only: bool,
    /// Also write every house of the front as IFC4 (`house.ifc`, with `takeoff.json` beside it).
    #[arg(long)]
    pub ifc: bool,
}

#[derive(Args)]
pub struct Report {
    /// A run folder, whole or with some of its files, or the folder of a built house.
    pub run: PathBuf,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Method {
    /// A steady state around an archive, with moves chosen by their recent success.
    Steady,
    /// NSGA-II with constraint domination.
    Nsga2,
    /// NSGA-III.
    Nsga3,
    /// MAP-Elites: the best house of each kind by the first objective, with a map of them.
    #[serde(rename = "map-elites")]
    MapElites,
    /// Random starts and random moves.
    Random,
    /// Hill climbers along weighted objectives.
    Hill,
}

impl From<Method> for Algorithm {
    fn from(method: Method) -> Algorithm {
        match method {
            Method::Steady => Algorithm::Steady,
            Method::Nsga2 => Algorithm::Nsga2,
            Method::Nsga3 => Algorithm::Nsga3,
            Method::MapElites => Algorithm::MapElites,
            Method::Random => Algorithm::Random,
            Method::Hill => Algorithm::Hill,
        }
    }
}

impl From<Algorithm> for Method {
    fn from(algorithm: Algorithm) -> Method {
        match algorithm {
            Algorithm::Steady => Method::Steady,
            Algorithm::Nsga2 => Method::Nsga2,
            Algorithm::Nsga3 => Method::Nsga3,
            Algorithm::MapElites => Method::MapElites,
            Algorithm::Random => Method::Random,
            Algorithm::Hill => Method::Hill,
        }
    }
}
