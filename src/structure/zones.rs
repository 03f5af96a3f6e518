//! Pressure zones by place: which zones of EN 1991-1-4 7.2 a piece of wall or roof lies in when the wind blows from a side.
//!
//! Zones are strips and corners of rectangles. On other plans every distance counts from the nearest edge of the roof body (or
//! facade) in the piece's own row, so that wings have edge strips of their own.

use super::loads::pressure::{DUO_0, DUO_90, FLAT, HIP, MONO_0, MONO_90, MONO_180, TROUGH_0, TROUGH_90, WALL, Zone};
use super::plan::{Cell, PLATEAU, Plan, Step};
use crate::frame::Area;
use crate::voxels::Direction;

/// Wind from a side with its edge length e = min(b, 2h), m.
#[derive(Clone, Copy, Debug)]
pub(super) struct Gust {
    /// The side the wind comes from: facades facing it are windward.
    pub from: Direction,
    /// e, m.
    pub e: f64,
}

/// Share of the interval `of` that lies in `within`, 0 to 1.
fn share(of: [f64; 2], within: [f64; 2]) -> f64 {
    let length = of[1] - of[0];
    if length <= 0.0 {
        return f64::from(u8::from(of[0] >= within[0] && of[0] < within[1]));
    }
    ((of[1].min(within[1]) - of[0].max(within[0])) / length).clamp(0.0, 1.0)
}

const FAR: f64 = f64::INFINITY;

/// An interval of an axis as distances from an edge: from the upper edge for `high`.
fn distances(interval: [f64; 2], edges: [f64; 2], high: bool) -> [f64; 2] {
    if high { [edges[1] - interval[1], edges[1] - interval[0]] } else { interval.map(|x| x - edges[0]) }
}

/// Whether a direction points to larger coordinates.
fn positive(d: Direction) -> bool {
    (d as usize) < 2
}

/// Zones of a half module of roof with their shares of it, which add up to 1.
pub(super) fn roof(plan: &Plan, area: Area, step: &Step, gust: &Gust, put: &mut impl FnMut(Zone, f64)) {
    let cell = plan.cell(step.cell);
    let Area::Slope(d) = area else { return face(plan, area, step, gust, put) };
    let slopes = plan.slopes_of(cell, d);
    if slopes == 1 << d as u8 {
        return face(plan, area, step, gust, put);
    }
    // A verge: part of the slopes beside it. Opposite to them it is the other half of the cell; across them the cell's slopes reach
    // over it too.
    let mut step = *step;
    if slopes >> (d.back() as u8) & 1 == 0 {
        let axis = d as usize % 2;
        let low = f64::from(step.cell[axis]) * plan.module[axis];
        step.rect[axis] = [low, low + plan.module[axis]];
    }
    let beside = f64::from(slopes.count_ones());
    for d in Direction::ALL.into_iter().filter(|&d| slopes >> (d as u8) & 1 == 1) {
        face(plan, Area::Slope(d), &step, gust, &mut |zone, share| put(zone, share / beside));
    }
    if slopes == 0 {
        face(plan, Area::Plateau, &step, gust, put);
    }
}

/// Zones of a half module of a face.
fn face(plan: &Plan, area: Area, step: &Step, gust: &Gust, put: &mut impl FnMut(Zone, f64)) {
    let cell = plan.cell(step.cell);
    let (along, across) = (gust.from as usize % 2, 1 - gust.from as usize % 2);
    let u = distances(step.rect[along], plan.edges(cell, along), positive(gust.from));
    let [low, high] = plan.edges(cell, across);
    let v = distances(step.rect[across], [low, high], false);
    let piece = Piece { plan, at: step.cell, cell, gust, u, v, width: high - low, row: step.rect[along] };
    match area {
        // A deck under a roof lies in the middle of nothing: zone H.
        _ if step.z < cell.top - 1.3 => put(FLAT + 2, 1.0),
        Area::Slope(d) if d == gust.from => piece.windward(put),
        Area::Slope(d) if d == gust.from.back() => piece.leeward(put),
        Area::Slope(d) => piece.along(d, put),
        Area::Plateau => {
            let near = share(u, [-FAR, 0.5 * gust.e]);
            put(FLAT + 2, near);
            put(FLAT + 3, 1.0 - near);
        }
        _ => {
            let (strip, near) = piece.depth();
            let corner = piece.corners();
            put(FLAT, strip * corner);
            put(FLAT + 1, strip * (1.0 - corner));
            put(FLAT + 2, near);
            put(FLAT + 3, 1.0 - strip - near);
        }
    }
}

struct Piece<'a> {
    plan: &'a Plan,
    at: [i32; 2],
    cell: &'a Cell,
    gust: &'a Gust,
    /// From the body's upwind edge, m.
    u: [f64; 2],
    /// From the body's lower edge across the wind, m.
    v: [f64; 2],
    width: f64,
    /// Interval along the wind, m from the plan's origin.
    row: [f64; 2],
}

