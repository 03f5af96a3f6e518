//! `structure.json`: the verdict with everything an engineer asks next.

mod review;
mod rows;
mod types;

use serde::Serialize;

pub use review::FIRST_ORDER;
pub use rows::{
    CheckReport, CriticalReport, DeflectionReport, DeformedReport, FoundationReport, MemberReport, ModeReport,
    RackingReport, SolutionReport, StoreyReport,
};
pub use types::{BasisReport, GoverningReport, GroupReport, LooseNode, StabilityReport, ThesisReport, VibrationReport};

use crate::score::{Details, Evaluator};
use crate::structure::{Check, Critical, FloorVibration, Governing, LoadReport, Review, ThesisResult, Verdict};
use crate::voxels::{Boards, Choice, Choices};

/// What is outside every verdict, printed with each.
const NOT_ASSESSED: [&str; 10] = [
    "connections and anchors beyond the sum of their pull",
    "vibration of floors on beams that give way (joists are taken on rigid supports), and of decks",
    "fastening of boards to steel members (capacities are of nails in timber)",
    "fire",
    "seismic action",
    "wind peaks on small areas (cpe,1) and dynamic response",
    "exceptional snow (EN 1991-1-3 annex B)",
    "compression across the grain at bearings",
    "settlement and bearing of the ground; the foundation itself",
    "light-gauge (class 4) sections",
];

/// The report; the verdict stands first.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct StructureReport {
    /// `ok`, `not ok`, `unstable` or `not assessed`.
    pub verdict: &'static str,
    /// Why, in a sentence.
    pub reason: String,
    /// What governs.
    pub governing: Option<GoverningReport>,
    /// The one change that would mend a failed check.
    pub mend: Option<String>,
    /// Nodes that move in a mechanism: index, place in m, direction ux uy uz rx ry rz.
    pub loose_nodes: Vec<LooseNode>,
    /// Largest utilisation of members and sheathing.
    pub utilisation: f64,
    /// Largest storey drift over its limit.
    pub sway_ratio: f64,
    /// Largest deflection over its limit.
    pub deflection_ratio: f64,
    /// Racking of sheathing over capacity.
    pub racking_ratio: f64,
    /// The floor that vibrates worst; missing without joists above ground.
    pub vibration: Option<VibrationReport>,
    /// The thesis's yes or no; missing when no frame could be solved.
    pub thesis: Option<ThesisReport>,
    /// Standards, annex, site and size.
    pub basis: BasisReport,
    /// How well the equations of the analysis hold; missing where there is no review of the frame.
    pub solution: Option<SolutionReport>,
    /// First buckling loads; missing where they were not asked for, as in a search.
    pub critical_load: Option<CriticalReport>,
    /// Boarded walls worst first, then the worst deck and roof panel.
    pub racking: Vec<RackingReport>,
    /// Storeys, lowest first, by EN 1993-1-1 (5.2).
    pub storeys: Vec<StoreyReport>,
    /// The deformed shape that is drawn.
    pub deformed: Option<DeformedReport>,
    /// Reactions of every line of the foundation.
    pub foundation: Vec<FoundationReport>,
    /// How the sections were chosen, in a sentence; missing where they were given.
    pub sizing: Option<String>,
    /// kN of permanent, imposed and snow load, and of the reactions to it.
    pub vertical_load_kn: [f64; 2],
    /// Pull of all anchors and of the worst one under 0.9 G + 1.5 W, kN.
    pub uplift_kn: [f64; 2],
    /// The house as a whole on its anchors, worst wind under 0.9 G + 1.5 W.
    pub stability: StabilityReport,
    /// Load path in a sentence.
    pub load_path: &'static str,
    /// Sections by group.
    pub sections: Vec<GroupReport>,
    /// Members, worst first.
    pub members: Vec<MemberReport>,
    /// Stiffness and capacity of sheathing as modelled, N/m.
    pub assumptions: Vec<String>,
    /// Every action, zone, arrangement and combination with clause and source; missing when no frame could be solved.
    pub loads: Option<LoadReport>,
    /// What no verdict covers.
    pub not_assessed: [&'static str; 10],
}

