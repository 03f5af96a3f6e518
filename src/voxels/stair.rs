//! Stairs: a record beside the labels, because a flight takes part of a voxel only.

use serde::{Deserialize, Serialize};

/// A horizontal direction along the grid.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord, Serialize, Deserialize)]
pub enum Direction {
    /// Towards +x (east).
    #[serde(rename = "+x")]
    East,
    /// Towards +y (north).
    #[serde(rename = "+y")]
    North,
    /// Towards -x (west).
    #[serde(rename = "-x")]
    West,
    /// Towards -y (south).
    #[serde(rename = "-y")]
    South,
}

impl Direction {
    /// All four, counter-clockwise from +x.
    pub const ALL: [Direction; 4] = [Direction::East, Direction::North, Direction::West, Direction::South];

    /// The unit step in plan.
    pub fn step(self) -> [isize; 2] {
        match self {
            Direction::East => [1, 0],
            Direction::North => [0, 1],
            Direction::West => [-1, 0],
            Direction::South => [0, -1],
        }
    }

    /// The direction a quarter turn counter-clockwise.
    pub fn left(self) -> Direction {
        Self::ALL[(self as usize + 1) % 4]
    }

    /// The opposite direction.
    pub fn back(self) -> Direction {
        Self::ALL[(self as usize + 2) % 4]
    }
}

/// The two stairs the modules allow: a module of run climbs a module of height, so a storey takes six.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum StairKind {
    /// One flight of six modules.
    Straight,
    /// Three modules up, a landing two cells wide, three modules back in the lane to the left of the first.
    UTurn,
}

/// A stair from storey `storey` to the one above.
///
/// ```text
/// straight (run = +x)          u-turn (run = +x, second lane to the left, that is +y)
/// f 1 2 3 4 5 6 h              h 6 5 4 L      f foot landing   h head landing
///                              f 1 2 3 L      L landing between the flights
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Stair {
    /// Storey it climbs from, 0 = ground storey.
    pub storey: usize,
    /// Plan cell of the first module of the first flight.
    pub start: [usize; 2],
    /// Direction of the first flight.
    pub run: Direction,
    /// Straight or U.
    pub kind: StairKind,
}

impl Stair {
    fn walk(&self, along: isize, left: isize) -> [isize; 2] {
        let (r, l) = (self.run.step(), self.run.left().step());
        [self.start[0] as isize + along * r[0] + left * l[0], self.start[1] as isize + along * r[1] + left * l[1]]
    }

    /// Plan cells of the flights in climbing order: module n climbs from n to n+1 modules above the floor. Six cells.
    pub fn flight_cells(&self) -> [[isize; 2]; 6] {
        match self.kind {
            StairKind::Straight => [0, 1, 2, 3, 4, 5].map(|a| self.walk(a, 0)),
            StairKind::UTurn => [(0, 0), (1, 0), (2, 0), (2, 1), (1, 1), (0, 1)].map(|(a, l)| self.walk(a, l)),
        }
    }

    /// Cells of the landing between two flights (empty for a straight stair).
    pub fn middle_landing(&self) -> Vec<[isize; 2]> {
        match self.kind {
            StairKind::Straight => Vec::new(),
            StairKind::UTurn => vec![self.walk(3, 0), self.walk(3, 1)],
        }
    }

    /// Cell in front of the first step, on the lower storey.
    pub fn foot(&self) -> [isize; 2] {
        self.walk(-1, 0)
    }

    /// Cell behind the last step, on the upper storey.
    pub fn head(&self) -> [isize; 2] {
        match self.kind {
            StairKind::Straight => self.walk(6, 0),
            StairKind::UTurn => self.walk(-1, 1),
        }
    }

    /// Cells in which the plate above is left out: every flight cell but the first (2.7 m of headroom remain there) and the
    /// middle landing. In a u-turn the first cell lies beside the last and is left out too, so that the void is a rectangle.
    pub fn void_cells(&self) -> Vec<[isize; 2]> {
        let flights = self.flight_cells();
        match self.kind {
            StairKind::Straight => flights[1..].to_vec(),
            StairKind::UTurn => flights.iter().copied().chain(self.middle_landing()).collect(),
        }
    }
}
