//! Supporting planes and lines of faces, and the signed intervals that edges leave on a line when equal and opposite ones cancel.

use rustc_hash::FxHashMap;

/// A position in whole micrometres.
pub(super) type Point = [i64; 3];

pub(super) fn sub(a: Point, b: Point) -> Point {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

pub(super) fn cross(a: Point, b: Point) -> [i128; 3] {
    let [a, b] = [a.map(i128::from), b.map(i128::from)];
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

/// The shortest whole vector along `v`, first non-zero component positive, and whether it was turned round; `None` for zero.
pub(super) fn primitive(v: [i128; 3]) -> Option<(Point, bool)> {
    let axis = v.iter().position(|&c| c != 0)?;
    let turned = v[axis] < 0;
    if v[(axis + 1) % 3] == 0 && v[(axis + 2) % 3] == 0 {
        let mut unit = [0; 3];
        unit[axis] = 1;
        return Some((unit, turned));
    }
    let divisor = gcd(gcd(v[0].unsigned_abs(), v[1].unsigned_abs()), v[2].unsigned_abs()) as i128;
    Some((v.map(|c| ((if turned { -c } else { c }) / divisor) as i64), turned))
}

fn gcd(mut a: u128, mut b: u128) -> u128 {
    while b != 0 {
        // Nearly all lengths fit half the width, where division is many times faster.
        if let (Ok(mut x), Ok(mut y)) = (u64::try_from(a), u64::try_from(b)) {
            while y != 0 {
                (x, y) = (y, x % y);
            }
            return u128::from(x);
        }
        (a, b) = (b, a % b);
    }
    a
}

/// A plane: its primitive normal and the product of the normal with any of its points.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub(super) struct PlaneKey {
    pub normal: Point,
    pub offset: i128,
}

impl PlaneKey {
    /// The plane of a polygon; `None` when it has no area.
    pub fn of(polygon: &[Point]) -> Option<PlaneKey> {
        let mut sum = [0i128; 3];
        for i in 1..polygon.len().saturating_sub(1) {
            let c = cross(sub(polygon[i], polygon[0]), sub(polygon[i + 1], polygon[0]));
            (0..3).for_each(|a| sum[a] += c[a]);
        }
        let (normal, _) = primitive(sum)?;
        Some(PlaneKey::through(normal, polygon[0]))
    }

    /// The plane with a primitive normal through a point.
    pub fn through(normal: Point, p: Point) -> PlaneKey {
        PlaneKey { normal, offset: (0..3).map(|a| i128::from(normal[a]) * i128::from(p[a])).sum() }
    }

    /// A point of the plane seen against its normal: two of its coordinates, so chosen that turning directions are kept.
    pub fn flat(&self, p: Point) -> [i64; 2] {
        let n = self.normal;
        let axis = (0..3).max_by_key(|&a| (n[a].unsigned_abs(), a)).unwrap_or(2);
        let [u, v] = [p[(axis + 1) % 3], p[(axis + 2) % 3]];
        if n[axis] > 0 { [u, v] } else { [v, u] }
    }
}

/// A line in space: primitive direction and moment of any of its points about the origin (Pluecker).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub(super) struct LineKey {
    pub direction: Point,
    moment: [i128; 3],
}

impl LineKey {
    pub fn through(direction: Point, p: Point) -> LineKey {
        LineKey { direction, moment: cross(p, direction) }
    }
}

/// A change of the sum of edges of one plane along a line.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
struct Event {
    plane: u32,
    at: i64,
    delta: i32,
}

/// A stretch of a line that bounds something in a plane: what lies to its left in that plane less what lies to its right.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Interval {
    pub plane: u32,
    pub from: i64,
    pub to: i64,
    pub step: i32,
}

/// What remains on a line. Places are coordinates along the first axis that its direction does not stand across.
#[derive(Clone, Debug)]
pub(super) struct Line {
    pub direction: Point,
    axis: usize,
    origin: Point,
    events: Vec<Event>,
    pub intervals: Vec<Interval>,
    /// Places at which every interval is cut, ascending.
    pub cuts: Vec<i64>,
}

impl Line {
    /// The place of one of its points.
    pub fn place(&self, p: Point) -> i64 {
        p[self.axis]
    }

    /// The point at a place that is a point of whole coordinates.
    pub fn point(&self, place: i64) -> Point {
        let n = (place - self.origin[self.axis]) / self.direction[self.axis];
        [0, 1, 2].map(|a| self.origin[a] + n * self.direction[a])
    }

    /// Sums the edges of each plane; edges that continue each other join, equal and opposite ones vanish.
    fn settle(&mut self) {
        self.events.sort_unstable();
        let (mut step, mut i) = (0, 0);
        while i < self.events.len() {
            let Event { plane, at, .. } = self.events[i];
            let before = step;
            while i < self.events.len() && (self.events[i].plane, self.events[i].at) == (plane, at) {
                step += self.events[i].delta;
                i += 1;
            }
            if step != before {
                if before != 0
                    && let Some(last) = self.intervals.last_mut()
                {
                    last.to = at;
                }
                if step != 0 {
                    self.intervals.push(Interval { plane, from: at, to: at, step });
                }
            }
        }
        self.events = Vec::new();
        self.cuts = self.intervals.iter().flat_map(|i| [i.from, i.to]).collect();
        self.cuts.sort_unstable();
        self.cuts.dedup();
    }

    /// The pieces of an interval between neighbouring cuts.
    pub fn pieces(&self, interval: &Interval) -> &[i64] {
        let first = self.cuts.partition_point(|&c| c < interval.from);
        let last = self.cuts.partition_point(|&c| c <= interval.to);
        &self.cuts[first..last]
    }

    /// Adds a cut; whether it was not there.
    pub fn cut(&mut self, place: i64) -> bool {
        match self.cuts.binary_search(&place) {
            Ok(_) => false,
            Err(i) => {
                self.cuts.insert(i, place);
                true
            }
        }
    }
}

/// All lines on which faces have edges.
#[derive(Clone, Debug, Default)]
pub(super) struct Lines {
    known: FxHashMap<LineKey, u32>,
    pub all: Vec<Line>,
}

impl Lines {
    /// Adds the directed edge from `a` to `b` of a face in a plane.
    pub fn add(&mut self, plane: u32, a: Point, b: Point) {
        let Some((direction, turned)) = primitive(sub(b, a).map(i128::from)) else { return };
        let key = LineKey::through(direction, a);
        let all = &mut self.all;
        let index = *self.known.entry(key).or_insert_with(|| {
            let axis = direction.iter().position(|&c| c != 0).unwrap_or(0);
            all.push(Line { direction, axis, origin: a, events: Vec::new(), intervals: Vec::new(), cuts: Vec::new() });
            all.len() as u32 - 1
        });
        let line = &mut all[index as usize];
        let sign = if turned { -1 } else { 1 };
        // Along the line's direction the sum rises by `sign` at the lower end and falls back at the upper end.
        let [low, high] = if turned { [b, a] } else { [a, b] };
        line.events.push(Event { plane, at: low[line.axis], delta: sign });
        line.events.push(Event { plane, at: high[line.axis], delta: -sign });
    }

    /// Settles every line.
    pub fn settle(&mut self) {
        self.all.iter_mut().for_each(Line::settle);
    }

    /// The line of a direction through a point.
    pub fn find(&self, direction: Point, p: Point) -> Option<usize> {
        self.known.get(&LineKey::through(direction, p)).map(|&i| i as usize)
    }
}
