//! Load settings: a simple site model on the numbers of `configs/loads.json`, and the thesis preset.

use std::collections::BTreeMap;
use std::path::Path;

use serde::Deserialize;
use thiserror::Error;

use super::catalogue::{CatalogueError, Sourced, read};
use crate::frame::Area;

/// National annex.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Deserialize)]
pub enum Annex {
    /// Recommended values.
    #[default]
    #[serde(rename = "EN")]
    En,
    /// The Netherlands.
    #[serde(rename = "NL")]
    Nl,
}

/// Where the house stands.
#[derive(Clone, Debug, PartialEq)]
pub struct Site {
    /// Basic wind velocity, m/s.
    pub vb0_m_s: f64,
    /// Terrain category of EN 1991-1-4 Table 4.1: 0, I, II, III or IV.
    pub terrain: String,
    /// Snow on the ground, kN/m2.
    pub sk_kn_m2: f64,
    /// National annex.
    pub annex: Annex,
}

/// Self weight of the build-ups without the frame, kN/m2.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SurfaceWeights {
    /// By `Surface as usize` of the envelope: wall, band, plinth, window, door, pitched roof, flat roof, deck, soffit, ground.
    pub surface_kn_m2: [f64; 10],
    /// Inside floors, without partitions.
    pub floor_kn_m2: f64,
}

impl Default for SurfaceWeights {
    /// Timber-framed house: boards, insulation, wood cladding; tiles on the roof (EN 1991-1-1 and build-ups of our layers).
    fn default() -> Self {
        SurfaceWeights { surface_kn_m2: [0.40, 0.40, 0.40, 0.35, 0.35, 0.60, 0.45, 0.60, 0.30, 0.0], floor_kn_m2: 0.70 }
    }
}

