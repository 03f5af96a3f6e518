//! Winds and combinations of EN 1990 over the base actions.

use super::cases::{Case, CaseLoads, UNITS};
use super::loads::{Expression, LoadSettings};
use super::wind::slenderness;
use crate::frame::HouseFrame;

/// Shortest action in a combination; decides kmod (EN 1995-1-1 Table 3.1).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Duration {
    Permanent = 0,
    Medium = 1,
    Short = 2,
}

/// A combination as factors on base actions: permanent, imposed, snow in one of its arrangements, a wind of [`winds`].
#[derive(Clone, Copy, Debug)]
pub(super) struct Combination {
    pub permanent: f64,
    pub imposed: f64,
    pub snow: (usize, f64),
    pub wind: Option<(usize, f64)>,
    pub duration: Duration,
    /// Expression of EN 1990.
    pub clause: &'static str,
}

/// Arrangements of snow: even, half off each of two sides, drifted.
pub(super) const SNOWS: usize = 4;
/// Base actions before the winds: permanent, imposed, four arrangements of snow.
pub(super) const GRAVITY: usize = 2 + SNOWS;
/// Winds from a side.
pub(super) const WINDS_A_SIDE: usize = 4;
/// All winds.
pub(super) const WINDS: usize = 4 * WINDS_A_SIDE;
/// Number of a side's wind that drives drift and vertical deflection: internal suction, windward roof pressed.
pub(super) const PRESSED: usize = 1;
/// Number of a side's wind that lifts: internal pressure, all roofs sucked.
pub(super) const LIFTING: usize = 2;
/// Number of a side's wind with the lee of duopitch roofs at its largest too.
pub(super) const BOTH: usize = 3;

/// Arrangements of snow that differ from the even one on this frame.
pub(super) fn snows(cases: &CaseLoads) -> [bool; SNOWS] {
    std::array::from_fn(|n| n == 0 || cases.slot(Case::HalfPlus as usize + n - 1).is_some())
}

/// Factors on the unit cases of the winds, four from each side: windward roofs pressed with internal pressure and with internal
/// suction, all sucked with internal pressure, windward roofs and the lee of duopitch roofs pressed with internal suction. So
/// three of the four cases of Table 7.4a are run; windward sucked with the lee pressed is not.
pub(super) fn winds(loads: &LoadSettings) -> [[f64; UNITS]; WINDS] {
    let [out, suck] = loads.cpi;
    std::array::from_fn(|n| {
        let (side, kind) = (n / WINDS_A_SIDE, n % WINDS_A_SIDE);
        let mut f = [0.0; UNITS];
        f[Case::Internal as usize] = if kind == PRESSED || kind == BOTH { suck } else { out };
        f[Case::Wind as usize + side] = 1.0;
        f[Case::Pressed as usize + side] = f64::from(u8::from(kind != LIFTING));
        f[Case::Lee as usize + side] = f64::from(u8::from(kind == BOTH));
        f
    })
}

/// Factor on a wind as an action on the house as a whole (racking and drift), by wind.
///
/// Pressure on the windward wall (zone D) and suction on the leeward one (zone E) do not peak together; EN 1991-1-4 7.2.2(3) lowers
/// the resulting force by 0.85 to 1. Only *their* part of it is lowered here: the factor is the lowered force along the wind over
/// the full one, and not under what 7.2.2(3) allows.
pub(super) fn overall(frame: &HouseFrame, loads: &LoadSettings, cases: &CaseLoads) -> [f64; WINDS] {
    std::array::from_fn(|n| {
        let (side, kind) = (n / WINDS_A_SIDE, n % WINDS_A_SIDE);
        let least = loads.correlation(slenderness(frame, side));
        let [walls, roofs, pressed] = cases.along[side];
        let rest = roofs + if kind == LIFTING { 0.0 } else { pressed };
        let full = walls + rest;
        if full > 0.0 { ((least * walls + rest) / full).clamp(least, 1.0) } else { 1.0 }
    })
}

/// Ultimate combinations (STR): permanent alone, each variable action leading with the others at psi0, uplift. Snow that leads is
/// taken in every arrangement, snow that accompanies lies evenly. Imposed load of roofs is in the snow where it is larger.
pub(super) fn ultimate(loads: &LoadSettings, cases: &CaseLoads) -> Vec<Combination> {
    let [up, low, q] = loads.gamma;
    let mut all = vec![Combination {
        permanent: loads.gamma_a,
        imposed: 0.0,
        snow: (0, 0.0),
        wind: None,
        duration: Duration::Permanent,
        clause: "6.10a, permanent alone",
    }];
    match loads.expression {
        Expression::One => leading(loads, cases, up, "6.10", &mut all),
        Expression::Two => {
            leading(loads, cases, loads.xi * up, "6.10b", &mut all);
            accompanying(loads, cases, &mut all);
        }
    }
    for side in 0..4 {
        all.push(Combination {
            permanent: low,
            imposed: 0.0,
            snow: (0, 0.0),
            wind: Some((WINDS_A_SIDE * side + LIFTING, q)),
            duration: Duration::Short,
            clause: "6.10, uplift",
        });
    }
    all
}

/// (6.10a): every variable action at psi0.
fn accompanying(loads: &LoadSettings, cases: &CaseLoads, all: &mut Vec<Combination>) {
    let [p_q, p_s, p_w] = loads.psi0.map(|p| p * loads.gamma[2]);
    let (permanent, clause) = (loads.gamma_a, "6.10a");
    let imposed = p_q;
    all.push(Combination { permanent, imposed, snow: (0, 0.0), wind: None, duration: Duration::Medium, clause });
    if p_s > 0.0 {
        for arrangement in (0..SNOWS).filter(|&n| snows(cases)[n]) {
            let snow = (arrangement, p_s);
            all.push(Combination { permanent, imposed, snow, wind: None, duration: Duration::Short, clause });
        }
    }
    if p_w > 0.0 {
        for side in 0..4 {
            let wind = Some((WINDS_A_SIDE * side + PRESSED, p_w));
            all.push(Combination { permanent, imposed, snow: (0, p_s), wind, duration: Duration::Short, clause });
        }
    }
}

fn leading(loads: &LoadSettings, cases: &CaseLoads, permanent: f64, clause: &'static str, all: &mut Vec<Combination>) {
    let q = loads.gamma[2];
    let [p_q, p_s, p_w] = loads.psi0.map(|p| p * q);
    let with = |imposed, snow, wind: Option<(usize, f64)>, duration| Combination {
        permanent,
        imposed,
        snow,
        wind,
        duration,
        clause,
    };
    all.push(with(q, (0, 0.0), None, Duration::Medium));
    if p_s > 0.0 {
        all.push(with(q, (0, p_s), None, Duration::Short));
    }
    for arrangement in (0..SNOWS).filter(|&n| snows(cases)[n]) {
        all.push(with(p_q, (arrangement, q), None, Duration::Short));
    }
    for side in 0..4 {
        let first = WINDS_A_SIDE * side;
        for kind in [0, PRESSED, BOTH] {
            if kind != BOTH || cases.slot(Case::Lee as usize + side).is_some() {
                all.push(with(p_q, (0, p_s), Some((first + kind, q)), Duration::Short));
            }
        }
        if p_w > 0.0 {
            all.push(with(q, (0, p_s), Some((first + PRESSED, p_w)), Duration::Short));
            all.push(with(p_q, (0, q), Some((first + PRESSED, p_w)), Duration::Short));
        }
    }
}
