//! Deflections and drift.

use super::catalogue::{Catalogue, SectionOption};
use super::check::{Piece, section_forces};
use super::loads::LoadSettings;
use super::verdict::Check;
use crate::frame::{HouseFrame, Role, Span};

/// Displacements and pieces of the base actions: 0 permanent, 1 imposed, 2 snow, 3.. winds.
pub(super) struct Actions<'a> {
    pub pieces: &'a [Piece],
    pub moves: &'a [[f64; 3]],
    pub count: usize,
}

impl Actions<'_> {
    pub fn piece(&self, element: usize, action: usize) -> &Piece {
        &self.pieces[element * self.count + action]
    }

    pub fn node(&self, node: usize, action: usize) -> [f64; 3] {
        self.moves[node * self.count + action]
    }
}

/// Winds used for deflection and drift: each side, internal suction and windward slope pressed.
const WINDS: [usize; 4] = [3 + 3, 3 + 7, 3 + 11, 3 + 15];
/// Base actions of a deflection: permanent, imposed, snow, four winds.
const BASES: [usize; 7] = [0, 1, 2, WINDS[0], WINDS[1], WINDS[2], WINDS[3]];

/// Largest deflection of a span over its limit, the check, and its permanent deflection in m.
pub(super) fn span_ratio(
    frame: &HouseFrame,
    catalogue: &Catalogue,
    sections: &[SectionOption; 4],
    loads: &LoadSettings,
    actions: &Actions<'_>,
    span: &Span,
) -> (f64, Check, f64) {
    let member = &frame.members[span.member as usize];
    let option = sections[member.group as usize];
    let creep = catalogue.material(option).timber.map_or(0.0, |t| t.k_def);
    let (first, last) = (span.elements[0] as usize, span.elements[1] as usize);
    let ends = [frame.elements[first].nodes[0] as usize, frame.elements[last].nodes[1] as usize];
    let length: f64 = (first..=last).map(|e| frame.element_length_m(e)).sum();
    let cantilever = !(span.held[0] && span.held[1]);
    let limit = |l: f64| l / (if cantilever { 2.0 } else { 1.0 } * length);
    let mut worst = (0.0f64, Check::TotalDeflection, 0.0f64);
    let mut before = 0.0;
    for e in first..=last {
        let own = frame.element_length_m(e);
        for part in [0.5, 1.0] {
            if part == 1.0 && e == last && !cantilever {
                continue;
            }
            let w = BASES.map(|b| {
                deflection(
                    frame,
                    catalogue,
                    sections,
                    actions,
                    e,
                    (before + part * own) / length,
                    part,
                    b,
                    ends,
                    span.held,
                )
            });
            let (total, variable) = combined(loads, &w, creep);
            let total = (total * limit(loads.limits[0]), Check::TotalDeflection);
            let variable = (variable * limit(loads.limits[1]), Check::VariableDeflection);
            for (value, check) in [total, variable] {
                if value > worst.0 {
                    worst = (value, check, worst.2);
                }
            }
            worst.2 = worst.2.max(norm(w[0]));
        }
        before += own;
    }
    worst
}

fn norm(v: [f64; 3]) -> f64 {
    (v[0] * v[0] + v[1] * v[1] + v[2] * v[2]).sqrt()
}

/// Total deflection with creep and variable deflection, each the largest over its combinations.
fn combined(loads: &LoadSettings, w: &[[f64; 3]; 7], creep: f64) -> (f64, f64) {
    let sum = |f: &[f64; 7]| norm([0, 1, 2].map(|a| (0..7).map(|c| f[c] * w[c][a]).sum()));
    let [p_q, p_s, _] = loads.psi0;
    let (g, q) = (1.0 + creep, 1.0 + loads.psi2_imposed * creep);
    let total =
        [[g, q, p_s, 0.0, 0.0, 0.0, 0.0], [g, p_q * q, 1.0, 0.0, 0.0, 0.0, 0.0]].iter().map(&sum).fold(0.0, f64::max);
    let mut variable = sum(&[0.0, 1.0, p_s, 0.0, 0.0, 0.0, 0.0]).max(sum(&[0.0, p_q, 1.0, 0.0, 0.0, 0.0, 0.0]));
    for n in 3..7 {
        let mut f = [0.0; 7];
        f[n] = 1.0;
        variable = variable.max(sum(&f));
    }
    (total, variable)
}

