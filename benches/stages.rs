//! One evaluation stage by stage on houses of the starter brief, and the steps of the search around it.
//!
//! `cargo bench --bench stages`: medians are of one house each, so that their sum compares with `whole_evaluation`.

use std::path::PathBuf;
use std::sync::LazyLock;

use divan::{Bencher, black_box};
use houscaper::brief::read_brief;
use houscaper::cubes::Mask;
use houscaper::envelope::KeyCache;
use houscaper::frame::{self, FrameWorkspace, JointScratch, distinct_joints};
use houscaper::parts;
use houscaper::price::cost;
use houscaper::score::{Evaluator, Paths};
use houscaper::search::houses::Houses;
use houscaper::search::massing::{Design, encode};
use houscaper::search::plot::Space;
use houscaper::search::proposal::{Evaluated, EvaluatedOf};
use houscaper::search::run::Searcher;
use houscaper::search::steady::{Settings, Steady};
use houscaper::search::{Score, from_brief, start::start};
use houscaper::structure::{self, Workspace};
use houscaper::voxels::rules::{self, Scratch};
use houscaper::voxels::{House, Reading, read_storeys};
use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;

fn main() {
    divan::main();
}

/// The starter brief with houses that keep every rule.
struct Bench {
    evaluator: Evaluator,
    space: Space,
    houses: Vec<(Design, House, Reading)>,
}

/// Houses drawn.
const HOUSES: u64 = 64;

static BENCH: LazyLock<Bench> = LazyLock::new(|| {
    let home = PathBuf::from(env!("CARGO_MANIFEST_DIR"));
    let configs = home.join("configs");
    let text = std::fs::read(configs.join("starter.json")).expect("the starter brief is shipped");
    let brief = read_brief(&text, "starter.json").expect("the starter brief is valid");
    let tileset = home.join("tilesets").join(&brief.tileset);
    let linear = home.join("tilesets").join(&brief.linear);
    let paths = Paths { brief: configs.clone(), configs, tileset, linear };
    let evaluator = Evaluator::load(brief, &paths).expect("its books and tilesets are shipped");
    let options = [0, 1, 2, 3].map(|g| evaluator.options[g].len());
    let space = from_brief::space(&evaluator.brief, None, &evaluator.rules, options).expect("the plot holds houses");
    let houses = (0..HOUSES)
        .map(|seed| {
            let design = start(&space, &mut ChaCha8Rng::seed_from_u64(seed)).expect("the plot holds houses");
            let house = encode(&design.massing, &space.plot);
            let reading = read_storeys(&house);
            (design, house, reading)
        })
        .filter(|(_, house, _)| evaluator.broken_rule(house).is_none())
        .collect();
    Bench { evaluator, space, houses }
});

/// Calls `stage` with one house after the other.
fn each<T>(bencher: Bencher, mut stage: impl FnMut(&Bench, &(Design, House, Reading)) -> T) {
    let bench = &*BENCH;
    let mut next = 0;
    bencher.bench_local(|| {
        next = (next + 1) % bench.houses.len();
        stage(black_box(bench), &bench.houses[next])
    });
}

#[divan::bench]
fn a_encode(bencher: Bencher) {
    each(bencher, |bench, (design, _, _)| encode(&design.massing, &bench.space.plot));
}

#[divan::bench]
fn b_read_storeys(bencher: Bencher) {
    each(bencher, |_, (_, house, _)| read_storeys(house));
}

#[divan::bench]
fn c_rules(bencher: Bencher) {
    let mut scratch = Scratch::default();
    each(bencher, |bench, (_, house, reading)| rules::violation(house, reading, &bench.evaluator.rules, &mut scratch));
}

#[divan::bench]
fn d_envelope_areas(bencher: Bencher) {
    let mut cache = KeyCache::default();
    each(bencher, |bench, (_, house, reading)| bench.evaluator.tiling.survey(house, reading, &mut cache));
}

#[divan::bench]
fn e_frame(bencher: Bencher) {
    let mut workspace = FrameWorkspace::default();
    each(bencher, |bench, (design, house, reading)| {
        let lines = |mask: u8| bench.evaluator.linear.lines(Mask(mask));
        frame::build(house, reading, &design.choices, lines, &mut workspace)
    });
}

