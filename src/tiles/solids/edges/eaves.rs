//! Eaves and verges: the strip that a roof reaches over the outside, in the roof's own plane, and its gutter.

use super::super::super::{Block, Component};
use super::super::border::{Border, HALF_UM};
use super::super::{Columns, Post, SolidStyle};
use crate::cubes::FaceNumber;

/// Width of the metal trim of a roof without overhang; a narrower overhang is built as trim.
const TRIM_UM: i32 = 20_000;
/// Thickness of the metal on a level strip.
const LEVEL_COPING_UM: i32 = 30_000;
/// Width of a gutter; depths below the edge of the roof plane of its foot and rim; thickness of its sheets.
const GUTTER_UM: i32 = 110_000;
const GUTTER_Z_UM: [i32; 2] = [100_000, 10_000];
const SHEET_UM: i32 = 5_000;
/// A strip and its gutter stay in the half of the cube they project into, so that two of them cannot meet beyond an inner corner.
const MOST_UM: i32 = HALF_UM - 5_000;

/// Width of the strip, µm: the style's overhang, held so that a gutter fits between it and the next voxel's centre.
fn width_um(style: &SolidStyle) -> i32 {
    let most = if style.gutter { MOST_UM - GUTTER_UM } else { MOST_UM };
    style.overhang_um.clamp(TRIM_UM, most)
}

/// How far eaves reach over the outside with their gutter.
pub(super) fn reach_um(style: &SolidStyle) -> i32 {
    width_um(style) + if style.gutter { GUTTER_UM } else { 0 }
}

/// Whether the roof of column q ends freely at its border along `axis`: the outside lies beyond, and the face says that it stops.
pub fn roof_ends(columns: &Columns, q: usize, axis: usize) -> bool {
    columns.post(q) == Post::Roof && columns.post(q ^ (1 << axis)) == Post::Empty && columns.border_face(q, axis).ends()
}

/// Roof height of column q half-way to its neighbour along `axis`, half modules (TILES.md 2 and 4).
pub fn mid_height(columns: &Columns, q: usize, axis: usize) -> i32 {
    match columns.post(q ^ (1 << axis)) {
        Post::Roof => 1,
        Post::Full => columns.border_face(q, axis).height().unwrap_or(2),
        Post::Deck | Post::Floor | Post::Empty => columns.border_face(q, axis).height().unwrap_or(0),
    }
}

/// The one roof height at the cube's centre, half modules: the median of what the roof columns continue to; an even split gives 1.
pub fn centre_height(columns: &Columns) -> i32 {
    let mut proposals = [0; 4];
    let mut count = 0;
    for q in (0..4).filter(|&q| columns.post(q) == Post::Roof) {
        proposals[count] = (mid_height(columns, q, 0) + mid_height(columns, q, 1) - 1).clamp(0, 2);
        count += 1;
    }
    proposals[..count].sort_unstable();
    match count {
        0 => 1,
        n if proposals[(n - 1) / 2] == proposals[n / 2] => proposals[n / 2],
        _ => 1,
    }
}

/// How a strip ends at the cube's middle plane.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Turn {
    /// Cut off square.
    Square,
    /// Round an outer corner of the roof: mitred with the strip along the column's other border.
    Outer,
    /// Into an inner corner: mitred with the strip of the roof that stands beside the same empty column.
    Inner,
}

/// Adds the strips along the free borders of roof column q.
pub(super) fn build(columns: &Columns, q: usize, style: &SolidStyle, blocks: &mut Vec<Block>) {
    for axis in 0..2 {
        if roof_ends(columns, q, axis) {
            strip(columns, Border { q, axis }, style, blocks);
        }
    }
}

fn strip(columns: &Columns, border: Border, style: &SolidStyle, blocks: &mut Vec<Block>) {
    let (q, axis) = (border.q, border.axis);
    let (mid, centre) = (mid_height(columns, q, axis), centre_height(columns));
    // The plane through the voxel's centre, the middle of the border and the cube's centre, continued outwards; depth is negative there.
    let plane = |[depth, aside]: [i32; 2]| 270_000 * centre + ((mid - centre) * aside - (mid - 1) * depth) / 5 * 3;
    let (turn, other) = if roof_ends(columns, q, 1 - axis) && columns.post(q ^ 3) == Post::Empty {
        (Turn::Outer, columns.border_face(q, 1 - axis))
    } else if roof_ends(columns, q ^ 3, 1 - axis) {
        (Turn::Inner, columns.border_face(q ^ 3, 1 - axis))
    } else {
        (Turn::Square, FaceNumber::None)
    };
    let far = width_um(style);
    let polygon = |out: [i32; 2], end: &dyn Fn(i32) -> i32| {
        let point = |out: i32, aside: i32| [-out, aside];
        [point(out[0], end(out[0])), point(out[1], end(out[1])), point(out[1], HALF_UM), point(out[0], HALF_UM)]
    };
    let mitre = |out: i32| match turn {
        Turn::Square => 0,
        Turn::Outer => -out,
        Turn::Inner => out,
    };
    let mut put = |component: Component, polygon: &[[i32; 2]], above: [i32; 2], level: Option<i32>| {
        let z = |p: [i32; 2]| above.map(|a| plane(level.map_or(p, |out| [-out, p[1]])) + a);
        blocks.extend(border.prism(component, q, polygon, z));
    };
    let whole = polygon([0, far], &mitre);
    if style.overhang_um < TRIM_UM {
        put(Component::Coping, &whole, [-style.fascia_um, LEVEL_COPING_UM], None);
        return;
    }
    put(Component::Fascia, &whole, [-style.fascia_um, 0], None);
    if mid == 1 && centre == 1 {
        put(Component::Coping, &whole, [0, LEVEL_COPING_UM], None);
    } else {
        let mut from = 0;
        for stratum in columns.shells.roof_cover.iter().rev() {
            let to = from + vertical_um(stratum.thickness_um, [mid - centre, mid - 1]);
            put(stratum.component, &whole, [from, to], None);
            from = to;
        }
    }
    if !gutter(style, columns.border_face(q, axis)) {
        return;
    }
    // Beside a strip without gutter this one stops flush with the strip's outer edge, at an outer corner as at an inner one.
    let end = |out: i32| if gutter(style, other) { mitre(out) } else { mitre(far) };
    let [foot, rim] = GUTTER_Z_UM.map(|z| -z);
    let edge = [far, far + SHEET_UM, far + GUTTER_UM - SHEET_UM, far + GUTTER_UM];
    put(Component::Gutter, &polygon([edge[0], edge[3]], &end), [foot, foot + SHEET_UM], Some(far));
    put(Component::Gutter, &polygon([edge[0], edge[1]], &end), [foot + SHEET_UM, rim], Some(far));
    put(Component::Gutter, &polygon([edge[2], edge[3]], &end), [foot + SHEET_UM, rim], Some(far));
}

/// Whether the edge with this number is an eaves that carries a gutter.
fn gutter(style: &SolidStyle, number: FaceNumber) -> bool {
    style.gutter && number == FaceNumber::End0
}

/// Thickness measured vertically of what is `thickness` µm across a plane that rises by these half modules per half module;
/// a multiple of 5 µm, as the roof's own strata are.
fn vertical_um(thickness: i32, rise: [i32; 2]) -> i32 {
    let squares: i32 = rise.iter().map(|r| r * r).sum();
    let secant = (1.0 + 0.36 * f64::from(squares)).sqrt();
    (f64::from(thickness) * secant / 5.0).round() as i32 * 5
}
