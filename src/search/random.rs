//! Random search with the same generator and the same moves, without selection: the baseline.

use super::domain::Domain;
use super::evolution::draw_arm;
use super::proposal::{CandidateOf, Draft, EvaluatedOf, Place, Proposer, Tally, mutate, start_draft};
use super::run::Searcher;
use rand::RngExt;
use rand_chacha::ChaCha8Rng;

/// Moves from a start at most.
const WALK: usize = 12;

/// Random walks from random starts.
pub struct RandomSearch<'a, D: Domain> {
    proposer: Proposer<'a, D>,
    batch: usize,
}

impl<'a, D: Domain> RandomSearch<'a, D> {
    /// A random search over a domain in batches of `batch`.
    pub fn new(domain: &'a D, seed: u64, batch: usize) -> Self {
        RandomSearch { proposer: Proposer::new(domain, seed), batch: batch.max(1) }
    }
}

impl<D: Domain> Searcher<D> for RandomSearch<'_, D> {
    fn ask(&mut self, most: usize) -> Vec<CandidateOf<D>> {
        let domain = self.proposer.domain;
        let draw = |_: Place, rng: &mut ChaCha8Rng, tally: &mut Tally| {
            let from = start_draft(domain, rng, tally)?;
            let steps = rng.random_range(0..=WALK);
            let one_move = |rng: &mut ChaCha8Rng| draw_arm(domain.arms(), 1, rng).unwrap_or(0);
            Some(match mutate(domain, (&from.genome, 0), steps, &one_move, rng, tally) {
                None => from,
                Some(walked) => Draft { parents: Vec::new(), ..walked },
            })
        };
        self.proposer.propose(self.batch.min(most), &draw)
    }

    fn tell(&mut self, _: &[EvaluatedOf<D>]) {}

    fn tally(&self) -> &Tally {
        self.proposer.tally()
    }
}
