//! How children are made: of one parent by moves, of two by crossover, of a start by grafting, and by polishing.

use super::Settings;
use super::arms::Chances;
use super::pool::Parent;
use crate::search::domain::{Domain, Operator};
use crate::search::proposal::{Draft, Tally, mutate};
use rand::RngExt;
use rand_chacha::ChaCha8Rng;

/// Front members among which the one to search around is picked.
const TOURNAMENT: usize = 3;

/// A design polished for a goal.
pub(super) fn polished<D: Domain>(
    domain: &D,
    parent: &Parent<D::Genome>,
    goal: usize,
    tally: &mut Tally,
) -> Option<Draft<D::Genome>> {
    let operator = Operator::POLISH;
    match domain.polish(&parent.genome, &domain.express(&parent.genome), goal) {
        Some(genome) => Some(Draft { genome, operator, arms: Vec::new(), goal: Some(goal), parents: vec![parent.id] }),
        None => {
            tally.missed(operator);
            None
        }
    }
}

/// A start with what a design of the front has learnt; as it is where nothing can be taken over.
pub(super) fn graft<D: Domain>(domain: &D, start: Draft<D::Genome>, donor: &Parent<D::Genome>) -> Draft<D::Genome> {
    match domain.graft(&start.genome, &donor.genome) {
        Some(genome) => Draft { genome, operator: Operator::GRAFT, parents: vec![donor.id], ..start },
        None => start,
    }
}

/// A child of the pool: one step from the front, or several, or a crossover.
pub(super) fn child<D: Domain>(
    domain: &D,
    settings: &Settings,
    chances: &Chances,
    parents: &[Parent<D::Genome>],
    elite: usize,
    rng: &mut ChaCha8Rng,
    tally: &mut Tally,
) -> Option<Draft<D::Genome>> {
    let local = elite > 0 && rng.random_bool(settings.local.clamp(0.0, 1.0));
    let a = if local { explore(&parents[..elite], rng) } else { better(parents, rng) };
    let arm = chances.draw(false, rng);
    let arm_of = domain.arms().get(arm)?;
    if arm_of.parents < 2 {
        let steps = if local { 1 } else { [1, 1, 1, 2, 3][rng.random_range(0..5usize)] };
        let first = std::cell::Cell::new(Some(arm));
        let draw = |rng: &mut ChaCha8Rng| first.take().unwrap_or_else(|| chances.draw(true, rng));
        return mutate(domain, (&a.genome, a.id), steps, &draw, rng, tally);
    }
    let b = better(parents, rng);
    let Some(crossed) = domain.vary(arm, [&a.genome, &b.genome], rng) else {
        tally.missed(arm_of.operator);
        return None;
    };
    let one_move = |rng: &mut ChaCha8Rng| chances.draw(true, rng);
    let mutated = if rng.random_bool(0.5) { mutate(domain, (&crossed, a.id), 1, &one_move, rng, tally) } else { None };
    let genome = mutated.map_or(crossed, |m| m.genome);
    Some(Draft { genome, operator: arm_of.operator, arms: vec![arm], goal: None, parents: vec![a.id, b.id] })
}

/// The member of the front, of a few drawn, that is worth most for the children it already has.
fn explore<'p, G>(front: &'p [Parent<G>], rng: &mut ChaCha8Rng) -> &'p Parent<G> {
    let merit = |p: &Parent<G>| (0.1 + p.worth) / f64::from(1 + p.children);
    let mut best = &front[rng.random_range(0..front.len())];
    for _ in 1..TOURNAMENT {
        let other = &front[rng.random_range(0..front.len())];
        if merit(other) > merit(best) {
            best = other;
        }
    }
    best
}

/// The better of two parents: the pool is in order.
fn better<'p, G>(parents: &'p [Parent<G>], rng: &mut ChaCha8Rng) -> &'p Parent<G> {
    let (a, b) = (rng.random_range(0..parents.len()), rng.random_range(0..parents.len()));
    &parents[a.min(b)]
}
