//! Test fits: whether a bedroom and a living room of usual sizes find room in a storey's clear area.

use super::free::Free;

/// Placements of one room that are tried against the other at most.
const TRIED: usize = 240;

/// A room that is tried.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Room {
    /// 3 x 3 m with a double bed and a wardrobe.
    Bedroom,
    /// 4 x 4 m with a sofa and tables.
    Living,
}

impl Room {
    /// Its side, m.
    pub fn side_m(self) -> f64 {
        match self {
            Room::Bedroom => 3.0,
            Room::Living => 4.0,
        }
    }

    /// Its name with its size.
    pub fn words(self) -> &'static str {
        match self {
            Room::Bedroom => "bedroom 3.0 × 3.0 m",
            Room::Living => "living room 4.0 × 4.0 m",
        }
    }
}

/// A room where it fits.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Fit {
    /// Which.
    pub room: Room,
    /// Its corner with the smallest coordinates, m.
    pub low: [f64; 2],
    /// Whether its east, north, west, south sides lie against something.
    pub against: [bool; 4],
    /// Which of these sides have a window behind them.
    pub lit: [bool; 4],
}

/// The rooms that fit side by side: both where there are such places, else the one that does, `first` before the other.
pub fn fit(free: &Free, first: Room) -> Vec<Fit> {
    let second = if first == Room::Living { Room::Bedroom } else { Room::Living };
    let (a, b) = (free.places(first), free.places(second));
    let (wa, wb) = (free.cells_of(first), free.cells_of(second));
    // Evenly out of all, so that a far corner is tried too.
    let step = a.len().div_ceil(TRIED).max(1);
    let mut best: Option<(i32, [usize; 2], [usize; 2])> = None;
    for (score, p) in a.iter().step_by(step) {
        let apart = |q: &[usize; 2]| (0..2).any(|i| q[i] >= p[i] + wa[i] || p[i] >= q[i] + wb[i]);
        let Some((other, q)) = b.iter().find(|(_, q)| apart(q)) else { continue };
        if best.is_none_or(|(known, ..)| score + other > known) {
            best = Some((score + other, *p, *q));
        }
    }
    match (best, a.first(), b.first()) {
        (Some((_, p, q)), ..) => vec![free.found(first, p), free.found(second, q)],
        (None, Some((_, p)), _) => vec![free.found(first, *p)],
        (None, None, Some((_, q))) => vec![free.found(second, *q)],
        (None, None, None) => Vec::new(),
    }
}

/// A sentence about the test fits of a storey.
pub fn words(free: &Free, fits: &[Fit]) -> String {
    let side = free.largest_square().0;
    let one = |room: Room| match fits.iter().any(|f| f.room == room) {
        true => format!("{} fits", room.words()),
        false if side + 1e-6 >= room.side_m() => format!("{} fits only in place of the other", room.words()),
        false => format!("{} does not fit", room.words()),
    };
    format!("Test fits: {}; {}. Largest clear square {:.2} m.", one(Room::Living), one(Room::Bedroom), side)
}
