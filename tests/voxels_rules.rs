//! Each rule once broken and once kept: a sample house passes, one change breaks the rule, undoing it passes again.

use std::time::Instant;

use houscaper::voxels::rules::{self, RuleSettings, Scratch};
use houscaper::voxels::{Direction, House, Label, Stair, StairKind, is_admissible, read_storeys, samples};

fn broken(house: &House) -> Vec<&'static str> {
    let mut ids: Vec<_> = rules::check(house, &RuleSettings::default()).iter().map(|v| v.rule).collect();
    ids.dedup();
    ids
}

#[test]
fn sample_houses_keep_every_rule() {
    for (name, house) in samples::all() {
        let violations = rules::check(&house, &RuleSettings::default());
        assert!(violations.is_empty(), "{name}: {violations:#?}");
    }
}

/// `change` must break `rule`; the house without it is the positive twin.
fn breaks(rule: &str, house: House, change: impl FnOnce(&mut House)) {
    assert!(rules::RULES.iter().any(|r| r.id == rule), "no rule {rule}");
    let before = broken(&house);
    assert!(!before.contains(&rule), "the twin breaks {rule} too: {before:?}");
    let mut bad = house;
    change(&mut bad);
    let after = broken(&bad);
    assert!(after.contains(&rule), "{rule} is not reported, only {after:?}");
    let list = rules::check(&bad, &RuleSettings::default());
    assert!(list.iter().all(|v| v.amount > 0.0 && !v.message.is_empty() && !v.fix.is_empty()));
    let fast = rules::violation(&bad, &read_storeys(&bad), &RuleSettings::default(), &mut Scratch::default());
    assert_eq!(fast, list.iter().map(|v| v.amount).sum::<f64>(), "{rule}: fast sum");
    let settings = RuleSettings { off: vec![rule.to_string()], ..Default::default() };
    assert!(rules::check(&bad, &settings).iter().all(|v| v.rule != rule), "{rule} cannot be switched off");
}

fn set(voxels: &[[usize; 3]], label: Label) -> impl FnOnce(&mut House) {
    let voxels = voxels.to_vec();
    move |house| voxels.iter().for_each(|&v| house.voxels.set(v, label))
}

/// A block of voxels from `low` up to and without `high`.
fn block(low: [usize; 3], high: [usize; 3]) -> Vec<[usize; 3]> {
    let range = |a: usize| low[a]..high[a];
    range(2).flat_map(|z| range(1).flat_map(move |y| range(0).map(move |x| [x, y, z]))).collect()
}

#[test]
fn exactly_126_patterns_are_admissible() {
    assert_eq!((1u8..=254).filter(|&m| is_admissible(m)).count(), 126);
    assert!(is_admissible(0) && is_admissible(255));
    // Complement and every axis mirror keep the answer.
    for m in 0..=255u8 {
        assert_eq!(is_admissible(m), is_admissible(!m));
        assert_eq!(is_admissible(m), is_admissible(m.reverse_bits()));
    }
}

#[test]
fn body_rules() {
    breaks("cubes-admissible", samples::box_house(), set(&[[0, 0, 0]], Label::Foundation));
    breaks("one-body", samples::box_house(), set(&[[0, 0, 7]], Label::Base));
    breaks("foundation-layer", samples::box_house(), set(&[[3, 3, 0]], Label::Base));
    breaks("foundation-layer", samples::box_house(), set(&block([0, 0, 0], [9, 8, 1]), Label::Empty));
    breaks("plates-complete", samples::hip_house(), set(&[[2, 2, 6]], Label::Base));
    breaks("plates-complete", samples::box_house(), set(&[[2, 2, 3]], Label::Floor));
    breaks("undercut", samples::box_house(), set(&block([3, 3, 2], [6, 6, 4]), Label::Empty));
    breaks("sky", samples::box_house(), set(&block([3, 3, 2], [6, 6, 4]), Label::Empty));
    breaks("zones", samples::box_house(), |h| h.zones = vec![0; 3]);
    breaks("zones", samples::box_house(), |h| h.zones = vec![1; h.voxels.labels().len()]);
    let tower = samples::massing([5, 9, 20], &[&[[1, 1, 3, 7]], &[[1, 1, 3, 7]]], 0);
    let higher = samples::massing([5, 9, 20], &[&[[1, 1, 3, 7]], &[[1, 1, 3, 7]], &[[1, 1, 3, 7]]], 0);
    breaks("slenderness", tower, |h| *h = higher);
}

