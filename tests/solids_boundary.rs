//! Boundaries of solids: closed, oriented, and they enclose exactly what their blocks fill.

#[path = "common/shells.rs"]
mod shells;
#[path = "common/solids.rs"]
mod solids_common;

use std::collections::BTreeMap;

use houscaper::cubes::CubeKey;
use houscaper::tiles::solids::{Polygon3, SolidStyle, body, boundary, six_volumes};
use houscaper::tiles::{Block, Component, Shells};
use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;
use rayon::prelude::*;
use solids_common::{layered_keys, random_keys};

/// Directed edges without their reverse.
fn open_edges(polygons: &[Polygon3]) -> usize {
    let mut edges: BTreeMap<([i32; 3], [i32; 3]), i32> = BTreeMap::new();
    for polygon in polygons {
        for (n, &a) in polygon.iter().enumerate() {
            let b = polygon[(n + 1) % polygon.len()];
            *edges.entry((a.min(b), a.max(b))).or_default() += if a < b { 1 } else { -1 };
        }
    }
    edges.values().filter(|count| **count != 0).count()
}

fn is_planar(polygon: &Polygon3) -> bool {
    let edge = |n: usize| [0, 1, 2].map(|a| i128::from(polygon[n][a]) - i128::from(polygon[0][a]));
    let cross = |u: [i128; 3], v: [i128; 3]| {
        [0, 1, 2].map(|i| u[(i + 1) % 3] * v[(i + 2) % 3] - u[(i + 2) % 3] * v[(i + 1) % 3])
    };
    let normals = (1..polygon.len() - 1).map(|n| cross(edge(n), edge(n + 1)));
    let normal = normals.fold([0; 3], |sum: [i128; 3], n| [0, 1, 2].map(|i| sum[i] + n[i]));
    normal != [0; 3] && (1..polygon.len()).all(|n| (0..3).map(|i| edge(n)[i] * normal[i]).sum::<i128>() == 0)
}

/// Groups of blocks by component, and by component and octant.
fn groups(blocks: &[Block]) -> Vec<Vec<Block>> {
    let mut groups: BTreeMap<(Component, Option<u8>), Vec<Block>> = BTreeMap::new();
    for block in blocks {
        groups.entry((block.component, None)).or_default().push(block.clone());
        groups.entry((block.component, Some(block.octant))).or_default().push(block.clone());
    }
    groups.into_values().collect()
}

fn check(key: CubeKey, shells: &Shells) -> Result<[usize; 2], String> {
    let mut count = [0; 2];
    for group in groups(&body(key, &SolidStyle::default(), shells)) {
        let what = group[0].component;
        let polygons = boundary(&group);
        count[0] += 1;
        count[1] += polygons.len();
        if !polygons.iter().all(is_planar) {
            return Err(format!("{key}: a polygon of {what:?} is not planar"));
        }
        let open = open_edges(&polygons);
        if open > 0 {
            return Err(format!("{key}: {open} open edges of {what:?}"));
        }
        let filled: i128 = group.iter().map(Block::six_volumes).sum();
        if six_volumes(&polygons) != filled {
            return Err(format!("{key}: {what:?} encloses {} and fills {filled}", six_volumes(&polygons)));
        }
    }
    Ok(count)
}

fn prove(name: &str, keys: &[CubeKey]) {
    let shells = shells::shells();
    let results: Vec<Result<[usize; 2], String>> = keys.par_iter().map(|key| check(*key, &shells)).collect();
    let flaws: Vec<&String> = results.iter().filter_map(|r| r.as_ref().err()).collect();
    let sums = results.iter().filter_map(|r| r.as_ref().ok()).fold([0; 2], |s, c| [s[0] + c[0], s[1] + c[1]]);
    println!("{name}: {} keys, {} solids, {} polygons", keys.len(), sums[0], sums[1]);
    assert!(flaws.is_empty(), "{} of {}: {:#?}", flaws.len(), keys.len(), &flaws[..flaws.len().min(5)]);
}

#[test]
fn every_layered_solid_is_closed_and_exact() {
    prove("layered", &layered_keys(&mut ChaCha8Rng::seed_from_u64(3)));
}

#[test]
fn solids_of_any_labels_are_closed_and_exact() {
    prove("random", &random_keys(&mut ChaCha8Rng::seed_from_u64(4), 20_000));
}

#[test]
fn shared_faces_cancel_in_whole_and_in_part() {
    let cuboid = |low, high| Block::cuboid(Component::Cladding, 0, low, high);
    let one = cuboid([0; 3], [100, 100, 100]);
    assert_eq!(boundary(std::slice::from_ref(&one)).len(), 6);
    let beside = boundary(&[one.clone(), cuboid([100, 0, 0], [200, 100, 100])]);
    assert_eq!(beside.len(), 10, "the shared face is gone");
    let part = boundary(&[one.clone(), cuboid([100, 20, 0], [200, 80, 50])]);
    assert_eq!((open_edges(&part), six_volumes(&part)), (0, 6 * (1_000_000 + 100 * 60 * 50)));
    assert_eq!(boundary(&[one.clone(), cuboid([200, 0, 0], [300, 100, 100])]).len(), 12);
    let mut torn = boundary(&[one]);
    torn.pop();
    assert_eq!(open_edges(&torn), 4, "a missing face is seen");
}
