//! The loop: ask for a batch, score it in parallel, commit it in index order, tell.

use super::Score;
use super::archive::Archive;
use super::contribution::exclusive;
use super::domain::Domain;
use super::elites::Elite;
use super::hypervolume::{REFERENCE_SAMPLE, hypervolume, reference_point};
use super::niche::Niche;
use super::proposal::{CandidateOf, Evaluated, EvaluatedOf, Tally};
use rayon::prelude::*;
use std::collections::BTreeMap;
use std::ops::ControlFlow;
use std::time::{Duration, Instant};

/// Proposes candidates and learns from their scores.
pub trait Searcher<D: Domain> {
    /// At most `most` new candidates, ids ascending; none when there is nothing new to offer.
    fn ask(&mut self, most: usize) -> Vec<CandidateOf<D>>;
    /// The scores of the candidates asked for last, in the same order.
    fn tell(&mut self, evaluated: &[EvaluatedOf<D>]);
    /// What was drawn so far.
    fn tally(&self) -> &Tally;
    /// The best design of each kind, where the search keeps a map of them.
    fn elites(&self) -> Option<&BTreeMap<Niche, Elite<D::Genome>>> {
        None
    }
}

/// Where a run stands after a batch.
#[derive(Clone, Debug, PartialEq)]
pub struct Progress {
    /// Evaluations done.
    pub evaluations: u64,
    /// Evaluations planned.
    pub planned: u64,
    /// Feasible ones among those done.
    pub feasible: u64,
    /// Entries of the archive.
    pub front: usize,
    /// Hypervolume of the archive, once the reference point is fixed.
    pub hypervolume: Option<f64>,
    /// Volume of the box between the reference point and the best values of the sample it was taken from; `None` while there
    /// is no reference point, or when the caller gave it.
    pub box_volume: Option<f64>,
    /// Time since the start.
    pub elapsed: Duration,
}

impl Progress {
    /// Evaluations a second.
    pub fn rate(&self) -> f64 {
        self.evaluations as f64 / self.elapsed.as_secs_f64().max(1e-9)
    }

    /// Hypervolume as a share of the box that the first feasible evaluations span: a number near 1 that grows with the front.
    pub fn relative_hypervolume(&self) -> Option<f64> {
        Some(self.hypervolume? / self.box_volume?)
    }
}

/// Limits of a run.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Limits {
    /// Evaluations at most.
    pub evaluations: u64,
    /// Reference point of the hypervolume, minimised sense; from the first feasible evaluations when `None`.
    pub reference: Option<Vec<f64>>,
    /// Evaluations without a gain of hypervolume worth naming ([`GAIN`]) after which the run ends; never when `None`.
    pub stagnation: Option<u64>,
}

/// The gain that ends a stagnation, relative to the hypervolume there was.
pub const GAIN: f64 = 1e-3;

/// Why a run ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stop {
    /// All evaluations are done.
    Done,
    /// The caller asked to stop.
    Interrupted,
    /// No new design was found in a whole batch.
    Exhausted,
    /// The hypervolume gained nothing worth naming for as long as the limits allow.
    Stagnated,
}

/// Where the scores of a batch come from.
pub trait Scorer<D: Domain> {
    /// How many candidates to ask for at most, of those that are left.
    fn most(&mut self, left: u64) -> u64 {
        left
    }

    /// The scores of a batch, in its order; `None` ends the run before the batch.
    fn score(&mut self, batch: &[CandidateOf<D>]) -> Option<Vec<Score>>;
}

/// Scores candidates here, in parallel.
pub struct Here<'e, D: Domain>(pub &'e (dyn Fn(&D::Genome, &D::Form) -> Score + Sync));

impl<D: Domain> Scorer<D> for Here<'_, D> {
    fn score(&mut self, batch: &[CandidateOf<D>]) -> Option<Vec<Score>> {
        Some(batch.par_iter().map(|c| (self.0)(&c.genome, &c.form)).collect())
    }
}

/// What a run ends with.
#[derive(Clone, Debug)]
pub struct Outcome<G> {
    /// All feasible non-dominated designs.
    pub archive: Archive<G>,
    /// The reference point, `None` when nothing was feasible.
    pub reference: Option<Vec<f64>>,
    /// Where the run ended.
    pub progress: Progress,
    /// Hypervolume after each batch from the fixing of the reference point on: (evaluations, hypervolume).
    pub history: Vec<(u64, f64)>,
    /// Why it ended.
    pub stop: Stop,
}

/// Runs a searcher: `evaluate` scores a design (called in parallel), `sink` sees each evaluation in index order,
/// `progress` is called after each batch and may break off.
///
/// Nothing but the times in [`Progress`] depends on the clock or on the number of threads.
pub fn run<D: Domain, S: Searcher<D> + ?Sized>(
    searcher: &mut S,
    evaluate: &(dyn Fn(&D::Genome, &D::Form) -> Score + Sync),
    limits: &Limits,
    sink: &mut dyn FnMut(&EvaluatedOf<D>),
    progress: &mut dyn FnMut(&Progress) -> ControlFlow<()>,
) -> Outcome<D::Genome> {
    run_scored(searcher, &mut Here(evaluate), limits, sink, progress)
}

