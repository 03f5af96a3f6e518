//! `tileset check` finds everything, says where, and says nothing about sound sets.
#![allow(clippy::unwrap_used, reason = "a test fails by panicking, in its helpers too")]

#[path = "common/bricks.rs"]
mod bricks;

use bricks::{Files, changed};
use houscaper::cubes::{Axis, Mask, needs_tile, reachable_labels};
use houscaper::tiles::check::{Finding, FindingKind, Folder, Report, check, compare_sections, sections};
use houscaper::tiles::{Block, Component};
use houscaper::voxels::Label;
use serde_json::json;

fn report(files: &Files) -> Report {
    check(&Folder::in_memory(files.clone()), None)
}

fn of(files: &Files, kind: FindingKind) -> Vec<Finding> {
    report(files).findings.into_iter().filter(|f| f.kind == kind).collect()
}

/// The set of bricks with one file changed.
fn with(file: &str, text: &str) -> Files {
    let mut files = bricks::set();
    assert!(files.insert(file.into(), text.into()).is_some());
    files
}

#[test]
fn a_complete_set_of_bricks_is_clean() {
    let report = report(&bricks::set());
    assert_eq!(report.findings, []);
    let coverage = report.coverage.unwrap();
    assert_eq!(coverage.reachable, reachable_labels().iter().filter(|l| needs_tile(l)).count());
    assert_eq!(coverage.covered, coverage.reachable);
}

#[test]
fn an_inside_out_brick_is_found_with_its_line() {
    let text = &bricks::set()["brick-001.obj"];
    let turned: String = text
        .lines()
        .map(|l| match l.strip_prefix("f ") {
            Some(f) => format!("f {}\n", f.split(' ').rev().collect::<Vec<_>>().join(" ")),
            None => format!("{l}\n"),
        })
        .collect();
    let found = of(&with("brick-001.obj", &turned), FindingKind::InsideOut);
    assert_eq!(found.len(), 1);
    assert_eq!((found[0].tiles.as_slice(), found[0].line), (["brick-001".to_owned()].as_slice(), Some(11)));
}

#[test]
fn an_open_brick_is_found_with_its_line() {
    let text = bricks::set()["brick-003.obj"].replacen("f 5 6 8 7\n", "", 1);
    let found = of(&with("brick-003.obj", &text), FindingKind::Open);
    assert_eq!(found.len(), 1, "{found:?}");
    assert!(found[0].line.is_some() && found[0].message.contains("wall_o0"));
}

#[test]
fn bricks_that_cut_each_other_are_found_and_touching_ones_are_not() {
    let cube = |name: &str, low: [f64; 3], high: [f64; 3]| (name.to_owned(), low, high);
    let base = cube("wall_o0", [0.0; 3], [450.0, 450.0, 270.0]);
    let touching = bricks::boxes(&[base.clone(), cube("wall_o1", [100.0, 100.0, 270.0], [200.0, 200.0, 300.0])]);
    let cutting = bricks::boxes(&[base, cube("wall_o1", [100.0, 100.0, 100.0], [200.0, 200.0, 300.0])]);
    assert_eq!(of(&with("brick-001.obj", &touching), FindingKind::Crossing), []);
    let found = of(&with("brick-001.obj", &cutting), FindingKind::Crossing);
    assert_eq!(found.len(), 1);
    assert!(found[0].message.contains("wall_o0") && found[0].message.contains("wall_o1"));
}

#[test]
fn parts_outside_the_cube_need_a_declared_overhang() {
    let cube = ("wall_o0".to_owned(), [0.0; 3], [450.0, 450.0, 270.0]);
    let fin = ("wall_o0".to_owned(), [460.0, 460.0, -50.0], [470.0, 470.0, 100.0]);
    let files = with("brick-001.obj", &bricks::boxes(&[cube, fin]));
    let found = of(&files, FindingKind::OutOfCube);
    assert_eq!(found.len(), 1);
    assert!(found[0].message.contains("50 mm outside"), "{}", found[0].message);
    let declared = changed(&files, |m| m["layers"][0]["overhang"] = json!(50));
    assert_eq!(of(&declared, FindingKind::OutOfCube), []);
}

#[test]
fn a_seam_names_face_neighbour_and_outline() {
    let mut low = bricks::bricks(Mask(17));
    low = low.replace("450", "440");
    let found = of(&with("brick-017.obj", &low), FindingKind::Seam);
    assert!(!found.is_empty());
    for finding in &found {
        assert_eq!(finding.tiles[0], "brick-017", "{}", finding.message);
        assert!(finding.neighbour.is_some() && finding.face.is_some());
        assert!(!finding.only_first.is_empty() || !finding.only_second.is_empty());
    }
    assert!(found.iter().any(|f| f.only_first.iter().any(|e| e.contains("440"))));
}

