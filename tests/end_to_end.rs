//! The main job from brief to folder: files complete and consistent, the same bytes for the same seed, refusals, kills.

#[path = "common/front.rs"]
mod front;
#[path = "common/runs.rs"]
mod runs;

use std::collections::BTreeMap;
use std::path::Path;
use std::time::{Duration, Instant};

use serde_json::json;

/// Evaluations of a small run.
const FEW: &str = "400";

fn whole_run(brief: &str) {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let (brief, out) = (runs::repository().join("configs").join(brief), folder.path().join("run"));
    let output = runs::optimize_ok(&brief, &out, &["--evaluations", FEW]);
    front::check_run(&out, &brief, 400);
    front::check_legible(&out, &brief);
    let named = String::from_utf8_lossy(&output.stdout).matches("why: ").count();
    assert!((4..=6).contains(&named), "{named} named houses");
    let run = runs::read_json(&out.join("run.json"));
    assert_eq!(run["status"], "complete");
    assert_eq!(run["counts"]["evaluations"], 400);
}

#[test]
fn starter_leaves_a_complete_and_consistent_folder() {
    whole_run("starter.json");
}

#[test]
fn two_storey_leaves_a_complete_and_consistent_folder() {
    whole_run("two-storey.json");
}

/// Files that must be the same bytes for the same seed.
fn promised(folder: &Path) -> BTreeMap<String, Vec<u8>> {
    let mut files = runs::files(folder);
    files.retain(|name, _| {
        ["evaluations.csv", "front.csv", "uncertainty.csv", "data.csv", "settings.json"].contains(&name.as_str())
            || ["clusters.csv", "whynot.csv", "whynot_houses.csv", "sensitivity.csv", "moves.csv"]
                .contains(&name.as_str())
            || name.ends_with(".svg")
            || (name.starts_with("front/") && !name.ends_with("thumb.png"))
    });
    files
}

#[test]
fn equal_seeds_give_equal_bytes_for_any_number_of_threads_and_other_seeds_others() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let brief = runs::repository().join("configs/starter.json");
    let run = |name: &str, more: &[&str]| {
        let out = folder.path().join(name);
        runs::optimize_ok(&brief, &out, &[&["--evaluations", "300"], more].concat());
        promised(&out)
    };
    let one = run("one", &["--threads", "1"]);
    assert!(one.keys().filter(|k| k.ends_with("house.glb")).count() > 3, "{:?}", one.keys());
    for (name, threads) in [("two", "2"), ("again", "1")] {
        let other = run(name, &["--threads", threads]);
        assert!(one.keys().eq(other.keys()), "{name}");
        let differing: Vec<&String> = one.keys().filter(|k| one[*k] != other[*k]).collect();
        assert!(differing.is_empty(), "{name}: {differing:?}");
    }
    let other = run("other", &["--threads", "2", "--seed", "2"]);
    assert_ne!(one["evaluations.csv"], other["evaluations.csv"]);
}

#[test]
fn a_used_output_folder_is_refused_and_left_alone() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let brief = runs::repository().join("configs/starter.json");
    for (file, text) in [("run.json", "{}"), ("letters.txt", "mine")] {
        let out = folder.path().join(file.replace('.', "-"));
        std::fs::create_dir(&out).expect("a folder");
        std::fs::write(out.join(file), text).expect("a file");
        let output = runs::optimize(&brief, &out, &["--evaluations", "10"]);
        assert_eq!(output.status.code(), Some(2), "{}", runs::said(&output));
        assert!(runs::said(&output).contains("nothing was written"), "{}", runs::said(&output));
        assert_eq!(runs::files(&out), BTreeMap::from([(file.to_owned(), text.as_bytes().to_vec())]));
    }
    let empty = folder.path().join("empty");
    std::fs::create_dir(&empty).expect("a folder");
    runs::optimize_ok(&brief, &empty, &["--evaluations", "200", "--tables-only"]);
}

#[test]
fn infeasible_limits_are_named() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let cases = [
        ("budget_eur", json!(1000), "price_eur"),
        ("gwp_kgco2e_max", json!(500), "gwp_kgco2e"),
        ("floor_area_m2_min", json!(5000), "floor_area_m2"),
    ];
    for (key, limit, named) in cases {
        let brief = runs::changed_brief("starter.json", folder.path(), |b| b["constraints"][key] = limit.clone());
        let out = folder.path().join(key);
        let output = runs::optimize(&brief, &out, &["--evaluations", "100"]);
        let said = runs::said(&output);
        assert_eq!(output.status.code(), Some(1), "{said}");
        assert!(said.contains("no feasible house") && said.contains(named), "{said}");
        let table = runs::Table::read(&out.join("whynot.csv"));
        let row = (0..table.rows.len())
            .map(|n| table.row(n))
            .find(|row| row["constraint"].contains(named) && row["limit"].parse().ok() == limit.as_f64());
        let row = row.expect("the limit");
        assert!(row["sampled"] == row["sampled_broken"] && row["sampled"] != "0", "{row:?}");
        let least = row["sampled_least_miss_percent"].parse::<f64>().expect("a number");
        assert!(
            said.contains(&format!(
                "{named}_{}: no house keeps it, the nearest misses it by {least:.1} %",
                if key.ends_with("min") { "min" } else { "max" }
            )),
            "{said}"
        );
        assert!(!said.contains("panicked"), "{said}");
    }
}

#[test]
fn a_plot_too_small_for_the_programme_is_the_inputs_fault() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let brief = runs::changed_brief("starter.json", folder.path(), |b| b["plot"]["modules"] = json!([5, 5, 17]));
    let out = folder.path().join("run");
    let output = runs::optimize(&brief, &out, &["--evaluations", "100"]);
    assert_eq!(output.status.code(), Some(2), "{}", runs::said(&output));
    assert!(runs::said(&output).contains("plot"), "{}", runs::said(&output));
    assert!(!out.exists(), "nothing is written");
}

#[test]
fn a_killed_run_leaves_a_readable_folder() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let out = folder.path().join("run");
    let mut child = runs::program()
        .args(["optimize", "configs/starter.json", "--evaluations", "10000000", "--out"])
        .arg(&out)
        .stderr(std::process::Stdio::null())
        .spawn()
        .expect("the program starts");
    let started = Instant::now();
    while !out.join("evaluations.csv").is_file() && started.elapsed() < Duration::from_secs(60) {
        std::thread::sleep(Duration::from_millis(50));
    }
    child.kill().expect("it runs");
    child.wait().expect("it ends");
    let table = runs::Table::read(&out.join("evaluations.csv"));
    assert!(!table.rows.is_empty());
    assert_eq!(runs::read_json(&out.join("run.json"))["status"], "running");
    houscaper::run::RunFolder::open(&out).expect("a run folder");
}
