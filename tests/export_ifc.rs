//! `house.ifc`: a STEP file whose references, ids and sums hold, the same each time; and, where `IFC_PYTHON` names a Python with
//! IfcOpenShell, what another program reads from it.

#[path = "common/runs.rs"]
mod runs;

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};
use std::process::Command;

use houscaper::export::dossier::{Extent, dossier};
use houscaper::export::ifc::{global_id, house_ifc};
use houscaper::score::{Evaluator, Tiling};
use houscaper::voxels::{Choices, House, samples};
use serde_json::Value;

/// Tilesets of every kind: two styles, a surface with roofs, one that stands off the voxels.
const TILESETS: [&str; 4] = ["architectural", "larch", "surface-2", "surface-1-offset"];

fn evaluator(tileset: &str, folder: &Path) -> Evaluator {
    runs::evaluator(&runs::changed_brief("starter.json", folder, |b| b["tileset"] = tileset.into()))
}

fn sample(name: &str) -> House {
    let all = samples::all().into_iter().chain(samples::gallery());
    all.into_iter().find(|(n, _)| *n == name).map(|(_, house)| house).expect("a sample")
}

fn model(name: &str, house: &House, evaluator: &Evaluator) -> String {
    let choices = Choices::default();
    let details = evaluator.details(house, &choices);
    let fabric = evaluator.tiling.fabric(house, &details.reading);
    let rows = evaluator.origins(house, &choices, &details).unwrap_or_default();
    let bytes = house_ifc(name, house, &choices, &details, evaluator, fabric.as_ref(), &rows).expect("a model");
    String::from_utf8(bytes).expect("STEP is ASCII")
}

/// Entities by number: class and attributes as text.
fn entities(text: &str) -> BTreeMap<u32, (&str, &str)> {
    let data = text.split_once("DATA;\n").expect("a data section").1.split_once("ENDSEC;").expect("its end").0;
    let entity = |line: &'_ str| -> Option<(u32, usize)> {
        Some((line.strip_prefix('#')?.split('=').next()?.parse().ok()?, line.find('=')?))
    };
    data.lines()
        .map(|line| {
            let (number, equals) = entity(line).unwrap_or_else(|| panic!("no entity: {line}"));
            let (class, rest) = line[equals + 1..].split_once('(').expect("attributes");
            (number, (class, rest.strip_suffix(");").expect("an end")))
        })
        .collect()
}

/// Attributes at the top level.
fn attributes(text: &str) -> Vec<&str> {
    let (mut depth, mut quoted, mut from, mut all) = (0, false, 0, Vec::new());
    for (at, c) in text.char_indices() {
        match c {
            '\'' => quoted = !quoted,
            '(' if !quoted => depth += 1,
            ')' if !quoted => depth -= 1,
            ',' if !quoted && depth == 0 => {
                all.push(&text[from..at]);
                from = at + 1;
            }
            _ => {}
        }
    }
    all.push(&text[from..]);
    all
}

fn references(list: &str) -> Vec<u32> {
    list.trim_matches(['(', ')']).split(',').filter_map(|r| r.strip_prefix('#')?.parse().ok()).collect()
}

/// Sums of `Houscaper_TakeOff` by line of the bill, over every product and the building.
fn sums(all: &BTreeMap<u32, (&str, &str)>) -> BTreeMap<usize, f64> {
    let mut sums = BTreeMap::new();
    for (class, text) in all.values() {
        let set = attributes(text);
        if *class != "IFCELEMENTQUANTITY" || set[2] != "'Houscaper_TakeOff'" {
            continue;
        }
        for quantity in references(set[5]) {
            let quantity = attributes(all[&quantity].1);
            let line = quantity[1].trim_matches('\'').strip_prefix("line ").and_then(|l| l.split(':').next());
            let line = line.and_then(|l| l.parse::<usize>().ok()).expect("a line of the bill");
            *sums.entry(line).or_insert(0.0) += quantity[3].parse::<f64>().expect("a number");
        }
    }
    sums
}

