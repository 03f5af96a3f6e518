//! The surface of a set of blocks: what lies between two of them cancels, what remains is closed.

use std::collections::BTreeMap;

use super::super::Block;

/// A planar convex polygon, µm, counter-clockwise seen from outside; it may have corners on straight edges.
pub type Polygon3 = Vec<[i32; 3]>;

/// The boundary of disjoint blocks as polygons: faces that two blocks share are left out, in part or whole, and every corner that
/// lies on an edge of another polygon is a corner of that polygon too, so each directed edge occurs as often as its reverse.
///
/// The polygons' signed volume is the sum of the blocks' volumes. Blocks may be of any component: pass those of one component for its
/// solids, or of one component and octant. Corners are whole µm as the blocks' are; where faces of blocks cross off the
/// grid that tiles lie on, a corner is rounded to the next µm.
pub fn boundary(blocks: &[Block]) -> Vec<Polygon3> {
    let mut planes: BTreeMap<([i64; 3], i64), [Vec<Polygon3>; 2]> = BTreeMap::new();
    for face in blocks.iter().flat_map(Block::faces) {
        let Some((normal, offset, reversed)) = plane(&face) else { continue };
        planes.entry((normal, offset)).or_default()[usize::from(reversed)].push(face);
    }
    let mut polygons = Vec::new();
    for ((normal, _), [front, back]) in &planes {
        let plan = Projection::along(*normal, front.first().or(back.first()));
        let flat = |faces: &[Polygon3]| -> Vec<Vec<[i64; 2]>> { faces.iter().map(|f| plan.flatten(f)).collect() };
        let (front, back) = (flat(front), flat(back));
        for (faces, others, reversed) in [(&front, &back, false), (&back, &front, true)] {
            for face in faces {
                polygons.extend(difference(face, others).iter().map(|piece| plan.lift(piece, reversed)));
            }
        }
    }
    insert_corners(&mut polygons);
    polygons
}

/// Six times the volume that closed polygons enclose, µm3, exact.
pub fn six_volumes(polygons: &[Polygon3]) -> i128 {
    let fan = |polygon: &Polygon3| -> i128 {
        let at = |n: usize| polygon[n].map(i128::from);
        (1..polygon.len() - 1)
            .map(|n| {
                let [a, b, c] = [at(0), at(n), at(n + 1)];
                (0..3)
                    .map(|i| {
                        let (j, k) = ((i + 1) % 3, (i + 2) % 3);
                        a[i] * (b[j] * c[k] - b[k] * c[j])
                    })
                    .sum::<i128>()
            })
            .sum()
    };
    polygons.iter().map(fan).sum()
}

/// The plane of a face: normal without common factor, its first component that is not 0 positive; offset; and whether the face
/// looks against that normal. `None` without area.
fn plane(face: &[[i32; 3]]) -> Option<([i64; 3], i64, bool)> {
    let mut normal = [0i128; 3];
    for n in 1..face.len() - 1 {
        let edge = |m: usize| [0, 1, 2].map(|a| i128::from(face[m][a]) - i128::from(face[0][a]));
        let (u, v) = (edge(n), edge(n + 1));
        (0..3).for_each(|i| normal[i] += u[(i + 1) % 3] * v[(i + 2) % 3] - u[(i + 2) % 3] * v[(i + 1) % 3]);
    }
    let divisor = normal.iter().fold(0, |d, n| gcd(d, n.abs()));
    let reversed = normal.iter().find(|n| **n != 0)? < &0;
    let divisor = if reversed { -divisor } else { divisor };
    let normal = normal.map(|n| (n / divisor) as i64);
    let offset = (0..3).map(|a| normal[a] * i64::from(face[0][a])).sum();
    Some((normal, offset, reversed))
}

fn gcd(a: i128, b: i128) -> i128 {
    if b == 0 { a } else { gcd(b, a % b) }
}

/// A plane's two coordinates along which it is not edge-on, counter-clockwise as seen against its normal.
struct Projection {
    axes: [usize; 2],
    dropped: usize,
    normal: [i64; 3],
    at: [i64; 3],
}

impl Projection {
    fn along(normal: [i64; 3], point: Option<&Polygon3>) -> Projection {
        let dropped = [2, 0, 1].into_iter().find(|&a| normal[a] != 0).unwrap_or(2);
        let axes = [(dropped + 1) % 3, (dropped + 2) % 3];
        let axes = if normal[dropped] > 0 { axes } else { [axes[1], axes[0]] };
        let at = point.and_then(|p| p.first()).map_or([0; 3], |p| p.map(i64::from));
        Projection { axes, dropped, normal, at }
    }

    /// Counter-clockwise whichever way the face looks.
    fn flatten(&self, face: &[[i32; 3]]) -> Vec<[i64; 2]> {
        let mut flat: Vec<[i64; 2]> = face.iter().map(|p| self.axes.map(|a| i64::from(p[a]))).collect();
        if doubled_area(&flat) < 0 {
            flat.reverse();
        }
        flat
    }

