//! How far the searches get in as many evaluations: a row per algorithm and brief, with the statistics against the first one.
//!
//! `cargo bench --bench quality -- --briefs starter,go-design --algorithms steady,nsga2 --seeds 10 --evaluations 3000`. An algorithm may
//! carry settings: `steady:batch=16:floor=0.2`. With `--logs DIR` each run leaves a log that other programs can compare. Hypervolumes are
//! of archives, up to a reference a tenth of the range beyond the worst of all runs' common front, relative to that front's.

use std::ops::ControlFlow;
use std::path::PathBuf;
use std::time::Instant;

use houscaper::brief::{Brief, read_brief};
use houscaper::score::{Evaluator, Paths, SizingGoal};
use houscaper::search::archive::Archive;
use houscaper::search::evolution::{self, Evolution};
use houscaper::search::hill::HillClimber;
use houscaper::search::houses::Houses;
use houscaper::search::hypervolume::{hypervolume, reference_point};
use houscaper::search::random::RandomSearch;
use houscaper::search::run::{Limits, Searcher, run};
use houscaper::search::steady::{self, Steady};
use houscaper::search::{Score, from_brief};
use houscaper::voxels::lattice::read_lattice;
use houscaper::voxels::{Choices, Given, House, Module, Resample, resample};

/// One run: feasible objective vectors in order, with the number of the evaluation.
struct Run {
    found: Vec<(u64, Vec<f64>)>,
    evaluations: u64,
    feasible: u64,
    front: usize,
    seconds: f64,
}

fn argument(name: &str, default: &str) -> String {
    let args: Vec<String> = std::env::args().collect();
    args.iter().position(|a| a == name).and_then(|i| args.get(i + 1)).map_or(default.to_owned(), String::clone)
}

fn main() {
    let seeds: u64 = argument("--seeds", "3").parse().expect("--seeds N");
    let evaluations: u64 = argument("--evaluations", "3000").parse().expect("--evaluations N");
    let algorithms = argument("--algorithms", "steady,nsga2");
    let logs = argument("--logs", "");
    for name in argument("--briefs", "starter").split(',') {
        let job = Job::load(name);
        let runs: Vec<(&str, Vec<Run>)> = algorithms
            .split(',')
            .map(|spec| (spec, (1..=seeds).map(|seed| job.run(spec, seed, evaluations)).collect()))
            .collect();
        if !logs.is_empty() {
            write_logs(&logs, name, &runs);
        }
        report(name, &runs, evaluations);
    }
}

struct Job {
    evaluator: Evaluator,
    given: Option<Given>,
}

impl Job {
    fn load(name: &str) -> Job {
        let home = PathBuf::from(env!("CARGO_MANIFEST_DIR"));
        let configs = home.join("configs");
        let text = std::fs::read(configs.join(format!("{name}.json"))).expect("a shipped brief");
        let brief: Brief = read_brief(&text, name).expect("a brief");
        let given = brief.given.as_ref().map(|wanted| {
            let bytes = std::fs::read(configs.join(&wanted.lattice)).expect("the lattice");
            let lattice = read_lattice(&bytes, &wanted.lattice).expect("a lattice");
            let how = Resample {
                cell_modules: wanted.cell_modules,
                offset: wanted.offset.map(|o| o as usize),
                ground: wanted.ground,
                crop: wanted.crop.map(|[first, last]| [first, last.map(|l| l + 1)]),
            };
            let occupancy = wanted.occupied.parse().expect("a rule");
            resample(&lattice, &occupancy, &Module::default(), &how).expect("given cells")
        });
        let paths = Paths {
            tileset: home.join("tilesets").join(&brief.tileset),
            linear: home.join("tilesets").join(&brief.linear),
            brief: configs.clone(),
            configs,
        };
        Job { evaluator: Evaluator::load(brief, &paths).expect("its books"), given }
    }

