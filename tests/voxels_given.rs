//! Lattices resampled to modules, and the repair of inadmissible cubes.

use std::path::PathBuf;

use houscaper::voxels::lattice::{Lattice, Occupancy, Values, read_lattice};
use houscaper::voxels::rules::{self, RuleSettings};
use houscaper::voxels::{
    GivenError, House, Hull, Label, Module, Placement, Resample, VoxelArray, field, repair, resample, samples,
};

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

/// A file of the GO-Design workshop, `None` where the folder of third-party files is not there.
fn workshop(file: &str) -> Option<Vec<u8>> {
    let beside = PathBuf::from(env!("CARGO_MANIFEST_DIR")).parent().map(|p| p.join("shared"));
    let folder = std::env::var_os("HOUSCAPER_SHARED").map(PathBuf::from).or(beside)?;
    let found = std::fs::read(folder.join("reference/lattices").join(file)).ok();
    if found.is_none() {
        eprintln!("skipped: reference/lattices/{file} is neither under $HOUSCAPER_SHARED nor under ../shared");
    }
    found
}

#[test]
fn cells_and_modules_name_each_other_and_fields_follow_them() {
    let (lattice, rule) = zones();
    let how = Resample { cell_modules: Some([3, 2, 6]), offset: [1, 2, 0], ..Resample::default() };
    let given = resample(&lattice, &rule, &Module::default(), &how).expect("a fit");
    // The lowest layer is empty and sank into the ground: cell layer 1 starts at module 0.
    assert_eq!([given.map.cell([1, 2, 0]), given.map.cell([6, 3, 11])], [Some([0, 0, 1]), Some([1, 0, 2])]);
    assert_eq!([given.map.cell([0, 2, 0]), given.map.cell([1, 2, 12]), given.map.cell([7, 2, 0])], [None; 3]);
    assert_eq!([given.map.module([1, 0, 2]), given.map.module([0, 0, 0])], [Some([4, 2, 6]), None]);
    let values = Values::Number(vec![9.0, 9.0, 1.0, 2.0, -3.0, 4.0]);
    let sun = Lattice::new([2, 1, 3], [0.0; 3], [1.8, 2.0, 3.24], values).expect("six cells");
    let sun = field(&sun, &lattice, &given).expect("a field");
    let at = |x: usize, y: usize, z: usize| sun[x + given.shape[0] * (y + given.shape[1] * z)];
    assert_eq!(
        [at(1, 2, 0), at(4, 3, 5), at(3, 2, 6), at(6, 3, 11), at(0, 0, 0)],
        [1.0, 2.0, 0.0, 4.0, 0.0].map(|v| v / 9.0)
    );
    let other = Lattice::new([1, 2, 3], [0.0; 3], [1.0; 3], Values::Number(vec![0.0; 6])).expect("six cells");
    assert!(matches!(field(&other, &lattice, &given), Err(GivenError::FieldShape { .. })));
    let flags = Lattice::new([2, 1, 3], [0.0; 3], [1.0; 3], Values::Bool(vec![true; 6])).expect("six cells");
    assert_eq!(field(&flags, &lattice, &given), Err(GivenError::FieldKind));
}

/// The workshop's sun field was computed by another program in the cells whose centre lies inside its envelope, so it tells inside from
/// outside for all layers but the lowest, whose centres lie on the envelope's floor.
#[test]
fn the_workshops_envelope_holds_the_cells_that_its_sun_field_knows() {
    let (Some(mesh), Some(sun)) = (workshop("compulsory_envelope.obj"), workshop("sun_access.csv")) else { return };
    let hull = Hull::read(&mesh, "compulsory_envelope.obj").expect("a closed mesh");
    let sun = read_lattice(&sun, "sun_access.csv").expect("a lattice");
    let Values::Number(values) = &sun.values else { panic!("a field of numbers") };
    let mut inside = 0;
    for (cell, value) in sun.cells().zip(values).filter(|(cell, _)| cell[2] > 0) {
        let centre = [0, 1, 2].map(|a| sun.minbound[a] + cell[a] as f64 * sun.unit[a]);
        assert_eq!(hull.contains(centre), *value > 0.0, "{cell:?} at {centre:?}, winding {}", hull.winding(centre));
        inside += usize::from(*value > 0.0);
    }
    assert_eq!(inside, 300, "100 cells in each of three layers");
    // On a plot at the lattice's scale every module of a cell agrees with it, but for cells that the surface cuts.
    let rule: Occupancy = "> 0".parse().expect("a rule");
    let how = Resample { cell_modules: Some([2, 2, 6]), ground: false, ..Resample::default() };
    let given = resample(&sun, &rule, &Module::default(), &how).expect("given cells");
    let placement = Placement::new(&hull, None, None, Some((&sun, &given)));
    assert_eq!(placement.scale, given.report.scale);
    let [nx, ny, _] = given.shape;
    let outside = placement.outside(&hull, [nx, ny, 13], &Module::default());
    let (mut agree, mut all) = (0, 0);
    for (at, outside) in outside.iter().enumerate().skip(nx * ny) {
        // Thirteen modules are 22 m of the file, and the envelope is 36 m high: the plan alone decides.
        let [x, y] = [at % nx, at / nx % ny];
        let cell = given.map.cell([x, y, 6]).expect("a cell");
        let known = values[cell[0] + sun.shape[0] * (cell[1] + sun.shape[1])] > 0.0;
        all += 1;
        agree += usize::from(known != *outside);
    }
    // A module is 5 m of the file: of 32 x 18 columns those along the edge of the envelope are cut, at most one in ten.
    assert!(agree * 10 >= all * 9, "{agree} of {all}");
    assert!(!outside[..nx * ny].contains(&true), "the foundation is not judged");
}
