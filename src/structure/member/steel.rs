//! A steel member by EN 1993-1-1.

use super::error::MemberError;
use super::input::{Duration, LoadAt, LtbMethod};
use super::report::{MemberReport, Quantities, Quantity, Worst};
use super::resolve::Case;
use super::shapes::positive;
use super::{ClauseLine, deflection};
use crate::structure::checks::steel::{Class, Curve, Lateral, LateralMethod, class_of, critical_moment, curves};
use crate::structure::checks::{Checked, Clause, Peaks, Section, Shape, Steel, SteelMember};

const NOT_COVERED: &[&str] = &[
    "connections, holes and net sections (6.2.2.2, 6.2.3(2)b)",
    "concentrated loads on webs (EN 1993-1-5 section 6)",
    "warping torsion of open sections (6.2.7(2))",
    "fire, fatigue, seismic action",
];

pub(super) fn check(case: &Case, steel: Steel) -> Result<MemberReport, MemberError> {
    let (section, loading) = (&case.section, case.actions.full());
    let mut report = MemberReport {
        name: case.input.name.clone().unwrap_or_default(),
        material: case.material.id.clone(),
        section: case.section_id.clone(),
        verdict: "not assessed",
        reason: None,
        utilisation: 0.0,
        governing: None,
        properties: properties(section, &steel, case),
        values: Vec::new(),
        clauses: Vec::new(),
        notes: notes(case),
        not_covered: NOT_COVERED,
    };
    let class = case.points(loading).iter().map(|&x| class_of(&steel, section, &loading.at(x))).max();
    let class = class.unwrap_or(Class::Four);
    let slender_web = web_slenderness(section).is_some_and(|s| s > 72.0 * steel.epsilon());
    let member = SteelMember::new(steel, section, class, 1.0, slenders(case), cases(lateral(case)?), curve(case)?);
    let (Some(mut member), false) = (member, slender_web) else {
        report.reason = Some(if slender_web {
            "the web is slenderer than 72 epsilon: shear buckling (6.2.6(6), EN 1993-1-5) is not assessed".into()
        } else {
            "class 4 under these forces (5.5.2, Table 5.2): local buckling (EN 1993-1-5, light gauge EN 1993-1-3) is not assessed".into()
        });
        return Ok(report);
    };
    member.cm = moment_factors(case)?;
    let (mut worst, mut peaks) = (Worst::default(), Peaks::default());
    for x in case.points(loading) {
        let f = loading.at(x);
        member.section(&f, |c| worst.add(c, Duration::Short, x));
        peaks.add(&f);
    }
    if loading.t != 0.0 {
        let resistance = section.wt * steel.fy / steel.gamma_m0 / 3f64.sqrt();
        // 6.2.7(9): what torsion leaves of the shear resistance; linear for hollow sections, taken for open ones too (safe).
        let checked = Checked { clause: Clause::SteelTorsion, demand: loading.t.abs(), resistance };
        worst.add(checked, Duration::Short, 0.0);
        let left = (1.0 - checked.ratio()).max(1e-9);
        for x in case.points(loading) {
            let reduced = |c: Checked| Checked { resistance: c.resistance * left, ..c };
            member.section(&loading.at(x), |c| {
                if matches!(c.clause, Clause::SteelShearY | Clause::SteelShearZ) {
                    worst.add(reduced(c), Duration::Short, x);
                }
            });
        }
        report.notes.push("torsion: St Venant; shear resistances are those of 6.2.7(9), V_pl,T,Rd".into());
    }
    if case.length.is_some() {
        member.stability(&peaks, |c| worst.add(c, Duration::Short, 0.0));
    }
    report.values = values(case, &member, &peaks, &worst);
    report.clauses = worst.lines();
    report.clauses.iter_mut().for_each(|l: &mut ClauseLine| l.combination = "design");
    let mut quantities = Quantities(std::mem::take(&mut report.values));
    let clauses = ["EN 1993-1-1 7.2.1", "EN 1993-1-1 7.2.1"];
    deflection::check(case, section.av[1], 0.0, clauses, &mut report.clauses, &mut quantities)?;
    report.values = quantities.0;
    Ok(report.judged())
}

/// The diagram's own C1 covers a change of sign.
fn cases([top, bottom]: [Option<Lateral>; 2]) -> [Option<Lateral>; 3] {
    [top, bottom, bottom]
}

fn slenders(case: &Case) -> [f64; 3] {
    [case.lengths[0], case.lengths[1], case.lengths[2]]
}

