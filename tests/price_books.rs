//! Books: what is refused, what is not, and what one changed rate changes.

use std::fs;
use std::path::{Path, PathBuf};

use houscaper::envelope::EnvelopeAreas;
use houscaper::price::{Books, PriceError, bill, cost};
use houscaper::quantities::{Item, Takeoff};
use serde_json::{Value, json};

fn configs() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("configs")
}

/// A copy of the books with one file edited, compiled.
fn with(file: &str, edit: impl FnOnce(&mut Value)) -> (tempfile::TempDir, Result<Books, PriceError>) {
    let folder = tempfile::tempdir().expect("a temporary folder");
    for name in ["prices.json", "carbon.json", "buildups.json"] {
        fs::copy(configs().join(name), folder.path().join(name)).expect("a copy of a book");
    }
    let path = folder.path().join(file);
    let mut book: Value = serde_json::from_str(&fs::read_to_string(&path).expect("a book")).expect("JSON");
    edit(&mut book);
    fs::write(&path, book.to_string()).expect("an edited book");
    let books = compile(folder.path());
    (folder, books)
}

fn compile(folder: &Path) -> Result<Books, PriceError> {
    let books = Books::load(folder)?;
    books.rates()?;
    Ok(books)
}

fn item<'a>(book: &'a mut Value, list: &str, id: &str) -> &'a mut Value {
    book[list].as_array_mut().expect("a list").iter_mut().find(|i| i["id"] == id).expect("the item")
}

fn remove(book: &mut Value, list: &str, id: &str) {
    book[list].as_array_mut().expect("a list").retain(|i| i["id"] != id);
}

fn refused(file: &str, words: &[&str], edit: impl FnOnce(&mut Value)) {
    let (_, untouched) = with(file, |_| ());
    assert!(untouched.is_ok(), "positive twin: {:?}", untouched.err());
    let (_, books) = with(file, edit);
    let message = books.map(|_| ()).expect_err(&format!("{words:?} must be refused")).to_string();
    for word in words.iter().chain([&file]) {
        assert!(message.contains(word), "\"{message}\" does not name {word}");
    }
}

#[test]
fn a_missing_price_is_an_error_and_never_zero() {
    let (_, books) = with("prices.json", |book| remove(book, "items", "osb_15"));
    let message = books.map(|_| ()).expect_err("no price").to_string();
    assert!(["prices.json", "osb_15", "buildup"].iter().all(|w| message.contains(w)), "{message}");
    refused("prices.json", &["glulam_gl24h", "frame.GL24h"], |book| remove(book, "items", "glulam_gl24h"));
    refused("prices.json", &["contingency"], |book| remove(book, "rates", "contingency"));
    refused("carbon.json", &["mineral_wool"], |book| remove(book, "items", "mineral_wool"));
    refused("buildups.json", &["price", "osb"], |book| {
        let wall = item(book, "buildups", "wall");
        wall["layers"][4]["parts"][0]["price"] = json!([]);
    });
    refused("buildups.json", &["uses.stair"], |book| {
        book["uses"].as_object_mut().expect("uses").remove("stair");
    });
}

#[test]
fn unknown_keys_and_units_are_errors() {
    refused("prices.json", &["colour"], |book| item(book, "items", "osb_15")["colour"] = json!("red"));
    refused("prices.json", &["furlong"], |book| item(book, "items", "osb_15")["unit"] = json!("furlong"));
    refused("carbon.json", &["colour"], |book| book["colour"] = json!("red"));
    refused("buildups.json", &["colour"], |book| item(book, "buildups", "wall")["colour"] = json!("red"));
    refused("buildups.json", &["chimney"], |book| book["uses"]["chimney"] = json!("wall"));
}

#[test]
fn a_quantity_in_another_unit_than_its_rate_is_an_error() {
    refused("buildups.json", &["osb_15", "m2", "m3", "wall"], |book| {
        item(book, "buildups", "wall")["layers"][4]["parts"][0]["price"][0]["unit"] = json!("m3");
    });
    refused("buildups.json", &["frame.C24", "m3", "kg"], |book| {
        let rows = book["frame"].as_array_mut().expect("frame");
        rows.iter_mut().find(|f| f["material"] == "C24").expect("C24")["price"] = json!("steel_shs_s355");
    });
}

