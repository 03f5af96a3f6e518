//! The command line as clap sees it. Names and meanings are a contract; flags may be added.

mod files;
mod search;
mod tileset;

use std::path::PathBuf;

use clap::{Args, Parser, Subcommand, ValueEnum};
use houscaper::score::SizingGoal;

pub use files::{Convert, CornerOrder, Cubes, Import, Scheme};
pub use search::{GlbParts, Merge, Method, Optimize, Report, Resume, Worker};
pub use tileset::{NewKind, Tileset, TilesetBake, TilesetNew};

/// Generative design optimizer for modular houses.
///
/// A brief goes in, a Pareto front of houses comes out: each rule-respecting, analysed, priced, as GLB with tables and plots.
#[derive(Parser)]
#[command(name = "houscaper", version, propagate_version = true)]
pub struct Cli {
    #[command(subcommand)]
    pub command: Command,
    /// Machine-readable stdout; everything for people goes to stderr.
    #[arg(long, global = true)]
    pub json: bool,
}

#[derive(Subcommand)]
pub enum Command {
    /// Search houses for a brief and write a run folder with the front, tables, plots and pictures.
    Optimize(Optimize),
    /// Carry on a run where it stopped, however it stopped, and write its results.
    Resume(Resume),
    /// One archive of all evaluations of several runs of a brief, such as an array of seeds.
    Merge(Merge),
    /// Evaluate the houses of runs on other machines (`optimize --queue`) through a NATS server; any number may come and go.
    Worker(Worker),
    /// List the rules a house breaks, with cells and fixes.
    Check(Check),
    /// Write the cube ids of a voxel array as a lattice CSV.
    Cubes(Cubes),
    /// Build one house: GLB, OBJ, frame, take-off, quote, structure, plans, elevations, a section and a picture.
    Build(Build),
    /// The same house, or a whole front, in several materials: each sized and checked, line by line, with the chance of each order.
    Compare(Compare),
    /// A picture of a house, or a turntable: an animated PNG, its frames and a sheet of sprites.
    Picture(super::picture::PictureArgs),
    /// The quote of a house as HTML, CSV and JSON.
    Quote(Quote),
    /// Write report.html into a run folder, or into the folder of a built house: one offline page with plots, houses in 3D, quotes and structures.
    Report(Report),
    /// Every design of a small brief, counted, hashed and evaluated: its true front.
    Enumerate(super::enumerate::Enumerate),
    /// Objectives and constraints of houses as JSON, one by one or in batches over stdin.
    Evaluate(Evaluate),
    /// Up to six better neighbours of a house: cheaper, lower in carbon, stiffer, or valid again, each with its differences.
    Improve(super::improve::Improve),
    /// Starts, moves, crossover, sizing and repair of houses over JSON lines, for optimizers outside.
    Vary(super::vary::Vary),
    /// Solve a 3D frame file (houscaper.frame/1).
    Solve(Solve),
    /// Check one member by EN 1993-1-1 or EN 1995-1-1, every clause with its numbers.
    Member(Box<super::member::Member>),
    /// Convert between lattice CSV, .npy, .vox, text and Houscaper's JSON; repair inadmissible cubes; make houses of massings.
    Convert(Convert),
    /// Check, list, show, scaffold or bake tilesets.
    #[command(subcommand)]
    Tileset(Tileset),
    /// Print the JSON Schema of a file format.
    Schema(Schema),
}

#[derive(Args)]
pub struct Check {
    /// Voxels: Houscaper JSON, text, MagicaVoxel .vox, a lattice CSV of labels 0 to 5, or sample:NAME for a house that comes along.
    #[arg(required_unless_present = "rules")]
    pub voxels: Option<PathBuf>,
    /// Take plot, programme and rule settings from this brief.
    #[arg(long)]
    pub brief: Option<PathBuf>,
    /// List the rules with their sentences and settings instead.
    #[arg(long)]
    pub rules: bool,
    #[command(flatten)]
    pub import: Import,
}

#[derive(Args)]
pub struct Build {
    /// Voxels.
    pub voxels: PathBuf,
    /// Brief with site, prices, materials [default: the shipped starter brief].
    #[arg(long)]
    pub brief: Option<PathBuf>,
    /// Price book instead of the brief's; one that "extends" another replaces or adds single rates.
    #[arg(long, value_name = "FILE")]
    pub prices: Option<PathBuf>,
    /// Tileset instead of the brief's: a folder with tileset.json (a style, meshes of solids, surfaces) or the name of a shipped one.
    #[arg(long)]
    pub tileset: Option<String>,
    /// Folder of the tileset's OBJ files when it is not where its manifest says; for meshes of solids.
    #[arg(long, value_name = "DIR", requires = "tileset")]
    pub tileset_root: Option<PathBuf>,
    /// Section and joist choices as JSON or a file of it, e.g. a front's choices.json [default: sized, see --size].
    #[arg(long)]
    pub choices: Option<String>,
    /// Choose the brief's sections so that all checks pass at least price, mass or carbon of the frame; sizing.json tells how.
    #[arg(long, value_enum, value_name = "GOAL", default_value_t = Goal::Price, conflicts_with = "choices")]
    pub size: Goal,
    /// Nodes of the model: `layers` writes house.glb, merged; `tiles` adds tiles.glb, a node a cube, equal tiles sharing their mesh.
    #[arg(long, value_enum, default_value_t = GlbParts::Layers)]
    pub glb_parts: GlbParts,
    /// Output folder.
    #[arg(long)]
    pub out: PathBuf,
    #[command(flatten)]
    pub import: Import,
}

