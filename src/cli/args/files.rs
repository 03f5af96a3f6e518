//! Commands that read and write voxel files: `convert`, `cubes`, and how voxel files are read.

use std::path::PathBuf;

use clap::{Args, ValueEnum};
use houscaper::voxels::vox::ColourMap;

/// How to read a voxel file.
#[derive(Args, Clone, Default)]
pub struct Import {
    /// For a lattice (CSV or .npy) that is not labels: what counts as occupied, e.g. ">= 0", "== True", "> 0.5".
    #[arg(long, value_name = "RULE")]
    pub occupied: Option<String>,
    /// For a .vox file whose voxels are not one module each: their size in metres, e.g. 0.3. A module is filled when half of it is.
    #[arg(long, value_name = "M")]
    pub voxel_m: Option<f64>,
    /// For a .vox file of another program: colours by palette index or #rrggbb and their labels, e.g. "157=window,246=empty".
    #[arg(long, value_name = "MAP")]
    pub colours: Option<ColourMap>,
    /// Size of a module in metres, for .npy, .vox and .txt, which do not say it [default: 0.9,0.9,0.54].
    #[arg(long, value_name = "X,Y,Z", value_parser = numbers::<3>, allow_hyphen_values = true, conflicts_with = "voxel_m")]
    pub module: Option<[f64; 3]>,
    /// Centre of the first voxel in metres, for the same [default: 0,0,0].
    #[arg(long, value_name = "X,Y,Z", value_parser = numbers::<3>, allow_hyphen_values = true)]
    pub origin: Option<[f64; 3]>,
    /// Make a house of a massing: footprints, storeys, roof, stairs, door and windows by the rules; labels are not used.
    #[arg(long)]
    pub house: bool,
}

#[derive(Args)]
pub struct Cubes {
    /// Voxels.
    pub voxels: PathBuf,
    /// Where to write the ids.
    #[arg(long)]
    pub out: PathBuf,
    /// Order of the eight corners in the thesis scheme.
    #[arg(long, value_enum, default_value_t = CornerOrder::FOrder)]
    pub corner_order: CornerOrder,
    /// Which id.
    #[arg(long, value_enum, default_value_t = Scheme::Thesis)]
    pub scheme: Scheme,
    #[command(flatten)]
    pub import: Import,
}

#[derive(Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum CornerOrder {
    /// x fastest, then y, then z.
    FOrder,
    /// The order of Rhino's BoxCorners.
    BoxCorners,
}

#[derive(Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum Scheme {
    /// Labels as digits in base 6, first corner most significant.
    Thesis,
    /// Occupancy bits, first corner least significant.
    Topogenesis,
}

#[derive(Args)]
#[command(after_long_help = FORMATS)]
pub struct Convert {
    /// Input: lattice CSV, numpy .npy, Houscaper JSON, text, MagicaVoxel .vox, or sample:NAME.
    pub input: PathBuf,
    /// Output; its extension decides: .csv, .npy, .json, .txt or .vox.
    pub output: PathBuf,
    /// Change the fewest voxels that make every cube admissible, and list them.
    #[arg(long)]
    pub repair: bool,
    /// Modules one lattice cell becomes, e.g. 4,4,6 (zoning lattices).
    #[arg(long, value_name = "X,Y,Z", value_parser = whole_numbers::<3>)]
    pub cell_modules: Option<[usize; 3]>,
    /// First and last lattice cell to take, e.g. 3,2,0,8,5,1.
    #[arg(long, value_name = "X0,Y0,Z0,X1,Y1,Z1", value_parser = whole_numbers::<6>)]
    pub crop: Option<[usize; 6]>,
    /// Set the lowest filled layer on the ground.
    #[arg(long)]
    pub ground: bool,
    #[command(flatten)]
    pub import: Import,
}

/// What the formats hold.
const FORMATS: &str = include_str!("../convert/formats.txt");

/// `N` whole numbers between commas.
fn whole_numbers<const N: usize>(text: &str) -> Result<[usize; N], String> {
    let numbers: Result<Vec<usize>, _> = text.split(',').map(|n| n.trim().parse()).collect();
    let numbers = numbers.ok().and_then(|n| <[usize; N]>::try_from(n).ok());
    numbers.ok_or_else(|| format!("expected {N} whole numbers between commas"))
}

/// `N` numbers between commas.
fn numbers<const N: usize>(text: &str) -> Result<[f64; N], String> {
    let numbers: Result<Vec<f64>, _> = text.split(',').map(|n| n.trim().parse()).collect();
    let numbers = numbers.ok().and_then(|n| <[f64; N]>::try_from(n).ok()).filter(|n| n.iter().all(|v| v.is_finite()));
    numbers.ok_or_else(|| format!("expected {N} numbers between commas"))
}
