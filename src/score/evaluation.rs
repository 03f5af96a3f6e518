//! What an evaluation says.

use super::Shortfall;
use crate::brief::{Constraint, Goal, Objective};
use crate::price::Cost;
use crate::quantities::Takeoff;
use crate::structure::{Assessment, Verdict};

/// The value of every objective, in its unit; NaN where it could not be found.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Values(pub [f64; Objective::ALL.len()]);

impl Default for Values {
    fn default() -> Self {
        Values([f64::NAN; Objective::ALL.len()])
    }
}

impl Values {
    /// The value of one objective.
    pub fn get(&self, objective: Objective) -> f64 {
        self.0[objective as usize]
    }

    pub(super) fn set(&mut self, objective: Objective, value: f64) {
        self.0[objective as usize] = value;
    }
}

/// Everything found about one house under one brief.
#[derive(Clone, Debug, PartialEq)]
pub struct Evaluation {
    /// Sum of the rule violations' amounts; 0 when every rule holds.
    pub rules: f64,
    /// Shortfalls against the programme.
    pub shortfall: Shortfall,
    /// Structure; `None` when the house broke rules and was not analysed.
    pub assessment: Option<Assessment>,
    /// Take-off; `None` as above.
    pub takeoff: Option<Takeoff>,
    /// Price, carbon, mass; `None` as above.
    pub cost: Option<Cost>,
    /// Objectives.
    pub values: Values,
    /// How far all constraints are broken, summed; 0 is feasible.
    pub violation: f64,
}

/// Added to the violation of a house that breaks rules, so that any rule-respecting house is better.
const RULE_OFFSET: f64 = 1000.0;

impl Evaluation {
    /// The evaluation of a house that breaks rules.
    pub(super) fn broken(rules: f64, shortfall: Shortfall) -> Self {
        Evaluation {
            rules,
            shortfall,
            assessment: None,
            takeoff: None,
            cost: None,
            values: Values::default(),
            violation: RULE_OFFSET + rules,
        }
    }

    /// Whether the house may stand in a front: rules, programme and limits kept, and the structure *ok* (or, with the thesis preset
    /// alone, passing the thesis rule).
    pub fn is_feasible(&self) -> bool {
        self.violation <= 0.0
    }

    /// Objectives as the search sees them, all minimised; empty when the house was not analysed or is a mechanism.
    pub fn minimised(&self, goals: &[Goal]) -> Vec<f64> {
        let standing = self.assessment.as_ref().is_some_and(|a| !matches!(a.verdict, Verdict::Unstable { .. }));
        if !standing {
            return Vec::new();
        }
        goals.iter().map(|g| g.minimised(self.values.get(g.objective))).collect()
    }
}

/// What the structure adds to the violation: a mechanism counts 1 plus its loose nodes, a failed check what it is beyond its limit.
pub(super) fn structural_violation(assessment: &Assessment, thesis_only: bool) -> f64 {
    match &assessment.verdict {
        Verdict::Unstable { nodes } => 1.0 + nodes.len() as f64,
        Verdict::NotAssessed { .. } if thesis_only => {
            assessment.thesis.map_or(1.0, |thesis| (thesis.ratio - 1.0).max(0.0))
        }
        Verdict::NotAssessed { .. } => 1.0,
        Verdict::Ok | Verdict::NotOk { .. } => {
            [assessment.utilisation, assessment.sway_ratio, assessment.deflection_ratio, assessment.vibration_ratio()]
                .iter()
                .map(|ratio| (ratio - 1.0).max(0.0))
                .sum()
        }
    }
}

/// What the limits of the brief add; the structural ones only as far as they are stricter than 1.
pub(super) fn limit_violation(limits: &[Constraint], values: &Values) -> f64 {
    limits
        .iter()
        .map(|limit| {
            let value = values.get(limit.objective);
            if value.is_nan() { 1.0 } else { limit.violation(value) }
        })
        .sum()
}
