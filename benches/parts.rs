//! Cutting houses of the starter brief into parts: what `distinct_parts` adds to an evaluation.
//!
//! `cargo bench --bench parts`: medians are of one house each.

use std::path::PathBuf;

use divan::{Bencher, black_box};
use houscaper::brief::read_brief;
use houscaper::parts::{Settings, cut};
use houscaper::score::{Evaluator, Paths};
use houscaper::search::massing::encode;
use houscaper::search::{from_brief, start::start};
use houscaper::voxels::{Choices, House, Reading, read_storeys};
use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;

fn main() {
    divan::main();
}

fn houses() -> Vec<(House, Reading, Choices)> {
    let home = PathBuf::from(env!("CARGO_MANIFEST_DIR"));
    let configs = home.join("configs");
    let text = std::fs::read(configs.join("starter.json")).expect("the starter brief is shipped");
    let brief = read_brief(&text, "starter.json").expect("the starter brief is valid");
    let (tileset, linear) = (home.join("tilesets").join(&brief.tileset), home.join("tilesets").join(&brief.linear));
    let paths = Paths { brief: configs.clone(), configs, tileset, linear };
    let evaluator = Evaluator::load(brief, &paths).expect("its books and tilesets are shipped");
    let options = [0, 1, 2, 3].map(|g| evaluator.options[g].len());
    let space = from_brief::space(&evaluator.brief, None, &evaluator.rules, options).expect("the plot holds houses");
    let draw = |seed| {
        let design = start(&space, &mut ChaCha8Rng::seed_from_u64(seed)).expect("the plot holds houses");
        let house = encode(&design.massing, &space.plot);
        let reading = read_storeys(&house);
        (house, reading, design.choices)
    };
    (0..64).map(draw).collect()
}

#[divan::bench]
fn cut_house(bencher: Bencher) {
    let houses = houses();
    let mut next = 0;
    bencher.bench_local(|| {
        next = (next + 1) % houses.len();
        let (house, reading, choices) = &houses[next];
        cut(black_box(house), reading, choices, Settings::default())
    });
}

#[divan::bench]
fn cut_and_count(bencher: Bencher) {
    let houses = houses();
    let mut next = 0;
    bencher.bench_local(|| {
        next = (next + 1) % houses.len();
        let (house, reading, choices) = &houses[next];
        cut(black_box(house), reading, choices, Settings::default()).map(|parts| parts.distinct())
    });
}
