//! `sizing.json`: how the sections of a house were chosen.

use serde_json::{Value, json};

use crate::score::{Evaluator, Sized, SizingGoal, SizingWalk};
use crate::structure::SizingStep;
use crate::voxels::Choice;

const GROUPS: [Choice; 4] = [Choice::Wall, Choice::Floor, Choice::Beam, Choice::Roof];

/// Goal, unit, what was chosen, and every analysis of every walk: joists along x and along y, with each kind of boards on offer.
pub fn sizing_json(sized: &Sized, goal: SizingGoal, evaluator: &Evaluator) -> Value {
    let options: serde_json::Map<String, Value> =
        GROUPS.iter().map(|&g| (g.name().to_owned(), json!(evaluator.options[g as usize].len()))).collect();
    json!({
        "schema": "houscaper.sizing/2",
        "goal": goal.name(),
        "unit": match goal {
            SizingGoal::Price => evaluator.books.prices.currency.as_str(),
            SizingGoal::Mass => "kg",
            SizingGoal::Carbon => "kgCO2e, fossil, A1-A3",
        },
        "basis": "frame: length of members x rate of a metre; boards: wall area x what the second side adds; net, default rates",
        "method": "all options are checked with the forces of the last analysis; each group takes the cheapest that holds; analysed again until nothing changes",
        "options": options,
        "wall_boards_offered": evaluator.brief.wall_boards,
        "taken": sized.taken,
        "walks": sized.walks.iter().map(|w| walk(w, evaluator)).collect::<Vec<_>>(),
    })
}

fn walk(walk: &SizingWalk, evaluator: &Evaluator) -> Value {
    let cents = |x: f64| (x * 100.0).round() / 100.0;
    let step = |s: &SizingStep| {
        let by_group = |value: &dyn Fn(usize) -> Value| -> Value {
            Value::Object(GROUPS.iter().map(|&g| (g.name().to_owned(), value(g as usize))).collect())
        };
        json!({
            "sections": by_group(&|g| json!(evaluator.catalogue.option_name(evaluator.options[g][s.bids[g]]))),
            "cost": cents(s.cost),
            "worst_ratio": by_group(&|g| json!((s.group_ratio[g] * 1e4).round() / 1e4)),
            "worst_of_racking_and_sway": (s.sheathing_ratio * 1e4).round() / 1e4,
            "ok": s.is_ok,
        })
    };
    json!({
        "joists": if walk.choices.joists_along_y(0) { "y" } else { "x" },
        "wall_boards": walk.boards,
        "boards_cost": cents(walk.boards_cost),
        "chosen": walk.sizing.best,
        "analyses": walk.sizing.steps.iter().map(step).collect::<Vec<_>>(),
    })
}
