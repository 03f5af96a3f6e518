//! `tileset check`: everything that is wrong with a set, for people or as JSON.

use std::collections::BTreeMap;
use std::path::Path;

use houscaper::tiles::check::{Finding, Folder, Report, check};
use houscaper::tiles::{MANIFEST_FILE, TilesetError, TilesetKind};

use super::architectural::{self, Architectural};
use crate::cli::check::plural;
use crate::cli::failure::{Blame, Failure, Outcome};
use crate::cli::output::say;

/// Most findings shown to people.
const MOST_FINDINGS: usize = 10;
/// Most tiles named in the summary of findings.
const MOST_SUSPECTS: usize = 4;

pub fn run(dir: &Path, root: Option<&Path>, as_json: bool) -> Outcome {
    let manifest = dir.join(MANIFEST_FILE);
    std::fs::metadata(&manifest).map_err(|source| TilesetError::Read { path: manifest, source }).input()?;
    let folder = Folder::open(dir, root);
    let set = architectural::is_style(dir).then(|| Architectural::load(dir)).transpose();
    let report = match &set {
        Ok(Some(set)) => check(&folder, Some(&|key| set.blocks(key))),
        Ok(None) | Err(_) => check(&folder, None),
    };
    // What keeps a style from building is found in its manifest, else it is told as it is: build-ups that are missing.
    if let Err(why) = set
        && report.is_clean()
    {
        return Err(why);
    }
    if as_json {
        say!("{}", serde_json::to_string(&report).run()?);
    } else {
        print(&report);
    }
    if report.is_clean() { Ok(()) } else { Err(Failure::Found) }
}

fn print(report: &Report) {
    let kind = match report.kind {
        TilesetKind::Surface => "surface",
        TilesetKind::Linear => "linear",
        TilesetKind::Solids => "solids",
        TilesetKind::Style => "style",
    };
    if !report.name.is_empty() {
        match report.coverage {
            Some(c) => say!("{} ({kind}): {} of {} configurations have a tile", report.name, c.covered, c.reachable),
            None => say!("{} ({kind})", report.name),
        }
    }
    if !report.compared.is_empty() {
        say!("{}", report.compared);
    }
    let count = report.findings.len();
    say!("{count} finding{}", plural(count));
    for finding in report.findings.iter().take(MOST_FINDINGS) {
        // Most messages begin with file and line themselves; those about the manifest as a whole do not.
        match (&finding.file, finding.line) {
            (Some(file), Some(line)) if !finding.message.starts_with(file.as_str()) => {
                say!("  {file}:{line}: {}", finding.message);
            }
            _ => say!("  {}", finding.message),
        }
    }
    if count > MOST_FINDINGS {
        say!("  and {} more (--json lists them all)", count - MOST_FINDINGS);
    }
    let tiles = suspects(&report.findings);
    if !tiles.is_empty() {
        let named: Vec<String> = tiles.iter().take(MOST_SUSPECTS).map(|(tile, n)| format!("{tile} in {n}")).collect();
        say!("tiles in most of them: {}", named.join(", "));
    }
}

/// Tiles by the number of findings they are named in, most first: the one to mend is at the top.
fn suspects(findings: &[Finding]) -> Vec<(&str, usize)> {
    let mut count: BTreeMap<&str, usize> = BTreeMap::new();
    for finding in findings {
        let names: std::collections::BTreeSet<&str> = finding.tiles.iter().map(String::as_str).collect();
        names.into_iter().for_each(|name| *count.entry(name).or_default() += 1);
    }
    let mut list: Vec<(&str, usize)> = count.into_iter().collect();
    list.sort_by_key(|(_, n)| std::cmp::Reverse(*n));
    list
}
