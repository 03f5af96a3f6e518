//! `tileset list`: the catalogue of the thesis, what houses need, and the tiles of a set.

use std::collections::BTreeSet;
use std::path::Path;

use anyhow::Context;
use houscaper::cubes::{Category, CubeKey, Mask, admissible_masks, canonical, turn_class};
use houscaper::tiles::{LabelSet, MANIFEST_FILE, Manifest, TilesetKind};
use serde_json::json;

use super::Loaded;
use super::architectural::{self, Architectural};
use super::catalogue::{self, Coverage};
use crate::cli::failure::{Blame, Failure, Outcome};
use crate::cli::output::say;

/// One tile of the catalogue.
struct Entry {
    name: String,
    pattern: String,
    class: Mask,
    category: &'static str,
    configurations: usize,
    pieces: usize,
    /// m2 of surface, or m of line.
    size: f64,
}

pub fn run(dir: Option<&Path>, root: Option<&Path>, as_json: bool) -> Outcome {
    let Some(dir) = dir else { return tables(&shipped()?, as_json, None) };
    if architectural::is_style(dir) {
        return tables(&[constructed(dir)?], as_json, None);
    }
    if super::is_solids(dir) {
        return tables(&[drawn(dir, root)?], as_json, None);
    }
    let set = super::load(dir)?;
    let kind = if matches!(set, Loaded::Linear(_)) { TilesetKind::Linear } else { TilesetKind::Surface };
    let path = dir.join(MANIFEST_FILE);
    let text = std::fs::read_to_string(&path).with_context(|| path.display().to_string()).input()?;
    let manifest = Manifest::parse(&text, &path, kind).input()?;
    let entries: Vec<Entry> = manifest.tiles.iter().filter_map(|tile| entry(&set, &tile.name, &tile.pattern)).collect();
    let has_tile = |mask: Mask| match &set {
        Loaded::Surface(set) => mask == Mask::FULL || !set.patches(mask).is_empty(),
        Loaded::Linear(set) => !set.tile_name(mask).is_empty(),
    };
    let needed = catalogue::needing_tiles();
    let with_tile = needed.iter().filter(|l| has_tile(Mask::of(l))).count();
    let own = Coverage { set: manifest.name.clone(), configurations: needed.len(), with_tile };
    tables(&[own], as_json, Some((&set, &manifest, &entries)))
}

/// The styles that come with the program.
fn shipped() -> Result<Vec<Coverage>, Failure> {
    ["architectural", "larch"].iter().map(|name| constructed(&super::named(name))).collect()
}

/// How many configurations the construction of a style gives solids.
fn constructed(dir: &Path) -> Result<Coverage, Failure> {
    let set = Architectural::load(dir)?;
    let [configurations, with_tile] = set.coverage();
    Ok(Coverage { set: set.name().into(), configurations, with_tile })
}

/// How many configurations a set of solids has a mesh for.
fn drawn(dir: &Path, root: Option<&Path>) -> Result<Coverage, Failure> {
    let set = LabelSet::load_from(dir, root).input()?;
    let needed = catalogue::needing_tiles();
    let with_tile = needed.iter().filter(|l| set.tile(CubeKey::of_labels(**l)).is_some()).count();
    Ok(Coverage { set: set.name().into(), configurations: needed.len(), with_tile })
}

fn tables(coverage: &[Coverage], as_json: bool, set: Option<(&Loaded, &Manifest, &[Entry])>) -> Outcome {
    if as_json {
        let mut answer = catalogue::as_json(coverage);
        if let Some((set, manifest, entries)) = set {
            answer["name"] = json!(manifest.name);
            answer["kind"] = json!(kind_name(set));
            answer["tiles"] = entries.iter().map(row).collect();
        }
        say!("{answer}");
        return Ok(());
    }
    catalogue::print(coverage);
    if let Some((set, manifest, entries)) = set {
        say!("");
        print(set, manifest, entries);
    }
    Ok(())
}

fn kind_name(set: &Loaded) -> &'static str {
    match set {
        Loaded::Surface(_) => "surface",
        Loaded::Linear(_) => "linear",
    }
}

fn size_key(set: &Loaded) -> &'static str {
    match set {
        Loaded::Surface(_) => "area m2",
        Loaded::Linear(_) => "length m",
    }
}

/// A tile measured on the first configuration it covers; `None` when it covers none.
fn entry(set: &Loaded, name: &str, pattern: &str) -> Option<Entry> {
    let covered: Vec<Mask> = Mask::all()
        .filter(|&m| match set {
            Loaded::Surface(set) => set.tile_name(m) == name,
            Loaded::Linear(set) => set.tile_name(m) == name,
        })
        .collect();
    let first = *covered.first()?;
    let (pieces, size) = match set {
        Loaded::Surface(set) => (set.patches(first).len(), set.area_terms(first).iter().map(|t| t.area_m2).sum()),
        Loaded::Linear(set) => (set.lines(first).len(), set.lines(first).iter().map(|l| l.length_mm() / 1000.0).sum()),
    };
    Some(Entry {
        name: name.to_owned(),
        pattern: pattern.to_owned(),
        class: canonical(first).0,
        category: if first == Mask::FULL { "full" } else { Category::of(first).name() },
        configurations: covered.len(),
        pieces,
        size,
    })
}

fn row(e: &Entry) -> serde_json::Value {
    json!({
        "tile": e.name, "pattern": e.pattern, "class": e.class.0, "category": e.category,
        "configurations": e.configurations, "pieces": e.pieces, "size": e.size,
    })
}

fn print(set: &Loaded, manifest: &Manifest, entries: &[Entry]) {
    say!("{} ({}): {}", manifest.name, kind_name(set), manifest.description);
    say!("corner order {}, module {:?} {}", manifest.corner_order, manifest.module_size, manifest.unit);
    let width = entries.iter().map(|e| e.name.len()).max().unwrap_or(0).max(4);
    let pieces = if matches!(set, Loaded::Linear(_)) { "lines" } else { "patches" };
    say!("{:width$}  corners   class  category  configurations  {pieces:>7}  {:>8}", "tile", size_key(set));
    for e in entries {
        say!(
            "{:width$}  {}  {:>5}  {:<8}  {:>14}  {:>7}  {:>8.4}",
            e.name,
            e.pattern,
            e.class.0,
            e.category,
            e.configurations,
            e.pieces,
            e.size
        );
    }
    let of = |category: &str| entries.iter().filter(|e| e.category == category).count();
    let turns: BTreeSet<Mask> = admissible_masks().map(turn_class).collect();
    let classes: BTreeSet<Mask> = admissible_masks().map(|m| canonical(m).0).collect();
    say!(
        "{} tiles: {} roof, {} floor, {} wall, {} extra{}; {} configurations",
        entries.len(),
        of("roof"),
        of("floor"),
        of("wall"),
        of("extra"),
        if of("full") > 0 { ", 1 full" } else { "" },
        entries.iter().map(|e| e.configurations).sum::<usize>(),
    );
    say!(
        "of {} admissible configurations: {} classes under quarter turns, {} with mirror",
        admissible_masks().count(),
        turns.len(),
        classes.len()
    );
}
