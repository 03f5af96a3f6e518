//! `layers.csv`: a file for each house, its columns, its sums against the bill, and what is refused.

#[path = "common/runs.rs"]
mod runs;

use std::path::Path;

use houscaper::export::dossier::{Extent, dossier};
use houscaper::export::tables::LAYERS_COLUMNS;
use houscaper::price::Books;
use houscaper::score::{Evaluator, layers};
use houscaper::tiles::Component;
use houscaper::voxels::{Choices, samples};
use runs::Table;

fn evaluator() -> Evaluator {
    runs::evaluator(&runs::repository().join("configs/starter.json"))
}

/// A file of a house as a table.
fn table(files: &[(String, Vec<u8>)], name: &str, folder: &Path) -> Table {
    let (_, bytes) = files.iter().find(|(file, _)| file == name).unwrap_or_else(|| panic!("no {name}"));
    std::fs::write(folder.join(name), bytes).expect("a temporary file");
    Table::read(&folder.join(name))
}

#[test]
fn each_house_has_its_layers_and_they_sum_to_its_bill() {
    let (evaluator, folder) = (evaluator(), tempfile::tempdir().expect("a temporary folder"));
    for (name, house) in samples::all() {
        let choices = Choices::default();
        let details = evaluator.details(&house, &choices);
        let files = dossier(name, &house, &choices, &details, &evaluator, Extent::Front).expect("files").files;
        let layers = table(&files, "layers.csv", folder.path());
        assert_eq!(layers.header, LAYERS_COLUMNS);
        // The bill without the frame's members.
        let bill = table(&files, "bom.csv", folder.path());
        let priced: f64 = (0..bill.rows.len())
            .map(|n| bill.row(n))
            .filter(|row| row["group"] != "frame")
            .map(|row| row["mass_kg"].parse::<f64>().expect("a mass"))
            .sum();
        let sum: f64 = layers.numbers("takeoff_kg").iter().sum();
        assert!((sum - priced).abs() <= 1e-6 * priced, "{name}: layers {sum} kg, bill {priced} kg");
        // The nodes of the GLB tell the same volumes.
        let (_, glb) = files.iter().find(|(file, _)| file == "house.glb").expect("house.glb");
        let gltf = gltf::Gltf::from_slice(glb).expect("a GLB");
        let mut found = 0;
        for node in gltf.nodes() {
            let Some(extras) = node.extras() else { continue };
            let extras: serde_json::Value = serde_json::from_str(extras.get()).expect("JSON");
            let (Some(component), Some(m3)) = (extras["component"].as_str(), extras["volume_m3"].as_f64()) else {
                continue;
            };
            let row = (0..layers.rows.len()).map(|n| layers.row(n)).find(|row| row["component"] == component);
            let told: f64 = row.expect("a row for each node")["volume_m3"].parse().expect("a volume");
            assert!((told - m3).abs() <= 1e-9 * m3, "{name} {component}: {told} and {m3}");
            found += 1;
        }
        assert_eq!(found, layers.numbers("volume_m3").iter().filter(|v| **v > 0.0).count(), "{name}");
        for n in 0..layers.rows.len() {
            let row = layers.row(n);
            assert!(Component::ALL.iter().any(|c| c.name() == row["component"]), "{name}");
            assert!(!row["weighed"].is_empty(), "{name}: {row:?}");
            assert!(row["weighed"] != "by volume" || row["source"].starts_with("build-ups "), "{name}: {row:?}");
        }
    }
}

/// A set of surfaces draws no solids and has no layers.
#[test]
fn surfaces_alone_have_no_layers() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let brief = runs::changed_brief("starter.json", folder.path(), |b| b["tileset"] = "surface-2".into());
    let (evaluator, house, choices) = (runs::evaluator(&brief), samples::box_house(), Choices::default());
    let details = evaluator.details(&house, &choices);
    assert!(details.volumes.is_none() && evaluator.layers(&house, &details).is_none());
    let files = dossier("box", &house, &choices, &details, &evaluator, Extent::Front).expect("files").files;
    assert!(files.iter().all(|(name, _)| name != "layers.csv") && files.iter().any(|(name, _)| name == "bom.csv"));
}

/// A stratum that is no component is refused by name; the same books with the right name are not.
#[test]
fn a_stratum_that_is_no_component_is_refused() {
    let evaluator = evaluator();
    let details = evaluator.details(&samples::box_house(), &Choices::default());
    let (volumes, takeoff) = (details.volumes.expect("drawn"), details.evaluation.takeoff.expect("taken off"));
    let folder = tempfile::tempdir().expect("a temporary folder");
    let configs = runs::repository().join("configs");
    for name in ["prices.json", "carbon.json", "buildups.json"] {
        std::fs::copy(configs.join(name), folder.path().join(name)).expect("a copy of a book");
    }
    let rows = |books: &Books| layers(&volumes, 1.0, &takeoff, books, &evaluator.tiling.shells);
    assert!(rows(&Books::load(folder.path()).expect("shipped books")).is_ok(), "positive twin");
    let path = folder.path().join("buildups.json");
    let text = std::fs::read_to_string(&path)
        .expect("build-ups")
        .replace("\"stratum\": \"coping\"", "\"stratum\": \"chimney\"");
    std::fs::write(&path, text).expect("an edited book");
    let message = rows(&Books::load(folder.path()).expect("readable")).expect_err("no component").to_string();
    assert!(["buildups.json", "coping", "chimney"].iter().all(|word| message.contains(word)), "{message}");
}
