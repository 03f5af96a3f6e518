//! A set of plan cells as one 64-bit word per row, with the few morphological operations that plan rules need.

use crate::voxels::Plan;

/// Widest plan a [`Cells`] holds: a row and a margin of [`Cells::MARGIN`] on both sides fit one 64-bit word.
pub const WIDEST: usize = 58;

/// A set of cells of an nx x ny plan, nx at most [`WIDEST`]. Bit x of row y is cell (x, y); cells outside are not in the set.
#[derive(Clone, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Cells {
    nx: usize,
    rows: Vec<u64>,
}

impl Cells {
    /// Empty cells around a plan within which gaps and courts are judged.
    pub const MARGIN: usize = 3;

    /// The empty set. A width above 64 is cut to 64.
    pub fn new([nx, ny]: [usize; 2]) -> Self {
        Cells { nx: nx.min(64), rows: vec![0; ny] }
    }

    /// All cells of a plan.
    pub fn full(size: [usize; 2]) -> Self {
        let mut all = Cells::new(size);
        let mask = all.mask();
        all.rows.fill(mask);
        all
    }

    /// The cells of a rectangle, clipped to the plan.
    pub fn rect(size: [usize; 2], [x, y]: [isize; 2], [w, h]: [usize; 2]) -> Self {
        let mut out = Cells::new(size);
        let (x0, x1) = (x.max(0), (x + w as isize).min(out.nx as isize));
        let (y0, y1) = (y.max(0), (y + h as isize).min(out.rows.len() as isize));
        if x0 < x1 {
            let bits = low(x1 as usize) & !low(x0 as usize);
            (y0..y1).for_each(|y| out.rows[y as usize] = bits);
        }
        out
    }

    /// The same set as a [`Plan`] read from voxels.
    pub fn from_plan(plan: &Plan) -> Self {
        let mut out = Cells::new(plan.size());
        plan.iter().for_each(|cell| out.set(cell, true));
        out
    }

    /// This set as a [`Plan`].
    pub fn to_plan(&self) -> Plan {
        let mut out = Plan::new(self.size());
        self.iter().for_each(|cell| out.set(cell, true));
        out
    }

    #[inline]
    fn mask(&self) -> u64 {
        low(self.nx)
    }

    /// Cells along x and y.
    #[inline]
    pub fn size(&self) -> [usize; 2] {
        [self.nx, self.rows.len()]
    }

    /// One row as bits.
    #[inline]
    pub fn row(&self, y: usize) -> u64 {
        self.rows[y]
    }

    /// Whether a cell is in the set; false outside the plan.
    #[inline]
    pub fn has(&self, [x, y]: [isize; 2]) -> bool {
        x >= 0
            && y >= 0
            && x < self.nx as isize
            && (y as usize) < self.rows.len()
            && self.rows[y as usize] >> x & 1 == 1
    }

    /// Puts a cell in the set or takes it out; cells outside the plan are ignored.
    #[inline]
    pub fn set(&mut self, [x, y]: [usize; 2], value: bool) {
        if x < self.nx && y < self.rows.len() {
            let bit = 1 << x;
            self.rows[y] = if value { self.rows[y] | bit } else { self.rows[y] & !bit };
        }
    }

    /// Number of cells in the set.
    pub fn count(&self) -> usize {
        self.rows.iter().map(|r| r.count_ones() as usize).sum()
    }

    /// Whether no cell is in the set.
    pub fn is_empty(&self) -> bool {
        self.rows.iter().all(|&r| r == 0)
    }

    fn zip(&self, other: &Cells, op: impl Fn(u64, u64) -> u64) -> Cells {
        Cells { nx: self.nx, rows: self.rows.iter().zip(&other.rows).map(|(&a, &b)| op(a, b)).collect() }
    }

    /// Cells in either set; both have the same plan, here and below.
    pub fn or(&self, other: &Cells) -> Cells {
        self.zip(other, |a, b| a | b)
    }

    /// Cells in both sets.
    pub fn and(&self, other: &Cells) -> Cells {
        self.zip(other, |a, b| a & b)
    }

    /// Cells of this set that are not in the other.
    pub fn minus(&self, other: &Cells) -> Cells {
        self.zip(other, |a, b| a & !b)
    }

    /// Whether every cell of `other` is in this set.
    pub fn contains(&self, other: &Cells) -> bool {
        self.rows.iter().zip(&other.rows).all(|(a, b)| b & !a == 0)
    }

