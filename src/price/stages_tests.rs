//! Stages by hand, parts and whole, what is unknown, and what one changed factor changes.

use std::path::{Path, PathBuf};

use serde_json::{Value, json};

use super::*;
use crate::envelope::{EnvelopeAreas, Surface};
use crate::price::{CarbonAccount, CarbonBook, CarbonFigures, cost};
use crate::quantities::{FrameGroup, FrameQuantity};

fn configs() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("configs")
}

fn edited(edit: impl FnOnce(&mut Value)) -> Result<Books, PriceError> {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let text = std::fs::read_to_string(configs().join("carbon.json")).expect("the list");
    let mut list: Value = serde_json::from_str(&text).expect("JSON");
    edit(&mut list);
    let path = folder.path().join("carbon.json");
    std::fs::write(&path, list.to_string()).expect("a list");
    Ok(Books { carbon: CarbonBook::load(&path)?, ..Books::load(&configs())? })
}

fn item<'a>(list: &'a mut Value, id: &str) -> &'a mut Value {
    list["items"].as_array_mut().expect("items").iter_mut().find(|i| i["id"] == id).expect("the item")
}

/// A square metre of wall, and a house with a bit of everything.
fn wall() -> Takeoff {
    let mut areas = EnvelopeAreas::default();
    areas.area_m2[Surface::Wall as usize] = 1.0;
    Takeoff::new(&areas, 0.0).expect("a take-off")
}

fn house() -> Takeoff {
    let mut areas = EnvelopeAreas::default();
    for (n, surface) in Surface::ALL.into_iter().enumerate() {
        areas.area_m2[surface as usize] = 7.0 + n as f64;
    }
    areas.area_m2[Surface::Window as usize] = 2.9160;
    let mut takeoff = Takeoff::new(&areas, 3.0).expect("a take-off");
    takeoff.add_window(1.8, 1.62).expect("a window");
    takeoff.add_doors(1);
    takeoff.add_stairs(1);
    [20.0, 22.0].into_iter().for_each(|m2| takeoff.add_floor(m2).expect("a floor"));
    takeoff.add_railing(4.0).expect("a railing");
    takeoff.add_perimeter(20.0).expect("a perimeter");
    let row = |material, kg| FrameQuantity {
        group: FrameGroup::Wall,
        material,
        section: 0,
        length_m: 1.0,
        volume_m3: 0.5,
        mass_kg: kg,
    };
    takeoff.add_frame(&[row(FrameMaterial::C24, 900.0), row(FrameMaterial::S355, 400.0)]).expect("a frame");
    takeoff
}

fn near(found: f64, expected: f64) {
    assert!((found - expected).abs() <= 1e-9 * expected.abs().max(1.0), "{found} is not {expected}");
}

