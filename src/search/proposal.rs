//! Candidates: drawn each from its own stream, checked, and never proposed twice.

use super::Score;
use super::domain::{Domain, Operator};
use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;
use rayon::prelude::*;
use rustc_hash::FxHashSet;
use std::collections::BTreeMap;

/// Children drawn for one candidate before it falls back to a new start, and starts before it is given up.
const TRIES: usize = 64;

/// A design to be evaluated.
#[derive(Clone, Debug)]
pub struct Candidate<G, F> {
    /// Index of the evaluation, 0 for the first.
    pub id: u64,
    /// Batch in which it was proposed.
    pub generation: u32,
    /// Ids of its parents.
    pub parents: Vec<u64>,
    /// What made it (the last one, where several moves were made).
    pub operator: Operator,
    /// The arms that made it, in their order; empty for starts and polished designs.
    pub arms: Vec<usize>,
    /// The goal it was polished for.
    pub goal: Option<usize>,
    /// The genome.
    pub genome: G,
    /// The genome written out.
    pub form: F,
}

/// A candidate with its score.
#[derive(Clone, Debug)]
pub struct Evaluated<G, F> {
    /// The candidate.
    pub candidate: Candidate<G, F>,
    /// Its score.
    pub score: Score,
}

/// A candidate of a domain.
pub type CandidateOf<D> = Candidate<<D as Domain>::Genome, <D as Domain>::Form>;

/// An evaluated candidate of a domain.
pub type EvaluatedOf<D> = Evaluated<<D as Domain>::Genome, <D as Domain>::Form>;

/// A design on its way to become a candidate.
#[derive(Clone, Debug)]
pub struct Draft<G> {
    /// The genome.
    pub genome: G,
    /// What made it.
    pub operator: Operator,
    /// The arms that made it.
    pub arms: Vec<usize>,
    /// The goal it was polished for.
    pub goal: Option<usize>,
    /// Ids of its parents.
    pub parents: Vec<u64>,
}

impl<G> Draft<G> {
    /// A design without parents.
    pub fn start(genome: G) -> Self {
        Draft { genome, operator: Operator::START, arms: Vec::new(), goal: None, parents: Vec::new() }
    }
}

/// Counts of what was drawn, by operator. Ordered maps: tables come out the same every time.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Tally {
    /// Draws that an operator turned into a design.
    pub made: BTreeMap<Operator, u64>,
    /// Draws where it could not apply.
    pub inapplicable: BTreeMap<Operator, u64>,
    /// Designs that had been evaluated before (cache hits).
    pub duplicate: BTreeMap<Operator, u64>,
    /// Designs whose bounds were beaten already: spared an evaluation.
    pub screened: BTreeMap<Operator, u64>,
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
            (&mut self.screened, &other.screened),
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

/// One draw of a draft for a place in the batch from its stream; `None` when its operator could not apply. `tries` counts the draws for
/// that place, from 0.
pub type Draw<'a, G> = dyn Fn(Place, &mut ChaCha8Rng, &mut Tally) -> Option<Draft<G>> + Sync + 'a;

/// Whether bounds on the objectives of a design are beaten already, so that its evaluation could change nothing.
pub type Beaten<'a> = dyn Fn(&[f64]) -> bool + Sync + 'a;

/// Which draw of a batch is asked for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Place {
    /// Place in the batch, from 0.
    pub index: usize,
    /// Draws for this place before, from 0.
    pub tries: usize,
}

/// Proposes candidates of a domain, numbered and never twice the same.
pub struct Proposer<'a, D: Domain> {
    /// The kind of genome.
    pub domain: &'a D,
    seed: u64,
    /// Identities of everything proposed: the upper half of each, 8 bytes and a load of 44 to 88 %, so 10 to 21 bytes a design. Among a
    /// million designs, two share theirs with a probability of 3e-8, and then the second one is not evaluated.
    seen: FxHashSet<u64>,
    next: u64,
    /// Streams used so far: one per place in a batch, whether or not the place could be filled.
    streams: u64,
    generation: u32,
    tally: Tally,
}

/// What the set of proposed designs knows a design by.
fn short(key: u128) -> u64 {
    (key >> 64) as u64
}

struct Drawn<G, F> {
    candidate: Option<(Draft<G>, F, u64)>,
    rng: ChaCha8Rng,
    tries: usize,
    tally: Tally,
}

impl<'a, D: Domain> Proposer<'a, D> {
    /// A proposer.
    pub fn new(domain: &'a D, seed: u64) -> Self {
        let (seen, tally) = (FxHashSet::default(), Tally::default());
        Proposer { domain, seed, seen, next: 0, streams: 0, generation: 0, tally }
    }

    /// Counts so far.
    pub fn tally(&self) -> &Tally {
        &self.tally
    }

    /// Number of candidates proposed so far.
    pub fn proposed(&self) -> u64 {
        self.next
    }

    /// Bytes that are held for what was proposed.
    pub fn memory(&self) -> usize {
        self.seen.capacity() * 8 / 7 * (size_of::<u64>() + 1)
    }

