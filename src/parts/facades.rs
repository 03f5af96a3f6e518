//! Where facades stand: half modules by cell, level and direction.

use super::columns::Columns;
use crate::voxels::{Direction, STOREY_MODULES};

/// Half modules of facade of every cell by level and direction: bit h is half module h above the slab of the level's plate.
pub(super) struct Facades {
    masks: Vec<u16>,
    /// Whether a facade stands in a row (x or y, across the direction) of a level and direction.
    lines: Vec<bool>,
    len: usize,
    most: usize,
    pub levels: usize,
}

/// Six bits moved to the even places of twelve.
const SPREAD: [u16; 64] = {
    let mut table = [0; 64];
    let mut n = 0;
    while n < 64 {
        let mut bit = 0;
        while bit < 6 {
            table[n] |= ((n as u16 >> bit) & 1) << (2 * bit);
            bit += 1;
        }
        n += 1;
    }
    table
};

impl Facades {
    pub fn new(columns: &Columns, layers: usize) -> Facades {
        let (len, levels) = (columns.len(), layers.div_ceil(STOREY_MODULES));
        let [nx, ny] = columns.size;
        let most = nx.max(ny);
        let (masks, lines) = (vec![0; len * 4 * levels], vec![false; most * 4 * levels]);
        let mut facades = Facades { masks, lines, len, most, levels };
        for y in 0..ny {
            for x in 0..nx {
                let at = columns.at([x, y]);
                if columns.filled(at) != 0 {
                    Direction::ALL.into_iter().for_each(|d| facades.read(columns, [x, y], at, d));
                }
            }
        }
        facades
    }

    /// Reads the border of a cell towards `d`. A wall stands where the cell is full and the neighbour is not, down to a roof, deck or
    /// underside in front, but not where a roof goes on one voxel higher; at the edge of a floor over the outside; and where a roof
    /// ends above its top voxel's centre.
    fn read(&mut self, columns: &Columns, cell: [usize; 2], at: usize, d: Direction) {
        let beside = at.wrapping_add_signed(columns.step(d));
        let same = columns.filled(at) == columns.filled(beside) && columns.slab(at) == columns.slab(beside);
        if same {
            return;
        }
        let (own, near) = (columns.kinds(at), columns.kinds(beside));
        let free = near.empty() | near.deck;
        let stopped = free | (near.roof & !(own.roof >> 1));
        let mut lower = own.full & (stopped | near.floor);
        let mut upper = (own.full & stopped) | (own.floor & free);
        let mut edges = own.roof & free & !(near.roof << 1);
        while edges != 0 {
            let k = edges.trailing_zeros() as usize;
            edges &= edges - 1;
            let height = columns.roof_height(at, k, d);
            lower |= u128::from(height >= 1) << k;
            upper |= u128::from(height >= 2) << k;
        }
        if lower | upper == 0 {
            return;
        }
        for level in 0..self.levels {
            let six = |mask: u128| SPREAD[(mask >> (STOREY_MODULES * level)) as usize & 63];
            let mask = six(lower) | six(upper) << 1;
            let sheet = level * 4 + d as usize;
            self.masks[sheet * self.len + at] = mask;
            self.lines[sheet * self.most + cell[usize::from(d.step()[0] == 0)]] |= mask != 0;
        }
    }

    /// Whether a facade stands anywhere in a row of cells.
    pub fn stands(&self, level: usize, d: Direction, line: usize) -> bool {
        self.lines[(level * 4 + d as usize) * self.most + line]
    }

    /// Half modules of facade along x and along y.
    pub fn lengths(&self) -> [u32; 2] {
        let mut sum = [0; 2];
        for (sheet, masks) in self.masks.chunks_exact(self.len).enumerate() {
            let along_x = matches!(Direction::ALL[sheet % 4], Direction::North | Direction::South);
            sum[usize::from(!along_x)] += masks.iter().map(|m| m.count_ones()).sum::<u32>();
        }
        sum
    }

    #[inline]
    pub fn mask(&self, level: usize, d: Direction, at: usize) -> u16 {
        self.masks[(level * 4 + d as usize) * self.len + at]
    }
}
