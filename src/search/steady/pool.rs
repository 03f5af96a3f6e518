//! The pool: a bounded set of parents, the best of everything evaluated so far.
//!
//! Where the front is smaller than the pool, what comes next under constraint domination fills it, so that near-feasible and dominated
//! designs stay as stepping stones. Where it is larger, the points that add least to the hypervolume leave it (no crowding distance:
//! for three and more objectives it says little of who is needed).

use crate::search::contribution::without_least;
use crate::search::hypervolume::reference_point;
use crate::search::sorting::sort_fronts;
use crate::search::{Score, dominates};

/// A parent.
#[derive(Clone, Debug)]
pub struct Parent<G> {
    /// Its evaluation.
    pub id: u64,
    /// Its genome.
    pub genome: G,
    /// Its score.
    pub score: Score,
    /// Front under constraint domination, 0 = none in the pool is better.
    pub rank: usize,
    /// What it adds to the hypervolume of its front, relative to the most that one adds.
    pub worth: f64,
    /// Children evaluated so far.
    pub children: u32,
    /// Goals for which it was polished, or is the result of that: bit g for goal g.
    pub polished: u32,
}

impl<G> Parent<G> {
    /// Whether it is feasible and undominated.
    pub fn is_elite(&self) -> bool {
        self.rank == 0 && self.score.is_feasible()
    }
}

/// Parents, best first.
#[derive(Clone, Debug)]
pub struct Pool<G> {
    parents: Vec<Parent<G>>,
    capacity: usize,
}

impl<G> Pool<G> {
    /// An empty pool for `capacity` parents, at least 2.
    pub fn new(capacity: usize) -> Self {
        Pool { parents: Vec::new(), capacity: capacity.max(2) }
    }

    /// The parents, best first: by rank, then worth, then id.
    pub fn parents(&self) -> &[Parent<G>] {
        &self.parents
    }

    /// The same, to be marked.
    pub fn parents_mut(&mut self) -> &mut [Parent<G>] {
        &mut self.parents
    }

    /// Number of feasible undominated ones, which come first.
    pub fn elite(&self) -> usize {
        self.parents.iter().take_while(|p| p.is_elite()).count()
    }

    /// Takes newcomers in and lets the least leave. Of designs with equal scores the first stays.
    pub fn update(&mut self, newcomers: impl Iterator<Item = Parent<G>>) {
        for new in newcomers {
            if self.parents.iter().all(|p| p.score != new.score) {
                self.parents.push(new);
            }
        }
        let scores: Vec<&Score> = self.parents.iter().map(|p| &p.score).collect();
        let mut kept: Vec<(usize, usize, f64)> = Vec::with_capacity(self.capacity);
        for (rank, front) in sort_fronts(&scores).into_iter().enumerate() {
            let room = self.capacity - kept.len();
            if room == 0 {
                break;
            }
            kept.extend(worth(&scores, &front, room).into_iter().map(|(i, worth)| (i, rank, worth)));
        }
        let mut old: Vec<Option<Parent<G>>> = std::mem::take(&mut self.parents).into_iter().map(Some).collect();
        for (i, rank, worth) in kept {
            self.parents.extend(old[i].take().map(|p| Parent { rank, worth, ..p }));
        }
        self.parents.sort_by(|a, b| a.rank.cmp(&b.rank).then(b.worth.total_cmp(&a.worth)).then(a.id.cmp(&b.id)));
    }

    /// Empties the pool and returns who was in it.
    pub fn take(&mut self) -> Vec<Parent<G>> {
        std::mem::take(&mut self.parents)
    }
}

/// At most `room` members of a front with what they are worth, relative to the best of them.
fn worth(scores: &[&Score], front: &[usize], room: usize) -> Vec<(usize, f64)> {
    let points: Vec<&[f64]> = front.iter().map(|&i| scores[i].objectives.as_slice()).collect();
    if front.iter().any(|&i| !scores[i].is_feasible()) {
        return front.iter().take(room).map(|&i| (i, 0.0)).collect();
    }
    let Some(reference) = reference_point(points.iter().copied()) else { return Vec::new() };
    debug_assert!(points.iter().all(|a| points.iter().all(|b| !dominates(a, b))));
    let kept = without_least(&points, &reference, room);
    let most = kept.iter().map(|k| k.1).filter(|w| w.is_finite()).fold(0.0, f64::max);
    kept.into_iter().map(|(i, w)| (front[i], if most > 0.0 { (w / most).min(1.0) } else { 1.0 })).collect()
}
