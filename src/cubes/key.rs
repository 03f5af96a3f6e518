//! What a tile is looked up by: eight labels, a number on each vertical face (rule B), and which decks are walked on.

use std::fmt;

use super::{Corner, Mask, Symmetry};
use crate::voxels::{Direction, Label};

/// How a roof ends at a vertical cube face on which a roof column stands beside a column that is no roof.
///
/// The eight labels do not know whether the roof goes on in the cube above or below, or stops at a wall or at a free edge; one
/// number per face says it. It belongs to the face, so both cubes at the face read the same one and their seam stays closed.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, PartialOrd, Ord)]
#[repr(u8)]
pub enum FaceNumber {
    /// No roof column beside another column: nothing to say.
    #[default]
    None = 0,
    /// The roof goes on one voxel lower: height 0 at the face's middle.
    StepDown = 1,
    /// The roof goes on one voxel higher: height 2.
    StepUp = 2,
    /// The roof ends here, 0 half modules above the voxel centres: eaves, or the foot of a roof that falls towards a wall.
    End0 = 3,
    /// The roof ends here at 1 half module: a verge, a level edge, or a level roof against a wall.
    End1 = 4,
    /// The roof ends here at 2 half modules: the high edge of a single-sided roof, or a lean-to against its wall.
    End2 = 5,
}

impl FaceNumber {
    /// All in the order of their codes.
    pub const ALL: [FaceNumber; 6] = [
        FaceNumber::None,
        FaceNumber::StepDown,
        FaceNumber::StepUp,
        FaceNumber::End0,
        FaceNumber::End1,
        FaceNumber::End2,
    ];

    /// The number of a code, `None` (the number) for a code above 5.
    pub fn from_code(code: u8) -> FaceNumber {
        Self::ALL.get(code as usize).copied().unwrap_or_default()
    }

    /// A roof that ends at this height in half modules (held to 0..=2).
    pub fn end(height: i32) -> FaceNumber {
        match height {
            ..=0 => FaceNumber::End0,
            1 => FaceNumber::End1,
            2.. => FaceNumber::End2,
        }
    }

    /// Roof height at the middle of the face in half modules; `None` where there is no roof edge.
    pub fn height(self) -> Option<i32> {
        match self {
            FaceNumber::None => None,
            FaceNumber::StepDown | FaceNumber::End0 => Some(0),
            FaceNumber::End1 => Some(1),
            FaceNumber::StepUp | FaceNumber::End2 => Some(2),
        }
    }

    /// Whether the roof goes on in the cube above or below.
    pub fn continues(self) -> bool {
        matches!(self, FaceNumber::StepDown | FaceNumber::StepUp)
    }

    /// Whether the roof stops at this face: at a wall when the other column is full, else at a free edge.
    pub fn ends(self) -> bool {
        matches!(self, FaceNumber::End0 | FaceNumber::End1 | FaceNumber::End2)
    }
}

/// Everything that decides what stands in a cube. Packed: 3 bits a label (corner order), 3 bits a face (order of
/// [`Direction::ALL`]: x high, y high, x low, y low), 1 bit a column x + 2y that says that its deck is walked on.
#[derive(Clone, Copy, Default, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct CubeKey(u64);

impl CubeKey {
    /// The key of eight labels in corner order, four face numbers in the order of [`Direction::ALL`], and walked decks (bit q for
    /// column q = x + 2y). Bits of columns that are no deck are cleared.
    pub fn new(labels: [Label; 8], faces: [FaceNumber; 4], walked: u8) -> CubeKey {
        let mut bits = 0;
        for (n, label) in labels.iter().enumerate() {
            bits |= u64::from(label.code()) << (3 * n);
        }
        for (n, face) in faces.iter().enumerate() {
            bits |= (*face as u64) << (24 + 3 * n);
        }
        let deck = (0..4).filter(|&q| labels[q].is_slab() && !labels[q + 4].is_filled()).fold(0u8, |m, q| m | 1 << q);
        CubeKey(bits | u64::from(walked & deck & 15) << 36)
    }

    /// The key of eight labels alone, as rule A reads them.
    pub fn of_labels(labels: [Label; 8]) -> CubeKey {
        CubeKey::new(labels, [FaceNumber::None; 4], 0)
    }

    /// The key of eight labels packed as 3 bits each, as a scan finds them.
    #[inline]
    pub(super) fn from_labels(bits: u64) -> CubeKey {
        CubeKey(bits)
    }

    /// The same labels with these codes of numbers, 3 bits each in the order of [`Direction::ALL`], on faces that had none.
    #[inline]
    pub(super) fn with_face_codes(self, codes: u64) -> CubeKey {
        CubeKey(self.0 | codes << 24)
    }