#[test]
fn missing_duplicate_and_unused_are_all_reported_at_once() {
    let files = changed(&bricks::set(), |m| {
        let tiles = m["tiles"].as_array_mut().unwrap();
        tiles.retain(|t| t["name"] != "brick-015" && t["name"] != "brick-240");
        let mut twin = tiles[0].clone();
        twin["name"] = "twin".into();
        tiles.push(twin);
    });
    let report = report(&files);
    let of = |kind| report.findings.iter().filter(|f| f.kind == kind).collect::<Vec<_>>();
    assert_eq!(of(FindingKind::Missing).len(), 2);
    assert_eq!(of(FindingKind::UnusedFile).len(), 2);
    let double = of(FindingKind::Duplicate);
    assert_eq!(double.len(), 1);
    assert_eq!(double[0].tiles, ["twin", "brick-001"]);
    assert!(double[0].line.is_some(), "the line in the manifest");
    assert!(report.coverage.is_some_and(|c| c.covered < c.reachable));
}

/// The other order of corners is named first, for shipped sets of every kind, and never for a set that states the right one.
#[test]
fn corners_in_another_order_are_named_first() {
    let shipped = |name: &str| {
        let dir = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("tilesets").join(name);
        let file = |entry: std::fs::DirEntry| {
            (entry.file_name().into_string().unwrap(), std::fs::read_to_string(entry.path()).unwrap())
        };
        std::fs::read_dir(dir).unwrap().map(|entry| file(entry.unwrap())).collect::<Files>()
    };
    for set in [bricks::set(), shipped("surface-1"), shipped("surface-2"), shipped("linear")] {
        assert!(of(&set, FindingKind::CornerOrder).is_empty());
        let other = changed(&set, |m| m["corner_order"] = "box_corners".into());
        let first = report(&other).findings.remove(0);
        assert_eq!(first.kind, FindingKind::CornerOrder, "{}", first.message);
        assert!(first.message.contains("f_order"), "{}", first.message);
    }
}

