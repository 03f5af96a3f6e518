//! Why not: which constraint binds, how near the front is to each, and what asking for less would give.

mod tables;
mod words;

use houscaper::score::{Bound, Demand, Evaluation};
use houscaper::search::dominates;
use houscaper::search::hypervolume::hypervolume;
use houscaper::search::knee::normalised;
use houscaper::search::massing::{Design, encode};
use rayon::prelude::*;

use super::record::{Record, natural};
use super::results::FrontHouse;
use super::{Found, Job};

pub use tables::write;
pub use words::{infeasible_words, report, words};

/// Houses near the front that are looked at, those of the least violation.
const NEAR: usize = 200;

/// Room, as a share of the limit, within which a constraint is active.
pub const ACTIVE: f64 = 0.02;

/// Objectives up to which the hypervolume that a relaxation gives is worked out: it grows too dear beyond.
const MOST_OBJECTIVES: usize = 4;

/// Shares of its limit by which a constraint is relaxed.
pub const RELAXED: [f64; 3] = [0.01, 0.05, 0.1];

/// A house that would stand in the front but for its constraints.
pub struct NearHouse {
    /// Index of its evaluation.
    pub id: u64,
    /// Its evaluation.
    pub evaluation: Evaluation,
    /// Objectives, minimised.
    pub objectives: Vec<f64>,
    /// Every constraint.
    pub bounds: Vec<Bound>,
    /// The house of the front that is nearest to it, by its place there; `None` when nothing is feasible.
    pub beside: Option<usize>,
}

impl NearHouse {
    /// The constraints it breaks, the most broken first.
    pub fn broken(&self) -> Vec<&Bound> {
        let mut broken: Vec<&Bound> = self.bounds.iter().filter(|b| b.violation > 0.0).collect();
        broken.sort_by(|a, b| b.violation.total_cmp(&a.violation));
        broken
    }
}

/// What is known of one constraint.
pub struct Row {
    /// Its key, side and limit.
    pub bound: Bound,
    /// Houses of the even sample of infeasible ones that break it.
    pub broken: usize,
    /// The least of their violations; infinite when none breaks it.
    pub least_miss: f64,
    /// Near houses that break it.
    pub near: usize,
    /// Near houses that break nothing else.
    pub alone: usize,
    /// Hypervolume that those add which miss it by at most each of [`RELAXED`], as a share of the front's.
    pub gain: Option<[f64; 3]>,
    /// Houses of the front within [`ACTIVE`] of the limit.
    pub active: usize,
    /// The least room in the front; NaN without a front.
    pub room: f64,
}

/// Why not.
pub struct WhyNot {
    /// Every constraint of the brief.
    pub rows: Vec<Row>,
    /// Houses of the even sample.
    pub sampled: usize,
    /// Infeasible evaluations.
    pub infeasible: u64,
    /// Houses that would stand in the front but for their constraints.
    pub near: Vec<NearHouse>,
}

/// Evaluates what the run kept of its infeasible houses once more, for each constraint by itself.
pub fn why_not(job: &Job, found: &Found, record: &Record, front: &[FrontHouse]) -> WhyNot {
    let look = |design: &Design| {
        let house = encode(&design.massing, &job.space.plot);
        let evaluation = job.evaluator.evaluate(&house, &design.choices);
        let bounds = job.evaluator.bounds(&house, &design.choices, &evaluation);
        (evaluation, bounds)
    };
    let kept = &record.faults;
    let sample: Vec<Vec<Bound>> = kept.sample.items().par_iter().map(|design| look(design).1).collect();
    let objectives = job.evaluator.brief.objectives.len();
    let would_enter = |o: &[f64]| !front.iter().any(|h| dominates(&h.objectives, o) || h.objectives == o);
    let mut entries = kept.near.entries();
    entries.retain(|e| would_enter(&e.objectives[..objectives]));
    entries.sort_by(|a, b| a.objectives[objectives].total_cmp(&b.objectives[objectives]).then(a.id.cmp(&b.id)));
    entries.truncate(NEAR);
    let near: Vec<NearHouse> = entries
        .into_par_iter()
        .map(|e| {
            let (evaluation, bounds) = look(&e.item);
            let objectives = e.objectives[..objectives].to_vec();
            let beside = beside(front, &objectives);
            NearHouse { id: e.id, evaluation, objectives, bounds, beside }
        })
        .collect();
    let along: Vec<Vec<Bound>> =
        front.par_iter().map(|h| job.evaluator.bounds(&h.house, &h.design.choices, &h.evaluation)).collect();
    let rows = rows(found, front, &sample, &near, &along);
    WhyNot { rows, sampled: sample.len(), infeasible: kept.sample.offered(), near }
}

