//! The loop: better than random, never the same house twice, and the same bytes for any number of threads.

use houscaper::search::archive::Archive;
use houscaper::search::domain::{Domain, Operator};
use houscaper::search::elites::{self, MapElites};
use houscaper::search::evolution::{Evolution, Settings};
use houscaper::search::hill::HillClimber;
use houscaper::search::houses::Houses;
use houscaper::search::hypervolume::hypervolume;
use houscaper::search::massing::Design;
use houscaper::search::plot::{ChoiceSpace, Plot, Programme, Space};
use houscaper::search::random::RandomSearch;
use houscaper::search::run::{Limits, Outcome, Searcher, Stop, run};
use houscaper::search::steady::{self, Steady};
use houscaper::search::{Score, dominates};
use houscaper::voxels::{Choices, House, Label};
use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write;
use std::ops::ControlFlow;

fn space() -> Space {
    let programme = Programme { floor_area_m2: [40.0, 90.0], ..Programme::default() };
    let choices = ChoiceSpace { options: [6, 6, 4, 5, 4, 2] };
    Space::new(Plot::new([10, 8, 16], None).expect("plot"), programme, choices).expect("space")
}

/// A toy with the conflict of the real problem: surface and sections cost, room and slender sections are wanted.
fn toy(design: &Design, house: &House) -> Score {
    let choices = &design.choices;
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

fn search<'h>(
    searcher: &mut dyn Searcher<Houses<'h>>,
    evaluations: u64,
    reference: Option<Vec<f64>>,
) -> (Outcome<Design>, String) {
    let mut log = String::new();
    let mut sink = |e: &houscaper::search::proposal::EvaluatedOf<Houses<'h>>| {
        let c = &e.candidate;
        writeln!(log, "{},{},{:?},{},{:?}", c.id, c.generation, c.parents, c.operator.name(), e.score)
            .expect("a string");
    };
    let limits = Limits { evaluations, reference, stagnation: None };
    let outcome = run(searcher, &toy, &limits, &mut sink, &mut |_| ControlFlow::Continue(()));
    (outcome, log)
}

/// A searcher by name over the houses of a space, with small populations.
fn searcher<'a>(name: &str, houses: &'a Houses<'a>, seed: u64) -> Box<dyn Searcher<Houses<'a>> + 'a> {
    let generational = Settings { population: 40, offspring: 40, ..Settings::default() };
    match name {
        "steady" => {
            Box::new(Steady::new(houses, seed, steady::Settings { pool: 40, starts: 40, ..Default::default() }))
        }
        "nsga2" => Box::new(Evolution::nsga2(houses, seed, generational)),
        "nsga3" => Box::new(Evolution::nsga3(houses, seed, 2, generational)),
        "map-elites" => Box::new(MapElites::new(houses, seed, elites::Settings { starts: 40, ..Default::default() })),
        "hill" => Box::new(HillClimber::new(houses, seed, 2, 8)),
        _ => Box::new(RandomSearch::new(houses, seed, 40)),
    }
}

const NAMES: [&str; 6] = ["steady", "nsga2", "nsga3", "hill", "random", "map-elites"];

#[test]
fn every_search_beats_random_moves_in_ten_of_ten_seeds() {
    let space = space();
    let houses = Houses::new(&space, None);
    let reference = vec![1500.0, 0.0];
    for seed in 0..10 {
        let volume = |name: &str| {
            let (outcome, _) = search(searcher(name, &houses, seed).as_mut(), 1500, Some(reference.clone()));
            outcome.progress.hypervolume.expect("a reference")
        };
        let random = volume("random");
        for name in &NAMES[..4] {
            let ours = volume(name);
            assert!(ours > random, "{name}, seed {seed}: {ours} against {random}");
        }
    }
}

#[test]
fn any_number_of_threads_gives_the_same_bytes_and_another_seed_differs() {
    let space = space();
    let log = |name: &str, threads: usize, seed: u64| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("a pool");
        pool.install(|| {
            let size = |_: &House, choices: &Choices, goal: usize| {
                let mut choices = *choices;
                choices.0[goal] = 2;
                Some(choices)
            };
            let houses = Houses::new(&space, None).sized_by(&size, 3);
            let mut searcher = searcher(name, &houses, seed);
            let (outcome, log) = search(searcher.as_mut(), 500, None);
            (log, format!("{:?} {:?} {:?}", outcome.archive.entries(), outcome.history, searcher.tally()))
        })
    };
    for name in NAMES {
        let one = log(name, 1, 3);
        assert_eq!(one, log(name, 2, 3), "{name}");
        assert_eq!(one, log(name, 5, 3), "{name}");
        assert_ne!(one, log(name, 2, 4), "{name}");
        assert_eq!(one.0.lines().count(), 500, "{name}");
    }
}

