//! The models of a house: what their nodes say sums to the take-off, single tiles stand where the merged layers stand, views have
//! legends, and the Khronos validator finds nothing in any file of a run.

#[path = "common/glb.rs"]
mod glb;
#[path = "common/khronos.rs"]
mod khronos;
#[path = "common/runs.rs"]
mod runs;

use std::collections::BTreeMap;

use glb::Model;
use houscaper::export::dossier::{Extent, dossier, tiles_glb};
use houscaper::export::{DistinctTiles, HOUSE_VIEWS};
use houscaper::price::{BillLine, bill};
use houscaper::score::{Details, Evaluator};
use houscaper::voxels::{Choices, House, samples};
use serde_json::Value;

const KEYS: [&str; 3] = ["mass_kg", "price_eur", "gwp_kgco2e"];

fn evaluator() -> Evaluator {
    runs::evaluator(&runs::repository().join("configs/starter.json"))
}

/// A storeyed house with a stair, a terrace and a hip: every kind of layer.
fn houses() -> Vec<(&'static str, House)> {
    let mut all = samples::all().to_vec();
    all.extend(samples::gallery().into_iter().filter(|(name, _)| *name == "villa"));
    all
}

fn lines(details: &Details, evaluator: &Evaluator) -> Vec<BillLine> {
    let takeoff = details.evaluation.takeoff.as_ref().expect("a take-off");
    bill(takeoff, &evaluator.books, &|n| n.to_string()).expect("a bill")
}

/// Mass, materials and carbon of lines of the bill.
fn sums<'a>(lines: impl Iterator<Item = &'a BillLine>) -> [f64; 3] {
    lines.fold([0.0; 3], |s, l| [s[0] + l.mass_kg, s[1] + l.amount, s[2] + l.gwp_kgco2e])
}

fn numbers(value: &Value) -> [f64; 3] {
    KEYS.map(|key| value[key].as_f64().unwrap_or(0.0))
}

fn add(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [0, 1, 2].map(|n| a[n] + b[n])
}

fn same(name: &str, found: [f64; 3], expected: [f64; 3]) {
    for n in 0..3 {
        let off = (found[n] - expected[n]).abs();
        assert!(off <= 1e-6 * expected[n].abs().max(1.0), "{name} {}: {} and {}", KEYS[n], found[n], expected[n]);
    }
}

fn file<'a>(files: &'a [(String, Vec<u8>)], name: &str) -> &'a [u8] {
    &files.iter().find(|(file, _)| file == name).unwrap_or_else(|| panic!("no {name}")).1
}

#[test]
fn layers_and_members_sum_to_the_bill() {
    let evaluator = evaluator();
    for (name, house) in houses() {
        let choices = Choices::default();
        let details = evaluator.details(&house, &choices);
        let files = dossier(name, &house, &choices, &details, &evaluator, Extent::Front).expect("files").files;
        let lines = lines(&details, &evaluator);
        let (frame, others): (Vec<&BillLine>, Vec<&BillLine>) = lines
            .iter()
            .filter(|l| !["manufacture", "site"].contains(&l.group.as_str()))
            .partition(|l| l.group == "frame");
        let model = Model::read(file(&files, "house.glb"));
        let layers = model.nodes.iter().map(|n| numbers(&n.extras)).fold([0.0; 3], add);
        let scene = &model.about["materials"];
        same(name, layers, numbers(&scene["layers"]));
        same(name, add(layers, numbers(&scene["layers_not_drawn"])), sums(others.into_iter()));
        same(name, numbers(&scene["frame"]), sums(frame.iter().copied()));
        // Nodes are few: one a layer, however many colours it has.
        let mut names: Vec<&str> = model.nodes.iter().map(|n| n.name.as_str()).collect();
        names.dedup();
        assert_eq!(names.len(), model.nodes.len(), "{name}: a node a layer");
        assert!(model.nodes.len() < 40 && model.nodes.iter().all(|n| n.extras["component"].is_string()));

        let members = Model::read(file(&files, "frame.glb"));
        let own: Vec<_> = members.nodes.iter().filter(|n| n.extras["member"].is_u64()).collect();
        assert!(!own.is_empty());
        for node in &own {
            for key in ["utilisation", "mass_kg", "price_line", "price_eur", "gwp_kgco2e", "section", "role"] {
                assert!(!node.extras[key].is_null(), "{name}: {} says no {key}", node.name);
            }
            let line = node.extras["price_line"].as_u64().expect("a number") as usize;
            assert_eq!(lines[line - 1].group, "frame", "{name}");
        }
        let drawn = own.iter().map(|n| numbers(&n.extras)).fold([0.0; 3], add);
        same(name, drawn, sums(frame.into_iter()));
    }
}

