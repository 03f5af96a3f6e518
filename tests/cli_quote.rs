//! Quotes: the same as those of `build`, recomputed by a script that knows nothing of the program, and changed by a user's own prices
//! in the lines concerned alone.

#[path = "common/cli.rs"]
mod cli;

use std::path::Path;
use std::process::Command;

use cli::{Scratch, has, ok, refused};
use serde_json::{Value, json};

fn read(path: &Path) -> Value {
    serde_json::from_slice(&std::fs::read(path).expect("a file")).expect("JSON")
}

/// Runs the script on a folder; `None` without Python.
fn requote(folder: &str) -> Option<(bool, String)> {
    let script = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/tools/requote.py");
    let Ok(output) = Command::new("python3").arg(script).arg(folder).output() else {
        println!("skipped: python3 does not start");
        return None;
    };
    let said = String::from_utf8_lossy(&output.stdout).into_owned() + &String::from_utf8_lossy(&output.stderr);
    Some((output.status.success(), said))
}

/// A user's book over the shipped one.
fn own_book(folder: &Scratch, change: impl FnOnce(&mut Value)) -> String {
    let mut book = json!({
        "schema": "houscaper.prices/1", "version": "mine 3", "date": "2026-11-01", "currency": "EUR", "vat": "excluded",
        "overhead": "net", "extends": "prices.json",
        "items": [{"id": "clay_tiles", "description": "Clay tiles laid, our roofer", "unit": "m2", "low": 90, "default": 95, "high": 100, "labour_h": 0.7612, "work": "site",
            "kind": "market", "year": 2026, "region": "here", "source": "offer of our roofer"}],
    });
    change(&mut book);
    let path = folder.path().join("prices.json");
    std::fs::write(&path, book.to_string()).expect("a file");
    path.display().to_string()
}

