//! `houscaper optimize`: the main job.

mod breakdowns;
mod chances;
mod checkpoint;
mod drawings;
mod even;
mod faults;
mod labour;
mod log;
mod looks;
mod map;
pub mod merge;
mod moves;
mod record;
mod results;
pub mod resume;
mod sensitivity;
mod stop;
mod summary;
mod whynot;

use std::ops::ControlFlow;
use std::path::PathBuf;
use std::time::{Duration, Instant};

use anyhow::{Context, anyhow};
use houscaper::brief::{Algorithm, read_brief};
use houscaper::export::given::{Page, given_html};
use houscaper::run::queue::score;
use houscaper::run::{Frames, RunFolder};
use houscaper::score::{Evaluator, Paths, SizingGoal};
use houscaper::search::from_brief;
use houscaper::search::houses::Houses;
use houscaper::search::massing::Design;
use houscaper::search::plot::Space;
use houscaper::search::random::RandomSearch;
use houscaper::search::run::{Limits, Outcome, Progress, Searcher, run as search, run_scored};
use houscaper::voxels::{Choices, House};

use super::args::Optimize;
use super::failure::{self, Blame, Failure, bad_input};
use super::input;
use super::input::site::Site;
use super::progress::SearchBar;
use checkpoint::Resumed;
use labour::Labour;
use record::Record;

/// A job: everything read and checked before anything is written.
struct Job {
    evaluator: Evaluator,
    space: Space,
    site: Site,
    reference: Option<House>,
    args: Optimize,
    paths: Paths,
    out: PathBuf,
    /// What `resume` needs to read the same job again.
    origin: serde_json::Value,
}

/// What a search of houses ends with.
type Found = Outcome<Design>;

pub fn run(args: Optimize, json: bool) -> failure::Outcome {
    use_threads(args.threads)?;
    let text = input::bytes(&args.brief)?;
    let job = prepare(args, text)?;
    let labour = labour::of(&job)?;
    let folder = RunFolder::create(&job.out, &Record::run_json(&job, None)).input()?;
    eprintln!("{}: searching, results in {}", job.evaluator.brief.name, job.out.display());
    execute(&job, &folder, labour, json)
}

pub(super) fn use_threads(threads: Option<usize>) -> failure::Outcome {
    match threads {
        Some(0) => Err(bad_input("--threads 0: expected at least 1")),
        Some(threads) => rayon::ThreadPoolBuilder::new().num_threads(threads).build_global().run(),
        None => Ok(()),
    }
}

/// Searches from where the folder's checkpoint ends, and writes the results.
fn execute(job: &Job, folder: &RunFolder, labour: Box<dyn Labour + '_>, json: bool) -> failure::Outcome {
    let started = Instant::now();
    stop::watch();
    let known = checkpoint::open(folder).run()?;
    let planned = job.evaluator.brief.search.evaluations as u64;
    if known.evaluations > planned {
        return Err(bad_input(format!("--evaluations {planned}: the run already has {}", known.evaluations)));
    }
    let mut record = Record::begin(job, folder).run()?;
    let rules = |house: &House| job.evaluator.broken_rule(house);
    let goals = SizingGoal::of_brief(&job.evaluator.brief);
    let sizings = &known.sizings;
    let size = |house: &House, choices: &Choices, goal: usize| {
        sizings.get(house, choices, goal, || job.evaluator.resize(house, choices, goals[goal]))
    };
    let screen = |house: &House, choices: &Choices, beaten: &dyn Fn(&[f64]) -> bool| {
        let keeps_rules = || job.evaluator.broken_rule(house).is_none();
        sizings.is_beaten(house, choices, keeps_rules, || job.evaluator.is_beaten(house, choices, beaten))
    };
    let houses = Houses::new(&job.space, Some(&rules)).sized_by(&size, goals.len()).screened_by(&screen);
    let mut searcher = from_brief::searcher(&houses, &job.evaluator.brief);
    let told = if known.evaluations > 0 { Frames::read(folder, checkpoint::FILE).run()? } else { None };
    let mut scorer = Resumed::new(told, Some(known.journal), sizings, labour.as_ref(), known.elapsed);
    let found = explore(job, searcher.as_mut(), &mut scorer, known.evaluations, &mut record)?;
    drop(scorer);
    labour.report();
    drop(labour);
    let baseline = if job.args.baseline { Some(baseline(job, &found, &rules)) } else { None };
    record.finish().run()?;
    record.screened = searcher.tally().screened.values().sum();
    record.search_seconds = found.progress.elapsed.as_secs_f64();
    log::write(&[folder], folder).run()?;
    let search =
        results::Search { found: &found, tally: searcher.tally(), baseline: baseline.as_ref(), record: &record };
    let written = results::write(job, &search, folder)?;
    if let Some(page) = given_page(job, &written) {
        folder.write("given.html", page.as_bytes()).run()?;
    }
    if let Some(elites) = searcher.elites() {
        map::write(job, elites, folder)?;
    }
    record.total_seconds = started.elapsed().as_secs_f64();
    folder.write("run.json", &Record::run_json(job, Some((&record, &found)))).run()?;
    summary::write(job, &found, &written, folder)?;
    if found.archive.is_empty() {
        return Err(Failure::Run(summary::nothing_feasible(job, &record, &written)));
    }
    super::report::write(folder)?;
    summary::print(job, &found, &written, &record, json).run()
}

