//! What a house is made of, read from its voxels: plates, storeys, openings.

use super::{Direction, Label, Module, Plan};

/// Width of a window frame on each side, m.
pub const FRAME_M: f64 = 0.060;
/// Width of the mullion on each inner module line of a window, m.
pub const MULLION_M: f64 = 0.022;

/// A floor plate: a layer at a storey level (k = 0, 6, 12 ...), the foundation being the first.
#[derive(Clone, Debug, PartialEq)]
pub struct Plate {
    /// Voxel layer.
    pub k: usize,
    /// Filled cells of the layer.
    pub cells: Plan,
    /// Cells that carry slab (floor or foundation).
    pub slab: Plan,
    /// Filled cells without slab: stair voids.
    pub void: Plan,
}

/// The rooms above one plate, up to the next plate or the roof.
#[derive(Clone, Debug, PartialEq)]
pub struct Storey {
    /// 0 = ground storey.
    pub index: usize,
    /// Layer of the plate underneath.
    pub plate_k: usize,
    /// Cells with room over the plate (filled in every layer of the clear height).
    pub plan: Plan,
    /// Clear height in metres between inner surfaces, the smallest outside stair voids.
    pub clear_height_m: f64,
    /// Module cells x plan area of a module, m2.
    pub gross_area_m2: f64,
    /// Net floor area, m2 (HOUSE definitions: inside the lining, headroom 1.5 m, without voids and stair openings).
    pub floor_area_m2: f64,
}

/// A rectangular group of window or opening voxels in one facade.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct FacadeOpening {
    /// `Window` or `Opening` (door).
    pub label: Label,
    /// Storey it belongs to.
    pub storey: usize,
    /// Outward normal of the facade.
    pub facing: Direction,
    /// Plan cell of the voxel column with the smallest coordinate along the facade.
    pub cell: [usize; 2],
    /// Modules along the facade.
    pub width: usize,
    /// Lowest voxel layer.
    pub k: usize,
    /// Modules high.
    pub height: usize,
}

impl FacadeOpening {
    /// Glass less frames, m2: 60 mm of frame on all four sides, a 22 mm mullion on each inner module line. Doors: 0.
    ///
    /// ```
    /// use houscaper::voxels::{Direction, FacadeOpening, Label, Module};
    /// let window = FacadeOpening {
    ///     label: Label::Window, storey: 0, facing: Direction::South, cell: [2, 1], width: 2, k: 2, height: 3,
    /// };
    /// // (1.8 - 0.12 - 0.022) x (1.62 - 0.12)
    /// assert!((window.glass_area_m2(&Module::default()) - 2.487).abs() < 1e-12);
    /// ```
    pub fn glass_area_m2(&self, module: &Module) -> f64 {
        if self.label != Label::Window {
            return 0.0;
        }
        let along = module.size_m[self.along()] * self.width as f64;
        let clear = along - 2.0 * FRAME_M - MULLION_M * (self.width as f64 - 1.0);
        let height = module.size_m[2] * self.height as f64 - 2.0 * FRAME_M;
        clear.max(0.0) * height.max(0.0)
    }

    /// Plan axis along the facade: 0 = x (facing north or south), 1 = y.
    #[inline]
    pub fn along(&self) -> usize {
        match self.facing {
            Direction::North | Direction::South => 0,
            Direction::East | Direction::West => 1,
        }
    }

    /// The plan cell of column `n` (0 .. width) counted along the facade, moved `out` cells outwards (negative: inwards).
    #[inline]
    pub fn column(&self, n: isize, out: isize) -> [isize; 2] {
        let step = self.facing.step();
        let mut cell = [self.cell[0] as isize + out * step[0], self.cell[1] as isize + out * step[1]];
        cell[self.along()] += n;
        cell
    }

    /// Whether column `n` begins at the top of the slab it stands on, half a module below its lowest voxel's lower side, as solids are
    /// built. Before a deck it begins on the upstand, at the voxel's lower side.
    pub fn reaches_slab(&self, voxels: &super::VoxelArray, n: usize) -> bool {
        let label = |out: isize, k: usize| {
            let [x, y] = self.column(n as isize, out);
            voxels.at([x, y, k as isize])
        };
        self.k.checked_sub(1).is_some_and(|k| label(0, k).is_slab() && !label(1, k).is_filled())
    }

    /// All voxels of the opening, lowest row first.
    pub fn voxels(&self) -> impl Iterator<Item = [usize; 3]> + '_ {
        (0..self.height).flat_map(move |row| {
            (0..self.width).map(move |n| {
                let mut cell = self.cell;
                cell[self.along()] += n;
                [cell[0], cell[1], self.k + row]
            })
        })
    }
}

/// A house read as a building.
#[derive(Clone, Debug, PartialEq, Default)]
pub struct Reading {
    /// Foundation and floor plates, lowest first.
    pub plates: Vec<Plate>,
    /// Storeys, lowest first (a roof space without standing room is none).
    pub storeys: Vec<Storey>,
    /// Windows and doors.
    pub openings: Vec<FacadeOpening>,
}