    /// `count` candidates, each drawn by `draw` from its own stream, in parallel; repeats within the batch are drawn
    /// again in index order. Fewer when there is nothing new to offer.
    pub fn propose(&mut self, count: usize, draw: &Draw<'_, D::Genome>) -> Vec<CandidateOf<D>> {
        self.propose_unbeaten(count, draw, None)
    }

    /// The same without the children that are `beaten`, where that is asked; starts never are.
    pub fn propose_unbeaten(
        &mut self,
        count: usize,
        draw: &Draw<'_, D::Genome>,
        beaten: Option<&Beaten<'_>>,
    ) -> Vec<CandidateOf<D>> {
        let this = &*self;
        let drawn: Vec<Drawn<D::Genome, D::Form>> =
            (0..count).into_par_iter().map(|index| this.first_draw(index, draw, beaten)).collect();
        let mut out = Vec::with_capacity(count);
        for (index, mut one) in drawn.into_iter().enumerate() {
            if one.candidate.as_ref().is_some_and(|c| self.seen.contains(&c.2)) {
                one.candidate.iter().for_each(|c| *one.tally.duplicate.entry(c.0.operator).or_default() += 1);
                one.candidate = self.search(index, &mut one.tries, &mut one.rng, (draw, beaten), &mut one.tally);
            }
            self.tally.merge(&one.tally);
            if let Some((draft, form, key)) = one.candidate {
                self.seen.insert(key);
                let Draft { genome, operator, arms, goal, parents } = draft;
                let (id, generation) = (self.next, self.generation);
                out.push(Candidate { id, generation, parents, operator, arms, goal, genome, form });
                self.next += 1;
            }
        }
        self.streams += count as u64;
        self.generation += 1;
        out
    }

    fn first_draw(
        &self,
        index: usize,
        draw: &Draw<'_, D::Genome>,
        beaten: Option<&Beaten<'_>>,
    ) -> Drawn<D::Genome, D::Form> {
        let mut rng = ChaCha8Rng::seed_from_u64(self.seed);
        rng.set_stream(self.streams + index as u64);
        let (mut tally, mut tries) = (Tally::default(), 0);
        let candidate = self.search(index, &mut tries, &mut rng, (draw, beaten), &mut tally);
        Drawn { candidate, rng, tries, tally }
    }

    /// Draws until something new and rule-respecting comes out; after [`TRIES`] draws asks the generator of starts.
    fn search(
        &self,
        index: usize,
        tries: &mut usize,
        rng: &mut ChaCha8Rng,
        (draw, beaten): (&Draw<'_, D::Genome>, Option<&Beaten<'_>>),
        tally: &mut Tally,
    ) -> Option<(Draft<D::Genome>, D::Form, u64)> {
        (0..2 * TRIES).find_map(|n| {
            let place = Place { index, tries: *tries };
            *tries += 1;
            let draft = if n < TRIES { draw(place, rng, tally) } else { start_draft(self.domain, rng, tally) }?;
            self.admit(draft, beaten, tally)
        })
    }

    fn admit(
        &self,
        draft: Draft<D::Genome>,
        beaten: Option<&Beaten<'_>>,
        tally: &mut Tally,
    ) -> Option<(Draft<D::Genome>, D::Form, u64)> {
        *tally.made.entry(draft.operator).or_default() += 1;
        let form = self.domain.express(&draft.genome);
        let key = short(self.domain.key(&draft.genome, &form));
        if self.seen.contains(&key) {
            *tally.duplicate.entry(draft.operator).or_default() += 1;
            return None;
        }
        let started = draft.operator == Operator::START || draft.operator == Operator::GRAFT;
        let asked = beaten.filter(|_| !started);
        if asked.is_some_and(|beaten| self.domain.is_beaten(&draft.genome, &form, beaten)) {
            *tally.screened.entry(draft.operator).or_default() += 1;
            return None;
        }
        if let Some(rule) = self.domain.broken_rule(&form) {
            *tally.rejected.entry((draft.operator, rule)).or_default() += 1;
            return None;
        }
        Some((draft, form, key))
    }
}

/// A start as a draft; `None` when the generator finds none.
pub fn start_draft<D: Domain>(domain: &D, rng: &mut ChaCha8Rng, tally: &mut Tally) -> Option<Draft<D::Genome>> {
    let found = domain.start(rng);
    if found.is_none() {
        tally.missed(Operator::START);
    }
    found.map(Draft::start)
}

/// Up to `count` moves from a parent, each drawn by `draw`, at least one of which applied.
pub fn mutate<D: Domain>(
    domain: &D,
    parent: (&D::Genome, u64),
    count: usize,
    draw: &dyn Fn(&mut ChaCha8Rng) -> usize,
    rng: &mut ChaCha8Rng,
    tally: &mut Tally,
) -> Option<Draft<D::Genome>> {
    let mut out: Option<Draft<D::Genome>> = None;
    for _ in 0..count {
        let arm = draw(rng);
        let operator = domain.arms()[arm].operator;
        let from = out.as_ref().map_or(parent.0, |o| &o.genome);
        match domain.vary(arm, [from, from], rng) {
            Some(genome) => {
                let mut arms = out.map_or_else(Vec::new, |o| o.arms);
                arms.push(arm);
                out = Some(Draft { genome, operator, arms, goal: None, parents: vec![parent.1] });
            }
            None => tally.missed(operator),
        }
    }
    out
}
