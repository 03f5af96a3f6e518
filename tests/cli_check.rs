//! `houscaper check`: sound houses are praised, every breach is named.

#[path = "common/cli.rs"]
mod cli;

use cli::{Scratch, has, ok, refused, run};
use houscaper::voxels::rules::RULES;
use houscaper::voxels::{Label, samples};
use serde_json::Value;

#[test]
fn a_sound_house_is_praised_with_storeys_and_area() {
    let folder = Scratch::new();
    let hip = ok(&["check", &folder.house("hip.json", &samples::hip_house())]);
    has(&hip.out, &["hip.json: keeps all 31 rules", "2 storeys", "m2 net floor area", "1 stair"]);
    let flat = ok(&["--json", "check", &folder.house("box.json", &samples::box_house())]);
    assert_eq!(flat.out, "{\"violations\":[]}\n");
}

#[test]
fn a_breach_is_named_with_rule_voxels_and_fix() {
    let folder = Scratch::new();
    let mut house = samples::box_house();
    house.voxels.set([1, 1, 3], Label::Window);
    let path = folder.house("corner.json", &house);
    let ran = run(&["check", &path]);
    assert_eq!(ran.code, 2);
    has(&ran.out, &["opening-corner: No window or door stands at a corner", "[1, 1, 3]", "fix: ", "violation"]);
    let ran = run(&["check", &path, "--json"]);
    assert_eq!((ran.code, ran.err.as_str()), (2, ""));
    let answer: Value = serde_json::from_str(&ran.out).expect("JSON");
    let keys = |v: &Value| v.as_object().expect("an object").keys().cloned().collect::<Vec<_>>();
    assert_eq!(keys(&answer), ["violations"]);
    let list = answer["violations"].as_array().expect("a list");
    let corner = list.iter().find(|v| v["rule"] == "opening-corner").expect("the breach");
    assert_eq!(keys(corner), ["cube", "fix", "message", "rule", "voxels"]);
    assert_eq!(corner["voxels"], serde_json::json!([[1, 1, 3]]));
}

#[test]
fn inadmissible_cubes_are_named_by_cube() {
    let folder = Scratch::new();
    let path = folder.file("diagonal.txt", "3.\n.3\n");
    let ran = run(&["check", &path, "--json"]);
    let answer: Value = serde_json::from_str(&ran.out).expect("JSON");
    let list = answer["violations"].as_array().expect("a list");
    assert!(
        list.iter().any(|v| v["rule"] == "cubes-admissible" && v["cube"] == serde_json::json!([1, 1, 0])),
        "{list:?}"
    );
}

#[test]
fn rules_are_listed_with_the_settings_of_the_brief() {
    let plain = ok(&["check", "--rules"]);
    assert!(RULES.iter().all(|r| plain.out.contains(r.id) && plain.out.contains(r.sentence)));
    has(&plain.out, &["\"view_m\": 2.7"]);
    let folder = Scratch::new();
    let brief = folder.brief("view.json", |b| b["rules"] = serde_json::json!({"view_m": 1.8, "off": ["roof-bump"]}));
    let set = ok(&["check", "--rules", "--brief", &brief]);
    has(&set.out, &["\"view_m\": 1.8", "[off]"]);
    let json: Value = serde_json::from_str(&ok(&["check", "--rules", "--json"]).out).expect("JSON");
    assert_eq!(json["rules"].as_array().map(Vec::len), Some(RULES.len()));
    let unknown = folder.brief("typo.json", |b| b["rules"] = serde_json::json!({"view": 1.8}));
    has(&refused(&["check", "--rules", "--brief", &unknown]), &["rules", "view", "houscaper check --rules"]);
}

#[test]
fn a_brief_adds_its_plot_and_programme() {
    let folder = Scratch::new();
    let house = folder.house("hip.json", &samples::hip_house());
    let fitting = folder.brief("fit.json", |b| {
        b["plot"]["modules"] = serde_json::json!([10, 9, 16]);
        b["programme"]["floor_area_m2"] = serde_json::json!([40, 120]);
    });
    has(&ok(&["check", &house, "--brief", &fitting]).out, &["and the brief's plot and programme"]);
    let asking = folder.brief("ask.json", |b| {
        b["plot"]["modules"] = serde_json::json!([8, 9, 16]);
        b["programme"]["floor_area_m2"] = serde_json::json!([110, 115]);
        b["programme"]["entrances_min"] = 2.into();
    });
    let ran = run(&["check", &house, "--brief", &asking, "--json"]);
    assert_eq!(ran.code, 2);
    let answer: Value = serde_json::from_str(&ran.out).expect("JSON");
    let rules: Vec<&str> =
        answer["violations"].as_array().expect("a list").iter().filter_map(|v| v["rule"].as_str()).collect();
    assert_eq!(rules, ["entrance", "plot.modules", "programme.floor_area_m2", "programme.entrances_min"]);
}

#[test]
fn a_mask_runs_from_north_to_south_and_given_cells_are_kept() {
    let folder = Scratch::new();
    let house = folder.house("hip.json", &samples::hip_house());
    let brief = |south: &str, lattice: &str| {
        folder.brief("plot.json", |b| {
            let mut rows = vec!["##########"; 8];
            rows.push(south);
            b["plot"] = serde_json::json!({"modules": [10, 9, 16], "mask": rows});
            b["programme"]["floor_area_m2"] = serde_json::json!([40, 120]);
            let file = folder.file("given.csv", lattice);
            b["given"] = serde_json::json!({"lattice": file, "occupied": ">= 0", "cell_modules": [3, 3, 6]});
        })
    };
    let lattice = |value: i32| {
        format!("minbound,shape,unit\n0,3,2.7\n0,1,2.7\n0,1,3.24\n\nIX,IY,IZ,value\n0,0,0,-1\n1,0,0,2\n2,0,0,{value}\n")
    };
    // Row y = 0 is empty in the sample; the given cell [3, 0] is the house's neighbour and must be filled.
    let rules = |brief: &str| {
        let ran = run(&["check", &house, "--brief", brief, "--json"]);
        let answer: Value = serde_json::from_str(&ran.out).unwrap_or_else(|e| panic!("{e}: {}", ran.err));
        let list = answer["violations"].as_array().expect("a list").clone();
        list.iter()
            .map(|v| (v["rule"].as_str().unwrap_or("").to_owned(), v["voxels"].as_array().map_or(0, Vec::len)))
            .collect::<Vec<_>>()
    };
    // Three columns of one row that the house leaves empty, six layers each.
    assert_eq!(rules(&brief("..........", &lattice(-1))), [("given.filled".to_owned(), 18)]);
    assert_eq!(rules(&brief("..........", &lattice(0))), [("given.filled".to_owned(), 36)]);
    let north: Vec<String> = std::iter::once("..........".to_owned()).chain(vec!["##########".to_owned(); 8]).collect();
    let barred = folder.brief("north.json", |b| {
        b["plot"] = serde_json::json!({"modules": [10, 9, 16], "mask": north});
        b["programme"]["floor_area_m2"] = serde_json::json!([40, 120]);
    });
    assert_eq!(rules(&barred), [], "the northernmost row is empty too");
    let barred = folder.brief("north.json", |b| {
        let mut rows = north.clone();
        rows[1] = rows[0].clone();
        b["plot"] = serde_json::json!({"modules": [10, 9, 16], "mask": rows});
        b["programme"]["floor_area_m2"] = serde_json::json!([40, 120]);
    });
    assert!(rules(&barred).iter().any(|(rule, _)| rule == "plot.mask"));
}
