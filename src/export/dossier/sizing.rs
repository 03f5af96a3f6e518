//! `sizing.json`: how the sections of a house were chosen.

use serde_json::{Value, json};

use crate::score::{Evaluator, Sized, SizingGoal};
use crate::structure::Sizing;
use crate::voxels::Choice;

const GROUPS: [Choice; 4] = [Choice::Wall, Choice::Floor, Choice::Beam, Choice::Roof];

/// Goal, unit, what was chosen, and every analysis of both walks: joists as chosen, and the other way.
pub fn sizing_json(sized: &Sized, goal: SizingGoal, evaluator: &Evaluator) -> Value {
    let options: serde_json::Map<String, Value> =
        GROUPS.iter().map(|&g| (g.name().to_owned(), json!(evaluator.options[g as usize].len()))).collect();
    let is_y = sized.choices.joists_along_y(0);
    let axis = |is_y: bool| if is_y { "y" } else { "x" };
    json!({
        "schema": "houscaper.sizing/1",
        "goal": goal.name(),
        "unit": match goal {
            SizingGoal::Price => evaluator.books.prices.currency.as_str(),
            SizingGoal::Mass => "kg",
            SizingGoal::Carbon => "kgCO2e, fossil, A1-A3",
        },
        "basis": "frame alone: length of members x rate of a metre, net, default rates",
        "method": "all options are checked with the forces of the last analysis; each group takes the cheapest that holds; analysed again until nothing changes",
        "options": options,
        "joists": axis(is_y),
        "chosen": sized.sizing.best,
        "analyses": walk(&sized.sizing, evaluator),
        "analyses_with_joists_the_other_way": walk(&sized.other, evaluator),
    })
}

fn walk(sizing: &Sizing, evaluator: &Evaluator) -> Vec<Value> {
    let step = |s: &crate::structure::SizingStep| {
        let by_group = |value: &dyn Fn(usize) -> Value| -> Value {
            Value::Object(GROUPS.iter().map(|&g| (g.name().to_owned(), value(g as usize))).collect())
        };
        json!({
            "sections": by_group(&|g| json!(evaluator.catalogue.option_name(evaluator.options[g][s.bids[g]]))),
            "cost": (s.cost * 100.0).round() / 100.0,
            "worst_ratio": by_group(&|g| json!((s.group_ratio[g] * 1e4).round() / 1e4)),
            "worst_of_racking_and_sway": (s.sheathing_ratio * 1e4).round() / 1e4,
            "ok": s.is_ok,
        })
    };
    sizing.steps.iter().map(step).collect()
}