#[test]
fn references_hold_ids_are_unique_and_quantities_sum_to_the_takeoff() {
    let folder = tempfile::tempdir().expect("a folder");
    for tileset in TILESETS {
        let evaluator = evaluator(tileset, folder.path());
        for name in ["box", "villa", "flat", "l_hip"] {
            let house = sample(name);
            let text = model(name, &house, &evaluator);
            assert!(text.is_ascii() && text.starts_with("ISO-10303-21;\n"));
            let all = entities(&text);
            let mut ids = BTreeSet::new();
            for (number, (class, text)) in &all {
                for token in text.split(['(', ')', ',']).filter_map(|t| t.strip_prefix('#')) {
                    let other: u32 = token.parse().expect("a number");
                    assert!(other < *number && all.contains_key(&other), "{class} #{number} refers to #{other}");
                }
                let first = attributes(text)[0];
                let rooted = !class.starts_with("IFCPROPERTYSINGLE") && !class.starts_with("IFCQUANTITY");
                if rooted && first.len() == 24 && first.starts_with('\'') {
                    assert!(ids.insert(first.to_owned()), "{class} {first} is there twice");
                }
            }
            assert!(ids.contains(&format!("'{}'", global_id(&[name, "building", ""]))));
            let choices = Choices::default();
            let rows = evaluator.origins(&house, &choices, &evaluator.details(&house, &choices)).expect("a take-off");
            let sums = sums(&all);
            assert_eq!(sums.len(), rows.len(), "{tileset} {name}");
            for row in &rows {
                // The same doubles in another order.
                let off = (sums[&row.line] - row.quantity).abs();
                assert!(off <= 1e-9 * row.quantity.max(1.0), "{tileset} {name} {:?}: {off}", row.item);
            }
        }
    }
}

/// A style shows everything that is taken off; nothing is left for the building.
#[test]
fn solids_leave_nothing_to_the_building() {
    let folder = tempfile::tempdir().expect("a folder");
    let evaluator = evaluator("architectural", folder.path());
    for (name, house) in samples::all().into_iter().chain(samples::gallery()) {
        let text = model(name, &house, &evaluator);
        let building = global_id(&[name, "quantities", "building/Houscaper_TakeOff"]);
        assert!(!text.contains(&building), "{name}");
    }
}

#[test]
fn the_same_house_has_the_same_bytes_on_any_number_of_threads() {
    let folder = tempfile::tempdir().expect("a folder");
    let evaluator = evaluator("larch", folder.path());
    let house = sample("villa");
    let once = model("villa", &house, &evaluator);
    for threads in [1, 3] {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("threads");
        assert!(pool.install(|| model("villa", &house, &evaluator)) == once, "{threads} threads");
    }
    // Another name gives other ids and nothing else of another length.
    let other = model("zilla", &house, &evaluator);
    assert_eq!(other.len(), once.len());
    let rooted = |(class, text): &(&str, &str)| {
        let first = attributes(text)[0].to_owned();
        (class.starts_with("IFCREL") && first.len() == 24).then_some(first)
    };
    let ids = |text: &str| entities(text).values().filter_map(rooted).collect::<BTreeSet<_>>();
    assert!(!ids(&once).is_empty() && ids(&other).is_disjoint(&ids(&once)));
}

/// Best of three, so that a busy machine says something of the program: with its origins, which a front has no other use for.
#[test]
fn a_house_takes_less_than_a_second() {
    let folder = tempfile::tempdir().expect("a folder");
    let evaluator = evaluator("architectural", folder.path());
    for (name, house) in samples::all().into_iter().chain(samples::gallery()) {
        let (choices, details) = (Choices::default(), evaluator.details(&house, &Choices::default()));
        let fabric = evaluator.tiling.fabric(&house, &details.reading);
        let once = || {
            let begun = std::time::Instant::now();
            let rows = evaluator.origins(&house, &choices, &details).expect("a take-off");
            let bytes =
                house_ifc(name, &house, &choices, &details, &evaluator, fabric.as_ref(), &rows).expect("a model");
            (begun.elapsed().as_secs_f64(), bytes.len())
        };
        let (seconds, bytes) = (0..3).map(|_| once()).fold((f64::INFINITY, 0), |best, one| (best.0.min(one.0), one.1));
        println!("{name}: {:.0} ms, {} kB", 1e3 * seconds, bytes / 1000);
        assert!(seconds < 1.0, "{name}: {seconds} s");
    }
}

/// The Python with IfcOpenShell, if there is one.
fn python() -> Option<PathBuf> {
    let python = std::env::var_os("IFC_PYTHON").map(PathBuf::from).filter(|p| p.is_file());
    if python.is_none() {
        println!("skipped: IFC_PYTHON names no Python with ifcopenshell");
    }
    python
}

fn checked(python: &Path, files: &[PathBuf]) -> Vec<Value> {
    let output = Command::new(python).arg(runs::repository().join("tests/tools/ifc_check.py")).args(files).output();
    let output = output.expect("Python starts");
    let said = String::from_utf8_lossy(&output.stderr).into_owned();
    serde_json::from_slice(&output.stdout).unwrap_or_else(|e| panic!("{e}: {said}"))
}

