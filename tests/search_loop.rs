//! The loop: better than random, never the same house twice, and the same bytes for any number of threads.

use houscaper::search::archive::Archive;
use houscaper::search::hypervolume::hypervolume;
use houscaper::search::nsga2::{Nsga2, Settings};
use houscaper::search::plot::{ChoiceSpace, Plot, Programme, Space};
use houscaper::search::random::RandomSearch;
use houscaper::search::run::{Limits, Outcome, Searcher, Stop, run};
use houscaper::search::{Score, dominates};
use houscaper::voxels::{Choices, House, Label};
use std::collections::BTreeSet;
use std::fmt::Write;
use std::ops::ControlFlow;

fn space() -> Space {
    let programme = Programme { floor_area_m2: [40.0, 90.0], ..Programme::default() };
    let choices = ChoiceSpace { options: [6, 6, 4, 5, 4, 2] };
    Space::new(Plot::new([10, 8, 16], None).expect("plot"), programme, choices).expect("space")
}

/// A toy with the conflict of the real problem: surface and sections cost, room and slender sections are wanted.
fn toy(house: &House, choices: &Choices) -> Score {
    let v = &house.voxels;
    let filled = v.filled_count() as f64;
    let mut faces = 0.0;
    for ([x, y, z], _) in v.iter().filter(|(_, l)| l.is_filled()) {
        let [x, y, z] = [x as isize, y as isize, z as isize];
        for [a, b, c] in [[x + 1, y, z], [x - 1, y, z], [x, y + 1, z], [x, y - 1, z], [x, y, z + 1], [x, y, z - 1]] {
            faces += f64::from(u8::from(!v.at([a, b, c]).is_filled()));
        }
    }
    let glass = v.iter().filter(|(_, l)| *l == Label::Window).count() as f64;
    let section: f64 = choices.0[..4].iter().map(|&c| (f64::from(c) - 2.0).powi(2)).sum();
    let price = faces + 8.0 * glass + 15.0 * section;
    let openness = -(filled + 12.0 * glass) / 10.0;
    Score { objectives: vec![price, openness], violation: (40.0 - glass).max(0.0) / 40.0 - 0.5 }
}

fn search(searcher: &mut dyn Searcher, evaluations: u64, reference: Option<Vec<f64>>) -> (Outcome, String) {
    let mut log = String::new();
    let mut sink = |e: &houscaper::search::proposal::Evaluated| {
        let c = &e.candidate;
        writeln!(log, "{},{},{:?},{},{:?}", c.id, c.generation, c.parents, c.operator.name(), e.score)
            .expect("a string");
    };
    let limits = Limits { evaluations, reference };
    let outcome = run(searcher, &toy, &limits, &mut sink, &mut |_| ControlFlow::Continue(()));
    (outcome, log)
}

#[test]
fn nsga2_beats_random_search_in_ten_of_ten_seeds() {
    let space = space();
    let reference = vec![1500.0, 0.0];
    let settings = Settings { population: 40, offspring: 40, ..Settings::default() };
    for seed in 0..10 {
        let (ours, _) = search(&mut Nsga2::new(&space, seed, settings, None), 1500, Some(reference.clone()));
        let (theirs, _) = search(&mut RandomSearch::new(&space, seed, 40, None), 1500, Some(reference.clone()));
        let (a, b) = (ours.progress.hypervolume, theirs.progress.hypervolume);
        assert!(a > b, "seed {seed}: {a:?} against {b:?}");
    }
}

#[test]
fn any_number_of_threads_gives_the_same_bytes_and_another_seed_differs() {
    let space = space();
    let log = |threads: usize, seed: u64| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("a pool");
        pool.install(|| {
            let mut searcher =
                Nsga2::new(&space, seed, Settings { population: 50, offspring: 50, crossover: 0.5, sizing: 0.0 }, None);
            let (outcome, log) = search(&mut searcher, 500, None);
            (log, format!("{:?} {:?} {:?}", outcome.archive, outcome.history, searcher.tally()))
        })
    };
    let one = log(1, 3);
    assert_eq!(one, log(2, 3));
    assert_eq!(one, log(2, 3));
    assert_ne!(one, log(2, 4));
    assert_eq!(one.0.lines().count(), 500);
}

