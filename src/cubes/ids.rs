//! Cube ids: the thesis's base-6 number in two corner orders, and topoGenesis's binary one.

use super::{Corner, Mask, cube_labels, cube_shape};
use crate::voxels::{Label, VoxelArray};

/// The order in which the eight corners are read as digits.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum CornerOrder {
    /// Corner j = x + 2y + 4z, x fastest. Ours and the thesis text's.
    #[default]
    FOrder,
    /// 000 100 110 010 001 101 111 011, as Rhino's BoxCorners lists them and the thesis's code read them.
    BoxCorners,
}

impl CornerOrder {
    /// Corner numbers in reading order.
    pub const fn corners(self) -> [usize; 8] {
        match self {
            CornerOrder::FOrder => [0, 1, 2, 3, 4, 5, 6, 7],
            CornerOrder::BoxCorners => [0, 1, 3, 2, 4, 5, 7, 6],
        }
    }

    /// Name in files.
    pub fn name(self) -> &'static str {
        match self {
            CornerOrder::FOrder => "f_order",
            CornerOrder::BoxCorners => "box_corners",
        }
    }

    /// The order of a name in a file; `None` for any other.
    pub fn from_name(name: &str) -> Option<CornerOrder> {
        [CornerOrder::FOrder, CornerOrder::BoxCorners].into_iter().find(|o| o.name() == name)
    }
}

/// The thesis's cube id: the labels as digits in base 6, first corner most significant, `sum label_j 6^(7-j)`.
/// Which corner is the first says the [`CornerOrder`] it was made with.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct ThesisId(pub u32);

impl ThesisId {
    /// Number of ids, 6^8.
    pub const COUNT: u32 = 1_679_616;

    /// The id of eight labels given in corner order.
    pub fn new(labels: &[Label; 8], order: CornerOrder) -> ThesisId {
        ThesisId(order.corners().iter().fold(0, |id, &c| id * 6 + u32::from(labels[c].code())))
    }

    /// The eight labels in corner order; `None` when the id is not below 6^8.
    pub fn labels(self, order: CornerOrder) -> Option<[Label; 8]> {
        if self.0 >= Self::COUNT {
            return None;
        }
        let mut labels = [Label::Empty; 8];
        let mut rest = self.0;
        for &corner in order.corners().iter().rev() {
            labels[corner] = Label::from_code((rest % 6) as u8)?;
            rest /= 6;
        }
        Some(labels)
    }

    /// The same cube's id in another corner order; `None` when the id is not below 6^8.
    pub fn reorder(self, from: CornerOrder, to: CornerOrder) -> Option<ThesisId> {
        Some(ThesisId::new(&self.labels(from)?, to))
    }

    /// The filled corners of the cube; `None` when the id is not below 6^8.
    pub fn mask(self, order: CornerOrder) -> Option<Mask> {
        Some(Mask::of(&self.labels(order)?))
    }

    /// The id of a mask whose filled corners all carry one label: how a binary id is read into the thesis's scheme.
    pub fn of_mask(mask: Mask, label: Label, order: CornerOrder) -> ThesisId {
        let mut labels = [Label::Empty; 8];
        for corner in Corner::all().filter(|&c| mask.has(c)) {
            labels[corner.number() as usize] = label;
        }
        ThesisId::new(&labels, order)
    }
}

/// topoGenesis's cube id `sum bit_j 2^j`, first corner least significant, in the given corner order.
pub fn topogenesis_id(mask: Mask, order: CornerOrder) -> u8 {
    (0..8).fold(0, |id, j| id | (mask.0 >> order.corners()[j] & 1) << j)
}

/// Which number a cube is given.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum IdScheme {
    /// Six labels, base 6.
    #[default]
    Thesis,
    /// Filled or empty, base 2.
    TopoGenesis,
}

/// The ids of all cubes of the padded array.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct CubeIds {
    /// Cubes along x, y, z.
    pub shape: [usize; 3],
    /// Ids, x fastest, then y, then z. Cube (0,0,0) is the one at the padded array's first corner.
    pub ids: Vec<u32>,
}

/// The ids of all cubes of the padded array, empty and full ones included.
pub fn cube_ids(voxels: &VoxelArray, scheme: IdScheme, order: CornerOrder) -> CubeIds {
    let shape = cube_shape(voxels);
    let [nx, ny, nz] = shape;
    let mut ids = Vec::with_capacity(nx * ny * nz);
    for k in 0..nz {
        for j in 0..ny {
            for i in 0..nx {
                let labels = cube_labels(voxels, [i, j, k]);
                ids.push(match scheme {
                    IdScheme::Thesis => ThesisId::new(&labels, order).0,
                    IdScheme::TopoGenesis => u32::from(topogenesis_id(Mask::of(&labels), order)),
                });
            }
        }
    }
    CubeIds { shape, ids }
}
