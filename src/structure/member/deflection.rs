//! Deflection of a simple span under characteristic loads.

use super::error::MemberError;
use super::report::{ClauseLine, Quantities};
use super::resolve::Case;
use super::shapes::positive;

/// Mid-span deflection of a simple span per N/m, m: bending 5 l^4 / (384 E I), shear l^2 / (8 G A_v).
fn per_load(e: f64, i: f64, g: f64, av: f64, l: f64) -> f64 {
    5.0 * l.powi(4) / (384.0 * e * i) + l * l / (8.0 * g * av)
}

/// Adds the lines for deflection: variable load at once against l/300, everything with creep against l/250.
pub(super) fn check(
    case: &Case,
    av: f64,
    k_def: f64,
    clauses: [&'static str; 2],
    lines: &mut Vec<ClauseLine>,
    values: &mut Quantities,
) -> Result<(), MemberError> {
    let (Some([g, q]), Some(l)) = (case.actions.service, case.length) else { return Ok(()) };
    let m = &case.material;
    let unit = 1e3 * per_load(m.e, case.section.i[0], m.g, av, l);
    let psi2 = case.input.psi2.unwrap_or(0.3);
    if !(0.0..=1.0).contains(&psi2) {
        return Err(MemberError::Range { key: "psi2", found: psi2, expected: "a number from 0 to 1" });
    }
    for load in [g, q, g + q].into_iter().filter(|load| *load > 0.0) {
        let meaning = format!("deflection under {:.3} kN/m at once, shear included", load / 1e3);
        values.put(&format!("w_{:03.0}", load / 10.0), unit * load, "mm", &meaning);
    }
    let total = unit * (g * (1.0 + k_def) + q * (1.0 + psi2 * k_def));
    let limits = [("limit_variable", case.input.limit_variable, 300.0), ("limit_total", case.input.limit_total, 250.0)];
    for (n, (key, given, default)) in limits.into_iter().enumerate() {
        let demand = [unit * q, total][n];
        let resistance = 1e3 * l / positive(key, given)?.unwrap_or(default);
        if demand > 0.0 {
            lines.push(ClauseLine {
                clause: clauses[n],
                name: ["deflection under variable load", "total deflection"][n],
                demand_symbol: ["w_inst,q", "w_fin"][n],
                demand,
                resistance_symbol: ["l / limit_variable", "l / limit_total"][n],
                resistance,
                unit: "mm",
                ratio: demand / resistance,
                combination: "characteristic",
                at: Some(0.5),
            });
        }
    }
    Ok(())
}
