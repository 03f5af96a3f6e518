//! From a frame with sections and loads to an assessment.

use super::actions::{BaseActions, Sum};
use super::cases::CaseLoads;
use super::catalogue::{Catalogue, SectionOption};
use super::combine::{Combination, ultimate};
use super::loads::LoadSettings;
use super::model::fill_model;
use super::screen::Screen;
use super::serviceability::{self, span_ratio, sway};
use super::stability::stability;
use super::verdict::{Assessment, Check, Governing, MemberResult, Mend, Verdict};
use super::vibration::{floor_areas, of_span};
use super::{report, strength};
use crate::analysis::{LoadCase, Model, Solution, Solver, Status};
use crate::frame::{HouseFrame, PanelKind, Span};
use crate::voxels::Boards;

/// Buffers of [`assess`], to be kept between houses, and what is asked of it.
#[derive(Default)]
pub struct Workspace {
    solver: Solver,
    pub(super) solution: Solution,
    model: Model,
    pub(super) loads: CaseLoads,
    cases: Vec<LoadCase>,
    pub(super) actions: BaseActions,
    screen: Screen,
    floor_m2: Vec<f64>,
    bounds: Vec<f64>,
    /// Keep per-member results.
    pub detail: bool,
    /// Report every load with its clause.
    pub report: bool,
    /// Ask for the thesis rule too; five more load cases. Settings of the thesis preset alone always ask for it.
    pub thesis: bool,
}

impl Workspace {
    /// A workspace that keeps per-member results, reports the loads and answers the thesis rule.
    pub fn detailed() -> Workspace {
        Workspace { detail: true, report: true, thesis: true, ..Workspace::default() }
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
    w.loads.fill(frame, loads);
    let ask_thesis = w.thesis || loads.preset_only;
    w.loads.lend(ask_thesis, &mut w.cases);
    let solved = w.solver.solve_into(&w.model, &w.cases, &mut w.solution);
    w.loads.give_back(&mut w.cases);
    if solved.is_err() {
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
    result.thesis = ask_thesis.then(|| super::thesis::thesis(frame, catalogue, sections, loads, &w.loads, &w.solution));
    if loads.preset_only {
        result.verdict = Verdict::NotAssessed {
            reason: "thesis preset: no imposed load, buckling or deflection; see its yes or no",
        };
        return result;
    }
    let combinations = ultimate(loads, &w.loads);
    w.actions.fill(frame, loads, &w.loads, &w.solution);
    check_all(frame, catalogue, sections, loads, &combinations, w, &mut result);
    result.stability = stability(frame, loads, &w.loads, &w.solution);
    result.vertical_n = report::balance(frame, &w.model, &w.loads, &w.solution);
    if w.report {
        let made = report::report(frame, loads, &w.model, &w.loads, &w.actions, &combinations, &w.solution);
        result.loads = Some(Box::new(made));
    }
    judge(frame, &mut result);
    result
}

/// Every check that the verdict rests on.
fn check_all(
    frame: &HouseFrame,
    catalogue: &Catalogue,
    sections: &[SectionOption; 4],
    loads: &LoadSettings,
    combinations: &[Combination],
    w: &mut Workspace,
    result: &mut Assessment,
) {
    if w.detail {
        let none = MemberResult { utilisation: 0.0, check: strength::UNLOADED, deflection_ratio: 0.0 };
        result.members = vec![none; frame.members.len()];
    }
    let k_mod = &catalogue.k_mod.timber;
    let sums: Vec<Sum> = combinations.iter().map(|c| Sum::new(c, k_mod[c.duration as usize])).collect();
    let loaded = strength::Loaded { frame, solution: &w.solution, actions: &w.actions, sums: &sums };
    strength::members(&loaded, catalogue, sections, &mut w.screen, result);
    strength::racking(&loaded, catalogue, combinations, result);
    deflections(frame, catalogue, sections, loads, w, result);
    vibration(frame, catalogue, sections, loads, w, result);
}

/// What is known of a frame without a solve: lengths and masses, by section group and together; no verdict, no ratios.
pub fn masses(frame: &HouseFrame, catalogue: &Catalogue, sections: &[SectionOption; 4]) -> Assessment {
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
    w: &mut Workspace,
    result: &mut Assessment,
) {
    let exact = |span: &Span| span_ratio(frame, catalogue, [sections; 2], loads, &w.solution, &w.actions, span);
    // Where no results by member are kept, the largest ratio is the same without the spans that cannot reach it.
    let only_worst = result.members.is_empty();
    let mut floor = 0.0;
    w.bounds.clear();
    if only_worst {
        let bound = |span| serviceability::bound(frame, catalogue, sections, loads, &w.solution, &w.actions, span);
        w.bounds.extend(frame.spans.iter().map(bound));
        let finite = w.bounds.iter().enumerate().filter(|(_, b)| b.is_finite());
        let first = finite.max_by(|a, b| a.1.total_cmp(b.1));
        floor = first.map_or(0.0, |(at, _)| exact(&frame.spans[at]).0);
    }
    for (at, span) in frame.spans.iter().enumerate() {
        if only_worst && w.bounds[at] < floor {
            continue;
        }
        let (ratio, check) = exact(span);
        let index = span.member as usize;
        let role = frame.members[index].role;
        result.deflection_ratio = result.deflection_ratio.max(ratio);
        if let Some(kept) = result.members.get_mut(index) {
            kept.deflection_ratio = kept.deflection_ratio.max(ratio);
        }
        govern(result, Governing { index, role: Some(role), check, utilisation: ratio });
    }
    let (ratio, node) = sway(frame, loads, &w.actions);
    result.sway_ratio = ratio;
    govern(result, Governing { index: node, role: None, check: Check::Sway, utilisation: ratio });
}

/// Floors of rooms; the worst joist stands for the house.
fn vibration(
    frame: &HouseFrame,
    catalogue: &Catalogue,
    sections: &[SectionOption; 4],
    loads: &LoadSettings,
    w: &mut Workspace,
    result: &mut Assessment,
) {
    floor_areas(frame, &mut w.floor_m2);
    for span in &frame.spans {
        let found = of_span(frame, catalogue, sections, loads, &w.solution, &w.floor_m2, span);
        let Some(floor) = found else { continue };
        if result.vibration.is_none_or(|worst| floor.ratio > worst.ratio) {
            result.vibration = Some(floor);
            let index = span.member as usize;
            let role = Some(frame.members[index].role);
            govern(result, Governing { index, role, check: Check::Vibration, utilisation: floor.ratio });
        }
    }
}

fn judge(frame: &HouseFrame, result: &mut Assessment) {
    result.verdict = match result.governing {
        Some(g) if g.utilisation > 1.0 => {
            let mend = match (g.check, g.role) {
                (Check::Racking(PanelKind::Wall) | Check::Sway, _) if frame.boards == Boards::OneSide => {
                    Mend::SecondSide
                }
                (Check::Racking(kind), _) => Mend::Boards(kind),
                (_, Some(_)) => Mend::Section(frame.members[g.index].group),
                (_, None) => Mend::Boards(PanelKind::Wall),
            };
            Verdict::NotOk { governing: g, mend }
        }
        _ => Verdict::Ok,
    };
}
