//! Small briefs whose every design is known: enumerated from the rules alone, reached by the moves alone, and their true fronts found by
//! the search. `configs/exact/NAME.front.json` is what `houscaper enumerate configs/exact/NAME.json --out …` wrote.
//!
//! The long checks run by hand: `cargo test --release --test search_exact -- --ignored --nocapture` (twenty seeds on every brief, and the
//! million designs listed again).

use std::collections::BTreeMap;
use std::ops::ControlFlow;
use std::path::PathBuf;

use houscaper::brief::read_brief;
use houscaper::score::{Evaluator, Paths, SizingGoal};
use houscaper::search::crossover::crossover;
use houscaper::search::enumerate::front::{count, front};
use houscaper::search::enumerate::{Shapes, designs_of, is_settled, key, shapes};
use houscaper::search::houses::Houses;
use houscaper::search::hypervolume::hypervolume;
use houscaper::search::identity::identity;
use houscaper::search::massing::{Design, encode};
use houscaper::search::moves::Move;
use houscaper::search::plot::{ChoiceSpace, Space};
use houscaper::search::run::{Limits, run};
use houscaper::search::start::start;
use houscaper::search::steady::{Settings, Steady};
use houscaper::search::symmetry::Symmetry;
use houscaper::search::{Score, from_brief};
use houscaper::voxels::{Choices, House};
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;
use rayon::prelude::*;
use serde_json::Value;

const SMALL: [&str; 3] = ["cabin", "frame", "corner"];

struct Job {
    evaluator: Evaluator,
    space: Space,
    stored: Value,
}

impl Job {
    fn load(name: &str) -> Job {
        let home = PathBuf::from(env!("CARGO_MANIFEST_DIR"));
        let configs = home.join("configs");
        let text = std::fs::read(configs.join(format!("exact/{name}.json"))).expect("a shipped brief");
        let brief = read_brief(&text, name).expect("a brief");
        let paths = Paths {
            tileset: home.join("tilesets").join(&brief.tileset),
            linear: home.join("tilesets").join(&brief.linear),
            brief: configs.join("exact"),
            configs: configs.clone(),
        };
        let evaluator = Evaluator::load(brief, &paths).expect("its books");
        let options = [0, 1, 2, 3].map(|g| evaluator.options[g].len());
        let space = from_brief::space(&evaluator.brief, None, &evaluator.rules, options).expect("a space");
        let stored = std::fs::read(configs.join(format!("exact/{name}.front.json"))).expect("its front");
        Job { evaluator, space, stored: serde_json::from_slice(&stored).expect("JSON") }
    }

    fn shapes(&self) -> Shapes {
        shapes(&self.space, &|house| self.evaluator.broken_rule(house), 2_000_000).expect("small enough")
    }

    fn score(&self, design: &Design, house: &House) -> Score {
        let evaluation = self.evaluator.evaluate(house, &design.choices);
        let objectives = evaluation.minimised(&self.evaluator.brief.objectives);
        Score { objectives, violation: evaluation.violation }
    }

    fn front(&self) -> Vec<Vec<f64>> {
        self.stored["front"].as_array().expect("a list").iter().map(|f| numbers(&f["minimised"])).collect()
    }

    fn designs(&self) -> u64 {
        self.stored["designs"].as_u64().expect("a count")
    }

    fn check_count(&self, name: &str, shapes: &Shapes) {
        let (designs, hash) = count(&shapes.designs, &self.space);
        let found = (shapes.designs.len() as u64, designs, format!("{hash:032x}"));
        let stored = (
            self.stored["shapes"].as_u64().expect("a count"),
            self.designs(),
            self.stored["hash"].as_str().expect("a hash").to_owned(),
        );
        assert_eq!(found, stored, "{name}: enumerate it again if rules or moves have changed");
    }
}

fn numbers(value: &Value) -> Vec<f64> {
    value.as_array().expect("a list").iter().map(|v| v.as_f64().expect("a number")).collect()
}

fn near(a: &[f64], b: &[f64]) -> bool {
    a.len() == b.len() && a.iter().zip(b).all(|(x, y)| (x - y).abs() <= 1e-9 * y.abs().max(1.0))
}

fn volume(points: &[Vec<f64>], reference: &[f64]) -> f64 {
    hypervolume(&points.iter().map(Vec::as_slice).collect::<Vec<_>>(), reference)
}

#[test]
fn the_designs_of_the_small_briefs_are_those_stored() {
    for name in SMALL {
        let job = Job::load(name);
        let shapes = job.shapes();
        assert!(shapes.designs.iter().all(|d| is_settled(d, &job.space)));
        job.check_count(name, &shapes);
    }
}

