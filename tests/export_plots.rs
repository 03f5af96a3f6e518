//! Plots and the contact sheet: drawn, deterministic, complete.

#[path = "common/houses.rs"]
mod houses;

use houscaper::export::picture::{Picture, render};
use houscaper::export::plots::*;
use houscaper::export::{Showing, from_envelope};
use serde_json::Value;

fn show(name: &str, bytes: &[u8]) {
    if let Some(folder) = std::env::var_os("HOUSCAPER_LOOK") {
        std::fs::write(std::path::Path::new(&folder).join(name), bytes).expect("folder to look in");
    }
}

fn axes() -> Vec<Axis> {
    let axis = |title: &str, unit: &str, maximise| Axis { title: title.into(), unit: unit.into(), maximise };
    vec![
        axis("Price", "EUR", false),
        axis("Embodied carbon A1-A3", "kgCO2e", false),
        axis("Floor area", "m²", true),
        axis("Utilisation", "", false),
    ]
}

/// A made-up cloud with a convex trade-off, the same each time.
fn cloud() -> Cloud {
    let mut state = 7u64;
    let mut random = move || {
        state = state.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        (state >> 33) as f64 / f64::from(1u32 << 31)
    };
    let mut cloud = Cloud::default();
    for i in 0..900 {
        let (s, d) = (random(), random());
        let row = vec![
            95e3 + 120e3 * s + 40e3 * d,
            7e3 + 9e3 * (1.0 - s).powi(2) + 6e3 * d + 3e3 * s * random(),
            42.0 + 45.0 * s + 3.0 * d,
            0.4 + 0.6 * random(),
        ];
        if i % 7 == 0 { cloud.infeasible.push(row) } else { cloud.feasible.push(row) }
    }
    for i in 0..34 {
        let s = f64::from(i) / 33.0;
        cloud.front.push(vec![
            95e3 + 118e3 * s,
            6.6e3 + 8.6e3 * (1.0 - s).powi(2),
            42.0 + 46.0 * s,
            0.5 + 0.4 * random(),
        ]);
    }
    cloud
}

fn named(cloud: &Cloud) -> Vec<Named> {
    [("cheapest", 0), ("lowest carbon", 33), ("best balance", 14), ("most different", 22), ("nearest to reference", 15)]
        .map(|(name, i)| Named { name: name.into(), values: cloud.front[i].clone() })
        .to_vec()
}

fn check(name: &str, svg: &str, words: &[&str]) {
    show(&format!("{name}.svg"), svg.as_bytes());
    for word in words {
        assert!(svg.contains(word), "{name} says {word}");
    }
    assert!(!svg.contains("NaN") && !svg.contains("\"inf"), "{name} has finite coordinates");
    let started = std::time::Instant::now();
    let png = svg_to_png(svg, 1.5).expect("our own SVG");
    println!("{name}: SVG {} B, PNG {} B in {:?}", svg.len(), png.len(), started.elapsed());
    assert_eq!(png, svg_to_png(svg, 1.5).expect("our own SVG"));
    show(&format!("{name}.png"), &png);
}

#[test]
fn plots_say_what_they_show() {
    let cloud = cloud();
    let (axes, named) = (axes(), named(&cloud));
    let svg = pareto("starter: price against carbon", &axes, [0, 1], Some(2), &cloud, &named).unwrap();
    assert_eq!(svg, pareto("starter: price against carbon", &axes, [0, 1], Some(2), &cloud, &named).unwrap());
    assert_eq!(svg.matches("<circle").count(), 128 + 772 + 2 * 34 + 3 + 5 - hidden(&svg), "every design, key and ring");
    check("pareto", &svg, &["Price [EUR]", "kgCO2e", "better", "cheapest", "nearest to reference"]);
    check("matrix", &scatter_matrix("starter: all pairs", &axes, &cloud).unwrap(), &["Utilisation", "less is better"]);
    check(
        "parallel",
        &parallel_coordinates("starter: front", &axes, &cloud, &named).unwrap(),
        &["Floor area", "best balance"],
    );
    let series = [("search", 0.9), ("hill climber", 0.7), ("random search", 0.68)].map(|(name, top)| Series {
        name: name.into(),
        points: (0..60).map(|i| [f64::from(i) * 100.0, top * (1.0 - (-f64::from(i) / 12.0).exp())]).collect(),
    });
    check(
        "hypervolume",
        &hypervolume("starter: progress", "a note", &series).unwrap(),
        &["Evaluations", "random search"],
    );
    let causes = [
        ("window at a corner", 412.0),
        ("diagonal contact", 1377.0),
        ("cantilever too long", 96.0),
        ("storey not reachable", 240.0),
    ]
    .map(|(name, value)| Bar { name: name.into(), value });
    check("rejected", &bars("Rejected moves by cause", "moves", &causes).unwrap(), &["65 %", "diagonal contact"]);
}

