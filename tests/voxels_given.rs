//! Lattices resampled to modules, and the repair of inadmissible cubes.

use std::path::PathBuf;

use houscaper::voxels::lattice::{Lattice, Occupancy, Values, read_lattice};
use houscaper::voxels::rules::{self, RuleSettings};
use houscaper::voxels::{GivenError, House, Label, Module, Resample, VoxelArray, repair, resample, samples};

fn zones() -> (Lattice, Occupancy) {
    // Two cells by one by three; the lowest layer is empty.
    let values = Values::Number(vec![-1.0, -1.0, 0.0, 2.0, 1.0, -1.0]);
    let lattice = Lattice::new([2, 1, 3], [0.0; 3], [1.8, 2.0, 3.24], values).expect("six cells");
    (lattice, ">= 0".parse().expect("a rule"))
}

fn bad_cubes(voxels: &VoxelArray) -> usize {
    let list = rules::check(&House::new(voxels.clone()), &RuleSettings::default());
    list.iter().filter(|v| v.rule == "cubes-admissible").count()
}

#[test]
fn cells_become_modules_and_the_scale_is_reported() {
    let (lattice, rule) = zones();
    let given = resample(&lattice, &rule, &Module::default(), &Resample::default()).expect("a fit");
    assert_eq!(given.report.cell_modules, [2, 2, 6], "1.8 / 0.9, 2.0 / 0.9 = 2.2, 3.24 / 0.54");
    assert!((given.report.error_m[1] + 0.2).abs() < 1e-12 && given.report.error_m[0].abs() < 1e-12);
    assert!((given.report.scale[1] - 0.9).abs() < 1e-12);
    assert_eq!(given.shape, [4, 2, 12], "the empty layer sank into the ground");
    let at = |x: usize, y: usize, z: usize| given.mask[x + 4 * (y + 2 * z)];
    assert_eq!([at(0, 0, 0), at(3, 1, 5), at(1, 1, 6), at(2, 0, 6)], [0, 2, 1, -1]);
    let voxels = given.to_voxels(Module::default());
    assert_eq!([voxels.get([0, 0, 0]), voxels.get([0, 0, 6])], [Label::Foundation, Label::Floor]);
    assert_eq!(voxels.filled_count(), 3 * 24);
}

#[test]
fn offset_crop_and_modules_are_kept() {
    let (lattice, rule) = zones();
    let how = Resample {
        cell_modules: Some([3, 3, 2]),
        offset: [1, 2, 1],
        ground: false,
        crop: Some([[1, 0, 1], [2, 1, 3]]),
    };
    let given = resample(&lattice, &rule, &Module::default(), &how).expect("a fit");
    assert_eq!(given.shape, [4, 5, 5]);
    let filled: Vec<_> = (0..given.mask.len()).filter(|&i| given.mask[i] >= 0).collect();
    assert_eq!((filled.len(), filled[0], given.report.cells), (18, 1 + 4 * (2 + 5), 1));
}

#[test]
fn what_cannot_be_given_is_an_error() {
    let (lattice, rule) = zones();
    let give = |rule: &str, how: Resample| {
        let rule: Occupancy = rule.parse().expect("a rule");
        resample(&lattice, &rule, &Module::default(), &how).expect_err("must fail")
    };
    let crop = |crop| Resample { crop: Some(crop), ..Default::default() };
    let size = |cell_modules| Resample { cell_modules: Some(cell_modules), ..Default::default() };
    assert!(matches!(give(">= 0", crop([[0; 3], [3, 1, 1]])), GivenError::Crop { .. }));
    assert!(matches!(give(">= 0", crop([[0; 3], [2, 1, 1]])), GivenError::Nothing { .. }));
    assert!(matches!(give("> 7", Resample::default()), GivenError::Nothing { .. }));
    assert!(matches!(give("== True", Resample::default()), GivenError::Occupancy(_)));
    assert!(matches!(give(">= 0", size([0, 1, 1])), GivenError::Size { .. }));
    assert!(matches!(give(">= 0", size([usize::MAX, 2, 2])), GivenError::Size { .. }));
    assert!(resample(&lattice, &rule, &Module::default(), &size([1, 1, 1])).is_ok());
}