    fn run(&self, spec: &str, seed: u64, evaluations: u64) -> Run {
        let evaluator = &self.evaluator;
        let options = [0, 1, 2, 3].map(|g| evaluator.options[g].len());
        let space =
            from_brief::space(&evaluator.brief, self.given.as_ref(), &evaluator.rules, options).expect("a space");
        let rules = |house: &House| evaluator.broken_rule(house);
        let goals = SizingGoal::of_brief(&evaluator.brief);
        let size = |house: &House, choices: &Choices, goal: usize| evaluator.resize(house, choices, goals[goal]);
        let screen = |house: &House, choices: &Choices, beaten: &dyn Fn(&[f64]) -> bool| {
            evaluator.is_beaten(house, choices, beaten)
        };
        let houses = Houses::new(&space, Some(&rules)).sized_by(&size, goals.len()).screened_by(&screen);
        let mut searcher = searcher(&houses, spec, seed, evaluator.brief.objectives.len());
        let mut out = Run { found: Vec::new(), evaluations, feasible: 0, front: 0, seconds: 0.0 };
        let started = Instant::now();
        let score = |design: &houscaper::search::massing::Design, house: &House| {
            let evaluation = evaluator.evaluate(house, &design.choices);
            let objectives = evaluation.minimised(&evaluator.brief.objectives);
            Score { objectives, violation: evaluation.violation }
        };
        let outcome = run(
            searcher.as_mut(),
            &score,
            &Limits { evaluations, reference: None, stagnation: None },
            &mut |e| {
                if e.score.is_feasible() {
                    out.found.push((e.candidate.id + 1, e.score.objectives.clone()));
                }
            },
            &mut |_| ControlFlow::Continue(()),
        );
        out.seconds = started.elapsed().as_secs_f64();
        (out.feasible, out.front) = (outcome.progress.feasible, outcome.progress.front);
        if std::env::args().any(|a| a == "--verbose") {
            println!("{spec} seed {seed}: {:?}", searcher.tally());
        }
        out
    }
}

fn searcher<'a>(
    houses: &'a Houses<'a>,
    spec: &str,
    seed: u64,
    objectives: usize,
) -> Box<dyn Searcher<Houses<'a>> + 'a> {
    let mut parts = spec.split(':');
    let name = parts.next().unwrap_or_default();
    let mut generational = evolution::Settings::default();
    let mut steady = steady::Settings::default();
    for part in parts {
        let (key, value) = part.split_once('=').expect("key=value");
        let number: f64 = value.parse().expect("a number");
        match key {
            "batch" => steady.batch = number as usize,
            "pool" => steady.pool = number as usize,
            "starts" => steady.starts = number as usize,
            "grafts" => steady.grafts = number,
            "immigrants" => steady.immigrants = number,
            "polish" => (steady.polish, generational.polish) = (number, number),
            "hopeful" => steady.hopeful = number,
            "local" => steady.local = number,
            "floor" => steady.floor = number,
            "rate" => steady.rate = number,
            "screen" => steady.screen = number > 0.0,
            "patience" => steady.patience = number as u64,
            "population" => (generational.population, generational.offspring) = (number as usize, number as usize),
            _ => panic!("no setting {key}"),
        }
    }
    match name {
        "steady" => Box::new(Steady::new(houses, seed, steady)),
        "nsga2" => Box::new(Evolution::nsga2(houses, seed, generational)),
        "nsga3" => Box::new(Evolution::nsga3(houses, seed, objectives, generational)),
        "random" => Box::new(RandomSearch::new(houses, seed, generational.population)),
        "hill" => Box::new(HillClimber::new(houses, seed, objectives, 20)),
        _ => panic!("no algorithm {name}"),
    }
}

fn front<'p>(points: impl Iterator<Item = &'p Vec<f64>>) -> Vec<Vec<f64>> {
    let mut archive = Archive::new();
    for (id, point) in points.enumerate() {
        archive.offer(id as u64, &Score { objectives: point.clone(), violation: 0.0 }, || ());
    }
    archive.points().into_iter().map(<[f64]>::to_vec).collect()
}

fn volume(points: &[Vec<f64>], reference: &[f64]) -> f64 {
    hypervolume(&points.iter().map(Vec::as_slice).collect::<Vec<_>>(), reference)
}

