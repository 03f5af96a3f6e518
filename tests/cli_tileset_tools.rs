//! `houscaper tileset` list, sheet, new and bake: what a designer starts from and takes away.

#[path = "common/cli.rs"]
mod cli;

use std::path::Path;

use cli::{Scratch, contents, has, ok, refused};
use serde_json::Value;

#[test]
fn the_list_shows_the_thesis_its_contradictions_and_our_coverage() {
    let list = ok(&["tileset", "list"]).out;
    let union = list.lines().find(|l| l.trim_start().starts_with("union")).expect("the sum");
    assert_eq!(union.split_whitespace().take(3).collect::<Vec<_>>(), ["union", "105", "493"]);
    has(&list, &["12 tiles, 60 configurations", "72: 9 parts of a wall", "109, with twelve", "25 + 10 + 4", "2376"]);
    assert!(list.lines().all(|l| l.chars().count() <= 100), "readable at 100 columns");
    let json: Value = serde_json::from_str(&ok(&["tileset", "list", "surface-2", "--json"]).out).expect("JSON");
    assert_eq!(json["union"], 493);
    assert_eq!(json["families"].as_array().map(Vec::len), Some(9));
    let coverage = &json["coverage"][0];
    assert_eq!(coverage["with_tile"], coverage["configurations"], "surfaces cover every mask");
    assert_eq!(json["tiles"].as_array().map(Vec::len), Some(26));
}

#[test]
fn a_new_set_passes_its_check_and_is_not_overwritten() {
    let folder = Scratch::new();
    let out = folder.at("mine");
    ok(&["tileset", "new", &out]);
    has(&ok(&["tileset", "check", &out]).out, &["mine (surface): 126 of 126", "0 seams open"]);
    let before = contents(Path::new(&out));
    assert_eq!(before.len(), 28, "manifest, cage and 26 tiles");
    has(&refused(&["tileset", "new", &out, "--kind", "solids"]), &["mine", "is there already"]);
    assert_eq!(contents(Path::new(&out)), before);
    let solids = folder.at("bodies");
    ok(&["tileset", "new", &solids, "--kind", "solids"]);
    let manifest = std::fs::read_to_string(Path::new(&solids).join("tileset.json")).expect("a manifest");
    let manifest: Value = serde_json::from_str(&manifest).expect("JSON");
    assert_eq!((&manifest["kind"], manifest["tiles"].as_array().map(Vec::len)), (&"solids".into(), Some(26)));
    has(&ok(&["tileset", "check", &solids]).out, &["2014 of 2014", "0 findings"]);
}

#[test]
fn a_baked_set_has_every_configuration_and_loads_again() {
    let folder = Scratch::new();
    for (name, configurations) in [("surface-1", 126), ("surface-2", 126), ("linear", 127)] {
        let out = folder.at(name);
        ok(&["tileset", "bake", name, "--out", &out]);
        assert_eq!(contents(Path::new(&out)).len(), configurations + 1);
        has(&ok(&["tileset", "check", &out]).out, &[&format!("{configurations} of {configurations}"), "0 seams open"]);
        ok(&["tileset", "bake", name, "--out", &out]);
    }
    let before = contents(folder.path());
    has(&refused(&["tileset", "bake", "linear", "--out", &folder.at("surface-1")]), &["nothing was written"]);
    assert_eq!(contents(folder.path()), before);
    let out = folder.at("solids");
    ok(&["tileset", "bake", "architectural", "--families", "--out", &out]);
    let files = contents(Path::new(&out));
    assert!(files.iter().any(|(path, _)| path.ends_with("components.mtl")));
}

#[test]
fn a_sheet_is_a_picture() {
    let folder = Scratch::new();
    let out = folder.at("sheet.png");
    ok(&["tileset", "sheet", "surface-2", "--out", &out]);
    let png = std::fs::read(&out).expect("a picture");
    assert_eq!(&png[1..4], b"PNG");
    has(&refused(&["tileset", "sheet", "linear", "--out", &out]), &["no surfaces to draw"]);
    assert_eq!(std::fs::read(&out).expect("a picture"), png);
}
