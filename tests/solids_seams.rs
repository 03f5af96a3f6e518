//! What whole solids show on the four vertical faces of every reachable cube: it follows from the face, so neighbours meet.

#[path = "common/shells.rs"]
mod shells;

use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

use houscaper::cubes::{Axis, CubeKey, FaceNumber, reachable_keys, reachable_labels};
use houscaper::tiles::check::sections;
use houscaper::tiles::solids::{Columns, Half, SolidStyle, solids};
use houscaper::tiles::{Component, Shells, StyleSet};
use houscaper::voxels::{Direction, Label};

/// Outlines by component, the axes of the face as they are.
type Section = Vec<(Component, Vec<[[i32; 2]; 2]>)>;
/// Axis, labels, number and walked decks: what both cubes at a face know.
type Face = (usize, [Label; 4], FaceNumber, [bool; 2]);

fn styles() -> [(String, SolidStyle); 2] {
    ["architectural", "larch"].map(|name| {
        let dir = Path::new(env!("CARGO_MANIFEST_DIR")).join("tilesets").join(name);
        let set = StyleSet::load(&dir).unwrap_or_else(|e| panic!("{e}"));
        (set.name, set.style)
    })
}

fn columns_at(side: Direction) -> [usize; 2] {
    match side {
        Direction::East => [1, 3],
        Direction::North => [2, 3],
        Direction::West => [0, 2],
        Direction::South => [0, 1],
    }
}

/// The sections on the four faces in the order of [`Direction::ALL`].
fn shown(key: CubeKey, style: &SolidStyle, shells: &Shells) -> [(Face, Section); 4] {
    let faces: Vec<_> = solids(key, style, shells).iter().map(|b| (b.component, b.faces())).collect();
    let all = sections(faces.iter().map(|(c, f)| (*c, f)), [900_000, 900_000, 540_000]);
    Direction::ALL.map(|side| {
        let (axis, high) = match side {
            Direction::East => (Axis::X, true),
            Direction::North => (Axis::Y, true),
            Direction::West => (Axis::X, false),
            Direction::South => (Axis::Y, false),
        };
        let [a, b] = columns_at(side);
        let labels = [a, b, a + 4, b + 4].map(|n| key.label(n));
        let section = all[2 * axis as usize + usize::from(high)].iter().filter_map(|(c, o)| Some(((*c)?, o.clone())));
        ((axis as usize, labels, key.face(side), [a, b].map(|q| key.walked(q))), section.collect())
    })
}

/// Whether openings on a face are built as such: at a corner of the house they stay wall.
fn openings(key: CubeKey, side: Direction, shells: &Shells) -> [[bool; 2]; 2] {
    let columns = Columns::new(key, shells);
    let axis = 1 - side as usize % 2;
    columns_at(side).map(|q| [Half::Lower, Half::Upper].map(|half| columns.infill(q, axis, half).is_some()))
}

fn prove(name: &str, keys: &[CubeKey], style: &SolidStyle) -> [usize; 4] {
    let shells = shells::shells();
    let mut faces: BTreeMap<Face, BTreeMap<Section, Vec<(CubeKey, Direction)>>> = BTreeMap::new();
    for &key in keys {
        for ((face, section), side) in shown(key, style, &shells).into_iter().zip(Direction::ALL) {
            faces.entry(face).or_default().entry(section).or_default().push((key, side));
        }
    }
    // Why a face is shown in more than one way.
    let mut why: BTreeMap<&str, usize> = BTreeMap::new();
    let mut unexplained = Vec::new();
    for (face, shown) in faces.iter().filter(|(_, shown)| shown.len() > 1) {
        let level = |s: &Section| s.iter().any(|(c, _)| *c == Component::FlatMembrane);
        let open = |places: &[(CubeKey, Direction)]| {
            places.iter().map(|(key, side)| openings(*key, *side, &shells)).collect::<BTreeSet<_>>()
        };
        let mut causes: BTreeMap<([[bool; 2]; 2], bool), usize> = BTreeMap::new();
        let mut single = true;
        for (section, places) in shown {
            let open = open(places);
            single &= open.len() == 1;
            for o in open {
                *causes.entry((o, level(section))).or_default() += 1;
            }
        }
        let cause = if causes.values().any(|n| *n > 1) || !single {
            unexplained
                .push(format!("{face:?}: {:#?}", shown.iter().map(|(s, p)| (p[0], p.len(), s)).collect::<Vec<_>>()));
            "unexplained"
        } else if causes.keys().map(|c| c.1).collect::<BTreeSet<_>>().len() == 1 {
            "opening at a corner of the house"
        } else {
            "level or sloped roof"
        };
        *why.entry(cause).or_default() += 1;
    }
    println!(
        "{name}: {} keys, {} vertical faces, {} kinds; shown in two ways: {why:?}",
        keys.len(),
        4 * keys.len(),
        faces.len()
    );
    if let Some(first) = unexplained.first() {
        println!("{} unexplained, first {first}", unexplained.len());
    }
    let n = |cause: &str| why.get(cause).copied().unwrap_or(0);
    [faces.len(), n("opening at a corner of the house"), n("level or sloped roof"), n("unexplained")]
}

#[test]
fn every_vertical_face_follows_from_the_face() {
    let numbered = reachable_keys();
    let labels: Vec<CubeKey> = reachable_labels().into_iter().map(CubeKey::of_labels).collect();
    for (name, style) in styles() {
        for (rule, keys) in [("rule B", &numbered), ("rule A", &labels)] {
            let [_, _, _, unexplained] = prove(&format!("{name}, {rule}"), keys, &style);
            assert_eq!(unexplained, 0, "{name} {rule}");
        }
    }
}
