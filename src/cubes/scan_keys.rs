//! The keys of all cubes in which something stands, word by word.

use super::face_words::FaceWords;
use super::faces::walked_columns;
use super::layers::{CUBES, Layers, Planes};
use super::{CubeKey, Rule};
use crate::voxels::VoxelArray;

/// Calls `visit(cube, key)` for every cube of the padded array in which something stands, x fastest: not for empty cubes, nor for
/// cubes with eight filled corners and no slab among them. Cubes inside a house with a slab above or below are visited.
///
/// `walked` tells of a slab voxel with nothing above it whether people walk on it. Rows of voxels become three words of bits, one
/// for each bit of a label's code, so that cubes where nothing stands are skipped 61 at a time, the numbers on the faces of 61 cubes
/// are found together, and a cube like the one before it takes its key. Allocates the words of four layers once.
pub fn scan_keys(
    voxels: &VoxelArray,
    rule: Rule,
    walked: impl Fn([usize; 3]) -> bool,
    mut visit: impl FnMut([usize; 3], CubeKey),
) {
    let [nx, ny, nz] = voxels.shape();
    if nx * ny * nz == 0 {
        return;
    }
    let mut layers = Layers::new(voxels);
    for k in 0..=nz {
        if k > 0 {
            layers.load(k);
        }
        for j in 0..=ny {
            for s in 0..layers.strides {
                let stride = Stride::new(layers.beside(j, k, s));
                let mut left = stride.standing();
                if left == 0 {
                    continue;
                }
                let numbers = if rule == Rule::B && stride.has_roof_edge() {
                    FaceWords::new(layers.around(j, k, s))
                } else {
                    FaceWords::default()
                };
                let (numbered, decks) = (numbers.any(), stride.decks());
                let repeats = stride.repeats() & !numbers.changes() & !decks;
                let mut key = CubeKey::default();
                while left != 0 {
                    let i = left.trailing_zeros();
                    let cube = [s * CUBES + i as usize, j, k];
                    if repeats >> i & 1 == 0 {
                        key = CubeKey::from_labels(stride.labels(i));
                        if numbered >> i & 1 == 1 {
                            key = key.with_face_codes(numbers.codes(i));
                        }
                        if decks >> i & 1 == 1 {
                            key = key.with_walked(walked_columns(voxels, cube, &walked));
                        }
                    }
                    visit(cube, key);
                    left &= left - 1;
                }
            }
        }
    }
}

/// The lowest bits: the cubes of one stride.
const LOW: u64 = (1 << CUBES) - 1;

/// The voxels of the four rows around the cubes of a stride: cube i lies between bits i and i + 1.
struct Stride {
    planes: [[u64; 3]; 4],
    filled: [u64; 4],
}

impl Stride {
    #[inline]
    fn new(rows: [Planes; 4]) -> Stride {
        // The first voxel is read for the sake of face numbers.
        let planes = rows.map(|row| row.0.map(|plane| plane >> 1));
        Stride { planes, filled: planes.map(|row| Planes(row).filled()) }
    }

    #[inline]
    fn slab(&self, row: usize) -> u64 {
        Planes(self.planes[row]).slab()
    }

    /// Cubes that are neither empty nor full without a slab.
    #[inline]
    fn standing(&self) -> u64 {
        let (mut any, mut all, mut slab) = (0, LOW, 0);
        for row in 0..4 {
            let (low, high) = (self.filled[row], self.filled[row] >> 1);
            any |= low | high;
            all &= low & high;
            slab |= self.slab(row) | self.slab(row) >> 1;
        }
        any & LOW & !(all & !slab)
    }

    /// Whether a roof stands beside another column on some face.
    #[inline]
    fn has_roof_edge(&self) -> bool {
        let [a, b] = [0, 1].map(|row| self.filled[row] & !self.slab(row) & !self.filled[row + 2]);
        let across = a ^ b;
        (across | across >> 1 | (a ^ a >> 1) | (b ^ b >> 1)) & LOW != 0
    }

    /// Cubes with a deck.
    #[inline]
    fn decks(&self) -> u64 {
        let [a, b] = [0, 1].map(|row| self.slab(row) & !self.filled[row + 2]);
        (a | a >> 1 | b | b >> 1) & LOW
    }

    /// Cubes with the same labels as the one before them in this stride.
    #[inline]
    fn repeats(&self) -> u64 {
        let changes = self.planes.as_flattened().iter().fold(0, |all, plane| all | (plane ^ plane >> 1));
        !(changes | changes << 1) & LOW & !1
    }

    /// The eight labels of cube i, 3 bits each.
    #[inline]
    fn labels(&self, i: u32) -> u64 {
        // Two neighbouring bits, three places apart.
        let spread = |plane: u64| {
            let two = plane >> i & 3;
            (two | two << 2) & 9
        };
        let row = |[a, b, c]: [u64; 3]| spread(a) | spread(b) << 1 | spread(c) << 2;
        (0..4).fold(0, |labels, n| labels | row(self.planes[n]) << (6 * n))
    }
}
