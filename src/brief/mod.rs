//! The brief: plot, programme, site, materials, objectives and constraints, as a checked file.

mod constraint;
mod objective;
mod read;
mod schema;

pub use constraint::Constraint;
pub use objective::{Goal, Objective, Sense};
pub use read::{BriefError, MOST_MODULES, SCHEMA, read_brief};
pub use schema::{Algorithm, Auto, Brief, Envelope, Given, Keep, Plot, Programme, Search, Sections, Site, ZoneArea};

impl Brief {
    /// The JSON Schema of briefs, as `configs/brief.schema.json` has it.
    pub fn json_schema() -> serde_json::Value {
        serde_json::to_value(schemars::schema_for!(Brief)).unwrap_or_default()
    }

    /// Number of plan cells that may be built on.
    pub fn buildable_cells(&self) -> usize {
        match &self.plot.mask {
            Some(rows) => rows.iter().flat_map(|r| r.bytes()).filter(|&b| b == b'#').count(),
            None => self.plot.modules[0] * self.plot.modules[1],
        }
    }

    /// Objectives that `constraints` name.
    fn limits_named(&self) -> impl Iterator<Item = Objective> + '_ {
        self.constraints.iter().filter_map(|(key, &limit)| Some(Constraint::parse(key, limit)?.objective))
    }

    /// All limits: those of `constraints`, plus utilisation, sway and deflection at most 1 unless the brief says otherwise.
    pub fn limits(&self) -> Vec<Constraint> {
        let mut limits: Vec<Constraint> =
            self.constraints.iter().filter_map(|(key, &limit)| Constraint::parse(key, limit)).collect();
        for objective in [Objective::Utilisation, Objective::SwayRatio, Objective::DeflectionRatio] {
            if !limits.iter().any(|l| l.objective == objective && l.is_max) {
                limits.push(Constraint { objective, is_max: true, limit: 1.0 });
            }
        }
        limits
    }
}
