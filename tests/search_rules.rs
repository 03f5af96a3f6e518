//! The moves measured by the real rule checker: at least 99 of 100 children are rule-respecting on every space.

use houscaper::brief::Brief;
use houscaper::search::cells::Cells;
use houscaper::search::crossover::crossover;
use houscaper::search::from_brief;
use houscaper::search::kept::Kept;
use houscaper::search::massing::{Design, encode};
use houscaper::search::moves::Move;
use houscaper::search::plot::{ChoiceSpace, Plot, Programme, Space};
use houscaper::search::settle::floor_area_m2;
use houscaper::search::start::start;
use houscaper::voxels::lattice::{Lattice, Values};
use houscaper::voxels::{CellMap, Given, House, Label, Module, Resample, ScaleReport, read_storeys, resample, rules};
use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;
use std::collections::BTreeMap;

/// Children wanted rule-respecting, in a hundred.
const WANTED: usize = 99;

fn space(modules: [usize; 3], area: [f64; 2], storeys: [usize; 2], given: bool) -> Space {
    let size = [modules[0], modules[1]];
    let mut plot = Plot::new(modules, None).expect("a plot");
    if given {
        let block = |x: isize, y: isize| Cells::rect(size, [x, y], [4, 4]);
        let fill = [block(1, 1).or(&block(9, 5)).to_plan(), block(5, 5).to_plan()];
        plot = plot.with_given(&fill, &[], Vec::new()).expect("given");
    }
    let programme = Programme { floor_area_m2: area, storeys, ..Programme::default() };
    Space::new(plot, programme, ChoiceSpace { options: [6, 6, 4, 5, 4, 2] }).expect("a space")
}

#[derive(Default)]
struct Count {
    tried: usize,
    made: usize,
    valid: usize,
}

#[derive(Default)]
struct Shares {
    by_operator: BTreeMap<&'static str, Count>,
    by_rule: BTreeMap<&'static str, usize>,
    first: BTreeMap<&'static str, String>,
    area_error: f64,
}

impl Shares {
    fn judge(&mut self, operator: &'static str, design: &Design, space: &Space) -> bool {
        let house = encode(&design.massing, &space.plot);
        let broken = rules::check(&house, &Default::default());
        let count = self.by_operator.entry(operator).or_default();
        count.made += 1;
        count.valid += usize::from(broken.is_empty());
        for violation in &broken {
            *self.by_rule.entry(violation.rule).or_default() += 1;
            self.first.entry(violation.rule).or_insert_with(|| violation.message.clone());
        }
        let reading = read_storeys(&house);
        let exact: f64 = reading.storeys.iter().map(|s| s.floor_area_m2).sum();
        self.area_error = self.area_error.max((floor_area_m2(&design.massing) / exact - 1.0).abs());
        broken.is_empty()
    }
}

fn measure(space: &Space, walks: u64, steps: usize) -> Shares {
    let mut shares = Shares::default();
    let mut previous: Option<Design> = None;
    for walk in 0..walks {
        let mut rng = ChaCha8Rng::seed_from_u64(11);
        rng.set_stream(walk);
        let mut design = start(space, &mut rng).expect("a start");
        shares.judge("start", &design, space);
        for _ in 0..steps {
            let choice = Move::draw(&mut rng);
            shares.by_operator.entry(choice.name()).or_default().tried += 1;
            let Some(child) = choice.apply(&design, space, &mut rng) else { continue };
            if shares.judge(choice.name(), &child, space) {
                design = child;
            }
        }
        shares.by_operator.entry("crossover").or_default().tried += usize::from(previous.is_some());
        if let Some(child) = previous.as_ref().and_then(|p| crossover(p, &design, space, &mut rng)) {
            shares.judge("crossover", &child, space);
        }
        previous = Some(design);
    }
    shares
}

fn assert_shares(name: &str, shares: &Shares) {
    let (mut made, mut valid) = (0, 0);
    for (operator, count) in &shares.by_operator {
        let share = 100.0 * count.valid as f64 / count.made.max(1) as f64;
        println!("{name} {operator:15} {:5} tried {:5} made {share:6.1} % valid", count.tried, count.made);
        made += count.made;
        valid += count.valid;
    }
    println!(
        "{name} all {valid} of {made}; area error {:.3}; rules {:?}\n{:#?}",
        shares.area_error, shares.by_rule, shares.first
    );
    assert!(shares.area_error < 1e-9, "floor areas are those of the reading");
    assert!(valid * 100 >= WANTED * made, "{name}: {valid} of {made} children keep the rules: {:?}", shares.by_rule);
}

#[test]
fn children_on_the_starter_plot_keep_the_rules() {
    assert_shares("starter", &measure(&space([10, 8, 16], [40.0, 90.0], [1, 2], false), 60, 40));
}

#[test]
fn children_on_a_larger_plot_keep_the_rules() {
    assert_shares("larger", &measure(&space([16, 14, 23], [90.0, 220.0], [2, 3], false), 40, 40));
}

#[test]
fn children_around_given_zones_keep_the_rules() {
    assert_shares("given", &measure(&space([16, 14, 23], [60.0, 260.0], [2, 3], true), 40, 40));
}

/// A lattice of the labels of the lower left `part` (in shares of a hundred) of a house's plan.
fn labels_of(design: &Design, plot: &Plot, part: usize) -> Given {
    let house = encode(&design.massing, plot);
    let [nx, ny, nz] = plot.modules;
    let keep = |[x, y, _]: [usize; 3]| x * 100 < nx * part && y * 100 <= ny * part;
    let mut values = vec![0.0; nx * ny * nz];
    house
        .voxels
        .iter()
        .filter(|(v, _)| keep(*v))
        .for_each(|(v, l)| values[house.voxels.index(v)] = f64::from(l.code()));
    let lattice = Lattice::new(plot.modules, [0.0; 3], [0.9, 0.9, 0.54], Values::Number(values)).expect("a lattice");
    let how = Resample { ground: false, ..Resample::default() };
    resample(&lattice, &"> 0".parse().expect("a rule"), &Module::default(), &how).expect("given voxels")
}

