//! Houses drawn by sets of meshes: what stands where, what is missing, and what foreign sets make of a house.
#![allow(clippy::unwrap_used, reason = "a test fails by panicking, in its helpers too")]

#[path = "common/bricks.rs"]
mod bricks;
#[path = "common/cli.rs"]
mod cli;

use std::path::{Path, PathBuf};

use bricks::Files;
use houscaper::cubes::{cube_labels, cube_shape};
use houscaper::envelope::{CUBE_UM, CubeTile, Fabric};
use houscaper::export::{Palette, Storeys, from_fabric};
use houscaper::price::Books;
use houscaper::score::Tiling;
use houscaper::tiles::Component;
use houscaper::voxels::{House, read_storeys, samples};
use serde_json::{Value, json};

fn repository(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join(name)
}

fn tiling(dir: &Path, root: Option<&Path>) -> Tiling {
    Tiling::load_from(dir, root, &Books::load(&repository("configs")).unwrap()).unwrap()
}

fn written(scratch: &cli::Scratch, name: &str, files: &Files) -> PathBuf {
    let dir = scratch.path().join(name);
    std::fs::create_dir(&dir).unwrap();
    files.iter().for_each(|(file, text)| std::fs::write(dir.join(file), text).unwrap());
    dir
}

fn fabric(tiling: &Tiling, house: &House) -> Fabric {
    tiling.fabric(house, &read_storeys(house)).unwrap()
}

fn houses() -> Vec<(&'static str, House)> {
    samples::all().into_iter().chain(samples::gallery()).collect()
}

/// The 26 bricks and the full cube, carried by mirrors and turns, fill the voxels of every house: nothing is turned inside out,
/// nothing stands in the wrong octant.
#[test]
fn bricks_fill_the_voxels_under_every_symmetry() {
    let scratch = cli::Scratch::new();
    let set = tiling(&written(&scratch, "bricks", &bricks::set()), None);
    let voxel: i128 = CUBE_UM.iter().map(|&c| i128::from(c)).product::<i128>() * 6;
    let (mut mirrored, mut turns) = (0, [0; 4]);
    for tile in set.meshes.as_ref().unwrap().placed_tiles() {
        mirrored += usize::from(tile.symmetry.mirror);
        turns[usize::from(tile.symmetry.turns)] += 1;
    }
    assert!(mirrored > 0 && turns.iter().all(|&n| n > 0), "{mirrored} {turns:?}");
    for (name, house) in houses() {
        let fabric = fabric(&set, &house);
        assert!(set.missing(&house.voxels).is_empty(), "{name}");
        let filled = voxel * house.voxels.filled_count() as i128;
        assert_eq!(fabric.six_volumes()[Component::Cladding as usize], filled, "{name}");
        assert!(fabric.six_volumes_by_voxel().values().all(|&v| v == voxel), "{name}: an octant in the wrong voxel");
        for (_, gathered) in fabric.gather_groups(|p| p.layer).unwrap() {
            assert_eq!(gathered.apart, None, "{name}");
            assert_eq!(gathered.solid.six_volumes(), filled, "{name}");
            assert_eq!(gathered.solid.report().open_edges, 0, "{name}");
        }
    }
}

/// A set for another module is stretched to the house's.
#[test]
fn another_module_is_stretched() {
    let scratch = cli::Scratch::new();
    let large = bricks::changed(&bricks::set(), |m| {
        m["unit"] = "m".into();
        m["module_size"] = json!([0.9, 0.9, 0.54]);
    });
    let scaled = |text: &String, factor: f64| -> String {
        let line = |l: &str| match l.strip_prefix("v ") {
            Some(v) => {
                let at: Vec<String> = v.split(' ').map(|c| (c.parse::<f64>().unwrap() * factor).to_string()).collect();
                format!("v {}", at.join(" "))
            }
            None => l.to_owned(),
        };
        text.lines().map(|l| line(l) + "\n").collect()
    };
    let of = |files: &Files, factor: f64| -> Files {
        files
            .iter()
            .map(|(n, t)| (n.clone(), if n.ends_with(".obj") { scaled(t, factor) } else { t.clone() }))
            .collect()
    };
    let house = samples::box_house();
    let metres = tiling(&written(&scratch, "metres", &of(&large, 0.001)), None);
    let double = bricks::changed(&large, |m| m["module_size"] = json!([1.8, 1.8, 1.08]));
    let double = tiling(&written(&scratch, "double", &of(&double, 0.002)), None);
    let volumes = [&metres, &double].map(|set| fabric(set, &house).volumes_m3()[Component::Cladding as usize]);
    assert!((volumes[0] - house.voxels.filled_count() as f64 * 0.9 * 0.9 * 0.54).abs() < 1e-9);
    assert!((volumes[0] - volumes[1]).abs() < 1e-9, "{volumes:?}");
    assert!(fabric(&double, &house).scale.iter().all(|s| (s - 0.5).abs() < 1e-9));
}

