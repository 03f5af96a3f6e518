//! Times of the search's own steps: encoding, one move with settling, a start, and a whole batch.

use divan::{Bencher, black_box};
use houscaper::search::houses::Houses;
use houscaper::search::identity::identity;
use houscaper::search::massing::{Design, encode};
use houscaper::search::moves::Move;
use houscaper::search::plot::{ChoiceSpace, Plot, Programme, Space};
use houscaper::search::proposal::{CandidateOf, Evaluated, EvaluatedOf};
use houscaper::search::run::Searcher;
use houscaper::search::steady::{Settings, Steady};
use houscaper::search::{Score, start::start};
use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;

fn main() {
    divan::main();
}

fn space() -> Space {
    let programme = Programme { floor_area_m2: [40.0, 90.0], ..Programme::default() };
    let choices = ChoiceSpace { options: [6, 6, 4, 5, 4, 2] };
    let plot = Plot::new([10, 8, 16], None).expect("a plot of 10 x 8 modules is large enough");
    Space::new(plot, programme, choices).expect("the programme's ranges are ordered")
}

fn designs(space: &Space, count: u64) -> Vec<Design> {
    let draw = |i| {
        let mut rng = ChaCha8Rng::seed_from_u64(i);
        start(space, &mut rng).expect("the plot holds houses")
    };
    (0..count).map(draw).collect()
}

#[divan::bench]
fn encode_and_identity(bencher: Bencher) {
    let space = space();
    let designs = designs(&space, 64);
    let mut i = 0;
    bencher.bench_local(|| {
        i = (i + 1) % designs.len();
        let house = encode(&designs[i].massing, &space.plot);
        black_box(identity(&house, &designs[i].choices))
    });
}

#[divan::bench]
fn encode_only(bencher: Bencher) {
    let space = space();
    let designs = designs(&space, 64);
    let mut i = 0;
    bencher.bench_local(|| {
        i = (i + 1) % designs.len();
        encode(black_box(&designs[i].massing), &space.plot)
    });
}

#[divan::bench]
fn one_move(bencher: Bencher) {
    let space = space();
    let designs = designs(&space, 64);
    let mut rng = ChaCha8Rng::seed_from_u64(1);
    let mut i = 0;
    bencher.bench_local(|| {
        i = (i + 1) % designs.len();
        Move::draw(&mut rng).apply(&designs[i], &space, &mut rng)
    });
}

#[divan::bench]
fn one_start(bencher: Bencher) {
    let space = space();
    let mut rng = ChaCha8Rng::seed_from_u64(1);
    bencher.bench_local(|| start(&space, &mut rng));
}

/// Ask for 100 children and tell their scores (a cheap stand-in), from a filled population on.
#[divan::bench(sample_count = 30)]
fn ask_and_tell_100(bencher: Bencher) {
    let space = space();
    let houses = Houses::new(&space, None);
    let mut searcher = Steady::new(&houses, 1, Settings { batch: 100, ..Settings::default() });
    let mut round = || {
        let score = |c: &CandidateOf<Houses>| {
            let filled = c.form.voxels.filled_count() as f64;
            let sections = c.genome.choices.0.iter().map(|&v| f64::from(v)).sum::<f64>();
            Score { objectives: vec![filled + sections, -filled, sections * filled], violation: 0.0 }
        };
        let batch = searcher.ask(100);
        let told: Vec<EvaluatedOf<Houses>> =
            batch.into_iter().map(|c| Evaluated { score: score(&c), candidate: c }).collect();
        searcher.tell(&told);
    };
    round();
    bencher.bench_local(round);
}
