//! The default search: a steady state in small fixed batches around an archive.
//!
//! A batch is drawn from one state (chances of the operators, pool of parents) and told back as a whole, so that neither the number of
//! threads nor the order in which evaluations end can change a result. Between batches, in index order: the pool takes the children in
//! ([`pool`]), operators are credited with what their children added ([`arms`]), and a search that no longer gains starts over with a new
//! pool beside the archive.
//!
//! A child is screened: where bounds that need no solve show that a member of the pool's front is nowhere worse, it could enter neither
//! that front nor the archive, and it is drawn again without an evaluation. It is measured against the pool and not the archive, so that a
//! pool that starts over may pass through what the archive already beats; starts are never asked.
//!
//! Measured on the starter brief by hypervolume of the archive at 2,000 and 3,000 evaluations with five seeds, ten for the polishing
//! (`cargo bench --bench quality`); the other briefs were run with the settings kept alone. What was tried and made no difference beyond the spread of the seeds: batches of 16 instead of 32; 20 or 80 % of single steps instead of 50;
//! operators by their weights alone, or almost by success alone; polishing infeasible designs that would enter the archive instead of the
//! pool's. What lost: a pool of 200, a tenth of new starts for ever, twice as many polished designs (at the same evaluations).

pub mod arms;
mod children;
pub mod pool;

use super::archive::Archive;
use super::contribution::{MOST_BY_VOLUME, exclusive};
use super::domain::Domain;
use super::hypervolume::reference_point;
use super::proposal::{CandidateOf, EvaluatedOf, Place, Proposer, Tally, start_draft};
use super::run::Searcher;
use arms::Chances;
use children::{child, graft, polished};
use pool::{Parent, Pool};
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;

/// Settings of the steady state.
#[derive(Clone, Debug, PartialEq)]
pub struct Settings {
    /// Children per batch.
    pub batch: usize,
    /// Parents kept.
    pub pool: usize,
    /// Evaluations at the beginning, and after a restart, that are starts.
    pub starts: usize,
    /// Share of starts that take over what the best designs have learnt, once there are any.
    pub grafts: f64,
    /// Share of children that are new starts for ever.
    pub immigrants: f64,
    /// Share of designs that are polished ([`Domain::polish`]).
    pub polish: f64,
    /// Share of those that are infeasible, where there are any that would enter the archive if they were not.
    pub hopeful: f64,
    /// Share of children that are one step from a member of the front (Pareto local search); the others may take several.
    pub local: f64,
    /// Whether children whose bounds a member of the front reaches are spared their evaluation.
    pub screen: bool,
    /// Share of operators drawn by their own weights, whatever their success.
    pub floor: f64,
    /// Weight of one new child in the mean success of its operator.
    pub rate: f64,
    /// Evaluations without a gain worth naming after which the pool starts over.
    pub patience: u64,
}

impl Default for Settings {
    fn default() -> Self {
        Settings {
            batch: 32,
            pool: 50,
            starts: 64,
            grafts: 0.5,
            immigrants: 0.02,
            polish: 0.05,
            hopeful: 0.5,
            local: 0.5,
            screen: true,
            floor: 0.4,
            rate: 0.02,
            patience: 3000,
        }
    }
}

/// A gain in hypervolume that counts as one, relative to what the archive has.
const GAIN: f64 = 1e-4;
/// Infeasible designs kept to be polished.
const MOST_HOPEFUL: usize = 64;
/// Stream of the draws that are made once for a batch; candidates have the streams from 0 on.
const BATCH_STREAM: u64 = 1 << 63;

/// The searcher.
pub struct Steady<'a, D: Domain> {
    settings: Settings,
    seed: u64,
    proposer: Proposer<'a, D>,
    archive: Archive<()>,
    pool: Pool<D::Genome>,
    chances: Chances,
    /// Evaluations since the first, or since the last restart.
    age: u64,
    /// Evaluations since the last gain.
    idle: u64,
    /// Least violation so far: what counts as a gain while nothing is feasible.
    least: f64,
    /// Infeasible designs that no entry of the archive covers, latest last: polishing may make them what is looked for.
    hopeful: Vec<Parent<D::Genome>>,
    /// The pool before the search started over, until both are put together again.
    aside: Vec<Parent<D::Genome>>,
    /// Polished designs owed: grows by the share of each batch.
    owed: f64,
    batches: u64,
    restarts: u64,
}

