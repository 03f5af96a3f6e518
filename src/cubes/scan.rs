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
/// Rows of voxels become words of bits, so that empty and full cubes are skipped 63 at a time. No allocation.
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
    let mut start = 0;
    while start <= nx {
        // Voxels start - 1 .. start + 62 as bits, so that cubes start .. start + 62 find both their columns.
        let bits = rows.map(|row| row_bits(row, start));
        let [low, high] = [bits.map(|b| b & LOW), bits.map(|b| b >> 1 & LOW)];
        let any = (0..4).fold(0, |all, n| all | low[n] | high[n]);
        let all = (0..4).fold(LOW, |all, n| all & low[n] & high[n]);
        let mut boundary = any & !all;
        while boundary != 0 {
            let i = boundary.trailing_zeros();
            let mask = (0..4).fold(0, |mask, n| mask | ((bits[n] >> i & 3) as u8) << (2 * n));
            visit(start + i as usize, Mask(mask));
            boundary &= boundary - 1;
        }
        start += 63;
    }
}

/// The lowest 63 bits: the cubes of one stride.
const LOW: u64 = u64::MAX >> 1;

/// Bit n is set when voxel start - 1 + n of the row is filled.
#[inline]
fn row_bits(row: &[Label], start: usize) -> u64 {
    let mut bits = 0;
    for_eights(row, start, |codes, at| bits |= lowest_bits(codes | codes >> 1 | codes >> 2) << at);
    bits
}

/// Calls `take(codes, at)` for the voxels start - 1 to start + 62 of a row, eight at a time: byte n of `codes` is the code of voxel
/// start - 1 + at + n. Nothing beyond the row's ends.
#[inline]
pub(super) fn for_eights(row: &[Label], start: usize, mut take: impl FnMut(u64, u32)) {
    let first = start.saturating_sub(1);
    let stride = row.get(first..row.len().min(start + 63)).unwrap_or(&[]);
    let (eights, rest) = stride.as_chunks::<8>();
    let mut at = u32::from(start == 0);
    for eight in eights {
        take(codes(eight), at);
        at += 8;
    }
    if !rest.is_empty() {
        let mut last = [Label::Empty; 8];
        last[..rest.len()].copy_from_slice(rest);
        take(codes(&last), at);
    }
}

/// The codes of eight labels as the bytes of a word, first lowest. Written so that it becomes a single load.
#[inline]
fn codes(eight: &[Label; 8]) -> u64 {
    eight.iter().rev().fold(0, |word, label| word << 8 | u64::from(label.code()))
}

/// The lowest bit of each of eight bytes, byte n to bit n: the product moves bit 8n to bit 56 + n, and no two terms meet below.
#[inline]
pub(super) fn lowest_bits(bytes: u64) -> u64 {
    (bytes & 0x0101_0101_0101_0101).wrapping_mul(0x0102_0408_1020_4080) >> 56
}
