//! Roof heights of a cube's columns as planes over quadrants of its plan, µm.

use super::super::heights::{Defaults, RoofHeights};
use super::super::style::{HALF_PLAN_MM, HALF_RISE_MM};
use super::column::Columns;

/// Half a module in plan and in height, µm.
pub(super) const HALF_PLAN_UM: i32 = 1000 * HALF_PLAN_MM;
pub(super) const HALF_RISE_UM: i32 = 1000 * HALF_RISE_MM;
/// Height of a cube, µm.
pub(super) const RISE_UM: i32 = 2 * HALF_RISE_UM;

/// A plane over one quadrant of the plan, z = level + 3/5 (slope[0] a + slope[1] b): a and b are the distances to the middle planes
/// x = 450 mm and y = 450 mm, and a slope of 1 is the roof's half module of height per half module of plan.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Plane {
    /// Height over the cube's centre, µm.
    pub level: i32,
    /// Rise along a and b.
    pub slope: [i32; 2],
}

impl Plane {
    /// A level plane.
    pub fn level(level: i32) -> Plane {
        Plane { level, slope: [0; 2] }
    }

    /// The same plane, moved down.
    pub fn lowered(self, by: i32) -> Plane {
        Plane { level: self.level - by, ..self }
    }

    pub fn is_level(self) -> bool {
        self.slope == [0; 2]
    }

    /// Five times the height over a point, exact.
    pub fn five_times(self, [a, b]: [i32; 2]) -> i64 {
        5 * i64::from(self.level)
            + 3 * (i64::from(self.slope[0]) * i64::from(a) + i64::from(self.slope[1]) * i64::from(b))
    }

    /// The height over a point, µm; exact for points on multiples of 5 µm.
    pub fn at(self, point: [i32; 2]) -> i32 {
        self.five_times(point).div_euclid(5) as i32
    }
}

/// The roof planes of a cube's columns.
#[derive(Clone, Copy, Debug)]
pub(super) struct Heights(RoofHeights);

impl Heights {
    /// Reads face numbers; where there are none (rule A), a roof falls to 0 towards the outside and rises to 2 towards a wall.
    pub fn new(columns: &Columns) -> Heights {
        Heights(RoofHeights::new(columns.posts(), columns.key.faces(), Defaults::SLOPED))
    }

    /// The roof plane of column q where b > a (the triangle beside the x-neighbour's border) or a > b.
    pub fn roof(&self, q: usize, beside_x: bool) -> Plane {
        let [x, y, centre] = [self.0.mid(q, 0), self.0.mid(q, 1), self.0.centre()];
        let slope = if beside_x { [1 - x, x - centre] } else { [y - centre, 1 - y] };
        Plane { level: HALF_RISE_UM * centre, slope }
    }

    /// The height of roof column q along its border towards `axis`, as a plane that does not change across the border.
    pub fn border(&self, q: usize, axis: usize) -> Plane {
        let mut slope = [0; 2];
        slope[1 - axis] = self.0.mid(q, axis) - self.0.centre();
        Plane { level: HALF_RISE_UM * self.0.centre(), slope }
    }

    /// Whether the roof of column q folds along the diagonal from its corner to the centre.
    pub fn folds(&self, q: usize) -> bool {
        self.0.folds(q)
    }
}
