//! Which constraint a house breaks, and how near it is to the others.

use super::evaluation::structural_violation;
use super::programme::{entrances, roof_rise};
use super::{Evaluation, Evaluator};
use crate::brief::Objective;
use crate::structure::{Assessment, Verdict};
use crate::voxels::{Choices, House, Reading, read_storeys};

/// Who asks for something.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Demand {
    /// The brief, which may ask for less.
    Brief,
    /// The rules of the voxels, or the structural checks: no brief can ask for less.
    Law,
}

/// A constraint on a house, as far as it is kept.
#[derive(Clone, Debug, PartialEq)]
pub struct Bound {
    /// Where it comes from: a key of the brief (`[0]` the least of a range, `[1]` the most), `structure.…` or `rules`.
    pub key: String,
    /// Who asks for it.
    pub demand: Demand,
    /// True: value <= limit; false: value >= limit.
    pub is_max: bool,
    /// The limit, in the key's unit; ratios of the structure have 1.
    pub limit: f64,
    /// The value; NaN when it could not be found.
    pub value: f64,
    /// What it adds to the violation of the evaluation; 0 when kept.
    pub violation: f64,
}

impl Bound {
    /// Room between value and limit as a share of the limit; 0 at the limit and beyond, NaN when the value is.
    pub fn room(&self) -> f64 {
        let inside = if self.is_max { self.limit - self.value } else { self.value - self.limit };
        if self.violation > 0.0 { 0.0 } else { inside.max(0.0) / self.limit.abs().max(1e-9) }
    }
}

impl Evaluator {
    /// Every constraint on a house, for one brief always the same ones in the same order. Their violations sum to that of the evaluation,
    /// which must be of this house.
    pub fn bounds(&self, house: &House, choices: &Choices, evaluation: &Evaluation) -> Vec<Bound> {
        let reading = read_storeys(house);
        let is_broken = evaluation.rules > 0.0;
        let rules = if is_broken { evaluation.violation } else { 0.0 };
        let mut out = vec![Bound { value: evaluation.rules, ..bound("rules", Demand::Law, true, 0.0, rules) }];
        self.programme_bounds(house, &reading, choices, evaluation, &mut out);
        for limit in &self.limits {
            let value = evaluation.values.get(limit.objective);
            let violation = if value.is_nan() { 1.0 } else { limit.violation(value) };
            let key = format!("constraints.{}_{}", limit.objective.name(), if limit.is_max { "max" } else { "min" });
            out.push(Bound { value, ..bound(&key, Demand::Brief, limit.is_max, limit.limit, violation) });
        }
        out.extend(self.structure_bounds(evaluation.assessment.as_ref()));
        if is_broken {
            // The violation of a house that breaks rules counts nothing else.
            out[1..].iter_mut().for_each(|b| b.violation = 0.0);
        }
        out
    }

    fn programme_bounds(
        &self,
        house: &House,
        reading: &Reading,
        choices: &Choices,
        evaluation: &Evaluation,
        out: &mut Vec<Bound>,
    ) {
        let (asked, missed) = (&self.brief.programme, &evaluation.shortfall);
        let storeys = reading.storeys.len() as f64;
        let rise = reading.plates.last().map_or(0, |plate| roof_rise(house, plate.k)) as f64;
        let range = |name: &str, [least, most]: [f64; 2], value: f64, missed: f64| {
            // The shortfall of a range is that of the side that is missed.
            let [low, high] = if value > most { [0.0, missed] } else { [missed, 0.0] };
            let key = |n: usize| format!("programme.{name}[{n}]");
            [
                Bound { value, ..bound(&key(0), Demand::Brief, false, least, low) },
                Bound { value, ..bound(&key(1), Demand::Brief, true, most, high) },
            ]
        };
        let least = |name: &str, limit: f64, value: f64, missed: f64| Bound {
            value,
            ..bound(&format!("programme.{name}"), Demand::Brief, false, limit, missed)
        };
        let floor = super::programme::floor_area_m2(reading);
        out.extend(range("floor_area_m2", asked.floor_area_m2, floor, missed.floor_area));
        out.extend(range("storeys", asked.storeys.map(|s| s as f64), storeys, missed.storeys));
        let clear = self.clear_height_m(reading, &self.sections(choices));
        out.push(least("clear_height_m", asked.clear_height_m, clear, missed.clear_height));
        let glazing = super::programme::glazing_ratio(house, reading, self.rules.view_m);
        out.push(least("glazing_ratio_min", asked.glazing_ratio_min, glazing, missed.glazing));
        out.push(least("entrances_min", asked.entrances_min as f64, entrances(reading) as f64, missed.entrances));
        out.extend(range("roof_rise", asked.roof_rise.map(|r| r as f64), rise, missed.roof));
    }

    /// The ratios of the structure, and whether it can be assessed at all.
    fn structure_bounds(&self, assessment: Option<&Assessment>) -> Vec<Bound> {
        let stands = |violation| {
            let value = if violation > 0.0 { 0.0 } else { 1.0 };
            Bound { value, ..bound("structure.stands", Demand::Law, false, 1.0, violation) }
        };
        let whole = assessment.map_or(0.0, |a| structural_violation(a, self.loads.preset_only));
        if self.loads.preset_only {
            let ratio = assessment.and_then(|a| a.thesis).map(|thesis| thesis.ratio);
            let missed = if ratio.is_some() { [0.0, whole] } else { [whole, 0.0] };
            let rule = bound("structure.thesis_rule", Demand::Law, true, 1.0, missed[1]);
            return vec![stands(missed[0]), Bound { value: ratio.unwrap_or(f64::NAN), ..rule }];
        }
        let checked = assessment.filter(|a| matches!(a.verdict, Verdict::Ok | Verdict::NotOk { .. }));
        let ratio = |key: &str, of: &dyn Fn(&Assessment) -> f64| {
            let value = checked.map_or(f64::NAN, of);
            Bound { value, ..bound(key, Demand::Law, true, 1.0, (value - 1.0).max(0.0)) }
        };
        let named = |o: Objective| format!("structure.{}", o.name());
        vec![
            stands(if checked.is_some() { 0.0 } else { whole }),
            ratio(&named(Objective::Utilisation), &|a| a.utilisation),
            ratio(&named(Objective::SwayRatio), &|a| a.sway_ratio),
            ratio(&named(Objective::DeflectionRatio), &|a| a.deflection_ratio),
            ratio("structure.vibration_ratio", &|a| a.vibration_ratio()),
        ]
    }
}

fn bound(key: &str, demand: Demand, is_max: bool, limit: f64, violation: f64) -> Bound {
    Bound { key: key.into(), demand, is_max, limit, value: f64::NAN, violation }
}
