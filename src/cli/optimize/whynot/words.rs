//! Why not, in words.

use houscaper::score::{Bound, Demand};
use houscaper::search::select::plain;
use serde_json::json;

use super::super::Job;
use super::super::faults::NEARLY;
use super::super::results::FrontHouse;
use super::{ACTIVE, NearHouse, RELAXED, Row, WhyNot, differences};

/// Lines for people: what is active along the front, what keeps houses out of it, and what asking for less would give.
pub fn words(job: &Job, why: &WhyNot, front: &[FrontHouse]) -> Vec<String> {
    let mut out = Vec::new();
    let mut active: Vec<&Row> = why.rows.iter().filter(|r| r.active > 0).collect();
    active.sort_by_key(|r| std::cmp::Reverse(r.active));
    let share = |r: &&Row| format!("{} in {} of {}", asked(&r.bound), r.active, front.len());
    if !active.is_empty() {
        let list: Vec<String> = active.iter().take(5).map(share).collect();
        out.push(format!("at its limit (within {:.0} %) along the front: {}", 100.0 * ACTIVE, list.join(", ")));
    }
    if why.near.is_empty() {
        return out;
    }
    let mut binding: Vec<&Row> = why.rows.iter().filter(|r| r.near > 0).collect();
    binding.sort_by_key(|r| std::cmp::Reverse(r.near));
    let list: Vec<String> =
        binding.iter().map(|r| format!("{} {} ({} of them nothing else)", r.bound.key, r.near, r.alone)).collect();
    out.push(format!(
        "{} houses would stand in the front but miss a constraint by at most {:.0} %: {}",
        why.near.len(),
        100.0 * NEARLY,
        list.join(", ")
    ));
    let gains = why.rows.iter().filter_map(|r| Some((r, r.gain?)));
    let mut gains: Vec<(&Row, [f64; 3])> = gains.filter(|(_, g)| g[2] > 0.0).collect();
    gains.sort_by(|a, b| b.1[2].total_cmp(&a.1[2]));
    for (row, gain) in gains.into_iter().take(3) {
        out.push(format!(
            "{} relaxed by {:.0} % would add at least {:.2} % hypervolume, from {} evaluated houses that miss nothing else{}",
            asked(&row.bound),
            100.0 * RELAXED[2],
            100.0 * gain[2],
            row.alone,
            example(job, why, &row.bound.key, front).map_or(String::new(), |e| format!("; {e}"))
        ));
    }
    out
}

/// The house that breaks only one constraint, and it least, beside the nearest one of the front.
fn example(job: &Job, why: &WhyNot, key: &str, front: &[FrontHouse]) -> Option<String> {
    let only = |h: &&NearHouse| matches!(h.broken()[..], [b] if b.key == key);
    let house = why.near.iter().find(only)?;
    let bound = house.broken().first().map(|b| (b.value, b.limit))?;
    let goals = job.evaluator.brief.objectives.iter().zip(differences(job, house, front));
    let list: Vec<String> = goals.map(|(g, d)| format!("{} {d:+.1} %", plain(g.objective.name()))).collect();
    let other = front[house.beside?].id;
    let [value, limit] = [bound.0, bound.1].map(digits);
    Some(format!("house {} ({value} for {limit}) against house {other}: {}", house.id, list.join(", ")))
}

/// A constraint with its limit; those of the structure have all the same.
fn asked(bound: &Bound) -> String {
    match bound.demand {
        Demand::Law => bound.key.clone(),
        Demand::Brief => {
            format!("{} {} {}", bound.key, if bound.is_max { "at most" } else { "at least" }, digits(bound.limit))
        }
    }
}

/// A number with at most five digits.
fn digits(value: f64) -> String {
    let decimals = (4 - value.abs().max(1.0).log10().floor() as i32).clamp(0, 4) as usize;
    let text = format!("{value:.decimals$}");
    if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.').to_owned() } else { text }
}

/// Why nothing was feasible: how many houses of the sample keep each constraint that any of them breaks.
pub fn infeasible_words(why: &WhyNot) -> Vec<String> {
    let mut broken: Vec<&Row> = why.rows.iter().filter(|r| r.broken > 0).collect();
    broken.sort_by_key(|r| std::cmp::Reverse(r.broken));
    let one = |r: &Row| {
        let miss = 100.0 * r.least_miss;
        let kept = why.sampled - r.broken;
        match kept {
            0 => format!("{}: no house keeps it, the nearest misses it by {miss:.1} %", r.bound.key),
            kept => format!("{}: {kept} of {} keep it", r.bound.key, why.sampled),
        }
    };
    broken.into_iter().map(one).collect()
}

/// For `--json`.
pub fn report(why: &WhyNot) -> serde_json::Value {
    let row = |r: &Row| {
        json!({
            "constraint": r.bound.key,
            "limit": r.bound.limit,
            "sampled_broken": r.broken,
            "near_broken": r.near,
            "near_broken_alone": r.alone,
            "relaxed_10_percent_gains": r.gain.map(|g| g[2]),
            "front_at_limit": r.active,
        })
    };
    json!({
        "infeasible": why.infeasible,
        "sampled": why.sampled,
        "near": why.near.len(),
        "constraints": why.rows.iter().map(row).collect::<Vec<_>>(),
    })
}
