//! Identity of a house: its voxels moved to their smallest corner, its stairs and zones with them, and its choices.

use crate::voxels::{Choices, House};

/// 128-bit content hash of a house and its choices, equal for houses that differ by their place on the plot only.
///
/// Two independent lanes of folded 64 x 64 -> 128 bit multiplication over eight bytes at a time; among a million houses a
/// chance collision has a probability below 1e-26.
pub fn identity(house: &House, choices: &Choices) -> u128 {
    let mut hash = Hash::new();
    let [nx, ny, _] = house.voxels.shape();
    let (low, size) = bounds(house);
    hash.word(size[0] as u64 | (size[1] as u64) << 20 | (size[2] as u64) << 40);
    let labels = house.voxels.labels();
    for z in low[2]..low[2] + size[2] {
        for y in low[1]..low[1] + size[1] {
            let row = low[0] + nx * (y + ny * z);
            for chunk in labels[row..row + size[0]].chunks(16) {
                hash.word(chunk.iter().fold(0, |word, label| word << 4 | u64::from(label.code())));
            }
            if let Some(zones) = house.zones.get(row..row + size[0]) {
                zones.iter().for_each(|&z| hash.word(z as u64));
            }
        }
    }
    for stair in &house.stairs {
        let at = [stair.start[0].wrapping_sub(low[0]), stair.start[1].wrapping_sub(low[1])];
        hash.word(stair.storey as u64 ^ (at[0] as u64) << 16 ^ (at[1] as u64) << 32);
        hash.word(stair.run as u64 | (stair.kind as u64) << 8);
    }
    choices.0.iter().for_each(|&c| hash.word(u64::from(c)));
    hash.finish()
}

/// Smallest corner and size of the filled voxels; zero size when there are none.
fn bounds(house: &House) -> ([usize; 3], [usize; 3]) {
    let (mut low, mut high) = ([usize::MAX; 3], [0; 3]);
    for (voxel, label) in house.voxels.iter() {
        if label.is_filled() {
            for a in 0..3 {
                low[a] = low[a].min(voxel[a]);
                high[a] = high[a].max(voxel[a] + 1);
            }
        }
    }
    if low[0] == usize::MAX { ([0; 3], [0; 3]) } else { (low, std::array::from_fn(|a| high[a] - low[a])) }
}

struct Hash {
    lanes: [u64; 2],
    length: u64,
}

impl Hash {
    /// Seeds and multipliers: fractional digits of the golden ratio and of pi.
    fn new() -> Self {
        Hash { lanes: [0x9e37_79b9_7f4a_7c15, 0x243f_6a88_85a3_08d3], length: 0 }
    }

    #[inline]
    fn word(&mut self, word: u64) {
        self.length += 1;
        self.lanes[0] = fold(self.lanes[0].rotate_left(23) ^ word, 0xd6e8_feb8_6659_fd93);
        self.lanes[1] = fold(self.lanes[1].wrapping_add(word), 0xa076_1d64_78bd_642f) ^ word.rotate_left(31);
    }

    fn finish(mut self) -> u128 {
        self.word(self.length);
        (0..4).for_each(|i| self.word(i));
        u128::from(self.lanes[0]) << 64 | u128::from(self.lanes[1])
    }
}

#[inline]
fn fold(a: u64, b: u64) -> u64 {
    let product = u128::from(a) * u128::from(b);
    (product as u64) ^ (product >> 64) as u64 ^ a
}
