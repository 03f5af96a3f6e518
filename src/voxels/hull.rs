//! A closed mesh from an OBJ file, and whether a point lies inside it.
//!
//! Inside is where the winding number of the surface is more than a half (Jacobson, Kavan and Sorkine-Hornung 2013, "Robust inside-outside
//! segmentation using generalized winding numbers"), the sum of the solid angles of all triangles over 4 pi (van Oosterom and Strackee 1983,
//! equation 8). No ray is cast, so that no edge or corner can be hit by chance. A point on the surface itself may count either way.

use std::collections::BTreeMap;

/// Triangles of a hull at most: each is looked at for every voxel of a plot.
pub const MOST_TRIANGLES: usize = 20_000;
/// Points that lie nearer to each other than this share of the hull's size are one.
const SAME: f64 = 1e-6;

/// Why a mesh is no hull.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum HullError {
    /// Not an OBJ file.
    #[error("{file}: {what}: expected an OBJ file with polygons (`v`, `f`), in metres, z up")]
    Obj {
        /// Name of the source.
        file: String,
        /// What the reader says.
        what: String,
    },
    /// A number that is none.
    #[error("{file}: vertex {vertex} is not finite")]
    Vertex {
        /// Name of the source.
        file: String,
        /// Vertex in the order of the file, from 1, repeated ones counted once.
        vertex: usize,
    },
    /// Nothing in it.
    #[error("{file}: {found} triangles, expected 4 to {MOST_TRIANGLES}: give a closed mesh, thinned out if need be")]
    Count {
        /// Name of the source.
        file: String,
        /// Triangles.
        found: usize,
    },
    /// An edge that not exactly two faces share, in opposite senses.
    #[error(
        "{file}: the mesh is not closed: {edges} of its edges are not shared by two faces that are turned the same way, the first from {from:?} to {to:?}; close the holes, turn the faces outwards and remove inner ones"
    )]
    Open {
        /// Name of the source.
        file: String,
        /// How many edges.
        edges: usize,
        /// Start of the first one.
        from: [f64; 3],
        /// Its end.
        to: [f64; 3],
    },
}

/// A closed mesh.
#[derive(Clone, Debug, PartialEq)]
pub struct Hull {
    triangles: Vec<[[f64; 3]; 3]>,
    /// Lowest and highest corner of its box.
    pub bounds: [[f64; 3]; 2],
}

impl Hull {
    /// Reads an OBJ file; `file` names it in errors. Groups and objects are one mesh; materials are not read.
    ///
    /// # Errors
    /// [`HullError`]: not an OBJ file, a mesh with holes, edges or turned faces, too many triangles.
    pub fn read(bytes: &[u8], file: &str) -> Result<Hull, HullError> {
        let options = tobj::LoadOptions { triangulate: true, ..Default::default() };
        let no_materials = |_: &std::path::Path| Ok(Default::default());
        let loaded = tobj::load_obj_buf(&mut &bytes[..], &options, no_materials);
        let (models, _) = loaded.map_err(|e| HullError::Obj { file: file.into(), what: e.to_string() })?;
        let mut corners = Vec::new();
        for mesh in models.iter().map(|m| &m.mesh) {
            let point = |i: &u32| -> Option<[f64; 3]> {
                let at = *i as usize * 3;
                mesh.positions.get(at..at + 3).map(|p| [0, 1, 2].map(|a| f64::from(p[a])))
            };
            corners.extend(mesh.indices.iter().filter_map(point));
        }
        Hull::from_corners(&corners, file)
    }

    /// From the corners of triangles, three for each.
    ///
    /// # Errors
    /// As [`Hull::read`].
    pub fn from_corners(corners: &[[f64; 3]], file: &str) -> Result<Hull, HullError> {
        if let Some(vertex) = corners.iter().position(|p| !p.iter().all(|v| v.is_finite())) {
            return Err(HullError::Vertex { file: file.into(), vertex: vertex + 1 });
        }
        let edge = |low: bool, a: usize| {
            let pick: fn(f64, f64) -> f64 = if low { f64::min } else { f64::max };
            corners.iter().map(|p| p[a]).reduce(pick).unwrap_or(0.0)
        };
        let bounds = [true, false].map(|low| [0, 1, 2].map(|a| edge(low, a)));
        let size = (0..3).map(|a| bounds[1][a] - bounds[0][a]).fold(0.0, f64::max);
        let grid = |p: &[f64; 3]| p.map(|v| (v / (size * SAME).max(f64::MIN_POSITIVE)).round() as i64);
        // Triangles that a rounding made flat carry no surface.
        let whole = |t: &&[[f64; 3]]| {
            let [a, b, c] = [grid(&t[0]), grid(&t[1]), grid(&t[2])];
            a != b && b != c && c != a
        };
        let triangles: Vec<[[f64; 3]; 3]> = corners.chunks_exact(3).filter(whole).map(|t| [t[0], t[1], t[2]]).collect();
        if !(4..=MOST_TRIANGLES).contains(&triangles.len()) {
            return Err(HullError::Count { file: file.into(), found: triangles.len() });
        }
        // Each edge is walked as often one way as the other; more than once each way where surfaces touch.
        let mut edges: BTreeMap<[[i64; 3]; 2], (i64, Edge)> = BTreeMap::new();
        for t in &triangles {
            for (a, b) in [(t[0], t[1]), (t[1], t[2]), (t[2], t[0])] {
                let (p, q) = (grid(&a), grid(&b));
                let (key, way) = if p < q { ([p, q], 1) } else { ([q, p], -1) };
                edges.entry(key).or_insert((0, [a, b])).0 += way;
            }
        }
        let mut open = edges.values().filter(|e| e.0 != 0);
        if let Some((_, [from, to])) = open.next() {
            return Err(HullError::Open { file: file.into(), edges: 1 + open.count(), from: *from, to: *to });
        }
        Ok(Hull { triangles, bounds })
    }

