//! Ten thousand rule-respecting houses, drawn as the search draws them: every envelope is a closed, oriented 2-manifold.

use std::path::Path;

use houscaper::envelope::{areas, manifold_report, mesh, volume};
use houscaper::search::massing::{Design, encode};
use houscaper::search::moves::Move;
use houscaper::search::plot::{ChoiceSpace, Plot, Programme, Space};
use houscaper::search::start::start;
use houscaper::tiles::Tileset;
use houscaper::voxels::rules::{RuleSettings, Scratch, violation};
use houscaper::voxels::{House, read_storeys};
use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;
use rayon::prelude::*;

const HOUSES: u64 = 10_000;

fn space() -> Space {
    let plot = Plot::new([14, 11, 20], None).expect("a plot");
    let programme = Programme { floor_area_m2: [40.0, 160.0], storeys: [1, 2], ..Programme::default() };
    Space::new(plot, programme, ChoiceSpace::default()).expect("a space")
}

/// A start and a few moves from it.
fn draw(space: &Space, seed: u64) -> House {
    let mut rng = ChaCha8Rng::seed_from_u64(seed);
    let mut design: Design = start(space, &mut rng).expect("a start");
    for _ in 0..seed % 6 {
        if let Some(next) = Move::draw(&mut rng).apply(&design, space, &mut rng) {
            design = next;
        }
    }
    encode(&design.massing, &space.plot)
}

#[test]
fn ten_thousand_houses_keep_the_rules_and_are_closed() {
    let tilesets = ["surface-1", "surface-2"].map(|name| {
        Tileset::load(&Path::new(env!("CARGO_MANIFEST_DIR")).join("tilesets").join(name)).expect("a shipped tileset")
    });
    let (space, settings) = (space(), RuleSettings::default());
    let wrong: Vec<u64> = (0..HOUSES)
        .into_par_iter()
        .filter(|&seed| {
            let house = draw(&space, seed);
            let broken = violation(&house, &read_storeys(&house), &settings, &mut Scratch::default()) > 0.0;
            let open = tilesets.iter().any(|tiles| {
                let mesh = mesh(&house.voxels, tiles).expect("every cube has a tile");
                let areas = areas(&house.voxels, tiles).expect("every cube has a tile");
                let agrees = (volume(&mesh) - areas.volume_m3).abs() <= 1e-9 * areas.volume_m3;
                !manifold_report(&mesh).is_closed_manifold() || !agrees
            });
            broken || open
        })
        .collect();
    assert!(wrong.is_empty(), "{} of {HOUSES} houses, seeds {:?}", wrong.len(), &wrong[..wrong.len().min(10)]);
}

#[test]
fn a_house_with_a_missing_triangle_is_not_closed() {
    let tiles = Tileset::load(&Path::new(env!("CARGO_MANIFEST_DIR")).join("tilesets/surface-2")).expect("a tileset");
    let mut mesh = mesh(&draw(&space(), 1).voxels, &tiles).expect("every cube has a tile");
    assert!(manifold_report(&mesh).is_closed_manifold());
    mesh.triangles.pop();
    mesh.surfaces.pop();
    assert!(!manifold_report(&mesh).is_closed_manifold());
}
