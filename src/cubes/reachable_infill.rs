//! What the rules about windows and doors exclude inside one cube.

use super::reachable::Level;
use crate::voxels::Label;

/// The four horizontal directions as (axis, towards the higher coordinate).
const SIDES: [(usize, bool); 4] = [(0, false), (0, true), (1, false), (1, true)];

/// The corner beside a corner along a plan axis.
fn beside(corner: usize, axis: usize) -> usize {
    corner ^ 1 << axis
}

/// Whether the neighbour on a side lies in the cube.
fn is_inside(corner: usize, (axis, high): (usize, bool)) -> bool {
    (corner >> axis & 1 == 1) != high
}

/// Whether every window and door in the cube can be part of an opening that breaks no rule: `opening-facade`, `opening-corner`,
/// `opening-surround`, `doors-ground`, `decks`.
pub(super) fn openings_stand(level: Level, labels: &[Label; 8]) -> bool {
    (0..8).filter(|&c| labels[c].is_infill()).all(|c| {
        // An opening looks one way: its parts in this cube must have a direction in common.
        part_of_opening(labels, c).into_iter().fold(15, |sides, part| sides & outlooks(labels, part)) != 0
            && stands_in_wall(labels, c)
            && opens_onto_deck(level, labels, c)
    }) && are_rectangles(labels)
}

/// The corners of the opening that a corner belongs to: `opening-surround` wants base around an opening, so whatever of its label
/// lies face to face with it is part of it.
fn part_of_opening(labels: &[Label; 8], corner: usize) -> Vec<usize> {
    let mut parts = vec![corner];
    let mut next = 0;
    while let Some(&at) = parts.get(next) {
        next += 1;
        for to in [at ^ 1, at ^ 2, at ^ 4] {
            if labels[to] == labels[corner] && !parts.contains(&to) {
                parts.push(to);
            }
        }
    }
    parts
}

/// The directions a window or door voxel may look, as bits of [`SIDES`]: outside on that side and on no other
/// (`opening-facade`, `opening-corner`), base behind (one voxel deep), base or the same opening to the left and right.
fn outlooks(labels: &[Label; 8], corner: usize) -> u8 {
    let fits = |&(axis, high): &(usize, bool)| {
        SIDES.iter().filter(|&&side| is_inside(corner, side)).all(|&side| {
            let found = labels[beside(corner, side.0)];
            if side == (axis, high) {
                found == Label::Empty
            } else if side.0 == axis {
                found == Label::Base
            } else {
                found == Label::Base || found == labels[corner]
            }
        })
    };
    SIDES.iter().enumerate().filter(|(_, side)| fits(side)).fold(0, |bits, (n, _)| bits | 1 << n)
}

/// `opening-surround` upwards and downwards: base or the same opening above; below the same opening, a slab, or, for a window, base.
fn stands_in_wall(labels: &[Label; 8], corner: usize) -> bool {
    let (own, other) = (labels[corner], labels[corner ^ 4]);
    match (corner < 4, other) {
        (_, label) if label == own => true,
        (true, label) => label == Label::Base,
        (false, label) => label.is_slab() || (label == Label::Base && own == Label::Window),
    }
}

/// `decks`: in front of a door on an upper plate lies slab at the same level.
fn opens_onto_deck(level: Level, labels: &[Label; 8], corner: usize) -> bool {
    let door = level == Level::OverPlate && labels[corner] == Label::Opening;
    let outside = |axis: usize| labels[beside(corner, axis)] == Label::Empty;
    !door || (0..2).filter(|&axis| outside(axis)).all(|axis| labels[beside(corner, axis) ^ 4].is_slab())
}

/// Openings are rectangles: on no side of the cube do three corners belong to an opening and the fourth not.
fn are_rectangles(labels: &[Label; 8]) -> bool {
    [[0, 1], [2, 3], [0, 2], [1, 3]].iter().all(|&[a, b]| {
        let side = [a, b, a + 4, b + 4];
        [Label::Opening, Label::Window].iter().all(|l| side.iter().filter(|&&c| labels[c] == *l).count() != 3)
    })
}