#[test]
fn admissible_houses_are_left_alone() {
    for (name, house) in samples::all() {
        let (same, changed) = repair(&house.voxels);
        assert!(changed.is_empty() && same == house.voxels, "{name}");
    }
}

#[test]
fn a_touching_pair_takes_one_change() {
    // Two blocks that touch along an edge: emptying or filling one cell per layer is needed, in each of two layers.
    let mut voxels = VoxelArray::new([4, 4, 2]);
    for z in 0..2 {
        for [x, y] in [[0, 0], [1, 0], [0, 1], [1, 1], [2, 2], [3, 2], [2, 3], [3, 3]] {
            voxels.set([x, y, z], Label::Base);
        }
    }
    assert_eq!(bad_cubes(&voxels), 3);
    let (mended, changed) = repair(&voxels);
    assert_eq!(bad_cubes(&mended), 0);
    assert_eq!(changed, [[2, 1, 0], [2, 1, 1]], "first corner in order, filled");
    assert_eq!(mended.get([2, 1, 0]), Label::Foundation);
    // A lone notch in a corner of a box takes a single voxel.
    let mut dented = samples::box_house().voxels;
    dented.set([0, 0, 0], Label::Foundation);
    let (mended, changed) = repair(&dented);
    assert_eq!((bad_cubes(&mended), changed.len()), (0, 1));
}

#[test]
fn noise_is_mended_the_same_way_every_time() {
    let mut state = 7u64;
    let mut next = || {
        state = state.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        state >> 33
    };
    for round in 0..20 {
        let mut voxels = VoxelArray::new([6, 5, 4]);
        (0..120).for_each(|i| {
            if next() % 4 > round % 4 {
                voxels.set([i % 6, i / 6 % 5, i / 30], Label::Base);
            }
        });
        let (mended, changed) = repair(&voxels);
        assert_eq!(bad_cubes(&mended), 0, "round {round}");
        assert_eq!(repair(&voxels), (mended, changed));
    }
}

#[test]
fn a_part_of_the_real_zoning_lattice_is_mended() {
    let root = std::env::var_os("HOUSCAPER_SHARED").map(PathBuf::from);
    let root = root.unwrap_or_else(|| PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../shared"));
    let path = root.join("reference/lattices/abm_mcda_f_030.csv");
    let Ok(bytes) = std::fs::read(&path) else {
        eprintln!("skipped: no {} (set HOUSCAPER_SHARED)", path.display());
        return;
    };
    let lattice = read_lattice(&bytes, "abm_mcda_f_030.csv").expect("a lattice");
    let rule: Occupancy = ">= 0".parse().expect("a rule");
    let mut worst = 0;
    for (x, y, z) in (0..=10).flat_map(|x| (0..=5).flat_map(move |y| (1..=3).map(move |z| (x, y, z)))) {
        let crop = Some([[x, y, z], [x + 6, y + 4, z + 2]]);
        let how = Resample { cell_modules: Some([4, 4, 6]), crop, ..Default::default() };
        let Ok(given) = resample(&lattice, &rule, &Module::default(), &how) else { continue };
        assert!(given.report.scale.iter().all(|s| *s < 0.4), "a change of scale");
        let voxels = given.to_voxels(Module::default());
        let (mended, changed) = repair(&voxels);
        assert_eq!(bad_cubes(&mended), 0);
        assert_eq!(changed.is_empty(), bad_cubes(&voxels) == 0);
        worst = worst.max(changed.len());
    }
    println!("most voxels changed: {worst}");
    assert!(worst > 0, "the lattice has inadmissible cubes");
}
