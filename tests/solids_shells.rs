//! Shells: thicknesses come from the shipped build-ups, and a wrong stratum is one clear error.

#[path = "common/shells.rs"]
mod shells;

use std::path::{Path, PathBuf};

use houscaper::price::Books;
use houscaper::tiles::{Component, Stack, depth_um};

fn configs() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("configs")
}

fn mm(stack: &Stack) -> Vec<(Component, f64)> {
    stack.iter().map(|s| (s.component, f64::from(s.thickness_um) / 1000.0)).collect()
}

#[test]
fn strata_are_those_of_the_build_ups() {
    use Component::*;
    let shells = shells::shells();
    assert_eq!(mm(&shells.wall), [(Cladding, 47.3), (WallInsulation, 195.2), (WallLining, 57.5)]);
    assert_eq!(mm(&shells.roof_cover), [(RoofCovering, 76.0)]);
    assert_eq!(mm(&shells.roof), [(RoofInsulation, 237.5), (RoofLining, 12.5)]);
    assert_eq!(mm(&shells.flat), [(FlatMembrane, 1.5), (FlatInsulation, 200.5)]);
    assert_eq!(mm(&shells.deck), [(DeckBoards, 67.0), (FlatMembrane, 1.5), (FlatInsulation, 200.5)]);
    assert_eq!(mm(&shells.floor), [(FloorBoards, 22.0), (FloorStructure, 145.5), (Ceiling, 12.5)]);
    assert_eq!(mm(&shells.soffit), [(SoffitInsulation, 149.7), (SoffitBoards, 37.3)]);
    assert_eq!(mm(&shells.ground), [(GroundSlab, 150.0), (GroundInsulation, 120.0)]);
    assert_eq!(mm(&shells.plinth), [(PlinthRender, 8.0), (PlinthInsulation, 120.0)]);
    assert_eq!(shells.beam_um, [300_000, 500_000], "0.15 m3 of concrete a metre, 300 mm wide");
    assert_eq!(depth_um(&shells.wall), 300_000);
}

#[test]
fn stacks_are_whole_millimetres_close_to_the_build_ups() {
    let shells = shells::shells();
    let books = Books::load(&configs()).expect("shipped books");
    let sum =
        |id: &str| -> f64 { books.buildups.named(id).expect("a build-up").layers.iter().map(|l| l.thickness_mm).sum() };
    let concrete = 300.0;
    let cassette = f64::from(depth_um(&shells.floor)) / 1000.0;
    let stacks = [
        (&shells.wall, sum("wall")),
        (&shells.floor, sum("floor")),
        (&shells.flat, sum("roof_flat") - cassette),
        (&shells.deck, sum("deck") - cassette),
        (&shells.soffit, sum("soffit")),
        (&shells.ground, sum("ground_slab")),
        (&shells.plinth, sum("plinth") - concrete),
    ];
    for (stack, expected) in stacks {
        assert_eq!(depth_um(stack) % 1000, 0);
        assert!((f64::from(depth_um(stack)) / 1000.0 - expected).abs() <= 0.5, "{stack:?} of {expected}");
        assert!(stack.iter().all(|s| s.thickness_um % 5 == 0 && s.thickness_um > 0));
    }
    let roof = f64::from(depth_um(&shells.roof) + depth_um(&shells.roof_cover)) / 1000.0;
    assert!((roof - sum("roof_pitched")).abs() <= 1.0, "{roof}");
}

#[test]
fn flat_roof_and_deck_contain_the_floor_cassette() {
    let shells = shells::shells();
    let books = Books::load(&configs()).expect("shipped books");
    for id in ["roof_flat", "deck"] {
        let strata = books.buildups.named(id).expect("a build-up").strata().expect("strata");
        let cassette = ["ceiling", "floor_structure", "floor_boards"];
        let lower: f64 = strata.iter().filter(|s| cassette.contains(&s.name)).map(|s| s.thickness_mm).sum();
        assert!((lower - f64::from(depth_um(&shells.floor)) / 1000.0).abs() < 1e-9, "{id}: {lower}");
    }
}

/// The message that the shipped build-ups give after a change of their text.
fn refused(from: &str, to: &str) -> String {
    let folder = tempfile::tempdir().expect("a folder");
    for name in ["prices.json", "carbon.json", "buildups.json"] {
        let mut text = std::fs::read_to_string(configs().join(name)).expect("a shipped book");
        if name == "buildups.json" {
            assert!(text.contains(from), "{from}");
            text = text.replacen(from, to, 1);
        }
        std::fs::write(folder.path().join(name), text).expect("written");
    }
    let books = Books::load(folder.path()).expect("still a book");
    houscaper::score::shells(&books).map_or_else(|e| e.to_string(), |_| String::new())
}

#[test]
fn wrong_strata_are_refused_by_name() {
    assert_eq!(refused("Plasterboard", "Plasterboard"), "", "the shipped file itself is accepted");
    let message = refused("\"stratum\": \"wall_lining\"", "\"stratum\": \"wall_linning\"");
    for word in ["buildups.json", "\"wall\"", "Plasterboard", "wall_linning", "cladding, wall_insulation, wall_lining"]
    {
        assert!(message.contains(word), "{word} in: {message}");
    }
    let message = refused("\"stratum\": \"cladding\"", "\"stratum\": \"ceiling\"");
    assert!(message.contains("ceiling") && message.contains("Breather"), "a component of another place: {message}");
    let message = refused(", \"stratum\": \"floor_boards\"", "");
    assert!(message.contains("OSB/3 22 mm") && message.contains("no \"stratum\""), "{message}");
    let message = refused(
        "\"label\": \"Stud zone, filled\", \"thickness_mm\": 180",
        "\"label\": \"Stud zone, filled\", \"thickness_mm\": 280",
    );
    assert!(message.contains("400") && message.contains("at most 350"), "{message}");
}
