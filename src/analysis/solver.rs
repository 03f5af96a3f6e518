//! From a frame and its cases to displacements, reactions and end forces.

use super::element::{Beam, LANES, Side};
use super::error::{self, InputError};
use super::factor::Factor;
use super::fixed_end::FixedEnds;
use super::idle::{Ground, IdleFinder};
use super::layout::Layout;
use super::mechanism::{self, Cause, Mechanism};
use super::model::{LoadCase, Model};
use super::phases::{Clock, Phases, Size};
use super::solution::{Solution, Span, Status};
use super::{axes, loads};

/// Largest unbalanced share a solved frame may have. House frames leave 1e-13, a chain of a hundred members 1e-11.
pub const RESIDUAL_LIMIT: f64 = 1e-8;

/// A frame whose stiffness, scaled to unit diagonal, has an eigenvalue below this is a mechanism. Pinned by a pinned square
/// (rounding leaves 1e-16) and by the same square with a brace 3e-13 as thick as its members (5e-14).
pub const MECHANISM_LIMIT: f64 = 1e-14;

/// Below this eigenvalue eleven or more of sixteen digits may be lost and the frame is called nearly singular. Pinned by the
/// square with the thread of a brace (5e-14, refused) and by a cantilever of a hundred members (solved to 1e-7).
pub const SINGULAR_LIMIT: f64 = 1e-12;

/// A linear static solver with buffers that outlive the frame: keep one per thread and feed it house after house.
///
/// The result does not depend on what was solved before nor on the number of threads.
#[derive(Default)]
pub struct Solver {
    pub(super) layout: Layout,
    pub(super) factor: Factor,
    finder: IdleFinder,
    pub(super) beams: Vec<Beam>,
    fixed: Vec<[bool; 6]>,
    active: Vec<[bool; 6]>,
    grounds: Vec<Ground>,
    pub(super) values: Vec<f64>,
    pub(super) rhs: Vec<f64>,
    pub(super) correction: Vec<f64>,
    /// Displacements and what is out of balance by block of cases, then node; see [`Side`].
    pub(super) moves: Vec<Side>,
    pub(super) balance: Vec<Side>,
    pub(super) fixed_end: FixedEnds,
    pub(super) largest: Vec<[[f64; LANES]; 2]>,
    pub(super) settled: Vec<bool>,
    pub(super) phases: Phases,
}

/// Solves `model` under `cases` once; see [`Solver::solve`].
pub fn solve(model: &Model, cases: &[LoadCase]) -> Result<Solution, InputError> {
    Solver::default().solve(model, cases)
}

impl Solver {
    /// An empty solver.
    pub fn new() -> Self {
        Self::default()
    }

    /// Solves `model` under `cases` on one factorisation.
    ///
    /// Errors only for input that describes no frame; a mechanism is [`Status::Unstable`] with the nodes that move.
    ///
    /// ```
    /// use houscaper::analysis::*;
    /// let model = Model {
    ///     nodes: vec![[0.0; 3], [2.0, 0.0, 0.0]],
    ///     materials: vec![Material { e: 210e9, g: 81e9, rho: 7850.0 }],
    ///     sections: vec![Section { a: 1e-3, iy: 1e-6, iz: 1e-6, j: 2e-6, asy: None, asz: None }],
    ///     members: vec![Member { nodes: [0, 1], material: 0, section: 0, reference: None, roll: 0.0, releases: [[false; 6]; 2] }],
    ///     supports: vec![Support { node: 0, fix: [true; 6] }],
    ///     shear: false,
    /// };
    /// let tip = LoadCase { nodal: vec![NodalLoad { node: 1, force: [0.0, 0.0, -1e3, 0.0, 0.0, 0.0] }], ..Default::default() };
    /// let solution = Solver::new().solve(&model, &[tip]).unwrap();
    /// let expected = -1e3 * 8.0 / (3.0 * 210e9 * 1e-6); // P L^3 / (3 E I)
    /// assert!(solution.status.is_solved());
    /// assert!((solution.displacements(0)[1][2] - expected).abs() < 1e-9 * expected.abs());
    /// ```
    pub fn solve(&mut self, model: &Model, cases: &[LoadCase]) -> Result<Solution, InputError> {
        let mut solution = Solution::default();
        self.solve_into(model, cases, &mut solution)?;
        Ok(solution)
    }

