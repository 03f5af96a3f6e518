//! What a tile shows on a cube face follows from that face alone, so that neighbours meet.

#[path = "common/shells.rs"]
mod shells;
#[path = "common/solids.rs"]
mod solids_common;

use std::collections::BTreeMap;

use houscaper::cubes::CubeKey;
use houscaper::tiles::solids::{Columns, Half, Post, SolidStyle, body};
use houscaper::tiles::{Block, Component};
use houscaper::voxels::{Direction, Label};
use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;
use solids_common::{layered_keys, posts, random_keys};

/// Outline of a region as directed intervals on lines: line (direction, offset) to places where the number of edges along it changes,
/// so that the same region has the same outline however it is cut into polygons.
type Outline = BTreeMap<([i64; 2], i64), BTreeMap<i64, i64>>;
/// Regions by what they are.
type Section = BTreeMap<(Component, u8), Outline>;

fn gcd(a: i64, b: i64) -> i64 {
    if b == 0 { a } else { gcd(b, a % b) }
}

fn add(outline: &mut Outline, polygon: &[[i64; 2]]) {
    for (n, a) in polygon.iter().enumerate() {
        let b = polygon[(n + 1) % polygon.len()];
        let d = [b[0] - a[0], b[1] - a[1]];
        let unit = gcd(d[0].abs(), d[1].abs()) * if d < [0, 0] { -1 } else { 1 };
        let d = d.map(|c| c / unit);
        let along = |p: [i64; 2]| if d[0] != 0 { p[0] } else { p[1] };
        let line = outline.entry((d, d[0] * a[1] - d[1] * a[0])).or_default();
        *line.entry(along(*a)).or_default() += 1;
        *line.entry(along(b)).or_default() -= 1;
    }
}

/// Faces of blocks on the plane `axis` = `at`, as outlines in the other two axes; `name` says what region a block belongs to.
fn section(blocks: &[Block], axis: usize, at: i32, name: impl Fn(&Block) -> Option<(Component, u8)>) -> Section {
    let mut section = Section::new();
    for block in blocks {
        let Some(name) = name(block) else { continue };
        for face in block.faces().iter().filter(|f| f.iter().all(|p| p[axis] == at)) {
            let [u, v] = [(axis + 1) % 3, (axis + 2) % 3];
            let mut polygon: Vec<[i64; 2]> = face.iter().map(|p| [p[u], p[v]].map(i64::from)).collect();
            let turn = |n: usize| {
                let q = polygon[(n + 1) % polygon.len()];
                polygon[n][0] * q[1] - polygon[n][1] * q[0]
            };
            if (0..polygon.len()).map(turn).sum::<i64>() < 0 {
                polygon.reverse();
            }
            add(section.entry(name).or_default(), &polygon);
        }
    }
    for outline in section.values_mut() {
        outline.values_mut().for_each(|line| line.retain(|_, change| *change != 0));
        outline.retain(|_, line| !line.is_empty());
    }
    section.retain(|_, outline| !outline.is_empty());
    section
}

/// The columns on a face in rising order.
fn face_columns(side: Direction) -> [usize; 2] {
    [[1, 3], [2, 3], [0, 2], [0, 1]][side as usize]
}

/// All that a vertical face may depend on: its labels, its number, which of its decks are walked on, where its walls give way to an
/// opening, and whether a roof whose face curve is level is built as a level or a sloped roof.
type FaceKey = (usize, [Label; 4], u8, [bool; 2], [[bool; 2]; 2], [bool; 2]);

fn vertical(key: CubeKey, columns: &Columns, blocks: &[Block], side: Direction) -> (FaceKey, Section) {
    let axis = side as usize % 2;
    let at = if matches!(side, Direction::East | Direction::North) { 900_000 } else { 0 };
    let qs = face_columns(side);
    let local = |b: &Block| {
        let q = qs.iter().position(|q| *q == usize::from(b.octant % 4))?;
        Some((b.component, q as u8 + 2 * (b.octant / 4)))
    };
    let section = section(blocks, axis, at, local);
    let labels = [qs[0], qs[1], qs[0] + 4, qs[1] + 4].map(|n| key.label(n));
    let openings = qs.map(|q| [Half::Lower, Half::Upper].map(|half| columns.infill(q, 1 - axis, half).is_some()));
    let level =
        [0, 1].map(|n| columns.post(qs[n]) == Post::Roof && section.contains_key(&(Component::FlatMembrane, n as u8)));
    ((axis, labels, key.face(side) as u8, qs.map(|q| key.walked(q)), openings, level), section)
}

