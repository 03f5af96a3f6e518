//! Everything the load cases and combinations need, SI (N, m).

use std::collections::BTreeMap;
use std::sync::Arc;

use super::pressure::{PressureTables, rows};
use super::site::{Annex, SurfaceWeights};
use crate::frame::Area;
use crate::voxels::Boards;

/// Form of the ultimate combinations.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Expression {
    /// (6.10).
    #[default]
    One,
    /// The less favourable of (6.10a) and (6.10b).
    Two,
}

/// Drifting snow (EN 1991-1-3 5.3.6).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SnowDrift {
    /// Weight of snow, N/m3.
    pub weight: f64,
    /// Least and most mu_w.
    pub mu_w: [f64; 2],
    /// Least and most drift length, m.
    pub length: [f64; 2],
    /// Pitch in degrees from which snow slides off the upper roof.
    pub slides: f64,
}

/// Limits of floor vibration (EN 1995-1-1 7.3.3) and the board that shares a point load between joists.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Vibration {
    /// Least first frequency, Hz.
    pub frequency: f64,
    /// Most deflection under 1 kN, m/N.
    pub deflection: f64,
    /// b of (7.4).
    pub b: f64,
    /// Modal damping ratio.
    pub damping: f64,
    /// Bending stiffness of the floor across the joists, N m2/m.
    pub board: f64,
}

/// Everything the load cases and combinations need, SI (N, m).
#[derive(Clone, Debug, PartialEq)]
pub struct LoadSettings {
    /// True for the thesis preset alone.
    pub preset_only: bool,
    /// The annex.
    pub annex: Annex,
    /// The terrain's name.
    pub terrain_name: String,
    /// Where the numbers are from, by their key in `loads.json`.
    pub sources: Arc<BTreeMap<String, String>>,
    /// Form of the ultimate combinations.
    pub expression: Expression,
    /// Partial factors of (6.10), or of (6.10b) without xi: G unfavourable, G favourable, variable.
    pub gamma: [f64; 3],
    /// Factor on permanent load in (6.10a), and for permanent load alone.
    pub gamma_a: f64,
    /// Factor on permanent load in (6.10b).
    pub xi: f64,
    /// Static equilibrium: permanent load that holds down, wind that lifts.
    pub equ: [f64; 2],
    /// psi0 of imposed load, snow, wind.
    pub psi0: [f64; 3],
    /// psi1 of imposed load, snow, wind.
    pub psi1: [f64; 3],
    /// psi2 of imposed load, snow, wind; for creep.
    pub psi2: [f64; 3],
    /// Imposed loads, N/m2.
    pub floor: f64,
    /// On stairs.
    pub stair: f64,
    /// On decks.
    pub deck: f64,
    /// On roofs by pitch in degrees (category H); stands in for snow where it is larger, never with it.
    pub roof: Vec<[f64; 2]>,
    /// On floors of roof spaces.
    pub attic: f64,
    /// Allowance for partitions on floors of storeys, with the imposed load.
    pub partitions: f64,
    /// Snow shape coefficient up to 30 degrees.
    pub mu1_30: f64,
    /// Snow in valleys: mu2 at 0 degrees, its gain to 30 degrees, its most.
    pub mu2: [f64; 3],
    /// Snow that drifts against taller parts.
    pub drift: SnowDrift,
    /// Snow on the ground, N/m2.
    pub sk: f64,
    /// Basic wind velocity, m/s.
    pub vb: f64,
    /// Roughness length and least height, m.
    pub terrain: [f64; 2],
    /// kg/m3.
    pub air_density: f64,
    /// External pressure coefficients.
    pub pressures: PressureTables,
    /// Height of parapets on flat roofs, m.
    pub parapet: f64,
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
    /// Floor vibration.
    pub vibration: Vibration,
    /// Self weights of the build-ups.
    pub weights: SurfaceWeights,
}

impl LoadSettings {
    /// Source and date of a number by its key in `loads.json`; empty for what is not there.
    pub fn source(&self, key: &str) -> String {
        self.sources.get(key).cloned().unwrap_or_default()
    }

    /// Peak velocity pressure at height z in m, N/m2: (1 + 7 Iv) rho/2 vm^2 (EN 1991-1-4 4.3 to 4.5, no orography).
    pub fn peak_pressure(&self, z: f64) -> f64 {
        let [z0, least] = self.terrain;
        let log = (z.max(least) / z0).ln();
        let kr = 0.19 * (z0 / 0.05f64).powf(0.07);
        let vm = kr * log * self.vb;
        (1.0 + 7.0 / log) * 0.5 * self.air_density * vm * vm
    }

