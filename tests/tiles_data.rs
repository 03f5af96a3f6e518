//! Tilesets on disk: what is committed is what the generator makes, and every mistake has its own error.
#![allow(clippy::unwrap_used, reason = "a test fails by panicking, in its helpers too")]

use houscaper::cubes::{Mask, admissible_masks};
use houscaper::tiles::*;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

fn root() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("tilesets")
}

fn baked() -> [(&'static str, Vec<BakedFile>); 4] {
    [
        ("surface-1", bake_surface(&Style::SURFACE_1)),
        ("surface-2", bake_surface(&Style::SURFACE_2)),
        ("linear", bake_linear()),
        ("surface-1-offset", bake_surface(&Style::SURFACE_1_OFFSET)),
    ]
}

/// Set HOUSCAPER_BAKE to rewrite the committed files.
#[test]
fn the_committed_files_are_what_the_generator_makes() {
    for (name, files) in baked() {
        let dir = root().join(name);
        if std::env::var_os("HOUSCAPER_BAKE").is_some() {
            write_files(&dir, &files).unwrap();
        }
        for file in &files {
            let text = std::fs::read_to_string(dir.join(&file.name)).unwrap();
            assert_eq!(text, file.text, "{name}/{}", file.name);
        }
        assert_eq!(std::fs::read_dir(&dir).unwrap().count(), files.len(), "no stray files in {name}");
    }
}

#[test]
fn loading_gives_back_the_construction_for_every_configuration() {
    for style in [Style::SURFACE_1, Style::SURFACE_1_OFFSET, Style::SURFACE_2] {
        let set = Tileset::load(&root().join(style.name)).unwrap();
        assert_eq!((set.name(), set.module_mm()), (style.name, CUBE_MM));
        for mask in admissible_masks() {
            let sorted = |mut f: Vec<Facet>| {
                f.sort();
                f
            };
            let loaded = sorted(set.patches(mask).iter().map(|p| p.facet().normalised()).collect());
            let made = sorted(construct(mask, 0, &style).into_iter().map(Facet::normalised).collect());
            assert_eq!(loaded, made, "{} {mask}", style.name);
        }
        assert_eq!(check_tileset(&set), []);
    }
    let linear = LinearTileset::load(&root().join("linear")).unwrap();
    for mask in Mask::all() {
        let expected = if mask.is_admissible() || mask == Mask::FULL { skeleton(mask) } else { Vec::new() };
        assert_eq!(linear.lines(mask), expected);
    }
    assert_eq!(check_linear_tileset(&linear), []);
}

type Files = BTreeMap<String, String>;

fn files(set: usize) -> Files {
    baked()[set].1.iter().map(|f| (f.name.clone(), f.text.clone())).collect()
}

fn from_memory(files: &Files) -> impl Fn(&Path) -> std::io::Result<String> + '_ {
    |path| {
        let name = path.file_name().and_then(|n| n.to_str()).unwrap_or_default();
        files.get(name).cloned().ok_or_else(|| std::io::Error::from(std::io::ErrorKind::NotFound))
    }
}

fn surface(files: &Files) -> Result<Tileset, TilesetError> {
    Tileset::read(Path::new("set"), from_memory(files))
}

/// The error of surface-2 with `old` replaced by `new` once in one file, and that the set is sound without it.
fn mutant(file: &str, old: &str, new: &str) -> TilesetError {
    let mut mutated = files(1);
    assert!(surface(&mutated).is_ok(), "the twin without the mistake loads");
    let text = mutated.get_mut(file).unwrap();
    assert!(text.contains(old), "{file} has no '{old}'");
    *text = text.replacen(old, new, 1);
    surface(&mutated).expect_err("the mistake must be found")
}

fn json_mutant(change: impl Fn(&mut serde_json::Value)) -> Result<Tileset, TilesetError> {
    let mut mutated = files(1);
    assert!(surface(&mutated).is_ok());
    let mut json: serde_json::Value = serde_json::from_str(&mutated[MANIFEST_FILE]).unwrap();
    change(&mut json);
    mutated.insert(MANIFEST_FILE.into(), json.to_string());
    surface(&mutated)
}

