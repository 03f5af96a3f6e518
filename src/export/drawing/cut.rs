//! What a plane cuts: closed areas of each material, exactly along the solids.

use std::collections::BTreeMap;

use rustc_hash::FxHashMap;

use super::collinear::{Segment, cancel};
use super::model::{Kind, Model, Piece};
use super::view::View;

/// A closed line, not repeated at its end, m; outer ones counter-clockwise, holes clockwise.
pub type Loop = Vec<[f64; 2]>;

/// What a plane cuts of a house.
#[derive(Clone, Debug, Default)]
pub struct Cut {
    /// Areas by piece, even-odd.
    pub areas: Vec<(usize, Vec<Loop>)>,
    /// Where material ends.
    pub outline: Vec<Segment>,
    /// Where one material ends at the next.
    pub between: Vec<Segment>,
}

/// Cuts the pieces that `which` picks at the plane `near` of a view. A corner in the plane counts as beyond it, so that a face in the
/// plane is cut or not as a whole.
pub fn cut(model: &Model, view: &View, near: f64, which: impl Fn(&Piece) -> bool) -> Cut {
    let mut found = Cut::default();
    // The skin of a set of surfaces closes only together.
    let mut groups: BTreeMap<usize, Vec<&Piece>> = BTreeMap::new();
    let skin = model.pieces.iter().position(|p| p.kind == Kind::Skin);
    for (n, piece) in model.pieces.iter().enumerate().filter(|(_, p)| which(p)) {
        let together = skin.filter(|_| matches!(piece.kind, Kind::Skin | Kind::Glass));
        groups.entry(together.unwrap_or(n)).or_default().push(piece);
    }
    let mut directed = Vec::new();
    for (n, pieces) in groups {
        let loops = loops(&pieces, view, near);
        directed.extend(loops.iter().flat_map(|l| (0..l.len()).map(|i| [l[i], l[(i + 1) % l.len()]])));
        if !loops.is_empty() {
            found.areas.push((n, loops));
        }
    }
    [found.outline, found.between] = cancel(&directed);
    found
}

/// The loops in which pieces that close together are cut.
fn loops(pieces: &[&Piece], view: &View, near: f64) -> Vec<Loop> {
    let mut known: FxHashMap<[i64; 3], u32> = FxHashMap::default();
    let mut places: Vec<[f64; 3]> = Vec::new();
    // Where each segment starts and ends: edges by their corners' numbers.
    let mut segments: Vec<[[u32; 2]; 2]> = Vec::new();
    for piece in pieces {
        let number: Vec<u32> = piece
            .vertices
            .iter()
            .map(|v| {
                let next = places.len() as u32;
                let n = *known.entry(v.map(|c| (c * 1e6).round() as i64)).or_insert(next);
                if n == next {
                    places.push(view.see(*v));
                }
                n
            })
            .collect();
        for triangle in &piece.triangles {
            let corners = triangle.map(|v| number[v as usize]);
            let above = corners.map(|c| places[c as usize][2] > near);
            let crossing = |up: bool| {
                let i = (0..3).find(|&i| above[i] != up && above[(i + 1) % 3] == up)?;
                let [a, b] = [corners[i], corners[(i + 1) % 3]];
                Some([a.min(b), a.max(b)])
            };
            if let (Some(down), Some(up)) = (crossing(false), crossing(true)) {
                segments.push([down, up]);
            }
        }
    }
    let at = |[a, b]: [u32; 2]| {
        let (p, q) = (places[a as usize], places[b as usize]);
        let t = (near - p[2]) / (q[2] - p[2]);
        [p[0] + t * (q[0] - p[0]), p[1] + t * (q[1] - p[1])]
    };
    chain(&segments)
        .into_iter()
        .map(|edges| straight(&edges.into_iter().map(at).collect::<Vec<_>>()))
        .filter(|l| l.len() > 2)
        .collect()
}

/// Segments end to start, as closed loops of the edges they start at.
fn chain(segments: &[[[u32; 2]; 2]]) -> Vec<Vec<[u32; 2]>> {
    let mut starts: FxHashMap<[u32; 2], Vec<usize>> = FxHashMap::default();
    for (n, [from, _]) in segments.iter().enumerate().rev() {
        starts.entry(*from).or_default().push(n);
    }
    let mut used = vec![false; segments.len()];
    let mut loops = Vec::new();
    for start in 0..segments.len() {
        let mut edges = Vec::new();
        let mut next = (!used[start]).then_some(start);
        while let Some(n) = next {
            used[n] = true;
            edges.push(segments[n][0]);
            let candidates = starts.get_mut(&segments[n][1]);
            next = candidates.and_then(|list| {
                while let Some(n) = list.pop() {
                    if !used[n] {
                        return Some(n);
                    }
                }
                None
            });
        }
        if edges.len() > 2 {
            loops.push(edges);
        }
    }
    loops
}

/// A loop without corners that lie on a straight line with their neighbours, to a micrometre.
fn straight(points: &[[f64; 2]]) -> Loop {
    let mut kept: Loop = Vec::with_capacity(points.len());
    for &p in points {
        if kept.last().is_none_or(|q: &[f64; 2]| (p[0] - q[0]).hypot(p[1] - q[1]) > 1e-6) {
            kept.push(p);
        }
    }
    let n = kept.len();
    let turns = |i: usize| {
        let (a, b, c) = (kept[(i + n - 1) % n], kept[i], kept[(i + 1) % n]);
        let (u, v) = ([b[0] - a[0], b[1] - a[1]], [c[0] - b[0], c[1] - b[1]]);
        (u[0] * v[1] - u[1] * v[0]).abs() > 1e-6 * u[0].hypot(u[1]).min(v[0].hypot(v[1]))
            || u[0] * v[0] + u[1] * v[1] < 0.0
    };
    (0..n).filter(|&i| turns(i)).map(|i| kept[i]).collect()
}

/// Signed area of a loop, m2.
pub fn area(points: &[[f64; 2]]) -> f64 {
    let n = points.len();
    (0..n).map(|i| (points[i], points[(i + 1) % n])).map(|(p, q)| p[0] * q[1] - p[1] * q[0]).sum::<f64>() / 2.0
}

/// Lowest and highest corner of loops.
pub fn bounds<'a>(loops: impl Iterator<Item = &'a [f64; 2]>) -> Option<[[f64; 2]; 2]> {
    loops.fold(None, |found, &p| match found {
        None => Some([p, p]),
        Some([low, high]) => Some([[0, 1].map(|a: usize| low[a].min(p[a])), [0, 1].map(|a: usize| high[a].max(p[a]))]),
    })
}
