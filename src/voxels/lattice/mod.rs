//! Lattice CSV of topoGenesis, both kinds, byte for byte; and the rule that says which values are occupied.
//!
//! The newer kind begins with `minbound,shape,unit` and the x, y, z rows of those columns, a blank line, `IX,IY,IZ,value` and
//! every voxel in C order (z fastest). The older kind has the voxels only, in C order or with x fastest.
//! Source: topoGenesis 0.0.13, `lattice.to_csv` and `lattice_from_csv`.

mod npy;
mod number;
mod occupancy;
mod read;
mod write;

pub use npy::{NpyError, read_npy, write_npy};
pub use occupancy::{Occupancy, OccupancyError};
pub use read::read_lattice;
pub use write::write_lattice;

use super::{Label, Module, VoxelArray};

/// The values of a lattice, x fastest: index `x + nx (y + ny z)`.
#[derive(Clone, Debug, PartialEq)]
pub enum Values {
    /// `True` and `False`.
    Bool(Vec<bool>),
    /// Integers and floats.
    Number(Vec<f64>),
}

/// Order of the rows in a file.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum RowOrder {
    /// z fastest, as topoGenesis writes.
    #[default]
    C,
    /// x fastest, as some files of the older kind have it.
    F,
}

/// How a file was written, so that it can be written again byte for byte.
#[derive(Clone, Debug, PartialEq)]
pub struct Style {
    /// Whether the metadata rows stand in front.
    pub metadata: bool,
    /// Order of the rows.
    pub order: RowOrder,
    /// Name of the fourth column.
    pub value_column: String,
    /// Carriage returns before each line feed, as runs of (carriage returns, lines); the last run goes on to the end.
    endings: Vec<(u8, usize)>,
    /// Empty lines after the last row.
    trailing_blank: usize,
    /// Whether the last line ends with a line feed.
    final_newline: bool,
    /// Numbers spelled in another way than ours: (metadata cell or value position in file order, text).
    spelled_meta: Vec<(usize, String)>,
    spelled: Vec<(usize, String)>,
}

impl Default for Style {
    /// The newer kind with LF, ending with one newline.
    fn default() -> Self {
        Style {
            metadata: true,
            order: RowOrder::C,
            value_column: "value".into(),
            endings: Vec::new(),
            trailing_blank: 0,
            final_newline: true,
            spelled_meta: Vec::new(),
            spelled: Vec::new(),
        }
    }
}

/// A lattice: values on a box of cells.
#[derive(Clone, Debug, PartialEq)]
pub struct Lattice {
    /// Cells along x, y, z.
    pub shape: [usize; 3],
    /// Centre of cell (0, 0, 0) in metres.
    pub minbound: [f64; 3],
    /// Size of a cell in metres; 1 where the file does not say.
    pub unit: [f64; 3],
    /// One value per cell.
    pub values: Values,
    /// How the file looked.
    pub style: Style,
}

/// What is wrong with a lattice.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum LatticeError {
    /// A line that does not read as it should.
    #[error("{file}:{line}: found `{found}`, expected {expected}")]
    Line {
        /// Name of the source.
        file: String,
        /// Line, from 1.
        line: usize,
        /// Text found.
        found: String,
        /// What should stand there, and what to do.
        expected: String,
    },
    /// A row out of order: shuffled, missing or repeated.
    #[error(
        "{file}:{line}: row of cell {found:?} where {expected:?} should stand: {cause}; write every cell once, in order"
    )]
    Order {
        /// Name of the source.
        file: String,
        /// Line, from 1.
        line: usize,
        /// Index found.
        found: [usize; 3],
        /// Index expected.
        expected: [usize; 3],
        /// Shuffled, missing or repeated.
        cause: &'static str,
    },
    /// Too few or too many rows.
    #[error("{file}:{line}: {found} rows for a shape of {shape:?}, expected {expected}; write every cell once")]
    Count {
        /// Name of the source.
        file: String,
        /// Last line.
        line: usize,
        /// Rows found.
        found: usize,
        /// Rows expected.
        expected: usize,
        /// Shape of the lattice.
        shape: [usize; 3],
    },
    /// A value that is no label.
    #[error(
        "cell {cell:?} has value {found}, which is no label; labels are 0 to 5, so give an occupancy rule for other lattices"
    )]
    Label {
        /// The cell.
        cell: [usize; 3],
        /// Its value.
        found: String,
    },
    /// A unit that is no size of a module.
    #[error("unit {found:?} is not positive and finite on each axis")]
    Unit {
        /// The unit.
        found: [f64; 3],
    },
}

impl Lattice {
    /// A lattice of the newer kind; `None` when the number of values is not nx ny nz.
    pub fn new(shape: [usize; 3], minbound: [f64; 3], unit: [f64; 3], values: Values) -> Option<Self> {
        let count = match &values {
            Values::Bool(v) => v.len(),
            Values::Number(v) => v.len(),
        };
        (count == shape.iter().product::<usize>()).then(|| Lattice {
            shape,
            minbound,
            unit,
            values,
            style: Style::default(),
        })
    }

    /// The labels of an array as numbers 0 to 5, with its origin and module.
    pub fn from_voxels(voxels: &VoxelArray) -> Self {
        Lattice {
            shape: voxels.shape(),
            minbound: voxels.origin_m,
            unit: voxels.module.size_m,
            values: Values::Number(voxels.labels().iter().map(|l| f64::from(l.code())).collect()),
            style: Style::default(),
        }
    }

    /// Reads the values as labels.
    ///
    /// # Errors
    /// Booleans, values other than 0 to 5, a unit that is not positive.
    pub fn to_voxels(&self) -> Result<VoxelArray, LatticeError> {
        let mut voxels = VoxelArray::new(self.shape);
        if !self.unit.iter().all(|u| u.is_finite() && *u > 0.0) {
            return Err(LatticeError::Unit { found: self.unit });
        }
        voxels.module = Module { size_m: self.unit };
        voxels.origin_m = self.minbound;
        for (at, cell) in self.cells().enumerate() {
            let value = match &self.values {
                Values::Bool(v) => Err(if v[at] { "True".to_string() } else { "False".to_string() }),
                Values::Number(v) => Label::ALL.iter().find(|l| f64::from(l.code()) == v[at]).ok_or(v[at].to_string()),
            };
            let label = value.map_err(|found| LatticeError::Label { cell, found })?;
            voxels.set(cell, *label);
        }
        Ok(voxels)
    }

    /// Which cells are occupied by a rule, x fastest.
    ///
    /// # Errors
    /// A rule for numbers on a lattice of True and False, or the other way round.
    pub fn mask(&self, occupancy: &Occupancy) -> Result<Vec<bool>, OccupancyError> {
        occupancy.mask(&self.values)
    }

    /// Every cell in storage order, x fastest.
    pub fn cells(&self) -> impl Iterator<Item = [usize; 3]> + use<> {
        let [nx, ny, nz] = self.shape;
        (0..nz).flat_map(move |z| (0..ny).flat_map(move |y| (0..nx).map(move |x| [x, y, z])))
    }
}

/// The cell of row `n` of a file.
fn cell_of_row(n: usize, [nx, ny, nz]: [usize; 3], order: RowOrder) -> [usize; 3] {
    match order {
        RowOrder::C => [n / (ny * nz), n / nz % ny, n % nz],
        RowOrder::F => [n % nx, n / nx % ny, n / (nx * ny)],
    }
}