    fn lift(&self, flat: &[[i64; 2]], reversed: bool) -> Polygon3 {
        let point = |p: &[i64; 2]| {
            let mut point = self.at;
            (0..2).for_each(|n| point[self.axes[n]] = p[n]);
            let rise: i128 =
                (0..2).map(|n| i128::from(self.normal[self.axes[n]]) * i128::from(p[n] - self.at[self.axes[n]])).sum();
            point[self.dropped] -= rounded(rise, i128::from(self.normal[self.dropped]));
            point.map(|c| c as i32)
        };
        let mut polygon: Polygon3 = flat.iter().map(point).collect();
        if reversed {
            polygon.reverse();
        }
        polygon
    }
}

fn rounded(value: i128, by: i128) -> i64 {
    let (value, by) = if by < 0 { (-value, -by) } else { (value, by) };
    (2 * value + by).div_euclid(2 * by) as i64
}

fn doubled_area(polygon: &[[i64; 2]]) -> i128 {
    let n = polygon.len();
    (0..n).map(|i| cross([0; 2], polygon[i], polygon[(i + 1) % n])).sum()
}

/// Twice the area of the triangle a, b, c.
fn cross(a: [i64; 2], b: [i64; 2], c: [i64; 2]) -> i128 {
    let d = |p: [i64; 2], axis: usize| i128::from(p[axis] - a[axis]);
    d(b, 0) * d(c, 1) - d(b, 1) * d(c, 0)
}

/// A convex polygon without what convex others cover of it, as convex pieces.
fn difference(face: &[[i64; 2]], others: &[Vec<[i64; 2]>]) -> Vec<Vec<[i64; 2]>> {
    let mut pieces = vec![face.to_vec()];
    for other in others {
        if !overlap(face, other) {
            continue;
        }
        let mut next = Vec::with_capacity(pieces.len());
        for piece in pieces {
            if overlap(&piece, other) {
                let mut rest = piece;
                for i in 0..other.len() {
                    let [inside, outside] = cut(&rest, other[i], other[(i + 1) % other.len()]);
                    next.extend((doubled_area(&outside) > 0).then_some(outside));
                    rest = inside;
                }
            } else {
                next.push(piece);
            }
        }
        pieces = next;
    }
    pieces
}

/// Whether two convex polygons share area.
fn overlap(first: &[[i64; 2]], second: &[[i64; 2]]) -> bool {
    let separates = |a: &[[i64; 2]], b: &[[i64; 2]]| {
        (0..a.len()).any(|i| b.iter().all(|p| cross(a[i], a[(i + 1) % a.len()], *p) <= 0))
    };
    !separates(first, second) && !separates(second, first)
}

/// The parts of a convex polygon left and right of the line from `a` to `b`.
fn cut(polygon: &[[i64; 2]], a: [i64; 2], b: [i64; 2]) -> [Vec<[i64; 2]>; 2] {
    let mut parts = [Vec::new(), Vec::new()];
    let side: Vec<i128> = polygon.iter().map(|p| cross(a, b, *p)).collect();
    for i in 0..polygon.len() {
        let j = (i + 1) % polygon.len();
        if side[i] >= 0 {
            parts[0].push(polygon[i]);
        }
        if side[i] <= 0 {
            parts[1].push(polygon[i]);
        }
        if side[i].signum() * side[j].signum() < 0 {
            let at = [0, 1].map(|axis| {
                let [p, q] = [i128::from(polygon[i][axis]), i128::from(polygon[j][axis])];
                rounded(p * side[j] - q * side[i], side[j] - side[i])
            });
            parts.iter_mut().for_each(|part| part.push(at));
        }
    }
    parts
}

/// Makes every corner that lies on an edge a corner there.
fn insert_corners(polygons: &mut [Polygon3]) {
    let mut corners: Vec<[i32; 3]> = polygons.iter().flatten().copied().collect();
    corners.sort_unstable();
    corners.dedup();
    for polygon in polygons {
        let n = polygon.len();
        let mut whole = Polygon3::with_capacity(n);
        for i in 0..n {
            let (a, b) = (polygon[i], polygon[(i + 1) % n]);
            whole.push(a);
            let (low, high) = (a.min(b), a.max(b));
            let range = corners.partition_point(|p| *p <= low)..corners.partition_point(|p| *p < high);
            let mut between: Vec<[i32; 3]> = corners[range].iter().copied().filter(|p| on_edge(a, b, *p)).collect();
            // Sorted corners run from the lower end to the higher one.
            if a > b {
                between.reverse();
            }
            whole.extend(between);
        }
        *polygon = whole;
    }
}

/// Whether p lies on the line through a and b; it is known to lie between them in the order of coordinates.
fn on_edge(a: [i32; 3], b: [i32; 3], p: [i32; 3]) -> bool {
    let d = |q: [i32; 3]| [0, 1, 2].map(|axis| i64::from(q[axis]) - i64::from(a[axis]));
    let (u, v) = (d(b), d(p));
    (0..3).all(|i| u[(i + 1) % 3] * v[(i + 2) % 3] == u[(i + 2) % 3] * v[(i + 1) % 3])
}
