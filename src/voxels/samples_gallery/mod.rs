//! Sample houses of many kinds, for pictures and broad tests; each keeps every rule.
//!
//! Spans are 5 or 7 modules wherever a roof rises: an odd span ends in a sharp ridge (5, 3, 1 modules on three layers; 7, 5, 3, 1
//! on four, the most without a storey under the roof), an even one in a flat strip. Living rooms have their glass to the
//! south, stairs stand on the north side, windows stand above each other.
//!
//! What the rules do not allow is not here: plates lie at whole storeys, so a split level is a storey beside another
//! ([`pitched::split`]), not half of one; and a roof that rises to one side needs a wall to lean on ([`pitched::lean_to`]), because
//! its uppermost row, one module wide, would otherwise be a bump.

mod flat;
mod pitched;
mod wings;

use super::samples::{Rect, add_stair};
use super::{Direction, House, Label, Stair, StairKind};

/// All gallery houses with their names.
pub fn gallery() -> Vec<(&'static str, House)> {
    vec![
        ("villa", pitched::villa()),
        ("gable", pitched::gable()),
        ("tower", pitched::tower()),
        ("row", pitched::row()),
        ("split", pitched::split()),
        ("lean_to", pitched::lean_to()),
        ("l_hip", wings::l_hip()),
        ("l_gable", wings::l_gable()),
        ("court", flat::court()),
        ("flat", flat::flat()),
        ("stepped", flat::stepped()),
        ("terrace", flat::terrace()),
    ]
}

/// A u-turn stair whose first flight runs east from `start`.
fn u_stair(house: &mut House, storey: usize, start: [usize; 2]) {
    add_stair(house, Stair { storey, start, run: Direction::East, kind: StairKind::UTurn });
}

/// A saddle roof of `rise` layers on the plate of layer `k`, with its ridge along x (0) or y (1) and verges at both ends.
fn saddle(house: &mut House, k: usize, [x, y, w, d]: Rect, ridge_along: usize, rise: usize) {
    for i in 0..rise {
        let (dx, dy) = if ridge_along == 0 { (0, i) } else { (i, 0) };
        block(house, [x + dx, y + dy, w - 2 * dx, d - 2 * dy], k + 1 + i);
    }
}

/// Base in one layer of a rectangle.
fn block(house: &mut House, [x, y, w, d]: Rect, k: usize) {
    for cell in (y..y + d).flat_map(|y| (x..x + w).map(move |x| [x, y, k])) {
        house.voxels.set(cell, Label::Base);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::voxels::{read_storeys, rules};

    #[test]
    fn every_house_keeps_every_rule() {
        let broken: Vec<String> = gallery()
            .iter()
            .flat_map(|(name, house)| {
                let found = rules::check(house, &Default::default());
                found.into_iter().map(move |v| format!("{name}: {v:?}"))
            })
            .collect();
        assert!(broken.is_empty(), "{}", broken.join("\n"));
    }

    /// Living rooms look south: on the ground, no other side has more glass.
    #[test]
    fn most_glass_of_the_ground_storey_faces_south() {
        for (name, house) in gallery() {
            let mut glass = [0.0; 4];
            for opening in read_storeys(&house).openings.iter().filter(|o| o.storey == 0) {
                glass[opening.facing as usize] += opening.glass_area_m2(&house.voxels.module);
            }
            let south = glass[Direction::South as usize];
            assert!(glass.iter().all(|g| *g <= south), "{name}: {glass:?}");
        }
    }

    /// Above a window or door of the ground storey's south side stands a window of the same columns, part of it, or wall.
    #[test]
    fn openings_stand_above_each_other() {
        for (name, house) in gallery() {
            let openings = read_storeys(&house).openings;
            let columns = |o: &super::super::FacadeOpening| o.cell[0]..o.cell[0] + o.width;
            for upper in openings.iter().filter(|o| o.storey > 0 && o.facing == Direction::South) {
                let below = openings
                    .iter()
                    .filter(|o| o.storey + 1 == upper.storey && o.facing == upper.facing && o.cell[1] == upper.cell[1]);
                let touched: Vec<_> = below.map(columns).filter(|c| columns(upper).any(|x| c.contains(&x))).collect();
                let inside = touched
                    .iter()
                    .all(|c| columns(upper).all(|x| c.contains(&x)) || c.clone().all(|x| columns(upper).contains(&x)));
                assert!(inside, "{name}: {upper:?} above {touched:?}");
            }
        }
    }
}
