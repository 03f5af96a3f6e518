//! What a survey costs, in counts that do not depend on the machine: cubes visited, keys learnt, solids made.

use std::collections::BTreeSet;

use houscaper::cubes::{CubeKey, Rule, cube_labels, cube_shape, scan_keys};
use houscaper::envelope::{KeyCache, KeyedSurface, VolumeTable, Volumes, survey_keys};
use houscaper::tiles::Style;
use houscaper::voxels::{VoxelArray, samples};

const SURFACE: KeyedSurface = KeyedSurface {
    style: Style { decks: true, name: "architectural", ..Style::SURFACE_2 },
    rule: Rule::B,
    edges: None,
};

/// Cubes in which something stands, and the keys among them, by looking at each cube.
fn standing(voxels: &VoxelArray) -> (usize, BTreeSet<u64>) {
    let [nx, ny, nz] = cube_shape(voxels);
    let (mut count, mut keys) = (0, BTreeSet::new());
    for n in 0..nx * ny * nz {
        let cube = [n % nx, n / nx % ny, n / nx / ny];
        let labels = cube_labels(voxels, cube);
        let any = labels.iter().any(|l| l.is_filled());
        if any && !labels.iter().all(|l| l.is_filled() && !l.is_slab()) {
            count += 1;
            keys.insert(houscaper::cubes::cube_key(voxels, cube, Rule::B, |_| false).bits());
        }
    }
    (count, keys)
}

#[test]
fn a_scan_visits_each_cube_that_holds_something_once_and_no_other() {
    for (name, house) in samples::all().into_iter().chain(samples::gallery()) {
        let (count, keys) = standing(&house.voxels);
        let (mut visited, mut met, mut last) = (0, BTreeSet::new(), None);
        let [nx, ny, _] = cube_shape(&house.voxels);
        scan_keys(
            &house.voxels,
            Rule::B,
            |_| false,
            |[x, y, z], key| {
                visited += 1;
                met.insert(key.bits());
                let at = x + nx * (y + ny * z);
                assert!(last.is_none_or(|last| last < at), "{name}: in order, none twice");
                last = Some(at);
            },
        );
        assert_eq!((visited, &met), (count, &keys), "{name}");
        let cubes = cube_shape(&house.voxels).iter().product::<usize>();
        assert!(visited * 5 < cubes * 3, "{name}: {visited} of {cubes} cubes; a house is mostly air and rooms");

        let mut cache = KeyCache::default();
        let first = survey_keys(&house.voxels, &SURFACE, |_| false, &mut cache).expect("a house has tiles");
        assert_eq!(cache.len(), keys.len(), "{name}: one entry for each key");
        assert_eq!(
            cache.counts().map(|(_, count)| count as usize).sum::<usize>(),
            count,
            "{name}: each cube counted once"
        );
        let again = survey_keys(&house.voxels, &SURFACE, |_| false, &mut cache).expect("a house has tiles");
        assert_eq!((first, cache.len()), (again, keys.len()), "{name}: nothing is learnt twice");
    }
}

#[test]
fn solids_are_asked_for_once_for_each_key_of_all_houses() {
    let (mut cache, mut table) = (KeyCache::default(), VolumeTable::default());
    let mut asked: Vec<CubeKey> = Vec::new();
    let mut known = BTreeSet::new();
    for round in 0..2 {
        for (name, house) in samples::all() {
            survey_keys(&house.voxels, &SURFACE, |_| false, &mut cache).expect("a house has tiles");
            let here: Vec<u64> = cache.counts().map(|(key, _)| key.bits()).collect();
            let new = here.iter().filter(|bits| !known.contains(*bits)).count();
            let before = asked.len();
            table.sum(&cache, |key| {
                asked.push(key);
                Volumes::default()
            });
            assert_eq!(asked.len() - before, new, "{name}, round {round}");
            assert!(round == 0 || new == 0);
            known.extend(here);
        }
    }
    assert_eq!((table.len(), table.is_empty()), (known.len(), false));
    assert!(asked.len() < 600, "{} keys in four houses", asked.len());
}
