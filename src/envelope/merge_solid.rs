//! A closed polyhedral surface in whole micrometres.

use rustc_hash::FxHashMap;

use super::merge_lines::{PlaneKey, Point, cross, primitive, sub};
use super::triangulate::triangulate;

/// A plane face with its outline, holes and triangles; all indices name vertices of its [`Solid`].
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Face {
    /// Shortest whole vector along the outward normal.
    pub normal: [i64; 3],
    /// What it was added as, see [`super::Merge::set_tag`].
    pub tag: u32,
    /// Counter-clockwise seen from outside. May visit a vertex twice where the face is pinched.
    pub outer: Vec<u32>,
    /// Clockwise seen from outside.
    pub holes: Vec<Vec<u32>>,
    /// Counter-clockwise seen from outside; every vertex of the outline and the holes is a corner of one.
    pub triangles: Vec<[u32; 3]>,
}

/// The boundary of a body: faces that close. Edges and vertices at which the body touches itself are allowed.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Solid {
    /// Positions in µm, ascending.
    pub vertices: Vec<[i64; 3]>,
    /// In the order of their planes.
    pub faces: Vec<Face>,
}

/// The face of a simple polygon; `None` without area.
fn face(tag: u32, polygon: &[Point], vertices: &[Point]) -> Option<Face> {
    let mut sum = [0i128; 3];
    for i in 1..polygon.len().saturating_sub(1) {
        let c = cross(sub(polygon[i], polygon[0]), sub(polygon[i + 1], polygon[0]));
        (0..3).for_each(|a| sum[a] += c[a]);
    }
    let (normal, turned) = primitive(sum)?;
    let normal = if turned { normal.map(|c| -c) } else { normal };
    let key = PlaneKey::through(normal, polygon[0]);
    let number = |p: &Point| vertices.binary_search(p).unwrap_or(0) as u32;
    let mut points = polygon.to_vec();
    points.sort_unstable();
    points.dedup();
    let flat: Vec<[i64; 2]> = points.iter().map(|&p| key.flat(p)).collect();
    let local = |p: &Point| points.binary_search(p).unwrap_or(0) as u32;
    let edges: Vec<([u32; 2], i32)> =
        (0..polygon.len()).map(|i| ([local(&polygon[i]), local(&polygon[(i + 1) % polygon.len()])], 1)).collect();
    let outer: Vec<u32> = polygon.iter().map(number).collect();
    let triangles = match triangulate(&flat, &edges) {
        Ok(triangles) => triangles.iter().map(|(t, _)| t.map(|n| number(&points[n as usize]))).collect(),
        // A polygon that crosses itself is shown all the same.
        Err(_) => (1..outer.len() - 1).map(|i| [outer[0], outer[i], outer[i + 1]]).collect(),
    };
    Some(Face { normal, tag, outer, holes: Vec::new(), triangles })
}

/// Polygons without those of which there is the same the other way round, whatever their tags.
pub(super) fn without_opposites(polygons: Vec<(u32, Vec<Point>)>) -> Vec<(u32, Vec<Point>)> {
    // A polygon read from its smallest corner on names it whatever its first corner.
    let named = |mut polygon: Vec<Point>| {
        let first = (0..polygon.len()).min_by_key(|&i| polygon[i]).unwrap_or(0);
        polygon.rotate_left(first);
        polygon
    };
    let mut open: FxHashMap<Vec<Point>, usize> = FxHashMap::default();
    let mut kept: Vec<Option<(u32, Vec<Point>)>> = Vec::with_capacity(polygons.len());
    for (tag, polygon) in polygons {
        let polygon = named(polygon);
        if let Some(other) = open.remove(&named(polygon.iter().rev().copied().collect())) {
            kept[other] = None;
        } else {
            open.insert(polygon.clone(), kept.len());
            kept.push(Some((tag, polygon)));
        }
    }
    kept.into_iter().flatten().collect()
}

/// What is to be known about a surface as a boundary.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct SolidReport {
    /// Directed edges of triangles without a reverse, counted as often as they lack one.
    pub open_edges: usize,
    /// Edges at which more than two triangles meet: the body touches itself there.
    pub crowded_edges: usize,
    /// Triangles without area.
    pub degenerate_triangles: usize,
}

impl Solid {
    /// Plane polygons with their tags, each a face of its own; two that are the same the other way round cancel. Nothing else is merged,
    /// so that the surface may run through itself.
    pub fn of_faces(polygons: Vec<(u32, Vec<[i64; 3]>)>) -> Solid {
        let kept = without_opposites(polygons);
        let mut vertices: Vec<Point> = kept.iter().flat_map(|(_, polygon)| polygon).copied().collect();
        vertices.sort_unstable();
        vertices.dedup();
        let faces = kept.iter().filter_map(|(tag, polygon)| face(*tag, polygon, &vertices)).collect();
        Solid { vertices, faces }
    }

    /// All triangles, face by face.
    pub fn triangles(&self) -> impl Iterator<Item = [u32; 3]> + '_ {
        self.faces.iter().flat_map(|f| f.triangles.iter().copied())
    }

    /// Number of triangles.
    pub fn triangle_count(&self) -> usize {
        self.faces.iter().map(|f| f.triangles.len()).sum()
    }

    fn corners(&self, triangle: [u32; 3]) -> [Point; 3] {
        triangle.map(|v| self.vertices[v as usize])
    }

    /// Six times the enclosed volume in µm3, exact.
    pub fn six_volumes(&self) -> i128 {
        let Some(&origin) = self.vertices.first() else { return 0 };
        self.triangles()
            .map(|t| {
                let [a, b, c] = self.corners(t).map(|p| sub(p, origin));
                let n = cross(b, c);
                (0..3).map(|i| i128::from(a[i]) * n[i]).sum::<i128>()
            })
            .sum()
    }

    /// Enclosed volume in m3.
    pub fn volume_m3(&self) -> f64 {
        self.six_volumes() as f64 / 6e18
    }

    /// Area of a face in m2.
    pub fn area_m2(&self, face: &Face) -> f64 {
        let double = |t: &[u32; 3]| {
            let [a, b, c] = self.corners(*t);
            cross(sub(b, a), sub(c, a)).map(|x| (x as f64).powi(2)).iter().sum::<f64>().sqrt()
        };
        face.triangles.iter().map(double).sum::<f64>() * 0.5e-12
    }

    /// Checks that the triangles close.
    pub fn report(&self) -> SolidReport {
        let mut edges: FxHashMap<[u32; 2], [i64; 2]> = FxHashMap::default();
        let mut report = SolidReport::default();
        for t in self.triangles() {
            let [a, b, c] = self.corners(t);
            report.degenerate_triangles += usize::from(cross(sub(b, a), sub(c, a)) == [0; 3]);
            for [a, b] in [[t[0], t[1]], [t[1], t[2]], [t[2], t[0]]] {
                edges.entry([a.min(b), a.max(b)]).or_default()[usize::from(a > b)] += 1;
            }
        }
        for [forth, back] in edges.into_values() {
            report.open_edges += forth.abs_diff(back) as usize;
            report.crowded_edges += usize::from(forth + back > 2);
        }
        report
    }
}
