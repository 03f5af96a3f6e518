//! The one rule of roof heights within a cube, in half modules of 270 mm: surfaces, solids, edges and lines all ask here.

use super::solids::{Post, border_side};
use crate::cubes::FaceNumber;

/// Heights of roofs where the face says nothing (rule A).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Defaults {
    /// Half-way to a column that is not filled below, or a deck.
    pub eaves: i32,
    /// Half-way to a full column.
    pub wall_foot: i32,
}

impl Defaults {
    /// Roofs fall to 0 towards the outside and rise to 2 towards a wall.
    pub const SLOPED: Defaults = Defaults { eaves: 0, wall_foot: 2 };
}

/// The height over a cube's centre from the heights of its roof columns half-way to their neighbours along x and y (at most four):
/// each proposes the planar continuation of its own three points; the median wins, an even split gives 1.
pub(crate) fn centre_height(mids: impl Iterator<Item = [i32; 2]>) -> i32 {
    let mut proposals = [0; 4];
    let mut count = 0;
    for ([x, y], proposal) in mids.zip(&mut proposals) {
        *proposal = (x + y - 1).clamp(0, 2);
        count += 1;
    }
    let proposals = &mut proposals[..count];
    proposals.sort_unstable();
    match (proposals.get(count.wrapping_sub(1) / 2), proposals.get(count / 2)) {
        (Some(low), Some(high)) if low == high => *low,
        _ => 1,
    }
}

/// The roof heights of a cube's columns x + 2y, 0 to 2; over a roof voxel's own centre, the column's corner, the height is 1.
#[derive(Clone, Copy, Debug)]
pub(super) struct RoofHeights {
    mids: [[i32; 2]; 4],
    centre: i32,
}

impl RoofHeights {
    /// From what the columns are and the numbers of the faces in the order of [`crate::voxels::Direction::ALL`].
    ///
    /// The height half-way from a roof's corner to the neighbour along an axis is 1 beside another roof, else what the face says on
    /// which that middle lies. For the centre see [`centre_height`].
    pub fn new(posts: [Post; 4], faces: [FaceNumber; 4], defaults: Defaults) -> RoofHeights {
        let mid = |q: usize, axis: usize| {
            let default = match posts[q ^ (1 << axis)] {
                Post::Roof => return 1,
                Post::Full => defaults.wall_foot,
                Post::Deck | Post::Floor | Post::Empty => defaults.eaves,
            };
            faces[border_side(q, axis) as usize].height().unwrap_or(default)
        };
        let mids = [0, 1, 2, 3].map(|q| [mid(q, 0), mid(q, 1)]);
        let centre = centre_height((0..4).filter(|&q| posts[q] == Post::Roof).map(|q| mids[q]));
        RoofHeights { mids, centre }
    }

    /// The height of roof column q half-way to its neighbour along `axis` (0 = x, 1 = y).
    #[inline]
    pub fn mid(&self, q: usize, axis: usize) -> i32 {
        self.mids[q][axis]
    }

    /// The height over the cube's centre.
    #[inline]
    pub fn centre(&self) -> i32 {
        self.centre
    }

    /// Whether the roof of column q folds along the diagonal from its corner to the centre: a hip or a valley.
    #[inline]
    pub fn folds(&self, q: usize) -> bool {
        let [x, y] = self.mids[q];
        1 + self.centre != x + y
    }
}
