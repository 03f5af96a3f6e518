//! Moves of the massing: bays, wings, storeys.

use super::pick;
use crate::search::cells::Cells;
use crate::search::massing::{Massing, StoreyMass};
use crate::search::openings::{Bay, bays};
use crate::search::plot::Space;
use rand::{Rng, RngExt};
use std::ops::Range;

/// Which storeys a change of one storey takes along: only itself, itself and all above, all below, or all.
fn scope(s: usize, count: usize, rng: &mut impl Rng) -> Range<usize> {
    match rng.random_range(0..4) {
        0 => s..s + 1,
        1 => s..count,
        2 => 0..s + 1,
        _ => 0..count,
    }
}

fn draw_storey(massing: &Massing, rng: &mut impl Rng) -> usize {
    rng.random_range(0..massing.storeys.len())
}

/// One to three modules, one most often.
fn depth(rng: &mut impl Rng) -> usize {
    [1, 1, 1, 2, 2, 3][rng.random_range(0..6usize)]
}

/// A bay or, one time in three, a piece of it at least three modules long.
fn piece(bay: Bay, rng: &mut impl Rng) -> Bay {
    if bay.length <= 3 || rng.random_range(0..3) > 0 {
        return bay;
    }
    let length = rng.random_range(3..=bay.length);
    // At one end of the bay: a push in its middle would leave two notches.
    let from = if rng.random_bool(0.5) { 0 } else { (bay.length - length) as isize };
    let [ax, ay] = crate::search::massing::along(bay.facing);
    Bay { cell: [bay.cell[0] + from * ax, bay.cell[1] + from * ay], length, ..bay }
}

/// The rectangle that reaches from a bay outwards (`from` = 1) or inwards (`from` = 1 - depth) over `depth` modules.
fn strip(size: [usize; 2], bay: Bay, from: isize, depth: usize) -> Cells {
    let ([nx, ny], [ax, ay], [x, y]) = (bay.facing.step(), crate::search::massing::along(bay.facing), bay.cell);
    let mut out = Cells::new(size);
    for i in 0..bay.length as isize {
        for d in from..from + depth as isize {
            let (cx, cy) = (x + i * ax + d * nx, y + i * ay + d * ny);
            if cx >= 0 && cy >= 0 {
                out.set([cx as usize, cy as usize], true);
            }
        }
    }
    out
}

/// Pushes a bay outwards or pulls it inwards.
pub fn push_bay(massing: &mut Massing, space: &Space, rng: &mut impl Rng, outwards: bool) -> Option<()> {
    let s = draw_storey(massing, rng);
    let bay = piece(pick(&bays(&massing.storeys[s].footprint), rng)?, rng);
    let depth = depth(rng);
    let from = if outwards { 1 } else { 1 - depth as isize };
    let strip = strip(space.plot.size(), bay, from, depth);
    for i in scope(s, massing.storeys.len(), rng) {
        let plan = &mut massing.storeys[i].footprint;
        *plan = if outwards { plan.or(&strip) } else { plan.minus(&strip) };
    }
    Some(())
}

/// Adds a rectangle at a facade.
pub fn add_wing(massing: &mut Massing, rng: &mut impl Rng) -> Option<()> {
    let s = draw_storey(massing, rng);
    let size = massing.storeys[s].footprint.size();
    let bay = pick(&bays(&massing.storeys[s].footprint), rng)?;
    let width = rng.random_range(3..=6usize).min(bay.length.max(3));
    let slide = rng.random_range(0..=bay.length.saturating_sub(width)) as isize;
    let [ax, ay] = crate::search::massing::along(bay.facing);
    let wing = Bay { cell: [bay.cell[0] + slide * ax, bay.cell[1] + slide * ay], length: width, ..bay };
    let strip = strip(size, wing, 1, rng.random_range(3..=6usize));
    let storeys = if rng.random_bool(0.5) { 0..s + 1 } else { scope(s, massing.storeys.len(), rng) };
    storeys.for_each(|i| massing.storeys[i].footprint = massing.storeys[i].footprint.or(&strip));
    Some(())
}

