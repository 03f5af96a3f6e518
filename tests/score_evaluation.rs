//! The evaluation as a function: pure, equal for equal houses, constraints measured, everything minimised.

#[path = "common/runs.rs"]
mod runs;

use std::collections::BTreeSet;

use houscaper::brief::{Constraint, Goal, Objective, Sense};
use houscaper::frame::Area;
use houscaper::quantities::Item;
use houscaper::score::{Evaluation, Evaluator, SizingGoal};
use houscaper::search::massing::encode;
use houscaper::search::{from_brief, start::start};
use houscaper::structure::{FREE_FALL_M_S2, Verdict};
use houscaper::voxels::{Boards, Choice, Choices, House, Label, samples};
use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;
use rayon::prelude::*;

fn evaluator() -> Evaluator {
    runs::evaluator(&runs::repository().join("configs/starter.json"))
}

/// Houses of the starter brief, as the search starts from them.
fn houses(evaluator: &Evaluator, count: u64) -> Vec<(House, Choices)> {
    let options = [0, 1, 2, 3].map(|g| evaluator.options[g].len());
    let space = from_brief::space(&evaluator.brief, None, &evaluator.rules, options).expect("a space");
    let draw = |seed| {
        let design = start(&space, &mut ChaCha8Rng::seed_from_u64(seed)).expect("a house");
        (encode(&design.massing, &space.plot), design.choices)
    };
    (0..count).map(draw).collect()
}

/// Everything an evaluation says; Debug writes every digit, and NaN equals itself.
fn words(evaluation: &Evaluation) -> String {
    format!("{evaluation:?}")
}

#[test]
fn the_same_house_is_the_same_evaluation_in_any_order() {
    let evaluator = evaluator();
    let houses = houses(&evaluator, 24);
    // A fresh evaluator each: no workspace was used before.
    let alone: Vec<String> =
        houses.iter().map(|(house, choices)| words(&self::evaluator().evaluate(house, choices))).collect();
    let forwards: Vec<String> = houses.iter().map(|(h, c)| words(&evaluator.evaluate(h, c))).collect();
    let mut backwards: Vec<String> = houses.iter().rev().map(|(h, c)| words(&evaluator.evaluate(h, c))).collect();
    backwards.reverse();
    let parallel: Vec<String> = houses.par_iter().map(|(h, c)| words(&evaluator.evaluate(h, c))).collect();
    assert_eq!(alone, forwards);
    assert_eq!(alone, backwards);
    assert_eq!(alone, parallel);
    assert!(alone.iter().collect::<BTreeSet<_>>().len() > 20, "different houses differ");
}

#[test]
fn details_say_the_same_objectives() {
    let evaluator = evaluator();
    for (house, choices) in houses(&evaluator, 6) {
        let (quick, full) = (evaluator.evaluate(&house, &choices), evaluator.details(&house, &choices));
        assert_eq!(format!("{:?}", quick.values), format!("{:?}", full.evaluation.values));
        assert_eq!(quick.violation, full.evaluation.violation);
    }
}

/// Cubes by their eight labels, one by one over the padded array.
fn distinct_by_sets(house: &House) -> usize {
    let [nx, ny, nz] = house.voxels.shape().map(|n| n as isize);
    let mut kinds = BTreeSet::new();
    for (z, y, x) in (-1..nz).flat_map(|z| (-1..ny).flat_map(move |y| (-1..nx).map(move |x| (z, y, x)))) {
        let corner = |j: isize| house.voxels.at([x + (j & 1), y + (j >> 1 & 1), z + (j >> 2)]);
        let labels: Vec<Label> = (0..8).map(corner).collect();
        let filled = labels.iter().filter(|l| l.is_filled()).count();
        if filled != 0 && filled != 8 {
            kinds.insert(labels.iter().map(|l| *l as u8).collect::<Vec<u8>>());
        }
    }
    kinds.len()
}

#[test]
fn distinct_tiles_are_the_distinct_label_patterns_on_the_surface() {
    let evaluator = evaluator();
    let samples = samples::all().into_iter().map(|(_, house)| (house, Choices::default()));
    for (house, choices) in samples.chain(houses(&evaluator, 8)) {
        let found = evaluator.details(&house, &choices).evaluation.values.get(Objective::DistinctTiles);
        assert_eq!(found, distinct_by_sets(&house) as f64);
    }
}

