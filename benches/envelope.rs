//! Polygonizing: ids, tiles, placement, areas and volumes, without mesh assembly; mesh assembly apart.
//!
//! `cargo bench --bench envelope`: rates are padded cubes a second on one core. The city is 54 blocks of 42 x 24 modules, 4
//! to 17 storeys under gables, with plates every six layers, windows, doors and recessed terraces; the village is nothing but
//! small houses. What they are made of is printed first, then a table of all sets side by side with the surface cubes a second
//! (cubes that are neither empty nor full). `architectural` is the tileset as shipped, with edges; `+ volumes` adds the volume of
//! every component. Keys are known, as they are in a search after its first houses.

mod arrays;

use std::hint::black_box;
use std::path::Path;
use std::sync::LazyLock;
use std::time::{Duration, Instant};

use arrays::{CITY, HOUSE, VILLAGE};
use divan::Bencher;
use divan::counter::ItemsCount;
use houscaper::cubes::{CubeKey, Mask, Rule, cube_shape, scan_keys, scan_masks};
use houscaper::envelope::{Fabric, KeyCache, KeyedSurface, VolumeTable, Volumes, mesh_keys, survey, survey_keys};
use houscaper::export::{Palette, Storeys, from_fabric, to_glb};
use houscaper::price::Books;
use houscaper::tiles::solids::{SolidStyle, solids};
use houscaper::tiles::{CUBE_MM, Shells, Style, Tileset, construct};
use houscaper::voxels::VoxelArray;

fn main() {
    for (name, voxels) in [("city", &*CITY), ("village", &*VILLAGE), ("house", &*HOUSE)] {
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
        side_by_side(voxels, cubes, surface);
    }
    divan::main();
}

/// Median times of all sets over one array.
fn side_by_side(voxels: &VoxelArray, cubes: usize, surface: usize) {
    let tiles = Tileset::from_facets("surface-2", CUBE_MM, |mask| construct(mask, 0, &Style::SURFACE_2));
    let row = |name: &str, work: &mut dyn FnMut()| {
        let time = median(work).as_secs_f64();
        let (all, on) = (cubes as f64 / time * 1e-6, surface as f64 / time * 1e-6);
        println!("  {name:28} {all:8.1} M cubes/s {on:8.1} M surface cubes/s {:12.1} us", time * 1e6);
    };
    row("surface-2, 256 tiles", &mut || {
        black_box(survey(voxels, &tiles).expect("every cube has a tile"));
    });
    for rule in [Rule::A, Rule::B] {
        for with_volumes in [false, true] {
            let name = format!("architectural {rule:?}{}", if with_volumes { " + volumes" } else { "" });
            let mut polygonizer = Polygonizer::new(rule);
            row(&name, &mut || polygonizer.run(voxels, with_volumes));
        }
    }
}

/// Median of 15 runs after a first one; runs of less than a millisecond are repeated for a millisecond.
fn median(work: &mut dyn FnMut()) -> Duration {
    let time = |n: u32, work: &mut dyn FnMut()| {
        let from = Instant::now();
        (0..n).for_each(|_| work());
        from.elapsed() / n
    };
    work();
    let once = time(1, work);
    let repeat = (Duration::from_millis(1).as_nanos() / once.as_nanos().max(1)).clamp(1, 1_000) as u32;
    let mut times: Vec<Duration> = (0..15).map(|_| time(repeat, work)).collect();
    times.sort_unstable();
    times[7]
}

/// The architectural set as a brief names it.
struct Polygonizer {
    surface: KeyedSurface,
    cache: KeyCache,
    volumes: VolumeTable,
}

impl Polygonizer {
    fn new(rule: Rule) -> Polygonizer {
        let edges = Some(SolidStyle::default());
        let surface = KeyedSurface { style: Style::architectural(&SHELLS), rule, edges };
        Polygonizer { surface, cache: KeyCache::default(), volumes: VolumeTable::default() }
    }

    /// Keys, tiles, areas, lengths of edges and the enclosed volume; then the volume of every component.
    fn run(&mut self, voxels: &VoxelArray, with_volumes: bool) {
        black_box(survey_keys(voxels, &self.surface, |_| false, &mut self.cache).expect("every cube has a tile"));
        if with_volumes {
            black_box(self.volumes.sum(&self.cache, |key| Volumes::of_blocks(&architectural(key))));
        }
    }
}

