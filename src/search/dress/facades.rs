//! Openings composed bay by bay: even rhythms, the same above each other, wide glass to the south, one marked entrance.

use crate::search::massing::{Massing, Opening, along};
use crate::search::openings::{Bay, Facades, bays, glass_m2};
use crate::search::plot::Programme;
use crate::search::settle::{facades, net_area_m2};
use crate::voxels::Direction;

/// Widths of windows per facing (east, north, west, south), from generous to sparing.
const WIDTHS: [[usize; 4]; 5] = [[3, 2, 3, 4], [2, 1, 2, 4], [2, 1, 2, 3], [2, 1, 2, 2], [1, 1, 1, 2]];
/// Glass over floor area that a composition stays under, as a share of the programme's most.
const GENEROUS: f64 = 0.85;
/// Free modules between two windows of a bay, at least.
const PIER: usize = 2;
/// Seats of a bay that can take the entrance between two windows.
const ENTRANCE_SEATS: usize = 6;

/// Gives every storey new openings: the most generous composition whose glass stays in the programme's range everywhere.
pub fn compose(massing: &mut Massing, programme: &Programme) {
    let entrance = entrance(massing);
    for widths in WIDTHS {
        let openings: Vec<Vec<Opening>> =
            (0..massing.storeys.len()).map(|s| storey(massing, s, &widths, entrance)).collect();
        let moderate = openings.iter().enumerate().all(|(s, list)| {
            let glass: f64 = list.iter().map(glass_m2).sum();
            glass <= GENEROUS * programme.glazing[1] * net_area_m2(massing, s)
        });
        for (storey, list) in massing.storeys.iter_mut().zip(openings) {
            storey.openings = list;
        }
        if moderate {
            return;
        }
    }
}

/// The entrance: bay and seat. South where the bay is long enough to keep windows on both sides, else another side.
fn entrance(massing: &Massing) -> Option<(Bay, usize)> {
    let free = bare(massing, 0);
    let bays = bays(&massing.storeys[0].footprint);
    let mut best: Option<((usize, usize), (Bay, usize))> = None;
    for bay in bays {
        let seats = bay.length.saturating_sub(2);
        let order = [Direction::South, Direction::West, Direction::East, Direction::North];
        let rank = order.iter().position(|d| *d == bay.facing).unwrap_or(0);
        let roomy = usize::from(seats < ENTRANCE_SEATS);
        // A third along the facade, then further and further from there.
        let mut places: Vec<usize> = (0..seats).collect();
        places.sort_by_key(|p| (p.abs_diff(seats / 3), *p));
        let place = places.into_iter().find(|p| free.is_free(&Opening::door(bay.facing, seat(&bay, *p))));
        if let Some(place) = place
            && best.is_none_or(|(key, _)| (roomy, rank) < key)
        {
            best = Some(((roomy, rank), (bay, place)));
        }
    }
    best.map(|(_, found)| found)
}

/// The cell of a seat, counted from the first that is no corner.
fn seat(bay: &Bay, place: usize) -> [isize; 2] {
    let ([x, y], [ax, ay]) = (bay.cell, along(bay.facing));
    let n = place as isize + 1;
    [x + n * ax, y + n * ay]
}

/// The facades of a storey with nothing seated.
fn bare(massing: &Massing, s: usize) -> Facades {
    let mut empty = massing.clone();
    empty.storeys.iter_mut().for_each(|storey| storey.openings.clear());
    facades(&empty, s)
}

fn storey(massing: &Massing, s: usize, widths: &[usize; 4], entrance: Option<(Bay, usize)>) -> Vec<Opening> {
    let mut free = bare(massing, s);
    let mut list = Vec::new();
    let mut take = |opening: Opening, free: &mut Facades| {
        let fits = free.is_free(&opening);
        if fits {
            free.take(&opening);
            list.push(opening);
        }
        fits
    };
    if s > 0 {
        let order = [Direction::South, Direction::West, Direction::East, Direction::North];
        let onto_deck = order.into_iter().find_map(|facing| {
            let places: Vec<Opening> = free.places(Opening::door(facing, [0, 0])).collect();
            places.get(places.len() / 2).copied()
        });
        if let Some(door) = onto_deck {
            take(door, &mut free);
        }
    }
    for bay in bays(&massing.storeys[s].footprint) {
        let seats = bay.length.saturating_sub(2);
        let wide = widths[bay.facing as usize];
        let sill = if bay.facing == Direction::South && s == 0 { 1 } else { 2 };
        let door = entrance.filter(|(at, _)| *at == bay).map(|(_, place)| place);
        if let Some(place) = door {
            let over = Opening::window(bay.facing, seat(&bay, place), 1, 2);
            take(if s == 0 { Opening::door(bay.facing, seat(&bay, place)) } else { over }, &mut free);
        }
        let parts = match door {
            Some(place) => vec![(0, place.saturating_sub(1)), (place + 2, seats.saturating_sub(place + 2))],
            None => vec![(0, seats)],
        };
        for (from, length) in parts {
            for (at, width) in rhythm(length, wide) {
                take(Opening::window(bay.facing, seat(&bay, from + at), width, sill), &mut free);
            }
        }
    }
    list
}

/// Windows of about `wide` modules on so many seats, as (seat, width): mirror-symmetric, with at least [`PIER`] between.
fn rhythm(seats: usize, wide: usize) -> Vec<(usize, usize)> {
    let mut width = wide.min(seats);
    if width == 0 {
        return Vec::new();
    }
    let count = ((seats + PIER) / (width + PIER)).max(1);
    // An odd number of windows is symmetric only where what is left over is even.
    if count % 2 == 1 && (seats - count * width) % 2 == 1 {
        width = if width > 1 { width - 1 } else { (width + 1).min(seats) };
    }
    let left = seats.saturating_sub(count * width);
    let mut gap = if count > 1 { ((left + count / 2) / count).max(PIER) } else { 0 };
    if count > 1 && (count - 1) * gap > left {
        gap = left / (count - 1);
    }
    if (left - (count - 1) * gap) % 2 == 1 && count.is_multiple_of(2) {
        gap = if (count - 1) * (gap + 1) <= left { gap + 1 } else { gap.saturating_sub(1) };
    }
    let edge = (left - (count - 1) * gap) / 2;
    (0..count).map(|n| (edge + n * (width + gap), width)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rhythms_are_symmetric_and_keep_their_piers() {
        for seats in 1..40 {
            for wide in 1..=4 {
                let windows = rhythm(seats, wide);
                assert!(!windows.is_empty(), "{seats} {wide}");
                let mirrored: Vec<_> = windows.iter().rev().map(|(at, w)| (seats - at - w, *w)).collect();
                assert!(windows.last().is_some_and(|(at, w)| at + w <= seats), "{seats} {wide} {windows:?}");
                let even = windows.len().is_multiple_of(2) || (seats - windows.len() * windows[0].1).is_multiple_of(2);
                assert!(!even || mirrored == windows, "{seats} {wide} {windows:?}");
                assert!(windows.windows(2).all(|p| p[1].0 > p[0].0 + p[0].1), "{seats} {wide} {windows:?}");
            }
        }
    }
}
