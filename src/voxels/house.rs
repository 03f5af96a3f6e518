//! A house as the program passes it around: labels, stairs, and the zone of each cell where a programme gives one.

use super::{Stair, VoxelArray};

/// Voxels with what the labels alone cannot say.
#[derive(Clone, Debug, PartialEq)]
pub struct House {
    /// The labels.
    pub voxels: VoxelArray,
    /// Stairs, lowest storey first.
    pub stairs: Vec<Stair>,
    /// Zone id per voxel in the order of the labels, -1 where no zone was given; empty when the house has no zones.
    pub zones: Vec<i32>,
}

impl House {
    /// A house without stairs and zones.
    pub fn new(voxels: VoxelArray) -> Self {
        House { voxels, stairs: Vec::new(), zones: Vec::new() }
    }
}
