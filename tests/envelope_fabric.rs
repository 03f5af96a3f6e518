//! The fabric of the sample houses: every component closes and holds what its blocks hold.

#[path = "common/shells.rs"]
mod shells;

use houscaper::cubes::{Rule, scan_keys};
use houscaper::envelope::{CUBE_UM, Fabric, house_stairs};
use houscaper::export::{Exploded, Palette, Storeys, from_fabric, from_parts, to_glb};
use houscaper::tiles::solids::{SolidStyle, solids};
use houscaper::tiles::{Block, Component};
use houscaper::voxels::{House, Label, VoxelArray, read_storeys, samples};
use serde_json::Value;

fn fabric(house: &House) -> Fabric {
    let (style, shells) = (SolidStyle::default(), shells::shells());
    let mut keys = Vec::new();
    // Decks are walked on where a door leads onto them: the same storey has one beside the deck.
    let walked = |[x, y, z]: [usize; 3]| {
        [[1, 0], [-1, 0], [0, 1], [0, -1]].into_iter().any(|[dx, dy]: [isize; 2]| {
            (1..8)
                .any(|n| house.voxels.at([x as isize + n * dx, y as isize + n * dy, z as isize + 1]) == Label::Opening)
        })
    };
    scan_keys(&house.voxels, Rule::B, walked, |cube, key| keys.push((cube, key)));
    let mut fabric = Fabric::new(&house.voxels, keys, |key| solids(key, &style, &shells).into());
    for blocks in house_stairs(house, &read_storeys(house), &style) {
        fabric.add_standing(&blocks);
    }
    fabric
}

/// A block in every octant of every filled voxel fills the house exactly.
#[test]
fn blocks_of_octants_make_the_voxels() {
    let house = samples::l_house();
    let octants = |key: houscaper::cubes::CubeKey| -> std::sync::Arc<[Block]> {
        (0..8u8)
            .filter(|&o| key.label(o.into()).is_filled())
            .map(|o| {
                let low = [0, 1, 2].map(|a| (i32::from(o) >> a & 1) * CUBE_UM[a] as i32 / 2);
                Block::cuboid(Component::Cladding, o, low, [0, 1, 2].map(|a| low[a] + CUBE_UM[a] as i32 / 2))
            })
            .collect()
    };
    let [nx, ny, nz] = houscaper::cubes::cube_shape(&house.voxels);
    let keys = (0..nx * ny * nz).map(|i| {
        let cube = [i % nx, i / nx % ny, i / nx / ny];
        (cube, houscaper::cubes::CubeKey::of_labels(houscaper::cubes::cube_labels(&house.voxels, cube)))
    });
    let fabric = Fabric::new(&house.voxels, keys, octants);
    let voxel = CUBE_UM.iter().map(|&c| i128::from(c)).product::<i128>() * 6;
    assert_eq!(fabric.six_volumes()[Component::Cladding as usize], voxel * house.voxels.filled_count() as i128);
    let by_voxel = fabric.six_volumes_by_voxel();
    assert!(by_voxel.values().all(|&v| v == voxel));
    assert_eq!(by_voxel.len(), house.voxels.filled_count());
    let solid = fabric.merge(&fabric.placed).expect("disjoint");
    assert_eq!(solid.six_volumes(), voxel * house.voxels.filled_count() as i128);
    assert_eq!(solid.report().open_edges, 0);
    let mut stretched = VoxelArray::new([1; 3]);
    stretched.module.size_m = [0.6, 0.9, 0.54];
    let small = Fabric::new(&stretched, [], octants);
    assert!((small.metres([900_000, 0, 540_000])[0] - 0.6).abs() < 1e-12);
}

