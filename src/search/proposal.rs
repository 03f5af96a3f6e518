//! Candidates: drawn each from its own stream, checked, and never proposed twice.

use super::Score;
use super::identity::identity;
use super::massing::{Design, encode};
use super::moves::Move;
use super::plot::Space;
use super::start::{NoStart, start};
use crate::voxels::{Choices, House};
use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;
use rayon::prelude::*;
use rustc_hash::FxHashSet;
use std::collections::BTreeMap;

/// Children drawn for one candidate before it falls back to a new start, and starts before it is given up.
const TRIES: usize = 24;

/// What made a design.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Operator {
    /// The generator of starts.
    Start,
    /// Crossover of two parents.
    Crossover,
    /// Sizing: the same house with the sections that pass at least cost.
    Sizing,
    /// A move (the last one, where several were made).
    Move(Move),
}

impl Operator {
    /// Name in tables.
    pub fn name(self) -> &'static str {
        match self {
            Operator::Start => "start",
            Operator::Crossover => "crossover",
            Operator::Sizing => "sizing",
            Operator::Move(m) => m.name(),
        }
    }
}

/// A design to be evaluated.
#[derive(Clone, Debug)]
pub struct Candidate {
    /// Index of the evaluation, 0 for the first.
    pub id: u64,
    /// Batch in which it was proposed.
    pub generation: u32,
    /// Ids of its parents.
    pub parents: Vec<u64>,
    /// What made it.
    pub operator: Operator,
    /// The genome.
    pub design: Design,
    /// The genome as voxels.
    pub house: House,
}

/// A candidate with its score.
#[derive(Clone, Debug)]
pub struct Evaluated {
    /// The candidate.
    pub candidate: Candidate,
    /// Its score.
    pub score: Score,
}

/// A design on its way to become a candidate.
#[derive(Clone, Debug)]
pub struct Draft {
    /// The genome.
    pub design: Design,
    /// What made it.
    pub operator: Operator,
    /// Ids of its parents.
    pub parents: Vec<u64>,
}

/// Counts of what was drawn, by operator. Ordered maps: tables come out the same every time.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Tally {
    /// Draws that an operator turned into a settled design.
    pub made: BTreeMap<Operator, u64>,
    /// Draws where it could not apply.
    pub inapplicable: BTreeMap<Operator, u64>,
    /// Designs that had been evaluated before (cache hits).
    pub duplicate: BTreeMap<Operator, u64>,
    /// Designs that the rule check rejected, by operator and rule.
    pub rejected: BTreeMap<(Operator, &'static str), u64>,
}

impl Tally {
    /// Adds the counts of another tally.
    pub fn merge(&mut self, other: &Tally) {
        for (mine, theirs) in [
            (&mut self.made, &other.made),
            (&mut self.inapplicable, &other.inapplicable),
            (&mut self.duplicate, &other.duplicate),
        ] {
            theirs.iter().for_each(|(k, n)| *mine.entry(*k).or_default() += n);
        }
        other.rejected.iter().for_each(|(k, n)| *self.rejected.entry(*k).or_default() += n);
    }

    /// Counts an operator that could not apply.
    pub fn missed(&mut self, operator: Operator) {
        *self.inapplicable.entry(operator).or_default() += 1;
    }
}

/// A rule check on encoded houses: the id of the first rule that is broken.
pub type RuleCheck<'a> = dyn Fn(&House) -> Option<&'static str> + Sync + 'a;

/// Sizes the sections of a house whose joists and boards stay; the number picks one of the goals. `None` where it cannot.
pub type Size<'a> = dyn Fn(&House, &Choices, u32) -> Option<Choices> + Sync + 'a;

/// One draw of a draft from a candidate's stream; `None` when its operator could not apply.
pub type Draw<'a> = dyn Fn(&mut ChaCha8Rng, &mut Tally) -> Option<Draft> + Sync + 'a;

/// Proposes candidates over a space, numbered and never twice the same.
pub struct Proposer<'a> {
    /// What may be drawn.
    pub space: &'a Space,
    seed: u64,
    rules: Option<&'a RuleCheck<'a>>,
    seen: FxHashSet<u128>,
    next: u64,
    /// Streams used so far: one per place in a batch, whether or not the place could be filled.
    streams: u64,
    generation: u32,
    tally: Tally,
}

struct Drawn {
    candidate: Option<(Draft, House, u128)>,
    rng: ChaCha8Rng,
    tally: Tally,
}

