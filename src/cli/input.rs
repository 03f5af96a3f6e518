//! Reading voxel files and briefs from the command line.

pub mod massing;
pub mod site;
mod vox;

use std::path::{Path, PathBuf};

use anyhow::Context;
use houscaper::brief::{Brief, read_brief};
use houscaper::score::{Evaluator, Paths};
use houscaper::voxels::lattice::{Lattice, LatticeError, Occupancy, RowOrder, read_lattice, read_npy};
use houscaper::voxels::{House, Label, Module, VoxelArray, infer_stairs, json, samples, text};

use super::args::Import;
use super::failure::{Blame, Failure, bad_input};
use super::home;

/// The bytes of an input file.
pub fn bytes(path: &Path) -> Result<Vec<u8>, Failure> {
    std::fs::read(path).with_context(|| format!("cannot read {}", path.display())).input()
}

/// A house from a voxel file, or from a massing with `--house`.
pub fn house(path: &Path, import: &Import) -> Result<House, Failure> {
    let house = voxels(path, import)?;
    if import.house { massing::dressed(house, path) } else { Ok(house) }
}

/// What a file holds: Houscaper JSON, text, .vox, or a lattice (CSV or .npy) of labels (or of anything else with `--occupied`); or a
/// house that comes with the program.
pub fn voxels(path: &Path, import: &Import) -> Result<House, Failure> {
    let name = path.display().to_string();
    let extension = path.extension().and_then(|e| e.to_str());
    if extension != Some("vox") && (import.voxel_m.is_some() || import.colours.is_some()) {
        return Err(bad_input(format!("{name}: --voxel-m and --colours read .vox files only")));
    }
    if !matches!(extension, Some("csv" | "npy")) && import.occupied.is_some() {
        return Err(bad_input(format!("{name}: --occupied reads lattices only, .csv or .npy")));
    }
    if !matches!(extension, Some("npy" | "vox" | "txt")) && (import.module.is_some() || import.origin.is_some()) {
        return Err(bad_input(format!(
            "{name}: says its module and origin itself; --module and --origin are for .npy, .vox and .txt"
        )));
    }
    let house = of_format(path, &name, extension, import)?;
    placed(house, import)
}

/// The module and the origin of the command line, where there are any.
fn placed(mut house: House, import: &Import) -> Result<House, Failure> {
    let module = import.module.map_or(house.voxels.module, |size_m| Module { size_m });
    if module.size_m.iter().any(|s| *s <= 0.0) {
        return Err(bad_input(format!("--module {:?}: expected three lengths above 0, in metres", module.size_m)));
    }
    house.voxels.module = module;
    house.voxels.origin_m = import.origin.unwrap_or(house.voxels.origin_m);
    Ok(house)
}

fn of_format(path: &Path, name: &str, extension: Option<&str>, import: &Import) -> Result<House, Failure> {
    if let Some(name) = path.to_str().and_then(|p| p.strip_prefix("sample:")) {
        return sample(name);
    }
    let bytes = bytes(path)?;
    match extension {
        Some("vox") => vox::house(&bytes, name, import),
        Some("json") => json::read(&bytes, name).input(),
        Some("txt") => {
            let text = String::from_utf8(bytes).with_context(|| format!("{name}: expected UTF-8 text")).input()?;
            Ok(labelled(text::parse(&text).with_context(|| name.to_owned()).input()?))
        }
        Some("csv" | "npy") => lattice_house(&lattice(&bytes, path)?, name, import),
        _ => Err(bad_input(format!("{name}: expected a file ending in .json, .csv, .npy, .txt or .vox"))),
    }
}

/// A house that comes with the program.
fn sample(name: &str) -> Result<House, Failure> {
    let mut houses: Vec<_> = samples::gallery();
    houses.extend(samples::all());
    let names: Vec<&str> = houses.iter().map(|(n, _)| *n).collect();
    let unknown = bad_input(format!("sample:{name}: unknown; there are {}", names.join(", ")));
    houses.into_iter().find(|(n, _)| *n == name).map(|(_, house)| house).ok_or(unknown)
}

/// A lattice from the bytes of a .csv or .npy file; what the latter does not say is the module and the origin of ours.
pub fn lattice(bytes: &[u8], path: &Path) -> Result<Lattice, Failure> {
    let name = path.display().to_string();
    if path.extension().is_some_and(|e| e == "npy") {
        return Ok(Lattice { unit: Module::default().size_m, ..read_npy(bytes, &name).input()? });
    }
    read_lattice(bytes, &name).input()
}

