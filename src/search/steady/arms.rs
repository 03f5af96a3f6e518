//! Which operator next: probability matching on recent success (Goldberg 1990; Thierens 2005), with a floor.

use crate::search::domain::Arm;
use rand::RngExt;
use rand_chacha::ChaCha8Rng;

/// Chances of the arms of a domain, adapted between batches.
#[derive(Clone, Debug, PartialEq)]
pub struct Chances {
    arms: Vec<Arm>,
    /// Recent mean credit of a child, per arm.
    quality: Vec<f64>,
    chances: Vec<f64>,
    floor: f64,
    rate: f64,
}

impl Chances {
    /// Chances by the arms' own weights. `floor` is the share that always goes by them, `rate` the weight of a new child against the
    /// mean of those before.
    pub fn new(arms: &[Arm], floor: f64, rate: f64) -> Self {
        let mut out = Chances {
            arms: arms.to_vec(),
            quality: vec![0.0; arms.len()],
            chances: Vec::new(),
            floor: floor.clamp(0.0, 1.0),
            rate: rate.clamp(0.0, 1.0),
        };
        out.match_quality();
        out
    }

    /// Learns from a batch: for each child its arms and its credit, 0 or more.
    pub fn learn<'c>(&mut self, children: impl Iterator<Item = (&'c [usize], f64)>) {
        let mut sums = vec![(0.0, 0.0); self.arms.len()];
        for (arms, credit) in children {
            for &arm in arms {
                sums[arm].0 += credit / arms.len() as f64;
                sums[arm].1 += 1.0 / arms.len() as f64;
            }
        }
        for (quality, (credit, uses)) in self.quality.iter_mut().zip(sums) {
            if uses > 0.0 {
                *quality += (1.0 - (1.0 - self.rate).powf(uses)) * (credit / uses - *quality);
            }
        }
        self.match_quality();
    }

    fn match_quality(&mut self) {
        let weights: f64 = self.arms.iter().map(|a| a.weight).sum();
        let total: f64 = self.quality.iter().sum();
        let floor = if total > 0.0 { self.floor } else { 1.0 };
        let matched = |q: f64| if total > 0.0 { (1.0 - floor) * q / total } else { 0.0 };
        self.chances =
            self.arms.iter().zip(&self.quality).map(|(a, &q)| floor * a.weight / weights + matched(q)).collect();
    }

    /// Draws an arm; of those with one parent only where `moves` says so.
    pub fn draw(&self, moves: bool, rng: &mut ChaCha8Rng) -> usize {
        let chance = |i: usize| if moves && self.arms[i].parents > 1 { 0.0 } else { self.chances[i] };
        let total: f64 = (0..self.arms.len()).map(chance).sum();
        let mut at = rng.random::<f64>() * total;
        for i in 0..self.arms.len() {
            at -= chance(i);
            if at < 0.0 {
                return i;
            }
        }
        // Rounding: the last arm that has a chance.
        (0..self.arms.len()).rev().find(|&i| chance(i) > 0.0).unwrap_or(0)
    }

    /// The chance of each arm, in their order; they sum to 1.
    pub fn chances(&self) -> &[f64] {
        &self.chances
    }
}