impl<'a> Proposer<'a> {
    /// A proposer; `rules` is asked for every design before it is proposed (hard rules), where given.
    pub fn new(space: &'a Space, seed: u64, rules: Option<&'a RuleCheck<'a>>) -> Self {
        Proposer {
            space,
            seed,
            rules,
            seen: FxHashSet::default(),
            next: 0,
            streams: 0,
            generation: 0,
            tally: Tally::default(),
        }
    }

    /// Counts so far.
    pub fn tally(&self) -> &Tally {
        &self.tally
    }

    /// Number of candidates proposed so far.
    pub fn proposed(&self) -> u64 {
        self.next
    }

    /// `count` candidates, each drawn by `draw` from its own stream, in parallel; repeats within the batch are drawn
    /// again in index order. Fewer when the space has nothing new to offer.
    pub fn propose(&mut self, count: usize, draw: &Draw<'_>) -> Vec<Candidate> {
        let first = self.streams;
        let this = &*self;
        let drawn: Vec<Drawn> = (0..count as u64).into_par_iter().map(|i| this.first_draw(first + i, draw)).collect();
        let mut out = Vec::with_capacity(count);
        for mut one in drawn {
            if one.candidate.as_ref().is_some_and(|c| self.seen.contains(&c.2)) {
                one.candidate.iter().for_each(|c| *one.tally.duplicate.entry(c.0.operator).or_default() += 1);
                one.candidate = self.search(&mut one.rng, draw, &mut one.tally);
            }
            self.tally.merge(&one.tally);
            if let Some((draft, house, key)) = one.candidate {
                self.seen.insert(key);
                let Draft { design, operator, parents } = draft;
                out.push(Candidate { id: self.next, generation: self.generation, parents, operator, design, house });
                self.next += 1;
            }
        }
        self.streams += count as u64;
        self.generation += 1;
        out
    }

    fn first_draw(&self, stream: u64, draw: &Draw<'_>) -> Drawn {
        let mut rng = ChaCha8Rng::seed_from_u64(self.seed);
        rng.set_stream(stream);
        let mut tally = Tally::default();
        let candidate = self.search(&mut rng, draw, &mut tally);
        Drawn { candidate, rng, tally }
    }

    /// Draws until something new and rule-respecting comes out; after [`TRIES`] draws asks the generator of starts.
    fn search(&self, rng: &mut ChaCha8Rng, draw: &Draw<'_>, tally: &mut Tally) -> Option<(Draft, House, u128)> {
        (0..2 * TRIES).find_map(|n| {
            let draft = if n < TRIES { draw(rng, tally) } else { start_draft(self.space, rng, tally).ok() }?;
            self.admit(draft, tally)
        })
    }

    fn admit(&self, draft: Draft, tally: &mut Tally) -> Option<(Draft, House, u128)> {
        *tally.made.entry(draft.operator).or_default() += 1;
        let house = encode(&draft.design.massing, &self.space.plot);
        let key = identity(&house, &draft.design.choices);
        if self.seen.contains(&key) {
            *tally.duplicate.entry(draft.operator).or_default() += 1;
            return None;
        }
        if let Some(rule) = self.rules.and_then(|check| check(&house)) {
            *tally.rejected.entry((draft.operator, rule)).or_default() += 1;
            return None;
        }
        Some((draft, house, key))
    }
}

/// A start as a draft.
///
/// # Errors
/// When the generator finds none.
pub fn start_draft(space: &Space, rng: &mut ChaCha8Rng, tally: &mut Tally) -> Result<Draft, NoStart> {
    let found = start(space, rng);
    if found.is_err() {
        tally.missed(Operator::Start);
    }
    Ok(Draft { design: found?, operator: Operator::Start, parents: Vec::new() })
}

/// Up to `count` random moves from a parent, at least one of which applied.
pub fn mutate(
    parent: &Design,
    count: usize,
    space: &Space,
    rng: &mut ChaCha8Rng,
    tally: &mut Tally,
) -> Option<(Design, Move)> {
    let mut out: Option<(Design, Move)> = None;
    for _ in 0..count {
        let choice = Move::draw(rng);
        let from = out.as_ref().map_or(parent, |o| &o.0);
        match choice.apply(from, space, rng) {
            Some(child) => out = Some((child, choice)),
            None => tally.missed(Operator::Move(choice)),
        }
    }
    out
}
