//! Loads: actions, wind, snow, combinations, and the balance of every case.

use super::page::{Page, fixed};
use crate::structure::{CombinationReport, LoadReport};

/// All of them.
pub fn put(page: &mut Page, loads: &LoadReport) {
    actions(page, loads);
    wind(page, loads);
    snow(page, loads);
    combinations(page, loads);
    sums(page, loads);
}

/// A number without trailing zeros, four digits behind the point under 10, else two.
fn plain(value: f64) -> String {
    let text = fixed(value, if value.abs() < 10.0 { 4 } else { 2 });
    let text = text.trim_end_matches('0').trim_end_matches('.');
    text.to_owned()
}

fn actions(page: &mut Page, loads: &LoadReport) {
    page.heading("Actions and factors, characteristic values");
    let rows: Vec<[String; 4]> = loads
        .actions
        .iter()
        .map(|a| {
            let values: Vec<String> = a.value.iter().map(|v| plain(*v)).collect();
            [a.action.to_owned(), values.join("; "), a.unit.to_owned(), a.source.clone()]
        })
        .collect();
    page.table(&["Action", "Value", "Unit", "Clause and source"], &rows);
}

fn wind(page: &mut Page, loads: &LoadReport) {
    page.heading("Wind");
    let kn = |f: [f64; 3]| f.map(|n| fixed(n / 1e3, 1)).join(", ");
    let rows: Vec<[String; 8]> = loads
        .wind
        .iter()
        .map(|w| {
            let zones: Vec<String> = w
                .zones
                .iter()
                .map(|z| {
                    let [least, most] = z.cpe.map(|c| fixed(c, 2));
                    let cpe = if least == most { least } else { format!("{least} / {most}") };
                    format!("{} {cpe} on {} m2", z.zone, fixed(z.area_m2, 1))
                })
                .collect();
            [
                w.from.to_owned(),
                fixed(w.qp_n_m2 / 1e3, 3),
                fixed(w.ze_m, 2),
                fixed(w.e_m, 2),
                fixed(w.h_over_d, 2),
                zones.join("; "),
                kn(w.least_n),
                kn(w.pressed_n),
            ]
        })
        .collect();
    page.table(
        &[
            "From",
            "#qp, kN/m2",
            "#ze, m",
            "#e, m",
            "#h/d",
            "Zone, cpe,10 smallest / largest, area",
            "=Smallest: x, y, z, kN",
            "=Roofs pressed, kN",
        ],
        &rows,
    );
    let mut clauses: Vec<String> =
        loads.wind.iter().flat_map(|w| &w.zones).map(|z| format!("{}: {}", z.zone, z.clause)).collect();
    clauses.sort();
    clauses.dedup();
    page.note(&format!("External pressures only; internal pressure acts beside them. {}.", clauses.join("; ")));
}

fn snow(page: &mut Page, loads: &LoadReport) {
    page.heading("Snow");
    let rows: Vec<[String; 3]> = loads
        .snow
        .iter()
        .map(|s| [s.arrangement.to_owned(), fixed(s.weight_n / 1e3, 1), s.clause.to_owned()])
        .collect();
    page.table(&["Arrangement", "#On the house, kN", "Clause"], &rows);
}

/// A combination as an engineer writes it.
pub fn formula(c: &CombinationReport) -> String {
    let [g, q, s, w] = c.factors;
    let term = |f: f64, what: &str| (f != 0.0).then(|| format!("{} {what}", fixed(f, 2)));
    let snow = match c.snow {
        Some(0) | None => "S".to_owned(),
        Some(n) => format!("S{}", n + 1),
    };
    [term(g, "G"), term(q, "Q"), term(s, &snow), term(w, "W")].into_iter().flatten().collect::<Vec<_>>().join(" + ")
}

fn combinations(page: &mut Page, loads: &LoadReport) {
    page.heading("Combinations");
    let rows: Vec<[String; 5]> = loads
        .combinations
        .iter()
        .enumerate()
        .map(|(n, c)| {
            let wind = c.wind.clone().unwrap_or_default();
            [format!("C{}", n + 1), formula(c), wind, c.duration.to_owned(), format!("EN 1990 {}", c.clause)]
        })
        .collect();
    page.table(&["=No.", "=Ultimate", "Wind", "Duration", "=Expression"], &rows);
    page.note("S even snow, S2 half on slopes towards +x or +y, S3 half towards -x or -y, S4 drifted.");
    page.list(&loads.serviceability);
}

fn sums(page: &mut Page, loads: &LoadReport) {
    page.heading("Equilibrium: loads and reactions of every case, characteristic");
    let kn = |f: [f64; 3]| f.map(|n| fixed(n / 1e3, 2));
    let rows: Vec<[String; 8]> = loads
        .sums
        .iter()
        .map(|s| {
            let ([lx, ly, lz], [rx, ry, rz]) = (kn(s.loads_n), kn(s.reactions_n));
            let off = (0..3).map(|a| (s.loads_n[a] + s.reactions_n[a]).abs()).fold(0.0, f64::max);
            [s.case.clone(), lx, ly, lz, rx, ry, rz, format!("{off:.0e}")]
        })
        .collect();
    page.table(&["Case", "#Load x, kN", "#y", "#z", "#Reaction x, kN", "#y", "#z", "#Difference, N"], &rows);
}