#[test]
fn mistakes_in_the_manifest_are_named() {
    let e = mutant(MANIFEST_FILE, "\"unit\": \"mm\"", "\"unit\": \"furlong\"");
    assert!(matches!(&e, TilesetError::Value { key, .. } if key == "unit"), "{e}");
    assert!(e.to_string().contains("set/tileset.json") && e.to_string().contains("furlong"), "{e}");
    let e = mutant(MANIFEST_FILE, "\"up_axis\": \"z\"", "\"up_axis\": \"w\"");
    assert!(matches!(&e, TilesetError::Value { key, .. } if key == "up_axis"), "{e}");
    let e = mutant(MANIFEST_FILE, "\"unit\"", "\"colour\": 1, \"unit\"");
    assert!(matches!(e, TilesetError::Manifest { .. }) && e.to_string().contains("colour"), "{e}");
    assert!(e.to_string().contains("line"), "{e}");
    let e = mutant(MANIFEST_FILE, "houscaper.tileset/1", "houscaper.tileset/9");
    assert!(matches!(&e, TilesetError::Value { key, .. } if key == "schema"), "{e}");
    let e = mutant(MANIFEST_FILE, "\"4\": \"opening\"", "\"4\": \"window\"");
    assert!(matches!(&e, TilesetError::Value { key, .. } if key == "labels"), "{e}");
    let e = mutant(MANIFEST_FILE, "\"11001000\"", "\"1100100\"");
    assert!(matches!(&e, TilesetError::Value { key, .. } if key == "pattern of tile roof-019"), "{e}");
    let e = mutant(MANIFEST_FILE, "\"11001000\"", "\"10010000\"");
    assert!(e.to_string().contains("admissible"), "{e}");
    let e = mutant(MANIFEST_FILE, "900.0", "900.5");
    assert!(matches!(&e, TilesetError::Value { key, .. } if key == "module_size"), "{e}");
    let e = mutant(MANIFEST_FILE, "900.0", "600.0");
    assert!(e.to_string().contains("square in plan"), "{e}");
}

#[test]
fn missing_and_doubled_tiles_are_named() {
    let e = json_mutant(|json| {
        json["tiles"].as_array_mut().unwrap().remove(3);
    })
    .unwrap_err();
    assert!(matches!(e, TilesetError::MissingTile { mask: 15, .. }), "{e}");
    assert!(e.to_string().contains("11110000"), "{e}");
    let e = json_mutant(|json| json["tiles"][1]["pattern"] = "01000000".into()).unwrap_err();
    let TilesetError::Duplicate { first, second, .. } = &e else { panic!("{e}") };
    assert_eq!((first.as_str(), second.as_str()), ("roof-001", "roof-003"));
    let e = json_mutant(|json| json["tiles"][0]["symmetry"]["quarter_turns"] = false.into()).unwrap_err();
    assert!(
        matches!(e, TilesetError::MissingTile { mask: 4, .. }),
        "mirroring reaches 2, turning is needed for 4: {e}"
    );
    let e = json_mutant(|json| json["tiles"][0]["file"] = "nowhere.obj".into()).unwrap_err();
    assert!(matches!(e, TilesetError::Read { .. }) && e.to_string().contains("nowhere.obj"), "{e}");
    let e = json_mutant(|json| json["tiles"][1]["name"] = "roof-001".into()).unwrap_err();
    assert!(e.to_string().contains("name of tile roof-001"), "{e}");
}

#[test]
fn the_corner_order_of_the_manifest_says_how_patterns_are_read() {
    let same = json_mutant(|json| {
        json["corner_order"] = "box_corners".into();
        for tile in json["tiles"].as_array_mut().unwrap() {
            let p: Vec<char> = tile["pattern"].as_str().unwrap().chars().collect();
            tile["pattern"] = [0, 1, 3, 2, 4, 5, 7, 6].map(|n: usize| p[n]).iter().collect::<String>().into();
        }
    });
    assert_eq!(same.unwrap(), surface(&files(1)).unwrap());
}

const TILE: &str = "roof-031.obj";

#[test]
fn mistakes_in_an_obj_file_are_named_with_their_line() {
    let text = &files(1)[TILE];
    let first_face = text.lines().position(|l| l.starts_with('f')).unwrap() + 1;
    let face = text.lines().nth(first_face - 1).unwrap().to_string();

    let e = mutant(TILE, &format!("{face}\n"), "");
    assert!(matches!(e, TilesetError::EndsInside { .. }), "{e}");
    let e = mutant(TILE, &face, &format!("{face}\n{face}"));
    assert!(matches!(e, TilesetError::EdgeTwice { line, .. } if line == first_face + 1), "{e}");
    let turned: Vec<&str> = face.split(' ').skip(1).collect();
    let e = mutant(TILE, &face, &format!("f {}", turned.into_iter().rev().collect::<Vec<_>>().join(" ")));
    assert!(matches!(e, TilesetError::EdgeTwice { .. }), "{e}");
    let e = mutant(TILE, "v 900 ", "v 960 ");
    assert!(matches!(e, TilesetError::LeavesCube { beyond: 60, overhang: 0, .. }), "{e}");
    assert!(e.to_string().contains("roof-031.obj:"), "{e}");
    let e = mutant(TILE, "v 900 ", "v nine ");
    assert!(matches!(e, TilesetError::Obj { .. }) && e.to_string().contains("'nine'"), "{e}");
    let e = mutant(TILE, "v 900 ", "v 900.4 ");
    assert!(e.to_string().contains("whole number of millimetres"), "{e}");
    let e = mutant(TILE, "g roof_o", "g rooof_o");
    assert!(matches!(e, TilesetError::Obj { .. }) && e.to_string().contains("rooof_o"), "{e}");
    let e = mutant(TILE, "g roof_o1", "g roof_o7");
    assert!(e.to_string().contains("a filled octant"), "{e}");
    let e = mutant(TILE, &face, "f 1 2 99");
    assert!(e.to_string().contains("'99'"), "{e}");
    let e = mutant(TILE, &face, "curv 1 2 3");
    assert!(e.to_string().contains("curv"), "{e}");
    let e = mutant(TILE, &face, "f 1 2");
    assert!(e.to_string().contains("2 vertices"), "{e}");
    let e = mutant(TILE, &face, "f 1 1 1");
    assert!(matches!(e, TilesetError::Polygon { .. }), "{e}");
}

