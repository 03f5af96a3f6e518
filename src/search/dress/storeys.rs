//! Footprints read off a massing, and put right.

use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;

use crate::search::cells::Cells;
use crate::search::shape::{Cause, check_pair, check_plan};
use crate::search::start::complete;
use crate::voxels::{Label, STOREY_MODULES, VoxelArray};

/// Layers of the six of a storey that must be filled for a cell to count as room: half, so that heights are rounded.
const LAYERS_NEEDED: usize = STOREY_MODULES / 2;
/// Changed cells that one corner less in a footprint is worth, when it has to be changed anyway.
const CELLS_PER_CORNER: usize = 2;
/// Completions tried for one footprint; the one that changes the fewest cells is taken.
const COMPLETIONS: u64 = 12;
/// Rounds in which storeys are put right against each other.
const ROUNDS: usize = 6;

/// Fills what is enclosed: in each layer, empty cells that do not reach its border and have something filled above them.
/// Voxel models are often hollow; courts, which are open to the sky, stay open.
pub fn fill_hollows(solid: &mut VoxelArray) {
    let [nx, ny, nz] = solid.shape();
    let mut covered = Cells::new([nx, ny]);
    for k in (0..nz).rev() {
        let layer = layer(solid, k);
        let outside = Cells::full([nx, ny]).minus(&layer);
        let open = outside.component([0, 0]);
        for [x, y] in outside.minus(&open).and(&covered).iter() {
            solid.set([x, y, k], Label::Base);
        }
        covered = covered.or(&layer);
    }
}

/// The filled cells of a layer; the array is at most as wide as [`Cells`] are.
pub fn layer(solid: &VoxelArray, k: usize) -> Cells {
    let [nx, ny, nz] = solid.shape();
    let mut cells = Cells::new([nx, ny]);
    for (x, y) in (0..ny).flat_map(|y| (0..nx).map(move |x| (x, y))).filter(|_| k < nz) {
        cells.set([x, y], solid.get([x, y, k]).is_filled());
    }
    cells
}

/// The plans of the storeys from the ground up: cells filled in half of the six layers at least. It ends at the first
/// storey that is no larger than a roof bump, or that tapers like a roof.
pub fn footprints(solid: &VoxelArray) -> Vec<Cells> {
    let [nx, ny, nz] = solid.shape();
    let mut plans = Vec::new();
    for s in 0..nz.div_ceil(STOREY_MODULES) {
        let layers: Vec<Cells> = (0..STOREY_MODULES).map(|i| layer(solid, s * STOREY_MODULES + i)).collect();
        let mut plan = Cells::new([nx, ny]);
        for (x, y) in (0..ny).flat_map(|y| (0..nx).map(move |x| (x, y))) {
            let filled = layers.iter().filter(|l| l.has([x as isize, y as isize])).count();
            plan.set([x, y], filled >= LAYERS_NEEDED);
        }
        let tapers = s > 0 && 2 * layers[STOREY_MODULES - 1].count() < layers[0].count();
        if tapers || plan.blocks(4).is_empty() {
            break;
        }
        plans.push(plan);
    }
    plans
}

/// Puts footprints right, each by itself and each on the one below, with few changes; tells what was changed.
pub fn mend(plans: &mut Vec<Cells>, notes: &mut Vec<String>) {
    for (s, plan) in plans.iter_mut().enumerate() {
        match completed(plan) {
            Some(better) => {
                tell(plan, &better, s, "so that it can be built and walked", notes);
                *plan = better;
            }
            None => notes.push(format!("storey {s} could not be brought into a plan that keeps the rules")),
        }
    }
    for _ in 0..ROUNDS {
        let Some((s, cause)) = first_fault(plans) else { return };
        let Some((lower, upper)) = joined(&plans[s - 1], &plans[s]) else {
            notes.push(format!("storey {s} does not fit the one below: it breaks the {} rule", cause.name()));
            plans.truncate(s);
            return;
        };
        let why = format!("so that one stands on the other ({})", cause.name());
        tell(&plans[s - 1], &lower, s - 1, &why, notes);
        tell(&plans[s], &upper, s, &why, notes);
        (plans[s - 1], plans[s]) = (lower, upper);
    }
}

