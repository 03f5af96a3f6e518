//! The designers' format: units, axes, pivots, label tables, patterns, variants, priorities, styles.
#![allow(clippy::unwrap_used, reason = "a test fails by panicking, in its helpers too")]

#[path = "common/bricks.rs"]
mod bricks;

use bricks::{Files, changed, manifest};
use houscaper::cubes::{CornerOrder, CubeKey, Mask, ThesisId};
use houscaper::tiles::*;
use houscaper::voxels::{Label, VoxelArray};
use serde_json::json;
use std::path::{Path, PathBuf};

fn reader(files: &Files) -> impl Fn(&Path) -> std::io::Result<String> + '_ {
    |path| {
        let name = path.file_name().and_then(|n| n.to_str()).unwrap_or_default();
        files.get(name).cloned().ok_or_else(|| std::io::ErrorKind::NotFound.into())
    }
}

fn solids(files: &Files) -> Result<LabelSet, TilesetError> {
    LabelSet::read(Path::new("set"), None, reader(files))
}

fn key(digits: &str) -> CubeKey {
    let labels: Vec<Label> = digits.bytes().map(|d| Label::from_code(d - b'0').unwrap()).collect();
    CubeKey::of_labels(labels.try_into().unwrap())
}

fn shipped(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tilesets").join(name)
}

#[test]
fn the_published_schema_is_the_types_schema() {
    let published: serde_json::Value = serde_json::from_str(include_str!("../configs/tileset.schema.json")).unwrap();
    assert_eq!(published, tileset_schema(), "run `houscaper schema tileset > configs/tileset.schema.json`");
    let text = published.to_string();
    for word in ["x,z,-y", "priority", "variants", "overhang_mm", "roof_covering", "box_corners"] {
        assert!(text.contains(word), "{word}");
    }
}

#[test]
fn metres_y_up_centred_and_box_corners_are_the_same_set() {
    let dir = shipped("surface-2");
    let plain = Tileset::load(&dir).unwrap();
    let mut files = Files::new();
    for entry in std::fs::read_dir(&dir).unwrap().flatten() {
        let text = std::fs::read_to_string(entry.path()).unwrap();
        let name = entry.file_name().into_string().unwrap();
        let turned = text.lines().map(|l| match l.strip_prefix("v ") {
            Some(v) => {
                let c: Vec<f64> = v.split(' ').map(|c| c.parse().unwrap()).collect();
                // Right, up, towards the viewer.
                format!("v {} {} {}", (c[0] - 450.0) / 1e3, (c[2] - 270.0) / 1e3, (450.0 - c[1]) / 1e3)
            }
            None => l.to_string(),
        });
        files.insert(
            name,
            if entry.path().extension().is_some_and(|e| e == "obj") {
                turned.collect::<Vec<_>>().join("\n")
            } else {
                text.clone()
            },
        );
    }
    let files = changed(&files, |m| {
        m["unit"] = "m".into();
        m["module_size"] = json!([0.9, 0.9, 0.54]);
        m["up_axis"] = "x,z,-y".into();
        m["pivot"] = "centre".into();
        m["corner_order"] = "box_corners".into();
        for tile in m["tiles"].as_array_mut().unwrap() {
            let p: Vec<char> = tile["pattern"].as_str().unwrap().chars().collect();
            tile["pattern"] = [0, 1, 3, 2, 4, 5, 7, 6].map(|n: usize| p[n]).iter().collect::<String>().into();
        }
    });
    assert_eq!(Tileset::read(Path::new("set"), reader(&files)).unwrap(), plain);
    // An explicit pivot says the same as its name.
    let explicit = changed(&files, |m| m["pivot"] = json!([0.45, 0.45, 0.27]));
    assert_eq!(Tileset::read(Path::new("set"), reader(&explicit)).unwrap(), plain);
    let wrong = changed(&files, |m| m["pivot"] = "middle".into());
    let e = Tileset::read(Path::new("set"), reader(&wrong)).unwrap_err();
    assert!(matches!(&e, TilesetError::Value { key, .. } if key == "pivot"), "{e}");
}

