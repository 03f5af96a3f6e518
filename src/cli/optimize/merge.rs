//! `houscaper merge`: one archive of all evaluations of several runs of a brief.
//!
//! Nothing is evaluated: each run's checkpoint is told to its searcher again, and what comes out goes through one ledger, run after run.
//! Ids go on from run to run, so that id minus the evaluations of the runs before is the id in its own run.

use std::ops::ControlFlow;
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
use super::record::{Record, hashes};
use super::{Job, log, results, resume, score, summary};
use crate::cli::args::{Merge, Resume};
use crate::cli::failure::{self, Blame, Failure, bad_input};

pub fn run(args: Merge, json: bool) -> failure::Outcome {
    let as_it_is = |run| Resume { run, evaluations: None, time_limit: None, threads: None };
    let mut runs = Vec::new();
    for run in &args.runs {
        let (job, folder, _) = resume::reopen(run, &as_it_is(run.clone()))?;
        runs.push((job, folder));
    }
    let Some(((first, _), others)) = runs.split_first() else { return Ok(()) };
    for ((job, _), run) in others.iter().zip(&args.runs[1..]) {
        if asked(job) != asked(first) || hashes(job) != hashes(first) {
            return Err(bad_input(format!(
                "{}: is a run of another brief, or with other books, than {}: expected runs that differ in their search settings only",
                run.display(),
                args.runs[0].display()
            )));
        }
    }
    let (mut job, ..) = resume::reopen(&args.runs[0], &as_it_is(args.runs[0].clone()))?;
    job.out.clone_from(&args.out);
    job.args.tables_only = args.tables_only;
    job.origin = json!({"merged": args.runs});
    let folder = RunFolder::create(&job.out, &Record::run_json(&job, None)).input()?;
    write(&job, &runs, &folder, json)
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
    let search = results::Search { found: &found, tally: &tally, baseline: None, record: &record };
    let written = results::write(job, &search, folder)?;
    folder.write("run.json", &Record::run_json(job, Some((&record, &found)))).run()?;
    if found.archive.is_empty() {
        return Err(Failure::Run(summary::nothing_feasible(job, &record, &written)));
    }
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
    let houses = Houses::new(&job.space, Some(&rules)).sized_by(&size, goals.len());
    let mut searcher = from_brief::searcher(&houses, &job.evaluator.brief);
    let told = Frames::read(folder, checkpoint::FILE).run()?;
    let evaluate = |house: &House, choices: &Choices| score(job, house, choices);
    let mut scorer = Resumed::new(told, None, &known.sizings, &evaluate, Duration::ZERO);
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
