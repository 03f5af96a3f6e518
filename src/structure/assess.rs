//! From a frame with sections and loads to an assessment.

use super::catalogue::{Catalogue, SectionOption};
use super::check::{Piece, Resistance, section_forces, stations};
use super::combine::{Combination, ultimate, winds};
use super::loads::LoadSettings;
use super::model::{CASES, Case, analysis_model, load_cases};
use super::serviceability::{Actions, frequency, span_ratio, sway, transverse};
use super::verdict::{Assessment, Check, Governing, MemberResult, Mend, ThesisResult, Verdict};
use crate::analysis::{Distribution, LoadCase, Solution, Solver, Status};
use crate::frame::HouseFrame;

/// Base actions: permanent, imposed, snow, sixteen winds.
const ACTIONS: usize = 19;

/// Buffers of [`assess`], to be kept between houses.
#[derive(Default)]
pub struct Workspace {
    solver: Solver,
    solution: Solution,
    cases: Vec<LoadCase>,
    uniform: Vec<[f64; 3]>,
    pieces: Vec<Piece>,
    moves: Vec<[f64; 3]>,
    /// Keep per-member results.
    pub detail: bool,
}

impl Workspace {
    /// A workspace that keeps per-member results.
    pub fn detailed() -> Workspace {
        Workspace { detail: true, ..Workspace::default() }
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
    let mut result = Assessment { group_length_m: frame.length_by_group_m(), ..Assessment::default() };
    for (g, &option) in sections.iter().enumerate() {
        let mass = catalogue.material(option).rho * catalogue.section(option).a;
        result.group_mass_kg[g] = mass * result.group_length_m[g];
    }
    result.frame_mass_kg = result.group_mass_kg.iter().sum();
    let model = analysis_model(frame, catalogue, sections);
    load_cases(frame, loads, &mut workspace.cases);
    let solved = workspace.solver.solve_into(&model, &workspace.cases, &mut workspace.solution);
    if solved.is_err() {
        result.verdict = Verdict::NotAssessed { reason: "the frame is no valid model" };
        return result;
    }
    match &workspace.solution.status {
        Status::Solved { .. } => {}
        Status::Unstable(m) | Status::NearlySingular { weakest: m, .. } => {
            result.verdict = Verdict::Unstable { nodes: moving(m) };
            return result;
        }
        Status::Empty => {
            result.verdict = Verdict::NotAssessed { reason: "nothing to solve" };
            return result;
        }
    }
    local_uniform(frame, &model.materials, &model, workspace);
    thesis(frame, catalogue, sections, loads, workspace, &mut result);
    if loads.preset_only {
        result.verdict = Verdict::NotAssessed {
            reason: "thesis preset: no imposed load, buckling or deflection; see its yes or no",
        };
        return result;
    }
    base_actions(frame, loads, workspace);
    strength(frame, catalogue, sections, loads, workspace, &mut result);
    racking(frame, loads, workspace, &mut result);
    deflections(frame, catalogue, sections, loads, workspace, &mut result);
    supports(frame, loads, workspace, &mut result);
    judge(frame, &mut result);
    result
}

fn moving(m: &crate::analysis::Mechanism) -> Vec<(usize, [f64; 6])> {
    m.motions.iter().map(|n| (n.node, n.direction)).collect()
}

/// Uniform loads in local axes per case and element, gravity included.
fn local_uniform(
    frame: &HouseFrame,
    materials: &[crate::analysis::Material],
    model: &crate::analysis::Model,
    w: &mut Workspace,
) {
    let n = frame.elements.len();
    w.uniform.clear();
    w.uniform.resize(n * CASES, [0.0; 3]);
    for (e, element) in model.members.iter().take(n).enumerate() {
        w.uniform[e * CASES][2] = -9.81 * materials[element.material].rho * model.sections[element.section].a;
    }
    for (c, case) in w.cases.iter().enumerate() {
        for l in &case.members {
            if let Distribution::Uniform { q } = l.distribution {
                let sum = &mut w.uniform[l.member * CASES + c];
                (0..3).for_each(|a| sum[a] += q[a]);
            }
        }
    }
    for e in 0..n {
        let member = &frame.members[frame.elements[e].member as usize];
        let [i, j] = frame.elements[e].nodes.map(|k| frame.nodes[k as usize]);
        let length = frame.element_length_m(e);
        let x = [0, 1, 2].map(|a| (j[a] - i[a]) / length);
        let [y, z] = transverse(frame, e, member.reference);
        for q in &mut w.uniform[e * CASES..(e + 1) * CASES] {
            *q = [x, y, z].map(|axis| (0..3).map(|a| axis[a] * q[a]).sum());
        }
    }
}

fn unit_piece(w: &Workspace, element: usize, case: usize) -> Piece {
    let f = &w.solution.end_forces(case)[element];
    let q = w.uniform[element * CASES + case];
    [f[0], f[1], f[2], f[4], f[5], q[0], q[1], q[2]]
}

fn add(into: &mut Piece, f: f64, p: &Piece) {
    (0..8).for_each(|n| into[n] += f * p[n]);
}

/// Adds up unit cases to the base actions, for every element and node.
fn base_actions(frame: &HouseFrame, loads: &LoadSettings, w: &mut Workspace) {
    let winds = winds(frame, loads);
    let (pieces, moves) = (&mut Vec::new(), &mut Vec::new());
    std::mem::swap(pieces, &mut w.pieces);
    std::mem::swap(moves, &mut w.moves);
    pieces.clear();
    moves.clear();
    for e in 0..frame.elements.len() {
        let unit: [Piece; 13] = std::array::from_fn(|c| unit_piece(w, e, c));
        let mut sum = unit[0];
        add(&mut sum, 1.0, &unit[1]);
        pieces.extend([sum, unit[2], unit[3]]);
        for f in &winds {
            let mut sum = [0.0; 8];
            (4..13).filter(|&c| f[c] != 0.0).for_each(|c| add(&mut sum, f[c], &unit[c]));
            pieces.push(sum);
        }
    }
    for n in 0..frame.nodes.len() {
        let unit: [[f64; 3]; 13] = std::array::from_fn(|c| {
            let u = w.solution.displacements(c)[n];
            [u[0], u[1], u[2]]
        });
        moves.push([0, 1, 2].map(|a| unit[0][a] + unit[1][a]));
        moves.extend([unit[2], unit[3]]);
        for f in &winds {
            moves.push([0, 1, 2].map(|a| (4..13).map(|c| f[c] * unit[c][a]).sum()));
        }
    }
    std::mem::swap(pieces, &mut w.pieces);
    std::mem::swap(moves, &mut w.moves);
}

fn combined(actions: &[Piece], c: &Combination) -> Piece {
    let mut sum = [0.0; 8];
    add(&mut sum, c.permanent, &actions[0]);
    for (f, n) in [(c.imposed, 1), (c.snow, 2)].into_iter().chain(c.wind.map(|(n, f)| (f, 3 + n))) {
        if f != 0.0 {
            add(&mut sum, f, &actions[n]);
        }
    }
    sum
}

fn strength(
    frame: &HouseFrame,
    catalogue: &Catalogue,
    sections: &[SectionOption; 4],
    loads: &LoadSettings,
    w: &Workspace,
    result: &mut Assessment,
) {
    let combinations = ultimate(loads);
    if w.detail {
        let none = MemberResult { utilisation: 0.0, check: Check::Bending, deflection_ratio: 0.0 };
        result.members = vec![none; frame.members.len()];
    }
    for span in &frame.spans {
        let member = &frame.members[span.member as usize];
        let option = sections[member.group as usize];
        let range = span.elements[0] as usize..=span.elements[1] as usize;
        let clear: f64 = range.clone().map(|e| frame.element_length_m(e)).sum();
        let r = Resistance::new(
            catalogue.material(option),
            catalogue.section(option),
            member.plies,
            clear,
            member.role.is_sheathed(),
        );
        let mut worst = (0.0, Check::Bending);
        for e in range {
            let length = frame.element_length_m(e);
            let actions = &w.pieces[e * ACTIONS..(e + 1) * ACTIONS];
            for c in &combinations {
                let p = combined(actions, c);
                let (xs, n) = stations(&p, length);
                for &x in &xs[..n] {
                    let ratio = r.ratio(section_forces(&p, x), c.duration.k_mod());
                    if ratio.0 > worst.0 {
                        worst = ratio;
                    }
                }
            }
        }
        let index = span.member as usize;
        if w.detail && worst.0 > result.members[index].utilisation {
            (result.members[index].utilisation, result.members[index].check) = worst;
        }
        result.utilisation = result.utilisation.max(worst.0);
        govern(result, Governing { index, role: Some(member.role), check: worst.1, utilisation: worst.0 });
    }
}

fn govern(result: &mut Assessment, candidate: Governing) {
    if result.governing.is_none_or(|g| candidate.utilisation > g.utilisation) {
        result.governing = Some(candidate);
    }
}

fn racking(frame: &HouseFrame, loads: &LoadSettings, w: &Workspace, result: &mut Assessment) {
    let combinations = ultimate(loads);
    let winds = winds(frame, loads);
    let overall = |n: usize| loads.correlation(frame.size_m[2] / frame.size_m[n / 4 % 2]);
    for (n, panel) in frame.panels.iter().enumerate() {
        let unit: [f64; 13] = std::array::from_fn(|c| w.solution.end_forces(c)[frame.elements.len() + n][0]);
        let wind = winds.map(|f| (4..13).map(|c| f[c] * unit[c]).sum::<f64>());
        let worst = combinations
            .iter()
            .map(|c| {
                let gusts = c.wind.map_or(0.0, |(n, f)| f * wind[n] * overall(n));
                (c.permanent * (unit[0] + unit[1]) + c.imposed * unit[2] + c.snow * unit[3] + gusts).abs()
            })
            .fold(0.0, f64::max)
            / panel.capacity_n;
        result.racking_ratio = result.racking_ratio.max(worst);
        result.utilisation = result.utilisation.max(worst);
        govern(result, Governing { index: n, role: None, check: Check::Racking(panel.kind), utilisation: worst });
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
    let actions = Actions { pieces: &w.pieces, moves: &w.moves, count: ACTIONS };
    result.floor_frequency_hz = f64::INFINITY;
    for span in &frame.spans {
        let (ratio, check, permanent) = span_ratio(frame, catalogue, sections, loads, &actions, span);
        let index = span.member as usize;
        let role = frame.members[index].role;
        result.deflection_ratio = result.deflection_ratio.max(ratio);
        if let Some(hz) = frequency(role, permanent) {
            result.floor_frequency_hz = result.floor_frequency_hz.min(hz);
        }
        if w.detail {
            let kept = &mut result.members[index].deflection_ratio;
            *kept = kept.max(ratio);
        }
        govern(result, Governing { index, role: Some(role), check, utilisation: ratio });
    }
    let (ratio, node) = sway(frame, loads, &actions);
    result.sway_ratio = ratio;
    govern(result, Governing { index: node, role: None, check: Check::Sway, utilisation: ratio });
}

/// Anchors under 0.9 G + 1.5 W, and the balance of vertical load and reactions.
fn supports(frame: &HouseFrame, loads: &LoadSettings, w: &Workspace, result: &mut Assessment) {
    let winds = winds(frame, loads);
    let reactions: Vec<&[[f64; 6]]> = (0..13).map(|c| w.solution.reactions(c)).collect();
    for f in &winds {
        let mut sum = 0.0;
        for (s, own) in reactions[0].iter().enumerate() {
            let wind: f64 = (4..13).map(|c| f[c] * reactions[c][s][2]).sum();
            let up = -(0.9 * (own[2] + reactions[1][s][2]) + 1.5 * wind);
            sum += up.max(0.0);
            result.anchor_n = result.anchor_n.max(up);
        }
        result.uplift_n = f64::max(result.uplift_n, sum);
    }
    let up: f64 = (0..4).flat_map(|c| reactions[c].iter().map(|r| r[2])).sum();
    let mut down = 9.81 * analysed_mass(frame, w);
    for case in &w.cases[1..4] {
        for l in &case.members {
            if let Distribution::Uniform { q } = l.distribution {
                down -= q[2] * frame.element_length_m(l.member);
            }
        }
    }
    result.vertical_n = [down, up];
}

fn analysed_mass(frame: &HouseFrame, w: &Workspace) -> f64 {
    (0..frame.elements.len())
        .map(|e| {
            let q = w.uniform[e * CASES];
            (q[0] * q[0] + q[1] * q[1] + q[2] * q[2]).sqrt() / 9.81 * frame.element_length_m(e)
        })
        .sum()
}

fn thesis(
    frame: &HouseFrame,
    catalogue: &Catalogue,
    sections: &[SectionOption; 4],
    loads: &LoadSettings,
    w: &Workspace,
    result: &mut Assessment,
) {
    let mut out = ThesisResult::default();
    for (e, element) in frame.elements.iter().enumerate() {
        let member = &frame.members[element.member as usize];
        let option = sections[member.group as usize];
        let m = catalogue.material(option);
        let length = frame.element_length_m(e);
        let r = Resistance::new(m, catalogue.section(option), member.plies, length, true);
        let own = unit_piece(w, e, Case::Frame as usize);
        for side in 0..4 {
            let mut p = unit_piece(w, e, Case::Thesis as usize + side);
            add(&mut p, loads.thesis_gravity, &own);
            let (xs, n) = stations(&p, length);
            for &x in &xs[..n] {
                let [t, c, axial] = r.extremes(section_forces(&p, x));
                out.stress = [out.stress[0].max(t), out.stress[1].max(c)];
                out.axial_stress = out.axial_stress.max(axial.abs());
                let ratio = (t / m.thesis_limit[0]).max(c / m.thesis_limit[1]);
                if ratio > out.ratio {
                    (out.ratio, out.limit) = (ratio, m.thesis_limit);
                }
            }
        }
    }
    out.passes = out.ratio <= 1.0;
    result.thesis = out;
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
