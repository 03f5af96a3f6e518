//! Houses out of massings: what another program drew becomes a house that keeps the rules.

use houscaper::search::dress::{DressError, Dressed, dress};
use houscaper::voxels::lattice::{Occupancy, read_lattice};
use houscaper::voxels::rules::{RuleSettings, check};
use houscaper::voxels::{Label, Module, Resample, VoxelArray, json, read_storeys, resample, vox};
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;

fn boxes(shape: [usize; 3], list: &[[usize; 6]]) -> VoxelArray {
    let mut voxels = VoxelArray::new(shape);
    for &[x, y, z, w, d, h] in list {
        for v in (z..z + h).flat_map(|z| (y..y + d).flat_map(move |y| (x..x + w).map(move |x| [x, y, z]))) {
            voxels.set(v, Label::Base);
        }
    }
    voxels
}

fn clean(dressed: &Dressed) {
    let broken = check(&dressed.house, &RuleSettings::default());
    assert!(broken.is_empty(), "{broken:?}, {:?}", dressed.notes);
}

fn reference(name: &str) -> Option<Vec<u8>> {
    let beside = std::path::PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../shared");
    let root = std::env::var_os("HOUSCAPER_SHARED").map_or(beside, std::path::PathBuf::from);
    let bytes = std::fs::read(root.join("reference").join(name)).ok();
    if bytes.is_none() {
        eprintln!("skipped: no reference file {name} (set HOUSCAPER_SHARED)");
    }
    bytes
}

#[test]
fn a_block_becomes_a_house_without_a_changed_voxel() {
    let dressed = dress(&boxes([9, 8, 14], &[[0, 0, 2, 9, 8, 12]]), &[]).expect("a block");
    clean(&dressed);
    assert_eq!((dressed.filled, dressed.emptied, dressed.notes.len()), (0, 0, 0), "{:?}", dressed.notes);
    let reading = read_storeys(&dressed.house);
    assert_eq!((reading.storeys.len(), dressed.house.stairs.len()), (2, 1));
    assert!(reading.openings.iter().any(|o| o.label == Label::Opening && o.storey == 0));
}

#[test]
fn a_shell_is_filled_and_a_court_stays_open() {
    let solid = boxes([10, 9, 12], &[[0, 0, 0, 10, 9, 12]]);
    let mut shell = solid.clone();
    for v in solid.iter().map(|(v, _)| v) {
        if (0..3).all(|a| v[a] > 0 && v[a] + 1 < solid.shape()[a]) {
            shell.set(v, Label::Empty);
        }
    }
    let (a, b) = (dress(&solid, &[]).expect("solid"), dress(&shell, &[]).expect("shell"));
    assert_eq!(a.house, b.house);
    let ring = boxes([13, 13, 6], &[[0, 0, 0, 13, 4, 6], [0, 9, 0, 13, 4, 6], [0, 4, 0, 4, 5, 6], [9, 4, 0, 4, 5, 6]]);
    let court = dress(&ring, &[]).expect("a ring");
    clean(&court);
    assert_eq!((court.filled, court.emptied), (0, 0));
}

#[test]
fn roofs_are_read_off_what_stands_on_top() {
    let walls = [0, 0, 0, 11, 7, 6];
    let step = |i: usize, gable: bool| {
        let x = if gable { 0 } else { i };
        [x, i, 6 + i, 11 - 2 * x, 7 - 2 * i, 1]
    };
    let top_layer = |gable: bool| {
        let mut list = vec![walls, [0, 0, 6, 11, 7, 1]];
        list.extend((0..4).map(|i| {
            let mut s = step(i, gable);
            s[2] += 1;
            s
        }));
        let dressed = dress(&boxes([11, 7, 11], &list), &[]).expect("a house");
        clean(&dressed);
        let voxels = dressed.house.voxels;
        voxels.iter().filter(|(v, l)| v[2] == 10 && l.is_filled()).count()
    };
    assert_eq!((top_layer(true), top_layer(false)), (11, 5), "a ridge from verge to verge, and one between hips");
    let flat = dress(&boxes([11, 7, 6], &[walls]), &[]).expect("a house");
    assert!(flat.house.voxels.iter().all(|(v, l)| v[2] <= 6 || !l.is_filled()));
}

#[test]
fn what_hangs_too_far_is_built_under_or_drawn_back() {
    let dressed = dress(&boxes([16, 8, 12], &[[0, 0, 0, 8, 8, 12], [8, 0, 6, 6, 8, 6]]), &[]).expect("a hook");
    clean(&dressed);
    assert!(dressed.notes.iter().any(|n| n.contains("cantilever")), "{:?}", dressed.notes);
    let thin = dress(&boxes([12, 12, 6], &[[0, 0, 0, 8, 8, 6], [8, 3, 0, 4, 1, 6], [3, 8, 0, 2, 3, 4]]), &[]);
    let thin = thin.expect("a block with fins");
    clean(&thin);
    assert!(!thin.notes.is_empty());
}

