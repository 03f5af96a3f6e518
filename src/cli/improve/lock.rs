//! `--lock`: which voxels stay as they are.

use std::path::Path;

use houscaper::search::improve::Locked;
use houscaper::voxels::House;
use houscaper::voxels::lattice::{Occupancy, read_lattice};

use crate::cli::failure::{Blame, Failure, bad_input};
use crate::cli::input;

/// The locked voxels of a house: of every flag a box of modules, or the filled cells of a lattice file.
pub fn locked(flags: &[String], house: &House) -> Result<Locked, Failure> {
    let shape = house.voxels.shape();
    let mut marked = vec![false; house.voxels.labels().len()];
    for flag in flags {
        if flag.ends_with(".csv") {
            for (mark, more) in marked.iter_mut().zip(lattice(flag, shape)?) {
                *mark |= more;
            }
            continue;
        }
        let ranges = ranges(flag, shape).map_err(|error| bad_input(format!("--lock {flag}: {error}")))?;
        for (voxel, _) in house.voxels.iter() {
            let inside = voxel.iter().zip(&ranges).all(|(c, [from, to])| (*from..*to).contains(c));
            marked[house.voxels.index(voxel)] |= inside;
        }
    }
    Ok(Locked::new(house, |voxel| marked[house.voxels.index(voxel)]))
}

/// Three ranges as in numpy: `from:to` without `to` itself, either left out, or a single number.
fn ranges(flag: &str, shape: [usize; 3]) -> Result<[[usize; 2]; 3], String> {
    let parts: Vec<&str> = flag.split(',').map(str::trim).collect();
    let parts: [&str; 3] = parts.try_into().map_err(|parts: Vec<&str>| {
        format!("{} parts, expected a lattice file ending in .csv, or three ranges x0:x1,y0:y1,z0:z1", parts.len())
    })?;
    let mut out = [[0; 2]; 3];
    for (a, part) in parts.into_iter().enumerate() {
        let (axis, most) = (["x", "y", "z"][a], shape[a]);
        let number = |text: &str, default: usize| match text.trim() {
            "" => Ok(default),
            text => text.parse().map_err(|_| format!("{axis} is `{part}`, expected from:to, : or a number")),
        };
        let [from, to] = match part.split_once(':') {
            Some((from, to)) => [number(from, 0)?, number(to, most)?],
            None if part.is_empty() => return Err(format!("{axis} is empty, expected from:to, : or a number")),
            None => number(part, 0).map(|n| [n, n.saturating_add(1)])?,
        };
        if from >= to || to > most {
            return Err(format!(
                "{axis} is `{part}`, expected a range inside the {most} modules of the house, the last not included"
            ));
        }
        out[a] = [from, to];
    }
    Ok(out)
}

/// The cells of a lattice file above 0, one per module of the house.
fn lattice(file: &str, shape: [usize; 3]) -> Result<Vec<bool>, Failure> {
    let lattice = read_lattice(&input::bytes(Path::new(file))?, file).input()?;
    if lattice.shape != shape {
        let found = lattice.shape;
        return Err(bad_input(format!(
            "--lock {file}: {found:?} cells, expected {shape:?}, one per module of the house"
        )));
    }
    let above: Occupancy = "> 0".parse().input()?;
    let mask = lattice.mask(&above).map_err(|error| bad_input(format!("--lock {file}: {error}")))?;
    // Both run x fastest.
    Ok(mask)
}