#[test]
fn ifcopenshell_finds_no_fault() {
    let Some(python) = python() else { return };
    let folder = tempfile::tempdir().expect("a folder");
    let mut files = Vec::new();
    let mut volumes = BTreeMap::new();
    // Meshes of somebody else's, where they are there.
    let shared = std::env::var_os("HOUSCAPER_SHARED").map(PathBuf::from);
    let meshes = shared.map(|s| s.join("reference/tilesets/topogenesis-chamfer")).filter(|root| root.is_dir());
    for tileset in TILESETS.into_iter().chain(meshes.as_ref().map(|_| "meshes")) {
        let evaluator = match (tileset, &meshes) {
            ("meshes", Some(root)) => {
                let mut evaluator = evaluator("architectural", folder.path());
                let manifest = runs::repository().join("tilesets/topogenesis");
                evaluator.tiling = Tiling::load_from(&manifest, Some(root), &evaluator.books).expect("a set");
                evaluator
            }
            _ => evaluator(tileset, folder.path()),
        };
        // All roofs, decks and stairs for one set; validation takes some seconds a file.
        let names: &[&str] = match tileset {
            "architectural" => &["villa", "stepped", "l_hip"],
            "larch" => &["l_hip"],
            _ => &["stepped"],
        };
        for &name in names {
            let (house, choices) = (sample(name), Choices::default());
            let details = evaluator.details(&house, &choices);
            let made = dossier(name, &house, &choices, &details, &evaluator, Extent::FrontIfc).expect("files").files;
            let own = folder.path().join(format!("{tileset}-{name}"));
            std::fs::create_dir(&own).expect("a folder");
            for (file, bytes) in made.iter().filter(|(file, _)| file.ends_with(".json") || file.ends_with(".ifc")) {
                std::fs::write(own.join(file), bytes).expect("a file");
            }
            files.push(own.join("house.ifc"));
            // What our own solids and sections hold.
            let drawn: f64 =
                evaluator.tiling.fabric(&house, &details.reading).map_or(0.0, |f| f.volumes_m3().iter().sum());
            volumes.insert(own.join("house.ifc").display().to_string(), drawn);
        }
    }
    for result in checked(&python, &files) {
        let file = result["file"].as_str().expect("a name");
        assert_eq!(result["faults"], serde_json::json!([]), "{file}");
        // Members come on top of the solids.
        assert!(result["volume_m3"].as_f64() > Some(volumes[file]), "{file}");
        // A style draws walls with openings; surfaces have none to void.
        let openings = result["counts"]["IfcOpeningElement"].as_u64().unwrap_or(0);
        assert_eq!(openings > 0, file.contains("architectural") || file.contains("larch"), "{file}");
        println!("{file}: {} in {} s", result["counts"], result["all_s"]);
    }
}

/// What is done to the text of a file.
type Spoil<'a> = &'a dyn Fn(&str) -> String;

/// The checker is no rubber stamp: what is broken in a file is found.
#[test]
fn the_check_finds_what_is_wrong() {
    let Some(python) = python() else { return };
    let folder = tempfile::tempdir().expect("a folder");
    let evaluator = evaluator("architectural", folder.path());
    let (house, choices) = (sample("box"), Choices::default());
    let details = evaluator.details(&house, &choices);
    let made = dossier("box", &house, &choices, &details, &evaluator, Extent::FrontIfc).expect("files").files;
    let get = |name: &str| made.iter().find(|(file, _)| file == name).map(|(_, bytes)| bytes.clone()).expect(name);
    let text = String::from_utf8(get("house.ifc")).expect("ASCII");
    let cases: [(&str, &str, Spoil); 5] = [
        ("a quantity", "quantities sum to", &|t| t.replacen("'floor_band','line", "'floor_band','line 9", 1)),
        ("a mark", "no product", &|t| t.replace("'E0-S01'", "'E0-S99'")),
        ("a class", "validate", &|t| t.replacen(".ELEMENTEDWALL.", ".BRICKWALL.", 1)),
        ("a template", "not in the template", &|t| t.replace("'LoadBearing'", "'CarriesLoads'")),
        ("a colour of nothing", "made of nothing", &|t| {
            t.lines().filter(|l| !l.contains("IFCRELASSOCIATESMATERIAL")).collect::<Vec<_>>().join("\n")
        }),
    ];
    for (what, expected, spoil) in cases {
        let own = folder.path().join(what.replace(' ', "-"));
        std::fs::create_dir(&own).expect("a folder");
        let spoilt = spoil(&text);
        assert_ne!(spoilt, text, "{what}");
        std::fs::write(own.join("house.ifc"), spoilt).expect("a file");
        for name in ["takeoff.json", "parts.json", "structure.json"] {
            std::fs::write(own.join(name), get(name)).expect("a file");
        }
        let results = checked(&python, &[own.join("house.ifc")]);
        let faults = results[0]["faults"].as_array().expect("a list");
        let found = faults.iter().any(|f| f.as_str().is_some_and(|f| f.contains(expected)));
        assert!(found, "{what}: {faults:?}");
    }
}