/// Layers keep their names and the colours of the set's material library; those that overlap are shown piece by piece and say so.
#[test]
fn layers_keep_their_names_and_colours() {
    let scratch = cli::Scratch::new();
    let mut files = bricks::changed(&bricks::set(), |m| {
        m["layers"] = json!([
            {"name": "Klinker", "kind": "solid", "component": "cladding", "groups": ["wall"]},
            {"name": "Kern", "kind": "solid", "component": "cladding", "overhang": 300.0},
        ]);
    });
    // A bar above its cube that reaches into both neighbours' bars.
    let bar = bricks::boxes(&[("Kern_o0".into(), [-200.0, 150.0, 600.0], [1100.0, 250.0, 650.0])]);
    // Vertices are counted from the end, so that it can stand behind any text.
    let from_end =
        |f: &str| f.split(' ').map(|n| (n.parse::<i64>().unwrap() - 9).to_string()).collect::<Vec<_>>().join(" ");
    let bar: String =
        bar.lines().map(|l| l.strip_prefix("f ").map_or(l.into(), |f| format!("f {}", from_end(f))) + "\n").collect();
    for (_, text) in files.iter_mut().filter(|(name, _)| name.ends_with(".obj")) {
        *text = format!("mtllib own.mtl\nusemtl clay\n{text}usemtl none\n{bar}");
    }
    files.insert("own.mtl".into(), "newmtl clay\nKd 0.8 0.2 0\nPr 0.5\n".into());
    let set = tiling(&written(&scratch, "own", &files), None);
    let fabric = fabric(&set, &samples::box_house());
    let scene = from_fabric(&fabric, &Palette::default(), Storeys::Together, Value::Null).unwrap();
    let names: Vec<&str> = scene.parts.iter().map(|p| p.name.as_str()).collect();
    assert_eq!(names, ["Klinker", "Kern"]);
    let [brick, core] = [0, 1].map(|n| &scene.materials[scene.parts[n].material]);
    assert_eq!((brick.name.as_str(), core.name.as_str()), ("Klinker", "Kern"));
    assert!(brick.rgba[0] > 0.5 && brick.rgba[1] < 0.1 && brick.rgba[2] == 0.0 && brick.roughness == 0.5, "{brick:?}");
    let usual = Palette::default().material(Component::Cladding);
    assert_eq!((core.rgba, core.roughness), (usual.rgba, usual.roughness), "no library has its material");
    assert_eq!(scene.parts[0].extras["not_merged"], Value::Null);
    assert!(scene.parts[1].extras["not_merged"].as_str().unwrap().contains("overlap"), "{}", scene.parts[1].extras);
    assert!(!scene.parts[1].triangles.is_empty());
}

