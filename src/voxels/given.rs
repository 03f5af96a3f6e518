//! Given voxels: a lattice of occupied cells resampled to modules.

use super::lattice::{Lattice, Occupancy, OccupancyError, Values};
use super::{Label, Module, STOREY_MODULES, VoxelArray};

/// How lattice cells become modules.
#[derive(Clone, Debug, PartialEq)]
pub struct Resample {
    /// Modules per lattice cell along x, y, z; `None`: its unit over the module, rounded, at least 1.
    pub cell_modules: Option<[usize; 3]>,
    /// Module at which the first (cropped) lattice cell starts.
    pub offset: [usize; 3],
    /// Set the lowest filled layer on k = 0; the offset along z is then not used.
    pub ground: bool,
    /// Part of the lattice to take: first cell, and the cell past the last.
    pub crop: Option<[[usize; 3]; 2]>,
}

impl Default for Resample {
    fn default() -> Self {
        Resample { cell_modules: None, offset: [0; 3], ground: true, crop: None }
    }
}

/// What the resampling did to the lattice's measures.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ScaleReport {
    /// Modules per lattice cell used.
    pub cell_modules: [usize; 3],
    /// Unit over module, rounded: what would be used by default.
    pub default_cell_modules: [usize; 3],
    /// Size of a cell in modules less its size in the lattice, m.
    pub error_m: [f64; 3],
    /// Size of a cell in modules over its size in the lattice; 1 = true to scale.
    pub scale: [f64; 3],
    /// Occupied lattice cells taken.
    pub cells: usize,
}

/// Which modules a lattice cell covers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct CellMap {
    /// The lattice cell whose modules begin at [`CellMap::offset`]: the first of the crop, on the layer that is set on the ground.
    pub first: [usize; 3],
    /// The cell past the last one taken.
    pub past: [usize; 3],
    /// Modules per cell.
    pub size: [usize; 3],
    /// Its first module.
    pub offset: [usize; 3],
}

impl CellMap {
    /// The lattice cell that covers a module, `None` where the lattice does not reach.
    pub fn cell(&self, module: [usize; 3]) -> Option<[usize; 3]> {
        let mut cell = [0; 3];
        for a in 0..3 {
            cell[a] = self.first[a] + module[a].checked_sub(self.offset[a])? / self.size[a];
        }
        (0..3).all(|a| cell[a] < self.past[a]).then_some(cell)
    }

    /// The first module of a lattice cell, `None` for cells that were not taken.
    pub fn module(&self, cell: [usize; 3]) -> Option<[usize; 3]> {
        let mut module = [0; 3];
        for a in 0..3 {
            module[a] = self.offset[a] + cell[a].checked_sub(self.first[a])? * self.size[a];
        }
        (0..3).all(|a| cell[a] < self.past[a]).then_some(module)
    }
}

/// A lattice in modules.
#[derive(Clone, Debug, PartialEq)]
pub struct Given {
    /// Which modules belong to which cell.
    pub map: CellMap,
    /// Modules along x, y, z.
    pub shape: [usize; 3],
    /// Zone id per module voxel, x fastest; -1 where nothing is given. Lattices of booleans or fields give zone 0.
    pub mask: Vec<i32>,
    /// What happened to the scale.
    pub report: ScaleReport,
}

