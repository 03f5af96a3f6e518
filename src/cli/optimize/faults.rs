//! What a run keeps of the houses that break a constraint.

use houscaper::search::Score;
use houscaper::search::archive::Archive;
use houscaper::search::massing::Design;

/// Violation up to which a house nearly keeps its constraints: a tenth of what was asked.
pub const NEARLY: f64 = 0.1;

/// Houses of the even sample at most.
const SAMPLE: usize = 256;

/// Infeasible houses: those that nearly kept everything and were good at it, and an even sample of all.
#[derive(Default)]
pub struct Faults {
    /// Those of a violation up to [`NEARLY`] that no other such house beats in every objective and in violation (the last number of
    /// each vector).
    pub near: Archive<Design>,
    /// Every so many-th of all.
    pub sample: Vec<(u64, Design)>,
    /// Infeasible evaluations.
    pub count: u64,
    every: u64,
}

impl Faults {
    /// Takes an infeasible evaluation in, in index order.
    pub fn add(&mut self, id: u64, score: &Score, design: &Design) {
        self.every = self.every.max(1);
        if score.violation <= NEARLY && !score.objectives.is_empty() {
            let objectives = score.objectives.iter().copied().chain([score.violation]).collect();
            self.near.offer(id, &Score { objectives, violation: 0.0 }, || design.clone());
        }
        if self.count.is_multiple_of(self.every) {
            self.sample.push((id, design.clone()));
        }
        self.count += 1;
        if self.sample.len() > SAMPLE {
            let mut keep = false;
            self.sample.retain(|_| {
                keep = !keep;
                keep
            });
            self.every *= 2;
        }
    }
}
