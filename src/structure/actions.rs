//! Unit cases summed up to base actions: what members, sheathing and nodes feel from permanent load, imposed load, snow in its
//! arrangements and each wind.

use super::cases::{Case, CaseLoads};
use super::check::Piece;
use super::combine::{BOTH, Combination, GRAVITY, LIFTING, PRESSED, SNOWS, WINDS, WINDS_A_SIDE, overall, snows};
use super::loads::LoadSettings;
use crate::analysis::Solution;
use crate::frame::HouseFrame;

/// Base actions on members and sheathing: permanent, imposed, snows, winds.
pub(super) const ACTIONS: usize = GRAVITY + WINDS;

/// Base actions on nodes: permanent, imposed, snows and a wind from each side (internal suction, windward roofs pressed).
pub(super) const BASES: usize = GRAVITY + 4;

/// Buffers of the base actions.
#[derive(Default)]
pub(super) struct BaseActions {
    pieces: Vec<Piece>,
    panels: Vec<[f64; ACTIONS]>,
    moves: Vec<[[f64; 3]; BASES]>,
    /// Factor on each wind as an action on the house as a whole.
    pub overall: [f64; WINDS],
    /// Arrangements of snow that differ from the even one.
    pub snows: [bool; SNOWS],
}

/// Forces and loads of an element in a unit case; zero in a case that loads nothing.
pub(super) fn unit_piece(solution: &Solution, cases: &CaseLoads, element: usize, case: usize) -> Piece {
    let Some(slot) = cases.slot(case) else { return [0.0; 8] };
    let f = &solution.end_forces(slot)[element];
    let q = solution.uniform_loads(slot)[element];
    [f[0], f[1], f[2], f[4], f[5], q[0], q[1], q[2]]
}

pub(super) fn add(into: &mut Piece, f: f64, p: &Piece) {
    (0..8).for_each(|n| into[n] += f * p[n]);
}

impl BaseActions {
    /// Sums up the unit cases of a solved frame.
    pub fn fill(&mut self, frame: &HouseFrame, loads: &LoadSettings, cases: &CaseLoads, solution: &Solution) {
        (self.overall, self.snows) = (overall(frame, loads, cases), snows(cases));
        self.pieces.clear();
        for e in 0..frame.elements.len() {
            let all = sums(loads, cases, |slot| {
                let f = &solution.end_forces(slot)[e];
                let q = solution.uniform_loads(slot)[e];
                [f[0], f[1], f[2], f[4], f[5], q[0], q[1], q[2]]
            });
            self.pieces.extend_from_slice(&all);
        }
        self.panels.clear();
        for p in frame.elements.len()..frame.elements.len() + frame.panels.len() {
            self.panels.push(sums(loads, cases, |slot| [solution.end_forces(slot)[p][0]]).map(|[axial]| axial));
        }
        self.moves.clear();
        for n in 0..frame.nodes.len() {
            let all = sums(loads, cases, |slot| {
                let u = &solution.displacements(slot)[n];
                [u[0], u[1], u[2]]
            });
            self.moves.push(std::array::from_fn(|b| all[action(b)]));
        }
    }

    /// All base actions of an element.
    pub fn pieces(&self, element: usize) -> &[Piece] {
        &self.pieces[element * ACTIONS..(element + 1) * ACTIONS]
    }

    /// An element's part in base `b` of the nodes.
    pub fn piece(&self, element: usize, b: usize) -> &Piece {
        &self.pieces(element)[action(b)]
    }

    /// Axial forces of a panel's brace by base action, full wind pressures, N.
    pub fn panel(&self, panel: usize) -> &[f64; ACTIONS] {
        &self.panels[panel]
    }

    /// Translations of a node, by base.
    pub fn node(&self, node: usize) -> &[[f64; 3]; BASES] {
        &self.moves[node]
    }
}

