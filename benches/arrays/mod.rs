//! House-like arrays to measure on.

use std::sync::LazyLock;

use houscaper::voxels::{Label, STOREY_MODULES, VoxelArray, samples};

/// Blocks of storeys with windows, one terrace each, and a gable on top.
pub static CITY: LazyLock<VoxelArray> = LazyLock::new(|| {
    let mut voxels = VoxelArray::new([300, 300, 120]);
    for b in 0..54 {
        let (x0, y0) = (4 + 49 * (b % 6), 4 + 33 * (b / 6));
        block(&mut voxels, [x0, y0], 4 + b * 7 % 14);
    }
    voxels
});

fn block(voxels: &mut VoxelArray, [x0, y0]: [usize; 2], storeys: usize) {
    let [wide, deep] = [42, 24];
    let top = storeys * STOREY_MODULES;
    for k in 0..=top + deep / 2 {
        // Above the top plate the gable's slopes come in by one module a layer; the upper half leaves a terrace to the east.
        let inset = k.saturating_sub(top + 1);
        let east = if k > top / 2 / STOREY_MODULES * STOREY_MODULES { wide - 6 } else { wide };
        for y in inset..deep - inset.min(deep) {
            for x in 0..east {
                let facade = y == 0 || y == deep - 1;
                let label = match k % STOREY_MODULES {
                    _ if k > top => Label::Base,
                    0 if k == 0 => Label::Foundation,
                    0 => Label::Floor,
                    1..=4 if k < STOREY_MODULES && facade && x == 20 => Label::Opening,
                    2..=4 if facade && (x % 4 == 1 || x % 4 == 2) && x < east - 1 => Label::Window,
                    _ => Label::Base,
                };
                voxels.set([x0 + x, y0 + y, k], label);
            }
        }
    }
}

/// Nothing but small houses: 6,930 of the two-storey sample house with a module of air around each, in seven tiers.
pub static VILLAGE: LazyLock<VoxelArray> = LazyLock::new(|| {
    let house = samples::hip_house().voxels;
    let [nx, ny, nz] = house.shape();
    let mut voxels = VoxelArray::new([30 * nx, 33 * ny, 7 * nz]);
    for n in 0..30 * 33 * 7 {
        let corner = [nx * (n % 30), ny * (n / 30 % 33), nz * (n / 990)];
        for (at, label) in house.iter() {
            voxels.set([0, 1, 2].map(|a| corner[a] + at[a]), label);
        }
    }
    voxels
});

/// The two-storey sample house under a hipped roof.
pub static HOUSE: LazyLock<VoxelArray> = LazyLock::new(|| samples::hip_house().voxels);
