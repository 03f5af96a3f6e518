//! Every design of a small space, by direct enumeration: the truth that searches are measured against.
//!
//! A space holds the designs that [`settle`](super::settle) leaves as they are and that pass the rule check. They are listed from the rules alone, without
//! moves or starts: footprints are unions of 3 x 3 blocks ([`plans`]), stairs every one that fits, doors and windows every set that can be
//! seated and keeps the glazing ([`openings`]), sections, joists and boards every combination. Of designs that differ by their place on the
//! plot, or by a symmetry of the plot that nothing else tells apart ([`symmetry`](super::symmetry)), the first is kept.

pub mod front;
pub mod openings;
pub mod plans;

use super::identity::identity;
use super::massing::{Design, Massing, Opening, Roof, StoreyMass, encode};
use super::plot::{ChoiceSpace, Space};
use super::settle::{check_area, settle, settle_roof};
use super::stairs::StairWell;
use super::symmetry::Symmetry;
use crate::voxels::{Choice, Choices, House, Stair};
use rustc_hash::FxHashSet;
use std::collections::BTreeMap;

/// More designs than were asked for.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[error(
    "more than {most} {what}: too many to enumerate; use a smaller plot or a mask, fewer storeys, a narrower range of glazing or of roofs, or raise --most"
)]
pub struct TooLarge {
    /// What there is too much of.
    pub what: &'static str,
    /// The limit.
    pub most: usize,
}

/// The shapes of a space.
#[derive(Clone, Debug, Default)]
pub struct Shapes {
    /// One design per shape, with the first choices; each stands for all that are the same but for place and symmetry.
    pub designs: Vec<Design>,
    /// Footprints that keep the plan rules, at every place on the plot.
    pub footprints: usize,
    /// Shapes that the rule check rejected, by rule.
    pub rejected: BTreeMap<&'static str, u64>,
}

/// Lists the shapes of a space.
///
/// # Errors
/// [`TooLarge`] beyond `most` shapes.
pub fn shapes(space: &Space, rules: &dyn Fn(&House) -> Option<&'static str>, most: usize) -> Result<Shapes, TooLarge> {
    let symmetries = Symmetry::of(&space.plot);
    let plans = plans::footprints(space, most)?;
    let mut out = Shapes { footprints: plans.len(), ..Shapes::default() };
    let mut seen: FxHashSet<u128> = FxHashSet::default();
    for stack in plans::distinct(plans::stacks(space, &plans, most)?, &symmetries) {
        let storey = |footprint| StoreyMass { footprint, openings: Vec::new(), stair: None };
        let bare = Massing { storeys: stack.into_iter().map(storey).collect(), roof: Roof::Flat };
        for massing in roofed(&bare, space).into_iter().flat_map(climbed) {
            if check_area(&massing, space).is_err() {
                continue;
            }
            for massing in lit(&massing, space, most)? {
                let design = Design { massing, choices: Choices::default() };
                if !is_settled(&design, space) || !seen.insert(shape_key(&design, space, &symmetries)) {
                    continue;
                }
                match rules(&encode(&design.massing, &space.plot)) {
                    None => out.designs.push(design),
                    Some(rule) => *out.rejected.entry(rule).or_default() += 1,
                }
                if out.designs.len() > most {
                    return Err(TooLarge { what: "shapes", most });
                }
            }
        }
    }
    Ok(out)
}

/// Whether settling leaves a design as it is: what a design of the search is.
pub fn is_settled(design: &Design, space: &Space) -> bool {
    let mut settled = design.clone();
    settle(&mut settled, space).is_ok() && settled == *design
}

/// The least identity among the images of a shape, whatever its choices.
fn shape_key(design: &Design, space: &Space, symmetries: &[Symmetry]) -> u128 {
    let of = |s: &Symmetry| -> Option<u128> {
        let image = s.design(&Design { choices: Choices::default(), ..design.clone() }, &free_joists(space))?;
        Some(identity(&encode(&image.massing, &space.plot), &Choices::default()))
    };
    symmetries.iter().filter_map(of).min().unwrap_or_default()
}