/// A style that cannot be built says so and counts nothing.
#[test]
fn a_mistaken_style_is_not_counted() {
    let style = |wall: &str| {
        let text = format!(r#"{{"schema": "houscaper.tileset/1", "kind": "style", "name": "mine", "{wall}": {{}}}}"#);
        Files::from([("tileset.json".into(), text)])
    };
    let report = report(&style("no such key"));
    assert!(!report.is_clean());
    assert_eq!(report.coverage, None);
}

#[test]
fn a_set_on_its_side_and_a_displaced_one_are_told_why() {
    let turned = |f: fn([f64; 3]) -> [f64; 3]| {
        let mut files = bricks::set();
        for (_, text) in files.iter_mut().filter(|(name, _)| name.ends_with(".obj")) {
            let line = |l: &str| match l.strip_prefix("v ") {
                Some(v) => {
                    let c: Vec<f64> = v.split(' ').map(|c| c.parse().unwrap()).collect();
                    let [x, y, z] = f([c[0], c[1], c[2]]);
                    format!("v {x} {y} {z}\n")
                }
                None => format!("{l}\n"),
            };
            *text = text.lines().map(line).collect();
        }
        files
    };
    let lying = turned(|[x, y, z]| [x, z, -y]);
    assert!(of(&lying, FindingKind::UpAxis).len() == 1, "{:?}", report(&lying).findings.first());
    assert!(of(&lying, FindingKind::UpAxis)[0].message.contains("states \"up_axis\": \"z\", state \"y\""));
    // Files with z up that are stated to have y up: the advice never repeats what is stated.
    let upright = changed(&bricks::set(), |m| m["up_axis"] = "y".into());
    let advice = of(&upright, FindingKind::UpAxis).remove(0).message;
    assert!(advice.contains("states \"up_axis\": \"y\", state \"z\""), "{advice}");
    let stated = changed(&lying, |m| m["up_axis"] = "y".into());
    assert_eq!(report(&stated).findings, []);
    let centred = turned(|[x, y, z]| [x - 450.0, y - 450.0, z - 270.0]);
    assert_eq!(of(&centred, FindingKind::Pivot).len(), 1);
    let stated = changed(&centred, |m| m["pivot"] = "centre".into());
    assert_eq!(report(&stated).findings, []);
}

#[test]
fn sections_of_an_override_are_compared_with_the_style() {
    let size = [900_000, 900_000, 540_000];
    let show = |list: &[Block]| {
        let faces: Vec<_> = list.iter().map(|b| (b.component, b.faces())).collect();
        sections(faces.iter().map(|(c, f)| (*c, f)), size)
    };
    let wall = Block::cuboid(Component::Cladding, 0, [0, 0, 0], [900_000, 450_000, 540_000]);
    let parts = [
        Block::cuboid(Component::Cladding, 0, [0, 0, 0], [300_000, 450_000, 540_000]),
        Block::cuboid(Component::Cladding, 0, [300_000, 0, 0], [900_000, 450_000, 540_000]),
    ];
    let thin = Block::cuboid(Component::Cladding, 0, [0, 0, 0], [900_000, 440_000, 540_000]);
    assert_eq!(compare_sections("o", "k", &show(&parts), &show(std::slice::from_ref(&wall))), []);
    let found = compare_sections("o", "k", &show(&[thin]), &show(&[wall]));
    assert_eq!(found.len(), 4, "both x faces and both z faces; nothing differs at y = 0");
    assert_eq!(found[0].face.as_deref(), Some(Axis::X.name()));
    assert!(found[0].only_first.iter().any(|e| e.contains("cladding y 440")), "{:?}", found[0].only_first);
}

#[test]
fn json_has_coverage_and_findings() {
    let report = report(&with("brick-001.obj", "f 1 2 3\n"));
    let json = serde_json::to_value(&report).unwrap();
    assert_eq!(json.as_object().unwrap().keys().collect::<Vec<_>>(), ["coverage", "findings"]);
    let finding = &json["findings"][0];
    assert_eq!((finding["kind"].as_str(), finding["line"].as_u64()), (Some("obj"), Some(1)));
    assert_eq!(finding["tiles"], json!(["brick-001"]));
}

/// An OBJ text with all lengths from the cube's first corner made smaller.
fn shrunk(text: &str) -> String {
    let line = |l: &str| match l.strip_prefix("v ") {
        Some(v) => {
            let at: Vec<String> = v.split(' ').map(|c| (c.parse::<f64>().unwrap() * 0.9).to_string()).collect();
            format!("v {}\n", at.join(" "))
        }
        None => format!("{l}\n"),
    };
    text.lines().map(line).collect()
}

#[test]
fn a_tile_for_labels_that_houses_never_show_is_compared_too() {
    let pattern = "01010401";
    let never = pattern.chars().map(|c| Label::from_code(c as u8 - b'0').unwrap()).collect::<Vec<_>>();
    assert!(!houscaper::cubes::reachable_labels().iter().any(|l| l[..] == never[..]));
    let with = |text: String| {
        let mut files = bricks::changed(&bricks::set(), |m| {
            let tile = json!({"name": "odd", "pattern": pattern, "file": "odd.obj", "priority": 1});
            m["tiles"].as_array_mut().unwrap().push(tile);
        });
        files.insert("odd.obj".into(), text);
        check(&Folder::in_memory(files), None).findings
    };
    let mask = Mask(0b1010_1010);
    assert_eq!(with(bricks::bricks(mask)), []);
    let found = with(shrunk(&bricks::bricks(mask)));
    assert!(found.iter().any(|f| f.kind == FindingKind::Seam && f.tiles.contains(&"odd".to_owned())), "{found:?}");
}

#[test]
fn a_tile_that_does_not_reach_a_face_is_named_even_where_differences_are_accepted() {
    let accepted = bricks::changed(&bricks::set(), |m| m["open_seams"] = json!(["x 1100", "y 1100", "z 1111"]));
    assert_eq!(check(&Folder::in_memory(accepted.clone()), None).findings, []);
    let mut files = accepted;
    files.insert("brick-015.obj".into(), shrunk(&bricks::bricks(Mask(15))));
    let found = check(&Folder::in_memory(files), None).findings;
    let mut faces: Vec<&str> = found.iter().filter_map(|f| f.face.as_deref()).collect();
    faces.dedup();
    assert_eq!(faces, ["x", "y"], "{found:?}");
    for finding in &found {
        assert_eq!(finding.tiles[0], "brick-015");
        assert!(finding.kind == FindingKind::Seam && finding.neighbour.is_some(), "{finding:?}");
        assert!(finding.only_first.is_empty() && !finding.only_second.is_empty(), "{finding:?}");
    }
}
