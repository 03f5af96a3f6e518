//! `houscaper improve`: neighbours that are better by the program's own evaluation, and that leave alone what is locked.

#[path = "common/cli.rs"]
mod cli;

use std::path::Path;

use cli::{Scratch, contents, has, ok, refused, run};
use houscaper::voxels::{House, Label, json as voxel_json, samples};
use serde_json::{Value, json};

const EVALUATIONS: &str = "160";

fn sample(name: &str) -> House {
    let (_, house) = samples::all().into_iter().find(|(n, _)| *n == name).expect("a sample");
    house
}

/// The starter brief on a plot that holds the samples.
fn brief(folder: &Scratch) -> String {
    folder.brief("brief.json", |b| {
        b["plot"]["modules"] = json!([14, 12, 17]);
        b["programme"] = json!({"floor_area_m2": [15, 160], "storeys": [1, 2], "clear_height_m": 2.4});
    })
}

fn improved(house: &str, brief: &str, out: &str, more: &[&str]) -> Value {
    let args =
        [&["improve", house, "--brief", brief, "--out", out, "--evaluations", EVALUATIONS, "--json"], more].concat();
    let told: Value = serde_json::from_str(&ok(&args).out).expect("JSON");
    let written: Value =
        serde_json::from_slice(&std::fs::read(Path::new(out).join("improve.json")).expect("a file")).expect("JSON");
    assert_eq!(told, written);
    told
}

fn read(folder: &Path) -> House {
    let path = folder.join("voxels.json");
    voxel_json::read(&std::fs::read(&path).expect("a file"), "voxels.json").expect("a house")
}

/// What `evaluate` says of the files of a folder.
fn evaluated(folder: &Path, brief: &str) -> Value {
    let file = |name: &str| folder.join(name).to_str().expect("UTF-8").to_owned();
    let out = ok(&["evaluate", &file("voxels.json"), "--choices", &file("choices.json"), "--brief", brief]).out;
    serde_json::from_str(&out).expect("JSON")
}

fn label(house: &House, v: [usize; 3]) -> Label {
    house.voxels.at(v.map(|c| c as isize))
}

#[test]
fn neighbours_are_better_by_evaluate_and_their_differences_add_up() {
    let folder = Scratch::new();
    let brief = brief(&folder);
    for (aim, figure) in [("price", "price_eur"), ("carbon", "gwp_kgco2e"), ("stiffness", "")] {
        let out = folder.at(aim);
        let told = improved("sample:box", &brief, &out, &["--aim", aim]);
        let neighbours = told["neighbours"].as_array().expect("a list");
        assert!((1..=6).contains(&neighbours.len()), "{aim}: {}", neighbours.len());
        let before = evaluated(&Path::new(&out).join("before"), &brief);
        for (n, neighbour) in neighbours.iter().enumerate() {
            let files = Path::new(&out).join((n + 1).to_string());
            let row = evaluated(&files, &brief);
            assert_eq!((&row["feasible"], &row["violations"]), (&json!(true), &json!(0)), "{aim} {n}");
            for (name, value) in neighbour["figures"].as_object().expect("figures") {
                assert_eq!(value["after"], row["objectives"][name], "{aim} {n} {name}");
                assert_eq!(value["before"], before["objectives"][name], "{aim} {n} {name}");
                let of = |key: &str| value[key].as_f64().expect("a number");
                assert_eq!(of("difference"), of("after") - of("before"));
            }
            let of = |row: &Value, name: &str| row["objectives"][name].as_f64().expect("a number");
            let stiff = |row: &Value| of(row, "sway_ratio").max(of(row, "deflection_ratio"));
            let better =
                if figure.is_empty() { stiff(&row) < stiff(&before) } else { of(&row, figure) < of(&before, figure) };
            assert!(better, "{aim} {n}");
            assert!(of(&row, "floor_area_m2") >= 0.97 * of(&before, "floor_area_m2"), "{aim} {n}");
            // The list of changes turns the one house into the other.
            let (old, new) = (read(&Path::new(&out).join("before")), read(&files));
            let text = std::fs::read_to_string(files.join("changes.csv")).expect("a table");
            let mut changed = 0;
            for line in text.lines().skip(1) {
                let cells: Vec<&str> = line.split(',').collect();
                let v = [0, 1, 2].map(|a: usize| cells[a].parse::<usize>().expect("a coordinate"));
                assert_eq!((label(&old, v).name(), label(&new, v).name()), (cells[3], cells[4]));
                changed += 1;
            }
            let differing = (0..17)
                .flat_map(|z| (0..12).flat_map(move |y| (0..14).map(move |x| [x, y, z])))
                .filter(|v| label(&old, *v) != label(&new, *v));
            assert_eq!(differing.count(), changed);
            assert_eq!(neighbour["voxels_changed"], json!(changed));
            assert!(files.join("house.glb").exists());
        }
        let table = std::fs::read_to_string(Path::new(&out).join("improve.csv")).expect("a table");
        has(&table, &["neighbour,figure,before,after,difference,percent", "1,price_eur,"]);
    }
}

#[test]
fn the_same_seed_gives_the_same_files() {
    let folder = Scratch::new();
    let brief = brief(&folder);
    let files = |name: &str, seed: &str| {
        let out = folder.at(name);
        improved("sample:box", &brief, &out, &["--seed", seed, "--aim", "price"]);
        let strip =
            |(path, bytes): (std::path::PathBuf, Vec<u8>)| (path.strip_prefix(&out).expect("below").to_owned(), bytes);
        contents(Path::new(&out)).into_iter().map(strip).collect::<Vec<_>>()
    };
    let (one, again, other) = (files("one", "4"), files("again", "4"), files("other", "5"));
    assert_eq!(one, again);
    assert_ne!(one, other);
}

