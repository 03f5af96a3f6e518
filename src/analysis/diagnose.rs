//! The weakest motion of a frame: inverse iteration on the stiffness matrix scaled to unit diagonal.

use super::factor::Factor;
use super::layout::{Layout, NONE};
use super::solution::Idle;

/// What is known of the weakest motion.
pub(super) struct Weakness {
    /// Smallest pivot over its diagonal.
    pub pivot: f64,
    /// Least eigenvalue of the scaled matrix (the pivot where nothing closer was needed).
    pub least: f64,
    /// The motion, when it was computed.
    pub moves: Option<Vec<[f64; 6]>>,
}

/// Shifts tried, as shares of the diagonal: the first is far above rounding and far below the stiffness of sound frames.
const SHIFTS: [f64; 4] = [1e-11, 1e-9, 1e-7, 1e-5];
const ITERATIONS: usize = 8;

/// Least eigenvalue of `D^-1/2 K D^-1/2` and its vector (in displacements). Leaves the shifted factor in `factor`.
pub(super) fn weakest(factor: &mut Factor, layout: &Layout, values: &[f64]) -> (f64, Option<Vec<f64>>) {
    let n = layout.n;
    let diagonal = usable_diagonal(layout, values);
    let mut shifted = values.to_vec();
    let positive = SHIFTS.iter().any(|shift| {
        shifted.copy_from_slice(values);
        (0..n).for_each(|k| shifted[layout.diagonal(k)] += shift * diagonal[k]);
        factor.factorise(layout, &shifted).is_ok()
    });
    if !positive {
        return (0.0, None);
    }
    let mut v = start_vector(&diagonal);
    for _ in 0..ITERATIONS {
        (0..n).for_each(|k| v[k] *= diagonal[k]);
        factor.solve(&mut v, 1);
        normalise(&mut v, &diagonal);
    }
    let mut kv = vec![0.0; n];
    layout.multiply(values, &v, &mut kv);
    let energy: f64 = v.iter().zip(&kv).map(|(a, b)| a * b).sum();
    (energy.max(0.0), v.iter().all(|x| x.is_finite()).then_some(v))
}

/// Diagonal with a stand-in where a dof has no stiffness at all.
fn usable_diagonal(layout: &Layout, values: &[f64]) -> Vec<f64> {
    let d: Vec<f64> = (0..layout.n).map(|k| values[layout.diagonal(k)]).collect();
    let mean = d.iter().sum::<f64>() / layout.n.max(1) as f64;
    let stand_in = if mean > 0.0 { mean } else { 1.0 };
    d.into_iter().map(|v| if v > 1e-14 * stand_in { v } else { stand_in }).collect()
}

/// A vector without symmetry: a fixed multiplicative sequence, so that no motion is orthogonal to it by accident.
fn start_vector(diagonal: &[f64]) -> Vec<f64> {
    let mut v: Vec<f64> = diagonal
        .iter()
        .enumerate()
        .map(|(k, d)| (0.5 + ((k as f64 + 1.0) * 0.618_033_988_749_894_9).fract()) / d.sqrt())
        .collect();
    normalise(&mut v, diagonal);
    v
}

fn normalise(v: &mut [f64], diagonal: &[f64]) {
    let size = v.iter().zip(diagonal).map(|(x, d)| x * x * d).sum::<f64>().sqrt();
    v.iter_mut().for_each(|x| *x /= size);
}

/// Unknowns to displacements of all nodes.
pub(super) fn spread(layout: &Layout, v: &[f64], nodes: usize) -> Vec<[f64; 6]> {
    let mut moves = vec![[0.0; 6]; nodes];
    for (row, equations) in moves.iter_mut().zip(&layout.equation) {
        for d in (0..6).filter(|&d| equations[d] != NONE) {
            row[d] = v[equations[d] as usize];
        }
    }
    moves
}

/// Largest rotational diagonal entry: the scale of a spring that grounds a rotation.
pub(super) fn typical_rotation(layout: &Layout, values: &[f64]) -> f64 {
    let rotations = layout.equation.iter().flat_map(|e| &e[3..]).filter(|e| **e != NONE);
    rotations.map(|&e| values[layout.diagonal(e as usize)]).fold(0.0, f64::max)
}

/// A rotation to ground.
pub(super) struct Spin {
    pub equation: u32,
    pub idle: Idle,
}

/// When the rotations of `moves`, alone, meet no stiffness and no load works on them, one of them may be held without
/// changing any force: the one that turns most. Translations are left aside, because a spin and a sway that are both free
/// come mixed out of the iteration.
pub(super) fn harmless_spin(layout: &Layout, values: &[f64], moves: &[[f64; 6]], loads: &[f64]) -> Option<Spin> {
    let mut v = vec![0.0; layout.n];
    for (row, equations) in moves.iter().zip(&layout.equation) {
        (3..6).filter(|&d| equations[d] != NONE).for_each(|d| v[equations[d] as usize] = row[d]);
    }
    let turn = v.iter().fold(0.0f64, |a, x| a.max(x.abs()));
    let mut kv = vec![0.0; layout.n];
    layout.multiply(values, &v, &mut kv);
    let energy: f64 = v.iter().zip(&kv).map(|(a, b)| a * b).sum();
    let whole: f64 = (0..layout.n).map(|k| v[k] * v[k] * values[layout.diagonal(k)]).sum();
    if turn == 0.0 || energy > super::solver::MECHANISM_LIMIT * whole {
        return None;
    }
    if loads.chunks_exact(layout.n.max(1)).any(|case| turns(layout, moves, case, turn)) {
        return None;
    }
    let (node, d) = (0..moves.len())
        .flat_map(|n| (3..6).map(move |d| (n, d)))
        .max_by(|a, b| moves[a.0][a.1].abs().total_cmp(&moves[b.0][b.1].abs()))?;
    let mut direction = [0.0; 6];
    direction[d] = 1.0;
    Some(Spin { equation: layout.equation[node][d], idle: Idle { node, direction } })
}

/// Whether the moments of `case` work on the rotations of `moves`. A wrong "no" cannot hide: the grounding spring would take
/// the moment and leave its node out of balance.
fn turns(layout: &Layout, moves: &[[f64; 6]], case: &[f64], turn: f64) -> bool {
    let (mut work, mut most) = (0.0f64, 0.0f64);
    for (row, equations) in moves.iter().zip(&layout.equation) {
        for d in (3..6).filter(|&d| equations[d] != NONE) {
            let moment = case[equations[d] as usize];
            work += moment * row[d];
            most = most.max(moment.abs());
        }
    }
    work.abs() > 1e-6 * most * turn
}