/// A square metre of wall, kg of each layer, and the default factors of `configs/carbon.json`:
///
/// | layer | kg | A4 | A5 | C3-C4 | D |
/// |---|---|---|---|---|---|
/// | plasterboard 12.5 mm x 850 | 10.625 | 0.0232 | 0.0368 | 0.0150055 | unknown |
/// | mineral wool 45 mm x 0.925 x 30 | 1.24875 | 0.0345 | 0.0803 | 0.0426623 | unknown |
/// | battens 45 mm x 0.075 x 470 | 1.58625 | 0.0158 | 0.0096 | 0.0537 | -0.685639 |
/// | PE film 0.2 mm x 920 | 0.184 | unknown | unknown | 2.77975 | -1.37231 |
/// | mineral wool 180 mm x 0.9 x 30 | 4.86 | 0.0345 | 0.0803 | 0.0426623 | unknown |
/// | studs | of the frame | | | | |
/// | OSB 15 mm x 605 | 9.075 | 0.0645 | 0.0512 | unknown | -0.523199 |
/// | breather membrane 0.3 mm x 500 | 0.15 | unknown | unknown | 2.22414 | -1.09785 |
/// | battens 25 mm x 0.08 x 470 | 0.94 | 0.0158 | 0.0096 | 0.0537 | -0.685639 |
/// | cladding 22 mm x 470 | 10.34 | unknown | unknown | 0.0537 | -0.685639 |
#[test]
fn a_square_metre_of_wall_by_hand() {
    let books = Books::load(&configs()).expect("the books");
    let sums = StageTable::new(&books).expect("a table").of(&wall());
    let wool = 1.24875 + 4.86;
    let battens = 1.58625 + 0.94;
    near(sums.stage(Stage::A4).known[1], 10.625 * 0.0232 + wool * 0.0345 + battens * 0.0158 + 9.075 * 0.0645);
    near(sums.stage(Stage::A5).known[1], 10.625 * 0.0368 + wool * 0.0803 + battens * 0.0096 + 9.075 * 0.0512);
    let films = 0.184 * 2.77975 + 0.15 * 2.22414;
    let wood = (battens + 10.34) * 0.0537;
    near(sums.stage(Stage::C3C4).known[1], 10.625 * 0.0150055 + wool * 0.0426623 + films + wood);
    let credits = 0.184 * 1.37231 + 0.15 * 1.09785 + 9.075 * 0.523199 + (battens + 10.34) * 0.685639;
    near(sums.stage(Stage::D).known[1], -credits);
    // Low: RICS for wool, 0 for wood; high: 0.07195 for plasterboard, 0.127193 for wood.
    let low = 10.625 * 0.0150055 + wool * 0.00122 + films;
    near(sums.stage(Stage::C3C4).known[0], low);
    let stored = -(battens + 10.34) * 1.55 - 9.075 * 1.5;
    near(sums.storage, stored);
    near(sums.release, -stored);
    for stage in Stage::ALL {
        assert_eq!(sums.stage(stage).unknown_items().collect::<Vec<_>>(), [Item::Wall], "{stage:?}");
    }
    let account = CarbonAccount::new(&wall(), &books, &|_| String::new(), 0.0).expect("an account");
    assert_eq!(account.total.a4.unknown, ["softwood_cladding", "pe_vapour_barrier", "breather_membrane"]);
    assert_eq!(account.total.c3_c4.unknown, ["osb"]);
    assert_eq!(account.total.d.unknown, ["mineral_wool", "plasterboard"]);
    assert_eq!(account.per_m2, None);
}

/// Lines, sections and materials each sum to the whole, that of A1-A3 to the cost's, and a m2 is a part of it.
#[test]
fn parts_sum_to_the_whole() {
    let books = Books::load(&configs()).expect("the books");
    let account = CarbonAccount::new(&house(), &books, &|_| "s".to_owned(), 42.0).expect("an account");
    let whole = cost(&house(), &books.rates().expect("rates"));
    (0..3).for_each(|k| near(account.total.a1_a3[k], whole.gwp_fossil[k]));
    near(account.total.biogenic_storage, whole.biogenic);
    near(account.total.energy_known_mj, whole.energy_known_mj);
    let dense = StageTable::new(&books).expect("a table").of(&house());
    let per_m2 = account.per_m2.as_ref().expect("a floor");
    for rows in [&account.lines, &account.groups, &account.materials] {
        assert!(rows.len() > 3);
        let sum = |value: &dyn Fn(&CarbonFigures) -> f64| rows.iter().map(|r| value(&r.figures)).sum::<f64>();
        for k in 0..3 {
            near(sum(&|f| f.a1_a3[k]), account.total.a1_a3[k]);
            for stage in Stage::ALL {
                near(sum(&|f| f.stage(stage).known[k]), account.total.stage(stage).known[k]);
                near(dense.stage(stage).known[k], account.total.stage(stage).known[k]);
                near(42.0 * per_m2.stage(stage).known[k], account.total.stage(stage).known[k]);
            }
        }
        near(sum(&|f| f.biogenic_storage), account.total.biogenic_storage);
        near(sum(&|f| f.energy_known_mj), account.total.energy_known_mj);
    }
    near(account.total.biogenic_release_c3, -account.total.biogenic_storage);
    assert!(account.total.biogenic_storage < -1000.0);
}

