//! A steel member with everything that does not depend on its forces worked out.

use super::super::terms::Terms;
use super::super::{Checked, Clause, Forces, Peaks, Section, Shape};
use super::buckling::{flexural, lateral, torsional};
use super::resistance::{Resistance, interaction, interaction_terms, plastic, reduced, shear_share};
use super::{Class, Curve, Lateral, Steel, curves, reduction};

/// A steel member ready to be checked.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SteelMember {
    /// The steel.
    pub steel: Steel,
    /// The section of one ply; resistances are those of all.
    pub section: Section,
    /// Class it is checked in.
    pub class: Class,
    /// Relative slenderness for flexural buckling about y and z and for torsional buckling (0 where it cannot occur).
    pub slenderness: [f64; 3],
    /// Reduction factors to them.
    pub chi: [f64; 3],
    /// Relative slenderness for lateral torsional buckling with the top edge compressed, with the bottom edge, and with the bottom edge
    /// where the moment changes sign along the member ([`Peaks::bottom_case`]); 0 when held.
    pub slenderness_lt: [f64; 3],
    /// Reduction factors to them.
    pub chi_lt: [f64; 3],
    /// Equivalent uniform moment factors C_my, C_mz, C_mLT of Table B.3; 1 is the safe side.
    pub cm: [f64; 3],
    resistance: Resistance,
    /// V_pl,Rd along y and z.
    shear: [f64; 2],
}

impl SteelMember {
    /// A member of class 1 to 3; class 4 has no resistance here, `None`. `plies` sections side by side share the forces; `lengths` are
    /// the buckling lengths about y, about z and for torsion, m, 0 where held; `free`: over which length the compressed flange is
    /// free, for the three cases of `slenderness_lt`, `None` where it is held.
    pub fn new(
        steel: Steel,
        section: &Section,
        class: Class,
        plies: f64,
        lengths: [f64; 3],
        free: [Option<Lateral>; 3],
        curve: Option<Curve>,
    ) -> Option<SteelMember> {
        if class == Class::Four {
            return None;
        }
        let w = if class <= Class::Two { section.wpl } else { section.wel };
        let open = matches!(section.shape, Shape::I { .. });
        let [curve_y, curve_z] = curve.map_or(curves(&section.shape), |c| [c; 2]);
        let twist = if open && lengths[2] > 0.0 { torsional(&steel, section, lengths[2]) } else { 0.0 };
        let slenderness = [flexural(&steel, section, 0, lengths[0]), flexural(&steel, section, 1, lengths[1]), twist];
        // Sections of equal stiffness about both axes have nowhere to tip to.
        let tips = open || section.i[0] > 1.001 * section.i[1];
        let held = |l: &Option<Lateral>| match l {
            Some(l) if tips => lateral(&steel, section, l, w[0] * steel.fy),
            _ => [0.0, 1.0],
        };
        let lt = [held(&free[0]), held(&free[1]), held(&free[2])];
        let f = plies * steel.fy / steel.gamma_m0;
        Some(SteelMember {
            steel,
            section: *section,
            class,
            slenderness,
            chi: [
                reduction(slenderness[0], curve_y),
                reduction(slenderness[1], curve_z),
                reduction(slenderness[2], curve_z),
            ],
            slenderness_lt: lt.map(|l| l[0]),
            chi_lt: lt.map(|l| l[1]),
            cm: [1.0; 3],
            resistance: Resistance { n: section.a * f, m: w.map(|w| w * f) },
            shear: section.av.map(|a| a * f / 3f64.sqrt()),
        })
    }

