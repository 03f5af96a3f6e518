//! The catalogue of labelled configurations: the thesis's families, its contradictions, and what houses need.

use std::collections::{BTreeMap, BTreeSet};

use houscaper::cubes::{
    Category, CubeKey, Grouping, Mask, catalogue, doubts, needs_tile, reachable_keys, reachable_labels,
};
use houscaper::voxels::Label;
use serde_json::{Value, json};

use crate::cli::output::say;

/// The labelled configurations that houses can show, and those of them that a set has a tile for.
pub struct Coverage {
    /// Name of the set.
    pub set: String,
    /// Labellings that need a tile.
    pub configurations: usize,
    /// Those with one.
    pub with_tile: usize,
}

/// Labellings that houses show and that need a tile.
pub fn needing_tiles() -> Vec<[Label; 8]> {
    reachable_labels().into_iter().filter(needs_tile).collect()
}

/// What a mask is, the full cube included.
fn category(mask: Mask) -> &'static str {
    if mask == Mask::FULL { "full" } else { Category::of(mask).name() }
}

/// Configurations, classes and keys of each category.
fn reachable() -> BTreeMap<&'static str, [usize; 3]> {
    let mut rows: BTreeMap<&'static str, [usize; 3]> = BTreeMap::new();
    let mut classes = BTreeSet::new();
    for labels in reachable_labels() {
        let row = rows.entry(category(Mask::of(&labels))).or_default();
        row[0] += 1;
        let class = Grouping::TurnsAndMirror.class(&labels);
        row[1] += usize::from(classes.insert(CubeKey::of_labels(class)));
    }
    for key in reachable_keys() {
        rows.entry(category(key.mask())).or_default()[2] += 1;
    }
    rows
}

/// Prints both tables.
pub fn print(coverage: &[Coverage]) {
    say!("the thesis's catalogue, enumerated");
    say!("  {:<22} {:>5}  {:>14}  definition (B lower, T upper corners)", "family", "tiles", "configurations");
    let families = catalogue();
    for family in &families {
        let mut lines = wrapped(family.definition, 51).into_iter();
        let first = lines.next().unwrap_or_default();
        say!("  {:<22} {:>5}  {:>14}  {}", family.name, family.tiles, family.configurations, first);
        lines.for_each(|line| say!("  {:<22} {:>5}  {:>14}  {}", "", "", "", line));
    }
    let all: BTreeSet<_> = families.iter().flat_map(|f| &f.members).collect();
    let tiles: usize = families.iter().map(|f| f.tiles).sum();
    say!("  {:<22} {:>5}  {:>14}  all different, all of admissible cubes", "union", tiles, all.len());
    say!("");
    say!("where its counts contradict each other");
    for doubt in doubts() {
        say!("  {}", doubt.subject);
        for (word, text) in [("here", &doubt.used), ("also", &doubt.other), ("because", &doubt.reason)] {
            for (n, line) in wrapped(text, 84).iter().enumerate() {
                say!("    {:<8} {line}", if n == 0 { word } else { "" });
            }
        }
    }
    say!("");
    say!("reachable under the rules (what no rule excludes that reads one cube and its face numbers)");
    say!("  {:<10} {:>14}  {:>7}  {:>7}", "category", "configurations", "classes", "keys");
    let rows = reachable();
    let total = rows.values().fold([0; 3], |sum, row| [0, 1, 2].map(|n| sum[n] + row[n]));
    for (name, [configurations, classes, keys]) in rows.iter().map(|(n, r)| (*n, *r)).chain([("all", total)]) {
        say!("  {name:<10} {configurations:>14}  {classes:>7}  {keys:>7}");
    }
    for c in coverage {
        let share = 100.0 * c.with_tile as f64 / c.configurations.max(1) as f64;
        say!("  {}: {} of {} have a tile, {share:.1} %", c.set, c.with_tile, c.configurations);
    }
}

/// The same for programs.
pub fn as_json(coverage: &[Coverage]) -> Value {
    let families: Vec<Value> = catalogue()
        .iter()
        .map(|f| {
            json!({
                "name": f.name, "definition": f.definition, "tiles": f.tiles, "configurations": f.configurations,
                "mirror": f.grouping == Grouping::TurnsAndMirror,
            })
        })
        .collect();
    let union: BTreeSet<_> = catalogue().into_iter().flat_map(|f| f.members).collect();
    let doubts: Vec<Value> = doubts()
        .iter()
        .map(|d| json!({"subject": d.subject, "used": d.used, "other": d.other, "reason": d.reason}))
        .collect();
    let reachable: BTreeMap<_, _> = reachable()
        .into_iter()
        .map(|(name, [n, classes, keys])| (name, json!({"configurations": n, "classes": classes, "keys": keys})))
        .collect();
    let coverage: Vec<Value> = coverage
        .iter()
        .map(|c| json!({"set": c.set, "configurations": c.configurations, "with_tile": c.with_tile}))
        .collect();
    json!({"families": families, "union": union.len(), "doubts": doubts, "reachable": reachable, "coverage": coverage})
}

/// A text in lines of at most `width` characters, cut at spaces.
fn wrapped(text: &str, width: usize) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    for word in text.split(' ') {
        match lines.last_mut() {
            Some(line) if line.len() + 1 + word.len() <= width => {
                line.push(' ');
                line.push_str(word);
            }
            _ => lines.push(word.to_owned()),
        }
    }
    lines
}
