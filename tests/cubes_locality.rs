//! What changing one voxel re-reads: 8 cubes under rule A, 64 under rule B, for every voxel and label of a few houses; and what the
//! decks that are walked on, which doors decide from afar, add to that.

use houscaper::cubes::{CubeKey, FaceNumber, Rule, corner_voxel, cube_key, cube_shape, scan_keys};
use houscaper::score::Walked;
use houscaper::voxels::{Direction, House, Label, read_storeys, samples};
use rayon::prelude::*;

/// The keys of all cubes of the padded array, x fastest; those that a scan passes over stay at the empty key.
fn keys(house: &House, rule: Rule, walked: impl Fn([usize; 3]) -> bool) -> Vec<CubeKey> {
    let [nx, ny, nz] = cube_shape(&house.voxels);
    let mut all = vec![CubeKey::default(); nx * ny * nz];
    scan_keys(&house.voxels, rule, walked, |[x, y, z], key| all[x + nx * (y + ny * z)] = key);
    all
}

/// Whether a scan visits the cube of a key: not when it is empty, nor when it is full without a slab.
fn is_visited(key: CubeKey) -> bool {
    let labels = key.labels();
    labels.iter().any(|l| l.is_filled()) && !labels.iter().all(|l| l.is_filled() && !l.is_slab())
}

/// The cubes that one voxel has a say in: those at its corners, and under rule B one more on every side.
fn around(voxel: [usize; 3], rule: Rule, shape: [usize; 3]) -> [[usize; 2]; 3] {
    let more = match rule {
        Rule::A => 0,
        Rule::B => 1,
    };
    [0, 1, 2].map(|a| [voxel[a].saturating_sub(more), (voxel[a] + 1 + more).min(shape[a] - 1)])
}

fn inside(cube: [usize; 3], range: [[usize; 2]; 3]) -> bool {
    (0..3).all(|a| (range[a][0]..=range[a][1]).contains(&cube[a]))
}

fn houses() -> Vec<(&'static str, House)> {
    let mut houses: Vec<_> = samples::all().into_iter().collect();
    houses.extend(samples::gallery().into_iter().filter(|(name, _)| ["gable", "stepped"].contains(name)));
    houses
}

/// Largest numbers of changed keys: with decks as they were, and with decks as the changed house has them.
fn check(name: &str, house: &House, voxel: [usize; 3], rule: Rule) -> [usize; 2] {
    let shape = cube_shape(&house.voxels);
    let cube = |n: usize| [n % shape[0], n / shape[0] % shape[1], n / shape[0] / shape[1]];
    let old = Walked::new(house, &read_storeys(house));
    let before = keys(house, rule, |v| old.has(v));
    let range = around(voxel, rule, shape);
    let most = match rule {
        Rule::A => 8,
        Rule::B => 64,
    };
    assert!(range.iter().map(|[a, b]| b + 1 - a).product::<usize>() <= most);
    let mut changed = [0; 2];
    for label in Label::ALL.into_iter().filter(|&l| l != house.voxels.get(voxel)) {
        let mut other = house.clone();
        other.voxels.set(voxel, label);
        let case = format!("{name} {voxel:?} {label:?} {rule:?}");

        // With the same decks walked on nothing beyond the neighbourhood changes, and reading it alone gives every key anew.
        let after = keys(&other, rule, |v| old.has(v));
        let differ: Vec<usize> = (0..before.len()).filter(|&n| before[n] != after[n]).collect();
        assert!(differ.iter().all(|&n| inside(cube(n), range)), "{case}");
        changed[0] = changed[0].max(differ.len());
        let mut patched = before.clone();
        for (n, key) in patched.iter_mut().enumerate().filter(|(n, _)| inside(cube(*n), range)) {
            let fresh = cube_key(&other.voxels, cube(n), rule, |v| old.has(v));
            *key = if is_visited(fresh) { fresh } else { CubeKey::default() };
        }
        assert_eq!(patched, after, "{case}");

        // With its own decks: elsewhere only walked bits change, in the cubes at decks that were walked on and are no more, or the reverse.
        let new = Walked::new(&other, &read_storeys(&other));
        let own = keys(&other, rule, |v| new.has(v));
        let differ: Vec<usize> = (0..before.len()).filter(|&n| before[n] != own[n]).collect();
        for &n in differ.iter().filter(|&&n| !inside(cube(n), range)) {
            assert_eq!((before[n].labels(), before[n].faces()), (own[n].labels(), own[n].faces()), "{case}");
            let flipped = (0..4).filter(|&q| before[n].walked(q) != own[n].walked(q));
            for q in flipped {
                let corner = houscaper::cubes::Corner::at([q as u8 & 1, q as u8 >> 1, 0]);
                let deck = corner_voxel(cube(n), corner).map(|c| c as usize);
                assert!(own[n].label(q).is_slab() && !own[n].label(q + 4).is_filled(), "{case}");
                assert_ne!(old.has(deck), new.has(deck), "{case}");
            }
        }
        assert_whole_decks(&other, &new, &case);
        changed[1] = changed[1].max(differ.len());
    }
    changed
}

