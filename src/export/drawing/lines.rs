//! Edges of faces where they are seen.

use rustc_hash::FxHashMap;

use super::collinear::{Segment, join};
use super::model::{Kind, Model, Piece};
use super::raster::{NOTHING, Raster, Window};
use super::view::View;

/// How strongly a line is drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[repr(u8)]
pub enum Weight {
    /// Something stands far behind, or nothing.
    Outline,
    /// An edge of the building.
    Edge,
    /// An edge of a small part.
    Detail,
    /// An edge of what lies far beyond the plane that cuts.
    Beyond,
}

/// What lies behind an outline is at least this much farther away, m.
const JUMP_M: f64 = 0.35;

/// What is farther away than `far` (towards the reader, m) is [`Weight::Beyond`]. Edges of the pieces that `which` picks where the raster shows one of their faces beside them and something else on the other
/// side: lines inside a plane face, seams of tiles among them, are no edges.
pub fn visible(
    model: &Model,
    view: &View,
    window: &Window,
    raster: &Raster,
    far: f64,
    which: impl Fn(&Piece) -> bool,
) -> Vec<(Weight, Segment)> {
    let mut found: Vec<(u8, Segment)> = Vec::new();
    for piece in model.pieces.iter().filter(|p| which(p)) {
        let seen: Vec<[f64; 3]> = piece.vertices.iter().map(|v| view.see(*v)).collect();
        let towards = |face: u32| view.see(model.faces[face as usize].1)[2] > 1e-6;
        for ([a, b], faces) in edges(piece) {
            // Both triangles of an edge inside a face have its number.
            if faces[0] == faces[1] || !faces.iter().any(|&f| f != NOTHING && towards(f)) {
                continue;
            }
            let Some([p, q]) = clip(seen[a as usize], seen[b as usize], window.near) else { continue };
            walk(model, raster, [p, q], Edge { faces, kind: piece.kind, far }, &mut found);
        }
    }
    let weight = |rank: u8| match rank {
        0 => Weight::Outline,
        1 => Weight::Edge,
        2 => Weight::Detail,
        _ => Weight::Beyond,
    };
    join(&found).into_iter().map(|(rank, segment)| (weight(rank), segment)).collect()
}

/// The edges of a piece with the faces on their two sides, in order of their corners; where more than two meet, the first and the
/// first that differs.
fn edges(piece: &Piece) -> Vec<([u32; 2], [u32; 2])> {
    let mut known: FxHashMap<[u32; 2], usize> = FxHashMap::default();
    let mut edges: Vec<([u32; 2], [u32; 2])> = Vec::with_capacity(piece.triangles.len() * 3 / 2);
    for (t, &face) in piece.triangles.iter().zip(&piece.face) {
        for [a, b] in [[t[0], t[1]], [t[1], t[2]], [t[2], t[0]]] {
            let edge = [a.min(b), a.max(b)];
            let n = *known.entry(edge).or_insert(edges.len());
            match edges.get_mut(n) {
                None => edges.push((edge, [face, NOTHING])),
                Some((_, faces)) if faces[1] == NOTHING || faces[1] == faces[0] => faces[1] = face,
                Some(_) => {}
            }
        }
    }
    edges
}

/// The part of an edge that is not nearer than `near`, right and up.
fn clip(p: [f64; 3], q: [f64; 3], near: f64) -> Option<Segment> {
    let flat = |p: [f64; 3]| [p[0], p[1]];
    let cut = |p: [f64; 3], q: [f64; 3]| {
        let t = (near - p[2]) / (q[2] - p[2]);
        [p[0] + t * (q[0] - p[0]), p[1] + t * (q[1] - p[1])]
    };
    match (p[2] <= near, q[2] <= near) {
        (true, true) => Some([flat(p), flat(q)]),
        (true, false) => Some([flat(p), cut(p, q)]),
        (false, true) => Some([cut(p, q), flat(q)]),
        (false, false) => None,
    }
}

/// What decides how an edge is drawn: the faces on its sides, of what it is one, and what is far.
#[derive(Clone, Copy)]
struct Edge {
    faces: [u32; 2],
    kind: Kind,
    far: f64,
}

/// How far two faces may lie apart and still be flush, m.
const FLUSH_M: f32 = 2e-3;

/// Goes along an edge cell by cell and notes the stretches on which it is seen.
fn walk(model: &Model, raster: &Raster, [p, q]: Segment, edge: Edge, found: &mut Vec<(u8, Segment)>) {
    let (a, b) = (raster.place(p), raster.place(q));
    let d = [b[0] - a[0], b[1] - a[1]];
    let length = d[0].hypot(d[1]);
    if length < 1e-6 {
        return;
    }
    let steps = (length.ceil() as usize).max(1);
    let side = [-d[1] / length * 0.8, d[0] / length * 0.8];
    let mut run: Option<(u8, usize)> = None;
    let mut close = |run: Option<(u8, usize)>, end: usize| {
        let Some((rank, start)) = run else { return };
        // A single cell at the end of a longer edge is where it meets what hides it.
        if end - start >= 2 || steps <= 2 {
            let at = |n: usize| [0, 1].map(|i| p[i] + (q[i] - p[i]) * n as f64 / steps as f64);
            found.push((rank, [at(start), at(end)]));
        }
    };
    for n in 0..steps {
        let t = (n as f64 + 0.5) / steps as f64;
        let at = [a[0] + d[0] * t, a[1] + d[1] * t];
        let look = |s: f64| match raster.at([at[0] + s * side[0], at[1] + s * side[1]]) {
            Some(i) => (raster.face[i], raster.depth[i]),
            None => (NOTHING, f32::NEG_INFINITY),
        };
        let (left, right) = (look(1.0), look(-1.0));
        let rank = rank(left, right, edge).filter(|_| !joint(model, left, right));
        if run.map(|r| r.0) != rank {
            close(run, n);
            run = rank.map(|rank| (rank, n));
        }
    }
    close(run, steps);
}

/// Whether two parts of the concrete meet flush: a joint inside it, which nobody sees.
fn joint(model: &Model, left: (u32, f32), right: (u32, f32)) -> bool {
    let concrete = |face: u32| model.piece_of(face).is_some_and(|p| p.kind == Kind::Concrete);
    (left.1 - right.1).abs() < FLUSH_M && concrete(left.0) && concrete(right.0)
}

/// How an edge is drawn that has these faces and depths on its sides; `None` where it is hidden.
fn rank(left: (u32, f32), right: (u32, f32), Edge { faces, kind, far: limit }: Edge) -> Option<u8> {
    let own = |face: u32| face != NOTHING && faces.contains(&face);
    if left.0 == right.0 || !(own(left.0) || own(right.0)) {
        return None;
    }
    if f64::from(left.1.max(right.1)) < limit {
        return Some(Weight::Beyond as u8);
    }
    let far = f64::from((left.1 - right.1).abs()) > JUMP_M;
    Some(match kind {
        Kind::Glass | Kind::Leaf | Kind::Rail | Kind::RailGlass | Kind::Stair => Weight::Detail as u8,
        _ if far => Weight::Outline as u8,
        Kind::Detail => Weight::Detail as u8,
        _ => Weight::Edge as u8,
    })
}
