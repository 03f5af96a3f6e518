//! Edges of roofs and decks: every situation of columns, face numbers and walked decks gives valid, disjoint blocks in their zone,
//! and what reaches a cube face follows from that face.

mod blocks;

use std::collections::HashMap;

use blocks::{Piece, first_fault, section, shells};
use houscaper::cubes::{CubeKey, FaceNumber};
use houscaper::tiles::solids::{Columns, Post, Railing, SolidStyle, edges};
use houscaper::tiles::{Block, Component, Shells};
use houscaper::voxels::{Direction, Label, is_admissible};

fn built(key: CubeKey, style: &SolidStyle, shells: &Shells) -> Vec<Block> {
    let mut blocks = Vec::new();
    edges::build(&Columns::new(key, shells), style, &mut blocks);
    blocks
}

/// Every admissible set of columns with every number on its faces where a roof ends, and every walked deck.
fn keys(slabs: &[Label]) -> Vec<CubeKey> {
    let mut keys = Vec::new();
    let bottoms: Vec<Label> = [Label::Empty, Label::Base].into_iter().chain(slabs.iter().copied()).collect();
    let n = bottoms.len();
    for code in 0..n.pow(4) * 16 {
        let mut labels = [Label::Empty; 8];
        for q in 0..4 {
            labels[q] = bottoms[code / n.pow(q as u32) % n];
            labels[q + 4] = if code / n.pow(4) >> q & 1 == 1 { Label::Base } else { Label::Empty };
        }
        let mask = (0..8).filter(|&i| labels[i].is_filled()).fold(0u8, |m, i| m | 1 << i);
        if mask == 0 || mask == 255 || !is_admissible(mask) {
            continue;
        }
        let shells = shells();
        let columns = Columns::new(CubeKey::of_labels(labels), &shells);
        // Columns left and right on each face, in the order of `Direction::ALL`.
        let numbered = [[1, 3], [2, 3], [0, 2], [0, 1]]
            .map(|[a, b]| (columns.post(a) == Post::Roof) != (columns.post(b) == Post::Roof));
        let free = numbered.iter().filter(|n| **n).count() as u32;
        let decks = (0..4).filter(|&q| columns.post(q) == Post::Deck).fold(0u8, |m, q| m | 1 << q);
        for number in 0..5usize.pow(free) {
            let mut rest = number;
            let faces = numbered.map(|n| {
                if !n {
                    return FaceNumber::None;
                }
                let digit = rest % 5;
                rest /= 5;
                FaceNumber::ALL[1 + digit]
            });
            for walked in (0..16u8).filter(|w| w & !decks == 0) {
                keys.push(CubeKey::new(labels, faces, walked));
            }
        }
    }
    keys
}

fn styles() -> Vec<SolidStyle> {
    let base = SolidStyle::default();
    vec![
        base,
        SolidStyle { railing: Railing::Bars, parapet_um: 0, gutter: false, overhang_um: 400_000, ..base },
        SolidStyle { overhang_um: 0, parapet_um: 150_000, ..base },
    ]
}

#[test]
fn every_edge_is_valid_disjoint_and_in_its_zone() {
    let shells = shells();
    for style in styles() {
        let mut kinds: HashMap<Component, usize> = HashMap::new();
        for key in keys(&[Label::Floor]) {
            let columns = Columns::new(key, &shells);
            let blocks = built(key, &style, &shells);
            if let Some(fault) = first_fault(&blocks) {
                panic!("{key}: {fault}");
            }
            for block in &blocks {
                *kinds.entry(block.component).or_default() += 1;
                let q = block.octant as usize;
                match columns.post(q) {
                    Post::Roof => outside(key, &columns, block),
                    Post::Deck => in_zone(key, &columns, q, &style, block),
                    Post::Full | Post::Floor | Post::Empty => panic!("{key}: an edge in column {q}"),
                }
            }
        }
        let expected: &[Component] = match (style.gutter, style.overhang_um) {
            (true, 0) => &[Component::Coping, Component::Cladding, Component::RailingGlass],
            (true, _) => &[Component::Gutter, Component::Fascia, Component::RoofCovering, Component::Coping],
            (false, _) => &[Component::Fascia, Component::RoofCovering, Component::RailingRail],
        };
        assert!(expected.iter().all(|c| kinds.get(c).is_some_and(|n| *n > 50)), "{kinds:?}");
    }
}