/// Why loads cannot be made.
#[derive(Debug, Error)]
pub enum LoadError {
    /// A terrain that is not in the table.
    #[error("site.terrain is `{0}`; it must be 0, I, II, III or IV")]
    Terrain(String),
    /// A number out of range.
    #[error("site.{key} is {value}; it must lie between {least} and {most}")]
    Range {
        /// The key.
        key: &'static str,
        /// As given.
        value: f64,
        /// Smallest allowed.
        least: f64,
        /// Largest allowed.
        most: f64,
    },
    /// The data file.
    #[error(transparent)]
    File(#[from] CatalogueError),
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
#[allow(dead_code, reason = "keys that must be known to be allowed")]
struct File {
    schema: String,
    gamma: BTreeMap<String, Sourced<[f64; 3]>>,
    psi0: BTreeMap<String, Sourced<[f64; 3]>>,
    psi2_imposed: Sourced<f64>,
    floor: BTreeMap<String, Sourced<f64>>,
    stair: Sourced<f64>,
    deck: Sourced<f64>,
    roof: Sourced<f64>,
    attic: Sourced<f64>,
    partitions: Sourced<f64>,
    mu1_30: Sourced<f64>,
    air_density: Sourced<f64>,
    terrain: BTreeMap<String, Sourced<[f64; 2]>>,
    wall_d_e: Sourced<[[f64; 3]; 3]>,
    wall_side: Sourced<f64>,
    slope_windward: Sourced<[f64; 2]>,
    slope_leeward: Sourced<f64>,
    slope_side: Sourced<f64>,
    flat: Sourced<[f64; 3]>,
    cpi: Sourced<[f64; 2]>,
    overall: Sourced<[f64; 2]>,
    thesis: Sourced<[f64; 2]>,
    limits: Sourced<[f64; 3]>,
}

/// The numbers of `configs/loads.json`.
pub struct LoadTable(File);

impl LoadTable {
    /// Loads `loads.json` of a folder.
    ///
    /// # Errors
    /// A missing file, an unknown key, a value without unit, source or date.
    pub fn load(configs: &Path) -> Result<LoadTable, LoadError> {
        Ok(LoadTable(read(&configs.join("loads.json"))?))
    }

    /// Settings of a site.
    ///
    /// # Errors
    /// Unknown terrain, or velocity or snow out of range.
    pub fn site(&self, site: &Site, weights: SurfaceWeights) -> Result<LoadSettings, LoadError> {
        range("vb0_m_s", site.vb0_m_s, 10.0, 60.0)?;
        range("sk_kn_m2", site.sk_kn_m2, 0.0, 15.0)?;
        let terrain = self.0.terrain.get(&site.terrain).ok_or_else(|| LoadError::Terrain(site.terrain.clone()))?.value;
        Ok(LoadSettings {
            preset_only: false,
            vb: site.vb0_m_s,
            terrain,
            sk: site.sk_kn_m2 * 1e3,
            ..self.base(site.annex, weights)
        })
    }

    /// The thesis preset: its yes/no only, the verdict stays not assessed.
    pub fn thesis(&self, weights: SurfaceWeights) -> LoadSettings {
        LoadSettings { preset_only: true, ..self.base(Annex::En, weights) }
    }

    fn base(&self, annex: Annex, weights: SurfaceWeights) -> LoadSettings {
        let f = &self.0;
        let key = if annex == Annex::Nl { "NL" } else { "EN" };
        let of = |m: &BTreeMap<String, Sourced<[f64; 3]>>| m.get(key).map_or([1.35, 1.0, 1.5], |s| s.value);
        LoadSettings {
            preset_only: false,
            gamma: of(&f.gamma),
            psi0: of(&f.psi0),
            psi2_imposed: f.psi2_imposed.value,
            floor: f.floor.get(key).map_or(2.0, |s| s.value) * 1e3,
            stair: f.stair.value * 1e3,
            deck: f.deck.value * 1e3,
            roof: f.roof.value * 1e3,
            attic: f.attic.value * 1e3,
            partitions: f.partitions.value * 1e3,
            mu1_30: f.mu1_30.value,
            sk: 0.0,
            vb: 0.0,
            terrain: [0.05, 2.0],
            air_density: f.air_density.value,
            wall_d_e: f.wall_d_e.value,
            wall_side: f.wall_side.value,
            slope_windward: f.slope_windward.value,
            slope_leeward: f.slope_leeward.value,
            slope_side: f.slope_side.value,
            flat: f.flat.value,
            cpi: f.cpi.value,
            overall: f.overall.value,
            thesis_gravity: f.thesis.value[0],
            thesis_wind: f.thesis.value[1],
            limits: f.limits.value,
            weights,
        }
    }
}

fn range(key: &'static str, value: f64, least: f64, most: f64) -> Result<(), LoadError> {
    if value >= least && value <= most { Ok(()) } else { Err(LoadError::Range { key, value, least, most }) }
}

/// Everything the load cases and combinations need, SI (N, m).
#[derive(Clone, Debug, PartialEq)]
pub struct LoadSettings {
    /// True for the thesis preset alone.
    pub preset_only: bool,
    /// Partial factors: G unfavourable, G favourable, variable.
    pub gamma: [f64; 3],
    /// psi0 of imposed load, snow, wind.
    pub psi0: [f64; 3],
    /// psi2 of imposed load, for creep.
    pub psi2_imposed: f64,
    /// Imposed loads, N/m2.
    pub floor: f64,
    /// On stairs.
    pub stair: f64,
    /// On decks.
    pub deck: f64,
    /// On flat roofs (category H); acts where it exceeds snow, never with it.
    pub roof: f64,
    /// On floors of roof spaces.
    pub attic: f64,
    /// Allowance for partitions on floors of storeys, with the imposed load.
    pub partitions: f64,
    /// Snow shape coefficient up to 30 degrees.
    pub mu1_30: f64,
    /// Snow on the ground, N/m2.
    pub sk: f64,
    /// Basic wind velocity, m/s.
    pub vb: f64,
    /// Roughness length and least height, m.
    pub terrain: [f64; 2],
    /// kg/m3.
    pub air_density: f64,
    /// Rows h/d, cpe D, cpe E.
    pub wall_d_e: [[f64; 3]; 3],
    /// cpe of side walls.
    pub wall_side: f64,
    /// cpe of the windward slope, suction and pressure.
    pub slope_windward: [f64; 2],
    /// cpe of the leeward slope.
    pub slope_leeward: f64,
    /// cpe of slopes along the wind.
    pub slope_side: f64,
    /// cpe of flat roofs: edge strip, rest, pressure.
    pub flat: [f64; 3],
    /// Internal pressure coefficients.
    pub cpi: [f64; 2],
    /// Lack of correlation of windward and leeward pressure, on the house as a whole: at h/d <= 1 and at h/d >= 5.
    pub overall: [f64; 2],
    /// Thesis: factor on the frame's own weight.
    pub thesis_gravity: f64,
    /// Thesis: N/m on each windward post line.
    pub thesis_wind: f64,
    /// Denominators: total deflection, variable deflection, drift.
    pub limits: [f64; 3],
    /// Self weights of the build-ups.
    pub weights: SurfaceWeights,
}

impl LoadSettings {
    /// Peak velocity pressure at height z in m, N/m2: (1 + 7 Iv) rho/2 vm^2 (EN 1991-1-4 4.3 to 4.5, no orography).
    pub fn peak_pressure(&self, z: f64) -> f64 {
        let [z0, least] = self.terrain;
        let log = (z.max(least) / z0).ln();
        let kr = 0.19 * (z0 / 0.05f64).powf(0.07);
        let vm = kr * log * self.vb;
        (1.0 + 7.0 / log) * 0.5 * self.air_density * vm * vm
    }

    /// Snow on a roof of `pitch` degrees, N/m2 of plan.
    pub fn snow(&self, pitch: f64) -> f64 {
        self.sk * self.mu1_30 * ((60.0 - pitch) / 30.0).clamp(0.0, 1.0)
    }

    /// cpe of windward and leeward walls for h/d, linear between the rows.
    pub fn wall_cpe(&self, h_over_d: f64) -> [f64; 2] {
        let t = &self.wall_d_e;
        let row = usize::from(h_over_d > t[1][0]);
        let f = ((h_over_d - t[row][0]) / (t[row + 1][0] - t[row][0])).clamp(0.0, 1.0);
        [1, 2].map(|c| t[row][c] + f * (t[row + 1][c] - t[row][c]))
    }

    /// Factor on the overall horizontal wind force (racking and drift), EN 1991-1-4 7.2.2(3).
    pub fn correlation(&self, h_over_d: f64) -> f64 {
        let [low, high] = self.overall;
        low + (high - low) * ((h_over_d - 1.0) / 4.0).clamp(0.0, 1.0)
    }

    /// Layers' weight (N/m2 of area) and imposed load and snow on an area.
    pub(super) fn vertical(&self, area: Area, pitch: f64) -> [f64; 3] {
        let w = |s: usize| self.weights.surface_kn_m2[s] * 1e3;
        let slope = 1.0 / pitch.to_radians().cos();
        match area {
            Area::Floor => [self.weights.floor_kn_m2 * 1e3, self.floor + self.partitions, 0.0],
            Area::Attic => [self.weights.floor_kn_m2 * 1e3, self.attic, 0.0],
            Area::Deck => [w(7), self.deck, self.snow(0.0)],
            Area::FlatRoof => [w(7), (self.roof - self.snow(0.0)).max(0.0), self.snow(0.0)],
            Area::Soffit => [w(8), 0.0, 0.0],
            Area::Stair => [self.weights.floor_kn_m2 * 1e3, self.stair, 0.0],
            Area::Wall(_) => [w(0), 0.0, 0.0],
            Area::Band(_) => [w(1), 0.0, 0.0],
            Area::Window(_) => [w(3), 0.0, 0.0],
            Area::Door(_) => [w(4), 0.0, 0.0],
            Area::Slope(_) => [w(5) * slope, 0.0, self.snow(pitch)],
            Area::Plateau => [w(5), 0.0, self.snow(0.0)],
        }
    }
}
