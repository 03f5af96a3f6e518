//! What must hold for every house of a front, checked from the files alone.
#![allow(dead_code)]

use std::collections::BTreeMap;
use std::path::Path;

use houscaper::score::Evaluator;
use houscaper::voxels::{House, read_storeys, rules};
use serde_json::Value;

use super::runs::{self, Table};

/// Files of each house of the front.
const HOUSE_FILES: [&str; 11] = [
    "voxels.csv",
    "voxels.json",
    "house.glb",
    "frame.glb",
    "frame.json",
    "bom.csv",
    "quote.html",
    "quote.json",
    "structure.json",
    "structure.html",
    "thumb.png",
];

/// Files of the run, besides its plots.
const RUN_FILES: [&str; 7] =
    ["run.json", "evaluations.csv", "front.csv", "uncertainty.csv", "data.csv", "settings.json", "log.json"];

/// Checks a whole run folder; the houses of its front by id.
pub fn check_run(out: &Path, brief: &Path, evaluations: usize) -> BTreeMap<String, House> {
    let evaluator = runs::evaluator(brief);
    for file in RUN_FILES.iter().chain(&["plots/contact_sheet.png", "plots/hypervolume.svg", "plots/parallel.png"]) {
        assert!(out.join(file).metadata().is_ok_and(|m| m.len() > 20), "{file} is missing or empty");
    }
    check_tables(out, &evaluator, evaluations);
    let front = Table::read(&out.join("front.csv"));
    assert!(!front.rows.is_empty(), "an empty front");
    let mut houses = BTreeMap::new();
    for n in 0..front.rows.len() {
        let row = front.row(n);
        let house = check_house(&out.join("front").join(row["id"]), &evaluator, &row);
        houses.insert(row["id"].to_owned(), house);
    }
    check_uncertainty(out);
    let folders = std::fs::read_dir(out.join("front")).expect("front").count();
    assert_eq!(folders, houses.len(), "a folder per house of front.csv");
    houses
}

/// `evaluations.csv` and `front.csv`: columns of the contract, every evaluation once, the front a part of it, none dominated.
fn check_tables(out: &Path, evaluator: &Evaluator, evaluations: usize) {
    let all = Table::read(&out.join("evaluations.csv"));
    let goals = &evaluator.brief.objectives;
    let mut expected = vec!["id", "generation", "feasible", "violation"];
    expected.extend(goals.iter().map(|g| g.objective.name()));
    assert_eq!(all.header[..expected.len()], expected[..], "the columns others rely on come first");
    assert!(all.header.len() > expected.len(), "design variables follow");
    assert_eq!(all.rows.len(), evaluations);
    assert!(all.numbers("id").iter().enumerate().all(|(n, id)| *id == n as f64), "ids count the evaluations");
    let feasible = all.header.iter().position(|h| h == "feasible").expect("feasible");
    for (row, violation) in all.rows.iter().zip(all.numbers("violation")) {
        assert_eq!(row[feasible] == "true", violation == 0.0, "{row:?}");
    }
    let front = Table::read(&out.join("front.csv"));
    assert_eq!(front.header, all.header);
    assert!(front.rows.iter().all(|row| all.rows.contains(row)), "the front is a part of the evaluations");
    let columns: Vec<Vec<f64>> =
        goals.iter().map(|g| front.numbers(g.objective.name()).iter().map(|v| g.minimised(*v)).collect()).collect();
    let vector = |n: usize| -> Vec<f64> { columns.iter().map(|c| c[n]).collect() };
    for (a, b) in (0..front.rows.len()).flat_map(|a| (0..front.rows.len()).map(move |b| (a, b))) {
        assert!(!houscaper::search::dominates(&vector(a), &vector(b)), "row {a} of the front dominates row {b}");
    }
}

/// `uncertainty.csv`: the houses of the front; deciles in order around the default price; chances of two houses sum to one.
fn check_uncertainty(out: &Path) {
    let (front, table) = (Table::read(&out.join("front.csv")), Table::read(&out.join("uncertainty.csv")));
    assert_eq!(front.numbers("id"), table.numbers("id"));
    let [low, middle, high] = ["price_p10_eur", "price_p50_eur", "price_p90_eur"].map(|name| table.numbers(name));
    assert!((0..low.len()).all(|n| 0.0 < low[n] && low[n] < middle[n] && middle[n] < high[n]));
    let chances: Vec<Vec<f64>> =
        table.numbers("id").iter().map(|id| table.numbers(&format!("cheaper_than_{id}"))).collect();
    for (a, b) in (0..low.len()).flat_map(|a| (0..low.len()).map(move |b| (a, b))) {
        assert!((chances[a][b] + chances[b][a] - 1.0).abs() < 1.5e-4, "{a} {b}");
    }
}

