//! Whether one can walk to every storey.

use super::facade::is_entrance;
use super::report::Report;
use super::site::{Site, Work, reset};
use crate::voxels::{Direction, Reading};

/// Mark of cells that are no floor to walk on.
const BLOCKED: u8 = 1;
const REACHED: u8 = 2;

/// The walking surface of all storeys: cell x of row y of storey s at `x + nx (y + ny s)`.
struct Floors<'s> {
    reading: &'s Reading,
    size: [usize; 2],
}

impl Floors<'_> {
    fn index(&self, storey: usize, [x, y]: [isize; 2]) -> Option<usize> {
        let [nx, ny] = self.size;
        let inside = x >= 0 && y >= 0 && (x as usize) < nx && (y as usize) < ny && storey < self.reading.storeys.len();
        inside.then(|| x as usize + nx * (y as usize + ny * storey))
    }

    fn place(&self, index: usize) -> (usize, [usize; 2]) {
        let [nx, ny] = self.size;
        (index / (nx * ny), [index % nx, index / nx % ny])
    }
}

pub(super) fn storeys(site: &Site, work: &mut Work, report: &mut Report) {
    let floors = Floors { reading: site.reading, size: [site.shape[0], site.shape[1]] };
    block(site, &floors, work);
    work.queue.clear();
    let doors = site.reading.openings.iter().filter(|o| is_entrance(site, o));
    for at in doors.filter_map(|o| floors.index(o.storey, o.column(0, -1))) {
        visit(at, work);
    }
    if work.queue.is_empty() {
        // Without an entrance (its own rule speaks) start anywhere on the ground storey.
        if let Some(at) = work.mark.iter().position(|m| *m == 0) {
            visit(at, work);
        }
    }
    walk(site, &floors, work);
    for (s, storey) in site.reading.storeys.iter().enumerate() {
        if s > 0 && storey.floor_area_m2 < site.settings.loft_max_m2 {
            continue;
        }
        let cells = floors.size[0] * floors.size[1];
        let lost = (cells * s..cells * (s + 1)).filter(|&at| work.mark[at] == 0).map(|at| {
            let (_, [x, y]) = floors.place(at);
            [x, y, storey.plate_k + 1]
        });
        report.voxels(
            lost,
            "of a storey cannot be reached on foot from the entrance",
            "add a stair from the storey below, or join the parts of the storey",
        );
    }
}

/// Marks what is no floor: outside the plan, voids, and under flights with less headroom than the stair's least.
fn block(site: &Site, floors: &Floors, work: &mut Work) {
    let [nx, ny] = floors.size;
    reset(work.mark, nx * ny * site.reading.storeys.len(), BLOCKED);
    for (s, storey) in site.reading.storeys.iter().enumerate() {
        for [x, y] in storey.plan.iter() {
            if site.slab(site.index([x, y, storey.plate_k])) {
                work.mark[x + nx * (y + ny * s)] = 0;
            }
        }
    }
    let dz = site.house.voxels.module.size_m[2];
    for stair in &site.house.stairs {
        let low = |n: usize| n as f64 * dz < site.settings.stair_headroom_min_m;
        let flights = stair.flight_cells().into_iter().enumerate().filter(|(n, _)| low(*n)).map(|(_, c)| c);
        let landing = stair.middle_landing().into_iter().filter(|_| low(3));
        for at in flights.chain(landing).filter_map(|c| floors.index(stair.storey, c)) {
            work.mark[at] = BLOCKED;
        }
    }
}

fn visit(at: usize, work: &mut Work) {
    if work.mark[at] == 0 {
        work.mark[at] = REACHED;
        work.queue.push(at as u32);
    }
}

fn walk(site: &Site, floors: &Floors, work: &mut Work) {
    while let Some(at) = work.queue.pop() {
        let (s, cell) = floors.place(at as usize);
        let cell = cell.map(|c| c as isize);
        for d in Direction::ALL {
            let [dx, dy] = d.step();
            if let Some(next) = floors.index(s, [cell[0] + dx, cell[1] + dy]) {
                visit(next, work);
            }
        }
        for stair in &site.house.stairs {
            let other = if stair.storey == s && stair.foot() == cell {
                floors.index(s + 1, stair.head())
            } else if stair.storey + 1 == s && stair.head() == cell {
                floors.index(s - 1, stair.foot())
            } else {
                None
            };
            if let Some(next) = other {
                visit(next, work);
            }
        }
    }
}
