//! Level lines of a roof: which are ridges, edges of a plateau or rafters across it, and which are purlins to be left out.

use super::grid::{X, label};
use super::types::Role;
use crate::voxels::VoxelArray;

/// Top filled layer of a cell at or above layer k - 1, relative to k: 1 higher, 0 level, -1 lower.
fn relative(v: &VoxelArray, [i, j]: [i32; 2], k: i32) -> i32 {
    match (label(v, i, j, k).is_filled(), label(v, i, j, k + 1).is_filled()) {
        (true, true) => 1,
        (true, false) => 0,
        (false, _) => -1,
    }
}

/// The role of a level step at the height of roof tops: on a slope none, at a ridge or plateau edge `Ridge`, across a plateau the
/// short way `Rafter`.
pub(super) fn level_line(v: &VoxelArray, p: [i32; 3], step: usize) -> Option<Role> {
    let k = (p[2] - 1) / 2;
    let along = 1 - step;
    let centre = [(p[0] - 1) / 2, (p[1] - 1) / 2];
    // Cells at both ends of the module the step lies in.
    let cells = if p[step] % 2 == 1 {
        [centre, shifted(centre, step, 1)]
    } else {
        [
            [0, 1].map(|a| if a == step { p[a] / 2 - 1 } else { centre[a] }),
            [0, 1].map(|a| if a == step { p[a] / 2 } else { centre[a] }),
        ]
    };
    let side = |d: i32| {
        let near = cells.map(|c| relative(v, shifted(c, along, d), k));
        if near.contains(&1) {
            1
        } else if near.contains(&0) {
            0
        } else {
            -1
        }
    };
    match (side(-1), side(1)) {
        (1, -1) | (-1, 1) => None,
        (-1, _) | (_, -1) => Some(Role::Ridge),
        (0, 0) => {
            let (this, other) = (extent(v, cells[0], step, k), extent(v, cells[0], along, k));
            (this < other || (this == other && step == X)).then_some(Role::Rafter)
        }
        _ => Some(Role::Ridge),
    }
}

fn shifted(mut cell: [i32; 2], axis: usize, by: i32) -> [i32; 2] {
    cell[axis] += by;
    cell
}

/// Cells of the plateau in a row through `cell` along `axis`.
fn extent(v: &VoxelArray, cell: [i32; 2], axis: usize, k: i32) -> i32 {
    let level = |d: i32| relative(v, shifted(cell, axis, d), k) == 0;
    (1..).take_while(|&d| level(d)).count() as i32 + (1..).take_while(|&d| level(-d)).count() as i32 + 1
}
