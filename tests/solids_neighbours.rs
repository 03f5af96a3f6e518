//! All solids of whole houses, with their stairs: no two share volume, also where they reach into the next cube.

mod blocks;

use std::collections::HashMap;

use blocks::{fault, overlap, shells};
use houscaper::cubes::{Rule, cube_key, cube_shape};
use houscaper::envelope::house_stairs;
use houscaper::tiles::Block;
use houscaper::tiles::solids::{Railing, SolidStyle, solids};
use houscaper::voxels::{House, Label, VoxelArray, read_storeys, samples};

/// Every block in house coordinates, with the cube it comes from (`None`: a stair).
fn placed(house: &House, style: &SolidStyle, walked: bool) -> Vec<(Option<[usize; 3]>, Block)> {
    let shells = shells();
    let mut all = Vec::new();
    let [nx, ny, nz] = cube_shape(&house.voxels);
    for cube in (0..nx * ny * nz).map(|i| [i % nx, i / nx % ny, i / nx / ny]) {
        let key = cube_key(&house.voxels, cube, Rule::B, |_| walked);
        let [dx, dy, dz] = [0, 1, 2].map(|a| (cube[a] as i32 - 1) * [900_000, 900_000, 540_000][a]);
        for mut block in solids(key, style, &shells) {
            block.plan.iter_mut().for_each(|p| *p = [p[0] + dx, p[1] + dy]);
            block.bottom.iter_mut().chain(&mut block.top).for_each(|z| *z += dz);
            all.push((Some(cube), block));
        }
    }
    let stairs = house_stairs(house, &read_storeys(house), style);
    all.extend(stairs.into_iter().flatten().map(|block| (None, block)));
    all
}

/// Pairs of blocks that share volume, among those that meet the same cell of a grid of 900 x 900 x 540 mm.
fn overlaps(all: &[(Option<[usize; 3]>, Block)]) -> Vec<(usize, usize)> {
    let mut grid: HashMap<[i32; 3], Vec<usize>> = HashMap::new();
    for (n, (_, block)) in all.iter().enumerate() {
        let span = |v: &mut dyn Iterator<Item = i32>, size: i32| {
            let (low, high) = v.fold((i32::MAX, i32::MIN), |(a, b), x| (a.min(x), b.max(x)));
            low.div_euclid(size)..=(high - 1).div_euclid(size)
        };
        for x in span(&mut block.plan.iter().map(|p| p[0]), 900_000) {
            for y in span(&mut block.plan.iter().map(|p| p[1]), 900_000) {
                for z in span(&mut block.bottom.iter().chain(&block.top).copied(), 540_000) {
                    grid.entry([x, y, z]).or_default().push(n);
                }
            }
        }
    }
    let mut found: Vec<(usize, usize)> = Vec::new();
    for cell in grid.values() {
        for (i, &m) in cell.iter().enumerate() {
            found.extend(cell[..i].iter().filter(|&&n| overlap(&all[m].1, &all[n].1)).map(|&n| (n, m)));
        }
    }
    found.sort_unstable();
    found.dedup();
    found
}

/// A gabled house with a lean-to against its gable, a flat-roofed wing and a mono-pitch: every way for a roof to end.
fn gables() -> House {
    let mut voxels = VoxelArray::new([14, 12, 12]);
    let mut fill = |x: [usize; 2], y: [usize; 2], k: [usize; 2], label: Label| {
        for z in k[0]..=k[1] {
            for (x, y) in (x[0]..=x[1]).flat_map(|x| (y[0]..=y[1]).map(move |y| (x, y))) {
                voxels.set([x, y, z], label);
            }
        }
    };
    fill([1, 12], [1, 10], [0, 0], Label::Foundation);
    fill([1, 7], [1, 5], [1, 7], Label::Base);
    fill([1, 7], [2, 4], [8, 8], Label::Base);
    fill([1, 7], [3, 3], [9, 9], Label::Base);
    // The lean-to and a level roof beside it.
    fill([8, 9], [1, 5], [1, 2], Label::Base);
    fill([10, 12], [1, 5], [1, 1], Label::Base);
    // A wing under a deck, with a slope that rises to one side. The eaves stay well above the deck: nothing in the cube of a railing
    // tells that eaves hang over it.
    fill([1, 4], [6, 10], [1, 2], Label::Base);
    fill([1, 4], [6, 8], [3, 3], Label::Floor);
    fill([1, 4], [10, 10], [3, 3], Label::Base);
    fill([3, 4], [1, 1], [2, 3], Label::Window);
    fill([6, 6], [5, 5], [1, 3], Label::Opening);
    House::new(voxels)
}

#[test]
fn houses_hold_no_two_things_in_one_place() {
    let base = SolidStyle::default();
    let bars = SolidStyle { railing: Railing::Bars, parapet_um: 0, overhang_um: 400_000, gutter: false, ..base };
    for (name, house) in samples::all().into_iter().chain([("gables", gables())]) {
        for (style, walked) in [(base, true), (base, false), (bars, true), (bars, false)] {
            let all = placed(&house, &style, walked);
            assert!(all.len() > 1_000, "{name}");
            for (cube, block) in &all {
                assert_eq!(fault(block), None, "{name} {cube:?} {block:?}");
            }
            let found = overlaps(&all);
            if let Some(&(n, m)) = found.first() {
                panic!("{name}, walked {walked}: {} overlaps, first\n{:?}\n{:?}", found.len(), all[n], all[m]);
            }
        }
    }
}

/// A block pushed into its neighbour is seen.
#[test]
fn an_overlap_is_seen() {
    let (_, house) = &samples::all()[0];
    let mut all = placed(house, &SolidStyle::default(), false);
    let last = all.len() - 1;
    all[last].1.plan.iter_mut().for_each(|p| *p = [p[0] - 100_000, p[1] - 100_000]);
    assert!(!overlaps(&all).is_empty());
}
