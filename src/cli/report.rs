//! `houscaper report`: the page of a folder that is there.

use std::time::Instant;

use houscaper::export::report::{Folder, Report, collect, report_html};
use houscaper::run::RunFolder;
use serde_json::json;

use super::args;
use super::failure::{Blame, Failure, Outcome};
use super::output::say;

/// The page.
const FILE: &str = "report.html";

pub fn run(args: &args::Report, json: bool) -> Outcome {
    let started = Instant::now();
    let folder = RunFolder::look(&args.run).input()?;
    let (report, bytes) = page(&folder)?;
    let path = args.run.join(FILE);
    if json {
        let count = |what: fn(&Report) -> usize| what(&report);
        let told = json!({
            "file": path,
            "bytes": bytes,
            "houses": count(|r| r.houses.len()),
            "houses_with_files": count(|r| r.houses.iter().filter(|h| !h.files.is_empty()).count()),
            "designs": report.cloud.as_ref().map(|c| c.total),
            "designs_shown": report.cloud.as_ref().map(|c| c.shown),
            "missing": report.missing,
        });
        say!("{}", serde_json::to_string_pretty(&told).run()?);
        return Ok(());
    }
    report.missing.iter().for_each(|sentence| eprintln!("{}: {sentence}", args.run.display()));
    let size = bytes as f64 / 1e6;
    say!("{}: {size:.1} MB, in {:.1} s; open it in a browser", path.display(), started.elapsed().as_secs_f64());
    Ok(())
}

/// Writes the page of a finished run into its folder; what is wrong with its files is the run's fault here.
pub fn write(folder: &RunFolder) -> Outcome {
    match page(folder) {
        Err(Failure::Input(error)) => Err(Failure::Run(error)),
        written => written.map(drop),
    }
}

/// Writes the page; what it shows, and its size in bytes.
fn page(folder: &RunFolder) -> Result<(Report, usize), Failure> {
    let read = |name: &str| folder.read(name);
    let files = |name: &str| folder.files(name);
    let (report, packed) = collect(&Folder { read: &read, files: &files }).input()?;
    let html = report_html(&report, &packed).run()?;
    folder.write(FILE, html.as_bytes()).run()?;
    Ok((report, html.len()))
}
