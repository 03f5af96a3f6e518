//! The construction rule: one cube's facets from its eight corners, column by column.
//!
//! Every height on a vertical cube face depends on that face's two columns only, so neighbouring tiles agree on it by
//! construction; `check_tileset` proves it for whatever is loaded.

use super::heights::{Defaults, RoofHeights};
use super::offset;
use super::polygon::{doubled_area, insert_points};
use super::solids::{Half, Post, wall_label};
use super::style::{HALF_PLAN_MM, HALF_RISE_MM, Style};
use super::{Facet, PatchKind};
use crate::cubes::{CubeKey, FaceNumber, Mask};
use crate::voxels::Label;

/// The four columns of a cube (x + 2y) with their heights.
pub(super) struct Columns {
    kinds: [Post; 4],
    heights: RoofHeights,
    undersides: [i32; 4],
    style: Style,
}

impl Columns {
    /// Reads the columns of a mask. Bit q of `flat` says that the bottom voxel of column q is a slab with a level top.
    pub(super) fn new(mask: Mask, flat: u8, style: &Style) -> Columns {
        let kinds = [0, 1, 2, 3].map(|q| match (mask.bottom() >> q & 1 == 1, mask.top() >> q & 1 == 1) {
            (true, true) => Post::Full,
            (true, false) if flat >> q & 1 == 1 => Post::Deck,
            (true, false) => Post::Roof,
            (false, true) => Post::Floor,
            (false, false) => Post::Empty,
        });
        Columns::with_heights(kinds, [FaceNumber::None; 4], [style.underside_mm; 4], style)
    }

    /// Reads the columns of a key.
    fn of_key(key: CubeKey, style: &Style) -> Columns {
        let kinds = [0, 1, 2, 3].map(|q| match Post::of(key.label(q), key.label(q + 4)) {
            Post::Deck if !style.decks => Post::Roof,
            kind => kind,
        });
        let undersides = [0, 1, 2, 3].map(|q| match key.label(q + 4) {
            Label::Foundation => style.ground_underside_mm,
            Label::Empty | Label::Base | Label::Floor | Label::Opening | Label::Window => style.underside_mm,
        });
        Columns::with_heights(kinds, key.faces(), undersides, style)
    }

    fn with_heights(kinds: [Post; 4], faces: [FaceNumber; 4], undersides: [i32; 4], style: &Style) -> Columns {
        let defaults = Defaults { eaves: style.eaves, wall_foot: style.wall_foot };
        Columns { kinds, heights: RoofHeights::new(kinds, faces, defaults), undersides, style: *style }
    }

    pub(super) fn kind(&self, q: usize) -> Post {
        self.kinds[q]
    }

    /// The heights of the roofs.
    pub(super) fn heights(&self) -> &RoofHeights {
        &self.heights
    }

    /// The solid part of a column above the mid towards `axis` and above the centre, as z intervals; empty ones have no height.
    fn section(&self, q: usize, axis: usize) -> [[i32; 2]; 2] {
        let top = 2 * HALF_RISE_MM;
        match self.kinds[q] {
            Post::Full => [[0, top]; 2],
            Post::Roof => [self.heights.mid(q, axis), self.heights.centre()].map(|h| [0, HALF_RISE_MM * h]),
            Post::Floor => [[self.undersides[q], top]; 2],
            Post::Deck | Post::Empty => [[0, 0]; 2],
        }
    }
}

/// Plan position of a column's corner.
pub(super) fn corner_xy(q: usize) -> [i32; 2] {
    [2 * HALF_PLAN_MM * (q as i32 & 1), 2 * HALF_PLAN_MM * (q as i32 >> 1)]
}

/// Plan position half-way from a column's corner to its neighbour along `axis`.
pub(super) fn mid_xy(q: usize, axis: usize) -> [i32; 2] {
    let mut xy = corner_xy(q);
    xy[axis] = HALF_PLAN_MM;
    xy
}

fn at([x, y]: [i32; 2], z: i32) -> [i32; 3] {
    [x, y, z]
}

const CENTRE: [i32; 2] = [HALF_PLAN_MM, HALF_PLAN_MM];

/// All facets of a configuration, oriented from filled to empty, cube-local mm.
///
/// Bit q of `flat` says that the bottom voxel of column q = x + 2y is a slab with a level top (a deck); pass 0 for tilesets that
/// know only filled and empty.
pub fn construct(mask: Mask, flat: u8, style: &Style) -> Vec<Facet> {
    facets(&Columns::new(mask, flat, style))
}

/// A facet with the label that it is built as.
#[derive(Clone, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct KeyFacet {
    /// Where it is and of what kind.
    pub facet: Facet,
    /// The label of its octant, but for the lower half of a wall that stands on a slab: the slab ends at the cube's bottom plane, so
    /// that half is built as the wall above it.
    pub label: Label,
}

