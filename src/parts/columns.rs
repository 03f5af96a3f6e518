//! What stands in each plan cell, one bit a layer: cubes read as columns, as the tiles do.

use super::PartsError;
use crate::tiles::centre_height;
use crate::voxels::{Direction, VoxelArray};

/// Layers that fit into a column; the top bits stay free for shifts.
const LAYERS: usize = 120;

/// Filled and slab voxels of each cell, in a plan with an empty border. Bit k is layer k; a bit of a *kind* stands for the cube
/// between the centres of layers k and k + 1.
pub(super) struct Columns {
    /// Cells along x and y without the border.
    pub size: [usize; 2],
    width: usize,
    filled: Vec<u128>,
    slab: Vec<u128>,
    /// [`Kinds::roof`], which heights ask for most.
    roof: Vec<u128>,
}

/// The kinds of one column, a bit a cube.
#[derive(Clone, Copy)]
pub(super) struct Kinds {
    /// Filled below and above.
    pub full: u128,
    /// Filled below only, no slab.
    pub roof: u128,
    /// Filled below only, with a slab.
    pub deck: u128,
    /// Filled above only.
    pub floor: u128,
}

impl Kinds {
    /// Not filled.
    pub fn empty(self) -> u128 {
        !(self.full | self.roof | self.deck | self.floor)
    }
}

impl Columns {
    pub fn new(voxels: &VoxelArray) -> Result<Columns, PartsError> {
        let [nx, ny, nz] = voxels.shape();
        if nz > LAYERS {
            return Err(PartsError::TooHigh { found: nz, limit: LAYERS });
        }
        let width = nx + 2;
        let (mut filled, mut slab) = (vec![0u128; width * (ny + 2)], vec![0u128; width * (ny + 2)]);
        for (row, labels) in voxels.labels().chunks_exact(nx.max(1)).enumerate() {
            if labels.iter().all(|label| !label.is_filled()) {
                continue;
            }
            let (y, z) = (row % ny, row / ny);
            let bit = |is_set: bool| if is_set { 1u128 << z } else { 0 };
            let at = 1 + width * (y + 1);
            let (f, s) = (&mut filled[at..at + nx], &mut slab[at..at + nx]);
            for ((f, s), label) in f.iter_mut().zip(s).zip(labels) {
                *f |= bit(label.is_filled());
                *s |= bit(label.is_slab());
            }
        }
        let roof = filled.iter().zip(&slab).map(|(f, s)| f & !(f >> 1) & !s).collect();
        Ok(Columns { size: [nx, ny], width, filled, slab, roof })
    }

    /// Index of a cell.
    #[inline]
    pub fn at(&self, [x, y]: [usize; 2]) -> usize {
        x + 1 + self.width * (y + 1)
    }

    /// Distance in indices to the neighbour in a direction.
    #[inline]
    pub fn step(&self, direction: Direction) -> isize {
        let [dx, dy] = direction.step();
        dx + dy * self.width as isize
    }

    /// Number of indices.
    pub fn len(&self) -> usize {
        self.filled.len()
    }

    #[inline]
    pub fn filled(&self, at: usize) -> u128 {
        self.filled[at]
    }

    #[inline]
    pub fn slab(&self, at: usize) -> u128 {
        self.slab[at]
    }

    /// The cubes of a column in which it is a roof.
    #[inline]
    pub fn roof(&self, at: usize) -> u128 {
        self.roof[at]
    }

    #[inline]
    pub fn kinds(&self, at: usize) -> Kinds {
        let (below, above) = (self.filled[at], self.filled[at] >> 1);
        let open = below & !above;
        Kinds { full: below & above, roof: open & !self.slab[at], deck: open & self.slab[at], floor: !below & above }
    }

