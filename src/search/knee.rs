//! Knees of a front: designs from which every step to a neighbour loses more than it gains.
//!
//! Objectives are normalised by the front's range. The trade-off of a design is the least of (largest loss) / (largest gain) over its
//! neighbours; a knee has one above 1 and is the sharpest around. The principle is that of Rachmawati and Srinivasan (2009, IEEE
//! Transactions on Evolutionary Computation 13(4)), with the largest instead of the summed loss and gain: two objectives that rise and
//! fall together, as price and carbon do, count once, and leaving one of them out changes nothing. The expected marginal utility of
//! Branke et al. (2004, PPSN VIII) was tried and put the ends of the front first, and it shrinks where a design has a near twin.

/// Neighbours differ by at most this share of the front's range in every objective.
pub const RADIUS: f64 = 0.25;

/// Steps in an objective smaller than this share of its value are too small for a rate of exchange.
const LEAST_STEP: f64 = 0.01;

/// A knee of a front.
#[derive(Clone, Debug, PartialEq)]
pub struct Knee {
    /// Position in the front.
    pub index: usize,
    /// The least that a step to a neighbour loses for each unit it gains, both in shares of the front's range; above 1.
    pub trade_off: f64,
    /// What an objective costs from here on and up to here; `None` where the neighbours do not show both.
    pub exchange: Option<Exchange>,
}

/// What one objective costs in another at a knee, in percent of its own values.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Exchange {
    /// The objective that a step gains in.
    pub gained: usize,
    /// The objective that pays.
    pub paid: usize,
    /// From here on: the least that 1 % costs at a neighbour.
    pub onward: f64,
    /// Up to here: the most that 1 % cost from a neighbour.
    pub before: f64,
}

/// The knees of a front of minimised objective vectors, sharpest first, no two of them neighbours. The best in an objective is none: its
/// front has one side only.
pub fn knees(points: &[&[f64]]) -> Vec<Knee> {
    let normalised = normalised(points);
    let trade_offs = trade_offs(&normalised);
    let is_end = |i: usize| normalised[i].contains(&0.0);
    let is_sharp = |i: usize| trade_offs[i].is_finite() && trade_offs[i] > 1.0 + 1e-9;
    let mut order: Vec<usize> = (0..points.len()).filter(|&i| is_sharp(i) && !is_end(i)).collect();
    order.sort_by(|&a, &b| trade_offs[b].total_cmp(&trade_offs[a]).then(a.cmp(&b)));
    let mut out: Vec<Knee> = Vec::new();
    for index in order {
        if out.iter().all(|k| !are_neighbours(&normalised[k.index], &normalised[index])) {
            let exchange = exchange(points, index, &neighbours(&normalised, index));
            out.push(Knee { index, trade_off: trade_offs[index], exchange });
        }
    }
    out
}

/// The least loss per gain of each of some normalised points over its neighbours; infinite for a point alone.
pub fn trade_offs(points: &[Vec<f64>]) -> Vec<f64> {
    let largest = |from: &[f64], to: &[f64]| from.iter().zip(to).map(|(a, b)| b - a).fold(0.0, f64::max);
    let ratio = |i: usize, j: usize| {
        let (loss, gain) = (largest(&points[i], &points[j]), largest(&points[j], &points[i]));
        if gain > 0.0 { loss / gain } else { f64::INFINITY }
    };
    (0..points.len())
        .map(|i| neighbours(points, i).into_iter().map(|j| ratio(i, j)).fold(f64::INFINITY, f64::min))
        .collect()
}

/// Points over the range of each objective, 0 = best; an objective that is the same for all is 1, so that it makes no end.
pub fn normalised(points: &[&[f64]]) -> Vec<Vec<f64>> {
    let objectives = points.iter().map(|p| p.len()).min().unwrap_or(0);
    let low = |m: usize| points.iter().map(|p| p[m]).fold(f64::INFINITY, f64::min);
    let range = |m: usize| points.iter().map(|p| p[m]).fold(f64::NEG_INFINITY, f64::max) - low(m);
    let scale: Vec<[f64; 2]> = (0..objectives).map(|m| [low(m), range(m)]).collect();
    let one = |p: &[f64]| -> Vec<f64> {
        scale.iter().zip(p).map(|([low, range], v)| if *range > 0.0 { (v - low) / range } else { 1.0 }).collect()
    };
    points.iter().map(|p| one(p)).collect()
}

fn are_neighbours(a: &[f64], b: &[f64]) -> bool {
    a.iter().zip(b).all(|(x, y)| (x - y).abs() <= RADIUS)
}

/// The neighbours of a point; all others where it has none.
fn neighbours(points: &[Vec<f64>], i: usize) -> Vec<usize> {
    let others = || (0..points.len()).filter(|&j| j != i);
    let near: Vec<usize> = others().filter(|&j| are_neighbours(&points[i], &points[j])).collect();
    if near.is_empty() { others().collect() } else { near }
}

/// Of all pairs of objectives, the one whose rate rises most at the knee, where it costs something on both sides.
fn exchange(points: &[&[f64]], k: usize, near: &[usize]) -> Option<Exchange> {
    let objectives = points[k].len();
    // By how much b is better than a, as a share of the knee's value.
    let better =
        |a: usize, b: usize, m: usize| (points[a][m] - points[b][m]) / points[k][m].abs().max(f64::MIN_POSITIVE);
    let one = |gained: usize, paid: usize| {
        let on = near.iter().filter(|&&y| better(k, y, gained) >= LEAST_STEP);
        let back = near.iter().filter(|&&y| better(y, k, gained) >= LEAST_STEP);
        let onward = on.map(|&y| better(y, k, paid) / better(k, y, gained)).min_by(f64::total_cmp)?;
        let before = back.map(|&y| better(k, y, paid) / better(y, k, gained)).max_by(f64::total_cmp)?;
        (before > 0.0 && onward > before).then_some(Exchange { gained, paid, onward, before })
    };
    // Of two objectives both ways round are equally steep; the one that is to be large is told as what is gained.
    let steepness = |e: &Exchange| e.onward / e.before * if points[k][e.gained] < 0.0 { 1.0 } else { 1.0 - 1e-9 };
    let pairs = (0..objectives).flat_map(|g| (0..objectives).filter(move |p| *p != g).map(move |p| (g, p)));
    let exchanges = pairs.filter_map(|(gained, paid)| one(gained, paid));
    exchanges.reduce(|best, e| if steepness(&e) > steepness(&best) { e } else { best })
}
