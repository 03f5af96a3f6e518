//! Repair: the rule-respecting design of a space that any voxels come near to.
//!
//! Footprints are read off the voxels storey by storey and put right as [`dress`](super::dress) does it; here they also keep to
//! the plot, the given cells and the programme, and openings, stairs and roof are taken over where they are. What then still
//! stands against a rule is loosened cause by cause. The outcome is near the voxels, not proven to be the nearest. Nothing is
//! drawn by lot.

use super::cells::Cells;
use super::decode::{decode, openings};
use super::dress::{footprints, mend, roof_rise, wished_stair};
use super::massing::{Design, Massing, Roof, StoreyMass};
use super::plot::Space;
use super::settle::{floor_area_m2, settle};
use super::shape::{Cause, check_plan};
use super::start::complete;
use crate::voxels::{Choices, House, VoxelArray};
use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;

/// Changes of the footprints before a repair is given up.
const ROUNDS: usize = 40;

/// No design of the space is near enough.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
pub enum RepairError {
    /// Nothing that could be a storey.
    #[error(
        "no storey can be made of the voxels: nowhere do three of six layers hold a plan of 4 x 4 modules, and nothing is given"
    )]
    NoStorey,
    /// A rule that still cannot be kept.
    #[error("the voxels are too far from a house: the {} rule cannot be kept; see `houscaper check --rules`", .0.name())]
    Rule(Cause),
}

/// A settled design near a house that may break any rule; the house's own one, settled, where it has one ([`decode`]).
///
/// # Errors
/// [`RepairError`]: no storey at all, or a rule that no small change heals.
pub fn repair(house: &House, choices: Choices, space: &Space) -> Result<Design, RepairError> {
    if let Some(massing) = decode(house, &space.plot) {
        let mut own = Design { massing, choices };
        if settle(&mut own, space).is_ok() {
            return Ok(own);
        }
    }
    let house = &on_plot(house, space);
    let mut plans = plans(house, space)?;
    let rise = roof_rise(&house.voxels, &plans);
    let mut last = Cause::Blocks;
    let mut with_openings = true;
    for round in 0..ROUNDS {
        let storeys = plans.iter().enumerate().map(|(s, plan)| StoreyMass {
            footprint: plan.clone(),
            openings: if with_openings { openings(&house.voxels, plan, s) } else { Vec::new() },
            stair: Some(house.stairs.iter().copied().find(|t| t.storey == s).unwrap_or_else(|| wished_stair(plan, s))),
        });
        let massing = Massing { storeys: storeys.collect(), roof: Roof::of_rise(rise) };
        let mut design = Design { massing, choices };
        let Err(cause) = settle(&mut design, space) else { return Ok(design) };
        last = cause;
        let area = floor_area_m2(&design.massing);
        match cause {
            Cause::Glazing | Cause::Entrance if with_openings => with_openings = false,
            _ => loosen(&mut plans, cause, area, space, round),
        }
    }
    Err(RepairError::Rule(last))
}

/// Footprints that keep the plan rules as far as possible, inside the plot, around the given cells, as many as the programme asks for.
fn plans(house: &House, space: &Space) -> Result<Vec<Cells>, RepairError> {
    let size = space.plot.size();
    let mut plans = footprints(&house.voxels);
    plans.truncate(space.most_storeys());
    while plans.len() < space.plot.given_storeys() {
        plans.push(Cells::new(size));
    }
    for (s, plan) in plans.iter_mut().enumerate() {
        *plan = kept(plan, s, space);
    }
    while plans.len() < space.least_storeys() {
        let next = kept(plans.last().ok_or(RepairError::NoStorey)?, plans.len(), space);
        plans.push(next);
    }
    if plans.iter().any(Cells::is_empty) {
        return Err(RepairError::NoStorey);
    }
    mend(&mut plans, &mut Vec::new());
    Ok(plans)
}

/// The house in an array of the plot's shape; what lies outside is cut off.
fn on_plot(house: &House, space: &Space) -> House {
    let mut voxels = VoxelArray::new(space.plot.modules);
    let inside = |v: &[usize; 3]| v.iter().zip(space.plot.modules).all(|(c, n)| *c < n);
    house.voxels.iter().filter(|(v, label)| label.is_filled() && inside(v)).for_each(|(v, label)| voxels.set(v, label));
    House { stairs: house.stairs.clone(), ..House::new(voxels) }
}

/// The plan with its given cells, on cells that may be built on.
fn kept(plan: &Cells, s: usize, space: &Space) -> Cells {
    let with_given = space.plot.must_fill(s).map_or_else(|| plan.clone(), |given| plan.or(given));
    with_given.and(&space.plot.allowed(s))
}

/// Changes footprints towards one that does not break `cause`; `round` turns the side on which that is tried first.
fn loosen(plans: &mut Vec<Cells>, cause: Cause, area_m2: f64, space: &Space, round: usize) {
    let [least, most] = space.programme.floor_area_m2;
    match cause {
        Cause::Area if area_m2 > most => strip(plans, space, round, false),
        Cause::Area if area_m2 < least => strip(plans, space, round, true),
        Cause::Slender | Cause::Stair if plans.len() > space.least_storeys() => plans.truncate(plans.len() - 1),
        Cause::Storeys if plans.len() > space.most_storeys() => plans.truncate(space.most_storeys()),
        Cause::Storeys => plans.extend(plans.last().cloned()),
        Cause::Cantilever | Cause::Drain => {
            for s in (1..plans.len()).rev() {
                plans[s - 1] = kept(&plans[s - 1].or(&plans[s]), s - 1, space);
            }
        }
        Cause::Plot | Cause::Given | Cause::Blocks | Cause::Diagonal | Cause::Passage | Cause::Gap => {
            for (s, plan) in plans.iter_mut().enumerate() {
                let mut rng = ChaCha8Rng::seed_from_u64(round as u64);
                let from = kept(plan, s, space);
                *plan = complete(from.clone(), &space.plot.allowed(s), &mut rng).unwrap_or(from);
            }
        }
        Cause::Roof => {
            if let (Some(top), s) = (plans.last_mut(), space.most_storeys()) {
                let ([x, y], extent) = top.bounds().unwrap_or_default();
                *top = kept(&Cells::rect(top.size(), [x as isize, y as isize], extent), s, space);
            }
        }
        Cause::Area | Cause::Slender | Cause::Stair | Cause::Glazing | Cause::Entrance => {
            strip(plans, space, round, true);
        }
    }
}

/// One row of modules more, or less, along one side of all storeys; the first side, from `round` on, on which every plan keeps its rules.
fn strip(plans: &mut [Cells], space: &Space, round: usize, grow: bool) {
    const SIDES: [[isize; 2]; 4] = [[1, 0], [0, 1], [-1, 0], [0, -1]];
    for n in 0..4 {
        let step = SIDES[(round + n) % 4];
        let changed: Vec<Cells> = plans
            .iter()
            .enumerate()
            .map(|(s, plan)| {
                let moved = plan.shifted(step);
                kept(&if grow { plan.or(&moved) } else { plan.and(&moved) }, s, space)
            })
            .collect();
        let differs = changed.iter().zip(plans.iter()).any(|(a, b)| a != b);
        if differs && changed.iter().all(|plan| check_plan(plan).is_ok()) {
            plans.clone_from_slice(&changed);
            return;
        }
    }
}
