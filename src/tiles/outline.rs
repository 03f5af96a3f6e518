//! The outline of what tiles show on a cube face, independent of how their polygons are cut.

use crate::cubes::Axis;
use std::collections::BTreeMap;

/// Directed segments on a face: each maximal straight piece once for each side it counts for, sorted. Coordinates are the two axes
/// after the face's own in the order x, y, z, x (so that the outline runs counter-clockwise seen from the axis's positive end).
pub type Outline = Vec<[[i32; 2]; 2]>;

/// A straight line in the plane: reduced direction and offset.
type Line = ([i64; 2], i64);

/// A point of the plane on the way along a line: change of the count there.
type Event = (i64, [i32; 2]);

/// The outline of the polygons that lie in the plane at `at` across `axis`, as seen from the positive end of the axis. Where
/// polygons touch edge to edge nothing is left, so the outline is that of their union.
pub fn outline<'a>(polygons: impl IntoIterator<Item = &'a Vec<[i32; 3]>>, axis: Axis, at: i32) -> Outline {
    let a = axis as usize;
    let mut lines: BTreeMap<Line, BTreeMap<Event, i32>> = BTreeMap::new();
    for polygon in polygons {
        if polygon.iter().any(|p| p[a] != at) {
            continue;
        }
        let points: Vec<[i32; 2]> = polygon.iter().map(|p| [p[(a + 1) % 3], p[(a + 2) % 3]]).collect();
        for (n, &from) in points.iter().enumerate() {
            add_edge(&mut lines, from, points[(n + 1) % points.len()]);
        }
    }
    let mut segments = Vec::new();
    for events in lines.values() {
        let (mut count, mut start) = (0, [0; 2]);
        for (&(_, point), &change) in events {
            if change == 0 {
                continue;
            }
            let ends = if count > 0 { [start, point] } else { [point, start] };
            segments.extend(std::iter::repeat_n(ends, i32::unsigned_abs(count) as usize));
            count += change;
            start = point;
        }
    }
    segments.sort_unstable();
    segments
}

/// Adds a directed edge to the line it lies on: counted up where it begins and down where it ends, along the line's direction.
fn add_edge(lines: &mut BTreeMap<Line, BTreeMap<Event, i32>>, from: [i32; 2], to: [i32; 2]) {
    let mut direction = [0, 1].map(|i| i64::from(to[i]) - i64::from(from[i]));
    let divisor = gcd(direction[0].unsigned_abs(), direction[1].unsigned_abs()) as i64;
    if divisor == 0 {
        return;
    }
    direction = direction.map(|d| d / divisor);
    let forward = direction > [0, 0];
    if !forward {
        direction = direction.map(|d| -d);
    }
    let along = |p: [i32; 2]| direction[0] * i64::from(p[0]) + direction[1] * i64::from(p[1]);
    let offset = direction[0] * i64::from(from[1]) - direction[1] * i64::from(from[0]);
    let events = lines.entry((direction, offset)).or_default();
    let sign = if forward { 1 } else { -1 };
    let [low, high] = if forward { [from, to] } else { [to, from] };
    *events.entry((along(low), low)).or_default() += sign;
    *events.entry((along(high), high)).or_default() -= sign;
}

fn gcd(a: u64, b: u64) -> u64 {
    if b == 0 { a } else { gcd(b, a % b) }
}

/// The same outline of a body on the other side of the face.
pub fn reversed(outline: &Outline) -> Outline {
    let mut turned: Outline = outline.iter().map(|[from, to]| [*to, *from]).collect();
    turned.sort_unstable();
    turned
}

/// What only the first and what only the second outline has, as segments of their own: the common parts of a straight line cancel,
/// also where one outline is cut differently.
pub fn difference(first: &Outline, second: &Outline) -> [Outline; 2] {
    let mut lines = BTreeMap::new();
    for [from, to] in first {
        add_edge(&mut lines, *from, *to);
    }
    for [from, to] in second {
        add_edge(&mut lines, *to, *from);
    }
    let [mut only_first, mut only_second] = [Vec::new(), Vec::new()];
    for events in lines.values() {
        let (mut count, mut start) = (0, [0; 2]);
        for (&(_, point), &change) in events {
            if change == 0 {
                continue;
            }
            // Whose segment it was shows in which of the two covers its middle in that direction.
            if count != 0 {
                let ends = if count > 0 { [start, point] } else { [point, start] };
                if covers(first, ends) { only_first.push(ends) } else { only_second.push([ends[1], ends[0]]) }
            }
            count += change;
            start = point;
        }
    }
    only_first.sort_unstable();
    only_second.sort_unstable();
    [only_first, only_second]
}

/// Whether a segment of the outline runs over all of `ends` in the same direction.
fn covers(outline: &Outline, [from, to]: [[i32; 2]; 2]) -> bool {
    let sub = |a: [i32; 2], b: [i32; 2]| [0, 1].map(|i| i64::from(a[i]) - i64::from(b[i]));
    outline.iter().any(|[p, q]| {
        let d = sub(*q, *p);
        [from, to].iter().all(|&e| {
            let v = sub(e, *p);
            let along = d[0] * v[0] + d[1] * v[1];
            d[0] * v[1] == d[1] * v[0] && along >= 0 && along <= d[0] * d[0] + d[1] * d[1]
        }) && d[0] * sub(to, from)[0] + d[1] * sub(to, from)[1] > 0
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn rectangle(x: [i32; 2], y: [i32; 2]) -> Vec<[i32; 3]> {
        vec![[x[0], y[0], 0], [x[1], y[0], 0], [x[1], y[1], 0], [x[0], y[1], 0]]
    }

    #[test]
    fn cuts_do_not_matter() {
        let whole = [rectangle([0, 9], [0, 6])];
        let parts = [rectangle([0, 4], [0, 6]), rectangle([4, 9], [0, 2]), rectangle([4, 9], [2, 6])];
        assert_eq!(outline(&whole, Axis::Z, 0), outline(&parts, Axis::Z, 0));
        assert_eq!(outline(&whole, Axis::Z, 0).len(), 4);
        assert!(outline(&whole, Axis::Z, 1).is_empty());
        let triangles = [vec![[0, 0, 0], [9, 0, 0], [9, 6, 0]], vec![[0, 0, 0], [9, 6, 0], [0, 6, 0]]];
        assert_eq!(outline(&whole, Axis::Z, 0), outline(&triangles, Axis::Z, 0));
    }

    #[test]
    fn a_face_seen_from_the_other_side_runs_the_other_way() {
        let top = outline(&[rectangle([0, 9], [0, 6])], Axis::Z, 0);
        let mut below = rectangle([0, 9], [0, 6]);
        below.reverse();
        assert_eq!(outline(&[below.clone()], Axis::Z, 0), reversed(&top));
        assert_ne!(outline(&[below], Axis::Z, 0), top);
    }

    #[test]
    fn the_difference_names_what_each_has_alone() {
        let narrow = outline(&[rectangle([0, 4], [0, 6])], Axis::Z, 0);
        let wide = outline(&[rectangle([0, 9], [0, 6])], Axis::Z, 0);
        let [only_narrow, only_wide] = difference(&narrow, &wide);
        assert_eq!(only_narrow, [[[4, 0], [4, 6]]]);
        assert_eq!(only_wide, [[[4, 0], [9, 0]], [[9, 0], [9, 6]], [[9, 6], [4, 6]]]);
        assert!(difference(&wide, &wide).iter().all(Vec::is_empty));
    }
}