#[test]
fn nothing_and_too_much_are_refused() {
    assert_eq!(dress(&VoxelArray::new([4, 4, 4]), &[]), Err(DressError::Empty));
    assert_eq!(dress(&boxes([9, 9, 9], &[[0, 0, 0, 3, 3, 9]]), &[]), Err(DressError::NoStorey));
    assert_eq!(dress(&boxes([9, 9, 9], &[[0, 0, 0, 9, 9, 2]]), &[]), Err(DressError::NoStorey));
    assert_eq!(dress(&boxes([60, 5, 6], &[[0, 0, 0, 60, 5, 6]]), &[]), Err(DressError::TooWide(60)));
}

/// Random heaps of blocks: the same house every time, and a house that keeps every rule or an error.
#[test]
fn random_massings_become_houses() {
    let mut rng = ChaCha8Rng::seed_from_u64(5);
    let (mut made, mut storeys) = (0, [0; 5]);
    for round in 0..60 {
        let mut list = Vec::new();
        for _ in 0..rng.random_range(1..4) {
            let size = [rng.random_range(4..11), rng.random_range(4..11), rng.random_range(5..19)];
            list.push([rng.random_range(0..8), rng.random_range(0..8), 0, size[0], size[1], size[2]]);
        }
        let massing = boxes([19, 19, 19], &list);
        let Ok(dressed) = dress(&massing, &[]) else { continue };
        made += 1;
        let broken = check(&dressed.house, &RuleSettings::default());
        assert!(broken.is_empty(), "round {round}: {broken:?}, {:?}", dressed.notes);
        assert_eq!(dress(&massing, &[]).as_ref(), Ok(&dressed));
        storeys[read_storeys(&dressed.house).storeys.len()] += 1;
        assert_eq!(json::read(json::write(&dressed.house).as_bytes(), "house").expect("ours"), dressed.house);
    }
    assert!(made >= 50 && storeys[1] > 0 && storeys[2] > 0 && storeys[3] > 0, "{made} {storeys:?}");
}

#[test]
fn the_reference_model_becomes_a_house_of_two_storeys_under_a_saddle_roof() {
    let Some(bytes) = reference("vox/obj_house7.vox") else { return };
    let scene = vox::read(&bytes, "house7", &Default::default()).expect("a real file");
    let massing = vox::rescale(&scene.voxels, 0.28, Module::default()).expect("a size");
    let dressed = dress(&massing, &[]).expect("a house");
    clean(&dressed);
    assert_eq!(read_storeys(&dressed.house).storeys.len(), 2);
    // The ridge runs from verge to verge, four modules above the eaves.
    let ridge: Vec<_> =
        dressed.house.voxels.iter().filter(|(v, l)| v[2] == 16 && l.is_filled()).map(|(v, _)| v).collect();
    let width =
        |a: usize| ridge.iter().map(|v| v[a]).max().unwrap_or(0) - ridge.iter().map(|v| v[a]).min().unwrap_or(0) + 1;
    assert!(!ridge.is_empty() && width(0) <= 2 && width(1) >= 7, "{ridge:?}");
}

#[test]
fn the_reference_lattices_become_houses() {
    for (name, rule, cell, crop) in [
        ("lattices/voxelized_envelope_lowres.csv", "== True", [1, 1, 6], None),
        ("lattices/voxelized_bunny.csv", "== True", [3, 3, 6], None),
        ("lattices/abm_mcda_f_030.csv", ">= 0", [4, 4, 6], Some([[12, 1, 1], [16, 4, 3]])),
    ] {
        let Some(bytes) = reference(name) else { return };
        let lattice = read_lattice(&bytes, name).expect("a lattice");
        let occupied: Occupancy = rule.parse().expect("a rule");
        let how = Resample { cell_modules: Some(cell), crop, ..Resample::default() };
        let given = resample(&lattice, &occupied, &Module::default(), &how).expect("given voxels");
        let dressed = dress(&given.to_voxels(Module::default()), &given.mask).expect("a house");
        let broken = check(&dressed.house, &RuleSettings::default());
        assert!(broken.is_empty(), "{name}: {broken:?} {:?}", dressed.notes);
        assert_eq!(dressed.house.zones.len(), dressed.house.voxels.labels().len());
    }
}