/// A few tiles of a designer's own: the rest of the house is not silently empty.
#[test]
fn cubes_without_a_tile_are_reported() {
    let scratch = cli::Scratch::new();
    let house = samples::box_house();
    let (file, out) = (scratch.house("house.json", &house), scratch.at("out"));
    let foreign = repository("tests/data/tilesets/foreign");
    let args = ["build", &file, "--tileset", foreign.to_str().unwrap(), "--out", &out];
    let ran = cli::ok(&[&["--json"], &args[..]].concat());
    let report: Value = serde_json::from_str(&ran.out).unwrap();
    assert!(report["verdict"].is_string(), "the structure is there too");
    let set = tiling(&foreign, None);
    let missing = set.missing(&house.voxels);
    assert!(missing.len() > 100);
    assert_eq!(report["tileset"]["cubes_without_tile"], missing.len());
    let list = std::fs::read_to_string(Path::new(&out).join("missing-tiles.csv")).unwrap();
    assert_eq!(list.lines().count(), missing.len() + 1);
    let first = &report["tileset"]["first_without_tile"][0];
    let [i, j, k] = missing[0].cube;
    let digits: String = missing[0].labels.iter().map(|l| l.code().to_string()).collect();
    assert_eq!((&first["cube"], &first["labels"]), (&json!([i, j, k]), &json!(digits)));
    assert!(list.lines().nth(1).unwrap().starts_with(&format!("{i},{j},{k},{digits}")), "{list}");
    cli::has(&ran.err, &[&format!("{} cubes have no tile", missing.len()), &digits, "missing-tiles.csv", "areas"]);
    // Every cube is either drawn or listed; those that are drawn are walls and windows of this set.
    let fabric = fabric(&set, &house);
    let drawn: std::collections::BTreeSet<[u32; 3]> = fabric.placed.iter().map(|p| p.cube).collect();
    let [nx, ny, nz] = cube_shape(&house.voxels);
    let mut walls = 0;
    for n in 0..nx * ny * nz {
        let cube = [n % nx, n / nx % ny, n / nx / ny];
        let labels = cube_labels(&house.voxels, cube);
        let filled = labels.iter().filter(|l| l.is_filled()).count();
        let listed = missing.iter().any(|m| m.cube == cube);
        let stands = drawn.contains(&cube.map(|c| c as u32));
        assert!(!(listed && stands), "{cube:?}");
        assert_eq!(
            listed || stands,
            filled > 0 && filled < 8,
            "{cube:?}: this set draws no full cube, so none is wanted"
        );
        walls += usize::from(stands);
    }
    assert!(walls > 0);
    let layers: Value = serde_json::from_slice(&std::fs::read(Path::new(&out).join("meshes.json")).unwrap()).unwrap();
    let names: Vec<&str> = layers["layers"].as_array().unwrap().iter().map(|l| l["layer"].as_str().unwrap()).collect();
    assert!(names.contains(&"cladding"), "{names:?}");
    let obj = std::fs::read_to_string(Path::new(&out).join("house.obj")).unwrap();
    let mtl = std::fs::read_to_string(Path::new(&out).join("house.mtl")).unwrap();
    for name in names {
        assert!(obj.contains(&format!("usemtl {name}\n")) && mtl.contains(&format!("newmtl {name}\n")), "{name}");
    }
}

/// TopoGenesis's 256 tiles with their own numbering, a unit cube about its centre: every house is one closed chamfered body.
#[test]
fn topogenesis_draws_whole_houses() {
    let Some(root) = cli::reference("tilesets/topogenesis-chamfer") else { return };
    let set = tiling(&repository("tilesets/topogenesis"), Some(Path::new(&root)));
    for (name, house) in houses() {
        assert!(set.missing(&house.voxels).is_empty(), "{name}");
        let fabric = fabric(&set, &house);
        let groups = fabric.gather_groups(|p| p.layer).unwrap();
        let [(_, body)] = &groups[..] else { panic!("{name}: {} layers", groups.len()) };
        assert_eq!(body.apart, None, "{name}");
        assert_eq!(body.solid.report().open_edges, 0, "{name}");
        assert_eq!(body.solid.six_volumes(), fabric.six_volumes().iter().sum::<i128>(), "{name}");
        let voxels = house.voxels.filled_count() as f64 * 0.9 * 0.9 * 0.54;
        let share = body.solid.volume_m3() / voxels;
        // Chamfers of a quarter module take little from bodies of rooms.
        assert!((0.9..1.0).contains(&share), "{name}: {share}");
        // The middle of every filled voxel is inside: its eight cubes have a body at that corner.
        let heart = fabric.tiles.iter().all(|(_, tile)| matches!(tile, CubeTile::Bodies(b) if !b.is_empty()));
        assert!(heart, "{name}");
    }
    // The same through the program: pictures, take-off and reports as for any other set.
    let scratch = cli::Scratch::new();
    let (file, out) = (scratch.house("house.json", &samples::hip_house()), scratch.at("out"));
    let manifest = repository("tilesets/topogenesis");
    let ran =
        cli::ok(&["build", &file, "--tileset", manifest.to_str().unwrap(), "--tileset-root", &root, "--out", &out]);
    cli::has(&ran.err, &["topogenesis-chamfer", "rule A", "1 stairs are not drawn"]);
    assert!(!Path::new(&out).join("missing-tiles.csv").exists());
    for file in ["house.glb", "house.obj", "thumb.png", "parts.glb", "bom.csv", "meshes.json"] {
        assert!(Path::new(&out).join(file).is_file(), "{file}");
    }
}