#[test]
fn every_component_of_the_samples_closes() {
    for (name, house) in samples::all() {
        let fabric = fabric(&house);
        let sums = fabric.six_volumes();
        let started = std::time::Instant::now();
        let merged = fabric.merge_groups(|b| b.component).unwrap_or_else(|e| panic!("{name}: {e}"));
        let time = started.elapsed();
        let triangles: usize = merged.iter().map(|(_, s)| s.triangle_count()).sum();
        let crowded: usize = merged.iter().map(|(_, s)| s.report().crowded_edges).sum();
        println!(
            "{name}: {} blocks, {} tiles, {triangles} triangles, {crowded} crowded edges, merged in {time:?}",
            fabric.placed.len(),
            fabric.tiles.len(),
        );
        for (component, solid) in &merged {
            assert_eq!(solid.report().open_edges, 0, "{name}: {}", component.name());
            assert_eq!(solid.six_volumes(), sums[*component as usize], "{name}: {}", component.name());
        }
    }
}

#[test]
fn scenes_hold_every_component_and_parts_move_apart() {
    let house = samples::hip_house();
    let fabric = fabric(&house);
    let palette = Palette::default();
    let scene = from_fabric(&fabric, &palette, Storeys::Together, Value::Null).expect("disjoint");
    let held = fabric.six_volumes();
    let names: Vec<&str> = Component::ALL.iter().filter(|&&c| held[c as usize] > 0).map(|c| c.name()).collect();
    assert_eq!(scene.parts.iter().map(|p| p.name.as_str()).collect::<Vec<_>>(), names);
    assert!(to_glb(&scene).is_ok());
    let apart = from_fabric(&fabric, &palette, Storeys::Apart, Value::Null).expect("disjoint");
    assert!(apart.parts.iter().any(|p| p.name == "cladding_1"));
    let parts: Vec<Option<u32>> = fabric.placed.iter().map(|b| Some((b.voxel[2].max(0) / 6) as u32)).collect();
    let moved = from_parts(&fabric, &parts, |n| format!("storey{n}"), |_| None, &palette, Exploded::default())
        .expect("disjoint");
    let [low, high] = moved.bounds().expect("parts");
    let [base, top] = scene.bounds().expect("parts");
    assert!((low[2] - base[2]).abs() < 1e-9 && high[2] > top[2] + 3.9, "the roof storey is lifted twice 2 m");
}

/// Faces with tags are the same surface: closed without a gap where tags meet, of the same volume, each tag with its own part of the
/// same outer area, and with one tag the very same faces.
#[test]
fn tagged_faces_make_the_same_surface() {
    for (name, house) in samples::all() {
        let fabric = fabric(&house);
        let labels: Vec<u32> =
            fabric.placed.iter().map(|p| house.voxels.at(p.voxel.map(|v| v as isize)) as u32).collect();
        let plain = fabric.gather_groups(|p| p.layer).expect("disjoint");
        let area = |solid: &houscaper::envelope::Solid| solid.faces.iter().map(|f| solid.area_m2(f)).sum::<f64>();
        let mut tagged = 0;
        for ((layer, own), (other, whole)) in fabric.gather_tagged(&labels).expect("disjoint").iter().zip(&plain) {
            assert_eq!(layer, other, "{name}");
            assert_eq!(own.solid.six_volumes(), whole.solid.six_volumes(), "{name} layer {layer}");
            assert_eq!(own.solid.report().open_edges, 0, "{name} layer {layer}");
            // What touches with unequal faces may leave some inside, which adds area and no volume.
            assert!(area(&own.solid) >= area(&whole.solid) - 1e-9, "{name} layer {layer}");
            tagged += usize::from(own.solid.faces.iter().any(|f| f.tag != own.solid.faces[0].tag));
        }
        assert!(tagged > 3, "{name}: {tagged} layers of several labels");
        let single = fabric.gather_tagged(&vec![0; fabric.placed.len()]).expect("disjoint");
        for ((_, own), (layer, whole)) in single.iter().zip(&plain) {
            assert!((area(&own.solid) - area(&whole.solid)).abs() < 1e-9, "{name} layer {layer}");
        }
    }
}