#[test]
fn mirrored_axes_keep_solids_outward() {
    let exchanged = |turn_faces: bool| {
        let mut files = bricks::set();
        for (_, text) in files.iter_mut().filter(|(name, _)| name.ends_with(".obj")) {
            let line = |l: &str| {
                let mut words: Vec<&str> = l.split(' ').collect();
                match words[0] {
                    "v" => words.swap(1, 2),
                    "f" if turn_faces => words[1..].reverse(),
                    _ => {}
                }
                words.join(" ")
            };
            *text = text.lines().map(line).collect::<Vec<_>>().join("\n");
        }
        solids(&changed(&files, |m| m["up_axis"] = "y,x,z".into()))
    };
    assert_eq!(exchanged(true).unwrap(), solids(&bricks::set()).unwrap());
    assert!(matches!(exchanged(false), Err(TilesetError::InsideOut { .. })), "inside out in the file, inside out here");
}

/// A set of one open corner tile with the given tiles claiming it.
fn claiming(tiles: &[(&str, &str, i32)]) -> Files {
    let mut files = Files::new();
    let entries = tiles
        .iter()
        .map(|(name, pattern, priority)| {
            files.insert(format!("{name}.obj"), bricks::bricks(Mask(17)));
            json!({"name": name, "pattern": pattern, "file": format!("{name}.obj"), "priority": priority})
        })
        .collect();
    files.insert("tileset.json".into(), manifest(entries).to_string());
    files
}

#[test]
fn priority_decides_and_equal_claims_name_both_tiles() {
    let set = solids(&claiming(&[("wall", "*000*000", 0), ("window", "*000[45]000", 1)])).unwrap();
    let name = |digits: &str| set.tile(key(digits)).map(|t| t.name.clone());
    assert_eq!(name("10001000").as_deref(), Some("wall"));
    assert_eq!(name("10005000").as_deref(), Some("window"));
    assert_eq!(name("11001100"), None);
    let e = solids(&claiming(&[("wall", "*000*000", 0), ("window", "*000[45]000", 0)])).unwrap_err();
    let TilesetError::Duplicate { first, second, configuration, .. } = &e else { panic!("{e}") };
    assert_eq!((first.as_str(), second.as_str(), configuration.as_str()), ("wall", "window", "10004000"));
    assert!(solids(&claiming(&[("wall", "*000[123]000", 0), ("window", "*000[45]000", 0)])).is_ok());
}

#[test]
fn a_permuted_label_table_is_converted() {
    let files = claiming(&[("window", "10004000", 0)]);
    assert!(solids(&files).unwrap().tile(key("10004000")).is_some());
    let swapped = changed(&files, |m| {
        m["labels"]["4"] = "window".into();
        m["labels"]["5"] = "opening".into();
    });
    let set = solids(&swapped).unwrap();
    assert!(set.tile(key("10005000")).is_some() && set.tile(key("10004000")).is_none());
}

#[test]
fn symmetry_carries_bodies_exactly() {
    let set = solids(&bricks::set()).unwrap();
    for mask in Mask::all().filter(|m| m.is_admissible()) {
        let digits = mask.pattern();
        let tile = set.tile(key(&digits)).unwrap();
        let octants: u8 = tile.bodies.iter().fold(0, |m, b| m | 1 << b.octant);
        assert_eq!(octants, mask.0, "{mask}");
        for body in &tile.bodies {
            assert!((body.volume_m3() - 0.45 * 0.45 * 0.27).abs() < 1e-15, "outward in every placement");
            let corner = [0, 1, 2].map(|a| i32::from(body.octant >> a & 1) * [900_000, 900_000, 540_000][a]);
            assert!(body.polygons.iter().flatten().any(|p| *p == corner), "{mask}: the brick stands at its corner");
        }
    }
}

