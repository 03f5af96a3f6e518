//! The cubes that a house can contain: every key that no rule excludes which can be read inside one cube.
//!
//! The rules (`voxels::rules`, with their default numbers) speak of layers: what a cube may hold depends on the [`Level`] it stands
//! at. A labelling is reachable when it is allowed at one level at least. Rules that look farther than a cube (plans, daylight,
//! stairs as a whole) exclude nothing here, so the set is a superset of what houses show and a safe ground for proofs.

use super::reachable_infill::openings_stand;
use super::{CubeKey, FaceNumber, Mask};
use crate::voxels::{Direction, Label};

/// Where a cube stands among the layers of a house: k counts voxel layers, plates lie at k = 6, 12, ...
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Level {
    /// Below the ground layer and the ground layer.
    Ground,
    /// Ground layer and first room layer.
    Foundation,
    /// Two room layers.
    Room,
    /// Last room layer and plate.
    UnderPlate,
    /// Plate and first room layer.
    OverPlate,
}

impl Level {
    /// All levels from the ground upwards.
    pub const ALL: [Level; 5] = [Level::Ground, Level::Foundation, Level::Room, Level::UnderPlate, Level::OverPlate];

    /// Labels that the lower and the upper layer may hold; `foundation-layer`, `plates-complete`: foundation is the ground layer
    /// and nothing else, floor lies in plates only, base in a plate is a stair's void, and windows and doors stand in rooms
    /// (`opening-facade`).
    pub fn labels(self) -> [&'static [Label]; 2] {
        use Label::{Base, Empty, Floor, Foundation, Opening, Window};
        let room: &[Label] = &[Empty, Base, Opening, Window];
        let plate: &[Label] = &[Empty, Base, Floor];
        match self {
            Level::Ground => [&[Empty], &[Empty, Foundation]],
            Level::Foundation => [&[Empty, Foundation], room],
            Level::Room => [room, room],
            // Above a window or door stands base (`opening-surround`), which in a plate is a void, inside the house.
            Level::UnderPlate => [&[Empty, Base], plate],
            Level::OverPlate => [plate, room],
        }
    }

    /// Whether no rule excludes eight labels at this level.
    pub fn allows(self, labels: &[Label; 8]) -> bool {
        let [lower, upper] = self.labels();
        labels[..4].iter().all(|l| lower.contains(l))
            && labels[4..].iter().all(|l| upper.contains(l))
            && cubes_admissible(labels)
            && undercut(self, labels)
            && stair_voids(self, labels)
            && openings_stand(self, labels)
    }
}

/// `cubes-admissible`: filled and empty corners are each connected along edges. All empty counts as allowed.
fn cubes_admissible(labels: &[Label; 8]) -> bool {
    Mask::of(labels).is_allowed()
}

/// `undercut`: below a voxel lies a voxel, or at least four empty layers; in the first room layer there is no room for them.
fn undercut(level: Level, labels: &[Label; 8]) -> bool {
    level != Level::Foundation || (0..4).all(|q| labels[q].is_filled() || !labels[q + 4].is_filled())
}

/// `plates-complete`, `stair-inside`, `stair-width`: base in a plate is a stair's void. The cell and its four neighbours are filled
/// through both storeys (inside the lining); in the lower storey its diagonal neighbours too, or a re-entrant corner would narrow
/// the flight. Above and below the void is room: base.
fn stair_voids(level: Level, labels: &[Label; 8]) -> bool {
    let plate = match level {
        Level::UnderPlate => 4,
        Level::OverPlate => 0,
        Level::Ground | Level::Foundation | Level::Room => return true,
    };
    let full = |q: usize| labels[q].is_filled() && labels[q + 4].is_filled();
    let below = || labels[..4].iter().all(|l| l.is_filled());
    (0..4).filter(|&q| labels[plate + q] == Label::Base).all(|q| {
        labels[4 - plate + q] == Label::Base && full(q ^ 1) && full(q ^ 2) && (level != Level::UnderPlate || below())
    })
}

/// Every labelling of a cube that is not empty and that some level allows, in the order of [`CubeKey::of_labels`].
pub fn reachable_labels() -> Vec<[Label; 8]> {
    let mut keys: Vec<CubeKey> = Vec::new();
    for level in Level::ALL {
        each_labelling(level.labels(), |labels| {
            if labels.iter().any(|l| l.is_filled()) && level.allows(labels) {
                keys.push(CubeKey::of_labels(*labels));
            }
        });
    }
    keys.sort_unstable();
    keys.dedup();
    keys.into_iter().map(CubeKey::labels).collect()
}

