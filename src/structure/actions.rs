//! Unit cases summed up to base actions: what members, sheathing and nodes feel from permanent load, imposed load, snow in its
//! arrangements and each wind.

use super::cases::{Case, CaseLoads, UNITS};
use super::check::Piece;
use super::combine::{Combination, GRAVITY, PRESSED, SNOWS, WINDS, WINDS_A_SIDE, overall, snows, winds};
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
        let winds = winds(loads);
        // Only cases that were solved, with their slots.
        let solved =
            |first: usize, end: usize| (first..end).filter_map(|c| Some((c, cases.slot(c)?))).collect::<Vec<_>>();
        let blowing = solved(Case::Internal as usize, UNITS);
        (self.overall, self.snows) = (overall(frame, loads, cases), snows(cases));
        self.pieces.clear();
        for e in 0..frame.elements.len() {
            let unit: [Piece; UNITS] = std::array::from_fn(|c| unit_piece(solution, cases, e, c));
            self.pieces.extend_from_slice(&unit[..3]);
            for arrangement in 1..SNOWS {
                let mut sum = unit[Case::Snow as usize];
                add(&mut sum, 1.0, &unit[Case::Snow as usize + arrangement]);
                self.pieces.push(sum);
            }
            for f in &winds {
                let mut sum = [0.0; 8];
                blowing.iter().filter(|(c, _)| f[*c] != 0.0).for_each(|(c, _)| add(&mut sum, f[*c], &unit[*c]));
                self.pieces.push(sum);
            }
        }
        self.panels.clear();
        for p in 0..frame.panels.len() {
            let axial = |slot: usize| solution.end_forces(slot)[frame.elements.len() + p][0];
            let of = |case: usize| cases.slot(case).map_or(0.0, axial);
            self.panels.push(std::array::from_fn(|b| match (b, b.checked_sub(GRAVITY)) {
                (_, Some(w)) => blowing.iter().map(|(c, slot)| winds[w][*c] * axial(*slot)).sum(),
                (0..3, None) => of(b),
                (_, None) => of(2) + of(b),
            }));
        }
        self.moves.clear();
        for n in 0..frame.nodes.len() {
            let at = |slot: usize| {
                let u = solution.displacements(slot)[n];
                [u[0], u[1], u[2]]
            };
            let of = |case: usize| cases.slot(case).map_or([0.0; 3], at);
            self.moves.push(std::array::from_fn(|b| match (b, b.checked_sub(GRAVITY)) {
                (_, Some(side)) => {
                    let wind = &winds[WINDS_A_SIDE * side + PRESSED];
                    let mut sum = [0.0; 3];
                    for (c, slot) in blowing.iter().filter(|(c, _)| wind[*c] != 0.0) {
                        let u = at(*slot);
                        (0..3).for_each(|a| sum[a] += wind[*c] * u[a]);
                    }
                    sum
                }
                (0..3, None) => of(b),
                (_, None) => {
                    let (even, more) = (of(2), of(b));
                    [0, 1, 2].map(|a| even[a] + more[a])
                }
            }));
        }
    }

    /// All base actions of an element.
    pub fn pieces(&self, element: usize) -> &[Piece] {
        &self.pieces[element * ACTIONS..(element + 1) * ACTIONS]
    }

    /// An element's part in base `b` of the nodes.
    pub fn piece(&self, element: usize, b: usize) -> &Piece {
        let action = b.checked_sub(GRAVITY).map_or(b, |side| GRAVITY + WINDS_A_SIDE * side + PRESSED);
        &self.pieces(element)[action]
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

/// Factors of a combination on the base actions, those that are not zero.
pub(super) fn terms(c: &Combination) -> impl Iterator<Item = (usize, f64)> {
    let snow = (2 + c.snow.0, c.snow.1);
    let wind = c.wind.map(|(n, f)| (GRAVITY + n, f));
    [(0, c.permanent), (1, c.imposed), snow].into_iter().chain(wind).filter(|(_, f)| *f != 0.0)
}

/// A combination of the base actions of an element.
pub(super) fn combined(actions: &[Piece], c: &Combination) -> Piece {
    let mut sum = [0.0; 8];
    terms(c).for_each(|(n, f)| add(&mut sum, f, &actions[n]));
    sum
}
