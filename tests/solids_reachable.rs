//! The exhaustive proof of the architectural tiles: every key that the rules allow, whole solids (body, infill and edges), both
//! shipped styles, rules A and B.

#[path = "common/shells.rs"]
mod shells;
#[path = "common/solids.rs"]
mod solids_common;

use std::collections::BTreeMap;
use std::path::Path;

use houscaper::cubes::{CubeKey, reachable_keys, reachable_labels};
use houscaper::tiles::solids::{SolidStyle, boundary, six_volumes, solids};
use houscaper::tiles::{Block, Component, StyleSet};
use solids_common::{flaw, overlap};

/// The shipped styles as their manifests give them.
fn styles() -> [(String, SolidStyle); 2] {
    ["architectural", "larch"].map(|name| {
        let dir = Path::new(env!("CARGO_MANIFEST_DIR")).join("tilesets").join(name);
        let set = StyleSet::load(&dir).unwrap_or_else(|e| panic!("{e}"));
        (set.name, set.style)
    })
}

/// Rule B's keys and, where they are others, rule A's.
fn keys() -> Vec<CubeKey> {
    let mut keys = reachable_keys();
    keys.extend(reachable_labels().into_iter().map(CubeKey::of_labels));
    keys.sort_unstable();
    keys.dedup();
    keys
}

/// Runs `prove` over the keys on two threads; sums of what it counts.
fn over(keys: &[CubeKey], prove: impl Fn(CubeKey) -> [usize; 3] + Sync) -> [usize; 3] {
    let halves = keys.split_at(keys.len() / 2);
    let run = |part: &[CubeKey]| {
        part.iter().fold([0; 3], |sum, key| {
            let found = prove(*key);
            [0, 1, 2].map(|n| sum[n] + found[n])
        })
    };
    let (first, second) = std::thread::scope(|scope| {
        let other = scope.spawn(|| run(halves.1));
        (run(halves.0), other.join().unwrap_or_else(|e| std::panic::resume_unwind(e)))
    });
    [0, 1, 2].map(|n| first[n] + second[n])
}

/// Convex pieces of positive volume of which no two share space have no self-intersection, whatever is glued of them.
#[test]
fn all_blocks_are_valid_and_disjoint() {
    let (keys, shells) = (keys(), shells::shells());
    for (name, style) in styles() {
        let [blocks, pairs, bad] = over(&keys, |key| {
            let blocks = solids(key, &style, &shells);
            let mut bad = 0;
            for (n, block) in blocks.iter().enumerate() {
                assert_eq!(flaw(block), None, "{name} {key} {block:?}");
                for other in blocks[..n].iter().filter(|b| overlap(b, block, 0)) {
                    bad += 1;
                    println!("{name} {key}: {block:?}\n and {other:?}");
                }
            }
            [blocks.len(), blocks.len() * blocks.len().saturating_sub(1) / 2, bad]
        });
        println!("{name}: {} keys, {blocks} blocks, {pairs} pairs, {bad} of them overlap", keys.len());
        assert_eq!(bad, 0, "{name}");
    }
}

/// Whether each directed edge occurs as often as its reverse.
fn is_closed(polygons: &[Vec<[i32; 3]>]) -> bool {
    let mut edges: Vec<([[i32; 3]; 2], i32)> = Vec::new();
    for polygon in polygons {
        for (n, a) in polygon.iter().enumerate() {
            let b = polygon[(n + 1) % polygon.len()];
            edges.push(if *a < b { ([*a, b], 1) } else { ([b, *a], -1) });
        }
    }
    edges.sort_unstable();
    edges.chunk_by(|a, b| a.0 == b.0).all(|same| same.iter().map(|e| e.1).sum::<i32>() == 0)
}

/// The solid of each component and octant: closed, oriented (positive, exactly the sum of its blocks).
#[test]
fn all_solids_are_closed_and_of_exact_volume() {
    let (keys, shells) = (keys(), shells::shells());
    for (name, style) in styles() {
        let [solid, polygons, inexact] = over(&keys, |key| {
            let mut parts: BTreeMap<(Component, u8), Vec<Block>> = BTreeMap::new();
            for block in solids(key, &style, &shells) {
                parts.entry((block.component, block.octant)).or_default().push(block);
            }
            let mut counts = [parts.len(), 0, 0];
            for (part, blocks) in &parts {
                let outside = boundary(blocks);
                counts[1] += outside.len();
                assert!(is_closed(&outside), "{name} {key} {part:?}");
                let volume = blocks.iter().map(Block::six_volumes).sum::<i128>();
                let drawn = six_volumes(&outside);
                assert!(volume > 0 && drawn > 0, "{name} {key} {part:?}");
                // A corner off the µm grid is rounded: at most 1 µm over the faces around it, 1e-9 m3.
                assert!((volume - drawn).abs() < 6_000_000_000, "{name} {key} {part:?}: {volume} {drawn}");
                counts[2] += usize::from(volume != drawn);
            }
            counts
        });
        println!("{name}: {} keys, {solid} solids of {polygons} polygons, {inexact} rounded", keys.len());
        assert_eq!(inexact, 0, "{name}");
    }
}

/// The proof can fail.
#[test]
fn a_broken_cube_is_seen() {
    let (_, style) = &styles()[0];
    let key = *keys().iter().max_by_key(|k| solids(**k, style, &shells::shells()).len()).unwrap_or_else(|| panic!());
    let blocks = solids(key, style, &shells::shells());
    let outside = boundary(&blocks[..1]);
    assert!(is_closed(&outside) && !is_closed(&outside[1..]));
    let mut turned = blocks[0].clone();
    turned.plan.reverse();
    assert!(flaw(&turned).is_some());
    assert!(overlap(&blocks[0], &blocks[0], 0));
}