/// A box 60 mm outside the cube's face x = 900.
const BOX: &str = "\ng sill_o1\nv 900 0 0\nv 960 0 0\nv 960 90 0\nv 900 90 0\nv 900 0 60\nv 960 0 60\nv 960 90 60\nv 900 90 60\n\
                   f -5 -6 -7 -8\nf -4 -3 -2 -1\nf -8 -7 -3 -4\nf -7 -6 -2 -3\nf -6 -5 -1 -2\nf -5 -8 -4 -1\n";

fn with_sill(overhang: f64, body: &str) -> Result<Tileset, TilesetError> {
    let mut mutated = files(1);
    let mut json: serde_json::Value = serde_json::from_str(&mutated[MANIFEST_FILE]).unwrap();
    json["layers"].as_array_mut().unwrap().push(serde_json::json!(
        {"name": "sill", "kind": "solid", "overhang": overhang}
    ));
    mutated.insert(MANIFEST_FILE.into(), json.to_string());
    mutated.get_mut(TILE).unwrap().push_str(body);
    surface(&mutated)
}

#[test]
fn a_solid_layer_must_be_closed_and_stay_within_its_overhang() {
    let set = with_sill(60.0, BOX).unwrap();
    assert_eq!(set.solids(Mask(31)).len(), 1);
    assert_eq!(set.solids(Mask(31))[0].polygons.len(), 6);
    assert_eq!(set.solids(Mask(15)), []);
    assert!(matches!(with_sill(50.0, BOX), Err(TilesetError::LeavesCube { beyond: 60, overhang: 50, .. })));
    let open = BOX.replacen("f -4 -3 -2 -1\n", "", 1);
    let e = with_sill(60.0, &open).unwrap_err();
    assert!(matches!(&e, TilesetError::OpenSolid { group, .. } if group == "sill_o1"), "{e}");
}

#[test]
fn metres_are_read_as_well_as_millimetres() {
    let mut metres = files(1);
    for (name, text) in &mut metres {
        if name.ends_with(".obj") {
            let scaled = text.lines().map(|l| match l.strip_prefix("v ") {
                Some(v) => format!(
                    "v {}",
                    v.split(' ')
                        .map(|c| (c.parse::<f64>().unwrap() / 1000.0).to_string())
                        .collect::<Vec<_>>()
                        .join(" ")
                ),
                None => l.to_string(),
            });
            *text = scaled.collect::<Vec<_>>().join("\n");
        } else {
            *text = text.replace("\"mm\"", "\"m\"").replace("900.0", "0.9").replace("540.0", "0.54");
        }
    }
    assert_eq!(surface(&metres).unwrap(), surface(&files(1)).unwrap());
}

#[test]
fn mistakes_in_a_linear_set_are_named() {
    let linear = |files: &Files| LinearTileset::read(Path::new("set"), from_memory(files));
    let sound = files(2);
    assert!(linear(&sound).is_ok());
    let mutant = |old: &str, new: &str| {
        let mut mutated = sound.clone();
        let text = mutated.get_mut("wall-017.obj").unwrap();
        assert!(text.contains(old));
        *text = text.replacen(old, new, 1);
        linear(&mutated).unwrap_err().to_string()
    };
    assert!(mutant("g stud_o0", "g strut_o0").contains("strut_o0"));
    assert!(mutant("g stud_o0", "g stud_o9").contains("stud_o9"));
    assert!(mutant("v 450 0 0", "v 450 -10 0").contains("10 mm outside"));
    assert!(mutant("l ", "f 1 2 3\nl ").contains("polygon"));
    let mut wrong = sound.clone();
    let text = wrong[MANIFEST_FILE].replace("\"linear\",\n  \"unit\"", "\"surface\",\n  \"unit\"");
    wrong.insert(MANIFEST_FILE.into(), text);
    assert!(matches!(linear(&wrong), Err(TilesetError::Value { key, .. }) if key == "kind"));
}
