//! Moves of windows and doors.

use super::pick;
use crate::search::fields::draw;
use crate::search::massing::{Infill, Massing, Opening};
use crate::search::openings::Facades;
use crate::search::plot::Space;
use crate::search::settle::facades;
use crate::voxels::Direction;
use rand::{Rng, RngExt};

fn storey(massing: &Massing, rng: &mut impl Rng) -> usize {
    rng.random_range(0..massing.storeys.len())
}

fn direction(rng: &mut impl Rng) -> Direction {
    Direction::ALL[rng.random_range(0..4usize)]
}

/// The facades of a storey with all its openings seated.
fn seated(massing: &Massing, s: usize) -> Facades {
    let mut out = facades(massing, s);
    massing.storeys[s].openings.iter().for_each(|o| out.take(o));
    out
}

/// A free place in storey `s` for an opening like `like`: on its own facade, or by the field where the plot has one for it on any.
fn draw_place(facades: &Facades, like: Opening, s: usize, space: &Space, rng: &mut impl Rng) -> Option<Opening> {
    let field = space.plot.fields.of(like.infill);
    let places: Vec<Opening> = match field {
        None => facades.places(like).collect(),
        Some(_) => Direction::ALL.into_iter().flat_map(|facing| facades.places(Opening { facing, ..like })).collect(),
    };
    draw(&places, field, s, rng)
}

fn draw_index(massing: &Massing, s: usize, infill: Infill, rng: &mut impl Rng) -> Option<usize> {
    let of_kind: Vec<usize> =
        (0..massing.storeys[s].openings.len()).filter(|&i| massing.storeys[s].openings[i].infill == infill).collect();
    pick(&of_kind, rng)
}

/// A new window of random width and sill.
pub fn add_window(massing: &mut Massing, space: &Space, rng: &mut impl Rng) -> Option<()> {
    let s = storey(massing, rng);
    let sill = if rng.random_bool(0.3) { 1 } else { 2 };
    let like = Opening::window(direction(rng), [0, 0], rng.random_range(1..=Opening::WIDEST), sill);
    let place = draw_place(&seated(massing, s), like, s, space, rng)?;
    massing.storeys[s].openings.push(place);
    Some(())
}

/// One window less.
pub fn remove_window(massing: &mut Massing, rng: &mut impl Rng) -> Option<()> {
    let s = storey(massing, rng);
    let i = draw_index(massing, s, Infill::Window, rng)?;
    massing.storeys[s].openings.remove(i);
    Some(())
}

/// A window to another free place, on its own facade or any.
pub fn move_window(massing: &mut Massing, space: &Space, rng: &mut impl Rng) -> Option<()> {
    relocate(massing, Infill::Window, space, rng)
}

/// A door to another free place.
pub fn move_door(massing: &mut Massing, space: &Space, rng: &mut impl Rng) -> Option<()> {
    relocate(massing, Infill::Door, space, rng)
}

fn relocate(massing: &mut Massing, infill: Infill, space: &Space, rng: &mut impl Rng) -> Option<()> {
    let s = storey(massing, rng);
    let i = draw_index(massing, s, infill, rng)?;
    let old = massing.storeys[s].openings[i];
    let mut free = seated(massing, s);
    free.release(&old);
    let facing = if rng.random_bool(0.5) { old.facing } else { direction(rng) };
    massing.storeys[s].openings[i] = draw_place(&free, Opening { facing, ..old }, s, space, rng)?;
    Some(())
}

/// A window one module wider or narrower, to either side, or with the other sill.
pub fn resize_window(massing: &mut Massing, rng: &mut impl Rng) -> Option<()> {
    let s = storey(massing, rng);
    let i = draw_index(massing, s, Infill::Window, rng)?;
    let old = massing.storeys[s].openings[i];
    let [ax, ay] = old.along();
    let moved = |by: isize| [old.cell[0] + by * ax, old.cell[1] + by * ay];
    let new = match rng.random_range(0..5) {
        0 => Opening { width: old.width + 1, ..old },
        1 => Opening { width: old.width + 1, cell: moved(-1), ..old },
        2 => Opening { width: old.width.saturating_sub(1), ..old },
        3 => Opening { width: old.width.saturating_sub(1), cell: moved(1), ..old },
        _ => Opening { sill: 3 - old.sill.clamp(1, 2), ..old },
    };
    let mut free = seated(massing, s);
    free.release(&old);
    if new.width == 0 || new.width > Opening::WIDEST || !free.is_free(&new) {
        return None;
    }
    massing.storeys[s].openings[i] = new;
    Some(())
}

/// A new door, in front of a window if need be.
pub fn add_door(massing: &mut Massing, space: &Space, rng: &mut impl Rng) -> Option<()> {
    let s = storey(massing, rng);
    let place = draw_place(&seated(massing, s), Opening::door(direction(rng), [0, 0]), s, space, rng)?;
    massing.storeys[s].openings.push(place);
    Some(())
}

/// One door less (entrances that the programme asks for come back when the design is settled).
pub fn remove_door(massing: &mut Massing, rng: &mut impl Rng) -> Option<()> {
    let s = storey(massing, rng);
    let i = draw_index(massing, s, Infill::Door, rng)?;
    massing.storeys[s].openings.remove(i);
    Some(())
}