#[test]
fn plan_rules() {
    let ring = |inner: usize| {
        let mut house = samples::massing([14, 14, 8], &[&[[1, 1, 12, 12]]], 0);
        block([4, 4, 0], [4 + inner, 4 + inner, 8]).into_iter().for_each(|v| house.voxels.set(v, Label::Empty));
        house
    };
    breaks("courts", ring(4), |h| *h = ring(3));
    let plan = |rects: &[[usize; 4]]| samples::massing([14, 14, 8], &[rects], 0);
    breaks("plan-blocks", plan(&[[1, 1, 6, 6], [7, 1, 4, 3]]), |h| *h = plan(&[[1, 1, 6, 6], [7, 1, 4, 2]]));
    breaks("plan-rooms", plan(&[[1, 1, 12, 4]]), |h| *h = plan(&[[1, 1, 12, 3]]));
    let out = |cells: usize| samples::massing([14, 9, 14], &[&[[1, 1, 7, 7]], &[[1, 1, 7 + cells, 7]]], 0);
    breaks("cantilever", out(2), |h| *h = out(3));
    let narrow = |back: usize| samples::massing([14, 9, 14], &[&[[1, 1, back, 7]], &[[1, 1, back + 2, 7]]], 0);
    breaks("cantilever", narrow(4), |h| *h = narrow(3));
}

#[test]
fn height_rules() {
    breaks("clear-height-min", samples::box_house(), |h| {
        block([0, 0, 4], [9, 8, 8]).into_iter().for_each(|v| h.voxels.set(v, Label::Empty));
    });
    breaks("clear-height-max", samples::hip_house(), set(&[[5, 6, 6], [6, 6, 6]], Label::Base));
    let settings = RuleSettings { clear_height_min_m: 3.1, ..Default::default() };
    let low = rules::check(&samples::box_house(), &settings);
    assert!(low.iter().any(|v| v.rule == "clear-height-min" && v.amount == 42.0));
}

#[test]
fn stair_rules() {
    let moved = |start, run| move |h: &mut House| h.stairs[0] = Stair { start, run, ..h.stairs[0] };
    breaks("stair-inside", samples::hip_house(), moved([1, 3], Direction::East));
    breaks("stair-inside", samples::hip_house(), |h| h.stairs.push(h.stairs[0]));
    breaks("stair-inside", samples::hip_house(), |h| h.stairs[0].storey = 5);
    breaks("stair-void", samples::hip_house(), set(&[[4, 3, 6]], Label::Floor));
    breaks("stair-headroom", samples::hip_house(), set(&[[5, 4, 6]], Label::Floor));
    breaks("storeys-reached", samples::hip_house(), |h| h.stairs.clear());
    let wing = |start| {
        let l: &[[usize; 4]] = &[[1, 1, 14, 4], [1, 1, 9, 12]];
        let mut house = samples::massing([16, 14, 14], &[l, l], 0);
        samples::add_stair(&mut house, Stair { storey: 0, start, run: Direction::West, kind: StairKind::Straight });
        house
    };
    // Cell (9, 4) has its four neighbours in the plan, but the re-entrant corner (10, 5) diagonally outside.
    breaks("stair-width", wing([8, 3]), |h| *h = wing([8, 4]));
}

