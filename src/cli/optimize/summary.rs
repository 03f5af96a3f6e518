//! What a person reads at the end of a run.

use houscaper::brief::Objective;
use houscaper::export::dossier::MISSING_FILE;
use houscaper::run::RunFolder;
use houscaper::score::{Evaluation, Shortfall};
use houscaper::search::knee::{Knee, knees};
use houscaper::search::massing::encode;
use houscaper::search::run::Stop;
use houscaper::search::select::{Named, knee_sentence};
use houscaper::structure::{Assessment, Verdict};
use serde_json::json;

use super::chances::Chances;
use super::record::Record;
use super::results::{FrontHouse, Written, caption, choice_words};
use super::{Found, Job, sensitivity, whynot};
use crate::cli::failure::{Blame, Failure};
use crate::cli::output::say;

/// Share of the draws from which on an order is called sure.
const SURE: f64 = 0.95;

/// Prints the named houses with their reasons and where things are.
pub fn print(job: &Job, found: &Found, written: &Written, record: &Record, json: bool) -> anyhow::Result<()> {
    let p = &found.progress;
    eprintln!(
        "{} evaluations in {:.1} s ({:.0} a second){}, {} feasible, front of {} houses{}",
        p.evaluations,
        record.search_seconds,
        p.rate(),
        match record.screened {
            0 => String::new(),
            screened => format!(", {screened} more houses ruled out before their solve"),
        },
        p.feasible,
        written.front.len(),
        match found.stop {
            Stop::Done => "",
            Stop::Interrupted => "; stopped before its end: `houscaper resume` carries on",
            Stop::Stagnated => "; nothing better was found for long",
            Stop::Exhausted => "; no new house could be found",
        }
    );
    if let Some(measured_by) = job.evaluator.tiling.measured_by() {
        eprintln!("tileset: {measured_by}");
        for [house, cubes] in without_tile(job, written) {
            eprintln!(
                "tileset: house {house} has {cubes} cubes without a tile, which stay empty; its {MISSING_FILE} lists them"
            );
        }
    }
    if json {
        say!("{}", serde_json::to_string_pretty(&report(job, found, written))?);
        return Ok(());
    }
    for (n, named) in written.named.iter().enumerate() {
        let house = &written.front[named.index];
        say!("\n{} (house {})", named.name, house.id);
        let storeys = house.design.massing.storeys.len();
        say!("  {}; {storeys} storey{}", caption(&house.evaluation), if storeys == 1 { "" } else { "s" });
        say!("  {}", choice_words(job, &house.design));
        say!("  {}", verdict_words(&house.evaluation));
        say!("  why: {}", named.sentence);
        written.chances.iter().for_each(|c| say!("  {}", chance_words(c, &written.named, n)));
        written.around.get(n).iter().for_each(|a| say!("  {}", sensitivity::words(job, a)));
        say!("  {}", job.out.join("front").join(house.id.to_string()).display());
    }
    further_knees(job, written).iter().for_each(|words| say!("\n{words}"));
    let clusters = &written.looks.clusters;
    say!(
        "\nby look ({} groups, {} structure, silhouette {:.2}):",
        clusters.medoids.len(),
        clusters.structure(),
        clusters.silhouette
    );
    written.looks.words(&written.front).iter().for_each(|words| say!("  {words}"));
    let why = whynot::words(job, &written.why, &written.front);
    if !why.is_empty() {
        say!("\nwhy not better:");
        why.iter().for_each(|words| say!("  {words}"));
    }
    price_order_words(written).iter().for_each(|words| say!("\n{words}"));
    say!("\nfront.csv, plots/ and front/ are in {}", job.out.display());
    Ok(())
}

/// Knees beside the named one.
fn further_knees(job: &Job, written: &Written) -> Vec<String> {
    let points: Vec<&[f64]> = written.front.iter().map(|h| h.objectives.as_slice()).collect();
    let names: Vec<&str> = job.evaluator.brief.objectives.iter().map(|g| g.objective.name()).collect();
    let is_named = |k: &Knee| written.named.iter().any(|n| n.index == k.index && n.name.contains("knee"));
    let one = |k: &Knee| {
        let sentence = knee_sentence(k, points[k.index], &names);
        format!("another knee is house {}: {sentence}", written.front[k.index].id)
    };
    knees(&points).iter().filter(|k| !is_named(k)).take(2).map(one).collect()
}

