//! The survival of NSGA-III: niches around reference directions (Deb, Jain 2014, "An evolutionary many-objective optimization algorithm
//! using reference-point-based nondominated sorting approach, part I"; for constraints Jain, Deb 2014, part II).

use super::Score;
use super::sorting::sort_fronts;

/// Reference directions and what normalising has learnt.
#[derive(Clone, Debug)]
pub struct Niches {
    directions: Vec<Vec<f64>>,
    ideal: Vec<f64>,
    /// Extreme points of the last batch, one per objective.
    extremes: Vec<Vec<f64>>,
    /// Worst value of each objective in the first front when it was last used.
    worst: Vec<f64>,
}

/// Das and Dennis' (1998) directions: all points of the unit simplex whose coordinates are multiples of 1/`divisions`.
pub fn das_dennis(objectives: usize, divisions: usize) -> Vec<Vec<f64>> {
    fn fill(left: usize, point: &mut Vec<usize>, objectives: usize, out: &mut Vec<Vec<usize>>) {
        if point.len() + 1 == objectives {
            point.push(left);
            out.push(point.clone());
            point.pop();
            return;
        }
        for i in 0..=left {
            point.push(i);
            fill(left - i, point, objectives, out);
            point.pop();
        }
    }
    let mut out = Vec::new();
    if objectives > 0 {
        fill(divisions, &mut Vec::new(), objectives, &mut out);
    }
    let share = |v: usize| v as f64 / divisions.max(1) as f64;
    out.into_iter().map(|p| p.into_iter().map(share).collect()).collect()
}

/// The most divisions with which there are at most `count` directions, at least 1.
fn divisions(objectives: usize, count: usize) -> usize {
    // C(p + m - 1, m - 1) directions.
    let directions = |p: usize| (1..objectives).fold(1.0, |c, i| c * (p + i) as f64 / i as f64);
    let mut p = 1;
    while objectives > 1 && directions(p + 1) <= count as f64 + 0.5 {
        p += 1;
    }
    p
}

impl Niches {
    /// At most `count` directions (but one per objective at least).
    pub fn new(objectives: usize, count: usize) -> Self {
        let directions = das_dennis(objectives, divisions(objectives, count));
        let unknown = vec![f64::INFINITY; objectives];
        Niches { directions, ideal: unknown.clone(), extremes: Vec::new(), worst: vec![f64::NEG_INFINITY; objectives] }
    }

    /// The reference directions.
    pub fn directions(&self) -> &[Vec<f64>] {
        &self.directions
    }

    /// Indices of the `count` scores that survive: feasible ones first, by front and niche; then the least violated.
    pub fn survivors(&mut self, scores: &[&Score], count: usize) -> Vec<usize> {
        let fronts = sort_fronts(scores);
        let mut kept: Vec<usize> = Vec::with_capacity(count);
        let mut feasible_fronts = fronts.iter().filter(|f| f.iter().all(|&i| scores[i].is_feasible())).peekable();
        let Some(first) = feasible_fronts.peek() else {
            return fronts.into_iter().flatten().take(count).collect();
        };
        let mut last: &[usize] = &[];
        let first: Vec<usize> = first.to_vec();
        for front in feasible_fronts {
            if kept.len() + front.len() <= count {
                kept.extend_from_slice(front);
            } else {
                last = front;
                break;
            }
        }
        let considered: Vec<usize> = kept.iter().chain(last).copied().collect();
        let points: Vec<&[f64]> = considered.iter().map(|&i| scores[i].objectives.as_slice()).collect();
        let front: Vec<&[f64]> = first.iter().map(|&i| scores[i].objectives.as_slice()).collect();
        let intercepts = self.normalise(&points, &front);
        if !last.is_empty() {
            let near: Vec<(usize, f64)> = points.iter().map(|p| self.nearest(p, &intercepts)).collect();
            self.fill(&mut kept, last, &near, count);
        }
        let rest = fronts.iter().flatten().filter(|&&i| !scores[i].is_feasible());
        let room = count.saturating_sub(kept.len());
        kept.extend(rest.take(room));
        kept
    }

