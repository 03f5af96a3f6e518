//! What lies outside a column: from which side, and between which heights.

use super::column::{Columns, Post};
use super::edges::{self, Rim};
use super::heights::{Heights, Plane, RISE_UM};
use super::strata::{Strata, round_up, total};
use super::style::SolidStyle;
use crate::voxels::Label;

/// How far a point of a column is from what is outside it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Metric {
    /// Outside beyond the plane x = 450 mm: the distance a to it.
    X,
    /// Outside beyond y = 450 mm: the distance b.
    Y,
    /// Outside only diagonally across the centre: the larger of both, so that walls mitre.
    Both,
}

/// A place in a quadrant of the plan, as a sum of `count` points (a, b), so that centres of cells are exact.
#[derive(Clone, Copy, Debug)]
pub(super) struct Spot {
    pub sum: [i64; 2],
    pub count: i64,
}

impl Spot {
    /// The distance of a metric, times `count`.
    pub fn measure(&self, metric: Metric) -> i64 {
        match metric {
            Metric::X => self.sum[0],
            Metric::Y => self.sum[1],
            Metric::Both => self.sum[0].max(self.sum[1]),
        }
    }

    /// Whether a distance is less than `depth`.
    pub fn within(&self, metric: Metric, depth: i32) -> bool {
        self.measure(metric) < i64::from(depth) * self.count
    }
}

/// Heights between which a side is outside.
#[derive(Clone, Copy, Debug)]
pub(super) struct Span {
    pub from: Plane,
    pub to: Plane,
    /// Whether another part of the house stands in front: then the wall there needs no cladding.
    pub hidden: bool,
}

/// One side of a column that is outside.
#[derive(Clone, Copy, Debug)]
pub(super) struct Side {
    pub metric: Metric,
    /// Spans from bottom to top, each beginning where the one before ends; the second may be empty.
    pub spans: [Span; 2],
    /// Whether it reaches up to the cube's top.
    pub to_top: bool,
}

impl Side {
    /// The axis along which the neighbour lies; none for the diagonal one.
    pub fn axis(&self) -> Option<usize> {
        match self.metric {
            Metric::X => Some(0),
            Metric::Y => Some(1),
            Metric::Both => None,
        }
    }
}

/// The sides of one column, and where strata that poke below the cube would meet the walls of the cube below.
#[derive(Clone, Debug, Default)]
pub(super) struct Sides {
    list: [Option<Side>; 4],
    sealed: [bool; 3],
    rim: [bool; 3],
    /// Width of what stands at the free edge of a deck.
    pub edge: i32,
}

/// Both depths of a roof, the larger: how far a roof above may poke into this cube.
fn deepest(strata: &Strata) -> i32 {
    strata.roof_depth(true).max(strata.roof_depth(false))
}

impl Sides {
    pub fn new(columns: &Columns, heights: &Heights, strata: &Strata, q: usize) -> Sides {
        let mut sides = Sides::default();
        if matches!(columns.post(q), Post::Empty | Post::Deck) {
            return sides;
        }
        let mut n = 0;
        let mut push = |side: Side| {
            sides.list[n] = Some(side);
            n += 1;
        };
        for (axis, metric) in [Metric::X, Metric::Y].into_iter().enumerate() {
            if let Some((spans, to_top)) = outside(columns, heights, strata, q, axis) {
                push(Side { metric, spans, to_top });
            }
        }
        // The diagonal column counts as the two columns between see it: their walls meet in this column's corner.
        for axis in 0..2 {
            let between = q ^ (1 << axis);
            if let Some((mut spans, mut to_top)) = outside(columns, heights, strata, between, 1 - axis) {
                for span in &mut spans {
                    span.from = Plane::level(span.from.level);
                    span.to = Plane::level(span.to.level);
                }
                if columns.post(q) == Post::Full && columns.post(between) == Post::Roof {
                    // The roof goes on over this column: its strata poke down from the cube above.
                    if columns.border_face(q, axis).continues() {
                        let under = RISE_UM - deepest(strata);
                        spans[0] = Span { from: spans[0].from, to: Plane::level(under), hidden: spans[0].hidden };
                        spans[1] = Span { from: Plane::level(under), to: Plane::level(under), hidden: false };
                        to_top = false;
                    }
                }
                push(Side { metric: Metric::Both, spans, to_top });
            }
        }
        if matches!(columns.post(q), Post::Full | Post::Roof) {
            sides.sealed = sealed(columns, q);
        }
        sides
    }

