//! Volumes from the table of keys are those of the blocks, of the parts and of the drawn solids: integers equal, files within 1e-9.

#[path = "common/drawn.rs"]
mod drawn;
#[path = "common/runs.rs"]
mod runs;

use std::collections::BTreeMap;

use drawn::{random, shipped};
use houscaper::envelope::{Fabric, HouseVolumes, KeyCache, PlacedBlock, Volumes, house_stairs, stretch};
use houscaper::export::{Exploded, Palette, Scene, Storeys, from_fabric, from_parts};
use houscaper::parts::{Settings, cut};
use houscaper::score::Evaluator;
use houscaper::tiles::Component;
use houscaper::voxels::{House, Label, read_storeys, samples};
use rayon::prelude::*;

fn evaluator() -> Evaluator {
    runs::evaluator(&runs::repository().join("configs/starter.json"))
}

fn volumes(evaluator: &Evaluator, house: &House, cache: &mut KeyCache) -> HouseVolumes {
    let reading = read_storeys(house);
    evaluator.tiling.survey(house, &reading, cache).expect("every cube has a tile");
    evaluator.tiling.volumes(house, &reading, cache).expect("a style")
}

fn fabric(evaluator: &Evaluator, house: &House) -> Fabric {
    evaluator.tiling.fabric(house, &read_storeys(house)).expect("a style")
}

#[test]
fn the_table_of_keys_holds_what_the_blocks_hold() {
    let evaluator = evaluator();
    let mut cache = KeyCache::default();
    for (name, house, _) in shipped().into_iter().chain(random(300)) {
        let found = volumes(&evaluator, &house, &mut cache);
        let fabric = fabric(&evaluator, &house);
        assert_eq!(found.total().all_six(), fabric.six_volumes(), "{name}");
        assert_eq!(found.total(), Volumes::of_fabric(&fabric), "{name}");
        assert_eq!(found, volumes(&evaluator, &house, &mut KeyCache::default()), "{name}: known keys change nothing");
        let style = &evaluator.tiling.style.as_ref().expect("a style").style;
        let stairs = house_stairs(&house, &read_storeys(&house), style);
        assert_eq!(found.stairs, Volumes::of_blocks(stairs.iter().flatten()), "{name}");
        assert_eq!(found.stairs.six(Component::StairTread) > 0, !stairs.is_empty(), "{name}");
        assert_eq!(found.cubes.six(Component::StairTread), 0, "{name}: no cube holds a stair");
        for (component, m3) in Component::ALL.iter().zip(fabric.volumes_m3()) {
            assert_eq!(found.total().m3(*component, stretch(&house.voxels)), m3, "{name}");
        }
    }
}

/// Sums by part and component, and of what is site work, in integers.
#[test]
fn parts_and_site_sum_to_the_house() {
    let evaluator = evaluator();
    let houses: Vec<_> = shipped().into_iter().chain(random(100)).collect();
    houses.par_iter().for_each(|(name, house, choices)| {
        let fabric = fabric(&evaluator, house);
        let parts = cut(house, &read_storeys(house), choices, Settings::default()).expect("a low house");
        let of_block = parts.of_fabric(&fabric);
        assert_eq!(of_block.len(), fabric.placed.len());
        let mut groups: BTreeMap<(Component, Option<u32>), Vec<&PlacedBlock>> = BTreeMap::new();
        for (placed, part) in fabric.placed.iter().zip(&of_block) {
            groups.entry((placed.component, part.map(|id| id.0))).or_default().push(placed);
        }
        let mut sums = vec![0; Component::COUNT];
        for ((component, part), blocks) in groups {
            let six = fabric.merge(blocks).expect("disjoint").six_volumes();
            assert!(six > 0, "{name} {} in {part:?}", component.name());
            assert!(component != Component::GroundSlab || part.is_none(), "{name}: foundation is site work");
            sums[component as usize] += six;
        }
        assert_eq!(sums, volumes(&evaluator, house, &mut KeyCache::default()).total().all_six(), "{name}");
    });
}

