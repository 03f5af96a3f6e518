//! `houscaper evaluate`: objectives and constraints of houses, one by one or in batches.

mod batch;
mod request;

use std::path::Path;

use houscaper::brief::Objective;
use houscaper::score::{Details, Evaluator};
use houscaper::structure::Verdict;
use houscaper::voxels::{Choices, House};
use rayon::prelude::*;
use serde_json::{Map, Value, json};

use super::args::Evaluate;
use super::check::Asked;
use super::failure::{Failure, Outcome, bad_input};
use super::input;
use super::output::say;

pub fn run(args: Evaluate) -> Outcome {
    let asked = Asked::load(&args.brief, args.prices.as_deref())?;
    if args.batch {
        return batch::run(&asked, args.genome, std::io::stdin().lock(), std::io::stdout().lock());
    }
    let choices = match &args.choices {
        Some(flag) => super::choices::from_flag(flag, &asked.evaluator)?,
        None => Choices::default(),
    };
    // All files are read before anything is printed, so that a bad one leaves no half of an answer.
    let houses: Vec<House> = args.voxels.iter().map(|path| read(path, &args, &asked)).collect::<Result<_, _>>()?;
    let rows: Vec<Value> =
        args.voxels.par_iter().zip(&houses).map(|(path, house)| row(path, house, &choices, &asked)).collect();
    rows.iter().for_each(|row| say!("{row}"));
    Ok(())
}

fn read(path: &Path, args: &Evaluate, asked: &Asked) -> Result<House, Failure> {
    let house = input::house(path, &args.import)?;
    let (found, expected) =
        (house.voxels.module, houscaper::voxels::Module { size_m: asked.evaluator.brief.plot.module_m });
    if found != expected {
        let text = format!(
            "{}: modules of {:?} m, expected {:?} m as in plot.module_m",
            path.display(),
            found.size_m,
            expected.size_m
        );
        return Err(bad_input(text));
    }
    Ok(house)
}

fn row(path: &Path, house: &House, choices: &Choices, asked: &Asked) -> Value {
    let details = asked.evaluator.details(house, choices);
    let site = asked.site.violations(house);
    let violation = details.evaluation.violation + site.iter().map(|v| v.amount).sum::<f64>();
    json!({
        "file": path.display().to_string(),
        "feasible": violation <= 0.0,
        "violation": violation,
        "violations": details.violations.len() + site.len(),
        "verdict": verdict(&details),
        "objectives": objectives(&details, &asked.evaluator),
    })
}

fn verdict(details: &Details) -> &'static str {
    match details.evaluation.assessment.as_ref().map(|a| &a.verdict) {
        Some(Verdict::Ok) => "ok",
        Some(Verdict::NotOk { .. }) => "not ok",
        Some(Verdict::Unstable { .. }) => "unstable",
        Some(Verdict::NotAssessed { .. }) | None => "not assessed",
    }
}

/// Every objective by name, those of the brief among them; null where it could not be found, as for a mechanism.
fn objectives(details: &Details, evaluator: &Evaluator) -> Map<String, Value> {
    let known = !details.evaluation.minimised(&evaluator.brief.objectives).is_empty();
    let value = |o: Objective| if known { json!(details.evaluation.values.get(o)) } else { Value::Null };
    Objective::ALL.into_iter().map(|o| (o.name().to_owned(), value(o))).collect()
}
