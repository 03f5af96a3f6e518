//! The objectives a brief may name.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// A quantity a house is judged by; each is defined in the README's table of definitions.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
#[repr(usize)]
pub enum Objective {
    /// Envelope and frame in place, net of VAT, EUR.
    PriceEur,
    /// The same per net floor area, EUR/m2.
    PricePerM2Eur,
    /// Mass of the frame's members, kg.
    FrameMassKg,
    /// Mass of everything priced, kg.
    MassKg,
    /// Embodied carbon, fossil A1-A3, kgCO2e.
    GwpKgco2e,
    /// Embodied non-renewable energy A1-A3, MJ.
    EnergyMj,
    /// Largest utilisation over members and combinations.
    Utilisation,
    /// Largest storey drift over storey height, over its limit.
    SwayRatio,
    /// Largest member deflection over span, over its limit.
    DeflectionRatio,
    /// Net floor area, m2.
    FloorAreaM2,
    /// Smallest storey's glass area over net floor area.
    GlazingRatio,
    /// Envelope area over net floor area.
    EnvelopeRatio,
    /// Sum of U A over the envelope, W/K.
    HeatLossWPerK,
    /// Number of distinct cube ids.
    DistinctTiles,
    /// Number of distinct factory parts up to congruence and mirror; worked out only where a brief names it.
    DistinctParts,
}

impl Objective {
    /// All objectives in storage order.
    pub const ALL: [Objective; 15] = [
        Objective::PriceEur,
        Objective::PricePerM2Eur,
        Objective::FrameMassKg,
        Objective::MassKg,
        Objective::GwpKgco2e,
        Objective::EnergyMj,
        Objective::Utilisation,
        Objective::SwayRatio,
        Objective::DeflectionRatio,
        Objective::FloorAreaM2,
        Objective::GlazingRatio,
        Objective::EnvelopeRatio,
        Objective::HeatLossWPerK,
        Objective::DistinctTiles,
        Objective::DistinctParts,
    ];

    /// The name in briefs and tables, unit as suffix.
    pub fn name(self) -> &'static str {
        match self {
            Objective::PriceEur => "price_eur",
            Objective::PricePerM2Eur => "price_per_m2_eur",
            Objective::FrameMassKg => "frame_mass_kg",
            Objective::MassKg => "mass_kg",
            Objective::GwpKgco2e => "gwp_kgco2e",
            Objective::EnergyMj => "energy_mj",
            Objective::Utilisation => "utilisation",
            Objective::SwayRatio => "sway_ratio",
            Objective::DeflectionRatio => "deflection_ratio",
            Objective::FloorAreaM2 => "floor_area_m2",
            Objective::GlazingRatio => "glazing_ratio",
            Objective::EnvelopeRatio => "envelope_ratio",
            Objective::HeatLossWPerK => "heat_loss_w_per_k",
            Objective::DistinctTiles => "distinct_tiles",
            Objective::DistinctParts => "distinct_parts",
        }
    }

    /// Whether it comes from the checks under a site model.
    pub fn is_structural(self) -> bool {
        matches!(self, Objective::Utilisation | Objective::SwayRatio | Objective::DeflectionRatio)
    }

    /// The objective of a name.
    pub fn from_name(name: &str) -> Option<Objective> {
        Self::ALL.into_iter().find(|o| o.name() == name)
    }

    /// What a person calls it, with its unit, for axes and tables.
    pub fn title(self) -> &'static str {
        match self {
            Objective::PriceEur => "Envelope and frame (EUR)",
            Objective::PricePerM2Eur => "Price (EUR/m²)",
            Objective::FrameMassKg => "Frame mass (kg)",
            Objective::MassKg => "Mass (kg)",
            Objective::GwpKgco2e => "Embodied carbon (kgCO2e A1-A3)",
            Objective::EnergyMj => "Embodied energy (MJ)",
            Objective::Utilisation => "Utilisation (-)",
            Objective::SwayRatio => "Sway over limit (-)",
            Objective::DeflectionRatio => "Deflection over limit (-)",
            Objective::FloorAreaM2 => "Net floor area (m²)",
            Objective::GlazingRatio => "Glazing ratio (-)",
            Objective::EnvelopeRatio => "Envelope over floor area (-)",
            Objective::HeatLossWPerK => "Heat loss (W/K)",
            Objective::DistinctTiles => "Distinct tiles (-)",
            Objective::DistinctParts => "Distinct parts (-)",
        }
    }
}

/// Which way an objective is better.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum Sense {
    /// Smaller is better.
    #[default]
    Min,
    /// Larger is better.
    Max,
}

/// An objective with its sense, in a brief either a bare name (minimised) or `{"name": …, "sense": "max"}`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Goal {
    /// The objective.
    pub objective: Objective,
    /// Its sense.
    pub sense: Sense,
}

impl Goal {
    /// The value as the search sees it: minimised.
    pub fn minimised(self, value: f64) -> f64 {
        match self.sense {
            Sense::Min => value,
            Sense::Max => -value,
        }
    }
}

#[derive(Serialize, Deserialize, JsonSchema)]
#[serde(untagged, expecting = "expected an objective's name or {\"name\": …, \"sense\": \"min\" or \"max\"}")]
pub(super) enum GoalForm {
    Name(String),
    Full(GoalFull),
}

#[derive(Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(super) struct GoalFull {
    /// Objective name.
    pub name: String,
    /// `min` or `max`.
    #[serde(default)]
    pub sense: Sense,
}

impl<'de> Deserialize<'de> for Goal {
    fn deserialize<D: serde::Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let (name, sense) = match GoalForm::deserialize(deserializer)? {
            GoalForm::Name(name) => (name, Sense::Min),
            GoalForm::Full(full) => (full.name, full.sense),
        };
        let objective = Objective::from_name(&name).ok_or_else(|| {
            let names: Vec<_> = Objective::ALL.iter().map(|o| o.name()).collect();
            serde::de::Error::custom(format!("unknown objective `{name}`; expected one of {}", names.join(", ")))
        })?;
        Ok(Goal { objective, sense })
    }
}

impl Serialize for Goal {
    fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        GoalForm::Full(GoalFull { name: self.objective.name().into(), sense: self.sense }).serialize(serializer)
    }
}

impl JsonSchema for Goal {
    fn schema_name() -> std::borrow::Cow<'static, str> {
        "Goal".into()
    }

    fn json_schema(generator: &mut schemars::SchemaGenerator) -> schemars::Schema {
        GoalForm::json_schema(generator)
    }
}
