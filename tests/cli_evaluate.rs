//! `houscaper evaluate`: one by one and in batches; whatever stands on a line is answered.

#[path = "common/cli.rs"]
mod cli;

use cli::{Ran, Scratch, has, ok, refused, run_with};
use houscaper::voxels::{House, samples};
use serde_json::{Value, json};

const MODULES: [usize; 3] = [10, 9, 16];

fn brief(folder: &Scratch) -> String {
    folder.brief("brief.json", |b| {
        b["plot"]["modules"] = json!(MODULES);
        b["programme"]["floor_area_m2"] = json!([20, 140]);
    })
}

/// The labels of a house on the plot.
fn labels(house: &House) -> Vec<u8> {
    let mut labels = Vec::new();
    for z in 0..MODULES[2] {
        for y in 0..MODULES[1] {
            labels.extend((0..MODULES[0]).map(|x| house.voxels.at([x, y, z].map(|c| c as isize)).code()));
        }
    }
    labels
}

fn line(id: impl Into<Value>, labels: &[u8]) -> String {
    json!({"id": id.into(), "shape": MODULES, "labels": labels}).to_string()
}

fn batch(brief: &str, flags: &[&str], input: &str) -> Vec<Value> {
    let ran: Ran = run_with(&[&["evaluate", "--batch", "--brief", brief], flags].concat(), input);
    assert_eq!((ran.code, ran.err.as_str()), (0, ""));
    ran.out.lines().map(|l| serde_json::from_str(l).expect("a JSON line")).collect()
}

#[test]
fn houses_are_evaluated_one_by_one() {
    let folder = Scratch::new();
    let hip = folder.house("hip.json", &samples::hip_house());
    let broken = folder.file("broken.txt", "333\n333\n333\n");
    let out = ok(&["evaluate", &hip, &broken, "--brief", &brief(&folder)]).out;
    let rows: Vec<Value> = out.lines().map(|l| serde_json::from_str(l).expect("a JSON line")).collect();
    assert_eq!(rows.len(), 2);
    assert_eq!((&rows[0]["file"], &rows[0]["violations"]), (&json!(hip), &json!(0)));
    assert!(["ok", "not ok"].iter().any(|v| rows[0]["verdict"] == *v), "{}", rows[0]);
    let price = rows[0]["objectives"]["price_eur"].as_f64().expect("a price");
    assert!((20_000.0..500_000.0).contains(&price), "{price}");
    assert_eq!(rows[0]["feasible"], json!(rows[0]["violation"].as_f64() <= Some(0.0)));
    assert_eq!(rows[1]["feasible"], json!(false));
    assert!(rows[1]["violations"].as_u64() > Some(0));
}

#[test]
fn a_house_beyond_the_plot_is_infeasible() {
    let folder = Scratch::new();
    let house = folder.house("deck.json", &samples::deck_house());
    let row = |brief: &str| -> Value {
        serde_json::from_str(&ok(&["evaluate", &house, "--brief", brief]).out).expect("JSON")
    };
    assert!(row(&brief(&folder))["violation"].as_f64() > Some(0.0));
    let fitting = folder.brief("fit.json", |b| {
        b["plot"]["modules"] = json!([14, 9, 16]);
        b["programme"]["glazing_ratio_min"] = json!(0.1);
    });
    assert_eq!(row(&fitting)["violations"], json!(0));
}

#[test]
fn a_batch_answers_every_line_in_the_brief_s_order() {
    let folder = Scratch::new();
    let brief = brief(&folder);
    let (hip, flat) = (samples::hip_house(), samples::box_house());
    let input = format!("{}\n{}\n\n{}\n", line(17, &labels(&hip)), line("b", &labels(&flat)), line(3, &vec![0; 1440]));
    let answers = batch(&brief, &[], &input);
    assert_eq!(answers.iter().map(|a| a["id"].clone()).collect::<Vec<_>>(), [json!(17), json!("b"), json!(3)]);
    assert!(answers.iter().all(|a| a["f"].as_array().map(Vec::len) == Some(3) && a["cv"].is_f64()), "{answers:?}");
    // An empty plot breaks rules: objectives are not known, the violation says so.
    assert_eq!(answers[2]["f"], json!([1e9, 1e9, 1e9]));
    assert!(answers[2]["cv"].as_f64() > Some(1000.0));
    // The same house as a file has the same objectives, the area negated because the brief maximises it.
    let file = folder.house("hip.json", &hip);
    let row: Value = serde_json::from_str(&ok(&["evaluate", &file, "--brief", &brief]).out).expect("JSON");
    let objective = |name: &str| row["objectives"][name].as_f64().expect("a number");
    let expected = [objective("price_eur"), objective("gwp_kgco2e"), -objective("floor_area_m2")];
    assert_eq!(answers[0]["f"], json!(expected));
    assert_eq!(answers[0]["cv"], row["violation"]);
}

