//! `houscaper solve`: numbers for programs, a summary for people, mechanisms by node, files refused by key.

#[path = "common/cli.rs"]
mod cli;

use cli::{Scratch, has, ok, reference, refused};
use serde_json::{Value, json};

/// A cantilever of 2 m along x: E I = 210e9 x 1e-6 N m2 about y, E A = 210e9 x 1e-3 N.
fn cantilever() -> Value {
    json!({
        "schema": "houscaper.frame/1", "name": "cantilever", "units": "N, m, kg",
        "nodes": [[0, 0, 0], [2, 0, 0]],
        "materials": [{"E": 210e9, "G": 80e9, "rho": 7850}],
        "sections": [{"A": 1e-3, "Iy": 1e-6, "Iz": 2e-6, "J": 1e-6}],
        "members": [{"n": [0, 1], "mat": 0, "sec": 0}],
        "supports": [{"node": 0, "fix": [1, 1, 1, 1, 1, 1]}],
        "cases": [
            {"name": "tip", "nodal": [{"node": 1, "F": [0, 0, -1000, 0, 0, 0]}]},
            {"name": "weight", "gravity": [0, 0, -9.81]},
            {"name": "line", "member": [{"m": 0, "type": "linear", "axes": "local", "q1": [0, 0, -500], "q2": [0, 0, -1500], "x1": 0, "x2": 2}]}
        ],
        "combinations": [{"name": "all", "factors": {"tip": 1.5, "weight": 1.35}}]
    })
}

fn file(folder: &Scratch, frame: &Value) -> String {
    folder.file("frame.json", frame.to_string())
}

fn solved(frame: &Value) -> Value {
    let folder = Scratch::new();
    serde_json::from_str(&ok(&["solve", &file(&folder, frame), "--json"]).out).expect("JSON")
}

fn near(found: &Value, expected: f64) {
    close(found, expected, expected.abs().max(1e-6));
}

/// `found` to 1e-9 of `scale`.
fn close(found: &Value, expected: f64, scale: f64) {
    let found = found.as_f64().expect("a number");
    assert!((found - expected).abs() <= 1e-9 * scale, "{found} instead of {expected}");
}

#[test]
fn a_cantilever_bends_as_in_the_books() {
    let answer = solved(&cantilever());
    assert_eq!(answer["status"], "solved");
    let [tip, weight, _, all] = [0, 1, 2, 3].map(|c| &answer["cases"][c]);
    assert_eq!([&tip["name"], &all["name"]], ["tip", "all"]);
    let ei = 210e9 * 1e-6;
    near(&tip["disp"][1][2], -1000.0 * 8.0 / (3.0 * ei)); // P L^3 / 3 E I
    near(&tip["reac"][0][2], 1000.0);
    near(&tip["reac"][0][4], -2000.0);
    assert_eq!(tip["reac"][1], json!([0.0, 0.0, 0.0, 0.0, 0.0, 0.0]));
    assert_eq!(tip["endf"][0].as_array().map(Vec::len), Some(12));
    let q = 7850.0 * 1e-3 * 9.81;
    near(&weight["disp"][1][2], -q * 16.0 / (8.0 * ei)); // q L^4 / 8 E I
    near(&all["disp"][1][2], -1.5 * 1000.0 * 8.0 / (3.0 * ei) - 1.35 * q * 2.0 / ei);
    near(&all["reac"][0][2], 1500.0 + 1.35 * q * 2.0);
}

#[test]
fn the_combination_adds_the_cases() {
    let answer = solved(&cantilever());
    let at = |case: usize| answer["cases"][case]["disp"][1][2].as_f64().expect("a number");
    assert!((at(3) - 1.5 * at(0) - 1.35 * at(1)).abs() < 1e-12 * at(3).abs());
}

