//! A timber member by EN 1995-1-1.

use super::deflection;
use super::error::MemberError;
use super::input::{Duration, LoadAt};
use super::report::{MemberReport, Quantities, Quantity, Worst};
use super::resolve::Case;
use super::shapes::positive;
use crate::structure::Catalogue;
use crate::structure::checks::timber::Held;
use crate::structure::checks::{Clause, Forces, Grade, Peaks, Section, TimberMember};

const NOT_COVERED: &[&str] = &[
    "compression and tension across the grain (6.1.3, 6.1.5), notches and holes (6.5)",
    "connections (section 8)",
    "vibration (7.3)",
    "fire, seismic action",
];

pub(super) fn check(case: &Case, grade: Grade, catalogue: &Catalogue) -> Result<MemberReport, MemberError> {
    let class = case.input.service_class.unwrap_or(1);
    if !(1..=3).contains(&class) {
        let expected = "service class 1, 2 or 3 (EN 1995-1-1 2.3.1.3)";
        return Err(MemberError::Range { key: "service_class", found: f64::from(class), expected });
    }
    let row = usize::from(class) - 1;
    let given = positive("kmod", case.input.kmod)?;
    let k_mod = |d: Duration| given.unwrap_or(catalogue.service.k_mod[row][d as usize]);
    let k_def = positive("kdef", case.input.kdef)?.unwrap_or(catalogue.service.k_def[row]);
    let k_sys = positive("ksys", case.input.ksys)?.unwrap_or(1.0);
    let held = held(case)?;
    let member = TimberMember::new(&grade, &case.section, 1.0, &held, k_sys);
    let mut worst = Worst::default();
    for loading in &case.actions.loadings {
        let k = k_mod(loading.duration);
        let mut peaks = Peaks::default();
        for x in case.points(loading) {
            let f = loading.at(x);
            peaks.add(&f);
            member.check(&f, k, |c| {
                if case.length.is_some() || !c.clause.is_stability() {
                    worst.add(c, loading.duration, x);
                }
            });
            if loading.t != 0.0 {
                worst.add(member.torsion(loading.t, &f, k), loading.duration, x);
            }
        }
        if case.length.is_some() {
            member.stability(&peaks, k, |c| worst.add(c, loading.duration, 0.0));
        }
    }
    let mut v = values(case, &member, &held, k_mod(case.actions.full().duration), &worst);
    let mut clauses = worst.lines();
    if let Some(word) = given.map(|_| "k_mod given") {
        clauses.iter_mut().for_each(|l| l.combination = word);
    }
    let numbers = ["EN 1995-1-1 2.2.3, 7.2", "EN 1995-1-1 2.2.3, 7.2"];
    v.put("kdef", k_def, "", "creep, Table 3.2");
    deflection::check(case, case.section.a / 1.2, k_def, numbers, &mut clauses, &mut v)?;
    Ok(MemberReport {
        name: case.input.name.clone().unwrap_or_default(),
        material: case.material.id.clone(),
        section: case.section_id.clone(),
        verdict: "ok",
        reason: None,
        utilisation: 0.0,
        governing: None,
        properties: properties(case, &grade),
        values: v.0,
        clauses,
        notes: notes(case, class),
        not_covered: NOT_COVERED,
    }
    .judged())
}

/// l_ef of Table 6.1: 0.9 l under uniform load, l for end moments; 2 h more with the load on the compressed edge, h / 2 less on the
/// other. The lower edge takes l.
fn held(case: &Case) -> Result<Held, MemberError> {
    let [y, z, _, free] = case.lengths;
    let my = &case.actions.full().my;
    let h = case.section.shape.size()[1];
    let own = if free == 0.0 {
        0.0
    } else if my.sag == 0.0 {
        free
    } else {
        let shift = match case.input.load_at {
            LoadAt::Top => 2.0 * h,
            LoadAt::Centre => 0.0,
            LoadAt::Bottom => -0.5 * h,
        };
        (0.9 * free + shift).max(0.1 * free)
    };
    let given = positive("l_ef_mm", case.input.l_ef_mm)?.map(|mm| mm * 1e-3);
    Ok(Held { buckling: [y, z], lateral: [given.unwrap_or(own), given.unwrap_or(free), given.unwrap_or(free)] })
}

/// Properties any section has.
pub(super) fn common(s: &Section, case: &Case, p: &mut Quantities) {
    p.put("A_mm2", s.a * 1e6, "mm2", "area");
    for (n, axis) in ["y", "z"].into_iter().enumerate() {
        p.put(&format!("I{axis}_mm4"), s.i[n] * 1e12, "mm4", &format!("second moment about {axis}"));
    }
    for (n, axis) in ["y", "z"].into_iter().enumerate() {
        p.put(&format!("Wel_{axis}_mm3"), s.wel[n] * 1e9, "mm3", &format!("elastic modulus about {axis}"));
    }
    p.put("It_mm4", s.it * 1e12, "mm4", "torsion constant");
    p.put("mass_kg_m", s.a * case.material.rho, "kg/m", "mean mass");
}