/// Every design of the cabin, evaluated again.
#[test]
fn the_front_of_the_cabin_is_found_again() {
    let job = Job::load("cabin");
    let truth = front(&job.shapes(), &job.space, &|design, house| job.score(design, house), &mut |_| ());
    assert_eq!(truth.designs, job.designs());
    assert_eq!(truth.feasible, job.stored["feasible"].as_u64().expect("a count"));
    let (mut found, stored) = (truth.front.points(), job.front());
    found.sort_by(|a, b| a.partial_cmp(b).expect("numbers"));
    assert_eq!(found.len(), stored.len());
    assert!(found.iter().zip(&stored).all(|(a, b)| near(a, b)), "{found:?}\n{stored:?}");
    let reference = truth.reference.expect("something is feasible");
    assert!(near(&reference, &numbers(&job.stored["reference"])));
    assert!(near(&[truth.hypervolume], &[job.stored["hypervolume"].as_f64().expect("a number")]));
}

/// The second way: what starts, moves and crossover reach, and nothing else, is what the enumeration lists. Choices are set apart: they
/// combine freely.
#[test]
fn moves_reach_exactly_the_shapes_that_are_enumerated() {
    for name in SMALL {
        let job = Job::load(name);
        let space = Space { choices: ChoiceSpace::default(), ..job.space.clone() };
        let of = |d: &Design| identity(&encode(&d.massing, &space.plot), &Choices::default());
        let symmetries = Symmetry::of(&space.plot);
        let mut expected: BTreeMap<u128, bool> = BTreeMap::new();
        for shape in &shapes(&space, &|_| None, 2_000_000).expect("small enough").designs {
            for image in symmetries.iter().filter_map(|s| s.design(shape, &free_joists(&space))) {
                expected.insert(of(&image), false);
            }
        }
        let mut rng = ChaCha8Rng::seed_from_u64(7);
        let mut all: Vec<Design> = Vec::new();
        let mut fresh: Vec<Design> = (0..300).filter_map(|_| start(&space, &mut rng).ok()).collect();
        let mut left = expected.len();
        // Every shape is tried again and again: a rare move of a shape is one draw in some hundreds.
        for round in 0..400u64 {
            for design in fresh {
                let seen = expected.get_mut(&of(&design));
                let seen = seen.unwrap_or_else(|| panic!("{name}: reached and not enumerated: {design:?}"));
                if !std::mem::replace(seen, true) {
                    left -= 1;
                    all.push(design);
                }
            }
            if left == 0 {
                break;
            }
            let step = |(n, design): (usize, &Design)| -> Vec<Design> {
                let mut rng = ChaCha8Rng::seed_from_u64(round);
                rng.set_stream(n as u64);
                let mate = &all[rng.random_range(0..all.len())];
                let moved = (0..12).filter_map(|_| Move::draw(&mut rng).apply(design, &space, &mut rng));
                moved.collect::<Vec<_>>().into_iter().chain(crossover(design, mate, &space, &mut rng)).collect()
            };
            fresh = all.par_iter().enumerate().flat_map_iter(step).collect();
        }
        assert_eq!(left, 0, "{name}: of {} shapes {left} are not reached", expected.len());
        println!("{name}: {} shapes reached", expected.len());
    }
}

/// The space whose joists may run either way, so that quarter turns exist.
fn free_joists(space: &Space) -> Space {
    Space { choices: ChoiceSpace { options: [1, 1, 1, 1, u16::MAX, 1] }, ..space.clone() }
}

/// Images under the symmetries of the plot are the same house to the evaluator: objectives to rounding, since sums run in another order.
#[test]
fn images_of_a_house_are_worth_the_same() {
    for name in SMALL {
        let job = Job::load(name);
        let symmetries = Symmetry::of(&job.space.plot);
        let found = job.shapes();
        let mut rng = ChaCha8Rng::seed_from_u64(3);
        let mut images = 0;
        for _ in 0..60 {
            let shape = &found.designs[rng.random_range(0..found.designs.len())];
            let designs = designs_of(shape, &job.space, &symmetries);
            let (own, design) = &designs[rng.random_range(0..designs.len())];
            let whole = job.score(design, &encode(&design.massing, &job.space.plot));
            for image in symmetries.iter().filter_map(|s| s.design(design, &job.space)) {
                assert_eq!(key(&image, &job.space, &symmetries), *own);
                let score = job.score(&image, &encode(&image.massing, &job.space.plot));
                assert!(near(&score.objectives, &whole.objectives), "{name}: {whole:?} {score:?} {image:?}");
                // Violations of some images that fail differ by 2e-5 of themselves, more than rounding: the analysis is not quite
                // even-handed. Far below any reported digit, and held to five times that here.
                assert_eq!(score.is_feasible(), whole.is_feasible(), "{name}: {whole:?} {score:?}");
                assert!((score.violation - whole.violation).abs() <= 1e-4 * whole.violation.max(1.0), "{name}");
                images += 1;
            }
        }
        assert!(images > 60, "{name}: {images}");
    }
}

