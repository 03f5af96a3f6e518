//! Sizing against exhaustive search, and what it promises of every sample house.

#[path = "common/runs.rs"]
mod runs;

use houscaper::score::{Evaluator, SizingGoal};
use houscaper::structure::Verdict;
use houscaper::voxels::{Choice, Choices, House, samples};

fn evaluator() -> Evaluator {
    runs::evaluator(&runs::repository().join("configs/starter.json"))
}

fn frame_cost(evaluator: &Evaluator, house: &House, choices: &Choices) -> Option<f64> {
    let details = evaluator.details(house, choices);
    let assessment = details.evaluation.assessment.as_ref()?;
    let ok = assessment.verdict == Verdict::Ok;
    ok.then_some(assessment.frame_mass_kg)
}

/// Every combination of a few sections a group, analysed one by one: none that passes is lighter than what sizing chose. Bound: a
/// walk that looks at one group at a time may stop up to 3 % above the best of all, and says so here.
#[test]
fn sizing_finds_what_exhaustive_search_finds() {
    let mut evaluator = evaluator();
    for (g, options) in evaluator.options.iter_mut().enumerate() {
        let every = if g == Choice::Roof as usize { 12 } else { 6 };
        *options = options.iter().copied().step_by(every).collect();
    }
    for (name, house) in samples::all().into_iter().filter(|(n, _)| ["box", "hip"].contains(n)) {
        let sized = evaluator.size(&house, SizingGoal::Mass).expect("it stands");
        let found = sized.walk().sizing.result().expect("it is analysed");
        let lengths = evaluator.options.each_ref().map(Vec::len);
        let mut best = f64::INFINITY;
        for n in 0..lengths.iter().product::<usize>() {
            let mut rest = n;
            let mut choices = sized.choices();
            for (g, &length) in lengths.iter().enumerate() {
                choices.0[g] = (rest % length) as u16;
                rest /= length;
            }
            best = best.min(frame_cost(&evaluator, &house, &choices).unwrap_or(f64::INFINITY));
        }
        assert_eq!(found.is_ok, best.is_finite(), "{name}");
        if found.is_ok {
            assert!(
                found.cost <= 1.03 * best && found.cost >= best - 1e-6,
                "{name}: {} kg, best {best} kg",
                found.cost
            );
        }
    }
}

#[test]
fn what_is_chosen_is_what_was_analysed() {
    let evaluator = evaluator();
    for (name, house) in samples::all().into_iter().take(4) {
        for goal in [SizingGoal::Price, SizingGoal::Mass, SizingGoal::Carbon] {
            let sized = evaluator.size(&house, goal).expect("samples stand");
            let step = sized.walk().sizing.result().expect("samples are analysed");
            let again = evaluator.details(&house, &sized.choices()).evaluation.assessment.expect("analysed");
            assert_eq!(step.is_ok, again.verdict == Verdict::Ok, "{name}");
            if goal == SizingGoal::Mass {
                assert!((step.cost - again.frame_mass_kg).abs() < 1e-6 * step.cost, "{name}");
            }
            // No other step of any walk passes at less cost, boards included.
            for walk in &sized.walks {
                let passes = walk.sizing.steps.iter().filter(|s| s.is_ok);
                let least = passes.map(|s| s.cost + walk.boards_cost).fold(f64::INFINITY, f64::min);
                assert!(step.is_ok && least >= sized.walk().cost() - 1e-9, "{name}");
            }
            assert_eq!(sized, evaluator.size(&house, goal).expect("twice the same"), "{name}");
        }
    }
}
