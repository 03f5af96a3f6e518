//! `report.html`: what is in it, what it says is missing, and what a browser does with it.

#[path = "common/runs.rs"]
mod runs;

use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};
use std::sync::OnceLock;

use runs::repository;
use serde_json::{Value, json};

/// Designs that the page must answer fast with.
const DESIGNS: usize = 5000;

/// A name that would end its element, and be markup, if it were not written as text.
const HOSTILE: &str = "</script><img src=x onerror=alert(1)> \"a\" & 'b'";

fn report(folder: &Path) -> Output {
    runs::program().args(["report", "--json"]).arg(folder).output().expect("the program starts")
}

fn report_ok(folder: &Path) -> Value {
    let output = report(folder);
    assert!(output.status.success(), "{}", runs::said(&output));
    serde_json::from_slice(&output.stdout).expect("JSON")
}

fn page(folder: &Path) -> String {
    std::fs::read_to_string(folder.join("report.html")).expect("the page")
}

/// A short real search; its table goes on with rows like its own up to [`DESIGNS`].
fn run() -> &'static Path {
    static RUN: OnceLock<tempfile::TempDir> = OnceLock::new();
    let place = RUN.get_or_init(|| {
        let place = tempfile::tempdir().expect("a folder");
        let out = place.path().join("run");
        runs::optimize_ok(&repository().join("configs/starter.json"), &out, &["--evaluations", "400"]);
        assert!(page(&out).contains("houscaper.report/1"), "the search itself ends with the page");
        let file = out.join("evaluations.csv");
        let mut table = std::fs::read_to_string(&file).expect("a table");
        let rows: Vec<String> = table.lines().skip(1).map(str::to_owned).collect();
        for id in rows.len()..DESIGNS {
            let (_, rest) = rows[id % rows.len()].split_once(',').expect("an id");
            let _ = writeln!(table, "{id},{rest}");
        }
        std::fs::write(&file, table).expect("a table");
        let mark = out.join("run.json");
        let mut run = runs::read_json(&mark);
        run["brief"]["name"] = json!(HOSTILE);
        std::fs::write(&mark, run.to_string()).expect("a mark");
        report_ok(&out);
        place
    });
    Box::leak(place.path().join("run").into_boxed_path())
}

#[test]
fn a_run_is_whole_within_its_budget_and_the_same_again() {
    let told = report_ok(run());
    let houses = told["houses"].as_u64().unwrap() as usize;
    assert!(houses >= 4 && told["houses_with_files"] == houses, "{told}");
    assert_eq!(
        (&told["designs"], &told["designs_shown"], &told["missing"]),
        (&json!(DESIGNS), &json!(DESIGNS), &json!([]))
    );
    let first = page(run());
    let before = first.find("<script type=\"text/plain\"").expect("pictures");
    assert!(before < 1_000_000, "{before} bytes before the first plot");
    assert!(first.len() - before < houses * 500_000, "{} bytes for {houses} houses", first.len());
    // Nothing is fetched, and a name is never markup.
    for address in ["src=\"http", "href=\"http", "url(", "@import", "fetch("] {
        assert!(!first[..before].contains(address), "{address}");
    }
    assert!(!first.contains("<img src=x") && first.contains("&lt;/script&gt;&lt;img"), "the title is text");
    report_ok(run());
    assert!(page(run()) == first, "the same folder gives the same page");
}

#[test]
fn a_folder_with_fewer_files_says_what_is_missing() {
    let place = tempfile::tempdir().unwrap();
    let from = repository().join("results/starter");
    for file in ["run.json", "front.csv", "clusters.csv"] {
        std::fs::copy(from.join(file), place.path().join(file)).unwrap();
    }
    let told = report_ok(place.path());
    let missing: Vec<&str> = told["missing"].as_array().unwrap().iter().filter_map(Value::as_str).collect();
    let says = |what: &str| assert!(missing.iter().any(|m| m.contains(what)), "{what}: {missing:?}");
    ["evaluations.csv", "whynot.csv", "67 of 67 houses have figures only"].into_iter().for_each(says);
    assert!(told["designs"].is_null() && !missing.iter().any(|m| m.contains("clusters.csv")), "{missing:?}");
}

#[test]
fn a_built_house_has_a_page_too() {
    let place = tempfile::tempdir().unwrap();
    let out = place.path().join("villa");
    let built = runs::program().args(["build", "sample:villa", "--out"]).arg(&out).output().unwrap();
    assert!(built.status.success(), "{}", runs::said(&built));
    let told = report_ok(&out);
    assert_eq!((&told["houses"], &told["houses_with_files"]), (&json!(1), &json!(1)));
    assert!(page(&out).contains("id=\"0/house.glb\""));
}

#[test]
fn what_cannot_be_reported_is_said() {
    let place = tempfile::tempdir().unwrap();
    let failed = |what: &str| {
        let output = report(place.path());
        assert_eq!(output.status.code(), Some(2), "{what}");
        assert!(runs::said(&output).contains(what), "{what}: {}", runs::said(&output));
        assert!(!place.path().join("report.html").exists());
    };
    failed("not a run folder");
    std::fs::write(place.path().join("run.json"), "{\"schema\": \"houscaper.quote-run/1\"}").unwrap();
    failed("schema is \"houscaper.quote-run/1\"");
    std::fs::write(
        place.path().join("run.json"),
        "{\"schema\": \"houscaper.run/1\", \"brief\": {\"objectives\": [\"price_eur\"]}}",
    )
    .unwrap();
    failed("front.csv: is not there");
    std::fs::write(place.path().join("front.csv"), "id,price_eur\n../3,1\n").unwrap();
    failed("front.csv, line 2: id '../3'");
    // A run that is going on keeps its temporary files.
    let part = place.path().join(".evaluations.csv.part");
    std::fs::write(&part, "").unwrap();
    std::fs::write(place.path().join("front.csv"), "id,price_eur\n3,1\n").unwrap();
    report_ok(place.path());
    assert!(part.exists());
}

/// A browser and what drives it, where they are there.
fn browser() -> Option<(PathBuf, PathBuf)> {
    let driver = PathBuf::from(std::env::var_os("PLAYWRIGHT_DIR")?);
    let chromium = std::env::var_os("CHROMIUM").map_or_else(|| PathBuf::from("/usr/bin/chromium"), PathBuf::from);
    (driver.is_dir() && chromium.is_file()).then_some((driver, chromium))
}

#[test]
fn a_browser_shows_brushes_chooses_and_compares() {
    let Some((driver, chromium)) = browser() else {
        println!("skipped: PLAYWRIGHT_DIR (the folder of playwright-core) or chromium is not there");
        return;
    };
    let told = Command::new("node")
        .arg(repository().join("tests/tools/report_page.mjs"))
        .arg(run().join("report.html"))
        .args([DESIGNS.to_string(), HOSTILE.to_owned()])
        .env("PLAYWRIGHT_DIR", driver)
        .env("CHROMIUM", chromium)
        .output()
        .expect("node starts");
    let said = format!("{}\n{}", String::from_utf8_lossy(&told.stdout), runs::said(&told));
    println!("{said}");
    assert!(told.status.success(), "{said}");
}
