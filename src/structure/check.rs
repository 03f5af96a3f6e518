//! Stress checks of one member piece.

use super::catalogue::{CrossSection, StructuralMaterial, Timber};
use super::verdict::Check;

/// Forces at end i and uniform loads of a piece in one combination, local axes, per member (all plies).
/// Order: Fx Fy Fz My Mz at i, then qx qy qz.
pub(super) type Piece = [f64; 8];

/// Section forces at a point: axial (tension positive), shear y and z, moments y and z.
pub(super) fn section_forces(p: &Piece, x: f64) -> [f64; 5] {
    let [fx, fy, fz, my, mz, qx, qy, qz] = *p;
    [-fx - qx * x, fy + qy * x, fz + qz * x, -my - fz * x - 0.5 * qz * x * x, -mz + fy * x + 0.5 * qy * x * x]
}

/// Points where stresses can be largest: the ends and where a shear force vanishes.
pub(super) fn stations(p: &Piece, length: f64) -> ([f64; 4], usize) {
    let mut out = [0.0, length, 0.0, 0.0];
    let mut n = 2;
    for (f, q) in [(p[1], p[6]), (p[2], p[7])] {
        if q != 0.0 {
            let x = -f / q;
            if x > 0.0 && x < length {
                out[n] = x;
                n += 1;
            }
        }
    }
    (out, n)
}

/// A member's resistance: section (plies counted), strengths, buckling factors for its clear length.
#[derive(Clone, Copy, Debug)]
pub(super) struct Resistance {
    a: f64,
    av: f64,
    wy: f64,
    wz: f64,
    kind: Kind,
    /// Reciprocals of design forces and moments at kmod = 1: N, V, My, Mz; see [`Resistance::bound`].
    least: [f64; 4],
}

#[derive(Clone, Copy, Debug)]
enum Kind {
    Timber { t: Timber, kh: f64, kht: f64, kc: [f64; 2] },
    Steel { fy: f64, chi: f64 },
}

impl Resistance {
    /// `clear` is the buckling length; `sheathed` members are held in their weak direction.
    pub fn new(m: &StructuralMaterial, s: &CrossSection, plies: u8, clear: f64, sheathed: bool) -> Resistance {
        let n = f64::from(plies);
        let slender = |i: f64| clear / (i / s.a).sqrt();
        let kind = match m.timber {
            Some(t) => {
                let glued = m.kind == super::catalogue::MaterialKind::Glulam;
                let kc = |i: f64| buckling_timber(&t, slender(i));
                let weak = if sheathed { 1.0 } else { kc(s.iz) };
                Kind::Timber {
                    t,
                    kh: size_factor(s.h, glued),
                    kht: size_factor(s.h.max(s.b), glued),
                    kc: [kc(s.iy), weak],
                }
            }
            None => {
                let weak = if sheathed { 1.0 } else { buckling_steel(m, slender(s.iz)) };
                Kind::Steel { fy: m.fy, chi: buckling_steel(m, slender(s.iy)).min(weak) }
            }
        };
        let (a, av, wy, wz) = (n * s.a, n * s.av, n * s.iy / (0.5 * s.h), n * s.iz / (0.5 * s.b));
        let [axial, shear, bending] = match &kind {
            Kind::Timber { t, kh, kht, kc } => {
                let compression = t.fc * kc[0].min(kc[1]);
                [compression.min(kht * t.ft), t.k_cr * t.fv, kh * t.fm].map(|f| f / t.gamma)
            }
            Kind::Steel { fy, chi } => [chi * fy, fy / 3f64.sqrt(), *fy],
        };
        let least = [a * axial, av * shear, wy * bending, wz * bending].map(|r| 1.0 / r);
        Resistance { a, av, wy, wz, kind, least }
    }

    /// A bound on [`Resistance::ratio`] times kmod, for kmod up to 1: axial force against the weaker of tension and buckling plus
    /// both moments in full, or shear. The ratio never exceeds it as long as it is under 1; beyond, infinity stands in, because
    /// compression enters one formula squared.
    pub fn bound(&self, [n, vy, vz, my, mz]: &[f64; 5]) -> f64 {
        let normal = n.abs() * self.least[0] + my.abs() * self.least[2] + mz.abs() * self.least[3];
        let shear = (vy.abs() + vz.abs()) * self.least[1];
        let bound = 1.000_001 * normal.max(shear);
        if bound < 0.5 { bound } else { f64::INFINITY }
    }