/// Infeasible designs outside the frame are not drawn; everything else must be.
fn hidden(svg: &str) -> usize {
    let drawn = svg.matches("<circle").count();
    let all = 128 + 772 + 2 * 34 + 3 + 5;
    assert!(drawn <= all && drawn >= all - 128, "{drawn} of {all}");
    all - drawn
}

fn broken_effect() -> Effect {
    Effect { name: "e".into(), kept: vec![Some([f64::NAN, 1.0]), None], all: vec![Some([0.0, f64::INFINITY])] }
}

#[test]
fn effects_and_fates_say_what_they_show() {
    let effect = |name: &str, price: [f64; 2], area: [f64; 2]| Effect {
        name: name.into(),
        kept: vec![Some(price), None, Some(area), None],
        all: vec![Some([price[0] - 3.0, price[1] + 3.0]), None, None, None],
    };
    let effects = [
        effect("add storey (2 of 3)", [31.0, 42.5], [48.0, 55.0]),
        effect("wall material (4 of 16)", [-1.25, 12.0], [0.0, 0.0]),
        effect("remove window (3 of 3)", [-2.0, -0.5], [0.0, 0.0]),
    ];
    let values = ["from 92000 EUR", "", "from 55.2 m²", ""].map(str::to_owned);
    let svg = tornado("starter: single changes", "9 of 22 houses", &axes(), &values, &effects).unwrap();
    // Better: of the windows a pale and a full bar, of the wall one, and of the storey's area two; worse: of the storey's price two, of
    // the wall one; and the key.
    let of = |colour: &str| svg.matches(colour).count();
    assert_eq!((of("#0072B2"), of("#E69F00")), (2 + 1 + 2 + 1, 2 + 1 + 1));
    check("tornado", &svg, &["Price", "add storey", "+42", "\u{2212}1.2", "change [%]", "from 92000 EUR", "better"]);
    let stacks = [("all draws", vec![60, 20, 0, 10, 10]), ("add storey", vec![1, 2, 0, 0, 1])]
        .map(|(name, counts)| Stack { name: name.into(), counts });
    let kinds = ["feasible", "infeasible", "breaks a rule", "evaluated before", "did not apply"];
    let svg = stacked("starter: moves", "share of the draws [%]", &kinds, &stacks).unwrap();
    check("moves", &svg, &["feasible", "100", "evaluated before"]);
    // Bars: four shares of the first, three of the second, five in the key, one sheet.
    assert_eq!(svg.matches("<rect").count(), 4 + 3 + 5 + 1);
    let series = Series { name: "a".into(), points: vec![[10.0, 0.1], [20.0, 0.4], [30.0, 0.5]] };
    assert_eq!([0.1, 0.2, 0.5, 0.6].map(|v| reached(&series, v)), [Some(10.0), Some(20.0), Some(30.0), None]);
}

#[test]
fn empty_and_broken_values_do_not_break_plots() {
    let axes = axes();
    let nan =
        Cloud { feasible: vec![vec![f64::NAN; 4], vec![]], front: vec![vec![1.0, 1.0, 1.0, 1.0]], ..Cloud::default() };
    for cloud in [Cloud::default(), nan] {
        for svg in [
            pareto("t", &axes, [0, 1], Some(2), &cloud, &[]).unwrap(),
            scatter_matrix("t", &axes, &cloud).unwrap(),
            parallel_coordinates("t", &axes, &cloud, &[]).unwrap(),
            hypervolume("t", "", &[Series { name: "a".into(), points: vec![] }]).unwrap(),
            bars("t", "moves", &[]).unwrap(),
            stacked("t", "%", &["a"], &[]).unwrap(),
            stacked("t", "%", &["a"], &[Stack { name: "none".into(), counts: vec![0] }]).unwrap(),
            tornado("t", "", &axes, &[], &[]).unwrap(),
            tornado("t", "", &axes, &[], &[broken_effect()]).unwrap(),
        ] {
            assert!(!svg.contains("NaN"));
            svg_to_png(&svg, 1.0).unwrap();
        }
    }
    assert!(pareto("t", &axes, [0, 9], None, &Cloud::default(), &[]).is_err());
}

