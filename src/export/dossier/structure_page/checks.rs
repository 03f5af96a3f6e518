//! Checks: members, deflections, boards, storeys, buckling, and the foundation.

use super::super::structure::{CheckReport, MemberReport, StructureReport};
use super::page::{Page, fixed};

/// Members listed at most; the file beside the page has all.
const LISTED: usize = 40;

/// Deflections listed at most.
const DEFLECTIONS: usize = 15;

/// All of them.
pub fn put(page: &mut Page, r: &StructureReport) {
    if !r.members.is_empty() {
        members(page, r);
        deflections(page, r);
    }
    if !r.racking.is_empty() {
        racking(page, r);
    }
    stability(page, r);
    if !r.foundation.is_empty() {
        foundation(page, r);
    }
}

/// A clause with its standard in three letters.
fn short(clause: &str) -> String {
    clause.replace("EN 1995-1-1", "EC5").replace("EN 1993-1-1", "EC3")
}

/// Demand and resistance; of a sum of ratios its terms, in the order of the formula below.
fn numbers(c: &CheckReport) -> String {
    if c.unit.is_empty() {
        return c.terms.iter().map(|t| fixed(t.value, 2)).collect::<Vec<_>>().join(" + ");
    }
    format!("{} of {} {}", fixed(c.demand, 2), fixed(c.resistance, 2), c.unit)
}

fn row(m: &MemberReport) -> [String; 13] {
    let own = |f: &dyn Fn(&CheckReport) -> String| m.governing.as_ref().map_or(String::new(), f);
    let plies = if m.plies > 1 { format!("{} x ", m.plies) } else { String::new() };
    [
        format!("{} {}", m.role, m.member),
        format!("{plies}{}", m.section),
        fixed(m.utilisation, 2),
        own(&|c| short(c.clause)),
        own(&numbers),
        own(&|c| format!("C{}", c.combination)),
        own(&|c| if c.k_mod == 1.0 { String::new() } else { fixed(c.k_mod, 1) }),
        own(&|c| fixed(c.clear_m, 2)),
        own(&|c| c.at_m.map_or("along".to_owned(), |x| fixed(x, 2))),
        own(&|c| fixed(c.n_kn, 2)),
        own(&|c| fixed(c.v_kn[0].hypot(c.v_kn[1]), 2)),
        own(&|c| fixed(c.m_knm[0], 2)),
        own(&|c| fixed(c.m_knm[1], 2)),
    ]
}

const TITLES: [&str; 13] =
    ["=Member", "=Section", "#Ratio", "=Clause", "=Demand", "=In", "#kmod", "#Clear", "#At", "#N", "#V", "#My", "#Mz"];

/// The worst of each role, then the worst of all; the clauses they name.
fn members(page: &mut Page, r: &StructureReport) {
    page.heading("Members: the worst of each role");
    let mut roles: Vec<&str> = Vec::new();
    let mut worst: Vec<&MemberReport> = Vec::new();
    for m in r.members.iter().filter(|m| m.governing.is_some()) {
        if !roles.contains(&m.role) {
            roles.push(m.role);
            worst.push(m);
        }
    }
    let listed: Vec<&MemberReport> = r.members.iter().filter(|m| m.governing.is_some()).take(LISTED).collect();
    table(page, &worst);
    page.heading("Members, worst first");
    table(page, &listed);
    let loaded = r.members.iter().filter(|m| m.governing.is_some()).count();
    if loaded > LISTED {
        page.note(&format!("{} more, all lower, are in structure.json.", loaded - LISTED));
    }
    page.note("In: combination. Clear: length in m between the points that hold the member, its buckling length about y; boards hold it about z, but for beam posts. At: distance from the member's start, m; along: the largest forces along the clear length. N in kN, tension positive; V, of both directions, in kN; M in kNm; y the strong axis. Demand: what the resistance is asked for; of a clause that adds ratios its terms, in the order of its formula below. EC3, EC5: EN 1993-1-1, EN 1995-1-1. The number of a member is that of frame.glb and structure.json; `houscaper member` checks one again with every clause.");
    let mut clauses: Vec<[String; 3]> = Vec::new();
    for m in worst.iter().chain(&listed) {
        let Some(c) = &m.governing else { continue };
        let formula = format!("{} <= {}", c.demand_symbol, c.resistance_symbol);
        let name = m.check.split(" (").next().unwrap_or_default();
        if clauses.iter().all(|row| row[0] != c.clause) {
            clauses.push([c.clause.to_owned(), name.to_owned(), formula]);
        }
    }
    clauses.sort();
    page.table(&["=Clause", "Check", "Demand against resistance"], &clauses);
}

