//! Clauses that a member is checked by.

/// A clause of EN 1993-1-1:2005 (steel) or EN 1995-1-1:2004 (timber).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Clause {
    /// 6.2.3.
    SteelTension,
    /// 6.2.4.
    SteelCompression,
    /// 6.2.5 about y, with 6.2.8.
    SteelBendingY,
    /// 6.2.5 about z, with 6.2.8.
    SteelBendingZ,
    /// 6.2.6 along y.
    SteelShearY,
    /// 6.2.6 along z.
    SteelShearZ,
    /// 6.2.7.
    SteelTorsion,
    /// 6.2.9, with 6.2.10.
    SteelBendingAxial,
    /// 6.3.1 about y.
    SteelBucklingY,
    /// 6.3.1 about z.
    SteelBucklingZ,
    /// 6.3.1.4.
    SteelTorsionalBuckling,
    /// 6.3.2.
    SteelLateral,
    /// 6.3.3 (6.61).
    SteelMemberY,
    /// 6.3.3 (6.62).
    SteelMemberZ,
    /// 6.1.2.
    TimberTension,
    /// 6.1.4.
    TimberCompression,
    /// 6.1.6 (6.11).
    TimberBendingY,
    /// 6.1.6 (6.12).
    TimberBendingZ,
    /// 6.1.7.
    TimberShear,
    /// 6.1.8.
    TimberTorsion,
    /// 6.2.3 (6.17).
    TimberTensionBendingY,
    /// 6.2.3 (6.18).
    TimberTensionBendingZ,
    /// 6.2.4 (6.19).
    TimberCompressionBendingY,
    /// 6.2.4 (6.20).
    TimberCompressionBendingZ,
    /// 6.3.2 (6.23).
    TimberColumnY,
    /// 6.3.2 (6.24).
    TimberColumnZ,
    /// 6.3.3 (6.33).
    TimberLateral,
    /// 6.3.3 (6.35).
    TimberLateralAxial,
}

/// What the demand and the resistance of a clause are measured in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Unit {
    /// N.
    Force,
    /// N m.
    Moment,
    /// Pa.
    Stress,
    /// A sum of ratios against 1.
    Sum,
}

