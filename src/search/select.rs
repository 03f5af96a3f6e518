//! The named houses: four to six of a front, each with the reason why it was picked.

use super::knee::{Knee, knees};
use crate::voxels::VoxelArray;

/// Why a house has a name.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Reason {
    /// Best in the objective of this index.
    Least(usize),
    /// Nearest to the ideal point, objectives normalised over the front.
    BestBalance,
    /// The sharpest knee of the front.
    Knee,
    /// Largest mean shape distance to the others.
    MostDifferent,
    /// Smallest shape distance to the reference.
    NearestReference,
}

/// A house with a name.
#[derive(Clone, Debug, PartialEq)]
pub struct Named {
    /// Position in the front given.
    pub index: usize,
    /// "cheapest", "lowest carbon", ...
    pub name: String,
    /// Why.
    pub reason: Reason,
    /// The reason as a sentence with its numbers.
    pub sentence: String,
}

/// Most houses that are named.
const MOST: usize = 6;

/// Names up to six houses of a front: the best of each of the first objectives (one house may be the best in several), the
/// best balance, the sharpest knee where there is one, the most different where there is room, the nearest to a reference.
///
/// `points` are minimised objective vectors (an objective to be maximised comes negated), `shapes` the houses in the same
/// order, `names` the objective names in the order of the vectors.
pub fn named_houses(
    points: &[&[f64]],
    shapes: &[&VoxelArray],
    names: &[&str],
    reference: Option<&VoxelArray>,
) -> Vec<Named> {
    let mut out: Vec<Named> = Vec::new();
    let count = points.len().min(shapes.len());
    for (m, objective) in names.iter().enumerate().take(3) {
        let ranking = ranked(count, |i| points[i].get(m).copied().unwrap_or(f64::INFINITY));
        let Some(&(best, value)) = ranking.first() else { break };
        let (name, sentence) = (least_name(objective), least_sentence(objective, value, count));
        add(&mut out, Named { index: best, name, reason: Reason::Least(m), sentence });
    }
    let balance = balance(&points[..count]);
    push(&mut out, MOST, ranked(count, |i| balance[i]), "best balance", Reason::BestBalance, &|v| {
        format!("nearest to the ideal point: {v:.2} of the front's range away, all objectives counting the same")
    });
    if let Some(knee) = knees(&points[..count]).first() {
        let sentence = knee_sentence(knee, points[knee.index], names);
        add(&mut out, Named { index: knee.index, name: "knee".into(), reason: Reason::Knee, sentence });
    }
    // The nearest to the reference was asked for; the most different gives way to it.
    let most = MOST - usize::from(reference.is_some());
    let apart = mean_distances(&shapes[..count]);
    push(&mut out, most, ranked(count, |i| -apart[i]), "most different", Reason::MostDifferent, &|v| {
        format!("its shape differs most from the others: {:.0} % of the voxels on average", -100.0 * v)
    });
    if let Some(reference) = reference {
        let ranking = ranked(count, |i| shape_distance(shapes[i], reference));
        push(&mut out, MOST, ranking, "nearest to the reference", Reason::NearestReference, &|v| {
            format!("closest in shape to the reference: {:.0} % of the voxels differ", 100.0 * v)
        });
    }
    out
}

/// Adds a name; a house that has one already gets both.
fn add(out: &mut Vec<Named>, new: Named) {
    match out.iter_mut().find(|n| n.index == new.index) {
        Some(named) => {
            named.name = format!("{}, {}", named.name, new.name);
            named.sentence = format!("{}; {}", named.sentence, new.sentence);
        }
        None => out.push(new),
    }
}

/// Names the first of a ranking that has no name yet, while fewer than `most` have one.
fn push(
    out: &mut Vec<Named>,
    most: usize,
    ranking: Vec<(usize, f64)>,
    name: &str,
    reason: Reason,
    sentence: &dyn Fn(f64) -> String,
) {
    let free = ranking.into_iter().find(|(i, _)| out.iter().all(|n| n.index != *i));
    if let Some((index, value)) = free.filter(|_| out.len() < most) {
        out.push(Named { index, name: name.into(), reason, sentence: sentence(value) });
    }
}