fn rows(
    found: &Found,
    front: &[FrontHouse],
    sample: &[Vec<Bound>],
    near: &[NearHouse],
    along: &[Vec<Bound>],
) -> Vec<Row> {
    let Some(all) = along.first().or(sample.first()) else { return Vec::new() };
    let volume = Volume::new(found, front);
    let one = |(n, bound): (usize, &Bound)| {
        let misses: Vec<f64> = sample.iter().map(|bounds| bounds[n].violation).filter(|v| *v > 0.0).collect();
        let breaking = near.iter().filter(|h| h.bounds[n].violation > 0.0);
        let alone: Vec<&NearHouse> = breaking.clone().filter(|h| h.broken().len() == 1).collect();
        // What is kept or not has no room.
        let has_room = !["rules", "structure.stands"].contains(&bound.key.as_str());
        let rooms: Vec<f64> = along.iter().filter(|_| has_room).map(|bounds| bounds[n].room()).collect();
        let gain = |volume: &Volume| {
            RELAXED.map(|by| volume.gained(alone.iter().filter(|h| h.bounds[n].violation <= by).map(|h| &h.objectives)))
        };
        Row {
            bound: Bound { value: f64::NAN, violation: 0.0, ..bound.clone() },
            broken: misses.len(),
            least_miss: misses.into_iter().fold(f64::INFINITY, f64::min),
            near: breaking.count(),
            alone: alone.len(),
            gain: volume.as_ref().filter(|_| bound.demand == Demand::Brief).map(gain),
            active: rooms.iter().filter(|r| **r <= ACTIVE).count(),
            room: rooms.into_iter().fold(f64::NAN, f64::min),
        }
    };
    all.iter().enumerate().map(one).collect()
}

/// The hypervolume of a front, and what other houses would add.
struct Volume<'a> {
    points: Vec<&'a [f64]>,
    reference: &'a [f64],
    whole: f64,
}

impl<'a> Volume<'a> {
    fn new(found: &'a Found, front: &'a [FrontHouse]) -> Option<Volume<'a>> {
        let reference = found.reference.as_deref().filter(|r| r.len() <= MOST_OBJECTIVES)?;
        let points: Vec<&[f64]> = front.iter().map(|h| h.objectives.as_slice()).collect();
        let whole = hypervolume(&points, reference);
        (whole > 0.0).then_some(Volume { points, reference, whole })
    }

    fn gained<'h>(&'h self, houses: impl Iterator<Item = &'h Vec<f64>>) -> f64 {
        let with: Vec<&[f64]> = self.points.iter().map(|p| &p[..]).chain(houses.map(|h| &h[..])).collect();
        if with.len() == self.points.len() { 0.0 } else { hypervolume(&with, self.reference) / self.whole - 1.0 }
    }
}

/// The house of the front that is nearest in objectives over its range.
fn beside(front: &[FrontHouse], objectives: &[f64]) -> Option<usize> {
    let points: Vec<&[f64]> = front.iter().map(|h| h.objectives.as_slice()).chain([objectives]).collect();
    let scaled = normalised(&points);
    let own = scaled.last()?;
    let apart = |i: usize| scaled[i].iter().zip(own).map(|(a, b)| (a - b).powi(2)).sum::<f64>();
    (0..front.len()).min_by(|&a, &b| apart(a).total_cmp(&apart(b)))
}

/// By how many percent each objective of a house differs from the nearest one of the front.
pub fn differences(job: &Job, house: &NearHouse, front: &[FrontHouse]) -> Vec<f64> {
    let Some(beside) = house.beside else { return vec![f64::NAN; house.objectives.len()] };
    let (own, other) = (natural(job, &house.objectives), natural(job, &front[beside].objectives));
    own.into_iter().zip(other).map(|(a, b)| 100.0 * (a - b) / b.abs().max(f64::MIN_POSITIVE)).collect()
}
