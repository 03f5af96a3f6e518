//! Eaves and verges: the strip that a roof reaches over the outside, in the roof's own plane, and its gutter.

use super::super::super::{Block, Component};
use super::super::border::{Border, HALF_UM};
use super::super::heights::Heights;
use super::super::strata::Strata;
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
    let roof = Heights::new(columns).roof(q, axis == 0);
    // The roof's plane beside the border, continued outwards, where depth is negative.
    let plane = |[depth, aside]: [i32; 2]| roof.at(if axis == 0 { [depth, aside] } else { [aside, depth] });
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
    if roof.is_level() {
        put(Component::Coping, &whole, [0, LEVEL_COPING_UM], None);
    } else {
        let mut from = 0;
        for (component, to) in Strata::new(columns.shells).cover {
            put(component, &whole, [from, to], None);
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

/// A strip as it is counted.
pub(super) struct StripTerms {
    /// m2 of the roof's plane; none where metal covers the strip.
    pub overhang_m2: f64,
    /// Length of its gutter, m.
    pub gutter_m: f64,
    /// Whether metal covers it.
    pub is_trim: bool,
}

/// What the strip along one free border holds, measured on its solids.
pub(super) fn strip_terms(columns: &Columns, border: Border, style: &SolidStyle) -> StripTerms {
    let mut blocks = Vec::new();
    strip(columns, border, style, &mut blocks);
    let is_trim = blocks.iter().any(|b| b.component == Component::Coping);
    let of = |component: Component| blocks.iter().filter(move |b| b.component == component);
    let overhang_m2 = if is_trim { 0.0 } else { of(Component::Fascia).map(Block::top_area_m2).sum() };
    let gutter_m = of(Component::Gutter).next().map_or(0.0, Block::top_area_m2) / (f64::from(GUTTER_UM) * 1e-6);
    StripTerms { overhang_m2, gutter_m, is_trim }
}

/// Whether the edge with this number is an eaves that carries a gutter.
fn gutter(style: &SolidStyle, number: FaceNumber) -> bool {
    style.gutter && number == FaceNumber::End0
}
