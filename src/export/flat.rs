//! Flat shading: a vertex for each position and face normal, shared by the triangles of one plane.

use glam::DVec3;
use rustc_hash::FxHashMap;

use super::Part;

/// A part as graphics files want it: single precision, one normal a vertex.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct FlatPart {
    /// Positions in m, z up.
    pub positions: Vec<[f32; 3]>,
    /// Unit face normals, parallel to `positions`.
    pub normals: Vec<[f32; 3]>,
    /// The vertex of the part that each comes from.
    pub sources: Vec<u32>,
    /// Three each; triangles whose area vanishes in single precision are left out.
    pub triangles: Vec<[u32; 3]>,
}

/// Splits vertices by face normal. Order: that of first use, so equal parts give equal bytes.
pub fn flatten(part: &Part) -> FlatPart {
    let mut flat = FlatPart::default();
    let mut seen: FxHashMap<([u32; 3], [i32; 3]), u32> = FxHashMap::default();
    for (ends, corners) in part.triangles.iter().filter_map(|&t| Some((t, part.corners(t)?))) {
        let positions = corners.map(single);
        let Some(normal) = face_normal(positions) else { continue };
        let normal = normal.to_array().map(|c| c as f32 + 0.0);
        let triangle = [0, 1, 2].map(|n| {
            let p = positions[n];
            *seen.entry((p.map(f32::to_bits), normal_key(normal))).or_insert_with(|| {
                flat.positions.push(p);
                flat.normals.push(normal);
                flat.sources.push(ends[n]);
                flat.positions.len() as u32 - 1
            })
        });
        flat.triangles.push(triangle);
    }
    flat
}

/// Single precision without negative zero, so that equal places have equal bits.
fn single(p: [f64; 3]) -> [f32; 3] {
    p.map(|c| c as f32 + 0.0)
}

/// Unit normal of a triangle as it will be stored; `None` for a triangle thinner than a micrometre.
fn face_normal(corners: [[f32; 3]; 3]) -> Option<DVec3> {
    let [a, b, c] = corners.map(|p| DVec3::from(p.map(f64::from)));
    let cross = (b - a).cross(c - a);
    let longest = (b - a).length().max((c - b).length()).max((a - c).length());
    (cross.length() > 1e-6 * longest).then(|| cross.normalize())
}

/// Normals within about a thousandth of a radian share a vertex.
pub(super) fn normal_key(normal: [f32; 3]) -> [i32; 3] {
    normal.map(|c| (f64::from(c) * 1024.0).round() as i32)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::export::beam_solid;

    #[test]
    fn a_box_has_four_vertices_a_face() {
        let flat = flatten(&beam_solid([0.0; 3], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0], 1.0, 1.0));
        assert_eq!((flat.positions.len(), flat.triangles.len()), (24, 12));
    }

    #[test]
    fn slivers_are_left_out() {
        let mut part = Part::new("sliver", 0);
        part.polygon(&[[0.0; 3], [1.0, 0.0, 0.0], [0.5, 0.0, 0.0]]);
        assert!(flatten(&part).triangles.is_empty());
    }
}
