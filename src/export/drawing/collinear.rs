//! Lines joined where they lie on one straight line, so that no seam between tiles shows.

use std::collections::BTreeMap;

/// A line from end to end, m.
pub type Segment = [[f64; 2]; 2];

/// Gaps up to this are closed, m.
const GAP_M: f64 = 0.012;

/// The straight line a segment lies on, to a thousandth in direction and 2 mm in place.
fn key([p, q]: Segment) -> Option<([i64; 3], [f64; 2])> {
    let d = [q[0] - p[0], q[1] - p[1]];
    let length = d[0].hypot(d[1]);
    if !(length.is_finite() && length > 1e-9) {
        return None;
    }
    let mut d = d.map(|c| c / length);
    if d[0] < -1e-9 || (d[0].abs() <= 1e-9 && d[1] < 0.0) {
        d = d.map(|c| -c);
    }
    let offset = d[0] * p[1] - d[1] * p[0];
    Some(([(d[0] * 1e3).round() as i64, (d[1] * 1e3).round() as i64, (offset * 500.0).round() as i64], d))
}

/// The union of segments by rank: on each straight line what has a lower rank covers what has a higher one. Segments come out by rank
/// and line, none overlapping another of its line.
pub fn join(lines: &[(u8, Segment)]) -> Vec<(u8, Segment)> {
    type Found = ([f64; 2], [f64; 2], Vec<(u8, [f64; 2])>);
    let mut groups: BTreeMap<[i64; 3], Found> = BTreeMap::new();
    for &(rank, segment) in lines {
        let Some((key, d)) = key(segment) else { continue };
        let group = groups.entry(key).or_insert_with(|| (segment[0], d, Vec::new()));
        let along = |p: [f64; 2]| (p[0] - group.0[0]) * group.1[0] + (p[1] - group.0[1]) * group.1[1];
        let (a, b) = (along(segment[0]), along(segment[1]));
        group.2.push((rank, [a.min(b), a.max(b)]));
    }
    let mut joined = Vec::new();
    for (origin, d, mut spans) in groups.into_values() {
        spans.sort_by(|a, b| a.0.cmp(&b.0).then(a.1[0].total_cmp(&b.1[0])).then(a.1[1].total_cmp(&b.1[1])));
        let mut covered: Vec<[f64; 2]> = Vec::new();
        let mut start = 0;
        while start < spans.len() {
            let rank = spans[start].0;
            let end = start + spans[start..].iter().take_while(|s| s.0 == rank).count();
            let own = union(spans[start..end].iter().map(|s| s.1));
            for piece in own.iter().flat_map(|&s| without(s, &covered)) {
                let at = |t: f64| [origin[0] + d[0] * t, origin[1] + d[1] * t];
                joined.push((rank, [at(piece[0]), at(piece[1])]));
            }
            covered.extend(own);
            covered.sort_by(|a, b| a[0].total_cmp(&b[0]));
            covered = union(covered.iter().copied());
            start = end;
        }
    }
    joined
}

/// Ascending spans joined where they touch.
fn union(spans: impl Iterator<Item = [f64; 2]>) -> Vec<[f64; 2]> {
    let mut joined: Vec<[f64; 2]> = Vec::new();
    for [a, b] in spans {
        match joined.last_mut() {
            Some(last) if a <= last[1] + GAP_M => last[1] = last[1].max(b),
            _ => joined.push([a, b]),
        }
    }
    joined
}

/// What ascending spans leave of one.
fn without([start, end]: [f64; 2], covered: &[[f64; 2]]) -> Vec<[f64; 2]> {
    let mut left = Vec::new();
    let mut from = start;
    for c in covered.iter().filter(|c| c[1] > start && c[0] < end) {
        if c[0] > from + GAP_M {
            left.push([from, c[0]]);
        }
        from = from.max(c[1]);
    }
    if end > from + GAP_M {
        left.push([from, end]);
    }
    left
}

/// Directed segments less those that run the other way in the same place: what is left bounds the union of the areas on their left.
/// The second list holds what was cancelled: lines between one area and the next.
pub fn cancel(lines: &[Segment]) -> [Vec<Segment>; 2] {
    type Found = ([f64; 2], [f64; 2], Vec<(f64, i32)>);
    let mut groups: BTreeMap<[i64; 3], Found> = BTreeMap::new();
    for &segment in lines {
        let Some((key, d)) = key(segment) else { continue };
        let group = groups.entry(key).or_insert_with(|| (segment[0], d, Vec::new()));
        let along = |p: [f64; 2]| (p[0] - group.0[0]) * group.1[0] + (p[1] - group.0[1]) * group.1[1];
        let (a, b) = (along(segment[0]), along(segment[1]));
        // In bits: forth counts in thousands, back in ones, so that one sum tells both.
        let step = if a < b { 1000 } else { 1 };
        group.2.push((a.min(b), step));
        group.2.push((a.max(b), -step));
    }
    let mut found = [Vec::new(), Vec::new()];
    for (origin, d, mut events) in groups.into_values() {
        events.sort_by(|a, b| a.0.total_cmp(&b.0));
        let at = |t: f64| [origin[0] + d[0] * t, origin[1] + d[1] * t];
        let mut sum = 0;
        for pair in 0..events.len().saturating_sub(1) {
            sum += events[pair].1;
            let [a, b] = [events[pair].0, events[pair + 1].0];
            let [forth, back] = [sum / 1000, sum % 1000];
            if b - a < 2e-4 || forth + back == 0 {
                continue;
            }
            found[usize::from(forth == back)].push([at(a), at(b)]);
        }
    }
    found.map(|list| join(&list.into_iter().map(|s| (0, s)).collect::<Vec<_>>()).into_iter().map(|(_, s)| s).collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn touching_segments_become_one_and_the_heavier_covers_the_lighter() {
        let lines = [
            (1, [[0.0, 0.0], [0.9, 0.0]]),
            (1, [[1.8, 0.0], [0.9, 0.0]]),
            (0, [[0.45, 0.0], [1.35, 0.0]]),
            (1, [[0.0, 0.5], [1.0, 0.5]]),
        ];
        let joined = join(&lines);
        let spans: Vec<(u8, [f64; 2])> = joined.iter().map(|(r, [p, q])| (*r, [p[0], q[0]])).collect();
        assert_eq!(spans, [(0, [0.45, 1.35]), (1, [0.0, 0.45]), (1, [1.35, 1.8]), (1, [0.0, 1.0])]);
    }

    #[test]
    fn two_squares_that_touch_have_one_outline() {
        let square = |x: f64, w: f64| {
            let c = [[x, 0.0], [x + w, 0.0], [x + w, 1.0], [x, 1.0]];
            [0, 1, 2, 3].map(|i| [c[i], c[(i + 1) % 4]])
        };
        let [outline, between] = cancel(&[square(0.0, 1.0), square(1.0, 2.0)].concat());
        let length = |l: &[Segment]| l.iter().map(|[p, q]| (q[0] - p[0]).hypot(q[1] - p[1])).sum::<f64>();
        assert!((length(&outline) - 8.0).abs() < 1e-9 && (length(&between) - 1.0).abs() < 1e-9);
        assert_eq!(outline.len(), 4, "{outline:?}");
    }
}