/// All facets of a key, oriented from filled to empty, cube-local mm: roofs end at the heights that the faces' numbers give, and as
/// in [`construct`] where a face has none (rule A); slabs with nothing above are decks if the style knows decks.
///
/// Any labelling of an admissible configuration with any numbers has a surface; every height on a face follows from the two columns
/// and the number of that face, so neighbours agree. Facets of a full or empty cube are none.
pub fn construct_key(key: CubeKey, style: &Style) -> Vec<KeyFacet> {
    let columns = Columns::of_key(key, style);
    facets(&columns)
        .into_iter()
        .map(|facet| {
            let (q, upper) = (usize::from(facet.octant & 3), facet.octant >= 4);
            let half = if upper { Half::Upper } else { Half::Lower };
            let label = match facet.kind {
                PatchKind::Wall if columns.kind(q) == Post::Full => wall_label(key.label(q), key.label(q + 4), half),
                PatchKind::Wall | PatchKind::Roof | PatchKind::Soffit | PatchKind::Deck => {
                    key.label(usize::from(facet.octant))
                }
            };
            KeyFacet { facet, label }
        })
        .collect()
}

fn facets(columns: &Columns) -> Vec<Facet> {
    if columns.style.is_offset() {
        let layer = |filled: fn(Post) -> bool| (0..4).fold(0, |bits, q| bits | u8::from(filled(columns.kind(q))) << q);
        let below = layer(|post| matches!(post, Post::Full | Post::Roof | Post::Deck));
        let above = layer(|post| matches!(post, Post::Full | Post::Floor));
        return offset::facets([below, above], &columns.style);
    }
    let mut facets = Vec::new();
    for q in 0..4 {
        lids(columns, q, &mut facets);
        for axis in 0..2 {
            walls(columns, q, axis, &mut facets);
        }
    }
    let points: Vec<[i32; 3]> = facets.iter().flat_map(|f| f.polygon.iter().copied()).collect();
    for facet in &mut facets {
        insert_points(&mut facet.polygon, &points);
    }
    facets
}

/// Roof, deck or underside of one column.
fn lids(columns: &Columns, q: usize, facets: &mut Vec<Facet>) {
    let bottom = q as u8;
    let quad = |z: [i32; 4]| {
        [at(corner_xy(q), z[0]), at(mid_xy(q, 0), z[1]), at(CENTRE, z[2]), at(mid_xy(q, 1), z[3])].to_vec()
    };
    match columns.kind(q) {
        Post::Roof => {
            let heights = columns.heights();
            let quad = quad([1, heights.mid(q, 0), heights.centre(), heights.mid(q, 1)].map(|h| HALF_RISE_MM * h));
            if !heights.folds(q) {
                push(facets, PatchKind::Roof, bottom, quad, [0, 0, 1]);
            } else {
                // Not planar: a hip or a valley runs from the corner to the centre.
                push(facets, PatchKind::Roof, bottom, vec![quad[0], quad[1], quad[2]], [0, 0, 1]);
                push(facets, PatchKind::Roof, bottom, vec![quad[0], quad[2], quad[3]], [0, 0, 1]);
            }
        }
        Post::Deck => push(facets, PatchKind::Deck, bottom, quad([0; 4]), [0, 0, 1]),
        Post::Floor => {
            push(facets, PatchKind::Soffit, bottom + 4, quad([columns.undersides[q]; 4]), [0, 0, -1]);
        }
        Post::Full | Post::Empty => {}
    }
}

/// The part of a column's section towards its neighbour along `axis` that the neighbour does not cover.
fn walls(columns: &Columns, q: usize, axis: usize, facets: &mut Vec<Facet>) {
    let other = q ^ (1 << axis);
    let (own, cover) = (columns.section(q, axis), columns.section(other, axis));
    let mut outward = [0; 3];
    outward[axis] = if q < other { 1 } else { -1 };
    let bottom = q as u8;
    let mut emit = |octant: u8, bounds: [[i32; 2]; 2]| {
        let [[l0, u0], [l1, u1]] = bounds.map(|[l, u]| [l, u.max(l)]);
        let mid = mid_xy(q, axis);
        push(facets, PatchKind::Wall, octant, vec![at(mid, l0), at(CENTRE, l1), at(CENTRE, u1), at(mid, u0)], outward);
    };
    for part in uncovered(own, cover) {
        match columns.kind(q) {
            Post::Full => {
                emit(bottom, part.map(|[l, u]| [l, u.min(HALF_RISE_MM)]));
                emit(bottom + 4, part.map(|[l, u]| [l.max(HALF_RISE_MM), u]));
            }
            Post::Floor => emit(bottom + 4, part),
            Post::Roof | Post::Deck | Post::Empty => emit(bottom, part),
        }
    }
}

/// What of the interval `own` lies below and above `cover`, at both ends of a border.
fn uncovered(own: [[i32; 2]; 2], cover: [[i32; 2]; 2]) -> Vec<[[i32; 2]; 2]> {
    if cover.iter().all(|[l, u]| l >= u) {
        return vec![own];
    }
    let below = [0, 1].map(|e| [own[e][0], own[e][1].min(cover[e][0])]);
    let above = [0, 1].map(|e| [own[e][0].max(cover[e][1]), own[e][1]]);
    vec![below, above]
}

/// Adds a polygon without repeated points, turned so that it faces `outward`; drops it when it has no area.
pub(super) fn push(
    facets: &mut Vec<Facet>,
    kind: PatchKind,
    octant: u8,
    mut polygon: Vec<[i32; 3]>,
    outward: [i64; 3],
) {
    polygon.dedup();
    if polygon.first() == polygon.last() {
        polygon.pop();
    }
    let area = doubled_area(&polygon);
    if area == [0; 3] {
        return;
    }
    if (0..3).map(|a| area[a] * outward[a]).sum::<i64>() < 0 {
        polygon.reverse();
    }
    facets.push(Facet { kind, octant, polygon });
}
