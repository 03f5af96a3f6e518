//! Comparison of materials: what it says is recomputed from the price book, and what it says would turn the order round does.

#[path = "common/cli.rs"]
mod cli;
#[path = "common/runs.rs"]
mod runs;

use cli::{Scratch, contents, has, ok, refused};
use houscaper::price::{CarbonItem, DRAWS, Draws, PriceMatrix, Stage};
use houscaper::score::{Account, Comparison, Evaluator, SizingGoal, Survival, Variant};
use houscaper::voxels::samples;
use serde_json::{Value, json};

fn evaluators(materials: &[&str]) -> Vec<(String, Evaluator)> {
    let load = |name: &&str| {
        let folder = Scratch::new();
        let change = |b: &mut Value| b["materials"] = json!(name.split('+').collect::<Vec<_>>());
        ((*name).to_owned(), runs::evaluator(&runs::changed_brief("starter.json", folder.path(), change)))
    };
    materials.iter().map(load).collect()
}

fn compared() -> (Vec<(String, Evaluator)>, Comparison) {
    let systems = evaluators(&["C24", "GL24h", "S355"]);
    let (_, house) = samples::all().into_iter().find(|(name, _)| *name == "box").expect("a sample");
    let draws = Draws::new(&systems[0].1.books, DRAWS, 1).expect("a complete book");
    let (comparison, left_out) = Comparison::new(&house, &systems, SizingGoal::Price, &draws).expect("priced");
    assert!(left_out.is_empty() && comparison.variants.len() == 3);
    (systems, comparison)
}

/// Quantities by item of the price book, times its rates, times what comes on top: the price of the evaluation. At low and high rates the
/// learning rate moves with them, which quantities hold at its default: prices lie further out than that.
#[test]
fn quantities_of_the_price_book_say_the_price() {
    let (systems, comparison) = compared();
    for (variant, (_, evaluator)) in comparison.variants.iter().zip(&systems) {
        assert!(variant.is_ok(), "{}", variant.system);
        for k in 0..3 {
            let items = evaluator.books.prices.items().iter().zip(&variant.quantities);
            let net: f64 = items.map(|(item, q)| q * item.range()[k]).sum();
            let price = net * evaluator.rates.in_place[k];
            let found = variant.price()[k];
            let holds = match k {
                0 => found < price,
                1 => (price / found - 1.0).abs() < 1e-12,
                _ => found > price,
            };
            assert!(holds, "{} {k}: {found} {price}", variant.system);
        }
    }
}

/// The mean of a triangle is the mean of its corners; that of a house's net price the sum over its items, that of the product with
/// overhead and contingency the product of the means, as all are drawn apart. Four standard errors of 4,096 draws.
#[test]
fn the_mean_of_the_draws_is_that_of_the_triangles() {
    let (systems, comparison) = compared();
    let books = &systems[0].1.books;
    let mean = |[a, c, b]: [f64; 3]| (a + b + c) / 3.0;
    let on_top =
        ["overhead_profit", "contingency"].map(|id| 1.0 + mean(books.prices.surcharge(id).expect("there").range()));
    for variant in &comparison.variants {
        let items = books.prices.items().iter().zip(&variant.quantities);
        let expected = items.map(|(item, q)| q * mean(item.range())).sum::<f64>() * on_top[0] * on_top[1];
        let n = variant.prices.len() as f64;
        let found = variant.prices.iter().sum::<f64>() / n;
        let variance = variant.prices.iter().map(|p| (p - found).powi(2)).sum::<f64>() / (n - 1.0);
        let error = (variance / n).sqrt();
        assert!((found - expected).abs() < 4.0 * error, "{}: {found}, by hand {expected} +- {error}", variant.system);
        let [low, _, high] = variant.price();
        assert!(variant.prices.iter().all(|p| (low..=high).contains(p)), "every draw is within low and high");
    }
    let chances = comparison.chance_cheapest();
    assert!((chances.iter().sum::<f64>() - 1.0).abs() < 1e-9);
    assert!((comparison.chance(0, 1) + comparison.chance(1, 0) - 1.0).abs() < 1e-12);
}