fn curve(case: &Case) -> Result<Option<Curve>, MemberError> {
    let Some(text) = &case.input.curve else { return Ok(None) };
    let all = [Curve::A0, Curve::A, Curve::B, Curve::C, Curve::D];
    let found = all.into_iter().find(|c| c.letter() == text.trim().to_lowercase());
    found
        .map(Some)
        .ok_or(MemberError::Missing { key: "curve", hint: "expected a0, a, b, c or d, or nothing (Table 6.2 decides)" })
}

fn web_slenderness(section: &Section) -> Option<f64> {
    match section.shape {
        Shape::I { h, tw, tf, .. } => Some((h - 2.0 * tf) / tw),
        Shape::Box { h, t, .. } => Some((h - 3.0 * t) / t),
        Shape::Tube { .. } | Shape::Rectangle { .. } => None,
    }
}

fn lateral(case: &Case) -> Result<[Option<Lateral>; 2], MemberError> {
    let (length, my) = (case.lengths[3], &case.actions.full().my);
    if length == 0.0 {
        return Ok([None; 2]);
    }
    let method = match case.input.ltb {
        LtbMethod::Rolled => LateralMethod::Rolled,
        LtbMethod::General => LateralMethod::General,
    };
    // The diagram is that of the whole member: between nearer supports uniform moment is the safe side.
    let whole = case.length.is_some_and(|l| (l - length).abs() < 1e-9);
    let c1 = positive("C1", case.input.c1)?.unwrap_or(if whole { my.c1() } else { 1.0 });
    let c2 = positive("C2", case.input.c2)?.unwrap_or(if my.sag != 0.0 { 0.454 } else { 0.0 });
    let half = 0.5 * case.section.shape.size()[1];
    let pushes = match case.input.load_at {
        LoadAt::Top => [c2 * half, 0.0],
        LoadAt::Centre => [0.0, 0.0],
        LoadAt::Bottom => [0.0, c2 * half],
    };
    Ok(pushes.map(|c2_zg| Some(Lateral { length, c1, c2_zg, method })))
}

fn moment_factors(case: &Case) -> Result<[f64; 3], MemberError> {
    let l = case.actions.full();
    let free = case.length.is_some_and(|length| (length - case.lengths[3]).abs() < 1e-9);
    let cm = |key, given: Option<f64>, own: f64| match given {
        Some(found) if !(0.4..=1.0).contains(&found) => {
            Err(MemberError::Range { key, found, expected: "a factor from 0.4 to 1 (Table B.3)" })
        }
        given => Ok(given.unwrap_or(own)),
    };
    Ok([
        cm("Cmy", case.input.cmy, l.my.cm())?,
        cm("Cmz", case.input.cmz, l.mz.cm())?,
        cm("CmLT", case.input.cmlt, if free { l.my.cm() } else { 1.0 })?,
    ])
}

fn properties(s: &Section, steel: &Steel, case: &Case) -> Vec<Quantity> {
    let mut p = Quantities::default();
    super::timber::common(s, case, &mut p);
    p.put("Iw_mm6", s.iw * 1e18, "mm6", "warping constant");
    for (n, axis) in ["y", "z"].into_iter().enumerate() {
        p.put(&format!("Wpl_{axis}_mm3"), s.wpl[n] * 1e9, "mm3", &format!("plastic modulus about {axis}"));
    }
    for (n, axis) in ["y", "z"].into_iter().enumerate() {
        p.put(&format!("Av_{axis}_mm2"), s.av[n] * 1e6, "mm2", &format!("shear area along {axis}, 6.2.6(3)"));
    }
    p.put("fy_MPa", steel.fy / 1e6, "MPa", "yield strength");
    p.put("gamma_M0", steel.gamma_m0, "", "partial factor, sections");
    p.put("gamma_M1", steel.gamma_m1, "", "partial factor, stability");
    p.0
}

