//! Houses on one rectangle, or two in a line, under hips, saddles and lean-tos.

use super::super::Direction::{East, North, South, West};
use super::super::samples::{Rect, add_stair, door, french_window, massing, window};
use super::super::{House, Stair, StairKind};
use super::{block, saddle, u_stair};

/// Two storeys of 11 x 7 modules under a hip roof, symmetric about its door.
pub fn villa() -> House {
    let plan: &[Rect] = &[[1, 1, 11, 7]];
    let mut house = massing([13, 9, 18], &[plan, plan], 4);
    u_stair(&mut house, 0, [5, 5]);
    door(&mut house, 0, [6, 1]);
    french_window(&mut house, 0, South, [2, 1], 3);
    french_window(&mut house, 0, South, [8, 1], 3);
    window(&mut house, 1, South, [2, 1], 3);
    window(&mut house, 1, South, [6, 1], 1);
    window(&mut house, 1, South, [8, 1], 3);
    for storey in 0..2 {
        window(&mut house, storey, East, [11, 3], 3);
        window(&mut house, storey, North, [3, 7], 1);
        window(&mut house, storey, North, [9, 7], 1);
    }
    house
}

/// One storey of 11 x 7 modules under a saddle roof along x.
pub fn gable() -> House {
    let plan: Rect = [1, 1, 11, 7];
    let mut house = massing([13, 9, 12], &[&[plan]], 0);
    saddle(&mut house, 6, plan, 0, 4);
    window(&mut house, 0, South, [2, 1], 2);
    door(&mut house, 0, [5, 1]);
    french_window(&mut house, 0, South, [7, 1], 4);
    window(&mut house, 0, East, [11, 3], 3);
    window(&mut house, 0, West, [1, 4], 1);
    window(&mut house, 0, North, [3, 7], 1);
    house
}

/// Three storeys of 7 x 7 modules under a pyramid, the stairs in turn on the north and on the south side.
pub fn tower() -> House {
    let plan: &[Rect] = &[[1, 1, 7, 7]];
    let mut house = massing([9, 9, 24], &[plan, plan, plan], 4);
    (0..2).for_each(|storey| u_stair(&mut house, storey, [3, [5, 2][storey % 2]]));
    window(&mut house, 0, South, [3, 1], 3);
    door(&mut house, 0, [7, 4]);
    window(&mut house, 0, North, [4, 7], 1);
    for storey in 0..3 {
        if storey > 0 {
            window(&mut house, storey, South, [3, 1], 3);
            window(&mut house, storey, East, [7, 4], 1);
        }
        window(&mut house, storey, West, [1, 4], 1);
    }
    house
}

/// Three houses of 6 x 7 modules in a row under one saddle roof, each with its door, its stair and two storeys.
pub fn row() -> House {
    let plan: Rect = [1, 1, 18, 7];
    let mut house = massing([20, 9, 18], &[&[plan], &[plan]], 0);
    saddle(&mut house, 12, plan, 0, 4);
    u_stair(&mut house, 0, [3, 5]);
    u_stair(&mut house, 0, [9, 5]);
    add_stair(&mut house, Stair { storey: 0, start: [16, 6], run: West, kind: StairKind::UTurn });
    for x in [1, 7, 13] {
        door(&mut house, 0, [x + 1, 1]);
        french_window(&mut house, 0, South, [x + 3, 1], 2);
        window(&mut house, 0, North, [x + 2, 7], 2);
        window(&mut house, 1, South, [x + 1, 1], 1);
        window(&mut house, 1, South, [x + 3, 1], 2);
        window(&mut house, 1, North, [x + 2, 7], 2);
    }
    (0..2).for_each(|storey| window(&mut house, storey, East, [18, 4], 1));
    house
}

/// Rooms on two levels under two roofs: a wing of one storey along x beside a block of two across it.
pub fn split() -> House {
    let (wing, tall): (Rect, Rect) = ([1, 2, 9, 7], [10, 1, 7, 9]);
    let mut house = massing([18, 11, 18], &[&[wing, tall], &[tall]], 0);
    saddle(&mut house, 6, wing, 0, 4);
    saddle(&mut house, 12, tall, 1, 4);
    u_stair(&mut house, 0, [12, 7]);
    french_window(&mut house, 0, South, [2, 2], 4);
    door(&mut house, 0, [7, 2]);
    french_window(&mut house, 0, South, [12, 1], 3);
    window(&mut house, 1, South, [12, 1], 3);
    for storey in 0..2 {
        window(&mut house, storey, East, [16, 3], 2);
        window(&mut house, storey, East, [16, 7], 2);
    }
    window(&mut house, 0, West, [1, 4], 3);
    house
}

/// Two storeys under a saddle roof, and at its east end a garden room under a roof that leans on the gable wall.
pub fn lean_to() -> House {
    let (main, room): (Rect, Rect) = ([1, 1, 9, 7], [10, 1, 4, 7]);
    let mut house = massing([15, 9, 18], &[&[main, room], &[main]], 0);
    saddle(&mut house, 12, main, 0, 4);
    (0..4).for_each(|i| block(&mut house, [10, 1, 4 - i, 7], 7 + i));
    u_stair(&mut house, 0, [4, 5]);
    window(&mut house, 0, South, [2, 1], 1);
    door(&mut house, 0, [4, 1]);
    french_window(&mut house, 0, South, [6, 1], 3);
    french_window(&mut house, 0, South, [11, 1], 2);
    french_window(&mut house, 0, East, [13, 3], 3);
    window(&mut house, 1, South, [2, 1], 1);
    window(&mut house, 1, South, [4, 1], 1);
    window(&mut house, 1, South, [6, 1], 3);
    (0..2).for_each(|storey| window(&mut house, storey, West, [1, 4], 1));
    window(&mut house, 1, North, [6, 7], 2);
    house
}