/// One house: rules, verdict, objectives, bill, models, all from its written files.
fn check_house(folder: &Path, evaluator: &Evaluator, row: &BTreeMap<&str, &str>) -> House {
    for file in HOUSE_FILES {
        assert!(folder.join(file).metadata().is_ok_and(|m| m.len() > 20), "{}/{file}", folder.display());
    }
    let house = runs::read_house(folder);
    let broken: Vec<String> = rules::check(&house, &evaluator.rules).into_iter().map(|v| v.message).collect();
    assert_eq!(broken, Vec::<String>::new(), "{}", folder.display());
    assert_eq!(runs::read_json(&folder.join("structure.json"))["verdict"], "ok");
    let evaluation = evaluator.evaluate(&house, &runs::choices(evaluator, row));
    assert!(evaluation.is_feasible());
    for goal in &evaluator.brief.objectives {
        let (name, found) = (goal.objective.name(), evaluation.values.get(goal.objective));
        let written: f64 = row[name].parse().expect("a number");
        assert_eq!(written, found, "{name} of {}", folder.display());
    }
    check_bill(folder, evaluation.values.get(houscaper::brief::Objective::PriceEur));
    let scene = check_glb(&folder.join("house.glb"));
    assert_eq!(scene["storeys"], read_storeys(&house).storeys.len());
    check_glb(&folder.join("frame.glb"));
    house
}

/// Lines of the bill sum to the quote's subtotal; line by line they are the same but for rounding to cents.
fn check_bill(folder: &Path, price_eur: f64) {
    let (bill, quote) = (Table::read(&folder.join("bom.csv")), runs::read_json(&folder.join("quote.json")));
    let lines = quote["lines"].as_array().expect("lines");
    let amounts = bill.numbers("amount");
    assert_eq!(amounts.len(), lines.len());
    for (amount, line) in amounts.iter().zip(lines) {
        assert!((amount - line["amount"].as_f64().expect("an amount")).abs() <= 0.005 + 1e-9, "{line}");
    }
    let cents = 0.005 * (lines.len() + 3) as f64;
    let sum: f64 = amounts.iter().sum();
    let subtotal = quote["subtotal"][1].as_f64().expect("a subtotal");
    assert!((sum - subtotal).abs() <= cents, "bill {sum}, quote {subtotal}");
    let surcharges: f64 =
        quote["surcharges"].as_array().expect("surcharges").iter().filter_map(|s| s["amount"].as_f64()).sum();
    assert!(
        (subtotal + surcharges - price_eur).abs() <= 1.5 * cents,
        "quote {} against {price_eur}",
        subtotal + surcharges
    );
    for (quantity, (rate, amount)) in bill.numbers("quantity").iter().zip(bill.numbers("rate").iter().zip(&amounts)) {
        assert!((quantity * rate - amount).abs() <= 1e-6 * amount.abs().max(1.0));
    }
}

/// Reads a GLB back: accessors inside their buffer, indices inside their mesh; the scene's extras.
fn check_glb(path: &Path) -> Value {
    let gltf = gltf::Gltf::from_slice(&std::fs::read(path).expect("a GLB")).expect("a valid GLB");
    let blob = gltf.blob.as_deref().expect("a binary chunk");
    let mut triangles = 0;
    for primitive in gltf.meshes().flat_map(|m| m.primitives().collect::<Vec<_>>()) {
        let reader = primitive.reader(|_| Some(blob));
        let vertices = reader.read_positions().expect("positions").count() as u32;
        let indices: Vec<u32> = reader.read_indices().expect("indices").into_u32().collect();
        assert!(indices.iter().all(|&i| i < vertices), "{}", path.display());
        triangles += indices.len() / 3;
    }
    assert!(triangles > 50, "{} has {triangles} triangles", path.display());
    let scene = gltf.default_scene().expect("a scene");
    scene.extras().as_ref().map_or(Value::Null, |e| serde_json::from_str(e.get()).expect("extras"))
}

/// Zone areas of a house as its GLB states them.
pub fn zones_in_glb(folder: &Path) -> BTreeMap<String, f64> {
    let scene = check_glb(&folder.join("house.glb"));
    let zones = scene["zones_m2"].as_object().expect("zones_m2 in the extras");
    zones.iter().map(|(zone, area)| (zone.clone(), area.as_f64().expect("an area"))).collect()
}

/// What makes a front legible: groups by look, what binds, and single changes around the named houses, each against the other files and,
/// where it can be, against an evaluation of its own.
pub fn check_legible(out: &Path, brief: &Path) {
    let evaluator = runs::evaluator(brief);
    let front = Table::read(&out.join("front.csv"));
    check_clusters(out, &front);
    check_why_not(out, &evaluator, &front);
    check_sensitivity(out, &evaluator, &front);
    for plot in ["clusters.png", "moves.svg", "moves.png", "hypervolume.png"] {
        assert!(out.join("plots").join(plot).metadata().is_ok_and(|m| m.len() > 500), "{plot}");
    }
}

