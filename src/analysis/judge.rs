//! Factor, solve, refine, and decide whether the numbers may be called a result.

use super::diagnose::{self, Weakness};
use super::layout::NONE;
use super::mechanism::{self, Cause, Mechanism};
use super::model::{LoadCase, Model};
use super::phases::Clock;
use super::recover;
use super::solution::{Idle, Solution, Status};
use super::solver::{MECHANISM_LIMIT, RESIDUAL_LIMIT, SINGULAR_LIMIT, Solver};

/// Pivots above this need no closer look as long as the first residual and the growth of the probe are small: elimination can
/// hide the last pivot of a singular frame in rounding, when the motion hardly moves the dof that comes last.
const SUSPICIOUS_PIVOT: f64 = 1e-8;
const LOOK_CLOSER: f64 = 1e-9;

/// A random load on the frame scaled to unit diagonal answered by more than this is looked at closer: a mechanism that no
/// load case sets off leaves neither a small pivot nor an unbalance, but it cannot hide from a load without symmetry. House
/// frames answer with 1e5, mechanisms with 1e13 and more.
const SUSPICIOUS_GROWTH: f64 = 1e9;

/// Residual from which a step of iterative refinement is made, and how often.
const REFINE_FROM: f64 = 1e-11;
const REFINEMENTS: usize = 2;

/// A suspicious frame whose displacements still change by more than this share in a further step of refinement has lost too
/// many digits. Random frames: 10,000 compared with an answer of 32 digits were right to 1e-5 (tests/analysis_random.rs).
const DRIFT_LIMIT: f64 = 1e-6;

/// What solving left.
struct Found {
    /// Residual before any refinement.
    first: f64,
    /// Residual at the end.
    residual: f64,
    /// Answer to the probe over the probe.
    growth: f64,
}

impl Solver {
    /// Factor, solve, refine, judge.
    pub(super) fn run(&mut self, model: &Model, cases: &[LoadCase], solution: &mut Solution) -> Status {
        let mut clock = Clock::start();
        if !self.factor.analyse(&self.layout) {
            return Status::Unstable(Mechanism { cause: Cause::Sway, motions: Vec::new() });
        }
        self.phases.symbolic = clock.lap();
        match self.attempts(model, cases, solution, &mut clock) {
            Ok(status) => status,
            Err(mechanism) => Status::Unstable(mechanism),
        }
    }

    /// As many attempts as there are spins to ground that only the solution brings to light.
    fn attempts(
        &mut self,
        model: &Model,
        cases: &[LoadCase],
        solution: &mut Solution,
        clock: &mut Clock,
    ) -> Result<Status, Mechanism> {
        for _ in 0..=model.nodes.len() {
            let mut weakness = self.factor_or_explain(model, cases.len(), solution)?;
            self.phases.numeric = clock.lap();
            let mut found = self.solve_refined(model, cases, solution)?;
            let suspicious = found.first > LOOK_CLOSER || found.growth > SUSPICIOUS_GROWTH;
            if suspicious && weakness.moves.is_none() {
                (weakness.least, weakness.moves) = self.weakest(model);
                if weakness.least < MECHANISM_LIMIT {
                    solution.clear_numbers();
                    self.start_displacements(cases, solution);
                    self.right_hand_sides(model, cases, solution);
                    self.ground_spin(model, cases.len(), &weakness.moves.unwrap_or_default(), solution)?;
                    continue;
                }
            }
            let drift = if weakness.moves.is_some() { self.drift(model, cases, solution, &mut found) } else { 0.0 };
            recover::reactions(self, model, solution);
            self.phases.solution = clock.lap();
            let certain = found.residual <= RESIDUAL_LIMIT && drift <= DRIFT_LIMIT;
            if certain && weakness.least >= SINGULAR_LIMIT {
                return Ok(Status::Solved { residual: found.residual, least_pivot: weakness.pivot });
            }
            let length = mechanism::mean_length(solution.spans.iter().map(|s| s.length));
            return Ok(Status::NearlySingular {
                condition: 1.0 / weakness.least.max(f64::MIN_POSITIVE),
                residual: found.residual,
                weakest: mechanism::name(model, &weakness.moves.unwrap_or_default(), length),
            });
        }
        Err(Mechanism { cause: Cause::Sway, motions: Vec::new() })
    }

    fn weakest(&mut self, model: &Model) -> (f64, Option<Vec<[f64; 6]>>) {
        let (least, v) = diagnose::weakest(&mut self.factor, &self.layout, &self.values);
        let moves = v.map(|v| diagnose::spread(&self.layout, &v, model.nodes.len()));
        // The factor now holds the shifted matrix; put the real one back where it exists.
        let _ = self.factor.factorise(&self.layout, &self.values);
        (least, moves)
    }

    /// A usable factor, or the mechanism that prevents one. Members that spin about their own axis between hinges are grounded
    /// as long as no case turns them, and listed as idle.
    fn factor_or_explain(
        &mut self,
        model: &Model,
        cases: usize,
        solution: &mut Solution,
    ) -> Result<Weakness, Mechanism> {
        for _ in 0..=model.nodes.len() {
            let positive = self.factor.factorise(&self.layout, &self.values).is_ok();
            let pivot = if positive { self.factor.least_pivot(&self.layout, &self.values) } else { 0.0 };
            if pivot > SUSPICIOUS_PIVOT {
                return Ok(Weakness { pivot, least: pivot, moves: None });
            }
            let (least, v) = diagnose::weakest(&mut self.factor, &self.layout, &self.values);
            let Some(v) = v else {
                return Err(Mechanism { cause: Cause::Sway, motions: Vec::new() });
            };
            let moves = diagnose::spread(&self.layout, &v, model.nodes.len());
            if positive && least > MECHANISM_LIMIT {
                let _ = self.factor.factorise(&self.layout, &self.values);
                return Ok(Weakness { pivot, least, moves: Some(moves) });
            }
            self.ground_spin(model, cases, &moves, solution)?;
        }
        Err(Mechanism { cause: Cause::Sway, motions: Vec::new() })
    }