/// Why a lattice cannot be given.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum GivenError {
    /// The rule does not fit the lattice.
    #[error(transparent)]
    Occupancy(#[from] OccupancyError),
    /// The crop leaves the lattice or is empty.
    #[error(
        "crop {found:?} is empty or leaves the lattice of {shape:?} cells; give the first cell and the one past the last"
    )]
    Crop {
        /// The crop.
        found: [[usize; 3]; 2],
        /// The lattice.
        shape: [usize; 3],
    },
    /// No cell satisfies the rule.
    #[error("no cell of the lattice satisfies `{rule}`; check the occupancy rule and the crop")]
    Nothing {
        /// The rule.
        rule: String,
    },
    /// A cell of no modules, or more modules than can be stored.
    #[error(
        "cell_modules {found:?} with offset {offset:?} gives no array or one of more than {most} voxels; use smaller whole numbers from 1"
    )]
    Size {
        /// Modules per cell.
        found: [usize; 3],
        /// Offset.
        offset: [usize; 3],
        /// Largest number of voxels.
        most: usize,
    },
    /// A field on other cells.
    #[error("the field has {found:?} cells, the lattice {expected:?}: fields lie on the cells of the lattice")]
    FieldShape {
        /// Cells of the field.
        found: [usize; 3],
        /// Cells of the lattice.
        expected: [usize; 3],
    },
    /// A field that is no field.
    #[error(
        "the field holds True and False or values that are no numbers: expected a number of 0 or more for each cell"
    )]
    FieldKind,
    /// A unit or module that is no length.
    #[error("unit {found:?} cannot be compared with the module; give positive lengths")]
    Unit {
        /// The unit.
        found: [f64; 3],
    },
}

/// Largest array that is made, voxels.
const MOST_VOXELS: usize = 64 << 20;

/// Resamples the occupied cells of a lattice to modules.
///
/// Cell (0, 0, 0) of the lattice, or the first of the crop, covers `cell_modules` modules from `offset` on.
///
/// # Errors
/// A rule that does not fit, a crop outside the lattice, no occupied cell, a size that cannot be.
pub fn resample(
    lattice: &Lattice,
    occupancy: &Occupancy,
    module: &Module,
    how: &Resample,
) -> Result<Given, GivenError> {
    let occupied = lattice.mask(occupancy)?;
    let [from, to] = how.crop.unwrap_or([[0; 3], lattice.shape]);
    if (0..3).any(|a| from[a] >= to[a] || to[a] > lattice.shape[a]) {
        return Err(GivenError::Crop { found: [from, to], shape: lattice.shape });
    }
    let inside = |cell: &[usize; 3]| (0..3).all(|a| (from[a]..to[a]).contains(&cell[a]));
    let cells: Vec<([usize; 3], i32)> = lattice
        .cells()
        .enumerate()
        .filter(|(at, cell)| occupied[*at] && inside(cell))
        .map(|(at, cell)| ([0, 1, 2].map(|a| cell[a] - from[a]), zone(&lattice.values, at)))
        .collect();
    let lowest = cells.iter().map(|(c, _)| c[2]).min().ok_or(GivenError::Nothing { rule: occupancy.to_string() })?;
    let report = scale(lattice, module, how, cells.len())?;
    let mut offset = how.offset;
    let sink = if how.ground { lowest } else { 0 };
    if how.ground {
        offset[2] = 0;
    }
    let size = report.cell_modules;
    let shape = extent([0, 1, 2].map(|a| to[a] - from[a] - if a == 2 { sink } else { 0 }), size, offset)?;
    let mut mask = vec![-1; shape.iter().product()];
    for ([x, y, z], zone) in cells {
        let low = [x * size[0] + offset[0], y * size[1] + offset[1], (z - sink) * size[2] + offset[2]];
        for k in low[2]..low[2] + size[2] {
            for j in low[1]..low[1] + size[1] {
                let row = low[0] + shape[0] * (j + shape[1] * k);
                mask[row..row + size[0]].fill(zone);
            }
        }
    }
    let first = [from[0], from[1], from[2] + sink];
    Ok(Given { map: CellMap { first, past: to, size, offset }, shape, mask, report })
}

