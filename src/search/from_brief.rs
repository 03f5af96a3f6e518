//! From a brief to the space of its houses, and to the search that it asks for.

use super::cells::Cells;
use super::domain::Domain;
use super::elites::{self, MapElites};
use super::evolution::{self, Evolution};
use super::fields::{Field, Fields};
use super::hill::HillClimber;
use super::kept::{Kept, KeptError};
use super::plot::{ChoiceSpace, Plot, PlotError, Programme, Space};
use super::random::RandomSearch;
use super::run::Searcher;
use super::steady::{self, Steady};
use crate::brief::{Algorithm, Brief, Keep};
use crate::voxels::{Given, Plan, STOREY_MODULES, rules::RuleSettings};

/// Why a brief has no space of houses.
#[derive(Debug, thiserror::Error)]
pub enum SpaceError {
    /// Plot, programme or given cells.
    #[error(transparent)]
    Plot(#[from] PlotError),
    /// Labels that no house could keep.
    #[error(transparent)]
    Kept(#[from] KeptError),
    /// The given lattice is larger than the plot.
    #[error(
        "given: the lattice takes {found:?} modules but plot.modules is {plot:?}: enlarge the plot, crop the lattice or lower cell_modules"
    )]
    LatticeTooLarge {
        /// Modules the lattice takes.
        found: [usize; 3],
        /// Modules of the plot.
        plot: [usize; 3],
    },
}

/// What the files that a brief names say of its plot.
#[derive(Clone, Copy, Debug, Default)]
pub struct Site<'a> {
    /// Given voxels.
    pub given: Option<&'a Given>,
    /// Sun access for each module of the given voxels, 0 to 1.
    pub sun: Option<&'a [f64]>,
    /// Entrance access likewise.
    pub entrances: Option<&'a [f64]>,
    /// Whether each voxel of the plot lies outside the envelope, x fastest.
    pub barred: Option<&'a [bool]>,
}

/// The space of a brief: plot, programme, given voxels and the number of section options (wall, floor, beam, roof).
///
/// # Errors
/// [`SpaceError`], naming the key of the brief.
pub fn space(
    brief: &Brief,
    given: Option<&Given>,
    rules: &RuleSettings,
    options: [usize; 4],
) -> Result<Space, SpaceError> {
    site_space(brief, &Site { given, ..Site::default() }, rules, options)
}

/// The same with fields and an envelope.
///
/// # Errors
/// As [`space`].
pub fn site_space(brief: &Brief, site: &Site, rules: &RuleSettings, options: [usize; 4]) -> Result<Space, SpaceError> {
    let [nx, ny, _] = brief.plot.modules;
    let mask = brief.plot.mask.as_ref().map(|rows| {
        let mut plan = Plan::new([nx, ny]);
        for (row, text) in rows.iter().enumerate() {
            for (x, mark) in text.bytes().enumerate() {
                plan.set([x, ny - 1 - row], mark == b'#');
            }
        }
        plan
    });
    let mut plot = Plot::new(brief.plot.modules, mask.as_ref())?;
    if let (Some(given), Some(wanted)) = (site.given, &brief.given) {
        plot = with_lattice(plot, given, wanted.keep)?;
        let field = |values: Option<&[f64]>| values.map(|values| Field::new(given, values));
        plot.fields = Fields { sun: field(site.sun), entrances: field(site.entrances) };
    }
    if let Some(barred) = site.barred {
        plot = plot.with_barred(barred)?;
    }
    let programme = Programme {
        floor_area_m2: brief.programme.floor_area_m2,
        storeys: brief.programme.storeys,
        entrances_min: brief.programme.entrances_min,
        glazing: [rules.glazing_ratio_min, rules.glazing_ratio_max],
        roof_rise: brief.programme.roof_rise,
    };
    let plates = brief.programme.storeys[1].min(plot.most_storeys()) as u32;
    let boards = brief.wall_boards.len().min(u16::MAX as usize) as u16;
    let [wall, floor, beam, roof] = options.map(|n| n.min(u16::MAX as usize) as u16);
    let choices = ChoiceSpace { options: [wall, floor, beam, roof, 1 << plates.min(15), boards] };
    Ok(Space::new(plot, programme, choices)?)
}

