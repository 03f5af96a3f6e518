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
/// Two objectives are swept in order of the first; more are sliced along the last (While et al. 2006, "A faster algorithm
/// for calculating hypervolume", HSO), so that three cost O(n^2) with a sorted insertion per slice.
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
