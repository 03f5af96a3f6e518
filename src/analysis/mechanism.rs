//! Frames that move without resistance: which nodes, which way, and why.

use super::model::Model;
use std::fmt;

/// How one node moves in a mechanism.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Motion {
    /// The node.
    pub node: usize,
    /// ux uy uz rx ry rz, global; the largest translation of the mechanism is 1 (the largest rotation when nothing
    /// translates).
    pub direction: [f64; 6],
}

/// Why a frame moves.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Cause {
    /// The part of the frame that moves has no support at all.
    Loose,
    /// Supports, members or rigid joints are missing: hinge chain, panel without a brace, missing support.
    Sway,
    /// A load acts on a dof that nothing resists (a rotation of a node with hinges only, a node without members).
    LoadOnIdle {
        /// The case.
        case: usize,
    },
    /// A load on a member reaches an end that is released on both sides.
    LoadOnReleasedMember {
        /// The case.
        case: usize,
        /// The member.
        member: usize,
    },
}

/// A motion without resistance.
#[derive(Clone, Debug, PartialEq)]
pub struct Mechanism {
    /// Why.
    pub cause: Cause,
    /// The nodes that move, the farthest first; motions under a tenth of the largest are left out.
    pub motions: Vec<Motion>,
}

const AXIS: [&str; 6] = ["x", "y", "z", "rotation x", "rotation y", "rotation z"];

impl fmt::Display for Motion {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "node {}", self.node)?;
        let translates = self.direction[..3].iter().any(|d| d.abs() > 0.05);
        let shown = if translates { 0..3 } else { 3..6 };
        for d in shown.filter(|&d| self.direction[d].abs() > 0.05) {
            write!(
                f,
                " {}{:.2} {}",
                if self.direction[d] < 0.0 { '-' } else { '+' },
                self.direction[d].abs(),
                AXIS[d]
            )?;
        }
        Ok(())
    }
}

impl fmt::Display for Mechanism {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.cause {
            Cause::Loose => write!(f, "a part of the frame has no support")?,
            Cause::Sway => write!(f, "the frame moves without resistance")?,
            Cause::LoadOnIdle { case } => write!(f, "case {case} loads a direction that nothing resists")?,
            Cause::LoadOnReleasedMember { case, member } => {
                write!(f, "case {case} loads member {member} along an end released on both sides")?;
            }
        }
        for (n, m) in self.motions.iter().take(8).enumerate() {
            write!(f, "{} {m}", if n == 0 { ":" } else { ";" })?;
        }
        match self.motions.len().saturating_sub(8) {
            0 => Ok(()),
            rest => write!(f, "; and {rest} nodes more"),
        }
    }
}

/// Mean member length: turns rotations into comparable displacements.
pub(super) fn mean_length(lengths: impl ExactSizeIterator<Item = f64>) -> f64 {
    let n = lengths.len();
    if n == 0 { 1.0 } else { lengths.sum::<f64>() / n as f64 }
}

/// Names the mechanism that the displacement field `moves` of every node is.
pub(super) fn name(model: &Model, moves: &[[f64; 6]], length: f64) -> Mechanism {
    let largest = |range: std::ops::Range<usize>| {
        moves.iter().flat_map(|m| &m[range.clone()]).fold(0.0f64, |a, v| if v.abs() > a.abs() { *v } else { a })
    };
    let (shift, turn) = (largest(0..3), largest(3..6));
    let translates = shift.abs() > 1e-6 * turn.abs() * length;
    let unit = if translates { shift } else { turn };
    let size = |m: &[f64; 6]| {
        let part = if translates { &m[..3] } else { &m[3..] };
        part.iter().map(|v| v * v).sum::<f64>().sqrt() / unit.abs()
    };
    let mut motions: Vec<(f64, Motion)> = moves
        .iter()
        .enumerate()
        .map(|(node, m)| (size(m), Motion { node, direction: m.map(|v| v / unit) }))
        .filter(|(s, _)| *s > 0.1)
        .collect();
    motions.sort_by(|a, b| b.0.total_cmp(&a.0).then(a.1.node.cmp(&b.1.node)));
    let cause = match motions.first() {
        Some((_, m)) if !reaches_support(model, m.node) => Cause::Loose,
        _ => Cause::Sway,
    };
    Mechanism { cause, motions: motions.into_iter().map(|(_, m)| m).collect() }
}

/// Whether members lead from `node` to any support.
fn reaches_support(model: &Model, node: usize) -> bool {
    let mut seen = vec![false; model.nodes.len()];
    seen[node] = true;
    let mut grew = true;
    while grew {
        grew = false;
        for m in &model.members {
            let [i, j] = m.nodes;
            if seen[i] != seen[j] {
                (seen[i], seen[j], grew) = (true, true, true);
            }
        }
    }
    model.supports.iter().any(|s| seen[s.node] && s.fix.contains(&true))
}

/// One node in one direction.
pub(super) fn single(cause: Cause, node: usize, direction: [f64; 6]) -> Mechanism {
    Mechanism { cause, motions: vec![Motion { node, direction }] }
}