/// A house against itself costs the same in every draw: what two houses share cancels.
#[test]
fn what_is_shared_cancels() {
    let systems = evaluators(&["C24"]);
    let twice: Vec<(String, Evaluator)> = systems.into_iter().chain(evaluators(&["C24"])).collect();
    let (_, house) = samples::all().into_iter().find(|(name, _)| *name == "box").expect("a sample");
    let draws = Draws::new(&twice[0].1.books, 500, 7).expect("a complete book");
    let (comparison, _) = Comparison::new(&house, &twice, SizingGoal::Price, &draws).expect("priced");
    assert_eq!(comparison.variants[0].prices, comparison.variants[1].prices);
    assert_eq!(comparison.chance(0, 1), 0.5);
    assert!(comparison.rows().iter().all(|r| r.amount[0] == r.amount[1] && r.gwp_kgco2e[0] == r.gwp_kgco2e[1]));
    let matrix = PriceMatrix::new(&twice[0].1.books).expect("a complete book");
    let takeoff = comparison.variants[0].evaluation.takeoff.expect("a take-off");
    assert_eq!(matrix.quantities(&takeoff), comparison.variants[0].quantities);
}

/// The frame alone differs, and the boards of the walls where a frame needs them.
#[test]
fn the_frame_alone_differs() {
    let (_, comparison) = compared();
    // Waste and labour, carried mass and connections are the frame's too.
    let shared = |group: &str| !["frame", "manufacture", "site"].contains(&group);
    for row in comparison.rows().iter().filter(|r| shared(&r.group) && r.item != "wall") {
        assert!(row.amount.iter().all(|a| (a - row.amount[0]).abs() < 1e-9), "{row:?}");
    }
    for (n, variant) in comparison.variants.iter().enumerate() {
        let rows: f64 = comparison.rows().iter().map(|r| r.amount[n]).sum();
        let net = variant.evaluation.cost.expect("priced").net_eur[1];
        assert!((rows - net).abs() < 1e-6, "lines sum to the cost");
    }
}

/// The rate at which two systems cost the same, put into the price book: they do.
#[test]
fn a_tie_is_a_tie() {
    let folder = Scratch::new();
    let out = |n: &str| folder.at(n);
    let first = ok(&["compare", "sample:box", "--materials", "GL24h,S355", "--json", "--out", &out("a")]);
    let found: Value = serde_json::from_str(&first.out).expect("JSON");
    let ties = found["pairs"][0]["ties"].as_array().expect("ties");
    let price = ties.iter().find(|t| t["of"] == "price" && t["item"] == "steel_shs_s355").expect("a rate of steel");
    let book = runs::repository().join("configs/prices.json");
    let mut book: Value = serde_json::from_slice(&std::fs::read(book).expect("the book")).expect("JSON");
    let items = book["items"].as_array_mut().expect("items");
    let steel = items.iter_mut().find(|i| i["id"] == "steel_shs_s355").expect("steel");
    assert_eq!(steel["default"], price["rate"]);
    for key in ["low", "default", "high"] {
        steel[key] = price["tie"].clone();
    }
    let prices = folder.path().join("prices.json");
    std::fs::write(&prices, book.to_string()).expect("a file");
    let brief = runs::changed_brief("starter.json", folder.path(), |b| b["prices"] = json!(prices));
    let brief = brief.display().to_string();
    let again =
        ok(&["compare", "sample:box", "--materials", "GL24h,S355", "--brief", &brief, "--json", "--out", &out("b")]);
    let again: Value = serde_json::from_str(&again.out).expect("JSON");
    let [a, b] = [0, 1].map(|n| again["variants"][n]["price_eur"][1].as_f64().expect("a price"));
    assert!((a / b - 1.0).abs() < 1e-9, "{a} {b}");
    assert_eq!(
        found["variants"][1]["choices"], again["variants"][1]["choices"],
        "one rate for all steel: the same sections"
    );
}