/// The same with scores from anywhere, such as the record of an earlier run.
pub fn run_scored<D: Domain, S: Searcher<D> + ?Sized>(
    searcher: &mut S,
    scorer: &mut dyn Scorer<D>,
    limits: &Limits,
    sink: &mut dyn FnMut(&EvaluatedOf<D>),
    progress: &mut dyn FnMut(&Progress) -> ControlFlow<()>,
) -> Outcome<D::Genome> {
    let started = Instant::now();
    let mut ledger = Ledger::new(limits);
    let stop = loop {
        let left = limits.evaluations.saturating_sub(ledger.progress.evaluations);
        if left == 0 {
            break Stop::Done;
        }
        if ledger.has_stagnated() {
            break Stop::Stagnated;
        }
        let batch = searcher.ask(scorer.most(left).min(left).min(usize::MAX as u64) as usize);
        if batch.is_empty() {
            break Stop::Exhausted;
        }
        let Some(scores) = scorer.score(&batch) else { break Stop::Interrupted };
        let pair = |(candidate, score)| Evaluated { candidate, score };
        let evaluated: Vec<EvaluatedOf<D>> = batch.into_iter().zip(scores).map(pair).collect();
        for one in &evaluated {
            ledger.commit(one.candidate.id, &one.candidate.genome, &one.score);
            sink(one);
        }
        searcher.tell(&evaluated);
        ledger.measure(started.elapsed());
        if progress(&ledger.progress).is_break() {
            break Stop::Interrupted;
        }
    };
    ledger.finish(stop, started.elapsed())
}

/// What a run knows of its evaluations, fed in index order: archive, reference point, hypervolume.
pub struct Ledger<G> {
    archive: Archive<G>,
    /// Feasible objective vectors until the reference point is fixed.
    sample: Vec<Vec<f64>>,
    reference: Option<Vec<f64>>,
    progress: Progress,
    history: Vec<(u64, f64)>,
    stagnation: Option<u64>,
    /// Evaluations and hypervolume at the last gain worth naming.
    gained: (u64, f64),
}

impl<G: Clone> Ledger<G> {
    /// Nothing evaluated yet.
    pub fn new(limits: &Limits) -> Self {
        let progress = Progress {
            evaluations: 0,
            planned: limits.evaluations,
            feasible: 0,
            front: 0,
            hypervolume: limits.reference.as_ref().map(|_| 0.0),
            box_volume: None,
            elapsed: Duration::ZERO,
        };
        let reference = limits.reference.clone();
        Ledger {
            archive: Archive::new(),
            sample: Vec::new(),
            reference,
            progress,
            history: Vec::new(),
            stagnation: limits.stagnation,
            gained: (0, 0.0),
        }
    }

    /// Takes the next evaluation in.
    pub fn commit(&mut self, id: u64, genome: &G, score: &Score) {
        self.progress.evaluations += 1;
        self.progress.feasible += u64::from(score.is_feasible());
        if score.is_feasible() && !self.archive.covers(&score.objectives) {
            if let (Some(reference), Some(volume)) = (&self.reference, &mut self.progress.hypervolume) {
                let others = self.archive.iter().map(|e| e.objectives.as_slice());
                *volume += exclusive(&score.objectives, others, reference);
            }
            self.archive.offer(id, score, || genome.clone());
        }
        if self.reference.is_none() && score.is_feasible() {
            self.sample.push(score.objectives.clone());
            if self.sample.len() == REFERENCE_SAMPLE {
                self.fix_reference();
            }
        }
    }

    fn fix_reference(&mut self) {
        self.reference = reference_point(self.sample.iter().map(Vec::as_slice));
        self.progress.box_volume = self.reference.as_deref().map(|reference| box_volume(reference, &self.sample));
        self.progress.hypervolume = self.reference.as_deref().map(|r| hypervolume(&self.archive.points(), r));
        self.sample = Vec::new();
    }

    fn has_stagnated(&self) -> bool {
        let idle = self.progress.evaluations - self.gained.0;
        self.progress.hypervolume.is_some() && self.stagnation.is_some_and(|most| idle >= most)
    }

    /// Closes a batch.
    pub fn measure(&mut self, elapsed: Duration) {
        self.progress.elapsed = elapsed;
        self.progress.front = self.archive.len();
        if let Some(volume) = self.progress.hypervolume
            && self.history.last().is_none_or(|h| h.0 < self.progress.evaluations)
        {
            self.history.push((self.progress.evaluations, volume));
            if volume > self.gained.1 * (1.0 + GAIN) {
                self.gained = (self.progress.evaluations, volume);
            }
        }
    }

    /// A run that ends before its reference point is fixed takes it from what was feasible.
    pub fn finish(mut self, stop: Stop, elapsed: Duration) -> Outcome<G> {
        if self.reference.is_none() {
            self.fix_reference();
        }
        self.measure(elapsed);
        let Ledger { archive, reference, progress, history, .. } = self;
        Outcome { archive, reference, progress, history, stop }
    }
}

/// Volume between a reference point and the best value of each objective in a sample.
fn box_volume(reference: &[f64], sample: &[Vec<f64>]) -> f64 {
    let best = |m: usize| sample.iter().map(|p| p[m]).fold(f64::INFINITY, f64::min);
    reference.iter().enumerate().map(|(m, r)| r - best(m)).product()
}