/// Each tile, turned and moved as its node says, holds what the blocks of its cube hold, and nothing is forgotten.
#[test]
fn tiles_stand_where_their_blocks_stand() {
    let evaluator = evaluator();
    for (name, house) in houses() {
        let choices = Choices::default();
        let details = evaluator.details(&house, &choices);
        let bytes = tiles_glb(name, &house, &choices, &details, &evaluator).expect("solids").expect("a style");
        let model = Model::read(&bytes);
        let fabric = evaluator.tiling.fabric(&house, &details.reading).expect("a fabric");
        let mut expected: BTreeMap<[u32; 3], (f64, [[f64; 3]; 2])> = BTreeMap::new();
        for placed in fabric.placed.iter().filter(|p| !fabric.standing.contains(&p.tile)) {
            let solid = fabric.merge([placed]).expect("a block");
            let entry = expected.entry(placed.cube).or_insert((0.0, [[f64::MAX; 3], [f64::MIN; 3]]));
            entry.0 += solid.volume_m3();
            for v in solid.vertices.iter().map(|v| fabric.metres(*v)) {
                entry.1[0] = [0, 1, 2].map(|a| entry.1[0][a].min(v[a]));
                entry.1[1] = [0, 1, 2].map(|a| entry.1[1][a].max(v[a]));
            }
        }
        let mut found = 0;
        for node in model.nodes.iter().filter(|n| n.extras["cube"].is_array()) {
            let cube: [u32; 3] = serde_json::from_value(node.extras["cube"].clone()).expect("a cube");
            let (volume, bounds) = &expected[&cube];
            let (own, [low, high]) = (node.volume(), node.bounds());
            assert!((own - volume).abs() <= 1e-5 * volume, "{name} {cube:?}: {own} and {volume}");
            for a in 0..3 {
                assert!(
                    (low[a] - bounds[0][a]).abs() < 1e-5 && (high[a] - bounds[1][a]).abs() < 1e-5,
                    "{name} {cube:?}"
                );
            }
            found += 1;
        }
        assert_eq!(found, expected.len(), "{name}: a node for each cube");
        let stairs = model.nodes.iter().filter(|n| n.extras["stair"].is_u64()).count();
        assert_eq!((stairs, found + stairs), (house.stairs.len(), model.nodes.len()), "{name}");
        let layers = model.nodes.iter().map(|n| numbers(&n.extras)).fold([0.0; 3], add);
        same(name, layers, numbers(&model.about["materials"]["layers"]));
        // Equal tiles share their geometry, turned ones too.
        let tiles = DistinctTiles::new(&fabric, &house).expect("tiles");
        let turned = tiles.of_cube.values().filter(|t| t.turns > 0).count();
        assert!(
            tiles.tiles.len() * 2 < found && turned > found / 8,
            "{name}: {} tiles, {turned} turned",
            tiles.tiles.len()
        );
        println!("{name}: {found} cubes, {} tiles, {turned} turned, {} bytes", tiles.tiles.len(), bytes.len());
    }
}

/// Each view colours something, by a legend in the scene; no view changes what is there.
#[test]
fn views_have_legends() {
    let (evaluator, house, choices) = (evaluator(), samples::hip_house(), Choices::default());
    let details = evaluator.details(&house, &choices);
    let files = dossier("hip", &house, &choices, &details, &evaluator, Extent::Front).expect("files").files;
    let tiles = tiles_glb("hip", &house, &choices, &details, &evaluator).expect("solids").expect("a style");
    for (name, bytes) in [("layers", file(&files, "house.glb")), ("tiles", tiles.as_slice())] {
        let model = Model::read(bytes);
        assert_eq!(model.variants, HOUSE_VIEWS, "{name}");
        for (n, view) in HOUSE_VIEWS.iter().enumerate().skip(1) {
            let legend = &model.about["views"][view];
            let named: Vec<&str> =
                legend["classes"].as_array().expect("classes").iter().filter_map(|c| c["material"].as_str()).collect();
            let shown = model.shown_in(n);
            assert!(shown.iter().filter(|m| named.contains(&m.as_str())).count() > 1, "{name} {view}: {shown:?}");
            assert!(shown.iter().all(|m| named.contains(&m.as_str()) || m == "no value"), "{name} {view}: {shown:?}");
            assert!(legend["means"].is_string(), "{name} {view}");
        }
        for view in ["carbon", "price"] {
            let legend = &model.about["views"][view];
            assert!(legend["max"].as_f64() > legend["min"].as_f64() && legend["unit"].is_string(), "{legend}");
        }
    }
}