#[test]
fn objectives_to_be_maximised_are_negated() {
    let evaluator = evaluator();
    let goals = [
        Goal { objective: Objective::FloorAreaM2, sense: Sense::Max },
        Goal { objective: Objective::FloorAreaM2, sense: Sense::Min },
        Goal { objective: Objective::PriceEur, sense: Sense::Min },
    ];
    let (house, choices) = &houses(&evaluator, 1)[0];
    let evaluation = evaluator.evaluate(house, choices);
    let [area, price] = [Objective::FloorAreaM2, Objective::PriceEur].map(|o| evaluation.values.get(o));
    assert!(area > 0.0 && price > 0.0);
    assert_eq!(evaluation.minimised(&goals), [-area, area, price]);
}

#[test]
fn a_broken_rule_is_worse_than_any_other_fault_and_is_not_analysed() {
    let evaluator = evaluator();
    let (mut house, choices) = houses(&evaluator, 1).swap_remove(0);
    let sound = evaluator.evaluate(&house, &choices);
    assert!(sound.rules == 0.0 && sound.violation < 1000.0 && sound.assessment.is_some());
    let [nx, ny, nz] = house.voxels.shape();
    house.voxels.set([nx - 1, ny - 1, nz - 1], Label::Base);
    let floating = evaluator.evaluate(&house, &choices);
    assert!(floating.rules > 0.0 && floating.violation > 1000.0, "{}", floating.violation);
    assert!(floating.assessment.is_none() && floating.minimised(&evaluator.brief.objectives).is_empty());
}

/// Houses that keep programme and structure: a limit alone adds how far it is missed, relative to itself.
#[test]
fn limits_add_their_relative_excess() {
    let mut evaluator = evaluator();
    evaluator.limits.clear();
    let houses = houses(&evaluator, 40);
    let feasible = houses.iter().find(|(h, c)| evaluator.evaluate(h, c).is_feasible());
    let (house, choices) = feasible.expect("one start in forty is feasible");
    let price = evaluator.evaluate(house, choices).values.get(Objective::PriceEur);
    for (limit, is_max, expected) in
        [(0.8 * price, true, 0.25), (price + 1.0, true, 0.0), (2.0 * price, false, 0.5), (price - 1.0, false, 0.0)]
    {
        let constraint = Constraint { objective: Objective::PriceEur, is_max, limit };
        evaluator.limits = vec![constraint];
        let found = evaluator.evaluate(house, choices);
        assert!((found.violation - expected).abs() < 1e-9, "{limit} {is_max}: {}", found.violation);
        assert_eq!(found.is_feasible(), expected == 0.0);
    }
}

/// Without limits and with the programme met, what is left is the structure's excess over 1, ratio by ratio.
#[test]
fn the_structure_adds_what_it_lacks() {
    let mut evaluator = evaluator();
    evaluator.limits.clear();
    let mut seen = [0; 2];
    for (house, choices) in houses(&evaluator, 60) {
        let evaluation = evaluator.evaluate(&house, &choices);
        let assessment = evaluation.assessment.as_ref().expect("rules are kept");
        let ratios =
            [assessment.utilisation, assessment.sway_ratio, assessment.deflection_ratio, assessment.vibration_ratio()];
        let excess: f64 = ratios.iter().map(|r| (r - 1.0).max(0.0)).sum();
        let expected = match &assessment.verdict {
            Verdict::Unstable { nodes } => 1.0 + nodes.len() as f64,
            _ => excess,
        };
        assert!((evaluation.violation - evaluation.shortfall.total() - expected).abs() < 1e-9);
        assert_eq!(matches!(assessment.verdict, Verdict::Ok), expected == 0.0, "{:?}", assessment.verdict);
        seen[usize::from(expected > 0.0)] += 1;
    }
    assert!(seen[0] > 0 && seen[1] > 0, "both kinds occur: {seen:?}");
}

