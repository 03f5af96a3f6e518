//! GO-Design: a zoning lattice drives the search, and its zones are carried to the results.

#[path = "common/front.rs"]
mod front;
#[path = "common/runs.rs"]
mod runs;

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use houscaper::voxels::lattice::{Occupancy, read_lattice};
use houscaper::voxels::{Given, House, Module, Resample, resample};
use serde_json::json;

/// The given voxels as the lattice file says.
fn given(lattice: &Path, how: &Resample) -> Given {
    let lattice = read_lattice(&std::fs::read(lattice).expect("a lattice"), "lattice").expect("a lattice");
    let occupied: Occupancy = ">= 0".parse().expect("a rule");
    resample(&lattice, &occupied, &Module::default(), how).expect("given voxels")
}

/// Every given voxel is filled and keeps its zone; no other voxel has one.
fn check_zones(house: &House, given: &Given) {
    let [nx, ny, nz] = house.voxels.shape();
    let [gx, gy, gz] = given.shape;
    for (index, &found) in house.zones.iter().enumerate() {
        let cell @ [x, y, z] = [index % nx, index / nx % ny, index / (nx * ny)];
        let inside = x < gx && y < gy && z < gz;
        let wanted = if inside { given.mask[x + gx * (y + gy * z)] } else { -1 };
        assert_eq!(found, wanted, "zone of {cell:?}");
        assert!(wanted < 0 || house.voxels.get(cell).is_filled(), "given voxel {cell:?} is empty");
    }
    assert_eq!(house.zones.len(), nx * ny * nz);
}

/// Gross plan area of each zone, from the given cells: modules of their first room layers.
fn zone_areas(given: &Given) -> BTreeMap<String, f64> {
    let mut areas = BTreeMap::new();
    let layer = given.shape[0] * given.shape[1];
    for (_, &zone) in given.mask.iter().enumerate().filter(|(i, z)| **z >= 0 && i / layer % 6 == 1) {
        *areas.entry(zone.to_string()).or_insert(0.0) += 0.81;
    }
    areas
}

/// Runs a brief and checks the whole folder with its zones.
fn check_zoned_run(brief: &Path, out: &Path, given: &Given, evaluations: usize) {
    let output = runs::optimize_ok(brief, out, &["--evaluations", &evaluations.to_string()]);
    assert!(runs::said(&output).contains("scale x"), "the change of scale is told: {}", runs::said(&output));
    let areas = zone_areas(given);
    for (id, house) in front::check_run(out, brief, evaluations) {
        check_zones(&house, given);
        let stated = front::zones_in_glb(&out.join("front").join(id));
        assert!(stated.keys().eq(areas.keys()), "{stated:?} against {areas:?}");
        assert!(stated.iter().all(|(zone, m2)| (m2 - areas[zone]).abs() < 1e-9), "{stated:?} against {areas:?}");
    }
}

#[test]
fn the_shipped_zoning_is_carried_through() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let configs = runs::repository().join("configs");
    let how = Resample { cell_modules: Some([2, 2, 6]), ..Resample::default() };
    let given = given(&configs.join("zoning.csv"), &how);
    assert_eq!(zone_areas(&given).len(), 3, "three zones");
    check_zoned_run(&configs.join("go-design.json"), &folder.path().join("run"), &given, 400);
}

/// The folder of third-party files: `HOUSCAPER_SHARED`, else `../shared` beside the checkout.
fn shared() -> Option<PathBuf> {
    let beside = runs::repository().parent().map(|p| p.join("shared"));
    let folder = std::env::var_os("HOUSCAPER_SHARED").map(PathBuf::from).or(beside)?;
    folder.is_dir().then_some(folder)
}

/// A part of the workshop's zoning lattice (93 cells of 10 m in three zones, top-heavy, hanging a layer above the ground), set on
/// the ground, each cell 3.6 x 3.6 x 3.24 m.
fn workshop(first: [usize; 3], last: [usize; 3], cells: usize, zones: usize, evaluations: usize) {
    let file = "reference/lattices/abm_mcda_f_030.csv";
    let Some(lattice) = shared().map(|f| f.join(file)).filter(|f| f.is_file()) else {
        eprintln!("skipped: {file} is neither under $HOUSCAPER_SHARED nor under ../shared");
        return;
    };
    let folder = tempfile::tempdir().expect("a temporary folder");
    let size = [0, 1].map(|a| 4 * (last[a] + 1 - first[a]) + 4);
    let brief = runs::changed_brief("go-design.json", folder.path(), |brief| {
        brief["name"] = json!("workshop");
        brief["plot"]["modules"] = json!([size[0], size[1], 17]);
        brief["programme"]["floor_area_m2"] = json!([150, 700]);
        // Houses this deep need their walls for the wind: the least glazing the rules allow.
        brief["programme"]["glazing_ratio_min"] = json!(0.1);
        brief["constraints"]["budget_eur"] = json!(1_500_000);
        brief["given"] = json!({
            "lattice": lattice, "occupied": ">= 0", "cell_modules": [4, 4, 6], "offset": [2, 2, 0],
            "ground": true, "keep": "filled", "crop": [first, last],
        });
    });
    let how = Resample {
        cell_modules: Some([4, 4, 6]),
        offset: [2, 2, 0],
        ground: true,
        crop: Some([first, last.map(|l| l + 1)]),
    };
    let given = given(&lattice, &how);
    assert_eq!((given.report.cells, zone_areas(&given).len()), (cells, zones));
    check_zoned_run(&brief, &folder.path().join("run"), &given, evaluations);
}

/// More cells above than below: what must stand underneath is the search's to find.
#[test]
fn a_top_heavy_part_of_the_workshop_lattice_becomes_houses() {
    workshop([12, 1, 1], [15, 3, 2], 19, 2, 300);
}

/// All three zones around a court; the two wings upstairs do not touch.
#[test]
fn three_zones_of_the_workshop_lattice_become_houses() {
    workshop([8, 1, 2], [13, 4, 3], 22, 3, 600);
}
