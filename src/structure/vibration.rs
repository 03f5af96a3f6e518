//! Vibration of floors: first frequency, deflection under 1 kN and velocity after a unit impulse (EN 1995-1-1 7.3.3).

use super::catalogue::{Catalogue, SectionOption};
use super::loads::{FREE_FALL_M_S2, LoadSettings};
use crate::analysis::Solution;
use crate::frame::{Area, HouseFrame, Role, Span};

/// How a floor vibrates: a rectangular floor of equal joists on rigid supports, loaded by nothing but itself.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct FloorVibration {
    /// First frequency, Hz (7.5).
    pub frequency_hz: f64,
    /// Deflection under a point load, m/N (7.3).
    pub deflection_m_n: f64,
    /// Velocity after a unit impulse, m/(N s2) (7.6).
    pub velocity: f64,
    /// Its limit b^(f1 zeta - 1) (7.4).
    pub velocity_limit: f64,
    /// Largest of the three over its limit; above 1 the floor fails.
    pub ratio: f64,
}

/// A floor of joists: span l and width b in m, stiffness along and across the joists in N m2/m, mass in kg/m2, joists `spacing` m
/// apart.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct JoistFloor {
    /// Span, m.
    pub span: f64,
    /// Width, m.
    pub width: f64,
    /// Distance of the joists, m.
    pub spacing: f64,
    /// Bending stiffness along the joists, N m2/m.
    pub along: f64,
    /// Bending stiffness across the joists, N m2/m.
    pub across: f64,
    /// Mass without imposed load, kg/m2.
    pub mass: f64,
}

impl JoistFloor {
    /// Frequency, deflection, velocity, and the worst of them over the limits of the settings.
    ///
    /// The point load spreads over the effective width l/1.1 (EI across / EI along)^(1/4), at least the distance of the joists
    /// (Hamm, Richter, Winter, WCTE 2010, after OENORM B 1995-1-1; the formula not verified against the standard).
    pub fn vibration(&self, limits: &super::loads::Vibration) -> FloorVibration {
        use std::f64::consts::PI;
        let l = self.span;
        let frequency_hz = PI / (2.0 * l * l) * (self.along / self.mass).sqrt();
        let width = (l / 1.1 * (self.across / self.along).powf(0.25)).max(self.spacing);
        let deflection_m_n = l.powi(3) / (48.0 * self.along * width);
        let modes =
            ((40.0 / frequency_hz).powi(2) - 1.0).max(0.0) * (self.width / l).powi(4) * self.along / self.across;
        let velocity = 4.0 * (0.4 + 0.6 * modes.powf(0.25)) / (self.mass * self.width * l + 200.0);
        let velocity_limit = limits.b.powf(frequency_hz * limits.damping - 1.0);
        let ratio =
            (limits.frequency / frequency_hz).max(deflection_m_n / limits.deflection).max(velocity / velocity_limit);
        FloorVibration { frequency_hz, deflection_m_n, velocity, velocity_limit, ratio }
    }
}

/// Fills the floor area that each element carries, m2: floors of rooms, not of roof spaces, decks or roofs.
pub(super) fn floor_areas(frame: &HouseFrame, out: &mut Vec<f64>) {
    out.clear();
    out.resize(frame.elements.len(), 0.0);
    for a in frame.areas.iter().filter(|a| a.area == Area::Floor) {
        out[a.element as usize] += a.area_m2;
    }
}

/// Vibration of a span; `None` for what is no joist of a room's floor between two supports.
pub(super) fn of_span(
    frame: &HouseFrame,
    catalogue: &Catalogue,
    sections: &[SectionOption; 4],
    loads: &LoadSettings,
    solution: &Solution,
    floor_m2: &[f64],
    span: &Span,
) -> Option<FloorVibration> {
    let member = &frame.members[span.member as usize];
    if member.role != Role::Joist || span.held != [true, true] {
        return None;
    }
    let elements = span.elements[0] as usize..=span.elements[1] as usize;
    let length: f64 = elements.clone().map(|e| solution.length(e)).sum();
    let spacing = elements.map(|e| floor_m2[e]).sum::<f64>() / length;
    if spacing < 1e-6 {
        return None;
    }
    let option = sections[member.group as usize];
    let (m, s) = (catalogue.material(option), catalogue.section(option));
    let plies = f64::from(member.plies);
    let [a, b] = member.ends;
    let across = usize::from((b[0] - a[0]).abs() > (b[1] - a[1]).abs());
    let floor = JoistFloor {
        span: length,
        width: frame.size_m[across],
        spacing,
        along: m.e * s.iy * plies / spacing,
        across: loads.vibration.board,
        mass: loads.weights.floor_kn_m2 * 1e3 / FREE_FALL_M_S2 + m.rho * s.a * plies / spacing,
    };
    Some(floor.vibration(&loads.vibration))
}