    /// Updates ideal and extreme points, and returns the intercepts of the plane through the extreme points (relative to the ideal
    /// point); of the worst values where there is no such plane.
    fn normalise(&mut self, points: &[&[f64]], front: &[&[f64]]) -> Vec<f64> {
        let m = self.ideal.len();
        for point in points {
            (0..m).for_each(|i| self.ideal[i] = self.ideal[i].min(point[i]));
        }
        self.worst = (0..m).map(|i| front.iter().map(|p| p[i]).fold(f64::NEG_INFINITY, f64::max)).collect();
        let candidates: Vec<Vec<f64>> = self.extremes.drain(..).chain(front.iter().map(|p| p.to_vec())).collect();
        // Achievement scalarising function along each axis.
        let asf = |p: &[f64], axis: usize| {
            (0..m).map(|i| (p[i] - self.ideal[i]) * if i == axis { 1.0 } else { 1e6 }).fold(f64::NEG_INFINITY, f64::max)
        };
        for axis in 0..m {
            let best = candidates.iter().min_by(|a, b| asf(a, axis).total_cmp(&asf(b, axis)));
            self.extremes.extend(best.cloned());
        }
        let shifted: Vec<Vec<f64>> =
            self.extremes.iter().map(|e| e.iter().zip(&self.ideal).map(|(v, z)| v - z).collect()).collect();
        let span: Vec<f64> = self.worst.iter().zip(&self.ideal).map(|(w, z)| w - z).collect();
        let plane = solve(shifted, vec![1.0; m]);
        let good = |x: &f64| x.is_finite() && *x > 1e-6;
        let intercepts: Option<Vec<f64>> = plane.map(|p| p.iter().map(|v| 1.0 / v).collect());
        let intercepts =
            intercepts.filter(|a| a.iter().zip(&span).all(|(a, s)| good(a) && *a <= s * (1.0 + 1e-9) + 1e-6));
        intercepts.unwrap_or(span).into_iter().map(|v| if good(&v) { v } else { 1e-6_f64.max(v) }).collect()
    }

    /// The direction nearest to a point, and its distance from it.
    fn nearest(&self, point: &[f64], intercepts: &[f64]) -> (usize, f64) {
        let scaled: Vec<f64> = (0..point.len()).map(|i| (point[i] - self.ideal[i]) / intercepts[i]).collect();
        let mut best = (0, f64::INFINITY);
        for (d, direction) in self.directions.iter().enumerate() {
            let norm: f64 = direction.iter().map(|v| v * v).sum();
            let along: f64 = scaled.iter().zip(direction).map(|(s, v)| s * v).sum::<f64>() / norm;
            let across: f64 = scaled.iter().zip(direction).map(|(s, v)| (s - along * v).powi(2)).sum();
            if across < best.1 {
                best = (d, across);
            }
        }
        best
    }

    /// Fills up from the last front: again and again the direction with the fewest members takes its nearest candidate (any, once it has a
    /// member; the lowest index, where the original draws at random).
    fn fill(&self, kept: &mut Vec<usize>, last: &[usize], near: &[(usize, f64)], count: usize) {
        let mut members = vec![0usize; self.directions.len()];
        near[..kept.len()].iter().for_each(|n| members[n.0] += 1);
        let first = kept.len();
        let mut left: Vec<Vec<usize>> = vec![Vec::new(); self.directions.len()];
        (0..last.len()).for_each(|i| left[near[first + i].0].push(i));
        left.iter_mut().for_each(|l| l.sort_by(|a, b| near[first + b].1.total_cmp(&near[first + a].1).then(b.cmp(a))));
        while kept.len() < count {
            let open = (0..left.len()).filter(|&d| !left[d].is_empty()).min_by_key(|&d| (members[d], d));
            let Some(direction) = open else { break };
            kept.extend(left[direction].pop().map(|i| last[i]));
            members[direction] += 1;
        }
    }
}

/// Solves a small linear system by elimination with row pivots; `None` when it is singular.
fn solve(mut a: Vec<Vec<f64>>, mut b: Vec<f64>) -> Option<Vec<f64>> {
    let n = b.len();
    for column in 0..n {
        let pivot = (column..n).max_by(|&i, &j| a[i][column].abs().total_cmp(&a[j][column].abs()))?;
        let size: f64 = a[pivot].iter().map(|v| v.abs()).fold(0.0, f64::max);
        if a[pivot][column].abs() <= 1e-12 * size.max(f64::MIN_POSITIVE) {
            return None;
        }
        a.swap(column, pivot);
        b.swap(column, pivot);
        let (pivot_row, pivot_value) = (a[column].clone(), b[column]);
        for row in (0..n).filter(|row| *row != column) {
            let factor = a[row][column] / pivot_row[column];
            a[row].iter_mut().zip(&pivot_row).for_each(|(v, p)| *v -= factor * p);
            b[row] -= factor * pivot_value;
        }
    }
    Some((0..n).map(|i| b[i] / a[i][i]).collect())
}
