//! Right-hand sides in, displacements out, and the unbalanced rest as the next right-hand side.

use super::element::LANES;
use super::layout::NONE;
use super::model::{LoadCase, Model};
use super::solution::Solution;
use super::solver::Solver;

impl Solver {
    /// Adds the solved unknowns to the displacements.
    pub(super) fn add_correction(&mut self, columns: usize, solution: &mut Solution) {
        let (n, nodes) = (self.layout.n, self.layout.equation.len());
        self.moves.clear();
        self.moves.resize(columns.div_ceil(LANES) * nodes, [[0.0; LANES]; 6]);
        for case in 0..columns {
            let u = &self.correction[case * n..(case + 1) * n];
            let out = &mut solution.displacements[case * nodes..(case + 1) * nodes];
            let sides = &mut self.moves[case / LANES * nodes..];
            for ((equations, row), side) in self.layout.equation.iter().zip(out).zip(sides) {
                for d in 0..6 {
                    if equations[d] != NONE {
                        row[d] += u[equations[d] as usize];
                    }
                    side[d][case % LANES] = row[d];
                }
            }
        }
    }

    /// What is out of balance at the free dofs becomes the right-hand side.
    pub(super) fn gather_residual(&mut self, columns: usize) {
        let (n, nodes) = (self.layout.n, self.layout.equation.len());
        for case in 0..columns {
            for (node, equations) in self.layout.equation.iter().enumerate() {
                for d in (0..6).filter(|&d| equations[d] != NONE) {
                    self.correction[case * n + equations[d] as usize] =
                        self.balance[case / LANES * nodes + node][d][case % LANES];
                }
            }
        }
    }

    /// Prescribed displacements as the start of the displacement field; marks nodes that any case moves.
    pub(super) fn start_displacements(&mut self, cases: &[LoadCase], solution: &mut Solution) {
        self.settled.clear();
        self.settled.resize(solution.nodes, false);
        for (case, loads) in cases.iter().enumerate() {
            for s in &loads.settlements {
                solution.displacements[case * solution.nodes + s.node][s.dof] += s.value;
                self.settled[s.node] = true;
            }
        }
    }

    /// Nodal loads less what the members of the held frame (settled where prescribed) push on their free ends.
    pub(super) fn right_hand_sides(&mut self, model: &Model, cases: &[LoadCase], solution: &Solution) {
        let n = self.layout.n;
        self.rhs.clear();
        self.rhs.resize(n * cases.len(), 0.0);
        let equation = &self.layout.equation;
        let mut push = |case: usize, node: usize, f: &[f64]| {
            for d in (0..6).filter(|&d| equation[node][d] != NONE) {
                self.rhs[case * n + equation[node][d] as usize] += f[d];
            }
        };
        for (case, loads) in cases.iter().enumerate() {
            loads.nodal.iter().for_each(|l| push(case, l.node, &l.force));
        }
        for (m, (member, beam)) in model.members.iter().zip(&self.beams).enumerate() {
            let [i, j] = member.nodes;
            let moved = self.settled[i] || self.settled[j];
            for case in 0..cases.len() {
                let fixed = self.fixed_end.get(m, case);
                if !moved && fixed.is_none_or(|f| *f == [0.0; 12]) {
                    continue;
                }
                let mut f = fixed.copied().unwrap_or_default();
                if moved {
                    let u = solution.displacements(case);
                    let extra = beam.forces(&u[i], &u[j]);
                    (0..12).for_each(|k| f[k] += extra[k]);
                }
                let f = beam.to_global(&f).map(|v| -v);
                push(case, i, &f[..6]);
                push(case, j, &f[6..]);
            }
        }
    }
}