    /// Clauses of 6.2 at one point of the member. Both signs of the moments count alike.
    #[inline]
    pub fn section(&self, f: &Forces, mut visit: impl FnMut(Checked)) {
        let mut check = |clause, demand, resistance| visit(Checked { clause, demand, resistance });
        let shear = self.shear_demand(f);
        let rho = [0, 1].map(|k| shear_share(shear[k], self.shear[k]));
        let r = reduced(&self.resistance, &self.section, self.class, rho);
        let (axial, m) = (f.n.abs(), [f.my.abs(), f.mz.abs()]);
        check(if f.n > 0.0 { Clause::SteelTension } else { Clause::SteelCompression }, axial, r.n);
        check(Clause::SteelBendingY, m[0], r.m[0]);
        check(Clause::SteelBendingZ, m[1], r.m[1]);
        check(Clause::SteelShearY, shear[0], self.shear[0]);
        check(Clause::SteelShearZ, shear[1], self.shear[1]);
        if (m[0] > 0.0 || m[1] > 0.0) && (axial > 0.0 || (m[0] > 0.0 && m[1] > 0.0)) {
            check(Clause::SteelBendingAxial, interaction(&r, &self.section, self.class, axial, m), 1.0);
        }
    }

    /// Shear along y and z; a round section takes their resultant.
    fn shear_demand(&self, f: &Forces) -> [f64; 2] {
        match self.section.shape {
            Shape::Tube { .. } => [0.0, (f.vy * f.vy + f.vz * f.vz).sqrt()],
            _ => [f.vy.abs(), f.vz.abs()],
        }
    }

    /// Clauses of 6.3 for the largest forces along the member.
    #[inline]
    pub fn stability(&self, p: &Peaks, mut visit: impl FnMut(Checked)) {
        let mut check = |clause, demand, resistance| visit(Checked { clause, demand, resistance });
        let [ny, nz, nt] = self.buckling();
        let c = p.compression;
        if c > 0.0 {
            check(Clause::SteelBucklingY, c, ny);
            check(Clause::SteelBucklingZ, c, nz);
            if self.slenderness[2] > 0.0 {
                check(Clause::SteelTorsionalBuckling, c, nt);
            }
        }
        let bottom = p.bottom_case();
        for (my, case) in [(p.my[0], 0), (p.my[1], bottom)] {
            if self.slenderness_lt[case] > 0.0 && my > 0.0 {
                check(Clause::SteelLateral, my, self.lateral_moment(case));
            }
        }
        let my = (p.my[0] / self.chi_lt[0]).max(p.my[1] / self.chi_lt[bottom]);
        if c > 0.0 && (my > 0.0 || p.mz > 0.0) {
            let [y, z] = self.amplified(c, my, p.mz);
            check(Clause::SteelMemberY, y, 1.0);
            check(Clause::SteelMemberZ, z, 1.0);
        }
    }

    /// N_b,Rd for buckling about y, about z and by torsion, N.
    pub fn buckling(&self) -> [f64; 3] {
        self.chi.map(|chi| chi * self.resistance.n * self.of_member())
    }

    /// M_b,Rd in one of the three cases of `slenderness_lt`, N m.
    pub fn lateral_moment(&self, case: usize) -> f64 {
        self.chi_lt[case] * self.resistance.m[0] * self.of_member()
    }

    /// N_c,Rd.
    pub fn axial(&self) -> f64 {
        self.resistance.n
    }

    /// M_c,Rd about y and z.
    pub fn moments(&self) -> [f64; 2] {
        self.resistance.m
    }

    /// V_c,Rd along y and z.
    pub fn shears(&self) -> [f64; 2] {
        self.shear
    }

    /// M_N,Rd over M_pl,Rd about y and z under an axial force, N of either sign, 6.2.9.1; classes 1 and 2.
    pub fn moments_left(&self, axial: f64) -> [f64; 2] {
        plastic(&self.section, (axial.abs() / self.resistance.n).min(1.0)).0
    }

    /// gamma M0 over gamma M1: from the resistance of a section to that of a member.
    fn of_member(&self) -> f64 {
        self.steel.gamma_m0 / self.steel.gamma_m1
    }

    /// Axial force over N_b,Rd about y and about z (the worse of flexure and torsion).
    fn axial_shares(&self, compression: f64) -> [f64; 2] {
        let [ny, nz, nt] = self.buckling();
        [compression / ny, compression / nz.min(nt)]
    }

