//! A run that is killed at any instant, or stopped, and resumed ends with the same bytes as one that was let be.

#[path = "common/runs.rs"]
mod runs;

use std::collections::BTreeMap;
use std::path::Path;
use std::process::{Child, Command, Stdio};
use std::thread::sleep;
use std::time::Duration;

use serde_json::json;

/// Files whose bytes do not depend on the way a run went.
fn lasting(out: &Path) -> BTreeMap<String, Vec<u8>> {
    let mut files = BTreeMap::new();
    for name in ["evaluations.csv", "front.csv", "moves.csv", "data.csv", "uncertainty.csv"] {
        files.insert(name.to_owned(), std::fs::read(out.join(name)).unwrap_or_else(|e| panic!("{name}: {e}")));
    }
    let Ok(front) = std::fs::read_dir(out.join("front")) else { return files };
    for house in front.flatten() {
        for file in std::fs::read_dir(house.path()).expect("a house").flatten() {
            let name = format!("{}/{}", house.file_name().to_string_lossy(), file.file_name().to_string_lossy());
            files.insert(name, std::fs::read(file.path()).expect("a file"));
        }
    }
    files
}

fn assert_same(whole: &BTreeMap<String, Vec<u8>>, other: &BTreeMap<String, Vec<u8>>, what: &str) {
    let names = |files: &BTreeMap<String, Vec<u8>>| files.keys().cloned().collect::<Vec<_>>();
    assert_eq!(names(whole), names(other), "{what}");
    let differ: Vec<&String> = whole.iter().filter(|(name, bytes)| other[*name] != **bytes).map(|f| f.0).collect();
    assert!(differ.is_empty(), "{what}: {differ:?} differ");
}

fn started(brief: &Path, out: &Path, more: &[&str]) -> Child {
    let mut command = runs::program();
    // A killed run may not have left its mark yet: then it is begun, else carried on.
    if out.join("run.json").is_file() {
        command.arg("resume").arg(out);
    } else {
        command.arg("optimize").arg(brief).arg("--out").arg(out);
    }
    command.args(more).stdout(Stdio::null()).stderr(Stdio::piped()).spawn().expect("the program starts")
}

/// Waits for a child at most so long; `None` when it still runs.
fn wait(child: &mut Child, longest: Duration) -> Option<bool> {
    let step = Duration::from_millis(5);
    for _ in 0..longest.as_millis() / 5 {
        if let Some(status) = child.try_wait().expect("a child") {
            return Some(status.success());
        }
        sleep(step);
    }
    None
}

#[test]
fn killed_at_any_instant_and_resumed_it_ends_with_the_same_bytes() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let brief = runs::changed_brief("starter.json", folder.path(), |b| b["search"]["evaluations"] = json!(300));
    let whole = folder.path().join("whole");
    runs::optimize_ok(&brief, &whole, &["--threads", "2"]);
    let whole = lasting(&whole);
    assert!(whole.len() > 20, "{}", whole.len());
    let mut state = 20_261_122_u64;
    let mut next = |below: u64| {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 33) % below
    };
    let mut kills = 0;
    for round in 0..1 {
        let out = folder.path().join(format!("killed{round}"));
        let mut ended = false;
        for n in 0..200u64 {
            let threads = ["1", "2"][(next(2)) as usize];
            let mut child = started(&brief, &out, &["--threads", threads]);
            // Early instants first, then longer and longer, so that a run gets to its end on a machine of any speed.
            match wait(&mut child, Duration::from_millis(20 + next(150 + 40 * n * n))) {
                Some(success) => {
                    assert!(success, "{}", runs::said(&child.wait_with_output().expect("a child")));
                    ended = true;
                    break;
                }
                None => {
                    child.kill().expect("a running child");
                    child.wait().expect("a child");
                    kills += 1;
                }
            }
        }
        assert!(ended, "round {round} never ended");
        assert_same(&whole, &lasting(&out), &format!("round {round} after {kills} kills"));
    }
    println!("{kills} kills");
    assert!(kills > 4, "{kills}");
}

