//! The symmetries a tile may be placed with: quarter turns about z, and a mirror.

use super::{Corner, Mask};

/// First mirrored in x if `mirror`, then turned counter-clockwise (seen from above) by `turns` quarter turns.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Symmetry {
    /// Mirrored in x before turning.
    pub mirror: bool,
    /// Quarter turns, 0 to 3.
    pub turns: u8,
}

impl Symmetry {
    /// Leaves everything where it is.
    pub const IDENTITY: Symmetry = Symmetry { mirror: false, turns: 0 };

    /// All eight: turns first, then mirrored turns.
    pub fn all() -> impl Iterator<Item = Symmetry> {
        [false, true].into_iter().flat_map(|mirror| (0..4).map(move |turns| Symmetry { mirror, turns }))
    }

    /// Where a point of a cube goes. `size` are the edges of the cube; turning needs a square plan.
    pub fn point(self, [mut x, mut y, z]: [i32; 3], size: [i32; 3]) -> [i32; 3] {
        if self.mirror {
            x = size[0] - x;
        }
        for _ in 0..self.turns % 4 {
            (x, y) = (size[0] - y, x);
        }
        [x, y, z]
    }

    /// Where a corner goes.
    pub fn corner(self, corner: Corner) -> Corner {
        let xyz = self.point(corner.xyz().map(i32::from), [1, 1, 1]);
        Corner::at(xyz.map(|c| c as u8))
    }

    /// Where a set of corners goes.
    pub fn mask(self, mask: Mask) -> Mask {
        Mask(Corner::all().filter(|&c| mask.has(c)).fold(0, |bits, c| bits | 1 << self.corner(c).number()))
    }

    /// Whether the axes x and y are exchanged.
    pub fn swaps_axes(self) -> bool {
        self.turns % 2 == 1
    }
}
