//! From a frame with sections and loads to an assessment.

use super::actions::BaseActions;
use super::catalogue::{Catalogue, SectionOption};
use super::combine::{ultimate, winds};
use super::loads::LoadSettings;
use super::model::{CASES, Case, UNITS, fill_model, load_cases};
use super::serviceability::{frequency, span_ratio, sway};
use super::strength;
use super::verdict::{Assessment, Check, Governing, MemberResult, Mend, Verdict};
use crate::analysis::{Distribution, LoadCase, Model, Solution, Solver, Status};
use crate::frame::HouseFrame;

/// Buffers of [`assess`], to be kept between houses, and what is asked of it.
#[derive(Default)]
pub struct Workspace {
    solver: Solver,
    solution: Solution,
    model: Model,
    cases: Vec<LoadCase>,
    actions: BaseActions,
    /// Keep per-member results.
    pub detail: bool,
    /// Ask for the thesis rule too; five more load cases. Settings of the thesis preset alone always ask for it.
    pub thesis: bool,
}

impl Workspace {
    /// A workspace that keeps per-member results and answers the thesis rule.
    pub fn detailed() -> Workspace {
        Workspace { detail: true, thesis: true, ..Workspace::default() }
    }
}

/// Assesses a frame. `sections` are the options of wall, floor, beam and roof.
pub fn assess(
    frame: &HouseFrame,
    catalogue: &Catalogue,
    sections: &[SectionOption; 4],
    loads: &LoadSettings,
    workspace: &mut Workspace,
) -> Assessment {
    let mut result = masses(frame, catalogue, sections);
    if sections.iter().any(|&s| catalogue.is_class_4(s)) {
        result.verdict = Verdict::NotAssessed {
            reason: "a section is class 4 in compression (EN 1993-1-1 5.5): local buckling is not assessed",
        };
        return result;
    }
    let w = workspace;
    fill_model(frame, catalogue, sections, &mut w.model);
    load_cases(frame, loads, &mut w.cases);
    let ask_thesis = w.thesis || loads.preset_only;
    let asked = if ask_thesis { CASES } else { UNITS };
    if w.solver.solve_into(&w.model, &w.cases[..asked], &mut w.solution).is_err() {
        result.verdict = Verdict::NotAssessed { reason: "the frame is no valid model" };
        return result;
    }
    match &w.solution.status {
        Status::Solved { .. } => {}
        Status::Unstable(m) | Status::NearlySingular { weakest: m, .. } => {
            let nodes = m.motions.iter().map(|n| (n.node, n.direction)).collect();
            result.verdict = Verdict::Unstable { nodes };
            return result;
        }
        Status::Empty => {
            result.verdict = Verdict::NotAssessed { reason: "nothing to solve" };
            return result;
        }
    }
    result.thesis = ask_thesis.then(|| super::thesis::thesis(frame, catalogue, sections, loads, &w.solution));
    if loads.preset_only {
        result.verdict = Verdict::NotAssessed {
            reason: "thesis preset: no imposed load, buckling or deflection; see its yes or no",
        };
        return result;
    }
    if w.detail {
        let none = MemberResult { utilisation: 0.0, check: strength::UNLOADED, deflection_ratio: 0.0 };
        result.members = vec![none; frame.members.len()];
    }
    let combinations = ultimate(loads);
    w.actions.fill(frame, loads, &w.solution);
    strength::members(frame, catalogue, sections, &combinations, &w.solution, &w.actions, &mut result);
    strength::racking(frame, catalogue, loads, &combinations, &w.solution, &mut result);
    deflections(frame, catalogue, sections, loads, w, &mut result);
    anchors(frame, loads, &w.solution, &mut result);
    result.vertical_n = balance(frame, w);
    judge(frame, &mut result);
    result
}

