//! Blocks of walls, roofs, floors and foundation: every cell of the plan, cut where planes cross, and stacked.

use super::super::{Block, Component};
use super::arrange::{Polygon, cells, centre};
use super::field::{Field, Paint};
use super::heights::{HALF_PLAN_UM, Plane};
use super::merge::merge;

/// A block in quadrant coordinates.
#[derive(Clone, Debug)]
pub(super) struct Piece {
    pub plan: Polygon,
    pub bottom: Plane,
    pub top: Plane,
    pub component: Component,
    pub octant: u8,
}

/// Adds the blocks of the body to `blocks`.
pub(super) fn build(field: &Field, blocks: &mut Vec<Block>) {
    let mut paints = Vec::new();
    let mut pieces = Vec::new();
    for q in 0..4 {
        let sides = field.sides(q);
        for cell in cells(field, q, &sides) {
            field.paints(q, &sides, &centre(&cell), &mut paints);
            if !paints.is_empty() {
                stack(cell, &paints, &mut pieces);
            }
        }
        merge(&mut pieces);
        blocks.extend(pieces.drain(..).map(|piece| placed(q, &piece)));
    }
}

/// A piece in the cube's own axes.
fn placed(q: usize, piece: &Piece) -> Block {
    let sign = |bit: usize| if q & bit == 0 { -1 } else { 1 };
    let (sx, sy) = (sign(1), sign(2));
    let mut corners = piece.plan.clone();
    if sx != sy {
        corners.reverse();
    }
    Block {
        component: piece.component,
        octant: piece.octant,
        bottom: corners.iter().map(|&c| piece.bottom.at(c)).collect(),
        top: corners.iter().map(|&c| piece.top.at(c)).collect(),
        plan: corners.iter().map(|[a, b]| [HALF_PLAN_UM + sx * a, HALF_PLAN_UM + sy * b]).collect(),
    }
}

/// The pieces over one cell.
fn stack(cell: Polygon, paints: &[Paint], pieces: &mut Vec<Piece>) {
    let mut planes: Vec<Plane> = Vec::with_capacity(16);
    for plane in paints.iter().flat_map(|p| p.from.iter().chain(&p.to)) {
        if !planes.contains(plane) {
            planes.push(*plane);
        }
    }
    let mut open = vec![cell];
    while let Some(cell) = open.pop() {
        match crossing(&cell, &planes) {
            Some((f, g)) => open.extend(split(&cell, f, g)),
            None => pile(&cell, paints, &planes, pieces),
        }
    }
}

/// Twofold differences of two planes over the corners of a cell.
fn differences(cell: &[[i32; 2]], f: Plane, g: Plane) -> impl Iterator<Item = i64> {
    cell.iter().map(move |&corner| f.five_times(corner) - g.five_times(corner))
}

/// Two planes that cross inside the cell.
fn crossing(cell: &[[i32; 2]], planes: &[Plane]) -> Option<(Plane, Plane)> {
    for (n, f) in planes.iter().enumerate() {
        for g in planes[..n].iter().filter(|g| f.slope != g.slope) {
            let above = differences(cell, *f, *g).any(|d| d > 0);
            if above && differences(cell, *f, *g).any(|d| d < 0) {
                return Some((*f, *g));
            }
        }
    }
    None
}

/// The parts of a cell on both sides of the line where two planes cross.
fn split(cell: &[[i32; 2]], f: Plane, g: Plane) -> [Polygon; 2] {
    let mut parts = [Vec::with_capacity(cell.len() + 1), Vec::with_capacity(cell.len() + 1)];
    let d: Vec<i64> = differences(cell, f, g).collect();
    for i in 0..cell.len() {
        let j = (i + 1) % cell.len();
        if d[i] >= 0 {
            parts[0].push(cell[i]);
        }
        if d[i] <= 0 {
            parts[1].push(cell[i]);
        }
        if d[i].signum() * d[j].signum() < 0 {
            let at = [0, 1].map(|axis| {
                let [p, q] = [i64::from(cell[i][axis]), i64::from(cell[j][axis])];
                // Whole multiples of 5 µm: depths and heights lie on grids chosen for it.
                ((p * d[j] - q * d[i]) / (d[j] - d[i])) as i32
            });
            parts[0].push(at);
            parts[1].push(at);
        }
    }
    parts
}

/// Stacks what the paints say between the planes of a cell in which none cross.
fn pile(cell: &Polygon, paints: &[Paint], planes: &[Plane], pieces: &mut Vec<Piece>) {
    let height = |plane: Plane| cell.iter().map(|&corner| plane.five_times(corner)).sum::<i64>();
    let mut levels: Vec<(i64, Plane)> = planes.iter().map(|p| (height(*p), *p)).collect();
    levels.sort_by_key(|level| level.0);
    levels.dedup_by_key(|level| level.0);
    // Planes of equal height over the whole cell are the same plane; the first stands for all.
    let spans = paints.iter().map(|p| (p.from.map(height), p.to.map(height), p.component.map(|c| (c, p.octant))));
    let spans: Vec<_> = spans.map(|([a, b], [c, d], what)| (a.max(b), c.min(d), what)).collect();
    let mut last: Option<Piece> = None;
    for pair in levels.windows(2) {
        let [(low, bottom), (high, top)] = [pair[0], pair[1]];
        let what = spans.iter().find(|(from, to, _)| *from <= low && high <= *to).and_then(|(_, _, what)| *what);
        let same = last.as_ref().is_some_and(|p| Some((p.component, p.octant)) == what);
        if same {
            if let Some(piece) = &mut last {
                piece.top = top;
            }
            continue;
        }
        pieces.extend(last.take());
        last = what.map(|(component, octant)| Piece { plan: cell.clone(), bottom, top, component, octant });
    }
    pieces.extend(last);
}
