//! Briefs that cannot be meant are refused by key, by every command that reads one.

#[path = "common/cli.rs"]
mod cli;

use cli::{Scratch, contents, has, ok, refused};
use houscaper::voxels::samples;
use serde_json::{Value, json};

fn refuses(change: impl Fn(&mut Value), parts: &[&str]) {
    let folder = Scratch::new();
    let house = folder.house("box.json", &samples::box_house());
    let brief = folder.brief("brief.json", change);
    let before = contents(folder.path());
    for args in [
        ["check", &house, "--brief", &brief].as_slice(),
        &["evaluate", &house, "--brief", &brief],
        &["evaluate", "--batch", "--brief", &brief],
    ] {
        has(&refused(args), parts);
    }
    assert_eq!(contents(folder.path()), before);
}

#[test]
fn the_brief_without_a_mistake_is_read() {
    let folder = Scratch::new();
    let house = folder.house("box.json", &samples::box_house());
    ok(&["evaluate", &house, "--brief", &folder.brief("brief.json", |_| ())]);
    for name in ["starter", "two-storey", "go-design"] {
        ok(&["check", "--rules", "--brief", &format!("configs/{name}.json")]);
    }
}

#[test]
fn unknown_keys_and_units_are_named_with_their_line() {
    refuses(|b| b["budget"] = json!(1), &["brief.json:", "unknown field `budget`"]);
    refuses(|b| b["plot"]["modules_mm"] = json!(900), &["brief.json:", "plot", "unknown field `modules_mm`"]);
    refuses(|b| b["site"]["vb0_km_h"] = json!(97), &["brief.json:", "site", "unknown field `vb0_km_h`"]);
    refuses(|b| b["wall_boards"] = json!([]), &["brief.json", "wall_boards", "one_side", "both_sides"]);
    refuses(|b| b["wall_boards"] = json!(["one_side", "one_side"]), &["brief.json", "wall_boards", "each entry once"]);
    refuses(|b| b["wall_boards"] = json!(["inside"]), &["brief.json:", "wall_boards", "both_sides"]);
    refuses(|b| b["search"]["sizing"] = json!(1.5), &["brief.json", "search.sizing", "0 to 1"]);
    refuses(|b| b["objectives"] = json!(["price_usd"]), &["brief.json:", "objectives", "price_eur"]);
    refuses(|b| b["schema"] = json!("houscaper.brief/2"), &["brief.json: `schema`", "houscaper.brief/1"]);
    refuses(|b| b["plot"]["module_m"] = json!([900, 900, 540]), &["`plot.module_m`", "in metres"]);
    refuses(|b| b["constraints"]["price_usd_max"] = json!(1), &["`constraints.price_usd_max`", "budget_eur"]);
}

#[test]
fn a_plot_too_small_for_the_programme_is_named() {
    refuses(|b| b["plot"]["modules"] = json!([5, 4, 7]), &["brief.json: `programme.floor_area_m2`", "at most 16.2 m2"]);
    refuses(|b| b["programme"]["storeys"] = json!([3, 3]), &["brief.json: `programme.storeys`", "at most 2 storeys"]);
    refuses(|b| b["plot"]["modules"] = json!([10, 8]), &["brief.json:", "plot.modules"]);
}

#[test]
fn constraints_that_no_house_can_keep_are_named() {
    refuses(
        |b| b["constraints"] = json!({"mass_kg_max": 100, "mass_kg_min": 200}),
        &["brief.json: `constraints`", "together no house"],
    );
    refuses(|b| b["constraints"]["budget_eur"] = json!(-1), &["brief.json: `constraints`", "budget_eur = -1"]);
    refuses(
        |b| b["constraints"]["floor_area_m2_max"] = json!(10),
        &["floor_area_m2_max = 10", "at least the programme's 40"],
    );
    refuses(|b| b["programme"]["floor_area_m2"] = json!([90, 40]), &["brief.json: `programme.floor_area_m2`"]);
}

#[test]
fn files_and_names_the_brief_does_not_find_are_named() {
    refuses(|b| b["prices"] = json!("none.json"), &["none.json"]);
    refuses(|b| b["tileset"] = json!("surface-9"), &["surface-9", "tileset.json"]);
    refuses(|b| b["materials"] = json!(["C24", "OAK"]), &["OAK", "C24"]);
    refuses(|b| b["sections"] = json!(["T_1x1"]), &["T_1x1", "sections"]);
    refuses(|b| b["given"] = json!({"lattice": "none.csv", "occupied": ">= 0"}), &["cannot read", "none.csv"]);
    refuses(
        |b| {
            b["given"] =
                json!({"lattice": concat!(env!("CARGO_MANIFEST_DIR"), "/configs/zoning.csv"), "occupied": "much"})
        },
        &["given.occupied", "`much` is no occupancy rule"],
    );
    let shipped = concat!(env!("CARGO_MANIFEST_DIR"), "/configs/zoning.csv");
    let given = |crop: Value| json!({"lattice": shipped, "occupied": ">= 0", "cell_modules": [2, 2, 6], "crop": crop});
    refuses(|b| b["given"] = given(json!([[0, 0, 0], [5, 4, 1]])), &["`given`", "beyond plot.modules"]);
    let folder = Scratch::new();
    let fitting = folder.brief("brief.json", |b| b["given"] = given(json!([[0, 0, 0], [2, 2, 1]])));
    ok(&["check", "--rules", "--brief", &fitting]);
}
