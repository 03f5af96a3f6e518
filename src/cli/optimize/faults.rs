//! What a run keeps of the houses that break a constraint.

use houscaper::search::Score;
use houscaper::search::archive::Archive;
use houscaper::search::massing::Design;

use super::even::EvenSample;

/// Violation up to which a house nearly keeps its constraints: a tenth of what was asked.
pub const NEARLY: f64 = 0.1;

/// Houses of the even sample at most.
const SAMPLE: usize = 256;

/// Infeasible houses: those that nearly kept everything and were good at it, and an even sample of all.
pub struct Faults {
    /// Those of a violation up to [`NEARLY`] that no other such house beats in every objective and in violation (the last number of
    /// each vector).
    pub near: Archive<Design>,
    /// Of all of them.
    pub sample: EvenSample<Design>,
}

impl Default for Faults {
    fn default() -> Self {
        Faults { near: Archive::default(), sample: EvenSample::new(SAMPLE) }
    }
}

impl Faults {
    /// Takes an infeasible evaluation in, in index order.
    pub fn add(&mut self, id: u64, score: &Score, design: &Design) {
        if score.violation <= NEARLY && !score.objectives.is_empty() {
            let objectives = score.objectives.iter().copied().chain([score.violation]).collect();
            self.near.offer(id, &Score { objectives, violation: 0.0 }, || design.clone());
        }
        self.sample.offer(|| design.clone());
    }
}