    /// The free edges of a deck column.
    pub fn of_deck(columns: &Columns, style: &SolidStyle, q: usize) -> Sides {
        let rim = match edges::rim(columns, q) {
            Rim::None => [false; 3],
            Rim::Straight(axis) => [axis == 0, axis == 1, false],
            Rim::Convex => [true, true, false],
            Rim::Concave => [false, false, true],
        };
        Sides { rim, edge: edges::edge_zone_um(columns, q, style), ..Sides::default() }
    }

    /// Whether a spot of a deck lies in the zone of its edge.
    pub fn is_edge(&self, spot: &Spot) -> bool {
        metrics(self.rim).any(|metric| spot.within(metric, self.edge))
    }

    /// The sides, nearest of equal ones first.
    pub fn iter(&self) -> impl Iterator<Item = &Side> {
        self.list.iter().flatten()
    }

    /// Whether the wall of the cube below stands under a spot.
    pub fn is_sealed(&self, spot: &Spot, strata: &Strata) -> bool {
        let wall = total(&strata.wall);
        metrics(self.sealed).any(|metric| spot.within(metric, wall))
    }

    /// All metrics by which the column is divided.
    pub fn metrics(&self) -> impl Iterator<Item = Metric> {
        self.iter().map(|side| side.metric).chain(metrics(self.sealed)).chain(metrics(self.rim))
    }
}

fn metrics(set: [bool; 3]) -> impl Iterator<Item = Metric> {
    [Metric::X, Metric::Y, Metric::Both].into_iter().zip(set).filter(|(_, on)| *on).map(|(metric, _)| metric)
}

/// Between which heights the neighbour of column q along `axis` is outside, and whether up to the cube's top.
fn outside(columns: &Columns, heights: &Heights, strata: &Strata, q: usize, axis: usize) -> Option<([Span; 2], bool)> {
    let neighbour = q ^ (1 << axis);
    let top = Plane::level(RISE_UM);
    let one = |from, to| [Span { from, to, hidden: false }, Span { from: to, to, hidden: false }];
    let continues = columns.border_face(q, axis).continues();
    let whole = Some((one(Plane::level(0), top), true));
    match (columns.post(q), columns.post(neighbour)) {
        (Post::Empty | Post::Deck, _) | (_, Post::Full) => None,
        (Post::Full, Post::Roof) if continues => None,
        (Post::Full, Post::Roof) => {
            let surface = heights.border(neighbour, axis);
            // The triangle beside the border decides what the roof is made of there.
            let is_level = heights.roof(neighbour, axis == 0).is_level();
            let under = surface.lowered(strata.roof_depth(is_level));
            let behind = Span { from: under, to: surface, hidden: true };
            Some(([behind, Span { from: surface, to: top, hidden: false }], true))
        }
        (Post::Full, Post::Floor) => {
            let underside = Plane::level(round_up(columns.underside_um(neighbour)));
            let zone = match columns.above(neighbour) {
                Label::Foundation => underside,
                _ => Plane::level(RISE_UM - total(&strata.floor)),
            };
            let free = Span { from: Plane::level(0), to: underside, hidden: false };
            Some(([free, Span { from: underside, to: zone, hidden: true }], false))
        }
        (Post::Roof, Post::Roof) | (Post::Floor, Post::Floor) => None,
        (Post::Roof, Post::Empty) if continues => None,
        (Post::Full | Post::Roof, Post::Deck) => {
            let deck = Plane::level(round_up(total(strata.deck(columns, neighbour))));
            let behind = Span { from: Plane::level(0), to: deck, hidden: true };
            Some(([behind, Span { from: deck, to: top, hidden: false }], true))
        }
        (Post::Floor, Post::Roof | Post::Deck) => whole,
        (Post::Full | Post::Roof | Post::Floor, Post::Empty) | (Post::Roof, Post::Floor) => whole,
    }
}

/// By which metrics the cube below has walls under column q: where the corner below a neighbour is empty and the roof does not go on
/// there one voxel lower.
fn sealed(columns: &Columns, q: usize) -> [bool; 3] {
    let empty = |q: usize| !columns.below(q).is_filled();
    let stops = |q: usize, axis: usize| {
        empty(q ^ (1 << axis)) && !(columns.post(q) == Post::Roof && columns.border_face(q, axis).continues())
    };
    let beyond = |axis: usize| !empty(q ^ (1 << axis)) && stops(q ^ (1 << axis), 1 - axis);
    [stops(q, 0), stops(q, 1), beyond(0) || beyond(1)]
}