/// The searcher that a brief's search settings ask for.
pub fn searcher<'a, D: Domain>(domain: &'a D, brief: &Brief) -> Box<dyn Searcher<D> + 'a> {
    let (search, objectives) = (&brief.search, brief.objectives.len());
    let seed = search.seed;
    let population = search.population.unwrap_or(evolution::Settings::default().population);
    let generational = evolution::Settings {
        population,
        offspring: population,
        polish: search.sizing,
        ..evolution::Settings::default()
    };
    match search.algorithm {
        Algorithm::Steady => {
            let usual = steady::Settings::default();
            let settings = steady::Settings {
                pool: search.population.unwrap_or(usual.pool),
                polish: search.sizing,
                screen: search.screen,
                ..usual
            };
            Box::new(Steady::new(domain, seed, settings))
        }
        Algorithm::Nsga2 => Box::new(Evolution::nsga2(domain, seed, generational)),
        Algorithm::Nsga3 => Box::new(Evolution::nsga3(domain, seed, objectives, generational)),
        Algorithm::MapElites => {
            let usual = elites::Settings::default();
            let starts = search.population.unwrap_or(usual.starts);
            Box::new(MapElites::new(domain, seed, elites::Settings { starts, polish: search.sizing, ..usual }))
        }
        Algorithm::Random => Box::new(RandomSearch::new(domain, seed, population)),
        Algorithm::Hill => Box::new(HillClimber::new(domain, seed, objectives, population.min(20))),
    }
}

fn with_lattice(plot: Plot, given: &Given, keep: Keep) -> Result<Plot, SpaceError> {
    let [nx, ny, nz] = plot.modules;
    let [gx, gy, gz] = given.shape;
    if gx > nx || gy > ny || gz > nz {
        return Err(SpaceError::LatticeTooLarge { found: given.shape, plot: plot.modules });
    }
    if keep == Keep::Labels {
        return with_labels(plot, given);
    }
    let storeys = gz.div_ceil(STOREY_MODULES);
    let mut fill = vec![Plan::new([nx, ny]); storeys];
    let mut zones = vec![-1; nx * ny * nz];
    for (index, &zone) in given.mask.iter().enumerate().filter(|(_, zone)| **zone >= 0) {
        let (x, y, z) = (index % gx, index / gx % gy, index / (gx * gy));
        fill[z / STOREY_MODULES].set([x, y], true);
        zones[x + nx * (y + ny * z)] = zone;
    }
    let mut empty = vec![Plan::new([nx, ny]); storeys];
    for (plan, filled) in empty.iter_mut().zip(&fill) {
        for (x, y) in (0..gy).flat_map(|y| (0..gx).map(move |x| (x, y))) {
            plan.set([x, y], !filled.has([x as isize, y as isize]));
        }
    }
    let none: Vec<Plan> = Vec::new();
    Ok(match keep {
        Keep::Filled | Keep::Labels => plot.with_given(&fill, &none, zones)?,
        Keep::Empty => plot.with_given(&none, &empty, zones)?,
        Keep::Both => plot.with_given(&fill, &empty, zones)?,
    })
}

/// Labels in place of zones.
fn with_labels(plot: Plot, given: &Given) -> Result<Plot, SpaceError> {
    let kept = Kept::new(given, &plot)?;
    let plans = |of: &dyn Fn(usize) -> Option<Cells>| -> Vec<Plan> {
        (0..kept.storeys()).filter_map(of).map(|cells| cells.to_plan()).collect()
    };
    let (fill, empty) = (plans(&|s| kept.fill(s).cloned()), plans(&|s| kept.outside(s).cloned()));
    let plot = plot.with_given(&fill, &empty, Vec::new())?;
    Ok(Plot { kept: Some(kept), ..plot })
}