    /// Height of the roof of cube k at the middle of the cell's side towards `d`, 0 to 2 half modules above the top voxel's centre: 1 is
    /// level, 0 falls to that side, 2 rises. The cell must be a roof in cube k. See the tiles' face numbers.
    pub fn roof_height(&self, at: usize, k: usize, d: Direction) -> u8 {
        if let Some(height) = self.direct(at.wrapping_add_signed(self.step(d)), k) {
            return height;
        }
        let (own, open) = self.own_height(at, k, d);
        if !open {
            return own;
        }
        // A hip's corner stays down: the lower of the neighbours along the same free edge counts.
        [d.left(), d.left().back()].into_iter().fold(own, |height, side| {
            let beside = at.wrapping_add_signed(self.step(side));
            let is_roof = |c: usize| self.roof[c] >> k & 1 == 1;
            if !is_roof(beside) {
                height
            } else if !is_roof(beside.wrapping_add_signed(self.step(d))) {
                height.min(self.own_height(beside, k, d).0)
            } else if self.direct(beside.wrapping_add_signed(-self.step(d)), k) == Some(2) {
                // Beside a valley the edge is that of a hipped bay.
                0
            } else {
                height
            }
        })
    }

    /// The height from the cell's own row, and whether its edge is free.
    fn own_height(&self, at: usize, k: usize, d: Direction) -> (u8, bool) {
        let near = at.wrapping_add_signed(self.step(d));
        let behind = at.wrapping_add_signed(-self.step(d));
        if let Some(height) = self.direct(near, k) {
            return (height, false);
        }
        let is_full = |c: usize| self.filled[c] >> k & 3 == 3;
        let (wall, backed) = (is_full(near), is_full(behind));
        let own = match (self.direct(behind, k), wall, backed) {
            (Some(height), _, _) => 2 - height,
            (None, true, false) => 2,
            (None, true, true) | (None, false, false) => 1,
            (None, false, true) => 0,
        };
        (own, !wall)
    }

    /// Height that a neighbouring roof gives: level, one step up, one step down; `None` where it is no roof.
    #[inline]
    fn direct(&self, at: usize, k: usize) -> Option<u8> {
        let roof = self.roof[at];
        match (self.filled[at] >> k) as u8 & 3 {
            0b01 => (roof >> k & 1 == 1).then_some(1),
            0b11 => (roof >> (k + 1) & 1 == 1).then_some(2),
            0b00 => (k > 0 && roof >> (k - 1) & 1 == 1).then_some(0),
            _ => None,
        }
    }

    /// Whether a label stands at a cell and layer; for tests of voxels outside, false.
    #[inline]
    pub fn has(&self, at: usize, k: usize) -> bool {
        self.filled[at] >> k & 1 == 1
    }
}

/// Roof heights towards the four sides, asked for once a column and layer.
pub(super) struct Heights<'c> {
    columns: &'c Columns,
    /// By column the layer last asked for and its heights in the order of [`Direction::ALL`].
    known: Vec<(u8, [u8; 4])>,
}

impl Heights<'_> {
    pub fn new(columns: &Columns) -> Heights<'_> {
        Heights { columns, known: vec![(u8::MAX, [0; 4]); columns.len()] }
    }

    /// [`Columns::roof_height`] towards all sides.
    pub fn of(&mut self, at: usize, k: usize) -> [u8; 4] {
        let (layer, heights) = self.known[at];
        if usize::from(layer) == k {
            return heights;
        }
        let heights = Direction::ALL.map(|d| self.columns.roof_height(at, k, d));
        self.known[at] = (k as u8, heights);
        heights
    }

    /// Height of the roofs of cube k over the middle of the cube that has the cell at its corner, towards both directions `out`, by the
    /// rule of the tiles.
    pub fn centre(&mut self, at: usize, k: usize, out: [Direction; 2]) -> u8 {
        let mids: [_; 4] = std::array::from_fn(|turn| {
            let (mut cell, mut towards) = (at, out);
            for axis in 0..2 {
                if turn >> axis & 1 == 1 {
                    cell = cell.wrapping_add_signed(self.columns.step(out[axis]));
                    towards[axis] = out[axis].back();
                }
            }
            let is_roof = self.columns.roof(cell) >> k & 1 == 1;
            is_roof.then(|| {
                let heights = self.of(cell, k);
                towards.map(|d| i32::from(heights[d as usize]))
            })
        });
        centre_height(mids.into_iter().flatten()) as u8
    }
}
