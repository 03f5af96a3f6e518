//! `houscaper check`: what a house breaks, where, and what mends it.

mod list;
pub mod plot;
mod programme;

use std::path::Path;

use houscaper::score::{Evaluator, floor_area_m2};
use houscaper::voxels::rules::{self, RULES, RuleSettings, Violation};
use houscaper::voxels::{Choices, House, read_storeys};
use serde_json::json;

use super::args::Check;
use super::failure::{Failure, Outcome};
use super::input;
use super::output::say;

pub fn run(args: Check, as_json: bool) -> Outcome {
    let brief = args.brief.as_deref().map(|path| Asked::load(path, None)).transpose()?;
    let settings = brief.as_ref().map_or_else(RuleSettings::default, |b| b.evaluator.rules.clone());
    let Some(path) = args.voxels.as_deref().filter(|_| !args.rules) else {
        return list::rules(&settings, as_json);
    };
    let house = input::house(path, &args.import)?;
    let violations = violations(&house, &settings, brief.as_ref());
    if as_json {
        let rows: Vec<_> = violations.iter().map(row).collect();
        say!("{}", json!({ "violations": rows }));
    } else if violations.is_empty() {
        praise(path, &house, &settings, brief.is_some());
    } else {
        list::violations(path, &violations);
    }
    if violations.is_empty() { Ok(()) } else { Err(Failure::Found) }
}

/// A brief with everything it names.
pub struct Asked {
    /// Programme, rules and books.
    pub evaluator: Evaluator,
    /// Plot, mask and given cells.
    pub site: plot::Site,
}

impl Asked {
    /// Reads a brief and all files it names, with a price book of the command line in place of its own.
    pub fn load(path: &Path, prices: Option<&Path>) -> Result<Asked, Failure> {
        let (mut brief, folder) = input::brief(path)?;
        input::own_prices(&mut brief, prices)?;
        let site = plot::Site::new(&brief, &folder)?;
        Ok(Asked { evaluator: input::evaluator(brief, folder)?, site })
    }
}

/// Broken rules, then, with a brief, what plot, given cells and programme miss.
pub fn violations(house: &House, settings: &RuleSettings, brief: Option<&Asked>) -> Vec<Violation> {
    let mut all = rules::check(house, settings);
    if let Some(Asked { evaluator, site }) = brief {
        all.extend(site.violations(house));
        let shortfall = evaluator.evaluate(house, &Choices::default()).shortfall;
        all.extend(programme::violations(&evaluator.brief.programme, house, &shortfall));
    }
    all
}

fn row(v: &Violation) -> serde_json::Value {
    json!({"rule": v.rule, "voxels": v.voxels, "cube": v.cube, "message": v.message, "fix": v.fix})
}

fn praise(path: &Path, house: &House, settings: &RuleSettings, with_brief: bool) {
    let reading = read_storeys(house);
    let storeys = reading.storeys.len();
    say!(
        "{}: keeps all {} rules{}: {storeys} storey{}, {:.1} m2 net floor area, {} stair{}",
        path.display(),
        RULES.iter().filter(|r| settings.off.iter().all(|off| off != r.id)).count(),
        if with_brief { " and the brief's plot and programme" } else { "" },
        plural(storeys),
        floor_area_m2(&reading),
        house.stairs.len(),
        plural(house.stairs.len()),
    );
}

/// The ending of a word after a count.
pub fn plural(count: usize) -> &'static str {
    if count == 1 { "" } else { "s" }
}
