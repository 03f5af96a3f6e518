//! The roof a massing wants: read off what stands above its top storey.

use super::storeys::layer;
use crate::search::cells::Cells;
use crate::search::massing::{Massing, Roof};
use crate::voxels::rules::{self, RuleSettings};
use crate::voxels::{House, Label, STOREY_MODULES, VoxelArray};

/// What a massing says about its roof.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Wish {
    /// Nothing above the top storey.
    Flat,
    /// It narrows along both axes.
    Hip {
        /// Modules it rises.
        rise: usize,
    },
    /// It narrows along one axis only.
    Gable {
        /// Modules it rises.
        rise: usize,
        /// Axis of the ridge: 0 = x, 1 = y.
        ridge_along: usize,
    },
}

impl Wish {
    /// Modules the roof rises, 0 = flat.
    pub fn rise(self) -> usize {
        match self {
            Wish::Flat => 0,
            Wish::Hip { rise } | Wish::Gable { rise, .. } => rise,
        }
    }
}

/// Layers below the top plate that may belong to a roof whose storey was rounded up.
const SWALLOWED: usize = STOREY_MODULES / 2;
/// Shrinks to less than this share of its length = narrows.
const NARROW: f64 = 0.7;

/// Reads the roof above the top storey. One that narrows to less than half goes on to its ridge, at most as high as a roof
/// without a storey in it may be; the rounding of heights to storeys may have swallowed part of it.
pub fn read(solid: &VoxelArray, plans: &[Cells]) -> Wish {
    let plate = plans.len() * STOREY_MODULES;
    let from = plate.saturating_sub(SWALLOWED);
    let layers: Vec<Cells> = (from..solid.shape()[2]).map(|k| layer(solid, k)).collect();
    let highest = layers.iter().rposition(|l| l.count() >= 3);
    let (Some(highest), Some(top)) = (highest, plans.last()) else { return Wish::Flat };
    let (Some((_, whole)), Some((_, left))) = (top.bounds(), layers[highest].bounds()) else { return Wish::Flat };
    let narrows = [0, 1].map(|a| (left[a] as f64) < NARROW * whole[a] as f64);
    // A chimney stands on a roof without anything between its size and the roof's.
    let slopes = layers.iter().any(|l| (top.count()..4 * top.count()).contains(&(5 * l.count())));
    if !slopes {
        return Wish::Flat;
    }
    let pointed = |axis: usize| 2 * left[axis] <= whole[axis];
    let ridge = whole[0].min(whole[1]).div_ceil(2);
    let full = |goes_on: bool, ridge: usize| {
        if goes_on { ridge } else { (from + highest).saturating_sub(plate) }.min(Roof::STEEPEST as usize)
    };
    let rise = match narrows {
        [true, false] => full(pointed(0), whole[0].div_ceil(2)),
        [false, true] => full(pointed(1), whole[1].div_ceil(2)),
        [true, true] | [false, false] => full(pointed(0) || pointed(1), ridge),
    };
    if rise == 0 {
        return Wish::Flat;
    }
    match narrows {
        [true, false] => Wish::Gable { rise, ridge_along: 1 },
        [false, true] => Wish::Gable { rise, ridge_along: 0 },
        [true, true] | [false, false] => Wish::Hip { rise },
    }
}

/// Replaces the hips of a settled roof by gables across the axis of the ridge; false, and nothing changed, where a rule
/// would be broken that holds now.
pub fn gable(house: &mut House, massing: &Massing, ridge_along: usize) -> bool {
    let Some(top) = massing.top() else { return false };
    let settings = RuleSettings::default();
    let before = rules::check(house, &settings).len();
    let mut gabled = house.clone();
    let plate = massing.storeys.len() * STOREY_MODULES;
    let mut cells = top.clone();
    for i in 1..=massing.roof.rise() {
        cells.iter().for_each(|[x, y]| gabled.voxels.set([x, y, plate + i], Label::Base));
        let across = if ridge_along == 0 { [0, 1] } else { [1, 0] };
        cells = cells.and(&cells.shifted(across)).and(&cells.shifted(across.map(|c: isize| -c)));
    }
    let keeps = rules::check(&gabled, &settings).len() <= before;
    if keeps {
        *house = gabled;
    }
    keeps
}