fn prove(name: &str, keys: &[CubeKey]) {
    let (shells, style) = (shells::shells(), SolidStyle::default());
    let mut faces: BTreeMap<FaceKey, (CubeKey, Section)> = BTreeMap::new();
    let mut compared = 0;
    for &key in keys {
        let columns = Columns::new(key, &shells);
        let blocks = body(key, &style, &shells);
        for side in Direction::ALL {
            let (face, section) = vertical(key, &columns, &blocks, side);
            compared += 1;
            match faces.get(&face) {
                Some((first, expected)) => {
                    assert_eq!(expected, &section, "{first} and {key} differ on {side:?}: {face:?}")
                }
                None => drop(faces.insert(face, (key, section))),
            }
        }
    }
    println!("{name}: {compared} vertical faces, {} different ones", faces.len());
    assert!(faces.len() * 2 < compared);
}

#[test]
fn vertical_faces_of_layered_keys_follow_from_the_face() {
    prove("layered", &layered_keys(&mut ChaCha8Rng::seed_from_u64(3)));
}

#[test]
fn vertical_faces_of_any_labels_follow_from_the_face() {
    // Few labels, so that faces repeat.
    let mut keys = random_keys(&mut ChaCha8Rng::seed_from_u64(6), 10_000);
    for key in &mut keys {
        let labels = key.labels().map(|l| match l {
            Label::Window | Label::Opening => Label::Base,
            other => other,
        });
        *key = CubeKey::new(labels, key.faces(), key.walked_columns());
    }
    prove("random", &keys);
}

/// Labels above, columns filled above only, faces at which a roof goes on, openings.
type UpperKey = ([Label; 4], [bool; 4], [bool; 4], [[bool; 2]; 4]);

/// The upper face: where walls and floors stand follows from the labels above, from which columns are filled above only, from where
/// a roof goes on beside a full column, and from where openings are.
#[test]
fn upper_faces_follow_from_the_face() {
    let (shells, style) = (shells::shells(), SolidStyle::default());
    let mut faces: BTreeMap<UpperKey, (CubeKey, Section)> = BTreeMap::new();
    for key in layered_keys(&mut ChaCha8Rng::seed_from_u64(3)) {
        let columns = Columns::new(key, &shells);
        // Behind a roof a wall has insulation in place of cladding: that is no other place.
        let wall = [Component::Cladding, Component::Band, Component::WallInsulation, Component::WallLining];
        let name = |b: &Block| {
            let up = b.top.iter().all(|z| *z == 540_000) && b.octant >= 4;
            up.then_some((if wall.contains(&b.component) { Component::Cladding } else { b.component }, 0))
        };
        let section = section(&body(key, &style, &shells), 2, 540_000, name);
        let face = (
            [4, 5, 6, 7].map(|n| key.label(n)),
            posts(&columns).map(|p| p == Post::Floor),
            key.faces().map(|n| n.continues()),
            [0, 1, 2, 3].map(|q| [0, 1].map(|axis| columns.infill(q, axis, Half::Upper).is_some())),
        );
        match faces.get(&face) {
            Some((first, expected)) => assert_eq!(expected, &section, "{first} and {key} differ above: {face:?}"),
            None => drop(faces.insert(face, (key, section))),
        }
    }
    println!("{} different upper faces", faces.len());
    assert!(faces.len() > 100);
}

#[test]
fn the_cut_of_a_region_does_not_matter_and_its_place_does() {
    let cuboid = |low, high| Block::cuboid(Component::Cladding, 0, low, high);
    let name = |b: &Block| Some((b.component, b.octant));
    let whole = section(&[cuboid([0; 3], [9, 20, 20])], 0, 0, name);
    let cut = [cuboid([0; 3], [9, 20, 5]), cuboid([0, 0, 5], [9, 7, 20]), cuboid([0, 7, 5], [9, 20, 20])];
    assert_eq!(whole, section(&cut, 0, 0, name));
    assert_ne!(whole, section(&cut[..2], 0, 0, name));
    assert_ne!(whole, section(&[cuboid([0; 3], [9, 20, 21])], 0, 0, name));
}
