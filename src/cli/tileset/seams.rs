//! `tileset check`: every configuration has a tile, and every pair that may meet fits.

use std::collections::BTreeMap;
use std::path::Path;

use houscaper::cubes::{Mask, admissible_masks};
use houscaper::tiles::{Finding, check_linear_tileset, check_tileset, meetings};
use serde_json::{Value, json};

use super::Loaded;
use crate::cli::check::plural;
use crate::cli::failure::{Failure, Outcome};
use crate::cli::output::say;

/// Most findings shown to people.
const MOST_FINDINGS: usize = 10;
/// Most tiles named in the summary of findings.
const MOST_SUSPECTS: usize = 4;

pub fn run(dir: &Path, as_json: bool) -> Outcome {
    let set = super::load(dir)?;
    let findings = match &set {
        Loaded::Surface(set) => check_tileset(set),
        Loaded::Linear(set) => check_linear_tileset(set),
    };
    let [reachable, covered] = coverage(&set);
    if as_json {
        let rows: Vec<Value> = findings.iter().map(row).collect();
        say!("{}", json!({"coverage": {"reachable": reachable, "covered": covered}, "findings": rows}));
    } else {
        print(&set, [reachable, covered], &findings);
    }
    if findings.is_empty() && covered == reachable { Ok(()) } else { Err(Failure::Found) }
}

/// Configurations that need a tile, and those that have one. Linear sets need one for the full cube too: it carries the slab grid.
fn coverage(set: &Loaded) -> [usize; 2] {
    let (needed, name): (Vec<Mask>, Box<dyn Fn(Mask) -> bool + '_>) = match set {
        Loaded::Surface(set) => (admissible_masks().collect(), Box::new(|m| !set.tile_name(m).is_empty())),
        Loaded::Linear(set) => {
            (admissible_masks().chain([Mask::FULL]).collect(), Box::new(|m| !set.tile_name(m).is_empty()))
        }
    };
    [needed.len(), needed.iter().filter(|m| name(**m)).count()]
}

fn row(finding: &Finding) -> Value {
    let meeting = finding.meeting;
    json!({
        "face": meeting.axis.name(),
        "configurations": [meeting.low.0, meeting.high.0],
        "tiles": finding.tiles,
        "only_first": finding.only_low,
        "only_second": finding.only_high,
        "message": finding.to_string(),
    })
}

fn print(set: &Loaded, [reachable, covered]: [usize; 2], findings: &[Finding]) {
    let (name, kind) = match set {
        Loaded::Surface(set) => (set.name(), "surface"),
        Loaded::Linear(set) => (set.name(), "linear"),
    };
    say!("{name} ({kind}): {covered} of {reachable} configurations have a tile");
    say!(
        "{} pairs that may meet compared along x, y and z: {} seam{} open",
        meetings().count(),
        findings.len(),
        plural(findings.len())
    );
    for finding in findings.iter().take(MOST_FINDINGS) {
        say!("  {finding}");
    }
    if findings.len() > MOST_FINDINGS {
        say!("  and {} more (--json lists them all)", findings.len() - MOST_FINDINGS);
    }
    let tiles = suspects(findings);
    if !tiles.is_empty() {
        let named: Vec<String> = tiles.iter().take(MOST_SUSPECTS).map(|(tile, n)| format!("{tile} in {n}")).collect();
        say!("tiles in most of them: {}", named.join(", "));
    }
}

/// Tiles by the number of open seams they stand at, most first: the one to mend is at the top.
fn suspects(findings: &[Finding]) -> Vec<(&str, usize)> {
    let mut count: BTreeMap<&str, usize> = BTreeMap::new();
    for finding in findings {
        let [low, high] = &finding.tiles;
        let names = [Some(low), Some(high).filter(|h| *h != low)];
        for name in names.into_iter().flatten().filter(|n| !n.is_empty()) {
            *count.entry(name).or_default() += 1;
        }
    }
    let mut list: Vec<(&str, usize)> = count.into_iter().collect();
    list.sort_by_key(|(_, n)| std::cmp::Reverse(*n));
    list
}