fn properties(case: &Case, g: &Grade) -> Vec<Quantity> {
    let mut p = Quantities::default();
    common(&case.section, case, &mut p);
    for (key, value, meaning) in [
        ("fmk_MPa", g.fm, "bending strength"),
        ("ft0k_MPa", g.ft, "tension strength"),
        ("fc0k_MPa", g.fc, "compression strength"),
        ("fvk_MPa", g.fv, "shear strength"),
        ("E_MPa", case.material.e, "mean modulus"),
        ("E05_MPa", g.e05, "fifth percentile of it"),
    ] {
        p.put(key, value / 1e6, "MPa", meaning);
    }
    p.put("gamma_M", g.gamma, "", "partial factor, Table 2.3");
    p.put("kcr", g.k_cr, "", "crack factor, 6.1.7(2)");
    p.0
}

fn values(case: &Case, m: &TimberMember, held: &Held, k_mod: f64, worst: &Worst) -> Quantities {
    let mut v = Quantities::default();
    v.put("kmod", k_mod, "", "Table 3.1");
    for (key, n, meaning) in [("kh_y", 0, "bending about y"), ("kh_z", 1, "bending about z"), ("kh_t", 2, "tension")] {
        v.put(key, m.k_h[n], "", &format!("size factor for {meaning}, 3.2(3), 3.3(3)"));
    }
    for (key, strength, meaning) in [
        ("fm_d_MPa", m.fm[0], "bending about y"),
        ("fm_z_d_MPa", m.fm[1], "bending about z"),
        ("ft_d_MPa", m.ft, "tension"),
        ("fc_d_MPa", m.fc, "compression"),
        ("fv_d_MPa", m.fv, "shear"),
    ] {
        v.put(key, strength * k_mod / 1e6, "MPa", &format!("design strength in {meaning}, 2.4.1"));
    }
    v.put("km", m.k_m(), "", "6.1.6(2)");
    let l = case.actions.full();
    let peak = Forces { n: l.n, my: l.my.peak(), mz: l.mz.peak(), ..Forces::default() };
    let [sn, sy, sz] = m.stresses(&peak).map(|s| s / 1e6);
    for (key, value, meaning) in [
        (if sn < 0.0 { "s_c0_d_MPa" } else { "s_t0_d_MPa" }, sn.abs(), "axial stress N / A"),
        ("s_my_d_MPa", sy, "largest bending stress about y, M_y / W_y"),
        ("s_mz_d_MPa", sz, "largest bending stress about z, M_z / W_z"),
    ] {
        if value > 0.0 {
            v.put(key, value, "MPa", meaning);
        }
    }
    if case.length.is_some() {
        for (n, axis) in ["y", "z"].into_iter().enumerate() {
            let [rel, kc] = m.columns[n];
            v.put(&format!("Lcr_{axis}_mm"), held.buckling[n] * 1e3, "mm", &format!("buckling length about {axis}"));
            v.put(&format!("lambda_rel_{axis}"), rel, "", "(6.21), (6.22)");
            v.put(&format!("kc_{axis}"), kc, "", "(6.25), (6.26)");
        }
        v.put("kc", m.columns[0][1].min(m.columns[1][1]), "", "the smaller");
        if held.lateral[0] > 0.0 {
            let [rel, k] = m.laterals[0];
            v.put("l_ef_mm", held.lateral[0] * 1e3, "mm", "effective length, Table 6.1");
            v.put("lambda_rel_m", rel, "", "(6.30), critical stress by (6.32)");
            v.put("kcrit", k, "", "(6.34)");
        }
    }
    if let Some(u) = worst.ratio(Clause::TimberBendingY) {
        let z = worst.ratio(Clause::TimberBendingZ).unwrap_or(0.0);
        v.put("util_bending", u.max(z), "", "larger of (6.11) and (6.12)");
    }
    v
}

fn notes(case: &Case, class: u8) -> Vec<String> {
    let mut notes =
        vec![format!("service class {class}; k_mod of the shortest action: {}", case.actions.full().duration.word())];
    if case.actions.service.is_some() {
        let [g, q] = case.actions.gamma;
        notes.push(format!("line loads on a simple span: {g} gk + {q} qk, and 1.35 gk alone with the k_mod of permanent load (EN 1990 (6.10))"));
    }
    match case.length {
        None => notes.push("no length given: cross-section only, no stability".into()),
        Some(_) if case.lengths[3] == 0.0 => notes.push("the compressed edge is held: k_crit = 1".into()),
        Some(_) => {}
    }
    if case.input.ksys.is_none() {
        notes.push("no load sharing (k_sys = 1)".into());
    }
    notes
}