#[test]
fn a_quote_is_that_of_the_house_built() {
    let folder = Scratch::new();
    let (built, quoted) = (folder.at("built"), folder.at("quoted"));
    ok(&["build", "sample:box", "--out", &built]);
    let book = read(Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/configs/prices.json")));
    let date = book["date"].as_str().expect("a date");
    let said = ok(&["quote", "sample:box", "--date", date, "--out", &quoted]).out;
    has(
        &said,
        &["quote HC-", "valid until", "envelope and frame in place, net of VAT", "with design and VAT", "quote.html"],
    );
    for file in ["quote.json", "quote.html", "bom.csv"] {
        let bytes = |at: &str| std::fs::read(Path::new(at).join(file)).expect("a file");
        assert_eq!(bytes(&built), bytes(&quoted), "{file}");
    }
    let printed = ok(&["quote", "sample:box", "--date", date, "--json", "--out", &folder.at("again")]).out;
    assert_eq!(serde_json::from_str::<Value>(&printed).expect("JSON"), read(&Path::new(&quoted).join("quote.json")));
    // Without a date it is issued today, with the same number.
    let today = ok(&["quote", "sample:box", "--json", "--out", &folder.at("today")]).out;
    let today: Value = serde_json::from_str(&today).expect("JSON");
    assert_eq!(today["reference"], read(&Path::new(&quoted).join("quote.json"))["reference"]);
    assert!(today["issued"].as_str().expect("a date") >= date, "the book is not of tomorrow");
    has(&refused(&["quote", "sample:box", "--date", "2027-02-29", "--out", &folder.at("x")]), &["2027-02-29"]);
    has(
        &refused(&["quote", "sample:box", "--date", "tomorrow", "--out", &folder.at("x")]),
        &["--date tomorrow", "2027-01-31"],
    );
}

#[test]
fn a_script_that_knows_only_the_books_finds_the_same() {
    let folder = Scratch::new();
    for name in ["villa", "hip", "terrace"] {
        ok(&["quote", &format!("sample:{name}"), "--out", &folder.at(name)]);
    }
    let Some((fine, said)) = requote(&folder.path().display().to_string()) else { return };
    assert!(fine && said.contains("3 bills, 0 differences"), "{said}");
    // It would see a cent.
    let path = folder.path().join("hip/quote.json");
    let mut quote = read(&path);
    let amount = quote["lines"][2]["amount"].as_f64().expect("an amount");
    quote["lines"][2]["amount"] = json!(amount + 0.02);
    std::fs::write(&path, quote.to_string()).expect("a file");
    let (fine, said) = requote(&folder.path().display().to_string()).expect("it started before");
    assert!(!fine && said.contains("line 3 amount"), "{said}");
}

/// One rate changes its own lines, and everything else to the byte of the bill stays.
#[test]
fn own_prices_change_their_lines_alone() {
    let folder = Scratch::new();
    let (shipped, own) = (folder.at("shipped"), folder.at("own"));
    let book = own_book(&folder, |_| ());
    // The choices are given: sizing looks at prices of sections only, but so it need not be believed.
    ok(&["quote", "sample:hip", "--choices", "{}", "--out", &shipped]);
    ok(&["quote", "sample:hip", "--choices", "{}", "--prices", &book, "--out", &own]);
    let [a, b] = [&shipped, &own].map(|at| read(&Path::new(at).join("quote.json")));
    let lines = |q: &Value| q["lines"].as_array().expect("lines").clone();
    let mut changed = 0.0;
    for (a, b) in lines(&a).iter().zip(&lines(&b)) {
        let tiles = a["source"].as_str().expect("a source").contains("clay_tiles");
        let [old, new] = [a, b].map(|l| l["amount"].as_f64().expect("an amount"));
        assert_eq!(old != new, tiles, "{a}");
        if tiles {
            let quantity = a["quantity"].as_f64().expect("a quantity");
            assert!((new - old - quantity * (95.0 - 50.8458)).abs() < 0.011, "{a} {b}");
            changed += new - old;
        }
        for key in ["quantity", "mass_kg", "gwp_kgco2e", "description"] {
            assert_eq!(a[key], b[key]);
        }
    }
    assert!(changed > 100.0);
    let subtotal = |q: &Value| q["subtotal"][1].as_f64().expect("a sum");
    assert!((subtotal(&b) - subtotal(&a) - changed).abs() < 1e-6);
    has(&b["books"]["prices"].to_string(), &["mine 3 over 2026.2", "2026-11-01"]);
    has(&b["sources"].to_string(), &["offer of our roofer"]);
}

/// A dearer hour changes the lines of labour, what practice saves of it, and the crew at the crane; hours stay.
#[test]
fn a_dearer_hour_changes_labour_alone() {
    let folder = Scratch::new();
    let (shipped, own) = (folder.at("shipped"), folder.at("own"));
    let book = own_book(&folder, |b| {
        b["items"] = json!([{"id": "labour_hour", "description": "Hour, NL", "unit": "h", "low": 45, "default": 50, "high": 55,
            "kind": "market", "year": 2026, "region": "NL", "source": "our payroll"}]);
    });
    ok(&["quote", "sample:hip", "--choices", "{}", "--out", &shipped]);
    ok(&["quote", "sample:hip", "--choices", "{}", "--prices", &book, "--out", &own]);
    let [a, b] = [&shipped, &own].map(|at| read(&Path::new(at).join("quote.json")));
    let lines = |q: &Value| q["lines"].as_array().expect("lines").clone();
    let mut changed = Vec::new();
    for (a, b) in lines(&a).iter().zip(&lines(&b)) {
        assert_eq!(a["quantity"], b["quantity"]);
        let [old, new] = [a, b].map(|l| l["amount"].as_f64().expect("an amount"));
        if old != new {
            assert!((new / old - 50.0 / 33.4).abs() < 1e-4, "{a} {b}");
            changed.push(a["item"].as_str().expect("an item").to_owned());
        }
    }
    assert_eq!(changed, ["factory_labour", "learning_labour", "site_labour", "assembly"]);
}

#[test]
fn a_book_that_cannot_be_used_is_named() {
    let folder = Scratch::new();
    let refuses = |change: &dyn Fn(&mut Value), parts: &[&str]| {
        let book = own_book(&folder, change);
        has(&refused(&["quote", "sample:box", "--prices", &book, "--out", &folder.at("x")]), parts);
        assert!(!folder.path().join("x").exists());
    };
    refuses(&|b| b["items"][0]["unit"] = json!("kg"), &["prices.json", "clay_tiles", "kg", "m2"]);
    refuses(&|b| b["items"][0]["low"] = json!(96), &["prices.json: clay_tiles", "low <= default"]);
    refuses(&|b| b["items"][0]["source"] = json!(""), &["clay_tiles.source", "names the source"]);
    refuses(&|b| b["currency"] = json!("CHF"), &["prices.json", "currency", "CHF", "EUR"]);
    refuses(&|b| b["extends"] = json!("nowhere.json"), &["nowhere.json", "check the path"]);
    refuses(&|b| b["discount"] = json!(0.1), &["prices.json", "discount"]);
    refuses(&|b| drop(b.as_object_mut().expect("an object").remove("extends")), &["window_min_m2", "missing"]);
    // Two books that extend each other.
    std::fs::write(folder.path().join("other.json"), std::fs::read(own_book(&folder, |_| ())).expect("a book"))
        .expect("a file");
    refuses(&|b| b["extends"] = json!("other.json"), &["extends", "a chain of books that ends"]);
    has(&refused(&["quote", "sample:box", "--prices", "nowhere.json", "--out", &folder.at("x")]), &["nowhere.json"]);
}
