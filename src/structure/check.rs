//! Forces along a member piece and the resistance they are set against: the fast side of [`checks`](super::checks).

use super::catalogue::{CrossSection, StructuralMaterial};
use super::checks::steel::{Lateral, LateralMethod, class_in_compression};
use super::checks::timber::Held;
use super::checks::{Checked, Clause, Forces, Peaks, SteelMember, Terms, TimberMember};
use super::screen::Reach;

/// Forces at end i and uniform loads of a piece in one combination, local axes, per member (all plies).
/// Order: Fx Fy Fz My Mz at i, then qx qy qz.
pub(super) type Piece = [f64; 8];

/// Section forces at a point: axial (tension positive), shear y and z, moments y and z.
#[inline]
pub(super) fn section_forces(p: &Piece, x: f64) -> [f64; 5] {
    let [fx, fy, fz, my, mz, qx, qy, qz] = *p;
    [-fx - qx * x, fy + qy * x, fz + qz * x, -my - fz * x - 0.5 * qz * x * x, -mz + fy * x + 0.5 * qy * x * x]
}

/// Section forces as the checks take them: local z points up, so that the solver's My of a sagging beam is negative and compresses the
/// upper edge.
#[inline]
pub(super) fn design_forces(p: &Piece, x: f64) -> Forces {
    let [n, vy, vz, my, mz] = section_forces(p, x);
    Forces { n, vy, vz, my: -my, mz }
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

/// Where a member is held sideways.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(super) struct Restraint {
    /// It cannot buckle about its weak axis.
    pub sideways: bool,
    /// The upper and the lower edge cannot move sideways.
    pub edges: [bool; 2],
}

/// Elastic stresses of a section, for the thesis rule.
#[derive(Clone, Copy, Debug)]
pub(super) struct Fibres {
    a: f64,
    w: [f64; 2],
}

impl Fibres {
    pub fn new(s: &CrossSection, plies: u8) -> Fibres {
        let n = f64::from(plies);
        Fibres { a: n * s.a, w: [n * s.iy / (0.5 * s.h), n * s.iz / (0.5 * s.b)] }
    }

    /// Extreme normal stresses (tension, compression as a positive number) and N/A at a point, Pa.
    pub fn extremes(&self, [n, _, _, my, mz]: [f64; 5]) -> [f64; 3] {
        let bending = (my / self.w[0]).abs() + (mz / self.w[1]).abs();
        [n / self.a + bending, bending - n / self.a, n / self.a]
    }
}

/// A member's resistance: all plies, for its clear length.
#[derive(Clone, Copy, Debug)]
pub(super) struct Resistance {
    kind: Kind,
    /// Reciprocals of the least design resistances at kmod = 1, N, V, My, Mz, of the clauses at a point, of those on stability, and the
    /// larger of both; see [`Resistance::bound`].
    least: [[f64; 4]; 3],
}

#[derive(Clone, Copy, Debug)]
enum Kind {
    Timber(TimberMember),
    Steel(SteelMember),
    /// Class 4: nothing is known, everything fails.
    Unknown,
}

/// Ratio of a class 4 member, which houses never reach: their sections are sorted out before.
const UNKNOWN: (f64, Clause) = (f64::MAX, Clause::SteelCompression);

/// C1 where the moment changes sign and the upper edge is held: at least 2 (two equal spans under uniform load: 2.20, a fixed-ended one:
/// 2.57, by [`Diagram::c1`](super::checks::Diagram::c1)). The effective length of EN 1995-1-1 Table 6.1 is the length over it.
const REVERSED_C1: f64 = 2.0;