/// A checkpoint that is cut off anywhere, as by a power failure, is carried on from its last whole batch; one of another search is refused.
#[test]
fn a_torn_checkpoint_is_carried_on_and_a_foreign_one_refused() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let brief = runs::changed_brief("starter.json", folder.path(), |b| b["search"]["evaluations"] = json!(200));
    let out = folder.path().join("run");
    runs::optimize_ok(&brief, &out, &["--tables-only"]);
    let whole = lasting(&out);
    let bytes = std::fs::read(out.join("checkpoint")).expect("a checkpoint");
    for keep in [0, 3, 8, 9, 30, bytes.len() / 3, bytes.len() / 2, bytes.len() - 1] {
        std::fs::write(out.join("checkpoint"), &bytes[..keep]).expect("a file");
        mark(&out, |m| m["status"] = json!("running"));
        let output = runs::program().arg("resume").arg(&out).output().expect("the program starts");
        assert!(output.status.success(), "cut at {keep}: {}", runs::said(&output));
        assert_same(&whole, &lasting(&out), &format!("cut at {keep}"));
        assert_eq!(std::fs::read(out.join("checkpoint")).expect("a checkpoint").len(), bytes.len(), "cut at {keep}");
    }
    // Complete: nothing to do. With another seed the houses do not fit the scores.
    let output = runs::program().arg("resume").arg(&out).output().expect("the program starts");
    assert!(output.status.success() && runs::said(&output).contains("complete"), "{}", runs::said(&output));
    mark(&out, |m| (m["status"], m["resume"]["seed"]) = (json!("running"), json!(7)));
    let output = runs::program().arg("resume").arg(&out).output().expect("the program starts");
    assert_eq!(output.status.code(), Some(1));
    assert!(runs::said(&output).contains("holds other houses"), "{}", runs::said(&output));
    // A book that has changed since is named.
    mark(&out, |m| m["hashes"]["carbon"] = json!("sha256:0"));
    let output = runs::program().arg("resume").arg(&out).output().expect("the program starts");
    assert_eq!(output.status.code(), Some(2));
    assert!(runs::said(&output).contains("changed since the run began: carbon"), "{}", runs::said(&output));
    let output = runs::program().arg("resume").arg(folder.path()).output().expect("the program starts");
    assert_eq!(output.status.code(), Some(2));
}

/// The map of elites is told from the scores alone: table and drawing come out the same from a run that was cut off.
#[test]
fn a_map_of_elites_is_the_same_after_a_cut() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let brief = runs::changed_brief("starter.json", folder.path(), |b| {
        b["search"]["evaluations"] = json!(160);
        b["search"]["algorithm"] = json!("map-elites");
    });
    let out = folder.path().join("run");
    runs::optimize_ok(&brief, &out, &[]);
    let map = || ["map.csv", "plots/map.svg", "plots/map.png"].map(|f| std::fs::read(out.join(f)).expect("the map"));
    let (whole, drawn) = (lasting(&out), map());
    let table = runs::Table::read(&out.join("map.csv"));
    let cells: BTreeMap<Vec<String>, &String> = table.rows.iter().map(|r| (r[..4].to_vec(), &r[4])).collect();
    assert_eq!(cells.len(), table.rows.len(), "a kind has one row");
    assert_eq!(String::from_utf8_lossy(&drawn[1]).matches("<image").count(), cells.len());
    let evaluations = runs::Table::read(&out.join("evaluations.csv"));
    for row in &table.rows {
        let id: usize = row[4].parse().expect("an id");
        assert_eq!(row[5..8], evaluations.rows[id][4..7], "the table of evaluations has the same objectives");
    }
    let bytes = std::fs::read(out.join("checkpoint")).expect("a checkpoint");
    std::fs::write(out.join("checkpoint"), &bytes[..bytes.len() / 2]).expect("a file");
    mark(&out, |m| m["status"] = json!("running"));
    let output = runs::program().arg("resume").arg(&out).output().expect("the program starts");
    assert!(output.status.success(), "{}", runs::said(&output));
    assert_same(&whole, &lasting(&out), "cut in the middle");
    assert!(drawn == map(), "the map differs");
}