    /// Largest ratio at a point and the check it comes from.
    pub fn ratio(&self, [n, vy, vz, my, mz]: [f64; 5], k_mod: f64) -> (f64, Check) {
        let (sn, sy, sz) = (n / self.a, (my / self.wy).abs(), (mz / self.wz).abs());
        let tau = (vy * vy + vz * vz).sqrt() / self.av;
        let (normal, shear) = match &self.kind {
            Kind::Timber { t, kh, kht, kc } => {
                let d = k_mod / t.gamma;
                let (fm, ft, fc) = (kh * t.fm * d, kht * t.ft * d, t.fc * d);
                let m1 = sy / fm + t.k_m * sz / fm;
                let m2 = t.k_m * sy / fm + sz / fm;
                let normal = if sn >= 0.0 {
                    (sn / ft + m1.max(m2), if sn / ft > m1 { Check::Tension } else { Check::Bending })
                } else {
                    let c = -sn / fc;
                    let buckling = (c / kc[0] + m1).max(c / kc[1] + m2);
                    let r = buckling.max(c * c + m1.max(m2));
                    (r, if c / kc[0].min(kc[1]) > m1.max(m2) { Check::Buckling } else { Check::Bending })
                };
                (normal, tau / (t.k_cr * t.fv * d))
            }
            Kind::Steel { fy, chi } => {
                let bending = (sy + sz) / fy;
                let axial = if sn >= 0.0 { sn / fy } else { -sn / (chi * fy) };
                let check = match (axial > bending, sn < 0.0) {
                    (true, true) => Check::Buckling,
                    (true, false) => Check::Tension,
                    _ => Check::Bending,
                };
                ((axial + bending, check), tau * 3f64.sqrt() / fy)
            }
        };
        if shear > normal.0 { (shear, Check::Shear) } else { normal }
    }

    /// Extreme normal stresses (tension, compression as a positive number) and N/A at a point, Pa.
    pub fn extremes(&self, [n, _, _, my, mz]: [f64; 5]) -> [f64; 3] {
        let bending = (my / self.wy).abs() + (mz / self.wz).abs();
        [n / self.a + bending, bending - n / self.a, n / self.a]
    }
}

/// kh of 3.2 (3) and 3.3 (3): sawn under 150 mm, glulam under 600 mm.
fn size_factor(h: f64, glued: bool) -> f64 {
    if glued { (0.6 / h).powf(0.1).clamp(1.0, 1.1) } else { (0.15 / h).powf(0.2).clamp(1.0, 1.3) }
}

/// kc of EN 1995-1-1 6.3.2.
pub(super) fn buckling_timber(t: &Timber, slenderness: f64) -> f64 {
    let rel = slenderness / std::f64::consts::PI * (t.fc / t.e05).sqrt();
    if rel <= 0.3 {
        return 1.0;
    }
    let k = 0.5 * (1.0 + t.beta_c * (rel - 0.3) + rel * rel);
    1.0 / (k + (k * k - rel * rel).sqrt())
}

/// chi of EN 1993-1-1 6.3.1.2: curve c for cold-formed hollow sections, and on the safe side for open ones.
fn buckling_steel(m: &StructuralMaterial, slenderness: f64) -> f64 {
    buckling_curve(m, slenderness, 0.49)
}