#[test]
fn programs_get_forces_along_members_extremes_and_balance() {
    let mut frame = cantilever();
    // A second member, unloaded but for a force inside it.
    frame["nodes"] = json!([[0, 0, 0], [2, 0, 0], [2, 0, 3]]);
    frame["members"] = json!([{"n": [0, 1], "mat": 0, "sec": 0}, {"n": [1, 2], "mat": 0, "sec": 0}]);
    frame["cases"][2]["member"]
        .as_array_mut()
        .expect("a list")
        .push(json!({"m": 1, "type": "point", "axes": "global", "P": [600, 0, 0], "x": 1.2}));
    frame["combinations"][0]["factors"] = json!({"tip": 2, "line": 1});
    let folder = Scratch::new();
    let path = file(&folder, &frame);
    let run = |more: &[&str]| -> Value {
        serde_json::from_str(&ok(&[&["solve", &path, "--json"], more].concat()).out).expect("JSON")
    };
    let answer = run(&["--stations", "3"]);
    let line = &answer["cases"][2];
    let along = &line["along"][0];
    assert_eq!(along["x"], json!([0.0, 1.0, 2.0]));
    // From the free end of the first member on: 600 N x 1.2 m of moment, the trapezoid of 500 to 1500 N/m.
    let shear = |x: f64| -(500.0 * (2.0 - x) + 250.0 * (4.0 - x * x));
    let moment = |x: f64| {
        let r = 2.0 - x;
        0.5 * (500.0 + 500.0 * x) * r * r + 500.0 * r * r * r / 3.0 + 600.0 * 1.2
    };
    for (k, x) in [0.0, 1.0, 2.0].into_iter().enumerate() {
        near(&along["forces"][k][0], 600.0);
        close(&along["forces"][k][2], shear(x), 2000.0);
        near(&along["forces"][k][4], moment(x));
    }
    near(&line["extremes"]["My"]["most"]["value"], moment(0.0));
    assert_eq!(
        (&line["extremes"]["My"]["most"]["member"], &line["extremes"]["My"]["most"]["x"]),
        (&json!(0), &json!(0.0))
    );
    // Along the upright the point load ends the shear: local z points to -x there.
    near(&line["along"][1]["least"][2], -600.0);
    close(&line["along"][1]["forces"][1][2], 0.0, 600.0);
    // Loads and reactions, forces and moments about the origin: -2000 N whose resultant is at 7/6 m, 600 N at 1.2 m height.
    let equilibrium = &line["equilibrium"];
    [600.0, 0.0, -2000.0].iter().enumerate().for_each(|(d, f)| near(&equilibrium["load"][d], *f));
    near(&equilibrium["load"][4], 2000.0 * 7.0 / 6.0 + 600.0 * 1.2);
    near(&equilibrium["reaction"][4], -(2000.0 * 7.0 / 6.0 + 600.0 * 1.2));
    assert!(equilibrium["out_of_balance"].as_f64().expect("a number") < 1e-12);
    let both = &answer["cases"][3];
    assert_eq!(both["combination"], json!({"tip": 2.0, "line": 1.0}));
    for k in 0..6 {
        let force = |c: usize| answer["cases"][c]["along"][0]["forces"][1][k].as_f64().expect("a number");
        close(&both["along"][0]["forces"][1][k], 2.0 * force(0) + force(2), 2000.0);
    }
    assert!(answer["residual"].as_f64().expect("a number") < 1e-12);
    assert!(answer["condition"]["estimate"].as_f64().expect("a number") > 1.0);
    assert_eq!(answer["size"]["unknowns"], 12);
    assert!(answer["timing_ms"]["numeric"].is_number() && answer["timing_ms"]["total"].is_number());
    assert_eq!(run(&["--stations", "0"])["cases"][0].get("along"), None);
    // Timing apart, the same bytes every time.
    let plain = |mut v: Value| {
        v["timing_ms"] = Value::Null;
        v.to_string()
    };
    assert_eq!(plain(run(&[])), plain(run(&[])));
    let help = ok(&["solve", "--help"]).out;
    has(&help, &["N > 0 is tension", "out_of_balance", "Hager and Higham", "along"]);
}

#[test]
fn buckling_is_answered_by_case_and_combination() {
    let mut frame = cantilever();
    frame["cases"][0]["nodal"][0]["F"] = json!([-1000, 0, 0, 0, 0, 0]);
    frame["combinations"][0]["factors"] = json!({"tip": 4, "weight": 1});
    let folder = Scratch::new();
    let path = file(&folder, &frame);
    let answer: Value =
        serde_json::from_str(&ok(&["solve", &path, "--json", "--stations", "0", "--buckling"]).out).expect("JSON");
    let factor = |case: usize| answer["cases"][case]["buckling"]["factor"].as_f64();
    // A flagpole: pi^2 E I / (4 L^2); four pieces are right to 1e-4 there.
    let euler = std::f64::consts::PI.powi(2) * 210e9 * 1e-6 / 16.0 / 1000.0;
    assert!((factor(0).expect("a number") / euler - 1.0).abs() < 1e-3, "{:?} of {euler}", factor(0));
    assert_eq!((factor(1), &answer["cases"][1]["buckling"]["never"]), (None, &json!(true)));
    assert!((factor(3).expect("a number") * 4.0 / factor(0).expect("a number") - 1.0).abs() < 1e-9);
    let mode = &answer["cases"][0]["buckling"];
    assert_eq!((&mode["member"], &mode["x"]), (&json!(0), &json!(2.0)));
    close(&mode["nodes"][1][2], 1.0, 1.0);
    has(&ok(&["solve", &path, "--buckling", "8"]).out, &["buckles at 129.5", "never buckles"]);
    assert_eq!(cli::run(&["solve", &path, "--buckling", "0"]).code, 2);
}