    /// Holds a spin that no load turns, or names the mechanism that `moves` is.
    fn ground_spin(
        &mut self,
        model: &Model,
        cases: usize,
        moves: &[[f64; 6]],
        solution: &mut Solution,
    ) -> Result<(), Mechanism> {
        let loads = &self.rhs[..cases * self.layout.n];
        let Some(idle) = diagnose::harmless_spin(&self.layout, &self.values, moves, loads) else {
            let length = mechanism::mean_length(solution.spans.iter().map(|s| s.length));
            return Err(mechanism::name(model, moves, length));
        };
        let at = self.layout.diagonal(idle.equation as usize);
        self.values[at] += diagnose::typical_rotation(&self.layout, &self.values).max(self.values[at]);
        solution.idle.push(idle.idle);
        Ok(())
    }

    /// Solves with as many steps of refinement as the residual asks for, or names the mechanism that a load sets off.
    fn solve_refined(
        &mut self,
        model: &Model,
        cases: &[LoadCase],
        solution: &mut Solution,
    ) -> Result<Found, Mechanism> {
        let columns = cases.len();
        std::mem::swap(&mut self.rhs, &mut self.correction);
        // One more column than there are cases costs less than a pass of its own.
        let size = self.append_probe();
        self.factor.solve(&mut self.correction, columns + 1);
        let mut found = Found { first: 0.0, residual: f64::INFINITY, growth: self.take_probe(columns) / size };
        for step in 0..=REFINEMENTS {
            self.add_correction(columns, solution);
            found.residual = self.balance(model, cases, solution)?;
            if step == 0 {
                found.first = found.residual;
            }
            if found.residual <= REFINE_FROM || step == REFINEMENTS {
                break;
            }
            self.gather_residual(columns);
            self.factor.solve(&mut self.correction, columns);
        }
        Ok(found)
    }

    fn balance(&mut self, model: &Model, cases: &[LoadCase], solution: &mut Solution) -> Result<f64, Mechanism> {
        let balance = recover::forces(self, model, cases, solution);
        if let Some((case, idle)) = balance.stray {
            let Idle { node, direction } = solution.idle[idle];
            return Err(mechanism::single(Cause::LoadOnIdle { case }, node, direction));
        }
        Ok(if balance.residual.is_nan() { f64::INFINITY } else { balance.residual })
    }

    /// Appends a load without symmetry, in the scale of unit diagonal; its size.
    fn append_probe(&mut self) -> f64 {
        let mut square = 0.0;
        for k in 0..self.layout.n {
            let r = ((k as f64 + 1.0) * 0.618_033_988_749_894_9).fract() - 0.5;
            square += r * r;
            self.correction.push(r * self.values[self.layout.diagonal(k)].sqrt());
        }
        square.sqrt()
    }

    /// Takes the answer to the probe off again; its size.
    fn take_probe(&mut self, columns: usize) -> f64 {
        let n = self.layout.n;
        let answer = &self.correction[columns * n..];
        let square: f64 = (0..n).map(|k| answer[k] * answer[k] * self.values[self.layout.diagonal(k)]).sum();
        self.correction.truncate(columns * n);
        // Not a number is as bad as too large.
        if square.is_finite() { square.sqrt() } else { f64::INFINITY }
    }

    /// One more step of refinement: the largest share by which it changes the displacements of a case, translations and
    /// rotations each by their own size.
    fn drift(&mut self, model: &Model, cases: &[LoadCase], solution: &mut Solution, found: &mut Found) -> f64 {
        self.gather_residual(cases.len());
        self.factor.solve(&mut self.correction, cases.len());
        self.add_correction(cases.len(), solution);
        match self.balance(model, cases, solution) {
            Ok(residual) => found.residual = residual,
            Err(_) => return f64::INFINITY,
        }
        let length = mechanism::mean_length(solution.spans.iter().map(|s| s.length));
        let mut worst = 0.0f64;
        for case in 0..cases.len() {
            let (mut size, mut change) = ([0.0f64; 2], [0.0f64; 2]);
            let correction = &self.correction[case * self.layout.n..];
            for (equations, row) in self.layout.equation.iter().zip(solution.displacements(case)) {
                for (d, (value, &equation)) in row.iter().zip(equations).enumerate() {
                    size[d / 3] = size[d / 3].max(value.abs());
                    if equation != NONE {
                        change[d / 3] = change[d / 3].max(correction[equation as usize].abs());
                    }
                }
            }
            // Trusses turn by rounding only.
            let floor = [1e-3 * length * size[1], 1e-3 * size[0] / length];
            for k in (0..2).filter(|&k| change[k] > 0.0) {
                worst = worst.max(change[k] / size[k].max(floor[k]));
            }
        }
        if worst.is_nan() { f64::INFINITY } else { worst }
    }
}
