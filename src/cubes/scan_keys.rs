//! The keys of all cubes in which something stands, word by word.

use super::faces::{cube_face, walked_columns};
use super::{CubeKey, FaceNumber, Rule};
use crate::voxels::{Direction, Label, VoxelArray};

/// Calls `visit(cube, key)` for every cube of the padded array in which something stands, x fastest: not for empty cubes, nor for
/// cubes with eight filled corners and no slab among them. Cubes inside a house with a slab above or below are visited.
///
/// `walked` tells of a slab voxel with nothing above it whether people walk on it. Rows of voxels become three words of bits, one
/// for each bit of a label's code, so that cubes where nothing stands are skipped 63 at a time and a cube like the one before it
/// takes its key. No allocation.
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
            let mut start = 0;
            while start <= nx {
                let stride = Stride::read(rows, start);
                let mut key = CubeKey::default();
                let mut left = stride.standing();
                let (faces, decks) = (if rule == Rule::B { stride.faces() } else { 0 }, stride.decks());
                let repeats = stride.repeats() & !faces & !decks;
                while left != 0 {
                    let i = left.trailing_zeros();
                    let cube = [start + i as usize, j, k];
                    if repeats >> i & 1 == 0 {
                        key = CubeKey::from_labels(stride.labels(i));
                        if faces >> i & 1 == 1 {
                            key = key.with_faces(stride.faced_sides(i).map(|(side, asked)| {
                                if asked { cube_face(voxels, cube, side) } else { FaceNumber::None }
                            }));
                        }
                        if decks >> i & 1 == 1 {
                            key = key.with_walked(walked_columns(voxels, cube, &walked));
                        }
                    }
                    visit(cube, key);
                    left &= left - 1;
                }
                start += 63;
            }
        }
    }
}

/// The lowest 63 bits: the cubes of one stride.
const LOW: u64 = u64::MAX >> 1;

/// 64 voxels of the four rows around 63 cubes: bit n of plane p of row r is bit p of the code of voxel start - 1 + n.
struct Stride {
    planes: [[u64; 3]; 4],
    filled: [u64; 4],
}

impl Stride {
    #[inline]
    fn read(rows: [&[Label]; 4], start: usize) -> Stride {
        let planes = rows.map(|row| row_planes(row, start));
        Stride { planes, filled: planes.map(|[a, b, c]| a | b | c) }
    }

    /// Bit 1 of a code is set in slabs only: floor 2 = 010, foundation 3 = 011; base 001, opening 100, window 101.
    #[inline]
    fn slab(&self, row: usize) -> u64 {
        self.planes[row][1]
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

    /// Voxels of the lower rows that carry a roof.
    #[inline]
    fn roofs(&self) -> [u64; 2] {
        [0, 1].map(|row| self.filled[row] & !self.slab(row) & !self.filled[row + 2])
    }

    /// Cubes with a roof beside another column on some face.
    #[inline]
    fn faces(&self) -> u64 {
        let [a, b] = self.roofs();
        let across = a ^ b;
        (across | across >> 1 | (a ^ a >> 1) | (b ^ b >> 1)) & LOW
    }

    /// Which faces of cube i those are.
    #[inline]
    fn faced_sides(&self, i: u32) -> [(Direction, bool); 4] {
        let [a, b] = self.roofs().map(|r| r >> i & 3);
        let odd = |pair: u64| pair == 1 || pair == 2;
        Direction::ALL.map(|side| {
            let asked = match side {
                Direction::East => (a ^ b) & 2 != 0,
                Direction::North => odd(b),
                Direction::West => (a ^ b) & 1 != 0,
                Direction::South => odd(a),
            };
            (side, asked)
        })
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

/// The planes of voxels start - 1 to start + 62 of a row; empty beyond its ends.
#[inline]
fn row_planes(row: &[Label], start: usize) -> [u64; 3] {
    let first = start.saturating_sub(1);
    let stride = row.get(first..row.len().min(start + 63)).unwrap_or(&[]);
    let (eights, rest) = stride.as_chunks::<8>();
    let mut planes = [0; 3];
    let mut at = u32::from(start == 0);
    let mut push = |eight: [Label; 8]| {
        let codes = u64::from_le_bytes(eight.map(Label::code));
        for (n, plane) in planes.iter_mut().enumerate() {
            *plane |= lowest_bits(codes >> n) << at;
        }
        at += 8;
    };
    eights.iter().for_each(|eight| push(*eight));
    if !rest.is_empty() {
        let mut last = [Label::Empty; 8];
        last[..rest.len()].copy_from_slice(rest);
        push(last);
    }
    planes
}

/// The lowest bit of each of eight bytes, byte n to bit n: the product moves bit 8n to bit 56 + n, and no two terms meet below.
#[inline]
fn lowest_bits(bytes: u64) -> u64 {
    (bytes & 0x0101_0101_0101_0101).wrapping_mul(0x0102_0408_1020_4080) >> 56
}
