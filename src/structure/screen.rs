//! Bounds on what a span can come to in each combination, so that only what can govern is checked clause by clause.

use rustc_hash::FxHashMap;

use super::actions::{ACTIONS, BaseActions, Sum};
use super::check::{Piece, Resistance, Restraint};
use crate::analysis::Solution;
use crate::frame::Span;
use crate::voxels::Choice;

/// Largest magnitudes of N, Vy, Vz, My, Mz along one or more pieces.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Reach(pub [f64; 5]);

impl Reach {
    /// Of a piece: N and V are linear, moments are off the line between their ends by at most q l^2 / 8.
    #[inline]
    pub fn of(p: &Piece, length: f64) -> Reach {
        let [fx, fy, fz, my, mz, qx, qy, qz] = *p;
        let larger = |a: f64, b: f64| a.abs().max(b.abs());
        let eighth = 0.125 * length * length;
        let half = 0.5 * length * length;
        Reach([
            larger(fx, fx + qx * length),
            larger(fy, fy + qy * length),
            larger(fz, fz + qz * length),
            larger(my, my + fz * length + half * qz) + eighth * qz.abs(),
            larger(mz, fy * length + half * qy - mz) + eighth * qy.abs(),
        ])
    }

    /// Takes in what another piece comes to.
    #[inline]
    pub fn join(&mut self, other: &Reach) {
        self.0.iter_mut().zip(&other.0).for_each(|(a, b)| *a = a.max(*b));
    }
}

/// What a resistance depends on within a house: group, plies, restraint and the bits of the clear length.
type Key = (Choice, u8, Restraint, u64);

/// Resistances of all spans, each worked out once, and bounds on their ratios. Buffers are kept.
#[derive(Default)]
pub(super) struct Screen {
    known: FxHashMap<Key, u32>,
    resistances: Vec<Resistance>,
    of_span: Vec<u32>,
    bounds: Vec<f64>,
}

impl Screen {
    /// Forgets the last house.
    pub fn clear(&mut self) {
        self.known.clear();
        self.resistances.clear();
        self.of_span.clear();
        self.bounds.clear();
    }

    /// Adds the next span.
    pub fn push(
        &mut self,
        (group, plies, held): (Choice, u8, Restraint),
        clear: f64,
        new: impl FnOnce() -> Resistance,
    ) {
        let resistances = &mut self.resistances;
        let number = *self.known.entry((group, plies, held, clear.to_bits())).or_insert_with(|| {
            resistances.push(new());
            resistances.len() as u32 - 1
        });
        self.of_span.push(number);
    }

    /// The resistance of a span.
    pub fn resistance(&self, span: usize) -> &Resistance {
        &self.resistances[self.of_span[span] as usize]
    }

    /// Bounds every span; the one with the largest bound.
    pub fn bound_all(
        &mut self,
        spans: &[Span],
        sums: &[Sum],
        solution: &Solution,
        actions: &BaseActions,
    ) -> Option<usize> {
        let mut worst: Option<usize> = None;
        for (at, span) in spans.iter().enumerate() {
            let shares = shares(self.resistance(at), span, solution, actions);
            let all = sums.iter().map(|sum| bound(self.resistance(at), &shares, sum));
            self.bounds.push(all.fold(0.0, f64::max));
            if worst.is_none_or(|w| self.bounds[at] > self.bounds[w]) {
                worst = Some(at);
            }
        }
        worst
    }

    /// What no ratio of a span exceeds.
    pub fn bound(&self, span: usize) -> f64 {
        self.bounds[span]
    }
}

/// Shares of resistance that the base actions take up on a span.
pub(super) fn shares(r: &Resistance, span: &Span, solution: &Solution, actions: &BaseActions) -> [[f64; 2]; ACTIONS] {
    let mut reach = [Reach::default(); ACTIONS];
    for e in span.elements[0] as usize..=span.elements[1] as usize {
        let length = solution.length(e);
        reach.iter_mut().zip(actions.pieces(e)).for_each(|(reach, p)| reach.join(&Reach::of(p, length)));
    }
    reach.map(|reach| r.shares(&reach))
}

/// What no ratio exceeds in a combination of base actions with these shares.
#[inline]
pub(super) fn bound(r: &Resistance, shares: &[[f64; 2]; ACTIONS], sum: &Sum) -> f64 {
    let of = |kind: usize| sum.terms().iter().map(|&(n, f)| f.abs() * shares[n][kind]).sum::<f64>();
    r.at_most(of(0).max(of(1)), sum.k_mod)
}
