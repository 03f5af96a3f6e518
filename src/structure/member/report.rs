//! What a checked member says.

use std::collections::BTreeMap;

use serde::Serialize;

use super::input::Duration;
use crate::structure::checks::{Checked, Clause, Unit};

/// A number with its symbol and unit.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Quantity {
    /// Key in files and in tests against books, e.g. `chi_y`.
    pub key: String,
    /// Value in `unit`.
    pub value: f64,
    /// Unit, empty for pure numbers.
    pub unit: &'static str,
    /// What it is, with its clause.
    pub meaning: String,
}

/// One clause with its numbers.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ClauseLine {
    /// Standard and number.
    pub clause: &'static str,
    /// What it checks.
    pub name: &'static str,
    /// Symbol of the demand; the formula of a sum.
    pub demand_symbol: &'static str,
    /// Demand in `unit`.
    pub demand: f64,
    /// Symbol of the resistance.
    pub resistance_symbol: &'static str,
    /// Resistance in `unit`.
    pub resistance: f64,
    /// kN, kNm, MPa, mm or empty.
    pub unit: &'static str,
    /// Demand over resistance.
    pub ratio: f64,
    /// Duration of the combination it comes from.
    pub combination: &'static str,
    /// Where, as a share of the length; `None` for the member as a whole.
    pub at: Option<f64>,
}

/// Everything about one member.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct MemberReport {
    /// Name as given.
    pub name: String,
    /// Material.
    pub material: String,
    /// Section.
    pub section: String,
    /// `ok`, `not ok` or `not assessed`.
    pub verdict: &'static str,
    /// Why it is not assessed.
    pub reason: Option<String>,
    /// Largest ratio.
    pub utilisation: f64,
    /// Clause of the largest ratio, in words and number.
    pub governing: Option<String>,
    /// Properties of the section and strengths of the material.
    pub properties: Vec<Quantity>,
    /// Factors and resistances on the way.
    pub values: Vec<Quantity>,
    /// Clauses in the order of the standard.
    pub clauses: Vec<ClauseLine>,
    /// Assumptions made.
    pub notes: Vec<String>,
    /// What is not checked.
    pub not_covered: &'static [&'static str],
}

/// Worst case of every clause.
#[derive(Default)]
pub(super) struct Worst(BTreeMap<Clause, (Checked, Duration, Option<f64>)>);

impl Worst {
    pub fn add(&mut self, c: Checked, duration: Duration, at: f64) {
        // A zero demand is no check at all, unless nothing else is asked.
        if c.demand == 0.0 {
            return;
        }
        let at = (!c.clause.is_stability()).then_some(at);
        let kept = self.0.entry(c.clause).or_insert((c, duration, at));
        if c.ratio() > kept.0.ratio() {
            *kept = (c, duration, at);
        }
    }

    /// Ratio of a clause, when it was checked.
    pub fn ratio(&self, clause: Clause) -> Option<f64> {
        self.0.get(&clause).map(|(c, ..)| c.ratio())
    }

    pub fn lines(&self) -> Vec<ClauseLine> {
        self.0.values().map(|(c, duration, at)| line(c, *duration, *at)).collect()
    }
}

fn line(c: &Checked, duration: Duration, at: Option<f64>) -> ClauseLine {
    let (scale, unit) = match c.clause.unit() {
        Unit::Force => (1e-3, "kN"),
        Unit::Moment => (1e-3, "kNm"),
        Unit::Stress => (1e-6, "MPa"),
        Unit::Sum => (1.0, ""),
    };
    let [demand_symbol, resistance_symbol] = c.clause.symbols();
    ClauseLine {
        clause: c.clause.number(),
        name: c.clause.name(),
        demand_symbol,
        demand: c.demand * scale,
        resistance_symbol,
        resistance: c.resistance * scale,
        unit,
        ratio: c.ratio(),
        combination: duration.word(),
        at,
    }
}

/// Collects quantities.
#[derive(Default)]
pub(super) struct Quantities(pub Vec<Quantity>);

impl Quantities {
    pub fn put(&mut self, key: &str, value: f64, unit: &'static str, meaning: &str) {
        self.0.push(Quantity { key: key.into(), value, unit, meaning: meaning.into() });
    }
}

impl MemberReport {
    /// Sets verdict and governing clause from the lines.
    pub(super) fn judged(mut self) -> MemberReport {
        let worst = self.clauses.iter().max_by(|a, b| a.ratio.total_cmp(&b.ratio));
        self.utilisation = worst.map_or(0.0, |l| l.ratio);
        self.governing = worst.map(|l| format!("{} ({})", l.name, l.clause));
        self.verdict = if self.utilisation <= 1.0 { "ok" } else { "not ok" };
        self
    }

    /// A value or property by its key.
    pub fn value(&self, key: &str) -> Option<f64> {
        if key == "utilisation" {
            return Some(self.utilisation);
        }
        self.values.iter().chain(&self.properties).find(|q| q.key == key).map(|q| q.value)
    }
}
