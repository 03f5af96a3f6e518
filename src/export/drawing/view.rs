//! Where a drawing is looked at from: which axes run right, up and towards the reader.

use crate::voxels::Direction;

/// An axis of the house with its sign.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Axis {
    /// 0 = x, 1 = y, 2 = z.
    pub of: usize,
    /// 1 or -1.
    pub sign: f64,
}

/// A parallel view along an axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct View {
    /// Right on the sheet, up on the sheet, towards the reader.
    pub axes: [Axis; 3],
}

impl View {
    /// Straight down, north up.
    pub fn plan() -> View {
        View { axes: [0, 1, 2].map(|of| Axis { of, sign: 1.0 }) }
    }

    /// The side of the house that faces `side`, as somebody in front of it sees it.
    pub fn facing(side: Direction) -> View {
        let [dx, dy] = side.step().map(|s| s as f64);
        // Who looks against (dx, dy) has (-dy, dx) on the right.
        let (right, depth) = match dx == 0.0 {
            true => (Axis { of: 0, sign: -dy }, Axis { of: 1, sign: dy }),
            false => (Axis { of: 1, sign: dx }, Axis { of: 0, sign: dx }),
        };
        View { axes: [right, Axis { of: 2, sign: 1.0 }, depth] }
    }

    /// A point of the house as [right, up, towards the reader], m.
    pub fn see(&self, p: [f64; 3]) -> [f64; 3] {
        self.axes.map(|a| a.sign * p[a.of])
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn east_is_on_the_right_of_the_south_side_and_north_on_that_of_the_east_side() {
        let p = [1.0, 2.0, 3.0];
        let seen = Direction::ALL.map(|side| View::facing(side).see(p));
        assert_eq!(seen, [[2.0, 3.0, 1.0], [-1.0, 3.0, 2.0], [-2.0, 3.0, -1.0], [1.0, 3.0, -2.0]]);
        assert_eq!(View::plan().see(p), p);
    }
}
