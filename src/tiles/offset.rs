//! Surfaces that stand outside the voxels: walls a distance out, roofs and undersides a distance up.
//!
//! In plan, everything within the wall offset of a filled column is filled: below the crossing by the lower layer, above it by the
//! upper one. So the body is a stack of two prisms in every cube. It cannot meet itself while the offset is less than half a module,
//! and the section on a face follows from the columns on that face, because those beyond are further away than the offset.

use super::construct::push;
use super::style::{CUBE_MM, HALF_PLAN_MM, HALF_RISE_MM, Style};
use super::{Facet, PatchKind};

/// The facets of a cube whose columns x + 2y are filled below and above as the bits of `layers` say.
pub(super) fn facets(layers: [u8; 2], style: &Style) -> Vec<Facet> {
    let wall = style.wall_offset_mm.clamp(0, HALF_PLAN_MM - 1);
    let crossing = HALF_RISE_MM + style.roof_offset_mm.clamp(1 - HALF_RISE_MM, HALF_RISE_MM - 1);
    let lines = [0, HALF_PLAN_MM - wall, HALF_PLAN_MM, HALF_PLAN_MM + wall, CUBE_MM[0]];
    let heights = [0, crossing, CUBE_MM[2]];
    let mut facets = Vec::new();
    for x in 0..4 {
        for y in 0..4 {
            let owners = layers.map(|layer| owner(layer, [x, y]));
            let [[x0, x1], [y0, y1]] = [x, y].map(|n| [lines[n], lines[n + 1]]);
            let lid = [[x0, y0, crossing], [x1, y0, crossing], [x1, y1, crossing], [x0, y1, crossing]].to_vec();
            match owners {
                [Some(q), None] => push(&mut facets, PatchKind::Roof, q, lid, [0, 0, 1]),
                [None, Some(q)] => push(&mut facets, PatchKind::Soffit, q + 4, lid, [0, 0, -1]),
                [None, None] | [Some(_), Some(_)] => {}
            }
            for (axis, next) in [[x + 1, y], [x, y + 1]].into_iter().enumerate().filter(|(a, next)| next[*a] < 4) {
                for (n, layer) in layers.into_iter().enumerate() {
                    let (q, side) = match (owners[n], owner(layer, next)) {
                        (Some(q), None) => (q, 1),
                        (None, Some(q)) => (q, -1),
                        (None, None) | (Some(_), Some(_)) => continue,
                    };
                    let ends = if axis == 0 { [[x1, y0], [x1, y1]] } else { [[x0, y1], [x1, y1]] };
                    let [[ax, ay], [bx, by]] = ends;
                    let [low, high] = [heights[n], heights[n + 1]];
                    let mut outward = [0; 3];
                    outward[axis] = side;
                    let polygon = vec![[ax, ay, low], [bx, by, low], [bx, by, high], [ax, ay, high]];
                    push(&mut facets, PatchKind::Wall, q + 4 * n as u8, polygon, outward);
                }
            }
        }
    }
    facets
}

/// Which column of a layer fills a cell of the plan, between lines at the offset and the middle: its own; else the one straight
/// across from it within the offset; at corners, where both or none is, the one across the corner.
fn owner(layer: u8, [x, y]: [usize; 2]) -> Option<u8> {
    let q = (x / 2 + 2 * (y / 2)) as u8;
    let filled = |q: u8| layer >> q & 1 == 1;
    let [near_x, near_y] = [x, y].map(|n| n == 1 || n == 2);
    if filled(q) {
        return Some(q);
    }
    match [near_x && filled(q ^ 1), near_y && filled(q ^ 2)] {
        [true, false] => Some(q ^ 1),
        [false, true] => Some(q ^ 2),
        [true, true] | [false, false] => (near_x && near_y && filled(q ^ 3)).then_some(q ^ 3),
    }
}
