//! Reading voxel files and briefs from the command line.

use std::path::{Path, PathBuf};

use anyhow::Context;
use houscaper::brief::{Brief, read_brief};
use houscaper::score::{Evaluator, Paths};
use houscaper::voxels::lattice::{Occupancy, read_lattice};
use houscaper::voxels::{House, Label, VoxelArray, infer_stairs, json, text};

use super::args::Import;
use super::failure::{Blame, Failure, bad_input};
use super::home;

/// The bytes of an input file.
pub fn bytes(path: &Path) -> Result<Vec<u8>, Failure> {
    std::fs::read(path).with_context(|| format!("cannot read {}", path.display())).input()
}

/// A house from Houscaper JSON, a text file, or a lattice CSV of labels (or of anything else with `--occupied`).
pub fn house(path: &Path, import: &Import) -> Result<House, Failure> {
    let name = path.display().to_string();
    let bytes = bytes(path)?;
    match path.extension().and_then(|e| e.to_str()) {
        Some("json") => json::read(&bytes, &name).input(),
        Some("txt") => {
            let text = String::from_utf8(bytes).with_context(|| format!("{name}: expected UTF-8 text")).input()?;
            Ok(labelled(text::parse(&text).with_context(|| name).input()?))
        }
        Some("csv") => lattice_house(&bytes, &name, import),
        _ => Err(bad_input(format!("{name}: expected a file ending in .json, .csv or .txt"))),
    }
}

fn lattice_house(bytes: &[u8], name: &str, import: &Import) -> Result<House, Failure> {
    let lattice = read_lattice(bytes, name).input()?;
    let Some(rule) = &import.occupied else {
        let voxels = lattice
            .to_voxels()
            .with_context(|| {
                format!("{name}: not a lattice of labels; say what counts as occupied, e.g. --occupied \">= 0\"")
            })
            .input()?;
        return Ok(labelled(voxels));
    };
    let occupancy: Occupancy = rule.parse().context("--occupied").input()?;
    let mask = lattice.mask(&occupancy).with_context(|| name.to_owned()).input()?;
    let labels = mask.iter().map(|&m| if m { Label::Base } else { Label::Empty }).collect();
    let voxels = VoxelArray::from_labels(lattice.shape, labels)
        .ok_or_else(|| bad_input(format!("{name}: the lattice's shape and its values disagree")))?;
    Ok(House::new(voxels))
}

/// Labels alone: stairs are read from the voids of the plates.
pub fn labelled(voxels: VoxelArray) -> House {
    House { stairs: infer_stairs(&voxels), ..House::new(voxels) }
}

/// A brief and its folder.
pub fn brief(path: &Path) -> Result<(Brief, PathBuf), Failure> {
    let brief = read_brief(&bytes(path)?, &path.display().to_string()).input()?;
    let folder = path.parent().map_or_else(PathBuf::new, Path::to_path_buf);
    Ok((brief, folder))
}

/// Everything a brief names, loaded.
pub fn evaluator(brief: Brief, folder: PathBuf) -> Result<Evaluator, Failure> {
    let near = if folder.as_os_str().is_empty() { Path::new(".") } else { &folder };
    let home = home::find(Some(near));
    let configs = home.as_ref().map_or_else(|| folder.clone(), |h| h.join("configs"));
    let paths = Paths {
        configs,
        tileset: home::tileset(&brief.tileset, home.as_deref()),
        linear: home::tileset(&brief.linear, home.as_deref()),
        brief: folder,
    };
    Evaluator::load(brief, &paths).input()
}

/// The evaluator of a brief file, or of the shipped starter brief.
pub fn evaluator_for(path: Option<&Path>) -> Result<Evaluator, Failure> {
    let shipped = home::find(None).map(|h| h.join("configs/starter.json"));
    let path = path.map(Path::to_path_buf).or(shipped);
    let path = path
        .ok_or_else(|| bad_input("no --brief given and no shipped configs/starter.json found; set HOUSCAPER_HOME"))?;
    let (brief, folder) = brief(&path)?;
    evaluator(brief, folder)
}