fn lattice_house(lattice: &Lattice, name: &str, import: &Import) -> Result<House, Failure> {
    let Some(rule) = &import.occupied else {
        let voxels = lattice.to_voxels().map_err(|error| no_labels(&error, lattice, name))?;
        return Ok(labelled(voxels));
    };
    let occupancy: Occupancy = rule.parse().context("--occupied").input()?;
    let mask = lattice.mask(&occupancy).with_context(|| name.to_owned()).input()?;
    let labels = mask.iter().map(|&m| if m { Label::Base } else { Label::Empty }).collect();
    let mut voxels = VoxelArray::from_labels(lattice.shape, labels)
        .ok_or_else(|| bad_input(format!("{name}: the lattice's shape and its values disagree")))?;
    voxels.module = Module { size_m: lattice.unit };
    voxels.origin_m = lattice.minbound;
    Ok(House::new(voxels))
}

/// The error of a lattice that holds no labels, with the line of the first cell that is none.
fn no_labels(error: &LatticeError, lattice: &Lattice, name: &str) -> Failure {
    let LatticeError::Label { cell: [x, y, z], found } = error else { return bad_input(format!("{name}: {error}")) };
    let [nx, ny, nz] = lattice.shape;
    let row = match lattice.style.order {
        RowOrder::C => z + nz * (y + ny * x),
        RowOrder::F => x + nx * (y + ny * z),
    };
    let line = row + if lattice.style.metadata { 7 } else { 2 };
    let at = if name.ends_with(".npy") { name.to_owned() } else { format!("{name}:{line}") };
    bad_input(format!(
        "{at}: cell [{x}, {y}, {z}] has value {found}, which is no label (0 to 5); for a lattice of other values say \
         what counts as occupied, e.g. --occupied \">= 0\""
    ))
}

/// Labels alone: stairs are read from the voids of the plates.
pub fn labelled(voxels: VoxelArray) -> House {
    let stairs = infer_stairs(&voxels);
    for stair in &stairs {
        eprintln!(
            "note: labels hold no stairs; from the void over storey {} a {:?} stair starting at cell {:?} is assumed (Houscaper JSON keeps the stair itself)",
            stair.storey, stair.kind, stair.start
        );
    }
    House { stairs, ..House::new(voxels) }
}

/// A brief and its folder.
pub fn brief(path: &Path) -> Result<(Brief, PathBuf), Failure> {
    let brief = read_brief(&bytes(path)?, &path.display().to_string()).input()?;
    let folder = path.parent().map_or_else(PathBuf::new, Path::to_path_buf);
    Ok((brief, folder))
}

/// Where the files are that a brief names; `folder` is the brief's own.
pub fn paths(brief: &Brief, folder: &Path) -> Paths {
    let near = if folder.as_os_str().is_empty() { Path::new(".") } else { folder };
    let home = home::find(Some(near));
    Paths {
        configs: home.as_ref().map_or_else(|| folder.to_path_buf(), |h| h.join("configs")),
        tileset: home::tileset(&brief.tileset, home.as_deref()),
        linear: home::tileset(&brief.linear, home.as_deref()),
        brief: folder.to_path_buf(),
    }
}

/// Everything a brief names, loaded.
pub fn evaluator(brief: Brief, folder: PathBuf) -> Result<Evaluator, Failure> {
    let paths = paths(&brief, &folder);
    Evaluator::load(brief, &paths).input()
}

/// The evaluator of a brief file, or of the shipped starter brief, with a price book of the command line in place of the brief's.
pub fn evaluator_for(path: Option<&Path>, prices: Option<&Path>) -> Result<Evaluator, Failure> {
    let path = path.map_or_else(shipped_brief, |path| Ok(path.to_path_buf()))?;
    let (mut brief, folder) = brief(&path)?;
    own_prices(&mut brief, prices)?;
    evaluator(brief, folder)
}

/// Puts a price book from the command line in place of the brief's.
pub fn own_prices(brief: &mut Brief, prices: Option<&Path>) -> Result<(), Failure> {
    let Some(path) = prices else { return Ok(()) };
    let path = std::path::absolute(path).with_context(|| format!("--prices {}", path.display())).input()?;
    let text =
        path.to_str().ok_or_else(|| bad_input(format!("--prices {}: expected a path in UTF-8", path.display())))?;
    brief.prices = text.to_owned();
    Ok(())
}

/// What a house is called: its file without ending, a sample without its prefix.
pub fn name_of(voxels: &Path) -> String {
    let name = voxels.file_stem().map_or_else(|| "house".into(), |s| s.to_string_lossy().into_owned());
    name.strip_prefix("sample:").map_or(name.clone(), str::to_owned)
}

/// The starter brief that ships.
pub fn shipped_brief() -> Result<PathBuf, Failure> {
    let shipped = home::find(None).map(|h| h.join("configs/starter.json"));
    shipped.ok_or_else(|| bad_input("no --brief given and no shipped configs/starter.json found; set HOUSCAPER_HOME"))
}
