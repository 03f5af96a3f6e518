//! Houses with wings at a right angle, open to the south-east.

use super::super::Direction::{East, North, South, West};
use super::super::House;
use super::super::samples::{Rect, door, french_window, massing, window};
use super::{saddle, u_stair};

/// One storey on an L of 12 x 12 modules with wings five wide under a hipped roof; the door in the inner corner.
pub fn l_hip() -> House {
    let mut house = massing([14, 14, 11], &[&[[1, 8, 12, 5], [1, 1, 5, 12]]], 3);
    door(&mut house, 0, [7, 8]);
    french_window(&mut house, 0, South, [9, 8], 3);
    french_window(&mut house, 0, South, [2, 1], 3);
    french_window(&mut house, 0, East, [5, 3], 3);
    window(&mut house, 0, East, [12, 9], 3);
    window(&mut house, 0, North, [3, 12], 1);
    window(&mut house, 0, West, [1, 4], 1);
    house
}

/// Two storeys: a main house of 12 x 7 modules under a saddle roof along x, and a wing five wide whose own saddle roof, a
/// module lower, runs into it.
pub fn l_gable() -> House {
    let (main, wing): (Rect, Rect) = ([1, 6, 12, 7], [1, 1, 5, 5]);
    let plan: &[Rect] = &[main, wing];
    let mut house = massing([14, 14, 18], &[plan, plan], 0);
    saddle(&mut house, 12, main, 0, 4);
    // The wing's ridge goes on to where it meets the slope of the main roof.
    saddle(&mut house, 12, [1, 1, 5, 8], 1, 3);
    u_stair(&mut house, 0, [5, 10]);
    door(&mut house, 0, [7, 6]);
    french_window(&mut house, 0, South, [9, 6], 3);
    french_window(&mut house, 0, South, [2, 1], 3);
    window(&mut house, 1, South, [7, 6], 1);
    window(&mut house, 1, South, [9, 6], 3);
    window(&mut house, 1, South, [2, 1], 3);
    for storey in 0..2 {
        window(&mut house, storey, East, [12, 8], 3);
        window(&mut house, storey, East, [5, 3], 2);
        window(&mut house, storey, North, [3, 12], 2);
    }
    house
}