/// The space with joists that may run either way, so that a quarter turn of a shape exists whatever its choices.
fn free_joists(space: &Space) -> Space {
    let mut options = space.choices.options;
    options[Choice::Joists as usize] = u16::MAX;
    Space { choices: ChoiceSpace { options }, ..space.clone() }
}

/// The identity of a design, the same for all that differ by place on the plot or by a symmetry of it.
pub fn key(design: &Design, space: &Space, symmetries: &[Symmetry]) -> u128 {
    let of = |image: Design| identity(&encode(&image.massing, &space.plot), &image.choices);
    symmetries.iter().filter_map(|s| s.design(design, space)).map(of).min().unwrap_or_else(|| of(design.clone()))
}

/// The designs of a shape: every combination of choices, of those that are the same but for a symmetry one.
pub fn designs_of(shape: &Design, space: &Space, symmetries: &[Symmetry]) -> Vec<(u128, Design)> {
    let storeys = shape.massing.storeys.len();
    let joists = space.choices.count(Choice::Joists).min(1 << storeys.min(15));
    let count = |c: Choice| if c == Choice::Joists { joists } else { space.choices.count(c) };
    let mut all = vec![Choices::default()];
    for choice in Choice::ALL {
        let with = |old: Choices| {
            (0..count(choice)).map(move |n| {
                let mut new = old;
                new.0[choice as usize] = n;
                new
            })
        };
        all = all.into_iter().flat_map(with).collect();
    }
    // Only a shape that is its own image can make two combinations the same.
    let own = identity(&encode(&shape.massing, &space.plot), &Choices::default());
    let wide = free_joists(space);
    let keeps = |s: &&Symmetry| {
        let plain = Design { choices: Choices::default(), ..shape.clone() };
        s.design(&plain, &wide).is_some_and(|i| identity(&encode(&i.massing, &space.plot), &Choices::default()) == own)
    };
    let several = symmetries.iter().filter(keeps).count() > 1;
    let mut seen = FxHashSet::default();
    let designs = all.into_iter().map(|choices| Design { choices, ..shape.clone() });
    let keyed = designs.map(|d| (key(&d, space, symmetries), d));
    keyed.filter(|(key, _)| !several || seen.insert(*key)).collect()
}

/// Every roof that the shape can carry and the programme admits.
fn roofed(bare: &Massing, space: &Space) -> Vec<Massing> {
    let all = (0..=Roof::STEEPEST as usize).map(|rise| Massing { roof: Roof::of_rise(rise), ..bare.clone() });
    all.filter(|massing| {
        let mut settled = massing.clone();
        settle_roof(&mut settled, space).is_ok() && settled.roof == massing.roof
    })
    .collect()
}

/// Every choice of stairs, from the ground up.
fn climbed(massing: Massing) -> Vec<Massing> {
    let mut all: Vec<(Massing, Option<Stair>)> = vec![(massing, None)];
    let count = all[0].0.storeys.len();
    for s in 0..count.saturating_sub(1) {
        let mut next = Vec::new();
        for (massing, below) in all {
            let well = StairWell::new(&massing.storeys[s].footprint, &massing.storeys[s + 1].footprint, below);
            for stair in well.candidates(s).into_iter().filter(|c| well.fits(c)) {
                let mut with = massing.clone();
                with.storeys[s].stair = Some(stair);
                next.push((with, Some(stair)));
            }
        }
        all = next;
    }
    all.into_iter().map(|(massing, _)| massing).collect()
}

/// Every choice of doors and windows, storey by storey.
fn lit(massing: &Massing, space: &Space, most: usize) -> Result<Vec<Massing>, TooLarge> {
    let mut all = vec![massing.clone()];
    for s in 0..massing.storeys.len() {
        let sets: Vec<Vec<Opening>> = openings::sets(massing, s, space, most)?;
        if all.len().saturating_mul(sets.len()) > most.saturating_mul(8) {
            return Err(TooLarge { what: "sets of windows and doors", most });
        }
        let with = |massing: &Massing| -> Vec<Massing> {
            let seat = |set: &Vec<Opening>| {
                let mut out = massing.clone();
                out.storeys[s].openings.clone_from(set);
                out
            };
            sets.iter().map(seat).collect()
        };
        all = all.iter().flat_map(with).collect();
    }
    Ok(all)
}
