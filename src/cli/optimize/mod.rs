//! `houscaper optimize`: the main job.

mod chances;
mod record;
mod results;
mod summary;

use std::ops::ControlFlow;
use std::path::PathBuf;
use std::time::{Duration, Instant};

use anyhow::{Context, anyhow};
use houscaper::brief::Brief;
use houscaper::run::RunFolder;
use houscaper::score::{Evaluator, Paths, SizingGoal};
use houscaper::search::nsga2::{Nsga2, Settings};
use houscaper::search::plot::Space;
use houscaper::search::proposal::Size;
use houscaper::search::random::RandomSearch;
use houscaper::search::run::{Limits, Outcome as Found, Progress, Searcher, run as search};
use houscaper::search::{Score, from_brief};
use houscaper::voxels::lattice::{Occupancy, read_lattice};
use houscaper::voxels::{Choices, Given, House, Module, Resample, resample};

use super::args::{Method, Optimize};
use super::failure::{Blame, Failure, Outcome, bad_input};
use super::input;
use super::progress::SearchBar;
use record::Record;

/// A job: everything read and checked before anything is written.
struct Job {
    evaluator: Evaluator,
    space: Space,
    reference: Option<House>,
    args: Optimize,
    paths: Paths,
    out: PathBuf,
}

pub fn run(args: Optimize, json: bool) -> Outcome {
    if let Some(threads) = args.threads {
        if threads == 0 {
            return Err(bad_input("--threads 0: expected at least 1"));
        }
        rayon::ThreadPoolBuilder::new().num_threads(threads).build_global().run()?;
    }
    let started = Instant::now();
    let job = prepare(args)?;
    let mut record = Record::new(&job);
    let folder = RunFolder::create(&job.out, &record.run_json(&job, None)).input()?;
    eprintln!("{}: searching, results in {}", job.evaluator.brief.name, job.out.display());
    let rules = |house: &House| job.evaluator.broken_rule(house);
    let goals = SizingGoal::of_brief(&job.evaluator.brief);
    let size = |house: &House, choices: &Choices, n: u32| {
        job.evaluator.resize(house, choices, goals[n as usize % goals.len()])
    };
    let mut searcher = searcher(&job, job.args.method, &rules, &size);
    let found = explore(&job, searcher.as_mut(), &mut record, &folder)?;
    let baseline = if job.args.baseline { Some(baseline(&job, &found, &rules)) } else { None };
    record.search_seconds = found.progress.elapsed.as_secs_f64();
    let search =
        results::Search { found: &found, tally: searcher.tally(), baseline: baseline.as_ref(), record: &record };
    let written = results::write(&job, &search, &folder)?;
    record.total_seconds = started.elapsed().as_secs_f64();
    folder.write("run.json", &record.run_json(&job, Some(&found))).run()?;
    if found.archive.is_empty() {
        return Err(Failure::Run(summary::nothing_feasible(&job, &record)));
    }
    summary::print(&job, &found, &written, &record, json).run()
}

fn prepare(args: Optimize) -> Result<Job, Failure> {
    let (mut brief, folder) = input::brief(&args.brief)?;
    input::own_prices(&mut brief, args.prices.as_deref())?;
    brief.search.seed = args.seed.unwrap_or(brief.search.seed);
    brief.search.evaluations = args.evaluations.unwrap_or(brief.search.evaluations);
    if brief.search.evaluations == 0 {
        return Err(bad_input("--evaluations 0: expected at least 1"));
    }
    if args.time_limit.is_some_and(|s| s.is_nan() || s <= 0.0) {
        return Err(bad_input("--time-limit: expected a number of seconds above 0"));
    }
    let given = given(&brief, &folder)?;
    let reference = match &brief.reference {
        Some(file) => Some(input::house(&folder.join(file), &super::args::Import::default())?),
        None => None,
    };
    let out = args
        .out
        .clone()
        .unwrap_or_else(|| PathBuf::from("results").join(format!("{}-seed{}", brief.name, brief.search.seed)));
    let paths = input::paths(&brief, &folder);
    let evaluator = Evaluator::load(brief, &paths).input()?;
    let options = [0, 1, 2, 3].map(|g| evaluator.options[g].len());
    let space = from_brief::space(&evaluator.brief, given.as_ref(), &evaluator.rules, options).input()?;
    // A start shows that plot, programme and given cells go together before a folder is made.
    let mut rng: rand_chacha::ChaCha8Rng = rand::SeedableRng::seed_from_u64(evaluator.brief.search.seed);
    houscaper::search::start::start(&space, &mut rng).input()?;
    Ok(Job { evaluator, space, reference, args, paths, out })
}

