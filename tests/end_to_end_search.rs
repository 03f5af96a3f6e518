//! The search against a random search with the same starts, moves and rules, by hypervolume on the starter brief.
//!
//! Reduced by default. In full: `HOUSCAPER_EVALUATIONS=5000 HOUSCAPER_SEEDS=10 cargo test --release --test end_to_end_search --
//! --nocapture`, which prints a row per seed.

#[path = "common/runs.rs"]
mod runs;

use std::ops::ControlFlow;
use std::sync::Mutex;
use std::time::Instant;

use houscaper::score::{Evaluator, SizingGoal};
use houscaper::search::houses::Houses;
use houscaper::search::massing::Design;
use houscaper::search::plot::Space;
use houscaper::search::random::RandomSearch;
use houscaper::search::run::{Limits, Outcome, Searcher, run};
use houscaper::search::steady::{Settings, Steady};
use houscaper::search::{Score, from_brief};
use houscaper::voxels::{Choices, House};

/// A number from the environment.
fn setting(name: &str, default: u64) -> u64 {
    std::env::var(name).ok().and_then(|text| text.parse().ok()).unwrap_or(default)
}

fn explore<'h>(evaluator: &Evaluator, searcher: &mut dyn Searcher<Houses<'h>>, limits: &Limits) -> Outcome<Design> {
    let goals = &evaluator.brief.objectives;
    let score = |design: &Design, house: &House| {
        let evaluation = evaluator.evaluate(house, &design.choices);
        Score { objectives: evaluation.minimised(goals), violation: evaluation.violation }
    };
    run(searcher, &score, limits, &mut |_| (), &mut |_| ControlFlow::Continue(()))
}

#[test]
fn the_search_beats_random_moves() {
    let evaluator = runs::evaluator(&runs::repository().join("configs/starter.json"));
    let options = [0, 1, 2, 3].map(|g| evaluator.options[g].len());
    let space: Space = from_brief::space(&evaluator.brief, None, &evaluator.rules, options).expect("a space");
    let rules = |house: &House| evaluator.broken_rule(house);
    let houses = Houses::new(&space, Some(&rules));
    let (evaluations, seeds) = (setting("HOUSCAPER_EVALUATIONS", 1500), setting("HOUSCAPER_SEEDS", 2));
    let mut lost = Vec::new();
    println!("seed  search       random       ratio   feasible      front");
    for seed in 1..=seeds {
        let mut steady = Steady::new(&houses, seed, Settings::default());
        let ours = explore(&evaluator, &mut steady, &Limits { evaluations, reference: None, stagnation: None });
        let mut random = RandomSearch::new(&houses, seed, 100);
        let theirs = explore(
            &evaluator,
            &mut random,
            &Limits { evaluations, reference: ours.reference.clone(), stagnation: None },
        );
        let volume = |outcome: &Outcome<Design>| outcome.progress.hypervolume.unwrap_or(0.0);
        let (a, b) = (volume(&ours), volume(&theirs));
        println!(
            "{seed:4}  {a:.5e}  {b:.5e}  {:.3}   {:4} {:4}     {:3} {:3}",
            a / b,
            ours.progress.feasible,
            theirs.progress.feasible,
            ours.progress.front,
            theirs.progress.front
        );
        if a <= b {
            lost.push(seed);
        }
    }
    assert!(lost.is_empty(), "random moves reach at least as far with seeds {lost:?} of {seeds}");
}

