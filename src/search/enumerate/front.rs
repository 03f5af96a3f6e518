//! The front of a whole space: every design evaluated.

use super::{Shapes, designs_of};
use crate::search::Score;
use crate::search::archive::Archive;
use crate::search::hypervolume::{hypervolume, reference_point};
use crate::search::massing::{Design, encode};
use crate::search::plot::Space;
use crate::search::symmetry::Symmetry;
use crate::voxels::House;
use rayon::prelude::*;

/// Shapes evaluated at a time.
const CHUNK: usize = 64;

/// What evaluating every design of a space tells.
#[derive(Clone, Debug)]
pub struct Truth {
    /// Designs evaluated.
    pub designs: u64,
    /// Those that keep all constraints.
    pub feasible: u64,
    /// Content hash of the designs: the sum of their identities modulo 2^128, so that it does not depend on their order.
    pub hash: u128,
    /// The front: identities and designs.
    pub front: Archive<(u128, Design)>,
    /// Per objective the worst value on the front and a tenth of the front's range more; `None` when nothing is feasible.
    pub reference: Option<Vec<f64>>,
    /// Hypervolume of the front up to the reference.
    pub hypervolume: f64,
}

/// Counts and hashes the designs of some shapes, without evaluating them.
pub fn count(shapes: &[Design], space: &Space) -> (u64, u128) {
    let symmetries = Symmetry::of(&space.plot);
    let of = |shape: &Design| {
        let designs = designs_of(shape, space, &symmetries);
        (designs.len() as u64, designs.iter().fold(0u128, |sum, d| sum.wrapping_add(d.0)))
    };
    shapes.par_iter().map(of).reduce(|| (0, 0), |a, b| (a.0 + b.0, a.1.wrapping_add(b.1)))
}

/// Evaluates every design of the shapes of a space, in parallel; `progress` is told how many are done.
pub fn front(
    shapes: &Shapes,
    space: &Space,
    evaluate: &(dyn Fn(&Design, &House) -> Score + Sync),
    progress: &mut dyn FnMut(u64),
) -> Truth {
    let symmetries = Symmetry::of(&space.plot);
    let mut truth =
        Truth { designs: 0, feasible: 0, hash: 0, front: Archive::new(), reference: None, hypervolume: 0.0 };
    for chunk in shapes.designs.chunks(CHUNK) {
        let of = |shape: &Design| -> Vec<(u128, Design, Score)> {
            let house = encode(&shape.massing, &space.plot);
            let score = |(key, design): (u128, Design)| {
                let score = evaluate(&design, &house);
                (key, design, score)
            };
            designs_of(shape, space, &symmetries).into_iter().map(score).collect()
        };
        let scored: Vec<Vec<(u128, Design, Score)>> = chunk.par_iter().map(of).collect();
        for (key, design, score) in scored.into_iter().flatten() {
            truth.feasible += u64::from(score.is_feasible());
            truth.hash = truth.hash.wrapping_add(key);
            truth.front.offer(truth.designs, &score, || (key, design));
            truth.designs += 1;
        }
        progress(truth.designs);
    }
    let points = truth.front.points();
    truth.reference = reference_point(points.iter().copied());
    truth.hypervolume = truth.reference.as_ref().map_or(0.0, |r| hypervolume(&points, r));
    truth
}
