//! Jambs, lintels and sills around windows and doors.

use super::grid::{Grid, STOREY, Z};
use super::types::Role;
use crate::voxels::{FacadeOpening, STOREY_MODULES};

/// Frames one opening: jambs from plate to plate at both edges, a lintel on top, a sill below unless it stands on the slab; no
/// stud is left below it.
pub(super) fn frame_opening(grid: &mut Grid, opening: &FacadeOpening) {
    let step = opening.facing.step();
    let normal = usize::from(step[0] == 0);
    let along = 1 - normal;
    let plane = 2 * opening.cell[normal] as i32 + if step[normal] > 0 { 2 } else { 0 };
    let from = 2 * opening.cell[along] as i32;
    let to = from + 2 * opening.width as i32;
    let floor = STOREY * opening.storey as i32;
    let (low, high) = (2 * opening.k as i32 - 1, 2 * (opening.k + opening.height) as i32 - 1);
    let at = |s: i32, z: i32| {
        let mut p = [0, 0, z];
        p[normal] = plane;
        p[along] = s;
        p
    };
    for s in [from, to] {
        for z in floor..floor + STOREY {
            if grid.role(at(s, z), Z).is_none() {
                grid.set(at(s, z), Z, Some(Role::Jamb));
            }
        }
    }
    let on_slab = opening.k <= STOREY_MODULES * opening.storey + 1;
    for s in from..to {
        grid.set(at(s, high), along, Some(Role::Lintel));
        if !on_slab {
            grid.set(at(s, low), along, Some(Role::Sill));
        }
        if s > from {
            (floor..low).for_each(|z| grid.set(at(s, z), Z, None));
        }
    }
}