    /// k_yy, k_yz, k_zy, k_zz of Annex B, Tables B.1 and B.2. Hollow sections: k_zz has the form of k_yy. A free flange makes a member
    /// susceptible to torsion (Table B.2) when it can buckle sideways at all.
    pub fn factors(&self, compression: f64) -> [f64; 4] {
        let [ny, nz] = self.axial_shares(compression);
        let [ly, lz] = [self.slenderness[0], self.slenderness[1]];
        let [cy, cz, clt] = self.cm;
        let plastic = self.class <= Class::Two;
        let closed = !matches!(self.section.shape, Shape::I { .. });
        let (kyy, kzz, kyz) = if plastic {
            let kyy = cy * (1.0 + (ly - 0.2).clamp(0.0, 0.8) * ny);
            let kzz = if closed {
                cz * (1.0 + (lz - 0.2).clamp(0.0, 0.8) * nz)
            } else {
                cz * (1.0 + (2.0 * lz - 0.6).clamp(0.0, 1.4) * nz)
            };
            (kyy, kzz, 0.6 * kzz)
        } else {
            let kyy = cy * (1.0 + 0.6 * ly.min(1.0) * ny);
            let kzz = cz * (1.0 + 0.6 * lz.min(1.0) * nz);
            (kyy, kzz, kzz)
        };
        let susceptible = self.chi_lt.iter().any(|chi| *chi < 1.0);
        let kzy = match (plastic, susceptible) {
            (true, false) => 0.6 * kyy,
            (false, false) => 0.8 * kyy,
            (true, true) if lz < 0.4 => (0.6 + lz).min(1.0 - 0.1 * lz * nz / (clt - 0.25)),
            (true, true) => 1.0 - 0.1 * lz.min(1.0) * nz / (clt - 0.25),
            (false, true) => 1.0 - 0.05 * lz.min(1.0) * nz / (clt - 0.25),
        };
        [kyy, kyz, kzy.max(0.0), kzz]
    }

    /// Left sides of (6.61) and (6.62); `my` already over chi LT.
    fn amplified(&self, compression: f64, my: f64, mz: f64) -> [f64; 2] {
        self.amplified_terms(compression, my, mz).map(|[n, y, z]| n + y + z)
    }

    /// Their terms: of the axial force, of bending about y and about z.
    fn amplified_terms(&self, compression: f64, my: f64, mz: f64) -> [[f64; 3]; 2] {
        let [ny, nz] = self.axial_shares(compression);
        let [kyy, kyz, kzy, kzz] = self.factors(compression);
        let r = self.of_member();
        let [y, z] = [my / (r * self.resistance.m[0]), mz / (r * self.resistance.m[1])];
        [[ny, kyy * y, kyz * z], [nz, kzy * y, kzz * z]]
    }

    /// The terms of 6.2.9 at a point, which sum up to the demand of [`SteelMember::section`]; none for other clauses of it.
    pub fn terms(&self, clause: Clause, f: &Forces) -> Terms {
        if clause != Clause::SteelBendingAxial {
            return Terms::default();
        }
        let shear = self.shear_demand(f);
        let rho = [0, 1].map(|k| shear_share(shear[k], self.shear[k]));
        let r = reduced(&self.resistance, &self.section, self.class, rho);
        interaction_terms(&r, &self.section, self.class, f.n.abs(), [f.my.abs(), f.mz.abs()])
    }

    /// The terms of (6.61) or (6.62), which sum up to the demand of [`SteelMember::stability`]; none for other clauses of it.
    pub fn stability_terms(&self, clause: Clause, p: &Peaks) -> Terms {
        let my = (p.my[0] / self.chi_lt[0]).max(p.my[1] / self.chi_lt[p.bottom_case()]);
        let [about_y, about_z] = self.amplified_terms(p.compression, my, p.mz);
        match clause {
            Clause::SteelMemberY => Terms::of([
                ("N_Ed / N_b,y,Rd", about_y[0]),
                ("k_yy M_y,Ed / M_b,Rd", about_y[1]),
                ("k_yz M_z,Ed / M_z,Rd", about_y[2]),
            ]),
            Clause::SteelMemberZ => Terms::of([
                ("N_Ed / N_b,z,Rd", about_z[0]),
                ("k_zy M_y,Ed / M_b,Rd", about_z[1]),
                ("k_zz M_z,Ed / M_z,Rd", about_z[2]),
            ]),
            _ => Terms::default(),
        }
    }
}
