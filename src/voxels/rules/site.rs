//! What every check looks at: the house, its reading, and its labels with one empty voxel around them.

use super::RuleSettings;
use crate::voxels::{House, Label, Reading, STOREY_MODULES};

/// Buffers that one house after another is checked in.
#[derive(Clone, Debug, Default)]
pub struct Scratch {
    padded: Vec<u8>,
    mark: Vec<u8>,
    count: Vec<u32>,
    queue: Vec<u32>,
}

/// Bit of a padded voxel that says: left out of its plate for a stair.
const STAIR_VOID: u8 = 8;

/// The house as checks see it.
pub(super) struct Site<'a> {
    pub house: &'a House,
    pub reading: &'a Reading,
    pub settings: &'a RuleSettings,
    /// Label codes of the padded array, x fastest, with [`STAIR_VOID`].
    padded: &'a [u8],
    /// Voxels of the unpadded array.
    pub shape: [usize; 3],
    /// Index steps of the padded array along x, y, z.
    pub stride: [usize; 3],
}

/// Buffers without contents.
pub(super) struct Work<'a> {
    /// Marks per padded voxel or plan cell.
    pub mark: &'a mut Vec<u8>,
    /// Counts per plan cell.
    pub count: &'a mut Vec<u32>,
    /// Indices to visit.
    pub queue: &'a mut Vec<u32>,
}

impl Scratch {
    pub(super) fn prepare<'a>(
        &'a mut self,
        house: &'a House,
        reading: &'a Reading,
        settings: &'a RuleSettings,
    ) -> (Site<'a>, Work<'a>) {
        let shape = house.voxels.shape();
        let stride = [1, shape[0] + 2, (shape[0] + 2) * (shape[1] + 2)];
        self.padded.clear();
        self.padded.resize(stride[2] * (shape[2] + 2), 0);
        if shape[0] > 0 {
            for (row, labels) in house.voxels.labels().chunks_exact(shape[0]).enumerate() {
                let at = 1 + stride[1] * (row % shape[1] + 1) + stride[2] * (row / shape[1] + 1);
                for (to, label) in self.padded[at..at + shape[0]].iter_mut().zip(labels) {
                    *to = label.code();
                }
            }
        }
        mark_stair_voids(&mut self.padded, house, reading, stride);
        let Scratch { padded, mark, count, queue } = self;
        (Site { house, reading, settings, padded, shape, stride }, Work { mark, count, queue })
    }
}

fn mark_stair_voids(padded: &mut [u8], house: &House, reading: &Reading, stride: [usize; 3]) {
    let [nx, ny, nz] = house.voxels.shape();
    for stair in &house.stairs {
        let Some(lower) = reading.storeys.get(stair.storey) else { continue };
        let k = lower.plate_k + STOREY_MODULES;
        for [x, y] in stair.void_cells() {
            if x >= 0 && y >= 0 && (x as usize) < nx && (y as usize) < ny && k < nz {
                let at = x as usize + 1 + stride[1] * (y as usize + 1) + stride[2] * (k + 1);
                if padded[at] == Label::Base.code() {
                    padded[at] |= STAIR_VOID;
                }
            }
        }
    }
}

impl<'a> Site<'a> {
    /// The padded labels: 0 is empty, anything else filled.
    pub fn padded(&self) -> &'a [u8] {
        self.padded
    }

    /// Index of a voxel in the padded array.
    #[inline]
    pub fn index(&self, [x, y, z]: [usize; 3]) -> usize {
        x + 1 + self.stride[1] * (y + 1) + self.stride[2] * (z + 1)
    }

    /// The voxel at an index of the padded array that is not padding.
    #[inline]
    pub fn voxel(&self, index: usize) -> [usize; 3] {
        let [_, sy, sz] = self.stride;
        [index % sy - 1, index / sy % (self.shape[1] + 2) - 1, index / sz - 1]
    }

    /// Whether the voxel at a padded index is filled.
    #[inline]
    pub fn filled(&self, index: usize) -> bool {
        self.padded[index] != 0
    }

    /// Whether the voxel at a padded index is slab.
    #[inline]
    pub fn slab(&self, index: usize) -> bool {
        matches!(self.padded[index] & 7, 2 | 3)
    }

    /// Whether a voxel of a plate is left out for a stair.
    #[inline]
    pub fn stair_void(&self, voxel: [usize; 3]) -> bool {
        self.padded[self.index(voxel)] & STAIR_VOID != 0
    }

    /// The label at any position; empty outside.
    #[inline]
    pub fn label(&self, [x, y]: [isize; 2], k: usize) -> Label {
        self.house.voxels.at([x, y, k as isize])
    }

    /// Filled voxels in storage order, with their padded index.
    pub fn filled_voxels(&self) -> impl Iterator<Item = ([usize; 3], usize)> + '_ {
        let [nx, ny, nz] = self.shape;
        (0..nz).flat_map(move |z| {
            (0..ny).flat_map(move |y| {
                let row = self.index([0, y, z]);
                (0..nx).filter(move |x| self.padded[row + x] != 0).map(move |x| ([x, y, z], row + x))
            })
        })
    }

    /// Index steps to the four side neighbours in the order +x, -x, +y, -y.
    pub fn sides(&self) -> [isize; 4] {
        let sy = self.stride[1] as isize;
        [1, -1, sy, -sy]
    }
}

/// Empties a buffer and fills it with `n` values.
pub(super) fn reset<T: Copy>(buffer: &mut Vec<T>, n: usize, value: T) {
    buffer.clear();
    buffer.resize(n, value);
}