fn architectural(key: CubeKey) -> Vec<houscaper::tiles::Block> {
    solids(key, &SolidStyle::default(), &SHELLS)
}

/// Strata of the shipped build-ups.
static SHELLS: LazyLock<Shells> = LazyLock::new(|| {
    let books = Books::load(&Path::new(env!("CARGO_MANIFEST_DIR")).join("configs")).expect("shipped books");
    houscaper::score::shells(&books).expect("shipped strata")
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

#[divan::bench(sample_count = 20, args = [Rule::A, Rule::B])]
fn city_architectural_volumes(bencher: Bencher, rule: Rule) {
    let mut polygonizer = Polygonizer::new(rule);
    rate(bencher, &CITY, |voxels| polygonizer.run(voxels, true));
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

#[divan::bench(sample_count = 20, args = [Rule::A, Rule::B])]
fn village_architectural_volumes(bencher: Bencher, rule: Rule) {
    let mut polygonizer = Polygonizer::new(rule);
    rate(bencher, &VILLAGE, |voxels| polygonizer.run(voxels, true));
}

#[divan::bench]
fn house_survey_tiles(bencher: Bencher) {
    let tiles = Tileset::from_facets("surface-2", CUBE_MM, |mask| construct(mask, 0, &Style::SURFACE_2));
    rate(bencher, &HOUSE, |voxels| {
        black_box(survey(voxels, &tiles).expect("every cube has a tile"));
    });
}

#[divan::bench(args = [Rule::A, Rule::B])]
fn house_survey_keys(bencher: Bencher, rule: Rule) {
    let (surface, mut cache) = (KeyedSurface { rule, ..SURFACE }, KeyCache::default());
    rate(bencher, &HOUSE, |voxels| {
        black_box(survey_keys(voxels, &surface, |_| false, &mut cache).expect("every cube has a tile"));
    });
}

#[divan::bench]
fn house_survey_keys_unknown(bencher: Bencher) {
    rate(bencher, &HOUSE, |voxels| {
        black_box(survey_keys(voxels, &SURFACE, |_| false, &mut KeyCache::default()).expect("every cube has a tile"));
    });
}

#[divan::bench]
fn house_mesh_keys(bencher: Bencher) {
    rate(bencher, &HOUSE, |voxels| {
        black_box(mesh_keys(voxels, &SURFACE).expect("every cube has a tile"));
    });
}

#[divan::bench(args = [Rule::A, Rule::B])]
fn house_architectural_volumes(bencher: Bencher, rule: Rule) {
    let mut polygonizer = Polygonizer::new(rule);
    rate(bencher, &HOUSE, |voxels| polygonizer.run(voxels, true));
}

fn house_fabric(voxels: &VoxelArray) -> Fabric {
    let mut keys = Vec::new();
    scan_keys(voxels, Rule::B, |_| false, |cube, key| keys.push((cube, key)));
    Fabric::new(voxels, keys, |key| architectural(key).into())
}

/// Mesh assembly, apart: blocks of every key made and placed.
#[divan::bench(sample_count = 10)]
fn house_glb_1_fabric(bencher: Bencher) {
    rate(bencher, &HOUSE, |voxels| {
        black_box(house_fabric(voxels));
    });
}

/// Mesh assembly, apart: blocks merged into one closed solid a component.
#[divan::bench(sample_count = 10)]
fn house_glb_2_scene(bencher: Bencher) {
    let (fabric, palette) = (house_fabric(&HOUSE), Palette::default());
    rate(bencher, &HOUSE, |_| {
        black_box(from_fabric(&fabric, &palette, Storeys::Together, serde_json::Value::Null).expect("disjoint"));
    });
}

/// Mesh assembly, apart: the bytes of the GLB.
#[divan::bench(sample_count = 10)]
fn house_glb_3_bytes(bencher: Bencher) {
    let scene = from_fabric(&house_fabric(&HOUSE), &Palette::default(), Storeys::Together, serde_json::Value::Null);
    let scene = scene.expect("disjoint");
    rate(bencher, &HOUSE, |_| {
        black_box(to_glb(&scene).expect("a valid scene"));
    });
}
