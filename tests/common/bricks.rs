//! A small complete set of solids: a brick in every filled octant.
#![allow(dead_code)]

use houscaper::cubes::{Corner, Mask, canonical_masks};
use serde_json::{Value, json};
use std::collections::BTreeMap;
use std::fmt::Write;

/// File name and text of every file of a set.
pub type Files = BTreeMap<String, String>;

/// The faces of a box by corner number x + 2y + 4z, counter-clockwise from outside.
pub const FACES: [[usize; 4]; 6] = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];

/// An OBJ text of boxes from low to high, mm, each in its group.
pub fn boxes(list: &[(String, [f64; 3], [f64; 3])]) -> String {
    let mut text = String::from("# bricks\n");
    for (n, (group, low, high)) in list.iter().enumerate() {
        for c in 0..8 {
            let at = |a: usize| if c >> a & 1 == 1 { high[a] } else { low[a] };
            writeln!(text, "v {} {} {}", at(0), at(1), at(2)).expect("text");
        }
        writeln!(text, "g {group}").expect("text");
        for face in FACES {
            writeln!(text, "f {}", face.map(|c| (n * 8 + c + 1).to_string()).join(" ")).expect("text");
        }
    }
    text
}

/// A brick in every octant of a mask, in groups `wall_o<octant>`.
pub fn bricks(mask: Mask) -> String {
    let filled = Corner::all().filter(|&c| mask.has(c));
    let list: Vec<_> = filled
        .map(|c| {
            let low = [0, 1, 2].map(|a| f64::from(c.xyz()[a]) * [450.0, 450.0, 270.0][a]);
            (format!("wall_o{}", c.number()), low, [low[0] + 450.0, low[1] + 450.0, low[2] + 270.0])
        })
        .collect();
    boxes(&list)
}

/// A mask as a pattern of filled and empty corners.
pub fn pattern(mask: Mask) -> String {
    mask.pattern().replace('1', "*")
}

/// A manifest with the given tiles.
pub fn manifest(tiles: Vec<Value>) -> Value {
    json!({
        "schema": "houscaper.tileset/1", "name": "bricks", "kind": "solids", "unit": "mm", "up_axis": "z",
        "module_size": [900, 900, 540], "corner_order": "f_order",
        "labels": {"0": "empty", "1": "base", "2": "floor", "3": "foundation", "4": "opening", "5": "window"},
        "layers": [{"name": "wall", "kind": "solid", "component": "cladding"}],
        "tiles": tiles
    })
}

/// The whole set: 26 canonical tiles and the full cube, whatever the labels.
pub fn set() -> Files {
    let masks: Vec<Mask> = canonical_masks().into_iter().chain([Mask::FULL]).collect();
    let name = |m: &Mask| format!("brick-{:03}", m.0);
    let tiles = masks
        .iter()
        .map(|m| {
            let symmetry = json!({"mirror": true, "quarter_turns": true});
            json!({"name": name(m), "pattern": pattern(*m), "symmetry": symmetry, "file": format!("{}.obj", name(m))})
        })
        .collect();
    let mut files: Files = masks.iter().map(|m| (format!("{}.obj", name(m)), bricks(*m))).collect();
    files.insert("tileset.json".into(), serde_json::to_string_pretty(&manifest(tiles)).expect("JSON"));
    files
}

/// The set with a change of its manifest.
pub fn changed(files: &Files, change: impl Fn(&mut Value)) -> Files {
    let mut files = files.clone();
    let mut json: Value = serde_json::from_str(&files["tileset.json"]).expect("JSON");
    change(&mut json);
    files.insert("tileset.json".into(), serde_json::to_string_pretty(&json).expect("JSON"));
    files
}