/// Equal input, equal bytes, and the validator's word on every model of a built house.
#[test]
fn khronos_finds_nothing_in_the_files_of_a_house() {
    let evaluator = evaluator();
    let folder = tempfile::tempdir().expect("a temporary folder");
    let mut paths = Vec::new();
    for (name, house) in houses() {
        let choices = Choices::default();
        let details = evaluator.details(&house, &choices);
        let full = Extent::Full { sizing: None };
        let mut files = dossier(name, &house, &choices, &details, &evaluator, full).expect("files").files;
        let tiles = || tiles_glb(name, &house, &choices, &details, &evaluator).expect("solids").expect("a style");
        files.push(("tiles.glb".into(), tiles()));
        assert!(file(&files, "tiles.glb") == tiles(), "{name}: equal input, equal bytes");
        for (file, bytes) in files.iter().filter(|(file, _)| file.ends_with(".glb")) {
            let path = folder.path().join(format!("{}-{file}", name.replace(' ', "-")));
            std::fs::write(&path, bytes).expect("a temporary file");
            println!("{}: {} bytes", path.display(), bytes.len());
            paths.push(path);
        }
    }
    khronos::validate(&paths);
}

/// three.js in headless Chromium loads every model of a house and draws all of its views. Needs THREE_DIR: a folder whose node_modules
/// hold `three` and `playwright-core`.
#[test]
fn three_js_shows_every_model() {
    let Some(modules) = std::env::var_os("THREE_DIR") else {
        return println!("skipped: THREE_DIR names no folder with three and playwright-core");
    };
    let (evaluator, choices) = (evaluator(), Choices::default());
    let (name, house) = houses().pop().expect("a house");
    let details = evaluator.details(&house, &choices);
    let folder = tempfile::tempdir().expect("a temporary folder");
    let mut files =
        dossier(name, &house, &choices, &details, &evaluator, Extent::Full { sizing: None }).expect("files").files;
    let tiles = tiles_glb(name, &house, &choices, &details, &evaluator).expect("solids").expect("a style");
    files.push(("tiles.glb".into(), tiles));
    let mut paths = Vec::new();
    for (file, bytes) in files.iter().filter(|(file, _)| file.ends_with(".glb")) {
        paths.push(folder.path().join(file));
        std::fs::write(folder.path().join(file), bytes).expect("a temporary file");
    }
    let script = runs::repository().join("tests/tools/show_glb.mjs");
    let mut node = std::process::Command::new("node");
    node.env("THREE_DIR", modules).arg(script).arg(folder.path().join("pictures")).args(&paths);
    let run = node.output().expect("node starts");
    let said = format!("{}{}", String::from_utf8_lossy(&run.stdout), String::from_utf8_lossy(&run.stderr));
    if run.status.code() == Some(3) {
        return println!("skipped: {said}");
    }
    println!("{said}");
    assert!(run.status.success(), "{said}");
    // As many nodes as the crate `gltf` reads, and as many pictures as there are views.
    for line in said.lines().filter(|l| l.starts_with('{')) {
        let shown: Value = serde_json::from_str(line).expect("JSON");
        let bytes = file(&files, shown["file"].as_str().expect("a name"));
        let model = Model::read(bytes);
        let meshes = shown["meshes"].as_u64().expect("a count") as usize;
        assert!(meshes >= model.nodes.len(), "{shown}");
        assert_eq!(shown["variants"].as_array().map_or(0, Vec::len), model.variants.len(), "{shown}");
    }
}
