//! MAP-Elites: the best design of every kind.
//!
//! Mouret and Clune, "Illuminating search spaces by mapping elites", arXiv 1504.04909 (2015): a map has a cell for each niche
//! ([`Domain::niche`]), a cell keeps the best design met there (its elite), and parents are drawn from the cells alike, whatever their
//! elites are worth. Best is, as under constraint domination, a feasible design before an infeasible one, the lesser violation, and of two
//! feasible ones the smaller first objective. The front of the run is, as for every searcher, that of all evaluations.

use super::Score;
use super::domain::{Domain, Operator};
use super::evolution::draw_arm;
use super::niche::Niche;
use super::proposal::{CandidateOf, Draft, EvaluatedOf, Place, Proposer, Tally, mutate, start_draft};
use super::run::Searcher;
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;
use std::collections::BTreeMap;

/// Settings of MAP-Elites.
#[derive(Clone, Debug, PartialEq)]
pub struct Settings {
    /// Children per batch.
    pub batch: usize,
    /// Evaluations at the beginning that are starts.
    pub starts: usize,
    /// Share of children that are new starts for ever.
    pub immigrants: f64,
    /// Share of designs that are polished ([`Domain::polish`]) for the first goal.
    pub polish: f64,
}

impl Default for Settings {
    fn default() -> Self {
        Settings { batch: 32, starts: 128, immigrants: 0.05, polish: 0.05 }
    }
}

/// The best design of a niche.
#[derive(Clone, Debug, PartialEq)]
pub struct Elite<G> {
    /// Its evaluation.
    pub id: u64,
    /// Its genome.
    pub genome: G,
    /// Its score.
    pub score: Score,
    /// Whether it was polished, or is what polishing gave.
    pub polished: bool,
}

/// Whether a score is better than another in the same niche: see the [module](self).
pub fn is_better(new: &Score, old: &Score) -> bool {
    let first = |s: &Score| s.objectives.first().copied().unwrap_or(f64::INFINITY);
    match (new.is_feasible(), old.is_feasible()) {
        (true, true) => first(new) < first(old),
        _ => new.dominates(old),
    }
}

/// The searcher.
pub struct MapElites<'a, D: Domain> {
    settings: Settings,
    seed: u64,
    proposer: Proposer<'a, D>,
    map: BTreeMap<Niche, Elite<D::Genome>>,
    evaluations: u64,
    owed: f64,
    batches: u64,
}

/// Stream of the draws that are made once for a batch; candidates have the streams from 0 on.
const BATCH_STREAM: u64 = 1 << 63;

impl<'a, D: Domain> MapElites<'a, D> {
    /// A searcher over a domain.
    pub fn new(domain: &'a D, seed: u64, settings: Settings) -> Self {
        let settings = Settings { batch: settings.batch.max(1), ..settings };
        let proposer = Proposer::new(domain, seed);
        MapElites { settings, seed, proposer, map: BTreeMap::new(), evaluations: 0, owed: 0.0, batches: 0 }
    }

    /// The map: a cell for each niche that something was met in.
    pub fn map(&self) -> &BTreeMap<Niche, Elite<D::Genome>> {
        &self.map
    }

    /// Elites to be polished in this batch: marked, so that none is polished twice.
    fn targets(&mut self, batch: usize) -> Vec<(u64, D::Genome)> {
        if self.proposer.domain.goals() == 0 {
            return Vec::new();
        }
        self.owed = (self.owed + self.settings.polish * batch as f64).min(batch as f64);
        let mut rng = ChaCha8Rng::seed_from_u64(self.seed);
        rng.set_stream(BATCH_STREAM + self.batches);
        let mut open: Vec<&mut Elite<D::Genome>> = self.map.values_mut().filter(|e| !e.polished).collect();
        let mut out = Vec::new();
        while self.owed >= 1.0 && !open.is_empty() {
            let elite = open.swap_remove(rng.random_range(0..open.len()));
            elite.polished = true;
            out.push((elite.id, elite.genome.clone()));
            self.owed -= 1.0;
        }
        out
    }
}

impl<D: Domain> Searcher<D> for MapElites<'_, D> {
    fn ask(&mut self, most: usize) -> Vec<CandidateOf<D>> {
        let batch = self.settings.batch.min(most);
        let targets = self.targets(batch);
        let elites: Vec<&Elite<D::Genome>> = self.map.values().collect();
        let (domain, settings) = (self.proposer.domain, &self.settings);
        let starting = self.evaluations < settings.starts as u64 || elites.is_empty();
        let draw = |place: Place, rng: &mut ChaCha8Rng, tally: &mut Tally| {
            if place.tries == 0
                && let Some(target) = targets.get(place.index)
            {
                return polished(domain, target, tally);
            }
            if starting || rng.random_bool(settings.immigrants.clamp(0.0, 1.0)) {
                return start_draft(domain, rng, tally);
            }
            child(domain, &elites, rng, tally)
        };
        self.proposer.propose(batch, &draw)
    }

    fn tell(&mut self, evaluated: &[EvaluatedOf<D>]) {
        self.batches += 1;
        self.evaluations += evaluated.len() as u64;
        for one in evaluated {
            let candidate = &one.candidate;
            let niche = self.proposer.domain.niche(&candidate.genome);
            if self.map.get(&niche).is_none_or(|old| is_better(&one.score, &old.score)) {
                let (genome, score) = (candidate.genome.clone(), one.score.clone());
                let elite = Elite { id: candidate.id, genome, score, polished: candidate.goal.is_some() };
                self.map.insert(niche, elite);
            }
        }
    }

    fn tally(&self) -> &Tally {
        self.proposer.tally()
    }

    fn elites(&self) -> Option<&BTreeMap<Niche, Elite<D::Genome>>> {
        Some(&self.map)
    }
}

/// An elite polished for the first goal.
fn polished<D: Domain>(domain: &D, (id, genome): &(u64, D::Genome), tally: &mut Tally) -> Option<Draft<D::Genome>> {
    let operator = Operator::POLISH;
    match domain.polish(genome, &domain.express(genome), 0) {
        Some(genome) => Some(Draft { genome, operator, arms: Vec::new(), goal: Some(0), parents: vec![*id] }),
        None => {
            tally.missed(operator);
            None
        }
    }
}

/// A child of elites drawn alike: by one to three moves, or by crossover.
fn child<D: Domain>(
    domain: &D,
    elites: &[&Elite<D::Genome>],
    rng: &mut ChaCha8Rng,
    tally: &mut Tally,
) -> Option<Draft<D::Genome>> {
    let any = |rng: &mut ChaCha8Rng| elites[rng.random_range(0..elites.len())];
    let a = any(rng);
    let all: f64 = domain.arms().iter().map(|arm| arm.weight).sum();
    let crossing: f64 = domain.arms().iter().filter(|arm| arm.parents > 1).map(|arm| arm.weight).sum();
    if crossing > 0.0 && rng.random_bool(crossing / all) {
        let (arm, b) = (draw_arm(domain.arms(), 2, rng)?, any(rng));
        let operator = domain.arms()[arm].operator;
        let Some(genome) = domain.vary(arm, [&a.genome, &b.genome], rng) else {
            tally.missed(operator);
            return None;
        };
        return Some(Draft { genome, operator, arms: vec![arm], goal: None, parents: vec![a.id, b.id] });
    }
    let steps = [1, 1, 1, 2, 3][rng.random_range(0..5usize)];
    let one_move = |rng: &mut ChaCha8Rng| draw_arm(domain.arms(), 1, rng).unwrap_or(0);
    mutate(domain, (&a.genome, a.id), steps, &one_move, rng, tally)
}
