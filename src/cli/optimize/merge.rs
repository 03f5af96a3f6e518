//! `houscaper merge`: one archive of all evaluations of several runs of a brief.
//!
//! Nothing is evaluated: each run's checkpoint is told to its searcher again, and what comes out goes through one ledger, run after run.
//! Ids go on from run to run, so that id minus the evaluations of the runs before is the id in its own run. A folder that was merged itself
//! stands for the runs it was merged from, each counted once: merging in steps or at once gives the same bytes.

use std::collections::BTreeSet;
use std::ops::ControlFlow;
use std::path::PathBuf;
use std::time::Duration;

use houscaper::run::{Frames, RunFolder};
use houscaper::score::SizingGoal;
use houscaper::search::from_brief;
use houscaper::search::houses::Houses;
use houscaper::search::proposal::Tally;
use houscaper::search::run::{Ledger, Limits, Stop, run_scored};
use houscaper::voxels::{Choices, House};
use serde_json::json;

use super::checkpoint::{self, Resumed};
use super::labour::Here;
use super::record::{Record, hashes};
use super::{Job, log, results, resume, summary};
use crate::cli::args::{Merge, Resume};
use crate::cli::failure::{self, Blame, Failure, bad_input};

/// Merged folders of merged folders at most: more is a circle.
const DEEPEST: usize = 16;

pub fn run(args: Merge, json: bool) -> failure::Outcome {
    let as_it_is = |run| Resume {
        run,
        evaluations: None,
        time_limit: None,
        threads: None,
        ifc: false,
        queue: None,
        per_question: 1,
    };
    let paths = runs_of(&args.runs)?;
    let mut runs = Vec::new();
    for run in &paths {
        let (job, folder, _) = resume::reopen(run, &as_it_is(run.clone()))?;
        runs.push((job, folder));
    }
    let Some(((first, _), others)) = runs.split_first() else { return Ok(()) };
    for ((job, _), run) in others.iter().zip(&paths[1..]) {
        if asked(job) != asked(first) || hashes(job) != hashes(first) {
            return Err(bad_input(format!(
                "{}: is a run of another brief, or with other books, than {}: expected runs that differ in their search settings only",
                run.display(),
                paths[0].display()
            )));
        }
    }
    let (mut job, ..) = resume::reopen(&paths[0], &as_it_is(paths[0].clone()))?;
    job.out.clone_from(&args.out);
    job.args.tables_only = args.tables_only;
    job.args.ifc = args.ifc;
    let seen = |run: &PathBuf| resume::seen_from(&args.out, run);
    job.origin = json!({"merged": paths.iter().map(seen).collect::<Vec<_>>()});
    let folder = RunFolder::create(&job.out, &Record::run_json(&job, None)).input()?;
    write(&job, &runs, &folder, json)
}

/// Folders of runs, with those in place of a merged one that it was merged from; each run once, at its first place.
fn runs_of(folders: &[PathBuf]) -> Result<Vec<PathBuf>, Failure> {
    let mut open: Vec<(PathBuf, usize)> = folders.iter().rev().map(|f| (f.clone(), 0)).collect();
    let (mut runs, mut seen) = (Vec::new(), BTreeSet::new());
    while let Some((run, depth)) = open.pop() {
        let mark = RunFolder::open(&run).input()?.read("run.json").run()?.unwrap_or_default();
        let mark: serde_json::Value = serde_json::from_slice(&mark).unwrap_or_default();
        let Some(merged) = mark["resume"]["merged"].as_array() else {
            let real = run.canonicalize().unwrap_or_else(|_| run.clone());
            match seen.insert(real) {
                true => runs.push(run),
                false => eprintln!("{}: is there twice; counted once", run.display()),
            }
            continue;
        };
        let own: Vec<PathBuf> = merged.iter().filter_map(|path| Some(run.join(path.as_str()?))).collect();
        if let Some(gone) = own.iter().find(|path| !path.join("run.json").is_file()) {
            return Err(bad_input(format!(
                "{}: is merged from {}, which is not there: a merged folder names its runs and needs their checkpoints; bring it back or merge the runs that are left",
                run.display(),
                gone.display()
            )));
        }
        if depth == DEEPEST {
            return Err(bad_input(format!("{}: is merged of merged folders in a circle", run.display())));
        }
        open.extend(own.into_iter().rev().map(|path| (path, depth + 1)));
    }
    Ok(runs)
}

