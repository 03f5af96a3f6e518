//! What a brief's files say of its plot: given lattice, fields on its cells, envelope.

use std::path::Path;

use anyhow::Context;
use houscaper::brief::{Brief, Given as AskedGiven};
use houscaper::score::Evaluator;
use houscaper::search::from_brief::{self, site_space};
use houscaper::search::plot::Space;
use houscaper::voxels::lattice::{Lattice, Occupancy, read_lattice};
use houscaper::voxels::{Given, Hull, Module, Placement, Resample, field, resample};

use super::bytes;
use crate::cli::failure::{Blame, Failure, bad_input};

/// A given lattice with the fields on its cells.
pub struct GivenSite {
    /// As it was read.
    pub lattice: Lattice,
    /// In modules.
    pub given: Given,
    sun: Option<Vec<f64>>,
    entrances: Option<Vec<f64>>,
}

/// Everything of it.
#[derive(Default)]
pub struct Site {
    /// Given cells.
    pub given: Option<GivenSite>,
    /// For each voxel of the plot whether the envelope bars it, x fastest.
    pub barred: Option<Vec<bool>>,
}

impl Site {
    /// Reads the files that a brief in `folder` names; `tell` hears what happened to scales.
    pub fn read(brief: &Brief, folder: &Path, tell: &dyn Fn(&str)) -> Result<Site, Failure> {
        let given = brief.given.as_ref().map(|asked| given(asked, folder, tell)).transpose()?;
        let barred = barred(brief, folder, given.as_ref(), tell)?;
        Ok(Site { given, barred })
    }

    /// The space of the brief that `evaluator` was loaded from, on this site.
    pub fn space(&self, evaluator: &Evaluator) -> Result<Space, Failure> {
        let given = self.given.as_ref();
        let site = from_brief::Site {
            given: given.map(|g| &g.given),
            sun: given.and_then(|g| g.sun.as_deref()),
            entrances: given.and_then(|g| g.entrances.as_deref()),
            barred: self.barred.as_deref(),
        };
        let options = [0, 1, 2, 3].map(|g| evaluator.options[g].len());
        site_space(&evaluator.brief, &site, &evaluator.rules, options).input()
    }
}

fn given(asked: &AskedGiven, folder: &Path, tell: &dyn Fn(&str)) -> Result<GivenSite, Failure> {
    let read = |file: &str| {
        let path = folder.join(file);
        read_lattice(&bytes(&path)?, &path.display().to_string()).input()
    };
    let lattice = read(&asked.lattice)?;
    let occupancy: Occupancy = asked.occupied.parse().context("given.occupied").input()?;
    let offset = asked.offset.map(|o| usize::try_from(o).ok());
    let [Some(x), Some(y), Some(z)] = offset else {
        return Err(bad_input(format!("`given.offset` is {:?}: expected modules of at least 0", asked.offset)));
    };
    let how = Resample {
        cell_modules: asked.cell_modules,
        offset: [x, y, z],
        ground: asked.ground,
        crop: asked.crop.map(|[first, last]| [first, last.map(|l| l.saturating_add(1))]),
    };
    let given = resample(&lattice, &occupancy, &Module::default(), &how).context("given").input()?;
    let r = &given.report;
    tell(&format!(
        "given: {} cells of {}, each {:?} modules; scale x {:.3}, y {:.3}, z {:.3} of the lattice",
        r.cells, asked.lattice, r.cell_modules, r.scale[0], r.scale[1], r.scale[2]
    ));
    let values = |file: &Option<String>, key: &str| -> Result<Option<Vec<f64>>, Failure> {
        let Some(file) = file else { return Ok(None) };
        field(&read(file)?, &lattice, &given).with_context(|| format!("{key}: {file}")).input().map(Some)
    };
    let (sun, entrances) = (values(&asked.sun, "given.sun")?, values(&asked.entrances, "given.entrances")?);
    Ok(GivenSite { lattice, given, sun, entrances })
}

fn barred(
    brief: &Brief,
    folder: &Path,
    given: Option<&GivenSite>,
    tell: &dyn Fn(&str),
) -> Result<Option<Vec<bool>>, Failure> {
    let Some(asked) = &brief.plot.envelope else { return Ok(None) };
    let path = folder.join(&asked.file);
    let hull = Hull::read(&bytes(&path)?, &path.display().to_string()).context("plot.envelope").input()?;
    let placement = Placement::new(&hull, asked.scale, asked.origin, given.map(|g| (&g.lattice, &g.given)));
    let barred = placement.outside(&hull, brief.plot.modules, &Module::default());
    let layer = brief.plot.modules[0] * brief.plot.modules[1];
    let inside = barred[layer.min(barred.len())..].iter().filter(|b| !**b).count();
    tell(&format!(
        "envelope: {inside} of {} voxels above the ground lie inside {}; scale {:?}, corner of the plot at {:?} of the file",
        barred.len() - layer.min(barred.len()),
        asked.file,
        placement.scale,
        placement.origin
    ));
    if inside == 0 {
        return Err(bad_input(format!(
            "`plot.envelope`: no voxel of the plot lies inside {}, whose box reaches from {:?} to {:?}: correct scale and origin",
            asked.file, hull.bounds[0], hull.bounds[1]
        )));
    }
    Ok(Some(barred))
}