#[divan::bench]
fn f_structure(bencher: Bencher) {
    let evaluator = &BENCH.evaluator;
    let mut frames = FrameWorkspace::default();
    let frames: Vec<_> = BENCH
        .houses
        .iter()
        .filter_map(|(design, house, reading)| {
            let lines = |mask: u8| evaluator.linear.lines(Mask(mask));
            let frame = frame::build(house, reading, &design.choices, lines, &mut frames).ok()?;
            Some((frame, evaluator.sections(&design.choices)))
        })
        .collect();
    let mut workspace = Workspace::default();
    let mut next = 0;
    bencher.bench_local(|| {
        next = (next + 1) % frames.len();
        let (frame, sections) = &frames[next];
        structure::assess(frame, &evaluator.catalogue, sections, &evaluator.loads, &mut workspace)
    });
}

#[divan::bench]
fn g_parts_and_their_repetition(bencher: Bencher) {
    let settings = BENCH.evaluator.part_settings();
    each(bencher, |_, (design, house, reading)| {
        parts::cut(house, reading, &design.choices, settings).map(|parts| parts.works())
    });
}

#[divan::bench]
fn g_distinct_joints(bencher: Bencher) {
    let mut workspace = FrameWorkspace::default();
    let mut frame_of = |(design, house, reading): &(Design, House, Reading)| {
        let lines = |mask: u8| BENCH.evaluator.linear.lines(Mask(mask));
        frame::build(house, reading, &design.choices, lines, &mut workspace).ok()
    };
    let frames: Vec<_> = BENCH.houses.iter().filter_map(&mut frame_of).collect();
    let (mut scratch, mut next) = (JointScratch::default(), 0);
    bencher.bench_local(|| {
        next = (next + 1) % frames.len();
        distinct_joints(black_box(&frames[next]), &mut scratch)
    });
}

#[divan::bench]
fn g_cost_of_a_takeoff(bencher: Bencher) {
    let evaluator = &BENCH.evaluator;
    let (design, house, _) = &BENCH.houses[0];
    let takeoff =
        evaluator.evaluate(house, &design.choices).takeoff.expect("a house that keeps the rules is taken off");
    bencher.bench_local(|| cost(black_box(&takeoff), &evaluator.rates));
}

#[divan::bench]
fn h_whole_evaluation(bencher: Bencher) {
    each(bencher, |bench, (design, house, _)| {
        bench.evaluator.forget();
        bench.evaluator.evaluate(house, &design.choices)
    });
}

/// An evaluation of a house that differs from one before by its sections.
#[divan::bench]
fn h_whole_evaluation_other_sections(bencher: Bencher) {
    each(bencher, |bench, (design, house, _)| bench.evaluator.evaluate(house, &design.choices));
}

/// A house that is ruled out without a solve.
#[divan::bench]
fn h_screened_out(bencher: Bencher) {
    each(bencher, |bench, (design, house, _)| {
        bench.evaluator.forget();
        bench.evaluator.is_beaten(house, &design.choices, &|_| true)
    });
}

/// Asks for 100 children, rule check included, and tells them stand-in scores: divide by 100 for one house.
#[divan::bench(sample_count = 20)]
fn i_ask_and_tell_100(bencher: Bencher) {
    let bench = &*BENCH;
    let check = |house: &House| bench.evaluator.broken_rule(house);
    let houses = Houses::new(&bench.space, Some(&check));
    let mut searcher = Steady::new(&houses, 1, Settings { batch: 100, ..Settings::default() });
    let mut round = || {
        let batch = searcher.ask(100);
        let told: Vec<EvaluatedOf<Houses>> = batch
            .into_iter()
            .map(|candidate| {
                let filled = candidate.form.voxels.filled_count() as f64;
                let sections = candidate.genome.choices.0.iter().map(|&v| f64::from(v)).sum::<f64>();
                let objectives = vec![filled + sections, -filled, sections * filled];
                Evaluated { candidate, score: Score { objectives, violation: 0.0 } }
            })
            .collect();
        searcher.tell(&told);
    };
    round();
    bencher.bench_local(round);
}
