//! What the report of the loads says.

use serde::Serialize;

/// Everything an engineer asks of the loads.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct LoadReport {
    /// Numbers with unit, clause and source.
    pub actions: Vec<ActionReport>,
    /// Wind from each side.
    pub wind: Vec<WindReport>,
    /// Arrangements of snow.
    pub snow: Vec<SnowReport>,
    /// Ultimate combinations.
    pub combinations: Vec<CombinationReport>,
    /// Combinations of serviceability and what each is compared with.
    pub serviceability: Vec<String>,
    /// Loads and reactions of every unit case.
    pub sums: Vec<SumReport>,
    /// Where a neighbouring value stands in, and what is left out.
    pub stand_ins: Vec<&'static str>,
}

/// A number of the site model.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ActionReport {
    /// What it is.
    pub action: &'static str,
    /// Its value, or values.
    pub value: Vec<f64>,
    /// Their unit.
    pub unit: &'static str,
    /// Clause, copy it was read from and date; or how it is made.
    pub source: String,
}

/// The wind from a side.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct WindReport {
    /// The side it comes from: `+x`, `+y`, `-x` or `-y`.
    pub from: &'static str,
    /// Peak velocity pressure, N/m2, at reference height, m.
    pub qp_n_m2: f64,
    /// Reference height: the whole house takes the pressure at its top, m.
    pub ze_m: f64,
    /// Edge length e = min(b, 2h), m.
    pub e_m: f64,
    /// h/d.
    pub h_over_d: f64,
    /// Factor for lack of correlation on the part of D and E in racking and drift (7.2.2(3)), and the factor it makes on the
    /// force as a whole.
    pub correlation: [f64; 2],
    /// Zones with an area.
    pub zones: Vec<ZoneReport>,
    /// Force of the external pressures with smallest coefficients, N.
    pub least_n: [f64; 3],
    /// Force with largest coefficients on windward slopes and level roofs, N.
    pub pressed_n: [f64; 3],
}

/// A pressure zone.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ZoneReport {
    /// Its letter.
    pub zone: &'static str,
    /// Where its coefficients are from.
    pub clause: &'static str,
    /// Area of surface (not plan), m2.
    pub area_m2: f64,
    /// cpe,10: smallest and largest.
    pub cpe: [f64; 2],
    /// Force of the smallest coefficient, N.
    pub force_n: [f64; 3],
}

/// An arrangement of snow.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct SnowReport {
    /// What lies where.
    pub arrangement: &'static str,
    /// Clause.
    pub clause: &'static str,
    /// Its weight on the house, N.
    pub weight_n: f64,
}

/// An ultimate combination.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct CombinationReport {
    /// Expression of EN 1990.
    pub clause: &'static str,
    /// Factors on permanent load, imposed load, snow, wind.
    pub factors: [f64; 4],
    /// Arrangement of snow, from 0, where snow acts.
    pub snow: Option<usize>,
    /// The wind, where it acts.
    pub wind: Option<String>,
    /// Shortest action: decides kmod (EN 1995-1-1 Table 3.1).
    pub duration: &'static str,
}

/// Loads and reactions of a case.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct SumReport {
    /// The case.
    pub case: String,
    /// Sum of its loads, N.
    pub loads_n: [f64; 3],
    /// Sum of the reactions, N.
    pub reactions_n: [f64; 3],
}
