//! The thesis's catalogue of labelled tiles, enumerated from definitions: nine families, 493 configurations.

use super::{Corner, CubeKey, Mask, Symmetry, admissible_masks};
use crate::voxels::Label;

/// How configurations are gathered into tiles.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Grouping {
    /// One tile serves all quarter turns and the mirror image.
    TurnsAndMirror,
    /// One tile serves all quarter turns; its mirror image is a tile of its own, as doors have a hand.
    Turns,
}

impl Grouping {
    /// Whether a symmetry may carry a tile to another configuration.
    fn has(self, symmetry: Symmetry) -> bool {
        self == Grouping::TurnsAndMirror || !symmetry.mirror
    }

    /// The first configuration of the class, in the order of keys.
    pub fn class(self, labels: &[Label; 8]) -> [Label; 8] {
        let key = CubeKey::of_labels(*labels);
        let all = Symmetry::all().filter(|&s| self.has(s)).map(|s| key.placed(s));
        all.min().unwrap_or(key).labels()
    }

    /// Number of classes that configurations form.
    pub fn classes(self, members: &[[Label; 8]]) -> usize {
        representatives(self, members).len()
    }
}

/// A family of configurations that the thesis models with tiles of one kind.
#[derive(Clone, Debug, PartialEq)]
pub struct Family {
    /// Name in listings.
    pub name: &'static str,
    /// What its members are; B and T are the lower and the upper four corners.
    pub definition: &'static str,
    /// How its tiles are counted.
    pub grouping: Grouping,
    /// Number of tiles: classes under `grouping`.
    pub tiles: usize,
    /// Number of configurations.
    pub configurations: usize,
    /// The configurations, in the order of their keys.
    pub members: Vec<[Label; 8]>,
}

impl Family {
    pub(super) fn new(
        name: &'static str,
        definition: &'static str,
        grouping: Grouping,
        members: impl IntoIterator<Item = [Label; 8]>,
    ) -> Family {
        let mut keys: Vec<CubeKey> = members.into_iter().map(CubeKey::of_labels).collect();
        keys.sort_unstable();
        keys.dedup();
        let members: Vec<_> = keys.into_iter().map(CubeKey::labels).collect();
        Family { name, definition, grouping, tiles: grouping.classes(&members), configurations: members.len(), members }
    }

    /// The first configuration of each tile.
    pub fn representatives(&self) -> Vec<[Label; 8]> {
        representatives(self.grouping, &self.members)
    }
}

fn representatives(grouping: Grouping, members: &[[Label; 8]]) -> Vec<[Label; 8]> {
    let mut classes: Vec<CubeKey> = members.iter().map(|m| CubeKey::of_labels(grouping.class(m))).collect();
    classes.sort_unstable();
    classes.dedup();
    classes.into_iter().map(CubeKey::labels).collect()
}

/// The families of the thesis, as its text counts them: 105 tiles, 493 configurations, all different.
///
/// ```
/// use houscaper::cubes::catalogue;
/// assert_eq!(catalogue().iter().map(|f| f.configurations).sum::<usize>(), 493);
/// assert_eq!(catalogue().iter().map(|f| f.tiles).sum::<usize>(), 105);
/// ```
pub fn catalogue() -> Vec<Family> {
    use Grouping::{Turns, TurnsAndMirror};
    use Label::{Base, Floor, Foundation, Opening, Window};
    vec![
        Family::new(
            "base",
            "the 126 admissible masks, every filled corner base",
            TurnsAndMirror,
            admissible_masks().map(|m| labelled(m.bottom(), Base, m.top(), Base)),
        ),
        Family::new("floor frame up", "B floor; T base, part of B, neither empty nor full", TurnsAndMirror, up(Floor)),
        Family::new("floor frame down", "T floor; B base, part of T or empty", TurnsAndMirror, down(Floor)),
        Family::new(
            "foundation frame up",
            "B foundation; T base, part of B, neither empty nor full",
            TurnsAndMirror,
            up(Foundation),
        ),
        Family::new(
            "foundation only",
            "T foundation, B empty",
            TurnsAndMirror,
            patterns().map(|t| labelled(0, Label::Empty, t, Foundation)),
        ),
        Family::new("windows", GLAZED, TurnsAndMirror, in_walls(Window, &parts_of_wall(false))),
        Family::new("openings", GLAZED, TurnsAndMirror, in_walls(Opening, &parts_of_wall(false))),
        Family::new("floor to opening", DOORS, Turns, to_opening(Floor)),
        Family::new("foundation to opening", DOORS, Turns, to_opening(Foundation)),
    ]
}

