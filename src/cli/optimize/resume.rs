//! `houscaper resume`: a run carried on where it stopped.

use std::path::{Path, PathBuf};

use anyhow::Context;
use houscaper::brief::Brief;
use houscaper::run::RunFolder;
use serde::{Deserialize, Serialize};

use super::record::{Record, hashes};
use super::{Job, execute, prepare, use_threads};
use crate::cli::args::{Method, Optimize, Resume};
use crate::cli::failure::{self, Blame, Failure, bad_input};

/// How a run was begun: kept in its `run.json`.
#[derive(Clone, Debug, Serialize, Deserialize)]
struct Origin {
    /// The brief's file, for what it names beside itself.
    file: PathBuf,
    /// The brief as it was.
    text: String,
    seed: u64,
    evaluations: usize,
    stagnation: Option<u64>,
    method: Method,
    prices: Option<PathBuf>,
    baseline: bool,
    tables_only: bool,
}

/// What a run has to keep of how it was begun.
pub fn origin(args: &Optimize, file: &Path, text: &[u8], brief: &Brief) -> serde_json::Value {
    let search = &brief.search;
    let origin = Origin {
        file: file.to_owned(),
        text: String::from_utf8_lossy(text).into_owned(),
        seed: search.seed,
        evaluations: search.evaluations,
        stagnation: search.stagnation,
        method: search.algorithm.into(),
        prices: args.prices.as_ref().and_then(|p| std::path::absolute(p).ok()),
        baseline: args.baseline,
        tables_only: args.tables_only,
    };
    serde_json::to_value(origin).unwrap_or_default()
}

/// The job of an earlier run, and what its `run.json` says.
pub(super) fn reopen(run: &Path, args: &Resume) -> Result<(Job, RunFolder, serde_json::Value), Failure> {
    let folder = RunFolder::open(run).input()?;
    let mark = folder.read("run.json").run()?.unwrap_or_default();
    let mark: serde_json::Value =
        serde_json::from_slice(&mark).with_context(|| format!("{}/run.json", run.display())).input()?;
    let origin: Origin = serde_json::from_value(mark["resume"].clone())
        .with_context(|| {
            format!("{}/run.json: key \"resume\", without which a run cannot be carried on", run.display())
        })
        .input()?;
    let optimize = Optimize {
        brief: origin.file,
        out: Some(run.to_owned()),
        seed: Some(origin.seed),
        evaluations: Some(args.evaluations.unwrap_or(origin.evaluations)),
        time_limit: args.time_limit,
        stagnation: origin.stagnation,
        threads: None,
        method: Some(origin.method),
        prices: origin.prices,
        baseline: origin.baseline,
        tables_only: origin.tables_only,
    };
    let job = prepare(optimize, origin.text.into_bytes())?;
    let (then, now) = (&mark["hashes"], hashes(&job));
    let changed: Vec<&str> = now
        .as_object()
        .into_iter()
        .flatten()
        .filter(|(key, hash)| then.get(key) != Some(hash))
        .map(|(key, _)| key.as_str())
        .collect();
    if !changed.is_empty() {
        return Err(bad_input(format!(
            "{}: changed since the run began: {}. Put the old files back, or begin a new run with another --out",
            run.display(),
            changed.join(", ")
        )));
    }
    Ok((job, folder, mark))
}

pub fn run(args: Resume, json: bool) -> failure::Outcome {
    use_threads(args.threads)?;
    let (job, folder, mark) = reopen(&args.run, &args)?;
    let planned = job.evaluator.brief.search.evaluations as u64;
    if mark["status"] == "complete" && mark["counts"]["evaluations"].as_u64() >= Some(planned) {
        eprintln!(
            "{}: the run is complete with {planned} evaluations; --evaluations N lets it go further",
            args.run.display()
        );
        return Ok(());
    }
    folder.write("run.json", &Record::run_json(&job, None)).run()?;
    eprintln!("{}: carrying on in {}", job.evaluator.brief.name, args.run.display());
    execute(&job, &folder, json)
}
