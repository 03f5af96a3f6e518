//! The roofs in a cube as lines: what the frame stands under, from the heights that the drawing uses.

use super::heights::{Defaults, RoofHeights};
use super::solids::Post;
use crate::cubes::CubeKey;

/// How a roof column folds along the line from its corner to the cube's centre.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Fold {
    /// A hip.
    Convex,
    /// A valley.
    Concave,
}

/// The roof columns of a cube with their heights in half modules above the cube's bottom plane (270 mm), 0 to 2. Over a roof
/// column's own corner the height is 1.
///
/// A roof column's surface over its quarter of the plan is the quad corner, middle towards the x-neighbour, centre, middle towards
/// the y-neighbour, folded along corner-centre where [`RoofShape::fold`] says so; the same heights make the surfaces
/// ([`super::construct_key`]) and the solids, so what lies on these lines lies in the drawn roof.
///
/// ```text
/// corner --- mid(q, x) ---        mid(q, axis): half-way from the corner of column q towards its neighbour along the axis,
///    |  \        |                on the vertical cube face that both columns share
/// mid(q, y) - centre ----
/// ```
#[derive(Clone, Copy, Debug)]
pub struct RoofShape {
    posts: [Post; 4],
    heights: RoofHeights,
}

impl RoofShape {
    /// The roofs of a key; `None` when no column is a roof. Faces without a number fall to 0 towards the outside and rise to 2
    /// towards a wall (rule A).
    pub fn new(key: CubeKey) -> Option<RoofShape> {
        let posts = [0, 1, 2, 3].map(|q| Post::of(key.label(q), key.label(q + 4)));
        let heights = || RoofHeights::new(posts, key.faces(), Defaults::SLOPED);
        posts.contains(&Post::Roof).then(|| RoofShape { posts, heights: heights() })
    }

    /// What column q = x + 2y is.
    #[inline]
    pub fn post(&self, q: usize) -> Post {
        self.posts[q]
    }

    /// Height of roof column q half-way to its neighbour along `axis` (0 = x, 1 = y).
    #[inline]
    pub fn mid(&self, q: usize, axis: usize) -> i32 {
        self.heights.mid(q, axis)
    }

    /// Height over the cube's centre.
    #[inline]
    pub fn centre(&self) -> i32 {
        self.heights.centre()
    }

    /// How roof column q folds.
    pub fn fold(&self, q: usize) -> Option<Fold> {
        let over = 1 + self.centre();
        let beside = self.mid(q, 0) + self.mid(q, 1);
        match over.cmp(&beside) {
            std::cmp::Ordering::Equal => None,
            std::cmp::Ordering::Greater => Some(Fold::Convex),
            std::cmp::Ordering::Less => Some(Fold::Concave),
        }
    }

    /// Rise of the roof of column q from its corner into the cube, along x and y, over the half of its quarter that lies beside the
    /// border towards `axis`: half modules of height per half module of plan. Both halves are the same where nothing folds.
    pub fn rise(&self, q: usize, axis: usize) -> [i32; 2] {
        let mut rise = [0; 2];
        rise[axis] = self.mid(q, axis) - 1;
        rise[1 - axis] = self.centre() - self.mid(q, axis);
        rise
    }
}