/// A brief whose given cells keep their labels.
fn labelled_brief() -> Brief {
    let text = std::fs::read_to_string("configs/starter.json").expect("the starter brief");
    let mut brief: serde_json::Value = serde_json::from_str(&text).expect("JSON");
    brief["plot"]["modules"] = serde_json::json!([16, 14, 17]);
    brief["programme"]["floor_area_m2"] = serde_json::json!([60.0, 220.0]);
    brief["programme"]["storeys"] = serde_json::json!([1, 2]);
    brief["given"] = serde_json::json!({"lattice": "labels.csv", "occupied": "> 0", "keep": "labels"});
    brief["programme"].as_object_mut().expect("a programme").remove("zones");
    serde_json::from_value(brief).expect("a brief")
}

/// Parts of houses are kept label by label, windows, doors, stairs and roof alike, while the rest changes.
#[test]
fn children_around_given_labels_keep_them_and_the_rules() {
    let free = space([16, 14, 17], [60.0, 220.0], [1, 2], false);
    let (mut given_openings, mut given_stairs, mut designs) = (0, 0, 0);
    for (seed, part) in [(1, 50), (2, 60), (3, 45), (4, 100)] {
        // Whole houses have two storeys, so that a stair is given too.
        let starts = (seed..).map(|s| start(&free, &mut ChaCha8Rng::seed_from_u64(s)).expect("a start"));
        let design = starts.into_iter().find(|d| part < 100 || d.massing.storeys.len() == 2).expect("a house");
        let given = labels_of(&design, &free.plot, part);
        let brief = labelled_brief();
        let space = from_brief::space(&brief, Some(&given), &Default::default(), [6, 6, 4, 5]).expect("a space");
        let kept = |house: &House| {
            let wrong = given.mask.iter().enumerate().filter(|(_, code)| **code >= 0).find(|(at, code)| {
                let [nx, ny, _] = given.shape;
                i32::from(house.voxels.get([at % nx, at / nx % ny, at / (nx * ny)]).code()) != **code
            });
            assert_eq!(wrong, None, "seed {seed}");
        };
        let count = |code: Label| given.mask.iter().filter(|z| **z == i32::from(code.code())).count();
        given_openings += count(Label::Window) + count(Label::Opening);
        given_stairs += usize::from(design.massing.storeys[0].stair.is_some() && part == 100);
        let mut shares = Shares::default();
        let mut looks = std::collections::BTreeSet::new();
        for walk in 0..8 {
            let mut rng = ChaCha8Rng::seed_from_u64(seed);
            rng.set_stream(walk);
            let mut design = start(&space, &mut rng).unwrap_or_else(|e| panic!("seed {seed}, walk {walk}: {e}"));
            for _ in 0..25 {
                let house = encode(&design.massing, &space.plot);
                kept(&house);
                looks.insert(house.voxels.labels().iter().map(|l| l.code()).collect::<Vec<_>>());
                let choice = Move::draw(&mut rng);
                shares.by_operator.entry(choice.name()).or_default().tried += 1;
                let Some(child) = choice.apply(&design, &space, &mut rng) else { continue };
                if shares.judge(choice.name(), &child, &space) {
                    design = child;
                }
            }
        }
        assert_shares("labels", &shares);
        designs += looks.len();
        assert!(part == 100 || looks.len() > 30, "seed {seed}: {} houses around the given part", looks.len());
    }
    assert!(given_openings > 40 && given_stairs > 0 && designs > 150, "{given_openings}, {given_stairs}, {designs}");
}

#[test]
fn labels_that_no_house_has_are_named() {
    let plot = Plot::new([10, 8, 16], None).expect("a plot");
    let kept = |cells: &[([usize; 3], i32)]| {
        let mut mask = vec![-1; 10 * 8 * 16];
        cells.iter().for_each(|([x, y, z], code)| mask[x + 10 * (y + 8 * z)] = *code);
        let map = CellMap { first: [0; 3], past: [10, 8, 16], size: [1; 3], offset: [0; 3] };
        let report = ScaleReport {
            cell_modules: [1; 3],
            default_cell_modules: [1; 3],
            error_m: [0.0; 3],
            scale: [1.0; 3],
            cells: cells.len(),
        };
        Kept::new(&Given { map, shape: [10, 8, 16], mask, report }, &plot).map(|_| ()).expect_err("no house")
    };
    let cases = [
        (vec![([1, 1, 1], 7)], "has the value 7"),
        (vec![([1, 1, 0], 2)], "holds the foundation"),
        (vec![([1, 1, 3], 2)], "holds base, opening or window"),
        (vec![([1, 1, 5], 5)], "openings end below it"),
        (vec![([1, 1, 3], 5), ([1, 1, 4], 1)], "no door or window"),
        (vec![([1, 1, 1], 1), ([1, 1, 2], 4)], "no door or window"),
        (vec![([2, 2, 5], 1), ([2, 2, 6], 1)], "no stair"),
        (vec![([2, 2, 5], 1), ([2, 2, 7], 5)], "lies in the roof"),
    ];
    for (cells, words) in cases {
        let error = kept(&cells).to_string();
        assert!(error.contains(words), "{cells:?}: {error}");
    }
}