/// Writes `summary.json`: what `--json` prints, and the reasons in words, but not where the folder lies.
pub fn write(job: &Job, found: &Found, written: &Written, folder: &RunFolder) -> Result<(), Failure> {
    let mut summary = report(job, found, written);
    summary.as_object_mut().and_then(|map| map.remove("out"));
    summary["schema"] = json!("houscaper.summary/1");
    summary["why_not_words"] = json!(whynot::words(job, &written.why, &written.front));
    summary["further_knees"] = json!(further_knees(job, written));
    summary["price_order"] = json!(price_order_words(written));
    folder.write("summary.json", &serde_json::to_vec_pretty(&summary).run()?).run()
}

fn report(job: &Job, found: &Found, written: &Written) -> serde_json::Value {
    let goals = &job.evaluator.brief.objectives;
    let values = |h: &FrontHouse| -> serde_json::Map<String, serde_json::Value> {
        goals.iter().map(|g| (g.objective.name().into(), json!(h.evaluation.values.get(g.objective)))).collect()
    };
    let mut report = json!({
        "out": job.out,
        "evaluations": found.progress.evaluations,
        "feasible": found.progress.feasible,
        "front": written.front.len(),
        "hypervolume": found.progress.relative_hypervolume(),
        "named": written.named.iter().enumerate().map(|(at, n)| {
            let house = &written.front[n.index];
            let chances = written.chances.as_ref();
            json!({
                "id": house.id,
                "name": n.name,
                "reason": n.sentence,
                "values": values(house),
                "price_tenths_eur": chances.map(|c| c.tenths[at]),
                "chance_cheapest_of_named": chances.map(|c| c.cheapest[at]),
                "chance_cheaper_than_named": chances.map(|c| &c.below[at]),
                "sensitivity": written.around.get(at).map(|a| sensitivity::report(job, a)),
            })
        }).collect::<Vec<_>>(),
        "by_look": written.looks.report(&written.front),
        "why_not": whynot::report(&written.why),
    });
    if let Some(measured_by) = job.evaluator.tiling.measured_by() {
        report["tileset"] =
            json!({"measured_by": measured_by, "house_and_cubes_without_tile": without_tile(job, written)});
    }
    report
}

/// How sure the order of the front by price is, from each house to the next.
fn price_order_words(written: &Written) -> Option<String> {
    let least = written.order.iter().min_by(|a, b| a.chance.total_cmp(&b.chance))?;
    let sure = written.order.iter().filter(|pair| pair.chance >= SURE).count();
    let id = |h: usize| written.front[h].id;
    Some(format!(
        "order of the front by price: {sure} of {} neighbours keep it in at least {:.0} % of the draws; least sure: house {} before {}, {:.0} %",
        written.order.len(),
        100.0 * SURE,
        id(least.first),
        id(least.second),
        100.0 * least.chance
    ))
}

/// What the draws of all rates say about the price of a named house, and about it beside the others.
fn chance_words(chances: &Chances, named: &[Named], n: usize) -> String {
    let [low, _, high] = chances.tenths[n].map(|p| p / 1e3);
    let own = format!("price EUR {low:.0}k to {high:.0}k in 80 % of the draws");
    let chance = |m: usize| chances.below[n][m];
    let names = |keep: &dyn Fn(f64) -> bool| -> Vec<String> {
        let others = (0..named.len()).filter(|m| *m != n && keep(chance(*m)));
        others.map(|m| format!("\"{}\"", named[m].name)).collect()
    };
    let (surely, never) = (names(&|c| c > 0.995), names(&|c| c < 0.005));
    let mut told = vec![own, format!("cheapest of the named houses in {:.0} % of them", 100.0 * chances.cheapest[n])];
    let open = (0..named.len()).filter(|m| *m != n && (0.005..=0.995).contains(&chance(*m)));
    told.extend(open.map(|m| format!("cheaper than \"{}\" in {:.0} %", named[m].name, 100.0 * chance(m))));
    if !surely.is_empty() {
        told.push(format!("cheaper than {} in all", surely.join(", ")));
    }
    if !never.is_empty() {
        told.push(format!("dearer than {} in all", never.join(", ")));
    }
    told.join("; ")
}