/// An unknown factor is no zero: its items are named, and what is known is less by its part.
#[test]
fn unknown_is_said_and_never_zero() {
    let before = Books::load(&configs()).expect("the books");
    let after = edited(|list| item(list, "mineral_wool")["stages"]["a4"] = Value::Null).expect("a list");
    let [a, b] = [&before, &after].map(|books| StageTable::new(books).expect("a table").of(&wall()));
    near(a.stage(Stage::A4).known[1] - b.stage(Stage::A4).known[1], (1.24875 + 4.86) * 0.0345);
    let frame = StageTable::new(&after).expect("a table").of_item(Item::FrameC24, 100.0);
    assert!(frame.stage(Stage::A4).is_complete() && !b.stage(Stage::A4).is_complete());
    let none = StageTable::new(&after).expect("a table").of_item(Item::Wall, 0.0);
    assert!(none.stages.iter().all(StageSum::is_complete), "what is not there is not unknown");
    // A list of the first version knows no stage at all.
    let old = edited(|list| {
        list["schema"] = json!("houscaper.carbon/1");
        list.as_object_mut().expect("a list").remove("stages");
        list["items"].as_array_mut().expect("items").iter_mut().for_each(|i| {
            i.as_object_mut().expect("an item").remove("stages");
        });
    });
    let sums = StageTable::new(&old.expect("a list")).expect("a table").of(&wall());
    assert!(sums.stages.iter().all(|s| s.known == [0.0; 3] && !s.is_complete()));
}

/// One factor changes its stage in the lines that hold the material, and nothing else.
#[test]
fn one_factor_changes_only_its_rows() {
    let before = Books::load(&configs()).expect("the books");
    let change = |list: &mut Value| {
        item(list, "clay_tile")["stages"]["d"] = json!({"low": -0.5, "default": -0.5, "high": 0.25, "source": "x"});
    };
    let after = edited(change).expect("a list");
    let of = |books| CarbonAccount::new(&house(), books, &|_| "s".to_owned(), 42.0).expect("an account");
    let (a, b) = (of(&before), of(&after));
    let mut changed = Vec::new();
    for (old, new) in a.lines.iter().zip(&b.lines) {
        if old != new {
            changed.push(old.name.as_str());
            let expected = CarbonFigures { d: new.figures.d.clone(), ..old.figures.clone() };
            assert_eq!(expected, new.figures, "only D of {}", old.name);
        }
    }
    assert_eq!(changed, ["pitched_roof"]);
}

#[test]
fn bad_factors_are_refused() {
    let refused = |words: &[&str], edit: &dyn Fn(&mut Value)| {
        let message = edited(edit).map(|_| ()).expect_err("refused").to_string();
        assert!(words.iter().all(|w| message.contains(w)), "{message}");
    };
    let stage =
        |key: &'static str, value: Value| move |list: &mut Value| item(list, "osb")["stages"][key] = value.clone();
    let factor =
        |low: f64, high: f64, source: &str| json!({"low": low, "default": low, "high": high, "source": source});
    refused(&["carbon.json", "osb.stages.a4", "0 <= low"], &stage("a4", factor(-0.1, 0.1, "x")));
    refused(&["osb.stages.d", "low <= default"], &stage("d", factor(0.1, -0.1, "x")));
    refused(&["osb.stages.a5.source"], &stage("a5", factor(0.1, 0.1, " ")));
    refused(&["b7"], &stage("b7", factor(0.1, 0.1, "x")));
    refused(&["schema", "houscaper.carbon/2"], &|list| list["schema"] = json!("houscaper.carbon/3"));
    assert!(edited(stage("d", factor(-2.0, 1.0, "x"))).is_ok(), "D may be of either sign");
}
