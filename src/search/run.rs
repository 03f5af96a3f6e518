//! The loop: ask for a batch, score it in parallel, commit it in index order, tell.

use super::Score;
use super::archive::Archive;
use super::hypervolume::{REFERENCE_SAMPLE, hypervolume, reference_point};
use super::massing::Design;
use super::proposal::{Candidate, Evaluated, Tally};
use crate::voxels::{Choices, House};
use rayon::prelude::*;
use std::ops::ControlFlow;
use std::time::{Duration, Instant};

/// Proposes candidates and learns from their scores.
pub trait Searcher {
    /// At most `most` new candidates, ids ascending; none when the space is exhausted.
    fn ask(&mut self, most: usize) -> Vec<Candidate>;
    /// The scores of the candidates asked for last, in the same order.
    fn tell(&mut self, evaluated: &[Evaluated]);
    /// What was drawn so far.
    fn tally(&self) -> &Tally;
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
}

/// Why a run ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stop {
    /// All evaluations are done.
    Done,
    /// The caller asked to stop.
    Interrupted,
    /// No new design was found in a whole batch.
    Exhausted,
}

/// What a run ends with.
#[derive(Clone, Debug)]
pub struct Outcome {
    /// All feasible non-dominated designs.
    pub archive: Archive<Design>,
    /// The reference point, `None` when nothing was feasible.
    pub reference: Option<Vec<f64>>,
    /// Where the run ended.
    pub progress: Progress,
    /// Hypervolume after each batch from the fixing of the reference point on: (evaluations, hypervolume).
    pub history: Vec<(u64, f64)>,
    /// Why it ended.
    pub stop: Stop,
}

/// Runs a searcher: `evaluate` scores a house (called in parallel), `sink` sees each evaluation in index order,
/// `progress` is called after each batch and may break off.
///
/// Nothing but the times in [`Progress`] depends on the clock or on the number of threads.
pub fn run<S: Searcher + ?Sized>(
    searcher: &mut S,
    evaluate: &(dyn Fn(&House, &Choices) -> Score + Sync),
    limits: &Limits,
    sink: &mut dyn FnMut(&Evaluated),
    progress: &mut dyn FnMut(&Progress) -> ControlFlow<()>,
) -> Outcome {
    let started = Instant::now();
    let mut state = State::new(limits);
    let stop = loop {
        let left = limits.evaluations.saturating_sub(state.progress.evaluations);
        if left == 0 {
            break Stop::Done;
        }
        let batch = searcher.ask(left.min(usize::MAX as u64) as usize);
        if batch.is_empty() {
            break Stop::Exhausted;
        }
        let score = |candidate: Candidate| {
            let score = evaluate(&candidate.house, &candidate.design.choices);
            Evaluated { candidate, score }
        };
        let evaluated: Vec<Evaluated> = batch.into_par_iter().map(score).collect();
        for one in &evaluated {
            state.commit(one);
            sink(one);
        }
        searcher.tell(&evaluated);
        state.measure(started.elapsed());
        if progress(&state.progress).is_break() {
            break Stop::Interrupted;
        }
    };
    state.finish(stop, started.elapsed())
}

struct State {
    archive: Archive<Design>,
    /// Feasible objective vectors until the reference point is fixed.
    sample: Vec<Vec<f64>>,
    reference: Option<Vec<f64>>,
    progress: Progress,
    history: Vec<(u64, f64)>,
}

impl State {
    fn new(limits: &Limits) -> Self {
        let progress = Progress {
            evaluations: 0,
            planned: limits.evaluations,
            feasible: 0,
            front: 0,
            hypervolume: None,
            box_volume: None,
            elapsed: Duration::ZERO,
        };
        let reference = limits.reference.clone();
        State { archive: Archive::new(), sample: Vec::new(), reference, progress, history: Vec::new() }
    }

    fn commit(&mut self, one: &Evaluated) {
        self.progress.evaluations += 1;
        self.progress.feasible += u64::from(one.score.is_feasible());
        if self.reference.is_none() && one.score.is_feasible() {
            self.sample.push(one.score.objectives.clone());
            if self.sample.len() == REFERENCE_SAMPLE {
                self.fix_reference();
            }
        }
        self.archive.offer(one.candidate.id, &one.score, || one.candidate.design.clone());
    }

    fn fix_reference(&mut self) {
        self.reference = reference_point(self.sample.iter().map(Vec::as_slice));
        self.progress.box_volume = self.reference.as_deref().map(|reference| box_volume(reference, &self.sample));
        self.sample = Vec::new();
    }

    fn measure(&mut self, elapsed: Duration) {
        self.progress.elapsed = elapsed;
        self.progress.front = self.archive.len();
        if let Some(reference) = &self.reference {
            let volume = hypervolume(&self.archive.points(), reference);
            self.progress.hypervolume = Some(volume);
            if self.history.last().is_none_or(|h| h.0 < self.progress.evaluations) {
                self.history.push((self.progress.evaluations, volume));
            }
        }
    }

    /// A run that ends before its reference point is fixed takes it from what was feasible.
    fn finish(mut self, stop: Stop, elapsed: Duration) -> Outcome {
        if self.reference.is_none() {
            self.fix_reference();
        }
        self.measure(elapsed);
        let State { archive, reference, progress, history, .. } = self;
        Outcome { archive, reference, progress, history, stop }
    }
}

/// Volume between a reference point and the best value of each objective in a sample.
fn box_volume(reference: &[f64], sample: &[Vec<f64>]) -> f64 {
    let best = |m: usize| sample.iter().map(|p| p[m]).fold(f64::INFINITY, f64::min);
    reference.iter().enumerate().map(|(m, r)| r - best(m)).product()
}
