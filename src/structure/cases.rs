//! The unit cases every combination is made of.

use super::loads::{FREE_FALL_M_S2, LoadSettings};
use super::plan::{Plan, Step, face};
use super::snow;
use super::wind::{Wind, each_step};
use crate::analysis::{Axes, Distribution, LoadCase, MemberLoad, Model};
use crate::frame::{Area, ElementArea, HouseFrame};
use crate::voxels::Direction;

/// The unit cases every combination is made of, then those of the thesis preset.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Case {
    /// Weight of the members and the build-ups.
    Permanent = 0,
    /// Imposed load.
    Imposed = 1,
    /// Snow, even; the imposed load of roofs where that is larger.
    Snow = 2,
    /// Half of the snow taken off the slopes towards +x or +y (upwards).
    HalfPlus = 3,
    /// Half of the snow taken off the slopes towards -x or -y (upwards).
    HalfMinus = 4,
    /// Snow drifted into valleys and against taller parts, beyond the even load.
    Drift = 5,
    /// Internal pressure: peak velocity pressure on all surfaces, outwards.
    Internal = 6,
    /// External pressure of the wind from a side, smallest coefficients: 7 + `Direction as usize`.
    Wind = 7,
    /// What largest coefficients add on slopes that face the wind and on level roofs: 11 + side.
    Pressed = 11,
    /// What largest coefficients add on the lee of duopitch roofs: 15 + side.
    Lee = 15,
    /// Weight of the members alone, for the thesis preset.
    Frame = 19,
    /// Thesis wind on the posts of a facade, blowing at it: 20 + `Direction as usize`.
    Thesis = 20,
}

/// Number of unit cases of the site model.
pub(super) const UNITS: usize = 19;
/// Number of unit cases with those of the thesis preset.
pub(super) const CASES: usize = 24;

/// All unit cases that load anything, as member loads. `cases` is reused.
pub fn load_cases(frame: &HouseFrame, loads: &LoadSettings, cases: &mut Vec<LoadCase>) {
    let mut all = CaseLoads::default();
    all.fill(frame, loads);
    cases.clear();
    all.lend(true, cases);
}

/// The unit cases of a frame with what is known of their sums.
#[derive(Clone, Debug, Default)]
pub(super) struct CaseLoads {
    all: Vec<LoadCase>,
    lent: Vec<u8>,
    slot: [u8; CASES],
    steps: Vec<Step>,
    /// Plan of the roofs.
    pub plan: Plan,
    /// Along-wind force of zones D and E, of the rest of the smallest coefficients, and of what is pressed, by side, N.
    pub along: [[f64; 3]; 4],
}

/// Index of a case that loads nothing and was not solved.
const EMPTY: u8 = u8::MAX;

impl CaseLoads {
    /// Fills all cases for a frame.
    pub fn fill(&mut self, frame: &HouseFrame, loads: &LoadSettings) {
        if self.all.len() != CASES {
            self.all = (0..CASES).map(|c| LoadCase { name: case_name(c), ..LoadCase::default() }).collect();
            for own in [Case::Permanent, Case::Frame] {
                self.all[own as usize].gravity = [0.0, 0.0, -FREE_FALL_M_S2];
            }
        }
        self.all.iter_mut().for_each(|c| c.members.clear());
        self.plan.fill(frame);
        self.along = [[0.0; 3]; 4];
        let wind = Wind::new(frame, loads);
        for a in &frame.areas {
            self.area(frame, loads, &wind, a);
        }
        thesis_wind(frame, loads, &mut self.all);
    }

    fn area(&mut self, frame: &HouseFrame, loads: &LoadSettings, wind: &Wind, a: &ElementArea) {
        let element = a.element as usize;
        let width = a.area_m2 / frame.element_length_m(element);
        self.plan.half_modules(frame, a, &mut self.steps);
        let (all, steps) = (&mut self.all, &self.steps[..]);
        let mut put = |case: usize, q: [f64; 3]| {
            if q != [0.0; 3] {
                all[case].members.push(uniform(element, q.map(|f| f * width)));
            }
        };
        let [layers, imposed, snow] = loads.vertical(a.area, frame.pitch_deg, frame.boards);
        let layers = frame.layers_n_m2.map_or(layers, |of| of[a.area.kind()]);
        put(Case::Permanent as usize, [0.0, 0.0, -layers]);
        put(Case::Imposed as usize, [0.0, 0.0, -imposed]);
        put(Case::Snow as usize, [0.0, 0.0, -snow]);
        if face(a.area).is_some() {
            let [plus, minus, drift] = uneven_snow(frame, loads, &self.plan, a, steps, snow);
            put(Case::HalfPlus as usize, [0.0, 0.0, plus]);
            put(Case::HalfMinus as usize, [0.0, 0.0, minus]);
            put(Case::Drift as usize, [0.0, 0.0, -drift]);
        }
        let Some(out) = normal(a.area, frame.pitch_deg) else { return };
        put(Case::Internal as usize, out.map(|n| n * wind.pressure));
        for side in 0..4 {
            let c = wind.coefficients(frame, &self.plan, a, steps, side);
            let push = |cpe: f64| out.map(|n| -n * cpe * wind.pressure);
            put(Case::Wind as usize + side, push(c.least));
            put(Case::Pressed as usize + side, push(c.pressed));
            put(Case::Lee as usize + side, push(c.lee));
            let step = Direction::ALL[side].step();
            let force =
                |cpe: f64| (0..2).map(|x| step[x] as f64 * out[x] * cpe * wind.pressure * a.area_m2).sum::<f64>();
            self.along[side][0] += force(c.walls);
            self.along[side][1] += force(c.least - c.walls);
            self.along[side][2] += force(c.pressed);
        }
    }

