//! Triangles of plane regions bounded by signed edges.
//!
//! Constrained Delaunay triangulation (`spade`): it takes regions with holes and pinched vertices as they are, keeps every vertex of
//! the boundary, makes the fattest triangles there are and runs in n log n; its predicates are exact, so with whole coordinates below
//! 2^53 nothing is rounded. Ear clipping with bridges would be quadratic and make slivers.

use rustc_hash::FxHashMap;
use spade::handles::FixedFaceHandle;
use spade::{ConstrainedDelaunayTriangulation, HasPosition, Point2, Triangulation};

/// A vertex that knows its number.
#[derive(Clone, Copy, Debug)]
struct Numbered {
    at: [i64; 2],
    number: u32,
}

impl HasPosition for Numbered {
    type Scalar = f64;

    fn position(&self) -> Point2<f64> {
        Point2::new(self.at[0] as f64, self.at[1] as f64)
    }
}

/// Why a region could not be triangulated.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Fault {
    /// Edges cross, or run through a vertex.
    Conflict,
    /// A place is covered more than once, or edges do not close.
    Overlap,
}

/// A triangle, counter-clockwise, and how often its place is covered: 1 or -1.
pub(super) type Signed = ([u32; 3], i32);

/// Triangulates the region in which the winding sum of `edges` is not zero.
///
/// - `points`: distinct whole coordinates;
/// - `edges`: from, to, and how much the covering is more to the left of the edge than to its right. Edges meet at points only.
pub(super) fn triangulate(points: &[[i64; 2]], edges: &[([u32; 2], i32)]) -> Result<Vec<Signed>, Fault> {
    let vertices = points.iter().enumerate().map(|(n, &at)| Numbered { at, number: n as u32 }).collect();
    let mut steps: FxHashMap<[u32; 2], i32> = FxHashMap::default();
    for &([a, b], step) in edges {
        if a < b {
            *steps.entry([a, b]).or_default() += step;
        } else {
            *steps.entry([b, a]).or_default() -= step;
        }
    }
    let mut pairs: Vec<[usize; 2]> = steps.keys().map(|e| e.map(|v| v as usize)).collect();
    pairs.sort_unstable();
    let mut conflict = false;
    let built = ConstrainedDelaunayTriangulation::<Numbered>::try_bulk_load_cdt(vertices, pairs, |_| conflict = true);
    let Ok(mesh) = built else { return Err(Fault::Conflict) };
    if conflict || mesh.num_vertices() != points.len() || mesh.num_constraints() != steps.len() {
        return Err(Fault::Conflict);
    }
    let covering = cover(&mesh, &steps)?;
    let mut triangles = Vec::with_capacity(mesh.num_inner_faces());
    for face in mesh.inner_faces() {
        let cover = covering[face.fix().index()].ok_or(Fault::Overlap)?;
        if cover.abs() > 1 {
            return Err(Fault::Overlap);
        }
        if cover != 0 {
            triangles.push((face.vertices().map(|v| v.data().number), cover));
        }
    }
    Ok(triangles)
}

/// How often each face is covered, from the outer face inwards; `None` where two ways to it disagree.
fn cover(
    mesh: &ConstrainedDelaunayTriangulation<Numbered>,
    steps: &FxHashMap<[u32; 2], i32>,
) -> Result<Vec<Option<i32>>, Fault> {
    let step = |a: u32, b: u32| if a < b { steps.get(&[a, b]).copied() } else { steps.get(&[b, a]).map(|s| -s) };
    let mut covering: Vec<Option<i32>> = vec![None; mesh.num_all_faces()];
    let outer: FixedFaceHandle<_> = mesh.outer_face().fix();
    covering[outer.index()] = Some(0);
    let mut open = Vec::new();
    for edge in mesh.directed_edges().filter(|e| e.is_outer_edge()) {
        let inner = edge.rev();
        let value = -step(edge.from().data().number, edge.to().data().number).unwrap_or(0);
        let place = &mut covering[inner.face().fix().index()];
        if place.is_some_and(|v| v != value) {
            return Err(Fault::Overlap);
        }
        *place = Some(value);
        open.push(inner.face().fix());
    }
    while let Some(face) = open.pop() {
        let Some(face) = mesh.face(face).as_inner() else { continue };
        let Some(here) = covering[face.fix().index()] else { continue };
        for edge in face.adjacent_edges() {
            let there = edge.rev().face();
            let value = here - step(edge.from().data().number, edge.to().data().number).unwrap_or(0);
            match covering[there.fix().index()] {
                Some(known) if known != value => return Err(Fault::Overlap),
                Some(_) => {}
                None => {
                    covering[there.fix().index()] = Some(value);
                    open.push(there.fix());
                }
            }
        }
    }
    Ok(covering)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn ring(from: u32, n: u32, step: i32) -> Vec<([u32; 2], i32)> {
        (0..n).map(|i| ([from + i, from + (i + 1) % n], step)).collect()
    }

    fn doubled(points: &[[i64; 2]], triangles: &[Signed]) -> i64 {
        let area = |t: [u32; 3]| {
            let [a, b, c] = t.map(|v| points[v as usize]);
            (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
        };
        triangles.iter().map(|&(t, s)| area(t) * i64::from(s)).sum()
    }

    #[test]
    fn a_square_with_a_hole_and_a_collinear_vertex() {
        let points = [[0, 0], [5, 0], [10, 0], [10, 10], [0, 10], [3, 3], [3, 6], [6, 6], [6, 3]];
        let edges = [ring(0, 5, 1), ring(5, 4, 1)].concat(); // the hole runs clockwise
        let triangles = triangulate(&points, &edges).expect("sound");
        assert_eq!(doubled(&points, &triangles), 2 * (100 - 9));
        assert_eq!(triangles.len(), 9, "V + 2 H - 2");
    }

    #[test]
    fn both_orientations_side_by_side() {
        let points = [[0, 0], [4, 0], [4, 4], [0, 4], [8, 0], [8, 4]];
        let mut edges = ring(0, 4, 1);
        edges.extend([([1, 4], -1), ([4, 5], -1), ([5, 2], -1), ([2, 1], -1)]);
        let triangles = triangulate(&points, &edges).expect("sound");
        assert_eq!((triangles.len(), doubled(&points, &triangles)), (4, 0));
        assert_eq!(triangles.iter().filter(|t| t.1 == 1).count(), 2);
    }

    #[test]
    fn what_is_covered_twice_or_open_or_crossing_is_refused() {
        let points = [[0, 0], [4, 0], [4, 4], [0, 4]];
        assert_eq!(triangulate(&points, &ring(0, 4, 2)), Err(Fault::Overlap));
        assert_eq!(triangulate(&points, &ring(0, 4, 1)[..3]), Err(Fault::Overlap));
        let bow = [([0, 2], 1), ([2, 3], 1), ([3, 1], 1), ([1, 0], 1)];
        assert_eq!(triangulate(&points, &bow), Err(Fault::Conflict));
    }
}
