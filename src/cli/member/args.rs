//! Flags of `houscaper member`.

use std::path::PathBuf;

use clap::{Args, ValueEnum};
use houscaper::structure::member::{Duration, FormingWord, Input, LoadAt, LtbMethod};

/// One member: kN, kNm, m; y is the strong axis; sagging moments are positive.
#[derive(Args, Default)]
pub struct Member {
    /// JSON file with one member, `members` (many), or a reference example with `input` and `expected`.
    #[arg(required_unless_present = "material")]
    pub file: Option<PathBuf>,
    /// S235, S355, C24, GL24h or GL28h.
    #[arg(long, conflicts_with = "file", requires = "section")]
    pub material: Option<String>,
    /// IPE200, SHS100x100x5, HF-RHS200x100x8, CHS114.3x5, T_60x200, or a size: 60x200 (timber), "RHS200x100x16 hot".
    #[arg(long, conflicts_with = "file")]
    pub section: Option<String>,
    /// Hot finished or cold formed, for hollow sections given by size.
    #[arg(long, value_enum, requires = "material")]
    pub forming: Option<Forming>,
    /// Span, m.
    #[arg(long, value_name = "M", requires = "material")]
    pub length: Option<f64>,
    /// Buckling length about y, m; 0 where held [default: the span].
    #[arg(long, value_name = "M", requires = "material")]
    pub buckling_y: Option<f64>,
    /// Buckling length about z, m; 0 where held [default: the span].
    #[arg(long, value_name = "M", requires = "material")]
    pub buckling_z: Option<f64>,
    /// Distance of lateral supports of the compressed edge, m; 0 where it is held all along [default: the span].
    #[arg(long, value_name = "M", requires = "material")]
    pub lateral: Option<f64>,
    /// Design compression, kN.
    #[arg(long, value_name = "KN", requires = "material", conflicts_with = "tension")]
    pub compression: Option<f64>,
    /// Design tension, kN.
    #[arg(long, value_name = "KN", requires = "material")]
    pub tension: Option<f64>,
    /// Design moment about y, kNm: at both ends, or START,END.
    #[arg(long, value_name = "KNM", value_delimiter = ',', num_args = 1..=2, allow_negative_numbers = true, requires = "material")]
    pub my: Vec<f64>,
    /// Design moment about z, kNm: at both ends, or START,END.
    #[arg(long, value_name = "KNM", value_delimiter = ',', num_args = 1..=2, allow_negative_numbers = true, requires = "material")]
    pub mz: Vec<f64>,
    /// Design shear along y beside that of the moments, kN.
    #[arg(long, value_name = "KN", allow_negative_numbers = true, requires = "material")]
    pub vy: Option<f64>,
    /// Design shear along z beside that of the moments, kN.
    #[arg(long, value_name = "KN", allow_negative_numbers = true, requires = "material")]
    pub vz: Option<f64>,
    /// Design torsion, kNm.
    #[arg(long, value_name = "KNM", allow_negative_numbers = true, requires = "material")]
    pub torsion: Option<f64>,
    /// Design line load along z on the span, kN/m.
    #[arg(long, value_name = "KN_M", allow_negative_numbers = true, requires = "material")]
    pub qz: Option<f64>,
    /// Design line load along y on the span, kN/m.
    #[arg(long, value_name = "KN_M", allow_negative_numbers = true, requires = "material")]
    pub qy: Option<f64>,
    /// Characteristic permanent line load, kN/m: strength with gamma G, deflection with creep.
    #[arg(long, value_name = "KN_M", requires = "material")]
    pub gk: Option<f64>,
    /// Characteristic variable line load, kN/m.
    #[arg(long, value_name = "KN_M", requires = "material")]
    pub qk: Option<f64>,
    /// Add the member's own weight to gk.
    #[arg(long, requires = "material")]
    pub self_weight: bool,
    /// Factor on gk [default: 1.35].
    #[arg(long, value_name = "F", requires = "material")]
    pub gamma_g: Option<f64>,
    /// Factor on qk [default: 1.5].
    #[arg(long, value_name = "F", requires = "material")]
    pub gamma_q: Option<f64>,
    /// Quasi-permanent share of qk, for creep [default: 0.3].
    #[arg(long, value_name = "F", requires = "material")]
    pub psi2: Option<f64>,
    /// Duration of the shortest action (timber) [default: medium].
    #[arg(long, value_enum, requires = "material")]
    pub duration: Option<Term>,
    /// Service class 1, 2 or 3 (timber) [default: 1].
    #[arg(long, value_name = "N", requires = "material")]
    pub service_class: Option<u8>,
    /// Load sharing factor of 6.6 (timber), 1.1 where it applies [default: 1].
    #[arg(long, value_name = "F", requires = "material")]
    pub ksys: Option<f64>,
    /// Where across the depth line loads act [default: top].
    #[arg(long, value_enum, requires = "material")]
    pub load_at: Option<At>,
    /// Procedure for lateral torsional buckling (steel): 6.3.2.3 or 6.3.2.2 [default: rolled].
    #[arg(long, value_enum, requires = "material")]
    pub ltb: Option<Ltb>,
    /// Limit of total deflection, span over this [default: 250].
    #[arg(long, value_name = "N", requires = "material")]
    pub limit_total: Option<f64>,
    /// Limit of deflection under variable load, span over this [default: 300].
    #[arg(long, value_name = "N", requires = "material")]
    pub limit_variable: Option<f64>,
    /// Verdict and governing clause only.
    #[arg(long)]
    pub brief: bool,
}

