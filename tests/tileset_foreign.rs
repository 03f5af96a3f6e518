//! Sets that others made: topoGenesis's 256 chamfered tiles, and manifests of schema houscaper.architectural-tiles/1.
#![allow(clippy::unwrap_used, reason = "a test fails by panicking, in its helpers too")]

use houscaper::cubes::{CubeKey, Mask};
use houscaper::tiles::check::{Finding, FindingKind, Folder, check};
use houscaper::tiles::*;
use houscaper::voxels::Label;
use serde_json::{Value, json};
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

fn data(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data/tilesets").join(name)
}

fn shipped(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tilesets").join(name)
}

fn topogenesis() -> Option<PathBuf> {
    let shared = std::env::var_os("HOUSCAPER_SHARED").map(PathBuf::from);
    let dir = shared.map(|s| s.join("reference/tilesets/topogenesis-chamfer")).filter(|d| d.is_dir());
    if dir.is_none() {
        eprintln!("skipped: HOUSCAPER_SHARED has no reference/tilesets/topogenesis-chamfer");
    }
    dir
}

fn of_mask(mask: Mask, label: Label) -> CubeKey {
    CubeKey::of_labels(std::array::from_fn(|n| if mask.0 >> n & 1 == 1 { label } else { Label::Empty }))
}

#[test]
fn topogenesis_tiles_stand_where_their_number_says() {
    let Some(root) = topogenesis() else { return };
    let set = LabelSet::load_from(&shipped("topogenesis"), Some(&root)).unwrap();
    for mask in Mask::all().filter(|m| *m != Mask::EMPTY) {
        let tile = set.tile(of_mask(mask, Label::Window)).unwrap();
        assert_eq!(tile.name, format!("Tile_{:03}", mask.0));
        // Every solid octant holds the cube's own corner, and no vertex is nearest to an empty corner only.
        let points: Vec<[i32; 3]> = tile.bodies.iter().flat_map(|b| b.polygons.iter().flatten().copied()).collect();
        for octant in 0..8u8 {
            let corner = [0, 1, 2].map(|a| i32::from(octant >> a & 1) * [900_000, 900_000, 540_000][a]);
            assert_eq!(points.contains(&corner), mask.0 >> octant & 1 == 1, "{mask} corner {octant}");
        }
        assert!(tile.bodies.iter().all(|b| b.volume_m3() > 0.0));
    }
    let full: f64 = set.tile(of_mask(Mask::FULL, Label::Base)).unwrap().bodies.iter().map(Body::volume_m3).sum();
    assert!((full - 0.9 * 0.9 * 0.54).abs() < 1e-12);
}

fn findings(root: &Path, change: impl Fn(&mut Value)) -> Vec<Finding> {
    let text = std::fs::read_to_string(shipped("topogenesis").join("tileset.json")).unwrap();
    let mut manifest: Value = serde_json::from_str(&text).unwrap();
    change(&mut manifest);
    let mut files = BTreeMap::from([("tileset.json".to_owned(), manifest.to_string())]);
    for id in 0..256 {
        let name = format!("Tile_{id:03}.obj");
        files.insert(name.clone(), std::fs::read_to_string(root.join(name)).unwrap());
    }
    check(&Folder::in_memory(files), None).findings
}

#[test]
fn topogenesis_is_sound_and_its_conventions_are_checked() {
    let Some(root) = topogenesis() else { return };
    let report = check(&Folder::open(&shipped("topogenesis"), Some(&root)), None);
    assert_eq!(report.findings, []);
    let coverage = report.coverage.expect("a set of meshes is counted");
    assert_eq!(coverage.covered, coverage.reachable);
    assert!(coverage.reachable > 1_900, "{}", coverage.reachable);
    let first = |change: &dyn Fn(&mut Value)| findings(&root, change).into_iter().next().unwrap();
    let unit = first(&|m| m["unit"] = "mm".into());
    assert_eq!(unit.kind, FindingKind::Unit);
    assert!(unit.message.contains("\"cube\""), "{}", unit.message);
    let order = first(&|m| m["corner_order"] = "box_corners".into());
    assert_eq!((order.kind, order.key.as_deref()), (FindingKind::CornerOrder, Some("corner_order")));
    let lying = first(&|m| m["up_axis"] = "y".into());
    assert_eq!((lying.kind, lying.key.as_deref()), (FindingKind::UpAxis, Some("up_axis")));
    let pivot = first(&|m| m["pivot"] = "corner".into());
    assert_eq!(pivot.kind, FindingKind::Pivot, "{}", pivot.message);
    assert!(pivot.message.contains("\"centre\""), "{}", pivot.message);
}

