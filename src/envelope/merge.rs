//! The boundary of many disjoint touching blocks as one closed surface of few faces.
//!
//! Faces are grouped by supporting plane; on each supporting line the directed edges of a plane are summed as signed intervals. Inner
//! edges, caps between touching blocks and T-junctions cancel in that one sum, collinear pieces join, and what remains is the boundary
//! of the difference of what faces one way and what faces the other. A line is cut at the same places in all of its planes, so the
//! triangles of neighbouring faces share their edges. All of it is exact in whole micrometres and does not depend on the order of the
//! blocks.

use rustc_hash::{FxHashMap, FxHashSet};

use super::merge_lines::{Line, Lines, PlaneKey, Point};
use super::merge_outline::outline;
use super::merge_solid::{Face, Solid};
use super::triangulate::{Fault, triangulate};
use crate::tiles::Block;

/// Faces that bound no union of disjoint blocks.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
pub enum MergeError {
    /// A place of a plane is covered twice from one side, or the edges in it do not close.
    #[error(
        "near ({}, {}, {}) µm faces with normal {normal:?} overlap or do not close; blocks must be disjoint and whole",
        at[0], at[1], at[2]
    )]
    Overlap {
        /// A vertex of the plane in µm.
        at: [i64; 3],
        /// Its normal.
        normal: [i64; 3],
    },
    /// Edges that cross at a place without whole coordinates.
    #[error("near ({}, {}, {}) µm two edges cross between whole micrometres; move one of the blocks", at[0], at[1], at[2])]
    Crossing {
        /// A vertex of the plane in µm.
        at: [i64; 3],
    },
}

/// Collects faces and makes their boundary.
#[derive(Clone, Debug, Default)]
pub struct Merge {
    known: FxHashMap<(PlaneKey, u32), u32>,
    planes: Vec<PlaneKey>,
    tags: Vec<u32>,
    tag: u32,
    lines: Lines,
    polygon: Vec<Point>,
}

impl Merge {
    /// Nothing yet.
    pub fn new() -> Merge {
        Merge::default()
    }

    /// What is added from here on has this tag, at first 0: faces of different tags stay apart even in one plane, and neither cancel nor
    /// join, but are cut alike where they meet.
    pub fn set_tag(&mut self, tag: u32) {
        self.tag = tag;
    }

    /// Adds the faces of a block moved by `offset` µm.
    pub fn add_block(&mut self, block: &Block, offset: [i64; 3]) {
        let n = block.plan.len();
        let at = |i: usize, z: i32| {
            [
                i64::from(block.plan[i % n][0]) + offset[0],
                i64::from(block.plan[i % n][1]) + offset[1],
                i64::from(z) + offset[2],
            ]
        };
        let mut polygon = std::mem::take(&mut self.polygon);
        polygon.clear();
        polygon.extend((0..n).rev().map(|i| at(i, block.bottom[i])));
        self.add_face(&polygon);
        polygon.clear();
        polygon.extend((0..n).map(|i| at(i, block.top[i])));
        self.add_face(&polygon);
        for i in 0..n {
            let j = (i + 1) % n;
            polygon.clear();
            polygon.extend([at(i, block.bottom[i]), at(j, block.bottom[j]), at(j, block.top[j]), at(i, block.top[i])]);
            self.add_face(&polygon);
        }
        self.polygon = polygon;
    }

    /// Adds a plane polygon, counter-clockwise seen from outside; repeated corners do no harm, one without area adds nothing.
    pub fn add_face(&mut self, polygon: &[[i64; 3]]) {
        if let Some(key) = PlaneKey::of(polygon) {
            self.add_loop(key, polygon);
        }
    }

    /// Adds everything of a surface that was merged before.
    pub fn add_solid(&mut self, solid: &Solid) {
        for face in &solid.faces {
            let points = |l: &Vec<u32>| l.iter().map(|&v| solid.vertices[v as usize]).collect::<Vec<_>>();
            let outer = points(&face.outer);
            let Some(key) = PlaneKey::of(&outer) else { continue };
            self.add_loop(key, &outer);
            face.holes.iter().for_each(|h| self.add_loop(key, &points(h)));
        }
    }

    fn add_loop(&mut self, key: PlaneKey, polygon: &[Point]) {
        let (planes, tags, tag) = (&mut self.planes, &mut self.tags, self.tag);
        let plane = *self.known.entry((key, tag)).or_insert_with(|| {
            planes.push(key);
            tags.push(tag);
            planes.len() as u32 - 1
        });
        for (i, &a) in polygon.iter().enumerate() {
            self.lines.add(plane, a, polygon[(i + 1) % polygon.len()]);
        }
    }

