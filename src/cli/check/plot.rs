//! Whether a house stands on its plot and keeps what the brief gives.

use std::path::Path;

use anyhow::Context;
use houscaper::brief::{Brief, Given as AskedGiven, Keep};
use houscaper::voxels::lattice::{Occupancy, read_lattice};
use houscaper::voxels::rules::Violation;
use houscaper::voxels::{Given, House, Module, Resample, STOREY_MODULES, resample};

use super::super::failure::{Blame, Failure, bad_input};
use super::super::input;

/// A brief's plot, mask and given cells, read once.
pub struct Site {
    modules: [usize; 3],
    /// Plan cells that may be built on, x fastest; `None`: all.
    buildable: Option<Vec<bool>>,
    given: Option<(Given, Keep)>,
}

impl Site {
    /// The site of a brief whose lattice is looked for in `folder`.
    pub fn new(brief: &Brief, folder: &Path) -> Result<Site, Failure> {
        // Rows of the mask run from north to south, plan cells from south to north.
        let buildable =
            brief.plot.mask.as_ref().map(|rows| rows.iter().rev().flat_map(|r| r.bytes().map(|b| b == b'#')).collect());
        let given = match &brief.given {
            Some(asked) => Some((inside(resampled(asked, folder)?, brief.plot.modules)?, asked.keep)),
            None => None,
        };
        Ok(Site { modules: brief.plot.modules, buildable, given })
    }

    /// Voxels outside the plot, on cells not to be built on, and given cells not kept; one violation each.
    pub fn violations(&self, house: &House) -> Vec<Violation> {
        let [nx, ny, nz] = self.modules;
        let size = format!("reach beyond the plot of {nx} x {ny} x {nz} modules");
        let outside = |[x, y, z]: [usize; 3]| x >= nx || y >= ny || z >= nz;
        let barred = |[x, y, z]: [usize; 3]| {
            !outside([x, y, z]) && self.buildable.as_ref().is_some_and(|cells| !cells[x + nx * y])
        };
        let filled = |wrong: &dyn Fn([usize; 3]) -> bool| -> Vec<[usize; 3]> {
            house.voxels.iter().filter(|(v, label)| label.is_filled() && wrong(*v)).map(|(v, _)| v).collect()
        };
        let (lost, built) = self.given_voxels(house);
        [
            ("plot.modules", filled(&outside), size.as_str(), "move them inside or enlarge plot.modules"),
            ("plot.mask", filled(&barred), "stand on cells that plot.mask bars", "move them or change plot.mask"),
            ("given.filled", lost, "are given as filled and are empty", "fill them"),
            ("given.empty", built, "are given as empty and are filled", "empty them"),
        ]
        .into_iter()
        .filter(|(_, voxels, ..)| !voxels.is_empty())
        .map(|(rule, voxels, what, fix)| Violation {
            rule,
            message: format!("{} voxels {what}", voxels.len()),
            fix: fix.to_owned(),
            cube: None,
            amount: voxels.len() as f64,
            voxels,
        })
        .collect()
    }

    /// Sum of the amounts of [`Site::violations`]: 0 when the house keeps the site.
    pub fn violation(&self, house: &House) -> f64 {
        if self.buildable.is_none() && self.given.is_none() && house.voxels.shape() == self.modules {
            return 0.0;
        }
        self.violations(house).iter().map(|v| v.amount).sum()
    }

    /// Given cells that the house has lost, and cells it fills though they are given as empty.
    fn given_voxels(&self, house: &House) -> (Vec<[usize; 3]>, Vec<[usize; 3]>) {
        let (mut lost, mut built) = (Vec::new(), Vec::new());
        let Some((given, keep)) = &self.given else { return (lost, built) };
        let [nx, ny, _] = given.shape;
        for (at, zone) in given.mask.iter().enumerate() {
            let voxel = [at % nx, at / nx % ny, at / (nx * ny)];
            let filled = house.voxels.at(voxel.map(|c| c as isize)).is_filled();
            // A plate that roofs the storey underneath does not count as filling the cell above it.
            let plate = voxel[2].is_multiple_of(STOREY_MODULES);
            match *zone >= 0 {
                true if !filled && *keep != Keep::Empty => lost.push(voxel),
                false if filled && !plate && *keep != Keep::Filled => built.push(voxel),
                _ => {}
            }
        }
        (lost, built)
    }
}

/// The given lattice of a brief in modules of its plot.
fn resampled(asked: &AskedGiven, folder: &Path) -> Result<Given, Failure> {
    let path = folder.join(&asked.lattice);
    let name = path.display().to_string();
    let lattice = read_lattice(&input::bytes(&path)?, &name).input()?;
    let rule: Occupancy = asked.occupied.parse().context("given.occupied").input()?;
    let mut offset = [0; 3];
    for (to, &from) in offset.iter_mut().zip(&asked.offset) {
        *to = usize::try_from(from)
            .map_err(|_| bad_input(format!("given.offset is {:?}: expected whole numbers from 0", asked.offset)))?;
    }
    // A brief's crop names its last cell, the library's the one past it.
    let crop = asked.crop.map(|[first, last]| [first, last.map(|c| c.saturating_add(1))]);
    let how = Resample { cell_modules: asked.cell_modules, offset, ground: asked.ground, crop };
    resample(&lattice, &rule, &Module::default(), &how).context(name).input()
}

/// Refuses given cells beyond the plot, which no house could keep.
fn inside(given: Given, plot: [usize; 3]) -> Result<Given, Failure> {
    let [nx, ny, _] = given.shape;
    let voxels = given
        .mask
        .iter()
        .enumerate()
        .filter(|(_, zone)| **zone >= 0)
        .map(|(at, _)| [at % nx, at / nx % ny, at / (nx * ny)]);
    let beyond = voxels.into_iter().find(|v| (0..3).any(|a| v[a] >= plot[a]));
    match beyond {
        None => Ok(given),
        Some(voxel) => Err(bad_input(format!(
            "`given`: its cells take {:?} modules and reach module {voxel:?}, beyond plot.modules {plot:?}; enlarge the plot, crop the \
             lattice or give smaller cell_modules",
            given.shape
        ))),
    }
}
