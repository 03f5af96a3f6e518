//! `houscaper member` as a program.

use assert_cmd::Command;
use serde_json::Value;

fn member(args: &[&str]) -> (i32, String, String) {
    let out = Command::cargo_bin("houscaper").expect("built").arg("member").args(args).output().expect("runs");
    let text = |bytes: &[u8]| String::from_utf8_lossy(bytes).into_owned();
    (out.status.code().unwrap_or(-1), text(&out.stdout), text(&out.stderr))
}

#[test]
fn flags_give_every_clause_and_the_governing_one() {
    let (code, out, err) = member(&[
        "--material",
        "C24",
        "--section",
        "60x220",
        "--length",
        "4.2",
        "--lateral",
        "0",
        "--gk",
        "0.4",
        "--qk",
        "0.8",
    ]);
    assert_eq!(code, 0, "{out}{err}");
    for part in ["EN 1995-1-1 6.1.6 (6.11)", "6.1.7 (6.13)", "kmod", "7.2", "k_crit = 1", "governed by"] {
        assert!(out.contains(part), "{part} is missing in\n{out}");
    }
}

#[test]
fn json_says_the_same_as_flags() {
    let dir = tempfile::tempdir().expect("a folder");
    let file = dir.path().join("column.json");
    std::fs::write(
        &file,
        r#"{"material": "S355", "section": "HF-SHS100x100x5", "L_mm": 3000, "NEd_kN": 200, "My_Ed_kNm": 5, "My_end_Ed_kNm": 0}"#,
    )
    .expect("written");
    let path = file.to_str().expect("a path");
    let (code, of_file, _) = member(&[path, "--json"]);
    assert_eq!(code, 0);
    let flags =
        ["--material", "S355", "--section", "HF-SHS100x100x5", "--length", "3", "--compression", "200", "--my", "5,0"];
    let (_, of_flags, _) = member(&[&flags[..], &["--json"]].concat());
    assert_eq!(of_file, of_flags);
    let report: Value = serde_json::from_str(&of_file).expect("JSON");
    assert_eq!(report["schema"], "houscaper.member_result/1");
    let clauses = report["clauses"].as_array().expect("a list");
    for l in clauses {
        let [demand, resistance, ratio] = ["demand", "resistance", "ratio"].map(|k| l[k].as_f64().expect("a number"));
        assert!((demand / resistance - ratio).abs() < 1e-12);
    }
    assert!(clauses.iter().any(|l| l["clause"] == "EN 1993-1-1 6.3.3 (6.61)"));
}

#[test]
fn many_members_and_a_failing_one() {
    let dir = tempfile::tempdir().expect("a folder");
    let file = dir.path().join("many.json");
    let one = r#"{"name": "a", "material": "C24", "section": "T_60x200", "L_mm": 2700, "NEd_kN": 20}"#;
    let two = r#"{"name": "b", "material": "C24", "section": "T_60x200", "L_mm": 2700, "NEd_kN": 900}"#;
    std::fs::write(&file, format!(r#"{{"schema": "houscaper.member/1", "members": [{one}, {two}]}}"#))
        .expect("written");
    let (code, out, _) = member(&[file.to_str().expect("a path"), "--json"]);
    let list: Value = serde_json::from_str(&out).expect("JSON");
    assert_eq!((code, &list[0]["verdict"], &list[1]["verdict"]), (2, &"ok".into(), &"not ok".into()));
}

#[test]
fn bad_input_gets_one_clear_error() {
    let dir = tempfile::tempdir().expect("a folder");
    let file = dir.path().join("bad.json");
    std::fs::write(&file, r#"{"material": "S355", "section": "IPE200", "length": 3}"#).expect("written");
    for (args, says) in [
        (vec!["--material", "CLT_CL24", "--section", "100x1000", "--compression", "1"], "cross-laminated"),
        (vec!["--material", "S355", "--section", "IPE999", "--compression", "1"], "IPE999"),
        (vec!["--material", "S355", "--section", "IPE200", "--length", "0", "--compression", "1"], "L_mm"),
        (vec!["--material", "S355", "--section", "IPE200"], "no force"),
        (vec![file.to_str().expect("a path")], "length"),
        (vec!["/nowhere.json"], "nowhere.json"),
    ] {
        let (code, out, err) = member(&args);
        assert_eq!((code, out.as_str()), (2, ""), "{args:?}: {err}");
        assert!(err.starts_with("error: ") && err.contains(says) && err.lines().count() == 1, "{args:?}: {err}");
    }
}

/// Reference examples beside the project are read as they are, their numbers compared.
#[test]
fn published_examples_are_compared() {
    let Some(shared) = std::env::var_os("HOUSCAPER_SHARED") else {
        println!("skipped: HOUSCAPER_SHARED is not set");
        return;
    };
    let folder = std::path::PathBuf::from(shared).join("reference/eurocode");
    for name in ["ec3_column_chs2445x10", "ec3_interaction_rhs200x100x16", "ec5_beam_benoit", "ec5_column_schneider"] {
        let path = folder.join(format!("{name}.json"));
        let (code, out, err) = member(&[path.to_str().expect("a path"), "--brief"]);
        assert_eq!(code, 0, "{out}{err}");
        assert!(out.contains("published values: ") && !out.contains("within"), "{out}");
    }
}
