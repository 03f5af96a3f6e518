//! Deflections and drift.

use super::actions::{BASES, BaseActions};
use super::catalogue::{Catalogue, SectionOption};
use super::check::{Piece, section_forces};
use super::combine::{GRAVITY, PRESSED, SNOWS, WINDS_A_SIDE};
use super::loads::LoadSettings;
use super::screen::Reach;
use super::verdict::Check;
use crate::analysis::Solution;
use crate::frame::{HouseFrame, Span};

/// Largest deflection of a span over its limit, and the check. `analysed` are the sections of the solution: with `sections` that are
/// others, the nodes of the span are taken to leave its chord in proportion to its flexibility, which is exact where its forces stay.
pub(super) fn span_ratio(
    frame: &HouseFrame,
    catalogue: &Catalogue,
    [sections, analysed]: [&[SectionOption; 4]; 2],
    loads: &LoadSettings,
    solution: &Solution,
    actions: &BaseActions,
    span: &Span,
) -> (f64, Check) {
    let member = &frame.members[span.member as usize];
    let option = sections[member.group as usize];
    let (m, s) = (catalogue.material(option), catalogue.section(option));
    let creep = m.k_def;
    let stiffness = [s.iy, s.iz].map(|i| m.e * i * f64::from(member.plies));
    let was = analysed[member.group as usize];
    let nodes_bend = if was == option {
        [1.0; 2]
    } else {
        let (m, s) = (catalogue.material(was), catalogue.section(was));
        [m.e * s.iz * f64::from(member.plies) / stiffness[1], m.e * s.iy * f64::from(member.plies) / stiffness[0]]
    };
    let (first, last) = (span.elements[0] as usize, span.elements[1] as usize);
    let length: f64 = (first..=last).map(|e| solution.length(e)).sum();
    let cantilever = !(span.held[0] && span.held[1]);
    let limit = |l: f64| l / (if cantilever { 2.0 } else { 1.0 } * length);
    let ends = [frame.elements[first].nodes[0], frame.elements[last].nodes[1]].map(|n| actions.node(n as usize));
    let mut worst = (0.0f64, Check::TotalDeflection);
    let mut before = 0.0;
    for e in first..=last {
        let own = solution.length(e);
        for part in [0.5, 1.0] {
            if part == 1.0 && e == last && !cantilever {
                continue;
            }
            let along = (before + part * own) / length;
            let w = deflections(frame, solution, actions, e, part, [stiffness, nodes_bend], |b| {
                let [c, d] = [ends[0][b], ends[1][b]];
                match span.held {
                    [true, false] => c,
                    [false, true] => d,
                    _ => [0, 1, 2].map(|x| c[x] + along * (d[x] - c[x])),
                }
            });
            let (total, variable) = combined(loads, &w, creep, &actions.snows);
            let total = (total * limit(loads.limits[0]), Check::TotalDeflection);
            let variable = (variable * limit(loads.limits[1]), Check::VariableDeflection);
            for candidate in [total, variable] {
                if candidate.0 > worst.0 {
                    worst = candidate;
                }
            }
        }
        before += own;
    }
    worst
}

/// What [`span_ratio`] does not exceed, with room for rounding; infinite where nothing simple can be said.
///
/// A span of one element held at both ends deflects from its chord by no more than a simple beam under its largest moment everywhere:
/// M l^2 / (8 E I).
pub(super) fn bound(
    frame: &HouseFrame,
    catalogue: &Catalogue,
    sections: &[SectionOption; 4],
    loads: &LoadSettings,
    solution: &Solution,
    actions: &BaseActions,
    span: &Span,
) -> f64 {
    if span.held != [true, true] || span.elements[0] != span.elements[1] {
        return f64::INFINITY;
    }
    let member = &frame.members[span.member as usize];
    let option = sections[member.group as usize];
    let (m, s) = (catalogue.material(option), catalogue.section(option));
    let e = span.elements[0] as usize;
    let length = solution.length(e);
    let bow = [s.iy, s.iz].map(|i| 0.125 * length * length / (m.e * i * f64::from(member.plies)));
    let w: [f64; BASES] = std::array::from_fn(|base| {
        let Reach([.., my, mz]) = Reach::of(actions.piece(e, base), length);
        my * bow[0] + mz * bow[1]
    });
    let [p_q, p_s, _] = loads.psi0;
    let snow = w[2..GRAVITY].iter().copied().fold(0.0, f64::max);
    let wind = w[GRAVITY..].iter().copied().fold(0.0, f64::max);
    let creep = m.k_def;
    let imposed = p_q.max(1.0) + loads.psi2[0] * creep;
    let total = w[0] * (1.0 + creep) + w[1] * imposed + snow * (p_s.max(1.0) + loads.psi2[1] * creep);
    let variable = (w[1] * p_q.max(1.0) + snow * p_s.max(1.0)).max(wind);
    1.000_001 * (total * loads.limits[0]).max(variable * loads.limits[1]) / length
}

