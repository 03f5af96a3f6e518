//! GO-Design: a zoning lattice drives the search, and its zones are carried to the results.

#[path = "common/front.rs"]
mod front;
#[path = "common/runs.rs"]
mod runs;

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use houscaper::voxels::lattice::{Occupancy, read_lattice};
use houscaper::voxels::{Given, House, Hull, Module, Placement, Resample, field, resample};
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

/// Sun, entrances, an envelope and areas by zone together: no voxel of the front leaves the envelope, every zone has its area, and the page
/// tells the same counts as the voxels.
#[test]
fn fields_envelope_and_areas_of_the_workshop_are_kept_and_shown() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let Some(lattices) = shared().map(|f| f.join("reference/lattices")).filter(|f| f.is_dir()) else {
        eprintln!("skipped: reference/lattices is neither under $HOUSCAPER_SHARED nor under ../shared");
        return;
    };
    let [lattice, sun, access, mesh] =
        ["abm_mcda_f_030.csv", "sun_access.csv", "ent_access.csv", "compulsory_envelope.obj"].map(|f| lattices.join(f));
    let (first, last) = ([8, 1, 2], [13, 4, 3]);
    let asked = |areas: serde_json::Value| {
        runs::changed_brief("go-design.json", folder.path(), |brief| {
            brief["name"] = json!("workshop");
            brief["plot"]["modules"] = json!([28, 20, 17]);
            brief["plot"]["envelope"] = json!({"file": mesh});
            brief["programme"]["floor_area_m2"] = json!([150, 700]);
            brief["programme"]["glazing_ratio_min"] = json!(0.1);
            brief["programme"]["zones"] = areas;
            brief["constraints"]["budget_eur"] = json!(1_500_000);
            brief["given"] = json!({
                "lattice": lattice, "occupied": ">= 0", "cell_modules": [4, 4, 6], "offset": [2, 2, 0], "keep": "filled",
                "crop": [first, last], "sun": sun, "entrances": access,
            });
        })
    };
    // 22 cells of 12.96 m2: the areas are those of the given cells, which stay filled.
    let brief = asked(json!([
        {"zone": 0, "name": "lobby", "area_m2": [10, 60]},
        {"zone": 1, "name": "roof garden", "area_m2": [60, 120]},
        {"zone": 2, "name": "workshop", "area_m2": [100, 200]},
    ]));
    let out = folder.path().join("run");
    let output = runs::optimize_ok(&brief, &out, &["--evaluations", "300"]);
    assert!(runs::said(&output).contains("lie inside"), "{}", runs::said(&output));
    let how = Resample {
        cell_modules: Some([4, 4, 6]),
        offset: [2, 2, 0],
        ground: true,
        crop: Some([first, last.map(|l| l + 1)]),
    };
    let given = given(&lattice, &how);
    let read = read_lattice(&std::fs::read(&lattice).expect("a lattice"), "lattice").expect("a lattice");
    let hull = Hull::read(&std::fs::read(&mesh).expect("a mesh"), "mesh").expect("a closed mesh");
    let placement = Placement::new(&hull, None, None, Some((&read, &given)));
    let page = std::fs::read_to_string(out.join("given.html")).expect("the page");
    let mut shown = 0;
    for (id, house) in front::check_run(&out, &brief, 300) {
        let mut filled = 0;
        for (voxel, _) in house.voxels.iter().filter(|(v, label)| label.is_filled() && v[2] > 0) {
            let centre = placement.centre(voxel, &Module::default());
            assert!(hull.contains(centre), "house {id}: {voxel:?} at {centre:?} is outside");
            filled += 1;
        }
        assert!(filled > 1000, "house {id}: {filled} voxels");
        if let Some(part) = page.split("<h2 id=").find(|part| part.starts_with(&format!("\"house-{id}\""))) {
            assert!(part.contains("<p>22 cells kept, 0 removed, "), "{}", part.chars().take(300).collect::<String>());
            // A frame for each given cell, and a square for each room module of the layers shown.
            assert_eq!(part.matches("<text").count(), 22);
            assert!(part.contains("[9, 1, 2] at (50, -90, 20) zone 1"), "a cell in its own coordinates");
            assert!(!part.contains("missed by"));
            shown += 1;
        }
    }
    assert!(shown > 0 && page.contains("rounding error") && !page.contains("http"), "an offline page");
    // Areas that no house can have are said with the zone.
    let brief = asked(json!([{"zone": 1, "area_m2": [500, 600]}]));
    let output = runs::optimize(&brief, &folder.path().join("none"), &["--evaluations", "64", "--tables-only"]);
    assert_eq!(output.status.code(), Some(1));
    assert!(runs::said(&output).contains("programme.zones"), "{}", runs::said(&output));
}

