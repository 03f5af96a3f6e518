//! Factors for size and instability.

use std::f64::consts::PI;

use super::Grade;

/// k_h of 3.2(3) and 3.3(3): sawn timber under 150 mm, glulam under 600 mm of depth (or width in tension), m.
pub fn size(h: f64, glued: bool) -> f64 {
    if glued { (0.6 / h).powf(0.1).clamp(1.0, 1.1) } else { (0.15 / h).powf(0.2).clamp(1.0, 1.3) }
}

/// Relative slenderness (6.21) and k_c (6.25) for a slenderness l / i.
pub fn column(grade: &Grade, slenderness: f64) -> [f64; 2] {
    let rel = slenderness / PI * (grade.fc / grade.e05).sqrt();
    if rel <= 0.3 {
        return [rel, 1.0];
    }
    let k = 0.5 * (1.0 + grade.beta_c * (rel - 0.3) + rel * rel);
    [rel, 1.0 / (k + (k * k - rel * rel).sqrt())]
}

/// Critical bending stress of a softwood rectangle (6.32), Pa: 0.78 b2 E0.05 / (h l_ef).
pub fn critical_stress(grade: &Grade, b: f64, h: f64, effective_length: f64) -> f64 {
    0.78 * b * b * grade.e05 / (h * effective_length)
}

/// Relative slenderness for bending (6.30) and k_crit (6.34); `strength` is the characteristic bending strength, Pa.
pub fn lateral(strength: f64, critical: f64) -> [f64; 2] {
    let rel = (strength / critical).sqrt();
    let k = match rel {
        r if r <= 0.75 => 1.0,
        r if r <= 1.4 => 1.56 - 0.75 * r,
        r => 1.0 / (r * r),
    };
    [rel, k]
}

/// k_shape of a rectangle (6.15).
pub fn torsion_shape(b: f64, h: f64) -> f64 {
    (1.0 + 0.15 * b.max(h) / b.min(h)).min(2.0)
}