/// Deflection of a point against the chord of its span (against the held end for a cantilever), global axes.
#[allow(clippy::too_many_arguments, reason = "one call site; a struct would only rename them")]
fn deflection(
    frame: &HouseFrame,
    catalogue: &Catalogue,
    sections: &[SectionOption; 4],
    actions: &Actions<'_>,
    element: usize,
    along: f64,
    part: f64,
    action: usize,
    ends: [usize; 2],
    held: [bool; 2],
) -> [f64; 3] {
    let e = &frame.elements[element];
    let [a, b] = e.nodes.map(|n| actions.node(n as usize, action));
    let [c, d] = ends.map(|n| actions.node(n, action));
    let chord = |x: usize| match held {
        [true, false] => c[x],
        [false, true] => d[x],
        _ => c[x] + along * (d[x] - c[x]),
    };
    let member = &frame.members[e.member as usize];
    let option = sections[member.group as usize];
    let (m, s) = (catalogue.material(option), catalogue.section(option));
    let plies = f64::from(member.plies);
    let own = own_deflection(
        actions.piece(element, action),
        frame.element_length_m(element),
        part,
        [m.e * s.iy * plies, m.e * s.iz * plies],
    );
    let [y, z] = transverse(frame, element, member.reference);
    // Only movement across the stick is deflection.
    let x = axis(frame, element);
    let raw = [0, 1, 2].map(|n| a[n] + part * (b[n] - a[n]) - chord(n) + own[0] * y[n] + own[1] * z[n]);
    let along_x: f64 = (0..3).map(|n| raw[n] * x[n]).sum();
    [0, 1, 2].map(|n| raw[n] - along_x * x[n])
}

fn axis(frame: &HouseFrame, element: usize) -> [f64; 3] {
    let [i, j] = frame.elements[element].nodes.map(|n| frame.nodes[n as usize]);
    let l = frame.element_length_m(element);
    [0, 1, 2].map(|n| (j[n] - i[n]) / l)
}

/// Local y and z of an element, as the solver takes them.
pub(super) fn transverse(frame: &HouseFrame, element: usize, reference: Option<[f64; 3]>) -> [[f64; 3]; 2] {
    let x = axis(frame, element);
    let v =
        reference.unwrap_or(if x[0].abs() + x[1].abs() > 1e-9 { [0.0, 0.0, 1.0] } else { [-x[2].signum(), 0.0, 0.0] });
    let cross =
        |a: [f64; 3], b: [f64; 3]| [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
    let y = cross(v, x);
    let l = norm(y);
    let y = y.map(|c| c / l);
    [y, cross(x, y)]
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

/// Largest storey drift over its limit, and the node.
pub(super) fn sway(frame: &HouseFrame, loads: &LoadSettings, actions: &Actions<'_>) -> (f64, usize) {
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
            for (side, wind) in WINDS.into_iter().enumerate() {
                let overall = loads.correlation(frame.size_m[2] / frame.size_m[side % 2]);
                let (a, b) = (actions.node(node as usize, wind), actions.node(under as usize, wind));
                let drift = ((a[0] - b[0]).powi(2) + (a[1] - b[1]).powi(2)).sqrt();
                let ratio = overall * drift * loads.limits[2] / (level.z_m - lower.z_m);
                if ratio > worst.0 {
                    worst = (ratio, node as usize);
                }
            }
        }
    }
    worst
}

/// Rough first frequency of a joist from its permanent deflection in m.
pub(super) fn frequency(role: Role, permanent_m: f64) -> Option<f64> {
    (role == Role::Joist && permanent_m > 1e-6).then(|| 18.0 / (permanent_m * 1e3).sqrt())
}
