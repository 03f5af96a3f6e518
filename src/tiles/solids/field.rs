//! What stands where in a cube: the one function of space from which all solids follow.

use super::super::Component;
use super::column::{Columns, Half, Post};
use super::heights::{HALF_PLAN_UM, HALF_RISE_UM, Heights, Plane, RISE_UM};
use super::sides::{Side, Sides, Span, Spot};
use super::strata::{Reach, Strata, total};
use super::style::SolidStyle;
use crate::voxels::Label;

/// What fills a range of heights over a spot of the plan unless something listed before it does.
#[derive(Clone, Copy, Debug)]
pub(super) struct Paint {
    /// Begins at the higher of these.
    pub from: [Plane; 2],
    /// Ends at the lower of these.
    pub to: [Plane; 2],
    /// What it is; `None` keeps the range free.
    pub component: Option<Component>,
    /// The corner it belongs to.
    pub octant: u8,
}

/// Lower than anything may poke.
const DEEP_UM: i32 = -RISE_UM;

/// The parts of a cube.
pub(super) struct Field<'a, 's> {
    pub columns: &'a Columns<'s>,
    pub heights: Heights,
    pub strata: Strata,
    style: &'a SolidStyle,
}

impl<'a, 's> Field<'a, 's> {
    pub fn new(columns: &'a Columns<'s>, style: &'a SolidStyle) -> Field<'a, 's> {
        Field { columns, heights: Heights::new(columns), strata: Strata::new(columns.shells), style }
    }

    pub fn sides(&self, q: usize) -> Sides {
        if self.columns.post(q) == Post::Deck {
            return Sides::of_deck(self.columns, self.style, q);
        }
        Sides::new(self.columns, &self.heights, &self.strata, q)
    }

    /// What fills the heights over a spot of column q, first come first served.
    pub fn paints(&self, q: usize, sides: &Sides, spot: &Spot, paints: &mut Vec<Paint>) {
        paints.clear();
        let mut near: [Option<&Side>; 4] = [None; 4];
        near.iter_mut().zip(sides.iter()).for_each(|(slot, side)| *slot = Some(side));
        near.sort_by_key(|side| side.map_or(i64::MAX, |s| spot.measure(s.metric)));
        let lowest = Plane::level(if sides.is_sealed(spot, &self.strata) { 0 } else { DEEP_UM });
        let mut brush = Brush { field: self, q, near, spot: *spot, paints };
        match self.columns.post(q) {
            Post::Empty => {}
            // What stands at a deck's edge is built by itself.
            Post::Deck if sides.is_edge(spot) => {}
            Post::Deck => brush.pile(self.strata.deck(self.columns, q), Plane::level(0), q as u8),
            Post::Full => brush.full(if self.columns.below(q).is_slab() { Plane::level(0) } else { lowest }),
            Post::Roof => brush.roof(lowest),
            Post::Floor => brush.floor(),
        }
    }

    /// The stratum of a wall at a side: none deeper than the wall.
    fn stratum(&self, spot: &Spot, side: &Side, stack: &[Reach]) -> Option<usize> {
        stack.iter().position(|(_, depth)| spot.within(side.metric, *depth))
    }
}

/// Lists what fills the heights over one spot.
struct Brush<'f, 'a, 's, 'p> {
    field: &'f Field<'a, 's>,
    q: usize,
    near: [Option<&'p Side>; 4],
    spot: Spot,
    paints: &'p mut Vec<Paint>,
}

impl Brush<'_, '_, '_, '_> {
    fn paint(&mut self, from: [Plane; 2], to: [Plane; 2], component: Option<Component>, octant: u8) {
        self.paints.push(Paint { from, to, component, octant });
    }

    /// Strata from `base` upwards.
    fn pile(&mut self, strata: &[Reach], base: Plane, octant: u8) {
        let mut below = 0;
        for &(component, height) in strata {
            self.paint([base.lowered(-below); 2], [base.lowered(-height); 2], Some(component), octant);
            below = height;
        }
    }

    /// Strata from `top` downwards, none below `lowest`.
    fn hang(&mut self, strata: &[Reach], top: Plane, lowest: Plane, octant: u8) {
        let mut above = 0;
        for &(component, depth) in strata {
            self.paint([top.lowered(depth), lowest], [top.lowered(above); 2], Some(component), octant);
            above = depth;
        }
    }

    /// One side's wall between two planes. Behind another part of the house the outermost stratum is insulation.
    fn wall(&mut self, side: &Side, stack: &[Reach], label: Label, clip: [Plane; 2], octant: u8) {
        let Some(k) = self.field.stratum(&self.spot, side, stack) else { return };
        let [low, high] = side.spans;
        let component = stack[k].0;
        let outermost = k == 0 && label != Label::Foundation;
        if !outermost || !(low.hidden || high.hidden) {
            let component = if outermost { face(label, component) } else { component };
            return self.paint([low.from, clip[0]], [high.to, clip[1]], Some(component), octant);
        }
        let behind = stack.get(1).map_or(component, |s| s.0);
        for Span { from, to, hidden } in [low, high] {
            let component = if hidden { behind } else { face(label, component) };
            self.paint([from, clip[0]], [to, clip[1]], Some(component), octant);
        }
    }

