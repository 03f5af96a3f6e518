//! The strata that stand in tiles, as distances from the outer face.

use super::super::{Component, Shells, Stratum, depth_um};
use super::column::Columns;
use crate::voxels::Label;

/// Thickness across a slope of 3 : 5 to height above the same spot: the secant, sqrt(1 + 0.6^2).
const SECANT: f64 = 1.166_190_378_969_06;
/// Heights that meet a sloped plane are multiples of this, so that their lines of intersection fall on whole multiples of 5 µm.
const GRID_UM: i32 = 60;
/// Distances in plan are multiples of this, for the same reason.
const PLAN_GRID_UM: i32 = 10;

/// A component and the depth at which it ends, from the outside inwards.
pub(super) type Reach = (Component, i32);

/// The shells as sums from the outside, rounded to the grids on which all tiles' corners lie.
#[derive(Clone, Debug)]
pub(super) struct Strata {
    /// Wall from its face inwards.
    pub wall: Vec<Reach>,
    /// Foundation's edge from its face inwards, with the perimeter beam.
    pub edge: Vec<Reach>,
    /// Depth of the foundation's edge below the slab top.
    pub edge_depth: i32,
    /// Sloped roof from the roof plane down, vertically.
    pub sloped: Vec<Reach>,
    /// Level roof from its surface down, with the floor structure below it.
    pub level: Vec<Reach>,
    /// Covering above the roof plane, vertically.
    pub cover: Vec<Reach>,
    /// Deck from the floor plane *up*: walked on, not walked on, and on a foundation.
    pub decks: [Vec<Reach>; 3],
    /// Floor from the slab top down.
    pub floor: Vec<Reach>,
    /// Floor with soffit from the slab top down.
    pub soffit: Vec<Reach>,
    /// Foundation from the slab top down.
    pub ground: Vec<Reach>,
}

impl Strata {
    pub fn new(shells: &Shells) -> Strata {
        let plain = |um: i32| um;
        let plan = |um: i32| round_to(f64::from(um), PLAN_GRID_UM);
        let slope = |um: i32| round_to(f64::from(um) * SECANT, GRID_UM);
        let beam = Stratum { component: Component::PerimeterBeam, thickness_um: shells.beam_um[0] };
        let up = |stack: &[Stratum]| sums(stack.iter().rev(), plain);
        // A foundation on which nothing stands is paved as high as a deck's boards are thick.
        let paving = shells.deck.first().map(|s| Stratum { component: Component::Paving, ..*s });
        Strata {
            wall: sums(&shells.wall, plan),
            edge: sums(shells.plinth.iter().chain([&beam]), plan),
            edge_depth: shells.beam_um[1].max(depth_um(&shells.ground)),
            sloped: sums(&shells.roof, slope),
            level: sums(shells.flat.iter().chain(&shells.floor), plain),
            cover: sums(shells.roof_cover.iter().rev(), slope),
            decks: [up(&shells.deck), up(&shells.flat), sums(&paving, plain)],
            floor: sums(&shells.floor, plain),
            soffit: sums(shells.floor.iter().chain(&shells.soffit), plain),
            ground: sums(&shells.ground, plain),
        }
    }

    /// What lies on the deck of column q, from the floor plane up.
    pub fn deck(&self, columns: &Columns, q: usize) -> &[Reach] {
        match columns.below(q) {
            Label::Foundation => &self.decks[2],
            _ if columns.key.walked(q) => &self.decks[0],
            _ => &self.decks[1],
        }
    }

    /// Depth of the roof below a sloped or level plane.
    pub fn roof_depth(&self, is_level: bool) -> i32 {
        round_up(total(if is_level { &self.level } else { &self.sloped }))
    }
}

/// Depth of all strata.
pub(super) fn total(strata: &[Reach]) -> i32 {
    strata.last().map_or(0, |(_, depth)| *depth)
}

/// The next height upwards at which a sloped plane may be met.
pub(super) fn round_up(um: i32) -> i32 {
    (um + GRID_UM - 1).div_euclid(GRID_UM) * GRID_UM
}

fn round_to(um: f64, grid: i32) -> i32 {
    (um / f64::from(grid)).round() as i32 * grid
}

fn sums<'s>(stack: impl IntoIterator<Item = &'s Stratum>, rounded: impl Fn(i32) -> i32) -> Vec<Reach> {
    let mut sum = 0;
    let strata = stack.into_iter().map(|s| {
        sum += s.thickness_um;
        (s.component, rounded(sum))
    });
    strata.collect()
}
