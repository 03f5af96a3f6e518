//! Houses of a style with a configuration drawn by a mesh: a pilaster on every straight wall. Only those cubes change, in the model, in
//! the volumes, in the parts and in what is baked.
#![allow(clippy::unwrap_used, reason = "a test fails by panicking, in its helpers too")]

#[path = "common/cli.rs"]
mod cli;
#[path = "common/shells.rs"]
mod shells;
#[path = "common/tile_obj.rs"]
mod tile_obj;

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};

use houscaper::cubes::CubeKey;
use houscaper::envelope::{CubeTile, Fabric};
use houscaper::export::{Exploded, Palette, Scene, Storeys, from_fabric, from_parts};
use houscaper::parts::{self, cut, marks};
use houscaper::price::Books;
use houscaper::score::Tiling;
use houscaper::tiles::check::{Folder, check};
use houscaper::tiles::solids::solids;
use houscaper::tiles::{Block, Component, LabelSet, StyleSet};
use houscaper::voxels::{Choices, House, Label, read_storeys, samples};
use serde_json::{Value, json};

/// The pilaster, mm: not in the middle, so that a mirror shows, and inside the cube's face, so that seams stay.
const LOW: [i32; 3] = [200, 450, 100];
const HIGH: [i32; 3] = [400, 490, 400];

fn repository(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join(name)
}

fn wall() -> CubeKey {
    let [e, b] = [Label::Empty, Label::Base];
    CubeKey::of_labels([b, b, e, e, b, b, e, e])
}

/// The style's own wall with the pilaster: facing north, and carried to the other three sides if `turned`.
fn style(scratch: &cli::Scratch, turned: bool) -> PathBuf {
    let set = StyleSet::load(&repository("tilesets/architectural")).unwrap();
    let mut blocks = solids(wall(), &set.style, &shells::shells());
    let facade = blocks.iter().flat_map(|b| b.plan.iter().map(|p| p[1])).max().unwrap();
    assert_eq!(facade, LOW[1] * 1000, "the pilaster stands on the facade");
    let cladding = blocks.iter().find(|b| b.component == Component::Cladding).unwrap().octant;
    blocks.push(Block::cuboid(Component::Cladding, cladding, LOW.map(|mm| mm * 1000), HIGH.map(|mm| mm * 1000)));
    let text = std::fs::read_to_string(repository("tilesets/architectural/tileset.json")).unwrap();
    let mut manifest: Value = serde_json::from_str(&text).unwrap();
    manifest["overrides"] = json!([{
        "name": "pilaster", "pattern": "11001100", "symmetry": {"mirror": false, "quarter_turns": turned},
        "file": "pilaster.obj",
    }]);
    let dir = scratch.path().join(if turned { "turned" } else { "north" });
    std::fs::create_dir(&dir).unwrap();
    std::fs::write(dir.join("tileset.json"), manifest.to_string()).unwrap();
    std::fs::write(dir.join("pilaster.obj"), tile_obj::obj(&blocks)).unwrap();
    let shells = shells::shells();
    let report = check(&Folder::open(&dir, None), Some(&|key| solids(key, &set.style, &shells)));
    assert_eq!(report.findings, [], "a pilaster that meets the style's own walls");
    dir
}

fn tiling(dir: &Path) -> Tiling {
    Tiling::load(dir, &Books::load(&repository("configs")).unwrap()).unwrap()
}

fn fabric(tiling: &Tiling, house: &House) -> Fabric {
    tiling.fabric(house, &read_storeys(house)).unwrap()
}

/// What stands in each cube: component, octant, faces.
type Standing = BTreeMap<[u32; 3], Vec<(Component, u8, Vec<Vec<[i32; 3]>>)>>;

fn by_cube(fabric: &Fabric) -> Standing {
    let mut cubes = Standing::new();
    for placed in &fabric.placed {
        let (tile, n) = (&fabric.tiles[placed.tile as usize].1, placed.block as usize);
        let (component, _, octant) = tile.kind(n);
        cubes.entry(placed.cube).or_default().push((component, octant, tile.faces(n)));
    }
    cubes
}

fn overridden(fabric: &Fabric) -> BTreeSet<[u32; 3]> {
    let is_mesh = |tile: u32| matches!(fabric.tiles[tile as usize].1, CubeTile::Bodies(_));
    fabric.placed.iter().filter(|p| is_mesh(p.tile)).map(|p| p.cube).collect()
}

fn volume(scene: &Scene, ending: &str) -> f64 {
    let parts = scene.parts.iter().filter(|p| p.name.ends_with(ending));
    let of = |part: &houscaper::export::Part| -> f64 {
        part.triangles
            .iter()
            .map(|&t| {
                let [a, b, c] = part.corners(t).unwrap();
                (a[0] * (b[1] * c[2] - b[2] * c[1])
                    + a[1] * (b[2] * c[0] - b[0] * c[2])
                    + a[2] * (b[0] * c[1] - b[1] * c[0]))
                    / 6.0
            })
            .sum()
    };
    parts.map(of).sum()
}

