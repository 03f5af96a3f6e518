//! Zoning and envelope lattices: occupied cells become modules.

use anyhow::Context;
use houscaper::voxels::lattice::{Lattice, Occupancy};
use houscaper::voxels::rules::{self, RuleSettings};
use houscaper::voxels::{Given, House, Module, Resample, ScaleReport, resample};

use super::super::args::Convert;
use super::super::check::plural;
use super::super::failure::{Blame, Failure, bad_input};
use super::super::input;

/// The occupied part of a lattice in modules, labelled by layer, each voxel with the zone of its cell.
pub fn read(args: &Convert) -> Result<House, Failure> {
    let name = args.input.display().to_string();
    if args.input.extension().is_none_or(|e| e != "csv" && e != "npy") {
        return Err(bad_input(format!(
            "{name}: --occupied, --cell-modules, --crop and --ground read lattices only, .csv or .npy"
        )));
    }
    let read = input::lattice(&input::bytes(&args.input)?, &args.input)?;
    let (unit, minbound) = (args.import.module.unwrap_or(read.unit), args.import.origin.unwrap_or(read.minbound));
    let lattice = Lattice { unit, minbound, ..read };
    let rule = Occupancy::require(args.import.occupied.as_deref()).context("--occupied").input()?;
    let module = Module::default();
    let how = Resample { cell_modules: args.cell_modules, offset: [0; 3], ground: args.ground, crop: crop(args) };
    let given = resample(&lattice, &rule, &module, &how).context(name).input()?;
    report(&lattice, &given.report, &module);
    let mut voxels = given.to_voxels(module);
    voxels.origin_m = origin_m(&lattice, &how, &module);
    let house = House { zones: zones(&given), ..House::new(voxels) };
    let loose = rules::check(&house, &RuleSettings::default()).into_iter().find(|v| v.rule == "one-body");
    if let Some(loose) = loose {
        eprintln!("note: {}; --crop takes a connected part", loose.message);
    }
    Ok(house)
}

/// The flag names the last cell, the library the one past it.
fn crop(args: &Convert) -> Option<[[usize; 3]; 2]> {
    let [x0, y0, z0, x1, y1, z1] = args.crop?;
    Some([[x0, y0, z0], [x1, y1, z1].map(|c| c.saturating_add(1))])
}

/// Where voxel (0, 0, 0) is centred when the first cell's low corner stays in place; a body set on the ground stands at z = 0.
fn origin_m(lattice: &Lattice, how: &Resample, module: &Module) -> [f64; 3] {
    let first = how.crop.map_or([0; 3], |[first, _]| first);
    let mut origin = [0, 1, 2].map(|a| {
        let low_corner = lattice.minbound[a] + (first[a] as f64 - 0.5) * lattice.unit[a];
        low_corner + 0.5 * module.size_m[a]
    });
    if how.ground {
        origin[2] = 0.0;
    }
    origin
}

/// Zone ids per voxel; none at all where the lattice knows a single one.
fn zones(given: &Given) -> Vec<i32> {
    let several = given.mask.iter().any(|z| *z > 0);
    if several { given.mask.clone() } else { Vec::new() }
}

/// Says what the change of scale did.
fn report(lattice: &Lattice, scale: &ScaleReport, module: &Module) {
    let product = |v: [f64; 3]| v.map(|x| format!("{}", (x * 1e6).round() / 1e6)).join(" x ");
    let [cx, cy, cz] = scale.cell_modules;
    let made = [0, 1, 2].map(|a| scale.cell_modules[a] as f64 * module.size_m[a]);
    eprintln!("{} occupied cell{} of {} m taken", scale.cells, plural(scale.cells), product(lattice.unit));
    eprintln!("one cell becomes {cx} x {cy} x {cz} modules = {} m", product(made));
    if scale.error_m.iter().any(|e| e.abs() > 1e-9) {
        let [dx, dy, dz] = scale.default_cell_modules;
        let factors = scale.scale.map(|s| format!("{s:.3}")).join(", ");
        eprintln!(
            "scale changed by {factors} along x, y, z ({dx} x {dy} x {dz} modules a cell are nearest to true scale)"
        );
    } else {
        eprintln!("true to scale");
    }
}