impl StructureReport {
    /// The report of a house, with what a review and a search for buckling loads have found.
    pub fn new(
        details: &Details,
        evaluator: &Evaluator,
        choices: &Choices,
        review: Option<&Review>,
        critical: Option<&Critical>,
        sizing: Option<String>,
    ) -> Self {
        let assessment = details.evaluation.assessment.clone().unwrap_or_default();
        let (verdict, reason, mend) = words(&assessment.verdict, assessment.thesis.as_ref());
        let frame = details.frame.as_ref();
        let names = evaluator.sections(choices).map(|option| evaluator.catalogue.option_name(option));
        let nodes = details.frame.as_ref().map_or(&[][..], |f| &f.nodes);
        let loose_nodes = match &assessment.verdict {
            Verdict::Unstable { nodes: loose } => loose
                .iter()
                .map(|&(node, direction)| LooseNode {
                    node,
                    at_m: nodes.get(node).copied().unwrap_or([0.0; 3]),
                    direction,
                })
                .collect(),
            Verdict::Ok | Verdict::NotOk { .. } | Verdict::NotAssessed { .. } => Vec::new(),
        };
        let stability = assessment.stability;
        let storeys = review.map(review::storeys).unwrap_or_default();
        StructureReport {
            verdict,
            reason,
            governing: assessment.governing.map(governing),
            mend,
            loose_nodes,
            utilisation: assessment.utilisation,
            sway_ratio: assessment.sway_ratio,
            deflection_ratio: assessment.deflection_ratio,
            racking_ratio: assessment.racking_ratio,
            vibration: assessment.vibration.map(vibration),
            thesis: assessment.thesis.as_ref().map(thesis),
            basis: types::basis(details, evaluator),
            solution: frame.zip(review).map(|(f, r)| SolutionReport {
                nodes: f.nodes.len(),
                elements: [f.elements.len(), f.panels.len()],
                unknowns: r.unknowns,
                residual: r.residual,
            }),
            critical_load: frame.zip(critical).map(|(f, c)| review::critical(f, c, &storeys)),
            racking: review.map(review::racking).unwrap_or_default(),
            storeys,
            deformed: frame.zip(review).map(|(f, r)| review::deformed(f, r)),
            foundation: review.map(review::foundation).unwrap_or_default(),
            sizing,
            vertical_load_kn: assessment.vertical_n.map(|n| n / 1e3),
            uplift_kn: [stability.uplift_n / 1e3, stability.anchor_n / 1e3],
            stability: StabilityReport {
                overturning_ratio: stability.overturning,
                sliding_kn: stability.sliding_n / 1e3,
                friction_needed: stability.friction.is_finite().then_some(stability.friction),
            },
            load_path: "roof and floors on rafters and joists, these on studs, beams and posts, down to the foundation; wind on studs, through decks and sheathed walls to the anchors",
            sections: groups(evaluator, choices, &assessment.group_length_m, &assessment.group_mass_kg),
            members: review::members(details, &names, review),
            assumptions: assumptions(evaluator.boards(choices)),
            loads: assessment.loads.map(|loads| *loads),
            not_assessed: NOT_ASSESSED,
        }
    }
}

/// A number for people: what follows the given decimals is noise of the analysis. No negative zero.
fn round(value: f64, decimals: i32) -> f64 {
    let unit = 10f64.powi(decimals);
    (value * unit).round() / unit + 0.0
}

fn vibration(v: FloorVibration) -> VibrationReport {
    VibrationReport {
        frequency_hz: v.frequency_hz,
        deflection_mm_kn: v.deflection_m_n * 1e6,
        velocity_m_ns2: [v.velocity, v.velocity_limit],
        ratio: v.ratio,
    }
}

fn thesis(result: &ThesisResult) -> ThesisReport {
    let mpa = |pair: [f64; 2]| pair.map(|s| s / 1e6);
    ThesisReport {
        passes: result.answer(),
        rule: "1.5 x gravity and 1000 N/m of wind per windward post line; largest stress with bending under half of the strength",
        stress_mpa: mpa(result.stress),
        axial_stress_mpa: result.axial_stress / 1e6,
        limit_mpa: mpa(result.limit),
    }
}