    /// As [`Solver::solve`], into the buffers of `solution`.
    pub fn solve_into(&mut self, model: &Model, cases: &[LoadCase], solution: &mut Solution) -> Result<(), InputError> {
        solution.status = Status::Empty;
        error::check_model(model)?;
        error::supported(model, &mut self.fixed)?;
        for (at, case) in cases.iter().enumerate() {
            error::check_case(model, at, case, &self.fixed)?;
        }
        solution.reset(model, cases.len());
        let mut clock = Clock::start();
        self.prepare_members(model, solution)?;
        self.phases.members = clock.lap();
        self.number(model, solution)?;
        self.phases.ordering = clock.lap();
        let stray = self.load(model, cases, solution)?;
        self.phases.loads = clock.lap();
        self.assemble(model);
        self.phases.assembly = clock.lap();
        solution.status = match stray.or_else(|| self.load_on_idle(cases, solution)) {
            Some(mechanism) => Status::Unstable(mechanism),
            None => self.run(model, cases, solution),
        };
        if matches!(solution.status, Status::Unstable(_)) {
            solution.clear_numbers();
            self.factor.discard();
        }
        Ok(())
    }

    /// Where the time of the last solve went.
    pub fn phases(&self) -> Phases {
        self.phases
    }

    /// Size of the system of the last solve.
    pub fn size(&self) -> Size {
        Size {
            unknowns: self.layout.n,
            stiffness_entries: self.values.len(),
            factor_entries: self.factor.len(),
            bytes: self.layout.bytes()
                + self.factor.bytes()
                + 8 * (self.values.len() + self.rhs.len() + self.correction.len()),
        }
    }

    fn prepare_members(&mut self, model: &Model, solution: &mut Solution) -> Result<(), InputError> {
        self.beams.clear();
        for (m, member) in model.members.iter().enumerate() {
            let [i, j] = member.nodes;
            let (material, section) = (&model.materials[member.material], &model.sections[member.section]);
            let (axes, length) =
                axes::local_axes(member, model.nodes[i], model.nodes[j]).ok_or(InputError::Axes { member: m, i, j })?;
            let flexibility = |area: Option<f64>| match area {
                Some(a) if model.shear => 1.0 / (material.g * a),
                _ => 0.0,
            };
            solution.spans.push(Span {
                axes,
                length,
                bending: [material.e * section.iy, material.e * section.iz],
                shear: [flexibility(section.asy), flexibility(section.asz)],
            });
            self.beams.push(Beam::new(member, material, section, model.shear, axes, length));
        }
        Ok(())
    }

    fn number(&mut self, model: &Model, solution: &mut Solution) -> Result<(), InputError> {
        self.active.clear();
        self.active.extend(self.fixed.iter().map(|f| f.map(|held| !held)));
        self.grounds.clear();
        self.finder.find(model, &self.beams, &mut self.active, &mut solution.idle, &mut self.grounds);
        self.layout.build(model, &self.active)
    }

    fn load(
        &mut self,
        model: &Model,
        cases: &[LoadCase],
        solution: &mut Solution,
    ) -> Result<Option<Mechanism>, InputError> {
        let stray = loads::member_loads(model, cases, &self.beams, solution, &mut self.fixed_end)?;
        self.start_displacements(cases, solution);
        self.right_hand_sides(model, cases, solution);
        Ok(stray.map(|(case, member)| {
            let x = solution.spans[member].axes[0];
            let cause = Cause::LoadOnReleasedMember { case, member };
            mechanism::single(cause, model.members[member].nodes[0], [x[0], x[1], x[2], 0.0, 0.0, 0.0])
        }))
    }

    fn assemble(&mut self, model: &Model) {
        self.values.clear();
        self.values.resize(self.layout.row_idx.len(), 0.0);
        for (member, beam) in model.members.iter().zip(&self.beams) {
            let [i, j] = member.nodes;
            self.layout.add_diagonal(i, &beam.block(0, 0), &mut self.values);
            self.layout.add_diagonal(j, &beam.block(1, 1), &mut self.values);
            self.layout.add_coupling(i, j, &beam.block(0, 1), &mut self.values);
        }
        for g in &self.grounds {
            let mut block = [[0.0; 6]; 6];
            for k in 0..9 {
                block[3 + k / 3][3 + k % 3] = g.stiffness * g.axis[k / 3] * g.axis[k % 3];
            }
            self.layout.add_diagonal(g.node, &block, &mut self.values);
        }
    }

    fn load_on_idle(&self, cases: &[LoadCase], solution: &Solution) -> Option<Mechanism> {
        for (case, loads) in cases.iter().enumerate() {
            for load in &loads.nodal {
                let size = load.force.iter().fold(0.0f64, |m, v| m.max(v.abs()));
                let begin = solution.idle.partition_point(|i| i.node < load.node);
                for idle in solution.idle[begin..].iter().take_while(|i| i.node == load.node) {
                    let work: f64 = (0..6).map(|d| idle.direction[d] * load.force[d]).sum();
                    if work.abs() > 1e-12 * size {
                        return Some(mechanism::single(Cause::LoadOnIdle { case }, idle.node, idle.direction));
                    }
                }
            }
        }
        None
    }
}
