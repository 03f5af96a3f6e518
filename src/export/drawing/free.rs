//! The clear floor of a storey: what walls, stairs, doors and openings in the floor leave.

use super::cut::Loop;
use super::doors::Place;
use super::fit::{Fit, Room};
use super::subject::Subject;
use crate::voxels::{LINING_M, Label, Storey};

/// Edge of a cell of the clear area, m; modules are whole multiples of it by default, so walls end on its lines.
const CELL_M: f64 = 0.05;

/// The clear floor of a storey in cells.
pub struct Free {
    size: [usize; 2],
    corner: [f64; 2],
    cell: [f64; 2],
    open: Vec<bool>,
    /// Blocked cells in the rectangle up to each place.
    sums: Vec<u32>,
    /// Cells just inside a window.
    bright: Vec<bool>,
}

impl Free {
    /// The floor between the walls, without stairs, openings in the floor, what doors need, and whatever is cut at plan height.
    pub fn new(subject: &Subject, storey: &Storey, poche: &[Loop]) -> Free {
        let per = [0, 1].map(|a| (subject.module[a] / CELL_M).round().max(1.0) as usize);
        let cell = [0, 1].map(|a| subject.module[a] / per[a] as f64);
        let plan = storey.plan.size();
        let size = [0, 1].map(|a| plan[a] * per[a]);
        let corner = [subject.origin[0], subject.origin[1]];
        let mut free = Free {
            size,
            corner,
            cell,
            open: vec![false; size[0] * size[1]],
            sums: Vec::new(),
            bright: vec![false; size[0] * size[1]],
        };
        free.rooms(storey, per);
        free.block_stairs(subject, storey, per);
        for o in subject.reading.openings.iter().filter(|o| o.storey == storey.index) {
            let place = Place::new(subject, o);
            match o.label {
                Label::Opening => free.block(place.landing()),
                _ => free.light(place.at(0.0, LINING_M + 0.02), place.at(place.width, LINING_M + 0.02)),
            }
        }
        free.block_cut(poche);
        free.add_up();
        free
    }

    /// Opens the cells that keep a wall's thickness from the outside.
    fn rooms(&mut self, storey: &Storey, per: [usize; 2]) {
        let reach = [0, 1].map(|a| (LINING_M / self.cell[a] - 1e-6).ceil() as isize);
        for y in 0..self.size[1] {
            for x in 0..self.size[0] {
                let span = |n: usize, a: usize| {
                    let (low, high) = (n as isize - reach[a], n as isize + reach[a]);
                    low.div_euclid(per[a] as isize)..=high.div_euclid(per[a] as isize)
                };
                let inside = span(y, 1).all(|j| span(x, 0).all(|i| storey.plan.has([i, j])));
                self.open[x + self.size[0] * y] = inside;
            }
        }
    }

    fn block_stairs(&mut self, subject: &Subject, storey: &Storey, per: [usize; 2]) {
        let mut cells: Vec<[isize; 2]> = Vec::new();
        for stair in &subject.house.stairs {
            if stair.storey == storey.index {
                cells.extend(stair.flight_cells());
                cells.extend(stair.middle_landing());
                cells.push(stair.foot());
            } else if stair.storey + 1 == storey.index {
                cells.extend(stair.void_cells());
                cells.push(stair.head());
            }
        }
        let plate = subject.reading.plates.iter().find(|p| p.k == storey.plate_k);
        cells.extend(plate.into_iter().flat_map(|p| p.void.iter()).map(|c| c.map(|n| n as isize)));
        for [i, j] in cells {
            for y in (j * per[1] as isize)..((j + 1) * per[1] as isize) {
                for x in (i * per[0] as isize)..((i + 1) * per[0] as isize) {
                    self.shut([x, y]);
                }
            }
        }
    }

    fn shut(&mut self, [x, y]: [isize; 2]) {
        if x >= 0 && y >= 0 && (x as usize) < self.size[0] && (y as usize) < self.size[1] {
            self.open[x as usize + self.size[0] * y as usize] = false;
        }
    }

    /// Cells that a rectangle touches.
    fn touched(&self, [low, high]: [[f64; 2]; 2]) -> [[isize; 2]; 2] {
        let first = [0, 1].map(|a| ((low[a] - self.corner[a]) / self.cell[a] + 1e-6).floor() as isize);
        let last = [0, 1].map(|a| ((high[a] - self.corner[a]) / self.cell[a] - 1e-6).ceil() as isize);
        [first, last]
    }

    fn block(&mut self, area: [[f64; 2]; 2]) {
        let [first, last] = self.touched(area);
        for y in first[1]..last[1] {
            (first[0]..last[0]).for_each(|x| self.shut([x, y]));
        }
    }

    fn light(&mut self, p: [f64; 2], q: [f64; 2]) {
        let [first, last] = self.touched([[p[0].min(q[0]), p[1].min(q[1])], [p[0].max(q[0]), p[1].max(q[1])]]);
        for y in first[1]..last[1].max(first[1] + 1) {
            for x in first[0]..last[0].max(first[0] + 1) {
                if x >= 0 && y >= 0 && (x as usize) < self.size[0] && (y as usize) < self.size[1] {
                    self.bright[x as usize + self.size[0] * y as usize] = true;
                }
            }
        }
    }