#[test]
fn garbage_is_answered_and_the_rest_goes_on() {
    let folder = Scratch::new();
    let brief = brief(&folder);
    let good = labels(&samples::box_house());
    let mut bad = good.clone();
    bad[7] = 6;
    let shape = |s: Value| json!({"id": 4, "shape": s, "labels": good}).to_string();
    let cases = [
        ("not json", Value::Null, "line 1: no JSON"),
        ("[1, 2]", Value::Null, "line 2"),
        ("{\"shape\": [10, 9, 16], \"labels\": []}", Value::Null, "missing field `id`"),
        (&line(4, &bad), json!(4), "labels[7] is 6, expected a label from 0 to 5"),
        (&line(5, &good[1..]), json!(5), "1439 labels, expected 1440"),
        (&shape(json!([9, 10, 16])), json!(4), "shape is [9, 10, 16], expected [10, 9, 16] as in plot.modules"),
        (&shape(json!([10, 9])), json!(4), "invalid length 2"),
        ("{\"id\": 8, \"shape\": [10, 9, 16], \"labels\": [-1]}", json!(8), "-1"),
        ("{\"id\": 9, \"shape\": [10, 9, 16], \"labels\": [], \"colour\": 1}", json!(9), "unknown field `colour`"),
        ("{\"id\": 10, \"shape\": [10, 9, 16], \"labels\": [], \"choices\": {}}", json!(10), "1440"),
        ("\u{fffd}", Value::Null, "no JSON"),
    ];
    let mut input: String = cases.iter().map(|(line, ..)| format!("{line}\n")).collect();
    input += &line(99, &good);
    let answers = batch(&brief, &[], &input);
    assert_eq!(answers.len(), cases.len() + 1);
    for (answer, (_, id, part)) in answers.iter().zip(&cases) {
        assert_eq!(&answer["id"], id, "{answer}");
        has(answer["error"].as_str().expect("an error"), &[part]);
    }
    assert!(answers[cases.len()]["cv"].is_f64());
}

#[test]
fn a_genome_carries_choices_by_name_or_index() {
    let folder = Scratch::new();
    let brief = brief(&folder);
    let with = |choices: Value| {
        let mut request: Value = serde_json::from_str(&line(1, &labels(&samples::hip_house()))).expect("JSON");
        request["choices"] = choices;
        request.to_string()
    };
    let f = |choices: Value| batch(&brief, &["--genome"], &with(choices))[0]["f"].clone();
    let plain = batch(&brief, &[], &line(1, &labels(&samples::hip_house())))[0]["f"].clone();
    assert_eq!(f(json!({})), plain);
    assert_eq!(f(json!({"wall_section": 0, "joist_axes": 0})), plain);
    let other = f(json!({"roof_section": 1}));
    assert_ne!(other, plain);
    let error = batch(&brief, &["--genome"], &with(json!({"roof_section": "C99 oak"})))[0]["error"].clone();
    let error = error.as_str().expect("an error");
    has(error, &["choices.roof_section is \"C99 oak\"", "expected an index below"]);
    let names: Vec<&str> = error.split("one of ").nth(1).expect("names").split(", ").collect();
    assert_eq!(f(json!({"roof_section": names[1]})), other);
    let file = folder.house("hip.json", &samples::hip_house());
    let chosen = json!({"roof_section": names[1]}).to_string();
    let row: Value =
        serde_json::from_str(&ok(&["evaluate", &file, "--brief", &brief, "--choices", &chosen]).out).expect("JSON");
    assert_eq!(row["objectives"]["price_eur"], other[0]);
    has(
        &refused(&["evaluate", &file, "--brief", &brief, "--choices", "{\"roof\": 1}"]),
        &["--choices: choices.roof: unknown"],
    );
    for (choices, part) in [
        (json!({"roof": 1}), "choices.roof: unknown"),
        (json!({"wall_section": 10_000}), "choices.wall_section is 10000"),
        (json!({"joist_axes": 65_536}), "choices.joist_axes is 65536"),
    ] {
        has(batch(&brief, &["--genome"], &with(choices))[0]["error"].as_str().expect("an error"), &[part]);
    }
    let unasked = &batch(&brief, &[], &with(json!({"wall_section": 0})))[0];
    has(unasked["error"].as_str().expect("an error"), &["--genome"]);
}

#[test]
fn batches_are_answered_when_they_close() {
    let folder = Scratch::new();
    assert_eq!(batch(&brief(&folder), &[], "\n\n\n"), Vec::<Value>::new());
    let mut child = std::process::Command::new(env!("CARGO_BIN_EXE_houscaper"))
        .current_dir(env!("CARGO_MANIFEST_DIR"))
        .args(["evaluate", "--batch", "--brief", &brief(&folder)])
        .stdin(std::process::Stdio::piped())
        .stdout(std::process::Stdio::piped())
        .spawn()
        .expect("the program starts");
    use std::io::{BufRead, Write};
    let mut stdin = child.stdin.take().expect("stdin");
    let mut answers = std::io::BufReader::new(child.stdout.take().expect("stdout")).lines();
    for id in 0..3 {
        // The answer is there although the input stays open.
        writeln!(stdin, "{}\n", line(id, &labels(&samples::box_house()))).expect("a line");
        let answer: Value = serde_json::from_str(&answers.next().expect("an answer").expect("text")).expect("JSON");
        assert_eq!(answer["id"], json!(id));
    }
    drop(stdin);
    assert!(child.wait().expect("an end").success());
}

#[test]
fn bad_houses_are_refused_before_anything_is_printed() {
    let folder = Scratch::new();
    let brief = brief(&folder);
    let good = folder.house("box.json", &samples::box_house());
    let bad = folder.file("bad.txt", "3?\n");
    has(&refused(&["evaluate", &good, &bad, "--brief", &brief]), &["bad.txt", "line 1, column 2"]);
    let mut scaled = samples::box_house();
    scaled.voxels.module.size_m = [1.0; 3];
    let scaled = folder.house("scaled.json", &scaled);
    has(&refused(&["evaluate", &scaled, "--brief", &brief]), &["scaled.json", "plot.module_m"]);
}