fn masses(frame: &HouseFrame, catalogue: &Catalogue, sections: &[SectionOption; 4]) -> Assessment {
    let mut result = Assessment { group_length_m: frame.length_by_group_m(), ..Assessment::default() };
    for (g, &option) in sections.iter().enumerate() {
        let mass = catalogue.material(option).rho * catalogue.section(option).a;
        result.group_mass_kg[g] = mass * result.group_length_m[g];
    }
    result.frame_mass_kg = result.group_mass_kg.iter().sum();
    result
}

/// Keeps the worst check of all.
pub(super) fn govern(result: &mut Assessment, candidate: Governing) {
    if result.governing.is_none_or(|g| candidate.utilisation > g.utilisation) {
        result.governing = Some(candidate);
    }
}

fn deflections(
    frame: &HouseFrame,
    catalogue: &Catalogue,
    sections: &[SectionOption; 4],
    loads: &LoadSettings,
    w: &Workspace,
    result: &mut Assessment,
) {
    result.floor_frequency_hz = f64::INFINITY;
    for span in &frame.spans {
        let (ratio, check, permanent) = span_ratio(frame, catalogue, sections, loads, &w.solution, &w.actions, span);
        let index = span.member as usize;
        let role = frame.members[index].role;
        result.deflection_ratio = result.deflection_ratio.max(ratio);
        if let Some(hz) = frequency(role, permanent) {
            result.floor_frequency_hz = result.floor_frequency_hz.min(hz);
        }
        if let Some(kept) = result.members.get_mut(index) {
            kept.deflection_ratio = kept.deflection_ratio.max(ratio);
        }
        govern(result, Governing { index, role: Some(role), check, utilisation: ratio });
    }
    let (ratio, node) = sway(frame, loads, &w.solution);
    result.sway_ratio = ratio;
    govern(result, Governing { index: node, role: None, check: Check::Sway, utilisation: ratio });
}

/// Pull of the anchors under 0.9 G + 1.5 W, full pressures.
fn anchors(frame: &HouseFrame, loads: &LoadSettings, solution: &Solution, result: &mut Assessment) {
    let reactions: [&[[f64; 6]]; UNITS] = std::array::from_fn(|c| solution.reactions(c));
    for f in &winds(frame, loads, false) {
        let mut sum = 0.0;
        for (s, own) in reactions[Case::Permanent as usize].iter().enumerate() {
            let wind: f64 = (Case::Walls as usize..UNITS).map(|c| f[c] * reactions[c][s][2]).sum();
            let up = -(0.9 * own[2] + 1.5 * wind);
            sum += up.max(0.0);
            result.anchor_n = result.anchor_n.max(up);
        }
        result.uplift_n = f64::max(result.uplift_n, sum);
    }
}

/// Vertical load of permanent + imposed + snow, and the reactions to it.
fn balance(frame: &HouseFrame, w: &Workspace) -> [f64; 2] {
    let gravity = [Case::Permanent, Case::Imposed, Case::Snow].map(|c| c as usize);
    let up = gravity.iter().flat_map(|&c| w.solution.reactions(c).iter().map(|r| r[2])).sum();
    let mut down = 0.0;
    for (e, m) in w.model.members.iter().take(frame.elements.len()).enumerate() {
        down += 9.81 * w.model.materials[m.material].rho * w.model.sections[m.section].a * w.solution.length(e);
    }
    for l in gravity.iter().flat_map(|&c| &w.cases[c].members) {
        if let Distribution::Uniform { q } = l.distribution {
            down -= q[2] * w.solution.length(l.member);
        }
    }
    [down, up]
}

fn judge(frame: &HouseFrame, result: &mut Assessment) {
    result.verdict = match result.governing {
        Some(g) if g.utilisation > 1.0 => {
            let mend = match (g.check, g.role) {
                (Check::Racking(kind), _) => Mend::Boards(kind),
                (_, Some(_)) => Mend::Section(frame.members[g.index].group),
                (_, None) => Mend::Boards(crate::frame::PanelKind::Wall),
            };
            Verdict::NotOk { governing: g, mend }
        }
        _ => Verdict::Ok,
    };
}
