//! Whether a mesh bounds a body: closed, oriented, and a surface everywhere.

use super::Mesh;
use rustc_hash::FxHashMap;

/// What is wrong with a mesh as a boundary, and its Euler number.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct ManifoldReport {
    /// Directed edges without a reverse.
    pub open_edges: usize,
    /// Edges with more than one triangle on a side, which includes neighbours of opposite orientation.
    pub crowded_edges: usize,
    /// Vertices around which the triangles form more than one fan: bodies touching in a point.
    pub pinched_vertices: usize,
    /// Triangles using a vertex twice.
    pub degenerate_triangles: usize,
    /// Vertices - edges + triangles; 2 for a ball, 0 for a ring.
    pub euler: i64,
}

impl ManifoldReport {
    /// Closed, oriented, and a 2-manifold.
    pub fn is_closed_manifold(&self) -> bool {
        self.open_edges + self.crowded_edges + self.pinched_vertices + self.degenerate_triangles == 0
    }
}

/// Checks every edge and every vertex of a mesh.
pub fn manifold_report(mesh: &Mesh) -> ManifoldReport {
    let mut report = ManifoldReport::default();
    // Directed edge -> number of triangles and the vertex opposite in the last of them.
    let mut edges: FxHashMap<[u32; 2], (usize, u32)> = FxHashMap::default();
    for &[a, b, c] in &mesh.triangles {
        report.degenerate_triangles += usize::from(a == b || b == c || c == a);
        for (edge, opposite) in [([a, b], c), ([b, c], a), ([c, a], b)] {
            let entry = edges.entry(edge).or_insert((0, opposite));
            *entry = (entry.0 + 1, opposite);
        }
    }
    let mut undirected = 0;
    for (&[a, b], &(count, _)) in &edges {
        let paired = edges.contains_key(&[b, a]);
        report.open_edges += usize::from(!paired);
        report.crowded_edges += usize::from(count > 1);
        undirected += usize::from(!paired || a < b);
    }
    report.euler = mesh.vertices.len() as i64 - undirected as i64 + mesh.triangles.len() as i64;
    if report.open_edges + report.crowded_edges == 0 {
        report.pinched_vertices = pinched(mesh, &edges);
    }
    report
}

/// Vertices whose triangles do not close in one turn: walk around each from one of its triangles and count.
fn pinched(mesh: &Mesh, edges: &FxHashMap<[u32; 2], (usize, u32)>) -> usize {
    let mut valence = vec![0usize; mesh.vertices.len()];
    let mut start = vec![None; mesh.vertices.len()];
    for triangle in &mesh.triangles {
        for n in 0..3 {
            let v = triangle[n] as usize;
            valence[v] += 1;
            start[v] = Some(triangle[(n + 1) % 3]);
        }
    }
    let one_fan = |v: usize| {
        let Some(first) = start[v] else { return true };
        let (mut spoke, mut turned) = (first, 0);
        while turned <= valence[v] {
            let Some(&(_, next)) = edges.get(&[v as u32, spoke]) else { return false };
            spoke = next;
            turned += 1;
            if spoke == first {
                break;
            }
        }
        turned == valence[v]
    };
    (0..valence.len()).filter(|&v| !one_fan(v)).count()
}