#[test]
fn the_same_question_has_the_same_bytes() {
    let folder = Scratch::new();
    let files = |name: &str, more: &[&str]| {
        let out = folder.at(name);
        let mut args = vec!["compare", "sample:hip", "--materials", "C24,GL24h,C24+S355", "--out", &out];
        args.extend(more);
        let said = ok(&args).out;
        has(&said, &["C24+S355", "is cheaper in", "draws"]);
        let mut all = contents(&folder.path().join(name));
        all.iter_mut().for_each(|(path, _)| *path = path.file_name().expect("a name").into());
        all
    };
    let (a, b, c) = (files("a", &[]), files("b", &[]), files("c", &["--seed", "2"]));
    assert_eq!(a, b);
    assert!(a != c, "another seed draws other rates");
    for name in ["compare.csv", "lines.csv", "compare.json", "compare.html", "price.svg", "carbon.png"] {
        assert!(a.iter().any(|(path, bytes)| path.ends_with(name) && bytes.len() > 100), "{name}");
    }
}

#[test]
fn a_question_that_cannot_be_answered_is_refused() {
    let folder = Scratch::new();
    let out = folder.at("x");
    let refuses = |args: &[&str], parts: &[&str]| {
        let args: Vec<&str> = ["compare"].iter().chain(args).copied().chain(["--out", out.as_str()]).collect();
        has(&refused(&args), parts);
        assert!(!std::path::Path::new(&out).exists());
    };
    refuses(&["sample:box", "--materials", "C24"], &["--materials names 1", "expected 2 to 6"]);
    refuses(&["sample:box", "--materials", "C24,C24"], &["twice"]);
    refuses(&["sample:box", "--materials", "C24,oak"], &["`oak`", "C24"]);
    refuses(&["sample:nowhere", "--materials", "C24,S355"], &["unknown"]);
    refuses(&["tilesets", "--materials", "C24,S355"], &["tilesets"]);
}

/// A whole front: a row for each house and system, houses in the order of their ids.
#[test]
fn a_front_is_compared_house_by_house() {
    let folder = Scratch::new();
    let run = folder.at("run");
    let brief = runs::changed_brief("starter.json", folder.path(), |b| b["search"]["evaluations"] = json!(300));
    let told = ok(&["optimize", &brief.display().to_string(), "--out", &run]).out;
    has(
        &told,
        &["in 80 % of the draws; cheapest of the named houses in", "order of the front by price", "least sure: house"],
    );
    has(
        &contents(&folder.path().join("run/plots")).iter().map(|f| f.0.display().to_string()).collect::<String>(),
        &["cheaper.svg"],
    );
    let out = folder.at("compared");
    let said = ok(&["compare", &run, "--materials", "C24+GL24h,S355", "--out", &out]).out;
    let houses = std::fs::read_dir(folder.path().join("run/front")).expect("a front").count();
    has(&said, &[&format!("C24+GL24h: stands in {houses} of {houses} houses"), "least carbon in"]);
    let table = std::fs::read_to_string(folder.path().join("compared/summary.csv")).expect("a table");
    let rows: Vec<Vec<&str>> = table.lines().skip(1).map(|l| l.split(',').collect()).collect();
    assert!(rows.len() == 2 * houses && houses > 1, "{table}");
    let ids: Vec<u64> = rows.iter().step_by(2).map(|r| r[0].parse().expect("an id")).collect();
    assert!(ids.windows(2).all(|w| w[0] < w[1]), "{ids:?}");
    for pair in rows.chunks(2) {
        let chances: f64 = pair.iter().map(|r| r[8].parse::<f64>().expect("a chance")).sum();
        assert!((chances - 1.0).abs() < 1e-3 || pair.iter().all(|r| r[2] == "false"), "{pair:?}");
        assert!(folder.path().join("compared").join(pair[0][0]).join("compare.html").is_file());
        for row in pair {
            let number = |n: usize| row[n].parse::<f64>().expect("a number");
            assert!(number(9) > 0.0 && number(10) > 0.0 && number(11) > 0.0 && number(12) < 0.0 && number(13) < 0.0);
            assert!(["", "true", "false"].contains(&row[14]), "{row:?}");
        }
    }
    let of = |name: &str| std::fs::read_to_string(folder.path().join("compared").join(name)).expect("a file");
    has(&of("front.html"), &["C24+GL24h, S355", "with biogenic storage counted: it stays in", "compare.html", "<svg"]);
    has(&of("front.svg"), &["C24+GL24h", "S355", "Fossil carbon A1-A3", "Price in place"]);
    assert!(std::fs::metadata(folder.path().join("compared/front.png")).expect("a picture").len() > 10_000);
}