    /// Whether the sets share a cell.
    pub fn meets(&self, other: &Cells) -> bool {
        self.rows.iter().zip(&other.rows).any(|(a, b)| a & b != 0)
    }

    /// The set moved by (dx, dy); what leaves the plan is lost.
    pub fn shifted(&self, [dx, dy]: [isize; 2]) -> Cells {
        let mut out = Cells::new(self.size());
        let mask = self.mask();
        for (y, &row) in self.rows.iter().enumerate() {
            let to = y as isize + dy;
            if to >= 0 && (to as usize) < out.rows.len() && dx.unsigned_abs() < 64 {
                out.rows[to as usize] = if dx >= 0 { row << dx } else { row >> -dx } & mask;
            }
        }
        out
    }

    /// The union of all k x k blocks inside the set (morphological opening).
    pub fn blocks(&self, k: usize) -> Cells {
        let ny = self.rows.len();
        let mut out = Cells::new(self.size());
        for y in 0..(ny + 1).saturating_sub(k) {
            let all = self.rows[y..y + k].iter().fold(u64::MAX, |a, r| a & r);
            let corner = (1..k).fold(all, |c, i| c & all >> i);
            let block = (1..k).fold(corner, |c, i| c | corner << i);
            out.rows[y..y + k].iter_mut().for_each(|r| *r |= block);
        }
        out
    }

    /// Cells whose eight neighbours are all in the set.
    pub fn inner(&self) -> Cells {
        let ny = self.rows.len();
        let mut out = Cells::new(self.size());
        for y in 1..ny.saturating_sub(1) {
            let column = self.rows[y - 1] & self.rows[y] & self.rows[y + 1];
            out.rows[y] = column & column << 1 & column >> 1;
        }
        out
    }

    /// Whether two cells in or two cells out of the set touch at a corner only.
    pub fn touches_diagonally(&self) -> bool {
        self.rows.windows(2).any(|pair| {
            let (a, b) = (pair[0], pair[1]);
            (a & !(a >> 1) & !b & b >> 1) | (!a & a >> 1 & b & !(b >> 1)) != 0
        })
    }

    /// The edge-connected part of the set that holds `seed`; empty when `seed` is not in the set.
    pub fn component(&self, seed: [isize; 2]) -> Cells {
        let mut part = Cells::new(self.size());
        if !self.has(seed) {
            return part;
        }
        part.rows[seed[1] as usize] = 1 << seed[0];
        let ny = self.rows.len();
        loop {
            let mut changed = false;
            for y in (0..ny).chain((0..ny).rev()) {
                let above = if y > 0 { part.rows[y - 1] } else { 0 };
                let below = if y + 1 < ny { part.rows[y + 1] } else { 0 };
                let grown = fill_runs(part.rows[y] | above | below, self.rows[y]);
                changed |= grown != part.rows[y];
                part.rows[y] = grown;
            }
            if !changed {
                return part;
            }
        }
    }

    /// The lowest cell, row by row.
    pub fn first(&self) -> Option<[isize; 2]> {
        let y = self.rows.iter().position(|&r| r != 0)?;
        Some([self.rows[y].trailing_zeros() as isize, y as isize])
    }

    /// Whether the set is one edge-connected part (false when empty).
    pub fn is_connected(&self) -> bool {
        self.first().is_some_and(|seed| self.component(seed) == *self)
    }

    /// The cells in the set, x fastest.
    pub fn iter(&self) -> impl Iterator<Item = [usize; 2]> + '_ {
        self.rows.iter().enumerate().flat_map(|(y, &row)| bits(row).map(move |x| [x, y]))
    }

    /// The empty cells of the plan and of a margin around it, as a plan of its own.
    pub fn outside(&self) -> Cells {
        let m = Self::MARGIN;
        let mut out = Cells::full([self.nx + 2 * m, self.rows.len() + 2 * m]);
        let mask = out.mask();
        for (y, &row) in self.rows.iter().enumerate() {
            out.rows[y + m] = !(row << m) & mask;
        }
        out
    }

    /// The smallest box around the set as (corner, size); `None` when empty.
    pub fn bounds(&self) -> Option<([usize; 2], [usize; 2])> {
        let y0 = self.rows.iter().position(|&r| r != 0)?;
        let y1 = self.rows.iter().rposition(|&r| r != 0)?;
        let any = self.rows.iter().fold(0, |a, r| a | r);
        let x0 = any.trailing_zeros() as usize;
        Some(([x0, y0], [64 - any.leading_zeros() as usize - x0, y1 - y0 + 1]))
    }

    /// Number of cell edges between the set and its outside.
    pub fn perimeter(&self) -> usize {
        let mut edges = 0;
        let mut above = 0;
        for &row in self.rows.iter().chain(&[0]) {
            edges += (row ^ above).count_ones() + 2 * (row & !(row << 1)).count_ones();
            above = row;
        }
        edges as usize
    }
}

