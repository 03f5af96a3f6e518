//! Dressing: a house out of a massing that knows nothing but filled and empty.
//!
//! A voxel model of another program or an envelope lattice says where there is building, not where floors, stairs, doors
//! and windows are. [`dress`] reads footprints off it storey by storey (`storeys.rs`), puts them right where they break a
//! plan rule, composes openings (`facades.rs`), and lets [`settle`](super::settle) seat stairs and roof as it does for the
//! search. The outcome keeps every rule or says which it could not keep. Nothing is drawn by lot: the same massing gives
//! the same house.

mod facades;
mod roof;
mod storeys;

pub(super) use storeys::{footprints, layer, mend};

use super::cells::{Cells, WIDEST};
use super::massing::{Design, Massing, Roof, StoreyMass, encode};
use super::plot::{ChoiceSpace, Plot, PlotError, Programme, Space};
use super::settle::settle;
use super::shape::Cause;
use crate::voxels::{Choices, Direction, House, Label, STOREY_MODULES, Stair, StairKind, VoxelArray};

/// A house made of a massing, and what had to be done for it.
#[derive(Clone, Debug, PartialEq)]
pub struct Dressed {
    /// The house.
    pub house: House,
    /// Voxels that are filled now and were empty, and the other way round; the roof and what it replaces not counted.
    pub filled: usize,
    /// See `filled`.
    pub emptied: usize,
    /// What could not be kept, in sentences.
    pub notes: Vec<String>,
}

/// Why a massing becomes no house.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum DressError {
    /// Nothing is filled.
    #[error("nothing is filled: there is no massing to make a house of")]
    Empty,
    /// Wider than the search's plans.
    #[error(
        "the massing is {0} modules wide; houses of at most {WIDEST} along x are made: use larger modules or a part"
    )]
    TooWide(usize),
    /// No layer has a plan that could be a storey.
    #[error("no storey: nowhere do three of the six layers of a storey hold a plan of 4 x 4 modules")]
    NoStorey,
    /// A plot that cannot be.
    #[error(transparent)]
    Plot(#[from] PlotError),
    /// Not even the ground storey can be completed.
    #[error("the ground storey cannot become a house: the {} rule cannot be kept; see `houscaper check --rules`", cause.name())]
    Ground {
        /// The rule.
        cause: Cause,
    },
}

/// Empty modules kept around the massing in plan, so that footprints can be completed.
const MARGIN: usize = 2;

/// Makes a house of the filled voxels of an array, whatever their labels; `zones` (one per voxel, or none) are carried along.
///
/// The lowest filled layer becomes the foundation. Plan coordinates keep their place: the origin moves with the margin that
/// is added around the massing.
///
/// # Errors
/// [`DressError`]: nothing filled, too wide, nothing that could be a storey.
///
/// ```
/// use houscaper::search::dress::dress;
/// use houscaper::voxels::{Label, VoxelArray, rules};
/// let mut block = VoxelArray::new([9, 8, 12]);
/// for v in block.clone().iter().map(|(v, _)| v) {
///     block.set(v, Label::Base);
/// }
/// let dressed = dress(&block, &[])?;
/// assert!(rules::check(&dressed.house, &Default::default()).is_empty());
/// assert_eq!(dressed.house.stairs.len(), 1); // two storeys
/// # Ok::<(), houscaper::search::dress::DressError>(())
/// ```
pub fn dress(massing: &VoxelArray, zones: &[i32]) -> Result<Dressed, DressError> {
    let body = Body::new(massing, zones)?;
    let mut notes = Vec::new();
    let mut plans = storeys::footprints(&body.solid);
    if plans.is_empty() {
        return Err(DressError::NoStorey);
    }
    storeys::mend(&mut plans, &mut notes);
    let wish = roof::read(&body.solid, &plans);
    loop {
        match design(&plans, wish.rise(), &body) {
            Ok((design, plot)) => return Ok(finish(design, &plot, wish, &body, notes)),
            Err(Failed::Plot(error)) => return Err(error.into()),
            Err(Failed::Cause(cause)) if plans.len() == 1 => return Err(DressError::Ground { cause }),
            Err(Failed::Cause(cause)) => {
                notes.push(format!("storey {} is left out: it breaks the {} rule", plans.len() - 1, cause.name()));
                plans.pop();
            }
        }
    }
}

/// The massing set on the ground with a margin around it, and what is enclosed filled.
struct Body {
    solid: VoxelArray,
    zones: Vec<i32>,
}

