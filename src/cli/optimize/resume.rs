//! `houscaper resume`: a run carried on where it stopped.

use std::path::{Path, PathBuf};

use anyhow::Context;
use houscaper::brief::Brief;
use houscaper::run::RunFolder;
use serde::{Deserialize, Serialize};

use super::record::{Record, hashes};
use super::{Job, execute, labour, prepare, use_threads};
use crate::cli::args::{GlbParts, Method, Optimize, Resume};
use crate::cli::failure::{self, Blame, Failure, bad_input};

/// How a run was begun: kept in its `run.json`.
#[derive(Clone, Debug, Serialize, Deserialize)]
struct Origin {
    /// The brief's file, for what it names beside itself; seen from the run's folder, so that both may move together.
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
    #[serde(default)]
    glb_parts: GlbParts,
    #[serde(default)]
    ifc: bool,
}

/// A path seen from a folder; as it is where the two have no root in common.
pub(super) fn seen_from(folder: &Path, path: &Path) -> PathBuf {
    let (Ok(folder), Ok(path)) = (std::path::absolute(folder), std::path::absolute(path)) else {
        return path.to_owned();
    };
    let shared = folder.components().zip(path.components()).take_while(|(a, b)| a == b).count();
    if shared == 0 {
        return path;
    }
    let up = folder.components().skip(shared).map(|_| std::path::Component::ParentDir);
    up.chain(path.components().skip(shared)).collect()
}

/// What a run in a folder has to keep of how it was begun.
pub fn origin(args: &Optimize, [file, out]: [&Path; 2], text: &[u8], brief: &Brief) -> serde_json::Value {
    let search = &brief.search;
    let origin = Origin {
        file: seen_from(out, file),
        text: String::from_utf8_lossy(text).into_owned(),
        seed: search.seed,
        evaluations: search.evaluations,
        stagnation: search.stagnation,
        method: search.algorithm.into(),
        prices: args.prices.as_ref().map(|prices| seen_from(out, prices)),
        baseline: args.baseline,
        tables_only: args.tables_only,
        glb_parts: args.glb_parts,
        ifc: args.ifc,
    };
    serde_json::to_value(origin).unwrap_or_default()
}

/// The job of an earlier run, and what its `run.json` says.
pub(super) fn reopen(run: &Path, args: &Resume) -> Result<(Job, RunFolder, serde_json::Value), Failure> {
    let folder = RunFolder::open(run).input()?;
    let mark = folder.read("run.json").run()?.unwrap_or_default();
    let mark: serde_json::Value =
        serde_json::from_slice(&mark).with_context(|| format!("{}/run.json", run.display())).input()?;
    if !mark["resume"]["merged"].is_null() {
        return Err(bad_input(format!(
            "{}: is merged from other runs: carry on one of those and merge again",
            run.display()
        )));
    }
    let origin: Origin = serde_json::from_value(mark["resume"].clone())
        .with_context(|| {
            format!("{}/run.json: key \"resume\", without which a run cannot be carried on", run.display())
        })
        .input()?;
    let optimize = Optimize {
        brief: run.join(origin.file),
        out: Some(run.to_owned()),
        seed: Some(origin.seed),
        evaluations: Some(args.evaluations.unwrap_or(origin.evaluations)),
        time_limit: args.time_limit,
        stagnation: origin.stagnation,
        threads: None,
        method: Some(origin.method),
        prices: origin.prices.map(|prices| run.join(prices)),
        baseline: origin.baseline,
        tables_only: origin.tables_only,
        glb_parts: origin.glb_parts,
        ifc: origin.ifc || args.ifc,
        queue: args.queue.clone(),
        per_question: args.per_question,
    };
    let job = prepare(optimize, origin.text.into_bytes())?;
    let (then, now) = (&mark["hashes"], hashes(&job));
    let changed: Vec<&str> = now
        .as_object()
        .into_iter()
        .flatten()
        .filter(|(key, hash)| then.get(key).unwrap_or(&serde_json::Value::Null) != *hash)
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
    // Models may be asked for when all is found: the results are then written again.
    if mark["status"] == "complete" && mark["counts"]["evaluations"].as_u64() >= Some(planned) && !args.ifc {
        eprintln!(
            "{}: the run is complete with {planned} evaluations; --evaluations N lets it go further, --ifc writes its models",
            args.run.display()
        );
        return Ok(());
    }
    let labour = labour::of(&job)?;
    folder.write("run.json", &Record::run_json(&job, None)).run()?;
    eprintln!("{}: carrying on in {}", job.evaluator.brief.name, args.run.display());
    execute(&job, &folder, labour, json)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_path_is_seen_from_a_folder() {
        let seen = |folder: &str, path: &str| seen_from(Path::new(folder), Path::new(path)).display().to_string();
        assert_eq!(seen("/a/results/run", "/a/configs/b.json"), "../../configs/b.json");
        assert_eq!(seen("/a", "/a/b.json"), "b.json");
        assert_eq!(seen("results/run", "configs/b.json"), "../../configs/b.json");
    }
}
