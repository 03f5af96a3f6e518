//! The four columns of a cube as the solids read them. Every part of the construction asks here, so that walls, openings and
//! edges agree on what stands where.

use super::super::{Shells, depth_um};
use crate::cubes::{CubeKey, FaceNumber};
use crate::voxels::{Direction, Label};

/// What a column of two corners is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Post {
    /// Filled below and above.
    Full,
    /// Filled below only, no slab: a roof on top.
    Roof,
    /// Filled below only, with a slab: the slab lies in the cube below, its top is this cube's bottom plane.
    Deck,
    /// Filled above only: an underside.
    Floor,
    /// Not filled.
    Empty,
}

impl Post {
    /// The column of a label below and one above.
    pub fn of(below: Label, above: Label) -> Post {
        match (below, above) {
            (Label::Empty, Label::Empty) => Post::Empty,
            (Label::Empty, _) => Post::Floor,
            (b, Label::Empty) if b.is_slab() => Post::Deck,
            (_, Label::Empty) => Post::Roof,
            _ => Post::Full,
        }
    }
}

/// Lower or upper half of a cube: 0 to 270 mm belongs to the bottom octant, 270 to 540 mm to the top octant.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Half {
    /// 0 to 270 mm.
    Lower,
    /// 270 to 540 mm.
    Upper,
}

/// A cube's columns, numbered x + 2y.
#[derive(Clone, Debug)]
pub struct Columns<'a> {
    /// The key it was read from.
    pub key: CubeKey,
    /// The strata.
    pub shells: &'a Shells,
    posts: [Post; 4],
}

impl<'a> Columns<'a> {
    /// Reads a key.
    pub fn new(key: CubeKey, shells: &'a Shells) -> Columns<'a> {
        let posts = [0, 1, 2, 3].map(|q| Post::of(key.label(q), key.label(q + 4)));
        Columns { key, shells, posts }
    }

    /// What column q is.
    pub fn post(&self, q: usize) -> Post {
        self.posts[q]
    }

    /// What all four are.
    pub(super) fn posts(&self) -> [Post; 4] {
        self.posts
    }

    /// Label below in column q.
    pub fn below(&self, q: usize) -> Label {
        self.key.label(q)
    }

    /// Label above in column q.
    pub fn above(&self, q: usize) -> Label {
        self.key.label(q + 4)
    }

    /// The face number on the border between column q and its neighbour along `axis` (0 = x, 1 = y): the middle of that border lies
    /// on the cube face across the *other* axis, on the side of q.
    pub fn border_face(&self, q: usize, axis: usize) -> FaceNumber {
        self.key.face(border_side(q, axis))
    }

    /// Height of the underside of a column of kind [`Post::Floor`], µm above the cube's bottom plane.
    pub fn underside_um(&self, q: usize) -> i32 {
        let depth = match self.above(q) {
            Label::Foundation => depth_um(&self.shells.ground),
            _ => depth_um(&self.shells.floor) + depth_um(&self.shells.soffit),
        };
        540_000 - depth
    }

    /// The label that the wall of a full column is built as, half by half: a wall on a slab begins at the slab's top, which is the
    /// cube's bottom plane, so the lower half takes the label above.
    pub fn wall_label(&self, q: usize, half: Half) -> Label {
        wall_label(self.below(q), self.above(q), half)
    }

    /// Whether the half of column q that faces its neighbour along `axis` is a window or door: the column is full, the neighbour is
    /// empty over the whole half (no roof, soffit or deck strata in front), and the column shows only this one wall (at a corner of
    /// the house it stays a wall). Returns [`Label::Window`] or [`Label::Opening`].
    ///
    /// In front of a deck the lower half stays wall: the upstand behind the deck's insulation.
    pub fn infill(&self, q: usize, axis: usize, half: Half) -> Option<Label> {
        let label = self.wall_label(q, half);
        if !label.is_infill() || self.post(q) != Post::Full || self.post(q ^ (2 >> axis)) != Post::Full {
            return None;
        }
        let free = match self.post(q ^ (1 << axis)) {
            Post::Empty => true,
            Post::Deck => half == Half::Upper,
            Post::Full | Post::Roof | Post::Floor => false,
        };
        free.then_some(label)
    }
}

/// Where the face lies that holds the middle of the border between column q and its neighbour along `axis` (0 = x, 1 = y).
pub(in crate::tiles) fn border_side(q: usize, axis: usize) -> Direction {
    match (axis, q & 1, q & 2) {
        (0, _, 0) => Direction::South,
        (0, _, _) => Direction::North,
        (_, 0, _) => Direction::West,
        (_, _, _) => Direction::East,
    }
}

/// The label that half of a full column's wall is built as, from the column's labels.
pub(in crate::tiles) fn wall_label(below: Label, above: Label, half: Half) -> Label {
    match half {
        Half::Lower if below.is_slab() && !above.is_slab() => above,
        Half::Lower => below,
        Half::Upper => above,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn borders_name_the_face_their_middle_lies_on() {
        let shells = Shells {
            wall: vec![],
            roof_cover: vec![],
            roof: vec![],
            flat: vec![],
            deck: vec![],
            floor: vec![],
            soffit: vec![],
            ground: vec![],
            plinth: vec![],
            beam_um: [0; 2],
        };
        let faces = [FaceNumber::End0, FaceNumber::End1, FaceNumber::End2, FaceNumber::StepUp]; // east, north, west, south
        let columns = Columns::new(CubeKey::new([Label::Base; 8], faces, 0), &shells);
        assert_eq!(columns.border_face(0, 0), FaceNumber::StepUp, "columns 0 and 1 meet on the south face");
        assert_eq!(columns.border_face(3, 0), FaceNumber::End1, "columns 2 and 3 on the north face");
        assert_eq!(columns.border_face(0, 1), FaceNumber::End2, "columns 0 and 2 on the west face");
        assert_eq!(columns.border_face(3, 1), FaceNumber::End0, "columns 1 and 3 on the east face");
    }
}