impl Clause {
    /// Number with the standard, e.g. `EN 1993-1-1 6.3.3 (6.61)`.
    pub fn number(self) -> &'static str {
        self.entry().0
    }

    /// What it checks, in words.
    pub fn name(self) -> &'static str {
        self.entry().1
    }

    /// Symbols of demand and resistance; of a sum, its formula and 1.
    pub fn symbols(self) -> [&'static str; 2] {
        self.entry().2
    }

    /// Unit of demand and resistance.
    pub fn unit(self) -> Unit {
        self.entry().3
    }

    /// Whether buckling or lateral torsional buckling is in it: about the member, not one section of it.
    pub fn is_stability(self) -> bool {
        self.number().contains(" 6.3.")
    }

    #[rustfmt::skip]
    fn entry(self) -> (&'static str, &'static str, [&'static str; 2], Unit) {
        use Unit::{Force, Moment, Stress, Sum};
        match self {
            Clause::SteelTension => ("EN 1993-1-1 6.2.3 (6.5)", "tension", ["N_Ed", "N_t,Rd"], Force),
            Clause::SteelCompression => ("EN 1993-1-1 6.2.4 (6.9)", "compression", ["N_Ed", "N_c,Rd"], Force),
            Clause::SteelBendingY => ("EN 1993-1-1 6.2.5 (6.12)", "bending about y", ["M_y,Ed", "M_c,y,Rd"], Moment),
            Clause::SteelBendingZ => ("EN 1993-1-1 6.2.5 (6.12)", "bending about z", ["M_z,Ed", "M_c,z,Rd"], Moment),
            Clause::SteelShearY => ("EN 1993-1-1 6.2.6 (6.17)", "shear along y", ["V_y,Ed", "V_c,y,Rd"], Force),
            Clause::SteelShearZ => ("EN 1993-1-1 6.2.6 (6.17)", "shear along z", ["V_z,Ed", "V_c,z,Rd"], Force),
            Clause::SteelTorsion => ("EN 1993-1-1 6.2.7 (6.23)", "torsion", ["T_Ed", "T_Rd"], Moment),
            Clause::SteelBendingAxial => ("EN 1993-1-1 6.2.9", "bending with axial force", ["(M_y,Ed / M_N,y,Rd)^a + (M_z,Ed / M_N,z,Rd)^b, M_Ed / M_N,Rd each", "1"], Sum),
            Clause::SteelBucklingY => ("EN 1993-1-1 6.3.1 (6.46)", "flexural buckling about y", ["N_Ed", "N_b,y,Rd"], Force),
            Clause::SteelBucklingZ => ("EN 1993-1-1 6.3.1 (6.46)", "flexural buckling about z", ["N_Ed", "N_b,z,Rd"], Force),
            Clause::SteelTorsionalBuckling => ("EN 1993-1-1 6.3.1.4", "torsional buckling", ["N_Ed", "N_b,T,Rd"], Force),
            Clause::SteelLateral => ("EN 1993-1-1 6.3.2 (6.54)", "lateral torsional buckling", ["M_y,Ed", "M_b,Rd"], Moment),
            Clause::SteelMemberY => ("EN 1993-1-1 6.3.3 (6.61)", "bending and compression with buckling about y", ["N_Ed / N_b,y,Rd + k_yy M_y,Ed / M_b,Rd + k_yz M_z,Ed / M_z,Rd", "1"], Sum),
            Clause::SteelMemberZ => ("EN 1993-1-1 6.3.3 (6.62)", "bending and compression with buckling about z", ["N_Ed / N_b,z,Rd + k_zy M_y,Ed / M_b,Rd + k_zz M_z,Ed / M_z,Rd", "1"], Sum),
            Clause::TimberTension => ("EN 1995-1-1 6.1.2 (6.1)", "tension along the grain", ["s_t,0,d", "f_t,0,d"], Stress),
            Clause::TimberCompression => ("EN 1995-1-1 6.1.4 (6.2)", "compression along the grain", ["s_c,0,d", "f_c,0,d"], Stress),
            Clause::TimberBendingY => ("EN 1995-1-1 6.1.6 (6.11)", "bending, y leading", ["s_m,y,d / f_m,y,d + k_m s_m,z,d / f_m,z,d", "1"], Sum),
            Clause::TimberBendingZ => ("EN 1995-1-1 6.1.6 (6.12)", "bending, z leading", ["k_m s_m,y,d / f_m,y,d + s_m,z,d / f_m,z,d", "1"], Sum),
            Clause::TimberShear => ("EN 1995-1-1 6.1.7 (6.13)", "shear", ["t_d", "f_v,d"], Stress),
            Clause::TimberTorsion => ("EN 1995-1-1 6.1.8 (6.14)", "torsion with shear", ["t_tor,d / (k_shape f_v,d) + (t_d / f_v,d)^2", "1"], Sum),
            Clause::TimberTensionBendingY => ("EN 1995-1-1 6.2.3 (6.17)", "bending and tension, y leading", ["s_t,0,d / f_t,0,d + s_m,y,d / f_m,y,d + k_m s_m,z,d / f_m,z,d", "1"], Sum),
            Clause::TimberTensionBendingZ => ("EN 1995-1-1 6.2.3 (6.18)", "bending and tension, z leading", ["s_t,0,d / f_t,0,d + k_m s_m,y,d / f_m,y,d + s_m,z,d / f_m,z,d", "1"], Sum),
            Clause::TimberCompressionBendingY => ("EN 1995-1-1 6.2.4 (6.19)", "bending and compression, y leading", ["(s_c,0,d / f_c,0,d)^2 + s_m,y,d / f_m,y,d + k_m s_m,z,d / f_m,z,d", "1"], Sum),
            Clause::TimberCompressionBendingZ => ("EN 1995-1-1 6.2.4 (6.20)", "bending and compression, z leading", ["(s_c,0,d / f_c,0,d)^2 + k_m s_m,y,d / f_m,y,d + s_m,z,d / f_m,z,d", "1"], Sum),
            Clause::TimberColumnY => ("EN 1995-1-1 6.3.2 (6.23)", "column with bending, buckling about y", ["s_c,0,d / (k_c,y f_c,0,d) + s_m,y,d / f_m,y,d + k_m s_m,z,d / f_m,z,d", "1"], Sum),
            Clause::TimberColumnZ => ("EN 1995-1-1 6.3.2 (6.24)", "column with bending, buckling about z", ["s_c,0,d / (k_c,z f_c,0,d) + k_m s_m,y,d / f_m,y,d + s_m,z,d / f_m,z,d", "1"], Sum),
            Clause::TimberLateral => ("EN 1995-1-1 6.3.3 (6.33)", "lateral torsional buckling", ["s_m,y,d", "k_crit f_m,y,d"], Stress),
            Clause::TimberLateralAxial => ("EN 1995-1-1 6.3.3 (6.35)", "lateral torsional buckling with compression", ["(s_m,y,d / (k_crit f_m,y,d))^2 + s_c,0,d / (k_c,z f_c,0,d)", "1"], Sum),
        }
    }
}

/// One clause applied: what is asked against what is there.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Checked {
    /// The clause.
    pub clause: Clause,
    /// Demand, at least 0, in the clause's [`Unit`].
    pub demand: f64,
    /// Resistance in the same unit.
    pub resistance: f64,
}

impl Checked {
    /// Demand over resistance; over 1 fails.
    #[inline]
    pub fn ratio(&self) -> f64 {
        if self.demand == 0.0 { 0.0 } else { self.demand / self.resistance }
    }

    /// Keeps the worse of two.
    #[inline]
    pub(in crate::structure) fn worse(kept: &mut (f64, Clause), other: &Checked) {
        let ratio = other.ratio();
        if ratio > kept.0 {
            *kept = (ratio, other.clause);
        }
    }
}