    /// Shuts the cells whose middle lies in what is cut.
    fn block_cut(&mut self, poche: &[Loop]) {
        for y in 0..self.size[1] {
            let v = self.corner[1] + (y as f64 + 0.5) * self.cell[1];
            let mut hits: Vec<f64> = Vec::new();
            for l in poche {
                for i in 0..l.len() {
                    let (p, q) = (l[i], l[(i + 1) % l.len()]);
                    if (p[1] > v) != (q[1] > v) {
                        hits.push(p[0] + (v - p[1]) / (q[1] - p[1]) * (q[0] - p[0]));
                    }
                }
            }
            hits.sort_by(f64::total_cmp);
            for pair in hits.chunks_exact(2) {
                let at = |u: f64| ((u - self.corner[0]) / self.cell[0] - 0.5).ceil() as isize;
                (at(pair[0])..at(pair[1])).for_each(|x| self.shut([x, y as isize]));
            }
        }
    }

    fn add_up(&mut self) {
        let [w, h] = self.size;
        self.sums = vec![0; (w + 1) * (h + 1)];
        for y in 0..h {
            for x in 0..w {
                let here = u32::from(!self.open[x + w * y]);
                let s = |x: usize, y: usize| self.sums[x + (w + 1) * y];
                self.sums[x + 1 + (w + 1) * (y + 1)] = here + s(x, y + 1) + s(x + 1, y) - s(x, y);
            }
        }
    }

    /// Whether every cell of a rectangle is clear.
    fn clear(&self, [x, y]: [usize; 2], [w, h]: [usize; 2]) -> bool {
        let s = |x: usize, y: usize| self.sums[x + (self.size[0] + 1) * y];
        x + w <= self.size[0] && y + h <= self.size[1] && s(x + w, y + h) + s(x, y) == s(x + w, y) + s(x, y + h)
    }

    /// Whether a place lies in the clear area.
    pub fn has(&self, p: [f64; 2]) -> bool {
        let at = [0, 1].map(|a| ((p[a] - self.corner[a]) / self.cell[a]).floor());
        let inside = (0..2).all(|a| at[a] >= 0.0 && (at[a] as usize) < self.size[a]);
        inside && self.open[at[0] as usize + self.size[0] * at[1] as usize]
    }

    /// Side and middle of the largest square in the clear area, m.
    pub fn largest_square(&self) -> (f64, [f64; 2]) {
        let [w, h] = self.size;
        let mut sides = vec![0_usize; w * h];
        let mut best = (0, [0, 0]);
        for y in 0..h {
            for x in 0..w {
                if !self.open[x + w * y] {
                    continue;
                }
                let near = if x == 0 || y == 0 {
                    0
                } else {
                    sides[x - 1 + w * y].min(sides[x + w * (y - 1)]).min(sides[x - 1 + w * (y - 1)])
                };
                sides[x + w * y] = near + 1;
                if near + 1 > best.0 {
                    best = (near + 1, [x, y]);
                }
            }
        }
        let (side, [x, y]) = best;
        let half = side as f64 / 2.0;
        let middle = [(x, 0), (y, 1)].map(|(n, a)| self.corner[a] + (n as f64 + 1.0 - half) * self.cell[a]);
        (side as f64 * self.cell[0].min(self.cell[1]), middle)
    }

    /// Cells across and along a room.
    pub(super) fn cells_of(&self, room: Room) -> [usize; 2] {
        self.cell.map(|c| (room.side_m() / c - 1e-6).ceil() as usize)
    }

    /// What lies along the sides of a room: against something, and with a window, east, north, west, south.
    fn sides(&self, [x, y]: [usize; 2], [w, h]: [usize; 2]) -> [[bool; 4]; 2] {
        let strips = [
            ([x + w, y], [1, h]),
            ([x, y + h], [w, 1]),
            ([x.wrapping_sub(1), y], [1, h]),
            ([x, y.wrapping_sub(1)], [w, 1]),
        ];
        let rows =
            |[x, y]: [usize; 2], [w, h]: [usize; 2]| (y..y + h).flat_map(move |v| (x..x + w).map(move |u| [u, v]));
        let against = strips.map(|(at, size)| {
            at[0] == usize::MAX || at[1] == usize::MAX || {
                let shut = rows(at, size)
                    .filter(|p| p[0] >= self.size[0] || p[1] >= self.size[1] || !self.open[p[0] + self.size[0] * p[1]]);
                2 * shut.count() >= size[0] * size[1]
            }
        });
        let edges = [([x + w - 1, y], [1, h]), ([x, y + h - 1], [w, 1]), ([x, y], [1, h]), ([x, y], [w, 1])];
        let lit = edges.map(|(at, size)| rows(at, size).any(|p| self.bright[p[0] + self.size[0] * p[1]]));
        [against, lit]
    }

    /// Every place of a room, the best ones first: in a corner, with a window, a living room with several.
    pub(super) fn places(&self, room: Room) -> Vec<(i32, [usize; 2])> {
        let size = self.cells_of(room);
        let mut places = Vec::new();
        for y in 0..(self.size[1] + 1).saturating_sub(size[1]) {
            for x in 0..(self.size[0] + 1).saturating_sub(size[0]) {
                if self.clear([x, y], size) {
                    let [against, lit] = self.sides([x, y], size);
                    let count = |list: [bool; 4]| list.iter().filter(|b| **b).count() as i32;
                    let corner = (0..4).any(|n| against[n] && against[(n + 1) % 4]);
                    let light =
                        if room == Room::Living { 3 * count(lit) + i32::from(lit[3]) } else { 4 * count(lit).min(1) };
                    places.push((2 * count(against) + 2 * i32::from(corner) + light, [x, y]));
                }
            }
        }
        places.sort_by_key(|(score, at)| (-score, at[1], at[0]));
        places
    }

    /// The room at a place.
    pub(super) fn found(&self, room: Room, at: [usize; 2]) -> Fit {
        let [against, lit] = self.sides(at, self.cells_of(room));
        Fit { room, low: [0, 1].map(|a| self.corner[a] + at[a] as f64 * self.cell[a]), against, lit }
    }
}