fn words(verdict: &Verdict, thesis: Option<&ThesisResult>) -> (&'static str, String, Option<String>) {
    match verdict {
        Verdict::Ok => ("ok", "every check holds".into(), None),
        Verdict::NotOk { governing: g, mend } => {
            let g = governing(*g);
            ("not ok", format!("{}: {} at {:.2}", g.check, g.what, g.utilisation), Some(mend.to_string()))
        }
        Verdict::Unstable { nodes } => ("unstable", format!("a mechanism: {} nodes move freely", nodes.len()), None),
        Verdict::NotAssessed { reason } => {
            let answer = thesis.map_or("not asked", ThesisResult::answer);
            ("not assessed", format!("{reason} (thesis rule: {answer})"), None)
        }
    }
}

fn governing(g: Governing) -> GoverningReport {
    let what = match (g.role, g.check) {
        (Some(role), _) => format!("{} {}", role.name(), g.index),
        (None, Check::Sway) => format!("node {}", g.index),
        (None, Check::Racking(crate::frame::PanelKind::Wall)) => format!("wall with panel {}", g.index),
        (None, _) => format!("panel {}", g.index),
    };
    GoverningReport { what, check: check_name(g.check), utilisation: g.utilisation }
}

/// A check in words, with its clause.
pub fn check_name(check: Check) -> String {
    match check {
        Check::Member(clause) => format!("{} ({})", clause.name(), clause.number()),
        Check::TotalDeflection => "total deflection".into(),
        Check::VariableDeflection => "deflection under variable actions".into(),
        Check::Sway => "storey sway".into(),
        Check::Vibration => "floor vibration".into(),
        Check::Racking(kind) => format!("racking of {} sheathing", format!("{kind:?}").to_lowercase()),
    }
}

fn groups(evaluator: &Evaluator, choices: &Choices, length_m: &[f64; 4], mass_kg: &[f64; 4]) -> Vec<GroupReport> {
    let names = [Choice::Wall, Choice::Floor, Choice::Beam, Choice::Roof];
    let sections = evaluator.sections(choices);
    (0..4)
        .map(|g| GroupReport {
            group: names[g].name(),
            section: evaluator.catalogue.option_name(sections[g]),
            length_m: length_m[g],
            mass_kg: mass_kg[g],
        })
        .collect()
}

fn assumptions(boards: Boards) -> Vec<String> {
    let mut list = vec![
        "studs, joists, rafters and braces are pinned at both ends with torsion held; plates and beams run through"
            .to_owned(),
        "first order, linear elastic; buckling length = clear length between the points that hold a member".to_owned(),
        "boards hold every member but beam posts sideways (no buckling about the weak axis); they hold both edges of studs, posts in walls, plates, lintels and sills, and the upper edge of joists, trimmers, beams, rafters, hips, valleys and ridges, whose lower edge is free over the clear length (half of it where the moment changes sign) and checked for lateral torsional buckling when it is compressed; beam posts are free on both".to_owned(),
        "steel: uniform moment taken along the member (C_m = 1, C_1 = 1, or 2 where it changes sign), class of uniform compression; timber: forces at the same point combined".to_owned(),
    ];
    list.extend(crate::frame::SHEATHING.iter().zip(["wall", "deck", "roof"]).map(|(s, name)| {
        let side = match (name, boards) {
            ("wall", Boards::BothSides) => " on both sides, for each",
            ("wall", Boards::OneSide) => " on one side",
            _ => "",
        };
        format!(
            "{name} sheathing{side}: OSB/3, nails 2.8 x 65 mm at {:.0} mm along all edges; {:.0} N/m in-plane shear stiffness, {:.0} N/m short-term capacity",
            1e3 * s.nail_spacing_m, s.shear_n_per_m, s.capacity_n_per_m
        )
    }));
    list.push("sticks meet on their axes; the distances of the timber's centre lines from the axes are stated below and neglected".to_owned());
    list.extend(crate::frame::axis_offsets().iter().map(|o| {
        let (role, axis) = (o.role.name(), o.axis.name());
        format!("axis of each {role}: {axis}; centre line at {:.0} mm + {} x depth", 1e3 * o.layers_m, o.depths)
    }));
    list.push("wall boards stand upright in one piece, up to 2.8 m wide; piers narrower than half the storey count in proportion, and the piers of a wall share its load (EN 1995-1-1 9.2.4.2, method A)".to_owned());
    list.push("members and anchors under full wind pressures; pressure on the windward and suction on the leeward wall are lowered for lack of correlation (EN 1991-1-4 7.2.2(3)) in racking and drift only".to_owned());
    list
}
