//! What a house is made of, read from its voxels: plates, storeys, openings.

use super::{Direction, Label, Plan};

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