#[test]
fn nothing_is_evaluated_twice_and_history_never_falls() {
    let space = space();
    let mut searcher = Nsga2::new(&space, 1, Settings::default(), None);
    let mut keys = BTreeSet::new();
    let mut ids = 0;
    let outcome = run(
        &mut searcher,
        &toy,
        &Limits { evaluations: 1000, reference: None },
        &mut |e| {
            assert_eq!(e.candidate.id, ids);
            ids += 1;
            let key = houscaper::search::identity::identity(&e.candidate.house, &e.candidate.design.choices);
            assert!(keys.insert(key), "evaluated twice");
        },
        &mut |_| ControlFlow::Continue(()),
    );
    assert_eq!((outcome.stop, keys.len()), (Stop::Done, 1000));
    assert!(outcome.history.windows(2).all(|w| w[0].0 < w[1].0 && w[0].1 <= w[1].1));
    assert!(outcome.history.last().is_some_and(|h| Some(h.1) == outcome.progress.hypervolume));
    let points = outcome.archive.points();
    for (i, a) in points.iter().enumerate() {
        assert!(points.iter().enumerate().all(|(j, b)| i == j || !dominates(a, b) && a != b));
    }
}

#[test]
fn a_rule_check_is_hard_and_counted() {
    let space = space();
    let no_flat_roofs = |house: &House| {
        let top = house.voxels.iter().filter(|(_, l)| l.is_filled()).map(|(v, _)| v[2]).max();
        top.is_some_and(|k| k % 6 == 0).then_some("hipped")
    };
    let mut searcher = Nsga2::new(
        &space,
        1,
        Settings { population: 30, offspring: 30, crossover: 0.3, sizing: 0.0 },
        Some(&no_flat_roofs),
    );
    let mut proposed = Vec::new();
    let limits = Limits { evaluations: 120, reference: None };
    run(&mut searcher, &toy, &limits, &mut |e| proposed.push(e.candidate.house.clone()), &mut |_| {
        ControlFlow::Continue(())
    });
    assert!(proposed.iter().all(|h| no_flat_roofs(h).is_none()));
    assert!(searcher.tally().rejected.iter().any(|((_, rule), n)| *rule == "hipped" && *n > 0));
}

#[test]
fn a_tiny_space_is_exhausted_without_repeats_and_a_run_can_be_stopped() {
    let space = space();
    let mut searcher = RandomSearch::new(&space, 1, 10, None);
    let limits = Limits { evaluations: 1000, reference: None };
    let outcome = run(&mut searcher, &toy, &limits, &mut |_| {}, &mut |p| {
        if p.evaluations >= 30 { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    });
    assert_eq!((outcome.stop, outcome.progress.evaluations), (Stop::Interrupted, 30));
    let reject_all = |_: &House| Some("never");
    let mut searcher = RandomSearch::new(&space, 1, 2, Some(&reject_all));
    let outcome = run(&mut searcher, &toy, &limits, &mut |_| {}, &mut |_| ControlFlow::Continue(()));
    assert_eq!((outcome.stop, outcome.progress.evaluations), (Stop::Exhausted, 0));
}

#[test]
fn the_archive_is_the_non_dominated_set_of_any_sequence() {
    let mut archive = Archive::new();
    let mut all: Vec<Vec<f64>> = Vec::new();
    let mut state = 12345u64;
    let mut volume = 0.0;
    for id in 0..400 {
        let mut next = || {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
            (state >> 33) % 30
        };
        let point: Vec<f64> = (0..3).map(|_| next() as f64).collect();
        archive.offer(id, &Score { objectives: point.clone(), violation: 0.0 }, || id);
        all.push(point);
        let now = hypervolume(&archive.points(), &[30.0; 3]);
        assert!(now >= volume, "hypervolume never falls");
        volume = now;
    }
    let first = |p: &Vec<f64>| all.iter().position(|q| q == p);
    let expected: Vec<u64> = (0..400u64)
        .filter(|&i| {
            let p = &all[i as usize];
            all.iter().all(|q| !dominates(q, p)) && first(p) == Some(i as usize)
        })
        .collect();
    assert_eq!(archive.entries().iter().map(|e| e.id).collect::<Vec<_>>(), expected);
    assert!(!archive.offer(999, &Score { objectives: vec![-1.0; 3], violation: 0.1 }, || 999));
    assert!(!archive.offer(999, &Score { objectives: vec![f64::NAN; 3], violation: 0.0 }, || 999));
}
