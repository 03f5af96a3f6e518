//! Why not, as tables.

use houscaper::export::tables::{Cell, csv};
use houscaper::run::RunFolder;
use houscaper::score::{Bound, Demand};

use super::super::Job;
use super::super::record::natural;
use super::super::results::FrontHouse;
use super::{NearHouse, Row, WhyNot, differences};
use crate::cli::failure::{Blame, Failure};

/// Writes `whynot.csv`, a row per constraint, and `whynot_houses.csv`, a row per house that nearly stands in the front.
pub fn write(job: &Job, why: &WhyNot, front: &[FrontHouse], folder: &RunFolder) -> Result<(), Failure> {
    folder.write("whynot.csv", constraints_csv(why, front).as_bytes()).run()?;
    folder.write("whynot_houses.csv", houses_csv(job, why, front).as_bytes()).run()
}

fn constraints_csv(why: &WhyNot, front: &[FrontHouse]) -> String {
    let header = [
        "constraint",
        "asked_by",
        "side",
        "limit",
        "sampled",
        "sampled_broken",
        "sampled_least_miss_percent",
        "near",
        "near_broken",
        "near_broken_alone",
        "relaxed_1_percent_gains_percent",
        "relaxed_5_percent_gains_percent",
        "relaxed_10_percent_gains_percent",
        "front",
        "front_within_2_percent",
        "front_least_room_percent",
    ];
    let row = |r: &Row| {
        let gain = |n: usize| r.gain.map_or(Cell::Empty, |g| Cell::Number(100.0 * g[n]));
        vec![
            Cell::Text(r.bound.key.clone()),
            Cell::from(if r.bound.demand == Demand::Brief { "brief" } else { "law" }),
            Cell::from(if r.bound.is_max { "at most" } else { "at least" }),
            Cell::Number(r.bound.limit),
            Cell::Count(why.sampled as i64),
            Cell::Count(r.broken as i64),
            Cell::Number(100.0 * r.least_miss),
            Cell::Count(why.near.len() as i64),
            Cell::Count(r.near as i64),
            Cell::Count(r.alone as i64),
            gain(0),
            gain(1),
            gain(2),
            Cell::Count(front.len() as i64),
            Cell::Count(r.active as i64),
            Cell::Number(100.0 * r.room),
        ]
    };
    csv(&header, why.rows.iter().map(row))
}

fn houses_csv(job: &Job, why: &WhyNot, front: &[FrontHouse]) -> String {
    let goals = &job.evaluator.brief.objectives;
    let against: Vec<String> = goals.iter().map(|g| format!("{}_against_percent", g.objective.name())).collect();
    let mut header = vec!["id", "violation", "broken", "binding", "limit", "value", "miss_percent"];
    header.extend(goals.iter().map(|g| g.objective.name()));
    header.push("nearest_in_front");
    header.extend(against.iter().map(String::as_str));
    let row = |h: &NearHouse| {
        let broken = h.broken();
        let binding = broken.first();
        let number = |of: &dyn Fn(&Bound) -> f64| binding.map_or(Cell::Empty, |b| Cell::Number(of(b)));
        let mut cells = vec![
            Cell::Count(h.id as i64),
            Cell::Number(h.evaluation.violation),
            Cell::Count(broken.len() as i64),
            binding.map_or(Cell::Empty, |b| Cell::Text(b.key.clone())),
            number(&|b| b.limit),
            number(&|b| b.value),
            number(&|b| 100.0 * b.violation),
        ];
        cells.extend(natural(job, &h.objectives).into_iter().map(Cell::Number));
        cells.push(h.beside.map_or(Cell::Empty, |f| Cell::Count(front[f].id as i64)));
        cells.extend(differences(job, h, front).into_iter().map(Cell::Number));
        cells
    };
    csv(&header, why.near.iter().map(row))
}
