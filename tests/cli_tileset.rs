//! `houscaper tileset`: shipped sets are proved, every mistake of a designer is one clear error.

#[path = "common/cli.rs"]
mod cli;

use std::path::Path;

use cli::{Scratch, contents, has, ok, refused, run};
use serde_json::Value;

/// A copy of a shipped set in a scratch folder.
fn copy(name: &str) -> (Scratch, String) {
    let folder = Scratch::new();
    for (path, bytes) in contents(&Path::new(env!("CARGO_MANIFEST_DIR")).join("tilesets").join(name)) {
        folder.file(path.file_name().and_then(|n| n.to_str()).expect("a name"), bytes);
    }
    let path = folder.at("");
    (folder, path)
}

/// Replaces `old`, which must be there, once in a file.
fn edit(folder: &Scratch, file: &str, old: &str, new: &str) {
    let text = std::fs::read_to_string(folder.at(file)).expect("a file");
    assert!(text.contains(old), "{file} has no {old}");
    folder.file(file, text.replacen(old, new, 1));
}

#[test]
fn shipped_sets_are_covered_and_closed() {
    for (name, configurations) in [("surface-1", 126), ("surface-2", 126), ("linear", 127)] {
        let people = ok(&["tileset", "check", name]);
        has(
            &people.out,
            &[&format!("{configurations} of {configurations} configurations"), "3684 pairs", "0 seams open"],
        );
        let programs: Value = serde_json::from_str(&ok(&["tileset", "check", name, "--json"]).out).expect("JSON");
        let expected =
            serde_json::json!({"coverage": {"reachable": configurations, "covered": configurations}, "findings": []});
        assert_eq!(programs, expected);
    }
}

#[test]
fn the_catalogue_has_the_thesis_counts() {
    let list = ok(&["tileset", "list", "surface-2"]).out;
    has(
        &list,
        &[
            "26 tiles: 11 roof, 11 floor, 3 wall, 1 extra; 126 configurations",
            "33 classes under quarter turns, 26 with mirror",
        ],
    );
    // The pyramid corner: two triangles of 450 x sqrt(450^2 + 270^2) / 2 mm2.
    let row = list.lines().find(|l| l.starts_with("roof-001")).expect("the row");
    assert_eq!(row.split_whitespace().collect::<Vec<_>>(), ["roof-001", "10000000", "1", "roof", "4", "2", "0.2362"]);
    assert!((0.45 * 0.45f64.hypot(0.27) - 0.2362).abs() < 1e-4);
    let json: Value = serde_json::from_str(&ok(&["tileset", "list", "linear", "--json"]).out).expect("JSON");
    assert_eq!(json["tiles"].as_array().map(Vec::len), Some(27));
}

#[test]
fn an_open_seam_names_tile_face_and_neighbour() {
    let (folder, path) = copy("surface-2");
    // The upper edge of the sloped tile sinks: it no longer meets its neighbours along y.
    for x in ["0", "450", "900"] {
        edit(&folder, "roof-003.obj", &format!("v {x} 0 270"), &format!("v {x} 0 200"));
    }
    let ran = run(&["tileset", "check", &path]);
    assert_eq!(ran.code, 2, "{}{}", ran.out, ran.err);
    has(
        &ran.out,
        &[
            "126 of 126",
            "seams open",
            "face between configurations",
            "tile 'roof-003'",
            "only the first has",
            "most of them: roof-003 in",
        ],
    );
    let ran = run(&["tileset", "check", &path, "--json"]);
    assert_eq!(ran.code, 2);
    let answer: Value = serde_json::from_str(&ran.out).expect("JSON");
    let finding = &answer["findings"][0];
    assert!(finding["tiles"].as_array().expect("two").iter().any(|t| t == "roof-003"), "{finding}");
    assert!(["x", "y", "z"].iter().any(|a| finding["face"] == *a));
    assert_eq!(finding["configurations"].as_array().map(Vec::len), Some(2));
}

/// What `check` says about a set with mistakes.
fn finds(path: &str) -> String {
    let ran = run(&["tileset", "check", path]);
    assert_eq!((ran.code, ran.err.as_str()), (2, ""), "{}", ran.out);
    ran.out
}

/// One mistake in a copy of a set: named by `check`, and the loader's error through `list` and `evaluate`.
fn refuses(set: &str, file: &str, [old, new]: [&str; 2], parts: &[&str]) {
    let (folder, path) = copy(set);
    ok(&["tileset", "check", &path]);
    edit(&folder, file, old, new);
    has(&finds(&path), parts);
    has(&refused(&["tileset", "list", &path]), parts);
    let key = if set == "linear" { "linear" } else { "tileset" };
    let brief = folder.brief("brief.json", |b| b[key] = path.as_str().into());
    has(&refused(&["check", "--rules", "--brief", &brief]), parts);
}