#[test]
fn opening_rules() {
    let door_off = block([2, 1, 1], [3, 2, 5]);
    breaks("entrance", samples::box_house(), set(&door_off, Label::Base));
    breaks("entrance", samples::box_house(), set(&[[2, 1, 4]], Label::Base));
    breaks("doors-per-storey", samples::box_house(), |h| {
        [[2, 6], [4, 6], [6, 6]].into_iter().for_each(|cell| samples::door(h, 0, cell));
    });
    breaks("doors-ground", samples::box_house(), set(&[[2, 1, 1]], Label::Base));
    breaks("doors-ground", samples::box_house(), set(&[[2, 0, 1]], Label::Base));
    breaks("decks", samples::deck_house(), |h| samples::door(h, 1, [6, 7]));
    breaks("opening-facade", samples::box_house(), set(&[[4, 4, 3]], Label::Window));
    breaks("opening-facade", samples::box_house(), set(&[[5, 2, 3]], Label::Window));
    breaks("opening-corner", samples::box_house(), set(&[[1, 1, 3]], Label::Window));
    breaks("opening-surround", samples::box_house(), set(&[[4, 1, 5]], Label::Opening));
    breaks("opening-surround", samples::box_house(), set(&block([7, 1, 3], [8, 2, 4]), Label::Window));
}

#[test]
fn glazing_rules() {
    let south = block([4, 1, 2], [7, 2, 5]);
    let east = block([7, 3, 2], [8, 5, 5]);
    breaks("glazing-orientations", samples::box_house(), set(&east, Label::Base));
    breaks("glazing-min", samples::box_house(), set(&south, Label::Base));
    breaks("glazing-max", samples::box_house(), |h| {
        samples::french_window(h, 0, Direction::North, [2, 6], 4);
        samples::window(h, 0, Direction::West, [1, 2], 4);
    });
    // A wall two modules before the south window takes its view: only the east window is left.
    let mut house = samples::massing([9, 12, 8], &[&[[1, 5, 7, 6]]], 0);
    samples::door(&mut house, 0, [2, 5]);
    samples::window(&mut house, 0, Direction::South, [4, 5], 3);
    samples::window(&mut house, 0, Direction::East, [7, 7], 2);
    breaks("glazing-orientations", house.clone(), set(&block([1, 2, 1], [8, 3, 6]), Label::Base));
    breaks("glazing-min", house, set(&block([1, 2, 1], [8, 3, 6]), Label::Base));
}

#[test]
fn roof_rules() {
    let ring = |gap: bool| {
        let mut house = samples::massing([12, 12, 10], &[&[[1, 1, 10, 10]]], 1);
        block([4, 4, 7], [8, 8, 8]).into_iter().for_each(|v| house.voxels.set(v, Label::Empty));
        if gap {
            block([4, 1, 7], [8, 4, 8]).into_iter().for_each(|v| house.voxels.set(v, Label::Empty));
        }
        house
    };
    breaks("roof-drain", ring(true), |h| *h = ring(false));
    breaks("roof-bump", samples::box_house(), set(&block([3, 3, 7], [5, 6, 8]), Label::Base));
    let mut wide = samples::box_house();
    block([3, 3, 7], [6, 6, 8]).into_iter().for_each(|v| wide.voxels.set(v, Label::Base));
    assert!(broken(&wide).is_empty(), "{:?}", broken(&wide));
    // A saddle roof ends in a ridge one module wide from verge to verge: the next step of its slopes. A wall is none, nor is
    // half a ridge.
    let mut saddle = samples::massing([13, 9, 12], &[&[[1, 1, 11, 7]]], 0);
    samples::door(&mut saddle, 0, [2, 1]);
    samples::window(&mut saddle, 0, Direction::South, [4, 1], 4);
    samples::window(&mut saddle, 0, Direction::East, [11, 3], 3);
    for i in 0..4 {
        block([1, 1 + i, 7 + i], [12, 8 - i, 8 + i]).into_iter().for_each(|v| saddle.voxels.set(v, Label::Base));
    }
    assert!(broken(&saddle).is_empty(), "{:?}", broken(&saddle));
    breaks("roof-bump", saddle.clone(), set(&block([1, 4, 10], [6, 5, 11]), Label::Empty));
    breaks("roof-bump", saddle, set(&block([1, 3, 9], [12, 4, 10]), Label::Empty));
}