fn mark(out: &Path, change: impl FnOnce(&mut serde_json::Value)) {
    let mut mark = runs::read_json(&out.join("run.json"));
    change(&mut mark);
    std::fs::write(out.join("run.json"), mark.to_string()).expect("a file");
}

/// Ctrl-C ends a run with a full report; resumed, it ends as if it had not been stopped. So does a run with a time limit, and one that is
/// let go further than it was planned to.
#[cfg(unix)]
#[test]
fn a_stopped_run_has_a_report_and_can_be_carried_on() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let brief = runs::changed_brief("starter.json", folder.path(), |b| b["search"]["evaluations"] = json!(900));
    let whole = folder.path().join("whole");
    runs::optimize_ok(&brief, &whole, &["--tables-only"]);
    let whole = lasting(&whole);
    let out = folder.path().join("stopped");
    let mut child = started(&brief, &out, &["--tables-only"]);
    while std::fs::metadata(out.join("checkpoint")).map_or(0, |m| m.len()) < 5000 {
        sleep(Duration::from_millis(5));
        assert!(child.try_wait().expect("a child").is_none(), "ended before it could be stopped");
    }
    let sent = Command::new("kill").args(["-INT", &child.id().to_string()]).status().expect("kill");
    assert!(sent.success());
    let output = child.wait_with_output().expect("a child");
    assert!(output.status.success(), "{}", runs::said(&output));
    assert!(runs::said(&output).contains("houscaper resume"), "{}", runs::said(&output));
    let stopped = runs::read_json(&out.join("run.json"));
    assert_eq!(stopped["status"], "stopped");
    let done = stopped["counts"]["evaluations"].as_u64().expect("a count");
    assert!((1..900).contains(&done), "{done}");
    assert_eq!(runs::Table::read(&out.join("evaluations.csv")).rows.len() as u64, done);
    assert!(out.join("plots/hypervolume.svg").is_file() && out.join("front.csv").is_file());
    // A little further by a time limit, then to its end.
    for more in [&["--time-limit", "0.3"][..], &[]] {
        let output = runs::program().arg("resume").arg(&out).args(more).output().expect("the program starts");
        assert!(output.status.success(), "{}", runs::said(&output));
    }
    assert_same(&whole, &lasting(&out), "stopped and resumed");
    let further = runs::program().arg("resume").arg(&out).args(["--evaluations", "960"]).output().expect("the program");
    assert!(further.status.success(), "{}", runs::said(&further));
    let table = std::fs::read(out.join("evaluations.csv")).expect("a table");
    assert!(table.starts_with(&whole["evaluations.csv"]) && table.len() > whole["evaluations.csv"].len());
}

