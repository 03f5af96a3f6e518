//! Hill climbing from many starts: what moves alone can do, each climber for itself along its own weighting of the objectives.

use super::Score;
use super::domain::Domain;
use super::evolution::draw_arm;
use super::nsga3::das_dennis;
use super::proposal::{CandidateOf, EvaluatedOf, Place, Proposer, Tally, mutate, start_draft};
use super::run::Searcher;
use rand_chacha::ChaCha8Rng;

/// Steps without a gain before a climber starts over.
const PATIENCE: u32 = 60;
/// Least weight of an objective, so that none is ignored.
const LEAST_WEIGHT: f64 = 0.02;

/// First-improvement climbers, one place of the batch each.
pub struct HillClimber<'a, D: Domain> {
    proposer: Proposer<'a, D>,
    climbers: Vec<Climber<D::Genome>>,
    /// Best and worst feasible values seen, for the weighting.
    range: Vec<[f64; 2]>,
}

struct Climber<G> {
    weights: Vec<f64>,
    at: Option<(u64, G, Score)>,
    idle: u32,
}

impl<'a, D: Domain> HillClimber<'a, D> {
    /// `climbers` climbers over a domain with so many objectives; each batch is a step of all.
    pub fn new(domain: &'a D, seed: u64, objectives: usize, climbers: usize) -> Self {
        // As many divisions of the weights as give every climber one of its own.
        let weights = (1..).map(|p| das_dennis(objectives.max(1), p)).find(|w| w.len() >= climbers || objectives < 2);
        let weights = weights.unwrap_or_default();
        let climber = |i: usize| {
            let even = weights[i * weights.len() / climbers.max(1)].iter().map(|w| w.max(LEAST_WEIGHT)).collect();
            Climber { weights: even, at: None, idle: 0 }
        };
        let climbers = (0..climbers.max(1)).map(climber).collect();
        HillClimber { proposer: Proposer::new(domain, seed), climbers, range: Vec::new() }
    }
}

impl<D: Domain> Searcher<D> for HillClimber<'_, D> {
    fn ask(&mut self, most: usize) -> Vec<CandidateOf<D>> {
        let (climbers, domain) = (&self.climbers, self.proposer.domain);
        let draw = |place: Place, rng: &mut ChaCha8Rng, tally: &mut Tally| {
            let Some((id, genome, _)) = &climbers[place.index % climbers.len()].at else {
                return start_draft(domain, rng, tally);
            };
            let one_move = |rng: &mut ChaCha8Rng| draw_arm(domain.arms(), 1, rng).unwrap_or(0);
            mutate(domain, (genome, *id), 1, &one_move, rng, tally)
        };
        self.proposer.propose(climbers.len().min(most), &draw)
    }

    fn tell(&mut self, evaluated: &[EvaluatedOf<D>]) {
        for one in evaluated.iter().filter(|e| e.score.is_feasible()) {
            let values = &one.score.objectives;
            if self.range.is_empty() {
                self.range = values.iter().map(|&v| [v, v]).collect();
            }
            self.range.iter_mut().zip(values).for_each(|(r, &v)| *r = [r[0].min(v), r[1].max(v)]);
        }
        for one in evaluated {
            let (c, range) = (&one.candidate, &self.range);
            // A climber knows its child by the parent; a start goes to the first climber without a place.
            let climber = match c.parents.first() {
                Some(parent) => self.climbers.iter_mut().find(|k| k.at.as_ref().is_some_and(|a| a.0 == *parent)),
                None => self.climbers.iter_mut().find(|k| k.at.is_none()),
            };
            let Some(climber) = climber else { continue };
            let better = climber.at.as_ref().is_none_or(|(_, _, score)| {
                cost(&one.score, &climber.weights, range) < cost(score, &climber.weights, range)
            });
            if better {
                climber.at = Some((c.id, c.genome.clone(), one.score.clone()));
                climber.idle = 0;
            } else {
                climber.idle += 1;
            }
        }
        self.climbers.iter_mut().filter(|c| c.idle >= PATIENCE).for_each(|c| (c.at, c.idle) = (None, 0));
    }

    fn tally(&self) -> &Tally {
        self.proposer.tally()
    }
}

/// Weighted sum over the ranges seen; an infeasible design costs more than any feasible one, and its violation.
fn cost(score: &Score, weights: &[f64], range: &[[f64; 2]]) -> f64 {
    if !score.is_feasible() {
        return 1e3 + if score.violation.is_nan() { f64::INFINITY } else { score.violation.max(0.0) };
    }
    let scaled = |(v, [low, high]): (&f64, &[f64; 2])| if high > low { (v - low) / (high - low) } else { 0.0 };
    score.objectives.iter().zip(range).map(scaled).zip(weights).map(|(v, w)| v * w).sum()
}