impl Body {
    fn new(massing: &VoxelArray, zones: &[i32]) -> Result<Body, DressError> {
        let [nx, ny, nz] = massing.shape();
        let filled = || massing.iter().filter(|(_, l)| l.is_filled()).map(|(v, _)| v);
        let lowest = filled().map(|v| v[2]).min().ok_or(DressError::Empty)?;
        if nx + 2 * MARGIN > WIDEST {
            return Err(DressError::TooWide(nx));
        }
        let mut solid = VoxelArray::new([nx + 2 * MARGIN, ny + 2 * MARGIN, nz - lowest]);
        solid.module = massing.module;
        let size = massing.module.size_m;
        let moved = |a: usize| massing.origin_m[a] - MARGIN as f64 * size[a];
        solid.origin_m = [moved(0), moved(1), if lowest > 0 { 0.0 } else { massing.origin_m[2] }];
        let mut carried = Vec::new();
        if zones.len() == massing.labels().len() && !zones.is_empty() {
            carried = vec![-1; solid.labels().len()];
        }
        for v in filled() {
            let to = [v[0] + MARGIN, v[1] + MARGIN, v[2] - lowest];
            solid.set(to, Label::Base);
            if let Some(zone) = carried.get_mut(solid.index(to)) {
                *zone = zones[massing.index(v)];
            }
        }
        storeys::fill_hollows(&mut solid);
        Ok(Body { solid, zones: carried })
    }
}

enum Failed {
    Plot(PlotError),
    Cause(Cause),
}

impl From<PlotError> for Failed {
    fn from(error: PlotError) -> Self {
        Failed::Plot(error)
    }
}

/// A settled design on the footprints, with composed openings.
fn design(plans: &[Cells], rise: usize, body: &Body) -> Result<(Design, Plot), Failed> {
    let [nx, ny, _] = body.solid.shape();
    let count = plans.len();
    let mut plot = Plot::new([nx, ny, count * STOREY_MODULES + 2 + Roof::STEEPEST as usize], None)?;
    (plot.module, plot.origin_m) = (body.solid.module, body.solid.origin_m);
    let programme = Programme { storeys: [count, count], ..Programme::default() };
    let space = Space::new(plot, programme, ChoiceSpace::default())?;
    let storeys = plans.iter().enumerate().map(|(s, plan)| StoreyMass {
        footprint: plan.clone(),
        openings: Vec::new(),
        stair: Some(wished_stair(plan, s)),
    });
    let massing = Massing { storeys: storeys.collect(), roof: Roof::of_rise(rise) };
    let mut plain = Design { massing, choices: Choices::default() };
    settle(&mut plain, &space).map_err(Failed::Cause)?;
    // Once more with openings that know where the stairs are; the plain ones stay where composed ones cannot be settled.
    let mut composed = plain.clone();
    facades::compose(&mut composed.massing, &space.programme);
    let design = if settle(&mut composed, &space).is_ok() { composed } else { plain };
    Ok((design, space.plot))
}

/// Modules that the roof over `plans` rises, read off what stands above them; 0 = flat.
pub(super) fn roof_rise(solid: &VoxelArray, plans: &[Cells]) -> usize {
    roof::read(solid, plans).rise()
}

/// Where a stair is wished for: along the north side, so that the rooms to the south stay whole.
pub(super) fn wished_stair(plan: &Cells, storey: usize) -> Stair {
    let ([x, y], [w, h]) = plan.bounds().unwrap_or_default();
    let start = [x + (w / 2).saturating_sub(2), y + h.saturating_sub(3)];
    Stair { storey, start, run: Direction::East, kind: StairKind::UTurn }
}

fn finish(design: Design, plot: &Plot, wish: roof::Wish, body: &Body, mut notes: Vec<String>) -> Dressed {
    let mut house = encode(&design.massing, plot);
    if wish.rise() > 0 && design.massing.roof == Roof::Flat {
        notes.push("the roof is flat: none that rises fits the top storey".into());
    }
    if let roof::Wish::Gable { ridge_along, .. } = wish
        && !roof::gable(&mut house, &design.massing, ridge_along)
    {
        notes.push("the roof is hipped: a saddle roof would break a rule on this plan".into());
    }
    let top = design.massing.storeys.len() * STOREY_MODULES;
    let (mut filled, mut emptied) = (0, 0);
    for (v, label) in house.voxels.iter().filter(|(v, _)| v[2] < top) {
        let before = body.solid.at(v.map(|c| c as isize)).is_filled();
        filled += usize::from(label.is_filled() && !before);
        emptied += usize::from(!label.is_filled() && before);
    }
    if !body.zones.is_empty() {
        let zone = |(v, label): ([usize; 3], Label)| {
            let inside = v[2] < body.solid.shape()[2] && label.is_filled();
            if inside { body.zones[body.solid.index(v)] } else { -1 }
        };
        house.zones = house.voxels.iter().map(zone).collect();
    }
    Dressed { house, filled, emptied, notes }
}
