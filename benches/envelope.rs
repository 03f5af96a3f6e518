//! Polygonizing: ids, tiles, placement, areas and volume, without mesh assembly; mesh assembly apart.
//!
//! `cargo bench --bench envelope`: rates are padded cubes a second on one core. The city is 54 blocks of 42 x 24 modules, 4
//! to 17 storeys under gables, with plates every six layers, windows, doors and recessed terraces; the village is nothing but
//! small houses. What they are made of is printed first.

use std::sync::LazyLock;

use divan::counter::ItemsCount;
use divan::{Bencher, black_box};
use houscaper::cubes::{Mask, Rule, cube_shape, scan_keys, scan_masks};
use houscaper::envelope::{KeyCache, KeyedSurface, mesh_keys, survey, survey_keys};
use houscaper::tiles::{CUBE_MM, Style, Tileset, construct};
use houscaper::voxels::{Label, STOREY_MODULES, VoxelArray, samples};

fn main() {
    for (name, voxels) in [("city", &*CITY), ("village", &*VILLAGE), ("house", &samples::hip_house().voxels)] {
        let cubes = cube_shape(voxels).iter().product::<usize>();
        let (mut surface, mut inside, mut keys) = (0, 0, std::collections::HashSet::new());
        scan_keys(
            voxels,
            Rule::B,
            |_| false,
            |_, key| {
                keys.insert(key);
                if key.mask() == Mask::FULL { inside += 1 } else { surface += 1 }
            },
        );
        let share = |n: usize| 100.0 * n as f64 / cubes as f64;
        println!(
            "{name}: {cubes} padded cubes, {surface} on the surface ({:.1} %), {inside} inside at a slab ({:.1} %), \
             {:.1} % of the voxels filled, {} keys",
            share(surface),
            share(inside),
            share(voxels.filled_count()),
            keys.len()
        );
    }
    divan::main();
}

/// Blocks of storeys with windows, one terrace each, and a gable on top.
static CITY: LazyLock<VoxelArray> = LazyLock::new(|| {
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
static VILLAGE: LazyLock<VoxelArray> = LazyLock::new(|| {
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

const SURFACE: KeyedSurface = KeyedSurface {
    style: Style { decks: true, name: "architectural", ..Style::SURFACE_2 },
    rule: Rule::B,
    edges: None,
};

fn rate(bencher: Bencher, voxels: &VoxelArray, mut work: impl FnMut(&VoxelArray)) {
    let cubes = cube_shape(voxels).iter().product::<usize>();
    bencher.counter(ItemsCount::new(cubes)).bench_local(|| work(black_box(voxels)));
}

#[divan::bench(sample_count = 20)]
fn city_scan_masks(bencher: Bencher) {
    rate(bencher, &CITY, |voxels| {
        let mut sum = 0;
        scan_masks(voxels, |_, mask| sum += usize::from(mask.0));
        black_box(sum);
    });
}

#[divan::bench(sample_count = 20, args = [Rule::A, Rule::B])]
fn city_scan_keys(bencher: Bencher, rule: Rule) {
    rate(bencher, &CITY, |voxels| {
        let mut sum = 0;
        scan_keys(voxels, rule, |_| false, |_, key| sum += key.bits());
        black_box(sum);
    });
}

#[divan::bench(sample_count = 20)]
fn city_survey_tiles(bencher: Bencher) {
    let tiles = Tileset::from_facets("surface-2", CUBE_MM, |mask| construct(mask, 0, &Style::SURFACE_2));
    rate(bencher, &CITY, |voxels| {
        black_box(survey(voxels, &tiles).expect("every cube has a tile"));
    });
}

#[divan::bench(sample_count = 20, args = [Rule::A, Rule::B])]
fn city_survey_keys(bencher: Bencher, rule: Rule) {
    let (surface, mut cache) = (KeyedSurface { rule, ..SURFACE }, KeyCache::default());
    rate(bencher, &CITY, |voxels| {
        black_box(survey_keys(voxels, &surface, |_| false, &mut cache).expect("every cube has a tile"));
    });
}

#[divan::bench(sample_count = 3)]
fn city_mesh_keys(bencher: Bencher) {
    rate(bencher, &CITY, |voxels| {
        black_box(mesh_keys(voxels, &SURFACE).expect("every cube has a tile"));
    });
}

#[divan::bench(sample_count = 20, args = [Rule::A, Rule::B])]
fn village_survey_keys(bencher: Bencher, rule: Rule) {
    let (surface, mut cache) = (KeyedSurface { rule, ..SURFACE }, KeyCache::default());
    rate(bencher, &VILLAGE, |voxels| {
        black_box(survey_keys(voxels, &surface, |_| false, &mut cache).expect("every cube has a tile"));
    });
}

#[divan::bench(sample_count = 20)]
fn village_survey_tiles(bencher: Bencher) {
    let tiles = Tileset::from_facets("surface-2", CUBE_MM, |mask| construct(mask, 0, &Style::SURFACE_2));
    rate(bencher, &VILLAGE, |voxels| {
        black_box(survey(voxels, &tiles).expect("every cube has a tile"));
    });
}

/// The two-storey sample house under a hipped roof.
#[divan::bench]
fn house_survey_tiles(bencher: Bencher) {
    let tiles = Tileset::from_facets("surface-2", CUBE_MM, |mask| construct(mask, 0, &Style::SURFACE_2));
    rate(bencher, &samples::hip_house().voxels, |voxels| {
        black_box(survey(voxels, &tiles).expect("every cube has a tile"));
    });
}

#[divan::bench(args = [Rule::A, Rule::B])]
fn house_survey_keys(bencher: Bencher, rule: Rule) {
    let (surface, mut cache) = (KeyedSurface { rule, ..SURFACE }, KeyCache::default());
    rate(bencher, &samples::hip_house().voxels, |voxels| {
        black_box(survey_keys(voxels, &surface, |_| false, &mut cache).expect("every cube has a tile"));
    });
}

#[divan::bench]
fn house_survey_keys_unknown(bencher: Bencher) {
    rate(bencher, &samples::hip_house().voxels, |voxels| {
        black_box(survey_keys(voxels, &SURFACE, |_| false, &mut KeyCache::default()).expect("every cube has a tile"));
    });
}

#[divan::bench]
fn house_mesh_keys(bencher: Bencher) {
    rate(bencher, &samples::hip_house().voxels, |voxels| {
        black_box(mesh_keys(voxels, &SURFACE).expect("every cube has a tile"));
    });
}
