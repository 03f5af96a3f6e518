//! Exact integer geometry of solids in micrometres. Products of four lengths occur, hence 128 bits.

use super::TilesetError;
use std::path::Path;

type Point = [i32; 3];
type Vector = [i128; 3];

fn sub(a: Point, b: Point) -> Vector {
    [0, 1, 2].map(|i| i128::from(a[i]) - i128::from(b[i]))
}

fn cross(a: Vector, b: Vector) -> Vector {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

fn dot(a: Vector, b: Vector) -> i128 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// Twice the vector area, right-handed to the order of the points.
pub(super) fn doubled_area(polygon: &[Point]) -> Vector {
    let mut sum = [0; 3];
    for i in 1..polygon.len().saturating_sub(1) {
        let c = cross(sub(polygon[i], polygon[0]), sub(polygon[i + 1], polygon[0]));
        (0..3).for_each(|a| sum[a] += c[a]);
    }
    sum
}

/// Largest distance of a point from the plane through the first point with the polygon's normal, µm; zero without an area.
pub(super) fn out_of_plane(polygon: &[Point]) -> f64 {
    let n = doubled_area(polygon);
    let length = n.iter().map(|&c| (c as f64).powi(2)).sum::<f64>().sqrt();
    if length == 0.0 {
        return 0.0;
    }
    polygon.iter().map(|&p| (dot(sub(p, polygon[0]), n) as f64 / length).abs()).fold(0.0, f64::max)
}

/// Six times the signed volume that closed, outward polygons enclose, µm3.
pub(super) fn six_volumes<'a>(polygons: impl IntoIterator<Item = &'a Vec<Point>>) -> i128 {
    let at = |p: Point| p.map(i128::from);
    polygons
        .into_iter()
        .map(|p| (1..p.len() - 1).map(|i| dot(at(p[0]), cross(at(p[i]), at(p[i + 1])))).sum::<i128>())
        .sum()
}

/// Cuts a planar polygon into triangles by ear clipping; a polygon that crosses itself gives a fan.
pub(super) fn triangulate(polygon: &[Point]) -> Vec<[Point; 3]> {
    let normal = doubled_area(polygon);
    let mut rest = polygon.to_vec();
    let mut triangles = Vec::with_capacity(rest.len().saturating_sub(2));
    let side = |a: Point, b: Point, c: Point| dot(cross(sub(b, a), sub(c, a)), normal);
    while rest.len() > 3 {
        let n = rest.len();
        let ear = (0..n).find(|&i| {
            let [a, b, c] = [rest[(i + n - 1) % n], rest[i], rest[(i + 1) % n]];
            let clear =
                |p: &Point| [a, b, c].contains(p) || side(a, b, *p) < 0 || side(b, c, *p) < 0 || side(c, a, *p) < 0;
            side(a, b, c) > 0 && rest.iter().all(clear)
        });
        let at = ear.unwrap_or(1);
        triangles.push([rest[(at + n - 1) % n], rest[at], rest[(at + 1) % n]]);
        rest.remove(at);
    }
    if let [a, b, c] = rest[..] {
        triangles.push([a, b, c]);
    }
    triangles
}

/// A polygon of a tile for the crossing test: triangles, edges, bounds, and where it was drawn.
struct Face<'a> {
    polygon: &'a [Point],
    triangles: Vec<[Point; 3]>,
    low: Point,
    high: Point,
    line: usize,
    group: &'a str,
}

/// Edges that run strictly through the inside of another polygon: solids that cut themselves or each other. Touching is allowed.
/// Each item is polygon, line and group; each pair of groups is reported once, with its first pair of polygons.
pub(super) fn crossings(polygons: &[(&Vec<Point>, usize, &str)], path: &Path) -> Vec<TilesetError> {
    let faces: Vec<Face> = polygons
        .iter()
        .map(|&(polygon, line, group)| Face {
            polygon,
            triangles: triangulate(polygon),
            low: [0, 1, 2].map(|a| polygon.iter().map(|p| p[a]).min().unwrap_or(0)),
            high: [0, 1, 2].map(|a| polygon.iter().map(|p| p[a]).max().unwrap_or(0)),
            line,
            group,
        })
        .collect();
    let mut found: Vec<([&str; 2], TilesetError)> = Vec::new();
    for a in &faces {
        for b in &faces {
            let apart = (0..3).any(|i| a.high[i] < b.low[i] || b.high[i] < a.low[i]);
            if apart || found.iter().any(|(g, _)| *g == [a.group, b.group] || *g == [b.group, a.group]) {
                continue;
            }
            if runs_through(a.polygon, &b.triangles) {
                let crossing = TilesetError::Crossing {
                    path: path.into(),
                    line: a.line,
                    group: a.group.into(),
                    other_line: b.line,
                    other_group: b.group.into(),
                };
                found.push(([a.group, b.group], crossing));
            }
        }
    }
    found.into_iter().map(|(_, e)| e).collect()
}

/// Whether an edge of the polygon crosses one of the triangles strictly.
fn runs_through(polygon: &[Point], triangles: &[[Point; 3]]) -> bool {
    (0..polygon.len()).any(|i| {
        let [p, q] = [polygon[i], polygon[(i + 1) % polygon.len()]];
        triangles.iter().any(|&t| pierces(p, q, t))
    })
}

fn pierces(p: Point, q: Point, [a, b, c]: [Point; 3]) -> bool {
    let n = cross(sub(b, a), sub(c, a));
    let (sp, sq) = (dot(sub(p, a), n).signum(), dot(sub(q, a), n).signum());
    if sp * sq >= 0 {
        return false;
    }
    // The edge passes each side of the triangle on the same hand: signed volumes of the edge with the sides.
    let hand = |u: Point, v: Point| dot(sub(q, p), cross(sub(u, p), sub(v, p))).signum();
    let [x, y, z] = [hand(a, b), hand(b, c), hand(c, a)];
    x != 0 && x == y && y == z
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_concave_polygon_is_cut_within_its_area() {
        let l = [[0, 0, 0], [4, 0, 0], [4, 2, 0], [2, 2, 0], [2, 4, 0], [0, 4, 0]];
        let triangles = triangulate(&l);
        assert_eq!(triangles.len(), 4);
        let sum: i128 = triangles.iter().map(|t| doubled_area(t)[2]).sum();
        assert_eq!((sum, doubled_area(&l)[2]), (24, 24));
        assert!(triangles.iter().all(|t| doubled_area(t)[2] > 0));
    }

    #[test]
    fn an_edge_pierces_a_triangle_only_strictly_inside() {
        let t = [[0, 0, 0], [9, 0, 0], [0, 9, 0]];
        assert!(pierces([2, 2, -1], [2, 2, 1], t) && pierces([2, 2, 1], [2, 2, -1], t));
        assert!(!pierces([2, 0, -1], [2, 0, 1], t), "on its edge");
        assert!(!pierces([2, 2, 0], [2, 2, 1], t), "touching");
        assert!(!pierces([8, 8, -1], [8, 8, 1], t), "beside");
    }
}