impl Piece<'_> {
    /// Shares within e/10 and from there to e/2 of the upwind edge.
    fn depth(&self) -> (f64, f64) {
        let e = self.gust.e;
        (share(self.u, [-FAR, 0.1 * e]), share(self.u, [0.1 * e, 0.5 * e]))
    }

    /// Share within e/4 of either edge across the wind.
    fn corners(&self) -> f64 {
        let f = 0.25 * self.gust.e;
        (share(self.v, [-FAR, f]) + share(self.v, [self.width - f, FAR])).min(1.0)
    }

    fn has(&self, d: Direction) -> bool {
        self.plan.body(self.cell).faces >> (d as u8) & 1 == 1
    }

    /// Whether the body has slopes that fall across the wind: hips.
    fn sides(&self) -> bool {
        self.has(self.gust.from.left()) || self.has(self.gust.from.left().back())
    }

    /// The upwind end of this slope in its row, the cell before it if the body goes on there, and this piece's distances from it:
    /// from its middle where another face begins there (ridge, hip), else from its edge.
    fn upwind_end(&self, d: Direction) -> (Cell, Option<Cell>, [f64; 2]) {
        let (from, bit) = (self.gust.from, 1u8 << d as u8);
        let end = self.plan.end_of(self.at, from, bit);
        let s = from.step().map(|s| s as i32);
        let (cell, before) = (*self.plan.cell(end), *self.plan.cell([end[0] + s[0], end[1] + s[1]]));
        let joined = self.plan.joined(&cell, &before);
        let (axis, module) = (from as usize % 2, self.plan.module[from as usize % 2]);
        let middle = (f64::from(end[axis]) + 0.5) * module;
        let line = match (cell.faces & !bit != 0, positive(from)) {
            (true, _) => middle,
            (false, true) => middle + 0.5 * module,
            (false, false) => middle - 0.5 * module,
        };
        let behind = distances(self.row, [line; 2], positive(from));
        (cell, joined.then_some(before), [behind[0].max(0.0), behind[1].max(0.0)])
    }

    /// F, G, H behind the upwind edge.
    fn edge(&self, first: Zone, put: &mut impl FnMut(Zone, f64)) {
        let ((strip, _), corner) = (self.depth(), self.corners());
        put(first, strip * corner);
        put(first + 1, strip * (1.0 - corner));
        put(first + 2, 1.0 - strip);
    }

    /// A slope that faces the wind.
    fn windward(&self, put: &mut impl FnMut(Zone, f64)) {
        let from = self.gust.from;
        let (_, before, behind) = self.upwind_end(from);
        if before.is_some_and(|c| c.faces >> (from.back() as u8) & 1 == 1) && !self.sides() {
            let strip = share(behind, [-FAR, 0.1 * self.gust.e]);
            put(TROUGH_0 + 4, strip);
            return put(TROUGH_0 + 3, 1.0 - strip);
        }
        self.edge(
            if self.sides() {
                HIP
            } else if self.has(from.back()) {
                DUO_0
            } else {
                MONO_0
            },
            put,
        );
    }

    /// A slope that faces away from the wind.
    fn leeward(&self, put: &mut impl FnMut(Zone, f64)) {
        let from = self.gust.from;
        let (end, before, behind) = self.upwind_end(from.back());
        let ridge = end.faces & (1 << from as u8 | PLATEAU) != 0 || before.is_some();
        let hip = end.faces & (1 << from.left() as u8 | 1 << from.left().back() as u8) != 0;
        if !ridge && !hip {
            return self.edge(if self.has(from) { TROUGH_0 } else { MONO_180 }, put);
        }
        let strip = share(behind, [-FAR, 0.1 * self.gust.e]);
        if !self.sides() {
            put(DUO_0 + 4, strip);
            return put(DUO_0 + 3, 1.0 - strip);
        }
        // Where the ridge ends in a hip, in the middle of a cell, half of the strip lies along each.
        let j = match (hip, end.faces >> (from as u8) & 1 == 1) {
            (false, _) => 0.0,
            (true, false) => 1.0,
            (true, true) => 0.5,
        };
        put(HIP + 4, strip * j);
        put(HIP + 5, strip * (1.0 - j));
        put(HIP + 3, 1.0 - strip);
    }

    /// A slope that falls to `d`, across the wind.
    fn along(&self, d: Direction, put: &mut impl FnMut(Zone, f64)) {
        let (end, before, behind) = self.upwind_end(d);
        let (strip, near) = self.depth();
        if end.faces >> (self.gust.from as u8) & 1 == 1 || before.is_some() {
            let hip = end.faces >> (self.gust.from as u8) & 1 == 1;
            let l = if hip { share(behind, [-FAR, 0.1 * self.gust.e]) } else { 0.0 };
            let m = (strip + near - l).max(0.0).min(1.0 - l);
            put(HIP + 6, l);
            put(HIP + 7, m);
            return put(HIP + 8, 1.0 - l - m);
        }
        // Shares within e/4 of the low and of the high edge.
        let f = 0.25 * self.gust.e;
        let ends = [share(self.v, [self.width - f, FAR]), share(self.v, [-FAR, f])];
        let [low, high] = if positive(d) { ends } else { [ends[1], ends[0]] };
        let rest = 1.0 - strip - near;
        if !self.has(d.back()) {
            let low = low.min(1.0 - high);
            put(MONO_90, strip * high);
            put(MONO_90 + 1, strip * low);
            put(MONO_90 + 2, strip * (1.0 - high - low));
            put(MONO_90 + 3, near);
            return put(MONO_90 + 4, rest);
        }
        let foot = self.plan.end_of(self.at, d, 1 << d as u8);
        let s = d.step().map(|s| s as i32);
        let runs_on = self.plan.joined(self.cell, self.plan.cell([foot[0] + s[0], foot[1] + s[1]]));
        let valley = runs_on && !self.has(self.gust.from) && !self.has(self.gust.from.back());
        let (first, corner) = if valley { (TROUGH_90, high) } else { (DUO_90, low) };
        put(first, strip * corner);
        put(first + 1, strip * (1.0 - corner));
        put(first + 2, near);
        put(first + 3, rest);
    }
}

