//! Free edges of decks: parapets and trims of level roofs that are not walked on, edge boards of those that are.

use super::super::super::{Block, Component, depth_um};
use super::super::border::{Border, HALF_UM};
use super::super::{Columns, Post, SolidStyle};
use super::{eaves, railing};
use crate::voxels::Label;

/// Width of a parapet from the facade inwards.
pub const PARAPET_UM: i32 = 200_000;
/// Width of the board or trim along the edge of a deck without parapet.
pub const EDGE_UM: i32 = 50_000;
/// How far copings project.
pub(super) const NOSE_UM: i32 = 20_000;
/// Thickness of copings.
const COPING_UM: i32 = 20_000;
/// Thinnest and thickest cladding of a parapet.
const CLADDING_UM: [i32; 2] = [5_000, 60_000];

/// Where the outside lies, as a deck column sees it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Rim {
    /// No free edge.
    None,
    /// Beyond the border along this axis.
    Straight(usize),
    /// Beyond both borders.
    Convex,
    /// Only diagonally across the cube's centre.
    Concave,
}

/// The free edge of column q: a deck (not a paved foundation) beside an empty column.
pub fn rim(columns: &Columns, q: usize) -> Rim {
    if columns.post(q) != Post::Deck || columns.below(q) == Label::Foundation {
        return Rim::None;
    }
    let free = |other: usize| columns.post(other) == Post::Empty;
    match (free(q ^ 1), free(q ^ 2)) {
        (true, true) => Rim::Convex,
        (true, false) => Rim::Straight(0),
        (false, true) => Rim::Straight(1),
        (false, false) if free(q ^ 3) => Rim::Concave,
        (false, false) => Rim::None,
    }
}

/// Thickness of what lies on the slab in a deck column, µm above z = 0; 0 on paved foundations and in other columns.
pub fn deck_depth_um(columns: &Columns, q: usize) -> i32 {
    if columns.post(q) != Post::Deck || columns.below(q) == Label::Foundation {
        0
    } else if columns.key.walked(q) {
        depth_um(&columns.shells.deck)
    } else {
        depth_um(&columns.shells.flat)
    }
}

/// Width of the zone along the free edge of a deck column that is built here: the deck's own strata fill the rest of the column.
///
/// Measured as the larger of the distances along x and y (Chebyshev) to the empty columns of the cube that share a side or the
/// centre with the deck; [`rim`] says where they are. 0 where nothing is built here.
pub fn edge_zone_um(columns: &Columns, q: usize, style: &SolidStyle) -> i32 {
    match rim(columns, q) {
        Rim::None => 0,
        Rim::Straight(_) | Rim::Convex | Rim::Concave if has_parapet(columns, q, style) => PARAPET_UM,
        Rim::Straight(_) | Rim::Convex | Rim::Concave => EDGE_UM,
    }
}

fn has_parapet(columns: &Columns, q: usize, style: &SolidStyle) -> bool {
    !columns.key.walked(q) && style.parapet_um > 0
}

/// The part of column q between two distances from the outside, in convex pieces.
pub(super) fn ring(q: usize, rim: Rim, [near, far]: [i32; 2]) -> Vec<(Border, Vec<[i32; 2]>)> {
    let both =
        |points: &dyn Fn(usize) -> Vec<[i32; 2]>| (0..2).map(|axis| (Border { q, axis }, points(axis))).collect();
    match rim {
        Rim::None => Vec::new(),
        Rim::Straight(axis) => {
            vec![(Border { q, axis }, vec![[near, 0], [far, 0], [far, HALF_UM], [near, HALF_UM]])]
        }
        Rim::Convex => both(&|_| vec![[near, near], [far, far], [far, HALF_UM], [near, HALF_UM]]),
        Rim::Concave => both(&|_| vec![[near, 0], [far, 0], [far, far], [near, near]]),
    }
}

/// Adds a ring between two heights.
pub(super) fn put(q: usize, rim: Rim, component: Component, depth: [i32; 2], z: [i32; 2], blocks: &mut Vec<Block>) {
    if depth[0] < depth[1] {
        for (border, polygon) in ring(q, rim, depth) {
            blocks.extend(border.prism(component, q, &polygon, |_| z));
        }
    }
}

/// Adds what stands at the free edge of column q, if it has one.
pub(super) fn build(columns: &Columns, q: usize, style: &SolidStyle, blocks: &mut Vec<Block>) {
    let rim = rim(columns, q);
    if rim == Rim::None {
        return;
    }
    let surface = deck_depth_um(columns, q);
    if has_parapet(columns, q, style) {
        let skin = columns.shells.wall.first().map_or(0, |s| s.thickness_um).clamp(CLADDING_UM[0], CLADDING_UM[1]);
        let head = surface + style.parapet_um;
        put(q, rim, Component::Cladding, [0, skin], [0, head], blocks);
        put(q, rim, Component::FlatInsulation, [skin, PARAPET_UM], [0, surface], blocks);
        put(q, rim, Component::WallInsulation, [skin, PARAPET_UM - skin], [surface, head], blocks);
        put(q, rim, Component::Cladding, [PARAPET_UM - skin, PARAPET_UM], [surface, head], blocks);
        put(q, rim, Component::Coping, [0, PARAPET_UM + NOSE_UM], [head, head + COPING_UM], blocks);
        nose(columns, q, rim, [head, head + COPING_UM], style, blocks);
    } else {
        put(q, rim, Component::Fascia, [0, EDGE_UM], [0, surface], blocks);
        if columns.key.walked(q) {
            railing::build(q, rim, surface, style, blocks);
        } else {
            put(q, rim, Component::Coping, [0, EDGE_UM], [surface, surface + COPING_UM], blocks);
            nose(columns, q, rim, [surface, surface + COPING_UM], style, blocks);
        }
    }
}

/// The part of a coping that projects beyond the facade. Where another edge arrives from the side it is mitred or kept clear of it.
fn nose(columns: &Columns, q: usize, rim: Rim, z: [i32; 2], style: &SolidStyle, blocks: &mut Vec<Block>) {
    let pieces = match rim {
        // The outside touches a concave corner in one line only: the columns beside it carry the projection.
        Rim::None | Rim::Concave => Vec::new(),
        Rim::Convex => ring(q, rim, [-NOSE_UM, 0]),
        Rim::Straight(axis) => {
            let border = Border { q, axis };
            let [outer, inner] = match columns.post(q ^ 3) {
                Post::Deck => [NOSE_UM, 0],
                Post::Roof if eaves::roof_ends(columns, q ^ 3, 1 - axis) => [eaves::reach_um(style); 2],
                Post::Full | Post::Roof | Post::Floor | Post::Empty => [0; 2],
            };
            vec![(border, vec![[-NOSE_UM, outer], [0, inner], [0, HALF_UM], [-NOSE_UM, HALF_UM]])]
        }
    };
    for (border, polygon) in pieces {
        blocks.extend(border.prism(Component::Coping, q, &polygon, |_| z));
    }
}