/// The lowest n bits set.
#[inline]
fn low(n: usize) -> u64 {
    if n >= 64 { u64::MAX } else { (1 << n) - 1 }
}

/// Positions of the set bits, lowest first.
#[inline]
fn bits(mut row: u64) -> impl Iterator<Item = usize> {
    std::iter::from_fn(move || {
        let x = row.trailing_zeros();
        (row != 0).then(|| {
            row &= row - 1;
            x as usize
        })
    })
}

/// The runs of `row` that hold at least one bit of `seeds`.
#[inline]
fn fill_runs(seeds: u64, row: u64) -> u64 {
    let mut part = seeds & row;
    loop {
        let next = (part | part << 1 | part >> 1) & row;
        if next == part {
            return part;
        }
        part = next;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn drawn(rows: &[&str]) -> Cells {
        let mut out = Cells::new([rows[0].len(), rows.len()]);
        for (y, row) in rows.iter().enumerate() {
            row.bytes().enumerate().filter(|(_, b)| *b == b'#').for_each(|(x, _)| out.set([x, y], true));
        }
        out
    }

    /// All 512 patterns on 3 x 3 cells: every operation against its definition, cell by cell.
    #[test]
    fn operations_equal_their_definitions_on_all_small_plans() {
        for pattern in 0..512u32 {
            let mut set = Cells::new([3, 3]);
            (0..9).filter(|i| pattern >> i & 1 == 1).for_each(|i| set.set([i % 3, i / 3], true));
            let has = |x: isize, y: isize| set.has([x, y]);
            assert_eq!(set.inner().count() == 1, pattern == 511);
            assert_eq!(set.blocks(3).is_empty(), pattern != 511);
            let diagonal = (0..2).any(|y| {
                (0..2).any(|x| {
                    has(x, y) == has(x + 1, y + 1) && has(x + 1, y) == has(x, y + 1) && has(x, y) != has(x + 1, y)
                })
            });
            assert_eq!(set.touches_diagonally(), diagonal);
            let edges: usize = set
                .iter()
                .map(|[x, y]| {
                    let (x, y) = (x as isize, y as isize);
                    [(1, 0), (-1, 0), (0, 1), (0, -1)].iter().filter(|(a, b)| !has(x + a, y + b)).count()
                })
                .sum();
            assert_eq!(set.perimeter(), edges);
            let squares = (0..2).flat_map(|y| (0..2).map(move |x| [x, y]));
            let mut union = Cells::new([3, 3]);
            for [x, y] in squares {
                let block = Cells::rect([3, 3], [x, y], [2, 2]);
                if set.contains(&block) {
                    union = union.or(&block);
                }
            }
            assert_eq!(set.blocks(2), union);
            assert_eq!(Cells::from_plan(&set.to_plan()), set);
        }
    }

    #[test]
    fn components_follow_a_spiral() {
        let spiral = drawn(&["#####", "....#", "###.#", "#...#", "#####"]);
        assert!(spiral.is_connected());
        let cut = drawn(&["#####", "....#", "###..", "#...#", "#####"]);
        assert!(!cut.is_connected());
        assert_eq!(cut.component([0, 0]).count(), 6);
        assert!(!Cells::new([4, 4]).is_connected());
    }

    #[test]
    fn shifting_loses_what_leaves_the_plan() {
        let row = drawn(&["##..", "#..."]);
        assert_eq!(row.shifted([-1, 0]), drawn(&["#...", "...."]));
        assert_eq!(row.shifted([3, 1]), drawn(&["....", "...#"]));
        assert_eq!(row.bounds(), Some(([0, 0], [2, 2])));
        assert_eq!(Cells::rect([4, 2], [-1, -1], [3, 9]), drawn(&["##..", "##.."]));
    }
}
