//! Violations and rules as text for people.

use std::path::Path;

use houscaper::voxels::rules::{RULES, RuleSettings, Violation};
use serde_json::json;

use super::super::failure::{Blame, Outcome};
use super::plural;
use crate::cli::output::say;

/// Most voxels listed for one violation.
const MOST_VOXELS: usize = 12;

/// Every rule with its sentence, and the settings in force.
pub fn rules(settings: &RuleSettings, as_json: bool) -> Outcome {
    let on = |id: &str| settings.off.iter().all(|off| off != id);
    let settings_json = serde_json::to_value(settings).run()?;
    if as_json {
        let list: Vec<_> =
            RULES.iter().map(|r| json!({"rule": r.id, "sentence": r.sentence, "on": on(r.id)})).collect();
        say!("{}", json!({"rules": list, "settings": settings_json}));
        return Ok(());
    }
    let width = RULES.iter().map(|r| r.id.len()).max().unwrap_or(0);
    for rule in RULES {
        say!("{:width$}  {}{}", rule.id, rule.sentence, if on(rule.id) { "" } else { " [off]" });
    }
    say!("\nSettings in force (the brief's `rules` changes them; sentences above state the defaults):");
    say!("{}", serde_json::to_string_pretty(&settings_json).run()?);
    Ok(())
}

/// Violations grouped by rule in the order given, and their number.
pub fn violations(path: &Path, all: &[Violation]) {
    let mut previous = "";
    let mut broken = 0;
    for violation in all {
        if violation.rule != previous {
            previous = violation.rule;
            broken += 1;
            let sentence = RULES.iter().find(|r| r.id == previous).map_or("Asked for by the brief.", |r| r.sentence);
            say!("{previous}: {sentence}");
        }
        say!("  - {}", violation.message);
        if let Some(cube) = violation.cube {
            say!("    cube {cube:?}");
        }
        if !violation.voxels.is_empty() {
            say!("    voxel{} {}", plural(violation.voxels.len()), voxels(&violation.voxels));
        }
        say!("    fix: {}", violation.fix);
    }
    let n = all.len();
    say!("{}: {n} violation{} of {broken} rule{}", path.display(), plural(n), plural(broken));
}

/// The first voxels of a list, and how many more there are.
pub fn voxels(all: &[[usize; 3]]) -> String {
    let shown: Vec<String> = all.iter().take(MOST_VOXELS).map(|v| format!("{v:?}")).collect();
    let more = all.len().saturating_sub(MOST_VOXELS);
    let rest = if more > 0 { format!(" and {more} more") } else { String::new() };
    format!("{}{rest}", shown.join(" "))
}
