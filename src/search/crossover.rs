//! Crossover: a child takes whole organs of its parents, so that it keeps the rules.

use super::massing::{Design, Infill, Massing};
use super::plot::Space;
use super::settle::settle;
use crate::voxels::Choices;
use rand::{Rng, RngExt};

/// A settled child of two parents that equals neither, or `None` when they do not combine.
pub fn crossover(a: &Design, b: &Design, space: &Space, rng: &mut impl Rng) -> Option<Design> {
    let mut child = Design { massing: recombine(a, b, rng)?, choices: mix(a.choices, b.choices, rng) };
    let ok = settle(&mut child, space).is_ok() && child != *a && child != *b;
    ok.then_some(child)
}

fn recombine(a: &Design, b: &Design, rng: &mut impl Rng) -> Option<Massing> {
    let mut out = a.massing.clone();
    match rng.random_range(0..4) {
        0 => inherit_openings(&mut out, &b.massing),
        1 => out.roof = b.massing.roof,
        2 => exchange_storeys(&mut out, &b.massing, rng)?,
        _ => {
            inherit_openings(&mut out, &b.massing);
            out.roof = b.massing.roof;
        }
    }
    Some(out)
}

/// The other parent's windows and doors, storey by storey; those that find no seat on this shape are dropped by settling.
fn inherit_openings(out: &mut Massing, from: &Massing) {
    for (mine, theirs) in out.storeys.iter_mut().zip(&from.storeys) {
        mine.openings.clone_from(&theirs.openings);
    }
}

/// The lower storeys of this parent under the upper storeys of the other.
fn exchange_storeys(out: &mut Massing, from: &Massing, rng: &mut impl Rng) -> Option<()> {
    if from.storeys.len() < 2 {
        return None;
    }
    let cut = rng.random_range(1..from.storeys.len().min(out.storeys.len() + 1).max(2));
    out.storeys.truncate(cut);
    out.storeys.extend_from_slice(from.storeys.get(cut..)?);
    out.roof = from.roof;
    if let Some(top) = out.storeys.last_mut() {
        top.stair = None;
    }
    // Doors of the upper storeys lead to decks that the lower storey may not have.
    for storey in out.storeys.iter_mut().skip(1) {
        storey.openings.retain(|o| o.infill == Infill::Window);
    }
    Some(())
}

/// Each choice from either parent.
pub fn mix(a: Choices, b: Choices, rng: &mut impl Rng) -> Choices {
    Choices(std::array::from_fn(|i| if rng.random_bool(0.5) { a.0[i] } else { b.0[i] }))
}