/// The base action of a base of the nodes.
fn action(base: usize) -> usize {
    base.checked_sub(GRAVITY).map_or(base, |side| GRAVITY + WINDS_A_SIDE * side + PRESSED)
}

/// All base actions of something that `unit` tells of a solved case; the winds in the order of [`super::combine::winds`].
fn sums<const N: usize>(
    loads: &LoadSettings,
    cases: &CaseLoads,
    unit: impl Fn(usize) -> [f64; N],
) -> [[f64; N]; ACTIONS] {
    let of = |case: usize| cases.slot(case).map(&unit);
    let plus = |a: &[f64; N], f: f64, b: &[f64; N]| -> [f64; N] { std::array::from_fn(|n| a[n] + f * b[n]) };
    let with = |a: [f64; N], b: Option<[f64; N]>| b.map_or(a, |b| plus(&a, 1.0, &b));
    let mut out = [[0.0; N]; ACTIONS];
    (0..3).for_each(|c| out[c] = of(c).unwrap_or([0.0; N]));
    (3..GRAVITY).for_each(|c| out[c] = with(out[2], of(c)));
    let [bursts, sucks] = loads.cpi;
    let internal = of(Case::Internal as usize).unwrap_or([0.0; N]);
    for side in 0..4 {
        let least = of(Case::Wind as usize + side).unwrap_or([0.0; N]);
        let pressed = with(least, of(Case::Pressed as usize + side));
        let first = GRAVITY + WINDS_A_SIDE * side;
        out[first] = plus(&pressed, bursts, &internal);
        out[first + PRESSED] = plus(&pressed, sucks, &internal);
        out[first + LIFTING] = plus(&least, bursts, &internal);
        out[first + BOTH] = with(out[first + PRESSED], of(Case::Lee as usize + side));
    }
    out
}

/// A combination as a list of base actions and their factors, none of them zero.
#[derive(Clone, Copy, Debug)]
pub(super) struct Sum {
    terms: [(usize, f64); 4],
    count: usize,
    /// kmod of timber.
    pub k_mod: f64,
}

impl Sum {
    /// Of a combination; `k_mod` is that of its duration.
    pub fn new(c: &Combination, k_mod: f64) -> Sum {
        let snow = (2 + c.snow.0, c.snow.1);
        let wind = c.wind.map_or((0, 0.0), |(n, f)| (GRAVITY + n, f));
        let mut sum = Sum { terms: [(0, 0.0); 4], count: 0, k_mod };
        for term in [(0, c.permanent), (1, c.imposed), snow, wind].into_iter().filter(|(_, f)| *f != 0.0) {
            sum.terms[sum.count] = term;
            sum.count += 1;
        }
        sum
    }

    /// Base actions and factors.
    pub fn terms(&self) -> &[(usize, f64)] {
        &self.terms[..self.count]
    }

    /// The sum of an element's base actions.
    #[inline]
    pub fn piece(&self, actions: &[Piece]) -> Piece {
        let mut sum = [0.0; 8];
        self.terms().iter().for_each(|&(n, f)| add(&mut sum, f, &actions[n]));
        sum
    }
}

#[cfg(test)]
mod tests {
    use super::super::cases::UNITS;
    use super::super::combine::winds;
    use super::super::{LoadTable, SurfaceWeights};
    use super::*;

    /// With one unit case at a time the sums are the factors of the winds.
    #[test]
    fn sums_follow_the_factors_of_the_winds() {
        let configs = std::path::Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/configs"));
        let loads = LoadTable::load(configs).expect("our loads").thesis(SurfaceWeights::default());
        let cases = CaseLoads::all_solved();
        let factors = winds(&loads);
        for one in 0..UNITS {
            let out = sums(&loads, &cases, |slot| [f64::from(u8::from(slot == one))]);
            for (n, wind) in factors.iter().enumerate() {
                assert_eq!(out[GRAVITY + n][0], wind[one], "wind {n}, case {one}");
            }
        }
    }
}
