//! The wind on a frame: peak pressure, edge lengths, and the coefficients that the zones of an area come to.

use super::loads::LoadSettings;
use super::loads::pressure::{WALL, ZONES, lee};
use super::plan::{Plan, Step, face};
use super::zones::{self, Gust};
use crate::frame::{Area, ElementArea, HouseFrame};
use crate::voxels::Direction;

/// Coefficients of an area in the wind from a side.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Coefficients {
    /// Smallest.
    pub least: f64,
    /// The part of it from zones D and E.
    pub walls: f64,
    /// Largest less smallest on slopes that face the wind and level roofs.
    pub pressed: f64,
    /// The same on the lee of duopitch roofs.
    pub lee: f64,
}

/// The wind on a frame.
#[derive(Clone, Debug)]
pub(super) struct Wind {
    /// Peak velocity pressure at the top, N/m2.
    pub pressure: f64,
    /// From each side.
    pub gusts: [Gust; 4],
    /// cpe,10 by side and zone, least and most.
    pub cpe: [[[f64; 2]; ZONES]; 4],
}

impl Wind {
    /// Heights and edge lengths are those of the whole house.
    pub fn new(frame: &HouseFrame, loads: &LoadSettings) -> Wind {
        let height = frame.size_m[2];
        let zones = loads.pressures.zones(frame.pitch_deg, loads.parapet, height);
        let cpe = std::array::from_fn(|side| {
            let mut own = zones;
            let [d, e] = loads.wall_cpe(slenderness(frame, side));
            (own[WALL + 3], own[WALL + 4]) = ([d; 2], [e; 2]);
            own
        });
        let gusts = Direction::ALL.map(|from| Gust { from, e: frame.size_m[1 - from as usize % 2].min(2.0 * height) });
        Wind { pressure: loads.peak_pressure(height), gusts, cpe }
    }

    /// Zones of an area in the wind from a side, with shares that add up to 1; none for areas the wind does not reach. `steps`: the
    /// area's half modules ([`Plan::half_modules`]).
    pub fn zones(
        &self,
        frame: &HouseFrame,
        plan: &Plan,
        a: &ElementArea,
        steps: &[Step],
        side: usize,
        put: &mut impl FnMut(usize, f64),
    ) {
        let (element, gust) = (a.element as usize, &self.gusts[side]);
        match a.area {
            Area::Wall(d) | Area::Band(d) | Area::Window(d) | Area::Door(d) => {
                let [p, q] = frame.elements[element].nodes.map(|n| frame.nodes[n as usize]);
                let middle = [0, 1, 2].map(|x| 0.5 * (p[x] + q[x]));
                let at = [0, 1].map(|x| middle[x] - plan.origin[x]);
                let width = a.area_m2 / frame.element_length_m(element);
                zones::wall(plan, d, at, middle[2], width, gust, put);
            }
            Area::Soffit => each_step(steps, |step, part| {
                let walls = zones::walls_under(plan, step.cell);
                let count = walls.clone().count() as f64;
                let middle = [0, 1].map(|x| 0.5 * (step.rect[x][0] + step.rect[x][1]));
                for d in walls {
                    let put = &mut |zone, share: f64| put(zone, share * part / count);
                    zones::wall(plan, d, middle, step.z, 0.0, gust, put);
                }
            }),
            area if face(area).is_some() => each_step(steps, |step, part| {
                zones::roof(plan, area, step, gust, &mut |zone, share| put(zone, share * part));
            }),
            _ => {}
        }
    }

    /// Coefficients of an area.
    pub fn coefficients(
        &self,
        frame: &HouseFrame,
        plan: &Plan,
        a: &ElementArea,
        steps: &[Step],
        side: usize,
    ) -> Coefficients {
        let mut c = Coefficients::default();
        self.zones(frame, plan, a, steps, side, &mut |zone, share| {
            let [least, most] = self.cpe[side][zone];
            c.least += share * least;
            if a.area != Area::Soffit && (WALL + 3..WALL + 5).contains(&zone) {
                c.walls += share * least;
            }
            *(if lee(zone) { &mut c.lee } else { &mut c.pressed }) += share * (most - least);
        });
        c
    }
}

/// h/d of the house in the wind from a side.
pub(super) fn slenderness(frame: &HouseFrame, side: usize) -> f64 {
    frame.size_m[2] / frame.size_m[side % 2].max(1e-9)
}

/// Visits half modules with their parts of the area.
pub(super) fn each_step(steps: &[Step], mut visit: impl FnMut(&Step, f64)) {
    steps.iter().for_each(|step| visit(step, 1.0 / steps.len() as f64));
}