/// The part of the plan on one side of a random line through the storey.
fn side_of_line(plan: &Cells, rng: &mut impl Rng) -> Option<(Cells, bool)> {
    let (nx, ny) = (plan.size()[0], plan.size()[1]);
    let ([x, y], [w, h]) = plan.bounds()?;
    let across_x = rng.random_bool(0.5);
    let (origin, extent) = if across_x { (x, w) } else { (y, h) };
    if extent < 4 {
        return None;
    }
    let cut = origin + rng.random_range(1..extent);
    let beyond = rng.random_bool(0.5);
    let half = match (across_x, beyond) {
        (true, true) => Cells::rect([nx, ny], [cut as isize, 0], [nx, ny]),
        (true, false) => Cells::rect([nx, ny], [0, 0], [cut, ny]),
        (false, true) => Cells::rect([nx, ny], [0, cut as isize], [nx, ny]),
        (false, false) => Cells::rect([nx, ny], [0, 0], [nx, cut]),
    };
    Some((half, across_x))
}

/// Cuts off everything beyond a line, at most half of the storey.
pub fn remove_wing(massing: &mut Massing, rng: &mut impl Rng) -> Option<()> {
    let s = draw_storey(massing, rng);
    let plan = massing.storeys[s].footprint.clone();
    let (half, _) = side_of_line(&plan, rng)?;
    // Only one of the parts beyond the line, where it cuts several wings.
    let beyond = plan.and(&half);
    let seeds: Vec<[usize; 2]> = beyond.iter().collect();
    let [x, y] = pick(&seeds, rng)?;
    let part = beyond.component([x as isize, y as isize]);
    if 2 * part.count() > plan.count() {
        return None;
    }
    let storeys = if rng.random_bool(0.5) { s..massing.storeys.len() } else { scope(s, massing.storeys.len(), rng) };
    storeys.for_each(|i| massing.storeys[i].footprint = massing.storeys[i].footprint.minus(&part));
    Some(())
}

/// Slides everything beyond a line along it, with its openings and stairs.
pub fn shift_wing(massing: &mut Massing, rng: &mut impl Rng) -> Option<()> {
    let s = draw_storey(massing, rng);
    let (half, across_x) = side_of_line(&massing.storeys[s].footprint, rng)?;
    let by = depth(rng) as isize * if rng.random_bool(0.5) { 1 } else { -1 };
    let step = if across_x { [0, by] } else { [by, 0] };
    let storeys = if rng.random_bool(0.7) { 0..massing.storeys.len() } else { scope(s, massing.storeys.len(), rng) };
    for i in storeys {
        shift_part(&mut massing.storeys[i], &half, step)?;
    }
    Some(())
}

fn shift_part(storey: &mut StoreyMass, half: &Cells, step: [isize; 2]) -> Option<()> {
    let (part, rest) = (storey.footprint.and(half), storey.footprint.minus(half));
    let moved = part.shifted(step);
    if moved.count() < part.count() {
        return None; // it would leave the plot
    }
    storey.footprint = rest.or(&moved);
    for opening in storey.openings.iter_mut().filter(|o| half.has(o.cell)) {
        opening.cell = [opening.cell[0] + step[0], opening.cell[1] + step[1]];
    }
    if let Some(stair) = storey.stair.as_mut().filter(|s| half.has(s.start.map(|v| v as isize))) {
        let [x, y] = [stair.start[0].checked_add_signed(step[0])?, stair.start[1].checked_add_signed(step[1])?];
        stair.start = [x, y];
    }
    Some(())
}

/// A storey on top: a copy of the top one, or of the larger part of it beyond a line.
pub fn add_storey(massing: &mut Massing, space: &Space, rng: &mut impl Rng) -> Option<()> {
    if massing.storeys.len() >= space.most_storeys() {
        return None;
    }
    let top = massing.storeys.last()?;
    let mut footprint = top.footprint.clone();
    if rng.random_bool(0.5) {
        let (half, _) = side_of_line(&footprint, rng)?;
        footprint = footprint.and(&half);
    }
    footprint = footprint.and(&space.plot.allowed(massing.storeys.len()));
    let openings =
        top.openings.iter().filter(|o| o.infill == crate::search::massing::Infill::Window).copied().collect();
    massing.storeys.push(StoreyMass { footprint, openings, stair: None });
    Some(())
}

/// The top storey off.
pub fn remove_storey(massing: &mut Massing, space: &Space) -> Option<()> {
    if massing.storeys.len() <= space.least_storeys() {
        return None;
    }
    massing.storeys.pop();
    Some(())
}