    /// Snow shape coefficient mu1 of a pitch in degrees (EN 1991-1-3 Table 5.2).
    pub fn mu1(&self, pitch: f64) -> f64 {
        self.mu1_30 * ((60.0 - pitch) / 30.0).clamp(0.0, 1.0)
    }

    /// Snow on a roof of `pitch` degrees, N/m2 of plan.
    pub fn snow(&self, pitch: f64) -> f64 {
        self.sk * self.mu1(pitch)
    }

    /// Snow shape coefficient mu2 in the valley between slopes of `pitch` degrees (EN 1991-1-3 Table 5.2).
    pub fn mu2(&self, pitch: f64) -> f64 {
        let [level, gain, most] = self.mu2;
        (level + gain * pitch / 30.0).min(most)
    }

    /// Snow against a taller part: load at the wall in N/m2 and drift length in m (EN 1991-1-3 5.3.6).
    ///
    /// `above` is the height of the taller part over the roof, `b1` and `b2` the lengths of the upper and the lower roof across the
    /// wall, all in m; `slope` the plan length in m of an upper slope of `pitch` degrees that falls towards the lower roof: half of
    /// its snow slides down and lies as a triangle over the drift length.
    pub fn drift(&self, above: f64, b1: f64, b2: f64, slope: f64, pitch: f64) -> [f64; 2] {
        let d = &self.drift;
        if self.sk <= 0.0 || above <= 0.0 {
            return [0.0, d.length[0]];
        }
        let length = (2.0 * above).clamp(d.length[0], d.length[1]);
        let wind = ((b1 + b2) / (2.0 * above)).min(d.weight * above / self.sk).clamp(d.mu_w[0], d.mu_w[1]);
        let slides = if pitch > d.slides { self.mu1(pitch) * slope / length } else { 0.0 };
        [(wind + slides) * self.sk, length]
    }

    /// cpe of windward and leeward walls for h/d, linear between the rows.
    pub fn wall_cpe(&self, h_over_d: f64) -> [f64; 2] {
        self.pressures.walls(h_over_d)
    }

    /// Factor on the overall horizontal wind force (racking and drift), EN 1991-1-4 7.2.2(3).
    pub fn correlation(&self, h_over_d: f64) -> f64 {
        let [low, high] = self.overall;
        low + (high - low) * ((h_over_d - 1.0) / 4.0).clamp(0.0, 1.0)
    }

    /// Imposed load on a roof of `pitch` degrees (category H), N/m2.
    pub fn roof_load(&self, pitch: f64) -> f64 {
        rows(&self.roof, pitch)[1]
    }

    /// Layers' weight (N/m2 of area), imposed load, and snow or the imposed load of a roof where that is larger.
    pub(in super::super) fn vertical(&self, area: Area, pitch: f64, boards: Boards) -> [f64; 3] {
        let w = |s: usize| self.weights.surface_kn_m2[s] * 1e3;
        let roof = |pitch: f64| self.snow(pitch).max(self.roof_load(pitch));
        match area {
            Area::Floor => [self.weights.floor_kn_m2 * 1e3, self.floor + self.partitions, 0.0],
            Area::Attic => [self.weights.floor_kn_m2 * 1e3, self.attic, 0.0],
            Area::Deck => [w(7), self.deck, self.snow(0.0)],
            Area::FlatRoof => [w(6), 0.0, roof(0.0)],
            Area::Soffit => [w(8), 0.0, 0.0],
            Area::Stair => [self.weights.floor_kn_m2 * 1e3, self.stair, 0.0],
            Area::Wall(_) if boards == Boards::BothSides => [self.weights.wall_both_kn_m2 * 1e3, 0.0, 0.0],
            Area::Wall(_) => [w(0), 0.0, 0.0],
            Area::Band(_) => [w(1), 0.0, 0.0],
            Area::Window(_) => [w(3), 0.0, 0.0],
            Area::Door(_) => [w(4), 0.0, 0.0],
            Area::Slope(_) => [w(5) / pitch.to_radians().cos(), 0.0, roof(pitch)],
            Area::Plateau => [w(5), 0.0, roof(0.0)],
        }
    }
}
