//! The numbers of `configs/loads.json` and the settings made of them.

use std::collections::BTreeMap;
use std::path::Path;
use std::sync::Arc;

use serde::Deserialize;

use super::super::catalogue::{Sourced, read};
use super::pressure::PressureTables;
use super::settings::{Expression, LoadSettings, SnowDrift, Vibration};
use super::site::{Annex, LoadError, Site, SurfaceWeights};

type ByAnnex<T> = BTreeMap<String, Sourced<T>>;
type Rows<const N: usize> = Sourced<Vec<[f64; N]>>;

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
#[allow(dead_code, reason = "keys that must be known to be allowed")]
struct File {
    schema: String,
    gamma: ByAnnex<[f64; 3]>,
    expression: ByAnnex<String>,
    gamma_g_610a: ByAnnex<f64>,
    xi: ByAnnex<f64>,
    equ: Sourced<[f64; 2]>,
    psi0: ByAnnex<[f64; 3]>,
    psi1: ByAnnex<[f64; 3]>,
    psi2: ByAnnex<[f64; 3]>,
    floor: ByAnnex<f64>,
    stair: Sourced<f64>,
    deck: Sourced<f64>,
    roof: ByAnnex<Vec<[f64; 2]>>,
    attic: Sourced<f64>,
    partitions: Sourced<f64>,
    mu1_30: Sourced<f64>,
    mu2: Sourced<[f64; 3]>,
    snow_drift: Sourced<[f64; 6]>,
    air_density: Sourced<f64>,
    terrain: ByAnnex<[f64; 2]>,
    wall_d_e: Sourced<[[f64; 3]; 3]>,
    wall_abc: Sourced<[f64; 3]>,
    flat: Rows<6>,
    parapet_m: Sourced<f64>,
    monopitch_0: Rows<7>,
    monopitch_180: Rows<4>,
    monopitch_90: Rows<6>,
    duopitch_0: Rows<11>,
    duopitch_90: Rows<5>,
    trough_0: Rows<6>,
    trough_90: Rows<5>,
    hip: Rows<13>,
    cpi: Sourced<[f64; 2]>,
    overall: Sourced<[f64; 2]>,
    thesis: Sourced<[f64; 2]>,
    limits: Sourced<[f64; 3]>,
    vibration: Sourced<[f64; 4]>,
    floor_board: Sourced<[f64; 2]>,
}

/// The numbers of `configs/loads.json`, with the source of each.
pub struct LoadTable {
    file: File,
    sources: Arc<BTreeMap<String, String>>,
}

impl LoadTable {
    /// Loads `loads.json` of a folder.
    ///
    /// # Errors
    /// A missing file, an unknown key, a value without unit, source or date, a table whose first column does not rise.
    pub fn load(configs: &Path) -> Result<LoadTable, LoadError> {
        let path = configs.join("loads.json");
        let file: File = read(&path)?;
        check(&file)?;
        let sources = Arc::new(sources(&read(&path)?));
        Ok(LoadTable { file, sources })
    }

    /// Settings of a site.
    ///
    /// # Errors
    /// Unknown terrain, or velocity or snow out of range.
    pub fn site(&self, site: &Site, weights: SurfaceWeights) -> Result<LoadSettings, LoadError> {
        range("vb0_m_s", site.vb0_m_s, 10.0, 60.0)?;
        range("sk_kn_m2", site.sk_kn_m2, 0.0, 15.0)?;
        let terrain = self.file.terrain.get(&site.terrain).ok_or_else(|| LoadError::Terrain(site.terrain.clone()))?;
        Ok(LoadSettings {
            preset_only: false,
            vb: site.vb0_m_s,
            terrain_name: site.terrain.clone(),
            terrain: terrain.value,
            sk: site.sk_kn_m2 * 1e3,
            ..self.base(site.annex, weights)
        })
    }

    /// The thesis preset: its yes/no only, the verdict stays not assessed.
    pub fn thesis(&self, weights: SurfaceWeights) -> LoadSettings {
        LoadSettings { preset_only: true, ..self.base(Annex::En, weights) }
    }