#[test]
fn people_get_extremes_and_balance() {
    let folder = Scratch::new();
    let text = ok(&["solve", &file(&folder, &cantilever())]).out;
    has(
        &text,
        &[
            "cantilever",
            "2 nodes, 1 members",
            "3 load cases, 1 combination",
            "solved",
            "largest displacement",
            "z at node 1",
        ],
    );
    has(&text, &["largest bending y", "2.00000e3 in member 0 at 0.00000 from its start"]);
    has(&text, &["6 unknowns", "condition about 1e1", "digits or more"]);
    // The trapezoid weighs (500 + 1500) / 2 x 2 m.
    has(&text, &["-2.00000e3", "2.00000e3", "out of balance"]);
    for line in text.lines().filter(|l| l.contains("out of balance")) {
        let ratio: f64 = line.split_whitespace().nth(3).and_then(|w| w.parse().ok()).expect("a ratio");
        assert!(ratio < 1e-9, "{line}");
    }
}

#[test]
fn a_mechanism_is_a_status_that_names_its_nodes() {
    let mut frame = cantilever();
    frame["supports"][0]["fix"] = json!([1, 1, 1, 1, 0, 1]);
    let answer = solved(&frame);
    assert_eq!((&answer["status"], &answer["cases"]), (&json!("unstable"), &json!([])));
    assert!(answer["mechanism"]["nodes"].as_array().expect("a list").iter().any(|n| n["node"] == 1));
    let folder = Scratch::new();
    has(&ok(&["solve", &file(&folder, &frame)]).out, &["unstable:", "node 1", "no displacements exist"]);
}

#[test]
fn published_values_are_compared() {
    let folder = Scratch::new();
    let mut frame = cantilever();
    let expected = |value: f64| json!([{"case": 0, "what": "reac", "node": 0, "comp": 2, "value": value, "printed": "1", "tol": 1e-6}]);
    frame["expected"] = expected(1000.0);
    has(&ok(&["solve", &file(&folder, &frame)]).out, &["published values: 1 of 1 agree"]);
    frame["expected"] = expected(999.0);
    has(
        &ok(&["solve", &file(&folder, &frame)]).out,
        &["published values: 0 of 1 agree", "case tip, reaction of node 0, component 2"],
    );
}

#[test]
fn the_twelve_published_frames_agree() {
    let Some(folder) = reference("frames") else { return };
    let mut files = 0;
    for entry in std::fs::read_dir(folder).expect("a folder") {
        let path = entry.expect("an entry").path();
        let text = ok(&["solve", path.to_str().expect("UTF-8")]).out;
        let line = text.lines().find(|l| l.starts_with("published values")).expect("a comparison");
        let words: Vec<&str> = line.split_whitespace().collect();
        assert_eq!(words[2], words[4], "{}: {line}", path.display());
        files += 1;
    }
    assert_eq!(files, 12);
}

#[test]
fn bad_frames_are_refused_by_key() {
    let folder = Scratch::new();
    let refuses = |change: &dyn Fn(&mut Value), parts: &[&str]| {
        let mut frame = cantilever();
        change(&mut frame);
        has(&refused(&["solve", &file(&folder, &frame)]), &[&["frame.json"], parts].concat());
    };
    refuses(&|f| f["nods"] = json!(1), &["at nods: unknown key"]);
    refuses(&|f| f["members"][0]["mat"] = json!("steel"), &["members[0].mat", "an index from 0"]);
    refuses(&|f| f["members"][0]["n"] = json!([0, 5]), &["member 0: node 5 does not exist"]);
    refuses(&|f| f["sections"][0]["A"] = json!(-1), &["section 0: A is -1"]);
    refuses(&|f| f["combinations"][0]["factors"]["snow"] = json!(1), &["combinations[0].factors.snow"]);
    let again = |f: &mut Value| {
        f["cases"][1]["name"] = json!("tip");
        f["combinations"][0]["factors"] = json!({"tip": 1});
    };
    refuses(&again, &["combinations[0].factors.tip", "two cases have this name"]);
    refuses(&|f| f["schema"] = json!("houscaper.frame/9"), &["schema", "houscaper.frame/1"]);
    has(&refused(&["solve", &folder.file("broken.json", "{\"nodes\": [")]), &["broken.json", "line 1"]);
    has(&refused(&["solve", &folder.at("none.json")]), &["cannot read", "none.json"]);
}
