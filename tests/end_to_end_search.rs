//! The search against a random search with the same starts, moves and rules, by hypervolume on the starter brief.
//!
//! Reduced by default. In full: `HOUSCAPER_EVALUATIONS=5000 HOUSCAPER_SEEDS=10 cargo test --release --test end_to_end_search --
//! --nocapture`, which prints a row per seed.

#[path = "common/runs.rs"]
mod runs;

use std::ops::ControlFlow;

use houscaper::score::Evaluator;
use houscaper::search::nsga2::{Nsga2, Settings};
use houscaper::search::plot::Space;
use houscaper::search::random::RandomSearch;
use houscaper::search::run::{Limits, Outcome, Searcher, run};
use houscaper::search::{Score, from_brief};
use houscaper::voxels::House;

/// A number from the environment.
fn setting(name: &str, default: u64) -> u64 {
    std::env::var(name).ok().and_then(|text| text.parse().ok()).unwrap_or(default)
}

fn explore(evaluator: &Evaluator, searcher: &mut dyn Searcher, limits: &Limits) -> Outcome {
    let goals = &evaluator.brief.objectives;
    let score = |house: &House, choices: &_| {
        let evaluation = evaluator.evaluate(house, choices);
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
    let (evaluations, seeds) = (setting("HOUSCAPER_EVALUATIONS", 1500), setting("HOUSCAPER_SEEDS", 2));
    let mut lost = Vec::new();
    println!("seed  search       random       ratio   feasible      front");
    for seed in 1..=seeds {
        let mut nsga2 = Nsga2::new(&space, seed, Settings::default(), Some(&rules));
        let ours = explore(&evaluator, &mut nsga2, &Limits { evaluations, reference: None });
        let mut random = RandomSearch::new(&space, seed, Settings::default().population, Some(&rules));
        let theirs = explore(&evaluator, &mut random, &Limits { evaluations, reference: ours.reference.clone() });
        let volume = |outcome: &Outcome| outcome.progress.hypervolume.unwrap_or(0.0);
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