    /// The same with these decks walked on, all of which must be decks.
    #[inline]
    pub(super) fn with_walked(self, columns: u8) -> CubeKey {
        CubeKey(self.0 | u64::from(columns) << 36)
    }

    /// The packed number, below 2^40.
    #[inline]
    pub fn bits(self) -> u64 {
        self.0
    }

    /// The label of corner n (0..8).
    #[inline]
    pub fn label(self, corner: usize) -> Label {
        Label::from_code((self.0 >> (3 * corner) & 7) as u8).unwrap_or_default()
    }

    /// The eight labels in corner order.
    pub fn labels(self) -> [Label; 8] {
        std::array::from_fn(|n| self.label(n))
    }

    /// The filled corners.
    pub fn mask(self) -> Mask {
        Mask::of(&self.labels())
    }

    /// The number on the face that lies towards `direction`.
    #[inline]
    pub fn face(self, direction: Direction) -> FaceNumber {
        FaceNumber::from_code((self.0 >> (24 + 3 * direction as u64) & 7) as u8)
    }

    /// The four face numbers in the order of [`Direction::ALL`].
    pub fn faces(self) -> [FaceNumber; 4] {
        Direction::ALL.map(|d| self.face(d))
    }

    /// Whether the deck in column q = x + 2y is walked on.
    #[inline]
    pub fn walked(self, q: usize) -> bool {
        self.0 >> (36 + q) & 1 == 1
    }

    /// The columns whose deck is walked on, bit q = x + 2y.
    pub fn walked_columns(self) -> u8 {
        (self.0 >> 36 & 15) as u8
    }

    /// The key of the cube placed with a symmetry.
    pub fn placed(self, symmetry: Symmetry) -> CubeKey {
        let mut labels = [Label::Empty; 8];
        let mut walked = 0;
        for corner in Corner::all() {
            let to = symmetry.corner(corner).number();
            labels[to as usize] = self.label(corner.number() as usize);
            if corner.number() < 4 && self.walked(corner.number() as usize) {
                walked |= 1 << to;
            }
        }
        let mut faces = [FaceNumber::None; 4];
        for direction in Direction::ALL {
            // The middle of the face in doubled coordinates of a unit cube.
            let [dx, dy] = direction.step();
            let at = symmetry.point([1 + dx as i32, 1 + dy as i32, 0], [2, 2, 2]);
            let to = Direction::ALL.into_iter().find(|d| d.step().map(|s| s as i32) == [at[0] - 1, at[1] - 1]);
            if let Some(to) = to {
                faces[to as usize] = self.face(direction);
            }
        }
        CubeKey::new(labels, faces, walked)
    }
}

impl fmt::Debug for CubeKey {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(self, f)
    }
}

/// Eight digits first corner first, then face codes and walked columns where there are any: `11112222`, `11110000/0304`,
/// `22220000/0000/15`.
impl fmt::Display for CubeKey {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for label in self.labels() {
            write!(f, "{}", label.code())?;
        }
        if self.0 >> 24 != 0 {
            write!(f, "/")?;
            for face in self.faces() {
                write!(f, "{}", face as u8)?;
            }
        }
        if self.walked_columns() != 0 {
            write!(f, "/{}", self.walked_columns())?;
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn packs_and_unpacks() {
        let labels = [1, 2, 0, 3, 0, 0, 5, 4].map(|c| Label::from_code(c).expect("a label"));
        let faces = [FaceNumber::End2, FaceNumber::None, FaceNumber::StepUp, FaceNumber::End0];
        let key = CubeKey::new(labels, faces, 0b1111);
        assert_eq!((key.labels(), key.faces()), (labels, faces));
        assert_eq!(key.walked_columns(), 0b0010, "only columns with a slab below and nothing above are decks");
        assert_eq!(key.to_string(), "12030054/5023/2");
    }

    #[test]
    fn four_quarter_turns_are_the_identity() {
        let labels = [2, 2, 1, 1, 0, 1, 0, 1].map(|c| Label::from_code(c).expect("a label"));
        let key = CubeKey::new(labels, [FaceNumber::End1, FaceNumber::StepUp, FaceNumber::None, FaceNumber::End0], 1);
        let turn = Symmetry { mirror: false, turns: 1 };
        let once = key.placed(turn);
        assert_ne!(once, key);
        assert_eq!(once.face(Direction::North), key.face(Direction::East));
        assert_eq!((0..4).fold(key, |k, _| k.placed(turn)), key);
        let mirror = Symmetry { mirror: true, turns: 0 };
        assert_eq!(key.placed(mirror).face(Direction::West), key.face(Direction::East));
        assert_eq!(key.placed(mirror).placed(mirror), key);
    }
}