fn table(page: &mut Page, members: &[&MemberReport]) {
    let rows: Vec<[String; 13]> = members.iter().map(|m| row(m)).collect();
    page.raw("<div class=\"small\">");
    page.marked_table(&TITLES, rows.iter().zip(members).map(|(row, m)| (row, m.utilisation > 1.0)));
    page.raw("</div>\n");
}

fn deflections(page: &mut Page, r: &StructureReport) {
    page.heading("Deflections against limits, worst first");
    let mut list: Vec<&MemberReport> = r.members.iter().filter(|m| m.deflection.is_some()).collect();
    list.sort_by(|a, b| b.deflection_ratio.total_cmp(&a.deflection_ratio).then(a.member.cmp(&b.member)));
    list.truncate(DEFLECTIONS);
    let rows: Vec<[String; 6]> = list
        .iter()
        .filter_map(|m| {
            let d = m.deflection.as_ref()?;
            Some([
                format!("{} {}", m.role, m.member),
                format!("{}{}", d.check, if d.cantilever { ", cantilever" } else { "" }),
                fixed(d.span_m, 2),
                fixed(d.mm, 1),
                fixed(d.limit_mm, 1),
                fixed(m.deflection_ratio, 2),
            ])
        })
        .collect();
    page.marked_table(
        &["Member", "Check", "#Span, m", "#Deflection, mm", "#Limit, mm", "#Ratio"],
        rows.iter().zip(&list).map(|(row, m)| (row, m.deflection_ratio > 1.0)),
    );
    page.note("Deflection from the chord of the span; total: with creep, kdef.");
    if let Some(d) = &r.deformed {
        page.note(&format!(
            "Largest displacement of the frame: {} mm on member {} under {}, elastic, without creep.",
            fixed(d.largest_mm, 1),
            d.member,
            d.combination
        ));
    }
}

fn racking(page: &mut Page, r: &StructureReport) {
    page.heading("Racking of boarded walls, decks and roofs, worst first");
    let rows: Vec<[String; 5]> = r
        .racking
        .iter()
        .map(|w| {
            let combination = format!("C{}", w.combination);
            [w.what.clone(), fixed(w.force_kn, 2), fixed(w.capacity_kn, 2), fixed(w.ratio, 2), combination]
        })
        .collect();
    page.marked_table(
        &["Where", "#Force, kN", "#Capacity, kN", "#Ratio", "=In"],
        rows.iter().zip(&r.racking).map(|(row, w)| (row, w.ratio > 1.0)),
    );
    page.note("EN 1995-1-1 9.2.4.2, method A; wind lowered for lack of correlation (EN 1991-1-4 7.2.2(3)). A deck or roof panel: force along its diagonal.");
}