const MANIFEST: &str = "tileset.json";

#[test]
fn a_missing_tile_is_named_by_its_corners() {
    let entry =
        "\"pattern\": \"10001000\",\n      \"symmetry\": {\n        \"mirror\": true,\n        \"quarter_turns\": true";
    let unturned = entry.replace("true", "false");
    refuses(
        "surface-1",
        MANIFEST,
        [entry, &unturned],
        &["tileset.json: no tile for configuration", "(corners 01000100"],
    );
}

#[test]
fn manifest_mistakes_name_the_key() {
    refuses(
        "surface-2",
        MANIFEST,
        ["\"unit\": \"mm\"", "\"unit\": \"furlong\""],
        &["tileset.json", "unit is \"furlong\"", "\"mm\""],
    );
    refuses("surface-2", MANIFEST, ["\"unit\"", "\"units\""], &["tileset.json", "unknown field `units`"]);
    refuses("surface-2", MANIFEST, ["roof-001.obj", "roof-1.obj"], &["roof-1.obj: cannot be read"]);
    refuses("linear", MANIFEST, ["\"up_axis\": \"z\"", "\"up_axis\": \"w\""], &["up_axis is \"w\""]);
}

#[test]
fn a_surface_that_ends_inside_the_cube_is_named_by_line() {
    refuses(
        "surface-2",
        "roof-001.obj",
        ["\nf 1 4 2", ""],
        &["roof-001.obj:7: the surface ends inside the cube at the edge"],
    );
}

#[test]
fn a_vertex_beyond_the_overhang_is_named_by_line() {
    let parts = ["roof-001.obj:2: the vertex [0, 0, -300] mm lies 300 mm outside", "overhang of 0 mm"];
    refuses("surface-2", "roof-001.obj", ["v 0 0 270", "v 0 0 -300"], &parts);
    refuses("linear", "roof-001.obj", ["v 0 0", "v -90 0"], &["roof-001.obj:2: the vertex", "outside the cube"]);
}

#[test]
fn an_open_solid_is_named_by_line_and_group() {
    let layer = "\"layers\": [\n    {\"name\": \"board\", \"kind\": \"solid\", \"overhang\": 0.0},";
    let tetrahedron = "v 100 100 100\nv 200 100 100\nv 100 200 100\nv 100 100 200\ng board_o0\nf -4 -2 -3\nf -4 -3 -1\nf -3 -2 -1\nf -4 -1 -2\n";
    let (folder, path) = copy("surface-2");
    edit(&folder, MANIFEST, "\"layers\": [", layer);
    let text = std::fs::read_to_string(folder.at("roof-001.obj")).expect("a tile");
    folder.file("roof-001.obj", format!("{text}{tetrahedron}"));
    ok(&["tileset", "check", &path]);
    edit(&folder, "roof-001.obj", "\nf -4 -1 -2", "");
    has(&finds(&path), &["roof-001.obj:", "the solid board_o0 is open at the edge", "close it"]);
}

#[test]
fn an_unknown_set_is_an_error() {
    has(&refused(&["tileset", "check", "surface-9"]), &["surface-9", "cannot be read"]);
    has(
        &refused(&["tileset", "bake", "surface-9", "--canonical", "--out", "never"]),
        &["surface-9", "surface-1, surface-1-offset, surface-2 or linear"],
    );
}

#[test]
fn baking_gives_the_shipped_files_and_spares_strangers() {
    let folder = Scratch::new();
    for name in ["surface-1", "surface-2", "linear"] {
        let out = folder.at(name);
        ok(&["tileset", "bake", name, "--canonical", "--out", &out]);
        let names = |root: &Path| -> Vec<_> {
            contents(root).into_iter().map(|(p, b)| (p.file_name().expect("a name").to_owned(), b)).collect()
        };
        let shipped = Path::new(env!("CARGO_MANIFEST_DIR")).join("tilesets").join(name);
        assert_eq!(names(&folder.path().join(name)), names(&shipped), "{name}");
        ok(&["tileset", "bake", name, "--canonical", "--out", &out]);
    }
    let before = contents(folder.path());
    has(
        &refused(&["tileset", "bake", "linear", "--canonical", "--out", &folder.at("surface-1")]),
        &["nothing was written"],
    );
    assert_eq!(contents(folder.path()), before);
    std::fs::create_dir(folder.path().join("mine")).expect("a folder");
    let note = folder.file("mine/note.txt", "precious");
    has(
        &refused(&["tileset", "bake", "linear", "--canonical", "--out", &folder.at("mine")]),
        &["note.txt", "nothing was written"],
    );
    has(&refused(&["tileset", "bake", "linear", "--canonical", "--out", &note]), &["is a file"]);
    assert_eq!(contents(&folder.path().join("mine")).len(), 1);
}