#[test]
fn architectural_manifests_are_converted() {
    let dir = data("foreign");
    let text = std::fs::read_to_string(dir.join("tileset.json")).unwrap();
    let (manifest, mistakes) = convert(&text, &dir).unwrap();
    assert!(mistakes.is_empty(), "{mistakes:?}");
    assert_eq!(manifest.tiles.len(), 2, "the two windows are variants of one tile");
    let set = LabelSet::load(&dir).unwrap();
    // Corners are listed round the base: 1 1 0 0 are the two front ones in either order.
    let labels = |digits: [u8; 8]| CubeKey::of_labels(digits.map(|d| Label::from_code(d).unwrap()));
    let window = set.tile(labels([2, 2, 0, 0, 5, 5, 0, 0])).unwrap();
    let components: Vec<Component> = window.bodies.iter().map(|b| b.component).collect();
    assert_eq!(components, [Component::WindowFrame, Component::Glass, Component::FloorStructure]);
    let wall = set.tile(labels([1, 1, 0, 0, 1, 1, 0, 0])).unwrap();
    let volume: f64 = wall.bodies.iter().map(Body::volume_m3).sum();
    assert!((volume - 0.9 * 0.3 * 0.54).abs() < 1e-12);
    assert!(wall.bodies.iter().flat_map(|b| b.polygons.iter().flatten()).all(|p| (0..=900_000).contains(&p[0])));
    // What is not there is said, not silently empty.
    let report = check(&Folder::open(&dir, None), None);
    assert!(report.coverage.is_some_and(|c| c.covered < c.reachable));
    assert!(report.findings.iter().any(|f| f.kind == FindingKind::Missing));
    assert!(report.findings.iter().all(|f| f.kind != FindingKind::Manifest && f.kind != FindingKind::Obj));
}

#[test]
fn the_web_form_of_the_same_tiles_is_the_same_set() {
    let dir = data("foreign");
    let plain = LabelSet::load(&dir).unwrap();
    let read = |path: &Path| -> std::io::Result<String> {
        let text = std::fs::read_to_string(path)?;
        if path.extension().is_some_and(|e| e == "json") {
            let mut json: Value = serde_json::from_str(&text).unwrap();
            json["files"] = "web".into();
            return Ok(json.to_string());
        }
        let turned = text.lines().map(|l| match l.strip_prefix("v ") {
            Some(v) => {
                let c: Vec<f64> = v.split(' ').map(|c| c.parse::<f64>().unwrap() / 1000.0).collect();
                format!("v {} {} {}", c[0], c[2], -c[1])
            }
            None => l.to_owned(),
        });
        Ok(turned.collect::<Vec<_>>().join("\n"))
    };
    let web = LabelSet::read(&dir, None, read).unwrap();
    for (a, b) in plain.placed_tiles().iter().zip(web.placed_tiles()) {
        assert_eq!(a, b);
    }
}

#[test]
fn missing_fields_and_unknown_groups_are_reported() {
    let dir = data("foreign");
    let text = std::fs::read_to_string(dir.join("tileset.json")).unwrap();
    let problems = |change: &dyn Fn(&mut Value)| -> String {
        let mut json: Value = serde_json::from_str(&text).unwrap();
        change(&mut json);
        let (_, mistakes) = convert(&json.to_string(), &dir).unwrap();
        mistakes.iter().map(ToString::to_string).collect::<Vec<_>>().join("\n")
    };
    assert_eq!(problems(&|_| {}), "");
    for (key, parts) in [
        ("moduleSize", "moduleSize: is missing"),
        ("cornerOrder", "cornerOrder: is missing"),
        ("tiles", "tiles: is missing"),
    ] {
        assert!(problems(&|m| m[key] = Value::Null).contains(parts), "{key}");
    }
    assert!(problems(&|m| m["source"] = json!({})).contains("source.unit: is missing"));
    assert!(problems(&|m| m["web"]["axisTransform"] = json!("x,z")).contains("web.axisTransform"));
    for (key, parts) in [
        ("signature", "signature of tile wall"),
        ("file", "file of tile wall"),
        ("pivot", "pivot of tile wall"),
        ("size", "size of tile wall"),
        ("id", "tiles[0].id"),
    ] {
        assert!(problems(&|m| m["tiles"][0][key] = Value::Null).contains(parts), "{key}");
    }
    assert!(problems(&|m| m["tiles"][0]["signature"] = json!("1100110x")).contains("eight digits"));

    let mut files: BTreeMap<String, String> = ["tileset.json", "wall.obj", "window.obj", "window-b.obj"]
        .into_iter()
        .map(|f| (f.to_owned(), std::fs::read_to_string(dir.join(f)).unwrap()))
        .collect();
    let renamed = files["window.obj"].replace("arc_glass_1", "mystery_1");
    files.insert("window.obj".into(), renamed);
    let report = check(&Folder::in_memory(files), None);
    let unknown: Vec<&Finding> = report.findings.iter().filter(|f| f.kind == FindingKind::Obj).collect();
    assert_eq!(unknown.len(), 1);
    assert!(unknown[0].message.contains("mystery_1") && unknown[0].line.is_some());
    assert_eq!(unknown[0].tiles, ["window"]);
}
