//! NSGA-II (Deb, Pratap, Agarwal, Meyarivan 2002) with constraint domination, in fixed batches.

use super::crossover::crossover;
use super::massing::{Design, encode};
use super::proposal::{Candidate, Draft, Evaluated, Operator, Proposer, RuleCheck, Size, Tally, mutate, start_draft};
use super::run::Searcher;
use super::{Score, plot::Space};
use rand::RngExt;
use rand_chacha::ChaCha8Rng;

/// Settings of NSGA-II.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Settings {
    /// Individuals kept from batch to batch (mu).
    pub population: usize,
    /// Children per batch (lambda).
    pub offspring: usize,
    /// Probability that a child has two parents.
    pub crossover: f64,
    /// Probability that a child is its parent with the sections sized, and that a start is sized, where sizing is given.
    pub sizing: f64,
}

impl Default for Settings {
    fn default() -> Self {
        Settings { population: 100, offspring: 100, crossover: 0.3, sizing: 0.05 }
    }
}

/// The searcher.
pub struct Nsga2<'a> {
    settings: Settings,
    proposer: Proposer<'a>,
    size: Option<&'a Size<'a>>,
    population: Vec<Individual>,
}

#[derive(Clone, Debug)]
struct Individual {
    evaluated: Evaluated,
    rank: usize,
    crowding: f64,
}

impl Individual {
    /// Crowded comparison: the lower front first, then the emptier neighbourhood.
    fn beats(&self, other: &Individual) -> bool {
        self.rank < other.rank || self.rank == other.rank && self.crowding > other.crowding
    }
}

impl<'a> Nsga2<'a> {
    /// A searcher over `space`; every candidate passes `rules` before it is proposed.
    pub fn new(space: &'a Space, seed: u64, settings: Settings, rules: Option<&'a RuleCheck<'a>>) -> Self {
        let settings =
            Settings { population: settings.population.max(1), offspring: settings.offspring.max(1), ..settings };
        Nsga2 { settings, proposer: Proposer::new(space, seed, rules), size: None, population: Vec::new() }
    }

    /// Lets children and starts be sized.
    pub fn sized_by(mut self, size: &'a Size<'a>) -> Self {
        self.size = Some(size);
        self
    }
}

impl Searcher for Nsga2<'_> {
    fn ask(&mut self, most: usize) -> Vec<Candidate> {
        let (population, settings, space) = (&self.population, self.settings, self.proposer.space);
        let size = self.size.filter(|_| settings.sizing > 0.0);
        let batch = if population.len() < settings.population { settings.population } else { settings.offspring };
        let filling = population.len() < settings.population;
        let draw = |rng: &mut ChaCha8Rng, tally: &mut Tally| {
            // Starts first; where they run out before the population is full, children of what there is join them.
            if population.is_empty() || filling && rng.random_bool(0.5) {
                let draft = start_draft(space, rng, tally).ok()?;
                match size.filter(|_| rng.random_bool(settings.sizing.min(1.0))) {
                    Some(size) => Some(sized_start(draft, size, space, rng)),
                    None => Some(draft),
                }
            } else if let Some(size) = size.filter(|_| rng.random_bool(settings.sizing.min(1.0))) {
                sized(population, size, rng, tally)
            } else {
                child(population, settings, space, rng, tally)
            }
        };
        self.proposer.propose(batch.min(most), &draw)
    }

    fn tell(&mut self, evaluated: &[Evaluated]) {
        let new = evaluated.iter().map(|e| Individual { evaluated: e.clone(), rank: 0, crowding: 0.0 });
        let mut all: Vec<Individual> = std::mem::take(&mut self.population);
        all.extend(new);
        self.population = survivors(all, self.settings.population);
    }

    fn tally(&self) -> &Tally {
        self.proposer.tally()
    }
}

/// The better of two random individuals.
fn tournament<'p>(population: &'p [Individual], rng: &mut ChaCha8Rng) -> &'p Individual {
    let (a, b) = (rng.random_range(0..population.len()), rng.random_range(0..population.len()));
    if population[b].beats(&population[a]) { &population[b] } else { &population[a] }
}

/// A parent with its sections sized.
fn sized(population: &[Individual], size: &Size, rng: &mut ChaCha8Rng, tally: &mut Tally) -> Option<Draft> {
    let parent = &tournament(population, rng).evaluated.candidate;
    let choices = size(&parent.house, &parent.design.choices, rng.random()).filter(|c| *c != parent.design.choices);
    let Some(choices) = choices else {
        tally.missed(Operator::Sizing);
        return None;
    };
    let design = Design { choices, ..parent.design.clone() };
    Some(Draft { design, operator: Operator::Sizing, parents: vec![parent.id] })
}