/// Zones of a piece of wall facing `d` with their shares. `p` is its middle in m from the plan's origin, at height `z`; `width` its
/// width in m.
pub(super) fn wall(
    plan: &Plan,
    d: Direction,
    p: [f64; 2],
    z: f64,
    width: f64,
    gust: &Gust,
    put: &mut impl FnMut(Zone, f64),
) {
    if d == gust.from {
        return put(WALL + 3, 1.0);
    }
    if d == gust.from.back() {
        return put(WALL + 4, 1.0);
    }
    let (axis, high) = (gust.from as usize % 2, positive(gust.from));
    let module = plan.module[axis];
    // The cell behind the wall; a corner post stands between two.
    let behind = |shift: f64| {
        let mut q = p;
        q[1 - axis] -= 0.25 * plan.module[1 - axis] * d.step()[1 - axis] as f64;
        q[axis] += shift * module;
        plan.cell_at(q)
    };
    let Some(cell) = [-0.01, 0.01].map(behind).into_iter().find(|&c| plan.cell(c).top.is_finite()) else {
        return put(WALL + 1, 1.0);
    };
    // The wall belongs to what stands as high as this piece, and to all that is under one roof with it.
    let own = plan.cell(cell);
    let stands = |c: [i32; 2]| plan.cell(c).top > z || plan.joined(own, plan.cell(c));
    let walk = |step: i32| {
        let mut at = cell;
        loop {
            let mut next = at;
            next[axis] += step;
            if !stands(next) {
                return at[axis];
            }
            at = next;
        }
    };
    let edges = [f64::from(walk(-1)) * module, (f64::from(walk(1)) + 1.0) * module];
    // A stud in the middle of a module carries that module, whatever the roof leaves of it.
    let centre = (p[axis] / module - 0.5).rem_euclid(1.0);
    let width = if width > 0.0 && centre.min(1.0 - centre) < 0.01 { module } else { width };
    let piece = [(p[axis] - 0.5 * width).max(edges[0]), (p[axis] + 0.5 * width).min(edges[1])];
    let u = distances(piece, edges, high);
    let (a, b) = (share(u, [-FAR, 0.2 * gust.e]), share(u, [0.2 * gust.e, gust.e]));
    put(WALL, a);
    put(WALL + 1, b);
    put(WALL + 2, 1.0 - a - b);
}

/// The directions that walls under a projecting floor face, nearest first: away from the nearest cells that reach down, within six
/// cells; all of them where several are equally near.
pub(super) fn walls_under(plan: &Plan, cell: [i32; 2]) -> impl Iterator<Item = Direction> + Clone {
    let reaches_down = move |d: Direction, n: i32| {
        let s = d.step().map(|s| s as i32);
        let other = plan.cell([cell[0] - n * s[0], cell[1] - n * s[1]]);
        other.top.is_finite() && other.soffit.is_nan()
    };
    let near = (1..=6).find(|&n| Direction::ALL.into_iter().any(|d| reaches_down(d, n)));
    let found = Direction::ALL.map(|d| near.is_some_and(|n| reaches_down(d, n)));
    Direction::ALL.into_iter().filter(move |&d| found[d as usize])
}