/// The given voxels of a brief, with the change of scale told.
fn given(brief: &Brief, folder: &std::path::Path) -> Result<Option<Given>, Failure> {
    let Some(wanted) = &brief.given else { return Ok(None) };
    let path = folder.join(&wanted.lattice);
    let lattice = read_lattice(&input::bytes(&path)?, &path.display().to_string()).input()?;
    let occupancy: Occupancy = wanted.occupied.parse().context("given.occupied").input()?;
    let offset = wanted.offset.map(|o| usize::try_from(o).ok());
    let [Some(x), Some(y), Some(z)] = offset else {
        return Err(bad_input(format!("`given.offset` is {:?}: expected modules of at least 0", wanted.offset)));
    };
    let how = Resample {
        cell_modules: wanted.cell_modules,
        offset: [x, y, z],
        ground: wanted.ground,
        crop: wanted.crop.map(|[first, last]| [first, last.map(|l| l + 1)]),
    };
    let given = resample(&lattice, &occupancy, &Module::default(), &how).context("given").input()?;
    let r = &given.report;
    eprintln!(
        "given: {} cells of {}, each {:?} modules; scale x {:.3}, y {:.3}, z {:.3} of the lattice",
        r.cells, wanted.lattice, r.cell_modules, r.scale[0], r.scale[1], r.scale[2]
    );
    Ok(Some(given))
}

type Rules<'a> = dyn Fn(&House) -> Option<&'static str> + Sync + 'a;

fn searcher<'a>(job: &'a Job, method: Method, rules: &'a Rules<'a>, size: &'a Size<'a>) -> Box<dyn Searcher + 'a> {
    let settings = &job.evaluator.brief.search;
    let population = settings.population;
    match method {
        Method::Nsga2 => {
            let nsga2 = Settings { population, offspring: population, sizing: settings.sizing, ..Settings::default() };
            Box::new(Nsga2::new(&job.space, settings.seed, nsga2, Some(rules)).sized_by(size))
        }
        Method::Random => Box::new(RandomSearch::new(&job.space, settings.seed, population, Some(rules))),
    }
}

fn score(job: &Job, house: &House, choices: &Choices) -> Score {
    let evaluation = job.evaluator.evaluate(house, choices);
    Score { objectives: evaluation.minimised(&job.evaluator.brief.objectives), violation: evaluation.violation }
}

fn explore(job: &Job, searcher: &mut dyn Searcher, record: &mut Record, folder: &RunFolder) -> Result<Found, Failure> {
    let planned = job.evaluator.brief.search.evaluations as u64;
    let bar = SearchBar::new(planned);
    let limit = job.args.time_limit.map(Duration::from_secs_f64);
    let mut trouble = None;
    let flushed = std::cell::Cell::new(Instant::now());
    let cell = std::cell::RefCell::new(record);
    let found = search(
        searcher,
        &|house, choices| score(job, house, choices),
        &Limits { evaluations: planned, reference: None },
        &mut |one| cell.borrow_mut().add(job, one),
        &mut |progress: &Progress| {
            bar.update(progress.evaluations, progress.front, progress.relative_hypervolume());
            cell.borrow_mut().close_batch(progress.elapsed);
            if flushed.get().elapsed() > Duration::from_secs(5) {
                flushed.set(Instant::now());
                if let Err(error) = folder.write("evaluations.csv", cell.borrow().evaluations_csv(job).as_bytes()) {
                    trouble = Some(error);
                    return ControlFlow::Break(());
                }
            }
            match limit {
                Some(limit) if progress.elapsed >= limit => ControlFlow::Break(()),
                _ => ControlFlow::Continue(()),
            }
        },
    );
    bar.finish();
    match trouble {
        Some(error) => Err(Failure::Run(anyhow!(error))),
        None => Ok(found),
    }
}

/// A random search with the same moves, evaluations and reference point: its hypervolume over evaluations.
fn baseline(job: &Job, found: &Found, rules: &Rules) -> Vec<(u64, f64)> {
    eprintln!("random baseline with the same moves");
    let planned = found.progress.evaluations;
    let bar = SearchBar::new(planned);
    let mut searcher = searcher(job, Method::Random, rules, &|_, _, _| None);
    let limits = Limits { evaluations: planned, reference: found.reference.clone() };
    let outcome = search(
        searcher.as_mut(),
        &|house, choices| score(job, house, choices),
        &limits,
        &mut |_| (),
        &mut |progress| {
            let relative = progress.hypervolume.zip(found.progress.box_volume).map(|(h, b)| h / b);
            bar.update(progress.evaluations, progress.front, relative);
            ControlFlow::Continue(())
        },
    );
    bar.finish();
    outcome.history
}
