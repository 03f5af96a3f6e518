//! What a point adds to the hypervolume of others: which to keep of too many, and which to show of a large front.

use super::hypervolume::hypervolume;
use super::nd_tree::covers;
use std::cmp::Reverse;
use std::collections::BinaryHeap;

/// The volume that `point` dominates and none of `others` does, up to `reference` (minimised sense). What of the others matters is
/// their part within the box of the point: clipped to it, few are left (While, Bradstreet, Barone 2012, the limit set of WFG).
pub fn exclusive<'p>(point: &[f64], others: impl Iterator<Item = &'p [f64]>, reference: &[f64]) -> f64 {
    let own: f64 = point.iter().zip(reference).map(|(p, r)| (r - p).max(0.0)).product();
    if own <= 0.0 {
        return 0.0;
    }
    let mut limit: Vec<Vec<f64>> = Vec::new();
    let mut clipped = vec![0.0; point.len()];
    for other in others {
        let mut inside = true;
        for ((c, p), (o, r)) in clipped.iter_mut().zip(point).zip(other.iter().zip(reference)) {
            *c = p.max(*o);
            inside &= *c < *r;
        }
        if inside && !limit.iter().any(|l| covers(l, &clipped)) {
            limit.retain(|l| !covers(&clipped, l));
            limit.push(clipped.clone());
        }
    }
    let slices: Vec<&[f64]> = limit.iter().map(Vec::as_slice).collect();
    (own - hypervolume(&slices, reference)).max(0.0)
}

/// What each of some points adds to the hypervolume of the others.
pub fn contributions(points: &[&[f64]], reference: &[f64]) -> Vec<f64> {
    (0..points.len()).map(|i| exclusive(points[i], all_but(points, i), reference)).collect()
}

fn all_but<'p>(points: &'p [&'p [f64]], out: usize) -> impl Iterator<Item = &'p [f64]> {
    points.iter().enumerate().filter(move |(j, _)| *j != out).map(|(_, p)| *p)
}

/// A volume as an order: larger first, then the lower index.
#[derive(PartialEq)]
struct Ranked(f64, usize);

impl Eq for Ranked {}

impl PartialOrd for Ranked {
    fn partial_cmp(&self, other: &Self) -> Option<std::cmp::Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Ranked {
    fn cmp(&self, other: &Self) -> std::cmp::Ordering {
        self.0.total_cmp(&other.0).then(other.1.cmp(&self.1))
    }
}

/// Most objectives for which a point's worth is the volume that it adds; beyond, exact volumes cost more than they tell.
pub const MOST_BY_VOLUME: usize = 4;

/// Indices of `count` points left when, again and again, the one of least worth is taken out; ascending, each with its worth: the
/// hypervolume that it adds to the others or, for more than four objectives, its distance from the nearest of them over the sides of
/// the box to the reference point (the truncation of SPEA2).
///
/// The worth of a point only grows as others leave, so a value computed earlier is a lower bound and most need not be computed again.
pub fn without_least(points: &[&[f64]], reference: &[f64], count: usize) -> Vec<(usize, f64)> {
    let mut alive = vec![true; points.len()];
    let low: Vec<f64> =
        (0..reference.len()).map(|m| points.iter().map(|p| p[m]).fold(f64::INFINITY, f64::min)).collect();
    let worth = |i: usize, alive: &[bool]| {
        let others = points.iter().zip(alive).enumerate().filter(|(j, (_, a))| *j != i && **a).map(|(_, (p, _))| *p);
        if reference.len() <= MOST_BY_VOLUME {
            exclusive(points[i], others, reference)
        } else {
            others.map(|o| apart(points[i], o, &low, reference)).fold(f64::INFINITY, f64::min)
        }
    };
    let mut heap: BinaryHeap<Reverse<Ranked>> =
        (0..points.len()).map(|i| Reverse(Ranked(worth(i, &alive), i))).collect();
    // How many were left when each value was computed.
    let mut fresh = vec![points.len(); points.len()];
    let mut left = points.len();
    while left > count {
        let Some(Reverse(Ranked(_, i))) = heap.pop() else { break };
        if fresh[i] == left {
            alive[i] = false;
            left -= 1;
        } else {
            fresh[i] = left;
            heap.push(Reverse(Ranked(worth(i, &alive), i)));
        }
    }
    (0..points.len()).filter(|&i| alive[i]).map(|i| (i, worth(i, &alive))).collect()
}

/// Squared distance over the sides of the box from `low` to `high`.
fn apart(a: &[f64], b: &[f64], low: &[f64], high: &[f64]) -> f64 {
    let side = |m: usize| (high[m] - low[m]).max(f64::MIN_POSITIVE);
    (0..a.len()).map(|m| ((a[m] - b[m]) / side(m)).powi(2)).sum()
}

/// Indices of at most `count` points that together dominate much: each next one adds most to those before (greedy; at least 63 % of the
/// best subset's volume, as hypervolume is submodular: Nemhauser, Wolsey, Fisher 1978). In the order in which they were taken; points
/// that add nothing are left out.
///
/// What a point adds only shrinks as others join, so a value computed earlier is an upper bound (lazy greedy, Minoux 1978).
pub fn spread_subset(points: &[&[f64]], reference: &[f64], count: usize) -> Vec<usize> {
    let mut chosen: Vec<usize> = Vec::new();
    let adds = |i: usize, chosen: &[usize]| exclusive(points[i], chosen.iter().map(|&j| points[j]), reference);
    let mut heap: BinaryHeap<Ranked> = (0..points.len()).map(|i| Ranked(adds(i, &[]), i)).collect();
    let mut fresh = vec![0; points.len()];
    while chosen.len() < count {
        let Some(Ranked(value, i)) = heap.pop() else { break };
        if fresh[i] == chosen.len() {
            if value <= 0.0 {
                break;
            }
            chosen.push(i);
        } else {
            fresh[i] = chosen.len();
            heap.push(Ranked(adds(i, &chosen), i));
        }
    }
    chosen
}
