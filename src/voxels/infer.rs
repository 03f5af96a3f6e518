//! Stairs from labels alone: the shape of a void in a plate tells which stair passes through it.

use super::{Direction, House, Plan, Reading, STOREY_MODULES, Stair, StairKind, VoxelArray, read_storeys};

/// Finds the stairs of a house of which only the labels are known.
///
/// A void of 5 x 1 cells in the plate above a storey is a straight stair, one of 2 x 4 cells a u-turn. Each shape fits two
/// orientations (first towards +x or +y, then back); the first whose landings are valid is taken: foot, head and flights
/// inside the lining of their storey, foot and head on slab. Voids of other shapes, or without valid landings, give none.
pub fn infer_stairs(voxels: &VoxelArray) -> Vec<Stair> {
    let house = House::new(voxels.clone());
    let reading = read_storeys(&house);
    let mut stairs: Vec<Stair> = Vec::new();
    for storey in &reading.storeys {
        let above = reading.plates.iter().find(|p| p.k == storey.plate_k + STOREY_MODULES);
        let Some(above) = above else { continue };
        for void in components(&above.void) {
            let found = candidates(&void, storey.index).into_iter().flatten().find(|s| stands(s, &reading));
            stairs.extend(found);
        }
    }
    stairs
}

/// Whether a stair's flights, foot and head lie inside the lining of storeys that exist, with slab under foot and head.
pub(super) fn stands(stair: &Stair, reading: &Reading) -> bool {
    let (Some(lower), Some(upper)) = (reading.storeys.get(stair.storey), reading.storeys.get(stair.storey + 1)) else {
        return false;
    };
    let slab = |k: usize, cell| reading.plates.iter().any(|p| p.k == k && p.slab.has(cell));
    stair.flight_cells().into_iter().chain(stair.middle_landing()).all(|c| lower.plan.interior(c))
        && lower.plan.interior(stair.foot())
        && slab(lower.plate_k, stair.foot())
        && upper.plan.interior(stair.head())
        && slab(upper.plate_k, stair.head())
        && stair.void_cells().into_iter().all(|c| upper.plan.interior(c))
}

/// 4-connected groups of cells, in plan order of their first cell.
fn components(plan: &Plan) -> Vec<Vec<[usize; 2]>> {
    let mut left = plan.clone();
    let mut groups = Vec::new();
    for first in plan.iter() {
        if !left.has(first.map(|c| c as isize)) {
            continue;
        }
        left.set(first, false);
        let mut group = vec![first];
        let mut next = 0;
        while next < group.len() {
            let [x, y] = group[next];
            next += 1;
            for d in Direction::ALL {
                let [dx, dy] = d.step();
                let cell = [x as isize + dx, y as isize + dy];
                if left.has(cell) {
                    let cell = cell.map(|c| c as usize);
                    left.set(cell, false);
                    group.push(cell);
                }
            }
        }
        groups.push(group);
    }
    groups
}

/// The two stairs a void could belong to.
fn candidates(void: &[[usize; 2]], storey: usize) -> [Option<Stair>; 2] {
    let low = [0, 1].map(|a| void.iter().map(|c| c[a]).min().unwrap_or(0));
    let high = [0, 1].map(|a| void.iter().map(|c| c[a]).max().unwrap_or(0));
    let size = [high[0] - low[0] + 1, high[1] - low[1] + 1];
    if size[0] * size[1] != void.len() {
        return [None, None];
    }
    let (kind, along) = match size {
        [5, 1] => (StairKind::Straight, 0),
        [1, 5] => (StairKind::Straight, 1),
        [4, 2] => (StairKind::UTurn, 0),
        [2, 4] => (StairKind::UTurn, 1),
        _ => return [None, None],
    };
    let forward = [Direction::East, Direction::North][along];
    [forward, forward.back()].map(|run| {
        let start = match kind {
            StairKind::Straight => before(if run == forward { low } else { high }, run)?,
            StairKind::UTurn => u_turn_start(low, high, run),
        };
        Some(Stair { storey, start, run, kind })
    })
}

/// The cell one step against `run`, `None` when it would leave the plan at 0.
fn before(cell: [usize; 2], run: Direction) -> Option<[usize; 2]> {
    let [dx, dy] = run.step();
    Some([cell[0].checked_add_signed(-dx)?, cell[1].checked_add_signed(-dy)?])
}

/// First cell of the lane that has the other lane to its left.
fn u_turn_start(low: [usize; 2], high: [usize; 2], run: Direction) -> [usize; 2] {
    match run {
        Direction::East => low,
        Direction::North => [high[0], low[1]],
        Direction::West => high,
        Direction::South => [low[0], high[1]],
    }
}
