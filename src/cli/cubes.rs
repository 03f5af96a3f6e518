//! `houscaper cubes`: the ids of all cubes of the padded array as a lattice.

use houscaper::cubes::{self, CornerOrder, IdScheme, cube_ids, scan_masks};
use houscaper::voxels::VoxelArray;
use houscaper::voxels::lattice::{Lattice, Values, write_lattice};

use super::args;
use super::check::plural;
use super::failure::{Failure, Outcome, bad_input};
use super::{input, output};

/// Most cubes named one by one.
const MOST_CUBES: usize = 20;

pub fn run(args: args::Cubes) -> Outcome {
    output::check_target(&args.out, &args.voxels)?;
    let voxels = input::house(&args.voxels, &args.import)?.voxels;
    let scheme = match args.scheme {
        args::Scheme::Thesis => IdScheme::Thesis,
        args::Scheme::Topogenesis => IdScheme::TopoGenesis,
    };
    let order = match args.corner_order {
        args::CornerOrder::FOrder => CornerOrder::FOrder,
        args::CornerOrder::BoxCorners => CornerOrder::BoxCorners,
    };
    let lattice = ids(&voxels, scheme, order)?;
    output::write(&args.out, &write_lattice(&lattice))?;
    let [nx, ny, nz] = lattice.shape;
    eprintln!("{}: {nx} x {ny} x {nz} cube ids, corner order {}", args.out.display(), order.name());
    report_inadmissible(&voxels);
    Ok(())
}

/// The ids as a lattice: its cell (0, 0, 0) is the cube at the padded array's first corner. Cells stand where the first corner of their
/// cube stands, as `boolean_marching_cubes()` has it; between corners topoGenesis would round them to its grid and refuse odd shapes.
fn ids(voxels: &VoxelArray, scheme: IdScheme, order: CornerOrder) -> Result<Lattice, Failure> {
    let ids = cube_ids(voxels, scheme, order);
    let unit = voxels.module.size_m;
    let minbound = [0, 1, 2].map(|a| voxels.origin_m[a] - unit[a]);
    let values = Values::Number(ids.ids.into_iter().map(f64::from).collect());
    Lattice::new(ids.shape, minbound, unit, values).ok_or_else(|| bad_input("the array has no voxels"))
}

/// Cubes of the padded array for which no tile exists.
pub fn inadmissible(voxels: &VoxelArray) -> Vec<([usize; 3], cubes::Mask)> {
    let mut bad = Vec::new();
    scan_masks(voxels, |cube, mask| {
        if !mask.is_allowed() {
            bad.push((cube, mask));
        }
    });
    bad
}

fn report_inadmissible(voxels: &VoxelArray) {
    let bad = inadmissible(voxels);
    if bad.is_empty() {
        return;
    }
    eprintln!(
        "{} inadmissible cube{} (no tile exists; `houscaper convert --repair` mends them):",
        bad.len(),
        plural(bad.len())
    );
    for (cube, mask) in bad.iter().take(MOST_CUBES) {
        eprintln!("  cube {cube:?}: filled corners {}", mask.pattern());
    }
    if bad.len() > MOST_CUBES {
        eprintln!("  and {} more", bad.len() - MOST_CUBES);
    }
}