/// The second side of boards: price by the difference of the wall's rates, the same frame, the wall's weight in the loads to the last
/// newton, half the shear in each wall of boards or near it, and a smaller drift.
#[test]
fn boards_on_both_sides_cost_weigh_and_brace() {
    let evaluator = evaluator();
    let (_, house) = samples::all().into_iter().find(|(name, _)| *name == "hip").expect("a sample");
    let one = evaluator.size(&house, SizingGoal::Price).expect("it stands").choices();
    let mut both = one;
    both.0[Choice::Boards as usize] = 1;
    assert_eq!([&one, &both].map(|c| evaluator.boards(c)), [Boards::OneSide, Boards::BothSides]);
    let [a, b] = [&one, &both].map(|choices| evaluator.details(&house, choices).evaluation);
    let wall_m2 = a.takeoff.as_ref().expect("a take-off").measured()[Item::Wall as usize];
    let moved = b.takeoff.as_ref().expect("a take-off").measured();
    assert!(wall_m2 > 50.0 && moved[Item::Wall as usize] == 0.0);
    assert!((moved[Item::WallBothSides as usize] - wall_m2).abs() < 1e-12);
    let rate = |item: Item| evaluator.rates.rows[item as usize];
    let [less, more] = [Item::Wall, Item::WallBothSides].map(rate);
    let differs = |o: Objective, per_m2: f64| {
        let found = b.values.get(o) - a.values.get(o);
        assert!((found - per_m2 * wall_m2).abs() < 1e-6 * a.values.get(o).abs(), "{}: {found}", o.name());
    };
    // The hours of factory work that repeat go faster; everything else of the difference is materials.
    let works = a.takeoff.as_ref().expect("a take-off").works();
    let practised = works.repeated_m2.iter().enumerate();
    let left = practised.map(|(n, m2)| m2 * evaluator.rates.works.average(n + 1)[1]).sum::<f64>() / works.area_m2();
    assert!(left > 0.5 && left < 1.0 && more.site_h == less.site_h);
    let labour = (more.factory_h - less.factory_h) * evaluator.rates.works.labour[1] * left;
    differs(Objective::PriceEur, (more.material[1] - less.material[1] + labour) * evaluator.rates.in_place[1]);
    differs(Objective::MassKg, more.mass_kg - less.mass_kg);
    differs(Objective::GwpKgco2e, more.gwp[1] - less.gwp[1]);
    differs(Objective::HeatLossWPerK, more.u_w_m2k - less.u_w_m2k);
    differs(Objective::FrameMassKg, 0.0);
    let [a, b] = [a, b].map(|e| e.assessment.expect("analysed"));
    assert!(b.racking_ratio < 0.7 * a.racking_ratio && b.sway_ratio < a.sway_ratio);
    // The frame carries the walls by its own areas; what they gain is that area's.
    let permanent = |boards: &Choices| {
        let frame = evaluator.details(&house, boards).frame.expect("a frame");
        let wall_m2: f64 = frame.areas.iter().filter(|a| matches!(a.area, Area::Wall(_))).map(|a| a.area_m2).sum();
        (wall_m2, frame.boards)
    };
    assert_eq!(permanent(&both).1, Boards::BothSides);
    let gained = permanent(&both).0 * (more.mass_kg - less.mass_kg) * FREE_FALL_M_S2;
    let found = b.vertical_n[0] - a.vertical_n[0];
    assert!((found - gained).abs() < 1e-6 * gained, "{found} N, by hand {gained} N");
}

/// A house with other sections, drawn from the brief's options: what most cheap moves of the search change.
fn with_other_sections(evaluator: &Evaluator, choices: &Choices, seed: u64) -> Choices {
    let mut out = *choices;
    for (group, step) in [Choice::Wall, Choice::Floor, Choice::Beam, Choice::Roof].into_iter().zip([1, 3, 2, 5]) {
        let options = evaluator.options[group as usize].len() as u64;
        out.0[group as usize] = ((u64::from(out.0[group as usize]) + seed * step) % options) as u16;
    }
    out
}