/// The houses of the front that have cubes without a tile, and how many.
fn without_tile(job: &Job, written: &Written) -> Vec<[u64; 2]> {
    let count = |h: &FrontHouse| [h.id, job.evaluator.tiling.missing(&h.house.voxels).len() as u64];
    written.front.iter().map(count).filter(|[_, cubes]| *cubes > 0).collect()
}

fn verdict_words(evaluation: &Evaluation) -> String {
    let Some(a) = &evaluation.assessment else { return "structure not analysed".into() };
    let word = match a.verdict {
        Verdict::Ok => "ok",
        Verdict::NotOk { .. } => "not ok",
        Verdict::Unstable { .. } => "unstable",
        Verdict::NotAssessed { .. } => "not assessed",
    };
    let thesis = a.thesis.map_or("not asked", |t| t.answer());
    if matches!(a.verdict, Verdict::NotAssessed { .. }) {
        return format!("structure {word} (thesis rule: {thesis})");
    }
    format!(
        "structure {word}: utilisation {:.2}, sway {:.2}, deflection {:.2} of their limits; thesis rule: {thesis}",
        a.utilisation, a.sway_ratio, a.deflection_ratio
    )
}

/// Says which constraints the least infeasible house could not keep.
pub fn nothing_feasible(job: &Job, record: &Record, written: &Written) -> anyhow::Error {
    let Some((violation, design)) = &record.nearest else {
        return anyhow::anyhow!("no house could be evaluated");
    };
    let house = encode(&design.massing, &job.space.plot);
    let evaluation = job.evaluator.evaluate(&house, &design.choices);
    let mut reasons = Vec::new();
    if evaluation.rules > 0.0 {
        reasons.extend(job.evaluator.broken_rule(&house).map(|rule| format!("rule {rule} is broken")));
    }
    for (name, value) in Shortfall::NAMES.iter().zip(evaluation.shortfall.values()) {
        if value > 0.0 {
            reasons.push(format!("{name} is missed by {:.0} %", 100.0 * value));
        }
    }
    for limit in &job.evaluator.limits {
        let value = evaluation.values.get(limit.objective);
        if limit.violation(value) > 0.0 {
            let side = if limit.is_max { "at most" } else { "at least" };
            let name = limit.objective.name();
            reasons.push(format!("{name} is {value:.4}, the brief asks {side} {}", limit.limit));
        }
    }
    if let Some(a) = &evaluation.assessment {
        reasons.extend(structural_reason(a));
    }
    anyhow::anyhow!(
        "no feasible house in {} evaluations; the nearest one (violation {violation:.3}) fails because: {}; of {} houses taken evenly from all: {}; relax these in the brief or raise search.evaluations (whynot.csv and evaluations.csv in {} have more)",
        record.count(),
        reasons.join("; "),
        written.why.sampled,
        whynot::infeasible_words(&written.why).join("; "),
        job.out.display()
    )
}

fn structural_reason(assessment: &Assessment) -> Option<String> {
    match &assessment.verdict {
        Verdict::Ok => None,
        Verdict::NotOk { mend, .. } => Some(format!(
            "structure: {} {:.2}, {} {:.2}, {} {:.2} ({mend})",
            Objective::Utilisation.name(),
            assessment.utilisation,
            Objective::SwayRatio.name(),
            assessment.sway_ratio,
            Objective::DeflectionRatio.name(),
            assessment.deflection_ratio
        )),
        Verdict::Unstable { nodes } => Some(format!("structure: a mechanism at {} nodes", nodes.len())),
        Verdict::NotAssessed { reason } => Some(format!("structure: {reason}")),
    }
}
