//! Solids of every key: convex, disjoint, and what the function of space says.

#[path = "common/shells.rs"]
mod shells;
#[path = "common/solids.rs"]
mod solids_common;

use houscaper::cubes::CubeKey;
use houscaper::tiles::solids::{Columns, SolidStyle, body, component_at};
use houscaper::tiles::{Block, Shells};
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;
use rayon::prelude::*;
use solids_common::{flaw, layered_keys, overlap, random_keys};

fn at(block: &Block, point: [f64; 3]) -> bool {
    let n = block.plan.len();
    let p = |i: usize| block.plan[i % n].map(f64::from);
    let inside = (0..n).all(|i| {
        let (a, b) = (p(i), p(i + 1));
        (b[0] - a[0]) * (point[1] - a[1]) - (b[1] - a[1]) * (point[0] - a[0]) > 0.0
    });
    // Height over the point by areas of a triangle that spans the plane.
    let height = |z: &[i32]| {
        let (a, b, c) = (p(0), p(1), p(2));
        let det = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
        let u = ((point[0] - a[0]) * (c[1] - a[1]) - (point[1] - a[1]) * (c[0] - a[0])) / det;
        let v = ((b[0] - a[0]) * (point[1] - a[1]) - (b[1] - a[1]) * (point[0] - a[0])) / det;
        f64::from(z[0]) + u * f64::from(z[1] - z[0]) + v * f64::from(z[2] - z[0])
    };
    inside && height(&block.bottom) < point[2] && point[2] < height(&block.top)
}

fn check(key: CubeKey, shells: &Shells) -> Result<usize, String> {
    let style = SolidStyle::default();
    let blocks = body(key, &style, shells);
    for (n, block) in blocks.iter().enumerate() {
        if let Some(flaw) = flaw(block) {
            return Err(format!("{key}: {flaw} of {block:?}"));
        }
        if let Some(other) = blocks[..n].iter().find(|other| overlap(other, block, 0)) {
            return Err(format!("{key}: {block:?} overlaps {other:?}"));
        }
    }
    let columns = Columns::new(key, shells);
    let mut rng = ChaCha8Rng::seed_from_u64(key.bits());
    for _ in 0..30 {
        // Odd coordinates lie on no line or plane of the arrangement but its diagonals.
        let mut point = [0, 1].map(|_| 1 + 2 * rng.random_range(0..450_000)).to_vec();
        point.push(1 + 2 * rng.random_range(-200_000..350_000));
        let point: [i32; 3] = [point[0], point[1], point[2]];
        if (point[0] - 450_000).abs() == (point[1] - 450_000).abs() {
            continue;
        }
        let found: Vec<&Block> = blocks.iter().filter(|b| at(b, point.map(f64::from))).collect();
        let said = component_at(&columns, &style, point);
        if found.len() > 1 || found.first().map(|b| (b.component, b.octant)) != said {
            return Err(format!("{key}: at {point:?} {found:?}, expected {said:?}"));
        }
    }
    Ok(blocks.len())
}

fn prove(name: &str, keys: &[CubeKey]) {
    let shells = shells::shells();
    let results: Vec<Result<usize, String>> = keys.par_iter().map(|key| check(*key, &shells)).collect();
    let flaws: Vec<&String> = results.iter().filter_map(|r| r.as_ref().err()).collect();
    let counts: Vec<usize> = results.iter().filter_map(|r| r.as_ref().ok()).copied().collect();
    let (sum, most) = (counts.iter().sum::<usize>(), counts.iter().max().copied().unwrap_or(0));
    println!("{name}: {} keys, blocks per tile {:.1} mean, {most} at most", keys.len(), sum as f64 / keys.len() as f64);
    assert!(flaws.is_empty(), "{} of {}: {:#?}", flaws.len(), keys.len(), &flaws[..flaws.len().min(5)]);
}

#[test]
fn every_layered_key_is_disjoint_convex_blocks() {
    prove("layered", &layered_keys(&mut ChaCha8Rng::seed_from_u64(3)));
}

#[test]
fn any_labels_are_disjoint_convex_blocks() {
    prove("random", &random_keys(&mut ChaCha8Rng::seed_from_u64(4), 20_000));
}

#[test]
fn an_overlap_and_a_flaw_are_seen() {
    let low = Block::cuboid(houscaper::tiles::Component::Cladding, 0, [0; 3], [100, 100, 100]);
    let beside = Block::cuboid(houscaper::tiles::Component::Cladding, 0, [100, 0, 0], [200, 100, 100]);
    let through = Block::cuboid(houscaper::tiles::Component::Cladding, 0, [50, 50, 50], [150, 150, 150]);
    assert!(!overlap(&low, &beside, 0) && overlap(&low, &through, 0) && !overlap(&low, &through, 50));
    assert_eq!(flaw(&low), None);
    assert_eq!(flaw(&Block { top: vec![100, 100, 100, 99], ..low.clone() }), Some("planarity"));
    assert_eq!(flaw(&Block { plan: low.plan.iter().rev().copied().collect(), ..low }), Some("convexity"));
}
