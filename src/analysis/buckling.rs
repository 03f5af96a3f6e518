//! The load factor at which a frame first buckles: eigenvalues of the elastic against the geometric stiffness.
//!
//! `(K + factor * G) mode = 0`, `G` from the axial forces of a linear solution. Members are cut into pieces, because a member
//! that is one element cannot bow between its ends. Flexural buckling of members, sway and everything between; not lateral
//! torsional nor torsional buckling (no Wagner or moment terms), no yielding, no imperfections, and the axial forces are those of
//! the undeformed frame.

use super::element::{Beam, Part};
use super::error::InputError;
use super::lanczos;
use super::line::Line;
use super::model::{LoadCase, Model};
use super::solution::Solution;
use super::solver::Solver;

/// The first buckling load of a frame.
#[derive(Clone, Debug, PartialEq)]
pub struct Buckling {
    /// Loads times this buckle the frame.
    pub factor: f64,
    /// How every node moves: ux uy uz rx ry rz, global; the largest translation, inside members too, is 1.
    pub nodes: Vec<[f64; 6]>,
    /// Where the largest translation is: the member and the distance from its end i.
    pub member: usize,
    /// See [`Buckling::member`].
    pub x: f64,
    /// Direction of the largest translation, global.
    pub direction: [f64; 3],
    /// Steps of the Lanczos iteration.
    pub steps: usize,
}

/// What was found of the first buckling load.
#[derive(Clone, Debug, PartialEq)]
pub enum BucklingAnswer {
    /// The frame buckles.
    Buckles(Buckling),
    /// No positive factor of the loads buckles it: nothing is compressed.
    Never,
    /// Nothing was computed: the frame is a mechanism or nearly one, or the iteration did not settle.
    Unknown,
}

/// Pieces that [`buckling_factor`] needs of every member for the four Euler columns to be right to 1 %.
pub const BUCKLING_PIECES: usize = 4;

/// Least factor by which the loads `factors[case] * case`, added up, buckle `model`. Every member is cut into `pieces`
/// ([`BUCKLING_PIECES`]; 1 leaves it straight between its ends, right where bracing members stand for panels). Errors as
/// [`Solver::solve`].
///
/// ```
/// use houscaper::analysis::*;
/// // A pinned column of 4 m under 1 kN: pi^2 E I / L^2.
/// let column = Model {
///     nodes: vec![[0.0; 3], [0.0, 0.0, 4.0]],
///     materials: vec![Material { e: 210e9, g: 81e9, rho: 0.0 }],
///     sections: vec![Section { a: 1e-2, iy: 1e-6, iz: 2e-6, j: 1e-6, asy: None, asz: None }],
///     members: vec![Member { nodes: [0, 1], material: 0, section: 0, reference: None, roll: 0.0, releases: [[false; 6]; 2] }],
///     supports: vec![
///         Support { node: 0, fix: [true, true, true, false, false, true] },
///         Support { node: 1, fix: [true, true, false, false, false, false] },
///     ],
///     shear: false,
/// };
/// let load = LoadCase { nodal: vec![NodalLoad { node: 1, force: [0.0, 0.0, -1e3, 0.0, 0.0, 0.0] }], ..Default::default() };
/// let BucklingAnswer::Buckles(found) = buckling_factor(&column, &[load], &[1.0], BUCKLING_PIECES).unwrap() else { panic!() };
/// let euler = std::f64::consts::PI.powi(2) * 210e9 * 1e-6 / 16.0 / 1e3;
/// assert!((found.factor / euler - 1.0).abs() < 1e-3);
/// ```
pub fn buckling_factor(
    model: &Model,
    cases: &[LoadCase],
    factors: &[f64],
    pieces: usize,
) -> Result<BucklingAnswer, InputError> {
    let solution = super::solver::solve(model, cases)?;
    let mut buckler = Buckler::new(model, &[pieces])?;
    Ok(buckler.first(&solution, factors))
}

/// A frame cut into pieces and factored once, to be asked for many combinations.
pub struct Buckler {
    solver: Solver,
    solved: bool,
    nodes: usize,
    /// Of every piece: its member, and its two ends as shares of the member's length.
    pieces: Vec<(u32, [f64; 2])>,
    model: Model,
}

impl Buckler {
    /// Cuts every member of `model` into `pieces[member]` pieces, the last value for all members beyond the list (at least 1),
    /// and factors the result.
    pub fn new(model: &Model, pieces: &[usize]) -> Result<Self, InputError> {
        let (cut, places) = refined(model, pieces);
        let mut solver = Solver::new();
        let solved = solver.solve(&cut, &[])?.status.is_solved();
        Ok(Buckler { solver, solved, nodes: model.nodes.len(), pieces: places, model: cut })
    }

    /// First buckling load under the sum of `factors[case]` times the cases of `solution`, a solution of the frame as it was
    /// before it was cut.
    pub fn first(&mut self, solution: &Solution, factors: &[f64]) -> BucklingAnswer {
        if !self.solved || !solution.status.is_solved() || self.solver.layout.n == 0 {
            return BucklingAnswer::Unknown;
        }
        let geometric = self.geometric(solution, factors);
        let s = &mut self.solver;
        let found = lanczos::largest(&s.layout, &mut s.factor, &s.values, &geometric);
        match found {
            None => BucklingAnswer::Unknown,
            Some(found) if found.value <= 0.0 => BucklingAnswer::Never,
            Some(found) => BucklingAnswer::Buckles(self.named(solution, &found)),
        }
    }