/// Where the sun field is high on one half only, windows of starts gather there; without a field they do not.
#[test]
fn windows_follow_the_sun_and_doors_the_access() {
    use houscaper::search::fields::Field;
    use houscaper::search::from_brief::{Site, site_space};
    use houscaper::search::massing::Infill;
    use houscaper::search::start::start;
    use houscaper::voxels::lattice::{Lattice, Values};
    use houscaper::voxels::rules::RuleSettings;
    use rand::SeedableRng;

    let configs = runs::repository().join("configs");
    let text = std::fs::read(configs.join("go-design.json")).expect("a brief");
    let brief = houscaper::brief::read_brief(&text, "go-design.json").expect("a brief");
    let how = Resample { cell_modules: Some([2, 2, 6]), ..Resample::default() };
    let given = given(&configs.join("zoning.csv"), &how);
    let lattice = read_lattice(&std::fs::read(configs.join("zoning.csv")).expect("a lattice"), "zoning").expect("one");
    let half = |axis: usize| {
        let values = lattice.cells().map(|c| if 2 * c[axis] < lattice.shape[axis] { 1.0 } else { 0.0 }).collect();
        let half =
            Lattice::new(lattice.shape, lattice.minbound, lattice.unit, Values::Number(values)).expect("a lattice");
        field(&half, &lattice, &given).expect("a field")
    };
    let [sun, access] = [half(0), half(1)];
    let means = |with: bool| {
        let site = match with {
            true => Site { given: Some(&given), sun: Some(&sun), entrances: Some(&access), barred: None },
            false => Site { given: Some(&given), ..Site::default() },
        };
        let space = site_space(&brief, &site, &RuleSettings::default(), [1; 4]).expect("a space");
        let fields = [(Infill::Window, Field::new(&given, &sun)), (Infill::Door, Field::new(&given, &access))];
        let mut sums = [[0.0; 2]; 2];
        for seed in 0..60 {
            let mut rng = rand_chacha::ChaCha8Rng::seed_from_u64(seed);
            let design = start(&space, &mut rng).expect("a start");
            for (s, opening) in
                design.massing.storeys.iter().enumerate().flat_map(|(s, m)| m.openings.iter().map(move |o| (s, o)))
            {
                for (sum, (_, field)) in sums.iter_mut().zip(&fields).filter(|(_, f)| f.0 == opening.infill) {
                    sum[0] += field.mean(s, opening);
                    sum[1] += 1.0;
                }
            }
        }
        sums.map(|[sum, count]| sum / count)
    };
    let (with, without) = (means(true), means(false));
    println!("sun at windows and access at doors: {with:?} with fields, {without:?} without");
    // Settling adds and moves windows for the glazing of each storey whatever the sun, so not all of them can follow.
    assert!(with[0] > without[0] + 0.1 && with[1] > without[1] + 0.1, "{with:?} against {without:?}");
}

/// Half of the ground storey of a house, label by label: every house of the front has it, `check` says where one has not, and the page counts by label.
#[test]
fn the_labels_of_half_a_storey_are_carried_through() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let free = folder.path().join("free");
    runs::optimize_ok(&runs::repository().join("configs/starter.json"), &free, &["--evaluations", "120"]);
    let fronts = std::fs::read_dir(free.join("front")).expect("a front");
    let lattice = fronts.flatten().map(|f| f.path()).min().expect("a house").join("voxels.csv");
    let brief = runs::changed_brief("starter.json", folder.path(), |brief| {
        brief["given"] =
            json!({"lattice": lattice, "occupied": "> 0", "keep": "labels", "crop": [[0, 0, 0], [4, 7, 5]]});
    });
    let out = folder.path().join("run");
    runs::optimize_ok(&brief, &out, &["--evaluations", "200"]);
    let bytes = std::fs::read(&lattice).expect("the lattice");
    let voxels = read_lattice(&bytes, "lattice").expect("a lattice").to_voxels().expect("labels");
    let given: Vec<_> = voxels.iter().filter(|(v, label)| v[0] < 5 && v[2] < 6 && label.is_filled()).collect();
    assert!(given.iter().any(|(_, label)| label.is_infill()), "a door or window is given");
    let fronts = front::check_run(&out, &brief, 200);
    for (id, house) in &fronts {
        let changed = given.iter().find(|(v, label)| house.voxels.get(*v) != *label);
        assert_eq!(changed, None, "house {id}");
        let check = |file: &Path| {
            let output = runs::program().arg("check").arg(file).arg("--brief").arg(&brief).output().expect("a check");
            (output.status.code(), runs::said(&output))
        };
        let (code, said) = check(&out.join("front").join(id).join("voxels.json"));
        assert_eq!(code, Some(0), "{said}");
    }
    let page = std::fs::read_to_string(out.join("given.html")).expect("the page");
    assert!(page.contains("<th>label</th>") && page.contains("5 window"), "the page counts by label");
    // The original's mirror image keeps the rules, but not these labels.
    let turned = folder.path().join("turned.csv");
    let mut other = houscaper::voxels::VoxelArray::new(voxels.shape());
    (other.module, other.origin_m) = (voxels.module, voxels.origin_m);
    voxels.iter().for_each(|([x, y, z], label)| other.set([voxels.shape()[0] - 1 - x, y, z], label));
    let lattice = houscaper::voxels::lattice::Lattice::from_voxels(&other);
    std::fs::write(&turned, houscaper::voxels::lattice::write_lattice(&lattice)).expect("a file");
    let output = runs::program().arg("check").arg(&turned).arg("--brief").arg(&brief).output().expect("a check");
    assert_eq!(output.status.code(), Some(2), "{}", runs::said(&output));
    let list = String::from_utf8_lossy(&output.stdout).into_owned();
    assert!(list.contains("given.labels"), "{list}");
}