    fn full(&mut self, lowest: Plane) {
        let (columns, strata, q) = (self.field.columns, &self.field.strata, self.q);
        let middle = Plane::level(HALF_RISE_UM);
        let halves = [(Half::Lower, [lowest, middle], q), (Half::Upper, [middle, Plane::level(RISE_UM)], q + 4)];
        let mut covered = false;
        for side in self.near.into_iter().flatten() {
            for (half, clip, octant) in halves {
                let label = columns.wall_label(q, half);
                let stack = if label == Label::Foundation { &strata.edge } else { &strata.wall };
                covered |= half == Half::Upper && side.to_top && self.spot.within(side.metric, total(stack));
                let infill = side.axis().and_then(|axis| columns.infill(q, axis, half));
                if infill.is_some() && self.spot.within(side.metric, total(stack)) {
                    let [low, high] = side.spans;
                    self.paint([low.from, clip[0]], [high.to, clip[1]], None, octant as u8);
                } else {
                    self.wall(side, stack, label, clip, octant as u8);
                }
            }
        }
        // The wall of the storey above stands on the wall below: a floor ends at its lining.
        if columns.above(q).is_slab() && !covered {
            let strata = if columns.above(q) == Label::Foundation { &strata.ground } else { &strata.floor };
            self.hang(strata, Plane::level(RISE_UM), Plane::level(0), q as u8 + 4);
        }
    }

    fn roof(&mut self, lowest: Plane) {
        let (strata, q) = (&self.field.strata, self.q);
        let plane = self.field.heights.roof(q, self.spot.sum[1] > self.spot.sum[0]);
        let (label, clip) = (self.field.columns.below(q), [Plane::level(0), plane]);
        for side in self.near.into_iter().flatten() {
            if self.field.stratum(&self.spot, side, &strata.wall) == Some(0) {
                self.wall(side, &strata.wall, label, clip, q as u8);
            }
        }
        self.hang(if plane.is_level() { &strata.level } else { &strata.sloped }, plane, lowest, q as u8);
        for side in self.near.into_iter().flatten() {
            self.wall(side, &strata.wall, label, clip, q as u8);
        }
        if !plane.is_level() {
            self.pile(&strata.cover, plane, q as u8);
        }
    }

    fn floor(&mut self) {
        let (strata, q) = (&self.field.strata, self.q);
        let (label, octant, top) = (self.field.columns.above(q), q as u8 + 4, Plane::level(RISE_UM));
        if label == Label::Foundation {
            for side in self.near.into_iter().flatten() {
                self.wall(side, &strata.edge, label, [top.lowered(strata.edge_depth), top], octant);
            }
            return self.hang(&strata.ground, top, Plane::level(0), octant);
        }
        let [underside, zone] = [total(&strata.soffit), total(&strata.floor)].map(|depth| top.lowered(depth));
        for side in self.near.into_iter().flatten() {
            if self.field.stratum(&self.spot, side, &strata.wall) == Some(0) {
                self.wall(side, &strata.wall, label, [underside, top], octant);
            }
        }
        // The boards of the soffit run under the wall as far as its cladding.
        let boards = strata.soffit.len().checked_sub(2).map_or(underside, |n| top.lowered(strata.soffit[n].1));
        if let Some(&(component, _)) = strata.soffit.last() {
            self.paint([underside; 2], [boards; 2], Some(component), octant);
        }
        for side in self.near.into_iter().flatten() {
            // Beside the soffit's insulation there is no room that a lining would belong to.
            let last = self.field.stratum(&self.spot, side, &strata.wall) == Some(strata.wall.len() - 1);
            self.wall(side, &strata.wall, label, [if last { zone } else { boards }, top], octant);
        }
        self.hang(&strata.soffit, top, underside, octant);
    }
}

/// The outermost stratum of a wall: a band where a floor plate meets the facade.
fn face(label: Label, component: Component) -> Component {
    match label {
        Label::Floor => Component::Band,
        Label::Empty | Label::Base | Label::Foundation | Label::Opening | Label::Window => component,
    }
}

/// The component at a point of the cube (µm, in the interior of a block) and the corner it belongs to; `None` where nothing stands.
///
/// Points above or below the cube answer for what pokes out of it.
pub fn component_at(columns: &Columns, style: &SolidStyle, point: [i32; 3]) -> Option<(Component, u8)> {
    let [dx, dy] = [point[0] - HALF_PLAN_UM, point[1] - HALF_PLAN_UM];
    let q = usize::from(dx > 0) + 2 * usize::from(dy > 0);
    let at = [dx.abs(), dy.abs()];
    let field = Field::new(columns, style);
    let mut paints = Vec::new();
    field.paints(q, &field.sides(q), &Spot { sum: at.map(i64::from), count: 1 }, &mut paints);
    let z = 5 * i64::from(point[2]);
    let covers = |p: &&Paint| p.from.iter().all(|f| f.five_times(at) < z) && p.to.iter().all(|t| z < t.five_times(at));
    let found = paints.iter().find(covers)?;
    Some((found.component?, found.octant))
}