/// chi for an imperfection factor (6.3.1.2(1), Table 6.1).
fn buckling_curve(m: &StructuralMaterial, slenderness: f64, imperfection: f64) -> f64 {
    let rel = slenderness / std::f64::consts::PI * (m.fy / m.e).sqrt();
    if rel <= 0.2 {
        return 1.0;
    }
    let phi = 0.5 * (1.0 + imperfection * (rel - 0.2) + rel * rel);
    (1.0 / (phi + (phi * phi - rel * rel).sqrt())).min(1.0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::structure::{Catalogue, CrossSection};

    fn catalogue() -> Catalogue {
        Catalogue::load(std::path::Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/configs"))).expect("our catalogue")
    }

    /// A rectangle b x h in m.
    fn rectangle(b: f64, h: f64) -> CrossSection {
        let (a, iy, iz) = (b * h, b * h.powi(3) / 12.0, h * b.powi(3) / 12.0);
        CrossSection { id: String::new(), family: "sawn".into(), b, h, a, iy, iz, j: iz, av: a / 1.5 }
    }

    /// What the bound rules out cannot govern: for many forces it is never under the ratio.
    #[test]
    fn the_bound_is_never_too_low() {
        let c = catalogue();
        for m in &c.materials {
            for (clear, sheathed) in [(0.9, true), (2.7, false), (5.4, true)] {
                let r = Resistance::new(m, &rectangle(0.06, 0.2), 1, clear, sheathed);
                let (mut ruled, mut random) = (0, 1u64);
                let mut next = || {
                    random = random.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
                    (random >> 11) as f64 / (1u64 << 52) as f64 - 1.0
                };
                for _ in 0..20_000 {
                    let forces = [next() * 4e4, next() * 4e3, next() * 1e4, next() * 3e3, next() * 5e2];
                    for k_mod in [0.6, 0.8, 0.9] {
                        let (bound, ratio) = (r.bound(&forces), r.ratio(forces, k_mod).0);
                        assert!(ratio * k_mod <= bound, "{} {forces:?}: {ratio} {bound}", m.id);
                        ruled += u32::from(bound < 0.5);
                    }
                }
                assert!(ruled > 1000, "{}: the bound rules out nothing", m.id);
            }
        }
    }

    /// Schneider, Bautabellen fuer Ingenieure, 20th edition, page 9.29: C24, 140 x 140 mm, 2.85 m, 65.2 kN, kmod 0.9.
    /// By hand: i = 140 / sqrt 12 = 40.41 mm, slenderness 70.5; relative 70.5 / pi sqrt(21 / 7333.3) = 1.2010;
    /// k = 0.5 (1 + 0.2 x 0.901 + 1.4424) = 1.3113; kc = 1 / (1.3113 + sqrt(1.7195 - 1.4424)) = 0.544; the book rounds to 0.542.
    #[test]
    fn timber_column_of_schneider() {
        let c = catalogue();
        let m = c.materials.iter().find(|m| m.id == "C24").expect("C24");
        let mut book = m.clone();
        let t = book.timber.as_mut().expect("timber");
        t.e05 = 7333.3e6;
        let kc = buckling_timber(t, 2.85 / (0.14 / 12f64.sqrt()));
        assert!((kc - 0.544).abs() < 5e-4 && (kc / 0.542 - 1.0).abs() < 5e-3, "{kc}");
        let r = Resistance::new(&book, &rectangle(0.14, 0.14), 1, 2.85, false);
        let (ratio, check) = r.ratio([-65.2e3, 0.0, 0.0, 0.0, 0.0], 0.9);
        assert!((ratio / 0.42 - 1.0).abs() < 0.01 && check == Check::Buckling, "{ratio} {check:?}");
    }

    /// Benoit, Legrand, Tastet, example 2.3.1: a joist 75 x 200 mm of C24 over 4.5 m, 0.5 m apart, 0.5 + 1.5 kN/m2.
    /// By hand: q = 0.5 (1.35 x 0.5 + 1.5 x 1.5) = 1.4625 kN/m, M = 3.702 kNm, W = 500 cm3, 7.404 MPa against
    /// 24 x 0.8 / 1.3 = 14.769 MPa: 0.5013; the book shares load over neighbours, ksys = 1.1: 0.4557.
    #[test]
    fn timber_joist_of_benoit() {
        let c = catalogue();
        let m = c.materials.iter().find(|m| m.id == "C24").expect("C24");
        let r = Resistance::new(m, &rectangle(0.075, 0.2), 1, 4.5, true);
        let moment = 1462.5 * 4.5 * 4.5 / 8.0;
        let (ratio, check) = r.ratio([0.0, 0.0, 0.0, moment, 0.0], 0.8);
        assert!((ratio / 1.1 / 0.45573 - 1.0).abs() < 5e-4 && check == Check::Bending, "{ratio}");
    }

    /// EN 1993-1-1 6.3.1.2 by hand, curve c (0.49), a cold-formed hollow section in S355 with a slenderness of 76.41 x 1 = relative 1:
    /// Phi = 0.5 (1 + 0.49 x 0.8 + 1) = 1.196, chi = 1 / (1.196 + sqrt(1.4304 - 1)) = 0.5399. Curve a (0.21) of the Designers' Guide,
    /// example 6.7 (CHS 244.5 x 10, 4 m, S355): chi = 0.8779; ours must lie below it, because it takes curve c.
    #[test]
    fn steel_column_curves() {
        let c = catalogue();
        let m = c.materials.iter().find(|m| m.id == "S355").expect("S355");
        let one = std::f64::consts::PI * (m.e / m.fy).sqrt();
        assert!((buckling_steel(m, one) - 0.5399).abs() < 1e-4);
        assert_eq!(buckling_steel(m, 0.2 * one), 1.0);
        let slenderness = 4.0 / (50_731_473.0f64 / 7367.03).sqrt() * 1e3;
        assert!((buckling_curve(m, slenderness, 0.21) - 0.877_915).abs() < 5e-4 * 0.877_915);
        assert!(buckling_steel(m, slenderness) < 0.877_915);
    }
}
