//! Whether a house stands on its plot and keeps what the brief gives.

use std::path::Path;

use houscaper::brief::{Brief, Keep};
use houscaper::voxels::rules::Violation;
use houscaper::voxels::{Given, House, STOREY_MODULES};

use super::super::failure::{Failure, bad_input};
use super::super::input::site;

/// A brief's plot, mask and given cells, read once.
pub struct Site {
    modules: [usize; 3],
    /// Plan cells that may be built on, x fastest; `None`: all.
    buildable: Option<Vec<bool>>,
    given: Option<(Given, Keep)>,
    /// For each voxel of the plot whether the envelope bars it, x fastest.
    barred: Option<Vec<bool>>,
}

impl Site {
    /// The site of a brief whose lattice is looked for in `folder`.
    pub fn new(brief: &Brief, folder: &Path) -> Result<Site, Failure> {
        // Rows of the mask run from north to south, plan cells from south to north.
        let buildable =
            brief.plot.mask.as_ref().map(|rows| rows.iter().rev().flat_map(|r| r.bytes().map(|b| b == b'#')).collect());
        let site = site::Site::read(brief, folder, &|_| ())?;
        let given = match (&brief.given, site.given) {
            (Some(asked), Some(read)) => Some((inside(read.given, brief.plot.modules)?, asked.keep)),
            _ => None,
        };
        Ok(Site { modules: brief.plot.modules, buildable, given, barred: site.barred })
    }

    /// Voxels outside the plot, on cells not to be built on, and given cells not kept; one violation each.
    pub fn violations(&self, house: &House) -> Vec<Violation> {
        let [nx, ny, nz] = self.modules;
        let size = format!("reach beyond the plot of {nx} x {ny} x {nz} modules");
        let outside = |[x, y, z]: [usize; 3]| x >= nx || y >= ny || z >= nz;
        let barred = |[x, y, z]: [usize; 3]| {
            !outside([x, y, z]) && self.buildable.as_ref().is_some_and(|cells| !cells[x + nx * y])
        };
        let beyond = |[x, y, z]: [usize; 3]| {
            !outside([x, y, z]) && self.barred.as_ref().is_some_and(|barred| barred[x + nx * (y + ny * z)])
        };
        let filled = |wrong: &dyn Fn([usize; 3]) -> bool| -> Vec<[usize; 3]> {
            house.voxels.iter().filter(|(v, label)| label.is_filled() && wrong(*v)).map(|(v, _)| v).collect()
        };
        let [lost, built, changed] = self.given_voxels(house);
        [
            ("plot.modules", filled(&outside), size.as_str(), "move them inside or enlarge plot.modules"),
            ("plot.mask", filled(&barred), "stand on cells that plot.mask bars", "move them or change plot.mask"),
            ("plot.envelope", filled(&beyond), "lie outside plot.envelope", "move them inside or change the envelope"),
            ("given.filled", lost, "are given as filled and are empty", "fill them"),
            ("given.labels", changed, "have another label than the given one", "give them the label of the lattice"),
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
        if self.buildable.is_none()
            && self.given.is_none()
            && self.barred.is_none()
            && house.voxels.shape() == self.modules
        {
            return 0.0;
        }
        self.violations(house).iter().map(|v| v.amount).sum()
    }

    /// Given cells that the house has lost, cells it fills though they are given as empty, and given labels it has changed.
    fn given_voxels(&self, house: &House) -> [Vec<[usize; 3]>; 3] {
        let [mut lost, mut built, mut changed] = [const { Vec::new() }; 3];
        let Some((given, keep)) = &self.given else { return [lost, built, changed] };
        let [nx, ny, _] = given.shape;
        for (at, zone) in given.mask.iter().enumerate() {
            let voxel = [at % nx, at / nx % ny, at / (nx * ny)];
            let label = house.voxels.at(voxel.map(|c| c as isize));
            let filled = label.is_filled();
            // A plate that roofs the storey underneath does not count as filling the cell above it.
            let plate = voxel[2].is_multiple_of(STOREY_MODULES);
            match *zone >= 0 {
                true if !filled && *keep != Keep::Empty => lost.push(voxel),
                true if *keep == Keep::Labels && i32::from(label.code()) != *zone => changed.push(voxel),
                false if filled && !plate && matches!(keep, Keep::Empty | Keep::Both) => built.push(voxel),
                _ => {}
            }
        }
        [lost, built, changed]
    }
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
