//! The search: genomes in, a Pareto front of genomes out.
//!
//! Three nouns, after pyribs: *archives* keep ([`archive`]), *searchers* propose ([`steady`], and beside it [`evolution`], [`elites`], [`hill`]
//! and [`random`]), and [`run`] is the loop that composes them through `ask` and `tell`. They know a [`domain`]: a kind of genome with its
//! operators. That of [`houses`] is the storey-wise reading of a rule-respecting voxel array plus choices ([`massing::Design`]);
//! [`massing::encode`] writes it as voxels. Moves ([`moves`]), crossover
//! ([`crossover`]) and the generator of starts ([`start`]) all pass through [`settle`], which re-seats what a change of
//! the massing has unseated, and returns a cause when the result would break a rule.
//!
//! Beside the search, [`dress`] makes a house of a massing from another program with the same parts.
//!
//! Beside it too, [`enumerate`] lists every design of a space that is small enough, without moves or starts.
//!
//! Deliberately absent: tiles, members and money. An evaluator is a closure from a house to a [`Score`].
//!
//! Every candidate draws from its own ChaCha8 stream, chosen by its index, and batches are committed in index order: the
//! number of threads cannot change a result.

pub mod archive;
pub mod cells;
pub mod clusters;
pub mod contribution;
pub mod crossover;
pub mod decode;
pub mod domain;
pub mod dress;
pub mod elites;
pub mod enumerate;
pub mod evolution;
pub mod fields;
pub mod from_brief;
pub mod hill;
pub mod houses;
pub mod hypervolume;
pub mod identity;
pub mod improve;
pub mod kept;
pub mod knee;
pub mod look;
pub mod massing;
pub mod moves;
mod nd_tree;
pub mod neighbours;
pub mod niche;
pub mod nsga3;
pub mod openings;
pub mod plot;
pub mod proposal;
pub mod random;
pub mod repair;
pub mod run;
pub mod select;
pub mod settle;
pub mod shape;
pub mod sorting;
pub mod stairs;
pub mod start;
pub mod steady;
pub mod symmetry;

/// What an evaluator says of a house.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Score {
    /// Objectives, all minimised, in the order of the brief; empty when the house could not be assessed.
    pub objectives: Vec<f64>,
    /// How far the constraints are broken, summed and scaled to about one; 0 or less is feasible.
    pub violation: f64,
}

impl Score {
    /// Whether all constraints hold and every objective is a finite number.
    pub fn is_feasible(&self) -> bool {
        self.violation <= 0.0 && !self.objectives.is_empty() && self.objectives.iter().all(|v| v.is_finite())
    }

    /// Whether this score dominates `other` under constraint domination (Deb et al. 2002, section VI): a feasible one
    /// beats an infeasible one, of two infeasible ones the smaller violation wins, of two feasible ones Pareto decides.
    pub fn dominates(&self, other: &Score) -> bool {
        match (self.is_feasible(), other.is_feasible()) {
            (true, false) => true,
            (false, true) => false,
            (false, false) => self.badness() < other.badness(),
            (true, true) => dominates(&self.objectives, &other.objectives),
        }
    }

    fn badness(&self) -> f64 {
        if self.violation.is_nan() { f64::INFINITY } else { self.violation.max(0.0) }
    }
}

/// Pareto dominance of minimised vectors of equal length: nowhere worse, somewhere better.
pub fn dominates(a: &[f64], b: &[f64]) -> bool {
    a.iter().zip(b).all(|(x, y)| x <= y) && a.iter().zip(b).any(|(x, y)| x < y)
}
