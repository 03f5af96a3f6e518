//! Corners of a cube and sets of corners.

use crate::voxels::is_admissible;

/// One of the three lattice axes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
#[repr(usize)]
pub enum Axis {
    /// East.
    X = 0,
    /// North.
    Y = 1,
    /// Up.
    Z = 2,
}

impl Axis {
    /// The three axes in order.
    pub const ALL: [Axis; 3] = [Axis::X, Axis::Y, Axis::Z];

    /// Lower-case letter.
    pub fn name(self) -> &'static str {
        match self {
            Axis::X => "x",
            Axis::Y => "y",
            Axis::Z => "z",
        }
    }
}

/// A corner of a cube, which is a voxel centre: number x + 2y + 4z.
///
/// ```text
///     6 ------- 7
///    /|        /|      z
///   4 ------- 5 |      |  y
///   | |       | |      | /
///   | 2 ------|-3      |/
///   |/        |/       +---- x
///   0 ------- 1
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Corner(u8);

impl Corner {
    /// The corner at x, y, z in {0, 1}; only the lowest bit of each counts.
    #[inline]
    pub const fn at(xyz: [u8; 3]) -> Corner {
        Corner((xyz[0] & 1) | (xyz[1] & 1) << 1 | (xyz[2] & 1) << 2)
    }

    /// The corner of a number; `None` above 7.
    #[inline]
    pub const fn new(number: u8) -> Option<Corner> {
        if number < 8 { Some(Corner(number)) } else { None }
    }

    /// All eight in order.
    pub fn all() -> impl Iterator<Item = Corner> {
        (0..8).map(Corner)
    }

    /// The number, 0 to 7.
    #[inline]
    pub const fn number(self) -> u8 {
        self.0
    }

    /// Coordinates in {0, 1}.
    #[inline]
    pub const fn xyz(self) -> [u8; 3] {
        [self.0 & 1, self.0 >> 1 & 1, self.0 >> 2]
    }

    /// The corner at the other end of the cube edge along `axis`.
    #[inline]
    pub const fn across(self, axis: Axis) -> Corner {
        Corner(self.0 ^ 1 << axis as u8)
    }
}

/// The filled corners of a cube: bit j is corner j. This is also topoGenesis's cube id.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Mask(pub u8);

impl Mask {
    /// No corner filled.
    pub const EMPTY: Mask = Mask(0);
    /// All corners filled.
    pub const FULL: Mask = Mask(255);

    /// All 256 masks.
    pub fn all() -> impl Iterator<Item = Mask> {
        (0..=255).map(Mask)
    }

    /// Whether a corner is filled.
    #[inline]
    pub const fn has(self, corner: Corner) -> bool {
        self.0 >> corner.0 & 1 == 1
    }

    /// The mask that fills what this one leaves empty.
    #[inline]
    pub const fn complement(self) -> Mask {
        Mask(!self.0)
    }

    /// Filled corners at z = 0 as four bits, x + 2y.
    #[inline]
    pub const fn bottom(self) -> u8 {
        self.0 & 15
    }

    /// Filled corners at z = 1 as four bits, x + 2y.
    #[inline]
    pub const fn top(self) -> u8 {
        self.0 >> 4
    }

    /// The four corners on one face as bits, in corner order; `high` is the face at coordinate 1. Two cubes may meet along
    /// `axis` exactly when the high face of the first equals the low face of the second.
    pub const fn face(self, axis: Axis, high: bool) -> u8 {
        let shifted = if high { self.0 >> (1 << axis as u8) } else { self.0 };
        match axis {
            Axis::X => shifted & 1 | (shifted >> 2 & 1) << 1 | (shifted >> 4 & 1) << 2 | (shifted >> 6 & 1) << 3,
            Axis::Y => shifted & 3 | (shifted >> 4 & 3) << 2,
            Axis::Z => shifted & 15,
        }
    }

    /// Whether a tile exists for it: filled *and* empty corners are each connected through cube edges. True for exactly 126
    /// masks (the thesis's number); all-empty and all-filled, which need no tile, are not among them.
    #[inline]
    pub const fn is_admissible(self) -> bool {
        self.0 != 0 && self.0 != 255 && is_admissible(self.0)
    }

    /// Whether a cube may look like this in a house: admissible, empty or full.
    #[inline]
    pub const fn is_allowed(self) -> bool {
        is_admissible(self.0)
    }

    /// The eight digits of the corners, first corner first, as written in tileset manifests.
    pub fn pattern(self) -> String {
        Corner::all().map(|c| if self.has(c) { '1' } else { '0' }).collect()
    }
}

impl std::fmt::Display for Mask {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{} ({})", self.0, self.pattern())
    }
}
