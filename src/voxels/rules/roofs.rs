//! Rules about roofs and decks.

use super::plans::mark_blocks;
use super::report::{Finding, Report};
use super::site::{Site, Work, reset};

pub(super) fn drain(site: &Site, work: &mut Work, report: &mut Report) {
    let sz = site.stride[2];
    reset(work.mark, site.padded().len(), 0);
    let surface = |at: usize| site.filled(at) && !site.filled(at + sz);
    let sides = site.sides();
    // Layer by layer upwards, so that what lies lower is settled when water falls onto it.
    let [nx, ny, nz] = site.shape;
    for z in 0..nz {
        work.queue.clear();
        for row in (0..ny).map(|y| site.index([0, y, z])) {
            for at in row..row + nx {
                let drains = |step: &isize| falls_off(site, (at as isize + step) as usize, work.mark);
                if surface(at) && sides.iter().any(drains) {
                    work.queue.push(at as u32);
                }
            }
        }
        for &at in work.queue.iter() {
            work.mark[at as usize] = 1;
        }
        while let Some(at) = work.queue.pop() {
            for step in sides {
                let next = (at as isize + step) as usize;
                if surface(next) && work.mark[next] == 0 {
                    work.mark[next] = 1;
                    work.queue.push(next as u32);
                }
            }
        }
    }
    let wet = site.filled_voxels().filter(|&(_, at)| surface(at) && work.mark[at] == 0).map(|(v, _)| v);
    report.voxels(
        wet,
        "of roof or deck have no non-rising way to a free edge",
        "open an edge for the water: take away the higher part on one side, or fill the hollow",
    );
}

/// Whether water that leaves sideways over the voxel position `at` falls to the ground or onto a surface that drains.
fn falls_off(site: &Site, mut at: usize, drained: &[u8]) -> bool {
    let sz = site.stride[2];
    if site.filled(at) || site.filled(at + sz) {
        return false;
    }
    while at >= 2 * sz {
        at -= sz;
        if site.filled(at) {
            return drained[at] != 0;
        }
    }
    true
}

pub(super) fn bump(site: &Site, work: &mut Work, report: &mut Report) {
    let [_, sy, sz] = site.stride;
    for k in 1..site.shape[2] {
        let from = sz * (k + 1);
        let filled = |at: usize| site.filled(from + at);
        reset(work.mark, sz, 0);
        mark_blocks(filled, [sy, sz / sy], site.settings.bump_min_modules, work.mark, work.count);
        for start in 0..sz {
            if filled(start) && work.mark[start] == 0 {
                let wide = collect(&filled, sy, start, work);
                if !wide && !is_step(site, k, work.queue) {
                    let cells: &[u32] = work.queue;
                    report.add(cells.len() as f64, || {
                        let voxels = cells.iter().map(|&at| site.voxel(from + at as usize)).collect();
                        let message =
                            format!("{} voxels of layer {k} stand up on less than 3 modules of plan", cells.len());
                        Finding::new(voxels, message, "take them away or widen them to 3 x 3 modules")
                    });
                }
            }
        }
    }
}

/// Collects the cells of a layer joined to `start` in `work.queue` and marks them 1 (2 stays); true when one lies in a block.
fn collect(filled: &impl Fn(usize) -> bool, sy: usize, start: usize, work: &mut Work) -> bool {
    work.queue.clear();
    work.queue.push(start as u32);
    work.mark[start] = 1;
    let (mut next, mut wide) = (0, false);
    while next < work.queue.len() {
        let at = work.queue[next];
        next += 1;
        for step in [1, -1, sy as i32, -(sy as i32)] {
            let to = at.wrapping_add_signed(step) as usize;
            wide |= filled(to) && work.mark[to] == 2;
            if filled(to) && work.mark[to] == 0 {
                work.mark[to] = 1;
                work.queue.push(to as u32);
            }
        }
    }
    wide
}

/// Whether cells of layer k are a step of a slope: all that the layer below leaves one module inside its own edges, all round
/// (a hip) or along one axis (a saddle, whose ridge runs from verge to verge). The ridge of a wing that runs into a saddle
/// roof one layer lower, one module wide, does not widen the layer below.
fn is_step(site: &Site, k: usize, cells: &[u32]) -> bool {
    let [_, sy, sz] = site.stride;
    let below = |at: usize| site.filled(sz * k + at);
    let hip = |at: usize| [at - sy, at, at + sy].iter().all(|&row| below(row - 1) && below(row) && below(row + 1));
    let saddle = |at: usize, across: usize, along: usize| {
        let slope = |n: usize| below(n) && (below(n - along) || below(n + along));
        below(at) && slope(at - across) && slope(at + across)
    };
    let steps = |inner: &dyn Fn(usize) -> bool| {
        cells.iter().all(|&c| {
            let c = c as usize;
            let beside = [c - 1, c + 1, c - sy, c + sy];
            inner(c) && beside.into_iter().all(|b| site.filled(sz * (k + 1) + b) || !below(b) || !inner(b))
        })
    };
    steps(&hip) || steps(&|at| saddle(at, 1, sy)) || steps(&|at| saddle(at, sy, 1))
}