#[test]
fn a_value_without_source_or_out_of_order_is_an_error() {
    refused("prices.json", &["source"], |book| {
        item(book, "items", "osb_15").as_object_mut().expect("item").remove("source");
    });
    refused("prices.json", &["osb_15.source"], |book| item(book, "items", "osb_15")["source"] = json!(" "));
    refused("prices.json", &["osb_15", "low"], |book| item(book, "items", "osb_15")["low"] = json!(99));
    refused("prices.json", &["osb_15.labour_h", "-1"], |book| item(book, "items", "osb_15")["labour_h"] = json!(-1));
    refused("prices.json", &["osb_15.low", "labour", "at least its own labour"], |book| {
        item(book, "items", "osb_15")["labour_h"] = json!(0.4);
    });
    refused("prices.json", &["works.payload_kg", "above 0"], |book| book["works"]["payload_kg"] = json!(0));
    refused("prices.json", &["works.learning_high", "at most 1"], |book| book["works"]["learning_high"] = json!(1.1));
    refused("prices.json", &["date", "soon", "2026-11-22"], |book| book["date"] = json!("soon"));
    refused("prices.json", &["labour_basis_eur_h", "missing"], |book| {
        book.as_object_mut().expect("a book").remove("labour_basis_eur_h");
    });
    refused("prices.json", &["crane_day", "works"], |book| remove(book, "items", "crane_day"));
    refused("prices.json", &["osb_15", "-1"], |book| item(book, "items", "osb_15")["low"] = json!(-1));
    refused("prices.json", &["osb_15", "twice"], |book| item(book, "items", "concrete")["id"] = json!("osb_15"));
    refused("carbon.json", &["osb.biogenic"], |book| item(book, "items", "osb")["biogenic"] = json!(1.5));
    refused("buildups.json", &["sum to 1"], |book| {
        item(book, "buildups", "wall")["layers"][1]["parts"][0]["fraction"] = json!(0.9);
    });
}

#[test]
fn a_book_on_another_basis_is_an_error() {
    refused("prices.json", &["overhead", "gross", "net"], |book| book["overhead"] = json!("gross"));
    refused("prices.json", &["vat", "included"], |book| book["vat"] = json!("included"));
    refused("carbon.json", &["stage", "A1-C4"], |book| book["stage"] = json!("A1-C4"));
}

/// A Lazio price is published with 26.5 % overhead and profit: the source names the gross price, the book holds it over 1.265.
#[test]
fn every_lazio_rate_is_a_published_price_over_1_265() {
    let books = compile(&configs()).expect("the books");
    let mut checked = 0;
    for item in books.prices.items().iter().filter(|item| item.source.starts_with("LAZIO")) {
        let gross = item.in_place()[1] * 1.265;
        let printed: Vec<f64> = item.source.split([' ', '-', ',', ';']).filter_map(|word| word.parse().ok()).collect();
        let direct = printed.iter().any(|value| (value - gross).abs() < 0.005);
        // A door is published per m2 (x 2.04 m2), GL28h is the middle of a range: those two are marked in their sources.
        let derived = item.source.contains("ASSUMED") || item.source.contains("x 2.04 m2");
        assert!(direct || derived, "{}: {gross} is not in \"{}\"", item.id, item.source);
        assert!(item.range()[0] <= item.range()[1] && item.range()[1] <= item.range()[2]);
        checked += 1;
    }
    assert!(checked > 15, "{checked} rates checked");
}

#[test]
fn one_changed_rate_changes_only_its_lines() -> Result<(), Box<dyn std::error::Error>> {
    let area_m2 = [30.0, 2.0, 3.0, 0.0, 1.9, 20.0, 0.0, 4.0, 2.0, 12.0];
    let areas = EnvelopeAreas { area_m2, ..Default::default() };
    let mut takeoff = Takeoff::new(&areas, 4.0)?;
    takeoff.add_window(1.8, 1.62)?;
    takeoff.add_stairs(1);
    takeoff.add_railing(3.0)?;
    let name = |_: u16| String::new();
    let before = bill(&takeoff, &compile(&configs())?, &name)?;
    let (_, dearer) = with("prices.json", |book| {
        let steel = item(book, "items", "stair_steel");
        steel["default"] = json!(8.5336);
    });
    let after = bill(&takeoff, &dearer?, &name)?;
    for (old, new) in before.iter().zip(&after) {
        // One EUR/kg more on a stair of 390 kg and on 3 m of railing of 18 kg/m, a hundredth of what stays wasted.
        let expected = match old.item.as_str() {
            "stair" => 390.0 / 1.01,
            "railing" => 54.0 / 1.01,
            "waste" if old.quantity == 0.01 => 0.01 * 444.0 / 1.01,
            _ => 0.0,
        };
        assert!((new.amount - old.amount - expected).abs() < 1e-9, "{}", old.item);
        assert_eq!([new.mass_kg, new.gwp_kgco2e, new.amount_low], [old.mass_kg, old.gwp_kgco2e, old.amount_low]);
    }
    Ok(())
}

#[test]
fn unknown_energy_is_said_and_never_zero() -> Result<(), Box<dyn std::error::Error>> {
    let mut takeoff = Takeoff::new(&EnvelopeAreas::default(), 0.0)?;
    takeoff.add_doors(1);
    takeoff.add_stairs(1);
    let known = cost(&takeoff, &compile(&configs())?.rates()?);
    assert!(known.energy_mj.is_some() && known.unknown_energy_items().next().is_none());
    let (_, books) = with("carbon.json", |book| item(book, "items", "door_ext_wood")["energy_mj"] = Value::Null);
    let books = books?;
    let unknown = cost(&takeoff, &books.rates()?);
    assert_eq!(unknown.energy_mj, None);
    assert_eq!(unknown.unknown_energy_items().collect::<Vec<_>>(), [Item::Door]);
    assert!(unknown.energy_known_mj > 0.0 && unknown.energy_known_mj < known.energy_known_mj);
    assert!(bill(&takeoff, &books, &|_| String::new())?.iter().any(|line| line.energy_mj.is_none()));
    Ok(())
}