/// The brief without its search settings, which runs that are put together need not share.
fn asked(job: &Job) -> serde_json::Value {
    let mut brief = serde_json::to_value(&job.evaluator.brief).unwrap_or_default();
    brief["search"] = serde_json::Value::Null;
    brief
}

fn write(job: &Job, runs: &[(Job, RunFolder)], folder: &RunFolder, json: bool) -> failure::Outcome {
    let mut record = Record::begin(job, folder).run()?;
    let mut ledger = Ledger::new(&Limits::default());
    let mut tally = Tally::default();
    for (one, from) in runs {
        tally.merge(&tell(one, from, &mut record, &mut ledger)?);
    }
    let found = ledger.finish(Stop::Done, Duration::ZERO);
    record.finish().run()?;
    let folders: Vec<&RunFolder> = runs.iter().map(|r| &r.1).collect();
    log::write(&folders, folder).run()?;
    record.screened = tally.screened.values().sum();
    let search = results::Search { found: &found, tally: &tally, baseline: None, record: &record };
    let written = results::write(job, &search, folder)?;
    folder.write("run.json", &Record::run_json(job, Some((&record, &found)))).run()?;
    summary::write(job, &found, &written, folder)?;
    if found.archive.is_empty() {
        return Err(Failure::Run(summary::nothing_feasible(job, &record, &written)));
    }
    crate::cli::report::write(folder)?;
    summary::print(job, &found, &written, &record, json).run()
}

/// Tells a run's checkpoint to its searcher again; every evaluation goes to the record and the ledger.
fn tell(
    job: &Job,
    folder: &RunFolder,
    record: &mut Record,
    ledger: &mut Ledger<houscaper::search::massing::Design>,
) -> Result<Tally, Failure> {
    let known = checkpoint::open(folder).run()?;
    let rules = |house: &House| job.evaluator.broken_rule(house);
    let goals = SizingGoal::of_brief(&job.evaluator.brief);
    let size = |house: &House, choices: &Choices, goal: usize| {
        known.sizings.get(house, choices, goal, || job.evaluator.resize(house, choices, goals[goal]))
    };
    let screen = |house: &House, choices: &Choices, beaten: &dyn Fn(&[f64]) -> bool| {
        let keeps_rules = || job.evaluator.broken_rule(house).is_none();
        known.sizings.is_beaten(house, choices, keeps_rules, || job.evaluator.is_beaten(house, choices, beaten))
    };
    let houses = Houses::new(&job.space, Some(&rules)).sized_by(&size, goals.len()).screened_by(&screen);
    let mut searcher = from_brief::searcher(&houses, &job.evaluator.brief);
    let told = Frames::read(folder, checkpoint::FILE).run()?;
    let labour = Here(job);
    let mut scorer = Resumed::new(told, None, &known.sizings, &labour, Duration::ZERO);
    let limits = Limits { evaluations: known.evaluations, ..Limits::default() };
    let (record, ledger) = (std::cell::RefCell::new(record), std::cell::RefCell::new(ledger));
    let mut trouble = None;
    run_scored(
        searcher.as_mut(),
        &mut scorer,
        &limits,
        &mut |one| {
            let mut record = record.borrow_mut();
            ledger.borrow_mut().commit(record.count(), &one.candidate.genome, &one.score);
            record.add(job, one);
        },
        &mut |_| {
            ledger.borrow_mut().measure(Duration::ZERO);
            match record.borrow_mut().close_batch() {
                Ok(()) => ControlFlow::Continue(()),
                Err(error) => {
                    trouble = Some(error);
                    ControlFlow::Break(())
                }
            }
        },
    );
    match (scorer.trouble.take(), trouble) {
        (Some(error), _) => Err(Failure::Run(error)),
        (None, Some(error)) => Err(Failure::Run(error.into())),
        (None, None) => Ok(searcher.tally().clone()),
    }
}