    fn base(&self, annex: Annex, weights: SurfaceWeights) -> LoadSettings {
        let f = &self.file;
        let key = annex.key();
        let three = |m: &ByAnnex<[f64; 3]>, or: [f64; 3]| m.get(key).map_or(or, |s| s.value);
        let one = |m: &ByAnnex<f64>, or: f64| m.get(key).map_or(or, |s| s.value);
        let two = f.expression.get(key).is_some_and(|s| s.value == "6.10a/b");
        let [snow_kn, w_least, w_most, l_least, l_most, slides] = f.snow_drift.value;
        let [frequency, mm_kn, b, damping] = f.vibration.value;
        let [board_e, board_mm] = f.floor_board.value;
        LoadSettings {
            preset_only: false,
            annex,
            terrain_name: "II".into(),
            sources: Arc::clone(&self.sources),
            expression: if two { Expression::Two } else { Expression::One },
            gamma: three(&f.gamma, [1.35, 1.0, 1.5]),
            gamma_a: one(&f.gamma_g_610a, 1.35),
            xi: one(&f.xi, 1.0),
            equ: f.equ.value,
            psi0: three(&f.psi0, [0.7, 0.5, 0.6]),
            psi1: three(&f.psi1, [0.5, 0.2, 0.2]),
            psi2: three(&f.psi2, [0.3, 0.0, 0.0]),
            floor: one(&f.floor, 2.0) * 1e3,
            stair: f.stair.value * 1e3,
            deck: f.deck.value * 1e3,
            roof: f.roof.get(key).map_or(Vec::new(), |s| s.value.iter().map(|r| [r[0], r[1] * 1e3]).collect()),
            attic: f.attic.value * 1e3,
            partitions: f.partitions.value * 1e3,
            mu1_30: f.mu1_30.value,
            mu2: f.mu2.value,
            drift: SnowDrift { weight: snow_kn * 1e3, mu_w: [w_least, w_most], length: [l_least, l_most], slides },
            sk: 0.0,
            vb: 0.0,
            terrain: [0.05, 2.0],
            air_density: f.air_density.value,
            pressures: pressures(f),
            parapet: f.parapet_m.value,
            cpi: f.cpi.value,
            overall: f.overall.value,
            thesis_gravity: f.thesis.value[0],
            thesis_wind: f.thesis.value[1],
            limits: f.limits.value,
            vibration: Vibration {
                frequency,
                deflection: mm_kn * 1e-6,
                b,
                damping,
                board: board_e * 1e6 * (board_mm * 1e-3).powi(3) / 12.0,
            },
            weights,
        }
    }

    /// Source and date of every number by its key in `loads.json` (with the annex or terrain behind a point).
    pub fn sources(&self) -> &BTreeMap<String, String> {
        &self.sources
    }
}

fn pressures(f: &File) -> PressureTables {
    PressureTables {
        sides: f.wall_abc.value,
        wall_d_e: f.wall_d_e.value,
        flat: f.flat.value.clone(),
        mono_0: f.monopitch_0.value.clone(),
        mono_180: f.monopitch_180.value.clone(),
        mono_90: f.monopitch_90.value.clone(),
        duo_0: f.duopitch_0.value.clone(),
        duo_90: f.duopitch_90.value.clone(),
        trough_0: f.trough_0.value.clone(),
        trough_90: f.trough_90.value.clone(),
        hip: f.hip.value.clone(),
    }
}

fn check(f: &File) -> Result<(), LoadError> {
    fn rising<const N: usize>(key: &'static str, rows: &[[f64; N]]) -> Result<(), LoadError> {
        let ok = !rows.is_empty() && rows.windows(2).all(|w| w[0][0] < w[1][0]);
        let expected = "rows whose first number rises";
        if ok { Ok(()) } else { Err(LoadError::Table { key, expected }) }
    }
    rising("wall_d_e", &f.wall_d_e.value)?;
    rising("flat", &f.flat.value)?;
    rising("monopitch_0", &f.monopitch_0.value)?;
    rising("monopitch_180", &f.monopitch_180.value)?;
    rising("monopitch_90", &f.monopitch_90.value)?;
    rising("duopitch_0", &f.duopitch_0.value)?;
    rising("duopitch_90", &f.duopitch_90.value)?;
    rising("trough_0", &f.trough_0.value)?;
    rising("trough_90", &f.trough_90.value)?;
    rising("hip", &f.hip.value)?;
    f.roof.values().try_for_each(|s| rising("roof", &s.value))?;
    match f.expression.values().all(|s| s.value == "6.10" || s.value == "6.10a/b") {
        true => Ok(()),
        false => Err(LoadError::Table { key: "expression", expected: "\"6.10\" or \"6.10a/b\"" }),
    }
}

/// `source, date` of every entry with a value.
fn sources(file: &serde_json::Map<String, serde_json::Value>) -> BTreeMap<String, String> {
    fn entry(v: &serde_json::Value) -> Option<String> {
        Some(format!("{} ({})", v.get("source")?.as_str()?, v.get("date")?.as_str()?))
    }
    let mut out = BTreeMap::new();
    for (key, value) in file {
        match entry(value) {
            Some(text) => {
                out.insert(key.clone(), text);
            }
            None => {
                for (inner, value) in value.as_object().into_iter().flatten() {
                    if let Some(text) = entry(value) {
                        out.insert(format!("{key}.{inner}"), text);
                    }
                }
            }
        }
    }
    out
}

fn range(key: &'static str, value: f64, least: f64, most: f64) -> Result<(), LoadError> {
    if value >= least && value <= most { Ok(()) } else { Err(LoadError::Range { key, value, least, most }) }
}
