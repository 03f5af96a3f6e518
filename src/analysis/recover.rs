//! End forces, equilibrium and reactions from displacements.

use super::element::LANES;
use super::layout::NONE;
use super::model::{LoadCase, Model};
use super::solution::Solution;
use super::solver::{RESIDUAL_LIMIT, Solver};

/// What equilibrium says of a solution.
pub(super) struct Balance {
    /// Largest unbalanced share at free dofs over all cases: forces by the largest end force and moments by the largest end
    /// moment of the case.
    pub residual: f64,
    /// The first case that loads a direction which was taken out because nothing resists it, and the direction's place in
    /// [`Solution::idle`]: members may push where no nodal load does (a rod without bending stiffness under a load across it).
    pub stray: Option<(usize, usize)>,
}

/// Fills the end forces and the balance of every node (nodal loads less end forces).
#[allow(
    clippy::needless_range_loop,
    reason = "a lane is the last index of every table here, and part of a case number"
)]
pub(super) fn forces(solver: &mut Solver, model: &Model, cases: &[LoadCase], solution: &mut Solution) -> Balance {
    let (nodes, members, columns) = (solution.nodes, solution.members, cases.len());
    solver.balance.clear();
    solver.balance.resize(nodes * columns, [0.0; 6]);
    for (case, loads) in cases.iter().enumerate() {
        for l in &loads.nodal {
            (0..6).for_each(|d| solver.balance[case * nodes + l.node][d] += l.force[d]);
        }
    }
    for (m, (member, beam)) in model.members.iter().zip(&solver.beams).enumerate() {
        let [i, j] = member.nodes;
        for first in (0..columns).step_by(LANES) {
            let lanes = LANES.min(columns - first);
            let mut u = [[0.0; LANES]; 12];
            for lane in 0..lanes {
                let moves = &solution.displacements[(first + lane) * nodes..(first + lane + 1) * nodes];
                let (a, b) = (&moves[i], &moves[j]);
                for d in 0..6 {
                    u[d][lane] = a[d];
                    u[6 + d][lane] = b[d];
                }
            }
            let mut f = beam.forces_of(&u);
            for lane in 0..lanes {
                let fixed = &solver.fixed_end[m * columns + first + lane];
                (0..12).for_each(|k| f[k][lane] += fixed[k]);
            }
            let g = beam.turned_out(&f);
            for lane in 0..lanes {
                let case = first + lane;
                solution.end_forces[case * members + m] = std::array::from_fn(|k| f[k][lane]);
                let balance = &mut solver.balance[case * nodes..(case + 1) * nodes];
                (0..6).for_each(|d| balance[i][d] -= g[d][lane]);
                (0..6).for_each(|d| balance[j][d] -= g[6 + d][lane]);
            }
        }
    }
    let length = super::mechanism::mean_length(solution.spans.iter().map(|s| s.length));
    let mut found = Balance { residual: 0.0, stray: None };
    for (case, loads) in cases.iter().enumerate() {
        let scale = scales(loads, solution, case, length);
        let balance = &solver.balance[case * nodes..(case + 1) * nodes];
        found.residual = nan_max(found.residual, unbalanced(solver, balance, scale));
        if found.stray.is_none() {
            found.stray = stray(balance, solution, scale).map(|idle| (case, idle));
        }
    }
    found
}

/// Largest of the two; not-a-number wins, so that it cannot hide.
fn nan_max(a: f64, b: f64) -> f64 {
    if a > b || a.is_nan() { a } else { b }
}

/// Largest force and largest moment of a case.
fn scales(loads: &LoadCase, solution: &Solution, case: usize, length: f64) -> [f64; 2] {
    let mut scale = [0.0f64; 2];
    for f in solution.end_forces(case) {
        (0..12).for_each(|k| scale[k / 3 % 2] = scale[k / 3 % 2].max(f[k].abs()));
    }
    for l in &loads.nodal {
        (0..6).for_each(|k| scale[k / 3] = scale[k / 3].max(l.force[k].abs()));
    }
    // A pinned frame has no moments to measure by, and a twisted bar no forces.
    [scale[0].max(scale[1] / length), scale[1].max(scale[0] * length)]
}

fn unbalanced(solver: &Solver, balance: &[[f64; 6]], scale: [f64; 2]) -> f64 {
    let mut worst = [0.0f64; 2];
    for (equations, row) in solver.layout.equation.iter().zip(balance) {
        for d in (0..6).filter(|&d| equations[d] != NONE) {
            worst[d / 3] = nan_max(worst[d / 3], row[d].abs());
        }
    }
    let share = |k: usize| if worst[k] == 0.0 { 0.0 } else { worst[k] / scale[k] };
    nan_max(share(0), share(1))
}

/// The first idle direction that feels a force.
fn stray(balance: &[[f64; 6]], solution: &Solution, scale: [f64; 2]) -> Option<usize> {
    solution.idle.iter().position(|idle| {
        let along = |range: std::ops::Range<usize>| -> f64 {
            range.map(|d| idle.direction[d] * balance[idle.node][d]).sum::<f64>().abs()
        };
        along(0..3) > RESIDUAL_LIMIT * scale[0] || along(3..6) > RESIDUAL_LIMIT * scale[1]
    })
}

/// Reactions: what the supports add for the balance of their nodes.
pub(super) fn reactions(solver: &Solver, model: &Model, solution: &mut Solution) {
    for case in 0..solution.cases {
        for (s, support) in model.supports.iter().enumerate() {
            let balance = &solver.balance[case * solution.nodes + support.node];
            let held = |d: usize| if support.fix[d] { 0.0 - balance[d] } else { 0.0 };
            solution.reactions[case * solution.supports + s] = std::array::from_fn(held);
        }
    }
}
