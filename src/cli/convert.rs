//! `houscaper convert`: between lattice CSV, .npy, .vox, Houscaper's JSON and text; zoning lattices to modules; repair; dressing.

mod values;
mod zoning;

use std::path::{Path, PathBuf};

use anyhow::Context;
use houscaper::voxels::lattice::{Lattice, read_lattice, write_lattice, write_npy};
use houscaper::voxels::{House, Module, infer_stairs, json, repair, text, vox};

use super::args::Convert;
use super::check::plural;
use super::cubes::inadmissible;
use super::failure::{Blame, Failure, Outcome, bad_input};
use super::{input, output};

/// What a voxel file is written as.
#[derive(Clone, Copy)]
enum Target {
    Csv,
    Json,
    Npy,
    Text,
    Vox,
}

pub fn run(args: Convert) -> Outcome {
    let target = target(&args.output)?;
    output::check_target(&args.output, &args.input)?;
    if let Some(lattice) = values::read(&args)? {
        return values::write(&args, &lattice);
    }
    let zoning = args.import.occupied.is_some() || args.cell_modules.is_some() || args.crop.is_some() || args.ground;
    let mut house = if zoning { zoning::read(&args)? } else { input::voxels(&args.input, &args.import)? };
    if args.repair {
        mend(&mut house);
    }
    if args.import.house {
        house = input::massing::dressed(house, &args.input)?;
    }
    let bytes = match target {
        Target::Csv => csv(&house, Some(&args.input).filter(|_| !zoning))?,
        Target::Json => json::write(&house).into_bytes(),
        Target::Npy => write_npy(&Lattice::from_voxels(&house.voxels)),
        Target::Text => text::write(&house.voxels).into_bytes(),
        Target::Vox => vox::write(&house.voxels).with_context(|| args.output.display().to_string()).input()?,
    };
    output::write(&args.output, &bytes)?;
    report(&args, &house, target);
    Ok(())
}

fn target(path: &Path) -> Result<Target, Failure> {
    match path.extension().and_then(|e| e.to_str()) {
        Some("csv") => Ok(Target::Csv),
        Some("json") => Ok(Target::Json),
        Some("npy") => Ok(Target::Npy),
        Some("txt") => Ok(Target::Text),
        Some("vox") => Ok(Target::Vox),
        _ => {
            Err(bad_input(format!("{}: expected an output ending in .csv, .npy, .json, .txt or .vox", path.display())))
        }
    }
}

/// Labels as a lattice, in the style of the input when that is a lattice too, so that nothing but changed labels differs.
fn csv(house: &House, input: Option<&PathBuf>) -> Result<Vec<u8>, Failure> {
    let mut lattice = Lattice::from_voxels(&house.voxels);
    if let Some(input) = input.filter(|i| i.extension().is_some_and(|e| e == "csv")) {
        lattice.style = read_lattice(&input::bytes(input)?, &input.display().to_string()).input()?.style;
    }
    Ok(write_lattice(&lattice))
}

/// Makes every cube admissible and lists the changed voxels; zones follow their voxels.
fn mend(house: &mut House) {
    let (mended, changed) = repair(&house.voxels);
    let filled = changed.iter().filter(|v| mended.get(**v).is_filled()).count();
    eprintln!(
        "repair: {} voxel{} changed ({filled} filled, {} emptied)",
        changed.len(),
        plural(changed.len()),
        changed.len() - filled
    );
    for &voxel in &changed {
        eprintln!("  {voxel:?}: {} -> {}", house.voxels.get(voxel).name(), mended.get(voxel).name());
        if let Some(zone) = house.zones.get_mut(mended.index(voxel)).filter(|_| !mended.get(voxel).is_filled()) {
            *zone = -1;
        }
    }
    house.voxels = mended;
}

fn report(args: &Convert, house: &House, target: Target) {
    let [nx, ny, nz] = house.voxels.shape();
    eprintln!("{}: {nx} x {ny} x {nz} modules, {} filled", args.output.display(), house.voxels.filled_count());
    if !house.zones.is_empty() && !matches!(target, Target::Json) {
        eprintln!("note: zones are stored in .json only");
    }
    if !matches!(target, Target::Json) && house.stairs != infer_stairs(&house.voxels) {
        eprintln!("note: these stairs cannot be told from labels; they are stored in .json only");
    }
    if matches!(target, Target::Npy | Target::Vox | Target::Text) && house.voxels.module != Module::default() {
        eprintln!(
            "note: the module's size of {:?} m is not stored; .json and .csv keep it, --module says it when the file is read",
            house.voxels.module.size_m
        );
    }
    let bad = inadmissible(&house.voxels).len();
    if bad > 0 {
        eprintln!("note: {bad} inadmissible cube{}; --repair mends them", plural(bad));
    }
}