/// What a roof carries outwards stands over empty columns only.
fn outside(key: CubeKey, columns: &Columns, block: &Block) {
    let n = block.plan.len() as i32;
    let middle = [0, 1].map(|k| block.plan.iter().map(|p| p[k]).sum::<i32>() / n);
    let column = usize::from(middle[0] > 450_000) + 2 * usize::from(middle[1] > 450_000);
    assert_eq!(columns.post(column), Post::Empty, "{key}: {block:?}");
    let (low, high) = quadrant(column);
    assert!(
        block.plan.iter().all(|p| (0..2).all(|k| (low[k]..=high[k]).contains(&p[k]))
            || (0..2).any(|k| p[k] == 450_000)
            || touches_two_empty(columns, block)),
        "{key}: {block:?}"
    );
}

/// A strip round an outer corner lies in two or three quadrants, all of them empty.
fn touches_two_empty(columns: &Columns, block: &Block) -> bool {
    block.plan.iter().all(|p| {
        (0..4).any(|q| {
            let (low, high) = quadrant(q);
            columns.post(q) == Post::Empty && (0..2).all(|k| (low[k]..=high[k]).contains(&p[k]))
        })
    })
}

fn quadrant(q: usize) -> ([i32; 2], [i32; 2]) {
    let low = [450_000 * (q as i32 & 1), 450_000 * (q as i32 >> 1)];
    (low, low.map(|l| l + 450_000))
}

/// What stands on a deck keeps to the zone that the deck's strata leave, below the surface exactly.
fn in_zone(key: CubeKey, columns: &Columns, q: usize, style: &SolidStyle, block: &Block) {
    let zone = edges::edge_zone_um(columns, q, style);
    assert!(zone > 0, "{key}");
    let surface = edges::deck_depth_um(columns, q);
    let below = block.bottom.iter().any(|&z| z < surface);
    let limit = match block.component {
        _ if below => [0, zone],
        Component::Coping => [-20_000, zone + 20_000],
        _ => [0, zone.max(85_000)],
    };
    for p in &block.plan {
        let d = distance(columns, q, *p);
        assert!((limit[0]..=limit[1]).contains(&d), "{key} at {d}: {block:?}");
    }
}

/// Distance to the outside, positive inside of it: the smaller one to the two borders at an outer corner, the larger one at an inner.
fn distance(columns: &Columns, q: usize, p: [i32; 2]) -> i32 {
    let d = [0, 1].map(|k| if q >> k & 1 == 0 { 450_000 - p[k] } else { p[k] - 450_000 });
    match edges::rim(columns, q) {
        edges::Rim::Straight(axis) => d[axis],
        edges::Rim::Convex => d[0].min(d[1]),
        edges::Rim::Concave => d[0].max(d[1]),
        edges::Rim::None => i32::MAX,
    }
}

/// Below a deck's surface the edge fills its zone wholly: with the strata behind it no gap stays.
#[test]
fn edge_zones_are_filled() {
    let shells = shells();
    let mut seen = 0;
    for style in styles() {
        for key in keys(&[Label::Floor]) {
            let columns = Columns::new(key, &shells);
            let blocks = built(key, &style, &shells);
            for q in 0..4 {
                let (zone, surface) = (edges::edge_zone_um(&columns, q, &style), edges::deck_depth_um(&columns, q));
                let [half, z] = [450_000, zone].map(i128::from);
                let area = match edges::rim(&columns, q) {
                    edges::Rim::None => 0,
                    edges::Rim::Straight(_) => half * z,
                    edges::Rim::Convex => half * half - (half - z) * (half - z),
                    edges::Rim::Concave => z * z,
                };
                let volume: i128 = blocks
                    .iter()
                    .filter(|b| b.octant as usize == q && b.bottom[0] < surface && columns.post(q) == Post::Deck)
                    .map(|b| b.six_volumes() * i128::from(surface) / i128::from(b.top[0].max(surface)))
                    .sum();
                assert_eq!(volume, 6 * area * i128::from(surface), "{key} column {q}");
                seen += usize::from(area > 0);
            }
        }
    }
    assert!(seen > 1_000);
}