/// Baking writes a foreign set as one of ours: millimetres, z up, our corner order, its layers and variants; houses stay the same.
#[test]
fn a_baked_foreign_set_draws_the_same_houses() {
    let scratch = cli::Scratch::new();
    let foreign = repository("tests/data/tilesets/foreign");
    let mut sets = vec![(foreign.clone(), None, true)];
    if let Some(root) = cli::reference("tilesets/topogenesis-chamfer") {
        sets.push((repository("tilesets/topogenesis"), Some(root), false));
    }
    for (n, (dir, root, variants)) in sets.iter().enumerate() {
        let out = scratch.at(&format!("baked-{n}"));
        let mut args = vec!["tileset", "bake", dir.to_str().unwrap(), "--out", out.as_str()];
        args.extend(root.iter().flat_map(|root| ["--root", root.as_str()]));
        cli::ok(&args);
        let [before, after] = [tiling(dir, root.as_deref().map(Path::new)), tiling(Path::new(&out), None)];
        let manifest = std::fs::read_to_string(Path::new(&out).join("tileset.json")).unwrap();
        assert_eq!(manifest.contains("\"variants\""), *variants);
        for (name, house) in samples::all() {
            assert_eq!(before.missing(&house.voxels), after.missing(&house.voxels), "{name}");
            let [a, b] = [&before, &after].map(|t| fabric(t, &house));
            assert_eq!(a.six_volumes_by_voxel(), b.six_volumes_by_voxel(), "{name}");
            let names = |f: &Fabric| f.layers.iter().map(|l| l.name.clone()).collect::<Vec<_>>();
            assert_eq!(names(&a), names(&b));
        }
    }
}

/// A search over houses of a set of meshes says what was measured, and which houses of the front lack tiles.
#[test]
fn a_search_says_what_meshes_do_not_measure() {
    let scratch = cli::Scratch::new();
    let foreign = repository("tests/data/tilesets/foreign").to_str().unwrap().to_owned();
    let brief = scratch.brief("brief.json", |b| b["tileset"] = foreign.as_str().into());
    let out = scratch.at("run");
    let ran = cli::ok(&["--json", "optimize", &brief, "--evaluations", "300", "--tables-only", "--out", &out]);
    let report: Value = serde_json::from_str(&ran.out).unwrap();
    let lacking = report["tileset"]["house_and_cubes_without_tile"].as_array().unwrap();
    assert!(!lacking.is_empty() && lacking.len() as u64 == report["front"].as_u64().unwrap(), "{report}");
    assert!(report["tileset"]["measured_by"].as_str().unwrap().contains("rule A"));
    cli::has(
        &ran.err,
        &["tileset: meshes give the drawing", &format!("house {} has", lacking[0][0]), "missing-tiles.csv"],
    );
    // A style is measured by itself and says nothing of the kind.
    let brief = scratch.brief("plain.json", |b| b["tileset"] = "architectural".into());
    let out = scratch.at("plain");
    let ran = cli::ok(&["--json", "optimize", &brief, "--evaluations", "60", "--tables-only", "--out", &out]);
    assert!(!ran.out.contains("measured_by") && !ran.err.contains("tileset:"));
}