#[test]
fn variants_are_chosen_by_place_alone() {
    let mut files = claiming(&[("wall", "*000*000", 0)]);
    files.insert("other.obj".into(), bricks::bricks(Mask(1)));
    let files = changed(&files, |m| m["tiles"][0]["variants"] = json!(["other.obj"]));
    let set = solids(&files).unwrap();
    let variant = |cube| set.tile_at(key("10001000"), cube).unwrap().variant;
    let row: Vec<usize> = (0..64).map(|i| variant([i, 2, 3])).collect();
    assert_eq!(row, (0..64).map(|i| variant([i, 2, 3])).collect::<Vec<_>>());
    let second = row.iter().filter(|v| **v == 1).count();
    assert!((16..=48).contains(&second), "{second} of 64 are the second variant");
    assert_eq!(set.tile(key("10001000")).unwrap().variant, 0);
}

#[test]
fn cubes_without_a_tile_are_listed_with_place_labels_and_id() {
    let mut voxels = VoxelArray::new([1, 1, 1]);
    voxels.set([0, 0, 0], Label::Window);
    let whole = solids(&bricks::set()).unwrap();
    assert_eq!(whole.missing_in(&voxels), []);
    let files = changed(&bricks::set(), |m| {
        m["tiles"].as_array_mut().unwrap().retain(|t| t["name"] != "brick-016");
    });
    let missing = solids(&files).unwrap().missing_in(&voxels);
    assert_eq!(missing.iter().map(|m| m.cube).collect::<Vec<_>>(), [[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0]]);
    assert_eq!(missing[0].thesis_id, ThesisId::new(&missing[0].labels, CornerOrder::FOrder));
    assert_eq!(missing[0].thesis_id.0, 5, "the window is the last corner");
}

#[test]
fn the_shipped_styles_load_with_a_look_for_every_component() {
    let pitched = StyleSet::load(&shipped("architectural")).unwrap();
    let level = StyleSet::load(&shipped("larch")).unwrap();
    for set in [&pitched, &level] {
        let components: Vec<Component> = set.palette.iter().map(|(c, _)| *c).collect();
        assert_eq!(components, Component::ALL, "{}", set.name);
        assert!(set.overrides.placed_tiles().is_empty());
        assert_eq!(set.rule, TileRule::B);
    }
    assert_eq!((pitched.name.as_str(), level.name.as_str()), ("architectural", "larch"));
    assert!(pitched.style.gutter && !level.style.gutter);
    assert_eq!((level.style.parapet_um, level.style.overhang_um), (450_000, 60_000));
    assert_ne!(pitched.palette, level.palette);
}

#[test]
fn mistakes_of_a_style_name_their_key() {
    let text = std::fs::read_to_string(shipped("larch").join("tileset.json")).unwrap();
    let files = Files::from([("tileset.json".to_owned(), text)]);
    let load = |files: &Files| StyleSet::read(Path::new("set"), reader(files));
    assert!(load(&files).is_ok());
    let key_of = |change: &dyn Fn(&mut serde_json::Value)| match load(&changed(&files, change)).unwrap_err() {
        TilesetError::Value { key, .. } => key,
        other => other.to_string(),
    };
    assert_eq!(key_of(&|m| m["style"]["overhang_mm"] = json!(900)), "style.overhang_mm");
    assert_eq!(key_of(&|m| m["palette"]["cladding"]["srgb"] = json!("brown")), "palette.cladding.srgb");
    assert_eq!(key_of(&|m| m["palette"]["bark"] = m["palette"]["glass"].clone()), "palette.bark");
    assert_eq!(key_of(&|m| m["module_size"] = json!([600, 600, 540])), "module_size");
    assert!(key_of(&|m| m["style"]["colour"] = json!(1)).contains("colour"));
}
