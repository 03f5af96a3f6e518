//! Unit cases summed up to base actions: what members and nodes feel from permanent load, imposed load, snow and each wind.

use super::check::Piece;
use super::combine::{Combination, GRAVITY, MEMBER_WINDS, winds};
use super::loads::LoadSettings;
use super::model::{Case, UNITS};
use crate::analysis::Solution;
use crate::frame::HouseFrame;

/// Base actions on members: permanent, imposed, snow, twelve winds.
const ACTIONS: usize = GRAVITY + MEMBER_WINDS.len();

/// Base actions on nodes: permanent, imposed, snow and a wind from each side (internal suction, windward slope pressed).
pub(super) const BASES: usize = GRAVITY + 4;

/// Buffers of the base actions.
#[derive(Default)]
pub(super) struct BaseActions {
    pieces: Vec<Piece>,
    moves: Vec<[[f64; 3]; BASES]>,
}

/// Forces and loads of an element in a unit case.
pub(super) fn unit_piece(solution: &Solution, element: usize, case: usize) -> Piece {
    let f = &solution.end_forces(case)[element];
    let q = solution.uniform_loads(case)[element];
    [f[0], f[1], f[2], f[4], f[5], q[0], q[1], q[2]]
}

pub(super) fn add(into: &mut Piece, f: f64, p: &Piece) {
    (0..8).for_each(|n| into[n] += f * p[n]);
}

impl BaseActions {
    /// Sums up the unit cases of a solved frame.
    pub fn fill(&mut self, frame: &HouseFrame, loads: &LoadSettings, solution: &Solution) {
        let all = winds(frame, loads, false);
        let of_members = MEMBER_WINDS.map(|n| all[n]);
        self.pieces.clear();
        for e in 0..frame.elements.len() {
            let unit: [Piece; UNITS] = std::array::from_fn(|c| unit_piece(solution, e, c));
            self.pieces.extend_from_slice(&unit[..GRAVITY]);
            for f in &of_members {
                let mut sum = [0.0; 8];
                (GRAVITY..UNITS).for_each(|c| add(&mut sum, f[c], &unit[c]));
                self.pieces.push(sum);
            }
        }
        let of_nodes: [&[f64; UNITS]; 4] = std::array::from_fn(|side| &of_members[3 * side + 1]);
        self.moves.clear();
        for n in 0..frame.nodes.len() {
            self.moves.push(std::array::from_fn(|b| match b.checked_sub(GRAVITY) {
                None => translation(solution, b, n),
                Some(side) => wind_translation(solution, of_nodes[side], n),
            }));
        }
    }

    /// All base actions of an element.
    pub fn pieces(&self, element: usize) -> &[Piece] {
        &self.pieces[element * ACTIONS..(element + 1) * ACTIONS]
    }

    /// An element's part in base `b` of the nodes.
    pub fn piece(&self, element: usize, b: usize) -> &Piece {
        let action = b.checked_sub(GRAVITY).map_or(b, |side| GRAVITY + 3 * side + 1);
        &self.pieces(element)[action]
    }

    /// Translations of a node, by base.
    pub fn node(&self, node: usize) -> &[[f64; 3]; BASES] {
        &self.moves[node]
    }
}

fn translation(solution: &Solution, case: usize, node: usize) -> [f64; 3] {
    let u = solution.displacements(case)[node];
    [u[0], u[1], u[2]]
}

/// Translation of a node under a wind given by its factors on the unit cases.
pub(super) fn wind_translation(solution: &Solution, factors: &[f64; UNITS], node: usize) -> [f64; 3] {
    let mut sum = [0.0; 3];
    for (c, f) in factors.iter().enumerate().skip(Case::Walls as usize) {
        let u = &solution.displacements(c)[node];
        (0..3).for_each(|a| sum[a] += f * u[a]);
    }
    sum
}

/// A combination of the base actions of an element.
pub(super) fn combined(actions: &[Piece], c: &Combination) -> Piece {
    let mut sum = [0.0; 8];
    add(&mut sum, c.permanent, &actions[0]);
    for (f, n) in [(c.imposed, 1), (c.snow, 2)].into_iter().chain(c.wind.map(|(n, f)| (f, GRAVITY + n))) {
        if f != 0.0 {
            add(&mut sum, f, &actions[n]);
        }
    }
    sum
}