/// Why a house is a knee, with its rates of exchange. `point` is minimised, so that what is to be large is negative.
pub fn knee_sentence(knee: &Knee, point: &[f64], names: &[&str]) -> String {
    let word = |m: usize| plain(names.get(m).copied().unwrap_or("?"));
    let is_max = |m: usize| point[m] < 0.0;
    let gain = |m: usize| if is_max(m) { "more" } else { "less" };
    let loss = |m: usize| if is_max(m) { "less" } else { "more" };
    let steps =
        format!("any step to a neighbour on the front loses at least {:.2} times what it gains", knee.trade_off);
    match knee.exchange {
        Some(e) => format!(
            "from here on 1 % {} {} costs at least {:.1} % {} {}, up to here at most {:.1} %; {steps}",
            gain(e.gained),
            word(e.gained),
            e.onward,
            loss(e.paid),
            word(e.paid),
            e.before
        ),
        None => steps,
    }
}

/// An objective without its unit.
pub fn plain(objective: &str) -> String {
    let bare = match objective {
        "gwp_kgco2e" => "carbon",
        "heat_loss_w_per_k" => "heat loss",
        other => ["_eur", "_kg", "_mj", "_m2"].iter().find_map(|unit| other.strip_suffix(unit)).unwrap_or(other),
    };
    bare.replace('_', " ")
}
/// Indices by ascending key, then index.
fn ranked(count: usize, key: impl Fn(usize) -> f64) -> Vec<(usize, f64)> {
    let mut out: Vec<(usize, f64)> = (0..count).map(|i| (i, key(i))).collect();
    out.sort_by(|a, b| a.1.total_cmp(&b.1).then(a.0.cmp(&b.0)));
    out
}

fn least_name(objective: &str) -> String {
    match objective {
        "price_eur" => "cheapest".into(),
        "gwp_kgco2e" => "lowest carbon".into(),
        "floor_area_m2" => "largest".into(),
        other => format!("best {other}"),
    }
}

fn least_sentence(objective: &str, value: f64, count: usize) -> String {
    let value = value.abs();
    let digits = if value >= 1000.0 { 0 } else { 3 - (value.max(1e-9).log10().floor() as i32).clamp(-3, 3) } as usize;
    format!("{objective} {value:.digits$}, the best of the {count} houses of the front")
}

/// Distance of each point from the ideal point, Euclidean over objectives normalised by the front's range and divided by
/// the square root of their number (0 = ideal, 1 = worst in all).
fn balance(points: &[&[f64]]) -> Vec<f64> {
    let objectives = points.iter().map(|p| p.len()).min().unwrap_or(0);
    let mut out = vec![0.0; points.len()];
    for m in 0..objectives {
        let low = points.iter().map(|p| p[m]).fold(f64::INFINITY, f64::min);
        let range = points.iter().map(|p| p[m] - low).fold(0.0, f64::max);
        if range > 0.0 {
            out.iter_mut().zip(points).for_each(|(d, p)| *d += ((p[m] - low) / range).powi(2));
        }
    }
    out.iter().map(|d| (d / objectives.max(1) as f64).sqrt()).collect()
}

fn mean_distances(shapes: &[&VoxelArray]) -> Vec<f64> {
    let others = shapes.len().saturating_sub(1).max(1) as f64;
    let sum = |a: &&VoxelArray| shapes.iter().map(|b| shape_distance(a, b)).sum::<f64>();
    shapes.iter().map(|a| sum(a) / others).collect()
}

/// Share of voxels that differ: 1 - (filled in both) / (filled in either), both moved to their smallest corner.
pub fn shape_distance(a: &VoxelArray, b: &VoxelArray) -> f64 {
    let ((la, sa), (lb, _)) = (corner(a), corner(b));
    let mut both = 0usize;
    for z in 0..sa[2] {
        for y in 0..sa[1] {
            for x in 0..sa[0] {
                let here = a.get([la[0] + x, la[1] + y, la[2] + z]).is_filled();
                let there = b.at([lb[0] + x, lb[1] + y, lb[2] + z].map(|v| v as isize)).is_filled();
                both += usize::from(here && there);
            }
        }
    }
    let either = a.filled_count() + b.filled_count() - both;
    if either == 0 { 0.0 } else { 1.0 - both as f64 / either as f64 }
}

/// Smallest filled corner and size from there to the end of the array.
fn corner(voxels: &VoxelArray) -> ([usize; 3], [usize; 3]) {
    let mut low = voxels.shape();
    for (voxel, _) in voxels.iter().filter(|(_, l)| l.is_filled()) {
        (0..3).for_each(|a| low[a] = low[a].min(voxel[a]));
    }
    (low, std::array::from_fn(|a| voxels.shape()[a] - low[a]))
}