impl Resistance {
    /// `clear` is the buckling length about the strong axis and, where the member is free, of everything else.
    pub fn new(m: &StructuralMaterial, s: &CrossSection, plies: u8, clear: f64, held: Restraint) -> Resistance {
        let (n, weak) = (f64::from(plies), if held.sideways { 0.0 } else { clear });
        let [top, bottom] = held.edges;
        // What lets the lower edge pass with half its length is that the upper one is held.
        let reversed = if top { REVERSED_C1 } else { 1.0 };
        match (m.steel, m.timber) {
            (Some(steel), _) => {
                let free = |c1| Lateral { length: clear, c1, c2_zg: 0.0, method: LateralMethod::Rolled };
                let cases = [(top, 1.0), (bottom, 1.0), (bottom, reversed)].map(|(h, c1)| (!h).then_some(free(c1)));
                let class = class_in_compression(&steel, &s.properties);
                let member = SteelMember::new(steel, &s.properties, class, n, [clear, weak, weak], cases, None);
                member.map_or(Resistance::unknown(), Resistance::of_steel)
            }
            (None, Some(grade)) => {
                let cases = [(top, 1.0), (bottom, 1.0), (bottom, reversed)];
                let lateral = cases.map(|(h, c1)| if h { 0.0 } else { clear / c1 });
                let lengths = Held { buckling: [clear, weak], lateral };
                Resistance::of_timber(TimberMember::new(&grade, &s.properties, n, &lengths, 1.0))
            }
            (None, None) => Resistance::unknown(),
        }
    }

    fn unknown() -> Resistance {
        Resistance { kind: Kind::Unknown, least: [[f64::INFINITY; 4]; 3] }
    }

    fn of_steel(m: SteelMember) -> Resistance {
        let [ny, nz, nt] = m.buckling();
        let [my, mz] = m.moments();
        let shear = m.shears()[0].min(m.shears()[1]);
        let lateral = [0, 1, 2].map(|case| m.lateral_moment(case)).into_iter().fold(f64::INFINITY, f64::min);
        let of_member = (m.steel.gamma_m0 / m.steel.gamma_m1).min(1.0);
        // Up to half of N_b,Rd the factors of Annex B stay under 1.4 about y and 1.7 about z with C_m = 1.
        let stability = [ny.min(nz).min(nt), f64::INFINITY, lateral / 1.4, mz * of_member / 1.7];
        Resistance { kind: Kind::Steel(m), least: reciprocals([m.axial(), shear, my, mz], stability) }
    }

    fn of_timber(m: TimberMember) -> Resistance {
        let [[_, ky], [_, kz]] = m.columns;
        let k_crit = m.laterals.iter().map(|l| l[1]).fold(1.0, f64::min);
        let axial = m.a * m.ft.min(m.fc * ky.min(kz));
        let [my, mz] = [m.w[0] * m.fm[0], m.w[1] * m.fm[1]];
        let stability = [axial, f64::INFINITY, my * k_crit, mz];
        Resistance { kind: Kind::Timber(m), least: reciprocals([axial, m.av * m.fv, my, mz], stability) }
    }

    /// A bound on every ratio at a point: axial force against the weakest of tension, compression and, for timber, buckling plus both
    /// moments in full, or shear.
    #[inline]
    pub fn bound(&self, f: &Forces, k_mod: f64) -> f64 {
        let least = &self.least[0];
        let normal = f.n.abs() * least[0] + f.my.abs() * least[2] + f.mz.abs() * least[3];
        self.at_most(normal.max((f.vy.abs() + f.vz.abs()) * least[1]), k_mod)
    }

    /// As [`Resistance::bound`] for [`Resistance::stability`].
    #[inline]
    pub fn bound_of_peaks(&self, p: &Peaks, k_mod: f64) -> f64 {
        let least = &self.least[1];
        self.at_most(p.compression * least[0] + p.my[0].max(p.my[1]) * least[2] + p.mz * least[3], k_mod)
    }

    /// Shares of resistance at kmod = 1 that forces no larger than `reach` take up: normal stresses, at a point or along the member, and
    /// shear. They grow with the forces and a sum of forces takes at most the sum of its parts' shares.
    #[inline]
    pub fn shares(&self, Reach([n, vy, vz, my, mz]): &Reach) -> [f64; 2] {
        let least = &self.least[2];
        [n * least[0] + my * least[2] + mz * least[3], (vy + vz) * least[1]]
    }

