//! What `improve` says of a neighbour: every figure before and after, in files, as a table, as JSON.

use houscaper::brief::Objective;
use houscaper::export::tables::{Cell, csv};
use serde_json::{Value, json};

use super::{Figures, Found, Neighbour};

/// Figures of the table for people, with their short heads and digits.
const SHOWN: [(Objective, &str, usize); 6] = [
    (Objective::PriceEur, "price EUR", 0),
    (Objective::GwpKgco2e, "kgCO2e", 0),
    (Objective::Utilisation, "utilisation", 2),
    (Objective::SwayRatio, "sway", 2),
    (Objective::DeflectionRatio, "deflection", 2),
    (Objective::FloorAreaM2, "floor m2", 1),
];

/// Difference and its share of the value before; `None` where a value is not known.
fn difference(before: f64, after: f64) -> (Option<f64>, Option<f64>) {
    let difference = (before.is_finite() && after.is_finite()).then_some(after - before);
    (difference, difference.filter(|_| before != 0.0).map(|d| 100.0 * d / before.abs()))
}

/// `improve.csv`: a row for each figure of each neighbour.
pub fn table(found: &Found) -> String {
    let mut rows: Vec<Vec<Cell>> = Vec::new();
    for (n, neighbour) in found.neighbours.iter().enumerate() {
        let mut row = |name: &str, before: f64, after: f64| {
            let (absolute, percent) = difference(before, after);
            let cell = |v: Option<f64>| v.map_or(Cell::Empty, Cell::Number);
            rows.push(vec![
                Cell::Count(n as i64 + 1),
                Cell::from(name),
                Cell::from(before),
                Cell::from(after),
                cell(absolute),
                cell(percent),
            ]);
        };
        row("voxels_changed", 0.0, neighbour.changes.len() as f64);
        row("choices_changed", 0.0, neighbour.choices as f64);
        row("violation", found.before.violation, neighbour.figures.violation);
        for objective in Objective::ALL {
            row(objective.name(), found.before.value(objective), neighbour.figures.value(objective));
        }
    }
    csv(&["neighbour", "figure", "before", "after", "difference", "percent"], rows)
}

/// The voxels that a neighbour changes, one row each.
pub fn changes(neighbour: &Neighbour) -> String {
    let row = |&([x, y, z], before, after): &([usize; 3], houscaper::voxels::Label, houscaper::voxels::Label)| {
        let mut cells: Vec<Cell> = [x, y, z].map(|c| Cell::Count(c as i64)).to_vec();
        cells.extend([Cell::from(before.name()), Cell::from(after.name())]);
        cells
    };
    csv(&["x", "y", "z", "before", "after"], neighbour.changes.iter().map(row))
}

/// `improve.json`, which `--json` prints too.
pub fn json(found: &Found) -> Value {
    let figure = |before: f64, after: f64| {
        let (difference, percent) = difference(before, after);
        json!({"before": known(before), "after": known(after), "difference": difference, "percent": percent})
    };
    let neighbours: Vec<Value> = found
        .neighbours
        .iter()
        .enumerate()
        .map(|(n, neighbour)| {
            let figures: serde_json::Map<String, Value> = Objective::ALL
                .into_iter()
                .map(|o| (o.name().to_owned(), figure(found.before.value(o), neighbour.figures.value(o))))
                .collect();
            json!({
                "folder": (n + 1).to_string(),
                "better": neighbour.better,
                "operator": neighbour.operator,
                "voxels_changed": neighbour.changes.len(),
                "choices_changed": neighbour.choices,
                "figures": figures,
            })
        })
        .collect();
    json!({
        "schema": "houscaper.improve/1",
        "house": found.name,
        "brief": found.brief,
        "aim": found.aim,
        "seed": found.seed,
        "evaluations": found.evaluations,
        "locked_voxels": found.locked,
        "floor_area_least_m2": known(found.least_m2),
        "before": {"feasible": found.before.violation <= 0.0, "violation": known(found.before.violation), "figures": all(&found.before)},
        "neighbours": neighbours,
    })
}

fn all(figures: &Figures) -> serde_json::Map<String, Value> {
    Objective::ALL.into_iter().map(|o| (o.name().to_owned(), known(figures.value(o)))).collect()
}

fn known(value: f64) -> Value {
    if value.is_finite() { json!(value) } else { Value::Null }
}

/// The table for people.
pub fn lines(found: &Found) -> Vec<String> {
    let number = |value: f64, digits: usize| match value.is_finite() {
        true => format!("{value:.digits$}"),
        false => "-".to_owned(),
    };
    let mut head = format!("{:<28}{:>8}", "", "voxels");
    SHOWN.iter().for_each(|(_, title, _)| head += &format!("{title:>20}"));
    let mut before = format!("{:<28}{:>8}", "as it is", "");
    SHOWN.iter().for_each(|(o, _, digits)| before += &format!("{:>20}", number(found.before.value(*o), *digits)));
    let mut out = vec![head, before];
    for (n, neighbour) in found.neighbours.iter().enumerate() {
        let mut line =
            format!("{:<28}{:>8}", format!("{} {}", n + 1, neighbour.better.join(", ")), neighbour.changes.len());
        for (objective, _, digits) in SHOWN {
            let after = neighbour.figures.value(objective);
            let percent = difference(found.before.value(objective), after).1;
            let share = percent.map_or(String::new(), |p| format!(" ({p:+.1} %)"));
            line += &format!("{:>20}", number(after, digits) + &share);
        }
        out.push(line);
    }
    out
}