/// Whether something of a house stands in a cube with these labels: in all that are not empty but those inside a room, eight filled
/// corners without slab above (a slab below lies in the cube below).
pub fn needs_tile(labels: &[Label; 8]) -> bool {
    let any = |corners: &[Label], wanted: fn(Label) -> bool| corners.iter().any(|l| wanted(*l));
    any(labels, Label::is_filled) && (any(labels, |l| !l.is_filled()) || any(&labels[4..], Label::is_slab))
}

/// Calls `visit` for every choice of four lower and four upper labels.
fn each_labelling([lower, upper]: [&[Label]; 2], mut visit: impl FnMut(&[Label; 8])) {
    let (n, m) = (lower.len().pow(4), upper.len().pow(4));
    for number in 0..n * m {
        let mut labels = [Label::Empty; 8];
        let (mut low, mut high) = (number % n, number / n);
        for q in 0..4 {
            labels[q] = lower[low % lower.len()];
            labels[q + 4] = upper[high % upper.len()];
            (low, high) = (low / lower.len(), high / upper.len());
        }
        visit(&labels);
    }
}

/// Every key that a cube of a rule-respecting house can have: reachable labels with every set of face numbers and walked decks that
/// fits them. Sorted, without repeats; computed anew at each call.
pub fn reachable_keys() -> Vec<CubeKey> {
    let mut keys: Vec<CubeKey> = reachable_labels().iter().flat_map(keys_of).collect();
    keys.sort_unstable();
    keys.dedup();
    keys
}

/// Every key with these labels: face numbers and walked decks that the labels leave possible.
pub fn keys_of(labels: &[Label; 8]) -> Vec<CubeKey> {
    let numbers = Direction::ALL.map(|side| face_numbers(labels, side));
    let mut keys = Vec::new();
    for walked in walked_decks(labels) {
        let count: usize = numbers.iter().map(Vec::len).product();
        for mut choice in 0..count {
            let faces = [0, 1, 2, 3].map(|f: usize| {
                let number = numbers[f][choice % numbers[f].len()];
                choice /= numbers[f].len();
                number
            });
            keys.push(CubeKey::new(*labels, faces, walked));
        }
    }
    keys
}

/// The two columns (x + 2y) at a vertical face of the cube.
fn columns_at(side: Direction) -> [usize; 2] {
    match side {
        Direction::East => [1, 3],
        Direction::North => [2, 3],
        Direction::West => [0, 2],
        Direction::South => [0, 1],
    }
}

/// The numbers that a face may have.
///
/// A border between a roof (filled below, no slab, empty above) and a column that is no roof has one. The roof goes on upwards only
/// where the neighbour's upper voxel can itself be a roof one layer higher: base, since a slab is a deck and window or door have
/// base above (`opening-surround`). It goes on downwards only beside an empty column. Otherwise it ends at any height.
pub fn face_numbers(labels: &[Label; 8], side: Direction) -> Vec<FaceNumber> {
    let roof = |q: usize| labels[q].is_filled() && !labels[q].is_slab() && !labels[q + 4].is_filled();
    let [a, b] = columns_at(side);
    let beside = match (roof(a), roof(b)) {
        (true, false) => b,
        (false, true) => a,
        _ => return vec![FaceNumber::None],
    };
    let [lower, upper] = [labels[beside], labels[beside + 4]];
    let goes_on = match (lower.is_filled(), upper.is_filled()) {
        (true, true) if upper == Label::Base => Some(FaceNumber::StepUp),
        (false, false) => Some(FaceNumber::StepDown),
        _ => None,
    };
    goes_on.into_iter().chain([FaceNumber::End0, FaceNumber::End1, FaceNumber::End2]).collect()
}

/// Sets of decks (bit x + 2y) that may be walked on: decks of floor (a foundation is paved ground), side by side all or none.
pub fn walked_decks(labels: &[Label; 8]) -> impl Iterator<Item = u8> {
    let decks =
        (0..4).filter(|&q| labels[q] == Label::Floor && !labels[q + 4].is_filled()).fold(0u8, |bits, q| bits | 1 << q);
    let has = |set: u8, q: u8| set >> q & 1 == 1;
    let uniform = move |set: u8| {
        [(0, 1), (0, 2), (1, 3), (2, 3)]
            .iter()
            .all(|&(a, b)| !(has(decks, a) && has(decks, b)) || has(set, a) == has(set, b))
    };
    (0..16u8).filter(move |&set| set & !decks == 0 && uniform(set))
}