/// A field on the cells of a lattice that was resampled to `given`, as a value from 0 to 1 for each module of it, x fastest: the lattice's
/// value over the largest one. Cells below 0 count as 0, so do all where nothing is above.
///
/// # Errors
/// A field of another shape, of True and False, or with values that are no numbers.
pub fn field(values: &Lattice, lattice: &Lattice, given: &Given) -> Result<Vec<f64>, GivenError> {
    if values.shape != lattice.shape {
        return Err(GivenError::FieldShape { found: values.shape, expected: lattice.shape });
    }
    let Values::Number(numbers) = &values.values else { return Err(GivenError::FieldKind) };
    if !numbers.iter().all(|v| v.is_finite()) {
        return Err(GivenError::FieldKind);
    }
    let largest = numbers.iter().copied().fold(0.0, f64::max);
    let [nx, ny, _] = given.shape;
    let value = |at: usize| {
        let cell = given.map.cell([at % nx, at / nx % ny, at / (nx * ny)]);
        cell.map_or(0.0, |[x, y, z]| numbers[x + lattice.shape[0] * (y + lattice.shape[1] * z)].max(0.0))
    };
    let scale = if largest > 0.0 { 1.0 / largest } else { 0.0 };
    Ok((0..given.mask.len()).map(|at| value(at) * scale).collect())
}

/// A whole value of 0 or more is a zone id; booleans and fields have one zone, 0.
fn zone(values: &Values, at: usize) -> i32 {
    match values {
        Values::Bool(_) => 0,
        Values::Number(v) if v[at].fract() == 0.0 && (0.0..=f64::from(i32::MAX)).contains(&v[at]) => v[at] as i32,
        Values::Number(_) => 0,
    }
}

fn scale(lattice: &Lattice, module: &Module, how: &Resample, cells: usize) -> Result<ScaleReport, GivenError> {
    let ratio = [0, 1, 2].map(|a| lattice.unit[a] / module.size_m[a]);
    if !ratio.iter().all(|r| r.is_finite() && *r > 0.0) {
        return Err(GivenError::Unit { found: lattice.unit });
    }
    let default_cell_modules = ratio.map(|r| (r.round() as usize).max(1));
    let cell_modules = how.cell_modules.unwrap_or(default_cell_modules);
    let made = [0, 1, 2].map(|a| cell_modules[a] as f64 * module.size_m[a]);
    Ok(ScaleReport {
        cell_modules,
        default_cell_modules,
        error_m: [0, 1, 2].map(|a| made[a] - lattice.unit[a]),
        scale: [0, 1, 2].map(|a| made[a] / lattice.unit[a]),
        cells,
    })
}

fn extent(cells: [usize; 3], size: [usize; 3], offset: [usize; 3]) -> Result<[usize; 3], GivenError> {
    let error = GivenError::Size { found: size, offset, most: MOST_VOXELS };
    let along = |a: usize| cells[a].checked_mul(size[a]).and_then(|n| n.checked_add(offset[a])).filter(|_| size[a] > 0);
    let (Some(x), Some(y), Some(z)) = (along(0), along(1), along(2)) else { return Err(error) };
    let volume = x.checked_mul(y).and_then(|n| n.checked_mul(z));
    volume.filter(|n| *n <= MOST_VOXELS).map(|_| [x, y, z]).ok_or(error)
}

impl Given {
    /// The given voxels with labels by layer: foundation at k = 0, floor at each storey level, base between.
    pub fn to_voxels(&self, module: Module) -> VoxelArray {
        let mut voxels = VoxelArray::new(self.shape);
        voxels.module = module;
        let [nx, ny, _] = self.shape;
        for (at, _) in self.mask.iter().enumerate().filter(|(_, zone)| **zone >= 0) {
            let z = at / (nx * ny);
            voxels.set([at % nx, at / nx % ny, z], plain_label(z));
        }
        voxels
    }
}

/// The label a filled voxel of layer k has where nothing else is said.
pub(super) fn plain_label(k: usize) -> Label {
    match (k, k % STOREY_MODULES) {
        (0, _) => Label::Foundation,
        (_, 0) => Label::Floor,
        _ => Label::Base,
    }
}