#[test]
fn a_map_of_elites_has_a_picture_in_each_cell_that_is_taken() {
    let scene = from_envelope(&houses::villa(), Showing::default(), Value::Null, |_| Value::Null);
    let image = render(&scene, &Picture::of_house(DiversityMap::PICTURE)).unwrap();
    let heading = |group: &str, name: &str| Heading { group: group.into(), name: name.into() };
    let cell = |at, worth| MapCell {
        at,
        caption: ["217 · EUR 128k".into(), "14.2 t CO2e · 86 m²".into()],
        worth,
        image: image.clone(),
    };
    let map = DiversityMap {
        title: "starter: the best house of each of 3 kinds".into(),
        note: "best: least Envelope and frame (EUR)".into(),
        rows: vec![heading("1 storey", "bar"), heading("1 storey", "L"), heading("2 storeys", "compact")],
        columns: vec![heading("low hip", "15 to 20 %"), heading("high hip", "15 to 20 %")],
        cells: vec![cell([0, 0], 1.0), cell([1, 1], 0.5), cell([2, 0], 0.0)],
    };
    let (svg, png) = diversity_map(&map).unwrap();
    show("map.svg", svg.as_bytes());
    show("map.png", &png);
    assert_eq!(svg.matches("<image").count(), 3);
    assert_eq!(svg.matches(">1 storey<").count() + svg.matches("1 storey\n").count(), 1, "a group is named once");
    assert!(svg.contains("high hip") && svg.contains("EUR 128k") && !svg.contains("NaN"));
    assert_eq!((svg, png), diversity_map(&map).unwrap());
}

#[test]
fn a_contact_sheet_holds_every_picture() {
    let scenes = [houses::villa(), houses::bungalow()]
        .map(|m| from_envelope(&m, Showing::default(), Value::Null, |_| Value::Null));
    let small = Picture { size: [320, 240], ..Picture::default() };
    let cards: Vec<Card> = (0..6)
        .map(|i| Card {
            title: format!("{} {}", 100 + i, if i == 0 { "cheapest" } else { "" }),
            caption: "EUR 128k · 14.2 t CO2e · 86 m²".into(),
            image: render(&scenes[i % 2], &small).unwrap(),
        })
        .collect();
    let png = contact_sheet("starter: 6 houses of the front", 3, &cards).unwrap();
    show("sheet.png", &png);
    assert_eq!(png, contact_sheet("starter: 6 houses of the front", 3, &cards).unwrap());
    assert!(contact_sheet("none", 3, &[]).is_ok());
    let groups = [(0, 2), (2, 6)]
        .map(|(from, to)| Group { heading: format!("{} houses", to - from), cards: cards[from..to].to_vec() });
    let png = grouped_sheet("starter: by look", 3, &groups).unwrap();
    show("groups.png", &png);
    assert_eq!(png, grouped_sheet("starter: by look", 3, &groups).unwrap());
    let size = |png: &[u8]| [16, 20].map(|at| u32::from_be_bytes(png[at..at + 4].try_into().unwrap()));
    // One row of the first group, two of the second, each group with its heading.
    assert_eq!(size(&png), [18 + 3 * (320 + 18), 56 + 2 * 44 + 3 * (240 + 46 + 18) + 18]);
    assert!(grouped_sheet("none", 3, &[]).is_ok());
}

#[test]
fn breakdowns_and_materials_say_what_they_show() {
    let sections = ["frame", "envelope", "openings"];
    let houses = [
        Parts { name: "12 cheapest".into(), parts: vec![30e3, 60e3, 10e3] },
        Parts { name: "40 lowest carbon".into(), parts: vec![45e3, 50e3, -5e3] },
    ];
    let svg = breakdown("starter: costs", "share in %", "Price [EUR]", &sections, &houses).unwrap();
    // 30, 60 and 10 of 100; below nothing is nothing: 45 of 95 and 50 of 95.
    check(
        "breakdown",
        &svg,
        &["Price [EUR]", "better", "envelope", "12 cheapest", "30\n", "60\n", "100k", "47\n", "53\n", "95k"],
    );
    assert_eq!(svg, breakdown("starter: costs", "share in %", "Price [EUR]", &sections, &houses).unwrap());
    let axes = axes();
    let framed: Vec<Framed> = (0..40)
        .map(|i| Framed { material: i % 3, x: 90e3 + 2e3 * i as f64, y: 9e3 + 100.0 * (i as f64 - 20.0).powi(2) })
        .collect();
    let names = ["C24".to_owned(), "C24 + GL24h".to_owned(), "S355".to_owned()];
    let svg = by_material("starter: by material", [&axes[0], &axes[1]], &names, &framed).unwrap();
    check("materials", &svg, &["C24 + GL24h (13)", "C24 (14)", "Price [EUR]", "kgCO2e", "better"]);
    check("no_materials", &by_material("none", [&axes[0], &axes[1]], &[], &[]).unwrap(), &["none"]);
}

#[test]
fn poor_designs_far_away_do_not_press_the_front_into_a_corner() {
    let mut cloud = cloud();
    cloud.feasible.push(vec![9e6, 9e6, 50.0, 0.5]);
    let svg = pareto("starter", &axes(), [0, 1], None, &cloud, &[]).unwrap();
    check("beyond", &svg, &["1 evaluated", "beyond the axes"]);
    assert!(!svg.contains("10M"), "the axes end near the front");
}