/// Runs of different seeds and algorithms, put together: the table has all their rows, the front is the non-dominated set of them.
#[test]
fn merged_runs_are_one_archive_of_all_evaluations() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let brief = runs::changed_brief("starter.json", folder.path(), |b| b["search"]["evaluations"] = json!(250));
    let place = |name: &str| folder.path().join(name);
    runs::optimize_ok(&brief, &place("a"), &["--tables-only"]);
    runs::optimize_ok(&brief, &place("b"), &["--tables-only", "--seed", "2", "--method", "nsga3"]);
    let merge = |out: &str, runs_of: &[&str]| {
        let mut command = runs::program();
        command.arg("merge").args(runs_of.iter().map(|r| place(r))).arg("--out").arg(place(out)).arg("--tables-only");
        command.output().expect("the program starts")
    };
    let output = merge("ab", &["a", "b"]);
    assert!(output.status.success(), "{}", runs::said(&output));
    let tables = ["a", "b", "ab"].map(|r| runs::Table::read(&place(r).join("evaluations.csv")));
    let [a, b, both] = &tables;
    assert_eq!(both.rows.len(), a.rows.len() + b.rows.len());
    for (n, row) in a.rows.iter().chain(&b.rows).enumerate() {
        assert_eq!(both.rows[n][0], n.to_string());
        assert_eq!(both.rows[n][2..], row[2..], "row {n}");
    }
    // Price and carbon are minimised, floor area is maximised; of equal rows the first stays.
    let points: Vec<[f64; 3]> = {
        let [price, carbon, area] = ["price_eur", "gwp_kgco2e", "floor_area_m2"]
            .map(|c| both.header.iter().position(|h| h == c).expect("a column"));
        let number = |row: &Vec<String>, at: usize| row[at].parse::<f64>().unwrap_or(f64::INFINITY);
        both.rows.iter().map(|r| [number(r, price), number(r, carbon), -number(r, area)]).collect()
    };
    let feasible = |n: &usize| both.rows[*n][2] == "true";
    let covers = |a: &[f64; 3], b: &[f64; 3]| a.iter().zip(b).all(|(x, y)| x <= y);
    let all: Vec<usize> = (0..points.len()).filter(feasible).collect();
    let beaten =
        |n: &usize| all.iter().any(|m| covers(&points[*m], &points[*n]) && (points[*m] != points[*n] || m < n));
    let mut expected: Vec<String> = all.iter().filter(|n| !beaten(n)).map(usize::to_string).collect();
    let mut front: Vec<String> =
        runs::Table::read(&place("ab").join("front.csv")).rows.iter().map(|r| r[0].clone()).collect();
    expected.sort();
    front.sort();
    assert!(front.len() > 3);
    assert_eq!(front, expected);
    // One run alone is merged to itself; runs of other briefs are refused.
    assert!(merge("aa", &["a"]).status.success());
    for file in ["evaluations.csv", "front.csv"] {
        let [one, same] = ["a", "aa"].map(|r| std::fs::read(place(r).join(file)).expect("a table"));
        assert!(one == same, "{file}");
    }
    // A merged folder stands for its runs, each counted once: in steps as at once.
    runs::optimize_ok(&brief, &place("d"), &["--tables-only", "--seed", "3"]);
    assert!(merge("abd", &["a", "b", "d"]).status.success());
    let output = merge("ab-d", &["ab", "d", "b"]);
    assert!(output.status.success() && runs::said(&output).contains("counted once"), "{}", runs::said(&output));
    for file in ["evaluations.csv", "front.csv", "moves.csv"] {
        let [one, same] = ["abd", "ab-d"].map(|r| std::fs::read(place(r).join(file)).expect("a table"));
        assert!(one == same, "{file}");
    }
    let output = runs::program().arg("resume").arg(place("ab")).output().expect("the program starts");
    assert_eq!(output.status.code(), Some(2));
    assert!(runs::said(&output).contains("merged from"), "{}", runs::said(&output));
    std::fs::rename(place("d"), place("gone")).expect("a run");
    let output = merge("again", &["abd"]);
    assert_eq!(output.status.code(), Some(2));
    assert!(runs::said(&output).contains("which is not there"), "{}", runs::said(&output));
    let other = runs::changed_brief("two-storey.json", folder.path(), |b| b["search"]["evaluations"] = json!(100));
    runs::optimize_ok(&other, &place("c"), &["--tables-only"]);
    let output = merge("ac", &["a", "c"]);
    assert_eq!(output.status.code(), Some(2));
    assert!(runs::said(&output).contains("another brief"), "{}", runs::said(&output));
    assert!(!place("ac").exists());
}
