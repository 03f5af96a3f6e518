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
        Resistance { a: n * s.a, av: n * s.av, wy: n * s.iy / (0.5 * s.h), wz: n * s.iz / (0.5 * s.b), kind }
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
    let rel = slenderness / std::f64::consts::PI * (m.fy / m.e).sqrt();
    if rel <= 0.2 {
        return 1.0;
    }
    let phi = 0.5 * (1.0 + 0.49 * (rel - 0.2) + rel * rel);
    (1.0 / (phi + (phi * phi - rel * rel).sqrt())).min(1.0)
}