/// A start with its sections sized; as it is where that cannot be done.
fn sized_start(mut draft: Draft, size: &Size, space: &Space, rng: &mut ChaCha8Rng) -> Draft {
    let house = encode(&draft.design.massing, &space.plot);
    if let Some(choices) = size(&house, &draft.design.choices, rng.random()) {
        draft.design.choices = choices;
    }
    draft
}

fn child(
    population: &[Individual],
    settings: Settings,
    space: &Space,
    rng: &mut ChaCha8Rng,
    tally: &mut Tally,
) -> Option<Draft> {
    let a = &tournament(population, rng).evaluated.candidate;
    let moves = [1, 1, 1, 2, 3][rng.random_range(0..5usize)];
    if !rng.random_bool(settings.crossover.clamp(0.0, 1.0)) {
        let (design, last) = mutate(&a.design, moves, space, rng, tally)?;
        return Some(Draft { design, operator: Operator::Move(last), parents: vec![a.id] });
    }
    let b = &tournament(population, rng).evaluated.candidate;
    let Some(crossed) = crossover(&a.design, &b.design, space, rng) else {
        tally.missed(Operator::Crossover);
        return None;
    };
    let mutated = if rng.random_bool(0.5) { mutate(&crossed, 1, space, rng, tally) } else { None };
    let design = mutated.map_or(crossed, |m| m.0);
    Some(Draft { design, operator: Operator::Crossover, parents: vec![a.id, b.id] })
}

/// The best `count` individuals: whole fronts while they fit, then the least crowded of the next. Order by (rank, id).
fn survivors(mut all: Vec<Individual>, count: usize) -> Vec<Individual> {
    let scores: Vec<&Score> = all.iter().map(|i| &i.evaluated.score).collect();
    let fronts = sort_fronts(&scores);
    let marks: Vec<(usize, usize, f64)> = fronts
        .iter()
        .enumerate()
        .flat_map(|(rank, front)| {
            let crowding = crowding(&front.iter().map(|&i| scores[i]).collect::<Vec<_>>());
            front.iter().zip(crowding).map(move |(&i, c)| (i, rank, c)).collect::<Vec<_>>()
        })
        .collect();
    for (i, rank, crowding) in marks {
        all[i].rank = rank;
        all[i].crowding = crowding;
    }
    let id = |i: &Individual| i.evaluated.candidate.id;
    all.sort_by(|a, b| a.rank.cmp(&b.rank).then(b.crowding.total_cmp(&a.crowding)).then(id(a).cmp(&id(b))));
    all.truncate(count);
    all
}

/// Fast non-dominated sort under constraint domination: indices front by front, ascending within a front.
pub fn sort_fronts(scores: &[&Score]) -> Vec<Vec<usize>> {
    let n = scores.len();
    let mut beaten_by = vec![0usize; n];
    let mut beats: Vec<Vec<usize>> = vec![Vec::new(); n];
    for i in 0..n {
        for j in 0..i {
            if scores[i].dominates(scores[j]) {
                beats[i].push(j);
                beaten_by[j] += 1;
            } else if scores[j].dominates(scores[i]) {
                beats[j].push(i);
                beaten_by[i] += 1;
            }
        }
    }
    let mut fronts = Vec::new();
    let mut front: Vec<usize> = (0..n).filter(|&i| beaten_by[i] == 0).collect();
    while !front.is_empty() {
        let mut next = Vec::new();
        for &i in &front {
            for &j in &beats[i] {
                beaten_by[j] -= 1;
                if beaten_by[j] == 0 {
                    next.push(j);
                }
            }
        }
        next.sort_unstable();
        fronts.push(std::mem::replace(&mut front, next));
    }
    fronts
}

/// Crowding distance within one front: the normalised side lengths of the box between neighbours, infinite at the ends.
/// Entries without objectives have none.
pub fn crowding(front: &[&Score]) -> Vec<f64> {
    let mut distance = vec![0.0; front.len()];
    let objectives = front.iter().map(|s| s.objectives.len()).min().unwrap_or(0);
    let mut order: Vec<usize> = (0..front.len()).collect();
    for m in 0..objectives {
        let value = |i: usize| front[i].objectives[m];
        order.sort_by(|&a, &b| value(a).total_cmp(&value(b)).then(a.cmp(&b)));
        let (first, last) = (order[0], order[order.len() - 1]);
        let range = value(last) - value(first);
        distance[first] = f64::INFINITY;
        distance[last] = f64::INFINITY;
        if range > 0.0 {
            order.windows(3).for_each(|w| distance[w[1]] += (value(w[2]) - value(w[0])) / range);
        }
    }
    distance
}
