//! Exact hypervolume: the measure of the objective space that a front dominates, up to a reference point.

/// Feasible evaluations from which the reference point is taken when a brief gives none (HOUSE.md section 1).
pub const REFERENCE_SAMPLE: usize = 200;

/// A reference point from feasible objective vectors: per objective the worst value plus 10 % of the range (of the
/// magnitude where the range is zero). `None` without vectors.
pub fn reference_point<'a>(points: impl IntoIterator<Item = &'a [f64]>) -> Option<Vec<f64>> {
    let mut ranges: Vec<[f64; 2]> = Vec::new();
    for point in points {
        if ranges.is_empty() {
            ranges = point.iter().map(|&v| [v, v]).collect();
        }
        for ([low, high], &v) in ranges.iter_mut().zip(point) {
            *low = low.min(v);
            *high = high.max(v);
        }
    }
    let margin = |[low, high]: [f64; 2]| if high > low { high - low } else { high.abs().max(1e-9) };
    (!ranges.is_empty()).then(|| ranges.into_iter().map(|r| r[1] + 0.1 * margin(r)).collect())
}

/// Hypervolume of minimised `points` up to `reference`: points that are not better than it everywhere count nothing.
///
/// Two objectives are swept in order of the first. Three are swept along the last, the area of the section being updated
/// as each point enters its staircase (Fonseca, Paquete, Lopez-Ibanez 2006). More are sliced along the last, recursively
/// (While et al. 2006, "A faster algorithm for calculating hypervolume", HSO).
pub fn hypervolume(points: &[&[f64]], reference: &[f64]) -> f64 {
    let inside = |p: &&&[f64]| p.len() == reference.len() && p.iter().zip(reference).all(|(v, r)| v < r);
    let points: Vec<&[f64]> = points.iter().filter(inside).copied().collect();
    slice(points, reference.len(), reference)
}

/// Hypervolume in the first `dimensions` objectives.
fn slice(mut points: Vec<&[f64]>, dimensions: usize, reference: &[f64]) -> f64 {
    match dimensions {
        0 => 0.0,
        1 => points.iter().map(|p| reference[0] - p[0]).fold(0.0, f64::max),
        2 => area(points, reference),
        3 => volume(points, reference),
        _ => {
            let last = dimensions - 1;
            points.sort_by(|a, b| a[last].total_cmp(&b[last]));
            let mut front: Vec<&[f64]> = Vec::new();
            let mut volume = 0.0;
            for (i, &point) in points.iter().enumerate() {
                let covers = |a: &[f64], b: &[f64]| a[..last].iter().zip(&b[..last]).all(|(x, y)| x <= y);
                if !front.iter().any(|old| covers(old, point)) {
                    front.retain(|old| !covers(point, old));
                    front.push(point);
                }
                let top = points.get(i + 1).map_or(reference[last], |next| next[last]);
                if top > point[last] {
                    volume += (top - point[last]) * slice(front.clone(), last, reference);
                }
            }
            volume
        }
    }
}

/// Volume dominated in the first three objectives.
fn volume(mut points: Vec<&[f64]>, reference: &[f64]) -> f64 {
    points.sort_by(|a, b| a[2].total_cmp(&b[2]));
    // The section as a staircase: x ascending, y descending.
    let mut stairs: Vec<[f64; 2]> = Vec::new();
    let (mut area, mut sum) = (0.0, 0.0);
    for (i, point) in points.iter().enumerate() {
        area += enter(&mut stairs, [point[0], point[1]], reference);
        let top = points.get(i + 1).map_or(reference[2], |next| next[2]);
        sum += (top - point[2]) * area;
    }
    sum
}

/// Puts a corner in a staircase and returns the area that it adds.
fn enter(stairs: &mut Vec<[f64; 2]>, [x, y]: [f64; 2], reference: &[f64]) -> f64 {
    let first = stairs.partition_point(|s| s[0] < x);
    let ceiling = if first == 0 { reference[1] } else { stairs[first - 1][1] };
    if ceiling <= y || stairs.get(first).is_some_and(|s| s[0] == x && s[1] <= y) {
        return 0.0;
    }
    let last = first + stairs[first..].partition_point(|s| s[1] >= y);
    let (mut added, mut left, mut height) = (0.0, x, ceiling);
    for step in &stairs[first..last] {
        added += (step[0] - left) * (height - y);
        (left, height) = (step[0], step[1]);
    }
    let right = stairs.get(last).map_or(reference[0], |s| s[0]);
    added += (right - left) * (height - y);
    stairs.splice(first..last, [[x, y]]);
    added
}

/// Area dominated in the first two objectives.
fn area(mut points: Vec<&[f64]>, reference: &[f64]) -> f64 {
    points.sort_by(|a, b| a[0].total_cmp(&b[0]).then(a[1].total_cmp(&b[1])));
    let mut lowest = reference[1];
    let mut sum = 0.0;
    for point in points {
        if point[1] < lowest {
            sum += (reference[0] - point[0]) * (lowest - point[1]);
            lowest = point[1];
        }
    }
    sum
}
