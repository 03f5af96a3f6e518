//! A timber member with everything that does not depend on its forces worked out.

use super::super::terms::{self, Terms};
use super::super::{Checked, Clause, Forces, Peaks, Section};
use super::Grade;
use super::factors::{column, critical_stress, lateral, size, torsion_shape};

/// Lengths over which a member can move sideways, m; 0 where it is held.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Held {
    /// Buckling lengths about y and z.
    pub buckling: [f64; 2],
    /// Effective length l_ef of 6.3.3 with the top edge compressed, with the bottom edge, and with the bottom edge where the moment
    /// changes sign along the member ([`Peaks::bottom_case`]).
    pub lateral: [f64; 3],
}

/// A timber member ready to be checked: strengths at k_mod = 1, Pa.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TimberMember {
    /// Bending strength about y and z, k_h and k_sys in, over gamma M.
    pub fm: [f64; 2],
    /// Tension strength, k_h in, over gamma M.
    pub ft: f64,
    /// Compression strength over gamma M.
    pub fc: f64,
    /// Shear strength over gamma M.
    pub fv: f64,
    /// Size factors for bending about y, about z and for tension.
    pub k_h: [f64; 3],
    /// Relative slenderness and k_c for buckling about y and z.
    pub columns: [[f64; 2]; 2],
    /// Relative slenderness and k_crit for the lengths of [`Held::lateral`]; slenderness 0 where held.
    pub laterals: [[f64; 2]; 3],
    /// Area of all plies, m2.
    pub a: f64,
    /// Moduli of all plies, m3.
    pub w: [f64; 2],
    /// Area that carries shear: 2/3 k_cr b h of all plies, m2.
    pub av: f64,
    k_m: f64,
    /// k_shape and torsion modulus of all plies, m3.
    torsion: [f64; 2],
}

impl TimberMember {
    /// A solid rectangle. `plies` side by side share the forces and buckle one by one; `k_sys` of 6.6 raises the strengths where several
    /// equal members are laterally connected (1 otherwise).
    pub fn new(grade: &Grade, section: &Section, plies: f64, held: &Held, k_sys: f64) -> TimberMember {
        let [b, h] = section.shape.size();
        // Glulam: 3.3(3) speaks of the depth in bending; none is taken for bending about the weak axis, the safe side.
        let flat = if grade.glued { 1.0 } else { size(b, false) };
        let k_h = [size(h, grade.glued), flat, size(h.max(b), grade.glued)];
        let radii = section.radii();
        let free = |length: f64| match length > 0.0 {
            true => lateral(k_h[0] * grade.fm, critical_stress(grade, b, h, length)),
            false => [0.0, 1.0],
        };
        let d = k_sys / grade.gamma;
        TimberMember {
            fm: [k_h[0] * grade.fm * d, k_h[1] * grade.fm * d],
            ft: k_h[2] * grade.ft * d,
            fc: grade.fc * d,
            fv: grade.fv * d,
            k_h,
            columns: [0, 1].map(|n| column(grade, held.buckling[n] / radii[n])),
            laterals: held.lateral.map(free),
            a: plies * section.a,
            w: section.wel.map(|w| plies * w),
            av: plies * grade.k_cr * section.av[1],
            k_m: grade.k_m,
            torsion: [torsion_shape(b, h), plies * section.wt],
        }
    }

    /// Stress of N (tension positive), of My and Mz (magnitudes) at a point, Pa.
    #[inline]
    pub fn stresses(&self, f: &Forces) -> [f64; 3] {
        [f.n / self.a, f.my.abs() / self.w[0], f.mz.abs() / self.w[1]]
    }

    /// Shear stress at a point, resultant of both directions, Pa. EN 1995-1-1 has no rule for shear in two directions.
    #[inline]
    pub fn shear_stress(&self, f: &Forces) -> f64 {
        if f.vy == 0.0 { f.vz.abs() / self.av } else { (f.vy * f.vy + f.vz * f.vz).sqrt() / self.av }
    }

    /// Clauses of 6.1, 6.2 and 6.3.2 at one point of the member.
    #[inline]
    pub fn check(&self, f: &Forces, k_mod: f64, mut visit: impl FnMut(Checked)) {
        let mut check = |clause, demand, resistance| visit(Checked { clause, demand, resistance });
        let [sn, sy, sz] = self.stresses(f);
        let (fm, k_m) = (self.fm.map(|f| f * k_mod), self.k_m);
        let (ry, rz) = (sy / fm[0], sz / fm[1]);
        let bending = [ry + k_m * rz, k_m * ry + rz];
        if bending[0] > 0.0 {
            check(Clause::TimberBendingY, bending[0], 1.0);
            check(Clause::TimberBendingZ, bending[1], 1.0);
        }
        check(Clause::TimberShear, self.shear_stress(f), self.fv * k_mod);
        if sn >= 0.0 {
            let t = sn / (self.ft * k_mod);
            check(Clause::TimberTension, sn, self.ft * k_mod);
            if bending[0] > 0.0 && sn > 0.0 {
                check(Clause::TimberTensionBendingY, t + bending[0], 1.0);
                check(Clause::TimberTensionBendingZ, t + bending[1], 1.0);
            }
            return;
        }
        let fc = self.fc * k_mod;
        let c = -sn / fc;
        let [[rel_y, ky], [rel_z, kz]] = self.columns;
        check(Clause::TimberCompression, -sn, fc);
        if bending[0] > 0.0 {
            check(Clause::TimberCompressionBendingY, c * c + bending[0], 1.0);
            check(Clause::TimberCompressionBendingZ, c * c + bending[1], 1.0);
        }
        // 6.3.2(2): up to 0.3 about both axes (6.19) and (6.20) stand alone.
        if rel_y > 0.3 || rel_z > 0.3 {
            check(Clause::TimberColumnY, c / ky + bending[0], 1.0);
            check(Clause::TimberColumnZ, c / kz + bending[1], 1.0);
        }
    }