/// Slabs without anything above that touch along a side are walked on all together or not at all.
fn assert_whole_decks(house: &House, walked: &Walked, case: &str) {
    let v = &house.voxels;
    for (at, label) in v.iter().filter(|(_, label)| label.is_slab()) {
        let [x, y, z] = at.map(|c| c as isize);
        let is_deck = |x: isize, y: isize| v.at([x, y, z]).is_slab() && !v.at([x, y, z + 1]).is_filled();
        if label == Label::Foundation || !is_deck(x, y) || !walked.has(at) {
            continue;
        }
        for d in Direction::ALL {
            let [dx, dy] = d.step();
            if is_deck(x + dx, y + dy) {
                assert!(walked.has([(x + dx) as usize, (y + dy) as usize, at[2]]), "{case}: deck at {at:?}");
            }
        }
    }
}

/// Every voxel, every label, both rules.
#[test]
fn one_voxel_re_reads_eight_cubes_or_sixty_four() {
    let mut widest = [[0; 2]; 2];
    for (name, house) in houses() {
        let [nx, ny, nz] = house.voxels.shape();
        let voxels: Vec<[usize; 3]> = (0..nx * ny * nz).map(|n| [n % nx, n / nx % ny, n / nx / ny]).collect();
        for (r, rule) in [Rule::A, Rule::B].into_iter().enumerate() {
            let worst = voxels
                .par_iter()
                .map(|&voxel| check(name, &house, voxel, rule))
                .reduce(|| [0; 2], |a, b| [a[0].max(b[0]), a[1].max(b[1])]);
            println!(
                "{name} {rule:?}: at most {} keys change, {} with the decks that doors decide",
                worst[0], worst[1]
            );
            widest[r] = [0, 1].map(|n| widest[r][n].max(worst[n]));
        }
    }
    assert_eq!(widest[0][0], 8, "under rule A the eight cubes at a voxel do change");
    assert!(widest[1][0] > 8 && widest[1][0] <= 64, "under rule B numbers change beyond them: {}", widest[1][0]);
    assert!(widest[1][1] > widest[1][0], "and a door decides over a whole deck: {}", widest[1][1]);
}

/// The bound of rule B is reached on each side: a voxel two away decides a number, one three away does not.
#[test]
fn the_neighbourhood_of_rule_b_is_as_small_as_stated() {
    // A level roof of base with a free edge all round, and a step up on it.
    let mut house = House::new(houscaper::voxels::VoxelArray::new([9, 9, 5]));
    for (x, y, z) in (2..7).flat_map(|x| (2..7).flat_map(move |y| (0..2).map(move |z| (x, y, z)))) {
        house.voxels.set([x, y, z], Label::Base);
    }
    (2..7).for_each(|y| (2..4).for_each(|x| house.voxels.set([x, y, 2], Label::Base)));
    let before = keys(&house, Rule::B, |_| false);
    let shape = cube_shape(&house.voxels);
    let mut reach = [[0isize; 2]; 3];
    for n in 0..9 * 9 * 5 {
        let voxel = [n % 9, n / 9 % 9, n / 81];
        let mut other = house.clone();
        let label = if house.voxels.get(voxel).is_filled() { Label::Empty } else { Label::Base };
        other.voxels.set(voxel, label);
        for (n, (a, b)) in before.iter().zip(keys(&other, Rule::B, |_| false)).enumerate() {
            let cube = [n % shape[0], n / shape[0] % shape[1], n / shape[0] / shape[1]];
            if *a != b {
                for axis in 0..3 {
                    let away = cube[axis] as isize - voxel[axis] as isize;
                    reach[axis] = [reach[axis][0].min(away), reach[axis][1].max(away)];
                }
            }
        }
    }
    assert_eq!(reach, [[-1, 2]; 3], "four cubes along each axis, and each of them is needed");
    assert!(before.iter().any(|key| key.faces().contains(&FaceNumber::End1)));
}
