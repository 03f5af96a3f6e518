//! Flexural, torsional and lateral torsional buckling, 6.3.1 and 6.3.2.

use std::f64::consts::PI;

use super::super::{Section, Shape};
use super::Steel;

/// Buckling curve of Table 6.1.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Curve {
    /// Imperfection factor 0.13.
    A0,
    /// 0.21.
    A,
    /// 0.34.
    B,
    /// 0.49.
    C,
    /// 0.76.
    D,
}

impl Curve {
    /// Imperfection factor alpha of Tables 6.1 and 6.3.
    pub fn imperfection(self) -> f64 {
        match self {
            Curve::A0 => 0.13,
            Curve::A => 0.21,
            Curve::B => 0.34,
            Curve::C => 0.49,
            Curve::D => 0.76,
        }
    }

    /// Letter in tables.
    pub fn letter(self) -> &'static str {
        match self {
            Curve::A0 => "a0",
            Curve::A => "a",
            Curve::B => "b",
            Curve::C => "c",
            Curve::D => "d",
        }
    }
}

/// chi of 6.3.1.2(1) (6.49) for a relative slenderness; 1 up to 0.2. The rule that buckling may be ignored below N / Ncr = 0.04 is not
/// used.
pub fn reduction(slenderness: f64, curve: Curve) -> f64 {
    if slenderness <= 0.2 {
        return 1.0;
    }
    let phi = 0.5 * (1.0 + curve.imperfection() * (slenderness - 0.2) + slenderness * slenderness);
    (1.0 / (phi + (phi * phi - slenderness * slenderness).sqrt())).min(1.0)
}

/// Relative slenderness about y or z: sqrt(A fy / Ncr), Ncr = pi2 E I / l2 (6.50).
pub(super) fn flexural(steel: &Steel, section: &Section, axis: usize, length: f64) -> f64 {
    length / section.radii()[axis] / PI * (steel.fy / steel.e).sqrt()
}

/// Relative slenderness of torsional buckling of a doubly symmetric open section, 6.3.1.4: Ncr,T = (G It + pi2 E Iw / l2) / i0^2.
pub(super) fn torsional(steel: &Steel, section: &Section, length: f64) -> f64 {
    let [iy, iz] = section.radii();
    let stiffness = steel.g * section.it + PI * PI * steel.e * section.iw / (length * length);
    (section.a * steel.fy * (iy * iy + iz * iz) / stiffness).sqrt()
}

/// How chi LT is found.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LateralMethod {
    /// 6.3.2.3 for rolled sections, lambda LT,0 = 0.4 and beta = 0.75 as recommended, without the factor f of (6.58): the safe side.
    Rolled,
    /// 6.3.2.2, general case.
    General,
}

/// A length over which the compressed flange is free to move sideways, held at its ends sideways and against twist.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lateral {
    /// Distance of the supports, m.
    pub length: f64,
    /// C1 of the moment diagram, at least 1.
    pub c1: f64,
    /// C2 times the height of the load above the shear centre, m; positive when the load pushes towards the shear centre from the
    /// compressed flange.
    pub c2_zg: f64,
    /// Which of the two procedures.
    pub method: LateralMethod,
}

/// Elastic critical moment of a doubly symmetric section, N m; ends free to turn and to warp (k = kw = 1):
/// `C1 pi2 E Iz / l2 (sqrt(Iw / Iz + l2 G It / (pi2 E Iz) + (C2 zg)^2) - C2 zg)`. EN 1993-1-1 gives no formula; this is that of
/// ENV 1993-1-1 Annex F and of the NCCI SN003 (Access Steel), C1 = 1.127 and C2 = 0.454 under uniform load.
pub fn critical_moment(steel: &Steel, section: &Section, lateral: &Lateral) -> f64 {
    let euler = PI * PI * steel.e * section.i[1] / (lateral.length * lateral.length);
    let z = lateral.c2_zg;
    let torsion = section.iw / section.i[1] + steel.g * section.it / euler;
    lateral.c1 * euler * ((torsion + z * z).sqrt() - z)
}

/// Relative slenderness and chi LT for a characteristic moment resistance W fy.
pub(super) fn lateral(steel: &Steel, section: &Section, free: &Lateral, moment: f64) -> [f64; 2] {
    let slenderness = (moment / critical_moment(steel, section, free)).sqrt();
    // 6.3.2.2(4): lateral torsional buckling may be ignored up to lambda LT,0.
    if slenderness <= 0.4 {
        return [slenderness, 1.0];
    }
    let curve = lateral_curve(section, free.method);
    let (alpha, s2) = (curve.imperfection(), slenderness * slenderness);
    let chi = match free.method {
        LateralMethod::General => reduction(slenderness, curve),
        LateralMethod::Rolled => {
            let phi = 0.5 * (1.0 + alpha * (slenderness - 0.4) + 0.75 * s2);
            (1.0 / (phi + (phi * phi - 0.75 * s2).sqrt())).min(1.0 / s2)
        }
    };
    [slenderness, chi.min(1.0)]
}

/// Curve of Table 6.4 (general) or 6.5 (rolled). Hollow sections, which the tables leave to curve d, take the general case.
pub(super) fn lateral_curve(section: &Section, method: LateralMethod) -> Curve {
    let slim = match section.shape {
        Shape::I { b, h, .. } => h <= 2.0 * b,
        Shape::Box { .. } | Shape::Tube { .. } | Shape::Rectangle { .. } => return Curve::D,
    };
    match (method, slim) {
        (LateralMethod::General, true) => Curve::A,
        (LateralMethod::General, false) | (LateralMethod::Rolled, true) => Curve::B,
        (LateralMethod::Rolled, false) => Curve::C,
    }
}
