//! Combinations of EN 1990 (6.10) over the base actions, and the winds.

use super::loads::LoadSettings;
use super::model::{Case, UNITS};
use crate::frame::HouseFrame;

/// Shortest action in a combination; decides kmod (EN 1995-1-1 Table 3.1).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Duration {
    Permanent = 0,
    Medium = 1,
    Short = 2,
}

/// A combination as factors on base actions: 0 permanent, 1 imposed, 2 snow, 3 + n wind n of [`MEMBER_WINDS`].
#[derive(Clone, Copy, Debug)]
pub(super) struct Combination {
    pub permanent: f64,
    pub imposed: f64,
    pub snow: f64,
    pub wind: Option<(usize, f64)>,
    pub duration: Duration,
}

/// Base actions before the winds: permanent, imposed, snow.
pub(super) const GRAVITY: usize = 3;

/// The winds of [`winds`] that members are checked for, three a side: the windward slope pressed with internal pressure and with
/// internal suction (gravity combinations), sucked with internal pressure (uplift).
pub(super) const MEMBER_WINDS: [usize; 12] = [1, 3, 0, 5, 7, 4, 9, 11, 8, 13, 15, 12];

/// Factors on the unit cases of the winds: from each of four sides, with internal pressure or suction, with the windward slope
/// sucked or pressed: index = 4 side + 2 internal + slope.
///
/// `overall`: for racking and drift. Pressure on the windward wall (zone D) and suction on the leeward one (zone E) do not peak
/// together; EN 1991-1-4 7.2.2(3) lowers *their* sum, as an action on the house as a whole, by 0.85 to 1. Roof, side walls and
/// internal pressure stay as they are, and members are checked under full pressures.
pub(super) fn winds(frame: &HouseFrame, loads: &LoadSettings, overall: bool) -> [[f64; UNITS]; 16] {
    let pressure = loads.peak_pressure(frame.size_m[2]);
    let mut out = [[0.0; UNITS]; 16];
    for (n, f) in out.iter_mut().enumerate() {
        let (side, internal, slope) = (n / 4, loads.cpi[n / 2 % 2], n % 2);
        let depth = frame.size_m[side % 2];
        let width = frame.size_m[1 - side % 2];
        let slender = frame.size_m[2] / depth;
        let correlation = if overall { loads.correlation(slender) } else { 1.0 };
        let [d, e] = loads.wall_cpe(slender).map(|c| correlation * c);
        let strip = (0.1 * width.min(2.0 * frame.size_m[2]) / depth).min(1.0);
        let flat = [loads.flat[0] * strip + loads.flat[1] * (1.0 - strip), loads.flat[2]][slope];
        for face in 0..4 {
            let (wall, roof) = match (face + 4 - side) % 4 {
                0 => (d, loads.slope_windward[slope]),
                2 => (e, loads.slope_leeward),
                _ => (loads.wall_side, loads.slope_side),
            };
            f[Case::Walls as usize + face] = pressure * (internal - wall);
            f[Case::Slopes as usize + face] = pressure * (internal - roof);
        }
        f[Case::Flats as usize] = pressure * (internal - flat);
    }
    out
}

/// Ultimate combinations: each variable action leading, and uplift.
pub(super) fn ultimate(loads: &LoadSettings) -> Vec<Combination> {
    let [up, low, q] = loads.gamma;
    let [p_q, p_s, p_w] = loads.psi0.map(|p| p * q);
    let with = |imposed, snow, wind: Option<(usize, f64)>, duration| Combination {
        permanent: up,
        imposed,
        snow,
        wind,
        duration,
    };
    let mut all = vec![
        // Permanent alone takes the recommended 1.35 in every annex (6.10a).
        Combination { permanent: 1.35, imposed: 0.0, snow: 0.0, wind: None, duration: Duration::Permanent },
        with(q, 0.0, None, Duration::Medium),
        with(q, p_s, None, Duration::Short),
        with(p_q, q, None, Duration::Short),
    ];
    for side in 0..4 {
        for internal in 0..2 {
            all.push(with(p_q, p_s, Some((3 * side + internal, q)), Duration::Short));
        }
        let pressed = 3 * side + 1;
        if p_w > 0.0 {
            all.push(with(q, p_s, Some((pressed, p_w)), Duration::Short));
            all.push(with(p_q, q, Some((pressed, p_w)), Duration::Short));
        }
        all.push(Combination {
            permanent: low,
            imposed: 0.0,
            snow: 0.0,
            wind: Some((3 * side + 2, q)),
            duration: Duration::Short,
        });
    }
    all
}
