//! Sample houses of many kinds, for pictures and broad tests; each keeps every rule.

use super::samples::{Rect, add_stair, door, french_window, massing, window};
use super::{Direction, House, Label, Stair, StairKind};
use Direction::{East, North, South, West};

/// All gallery houses with their names.
pub fn gallery() -> Vec<(&'static str, House)> {
    vec![
        ("villa", villa()),
        ("gable", gable()),
        ("court", court()),
        ("flat", flat()),
        ("stepped", stepped()),
        ("tower", tower()),
    ]
}

fn u_stair(house: &mut House, storey: usize, start: [usize; 2]) {
    add_stair(house, Stair { storey, start, run: East, kind: StairKind::UTurn });
}

/// Two storeys of 10 x 8 modules under a hip roof.
fn villa() -> House {
    let plan: &[Rect] = &[[1, 1, 10, 8]];
    let mut house = massing([12, 10, 18], &[plan, plan], 4);
    u_stair(&mut house, 0, [4, 4]);
    door(&mut house, 0, [5, 1]);
    french_window(&mut house, 0, South, [7, 1], 3);
    window(&mut house, 0, South, [2, 1], 2);
    for storey in 0..2 {
        window(&mut house, storey, East, [10, 3], 3);
        window(&mut house, storey, West, [1, 3], 2);
        window(&mut house, storey, North, [4, 8], 2);
    }
    window(&mut house, 1, South, [2, 1], 2);
    window(&mut house, 1, South, [5, 1], 1);
    window(&mut house, 1, South, [7, 1], 3);
    house
}

/// One storey of 10 x 7 modules under a saddle roof along x.
fn gable() -> House {
    let mut house = massing([12, 9, 11], &[&[[1, 1, 10, 7]]], 0);
    for i in 0..3 {
        for y in 1 + i..8 - i {
            (1..11).for_each(|x| house.voxels.set([x, y, 7 + i], Label::Base));
        }
    }
    door(&mut house, 0, [4, 1]);
    french_window(&mut house, 0, South, [6, 1], 3);
    window(&mut house, 0, South, [2, 1], 1);
    window(&mut house, 0, East, [10, 3], 3);
    window(&mut house, 0, West, [1, 3], 3);
    house
}

/// One storey round a court of 4 x 4 modules, flat roof.
fn court() -> House {
    let ring: &[Rect] = &[[1, 1, 12, 4], [1, 9, 12, 4], [1, 5, 4, 4], [9, 5, 4, 4]];
    let mut house = massing([14, 14, 7], &[ring], 0);
    door(&mut house, 0, [3, 1]);
    window(&mut house, 0, South, [6, 1], 4);
    window(&mut house, 0, East, [12, 5], 4);
    french_window(&mut house, 0, North, [6, 4], 2);
    window(&mut house, 0, West, [1, 6], 3);
    window(&mut house, 0, North, [5, 12], 4);
    house
}

/// Two storeys of 9 x 7 modules with a flat roof.
fn flat() -> House {
    let plan: &[Rect] = &[[1, 1, 9, 7]];
    let mut house = massing([11, 9, 13], &[plan, plan], 0);
    u_stair(&mut house, 0, [3, 3]);
    door(&mut house, 0, [2, 1]);
    french_window(&mut house, 0, South, [4, 1], 4);
    window(&mut house, 0, East, [9, 3], 3);
    window(&mut house, 1, South, [3, 1], 5);
    window(&mut house, 1, East, [9, 3], 3);
    house
}

/// Two storeys beside a lower wing whose roof is a terrace with a door onto it.
fn stepped() -> House {
    let mut house = massing([16, 10, 17], &[&[[1, 1, 14, 8]], &[[1, 1, 9, 8]]], 3);
    u_stair(&mut house, 0, [4, 4]);
    door(&mut house, 0, [5, 1]);
    window(&mut house, 0, South, [2, 1], 2);
    french_window(&mut house, 0, South, [8, 1], 5);
    window(&mut house, 0, East, [14, 3], 3);
    window(&mut house, 0, West, [1, 3], 3);
    window(&mut house, 1, South, [3, 1], 4);
    window(&mut house, 1, West, [1, 3], 3);
    door(&mut house, 1, [9, 5]);
    window(&mut house, 1, East, [9, 2], 2);
    house
}

/// Three storeys of 8 x 8 modules under a hip roof.
fn tower() -> House {
    let plan: &[Rect] = &[[1, 1, 8, 8]];
    let mut house = massing([10, 10, 24], &[plan, plan, plan], 4);
    u_stair(&mut house, 0, [3, 5]);
    u_stair(&mut house, 1, [3, 2]);
    door(&mut house, 0, [2, 1]);
    for storey in 0..3 {
        window(&mut house, storey, South, [4, 1], 3);
        window(&mut house, storey, East, [8, 3], 3);
        window(&mut house, storey, West, [1, 4], 2);
    }
    house
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::voxels::rules;

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
}
