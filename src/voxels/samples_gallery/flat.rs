//! Houses with level roofs and decks.

use super::super::Direction::{East, North, South, West};
use super::super::House;
use super::super::samples::{Rect, door, french_window, massing, window};
use super::{saddle, u_stair};

/// One storey round a court of 5 x 5 modules, flat roof; the rooms open into the court.
pub fn court() -> House {
    let ring: &[Rect] = &[[1, 1, 13, 4], [1, 10, 13, 4], [1, 5, 4, 5], [10, 5, 4, 5]];
    let mut house = massing([15, 15, 7], &[ring], 0);
    window(&mut house, 0, South, [3, 1], 3);
    door(&mut house, 0, [7, 1]);
    window(&mut house, 0, South, [9, 1], 3);
    window(&mut house, 0, East, [13, 3], 3);
    window(&mut house, 0, East, [13, 9], 3);
    french_window(&mut house, 0, South, [6, 10], 3);
    french_window(&mut house, 0, West, [10, 6], 3);
    window(&mut house, 0, West, [1, 7], 1);
    house
}

/// Two storeys of 9 x 7 modules with a flat roof and long windows above each other.
pub fn flat() -> House {
    let plan: &[Rect] = &[[1, 1, 9, 7]];
    let mut house = massing([11, 9, 13], &[plan, plan], 0);
    u_stair(&mut house, 0, [4, 5]);
    door(&mut house, 0, [2, 1]);
    french_window(&mut house, 0, South, [4, 1], 5);
    window(&mut house, 1, South, [2, 1], 1);
    window(&mut house, 1, South, [4, 1], 5);
    for storey in 0..2 {
        window(&mut house, storey, East, [9, 3], 3);
    }
    house
}

/// Two storeys under a saddle roof beside a lower part whose roof is a terrace with a door onto it.
pub fn stepped() -> House {
    let upper: Rect = [1, 1, 9, 7];
    let mut house = massing([16, 9, 18], &[&[[1, 1, 14, 7]], &[upper]], 0);
    saddle(&mut house, 12, upper, 0, 4);
    u_stair(&mut house, 0, [4, 5]);
    window(&mut house, 0, South, [2, 1], 2);
    door(&mut house, 0, [5, 1]);
    french_window(&mut house, 0, South, [7, 1], 2);
    french_window(&mut house, 0, South, [10, 1], 4);
    window(&mut house, 0, East, [14, 3], 3);
    window(&mut house, 1, South, [2, 1], 2);
    window(&mut house, 1, South, [5, 1], 1);
    window(&mut house, 1, South, [7, 1], 2);
    window(&mut house, 1, East, [9, 2], 1);
    door(&mut house, 1, [9, 4]);
    window(&mut house, 1, East, [9, 6], 1);
    (0..2).for_each(|storey| window(&mut house, storey, West, [1, 4], 1));
    house
}

/// Three storeys set back one after the other to the south, each with a terrace in front of its living room.
pub fn terrace() -> House {
    let mut house = massing([12, 17, 19], &[&[[1, 1, 10, 15]], &[[1, 5, 10, 11]], &[[1, 9, 10, 7]]], 0);
    u_stair(&mut house, 0, [4, 13]);
    u_stair(&mut house, 1, [4, 10]);
    for (storey, y) in [(0, 1), (1, 5), (2, 9)] {
        door(&mut house, storey, [3, y]);
        french_window(&mut house, storey, South, [5, y], 4);
        window(&mut house, storey, East, [10, y + 3], 2);
        window(&mut house, storey, West, [1, y + 3], 2);
    }
    window(&mut house, 0, East, [10, 8], 2);
    window(&mut house, 0, West, [1, 8], 2);
    (0..2).for_each(|storey| window(&mut house, storey, North, [3, 15], 2));
    house
}