const GLAZED: &str = "one wall of base in 5 categories: corner above, corner below, side, upper half, lower half; outside or room behind";
const DOORS: &str = "B slab, T the same pattern of base and opening; the openings joined, at least one of each";

/// Eight labels: `lower` on the corners in `bottom` (bits x + 2y), `upper` on those in `top`.
pub(super) fn labelled(bottom: u8, lower: Label, top: u8, upper: Label) -> [Label; 8] {
    let mut labels = [Label::Empty; 8];
    for q in 0..4 {
        if bottom >> q & 1 == 1 {
            labels[q] = lower;
        }
        if top >> q & 1 == 1 {
            labels[q + 4] = upper;
        }
    }
    labels
}

/// The 13 patterns of four plan corners that hang together side by side, as bits x + 2y.
pub(super) fn patterns() -> impl Iterator<Item = u8> {
    (1..16).filter(|p| ![0b0110, 0b1001].contains(p))
}

/// Whether one set of corners lies in another.
fn is_part(inner: u8, outer: u8) -> bool {
    inner & !outer == 0
}

/// Walls on a plate that ends: the slab lies in the cube below, so only what stands on it is modelled.
fn up(slab: Label) -> impl Iterator<Item = [Label; 8]> {
    let pairs = patterns().flat_map(|b| patterns().map(move |t| (b, t)));
    let admissible = |&(b, t): &(u8, u8)| Mask(b | t << 4).is_allowed();
    pairs
        .filter(|&(b, t)| is_part(t, b) && t != 15)
        .filter(admissible)
        .map(move |(b, t)| labelled(b, slab, t, Label::Base))
}

fn down(slab: Label) -> impl Iterator<Item = [Label; 8]> {
    let pairs = patterns().flat_map(|t| (0..16).map(move |b| (b, t)));
    let admissible = |&(b, t): &(u8, u8)| Mask(b | t << 4).is_allowed();
    pairs.filter(|&(b, t)| is_part(b, t)).filter(admissible).map(move |(b, t)| labelled(b, Label::Base, t, slab))
}

/// Which of the four octants of a wall are glazed, bits along + 2 up: 8 parts in 5 categories, and the whole wall.
pub(super) fn parts_of_wall(with_full: bool) -> Vec<u8> {
    let parts = [0b0100, 0b1000, 0b0001, 0b0010, 0b0101, 0b1010, 0b1100, 0b0011];
    parts.into_iter().chain(with_full.then_some(0b1111)).collect()
}

/// `infill` in parts of each of the four walls of a cube, with the outside and with a room in the cube's other half. Members come as
/// often as they are met: in a full cube a corner octant belongs to two walls.
pub(super) fn in_walls(infill: Label, parts: &[u8]) -> Vec<[Label; 8]> {
    let mut members = Vec::new();
    for (axis, high) in [(0, false), (0, true), (1, false), (1, true)] {
        let along = 1 - axis;
        let in_wall = |c: Corner| (c.xyz()[axis] == 1) == high;
        for deep in [false, true] {
            for part in parts {
                let mut labels = [Label::Empty; 8];
                for corner in Corner::all().filter(|&c| deep || in_wall(c)) {
                    let at = corner.xyz();
                    let glazed = in_wall(corner) && part >> (at[along] + 2 * at[2]) & 1 == 1;
                    labels[corner.number() as usize] = if glazed { infill } else { Label::Base };
                }
                members.push(labels);
            }
        }
    }
    members
}

/// Doors and glass doors on a slab of the same plan.
fn to_opening(slab: Label) -> impl Iterator<Item = [Label; 8]> {
    let pairs = patterns().flat_map(|p| patterns().map(move |open| (p, open)));
    pairs.filter(|&(p, open)| is_part(open, p) && open != p).map(move |(p, open)| with_opening(p, slab, p, open))
}

/// `bottom` of `slab`, `top` of base, with openings on the corners in `open`.
pub(super) fn with_opening(bottom: u8, slab: Label, top: u8, open: u8) -> [Label; 8] {
    let mut labels = labelled(bottom, slab, top, Label::Base);
    for q in (0..4).filter(|q| open >> q & 1 == 1) {
        labels[q + 4] = Label::Opening;
    }
    labels
}
