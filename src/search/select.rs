//! The named houses: four to six of a front, each with the reason why it was picked.

use crate::voxels::VoxelArray;

/// Why a house has a name.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Reason {
    /// Best in the objective of this index.
    Least(usize),
    /// Nearest to the ideal point, objectives normalised over the front.
    BestBalance,
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
/// best balance, the most different, the nearest to a reference.
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
        match out.iter_mut().find(|n| n.index == best) {
            // The best in two objectives has both names.
            Some(named) => {
                named.name = format!("{}, {name}", named.name);
                named.sentence = format!("{}; {sentence}", named.sentence);
            }
            None => out.push(Named { index: best, name, reason: Reason::Least(m), sentence }),
        }
    }
    let mut push = |ranking: Vec<(usize, f64)>, name: String, reason: Reason, sentence: &dyn Fn(f64) -> String| {
        let free = ranking.into_iter().find(|(i, _)| out.iter().all(|n| n.index != *i));
        if let Some((index, value)) = free.filter(|_| out.len() < MOST) {
            out.push(Named { index, name, reason, sentence: sentence(value) });
        }
    };
    let balance = balance(&points[..count]);
    push(ranked(count, |i| balance[i]), "best balance".into(), Reason::BestBalance, &|v| {
        format!("nearest to the ideal point: {v:.2} of the front's range away, all objectives counting the same")
    });
    let apart = mean_distances(&shapes[..count]);
    push(ranked(count, |i| -apart[i]), "most different".into(), Reason::MostDifferent, &|v| {
        format!("its shape differs most from the others: {:.0} % of the voxels on average", -100.0 * v)
    });
    if let Some(reference) = reference {
        let ranking = ranked(count, |i| shape_distance(shapes[i], reference));
        push(ranking, "nearest to the reference".into(), Reason::NearestReference, &|v| {
            format!("closest in shape to the reference: {:.0} % of the voxels differ", 100.0 * v)
        });
    }
    out
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
