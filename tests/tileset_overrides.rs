//! A style with one configuration drawn by a mesh: one that meets its neighbours is clean, one that does not is named.
#![allow(clippy::unwrap_used, reason = "a test fails by panicking, in its helpers too")]

#[path = "common/shells.rs"]
mod shells;

use std::collections::BTreeMap;
use std::fmt::Write;
use std::path::Path;

use houscaper::cubes::CubeKey;
use houscaper::tiles::check::{FindingKind, Folder, Report, check};
use houscaper::tiles::solids::{boundary, solids};
use houscaper::tiles::{Block, StyleSet};
use houscaper::voxels::Label;
use serde_json::{Value, json};

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

/// Blocks as OBJ in mm, a closed solid for each component and octant.
fn obj(blocks: &[Block]) -> String {
    let mut parts: BTreeMap<_, Vec<Block>> = BTreeMap::new();
    blocks.iter().for_each(|b| parts.entry((b.component, b.octant)).or_default().push(b.clone()));
    let (mut text, mut used) = (String::new(), 0);
    for ((component, octant), blocks) in parts {
        writeln!(text, "g {}_o{octant}", component.name()).unwrap();
        for face in boundary(&blocks) {
            face.iter().for_each(|p| {
                let [x, y, z] = p.map(|um| f64::from(um) / 1000.0);
                writeln!(text, "v {x} {y} {z}").unwrap();
            });
            let corners: Vec<String> = (1..=face.len()).map(|n| (used + n).to_string()).collect();
            writeln!(text, "f {}", corners.join(" ")).unwrap();
            used += face.len();
        }
    }
    text
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
    assert_eq!((clean.coverage.covered, clean.coverage.reachable), (2029, 2029));
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
