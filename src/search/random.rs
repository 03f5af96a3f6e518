//! Random search with the same generator and the same moves, without selection: the baseline.

use super::plot::Space;
use super::proposal::{Candidate, Draft, Evaluated, Operator, Proposer, RuleCheck, Tally, mutate, start_draft};
use super::run::Searcher;
use rand::RngExt;
use rand_chacha::ChaCha8Rng;

/// Moves from a start at most.
const WALK: usize = 12;

/// Random walks from random starts.
pub struct RandomSearch<'a> {
    proposer: Proposer<'a>,
    batch: usize,
}

impl<'a> RandomSearch<'a> {
    /// A random search over `space` in batches of `batch`.
    pub fn new(space: &'a Space, seed: u64, batch: usize, rules: Option<&'a RuleCheck<'a>>) -> Self {
        RandomSearch { proposer: Proposer::new(space, seed, rules), batch: batch.max(1) }
    }
}

impl Searcher for RandomSearch<'_> {
    fn ask(&mut self, most: usize) -> Vec<Candidate> {
        let space = self.proposer.space;
        let draw = |rng: &mut ChaCha8Rng, tally: &mut Tally| {
            let from = start_draft(space, rng, tally).ok()?;
            let steps = rng.random_range(0..=WALK);
            Some(match mutate(&from.design, steps, space, rng, tally) {
                None => from,
                Some((design, last)) => Draft { design, operator: Operator::Move(last), parents: Vec::new() },
            })
        };
        self.proposer.propose(self.batch.min(most), &draw)
    }

    fn tell(&mut self, _: &[Evaluated]) {}

    fn tally(&self) -> &Tally {
        self.proposer.tally()
    }
}
