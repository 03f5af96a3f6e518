//! The padded cube array of a voxel array: one empty layer is thought on all sides, so that a house is closed.

use super::{Corner, Mask};
use crate::voxels::{Label, VoxelArray};

/// Cubes along x, y and z of the padded array: one more than voxels.
#[inline]
pub fn cube_shape(voxels: &VoxelArray) -> [usize; 3] {
    voxels.shape().map(|n| n + 1)
}

/// The voxel at a corner of a cube; -1 or the shape itself in the padding.
#[inline]
pub fn corner_voxel(cube: [usize; 3], corner: Corner) -> [isize; 3] {
    let at = corner.xyz();
    [0, 1, 2].map(|a| cube[a] as isize - 1 + at[a] as isize)
}

/// The eight labels of a cube in corner order.
pub fn cube_labels(voxels: &VoxelArray, cube: [usize; 3]) -> [Label; 8] {
    let mut labels = [Label::Empty; 8];
    for corner in Corner::all() {
        labels[corner.number() as usize] = voxels.at(corner_voxel(cube, corner));
    }
    labels
}

/// The mask of one cube.
pub fn cube_mask(voxels: &VoxelArray, cube: [usize; 3]) -> Mask {
    Mask::of(&cube_labels(voxels, cube))
}

impl Mask {
    /// The filled corners of eight labels in corner order.
    pub fn of(labels: &[Label; 8]) -> Mask {
        Mask((0..8).filter(|&j| labels[j].is_filled()).fold(0, |bits, j| bits | 1 << j))
    }
}

/// Calls `visit(cube, mask)` for every cube of the padded array that is neither empty nor full, x fastest.
///
/// Slides along x: the four voxels of the next column enter as the odd bits, the last ones are kept as the even bits, so a cube
/// costs four reads. No allocation.
pub fn scan_masks(voxels: &VoxelArray, mut visit: impl FnMut([usize; 3], Mask)) {
    let [nx, ny, nz] = voxels.shape();
    if nx * ny * nz == 0 {
        return;
    }
    let labels = voxels.labels();
    let row = |y: usize, z: usize| -> &[Label] {
        // Row y - 1 of layer z - 1 in voxel numbers; nothing in the padding.
        if y == 0 || z == 0 || y > ny || z > nz {
            &[]
        } else {
            let start = nx * (y - 1 + ny * (z - 1));
            &labels[start..start + nx]
        }
    };
    for k in 0..=nz {
        for j in 0..=ny {
            let rows = [row(j, k), row(j + 1, k), row(j, k + 1), row(j + 1, k + 1)];
            scan_row(rows, nx, |i, mask| visit([i, j, k], mask));
        }
    }
}

/// One row of cubes between four rows of voxels, each nx long or empty.
#[inline]
fn scan_row(rows: [&[Label]; 4], nx: usize, mut visit: impl FnMut(usize, Mask)) {
    if rows.iter().all(|r| r.is_empty()) {
        return;
    }
    let mut last = 0u8;
    for i in 0..=nx {
        let mut next = 0u8;
        for (n, r) in rows.iter().enumerate() {
            next |= u8::from(r.get(i).is_some_and(|l| l.is_filled())) << (2 * n);
        }
        let mask = last | next << 1;
        if mask != 0 && mask != 255 {
            visit(i, Mask(mask));
        }
        last = next;
    }
}