/// The screen spares a solve only where its outcome could change nothing: every house it rules out is evaluated all the same here, and
/// none would enter the archive that the search ends with.
#[test]
fn the_screen_rules_out_nothing_that_would_be_kept() {
    let evaluator = runs::evaluator(&runs::repository().join("configs/starter.json"));
    let options = [0, 1, 2, 3].map(|g| evaluator.options[g].len());
    let space: Space = from_brief::space(&evaluator.brief, None, &evaluator.rules, options).expect("a space");
    let rules = |house: &House| evaluator.broken_rule(house);
    let ruled_out = Mutex::new(Vec::new());
    let screen = |house: &House, choices: &Choices, beaten: &dyn Fn(&[f64]) -> bool| {
        let is_beaten = evaluator.is_beaten(house, choices, beaten);
        if is_beaten {
            let evaluation = evaluator.details(house, choices).evaluation;
            let objectives = evaluation.minimised(&evaluator.brief.objectives);
            ruled_out.lock().expect("no panic").push(Score { objectives, violation: evaluation.violation });
        }
        is_beaten
    };
    let houses = Houses::new(&space, Some(&rules)).screened_by(&screen);
    let mut steady = Steady::new(&houses, 1, Settings::default());
    let outcome = explore(&evaluator, &mut steady, &Limits { evaluations: 500, reference: None, stagnation: None });
    let ruled_out = ruled_out.lock().expect("no panic");
    let feasible: Vec<&Score> = ruled_out.iter().filter(|s| s.is_feasible()).collect();
    println!("{} evaluated, {} ruled out, {} of these feasible", 500, ruled_out.len(), feasible.len());
    assert!(feasible.len() > 100, "a test of something");
    assert!(feasible.iter().all(|s| outcome.archive.covers(&s.objectives)));
    assert_eq!(steady.tally().screened.values().sum::<u64>() as usize, ruled_out.len());
}

/// Sizing as a move: with it the search reaches further in as many evaluations, on the mean of the seeds (not on each: sized houses may
/// crowd others out of a population). The analyses that sizing takes are no evaluations, so the time of both is printed too.
#[test]
fn sizing_takes_the_search_further() {
    let evaluator = runs::evaluator(&runs::repository().join("configs/starter.json"));
    let options = [0, 1, 2, 3].map(|g| evaluator.options[g].len());
    let space: Space = from_brief::space(&evaluator.brief, None, &evaluator.rules, options).expect("a space");
    let rules = |house: &House| evaluator.broken_rule(house);
    let goals = SizingGoal::of_brief(&evaluator.brief);
    let size = |house: &House, choices: &Choices, goal: usize| evaluator.resize(house, choices, goals[goal]);
    let plain_houses = Houses::new(&space, Some(&rules));
    let sized_houses = plain_houses.clone().sized_by(&size, goals.len());
    let (evaluations, seeds) = (setting("HOUSCAPER_EVALUATIONS", 1500), setting("HOUSCAPER_SEEDS", 2));
    let share = std::env::var("HOUSCAPER_SIZING").ok().and_then(|s| s.parse().ok());
    let settings = Settings { polish: share.unwrap_or(Settings::default().polish), ..Settings::default() };
    let mut logs = 0.0;
    println!("seed  with sizing  without      ratio   seconds       front");
    for seed in 1..=seeds {
        let started = Instant::now();
        let mut plain = Steady::new(&plain_houses, seed, settings.clone());
        let without = explore(&evaluator, &mut plain, &Limits { evaluations, reference: None, stagnation: None });
        let middle = Instant::now();
        let mut sizing = Steady::new(&sized_houses, seed, settings.clone());
        let with = explore(
            &evaluator,
            &mut sizing,
            &Limits { evaluations, reference: without.reference.clone(), stagnation: None },
        );
        let seconds = [middle.elapsed().as_secs_f64(), (middle - started).as_secs_f64()];
        let [a, b] = [&with, &without].map(|outcome| outcome.progress.hypervolume.unwrap_or(0.0));
        let fronts = [with.progress.front, without.progress.front];
        println!(
            "{seed:4}  {a:.5e}  {b:.5e}  {:.3}   {:5.1} {:5.1}   {:3} {:3}",
            a / b,
            seconds[0],
            seconds[1],
            fronts[0],
            fronts[1]
        );
        logs += (a / b).ln();
    }
    let mean = (logs / seeds as f64).exp();
    println!("mean of {seeds} seeds {mean:.3}");
    assert!(mean > 1.0, "sizing does not help: {mean}");
}