/// Volume of the closed part of a scene in m3, from the corners that its files hold, by signed tetrahedra from its first corner.
fn signed_volume(scene: &Scene, part: usize) -> f64 {
    let part = &scene.parts[part];
    let from = part.vertices[0];
    let six: f64 = part
        .triangles
        .iter()
        .map(|t| {
            let [a, b, c] = part.corners(*t).expect("a corner").map(|p| [0, 1, 2].map(|i| p[i] - from[i]));
            let cross = [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
            cross.iter().zip(c).map(|(n, c)| n * c).sum::<f64>()
        })
        .sum();
    six / 6.0
}

fn close(found: f64, expected: f64) -> bool {
    (found - expected).abs() <= 1e-9 * expected.abs()
}

#[test]
fn drawn_solids_hold_what_the_table_says() {
    let evaluator = evaluator();
    let mut houses: Vec<_> = shipped().into_iter().chain(random(20)).collect();
    // A module of another size stretches everything.
    let (_, mut stretched, choices) = houses[1].clone();
    stretched.voxels.module.size_m = [0.6, 0.75, 0.5];
    houses.push(("stretched".into(), stretched, choices));
    houses.par_iter().for_each(|(name, house, choices)| {
        let fabric = fabric(&evaluator, house);
        let total = volumes(&evaluator, house, &mut KeyCache::default()).total();
        let m3 = |component: Component| total.m3(component, stretch(&house.voxels));
        let palette = Palette::default();
        let scene = from_fabric(&fabric, &palette, Storeys::Together, serde_json::Value::Null).expect("disjoint");
        let mut seen = 0.0;
        for (n, part) in scene.parts.iter().enumerate() {
            let component = Component::ALL[part.material];
            let (drawn, expected) = (signed_volume(&scene, n), m3(component));
            assert!(close(drawn, expected), "{name} {}: drawn {drawn}, table {expected}", part.name);
            let told = part.extras["volume_m3"].as_f64().expect("a volume");
            assert!(close(told, expected), "{name} {}: told {told}", part.name);
            seen += expected;
        }
        let all: f64 = Component::ALL.iter().map(|c| m3(*c)).sum();
        assert!(close(seen, all), "{name}: nothing is left out of the scene");

        // The exploded parts, moved as they are, with what stays on site.
        let cut = cut(house, &read_storeys(house), choices, Settings::default()).expect("a low house");
        const SITE: u32 = u32::MAX;
        let part_of: Vec<Option<u32>> =
            cut.of_fabric(&fabric).into_iter().map(|part| Some(part.map_or(SITE, |id| id.0))).collect();
        let moved = from_parts(&fabric, &part_of, |n| n.to_string(), |_| None, &palette, Exploded::default())
            .expect("disjoint");
        let mut by_component = vec![0.0; Component::COUNT];
        for (n, part) in moved.parts.iter().enumerate() {
            let volume = signed_volume(&moved, n);
            assert!(volume > 0.0, "{name} {}", part.name);
            by_component[part.material] += volume;
        }
        for (component, found) in Component::ALL.iter().zip(by_component) {
            assert!(close(found, m3(*component)), "{name} {}: {found} in parts", component.name());
        }
    });
}

/// One voxel more is seen: the table follows the house, not the cache.
#[test]
fn a_changed_house_has_other_volumes() {
    let evaluator = evaluator();
    let mut cache = KeyCache::default();
    let mut house = samples::box_house();
    let before = volumes(&evaluator, &house, &mut cache);
    let window = house.voxels.iter().find(|(_, l)| *l == Label::Window).expect("a window").0;
    house.voxels.set(window, Label::Base);
    let after = volumes(&evaluator, &house, &mut cache);
    assert!(after.cubes.six(Component::Glass) < before.cubes.six(Component::Glass));
    assert!(after.cubes.six(Component::WallLining) > before.cubes.six(Component::WallLining));
    assert_eq!(after.cubes.six(Component::GroundSlab), before.cubes.six(Component::GroundSlab));
}