/// The level roof's metal and the thickness of tiles on another slope are all that two cubes may show differently on one face.
fn plain(pieces: Vec<Piece>) -> Vec<(String, [i32; 2], i32)> {
    let name = |c: Component, line: [i32; 2]| match c {
        Component::Coping | Component::RoofCovering if line[1] - line[0] > 25_000 => "top".to_owned(),
        _ => c.name().to_owned(),
    };
    let mut plain: Vec<_> = pieces.into_iter().map(|(c, line, z)| (name(c, line), line, z[0])).collect();
    plain.sort();
    plain
}

#[test]
fn sections_on_side_faces_follow_from_the_face() {
    let shells = shells();
    for style in styles() {
        let mut seen: HashMap<_, (Vec<_>, CubeKey)> = HashMap::new();
        let (mut compared, mut rich) = (0, 0);
        for key in keys(&[Label::Floor]) {
            let blocks = built(key, &style, &shells);
            for (direction, columns, axis, at, side) in [
                (Direction::East, [1, 3], 0, 900_000, -1),
                (Direction::West, [0, 2], 0, 0, 1),
                (Direction::North, [2, 3], 1, 900_000, -1),
                (Direction::South, [0, 1], 1, 0, 1),
            ] {
                let labels = columns.map(|q| (key.label(q), key.label(q + 4), key.walked(q)));
                let face = (axis, labels, key.face(direction));
                let cut = plain(section(&blocks, axis, at, side));
                rich += usize::from(cut.len() >= 3);
                match seen.get(&face) {
                    Some((first, other)) => {
                        assert_eq!(first, &cut, "{key} and {other} on {face:?}");
                        compared += 1;
                    }
                    None => {
                        seen.insert(face, (cut, key));
                    }
                }
            }
        }
        assert!(compared > 10_000 && rich > 100, "{compared} faces, {rich} with three pieces");
    }
}

/// Nothing stands where no edge is: under a roof that goes on, beside walls, on paved foundations.
#[test]
fn no_edge_where_nothing_ends() {
    let (style, shells) = (SolidStyle::default(), shells());
    let [e, b, f, g] = [Label::Empty, Label::Base, Label::Floor, Label::Foundation];
    let none = FaceNumber::None;
    let roof = [b, e, b, e, e, e, e, e];
    let ends = |number| built(CubeKey::new(roof, [none, number, none, number], 0), &style, &shells);
    assert!(ends(FaceNumber::StepDown).is_empty() && ends(FaceNumber::StepUp).is_empty());
    assert!(!ends(FaceNumber::End0).is_empty() && !ends(FaceNumber::End1).is_empty());
    let deck = |l: Label, front: [Label; 2]| {
        built(CubeKey::new([l, front[0], l, front[0], e, front[1], e, front[1]], [none; 4], 15), &style, &shells)
    };
    assert!(!deck(f, [e, e]).is_empty());
    assert!(deck(f, [b, b]).is_empty(), "a wall beside the deck");
    assert!(deck(g, [e, e]).is_empty(), "paving");
}

/// Gutters hang along eaves only, and the styles' switches are obeyed.
#[test]
fn gutters_hang_along_eaves() {
    let shells = shells();
    let none = FaceNumber::None;
    let gutters = |number, gutter| {
        let labels = [Label::Base, Label::Empty, Label::Base, Label::Empty]
            .into_iter()
            .chain([Label::Empty; 4])
            .collect::<Vec<_>>();
        let labels: [Label; 8] = labels.try_into().expect("eight labels");
        let style = SolidStyle { gutter, ..SolidStyle::default() };
        let key = CubeKey::new(labels, [none, number, none, number], 0);
        built(key, &style, &shells).iter().filter(|b| b.component == Component::Gutter).count()
    };
    // Two columns, three sheets each.
    assert_eq!(gutters(FaceNumber::End0, true), 6);
    assert_eq!(gutters(FaceNumber::End0, false), 0);
    assert_eq!(gutters(FaceNumber::End1, true), 0);
}

/// The rail stands at its height above the deck's surface.
#[test]
fn railings_are_high_enough() {
    let (style, shells) = (SolidStyle::default(), shells());
    let mut labels = [Label::Empty; 8];
    labels[0] = Label::Floor;
    labels[2] = Label::Floor;
    let railing = |walked| {
        let blocks = built(CubeKey::new(labels, [FaceNumber::None; 4], walked), &style, &shells);
        blocks.iter().filter(|b| b.component == Component::RailingRail).map(|b| b.top[0]).max()
    };
    assert_eq!(railing(15), Some(230_000 + 1_000_000));
    assert_eq!(railing(0), None);
}
