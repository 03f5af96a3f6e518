//! What pokes out of a tile into the one below or above never meets what stands there.

#[path = "common/shells.rs"]
mod shells;
#[path = "common/solids.rs"]
mod solids_common;

use std::collections::BTreeSet;

use houscaper::cubes::{CubeKey, Rule, cube_key, cube_mask, cube_shape};
use houscaper::tiles::solids::{SolidStyle, body};
use houscaper::tiles::{Block, Shells};
use houscaper::voxels::{Label, VoxelArray, samples};
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;
use solids_common::overlap;

/// A house of one to three storeys on unions of two rectangles, each storey on the one below or jettied by a voxel, with a roof
/// whose layers draw in on all sides, on two, on one, or not at all.
fn drawn(rng: &mut ChaCha8Rng) -> Option<VoxelArray> {
    let shape = [12, 11, 26];
    let mut voxels = VoxelArray::new(shape);
    let mut rects: Vec<[usize; 4]> = (0..2).map(|_| rect(rng, [2, 2, 10, 9])).collect();
    let storeys = rng.random_range(1..=3);
    for s in 0..storeys {
        let plate = if s == 0 { Label::Foundation } else { Label::Floor };
        rects.iter().for_each(|r| fill(&mut voxels, *r, 6 * s, plate));
        for k in 6 * s + 1..6 * s + 6 {
            rects.iter().for_each(|r| fill(&mut voxels, *r, k, Label::Base));
        }
        rects.iter().for_each(|r| fill(&mut voxels, *r, 6 * s + 6, Label::Floor));
        match rng.random_range(0..4) {
            0 if s + 1 < storeys => rects = rects.iter().map(|r| rect(rng, *r)).collect(),
            1 if s + 1 < storeys => rects.iter_mut().for_each(|r| r[0] = r[0].max(2) - 1),
            2 if s + 1 < storeys => rects.truncate(1),
            _ => {}
        }
        if s + 1 < storeys {
            rects.iter().for_each(|r| fill(&mut voxels, *r, 6 * s + 6, Label::Floor));
        }
    }
    let [rise, shape_of_roof] = [rng.random_range(0..5), rng.random_range(0..4)];
    let mut layers = rects;
    for k in 6 * storeys + 1..=6 * storeys + rise {
        layers.iter().for_each(|r| fill(&mut voxels, *r, k, Label::Base));
        for r in &mut layers {
            *r = match shape_of_roof {
                0 => [r[0] + 1, r[1] + 1, r[2].max(1) - 1, r[3].max(1) - 1],
                1 => [r[0] + 1, r[1], r[2].max(1) - 1, r[3]],
                2 => [r[0], r[1] + 1, r[2], r[3]],
                _ => *r,
            };
        }
    }
    admissible(&voxels).then_some(voxels)
}

/// First and one past last x, y: within another, at least two modules wide.
fn rect(rng: &mut ChaCha8Rng, [x0, y0, x1, y1]: [usize; 4]) -> [usize; 4] {
    let mut span = |low: usize, high: usize| {
        let from = rng.random_range(low..=high.max(low + 2) - 2);
        (from, rng.random_range(from + 2..=high.max(from + 2)))
    };
    let ((a, c), (b, d)) = (span(x0, x1), span(y0, y1));
    [a, b, c, d]
}

/// Base does not replace a plate.
fn fill(voxels: &mut VoxelArray, [x0, y0, x1, y1]: [usize; 4], k: usize, label: Label) {
    for x in x0..x1 {
        for y in y0..y1 {
            voxels.set([x, y, k], label);
        }
    }
}

fn cubes(voxels: &VoxelArray) -> impl Iterator<Item = [usize; 3]> {
    let [nx, ny, nz] = cube_shape(voxels);
    (0..nz).flat_map(move |k| (0..ny).flat_map(move |j| (0..nx).map(move |i| [i, j, k])))
}

fn admissible(voxels: &VoxelArray) -> bool {
    cubes(voxels).all(|cube| cube_mask(voxels, cube).is_allowed())
}

/// Which of two tiles above each other meet, and how many pairs of tiles have blocks that poke out at all.
fn collisions(pairs: &BTreeSet<[CubeKey; 2]>, shells: &Shells) -> (Vec<String>, usize) {
    let (mut found, mut poking) = (Vec::new(), 0);
    for [upper, lower] in pairs {
        let [above, below] = [upper, lower].map(|key| body(*key, &SolidStyle::default(), shells));
        let down = |b: &&Block| b.bottom.iter().any(|z| *z < 0);
        let up = |b: &&Block| b.top.iter().any(|z| *z > 540_000);
        poking += usize::from(above.iter().any(|b| down(&b)) || below.iter().any(|b| up(&b)));
        let meet = |a: &Block, b: &Block| overlap(b, a, 540_000);
        let hit = above.iter().filter(down).find_map(|a| below.iter().find(|b| meet(a, b)).map(|b| (a, b)));
        let hit =
            hit.or_else(|| below.iter().filter(up).find_map(|b| above.iter().find(|a| meet(a, b)).map(|a| (a, b))));
        if let Some((a, b)) = hit {
            found.push(format!("{upper} above {lower}: {:?} meets {:?}", a.component, b.component));
        }
    }
    (found, poking)
}

#[test]
fn what_pokes_out_stays_clear_in_houses() {
    let mut rng = ChaCha8Rng::seed_from_u64(5);
    let mut houses: Vec<VoxelArray> = samples::all().into_iter().map(|(_, house)| house.voxels).collect();
    while houses.len() < 1000 {
        houses.extend(drawn(&mut rng));
    }
    let mut pairs = BTreeSet::new();
    for voxels in &houses {
        for rule in [Rule::A, Rule::B] {
            for [i, j, k] in cubes(voxels).filter(|cube| cube[2] > 0) {
                pairs.insert([k, k - 1].map(|k| cube_key(voxels, [i, j, k], rule, |_| false)));
            }
        }
    }
    let (found, poking) = collisions(&pairs, &shells::shells());
    println!(
        "{} houses, {} pairs of tiles above each other, {poking} with blocks that poke out",
        houses.len(),
        pairs.len()
    );
    assert!(poking > 200);
    assert!(found.is_empty(), "{}: {:#?}", found.len(), &found[..found.len().min(12)]);
}