/// The first storey that does not fit the ones below it.
fn first_fault(plans: &[Cells]) -> Option<(usize, Cause)> {
    let mut standing = plans.first()?.clone();
    for s in 1..plans.len() {
        if let Err(cause) = check_pair(&plans[s - 1], &plans[s], &standing) {
            return Some((s, cause));
        }
        standing = standing.and(&plans[s]);
    }
    None
}

/// The plan itself where it keeps the plan rules, else the calmest with few changes that does: what is too narrow is taken
/// away or widened.
fn completed(plan: &Cells) -> Option<Cells> {
    if check_plan(plan).is_ok() {
        return Some(plan.clone());
    }
    let everywhere = Cells::full(plan.size());
    let parts = [3, 4, 5].map(|side| largest_part(&plan.blocks(side)));
    let boxes = parts[0].bounds().map(|([x, y], extent)| Cells::rect(plan.size(), [x as isize, y as isize], extent));
    let mut candidates = Vec::new();
    for from in [plan, &plan.blocks(3)].into_iter().chain(&parts).chain(&boxes) {
        if check_plan(from).is_ok() {
            candidates.push(from.clone());
            continue;
        }
        for seed in 0..COMPLETIONS {
            candidates.extend(complete(from.clone(), &everywhere, &mut ChaCha8Rng::seed_from_u64(seed)).ok());
        }
    }
    candidates.into_iter().min_by_key(|c| changes(plan, c) + CELLS_PER_CORNER * corners(c))
}

/// Corners of a plan's outline.
fn corners(plan: &Cells) -> usize {
    let [nx, ny] = plan.size().map(|n| n as isize);
    let around =
        |x: isize, y: isize| [[0, 0], [1, 0], [0, 1], [1, 1]].iter().filter(|d| plan.has([x + d[0], y + d[1]])).count();
    (-1..ny).flat_map(|y| (-1..nx).map(move |x| (x, y))).filter(|&(x, y)| around(x, y) % 2 == 1).count()
}

fn largest_part(plan: &Cells) -> Cells {
    let mut rest = plan.clone();
    let mut largest = Cells::new(plan.size());
    while let Some(seed) = rest.first() {
        let part = rest.component(seed);
        rest = rest.minus(&part);
        if part.count() > largest.count() {
            largest = part;
        }
    }
    largest
}

fn changes(from: &Cells, to: &Cells) -> usize {
    from.minus(to).count() + to.minus(from).count()
}

/// Two footprints that fit each other, with the fewest changes: the lower one built out under the upper, the upper one drawn
/// back onto the lower, or both made alike.
fn joined(lower: &Cells, upper: &Cells) -> Option<(Cells, Cells)> {
    let union = completed(&lower.or(upper));
    let common = completed(&lower.and(upper));
    let candidates = [
        union.clone().map(|l| (l, upper.clone())),
        common.clone().map(|u| (lower.clone(), u)),
        Some((lower.clone(), lower.clone())),
        union.map(|l| (l.clone(), l)),
    ];
    let fits = |(l, u): &(Cells, Cells)| check_plan(l).is_ok() && check_plan(u).is_ok() && check_pair(l, u, l).is_ok();
    candidates.into_iter().flatten().filter(fits).min_by_key(|(l, u)| changes(lower, l) + changes(upper, u))
}

fn tell(from: &Cells, to: &Cells, s: usize, why: &str, notes: &mut Vec<String>) {
    let (added, taken) = (to.minus(from).count(), from.minus(to).count());
    if added + taken > 0 {
        notes.push(format!("storey {s}: {added} plan cells added and {taken} taken away, {why}"));
    }
}