    /// Moves the cases that load anything into `out`, those of the thesis preset only if asked for; [`CaseLoads::give_back`] takes
    /// them again.
    pub fn lend(&mut self, thesis: bool, out: &mut Vec<LoadCase>) {
        self.slot = [EMPTY; CASES];
        self.lent.clear();
        for case in 0..if thesis { CASES } else { UNITS } {
            if !self.all[case].members.is_empty() || self.all[case].gravity != [0.0; 3] {
                self.slot[case] = out.len() as u8;
                self.lent.push(case as u8);
                out.push(std::mem::take(&mut self.all[case]));
            }
        }
    }

    /// As if every case had been solved, in order.
    #[cfg(test)]
    pub fn all_solved() -> CaseLoads {
        CaseLoads { slot: std::array::from_fn(|c| c as u8), ..CaseLoads::default() }
    }

    /// Takes back what [`CaseLoads::lend`] moved out.
    pub fn give_back(&mut self, cases: &mut Vec<LoadCase>) {
        for (&case, lent) in self.lent.iter().zip(cases.drain(..)) {
            self.all[case as usize] = lent;
        }
    }

    /// Sum of a case's loads, with the members' own weight where it acts and `model` is given, N.
    pub fn force(&self, frame: &HouseFrame, model: Option<&Model>, case: usize) -> [f64; 3] {
        super::report::force(frame, model, &self.all[case])
    }

    /// Number of a case among those that were solved, `None` for one that loads nothing.
    pub fn slot(&self, case: usize) -> Option<usize> {
        (self.slot[case] != EMPTY).then_some(self.slot[case] as usize)
    }
}

/// Snow beyond the even load `even` on a roof: what one-sided arrangements take off, and what drifts onto it, N/m2.
fn uneven_snow(
    frame: &HouseFrame,
    loads: &LoadSettings,
    plan: &Plan,
    a: &ElementArea,
    steps: &[Step],
    even: f64,
) -> [f64; 3] {
    let mut out = [0.0; 3];
    if loads.sk <= 0.0 {
        return out;
    }
    let pitched = matches!(a.area, Area::Slope(_));
    let lies = loads.snow(if pitched { frame.pitch_deg } else { 0.0 });
    each_step(steps, |step, part| {
        let halved = snow::halved(plan, a.area, step);
        (0..2).for_each(|n| out[n] += part * halved[n] * (even - 0.5 * lies));
        out[2] += part * snow::drifted(plan, loads, frame.pitch_deg, a.area, step, even);
    });
    out
}

/// Outward force per m2 (plan m2 of roofs) of a pressure of 1 N/m2; `None` where the wind does not reach.
pub(super) fn normal(area: Area, pitch_deg: f64) -> Option<[f64; 3]> {
    let out = |d: Direction| d.step().map(|s| s as f64);
    match area {
        Area::Wall(d) | Area::Band(d) | Area::Window(d) | Area::Door(d) => Some([out(d)[0], out(d)[1], 0.0]),
        Area::Slope(d) => {
            let t = pitch_deg.to_radians().tan();
            Some([out(d)[0] * t, out(d)[1] * t, 1.0])
        }
        Area::Plateau | Area::FlatRoof | Area::Deck => Some([0.0, 0.0, 1.0]),
        Area::Soffit => Some([0.0, 0.0, -1.0]),
        Area::Floor | Area::Attic | Area::Stair => None,
    }
}

fn thesis_wind(frame: &HouseFrame, loads: &LoadSettings, cases: &mut [LoadCase]) {
    for m in &frame.members {
        for d in Direction::ALL {
            if m.facades >> (d as u8) & 1 == 1 {
                let [x, y] = d.step().map(|s| -loads.thesis_wind * s as f64);
                let case = &mut cases[Case::Thesis as usize + d as usize];
                case.members.extend(m.elements().map(|e| uniform(e, [x, y, 0.0])));
            }
        }
    }
}

fn uniform(member: usize, q: [f64; 3]) -> MemberLoad {
    MemberLoad { member, axes: Axes::Global, distribution: Distribution::Uniform { q } }
}

pub(super) fn case_name(case: usize) -> String {
    let side = |first: usize| ["+x", "+y", "-x", "-y"][case - first];
    match case {
        0 => "permanent".into(),
        1 => "imposed".into(),
        2 => "snow".into(),
        3 => "half of the snow off slopes towards +x or +y".into(),
        4 => "half of the snow off slopes towards -x or -y".into(),
        5 => "drifted snow beyond the even".into(),
        6 => "internal pressure, cpi = 1".into(),
        7..=10 => format!("wind from {}, smallest coefficients", side(7)),
        11..=14 => format!("wind from {}, largest less smallest on windward slopes and level roofs", side(11)),
        15..=18 => format!("wind from {}, largest less smallest on the lee of duopitch roofs", side(15)),
        19 => "frame".into(),
        _ => format!("thesis wind on {}", side(20)),
    }
}
