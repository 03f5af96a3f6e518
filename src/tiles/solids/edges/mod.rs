//! What stands at edges: eaves and verges with gutters outside of roofs, parapets, trims and railings along decks.

mod deck;
mod eaves;
mod railing;

pub use deck::{EDGE_UM, PARAPET_UM, Rim, deck_depth_um, edge_zone_um, rim};
pub use eaves::{centre_height, mid_height, roof_ends};

use super::super::Block;
use super::{Columns, SolidStyle};

/// How far the solids of an edge may reach sideways from the middle plane that they end at: eaves with gutter, parapets, railings.
pub(super) fn side_reach_um(style: &SolidStyle) -> i32 {
    eaves::reach_um(style).max(PARAPET_UM + deck::NOSE_UM) + deck::NOSE_UM
}

/// Adds everything at the edges of a cube's roofs and decks: disjoint blocks, outside of roofs and within
/// [`edge_zone_um`] of the free edges of decks (copings project beyond both).
pub fn build(columns: &Columns, style: &SolidStyle, blocks: &mut Vec<Block>) {
    for q in 0..4 {
        eaves::build(columns, q, style, blocks);
        deck::build(columns, q, style, blocks);
    }
}
