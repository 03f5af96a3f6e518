//! The moves measured by the real rule checker: at least 99 of 100 children are rule-respecting on every space.

use houscaper::search::cells::Cells;
use houscaper::search::crossover::crossover;
use houscaper::search::massing::{Design, encode};
use houscaper::search::moves::Move;
use houscaper::search::plot::{ChoiceSpace, Plot, Programme, Space};
use houscaper::search::settle::floor_area_m2;
use houscaper::search::start::start;
use houscaper::voxels::{read_storeys, rules};
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