#[test]
fn nothing_is_evaluated_twice_and_history_never_falls() {
    let space = space();
    let houses = Houses::new(&space, None);
    for name in NAMES {
        let mut keys = BTreeSet::new();
        let mut ids = 0;
        let outcome = run(
            searcher(name, &houses, 1).as_mut(),
            &toy,
            &Limits { evaluations: 1000, reference: None, stagnation: None },
            &mut |e| {
                assert_eq!(e.candidate.id, ids);
                ids += 1;
                let key = houscaper::search::identity::identity(&e.candidate.form, &e.candidate.genome.choices);
                assert!(keys.insert(key), "{name}: evaluated twice");
            },
            &mut |_| ControlFlow::Continue(()),
        );
        assert_eq!((outcome.stop, keys.len()), (Stop::Done, 1000), "{name}");
        assert!(outcome.history.windows(2).all(|w| w[0].0 < w[1].0 && w[0].1 <= w[1].1), "{name}");
        let (last, reference) = (outcome.history.last().expect("a history"), outcome.reference.expect("a reference"));
        assert_eq!(Some(last.1), outcome.progress.hypervolume, "{name}");
        let points = outcome.archive.points();
        // The sum of what each entry added is the volume of what is left.
        let whole = hypervolume(&points, &reference);
        assert!((last.1 - whole).abs() <= 1e-9 * whole, "{name}: {} against {whole}", last.1);
        for (i, a) in points.iter().enumerate() {
            assert!(points.iter().enumerate().all(|(j, b)| i == j || !dominates(a, b) && a != b), "{name}");
        }
    }
}

/// Every cell holds the first of the best that was met of its kind, told by going through all evaluations again; and the map is what the
/// search is for: in as many evaluations it meets more kinds than the steady state, and is worth more over all kinds than random moves.
#[test]
fn a_map_holds_the_best_of_each_kind_and_meets_more_kinds() {
    let space = space();
    let houses = Houses::new(&space, None);
    let reach = |name: &str, seed: u64| {
        let mut best: BTreeMap<_, (u64, Score)> = BTreeMap::new();
        let mut searcher = searcher(name, &houses, seed);
        let limits = Limits { evaluations: 1500, reference: None, stagnation: None };
        run(
            searcher.as_mut(),
            &toy,
            &limits,
            &mut |e| {
                let niche = houses.niche(&e.candidate.genome);
                let better = |old: &(u64, Score)| match (e.score.is_feasible(), old.1.is_feasible()) {
                    (true, true) => e.score.objectives[0] < old.1.objectives[0],
                    (mine, theirs) => !theirs && (mine || e.score.violation < old.1.violation),
                };
                if best.get(&niche).is_none_or(better) {
                    best.insert(niche, (e.candidate.id, e.score.clone()));
                }
            },
            &mut |_| ControlFlow::Continue(()),
        );
        if let Some(map) = searcher.elites() {
            let ids = map.iter().map(|(niche, e)| (*niche, (e.id, e.score.clone()))).collect::<BTreeMap<_, _>>();
            assert_eq!(ids, best);
            assert!(map.iter().all(|(niche, e)| houses.niche(&e.genome) == *niche));
        }
        // Sum of what each kind is worth, from the price that no house of the toy reaches.
        let feasible = best.values().filter(|(_, s)| s.is_feasible());
        (feasible.clone().count(), feasible.map(|(_, s)| 3000.0 - s.objectives[0]).sum::<f64>())
    };
    for seed in 0..5 {
        let [map, steady, random] = ["map-elites", "steady", "random"].map(|name| reach(name, seed));
        println!("seed {seed}: kinds and worth: map-elites {map:?}, steady {steady:?}, random {random:?}");
        assert!(map.0 > steady.0 && map.1 > steady.1 && map.1 > random.1);
    }
}

/// A parent is sized for each goal at most once, and what sizing made is not sized for the same goal again.
#[test]
fn no_house_is_sized_twice_for_the_same_goal() {
    let space = space();
    let asked = std::sync::Mutex::new(Vec::new());
    let size = |house: &House, choices: &Choices, goal: usize| {
        asked.lock().expect("no panic").push((houscaper::search::identity::identity(house, choices), goal));
        let mut choices = *choices;
        choices.0[goal] = (choices.0[goal] + 1) % 4;
        Some(choices)
    };
    let houses = Houses::new(&space, None).sized_by(&size, 2);
    let settings = steady::Settings { polish: 0.3, ..Default::default() };
    let mut searcher = Steady::new(&houses, 1, settings);
    let mut sized = BTreeSet::new();
    let mut sink = |e: &houscaper::search::proposal::EvaluatedOf<Houses<'_>>| {
        if let Some(goal) = e.candidate.goal {
            assert_eq!(e.candidate.operator, Operator::POLISH);
            sized.insert((houscaper::search::identity::identity(&e.candidate.form, &e.candidate.genome.choices), goal));
        }
    };
    let limits = Limits { evaluations: 800, reference: None, stagnation: None };
    run(&mut searcher, &toy, &limits, &mut sink, &mut |_| ControlFlow::Continue(()));
    let asked = asked.into_inner().expect("no panic");
    let distinct: BTreeSet<_> = asked.iter().copied().collect();
    assert!(asked.len() > 100, "{}", asked.len());
    assert_eq!(asked.len(), distinct.len());
    assert!(sized.iter().all(|s| !distinct.contains(s)));
}