/// The page about the given cells and what the named houses make of them; `None` where nothing is given.
fn given_page(job: &Job, written: &results::Written) -> Option<String> {
    let given = job.site.given.as_ref()?;
    let shown = |n: &houscaper::search::select::Named| {
        let house = &written.front[n.index];
        (house.id, n.name.clone(), &house.house)
    };
    let houses = written.named.iter().map(shown).collect();
    Some(given_html(&Page { brief: &job.evaluator.brief, lattice: &given.lattice, given: &given.given, houses }))
}

/// Reads everything that a brief names; `text` is the brief itself.
fn prepare(args: Optimize, text: Vec<u8>) -> Result<Job, Failure> {
    let file = std::path::absolute(&args.brief).with_context(|| args.brief.display().to_string()).input()?;
    let mut brief = read_brief(&text, &args.brief.display().to_string()).input()?;
    let folder = args.brief.parent().map_or_else(PathBuf::new, std::path::Path::to_path_buf);
    input::own_prices(&mut brief, args.prices.as_deref())?;
    brief.search.seed = args.seed.unwrap_or(brief.search.seed);
    brief.search.evaluations = args.evaluations.unwrap_or(brief.search.evaluations);
    brief.search.algorithm = args.method.map_or(brief.search.algorithm, Algorithm::from);
    brief.search.stagnation = args.stagnation.or(brief.search.stagnation);
    let out = args
        .out
        .clone()
        .unwrap_or_else(|| PathBuf::from("results").join(format!("{}-seed{}", brief.name, brief.search.seed)));
    let origin = resume::origin(&args, [&file, &out], &text, &brief);
    if brief.search.evaluations == 0 {
        return Err(bad_input("--evaluations 0: expected at least 1"));
    }
    if args.time_limit.is_some_and(|s| s.is_nan() || s <= 0.0) {
        return Err(bad_input("--time-limit: expected a number of seconds above 0"));
    }
    let site = Site::read(&brief, &folder, &|text| eprintln!("{text}"))?;
    let reference = match &brief.reference {
        Some(file) => Some(input::house(&folder.join(file), &super::args::Import::default())?),
        None => None,
    };
    let paths = input::paths(&brief, &folder);
    let evaluator = Evaluator::load(brief, &paths).input()?;
    let space = site.space(&evaluator)?;
    // A start shows that plot, programme and given cells go together before a folder is made.
    let mut rng: rand_chacha::ChaCha8Rng = rand::SeedableRng::seed_from_u64(evaluator.brief.search.seed);
    houscaper::search::start::start(&space, &mut rng).input()?;
    Ok(Job { evaluator, space, site, reference, args, paths, out, origin })
}

type Rules<'a> = dyn Fn(&House) -> Option<&'static str> + Sync + 'a;

fn explore<'h>(
    job: &Job,
    searcher: &mut (dyn Searcher<Houses<'h>> + '_),
    scorer: &mut Resumed,
    known: u64,
    record: &mut Record,
) -> Result<Found, Failure> {
    let search = &job.evaluator.brief.search;
    let planned = search.evaluations as u64;
    let bar = SearchBar::new(planned);
    let limit = job.args.time_limit.map(Duration::from_secs_f64);
    let limits = Limits { evaluations: planned, reference: None, stagnation: search.stagnation };
    let mut trouble = None;
    let cell = std::cell::RefCell::new(record);
    let mut found = run_scored(
        searcher,
        scorer,
        &limits,
        &mut |one| cell.borrow_mut().add(job, one),
        &mut |progress: &Progress| {
            bar.update(progress.evaluations, progress.front, progress.relative_hypervolume());
            let mut record = cell.borrow_mut();
            // While a run is resumed the older table stands: it is longer.
            let shown = record.close_batch().and_then(|()| match progress.evaluations < known {
                true => Ok(()),
                false => record.publish(),
            });
            if let Err(error) = shown {
                trouble = Some(error);
                return ControlFlow::Break(());
            }
            let late = limit.is_some_and(|limit| progress.elapsed >= limit);
            if stop::asked() || late { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
        },
    );
    bar.finish();
    found.progress.elapsed = scorer.elapsed;
    match (scorer.trouble.take(), trouble) {
        (Some(error), _) => Err(Failure::Run(error)),
        (None, Some(error)) => Err(Failure::Run(anyhow!(error))),
        (None, None) => Ok(found),
    }
}

/// A random search with the same moves, evaluations and reference point: its hypervolume over evaluations.
fn baseline(job: &Job, found: &Found, rules: &Rules) -> Vec<(u64, f64)> {
    eprintln!("random baseline with the same moves");
    let planned = found.progress.evaluations;
    let bar = SearchBar::new(planned);
    let houses = Houses::new(&job.space, Some(rules));
    let settings = &job.evaluator.brief.search;
    let mut searcher = RandomSearch::new(&houses, settings.seed, settings.population.unwrap_or(100));
    let limits = Limits { evaluations: planned, reference: found.reference.clone(), stagnation: None };
    let outcome = search(
        &mut searcher,
        &|design, house| score(&job.evaluator, house, &design.choices),
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
