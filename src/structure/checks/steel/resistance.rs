//! Cross-section resistance under bending with axial force, 6.2.9, reduced for shear by 6.2.8 and 6.2.10.

use super::super::terms::Terms;
use super::super::{Section, Shape};
use super::Class;

/// Plastic resistances of one cross-section, N and N m, already reduced for high shear.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Resistance {
    /// A fy / gamma M0.
    pub n: f64,
    /// W fy / gamma M0 about y and z.
    pub m: [f64; 2],
}

/// rho of 6.2.8(3), 0 up to half of the shear resistance. At most 0.99, so that a member that shear alone overstrains keeps a finite ratio.
pub fn shear_share(v: f64, resistance: f64) -> f64 {
    let over = (2.0 * v / resistance - 1.0).clamp(0.0, 1.0);
    (over * over).min(0.99)
}

/// Resistances with `rho` of the shear forces along y and z, 6.2.8 and 6.2.10: the shear area keeps (1 - rho) fy.
pub fn reduced(full: &Resistance, section: &Section, class: Class, rho: [f64; 2]) -> Resistance {
    if rho == [0.0; 2] {
        return *full;
    }
    let n = full.n * (1.0 - (rho[0] * section.av[0] + rho[1] * section.av[1]) / section.a).max(0.0);
    // About y, the webs' part of the plastic modulus is what Vz uses up: Aw^2 / (4 tw) of (6.30). Everywhere else the whole modulus is
    // taken as used up, on the safe side.
    let webs = match section.shape {
        Shape::I { h, tw, tf, .. } if class <= Class::Two => 0.25 * tw * (h - 2.0 * tf).powi(2) / section.wpl[0],
        Shape::Box { h, t, .. } if class <= Class::Two => 0.5 * t * (h - 2.0 * t).powi(2) / section.wpl[0],
        _ => 1.0,
    };
    let both = if matches!(section.shape, Shape::I { .. }) { 0.0 } else { rho[1] };
    let m = [full.m[0] * (1.0 - rho[1] * webs) * (1.0 - rho[0]), full.m[1] * (1.0 - rho[0]) * (1.0 - both)];
    Resistance { n, m }
}

/// Left side of the check of 6.2.9 (1 fails): for class 3 the elastic stress at the corner (6.42), which is the linear sum of (6.2) too;
/// for classes 1 and 2 the larger of M over M_N,Rd about each axis and of (6.41), at most the linear sum. The sum is never the smaller of
/// the two while it is under 1, so the verdict is that of 6.2.9.1, and beyond 1 it stays finite. `axial`, `m`: magnitudes.
pub fn interaction(r: &Resistance, section: &Section, class: Class, axial: f64, m: [f64; 2]) -> f64 {
    let n = used(axial, r.n);
    let linear = n + used(m[0], r.m[0]) + used(m[1], r.m[1]);
    if class == Class::Three || n >= 1.0 {
        return linear;
    }
    let ([my, mz], powers) = plastic(section, n);
    let [y, z] = [used(m[0], my * r.m[0]), used(m[1], mz * r.m[1])];
    let both = if y > 0.0 && z > 0.0 { y.powf(powers[0]) + z.powf(powers[1]) } else { 0.0 };
    y.max(z).max(n).max(both).min(linear)
}

/// The terms of whichever of the sums and ratios [`interaction`] is.
pub fn interaction_terms(r: &Resistance, section: &Section, class: Class, axial: f64, m: [f64; 2]) -> Terms {
    let n = used(axial, r.n);
    let whole = interaction(r, section, class, axial, m);
    let linear = [n, used(m[0], r.m[0]), used(m[1], r.m[1])];
    if whole == linear[0] + linear[1] + linear[2] {
        return Terms::of([("N_Ed / N_Rd", linear[0]), ("M_y,Ed / M_y,Rd", linear[1]), ("M_z,Ed / M_z,Rd", linear[2])]);
    }
    let ([my, mz], powers) = plastic(section, n);
    let [y, z] = [used(m[0], my * r.m[0]), used(m[1], mz * r.m[1])];
    match whole {
        w if w == y => Terms::of([("M_y,Ed / M_N,y,Rd", y)]),
        w if w == z => Terms::of([("M_z,Ed / M_N,z,Rd", z)]),
        w if w == n => Terms::of([("N_Ed / N_Rd", n)]),
        _ => Terms::of([("(M_y,Ed / M_N,y,Rd)^a", y.powf(powers[0])), ("(M_z,Ed / M_N,z,Rd)^b", z.powf(powers[1]))]),
    }
}

/// A force over its resistance: nothing asks for nothing, also of a section that shear uses up; infinite where that has to carry something.
fn used(force: f64, resistance: f64) -> f64 {
    if force == 0.0 { 0.0 } else { force / resistance }
}

/// M_N,Rd over M_pl,Rd about y and z under an axial force of `n` times the plastic one, and the powers of (6.41).
pub fn plastic(section: &Section, n: f64) -> ([f64; 2], [f64; 2]) {
    let a = section.a;
    let share = |flanges: f64| ((a - flanges) / a).min(0.5);
    match section.shape {
        Shape::I { b, h, tf, tw, .. } => {
            let (web, s) = ((h - 2.0 * tf) * tw / a, share(2.0 * b * tf));
            // (6.33) to (6.35): a small axial force that the web carries does not lower the moments.
            let my = if n <= 0.25 && n <= 0.5 * web { 1.0 } else { ((1.0 - n) / (1.0 - 0.5 * s)).min(1.0) };
            let mz = if n <= web || n <= s { 1.0 } else { 1.0 - ((n - s) / (1.0 - s)).powi(2) };
            ([my, mz], [2.0, (5.0 * n).max(1.0)])
        }
        Shape::Box { b, h, t, .. } => {
            let left = |s: f64| ((1.0 - n) / (1.0 - 0.5 * s)).min(1.0);
            // Beyond n = 0.94 the denominator turns negative: 6 is the limit of 6.2.9.1(6).
            let power = Some(1.0 - 1.13 * n * n).filter(|d| *d > 0.0).map_or(6.0, |d| (1.66 / d).min(6.0));
            ([left(share(2.0 * b * t)), left(share(2.0 * h * t))], [power; 2])
        }
        Shape::Tube { .. } => ([1.0 - n.powf(1.7); 2], [2.0; 2]),
        Shape::Rectangle { .. } => ([1.0 - n * n; 2], [1.0; 2]),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::structure::checks::{Forming, Shape};

    /// Shear that uses up the whole section leaves no resistance: nothing asks for nothing of it, and any force fails.
    #[test]
    fn a_section_used_up_by_shear_gives_no_nan() {
        let section = Shape::Box { b: 0.1, h: 0.1, t: 0.005, forming: Forming::Hot }.properties();
        let none = Resistance { n: 0.0, m: [0.0; 2] };
        for class in [Class::One, Class::Three] {
            assert_eq!(interaction(&none, &section, class, 0.0, [0.0; 2]), 0.0);
            assert!(interaction_terms(&none, &section, class, 0.0, [0.0; 2]).sum() == 0.0);
            assert_eq!(interaction(&none, &section, class, 1.0, [0.0; 2]), f64::INFINITY);
            assert_eq!(interaction(&none, &section, class, 0.0, [1.0, 0.0]), f64::INFINITY);
        }
    }
}