    /// The boundary.
    ///
    /// # Errors
    /// Blocks that overlap, or faces that do not close.
    pub fn finish(mut self) -> Result<Solid, MergeError> {
        self.lines.settle();
        let mut edges = vec![Vec::new(); self.planes.len()];
        for (l, line) in self.lines.all.iter().enumerate() {
            for (i, interval) in line.intervals.iter().enumerate() {
                edges[interval.plane as usize].push((l as u32, i as u32));
            }
        }
        let tags = self.tags;
        let mut work = Arrangement { planes: self.planes, edges, lines: self.lines };
        let mut order: Vec<usize> = (0..work.planes.len()).filter(|&p| !work.edges[p].is_empty()).collect();
        order.sort_unstable_by_key(|&p| (work.planes[p], tags[p]));
        work.cut_at_vertices(order.clone());
        let mut shaped: Vec<Option<Vec<Flat>>> = vec![None; work.planes.len()];
        loop {
            let mut crossed = Vec::new();
            for &p in &order {
                if shaped[p].is_none() {
                    match work.shape(p) {
                        Ok(faces) => shaped[p] = Some(faces),
                        Err(Fault::Conflict) => crossed.push(p),
                        Err(Fault::Overlap) => return Err(work.overlap(p)),
                    }
                }
            }
            if crossed.is_empty() {
                break;
            }
            // A cut for one plane may serve another, so only a round without any cut is hopeless.
            let mut cut = false;
            for &p in &crossed {
                let touched = work.cut_at_crossings(p)?;
                cut |= !touched.is_empty();
                for t in work.cut_at_vertices(touched) {
                    shaped[t] = None;
                }
            }
            if !cut {
                return Err(work.overlap(crossed[0]));
            }
        }
        let tagged =
            |p: usize| shaped[p].take().unwrap_or_default().into_iter().map(|flat| (tags[p], flat)).collect::<Vec<_>>();
        Ok(assemble(order.into_iter().flat_map(tagged).collect()))
    }
}

/// A face by points.
#[derive(Clone, Debug)]
pub(super) struct Flat {
    pub normal: Point,
    pub loops: Vec<Vec<Point>>,
    pub triangles: Vec<[Point; 3]>,
}

/// Vertices numbered by position.
fn assemble(flats: Vec<(u32, Flat)>) -> Solid {
    let mut vertices: Vec<Point> = flats.iter().flat_map(|(_, f)| f.loops.iter().flatten().copied()).collect();
    vertices.sort_unstable();
    vertices.dedup();
    let number: FxHashMap<Point, u32> = vertices.iter().enumerate().map(|(n, &p)| (p, n as u32)).collect();
    let mut faces = Vec::with_capacity(flats.len());
    for (tag, flat) in flats {
        let mut loops = flat.loops.iter().map(|l| l.iter().map(|p| number[p]).collect::<Vec<u32>>());
        let outer = loops.next().unwrap_or_default();
        let holes = loops.collect();
        let triangles = flat.triangles.iter().map(|t| t.map(|p| number[&p])).collect();
        faces.push(Face { normal: flat.normal, tag, outer, holes, triangles });
    }
    Solid { vertices, faces }
}

/// Planes with the intervals of lines that bound something in them.
struct Arrangement {
    planes: Vec<PlaneKey>,
    edges: Vec<Vec<(u32, u32)>>,
    lines: Lines,
}

impl Arrangement {
    fn overlap(&self, plane: usize) -> MergeError {
        let at = self.edges[plane].first().map_or([0; 3], |&(l, i)| {
            let line = &self.lines.all[l as usize];
            line.point(line.intervals[i as usize].from)
        });
        MergeError::Overlap { at, normal: self.planes[plane].normal }
    }

    fn pieces(&self, plane: usize) -> impl Iterator<Item = (&Line, &[i64], i32)> {
        self.edges[plane].iter().map(|&(l, i)| {
            let line = &self.lines.all[l as usize];
            let interval = &line.intervals[i as usize];
            (line, line.pieces(interval), interval.step)
        })
    }

