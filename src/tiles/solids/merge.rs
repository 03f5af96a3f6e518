//! Joins neighbouring pieces of one component that together are convex.

use super::arrange::Polygon;
use super::body::Piece;

/// Joins pieces with the same component, corner, bottom and top that share a whole edge in plan, while the union is convex.
pub(super) fn merge(pieces: &mut Vec<Piece>) {
    // A piece that has grown may fit one that did not before: until nothing changes.
    while pass(pieces) {}
}

fn pass(pieces: &mut Vec<Piece>) -> bool {
    let before = pieces.len();
    let mut i = 0;
    while i < pieces.len() {
        let mut j = i + 1;
        while j < pieces.len() {
            match joined(&pieces[i], &pieces[j]) {
                Some(plan) => {
                    pieces[i].plan = plan;
                    pieces.remove(j);
                }
                None => j += 1,
            }
        }
        i += 1;
    }
    pieces.len() < before
}

fn joined(first: &Piece, second: &Piece) -> Option<Polygon> {
    let alike = first.component == second.component
        && first.octant == second.octant
        && first.bottom == second.bottom
        && first.top == second.top;
    if alike { union(&first.plan, &second.plan) } else { None }
}

/// The union of two convex polygons that share one whole edge, if it is convex.
fn union(first: &[[i32; 2]], second: &[[i32; 2]]) -> Option<Polygon> {
    let (n, m) = (first.len(), second.len());
    for i in 0..n {
        let (p, r) = (first[i], first[(i + 1) % n]);
        let Some(j) = (0..m).find(|&j| second[j] == r && second[(j + 1) % m] == p) else { continue };
        // Round the first from r to p, then round the second from behind p to before r.
        let mut union: Polygon = (1..=n).map(|k| first[(i + k) % n]).collect();
        union.extend((2..m).map(|k| second[(j + k) % m]));
        return straightened(union);
    }
    None
}

/// Without corners on straight edges; `None` for a polygon with a reflex corner.
fn straightened(polygon: Polygon) -> Option<Polygon> {
    let n = polygon.len();
    let turn = |i: usize| {
        let [a, b, c] = [polygon[(i + n - 1) % n], polygon[i], polygon[(i + 1) % n]].map(|p| p.map(i64::from));
        (b[0] - a[0]) * (c[1] - b[1]) - (b[1] - a[1]) * (c[0] - b[0])
    };
    let turns: Vec<i64> = (0..n).map(turn).collect();
    if turns.iter().any(|t| *t < 0) {
        return None;
    }
    Some(polygon.into_iter().zip(turns).filter(|(_, t)| *t > 0).map(|(p, _)| p).collect())
}
