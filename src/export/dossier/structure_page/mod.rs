//! `structure.html`: the structural summary of a house on a few sheets of A4, for an engineer to review. It prints the record of
//! `structure.json` and nothing else; only the drawings come from the frame.

mod checks;
mod drawings;
mod loads;
mod page;

pub use drawings::Drawings;

use super::structure::StructureReport;
use page::{Page, fixed};

/// Nodes of a mechanism that are listed at most.
const LOOSE: usize = 20;

/// The page of a house called `name`.
pub fn structure_html(name: &str, report: &StructureReport, drawings: Option<&Drawings>) -> String {
    let mut page = Page::new(&format!("Structure: {name}"));
    head(&mut page, name, report);
    if let Some(drawings) = drawings {
        drawings.put(&mut page, report);
    }
    basis(&mut page, report);
    if let Some(found) = &report.loads {
        loads::put(&mut page, found);
    }
    checks::put(&mut page, report);
    page.heading("What is not assessed");
    page.list(&report.not_assessed);
    if let Some(found) = &report.loads {
        page.heading("What stands in for what");
        page.list(&found.stand_ins);
    }
    page.note("All numbers are those of structure.json beside this page, which has every member; the frame with its loads is in frame.json for any solver, in colour in frame.glb. An indication made by a program: it replaces no engineer who signs.");
    page.finish()
}

fn head(page: &mut Page, name: &str, r: &StructureReport) {
    let class = match r.verdict {
        "ok" => "good",
        "not assessed" => "open",
        _ => "bad",
    };
    page.raw(&format!(
        "<h1>{}</h1>\n<p class=\"verdict {class}\"><strong>Structure {}.</strong> {}",
        page::escape(name),
        page::escape(r.verdict),
        page::escape(&r.reason)
    ));
    page.raw(&match (&r.governing, r.verdict) {
        (Some(g), "ok") => {
            format!(
                "; nearest to its limit: {}, {}, at {}.",
                page::escape(&g.what),
                page::escape(&g.check),
                fixed(g.utilisation, 2)
            )
        }
        _ => ".".to_owned(),
    });
    if let Some(mend) = &r.mend {
        page.raw(&format!(" What would mend it: {}.", page::escape(mend)));
    }
    page.raw("</p>\n");
    if !r.loose_nodes.is_empty() {
        let rows: Vec<[String; 3]> = r
            .loose_nodes
            .iter()
            .take(LOOSE)
            .map(|n| {
                let words = |v: &[f64]| v.iter().map(|c| fixed(*c, 2)).collect::<Vec<_>>().join(", ");
                [n.node.to_string(), words(&n.at_m), words(&n.direction)]
            })
            .collect();
        page.heading("Nodes that move freely");
        page.table(&["=Node", "At x, y, z, m", "Direction: ux, uy, uz, rx, ry, rz"], &rows);
    }
    let worst = r.members.first().map_or(0.0, |m| m.utilisation);
    let [total, variable, drift] = r.basis.limits;
    let mut rows = vec![
        (
            worst,
            ["Members: strength and stability", "1", "EN 1993-1-1 6.2, 6.3; EN 1995-1-1 6.1 to 6.3"].map(str::to_owned),
        ),
        (r.racking_ratio, ["Racking of boards", "1", "EN 1995-1-1 9.2.4.2"].map(str::to_owned)),
        (
            r.deflection_ratio,
            [
                "Deflection".into(),
                format!("l/{total:.0} total, l/{variable:.0} variable"),
                "EN 1990 A1.4; EN 1995-1-1 2.2.3, 7.2".into(),
            ],
        ),
        (r.sway_ratio, ["Storey sway under wind".into(), format!("H/{drift:.0}"), "EN 1990 A1.4.3".into()]),
    ];
    if let Some(v) = &r.vibration {
        let words = format!(
            "{} Hz (at least 8), {} mm/kN, {} m/(N s2) (at most {})",
            fixed(v.frequency_hz, 1),
            fixed(v.deflection_mm_kn, 2),
            fixed(v.velocity_m_ns2[0], 4),
            fixed(v.velocity_m_ns2[1], 4)
        );
        rows.push((v.ratio, ["Floor vibration".into(), words, "EN 1995-1-1 7.3.3".into()]));
    }
    page.heading("Summary");
    let cells: Vec<([String; 4], bool)> = rows
        .into_iter()
        .map(|(ratio, [check, limit, clause])| ([check, fixed(ratio, 2), limit, clause], ratio > 1.0))
        .collect();
    page.marked_table(&["Check", "#Over its limit", "Limit", "Clause"], cells.iter().map(|(row, over)| (row, *over)));
    let s = &r.stability;
    let friction = s.friction_needed.map_or("nothing presses down".to_owned(), |f| fixed(f, 2));
    let mut rows = vec![
        [
            "Overturning 1.5 W / righting 0.9 G".into(),
            fixed(s.overturning_ratio, 2),
            "above 1 only anchors hold the house".to_owned(),
        ],
        [
            "Horizontal force of 1.5 W".into(),
            format!("{} kN", fixed(s.sliding_kn, 1)),
            format!("friction that would carry it without anchors: {friction}"),
        ],
        [
            "Pull of all anchors, 0.9 G + 1.5 W".into(),
            format!("{} kN", fixed(r.uplift_kn[0], 1)),
            format!("worst anchor {} kN; anchors are not checked", fixed(r.uplift_kn[1], 1)),
        ],
        [
            "G + Q + S and its reactions".into(),
            format!("{} kN", fixed(r.vertical_load_kn[0], 1)),
            format!("reactions {} kN", fixed(r.vertical_load_kn[1], 1)),
        ],
    ];
    if let Some(c) = &r.critical_load {
        let factor = c.alpha_cr.map_or(String::new(), |factor| fixed(factor, 1));
        rows.push(["Critical load factor of the frame".into(), factor, c.conclusion.clone()]);
    } else if let Some(least) = r.storeys.iter().map(|s| s.alpha_cr).reduce(f64::min) {
        rows.push([
            "Critical load factor, storey by storey".into(),
            fixed(least, 1),
            "EN 1993-1-1 (5.2); at least 10 for first-order analysis".into(),
        ]);
    }
    if let Some(s) = &r.solution {
        rows.push([
            "Residual of the analysis".into(),
            format!("{:.0e}", s.residual),
            format!(
                "{} nodes, {} elements, {} braces for boards, {} unknowns",
                s.nodes, s.elements[0], s.elements[1], s.unknowns
            ),
        ]);
    }
    if let Some(t) = &r.thesis {
        rows.push([
            "Thesis rule (for comparison)".into(),
            t.passes.into(),
            format!(
                "{}: {} and {} MPa of {} and {}",
                t.rule,
                fixed(t.stress_mpa[0], 1),
                fixed(t.stress_mpa[1], 1),
                fixed(t.limit_mpa[0], 0),
                fixed(t.limit_mpa[1], 0)
            ),
        ]);
    }
    page.table(&["=House as a whole", "#", ""], &rows);
}

