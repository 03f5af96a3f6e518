//! Strips of deck that hold single nodes of a stick across.

use super::grid::{Grid, NONE, STEPS, X, Y, Z, label};
use super::sheathing::{Panel, PanelKind, SHEATHING};
use super::sticks::Stick;
use super::types::{HouseFrame, Role};
use crate::voxels::VoxelArray;

/// Board nailed along a stick holds its inner nodes across: per node two diagonal strips of deck, one module wide, run at about 45
/// degrees to both ends of the bay. E A = 2 (1 + nu) S w; capacity: shear flow x w x sqrt 2.
///
/// Needed where a vertical pushes: walls along the joists, sills of walls above, posts under a joist.
pub(super) fn hold_by_deck(grid: &Grid, v: &VoxelArray, stick: &Stick, frame: &mut HouseFrame) {
    let (axis, across) = if stick.step == X { (X, Y) } else { (Y, X) };
    for n in 1..stick.length {
        let p = stick.at(n);
        let pushed = grid.role(p, Z).is_some() || grid.role([p[0], p[1], p[2] - 1], Z).is_some();
        let crossed =
            [p, super::grid::sub(p, STEPS[across])].iter().any(|&q| grid.role(q, across) == Some(Role::Joist));
        if !pushed || crossed || grid.node[grid.point(p)] == NONE {
            continue;
        }
        for side in [-1, 1] {
            for end in [-1, 1] {
                if let Some(q) = strip_end(grid, v, p, axis, side, end) {
                    strip(grid, v, frame, p, q);
                }
            }
        }
    }
}

/// The node at which a strip from `p` across to `side` and along to `end` leaves the deck: on the first level stick across the axis
/// that bounds the slab, as near to 45 degrees as nodes allow.
fn strip_end(grid: &Grid, v: &VoxelArray, p: [i32; 3], axis: usize, side: i32, end: i32) -> Option<[i32; 3]> {
    let across = 1 - axis;
    let slab = |q: [i32; 3]| {
        let cell = |c: i32, towards: i32| if c % 2 == 0 && towards < 0 { c / 2 - 1 } else { c / 2 };
        let (along, off) = (cell(q[axis], end), cell(q[across], side));
        let [i, j] = if axis == X { [along, off] } else { [off, along] };
        label(v, i, j, q[2] / 2).is_slab()
    };
    let mut q = p;
    let mut edge = 0;
    // Along the stick to the edge of the slab beside it.
    while slab(q) && edge < 40 {
        q[axis] += end;
        edge += 1;
    }
    let ideal = edge.min(grid.size()[across]);
    let nodes = (1..=2 * ideal).filter_map(|n| {
        let mut r = q;
        r[across] += side * n;
        (grid.inside(r)
            && grid.node[grid.point(r)] != NONE
            && grid.level_at(r, &[Role::Plate, Role::Beam, Role::Trimmer]))
        .then_some((n, r))
    });
    nodes.min_by_key(|(n, _)| ((n - ideal).abs(), *n)).map(|(_, r)| r)
}

fn strip(grid: &Grid, v: &VoxelArray, frame: &mut HouseFrame, p: [i32; 3], q: [i32; 3]) {
    let nodes = [p, q].map(|r| grid.node[grid.point(r)]);
    let board = SHEATHING[PanelKind::Deck as usize];
    let width = v.module.size_m[0];
    frame.panels.push(Panel {
        kind: PanelKind::Deck,
        nodes,
        ea_n: 2.6 * board.shear_n_per_m * width,
        capacity_n: board.capacity_n_per_m * width * std::f64::consts::SQRT_2,
        line: frame.panels.len() as u32,
    });
}
