//! What the review of a frame adds to the report: members with their governing check in numbers, the foundation, storeys, buckling, the
//! deformed shape.

use super::rows::{
    CheckReport, CriticalReport, DeflectionReport, DeformedReport, FoundationReport, MemberReport, ModeReport,
    RackingReport, StoreyReport, TermReport,
};
use super::{check_name, round};
use crate::frame::{HouseFrame, PanelKind};
use crate::score::Details;
use crate::structure::checks::Unit;
use crate::structure::{
    BucklingMode, Critical, FoundationLine, GoverningCheck, LineKind, MemberReview, ModeKind, Peak, RackingReview,
    Review,
};
use crate::voxels::Direction;

/// Least critical load factor that lets a frame be analysed to first order (EN 1993-1-1 5.2.1(3), elastic analysis).
pub const FIRST_ORDER: f64 = 10.0;

/// Members, worst first.
pub(super) fn members(details: &Details, names: &[String; 4], review: Option<&Review>) -> Vec<MemberReport> {
    let (Some(frame), Some(assessment)) = (&details.frame, &details.evaluation.assessment) else { return Vec::new() };
    let mut list: Vec<MemberReport> = frame
        .members
        .iter()
        .zip(&assessment.members)
        .enumerate()
        .map(|(member, (stick, result))| {
            let own: Option<&MemberReview> = review.and_then(|r| r.members.get(member));
            MemberReport {
                member,
                role: stick.role.name(),
                length_m: stick.length_m,
                plies: stick.plies,
                section: names[stick.group as usize].clone(),
                utilisation: result.utilisation,
                check: check_name(result.check),
                deflection_ratio: result.deflection_ratio,
                governing: own.and_then(|m| m.governing).map(check),
                axial_kn: own.filter(|m| m.governing.is_some()).map(|m| m.axial_n.map(|n| round(n / 1e3, 3))),
                deflection: own.and_then(|m| m.deflection).map(|d| DeflectionReport {
                    check: check_name(d.check),
                    span_m: round(d.span_m, 3),
                    cantilever: d.is_cantilever,
                    mm: round(1e3 * d.deflection_m, 3),
                    limit_mm: round(1e3 * d.limit_m, 3),
                }),
            }
        })
        .collect();
    list.sort_by(|a, b| b.utilisation.total_cmp(&a.utilisation).then(a.member.cmp(&b.member)));
    list
}

fn check(g: GoverningCheck) -> CheckReport {
    let clause = g.checked.clause;
    let (scale, unit) = match clause.unit() {
        Unit::Force => (1e-3, "kN"),
        Unit::Moment => (1e-3, "kNm"),
        Unit::Stress => (1e-6, "MPa"),
        Unit::Sum => (1.0, ""),
    };
    let [demand_symbol, resistance_symbol] = clause.symbols();
    let kilo = |x: f64| round(x / 1e3, 3);
    CheckReport {
        clause: clause.number(),
        demand_symbol,
        demand: round(g.checked.demand * scale, 4),
        resistance_symbol,
        resistance: round(g.checked.resistance * scale, 4),
        unit,
        terms: g.terms.iter().map(|t| TermReport { symbol: t.symbol, value: round(t.value, 4) }).collect(),
        combination: g.combination + 1,
        at_m: g.at_m.map(|x| round(x, 3)),
        clear_m: round(g.clear_m, 3),
        k_mod: g.k_mod,
        n_kn: kilo(g.forces.n),
        v_kn: [g.forces.vy, g.forces.vz].map(kilo),
        m_knm: [g.forces.my, g.forces.mz].map(kilo),
    }
}

/// The foundation, line by line.
pub(super) fn foundation(review: &Review) -> Vec<FoundationReport> {
    review.foundation.iter().map(line).collect()
}

fn line(l: &FoundationLine) -> FoundationReport {
    let kn = |n: f64| round(n / 1e3, 3);
    let place = |p: &Peak| p.at_m.map(|c| round(c, 3));
    FoundationReport {
        line: match l.kind {
            LineKind::AlongX(y) => format!("wall along x at y = {y:.2} m"),
            LineKind::AlongY(x) => format!("wall along y at x = {x:.2} m"),
            LineKind::Post([x, y]) => format!("post at x = {x:.2}, y = {y:.2} m"),
        },
        extent_m: l.extent_m.map(|c| round(c, 3)),
        length_m: round(l.length_m, 3),
        supports: l.supports,
        characteristic_kn: l.vertical_n.map(kn),
        design_kn: kn(l.design_n.0),
        combination: l.design_n.1 + 1,
        design_kn_m: (l.length_m > 0.0).then(|| round(l.design_n.0 / 1e3 / l.length_m, 3)),
        push_kn: kn(l.push.force_n),
        push_at_m: place(&l.push),
        pull_kn: kn(l.pull.force_n),
        pull_at_m: place(&l.pull),
        along_kn: kn(l.along_n),
    }
}