fn values(case: &Case, m: &SteelMember, peaks: &Peaks, worst: &Worst) -> Vec<Quantity> {
    let mut v = Quantities::default();
    v.put("class", f64::from(m.class as u8), "", "class of the section under these forces, Table 5.2");
    v.put("Nc_Rd_kN", m.axial() / 1e3, "kN", "A fy / gamma_M0, 6.2.4");
    v.put("Mc_Rd_kNm", m.moments()[0] / 1e3, "kNm", "W_y fy / gamma_M0, 6.2.5");
    v.put("Mc_z_Rd_kNm", m.moments()[1] / 1e3, "kNm", "W_z fy / gamma_M0, 6.2.5");
    v.put("Vc_y_Rd_kN", m.shears()[0] / 1e3, "kN", "A_v,y fy / sqrt 3 / gamma_M0, 6.2.6");
    v.put("Vc_z_Rd_kN", m.shears()[1] / 1e3, "kN", "A_v,z fy / sqrt 3 / gamma_M0, 6.2.6");
    let axial = case.actions.full().n.abs();
    if m.class <= Class::Two && axial > 0.0 {
        let [y, z] = m.moments_left(axial);
        v.put("MN_over_Mpl", y, "", "M_N,y,Rd / M_pl,y,Rd, 6.2.9.1");
        v.put("MN_over_Mpl_z", z, "", "M_N,z,Rd / M_pl,z,Rd, 6.2.9.1");
    }
    if case.length.is_none() {
        return v.0;
    }
    let own = curves(&m.section.shape).map(Curve::letter);
    let letters = case.input.curve.as_deref().map_or(own, |c| [c; 2]);
    for (n, axis) in ["y", "z"].into_iter().enumerate() {
        let length = case.lengths[n];
        v.put(&format!("Lcr_{axis}_mm"), length * 1e3, "mm", &format!("buckling length about {axis}"));
        v.put(&format!("lambda_{axis}"), m.slenderness[n], "", &format!("relative slenderness about {axis}, 6.3.1.3"));
        v.put(&format!("chi_{axis}"), m.chi[n], "", &format!("curve {}, Table 6.2, (6.49)", letters[n]));
    }
    if m.slenderness[2] > 0.0 {
        v.put("lambda_T", m.slenderness[2], "", "relative slenderness for torsional buckling, 6.3.1.4");
        v.put("chi_T", m.chi[2], "", &format!("curve {}, (6.49)", letters[1]));
    }
    v.put("chi", m.chi.iter().copied().fold(1.0, f64::min), "", "least of them");
    v.put(
        "Nb_Rd_kN",
        m.buckling().into_iter().fold(f64::INFINITY, f64::min) / 1e3,
        "kN",
        "least chi A fy / gamma_M1, 6.3.1.1",
    );
    for (edge, name) in ["", "_hogging"].into_iter().enumerate() {
        if m.slenderness_lt[edge] > 0.0 && peaks.my[edge] > 0.0 {
            if let Ok([Some(a), Some(b)]) = lateral(case) {
                let mcr = critical_moment(&m.steel, &m.section, [&a, &b][edge]);
                v.put(&format!("C1{name}"), [a, b][edge].c1, "", "moment gradient factor of M_cr");
                v.put(
                    &format!("Mcr{name}_kNm"),
                    mcr / 1e3,
                    "kNm",
                    "elastic critical moment (NCCI SN003; not in EN 1993-1-1)",
                );
            }
            v.put(&format!("lambda_LT{name}"), m.slenderness_lt[edge], "", "6.3.2.2");
            v.put(&format!("chi_LT{name}"), m.chi_lt[edge], "", "6.3.2");
            v.put(&format!("Mb_Rd{name}_kNm"), m.lateral_moment(edge) / 1e3, "kNm", "chi_LT W_y fy / gamma_M1, (6.55)");
        }
    }
    if let Some(u) = worst.ratio(Clause::SteelMemberY) {
        for (key, value) in ["Cmy", "Cmz", "CmLT"].into_iter().zip(m.cm) {
            v.put(key, value, "", "equivalent uniform moment factor, Table B.3");
        }
        for (key, value) in ["kyy", "kyz", "kzy", "kzz"].into_iter().zip(m.factors(peaks.compression)) {
            v.put(key, value, "", "interaction factor, Annex B");
        }
        v.put("u_6_61", u, "", "left side of (6.61)");
        v.put("u_6_62", worst.ratio(Clause::SteelMemberZ).unwrap_or(0.0), "", "left side of (6.62)");
    }
    v.0
}

fn notes(case: &Case) -> Vec<String> {
    let mut notes = vec!["combination as given; the forces are design values".to_owned()];
    if case.actions.service.is_some() {
        let [g, q] = case.actions.gamma;
        notes[0] = format!(
            "line loads gk, qk with {g} and {q} (EN 1990 (6.10)) on a simple span, beside the design forces given"
        );
    }
    if case.length.is_none() {
        notes.push("no length given: cross-section only, no stability".into());
        return notes;
    }
    match case.section.shape {
        Shape::I { .. } => notes.push("torsional buckling 6.3.1.4 with the curve of z; C_m from the moment diagram (Table B.3, ends held)".into()),
        _ => notes.push("hollow section: no torsional buckling; k_zz of Table B.1 has the form of k_yy; C_m from the moment diagram (Table B.3, ends held)".into()),
    }
    if case.lengths[3] == 0.0 {
        notes.push("the compressed flange is held: no lateral torsional buckling".into());
    }
    notes.push("chi_LT without the factor f of (6.58); buckling is not ignored for N_Ed / N_cr under 0.04; both on the safe side".into());
    notes
}