fn report(name: &str, runs: &[(&str, Vec<Run>)], evaluations: u64) {
    let union = front(runs.iter().flat_map(|r| &r.1).flat_map(|r| r.found.iter().map(|f| &f.1)));
    let Some(reference) = reference_point(union.iter().map(Vec::as_slice)) else {
        return println!("{name}: nothing feasible");
    };
    let whole = volume(&union, &reference);
    let shares = |until: u64| -> Vec<Vec<f64>> {
        let of = |r: &Run| volume(&front(r.found.iter().filter(|f| f.0 <= until).map(|f| &f.1)), &reference) / whole;
        runs.iter().map(|(_, all)| all.iter().map(of).collect()).collect()
    };
    println!("{name}: common front of {} points", union.len());
    for until in [evaluations / 3, evaluations] {
        let all = shares(until);
        for ((spec, runs), values) in runs.iter().zip(&all) {
            let (p, a12) = compare(&all[0], values);
            let mean = |of: &dyn Fn(&Run) -> f64| runs.iter().map(of).sum::<f64>() / runs.len() as f64;
            println!(
                "  {until:6} {spec:40} median {:.4} [{:.4} {:.4}]  A12 {a12:.2} p {p:.2e}  {:.1} s  {:.0} % feasible  front {:.0}",
                quantile(values, 0.5),
                quantile(values, 0.25),
                quantile(values, 0.75),
                mean(&|r| r.seconds),
                100.0 * mean(&|r| r.feasible as f64 / r.evaluations as f64),
                mean(&|r| r.front as f64),
            );
        }
    }
}

fn quantile(values: &[f64], q: f64) -> f64 {
    let mut sorted = values.to_vec();
    sorted.sort_by(f64::total_cmp);
    let at = q * (sorted.len() - 1) as f64;
    let (low, high) = (at.floor() as usize, at.ceil() as usize);
    sorted[low] + (at - low as f64) * (sorted[high] - sorted[low])
}

/// Two-sided p of Mann and Whitney (normal approximation with continuity and ties), and A12: the chance that `a` is the larger.
fn compare(a: &[f64], b: &[f64]) -> (f64, f64) {
    let wins: f64 = a
        .iter()
        .flat_map(|x| {
            b.iter().map(move |y| {
                if x > y {
                    1.0
                } else if x == y {
                    0.5
                } else {
                    0.0
                }
            })
        })
        .sum();
    let (n, m) = (a.len() as f64, b.len() as f64);
    let mut all: Vec<f64> = a.iter().chain(b).copied().collect();
    all.sort_by(f64::total_cmp);
    let ties: f64 = all.chunk_by(|x, y| x == y).map(|c| (c.len() as f64).powi(3) - c.len() as f64).sum();
    let total = n + m;
    let variance = n * m / 12.0 * (total + 1.0 - ties / (total * (total - 1.0)));
    let z = ((wins - n * m / 2.0).abs() - 0.5).max(0.0) / variance.sqrt().max(1e-12);
    (erfc(z / std::f64::consts::SQRT_2).min(1.0), wins / (n * m))
}

/// Complementary error function (Numerical Recipes' Chebyshev fit, relative error below 1.2e-7).
fn erfc(x: f64) -> f64 {
    let t = 1.0 / (1.0 + 0.5 * x);
    let terms = [
        -1.265_512_23,
        1.000_023_68,
        0.374_091_96,
        0.096_784_18,
        -0.186_288_06,
        0.278_868_07,
        -1.135_203_98,
        1.488_515_87,
        -0.822_152_23,
        0.170_872_77,
    ];
    let poly = terms.iter().rev().fold(0.0, |sum, c| sum * t + c);
    t * (-x * x + poly).exp()
}

fn write_logs(folder: &str, brief: &str, runs: &[(&str, Vec<Run>)]) {
    std::fs::create_dir_all(folder).expect("a folder");
    for (spec, runs) in runs {
        for (seed, run) in runs.iter().enumerate() {
            let mut blocks = Vec::new();
            let step = 100;
            for end in (step..=run.evaluations).step_by(step as usize) {
                let found: Vec<&Vec<f64>> =
                    run.found.iter().filter(|f| f.0 > end - step && f.0 <= end).map(|f| &f.1).collect();
                let t = run.seconds * end as f64 / run.evaluations as f64;
                blocks.push(serde_json::json!({"evals": end, "t": t, "f": found}));
            }
            let path = format!("{folder}/{brief}_{}_{}.json", spec.replace([':', '='], "-"), seed + 1);
            std::fs::write(path, serde_json::json!({"log": blocks}).to_string()).expect("a file");
        }
    }
}
