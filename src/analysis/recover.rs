//! End forces, equilibrium and reactions from displacements.

use super::element::{Beam, LANES, Side};
use super::fixed_end::FixedEnds;
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
pub(super) fn forces(solver: &mut Solver, model: &Model, cases: &[LoadCase], solution: &mut Solution) -> Balance {
    let (nodes, members, columns) = (solution.nodes, solution.members, cases.len());
    solver.balance.clear();
    solver.balance.resize(nodes * columns.div_ceil(LANES), [[0.0; LANES]; 6]);
    for (case, loads) in cases.iter().enumerate() {
        for l in &loads.nodal {
            let side = &mut solver.balance[case / LANES * nodes + l.node];
            (0..6).for_each(|d| side[d][case % LANES] += l.force[d]);
        }
    }
    solver.largest.clear();
    solver.largest.resize(columns.div_ceil(LANES), [[0.0; LANES]; 2]);
    let Solver { beams, fixed_end, moves, balance, largest, .. } = solver;
    // The same arithmetic on wider registers where the processor has them.
    pulp::Arch::new().dispatch(Recovery {
        model,
        beams,
        nodes,
        members,
        columns,
        moves,
        fixed_end,
        end_forces: &mut solution.end_forces,
        balance,
        largest,
    });
    let length = super::mechanism::mean_length(solution.spans.iter().map(|s| s.length));
    let mut found = Balance { residual: 0.0, stray: None };
    for (case, loads) in cases.iter().enumerate() {
        let scale = scales(loads, &solver.largest[case / LANES], case % LANES, length);
        let balance = &solver.balance[case / LANES * nodes..][..nodes];
        found.residual = nan_max(found.residual, unbalanced(solver, balance, case % LANES, scale));
        if found.stray.is_none() {
            found.stray = stray(balance, case % LANES, solution, scale).map(|idle| (case, idle));
        }
    }
    found
}

/// What recovery reads and fills, of all members.
struct Recovery<'a> {
    model: &'a Model,
    beams: &'a [Beam],
    nodes: usize,
    members: usize,
    columns: usize,
    moves: &'a [Side],
    fixed_end: &'a FixedEnds,
    end_forces: &'a mut [[f64; 12]],
    balance: &'a mut [Side],
    /// Largest force and moment at member ends, by block of cases.
    largest: &'a mut [[[f64; LANES]; 2]],
}

impl pulp::NullaryFnOnce for Recovery<'_> {
    type Output = ();

    #[inline(always)]
    fn call(mut self) {
        for (m, (member, beam)) in self.model.members.iter().zip(self.beams).enumerate() {
            self.member(m, member.nodes, beam);
        }
    }
}

impl Recovery<'_> {
    /// End forces of member `m` in all cases.
    #[inline(always)]
    #[allow(
        clippy::needless_range_loop,
        reason = "a lane is the last index of every table here, and part of a case number"
    )]
    fn member(&mut self, m: usize, [i, j]: [usize; 2], beam: &Beam) {
        for (block, largest) in self.largest.iter_mut().enumerate() {
            let first = block * LANES;
            let lanes = LANES.min(self.columns - first);
            let ends = [i, j].map(|node| block * self.nodes + node);
            let u = std::array::from_fn(|d| self.moves[ends[d / 6]][d % 6]);
            let (mut fixed, mut loaded) = ([[0.0; LANES]; 12], false);
            for lane in 0..lanes {
                if let Some(own) = self.fixed_end.get(m, first + lane) {
                    (0..12).for_each(|k| fixed[k][lane] = own[k]);
                    loaded = true;
                }
            }
            let mut f = beam.forces_of(&u);
            for k in 0..12 {
                let largest = &mut largest[k / 3 % 2];
                for lane in 0..LANES {
                    f[k][lane] += fixed[k][lane];
                    let size = f[k][lane].abs();
                    largest[lane] = if size > largest[lane] { size } else { largest[lane] };
                }
            }
            let g = if loaded { beam.turned_out(&f) } else { beam.turned_out_of(&f) };
            for lane in 0..lanes {
                self.end_forces[(first + lane) * self.members + m] = std::array::from_fn(|k| f[k][lane]);
            }
            for (end, side) in ends.into_iter().enumerate() {
                for d in 0..6 {
                    (0..LANES).for_each(|lane| self.balance[side][d][lane] -= g[6 * end + d][lane]);
                }
            }
        }
    }
}

/// Largest of the two; not-a-number wins, so that it cannot hide.
fn nan_max(a: f64, b: f64) -> f64 {
    if a > b || a.is_nan() { a } else { b }
}

/// Largest force and largest moment of a case, members' and nodal loads'.
fn scales(loads: &LoadCase, members: &[[f64; LANES]; 2], lane: usize, length: f64) -> [f64; 2] {
    let mut scale = members.map(|of| of[lane]);
    for l in &loads.nodal {
        (0..6).for_each(|k| scale[k / 3] = scale[k / 3].max(l.force[k].abs()));
    }
    // A pinned frame has no moments to measure by, and a twisted bar no forces.
    [scale[0].max(scale[1] / length), scale[1].max(scale[0] * length)]
}

fn unbalanced(solver: &Solver, balance: &[Side], lane: usize, scale: [f64; 2]) -> f64 {
    let mut worst = [0.0f64; 2];
    for (equations, row) in solver.layout.equation.iter().zip(balance) {
        for d in (0..6).filter(|&d| equations[d] != NONE) {
            worst[d / 3] = nan_max(worst[d / 3], row[d][lane].abs());
        }
    }
    let share = |k: usize| if worst[k] == 0.0 { 0.0 } else { worst[k] / scale[k] };
    nan_max(share(0), share(1))
}

/// The first idle direction that feels a force.
fn stray(balance: &[Side], lane: usize, solution: &Solution, scale: [f64; 2]) -> Option<usize> {
    solution.idle.iter().position(|idle| {
        let along = |range: std::ops::Range<usize>| -> f64 {
            range.map(|d| idle.direction[d] * balance[idle.node][d][lane]).sum::<f64>().abs()
        };
        along(0..3) > RESIDUAL_LIMIT * scale[0] || along(3..6) > RESIDUAL_LIMIT * scale[1]
    })
}

/// Reactions: what the supports add for the balance of their nodes.
pub(super) fn reactions(solver: &Solver, model: &Model, solution: &mut Solution) {
    for case in 0..solution.cases {
        for (s, support) in model.supports.iter().enumerate() {
            let balance = &solver.balance[case / LANES * solution.nodes + support.node];
            let held = |d: usize| if support.fix[d] { 0.0 - balance[d][case % LANES] } else { 0.0 };
            solution.reactions[case * solution.supports + s] = std::array::from_fn(held);
        }
    }
}