    /// How often the surface winds around a point: about 0 outside, 1 inside, -1 inside a mesh whose faces look inwards.
    pub fn winding(&self, point: [f64; 3]) -> f64 {
        let angle: f64 = self.triangles.iter().map(|t| solid_angle(t, point)).sum();
        angle / (4.0 * std::f64::consts::PI)
    }

    /// Whether a point lies inside, whichever way the faces look.
    pub fn contains(&self, point: [f64; 3]) -> bool {
        let [low, high] = &self.bounds;
        (0..3).all(|a| (low[a]..=high[a]).contains(&point[a])) && self.winding(point).abs() > 0.5
    }

    /// Enclosed volume, cubic units of the file.
    pub fn volume(&self) -> f64 {
        let six: f64 = self.triangles.iter().map(|[a, b, c]| dot(a, &cross(b, c))).sum();
        (six / 6.0).abs()
    }
}

/// Start and end of an edge.
type Edge = [[f64; 3]; 2];

/// Signed solid angle of a triangle seen from a point.
fn solid_angle(triangle: &[[f64; 3]; 3], p: [f64; 3]) -> f64 {
    let [a, b, c] = triangle.map(|v| [0, 1, 2].map(|i| v[i] - p[i]));
    let [la, lb, lc] = [&a, &b, &c].map(|v| dot(v, v).sqrt());
    let over = dot(&a, &cross(&b, &c));
    let under = la * lb * lc + dot(&a, &b) * lc + dot(&b, &c) * la + dot(&c, &a) * lb;
    2.0 * over.atan2(under)
}

fn dot(a: &[f64; 3], b: &[f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn cross(a: &[f64; 3], b: &[f64; 3]) -> [f64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

#[cfg(test)]
mod tests {
    use super::*;

    /// An L of two cubes beside and one on top, as an OBJ with quads.
    const L: &str = "v 0 0 0\nv 2 0 0\nv 2 2 0\nv 1 2 0\nv 1 1 0\nv 0 1 0\nv 0 0 3\nv 2 0 3\nv 2 2 3\nv 1 2 3\nv 1 1 3\nv 0 1 3\n\
        f 1 6 5\nf 1 5 2\nf 5 4 3\nf 5 3 2\nf 7 11 12\nf 7 8 11\nf 11 9 10\nf 11 8 9\n\
        f 1 2 8 7\nf 2 3 9 8\nf 3 4 10 9\nf 4 5 11 10\nf 5 6 12 11\nf 6 1 7 12\n";

    #[test]
    fn inside_is_where_the_surface_winds_around() {
        let hull = Hull::read(L.as_bytes(), "l.obj").expect("a closed mesh");
        assert!((hull.volume() - 9.0).abs() < 1e-9, "{}", hull.volume());
        // Every point of a grid that avoids the surface, against the two boxes that the L is made of.
        let mut inside = 0;
        for n in 0..30 * 30 * 40 {
            let p = [n % 30, n / 30 % 30, n / 900].map(|i| f64::from(i) / 10.0 - 0.45);
            let boxed = |x: [f64; 2], y: [f64; 2]| p[0] > x[0] && p[0] < x[1] && p[1] > y[0] && p[1] < y[1];
            let expected = p[2] > 0.0 && p[2] < 3.0 && (boxed([0.0, 2.0], [0.0, 1.0]) || boxed([1.0, 2.0], [0.0, 2.0]));
            assert_eq!(hull.contains(p), expected, "{p:?}");
            assert!((hull.winding(p) - f64::from(u8::from(expected))).abs() < 1e-9, "{p:?}: {}", hull.winding(p));
            inside += usize::from(expected);
        }
        assert_eq!(inside, 3 * 100 * 30);
    }

    #[test]
    fn an_open_or_turned_mesh_says_where() {
        let without = L.replace("f 4 5 11 10\n", "");
        let error = Hull::read(without.as_bytes(), "l.obj").expect_err("a hole").to_string();
        assert!(error.contains("4 of its edges") && error.contains("not closed") && error.contains("l.obj"), "{error}");
        let turned = L.replace("f 4 5 11 10\n", "f 10 11 5 4\n");
        assert!(matches!(Hull::read(turned.as_bytes(), "l.obj"), Err(HullError::Open { edges: 4, .. })));
        // All of them turned is as good: only the sign differs.
        let back: String = L
            .lines()
            .map(|line| match line.strip_prefix("f ") {
                Some(rest) => format!("f {}\n", rest.split(' ').rev().collect::<Vec<_>>().join(" ")),
                None => format!("{line}\n"),
            })
            .collect();
        let hull = Hull::read(back.as_bytes(), "l.obj").expect("a closed mesh");
        assert!(hull.contains([1.5, 1.5, 1.0]) && !hull.contains([0.5, 1.5, 1.0]));
        assert!(matches!(Hull::read(b"v 0 0\nf 1 2 3", "x.obj"), Err(HullError::Obj { .. })));
        assert!(matches!(Hull::read(b"", "x.obj"), Err(HullError::Count { found: 0, .. })));
    }
}
