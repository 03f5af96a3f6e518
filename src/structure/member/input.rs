//! The input of one member, named with its units.

use schemars::JsonSchema;
use serde::Deserialize;

/// How a hollow section was made.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum FormingWord {
    /// EN 10210.
    Hot,
    /// EN 10219.
    Cold,
}

/// Where across the depth the uniform load acts.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum LoadAt {
    /// On the upper edge, which a sagging moment compresses.
    #[default]
    Top,
    /// At the centroid.
    Centre,
    /// On the lower edge.
    Bottom,
}

/// Procedure for lateral torsional buckling of steel.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum LtbMethod {
    /// 6.3.2.3.
    #[default]
    Rolled,
    /// 6.3.2.2.
    General,
}

/// Duration of the shortest action, EN 1995-1-1 Table 2.1.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum Duration {
    /// Self weight.
    Permanent,
    /// Storage.
    Long,
    /// Imposed load of floors.
    #[default]
    Medium,
    /// Snow, wind.
    Short,
    /// Gusts where the annex says so, accidents.
    Instantaneous,
}

impl Duration {
    /// Word in files.
    pub fn word(self) -> &'static str {
        ["permanent", "long", "medium", "short", "instantaneous"][self as usize]
    }
}

/// One member. Compression and sagging are positive; y is the strong axis. Moments are at the start, `_end` ones at the end (the same
/// where none is given); design loads `q?_Ed` and characteristic ones `gk`, `qk` bend a simple span between them.
///
/// Keys in files are the fields' names, with upper case as in `NEd_kN`; unknown keys are errors.
#[derive(Clone, Debug, Default, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
#[allow(missing_docs, reason = "the names say what they are, with their units")]
pub struct Input {
    pub name: Option<String>,
    #[serde(alias = "steel", alias = "grade")]
    pub material: Option<String>,
    pub section: Option<String>,
    pub forming: Option<FormingWord>,
    pub b_mm: Option<f64>,
    pub h_mm: Option<f64>,
    pub t_mm: Option<f64>,
    #[serde(rename = "L_mm")]
    pub length_mm: Option<f64>,
    #[serde(rename = "Lcr_mm")]
    pub lcr_mm: Option<f64>,
    #[serde(rename = "Lcr_y_mm")]
    pub lcr_y_mm: Option<f64>,
    #[serde(rename = "Lcr_z_mm")]
    pub lcr_z_mm: Option<f64>,
    #[serde(rename = "Lcr_T_mm")]
    pub lcr_t_mm: Option<f64>,
    /// Distance of lateral supports of the compressed edge; 0 where it is held all along.
    #[serde(rename = "L_LT_mm")]
    pub l_lt_mm: Option<f64>,
    /// Effective length of 6.3.3 of EN 1995-1-1 itself.
    pub l_ef_mm: Option<f64>,
    pub load_at: LoadAt,
    pub ltb: LtbMethod,
    pub curve: Option<String>,
    #[serde(rename = "NEd_N")]
    pub n_n: Option<f64>,
    #[serde(rename = "NEd_kN")]
    pub n_kn: Option<f64>,
    #[serde(rename = "Vy_Ed_kN")]
    pub vy_kn: Option<f64>,
    #[serde(rename = "Vz_Ed_kN")]
    pub vz_kn: Option<f64>,
    #[serde(rename = "T_Ed_kNm")]
    pub t_knm: Option<f64>,
    #[serde(rename = "My_Ed_Nmm")]
    pub my_nmm: Option<f64>,
    #[serde(rename = "My_Ed_kNm")]
    pub my_knm: Option<f64>,
    #[serde(rename = "My_end_Ed_kNm")]
    pub my_end_knm: Option<f64>,
    #[serde(rename = "Mz_Ed_Nmm")]
    pub mz_nmm: Option<f64>,
    #[serde(rename = "Mz_Ed_kNm")]
    pub mz_knm: Option<f64>,
    #[serde(rename = "Mz_end_Ed_kNm")]
    pub mz_end_knm: Option<f64>,
    #[serde(rename = "qz_Ed_kN_m")]
    pub qz_kn_m: Option<f64>,
    #[serde(rename = "qy_Ed_kN_m")]
    pub qy_kn_m: Option<f64>,
    #[serde(rename = "gk_kN_m")]
    pub gk_kn_m: Option<f64>,
    #[serde(rename = "qk_kN_m")]
    pub qk_kn_m: Option<f64>,
    #[serde(rename = "gk_kN_m2")]
    pub gk_kn_m2: Option<f64>,
    #[serde(rename = "qk_kN_m2")]
    pub qk_kn_m2: Option<f64>,
    pub spacing_m: Option<f64>,
    pub self_weight: bool,
    #[serde(rename = "gamma_G")]
    pub gamma_g: Option<f64>,
    #[serde(rename = "gamma_Q")]
    pub gamma_q: Option<f64>,
    pub psi2: Option<f64>,
    /// Limits of deflection: span over this.
    pub limit_total: Option<f64>,
    pub limit_variable: Option<f64>,
    #[serde(rename = "Cmy")]
    pub cmy: Option<f64>,
    #[serde(rename = "Cmz")]
    pub cmz: Option<f64>,
    #[serde(rename = "CmLT")]
    pub cmlt: Option<f64>,
    #[serde(rename = "C1")]
    pub c1: Option<f64>,
    #[serde(rename = "C2")]
    pub c2: Option<f64>,
    /// 1 where the compressed flange is held; no other value.
    #[serde(rename = "chi_LT")]
    pub chi_lt: Option<f64>,
    pub service_class: Option<u8>,
    pub duration: Option<Duration>,
    pub kmod: Option<f64>,
    pub ksys: Option<f64>,
    pub kdef: Option<f64>,
    #[serde(rename = "kcr")]
    pub k_cr: Option<f64>,
    #[serde(rename = "gamma_M")]
    pub gamma_m: Option<f64>,
    #[serde(rename = "gamma_M0")]
    pub gamma_m0: Option<f64>,
    #[serde(rename = "gamma_M1")]
    pub gamma_m1: Option<f64>,
    #[serde(rename = "fy_MPa")]
    pub fy_mpa: Option<f64>,
    #[serde(rename = "E_MPa")]
    pub e_mpa: Option<f64>,
    #[serde(rename = "G_MPa")]
    pub g_mpa: Option<f64>,
    #[serde(rename = "fmk_MPa")]
    pub fmk_mpa: Option<f64>,
    #[serde(rename = "ft0k_MPa")]
    pub ft0k_mpa: Option<f64>,
    #[serde(rename = "fc0k_MPa")]
    pub fc0k_mpa: Option<f64>,
    #[serde(rename = "fvk_MPa")]
    pub fvk_mpa: Option<f64>,
    #[serde(rename = "E05_MPa")]
    pub e05_mpa: Option<f64>,
    pub beta_c: Option<f64>,
    /// Properties of a table in the place of the computed ones.
    #[serde(rename = "A_mm2")]
    pub a_mm2: Option<f64>,
    #[serde(rename = "I_mm4")]
    pub i_mm4: Option<f64>,
    #[serde(rename = "Iy_mm4")]
    pub iy_mm4: Option<f64>,
    #[serde(rename = "Iz_mm4")]
    pub iz_mm4: Option<f64>,
    #[serde(rename = "It_mm4")]
    pub it_mm4: Option<f64>,
    #[serde(rename = "Iw_mm6")]
    pub iw_mm6: Option<f64>,
    #[serde(rename = "Wpl_y_mm3")]
    pub wpl_y_mm3: Option<f64>,
    #[serde(rename = "Wpl_z_mm3")]
    pub wpl_z_mm3: Option<f64>,
    /// Resistances printed in a book beside its input; compared, not used.
    #[serde(rename = "Nc_Rd_kN")]
    pub nc_rd_kn: Option<f64>,
    #[serde(rename = "Mc_Rd_kNm")]
    pub mc_rd_knm: Option<f64>,
    /// How a book counts the shear area in deflections; said, not used (it is 5/6 b h here too).
    #[serde(rename = "Av")]
    pub av: Option<String>,
}