/// Stages by material times factors, and what the account says of the order, recomputed from the factor list of the file.
#[test]
fn the_carbon_of_a_comparison_is_that_of_its_materials() {
    let (systems, comparison) = compared();
    let book = &systems[0].1.books.carbon;
    let near = |a: f64, b: f64| assert!((a - b).abs() <= 1e-9 * a.abs().max(1.0), "{a} is not {b}");
    let sum = |v: &Variant, factor: &dyn Fn(&CarbonItem) -> f64| -> f64 {
        book.items().iter().zip(&v.materials).map(|(item, q)| q * factor(item)).sum()
    };
    let stage = |item: &CarbonItem, s: Stage, k: usize| item.stage(s).map_or(0.0, |f| f.range()[k]);
    for v in &comparison.variants {
        for k in 0..3 {
            near(sum(v, &|i| i.range()[k]), v.carbon()[k]);
            Stage::ALL.into_iter().for_each(|s| near(sum(v, &|i| stage(i, s, k)), v.stages.stage(s).known[k]));
        }
        near(sum(v, &|i| i.biogenic), v.stages.storage);
        near(v.stages.release, -v.stages.storage);
        let unknown = Stage::ALL.map(|s| v.stages.stage(s).unknown_items().count());
        assert!(unknown.iter().all(|n| *n > 0), "windows, doors, boards: {unknown:?}");
    }
    let survivals = comparison.survivals(book);
    assert_eq!(survivals.len(), 2);
    for s in &survivals {
        let of = |name: &str| comparison.variants.iter().find(|v| v.system == name).expect("a system");
        let (a, b) = (of(&s.less), of(&s.more));
        assert!(s.a1_a3[0] < s.a1_a3[1]);
        near(s.a1_a3[0], a.carbon()[1]);
        let inside = |v: &Variant, k: usize| {
            v.carbon()[k] + Stage::INSIDE.iter().map(|st| v.stages.stage(*st).known[k]).sum::<f64>()
        };
        let kept = |account: Account| s.kept.contains(&account);
        assert_eq!(kept(Account::FossilLow), a.carbon()[0] < b.carbon()[0]);
        assert_eq!(kept(Account::FossilHigh), a.carbon()[2] < b.carbon()[2]);
        assert_eq!(kept(Account::Stages), inside(a, 1) < inside(b, 1));
        assert_eq!(kept(Account::StagesLow), inside(a, 0) < inside(b, 0));
        assert_eq!(kept(Account::StagesHigh), inside(a, 2) < inside(b, 2));
        let stored = |v: &Variant| v.carbon()[1] + v.stages.storage;
        assert_eq!(kept(Account::Storage), stored(a) < stored(b));
        assert_eq!(s.kept.len() + s.turned.len(), Account::ALL.len() - 1);
        // Every corner of the factors that differ lies within the difference, and its ends are corners.
        let corner = |pick: &dyn Fn(f64) -> usize| -> f64 {
            let quantities = a.materials.iter().zip(&b.materials).map(|(a, b)| b - a);
            let all =
                |i: &CarbonItem, k: usize| i.range()[k] + Stage::INSIDE.map(|st| stage(i, st, k)).iter().sum::<f64>();
            book.items().iter().zip(quantities).map(|(i, q)| q * all(i, pick(q))).sum()
        };
        near(corner(&|q| if q > 0.0 { 0 } else { 2 }), s.difference[0]);
        near(corner(&|q| if q > 0.0 { 2 } else { 0 }), s.difference[1]);
        assert!((s.difference[0]..=s.difference[1]).contains(&corner(&|_| 1)));
        // What both hold alike is not listed as unknown.
        assert!(s.unknown.iter().all(|u| u.more.abs() > 1e-6 && u.material != "double_glazing"), "{:?}", s.unknown);
        has(&s.sentence(), &[&s.less, &s.more, "D is in none of this", "The order"]);
    }
    let places = comparison.ranks(Account::Fossil);
    assert!(places.iter().all(Option::is_some));
    let first = comparison.variants.iter().zip(&places).find(|(_, p)| **p == Some(1)).expect("a first");
    assert_eq!(first.0.system, survivals[0].less);
    assert_eq!(comparison.order_is_kept(), Some(survivals.iter().all(Survival::is_kept)));
}
