//! Architectural tiles: the closed solids of every material that stand in a cube, from its key, a style and the shells.

mod arrange;
mod body;
mod border;
mod column;
pub mod edges;
mod field;
mod heights;
pub mod infill;
mod merge;
mod sides;
mod strata;
mod style;

pub use column::{Columns, Half, Post};
pub(in crate::tiles) use column::{border_side, wall_label};
pub use field::component_at;
pub use style::{Railing, SolidStyle};

use super::{Block, Shells};
use crate::cubes::CubeKey;

/// Everything that stands in a cube: disjoint convex blocks, each with its component and the octant it belongs to.
///
/// Blocks of neighbouring cubes meet exactly: the section of each component on a shared face follows from that face's labels and
/// number alone. Any labelling of an admissible configuration gives solids, also one that breaks other rules.
pub fn solids(key: CubeKey, style: &SolidStyle, shells: &Shells) -> Vec<Block> {
    let columns = Columns::new(key, shells);
    let mut blocks = Vec::with_capacity(32);
    body::build(&field::Field::new(&columns, style), &mut blocks);
    infill::build(&columns, style, &mut blocks);
    edges::build(&columns, style, &mut blocks);
    blocks
}

/// The body alone: walls, roofs with their covering, floors, decks and foundation, without what fills openings and stands at edges.
pub fn body(key: CubeKey, style: &SolidStyle, shells: &Shells) -> Vec<Block> {
    let columns = Columns::new(key, shells);
    let mut blocks = Vec::with_capacity(32);
    body::build(&field::Field::new(&columns, style), &mut blocks);
    blocks
}