impl<'a, D: Domain> Steady<'a, D> {
    /// A searcher over a domain.
    pub fn new(domain: &'a D, seed: u64, settings: Settings) -> Self {
        let chances = Chances::new(domain.arms(), settings.floor, settings.rate);
        Steady {
            seed,
            proposer: Proposer::new(domain, seed),
            archive: Archive::new(),
            pool: Pool::new(settings.pool),
            chances,
            age: 0,
            idle: 0,
            least: f64::INFINITY,
            hopeful: Vec::new(),
            aside: Vec::new(),
            owed: 0.0,
            batches: 0,
            restarts: 0,
            settings: Settings { batch: settings.batch.max(1), ..settings },
        }
    }

    /// The chances of the operators as they are now.
    pub fn chances(&self) -> &Chances {
        &self.chances
    }

    /// Times the pool started over.
    pub fn restarts(&self) -> u64 {
        self.restarts
    }

    /// Designs to be polished in this batch, each with its goal; marked, so that none is polished twice.
    fn targets(&mut self, batch: usize) -> Vec<(Parent<D::Genome>, usize)> {
        let goals = self.proposer.domain.goals().min(32);
        self.owed = (self.owed + self.settings.polish * batch as f64).min(batch as f64);
        let mut rng = ChaCha8Rng::seed_from_u64(self.seed);
        rng.set_stream(BATCH_STREAM + self.batches);
        let mut out = Vec::new();
        let archive = &self.archive;
        self.hopeful.retain(|p| !archive.covers(&p.score.objectives));
        while self.owed >= 1.0 && goals > 0 {
            let hopeful = rng.random_bool(self.settings.hopeful.clamp(0.0, 1.0));
            let (elite, parents) = (self.pool.elite(), self.pool.parents_mut());
            let target = match hopeful {
                true => take_open(&mut self.hopeful, goals, &mut rng),
                false => None,
            };
            let target = target
                .or_else(|| take_open(&mut parents[..elite], goals, &mut rng))
                .or_else(|| take_open(parents, goals, &mut rng));
            let Some(target) = target else { break };
            // A design may be among the hopeful and in the pool.
            let same = self.hopeful.iter_mut().chain(self.pool.parents_mut()).filter(|p| p.id == target.0.id);
            same.for_each(|p| p.polished |= target.0.polished);
            out.push(target);
            self.owed -= 1.0;
        }
        out
    }

    /// Sets the pool aside and begins a new one from starts; where one is aside already, puts the two together instead. So a search that
    /// gains no more looks elsewhere half of the time, undisturbed by what it already has.
    fn start_over(&mut self) {
        self.idle = 0;
        if self.aside.is_empty() {
            self.aside = self.pool.take();
            self.age = 0;
            self.restarts += 1;
        } else {
            let aside = std::mem::take(&mut self.aside);
            self.pool.update(aside.into_iter());
        }
    }

    /// Takes a batch into the archive, credits the operators whose children entered, and returns what the children added to the
    /// hypervolume of the front in the pool, relative to the box that it spans.
    fn credit(&mut self, evaluated: &[EvaluatedOf<D>]) -> f64 {
        let elite: Vec<&[f64]> =
            self.pool.parents()[..self.pool.elite()].iter().map(|p| p.score.objectives.as_slice()).collect();
        let reference = reference_point(elite.iter().copied());
        let mut gain = 0.0;
        let mut credits = vec![0.0; evaluated.len()];
        for (one, credit) in evaluated.iter().zip(&mut credits) {
            if !self.archive.offer(one.candidate.id, &one.score, || ()) {
                continue;
            }
            *credit = 1.0;
            gain += match &reference {
                Some(reference) if reference.len() <= MOST_BY_VOLUME => {
                    let low = |m: usize| elite.iter().map(|p| p[m]).fold(f64::INFINITY, f64::min);
                    let whole: f64 = (0..reference.len()).map(|m| reference[m] - low(m)).product();
                    exclusive(&one.score.objectives, elite.iter().copied(), reference) / whole
                }
                _ => 1.0,
            };
        }
        let children = evaluated.iter().zip(credits).map(|(e, c)| (e.candidate.arms.as_slice(), c));
        self.chances.learn(children.filter(|(arms, _)| !arms.is_empty()));
        gain
    }
}

