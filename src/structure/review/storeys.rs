//! How stiff the storeys are against swaying under what they carry: EN 1993-1-1 (5.2).

use super::super::combine::{PRESSED, WINDS_A_SIDE};
use super::Solved;
use crate::analysis::Distribution;

/// A storey's sway stiffness.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StoreyReview {
    /// Foot and head above the foundation, m.
    pub z_m: [f64; 2],
    /// The side the wind of the least factor comes from, as a number of [`crate::voxels::Direction`].
    pub side: usize,
    /// Horizontal load above the foot in that wind, characteristic, N.
    pub horizontal_n: f64,
    /// Vertical design load above the foot, the largest of all ultimate combinations, N.
    pub vertical_n: f64,
    /// Largest drift of a post or stud over the storey in that wind, m.
    pub drift_m: f64,
    /// alpha_cr = H h / (V drift), (5.2), least of the four winds.
    pub factor: f64,
}

pub(super) fn storeys(s: &Solved) -> Vec<StoreyReview> {
    let levels = &s.frame.levels;
    let mut out = Vec::new();
    for (n, level) in levels.iter().enumerate().skip(1) {
        // The eave over a knee wall is measured from the floor below it.
        let lower = if level.z_m - levels[n - 1].z_m < 1.5 && n > 1 { &levels[n - 2] } else { &levels[n - 1] };
        let vertical = s.combinations.iter().map(|c| -above(s, &s.of(c), lower.z_m)[2]).fold(0.0, f64::max);
        let mut worst: Option<StoreyReview> = None;
        for side in 0..4 {
            let factors = s.factors(0.0, 0.0, (0, 0.0), Some((WINDS_A_SIDE * side + PRESSED, 1.0)));
            let axis = side % 2;
            let horizontal = above(s, &factors, lower.z_m)[axis].abs();
            let drift = drift(s, &factors, axis, &level.nodes, &lower.nodes);
            if horizontal <= 0.0 || drift <= 0.0 || vertical <= 0.0 {
                continue;
            }
            let factor = horizontal * (level.z_m - lower.z_m) / (vertical * drift);
            if worst.is_none_or(|w| factor < w.factor) {
                worst = Some(StoreyReview {
                    z_m: [lower.z_m, level.z_m],
                    side,
                    horizontal_n: horizontal,
                    vertical_n: vertical,
                    drift_m: drift,
                    factor,
                });
            }
        }
        out.extend(worst);
    }
    out
}

/// Largest relative displacement along an axis of two nodes above each other, m.
fn drift(s: &Solved, factors: &[f64], axis: usize, upper: &[u32], lower: &[u32]) -> f64 {
    let same = |a: u32, b: u32| {
        let (p, q) = (s.frame.nodes[a as usize], s.frame.nodes[b as usize]);
        (p[0] - q[0]).abs() < 1e-6 && (p[1] - q[1]).abs() < 1e-6
    };
    let pairs = upper.iter().filter_map(|&u| Some((u, *lower.iter().find(|&&l| same(u, l))?)));
    let moves = |n: u32| s.displacement(factors, n as usize)[axis];
    pairs.map(|(u, l)| (moves(u) - moves(l)).abs()).fold(0.0, f64::max)
}

/// Sum of the loads on nodes above a height, loads of elements halved to their ends, N.
fn above(s: &Solved, factors: &[f64], z_m: f64) -> [f64; 3] {
    let mut sum = [0.0; 3];
    let share = |e: usize| {
        let ends = s.frame.elements[e].nodes.map(|n| s.frame.nodes[n as usize][2]);
        ends.iter().filter(|z| **z > z_m + 1e-6).count() as f64 * 0.5
    };
    for (slot, f) in factors.iter().enumerate().filter(|(_, f)| **f != 0.0) {
        let case = &s.lent[slot];
        for l in &case.members {
            if let Distribution::Uniform { q } = l.distribution {
                let length = f * share(l.member) * s.frame.element_length_m(l.member);
                (0..3).for_each(|a| sum[a] += q[a] * length);
            }
        }
        for (e, m) in s.model.members.iter().take(s.frame.elements.len()).enumerate() {
            let mass = s.model.materials[m.material].rho * s.model.sections[m.section].a * s.frame.element_length_m(e);
            (0..3).for_each(|a| sum[a] += f * share(e) * case.gravity[a] * mass);
        }
    }
    sum
}