#[derive(Clone, Copy, ValueEnum)]
pub enum Forming {
    /// EN 10210, buckling curve a.
    Hot,
    /// EN 10219, buckling curve c.
    Cold,
}

#[derive(Clone, Copy, ValueEnum)]
pub enum Term {
    /// Self weight.
    Permanent,
    /// Storage.
    Long,
    /// Imposed load of floors.
    Medium,
    /// Snow, wind.
    Short,
    /// Gusts, accidents.
    Instantaneous,
}

#[derive(Clone, Copy, ValueEnum)]
pub enum At {
    /// On the upper edge.
    Top,
    /// At the centroid.
    Centre,
    /// On the lower edge.
    Bottom,
}

#[derive(Clone, Copy, ValueEnum)]
pub enum Ltb {
    /// Rolled sections, 6.3.2.3.
    Rolled,
    /// General case, 6.3.2.2.
    General,
}

impl Member {
    /// The flags as an input file would say them.
    pub fn input(&self) -> Input {
        let mm = |m: Option<f64>| m.map(|m| m * 1e3);
        let first = |m: &[f64]| m.first().copied();
        let second = |m: &[f64]| m.get(1).copied();
        Input {
            material: self.material.clone(),
            section: self.section.clone(),
            forming: self.forming.map(|f| match f {
                Forming::Hot => FormingWord::Hot,
                Forming::Cold => FormingWord::Cold,
            }),
            length_mm: mm(self.length),
            lcr_y_mm: mm(self.buckling_y),
            lcr_z_mm: mm(self.buckling_z),
            l_lt_mm: mm(self.lateral),
            n_kn: self.compression.or(self.tension.map(|t| -t)),
            my_knm: first(&self.my),
            my_end_knm: second(&self.my),
            mz_knm: first(&self.mz),
            mz_end_knm: second(&self.mz),
            vy_kn: self.vy,
            vz_kn: self.vz,
            t_knm: self.torsion,
            qz_kn_m: self.qz,
            qy_kn_m: self.qy,
            gk_kn_m: self.gk,
            qk_kn_m: self.qk,
            self_weight: self.self_weight,
            gamma_g: self.gamma_g,
            gamma_q: self.gamma_q,
            psi2: self.psi2,
            duration: self.duration.map(|d| match d {
                Term::Permanent => Duration::Permanent,
                Term::Long => Duration::Long,
                Term::Medium => Duration::Medium,
                Term::Short => Duration::Short,
                Term::Instantaneous => Duration::Instantaneous,
            }),
            service_class: self.service_class,
            ksys: self.ksys,
            load_at: self.load_at.map_or(LoadAt::Top, |at| match at {
                At::Top => LoadAt::Top,
                At::Centre => LoadAt::Centre,
                At::Bottom => LoadAt::Bottom,
            }),
            ltb: self.ltb.map_or(LtbMethod::Rolled, |l| match l {
                Ltb::Rolled => LtbMethod::Rolled,
                Ltb::General => LtbMethod::General,
            }),
            limit_total: self.limit_total,
            limit_variable: self.limit_variable,
            ..Input::default()
        }
    }
}