fn basis(page: &mut Page, r: &StructureReport) {
    let b = &r.basis;
    page.heading("Basis");
    page.table(
        &["=", ""],
        &[
            ["Standards".to_owned(), b.standards.join(", ")],
            ["National annex".into(), format!("{}; combinations by {}", b.annex, b.expression)],
            [
                "Site".into(),
                format!(
                    "basic wind velocity {} m/s, terrain {}, snow on the ground {} kN/m2",
                    fixed(b.wind_m_s, 1),
                    b.terrain,
                    fixed(b.snow_kn_m2, 2)
                ),
            ],
            [
                "Size of the frame".into(),
                format!(
                    "{} x {} m, {} m high, axes of the members",
                    fixed(b.size_m[0], 2),
                    fixed(b.size_m[1], 2),
                    fixed(b.size_m[2], 2)
                ),
            ],
            ["Service class".into(), "1 (EN 1995-1-1 2.3.1.3); consequence class as the partial factors below".into()],
            ["Load path".into(), r.load_path.to_owned()],
        ],
    );
    let rows: Vec<[String; 4]> = r
        .sections
        .iter()
        .map(|g| {
            [
                g.group.trim_end_matches("_section").to_owned(),
                g.section.clone(),
                fixed(g.length_m, 1),
                fixed(g.mass_kg, 0),
            ]
        })
        .collect();
    page.heading("Sections");
    page.table(&["Group", "Material and section", "#Length, m", "#Mass, kg"], &rows);
    page.note("Length with every ply. b x h in mm; strengths and properties with their sources in configs/materials.json and configs/sections.json.");
    if let Some(sizing) = &r.sizing {
        page.note(&format!("{sizing}. sizing.json lists every analysis."));
    }
    page.heading("Assumptions");
    page.list(&r.assumptions);
}
