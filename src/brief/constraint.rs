//! Limits on objectives.

use super::Objective;

/// A limit that a feasible house keeps.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Constraint {
    /// What is limited.
    pub objective: Objective,
    /// True: value <= limit; false: value >= limit.
    pub is_max: bool,
    /// The limit, in the objective's unit.
    pub limit: f64,
}

impl Constraint {
    /// Reads `<objective>_max`, `<objective>_min` or `budget_eur`; `None` for any other key.
    pub fn parse(key: &str, limit: f64) -> Option<Constraint> {
        if key == "budget_eur" {
            return Some(Constraint { objective: Objective::PriceEur, is_max: true, limit });
        }
        let (name, is_max) = match key.strip_suffix("_max") {
            Some(name) => (name, true),
            None => (key.strip_suffix("_min")?, false),
        };
        Some(Constraint { objective: Objective::from_name(name)?, is_max, limit })
    }

    /// The key of the limit on the other side.
    pub(super) fn opposite_key(&self) -> String {
        format!("{}_{}", self.objective.name(), if self.is_max { "min" } else { "max" })
    }

    /// How far a value is beyond the limit, relative to the limit; 0 when kept.
    pub fn violation(&self, value: f64) -> f64 {
        let beyond = if self.is_max { value - self.limit } else { self.limit - value };
        if beyond <= 0.0 { 0.0 } else { beyond / self.limit.abs().max(1e-9) }
    }
}
