//! The generational searches: a population, a batch of children, and the best of both survive. Who is best is what tells NSGA-II from
//! NSGA-III.

use super::Score;
use super::domain::{Arm, Domain, Operator};
use super::nsga3::Niches;
use super::proposal::{CandidateOf, Draft, EvaluatedOf, Place, Proposer, Tally, mutate, start_draft};
use super::run::Searcher;
use super::sorting::{crowding, sort_fronts};
use rand::RngExt;
use rand_chacha::ChaCha8Rng;

/// Settings of a generational search.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Settings {
    /// Individuals kept from batch to batch (mu).
    pub population: usize,
    /// Children per batch (lambda).
    pub offspring: usize,
    /// Probability that a child has two parents.
    pub crossover: f64,
    /// Probability that a child of two parents also takes a move.
    pub mutation: f64,
    /// Moves of a child of one parent: drawn from these.
    pub moves: [usize; 5],
    /// Probability that a child is its parent polished ([`Domain::polish`]), where there is something to polish.
    pub polish: f64,
}

impl Default for Settings {
    fn default() -> Self {
        Settings {
            population: 100,
            offspring: 100,
            crossover: 0.3,
            mutation: 0.5,
            moves: [1, 1, 1, 2, 3],
            polish: 0.05,
        }
    }
}

/// Who survives.
#[derive(Clone, Debug)]
enum Survival {
    /// By front, then crowding distance (Deb et al. 2002).
    Crowding,
    /// By front, then niches around reference directions (Deb, Jain 2014).
    Niches(Niches),
}

/// The searcher.
pub struct Evolution<'a, D: Domain> {
    settings: Settings,
    survival: Survival,
    proposer: Proposer<'a, D>,
    population: Vec<Individual<D::Genome>>,
}

/// A member of the population, ordered best first.
#[derive(Clone, Debug)]
struct Individual<G> {
    id: u64,
    genome: G,
    score: Score,
    /// Goals for which it was polished, or is the result of that: bit g for goal g.
    polished: u32,
    rank: usize,
    crowding: f64,
}

impl<G> Individual<G> {
    /// Crowded comparison: the lower front first, then the emptier neighbourhood (the same for all where niches decide).
    fn beats(&self, other: &Self) -> bool {
        self.rank < other.rank || self.rank == other.rank && self.crowding > other.crowding
    }
}

impl<'a, D: Domain> Evolution<'a, D> {
    /// NSGA-II (Deb, Pratap, Agarwal, Meyarivan 2002) with constraint domination.
    pub fn nsga2(domain: &'a D, seed: u64, settings: Settings) -> Self {
        Evolution::new(domain, seed, settings, Survival::Crowding)
    }

    /// NSGA-III (Deb, Jain 2014; constraints: Jain, Deb 2014) with about as many reference directions as the population has members.
    pub fn nsga3(domain: &'a D, seed: u64, objectives: usize, settings: Settings) -> Self {
        let niches = Niches::new(objectives, settings.population);
        Evolution::new(domain, seed, settings, Survival::Niches(niches))
    }

    fn new(domain: &'a D, seed: u64, settings: Settings, survival: Survival) -> Self {
        let settings =
            Settings { population: settings.population.max(1), offspring: settings.offspring.max(1), ..settings };
        Evolution { settings, survival, proposer: Proposer::new(domain, seed), population: Vec::new() }
    }

    /// The scores of the population.
    pub fn population(&self) -> impl Iterator<Item = &Score> {
        self.population.iter().map(|i| &i.score)
    }
}

impl<D: Domain> Searcher<D> for Evolution<'_, D> {
    fn ask(&mut self, most: usize) -> Vec<CandidateOf<D>> {
        let (population, settings, domain) = (&self.population, self.settings, self.proposer.domain);
        let filling = population.len() < settings.population;
        let batch = if filling { settings.population } else { settings.offspring };
        let polishing = domain.goals() > 0 && settings.polish > 0.0;
        let draw = |_: Place, rng: &mut ChaCha8Rng, tally: &mut Tally| {
            let polish = polishing && rng.random_bool(settings.polish.min(1.0));
            // Starts first; where they run out before the population is full, children of what there is join them.
            if population.is_empty() || filling && rng.random_bool(0.5) {
                let draft = start_draft(domain, rng, tally)?;
                return Some(if polish { polished_start(domain, draft, rng) } else { draft });
            }
            match polish {
                true => polished(domain, population, rng, tally),
                false => child(domain, population, settings, rng, tally),
            }
        };
        self.proposer.propose(batch.min(most), &draw)
    }

    fn tell(&mut self, evaluated: &[EvaluatedOf<D>]) {
        let new = evaluated.iter().map(|e| Individual {
            id: e.candidate.id,
            genome: e.candidate.genome.clone(),
            score: e.score.clone(),
            polished: e.candidate.goal.map_or(0, |goal| 1 << goal.min(31)),
            rank: 0,
            crowding: 0.0,
        });
        let mut all: Vec<Individual<D::Genome>> = std::mem::take(&mut self.population);
        for parent in evaluated.iter().filter(|e| e.candidate.goal.is_some()) {
            let (id, goal) = (parent.candidate.parents.first(), parent.candidate.goal.unwrap_or(0));
            all.iter_mut().filter(|i| Some(&i.id) == id).for_each(|i| i.polished |= 1 << goal.min(31));
        }
        all.extend(new);
        self.population = match &mut self.survival {
            Survival::Crowding => by_crowding(all, self.settings.population),
            Survival::Niches(niches) => by_niches(all, niches, self.settings.population),
        };
    }

    fn tally(&self) -> &Tally {
        self.proposer.tally()
    }
}

