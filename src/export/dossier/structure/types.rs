//! Small parts of the report.

use serde::Serialize;

use super::round;
use crate::score::{Details, Evaluator};
use crate::structure::{Annex, Expression};

/// What the verdict rests on.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct BasisReport {
    /// Standards.
    pub standards: [&'static str; 6],
    /// National annex: NL, or EN for the recommended values.
    pub annex: &'static str,
    /// Ultimate combinations by `6.10` or `6.10a and 6.10b`.
    pub expression: &'static str,
    /// Basic wind velocity, m/s.
    pub wind_m_s: f64,
    /// Terrain category.
    pub terrain: String,
    /// Snow on the ground, kN/m2.
    pub snow_kn_m2: f64,
    /// Size of the frame along x, y and z, m.
    pub size_m: [f64; 3],
    /// Denominators of the limits: l over total deflection, l over variable deflection, H over drift.
    pub limits: [f64; 3],
}

/// What governs.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct GoverningReport {
    /// Member, panel or node.
    pub what: String,
    /// The check.
    pub check: String,
    /// Its ratio.
    pub utilisation: f64,
}

/// A node of a mechanism.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct LooseNode {
    /// Index in frame.json.
    pub node: usize,
    /// Place in m.
    pub at_m: [f64; 3],
    /// Direction of motion ux uy uz rx ry rz.
    pub direction: [f64; 6],
}

/// How a floor vibrates (EN 1995-1-1 7.3.3).
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct VibrationReport {
    /// First frequency, Hz, at least 8.
    pub frequency_hz: f64,
    /// Deflection under 1 kN, mm.
    pub deflection_mm_kn: f64,
    /// Velocity after a unit impulse and its limit, m/(N s2).
    pub velocity_m_ns2: [f64; 2],
    /// Largest of the three over its limit.
    pub ratio: f64,
}

/// Static equilibrium (EN 1990 EQU).
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct StabilityReport {
    /// Overturning moment of 1.5 W over the righting moment of 0.9 G; above 1 only anchors hold the house.
    pub overturning_ratio: f64,
    /// Horizontal force of 1.5 W, kN: what anchors carry in shear.
    pub sliding_kn: f64,
    /// Friction coefficient that would carry it without anchors; missing where nothing presses down.
    pub friction_needed: Option<f64>,
}

/// The thesis rule.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ThesisReport {
    /// yes or no.
    pub passes: &'static str,
    /// The rule.
    pub rule: &'static str,
    /// Largest tensile and compressive stress with bending, MPa.
    pub stress_mpa: [f64; 2],
    /// Largest N/A alone, MPa, for information.
    pub axial_stress_mpa: f64,
    /// Limits, MPa.
    pub limit_mpa: [f64; 2],
}

/// A role group.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct GroupReport {
    /// wall, floor, beam or roof section.
    pub group: &'static str,
    /// Material and section.
    pub section: String,
    /// Length of all members, m.
    pub length_m: f64,
    /// Their mass, kg.
    pub mass_kg: f64,
}

/// The basis of a house's verdict.
pub(super) fn basis(details: &Details, evaluator: &Evaluator) -> BasisReport {
    let loads = &evaluator.loads;
    BasisReport {
        standards: ["EN 1990", "EN 1991-1-1", "EN 1991-1-3", "EN 1991-1-4", "EN 1993-1-1", "EN 1995-1-1"],
        annex: match loads.annex {
            Annex::En => "EN (recommended values)",
            Annex::Nl => "NL",
        },
        expression: match loads.expression {
            Expression::One => "6.10",
            Expression::Two => "6.10a and 6.10b",
        },
        wind_m_s: loads.vb,
        terrain: loads.terrain_name.clone(),
        snow_kn_m2: loads.sk / 1e3,
        size_m: details.frame.as_ref().map_or([0.0; 3], |f| f.size_m.map(|m| round(m, 3))),
        limits: loads.limits,
    }
}