    /// Minus the geometric stiffness in the pattern of the elastic one: positive where compression softens.
    fn geometric(&self, solution: &Solution, factors: &[f64]) -> Vec<f64> {
        let mut values = vec![0.0; self.solver.values.len()];
        for ((member, beam), (whole, at)) in self.model.members.iter().zip(&self.solver.beams).zip(&self.pieces) {
            let line = Line::new(solution, factors, *whole as usize);
            let force = |t: f64| line.forces(t * line.length())[0];
            // The mean over a piece whose force varies linearly; point loads inside are met by the middle.
            let pull = (force(at[0] + 1e-9) + 4.0 * force(0.5 * (at[0] + at[1])) + force(at[1])) / 6.0;
            let [i, j] = member.nodes;
            let g = softened(beam, -pull);
            self.solver.layout.add_diagonal(i, &g.block(0, 0), &mut values);
            self.solver.layout.add_diagonal(j, &g.block(1, 1), &mut values);
            self.solver.layout.add_coupling(i, j, &g.block(0, 1), &mut values);
        }
        values
    }

    fn named(&self, solution: &Solution, found: &lanczos::Found) -> Buckling {
        let mut moves = super::diagnose::spread(&self.solver.layout, &found.vector, self.model.nodes.len());
        let size = |m: &[f64; 6]| (m[0] * m[0] + m[1] * m[1] + m[2] * m[2]).sqrt();
        let (mut best, mut piece, mut end) = (-1.0, 0, 0);
        for (p, member) in self.model.members.iter().enumerate() {
            for (e, &node) in member.nodes.iter().enumerate() {
                if size(&moves[node]) > best * (1.0 + 1e-9) {
                    (best, piece, end) = (size(&moves[node]), p, e);
                }
            }
        }
        // A mode has no sign: its largest component counts as positive.
        let at = moves[self.model.members[piece].nodes[end]];
        let lead = (0..3).fold(0.0f64, |a, d| if at[d].abs() > a.abs() { at[d] } else { a });
        let unit = if best > 0.0 { best * lead.signum() } else { 1.0 };
        moves.iter_mut().flatten().for_each(|v| *v /= unit);
        let (member, places) = self.pieces[piece];
        moves.truncate(self.nodes);
        Buckling {
            factor: 1.0 / found.value,
            nodes: moves,
            member: member as usize,
            x: places[end] * solution.length(member as usize),
            direction: [at[0] / unit, at[1] / unit, at[2] / unit],
            steps: found.steps,
        }
    }
}

/// `model` with its members cut; inner nodes come after the given ones. Releases stay at the outer ends.
fn refined(model: &Model, pieces: &[usize]) -> (Model, Vec<(u32, [f64; 2])>) {
    let mut cut = model.clone();
    cut.members.clear();
    let mut places = Vec::new();
    for (m, member) in model.members.iter().enumerate() {
        let count = pieces.get(m).or(pieces.last()).map_or(1, |&p| p.max(1));
        let [a, b] = member.nodes.map(|n| model.nodes.get(n).copied().unwrap_or_default());
        let mut from = member.nodes[0];
        for k in 0..count {
            let (start, end) = (k as f64 / count as f64, (k + 1) as f64 / count as f64);
            let last = k + 1 == count;
            let to = if last { member.nodes[1] } else { cut.nodes.len() };
            if !last {
                cut.nodes.push(std::array::from_fn(|d| a[d] + end * (b[d] - a[d])));
            }
            let mut piece = member.clone();
            piece.nodes = [from, to];
            for (e, outer) in [k == 0, last].into_iter().enumerate() {
                piece.releases[e] = if outer { member.releases[e] } else { [false; 6] };
            }
            cut.members.push(piece);
            places.push((m as u32, [start, end]));
            from = to;
        }
    }
    (cut, places)
}

/// The beam with the geometric stiffness of a compression in place of its own: cubic displacements (Przemieniecki, Theory of
/// Matrix Structural Analysis, 1968, section 15.2), released ends following as the elastic beam lets them.
fn softened(beam: &Beam, compression: f64) -> Beam {
    let (l, c) = (beam.length, compression / (30.0 * beam.length));
    let plane = |part: &Part<4>, sign: f64| {
        let (a, b) = (36.0 * c, 3.0 * c * l * sign);
        let (d, e) = (4.0 * c * l * l, -c * l * l);
        let g = [[a, b, -a, b], [b, d, -b, e], [-a, -b, a, -b], [b, e, -b, d]];
        let mut k = [[0.0; 4]; 4];
        for (r, row) in k.iter_mut().enumerate() {
            for (s, entry) in row.iter_mut().enumerate() {
                let along = |p: usize| -> f64 { (0..4).map(|q| g[p][q] * part.carry[s][q]).sum() };
                *entry = (0..4).map(|p| part.carry[r][p] * along(p)).sum();
            }
        }
        Part { k, carry: part.carry, loose: part.loose }
    };
    let mut g = beam.clone();
    (g.axial.k, g.torsion.k) = ([[0.0; 2]; 2], [[0.0; 2]; 2]);
    g.bend_z = plane(&beam.bend_z, 1.0);
    g.bend_y = plane(&beam.bend_y, -1.0);
    g
}