#[test]
fn locked_voxels_stay() {
    let folder = Scratch::new();
    let brief = brief(&folder);
    let house = sample("box");
    let [nx, ny, _] = house.voxels.shape();
    // A box of modules, and the same as a lattice file.
    let out = folder.at("boxed");
    let lock = format!("0:{},:,:", nx / 2);
    let told = improved("sample:box", &brief, &out, &["--lock", &lock]);
    let neighbours = told["neighbours"].as_array().expect("a list");
    assert!(!neighbours.is_empty());
    assert_eq!(told["locked_voxels"], json!(nx / 2 * ny * house.voxels.shape()[2]));
    for n in 1..=neighbours.len() {
        let new = read(&Path::new(&out).join(n.to_string()));
        for (v, old) in house.voxels.iter().filter(|(v, _)| v[0] < nx / 2) {
            assert_eq!(label(&new, v), old, "neighbour {n}, voxel {v:?}");
        }
    }
    // All of it locked: sections are all that can change.
    let all = folder.at("all");
    let told = improved("sample:box", &brief, &all, &["--lock", ":,:,:", "--aim", "stiffness"]);
    for neighbour in told["neighbours"].as_array().expect("a list") {
        assert_eq!(neighbour["voxels_changed"], json!(0));
        assert!(neighbour["choices_changed"].as_u64() > Some(0));
    }
    assert!(!told["neighbours"].as_array().expect("a list").is_empty());
}

#[test]
fn a_lattice_locks_what_a_box_locks() {
    let folder = Scratch::new();
    let brief = brief(&folder);
    let house = sample("box");
    let mut marks = houscaper::voxels::VoxelArray::new(house.voxels.shape());
    house.voxels.iter().filter(|(v, _)| v[1] < 3).for_each(|(v, _)| marks.set(v, Label::Base));
    let lattice = houscaper::voxels::lattice::Lattice::from_voxels(&marks);
    let file = folder.file("lock.csv", houscaper::voxels::lattice::write_lattice(&lattice));
    let by =
        |name: &str, lock: &str| improved("sample:box", &brief, &folder.at(name), &["--aim", "price", "--lock", lock]);
    assert_eq!(by("a", &file), by("b", ":,:3,:"));
}

#[test]
fn a_house_that_breaks_rules_becomes_valid_with_few_changes() {
    let folder = Scratch::new();
    let brief = brief(&folder);
    let mut broken = sample("box");
    let wall = broken.voxels.iter().find(|(v, l)| *l == Label::Window && v[2] == 2).expect("a window").0;
    // A hole through the wall beside a window, and a lonely voxel on the roof.
    let top = broken.voxels.shape()[2] - 1;
    broken.voxels.set([wall[0], wall[1], 3], Label::Empty);
    broken.voxels.set([wall[0], wall[1], top], Label::Base);
    broken.voxels.origin_m = [3.6, -1.8, 0.0];
    let file = folder.house("broken.json", &broken);
    assert_eq!(run(&["check", &file, "--brief", &brief]).code, 2);
    let out = folder.at("out");
    let told = improved(&file, &brief, &out, &[]);
    assert_eq!(told["aim"], json!(["valid"]));
    let neighbours = told["neighbours"].as_array().expect("a list");
    assert!(!neighbours.is_empty());
    let changed: Vec<u64> = neighbours.iter().map(|n| n["voxels_changed"].as_u64().expect("a count")).collect();
    for n in 1..=neighbours.len() {
        let files = Path::new(&out).join(n.to_string());
        ok(&["check", files.join("voxels.json").to_str().expect("UTF-8"), "--brief", &brief]);
        assert_eq!(evaluated(&files, &brief)["feasible"], json!(true));
        assert_eq!(read(&files).voxels.origin_m, broken.voxels.origin_m, "a neighbour stands where the house stood");
    }
    // The nearest puts back what was broken and little else.
    assert!(changed[0] <= 12, "{changed:?}");
    assert_eq!(told["before"]["feasible"], json!(false));
}

#[test]
fn wrong_requests_are_refused_and_nothing_is_written() {
    let folder = Scratch::new();
    let brief = brief(&folder);
    let out = folder.at("out");
    let with = |more: &[&str]| refused(&[&["improve", "sample:box", "--brief", &brief, "--out", &out], more].concat());
    has(&with(&["--lock", "1:2"]), &["--lock 1:2", "three ranges"]);
    has(&with(&["--lock", "1:2,3:3,:"]), &["y is `3:3`", "last not included"]);
    has(&with(&["--lock", "0:999,:,:"]), &["x is `0:999`"]);
    has(&with(&["--lock", "a:b,:,:"]), &["x is `a:b`"]);
    has(&with(&["--lock", &folder.at("none.csv")]), &["cannot read"]);
    has(&with(&["--keep-area", "99"]), &["--keep-area"]);
    has(&with(&["--aim", "valid"]), &["passes as it is"]);
    let empty = folder.file("empty.txt", "000\n000\n000\n");
    let line = refused(&["improve", "sample:terrace", "--brief", "configs/starter.json", "--out", &out]);
    has(&line, &["sample:terrace", "[10, 8, 17]", "plot.modules"]);
    let line = refused(&["improve", &empty, "--brief", &brief, "--out", &out]);
    has(&line, &["empty.txt"]);
    assert!(!Path::new(&out).exists());
}
