//! Rows of voxels as words of bits, four layers at a time.

use super::scan::{for_eights, lowest_bits};
use crate::voxels::{Label, VoxelArray};

/// Cubes of one stride. A stride's 64 voxels reach two beyond its cubes' lower and one beyond their upper columns, so that the
/// columns around every cube of the stride lie in the same words.
pub(super) const CUBES: usize = 61;

/// Padding rows on both sides of a layer: what lies around the cubes of the first and last row.
const PADDING: usize = 2;

/// The bits of 64 voxels of a row: bit n of plane p is bit p of the code of voxel 61 s - 2 + n, for stride s.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Planes(pub [u64; 3]);

impl Planes {
    /// Everything but empty.
    #[inline]
    pub fn filled(self) -> u64 {
        self.0[0] | self.0[1] | self.0[2]
    }

    /// Bit 1 of a code is set in slabs only: floor 2 = 010, foundation 3 = 011; base 001, opening 100, window 101.
    #[inline]
    pub fn slab(self) -> u64 {
        self.0[1]
    }

    /// Base, opening or window.
    #[inline]
    pub fn no_slab(self) -> u64 {
        self.filled() & !self.slab()
    }
}

/// The layers around one layer of cubes: one below, the two between which the cubes lie, one above. Every voxel is read once in
/// a scan; what lies outside the array is empty.
pub(super) struct Layers<'a> {
    labels: &'a [Label],
    shape: [usize; 3],
    /// Strides of a row.
    pub strides: usize,
    /// Four layers in turn, rows with their padding, strides.
    planes: Vec<Planes>,
}

impl<'a> Layers<'a> {
    /// Ready for the lowest layer of cubes.
    pub fn new(voxels: &'a VoxelArray) -> Layers<'a> {
        let shape = voxels.shape();
        let strides = shape[0] / CUBES + 1;
        let planes = vec![Planes::default(); 4 * (shape[1] + 2 * PADDING) * strides];
        let mut layers = Layers { labels: voxels.labels(), shape, strides, planes };
        layers.load(0);
        layers
    }

    /// Makes ready for layer k of cubes, 0 first and then one by one: voxel layers k - 2 to k + 1.
    pub fn load(&mut self, k: usize) {
        let [nx, ny, nz] = self.shape;
        // Before the first layer of cubes two layers are unread.
        for z in if k == 0 { 0..2 } else { k + 1..k + 2 } {
            let start = self.at(z, PADDING, 0);
            let layer = &mut self.planes[start..start + ny * self.strides];
            if z >= nz {
                layer.fill(Planes::default());
                continue;
            }
            let labels = &self.labels[nx * ny * z..nx * ny * (z + 1)];
            for (row, words) in labels.chunks_exact(nx.max(1)).zip(layer.chunks_exact_mut(self.strides)) {
                words.iter_mut().enumerate().for_each(|(s, word)| *word = row_planes(row, s * CUBES));
            }
        }
    }

    /// Index of a row with padding in a voxel layer.
    #[inline]
    fn at(&self, z: usize, row: usize, stride: usize) -> usize {
        (z % 4 * (self.shape[1] + 2 * PADDING) + row) * self.strides + stride
    }

    /// Voxel rows j - 2 to j + 1 around row j of cubes, in voxel layers k - 2 to k + 1 around layer k of cubes.
    #[inline]
    pub fn around(&self, j: usize, k: usize, stride: usize) -> [[Planes; 4]; 4] {
        // Four layers back is the same place as two ahead: layer k - 2 is kept where layer k + 2 will be.
        [k + 2, k + 3, k, k + 1].map(|z| [0, 1, 2, 3].map(|row| self.planes[self.at(z, j + row, stride)]))
    }

    /// The four rows of voxels at row j of cubes of layer k: behind and in front below, behind and in front above.
    #[inline]
    pub fn beside(&self, j: usize, k: usize, stride: usize) -> [Planes; 4] {
        let [below, above] = [self.at(k + 3, j + 1, stride), self.at(k, j + 1, stride)];
        [below, below + self.strides, above, above + self.strides].map(|at| self.planes[at])
    }
}

/// The planes of voxels start - 2 to start + 61 of a row; empty beyond its ends.
#[inline]
fn row_planes(row: &[Label], start: usize) -> Planes {
    let (mut ones, mut twos, mut fours) = (0, 0, 0);
    for_eights(row, start.saturating_sub(1), |codes, at| {
        ones |= lowest_bits(codes) << at;
        twos |= lowest_bits(codes >> 1) << at;
        fours |= lowest_bits(codes >> 2) << at;
    });
    // At a row's beginning the words were read from voxel -1 on.
    Planes([ones, twos, fours].map(|plane| if start == 0 { plane << 1 } else { plane }))
}
