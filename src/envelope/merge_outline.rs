//! Outlines and holes of plane faces, read off their triangles.

use rustc_hash::FxHashMap;

use super::merge::Flat;
use super::merge_lines::Point;
use super::triangulate::Signed;

/// Faces of one plane: triangles that hang together by edges, with their loops, the outer one first.
///
/// At a vertex at which a face is pinched the loops follow the face's inside round the vertex, so that each face has one outer loop.
pub(super) fn outline(normal: Point, points: &[Point], flat: &[[i64; 2]], triangles: &[Signed]) -> Vec<Flat> {
    let mut faces = Vec::new();
    for sign in [1, -1] {
        let turned: Vec<[u32; 3]> = triangles
            .iter()
            .filter(|t| t.1 == sign)
            .map(|&([a, b, c], _)| if sign > 0 { [a, b, c] } else { [a, c, b] })
            .collect();
        let outward = normal.map(|c| c * i64::from(sign));
        faces.extend(bodies(&turned).into_iter().map(|body| {
            let mut loops = loops(&body);
            // Seen from outside, an outer loop encloses a positive area.
            loops.sort_by_key(|l| (doubled(flat, l) * i128::from(sign) <= 0, l[0]));
            Flat {
                normal: outward,
                loops: loops.iter().map(|l| l.iter().map(|&v| points[v as usize]).collect()).collect(),
                triangles: body.iter().map(|t| t.map(|v| points[v as usize])).collect(),
            }
        }));
    }
    faces
}

fn edges(t: [u32; 3]) -> [[u32; 2]; 3] {
    [[t[0], t[1]], [t[1], t[2]], [t[2], t[0]]]
}

/// Triangles that hang together, in a set order.
fn bodies(triangles: &[[u32; 3]]) -> Vec<Vec<[u32; 3]>> {
    let mut list = triangles.to_vec();
    for t in &mut list {
        let least = (0..3).min_by_key(|&i| t[i]).unwrap_or(0);
        t.rotate_left(least);
    }
    list.sort_unstable();
    let of_edge: FxHashMap<[u32; 2], usize> =
        list.iter().enumerate().flat_map(|(n, &t)| edges(t).map(|e| (e, n))).collect();
    let mut taken = vec![false; list.len()];
    let mut bodies = Vec::new();
    for first in 0..list.len() {
        if taken[first] {
            continue;
        }
        taken[first] = true;
        let mut members = vec![first];
        let mut i = 0;
        while i < members.len() {
            for [a, b] in edges(list[members[i]]) {
                if let Some(&n) = of_edge.get(&[b, a])
                    && !taken[n]
                {
                    taken[n] = true;
                    members.push(n);
                }
            }
            i += 1;
        }
        members.sort_unstable();
        bodies.push(members.into_iter().map(|n| list[n]).collect());
    }
    bodies
}

/// Boundary loops of triangles, each from its smallest vertex on.
fn loops(triangles: &[[u32; 3]]) -> Vec<Vec<u32>> {
    // Edge -> the corner opposite.
    let of_edge: FxHashMap<[u32; 2], u32> =
        triangles.iter().flat_map(|&t| [([t[0], t[1]], t[2]), ([t[1], t[2]], t[0]), ([t[2], t[0]], t[1])]).collect();
    let mut open: Vec<[u32; 2]> = of_edge.keys().filter(|[a, b]| !of_edge.contains_key(&[*b, *a])).copied().collect();
    open.sort_unstable();
    let mut done: FxHashMap<[u32; 2], ()> = FxHashMap::default();
    let mut loops = Vec::new();
    for &start in &open {
        if done.contains_key(&start) {
            continue;
        }
        let (mut edge, mut ring) = (start, Vec::new());
        while done.insert(edge, ()).is_none() {
            ring.push(edge[0]);
            let v = edge[1];
            // Turn round v through the inside until the next edge of the boundary.
            let mut spoke = of_edge[&edge];
            while let Some(&next) = of_edge.get(&[spoke, v]) {
                spoke = next;
            }
            edge = [v, spoke];
        }
        loops.push(ring);
    }
    loops
}

fn doubled(flat: &[[i64; 2]], ring: &[u32]) -> i128 {
    let at = |i: usize| flat[ring[i % ring.len()] as usize].map(i128::from);
    (0..ring.len()).map(|i| at(i)[0] * at(i + 1)[1] - at(i + 1)[0] * at(i)[1]).sum()
}