#[test]
fn bounds_without_a_solve_are_the_objectives_themselves_and_change_no_evaluation() {
    let (asked_before, fresh) = (evaluator(), evaluator());
    let mut compared = 0;
    for (seed, (house, choices)) in houses(&fresh, 12).into_iter().enumerate() {
        for variant in 0..3 {
            let choices = with_other_sections(&fresh, &choices, seed as u64 * variant);
            // The carcass is shared by the three variants, and each is asked for twice.
            for answer in [true, false] {
                let seen = std::cell::RefCell::new(Vec::new());
                let note = |bounds: &[f64]| {
                    *seen.borrow_mut() = bounds.to_vec();
                    answer
                };
                let is_beaten = asked_before.is_beaten(&house, &choices, &note);
                let evaluation = fresh.details(&house, &choices).evaluation;
                let whole = asked_before.evaluate(&house, &choices);
                // Details are made from nothing.
                assert_eq!(format!("{:?}", whole.values), format!("{:?}", evaluation.values));
                assert_eq!(whole.violation.to_bits(), evaluation.violation.to_bits());
                if whole.rules > 0.0 {
                    assert!(!is_beaten, "a house that breaks rules has no bounds");
                    continue;
                }
                assert_eq!(is_beaten, answer);
                let objectives = fresh.brief.objectives.iter().map(|g| g.minimised(evaluation.values.get(g.objective)));
                assert_eq!(*seen.borrow(), objectives.collect::<Vec<_>>(), "to the last bit");
                compared += 1;
            }
        }
    }
    assert!(compared > 40, "{compared}");
}

/// The constraints one by one sum to the violation, of houses that keep all, that miss something, and that break a rule; the room of a
/// kept one is what is left to its limit.
#[test]
fn bounds_sum_to_the_violation() {
    let mut evaluator = evaluator();
    // Drawn for the shipped brief: many miss what is asked from here on.
    let drawn = houses(&evaluator, 60);
    evaluator.limits.push(Constraint { objective: Objective::PriceEur, is_max: true, limit: 90_000.0 });
    evaluator.limits.push(Constraint { objective: Objective::GlazingRatio, is_max: false, limit: 0.2 });
    evaluator.brief.programme.floor_area_m2 = [55.0, 70.0];
    evaluator.brief.programme.entrances_min = 2;
    let mut seen = BTreeSet::new();
    let mut keys: Option<Vec<String>> = None;
    for (house, choices) in &drawn {
        let evaluation = evaluator.evaluate(house, choices);
        let bounds = evaluator.bounds(house, choices, &evaluation);
        let sum: f64 = bounds.iter().map(|b| b.violation).sum();
        assert!(
            (sum - evaluation.violation).abs() < 1e-9 * evaluation.violation.max(1.0),
            "{sum} {}",
            evaluation.violation
        );
        // A plan too narrow for the least rise keeps it all the same.
        for b in bounds.iter().filter(|b| b.key != "programme.roof_rise[0]") {
            let beyond = if b.is_max { b.value - b.limit } else { b.limit - b.value };
            if !b.value.is_nan() {
                assert_eq!(b.violation > 0.0, beyond > 0.0, "{b:?}");
            }
            if b.violation > 0.0 {
                seen.insert(b.key.clone());
                assert_eq!(b.room(), 0.0);
            } else if b.value.is_finite() {
                assert!((b.room() * b.limit.abs().max(1e-9) + beyond).abs() < 1e-9, "{b:?}");
            }
        }
        let found: Vec<String> = bounds.into_iter().map(|b| b.key).collect();
        assert_eq!(keys.get_or_insert_with(|| found.clone()), &found, "the same constraints for every house");
    }
    for key in
        ["programme.floor_area_m2[1]", "programme.entrances_min", "constraints.price_eur_max", "structure.sway_ratio"]
    {
        assert!(seen.contains(key), "{key} is broken by none of {seen:?}");
    }
    let (mut house, choices) = drawn[0].clone();
    let [nx, ny, nz] = house.voxels.shape();
    house.voxels.set([nx - 1, ny - 1, nz - 1], Label::Base);
    let evaluation = evaluator.evaluate(&house, &choices);
    let broken: Vec<_> =
        evaluator.bounds(&house, &choices, &evaluation).into_iter().filter(|b| b.violation > 0.0).collect();
    assert_eq!(broken.len(), 1);
    assert_eq!((broken[0].key.as_str(), broken[0].violation), ("rules", evaluation.violation));
}