/// Deflections of a point of an element under the base actions against `chord` (of its span, or the held end of a cantilever),
/// global axes, only across the stick. The nodes' part counts `nodes_bend` times along local y and z.
fn deflections(
    frame: &HouseFrame,
    solution: &Solution,
    actions: &BaseActions,
    element: usize,
    part: f64,
    [stiffness, nodes_bend]: [[f64; 2]; 2],
    chord: impl Fn(usize) -> [f64; 3],
) -> [[f64; 3]; BASES] {
    let [a, b] = frame.elements[element].nodes.map(|n| actions.node(n as usize));
    let [x, y, z] = solution.axes(element);
    let length = solution.length(element);
    std::array::from_fn(|base| {
        let mut own = own_deflection(actions.piece(element, base), length, part, stiffness);
        let (a, b, c) = (a[base], b[base], chord(base));
        if nodes_bend != [1.0; 2] {
            let moved = [0, 1, 2].map(|n| a[n] + part * (b[n] - a[n]) - c[n]);
            let along = |axis: &[f64; 3]| (0..3).map(|n| moved[n] * axis[n]).sum::<f64>();
            own = [own[0] + (nodes_bend[0] - 1.0) * along(y), own[1] + (nodes_bend[1] - 1.0) * along(z)];
        }
        let raw = [0, 1, 2].map(|n| a[n] + part * (b[n] - a[n]) - c[n] + own[0] * y[n] + own[1] * z[n]);
        let along: f64 = (0..3).map(|n| raw[n] * x[n]).sum();
        [0, 1, 2].map(|n| raw[n] - along * x[n])
    })
}

fn norm(v: [f64; 3]) -> f64 {
    (v[0] * v[0] + v[1] * v[1] + v[2] * v[2]).sqrt()
}

/// Total deflection with creep and variable deflection, each the largest over its combinations: characteristic (EN 1990 6.14b), with
/// the creep of the quasi-permanent part (EN 1995-1-1 2.2.3: kdef on permanent load, psi2 kdef on imposed load and snow).
fn combined(loads: &LoadSettings, w: &[[f64; 3]; BASES], creep: f64, snows: &[bool; SNOWS]) -> (f64, f64) {
    let sum = |terms: &[(usize, f64)]| norm([0, 1, 2].map(|a| terms.iter().map(|&(base, f)| f * w[base][a]).sum()));
    let [p_q, p_s, _] = loads.psi0;
    let (g, q, s) = (1.0 + creep, 1.0 + loads.psi2[0] * creep, loads.psi2[1] * creep);
    let mut total = sum(&[(0, g), (1, q), (2, p_s + s)]);
    let mut variable = sum(&[(1, 1.0), (2, p_s)]);
    for arrangement in (0..SNOWS).filter(|&n| snows[n]) {
        let base = 2 + arrangement;
        total = total.max(sum(&[(0, g), (1, p_q + loads.psi2[0] * creep), (base, 1.0 + s)]));
        variable = variable.max(sum(&[(1, p_q), (base, 1.0)]));
    }
    variable = w[GRAVITY..].iter().map(|&wind| norm(wind)).fold(variable, f64::max);
    (total, variable)
}

/// Deflection inside a piece against its own chord at `part`, local y and z: end moments and uniform load on a simple beam.
fn own_deflection(p: &Piece, length: f64, part: f64, [ei_y, ei_z]: [f64; 2]) -> [f64; 2] {
    let ends = [section_forces(p, 0.0), section_forces(p, length)];
    let bow = |m0: f64, m1: f64, q: f64, ei: f64| {
        let (a, b) = (part, 1.0 - part);
        // v'' = M / EI with M linear plus q x^2 / 2 - q l x / 2.
        let linear = -length * length * a * b * (m0 * (1.0 + b) + m1 * (1.0 + a)) / 6.0;
        let uniform = q * length.powi(4) * a * (1.0 - 2.0 * a * a + a.powi(3)) / 24.0;
        (linear + uniform) / ei
    };
    // About z, M = EI v''; about y, M = -EI w''.
    [bow(ends[0][4], ends[1][4], p[6], ei_z), bow(-ends[0][3], -ends[1][3], p[7], ei_y)]
}

/// Largest storey drift over its limit, and the node; wind as an action on the house as a whole.
pub(super) fn sway(frame: &HouseFrame, loads: &LoadSettings, actions: &BaseActions) -> (f64, usize) {
    let mut worst = (0.0, 0);
    for (n, level) in frame.levels.iter().enumerate().skip(1) {
        // The eave over a knee wall is measured from the floor below it.
        let mut lower = n - 1;
        if level.z_m - frame.levels[lower].z_m < 1.5 && lower > 0 {
            lower -= 1;
        }
        let lower = &frame.levels[lower];
        for &node in &level.nodes {
            let p = frame.nodes[node as usize];
            let under = lower.nodes.iter().find(|&&m| {
                let q = frame.nodes[m as usize];
                (p[0] - q[0]).abs() < 1e-6 && (p[1] - q[1]).abs() < 1e-6
            });
            let Some(&under) = under else { continue };
            for side in 0..4 {
                let [a, b] = [node, under].map(|n| actions.node(n as usize)[GRAVITY + side]);
                let drift = actions.overall[WINDS_A_SIDE * side + PRESSED]
                    * ((a[0] - b[0]).powi(2) + (a[1] - b[1]).powi(2)).sqrt();
                let ratio = drift * loads.limits[2] / (level.z_m - lower.z_m);
                if ratio > worst.0 {
                    worst = (ratio, node as usize);
                }
            }
        }
    }
    worst
}