#[test]
fn settings_reject_what_cannot_be_meant() {
    assert!(RuleSettings::default().validate().is_ok());
    let bad = |change: fn(&mut RuleSettings)| {
        let mut settings = RuleSettings::default();
        change(&mut settings);
        settings.validate().expect_err("must be refused").to_string()
    };
    assert!(bad(|s| s.view_m = -1.0).contains("view_m"));
    assert!(bad(|s| s.glazing_ratio_min = 0.5).contains("glazing_ratio_max"));
    assert!(bad(|s| s.off.push("roof-dran".into())).contains("roof-dran"));
    assert!(serde_json::from_str::<RuleSettings>(r#"{"doors": 3}"#).is_err());
    let one: RuleSettings = serde_json::from_str(r#"{"clear_height_min_m": 2.6}"#).expect("a partial override");
    assert_eq!(one, RuleSettings { clear_height_min_m: 2.6, ..Default::default() });
}

#[test]
fn ids_are_distinct_and_sentences_end() {
    for (i, rule) in rules::RULES.iter().enumerate() {
        assert!(rule.sentence.ends_with('.'), "{}", rule.id);
        assert!(rules::RULES[..i].iter().all(|r| r.id != rule.id));
    }
}

/// Houses with a few voxels changed at random: the sum for the search is exactly the sum of the list.
#[test]
fn the_fast_sum_equals_the_list() {
    let mut state = 1u64;
    let mut next = |n: usize| {
        state = state.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        (state >> 33) as usize % n
    };
    let mut scratch = Scratch::default();
    let settings = RuleSettings::default();
    let mut whole = 0;
    for round in 0..400 {
        let (_, mut house) = samples::all()[round % 4].clone();
        for _ in 0..next(4) {
            let voxel = house.voxels.shape().map(&mut next);
            house.voxels.set(voxel, Label::ALL[next(6)]);
        }
        if next(5) == 0 {
            house.stairs.iter_mut().for_each(|s| s.start = [next(9), next(9)]);
        }
        let fast = rules::violation(&house, &read_storeys(&house), &settings, &mut scratch);
        let list = rules::check(&house, &settings);
        assert_eq!(fast, list.iter().map(|v| v.amount).sum::<f64>(), "round {round}");
        whole += list.is_empty() as usize;
    }
    assert!((50..350).contains(&whole), "{whole} of 400 keep all rules");
}

/// Times reading and checking; run with `--nocapture` to see the numbers. The bounds hold in release builds.
#[test]
fn reading_and_checking_are_cheap() {
    let mut scratch = Scratch::default();
    let settings = RuleSettings::default();
    for (name, house) in samples::all() {
        let time = |work: &mut dyn FnMut()| {
            (0..50)
                .map(|_| {
                    let start = Instant::now();
                    (0..4).for_each(|_| work());
                    start.elapsed().as_secs_f64() / 4.0 * 1e6
                })
                .fold(f64::INFINITY, f64::min)
        };
        let read = time(&mut || drop(std::hint::black_box(read_storeys(&house))));
        let reading = read_storeys(&house);
        let check = time(&mut || {
            std::hint::black_box(rules::violation(&house, &reading, &settings, &mut scratch));
        });
        println!("{name} {:?}: read {read:.1} us, violation {check:.1} us", house.voxels.shape());
        if !cfg!(debug_assertions) {
            assert!(read < 60.0 && check < 200.0, "{name}: read {read:.1} us, violation {check:.1} us");
        }
    }
}