/// How far a seed gets: the share of the true hypervolume after so many evaluations.
fn share(job: &Job, seed: u64, evaluations: u64, settings: &Settings) -> f64 {
    let rules = |house: &House| job.evaluator.broken_rule(house);
    let goals = SizingGoal::of_brief(&job.evaluator.brief);
    let size = |house: &House, choices: &Choices, goal: usize| job.evaluator.resize(house, choices, goals[goal]);
    let mut houses = Houses::new(&job.space, Some(&rules)).sized_by(&size, goals.len());
    if std::env::var_os("EXACT_SYMMETRY").is_some() {
        houses = houses.up_to_symmetry();
    }
    let mut searcher = Steady::new(&houses, seed, settings.clone());
    let found = run(
        &mut searcher,
        &|design, house| job.score(design, house),
        &Limits { evaluations, ..Limits::default() },
        &mut |_| (),
        &mut |_| ControlFlow::Continue(()),
    );
    let (front, reference) = (job.front(), numbers(&job.stored["reference"]));
    // Nothing the search can reach is better than everything there is.
    let covered = |p: &[f64]| {
        let no_worse = |f: &Vec<f64>| f.iter().zip(p).all(|(a, b)| *a <= b + 1e-9 * b.abs().max(1.0));
        front.iter().any(no_worse)
    };
    assert!(found.archive.points().into_iter().all(covered), "a design that the enumeration lacks");
    hypervolume(&found.archive.points(), &reference) / volume(&front, &reference)
}

/// The settings that a user gets, or those that `EXACT_SETTINGS` changes, such as `starts=32:polish=0.1`.
fn settings() -> Settings {
    let mut settings = Settings::default();
    let asked = std::env::var("EXACT_SETTINGS").unwrap_or_default();
    for (key, value) in asked.split(':').filter_map(|part| part.split_once('=')) {
        let number: f64 = value.parse().expect("a number");
        match key {
            "batch" => settings.batch = number as usize,
            "pool" => settings.pool = number as usize,
            "starts" => settings.starts = number as usize,
            "grafts" => settings.grafts = number,
            "immigrants" => settings.immigrants = number,
            "polish" => settings.polish = number,
            "hopeful" => settings.hopeful = number,
            "local" => settings.local = number,
            "floor" => settings.floor = number,
            "rate" => settings.rate = number,
            "patience" => settings.patience = number as u64,
            _ => panic!("no setting {key}"),
        }
    }
    settings
}

/// Prints what `seeds` seeds reach within `part` of the evaluations of the enumeration; returns how many reach 99.9 %.
fn measure(name: &str, seeds: u64, part: f64) -> u64 {
    let job = Job::load(name);
    let evaluations = (job.designs() as f64 * part) as u64;
    let settings = settings();
    let mut shares: Vec<f64> = (1..=seeds).map(|seed| share(&job, seed, evaluations, &settings)).collect();
    shares.sort_by(f64::total_cmp);
    let reached = shares.iter().filter(|s| **s >= 0.999).count() as u64;
    println!(
        "{name}: {} designs, front of {}; in {evaluations} evaluations ({:.1} %) {reached} of {seeds} seeds reach 99.9 %; least {:.5} median {:.5}",
        job.designs(),
        job.front().len(),
        100.0 * part,
        shares[0],
        shares[shares.len() / 2],
    );
    reached
}

#[test]
fn the_search_reaches_the_true_fronts() {
    for name in SMALL {
        assert_eq!(measure(name, 3, 0.02), 3, "{name}");
    }
}

#[test]
#[ignore = "twenty seeds on every brief take minutes"]
fn twenty_seeds_reach_the_true_fronts() {
    let briefs = std::env::var("EXACT_BRIEFS").unwrap_or("cabin,frame,corner,million".into());
    let seeds = std::env::var("EXACT_SEEDS").map_or(20, |s| s.parse().expect("a count"));
    let parts = std::env::var("EXACT_PARTS").unwrap_or("0.005,0.01,0.02".into());
    let mut failed = Vec::new();
    for name in briefs.split(',') {
        if Job::load(name).stored["front"].is_null() {
            println!("{name}: skipped, its designs are counted and hashed but not yet evaluated");
            continue;
        }
        for part in parts.split(',').map(|p| p.parse().expect("a share")) {
            if measure(name, seeds, part) < seeds && part >= 0.02 {
                failed.push(name);
            }
        }
    }
    assert!(failed.is_empty(), "{failed:?}");
}

#[test]
#[ignore = "listing a million designs takes half a minute or more"]
fn the_million_designs_are_those_stored() {
    let job = Job::load("million");
    job.check_count("million", &job.shapes());
}