    /// What no ratio exceeds where the share of resistance at kmod = 1 is `share`, with room for rounding.
    ///
    /// The clauses on timber are sums of shares and, over 1, of their squares: a share r takes at most r, or r^2 over 1. Forces enter
    /// some clauses on steel squared or amplified: under a half they stay under the share, beyond it infinity stands in.
    #[inline]
    pub fn at_most(&self, share: f64, k_mod: f64) -> f64 {
        let share = 1.000_001 * share;
        match self.kind {
            Kind::Timber(_) => {
                let ratio = share / k_mod;
                if ratio <= 1.0 { ratio } else { ratio * ratio }
            }
            Kind::Steel(_) if share < 0.5 => share,
            Kind::Steel(_) | Kind::Unknown => f64::INFINITY,
        }
    }

    /// Worst ratio at a point and its clause.
    pub fn ratio(&self, f: &Forces, k_mod: f64) -> (f64, Clause) {
        let mut worst = (0.0, Clause::TimberBendingY);
        let keep = |c: Checked| Checked::worse(&mut worst, &c);
        match &self.kind {
            Kind::Timber(m) => m.check(f, k_mod, keep),
            Kind::Steel(m) => m.section(f, keep),
            Kind::Unknown => return UNKNOWN,
        }
        worst
    }

    /// Every clause at a point, as [`Resistance::ratio`] takes them; none for class 4.
    pub fn each(&self, f: &Forces, k_mod: f64, visit: impl FnMut(Checked)) {
        match &self.kind {
            Kind::Timber(m) => m.check(f, k_mod, visit),
            Kind::Steel(m) => m.section(f, visit),
            Kind::Unknown => {}
        }
    }

    /// Every clause of [`Resistance::stability`]; none for class 4.
    pub fn each_stability(&self, p: &Peaks, k_mod: f64, visit: impl FnMut(Checked)) {
        match &self.kind {
            Kind::Timber(m) => m.stability(p, k_mod, visit),
            Kind::Steel(m) => m.stability(p, visit),
            Kind::Unknown => {}
        }
    }

    /// The terms of a clause of [`Resistance::each`] that is a sum.
    pub fn terms(&self, clause: Clause, f: &Forces, k_mod: f64) -> Terms {
        match &self.kind {
            Kind::Timber(m) => m.terms(clause, f, k_mod),
            Kind::Steel(m) => m.terms(clause, f),
            Kind::Unknown => Terms::default(),
        }
    }

    /// The terms of a clause of [`Resistance::each_stability`] that is a sum.
    pub fn stability_terms(&self, clause: Clause, p: &Peaks, k_mod: f64) -> Terms {
        match &self.kind {
            Kind::Timber(m) => m.stability_terms(clause, p, k_mod),
            Kind::Steel(m) => m.stability_terms(clause, p),
            Kind::Unknown => Terms::default(),
        }
    }

    /// Whether [`Resistance::stability`] has anything to say: its clauses take the largest forces of a member. Timber with held edges
    /// has none.
    #[inline]
    pub fn has_peaks(&self) -> bool {
        match &self.kind {
            Kind::Timber(m) => m.is_free(),
            Kind::Steel(_) => true,
            Kind::Unknown => false,
        }
    }

    /// Worst ratio of the clauses that take the largest forces along the member.
    pub fn stability(&self, p: &Peaks, k_mod: f64) -> (f64, Clause) {
        let mut worst = (0.0, Clause::SteelBucklingY);
        let keep = |c: Checked| Checked::worse(&mut worst, &c);
        match &self.kind {
            Kind::Timber(m) => m.stability(p, k_mod, keep),
            Kind::Steel(m) => m.stability(p, keep),
            Kind::Unknown => return UNKNOWN,
        }
        worst
    }
}

/// Reciprocals of resistances of the clauses at a point and on stability, and the larger of each two.
fn reciprocals(point: [f64; 4], stability: [f64; 4]) -> [[f64; 4]; 3] {
    let [p, s] = [point, stability].map(|l| l.map(|r| 1.0 / r));
    [p, s, std::array::from_fn(|n| p[n].max(s[n]))]
}

#[cfg(test)]
#[path = "check_tests.rs"]
mod tests;