    /// Whether an edge is free, so that [`TimberMember::stability`] has something to say.
    #[inline]
    pub fn is_free(&self) -> bool {
        self.laterals.iter().any(|l| l[0] > 0.0)
    }

    /// Lateral torsional buckling, 6.3.3, for the largest forces along the member.
    #[inline]
    pub fn stability(&self, p: &Peaks, k_mod: f64, mut visit: impl FnMut(Checked)) {
        let [_, [_, kz]] = self.columns;
        let c = p.compression / (self.a * self.fc * k_mod);
        for (my, case) in [(p.my[0], 0), (p.my[1], p.bottom_case())] {
            let [rel, k_crit] = self.laterals[case];
            if rel == 0.0 || my == 0.0 {
                continue;
            }
            let (stress, strength) = (my / self.w[0], k_crit * self.fm[0] * k_mod);
            visit(Checked { clause: Clause::TimberLateral, demand: stress, resistance: strength });
            if c > 0.0 {
                // Over 1, where the clause fails anyway, the square is left out: the ratio then grows with the forces, not their square.
                let bending = stress / strength;
                let demand = bending.min(bending * bending) + c / kz;
                visit(Checked { clause: Clause::TimberLateralAxial, demand, resistance: 1.0 });
            }
        }
    }

    /// The terms of a clause of [`TimberMember::check`] at a point, which sum up to its demand; none where it is no sum.
    pub fn terms(&self, clause: Clause, f: &Forces, k_mod: f64) -> Terms {
        let Some((axial, [y, z])) = terms::timber(clause) else { return Terms::default() };
        let [sn, sy, sz] = self.stresses(f);
        let weight = if y.starts_with("k_m") { [self.k_m, 1.0] } else { [1.0, self.k_m] };
        let [ry, rz] = [weight[0] * sy / (self.fm[0] * k_mod), weight[1] * sz / (self.fm[1] * k_mod)];
        let Some(symbol) = axial else { return Terms::of([(y, ry), (z, rz)]) };
        let c = -sn / (self.fc * k_mod);
        let value = match clause {
            Clause::TimberColumnY => c / self.columns[0][1],
            Clause::TimberColumnZ => c / self.columns[1][1],
            Clause::TimberCompressionBendingY | Clause::TimberCompressionBendingZ => c * c,
            _ => sn / (self.ft * k_mod),
        };
        Terms::of([(symbol, value), (y, ry), (z, rz)])
    }

    /// The terms of a clause of [`TimberMember::stability`], of the edge that is worse.
    pub fn stability_terms(&self, clause: Clause, p: &Peaks, k_mod: f64) -> Terms {
        if clause != Clause::TimberLateralAxial {
            return Terms::default();
        }
        let ratio = |my: f64, case: usize| {
            let [rel, k_crit] = self.laterals[case];
            if rel == 0.0 { 0.0 } else { my / self.w[0] / (k_crit * self.fm[0] * k_mod) }
        };
        let bending = ratio(p.my[0], 0).max(ratio(p.my[1], p.bottom_case()));
        // As in the check: over 1 the square is left out.
        let (symbol, value) = match bending {
            b if b <= 1.0 => ("(s_m,y,d / (k_crit f_m,y,d))^2", b * b),
            b => ("s_m,y,d / (k_crit f_m,y,d)", b),
        };
        let axial = p.compression / (self.a * self.fc * k_mod) / self.columns[1][1];
        Terms::of([(symbol, value), ("s_c,0,d / (k_c,z f_c,0,d)", axial)])
    }

    /// Torsion with shear at a point: 6.1.8, and as EN 1995-1-1:2004 has no rule for both, tau_tor / (k_shape f_v,d) + (tau / f_v,d)^2.
    pub fn torsion(&self, torque: f64, f: &Forces, k_mod: f64) -> Checked {
        let [k_shape, wt] = self.torsion;
        let fv = self.fv * k_mod;
        let demand = torque.abs() / wt / (k_shape * fv) + (self.shear_stress(f) / fv).powi(2);
        Checked { clause: Clause::TimberTorsion, demand, resistance: 1.0 }
    }

    /// k_shape (6.15) and the torsion modulus, m3.
    pub fn torsion_values(&self) -> [f64; 2] {
        self.torsion
    }

    /// Factor k_m.
    pub fn k_m(&self) -> f64 {
        self.k_m
    }
}