fn stability(page: &mut Page, r: &StructureReport) {
    if r.storeys.is_empty() && r.critical_load.is_none() {
        return;
    }
    page.heading("Stability of the frame: critical load factor");
    match &r.critical_load {
        Some(c) => {
            let rows: Vec<[String; 5]> = [
                ("the frame: sticks straight, joints move", &c.frame),
                ("a member over its clear length (Euler)", &c.member),
            ]
            .into_iter()
            .filter_map(|(what, mode)| {
                let m = mode.as_ref()?;
                let [x, y, z] = m.at_m.map(|c| fixed(c, 2));
                Some([
                    what.to_owned(),
                    fixed(m.factor, 1),
                    format!("C{}", m.combination),
                    match m.kind {
                        "sway" => "storeys sway".to_owned(),
                        _ => "local".to_owned(),
                    },
                    format!("{} moves most, at {x}, {y}, {z} m", m.what),
                ])
            })
            .collect();
            page.table(
                &["Least eigenvalue over all ultimate combinations", "#alpha_cr", "Combination", "Mode", "Where"],
                &rows,
            );
            page.raw(&format!("<p><strong>{}.</strong></p>\n", super::page::escape(&c.conclusion)));
            page.note("The frame: sticks are held straight, so that storeys sway, decks shear and roofs push out on the stiffness of the boards; the lower of this factor and those of the storeys below counts. A member: boards hold the weak axes of all but beam posts (a bare stud would buckle about its weak axis at one or two times its load); the factor is its Euler load over its force, and its own check above, which reduces for buckling, is what counts for it.");
        }
        None => page.note("The first buckling load was not computed for this house: a search leaves it out, `houscaper build` finds it."),
    }
    if !r.storeys.is_empty() {
        let rows: Vec<[String; 7]> = r
            .storeys
            .iter()
            .map(|s| {
                [
                    format!("{} to {} m", fixed(s.z_m[0], 2), fixed(s.z_m[1], 2)),
                    s.wind_from.to_owned(),
                    fixed(s.horizontal_kn, 2),
                    fixed(s.drift_mm, 2),
                    fixed(s.vertical_kn, 1),
                    fixed(s.alpha_cr, 1),
                    if s.alpha_cr >= super::super::structure::FIRST_ORDER {
                        "at least 10".into()
                    } else {
                        "below 10".into()
                    },
                ]
            })
            .collect();
        page.table(
            &["Storey", "Wind from", "#H, kN", "#Drift, mm", "#V_Ed, kN", "#alpha_cr = H h / (V drift)", ""],
            &rows,
        );
        page.note("Storey by storey, EN 1993-1-1 (5.2): H and the largest drift of a post under the characteristic wind, V the largest vertical design load above the storey's foot. The formula is meant for slopes under 26 degrees; for steeper roofs it stands as an estimate.");
    }
}

fn foundation(page: &mut Page, r: &StructureReport) {
    page.heading("Reactions on the foundation");
    let rows: Vec<[String; 10]> = r
        .foundation
        .iter()
        .map(|l| {
            let place = |force: f64, at: [f64; 2]| {
                if force > 0.0 {
                    format!("{} at {}, {}", fixed(force, 1), fixed(at[0], 2), fixed(at[1], 2))
                } else {
                    "none".into()
                }
            };
            let [g, q, s] = l.characteristic_kn.map(|f| fixed(f, 1));
            [
                l.line.clone(),
                if l.length_m > 0.0 { fixed(l.length_m, 2) } else { String::new() },
                g,
                q,
                s,
                fixed(l.design_kn, 1),
                l.design_kn_m.map_or(String::new(), |d| fixed(d, 1)),
                place(l.push_kn, l.push_at_m),
                place(l.pull_kn, l.pull_at_m),
                fixed(l.along_kn, 1),
            ]
        })
        .collect();
    page.table(
        &[
            "Line",
            "#Sole, m",
            "#G, kN",
            "#Q, kN",
            "#S, kN",
            "#Ultimate, kN",
            "#kN/m",
            "Largest push of a support, kN",
            "Largest pull, 0.9 G + 1.5 W, kN",
            "#Along it, kN",
        ],
        &rows,
    );
    let sum = |k: usize| fixed(r.foundation.iter().map(|l| l.characteristic_kn[k]).sum::<f64>(), 1);
    page.note(&format!(
        "All lines together: G {} kN, Q {} kN, S {} kN. A support where lines meet counts in equal shares to each. The weight of the foundation and of the ground floor on it is not in these.",
        sum(0),
        sum(1),
        sum(2)
    ));
}
