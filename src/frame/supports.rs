//! Floor levels and the eave: the nodes whose drift is measured.

use super::grid::{Grid, NONE, STOREY};
use super::sticks::Stick;
use super::types::{HouseFrame, Level, Role};

/// Fills [`HouseFrame::levels`].
pub(super) fn fill(grid: &Grid, sticks: &[Stick], half_m: f64, frame: &mut HouseFrame) {
    // Gable studs reach higher, but each to its own height.
    let plates = sticks.iter().filter(|s| s.role == Role::Plate);
    let eave = plates.map(|s| s.from[2]).max().unwrap_or(0);
    let mut heights: Vec<i32> = (0..=eave / STOREY).map(|s| s * STOREY).collect();
    if eave % STOREY != 0 {
        heights.push(eave);
    }
    for z in heights {
        let mut level = Level { z_m: f64::from(z) * half_m, nodes: Vec::new() };
        for s in sticks.iter().filter(|s| s.role.is_vertical() && s.from[2] <= z && z <= s.from[2] + s.length) {
            let node = grid.node[grid.point([s.from[0], s.from[1], z])];
            if node != NONE {
                level.nodes.push(node);
            }
        }
        level.nodes.sort_unstable();
        level.nodes.dedup();
        frame.levels.push(level);
    }
}
