//! Moves of roof, stairs and choices.

use super::pick;
use crate::search::massing::{Design, Massing, Roof};
use crate::search::plot::Space;
use crate::search::stairs::StairWell;
use crate::voxels::{Choice, Choices, Stair};
use rand::{Rng, RngExt};

/// A hipped roof one layer higher or lower.
pub fn step_roof(massing: &mut Massing, by: i8) -> Option<()> {
    let Roof::Hip(rise) = massing.roof else { return None };
    let next = rise.checked_add_signed(by).filter(|r| (1..=Roof::STEEPEST).contains(r))?;
    massing.roof = Roof::Hip(next);
    Some(())
}

/// From flat to a hip of random rise, or back.
pub fn switch_roof(massing: &mut Massing, rng: &mut impl Rng) -> Option<()> {
    massing.roof = match massing.roof {
        Roof::Flat => Roof::Hip(rng.random_range(1..=Roof::STEEPEST)),
        Roof::Hip(_) => Roof::Flat,
    };
    Some(())
}

/// A stair to another of the places where it fits; `turned` asks for another direction or kind, else both stay.
pub fn move_stair(massing: &mut Massing, rng: &mut impl Rng, turned: bool) -> Option<()> {
    if massing.storeys.len() < 2 {
        return None;
    }
    let s = rng.random_range(0..massing.storeys.len() - 1);
    let old = massing.storeys[s].stair?;
    let below = s.checked_sub(1).and_then(|i| massing.storeys[i].stair);
    let well = StairWell::new(&massing.storeys[s].footprint, &massing.storeys[s + 1].footprint, below);
    let same = |c: &Stair| c.kind == old.kind && c.run == old.run;
    let candidates: Vec<Stair> = well.candidates(s).into_iter().filter(|c| *c != old && same(c) != turned).collect();
    let new = pick(&candidates, rng).filter(|c| well.fits(c))?;
    massing.storeys[s].stair = Some(new);
    Some(())
}

/// Another option of a choice: a neighbour in the list half of the time, any other else.
pub fn change(choices: &mut Choices, choice: Choice, space: &Space, rng: &mut impl Rng) -> Option<()> {
    let (options, old) = (space.choices.count(choice), choices.0[choice as usize]);
    if options < 2 {
        return None;
    }
    let new = if rng.random_bool(0.5) {
        if rng.random_bool(0.5) { old.checked_add(1)? } else { old.checked_sub(1)? }
    } else {
        rng.random_range(0..options)
    };
    if new >= options || new == old {
        return None;
    }
    choices.0[choice as usize] = new;
    Some(())
}

/// The joists of one plate the other way.
pub fn turn_joists(design: &mut Design, space: &Space, rng: &mut impl Rng) -> Option<()> {
    let plates = design.massing.storeys.len().min(16);
    let bits = design.choices.0[Choice::Joists as usize] ^ 1 << rng.random_range(0..plates);
    if bits >= space.choices.count(Choice::Joists) {
        return None;
    }
    design.choices.0[Choice::Joists as usize] = bits;
    Some(())
}