#[test]
fn a_rule_check_is_hard_and_counted() {
    let space = space();
    let no_flat_roofs = |house: &House| {
        let top = house.voxels.iter().filter(|(_, l)| l.is_filled()).map(|(v, _)| v[2]).max();
        top.is_some_and(|k| k % 6 == 0).then_some("hipped")
    };
    let houses = Houses::new(&space, Some(&no_flat_roofs));
    for name in NAMES {
        let mut searcher = searcher(name, &houses, 1);
        let mut proposed = Vec::new();
        let limits = Limits { evaluations: 120, reference: None, stagnation: None };
        run(searcher.as_mut(), &toy, &limits, &mut |e| proposed.push(e.candidate.form.clone()), &mut |_| {
            ControlFlow::Continue(())
        });
        assert!(proposed.iter().all(|h| no_flat_roofs(h).is_none()), "{name}");
        assert!(searcher.tally().rejected.iter().any(|((_, rule), n)| *rule == "hipped" && *n > 0), "{name}");
    }
}

#[test]
fn a_tiny_space_is_exhausted_without_repeats_and_a_run_can_be_stopped() {
    let space = space();
    let houses = Houses::new(&space, None);
    let reject_all = |_: &House| Some("never");
    let nothing = Houses::new(&space, Some(&reject_all));
    let limits = Limits { evaluations: 1000, reference: None, stagnation: None };
    for name in NAMES {
        let outcome = run(searcher(name, &houses, 1).as_mut(), &toy, &limits, &mut |_| {}, &mut |p| {
            if p.evaluations >= 30 { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
        });
        assert_eq!(outcome.stop, Stop::Interrupted, "{name}");
        assert!((30..=70).contains(&outcome.progress.evaluations), "{name}: {}", outcome.progress.evaluations);
        let outcome =
            run(searcher(name, &nothing, 1).as_mut(), &toy, &limits, &mut |_| {}, &mut |_| ControlFlow::Continue(()));
        assert_eq!((outcome.stop, outcome.progress.evaluations), (Stop::Exhausted, 0), "{name}");
    }
}

/// Against the definition, for two to five objectives, with many equal and many dominated points.
#[test]
fn the_archive_is_the_non_dominated_set_of_any_sequence() {
    for objectives in 2..=5 {
        let mut archive = Archive::new();
        let mut all: Vec<Vec<f64>> = Vec::new();
        let mut state = 12345u64 + objectives as u64;
        let mut next = || {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
            ((state >> 33) % 30) as f64
        };
        let mut volume = 0.0;
        for id in 0..1500 {
            let mut point: Vec<f64> = (0..objectives).map(|_| next()).collect();
            // Most lie near a common plane, so that the archive grows large; some are behind it, and now and then one in front of it.
            let excess = point.iter().sum::<f64>() / objectives as f64 - 15.0;
            let shift = [-1.0, 3.0, 3.0, 3.0].get(next() as usize).unwrap_or(&0.0);
            point.iter_mut().for_each(|v| *v = (*v - excess).round() + shift);
            archive.offer(id, &Score { objectives: point.clone(), violation: 0.0 }, || id);
            all.push(point);
            if id % 50 == 0 && objectives < 4 {
                let now = hypervolume(&archive.points(), &vec![60.0; objectives]);
                assert!(now >= volume, "hypervolume never falls");
                volume = now;
            }
        }
        let first = |p: &Vec<f64>| all.iter().position(|q| q == p);
        let expected: Vec<u64> = (0..all.len() as u64)
            .filter(|&i| {
                let p = &all[i as usize];
                all.iter().all(|q| !dominates(q, p)) && first(p) == Some(i as usize)
            })
            .collect();
        assert!(expected.len() > 5, "{objectives} objectives: {}", expected.len());
        assert_eq!(archive.len(), expected.len());
        assert_eq!(archive.iter().map(|e| e.id).collect::<Vec<_>>(), expected);
        assert!(!archive.offer(9999, &Score { objectives: vec![-99.0; objectives], violation: 0.1 }, || 9999));
        assert!(!archive.offer(9999, &Score { objectives: vec![f64::NAN; objectives], violation: 0.0 }, || 9999));
    }
}
