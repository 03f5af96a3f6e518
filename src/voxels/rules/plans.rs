//! Rules about plans: courts, blocks, cantilevers.

use super::report::{Finding, Report};
use super::site::{Site, Work, reset};
use crate::voxels::Storey;

/// Marks every cell of a `size` grid that lies in a `side` x `side` block of cells that satisfy `has`, with value 2.
/// Other cells keep their mark. `mark` and `count` hold size[0] * size[1] cells, x fastest.
pub(super) fn mark_blocks(
    has: impl Fn(usize) -> bool,
    size: [usize; 2],
    side: usize,
    mark: &mut [u8],
    count: &mut Vec<u32>,
) {
    let [nx, ny] = size;
    reset(count, nx * ny, 0);
    for at in 0..nx * ny {
        if !has(at) {
            continue;
        }
        // Side of the largest full square that ends in this cell.
        let (x, y) = (at % nx, at / nx);
        let behind = if x == 0 || y == 0 { 0 } else { count[at - 1].min(count[at - nx]).min(count[at - nx - 1]) };
        count[at] = 1 + behind;
        if count[at] as usize >= side {
            for row in 0..side {
                let end = at - row * nx;
                mark[end + 1 - side..=end].fill(2);
            }
        }
    }
}

pub(super) fn courts(site: &Site, work: &mut Work, report: &mut Report) {
    let least = site.settings.court_min_modules;
    let [_, sy, sz] = site.stride;
    let size = [sy, sz / sy];
    for k in 0..site.shape[2] {
        let layer = &site.padded()[sz * (k + 1)..sz * (k + 2)];
        let below = &site.padded()[sz * k..sz * (k + 1)];
        let same = k > 0 && layer.iter().zip(below).all(|(a, b)| (*a == 0) == (*b == 0));
        if same || !close(layer, sy, work) {
            continue;
        }
        // Marks are now: 0 court cell, 1 filled or outside.
        let open: Vec<bool> = work.mark.iter().map(|&m| m == 0).collect();
        mark_blocks(|at| open[at], size, least, work.mark, work.count);
        let narrow = (0..open.len()).filter(|&at| work.mark[at] == 0).map(|at| [at % sy - 1, at / sy - 1, k]);
        report.voxels(
            narrow,
            "of a court lie where it is narrower than 4 modules, or as the brief sets",
            "widen the court, open it to a side, or fill it",
        );
    }
}

/// Marks filled cells of a padded layer and those connected to its border; true when cells are left: a court.
fn close(layer: &[u8], sy: usize, work: &mut Work) -> bool {
    work.mark.clear();
    work.mark.extend(layer.iter().map(|&p| (p != 0) as u8));
    if work.mark.is_empty() {
        return false;
    }
    work.mark[0] = 1;
    work.queue.clear();
    work.queue.push(0);
    while let Some(at) = work.queue.pop() {
        for step in [1, -1, sy as i32, -(sy as i32)] {
            let next = at.wrapping_add_signed(step);
            match work.mark.get_mut(next as usize) {
                Some(mark) if *mark == 0 => *mark = 1,
                _ => continue,
            }
            work.queue.push(next);
        }
    }
    work.mark.contains(&0)
}

/// Marks the plan cells of a storey that lie in blocks of `side`; returns (cells in the plan, cells in blocks).
fn cover(storey: &Storey, side: usize, work: &mut Work) -> (usize, usize) {
    let size = storey.plan.size();
    reset(work.mark, size[0] * size[1], 0);
    let has = |at: usize| storey.plan.has([(at % size[0]) as isize, (at / size[0]) as isize]);
    mark_blocks(has, size, side, work.mark, work.count);
    (storey.plan.count(), work.mark.iter().filter(|m| **m == 2).count())
}

/// Voxels of a storey's lowest room layer whose plan cell is not marked as part of a block.
fn outside_blocks(storey: &Storey, mark: &[u8]) -> Vec<[usize; 3]> {
    let nx = storey.plan.size()[0];
    storey.plan.iter().filter(|[x, y]| mark[x + nx * y] != 2).map(|[x, y]| [x, y, storey.plate_k + 1]).collect()
}

pub(super) fn blocks(site: &Site, work: &mut Work, report: &mut Report) {
    let side = site.settings.block_modules;
    for storey in &site.reading.storeys {
        let (all, covered) = cover(storey, side, work);
        report.add((all - covered) as f64, || {
            let cells = outside_blocks(storey, work.mark);
            let message =
                format!("{} plan cells of storey {} lie in no {side} x {side} block", cells.len(), storey.index);
            Finding::new(cells, message, "widen the narrow part or take it away")
        });
    }
}

pub(super) fn rooms(site: &Site, work: &mut Work, report: &mut Report) {
    let (side, share) = (site.settings.room_modules, site.settings.room_share);
    for storey in &site.reading.storeys {
        let (all, covered) = cover(storey, side, work);
        let missing = share * all as f64 - covered as f64;
        report.add(if missing > 1e-9 { missing } else { 0.0 }, || {
            let message = format!(
                "only {covered} of {all} plan cells of storey {} lie in {side} x {side} blocks, {:.0} % are needed",
                storey.index,
                share * 100.0
            );
            Finding::new(outside_blocks(storey, work.mark), message, "widen the wings or shorten the narrow ones")
        });
    }
}

pub(super) fn cantilever(site: &Site, work: &mut Work, report: &mut Report) {
    let [nx, ny, nz] = site.shape;
    let sz = site.stride[2];
    // Layers filled without a gap from the ground, per padded column.
    reset(work.count, sz, 0);
    for y in 0..ny {
        for x in 0..nx {
            let foot = site.index([x, y, 0]);
            work.count[foot - sz] = (0..nz).take_while(|z| site.filled(foot + sz * z)).count() as u32;
        }
    }
    let grounded = |column: usize, k: usize| work.count[column] > k as u32;
    let held = |v: [usize; 3], at: usize| {
        let column = at - sz * (v[2] + 1);
        site.sides().into_iter().any(|step| held_along(site, column, step, v[2], &grounded))
    };
    let loose =
        site.filled_voxels().filter(|&(v, at)| v[2] > 0 && !site.filled(at - sz) && !held(v, at)).map(|(v, _)| v);
    report.voxels(
        loose,
        "hang too far out, or without twice as much standing behind them in line",
        "draw the storey back, or build under it",
    );
}

/// Whether a voxel without support is held in one direction: support within reach, and enough of it behind.
fn held_along(site: &Site, column: usize, step: isize, k: usize, grounded: &impl Fn(usize, usize) -> bool) -> bool {
    let plane = site.stride[2];
    let lift = plane * (k + 1);
    let mut at = column;
    for out in 1..=site.settings.cantilever_max_modules {
        let Some(next) = at.checked_add_signed(step).filter(|&n| n < plane && site.filled(n + lift)) else {
            return false;
        };
        at = next;
        if grounded(at, k) {
            let back = site.settings.cantilever_back_factor * out;
            return (0..back)
                .all(|n| at.checked_add_signed(step * n as isize).is_some_and(|b| b < plane && grounded(b, k)));
        }
    }
    false
}
