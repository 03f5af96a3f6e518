//! A style with one configuration drawn by a mesh: one that meets its neighbours is clean, one that does not is named.
#![allow(clippy::unwrap_used, reason = "a test fails by panicking, in its helpers too")]

#[path = "common/shells.rs"]
mod shells;
#[path = "common/tile_obj.rs"]
mod tile_obj;

use std::path::Path;

use houscaper::cubes::CubeKey;
use houscaper::tiles::StyleSet;
use houscaper::tiles::check::{FindingKind, Folder, Report, check};
use houscaper::tiles::solids::solids;
use houscaper::voxels::Label;
use serde_json::{Value, json};
use tile_obj::obj;

fn shipped() -> (Value, StyleSet) {
    let dir = Path::new(env!("CARGO_MANIFEST_DIR")).join("tilesets/architectural");
    let text = std::fs::read_to_string(dir.join("tileset.json")).unwrap();
    (serde_json::from_str(&text).unwrap(), StyleSet::load(&dir).unwrap())
}

/// A straight wall of base: one key has these labels.
fn wall() -> CubeKey {
    let [e, b] = [Label::Empty, Label::Base];
    CubeKey::of_labels([b, b, e, e, b, b, e, e])
}

fn report(mesh: &str) -> Report {
    let (mut manifest, set) = shipped();
    manifest["overrides"] = json!([{
        "name": "own-wall", "pattern": "11001100", "symmetry": {"mirror": false, "quarter_turns": false}, "file": "own-wall.obj",
    }]);
    let files = [("tileset.json".to_owned(), manifest.to_string()), ("own-wall.obj".to_owned(), mesh.to_owned())];
    let shells = shells::shells();
    check(&Folder::in_memory(files.into()), Some(&|key| solids(key, &set.style, &shells)))
}

#[test]
fn a_mesh_that_fits_is_clean_and_one_that_does_not_is_named() {
    let (_, set) = shipped();
    let mut blocks = solids(wall(), &set.style, &shells::shells());
    let clean = report(&obj(&blocks));
    assert_eq!(clean.findings, []);
    assert_eq!(clean.coverage.map(|c| (c.covered, c.reachable)), Some((2029, 2029)));
    // The facade stands back by 10 mm.
    let outer = blocks.iter().flat_map(|b| b.plan.iter().map(|p| p[1])).max().unwrap();
    blocks.iter_mut().flat_map(|b| &mut b.plan).filter(|p| p[1] == outer).for_each(|p| p[1] -= 10_000);
    let found = report(&obj(&blocks)).findings;
    assert!(found.iter().all(|f| f.kind == FindingKind::Seam), "{found:?}");
    assert!(found.iter().filter(|f| f.face.as_deref() == Some("x")).count() == 2, "both ends of the wall: {found:?}");
    for finding in &found {
        assert_eq!(finding.tiles, ["own-wall"]);
        assert_eq!(finding.neighbour.as_deref(), Some("the style's own tile"));
        assert_eq!(finding.configurations, [wall().to_string()]);
        assert!(finding.face.is_some() && !finding.only_first.is_empty() && !finding.only_second.is_empty());
    }
}
