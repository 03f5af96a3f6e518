//! The designs one change away from a design.

use super::identity::identity;
use super::massing::{Design, encode};
use super::moves::Move;
use super::plot::Space;
use super::settle::settle;
use crate::voxels::Choice;
use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;
use rustc_hash::FxHashSet;

/// A single change.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Change {
    /// A choice takes another value.
    Choice(Choice, u16),
    /// A move of the shape.
    Move(Move),
}

/// A design one change away.
#[derive(Clone, Debug, PartialEq)]
pub struct Neighbour {
    /// The change.
    pub change: Change,
    /// What it leads to.
    pub design: Design,
}

/// How many neighbours are asked for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Reach {
    /// Values tried of each choice at most, evenly over its list.
    pub values: usize,
    /// Draws of each move of the shape.
    pub draws: usize,
}

/// The designs one change away: every choice at up to `reach.values` other values, and `reach.draws` draws of each move of the shape, which
/// depend on `seed` alone. Different from `design` and from each other.
pub fn neighbours(design: &Design, space: &Space, reach: Reach, seed: u64) -> Vec<Neighbour> {
    let mut known = FxHashSet::default();
    let key = |d: &Design| identity(&encode(&d.massing, &space.plot), &d.choices);
    known.insert(key(design));
    let chosen = Choice::ALL.into_iter().flat_map(|c| other_values(design, space, c, reach.values));
    let moved = Move::ALL.into_iter().enumerate().filter(|(_, m)| m.choice().is_none());
    let drawn = moved.flat_map(|(n, one)| {
        (0..reach.draws).filter_map(move |draw| {
            let mut rng = ChaCha8Rng::seed_from_u64(seed);
            rng.set_stream((n * reach.draws + draw) as u64);
            Some(Neighbour { change: Change::Move(one), design: one.apply(design, space, &mut rng)? })
        })
    });
    chosen.chain(drawn).filter(|n| known.insert(key(&n.design))).collect()
}

/// The design with other values of one choice: of joists one plate at a time, else evenly many of the list.
fn other_values(design: &Design, space: &Space, choice: Choice, most: usize) -> Vec<Neighbour> {
    let (count, own) = (space.choices.count(choice), design.choices.0[choice as usize]);
    let values: Vec<u16> = match choice {
        Choice::Joists => (0..design.massing.storeys.len().min(15)).map(|plate| own ^ 1 << plate).collect(),
        _ => {
            let others: Vec<u16> = (0..count).filter(|v| *v != own).collect();
            let kept = others.len().min(most);
            (0..kept).map(|n| others[n * others.len() / kept]).collect()
        }
    };
    let one = |value: u16| {
        let mut out = design.clone();
        out.choices.0[choice as usize] = value;
        settle(&mut out, space).ok()?;
        (out.massing == design.massing).then_some(Neighbour { change: Change::Choice(choice, value), design: out })
    };
    values.into_iter().filter(|v| *v < count).filter_map(one).collect()
}
