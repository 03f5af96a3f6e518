//! What the houses of a front are made up of in money and carbon, and of which materials.

use houscaper::brief::Objective;
use houscaper::export::plots::{self, Framed, Parts};
use houscaper::price::{BillLine, bill};
use houscaper::quantities::Group;
use houscaper::search::select::Named;

use super::Job;
use super::results::{FrontHouse, axis};
use crate::cli::failure::{Blame, Failure};

/// Houses in a breakdown at most where none is named.
const SHOWN: usize = 8;

/// The plots by file name, without extension; none for an empty front.
pub fn sheets(job: &Job, front: &[FrontHouse], named: &[Named]) -> Result<Vec<(String, String)>, Failure> {
    if front.is_empty() {
        return Ok(Vec::new());
    }
    let name = &job.evaluator.brief.name;
    let mut shown: Vec<(usize, String)> = Vec::new();
    for house in named {
        // A house with several names is one bar.
        match shown.iter_mut().find(|(index, _)| *index == house.index) {
            Some((_, words)) => *words = format!("{words}, {}", house.name),
            None => shown.push((house.index, format!("{} {}", front[house.index].id, house.name))),
        }
    }
    if shown.is_empty() {
        shown.extend((0..front.len().min(SHOWN)).map(|index| (index, front[index].id.to_string())));
    }
    let section = |number: u16| job.evaluator.catalogue.section_id(number);
    let mut bills: Vec<(String, Vec<BillLine>)> = Vec::new();
    for (index, words) in shown {
        if let Some(takeoff) = &front[index].evaluation.takeoff {
            bills.push((words, bill(takeoff, &job.evaluator.books, &section).run()?));
        }
    }
    let groups = Group::ALL.map(Group::name);
    let parts = |of: fn(&BillLine) -> f64| -> Vec<Parts> {
        let one = |(name, lines): &(String, Vec<BillLine>)| Parts {
            name: name.clone(),
            parts: groups.map(|g| lines.iter().filter(|l| l.group == g).map(of).sum()).to_vec(),
        };
        bills.iter().map(one).collect()
    };
    let currency = &job.evaluator.books.prices.currency;
    let words = groups.map(|g| g.replace('_', " "));
    let words: Vec<&str> = words.iter().map(String::as_str).collect();
    let note = "figures in the bars: share of the house in %";
    let price = plots::breakdown(
        &format!("{name}: what the named houses cost"),
        &format!("{note}; overhead and contingency, which the price objective adds, are left out"),
        &format!("Envelope and frame, net of overhead and VAT [{currency}]"),
        &words,
        &parts(|l| l.amount),
    );
    let carbon = plots::breakdown(
        &format!("{name}: carbon of the named houses"),
        note,
        "Embodied carbon, fossil A1-A3 [kgCO2e]",
        &words,
        &parts(|l| l.gwp_kgco2e),
    );
    Ok(vec![
        ("cost_breakdown".into(), price.run()?),
        ("carbon_breakdown".into(), carbon.run()?),
        ("materials".into(), materials(job, front)?),
    ])
}

/// Carbon against price of the front by the materials of its frames.
fn materials(job: &Job, front: &[FrontHouse]) -> Result<String, Failure> {
    let mut names: Vec<String> = front.iter().map(|h| frame_of(job, h)).collect();
    names.sort();
    names.dedup();
    let houses: Vec<Framed> = front
        .iter()
        .map(|h| Framed {
            material: names.iter().position(|n| *n == frame_of(job, h)).unwrap_or(0),
            x: h.evaluation.values.get(Objective::PriceEur),
            y: h.evaluation.values.get(Objective::GwpKgco2e),
        })
        .collect();
    let axes = [axis(Objective::PriceEur, false), axis(Objective::GwpKgco2e, false)];
    let title = format!("{}: the front by the materials of its frames", job.evaluator.brief.name);
    plots::by_material(&title, [&axes[0], &axes[1]], &names, &houses).run()
}

/// The materials of a house's frame, each once, by name.
fn frame_of(job: &Job, house: &FrontHouse) -> String {
    let sections = job.evaluator.sections(&house.design.choices);
    let mut ids: Vec<String> = sections.iter().map(|s| job.evaluator.catalogue.material(*s).id.to_string()).collect();
    ids.sort();
    ids.dedup();
    ids.join(" + ")
}