/// `clusters.csv`: every house of the front in one group, one in the middle of each, which alone says what they share.
fn check_clusters(out: &Path, front: &Table) {
    let table = Table::read(&out.join("clusters.csv"));
    assert_eq!(table.numbers("id"), front.numbers("id"));
    assert_eq!(table.numbers("storeys"), front.numbers("storeys"));
    let mut middles: BTreeMap<&str, usize> = BTreeMap::new();
    for n in 0..table.rows.len() {
        let row = table.row(n);
        *middles.entry(row["cluster"]).or_default() += usize::from(row["is_medoid"] == "true");
        assert_eq!(row["is_medoid"] == "true", row["shared"].contains("plan of"), "{row:?}");
        let windows: f64 = front.row(n)["windows"].parse().expect("a count");
        let glass: f64 =
            ["east", "north", "west", "south"].map(|s| table.numbers(&format!("glass_{s}_m2"))[n]).iter().sum();
        assert_eq!(windows > 0.0, glass > 0.0);
        assert!(row["is_knee"] == "false" || table.numbers("trade_off")[n] > 1.0);
    }
    assert!(middles.values().all(|n| *n == 1), "{middles:?}");
}

/// `whynot.csv` and `whynot_houses.csv`: counts that go together, and houses that were evaluated, are infeasible by what is said, and
/// are dominated by no house of the front.
fn check_why_not(out: &Path, evaluator: &Evaluator, front: &Table) {
    let table = Table::read(&out.join("whynot.csv"));
    let [sampled, broken, near, near_broken, alone, along, active] =
        ["sampled", "sampled_broken", "near", "near_broken", "near_broken_alone", "front", "front_within_2_percent"]
            .map(|name| table.numbers(name));
    for n in 0..table.rows.len() {
        assert!(
            broken[n] <= sampled[n] && alone[n] <= near_broken[n] && near_broken[n] <= near[n] && active[n] <= along[n]
        );
        assert_eq!(along[n], front.rows.len() as f64);
    }
    assert!(broken.iter().any(|n| *n > 0.0), "something is broken in some house");
    let (houses, all) = (Table::read(&out.join("whynot_houses.csv")), Table::read(&out.join("evaluations.csv")));
    assert_eq!(houses.rows.len() as f64, near[0]);
    let goals = &evaluator.brief.objectives;
    let vector = |table: &Table, n: usize| -> Vec<f64> {
        goals.iter().map(|g| g.minimised(table.numbers(g.objective.name())[n])).collect()
    };
    let keys: Vec<String> = (0..table.rows.len()).map(|n| table.row(n)["constraint"].to_owned()).collect();
    let best: Vec<Vec<f64>> = (0..front.rows.len()).map(|n| vector(front, n)).collect();
    for n in 0..houses.rows.len() {
        let row = houses.row(n);
        let evaluated = all.row(row["id"].parse().expect("an id"));
        assert_eq!(evaluated["feasible"], "false");
        assert_eq!(evaluated["violation"], row["violation"]);
        assert!(goals.iter().all(|g| evaluated[g.objective.name()] == row[g.objective.name()]));
        assert!(keys.iter().any(|k| k == row["binding"]), "{row:?}");
        let own = vector(&houses, n);
        assert!(best.iter().all(|b| !houscaper::search::dominates(b, &own)), "{row:?}");
        assert!(front.rows.iter().any(|f| f[0] == row["nearest_in_front"]));
    }
}

/// `sensitivity.csv`: ranges in order, those of all houses around those of the feasible ones; what a section does, by evaluation.
fn check_sensitivity(out: &Path, evaluator: &Evaluator, front: &Table) {
    let table = Table::read(&out.join("sensitivity.csv"));
    let mut evaluated = 0;
    for n in 0..table.rows.len() {
        let row = table.row(n);
        let number = |name: &str| row[name].parse::<f64>().ok();
        let (neighbours, feasible) = (number("neighbours"), number("feasible"));
        assert!(feasible <= neighbours && neighbours > Some(0.0));
        assert_eq!(number("least_percent").is_some(), feasible > Some(0.0), "{row:?}");
        let [Some(low), Some(high)] = ["least_percent", "greatest_percent"].map(number) else { continue };
        let outer = ["infeasible_too_least_percent", "infeasible_too_greatest_percent"]
            .map(|name| number(name).expect("wider"));
        assert!(outer[0] <= low && low <= high && high <= outer[1], "{row:?}");
        assert!(out.join(format!("plots/sensitivity/{}.png", row["house"])).is_file());
        if !row["change"].starts_with("rafter") || evaluated > 11 {
            continue;
        }
        let at = front.rows.iter().position(|f| f[0] == row["house"]).expect("a house of the front");
        let house = runs::read_house(&out.join("front").join(row["house"]));
        let choices = runs::choices(evaluator, &front.row(at));
        let goal =
            evaluator.brief.objectives.iter().find(|g| g.objective.name() == row["objective"]).expect("an objective");
        for (end, by) in [(low, "least_by"), (high, "greatest_by")] {
            let options = &evaluator.options[3];
            let option =
                options.iter().position(|o| evaluator.catalogue.option_name(*o) == row[by]).expect("an option");
            let mut changed = choices;
            changed.0[3] = option as u16;
            let [old, new] = [choices, changed].map(|c| evaluator.evaluate(&house, &c).values.get(goal.objective));
            assert!((100.0 * (new / old - 1.0) - end).abs() < 1e-9 * end.abs().max(1.0), "{row:?}");
            evaluated += 1;
        }
    }
    assert!(evaluated > 0, "no section was changed");
}