#[derive(Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum Goal {
    /// Least price of the frame.
    Price,
    /// Least mass of the frame.
    Mass,
    /// Least fossil carbon of the frame, A1-A3.
    Carbon,
}

impl From<Goal> for SizingGoal {
    fn from(goal: Goal) -> Self {
        match goal {
            Goal::Price => SizingGoal::Price,
            Goal::Mass => SizingGoal::Mass,
            Goal::Carbon => SizingGoal::Carbon,
        }
    }
}

#[derive(Args)]
pub struct Compare {
    /// Voxels, or the folder of a run whose front is compared.
    pub input: PathBuf,
    /// Systems, separated by commas; the materials of one joined by +, e.g. C24,GL24h,S355 or C24,C24+S355.
    #[arg(long, value_delimiter = ',', required = true, value_name = "A,B,...")]
    pub materials: Vec<String>,
    /// Brief with site and books [default: the run's own, or the shipped starter brief].
    #[arg(long)]
    pub brief: Option<PathBuf>,
    /// Price book instead of the brief's; one that "extends" another replaces or adds single rates.
    #[arg(long, value_name = "FILE")]
    pub prices: Option<PathBuf>,
    /// What each system is sized for.
    #[arg(long, value_enum, value_name = "GOAL", default_value_t = Goal::Price)]
    pub size: Goal,
    /// Draws of the rates between low and high, shared by all systems.
    #[arg(long, value_name = "N", default_value_t = houscaper::price::DRAWS, value_parser = clap::builder::RangedU64ValueParser::<usize>::new().range(100..=1_000_000))]
    pub draws: usize,
    /// Seed of the draws.
    #[arg(long, default_value_t = 1)]
    pub seed: u64,
    /// Output folder.
    #[arg(long)]
    pub out: PathBuf,
    #[command(flatten)]
    pub import: Import,
}

#[derive(Args)]
pub struct Quote {
    /// Voxels.
    pub voxels: PathBuf,
    /// Brief with site, prices, materials [default: the shipped starter brief].
    #[arg(long)]
    pub brief: Option<PathBuf>,
    /// Price book instead of the brief's; one that "extends" another replaces or adds single rates.
    #[arg(long, value_name = "FILE")]
    pub prices: Option<PathBuf>,
    /// Section, joist and board choices as JSON or a file of it [default: sized, see --size].
    #[arg(long)]
    pub choices: Option<String>,
    /// Choose sections, joists and boards so that all checks pass at least price, mass or carbon of the frame.
    #[arg(long, value_enum, value_name = "GOAL", default_value_t = Goal::Price, conflicts_with = "choices")]
    pub size: Goal,
    /// Day of issue, YYYY-MM-DD [default: today, UTC]; the quote is valid for 30 days.
    #[arg(long, value_name = "DATE")]
    pub date: Option<String>,
    /// Output folder.
    #[arg(long)]
    pub out: PathBuf,
    #[command(flatten)]
    pub import: Import,
}

#[derive(Args)]
pub struct Evaluate {
    /// Voxel files.
    #[arg(required_unless_present = "batch")]
    pub voxels: Vec<PathBuf>,
    /// Brief.
    #[arg(long)]
    pub brief: PathBuf,
    /// Price book instead of the brief's; one that "extends" another replaces or adds single rates.
    #[arg(long, value_name = "FILE")]
    pub prices: Option<PathBuf>,
    /// Read candidates as JSON lines on stdin; an empty line closes a batch.
    #[arg(long, conflicts_with = "voxels")]
    pub batch: bool,
    /// In a batch, read `stairs` and `choices` (sections, joists, boards) beside the labels, as `houscaper vary` writes them.
    #[arg(long, requires = "batch")]
    pub genome: bool,
    /// Section and joist choices of the houses: a file or JSON, e.g. '{"wall_section": "C24 T_60x200"}' [default: the first option of each].
    #[arg(long, value_name = "JSON", conflicts_with = "batch")]
    pub choices: Option<String>,
    #[command(flatten)]
    pub import: Import,
}

#[derive(Args)]
#[command(after_long_help = SOLVE_OUTPUT)]
pub struct Solve {
    /// Frame file.
    pub frame: PathBuf,
    /// Places along every member at which --json gives its internal forces, ends included; 0 leaves `along` out.
    #[arg(long, value_name = "N", default_value_t = 5)]
    pub stations: usize,
    /// First buckling load factor of every case and combination, members cut into N pieces (4 when no N is given; 1 leaves
    /// members straight between their ends).
    #[arg(long, value_name = "N", num_args = 0..=1, default_missing_value = "4", value_parser = clap::value_parser!(u8).range(1..=32))]
    pub buckling: Option<u8>,
    /// Solve N times, for timing: the run of least time is stated.
    #[arg(long, value_name = "N", default_value_t = 1)]
    pub repeat: usize,
}

/// What `solve` answers.
const SOLVE_OUTPUT: &str = include_str!("solve/output.txt");

#[derive(Args)]
pub struct Schema {
    /// Which format.
    #[arg(value_enum)]
    pub format: Format,
}

#[derive(Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum Format {
    /// houscaper.brief/1
    Brief,
    /// houscaper.tileset/1
    Tileset,
    /// houscaper.member/1
    Member,
}