impl<D: Domain> Searcher<D> for Steady<'_, D> {
    fn ask(&mut self, most: usize) -> Vec<CandidateOf<D>> {
        let batch = self.settings.batch.min(most);
        let targets = self.targets(batch);
        let Steady { settings, pool, chances, proposer, age, .. } = self;
        let (parents, elite, domain) = (pool.parents(), pool.elite(), proposer.domain);
        let starting = *age < settings.starts as u64 || parents.len() < 2;
        let draw = |place: Place, rng: &mut ChaCha8Rng, tally: &mut Tally| {
            if place.tries == 0
                && let Some((parent, goal)) = targets.get(place.index)
            {
                return polished(domain, parent, *goal, tally);
            }
            if starting || rng.random_bool(settings.immigrants.clamp(0.0, 1.0)) {
                let start = start_draft(domain, rng, tally)?;
                let grafted = elite > 0 && rng.random_bool(settings.grafts.clamp(0.0, 1.0));
                return Some(if grafted { graft(domain, start, &parents[rng.random_range(0..elite)]) } else { start });
            }
            child(domain, settings, chances, parents, elite, rng, tally)
        };
        let front = &parents[..elite];
        let beaten = |bounds: &[f64]| front.iter().any(|p| p.score.objectives.iter().zip(bounds).all(|(a, b)| a <= b));
        proposer.propose_unbeaten(batch, &draw, if settings.screen { Some(&beaten) } else { None })
    }

    fn tell(&mut self, evaluated: &[EvaluatedOf<D>]) {
        self.batches += 1;
        self.age += evaluated.len() as u64;
        let gain = self.credit(evaluated);
        let least = evaluated.iter().map(|e| e.score.violation).fold(self.least, f64::min);
        let gains = gain > GAIN || self.pool.elite() == 0 && least < self.least;
        self.idle = if gains { 0 } else { self.idle + evaluated.len() as u64 };
        self.least = least;
        for one in evaluated {
            for id in &one.candidate.parents {
                if let Some(parent) = self.pool.parents_mut().iter_mut().find(|p| p.id == *id) {
                    parent.children += 1;
                }
            }
        }
        let parent = |e: &EvaluatedOf<D>| Parent {
            id: e.candidate.id,
            genome: e.candidate.genome.clone(),
            score: e.score.clone(),
            rank: 0,
            worth: 0.0,
            children: 0,
            polished: e.candidate.goal.map_or(0, |goal| 1 << goal),
        };
        let known = |e: &&EvaluatedOf<D>| {
            let objectives = &e.score.objectives;
            !e.score.is_feasible() && !objectives.is_empty() && objectives.iter().all(|v| v.is_finite())
        };
        if self.proposer.domain.goals() > 0 {
            self.hopeful.extend(evaluated.iter().filter(known).filter(|e| e.candidate.goal.is_none()).map(parent));
            let excess = self.hopeful.len().saturating_sub(MOST_HOPEFUL);
            self.hopeful.drain(..excess);
        }
        self.pool.update(evaluated.iter().map(parent));
        if self.idle >= self.settings.patience {
            self.start_over();
        }
    }

    fn tally(&self) -> &Tally {
        self.proposer.tally()
    }
}

/// One of some parents that is not polished for every goal, with a goal that is left; marked as polished for it.
fn take_open<G: Clone>(parents: &mut [Parent<G>], goals: usize, rng: &mut ChaCha8Rng) -> Option<(Parent<G>, usize)> {
    let open: Vec<usize> = (0..parents.len()).filter(|&i| parents[i].polished.count_ones() < goals as u32).collect();
    let parent = &mut parents[*open.get(rng.random_range(0..open.len().max(1)))?];
    let left: Vec<usize> = (0..goals).filter(|g| parent.polished >> g & 1 == 0).collect();
    let goal = *left.get(rng.random_range(0..left.len().max(1)))?;
    parent.polished |= 1 << goal;
    Some((parent.clone(), goal))
}
