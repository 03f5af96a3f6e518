//! Roof heights of a cube's columns, as planes over half modules.

use super::column::{Columns, Post};

/// Half a module in plan and in height, µm.
pub(super) const HALF_PLAN_UM: i32 = 450_000;
pub(super) const HALF_RISE_UM: i32 = 270_000;
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

/// The roof heights of a cube in half modules.
#[derive(Clone, Copy, Debug)]
pub(super) struct Heights {
    mids: [[i32; 2]; 4],
    centre: i32,
}

impl Heights {
    /// Reads face numbers; where there are none (rule A), a roof falls to 0 towards the outside and rises to 2 towards a wall.
    pub fn new(columns: &Columns) -> Heights {
        let mid = |q: usize, axis: usize| {
            let default = match columns.post(q ^ (1 << axis)) {
                Post::Roof => return 1,
                Post::Full => 2,
                Post::Deck | Post::Floor | Post::Empty => 0,
            };
            columns.border_face(q, axis).height().unwrap_or(default)
        };
        let mids = [0, 1, 2, 3].map(|q| [mid(q, 0), mid(q, 1)]);
        // Every roof column proposes the planar continuation of its own three points; the median wins, an even split gives 1.
        let mut proposals = [0; 4];
        let mut count = 0;
        for q in (0..4).filter(|&q| columns.post(q) == Post::Roof) {
            proposals[count] = (mids[q][0] + mids[q][1] - 1).clamp(0, 2);
            count += 1;
        }
        let proposals = &mut proposals[..count];
        proposals.sort_unstable();
        let centre = match (proposals.get(count.wrapping_sub(1) / 2), proposals.get(count / 2)) {
            (Some(low), Some(high)) if low == high => *low,
            _ => 1,
        };
        Heights { mids, centre }
    }

    /// The roof plane of column q where b > a (the triangle beside the x-neighbour's border) or a > b.
    pub fn roof(&self, q: usize, beside_x: bool) -> Plane {
        let [x, y] = self.mids[q];
        let slope = if beside_x { [1 - x, x - self.centre] } else { [y - self.centre, 1 - y] };
        Plane { level: HALF_RISE_UM * self.centre, slope }
    }

    /// The height of roof column q along its border towards `axis`, as a plane that does not change across the border.
    pub fn border(&self, q: usize, axis: usize) -> Plane {
        let mut slope = [0; 2];
        slope[1 - axis] = self.mids[q][axis] - self.centre;
        Plane { level: HALF_RISE_UM * self.centre, slope }
    }

    /// Whether the roof of column q folds along the diagonal from its corner to the centre.
    pub fn folds(&self, q: usize) -> bool {
        self.roof(q, true) != self.roof(q, false)
    }
}