    /// Cuts lines where a vertex of one of their planes lies on them, in all planes; answers every plane that was looked at.
    fn cut_at_vertices(&mut self, first: Vec<usize>) -> Vec<usize> {
        let mut open = first;
        let mut seen: FxHashSet<usize> = open.iter().copied().collect();
        while let Some(p) = open.pop() {
            let mut points: Vec<Point> =
                self.pieces(p).flat_map(|(line, cuts, _)| cuts.iter().map(|&c| line.point(c))).collect();
            points.sort_unstable();
            points.dedup();
            let directions: FxHashSet<Point> = self.pieces(p).map(|(line, ..)| line.direction).collect();
            for direction in directions {
                for &point in &points {
                    let Some(l) = self.lines.find(direction, point) else { continue };
                    let place = self.lines.all[l].place(point);
                    let inside = |i: &super::merge_lines::Interval| i.from < place && place < i.to;
                    if self.lines.all[l].intervals.iter().any(|i| i.plane as usize == p && inside(i)) {
                        open.extend(self.cut(l, place, &mut seen));
                    }
                }
            }
        }
        seen.into_iter().collect()
    }

    /// Cuts a line at a place; answers the planes that have an edge there when the cut is new.
    fn cut(&mut self, l: usize, place: i64, seen: &mut FxHashSet<usize>) -> Vec<usize> {
        let line = &mut self.lines.all[l];
        if !line.cut(place) {
            return Vec::new();
        }
        let planes: Vec<usize> =
            line.intervals.iter().filter(|i| i.from < place && place < i.to).map(|i| i.plane as usize).collect();
        seen.extend(&planes);
        planes
    }

    /// Cuts the edges of a plane where they cross, which they do where two blocks touch in a point from either side of it.
    fn cut_at_crossings(&mut self, plane: usize) -> Result<Vec<usize>, MergeError> {
        let key = self.planes[plane];
        let mut found = Vec::new();
        let edges = &self.edges[plane];
        for (n, &(l, i)) in edges.iter().enumerate() {
            for &(m, j) in &edges[n + 1..] {
                let [a, b] = [&self.lines.all[l as usize], &self.lines.all[m as usize]];
                if a.direction == b.direction {
                    continue;
                }
                let ends = |line: &Line, i: u32| {
                    let i = &line.intervals[i as usize];
                    [line.point(i.from), line.point(i.to)]
                };
                let (s, t) = (ends(a, i), ends(b, j));
                if let Some(at) = crossing(s.map(|p| key.flat(p)), t.map(|p| key.flat(p)), s) {
                    found.push((l as usize, m as usize, at.ok_or(MergeError::Crossing { at: s[0] })?));
                }
            }
        }
        let mut touched = FxHashSet::default();
        for (l, m, at) in found {
            for line in [l, m] {
                let place = self.lines.all[line].place(at);
                self.cut(line, place, &mut touched);
            }
        }
        Ok(touched.into_iter().collect())
    }

    fn shape(&self, plane: usize) -> Result<Vec<Flat>, Fault> {
        let key = self.planes[plane];
        let mut points: Vec<Point> =
            self.pieces(plane).flat_map(|(line, cuts, _)| cuts.iter().map(|&c| line.point(c))).collect();
        points.sort_unstable();
        points.dedup();
        let number = |p: Point| points.binary_search(&p).unwrap_or(0) as u32;
        let mut edges = Vec::new();
        for (line, cuts, step) in self.pieces(plane) {
            for pair in cuts.windows(2) {
                let [a, b] = [line.point(pair[0]), line.point(pair[1])].map(number);
                // Places rise along the direction, whose first component is positive.
                edges.push(([a, b], step));
            }
        }
        let flat: Vec<[i64; 2]> = points.iter().map(|&p| key.flat(p)).collect();
        let triangles = triangulate(&flat, &edges)?;
        Ok(outline(key.normal, &points, &flat, &triangles))
    }
}

/// Where two segments of a plane cross strictly inside both: `None` nowhere, `Some(None)` not at a whole point. `space` are the ends
/// of the first in space.
fn crossing(s: [[i64; 2]; 2], t: [[i64; 2]; 2], space: [Point; 2]) -> Option<Option<Point>> {
    let side = |a: [i64; 2], b: [i64; 2], c: [i64; 2]| {
        i128::from(b[0] - a[0]) * i128::from(c[1] - a[1]) - i128::from(b[1] - a[1]) * i128::from(c[0] - a[0])
    };
    let [p, q] = [side(t[0], t[1], s[0]), side(t[0], t[1], s[1])];
    let [u, v] = [side(s[0], s[1], t[0]), side(s[0], s[1], t[1])];
    if p.signum() * q.signum() >= 0 || u.signum() * v.signum() >= 0 {
        return None;
    }
    // The point divides the first segment as p : -q.
    let whole = |a: usize| {
        let n = p * i128::from(space[1][a] - space[0][a]);
        (n % (p - q) == 0).then(|| space[0][a] + (n / (p - q)) as i64)
    };
    Some(match (whole(0), whole(1), whole(2)) {
        (Some(x), Some(y), Some(z)) => Some([x, y, z]),
        _ => None,
    })
}