/// The better of two random individuals.
fn tournament<'p, G>(population: &'p [Individual<G>], rng: &mut ChaCha8Rng) -> &'p Individual<G> {
    let (a, b) = (rng.random_range(0..population.len()), rng.random_range(0..population.len()));
    if population[b].beats(&population[a]) { &population[b] } else { &population[a] }
}

/// A parent polished for a goal that it was not polished for yet.
fn polished<D: Domain>(
    domain: &D,
    population: &[Individual<D::Genome>],
    rng: &mut ChaCha8Rng,
    tally: &mut Tally,
) -> Option<Draft<D::Genome>> {
    let parent = tournament(population, rng);
    let goal = rng.random_range(0..domain.goals());
    if parent.polished >> goal.min(31) & 1 == 1 {
        return None;
    }
    let genome = domain.polish(&parent.genome, &domain.express(&parent.genome), goal);
    if genome.is_none() {
        tally.missed(Operator::POLISH);
    }
    let (operator, arms, parents) = (Operator::POLISH, Vec::new(), vec![parent.id]);
    Some(Draft { genome: genome?, operator, arms, goal: Some(goal), parents })
}

/// A start polished; as it is where that cannot be done.
fn polished_start<D: Domain>(domain: &D, draft: Draft<D::Genome>, rng: &mut ChaCha8Rng) -> Draft<D::Genome> {
    let goal = rng.random_range(0..domain.goals());
    match domain.polish(&draft.genome, &domain.express(&draft.genome), goal) {
        Some(genome) => Draft { genome, operator: Operator::POLISH, goal: Some(goal), ..draft },
        None => draft,
    }
}

/// Draws an arm with `parents` parents by weight.
pub(super) fn draw_arm(arms: &[Arm], parents: usize, rng: &mut ChaCha8Rng) -> Option<usize> {
    let total: f64 = arms.iter().filter(|a| a.parents == parents).map(|a| a.weight).sum();
    let mut at = rng.random::<f64>() * total;
    let mut last = None;
    for (i, arm) in arms.iter().enumerate().filter(|(_, a)| a.parents == parents) {
        last = Some(i);
        at -= arm.weight;
        if at < 0.0 {
            break;
        }
    }
    last
}

/// A child of one parent by one or more moves, or of two by crossover.
fn child<D: Domain>(
    domain: &D,
    population: &[Individual<D::Genome>],
    settings: Settings,
    rng: &mut ChaCha8Rng,
    tally: &mut Tally,
) -> Option<Draft<D::Genome>> {
    let a = tournament(population, rng);
    let one_move = |rng: &mut ChaCha8Rng| draw_arm(domain.arms(), 1, rng).unwrap_or(0);
    let moves = settings.moves[rng.random_range(0..settings.moves.len())];
    let crossing =
        if rng.random_bool(settings.crossover.clamp(0.0, 1.0)) { draw_arm(domain.arms(), 2, rng) } else { None };
    let Some(arm) = crossing else {
        return mutate(domain, (&a.genome, a.id), moves, &one_move, rng, tally);
    };
    let b = tournament(population, rng);
    let operator = domain.arms()[arm].operator;
    let Some(crossed) = domain.vary(arm, [&a.genome, &b.genome], rng) else {
        tally.missed(operator);
        return None;
    };
    let mutates = rng.random_bool(settings.mutation.clamp(0.0, 1.0));
    let mutated = if mutates { mutate(domain, (&crossed, a.id), 1, &one_move, rng, tally) } else { None };
    let genome = mutated.map_or(crossed, |m| m.genome);
    Some(Draft { genome, operator, arms: vec![arm], goal: None, parents: vec![a.id, b.id] })
}

/// The best `count`: whole fronts while they fit, then the least crowded of the next. Order by (rank, crowding, id).
fn by_crowding<G>(mut all: Vec<Individual<G>>, count: usize) -> Vec<Individual<G>> {
    let scores: Vec<&Score> = all.iter().map(|i| &i.score).collect();
    let marks: Vec<(usize, usize, f64)> = sort_fronts(&scores)
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
    all.sort_by(|a, b| a.rank.cmp(&b.rank).then(b.crowding.total_cmp(&a.crowding)).then(a.id.cmp(&b.id)));
    all.truncate(count);
    all
}

/// The best `count`: whole fronts while they fit, then by niches of the next. Parents are then drawn at random, but for violation.
fn by_niches<G>(all: Vec<Individual<G>>, niches: &mut Niches, count: usize) -> Vec<Individual<G>> {
    let scores: Vec<&Score> = all.iter().map(|i| &i.score).collect();
    let kept = niches.survivors(&scores, count);
    let mut all: Vec<Option<Individual<G>>> = all.into_iter().map(Some).collect();
    let mut feasible = 0;
    let mut out: Vec<Individual<G>> = kept.iter().filter_map(|&i| all[i].take()).collect();
    for (place, one) in out.iter_mut().enumerate() {
        one.crowding = 0.0;
        // Feasible ones are equals; the others come after them, the least violation first.
        one.rank = if one.score.is_feasible() { 0 } else { 1 + place };
        feasible += usize::from(one.score.is_feasible());
    }
    debug_assert!(feasible <= count);
    out
}
