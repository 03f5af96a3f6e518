//! The same voxels in different tilesets: another look and another take-off, never other voxels; and a style's own tiles written as
//! meshes hold what the style builds.
#![allow(clippy::unwrap_used, reason = "a test fails by panicking, in its helpers too")]

#[path = "common/cli.rs"]
mod cli;

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use houscaper::cubes::{Rule, scan_keys};
use houscaper::envelope::Fabric;
use houscaper::price::Books;
use houscaper::score::{Tiling, shells};
use houscaper::tiles::solids::solids;
use houscaper::tiles::{Component, StyleSet};
use houscaper::voxels::{House, read_storeys, samples};
use serde_json::Value;

fn repository(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join(name)
}

/// The architectural style looked up by labels alone, as it is baked.
fn by_labels(scratch: &cli::Scratch) -> String {
    let text = std::fs::read_to_string(repository("tilesets/architectural/tileset.json")).unwrap();
    let mut manifest: Value = serde_json::from_str(&text).unwrap();
    manifest["rule"] = "A".into();
    std::fs::create_dir(scratch.path().join("rule-a")).unwrap();
    scratch.file("rule-a/tileset.json", manifest.to_string());
    scratch.at("rule-a")
}

#[test]
fn swapping_the_tileset_keeps_the_voxels_and_baked_tiles_hold_what_the_style_builds() {
    let scratch = cli::Scratch::new();
    let baked = scratch.at("baked");
    cli::ok(&["tileset", "bake", "architectural", "--out", &baked]);
    let rule_a = by_labels(&scratch);
    volumes_agree(&baked, &rule_a);

    let house = samples::l_house();
    let file = scratch.house("house.json", &house);
    let mut sets = vec![
        ("architectural", vec!["architectural".to_owned()]),
        ("larch", vec!["larch".to_owned()]),
        ("surface-2", vec!["surface-2".to_owned()]),
        ("baked", vec![baked.clone()]),
        ("rule-a", vec![rule_a]),
    ];
    if let Some(root) = cli::reference("tilesets/topogenesis-chamfer") {
        let manifest = repository("tilesets/topogenesis").to_str().unwrap().to_owned();
        sets.push(("topogenesis", vec![manifest, "--tileset-root".to_owned(), root]));
    }
    let mut files: BTreeMap<&str, BTreeMap<&str, Vec<u8>>> = BTreeMap::new();
    for (name, tileset) in &sets {
        let out = scratch.at(&format!("out-{name}"));
        let mut args = vec!["build", file.as_str(), "--out", out.as_str(), "--tileset"];
        args.extend(tileset.iter().map(String::as_str));
        cli::ok(&args);
        let read = |file: &'static str| (file, std::fs::read(Path::new(&out).join(file)).unwrap());
        files.insert(name, ["voxels.csv", "house.glb", "thumb.png", "bom.csv", "frame.json"].map(read).into());
    }
    let of = |set: &str, file: &str| &files[set][file];
    for (set, own) in &files {
        assert_eq!(own["voxels.csv"], *of("architectural", "voxels.csv"), "{set}");
        assert!(
            sticks(&own["frame.json"]) == sticks(of("architectural", "frame.json")),
            "{set}: one frame under every skin"
        );
        for other in files.keys().filter(|other| *other != set) {
            assert_ne!(own["house.glb"], *of(other, "house.glb"), "{set} {other}");
            // Baked tiles are those of the style by labels alone, and the roof of an L under a hip differs from rule B's.
            let alike = ["baked", "rule-a"].contains(set) && ["baked", "rule-a"].contains(other);
            assert!(alike || own["thumb.png"] != *of(other, "thumb.png"), "{set} {other}");
        }
    }
    // The take-off: styles and surfaces differ where roofs, edges and openings do; sets of meshes are measured by the surface of the
    // architectural construction by labels alone, and say so.
    for [one, other] in [["architectural", "larch"], ["architectural", "surface-2"], ["larch", "surface-2"]] {
        assert_ne!(of(one, "bom.csv"), of(other, "bom.csv"), "{one} {other}");
    }
    assert_eq!(of("baked", "bom.csv"), of("rule-a", "bom.csv"));
    // What is taken off is what the frame carries.
    assert!(of("baked", "frame.json") == of("rule-a", "frame.json"));
    assert!(of("baked", "frame.json") != of("architectural", "frame.json"));
    assert_ne!(of("baked", "bom.csv"), of("architectural", "bom.csv"), "a hip has no straight verge by labels alone");
    if files.contains_key("topogenesis") {
        assert_eq!(of("topogenesis", "bom.csv"), of("baked", "bom.csv"));
    }
}

/// A frame file without its loads.
fn sticks(file: &[u8]) -> Value {
    let mut frame: Value = serde_json::from_slice(file).unwrap();
    assert!(frame.as_object_mut().unwrap().remove("cases").is_some());
    frame
}

/// The volume of every component of every sample house, exactly: files hold whole micrometres, and volumes are sums of whole numbers.
fn volumes_agree(baked: &str, rule_a: &str) {
    let books = Books::load(&repository("configs")).unwrap();
    let [meshes, style] = [baked, rule_a].map(|dir| Tiling::load(Path::new(dir), &books).unwrap());
    let (set, shells) = (StyleSet::load(Path::new(rule_a)).unwrap(), shells(&books).unwrap());
    let houses: Vec<(&str, House)> = samples::all().into_iter().chain(samples::gallery()).collect();
    for (name, house) in &houses {
        assert!(meshes.missing(&house.voxels).is_empty(), "{name}");
        let mesh = meshes.fabric(house, &read_storeys(house)).unwrap();
        // Labels do not tell which decks are walked on, and stairs belong to no cube.
        let mut keys = Vec::new();
        scan_keys(&house.voxels, Rule::A, |_| false, |cube, key| keys.push((cube, key)));
        let built = Fabric::new(&house.voxels, keys, |key| solids(key, &set.style, &shells).into());
        for &component in Component::ALL {
            let [drawn, wanted] = [&mesh, &built].map(|f| f.six_volumes()[component as usize]);
            assert_eq!(drawn, wanted, "{name}: {}", component.name());
        }
        assert_eq!(mesh.six_volumes_by_voxel(), built.six_volumes_by_voxel(), "{name}");
        // Merged, layer by layer, it is the same body.
        let surface = |f: &Fabric| -> Vec<_> {
            let groups = f.gather_groups(|p| p.component).unwrap();
            groups.into_iter().map(|(c, g)| (c, g.apart, g.solid.six_volumes(), g.solid.report().open_edges)).collect()
        };
        assert_eq!(surface(&mesh), surface(&built), "{name}");
    }
    // A house without stairs and walked decks is the same through the tiling, too.
    let house = samples::l_house();
    let [a, b] = [&meshes, &style].map(|t| t.fabric(&house, &read_storeys(&house)).unwrap().volumes_m3());
    assert_eq!(a, b);
}