/// Boarded walls worst first, then a deck and a roof panel.
pub(super) fn racking(review: &Review) -> Vec<RackingReport> {
    let mut list: Vec<RackingReport> = review.racking.iter().map(boarded).collect();
    list.sort_by(|a, b| b.ratio.total_cmp(&a.ratio).then_with(|| a.what.cmp(&b.what)));
    list
}

fn boarded(r: &RackingReview) -> RackingReport {
    let [low, high] = r.extent_m;
    let axis = usize::from(high[1] - low[1] > high[0] - low[0]);
    let (along, across) = [("x", "y"), ("y", "x")][axis];
    let height = format!("z = {:.2} to {:.2} m", low[2], high[2]);
    RackingReport {
        what: match r.kind {
            PanelKind::Wall => format!(
                "wall along {along} at {across} = {:.2} m, {along} = {:.2} to {:.2} m, {height}",
                low[1 - axis],
                low[axis],
                high[axis]
            ),
            PanelKind::Deck => {
                format!("worst deck panel, at x = {:.2}, y = {:.2}, z = {:.2} m", low[0], low[1], low[2])
            }
            PanelKind::Roof => format!("worst roof panel, at x = {:.2}, y = {:.2} m, {height}", low[0], low[1]),
        },
        force_kn: round(r.force_n / 1e3, 3),
        capacity_kn: round(r.capacity_n / 1e3, 3),
        ratio: r.ratio(),
        combination: r.combination + 1,
    }
}

/// The storeys, lowest first.
pub(super) fn storeys(review: &Review) -> Vec<StoreyReport> {
    let row = |s: &crate::structure::StoreyReview| StoreyReport {
        z_m: s.z_m.map(|z| round(z, 3)),
        wind_from: ["+x", "+y", "-x", "-y"][s.side % Direction::ALL.len()],
        horizontal_kn: round(s.horizontal_n / 1e3, 3),
        vertical_kn: round(s.vertical_n / 1e3, 3),
        drift_mm: round(1e3 * s.drift_m, 4),
        alpha_cr: round(s.factor, 2),
    };
    review.storeys.iter().map(row).collect()
}

/// The shape that is drawn.
pub(super) fn deformed(frame: &HouseFrame, review: &Review) -> DeformedReport {
    let d = &review.deformed;
    DeformedReport {
        combination: d.combination.clone(),
        largest_mm: round(1e3 * d.largest_m, 3),
        member: d.member,
        at_m: d.at_m.map(|c| round(c, 3)),
        scale: super::super::frame_scene::deformation_scale(frame, d),
    }
}

/// First buckling loads in words.
pub(super) fn critical(frame: &HouseFrame, found: &Critical, storeys: &[StoreyReport]) -> CriticalReport {
    let of_storeys = storeys.iter().map(|s| s.alpha_cr).fold(f64::INFINITY, f64::min);
    let least = found.frame.as_ref().map_or(f64::INFINITY, |m| m.factor).min(of_storeys);
    let conclusion = if !found.is_known {
        "the iteration for the first buckling load did not settle: it is not known".to_owned()
    } else if least.is_infinite() {
        "nothing is compressed: no load buckles the frame".to_owned()
    } else if least >= FIRST_ORDER {
        format!(
            "alpha_cr = {least:.1}, at least {FIRST_ORDER:.0}: first-order analysis is justified (EN 1993-1-1 5.2.1(3), elastic; for timber by the same reasoning)"
        )
    } else if least > 1.0 {
        format!(
            "alpha_cr = {least:.1}, less than {FIRST_ORDER:.0}: first-order analysis is not justified (EN 1993-1-1 5.2.1(3)); sway effects grow by about 1 / (1 - 1/alpha_cr) = {:.2} (5.2.2(5)B), which is not done here",
            1.0 / (1.0 - 1.0 / least)
        )
    } else {
        format!("alpha_cr = {least:.1}: the frame buckles under its design loads")
    };
    let report = |m: &BucklingMode| mode(frame, m);
    CriticalReport {
        frame: found.frame.as_ref().map(report),
        member: found.member.as_ref().map(report),
        alpha_cr: least.is_finite().then(|| round(least, 2)),
        limit: FIRST_ORDER,
        conclusion,
    }
}

fn mode(frame: &HouseFrame, m: &BucklingMode) -> ModeReport {
    let what = m.member.map_or_else(|| "a panel".to_owned(), |id| format!("{} {id}", frame.members[id].role.name()));
    ModeReport {
        factor: round(m.factor, 3),
        combination: m.combination + 1,
        kind: match m.kind {
            ModeKind::Sway => "sway",
            ModeKind::Local => "local",
        },
        what,
        at_m: m.at_m.map(|c| round(c, 3)),
        direction: m.direction.map(|c| round(c, 3)),
    }
}