#[test]
fn only_the_overridden_cubes_change() {
    let scratch = cli::Scratch::new();
    let plain = tiling(&repository("tilesets/architectural"));
    let own = tiling(&style(&scratch, true));
    let [w, d, h] = [0, 1, 2].map(|a| f64::from(HIGH[a] - LOW[a]) / 1000.0);
    let mut facing: BTreeSet<CubeKey> = BTreeSet::new();
    for (name, house) in samples::all() {
        let [before, after] = [&plain, &own].map(|t| fabric(t, &house));
        let changed = overridden(&after);
        assert!(changed.len() > 20 && overridden(&before).is_empty(), "{name}: {}", changed.len());
        facing.extend(after.tiles.iter().filter(|t| matches!(t.1, CubeTile::Bodies(_))).map(|t| t.0));
        let [old, new] = [by_cube(&before), by_cube(&after)];
        assert_eq!(old.keys().collect::<Vec<_>>(), new.keys().collect::<Vec<_>>(), "{name}");
        for (cube, pieces) in &new {
            assert_eq!(*pieces == old[cube], !changed.contains(cube), "{name} {cube:?}");
        }
        // Volumes: exactly a pilaster more for each of them, in the cladding alone.
        let count = changed.len() as f64;
        let pilaster: i128 = (0..3).map(|a| i128::from(HIGH[a] - LOW[a]) * 1000).product::<i128>() * 6;
        for &component in Component::ALL {
            let more = after.six_volumes()[component as usize] - before.six_volumes()[component as usize];
            let wanted = if component == Component::Cladding { pilaster * changed.len() as i128 } else { 0 };
            assert_eq!(more, wanted, "{name} {}", component.name());
        }
        // The model: still one closed cladding, without faces left between meshes and blocks.
        let area = |fabric: &Fabric| -> f64 {
            let groups = fabric.gather_groups(|p| p.component).unwrap();
            let (_, cladding) = groups.iter().find(|(c, _)| *c == Component::Cladding).unwrap();
            assert_eq!((cladding.apart, cladding.solid.report().open_edges), (None, 0), "{name}");
            cladding.solid.faces.iter().map(|f| cladding.solid.area_m2(f)).sum()
        };
        let sides = count * 2.0 * d * (w + h);
        assert!((area(&after) - area(&before) - sides).abs() < 1e-9, "{name}: {}", area(&after) - area(&before));
        let scene = |f: &Fabric| from_fabric(f, &Palette::default(), Storeys::Together, Value::Null).unwrap();
        let grown = volume(&scene(&after), "cladding") - volume(&scene(&before), "cladding");
        assert!((grown - count * w * d * h).abs() < 1e-6, "{name}: {grown}");
        // The parts: every pilaster goes with its panel.
        let reading = read_storeys(&house);
        let cut = cut(&house, &reading, &Choices::default(), parts::Settings::default()).unwrap();
        let marks = marks(&cut);
        let exploded = |f: &Fabric| {
            let of = |p: &houscaper::envelope::PlacedBlock| {
                let [x, y, z] = p.voxel.map(|c| usize::try_from(c).ok());
                cut.of([x?, y?, z?], p.component, f.centre_m(p)).map(|id| id.0)
            };
            let part_of: Vec<Option<u32>> = f.placed.iter().map(of).collect();
            let names = |n: u32| marks.piece[n as usize].clone();
            from_parts(f, &part_of, names, |_| None, &Palette::default(), Exploded::default()).unwrap()
        };
        let grown = volume(&exploded(&after), ".cladding") - volume(&exploded(&before), ".cladding");
        assert!((grown - count * w * d * h).abs() < 1e-6, "{name}: parts grew by {grown}");
    }
    assert_eq!(facing.len(), 4, "walls face four ways");
}

#[test]
fn files_of_a_house_show_the_override_and_baking_keeps_it() {
    let scratch = cli::Scratch::new();
    let dir = style(&scratch, false);
    let house = scratch.house("house.json", &samples::box_house());
    let dir = dir.to_str().unwrap();
    let [plain, own] = ["architectural", dir].map(|set| {
        let out = scratch.at(if set == dir { "own" } else { "plain" });
        cli::ok(&["build", &house, "--tileset", set, "--out", &out]);
        out
    });
    let read = |folder: &str, file: &str| std::fs::read(Path::new(folder).join(file)).unwrap();
    for file in ["voxels.csv", "bom.csv", "quote.json", "parts.csv", "frame.glb"] {
        assert_eq!(read(&plain, file), read(&own, file), "{file} does not depend on the mesh");
    }
    for file in ["house.glb", "house.obj", "parts.glb"] {
        assert_ne!(read(&plain, file), read(&own, file), "{file}");
    }
    let baked = scratch.at("baked");
    cli::ok(&["tileset", "bake", dir, "--families", "--out", &baked]);
    let baked = LabelSet::load(Path::new(&baked)).unwrap();
    let set = StyleSet::load(Path::new(dir)).unwrap();
    let cladding = |bodies: &[houscaper::tiles::Body]| -> i128 {
        bodies.iter().filter(|b| b.component == Component::Cladding).map(|b| b.six_volumes()).sum()
    };
    let own = cladding(&set.overrides.tile(wall()).unwrap().bodies);
    assert_eq!(cladding(&baked.tile(wall()).unwrap().bodies), own);
    // The wall facing south is not overridden here.
    let [e, b] = [Label::Empty, Label::Base];
    let south = CubeKey::of_labels([e, e, b, b, e, e, b, b]);
    let pilaster: i128 = (0..3).map(|a| i128::from(HIGH[a] - LOW[a]) * 1000).product::<i128>() * 6;
    assert_eq!(own - cladding(&baked.tile(south).unwrap().bodies), pilaster);
}
