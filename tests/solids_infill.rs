//! Windows and doors of architectural tiles: every neighbourhood of infill labels, faces, closed cuts, glass as counted.

mod blocks;

use blocks::{first_fault, level_section, section, shells};
use houscaper::cubes::{CubeKey, FaceNumber, Symmetry, cube_labels, cube_shape};
use houscaper::tiles::solids::{Columns, Half, Post, SolidStyle, infill};
use houscaper::tiles::{Block, Component, Shells};
use houscaper::voxels::{Label, Module, is_admissible, read_storeys, samples};

const WALL_UM: i32 = 300_000;

fn built(key: CubeKey, style: &SolidStyle, shells: &Shells) -> Vec<Block> {
    let mut blocks = Vec::new();
    infill::build(&Columns::new(key, shells), style, &mut blocks);
    blocks
}

/// Keys with two full columns along the west side whose labels run through `palette` (four corners), and all that may stand in
/// front of them; quarter turns and mirrors of these are all places where infill can stand, but for reading two sides at once.
fn keys(palette: &[Label]) -> Vec<CubeKey> {
    let mut keys = Vec::new();
    let n = palette.len();
    for code in 0..n.pow(4) {
        let own = [0, 1, 2, 3].map(|i| palette[code / n.pow(i) % n]);
        for front in 0..3usize.pow(4) {
            // In front: empty, base or floor.
            let other = [0, 1, 2, 3].map(|i| [Label::Empty, Label::Base, Label::Floor][front / 3usize.pow(i) % 3]);
            let labels = [own[0], other[0], own[1], other[1], own[2], other[2], own[3], other[3]];
            let mask = (0..8).filter(|&i| labels[i].is_filled()).fold(0u8, |m, i| m | 1 << i);
            if mask != 255 && is_admissible(mask) {
                keys.push(CubeKey::new(labels, [FaceNumber::None; 4], 0));
            }
        }
    }
    keys
}

const PALETTE: [Label; 5] = [Label::Base, Label::Floor, Label::Foundation, Label::Opening, Label::Window];

#[test]
fn every_infill_is_valid_disjoint_and_in_its_zone() {
    let (style, shells) = (SolidStyle::default(), shells());
    let mut found = 0;
    for key in keys(&PALETTE) {
        let blocks = built(key, &style, &shells);
        found += usize::from(!blocks.is_empty());
        if let Some(fault) = first_fault(&blocks) {
            panic!("{key}: {fault}");
        }
        for block in &blocks {
            assert!(
                !key.label(block.octant as usize).is_slab() && key.label(block.octant as usize).is_infill(),
                "{key}"
            );
            let [x0, x1] = [block.plan.iter().map(|p| p[0]).min(), block.plan.iter().map(|p| p[0]).max()]
                .map(|v| v.expect("corners"));
            // The west columns' wall towards the east: from x = 450 inwards, sills project beyond.
            let nose = if block.component == Component::Sill { 45_000 } else { 0 };
            assert!(x0 >= 450_000 - WALL_UM && x1 <= 450_000 + nose, "{key}: {block:?}");
            assert!(block.plan.iter().all(|p| (0..=900_000).contains(&p[1])), "{key}: {block:?}");
            assert!(block.bottom.iter().all(|&z| z >= 0) && block.top.iter().all(|&z| z <= 540_000), "{key}");
        }
    }
    assert!(found > 1_000, "only {found} keys show infill");
}

/// A tampered set must be seen: the test above can fail.
#[test]
fn faults_are_seen() {
    let (style, shells) = (SolidStyle::default(), shells());
    let [e, w, b] = [Label::Empty, Label::Window, Label::Base];
    let key = CubeKey::of_labels([w, e, b, e, w, e, b, e]);
    let good = built(key, &style, &shells);
    assert_eq!(first_fault(&good), None);
    for n in 0..good.len() {
        for change in 0..3 {
            let mut bad = good.clone();
            match change {
                0 => bad[n].plan.reverse(),
                1 => bad[n].top.iter_mut().for_each(|z| *z = -1),
                _ => bad.push(good[n].clone()),
            }
            assert!(first_fault(&bad).is_some(), "change {change} of block {n} is not seen");
        }
    }
}

/// Whether the house rules' corner case stands in this cube: a window column that is the last of its wall on the cube's far side.
fn straight(key: CubeKey, shells: &Shells) -> bool {
    let columns = Columns::new(key, shells);
    [0, 2].iter().all(|&q| columns.post(q) == Post::Full)
}

/// On a cube face only the labels of that face count: all cubes that share them show the same section.
#[test]
fn sections_on_side_faces_follow_from_their_labels() {
    let (style, shells) = (SolidStyle::default(), shells());
    let mut seen: std::collections::HashMap<[Label; 4], (Vec<blocks::Piece>, CubeKey)> = Default::default();
    let mut compared = 0;
    for key in keys(&PALETTE).into_iter().filter(|k| straight(*k, &shells)) {
        let blocks = built(key, &style, &shells);
        // North face: corners 2, 3, 6, 7; the same face is the south face of the next cube, where these are 0, 1, 4, 5.
        for (face, at, side) in [([2, 3, 6, 7], 900_000, -1), ([0, 1, 4, 5], 0, 1)] {
            let labels = face.map(|c| key.label(c));
            // What projects before the facade keeps clear of edges that arrive from the side, which the face does not see.
            let cut: Vec<_> = section(&blocks, 1, at, side)
                .into_iter()
                .filter(|(component, line, _)| !(*component == Component::Sill && line[0] >= 450_000))
                .collect();
            match seen.get(&labels) {
                Some((first, other)) => {
                    assert_eq!(first, &cut, "{key} and {other}");
                    compared += 1;
                }
                None => {
                    seen.insert(labels, (cut, key));
                }
            }
        }
    }
    assert!(compared > 1_000 && seen.values().any(|(cut, _)| cut.len() >= 4));
}

/// What reaches the cube's top goes on at the bottom of the cube above, and the other way round.
#[test]
fn sections_on_level_faces_meet() {
    let (style, shells) = (SolidStyle::default(), shells());
    let mut met = 0;
    let n = PALETTE.len();
    for code in 0..n.pow(6) {
        let l = |i: u32| PALETTE[code / n.pow(i) % n];
        let e = Label::Empty;
        // A wall two columns long and three voxels high with nothing in front.
        let below = CubeKey::of_labels([l(0), e, l(1), e, l(2), e, l(3), e]);
        let above = CubeKey::of_labels([l(2), e, l(3), e, l(4), e, l(5), e]);
        let (lower, upper) = (built(below, &style, &shells), built(above, &style, &shells));
        let (head, foot) = (level_section(&lower, 540_000, true), level_section(&upper, 0, false));
        for (q, label, beside) in [(0, l(2), l(3)), (2, l(3), l(2))] {
            let mine = |cut: &[(Component, Vec<[i32; 2]>)]| -> Vec<_> {
                cut.iter().filter(|(_, plan)| (plan[0][1] < 450_000) == (q == 0)).cloned().collect()
            };
            if label.is_slab() {
                // Slabs interrupt: nothing reaches them from below, and what stands on them begins there.
                assert!(mine(&head).is_empty(), "{below}");
            } else if !beside.is_slab() {
                // Beside a slab the opening's border changes at the slab's top, which is this face: below it meets the band.
                assert_eq!(mine(&head), mine(&foot), "{below} under {above}");
                met += usize::from(!mine(&head).is_empty());
            }
        }
    }
    assert!(met > 1_000);
}

/// Bars stand at voxel borders only: where the neighbour goes on there is a mullion or nothing, and cube faces show only bars that
/// run through them.
#[test]
fn a_group_reads_as_one_opening() {
    let (style, shells) = (SolidStyle::default(), shells());
    let [e, w, b] = [Label::Empty, Label::Window, Label::Base];
    let volume = |blocks: &[Block], c: Component| -> f64 {
        blocks.iter().filter(|b| b.component == c).map(Block::volume_m3).sum()
    };
    let inner = built(CubeKey::of_labels([w, e, w, e, w, e, w, e]), &style, &shells);
    let mullion = 0.022 * 0.070 * 0.540;
    assert!((volume(&inner, Component::WindowFrame) - mullion).abs() < 1e-12);
    assert_eq!(volume(&inner, Component::Reveal), 0.0);
    let edge = built(CubeKey::of_labels([w, e, b, e, w, e, b, e]), &style, &shells);
    assert!((volume(&edge, Component::WindowFrame) - 0.060 * 0.070 * 0.540).abs() < 1e-12);
    // 100 mm outside and 130 mm inside of the frame.
    assert!((volume(&edge, Component::Reveal) - 0.230 * 0.015 * 0.540).abs() < 1e-12);
}

/// At each border against wall the boards, the frame and the sill together close the wall's whole cut.
#[test]
fn cuts_through_the_wall_are_closed() {
    let (style, shells) = (SolidStyle::default(), shells());
    let mut cuts = 0;
    for key in keys(&PALETTE) {
        let columns = Columns::new(key, &shells);
        let blocks = built(key, &style, &shells);
        for q in [0, 2] {
            for (half, z) in [(Half::Lower, [0, 270_000]), (Half::Upper, [270_000, 540_000])] {
                let Some(_) = columns.infill(q, 0, half) else { continue };
                if columns.infill(q ^ 2, 0, half).is_some() {
                    continue;
                }
                let side = if q == 0 { -1 } else { 1 };
                let area: i64 = section(&blocks, 1, 450_000, side)
                    .iter()
                    .map(|(_, line, h)| {
                        let height = i64::from(h[2].min(z[1]) - h[0].max(z[0])).max(0);
                        i64::from(line[1].min(450_000) - line[0].min(450_000)) * height
                    })
                    .sum();
                assert_eq!(area, i64::from(WALL_UM) * 270_000, "{key} column {q} {half:?}");
                cuts += 1;
            }
        }
    }
    assert!(cuts > 500);
}

/// The glass of the sample houses is what the take-off counts: frames and mullions are one truth.
#[test]
fn glass_is_what_is_counted() {
    let (style, shells) = (SolidStyle::default(), shells());
    for (name, house) in samples::all() {
        let mut volume = 0.0;
        let [nx, ny, nz] = cube_shape(&house.voxels);
        for cube in (0..nx * ny * nz).map(|i| [i % nx, i / nx % ny, i / nx / ny]) {
            let key = CubeKey::of_labels(cube_labels(&house.voxels, cube));
            volume += built(key, &style, &shells)
                .iter()
                .filter(|b| b.component == Component::Glass)
                .map(Block::volume_m3)
                .sum::<f64>();
        }
        let module = Module::default();
        let counted: f64 = read_storeys(&house)
            .openings
            .iter()
            .map(|o| {
                // A French window stands on the slab, half a module below the voxel that the count begins with.
                let slab = o.label == Label::Window && {
                    let [x, y] = o.cell;
                    house.voxels.get([x, y, o.k - 1]).is_slab()
                };
                let clear = 0.9 * o.width as f64 - 0.120 - 0.022 * (o.width as f64 - 1.0);
                o.glass_area_m2(&module) + if slab { 0.270 * clear } else { 0.0 }
            })
            .sum();
        assert!(counted > 1.0 && (volume / 0.012 - counted).abs() < 1e-9, "{name}: {} and {counted}", volume / 0.012);
    }
}

/// A quarter turn of the key turns the solids; a mirrored key keeps all volumes.
#[test]
fn solids_turn_with_their_key() {
    let (style, shells) = (SolidStyle::default(), shells());
    let volume = |blocks: &[Block]| blocks.iter().map(Block::six_volumes).sum::<i128>();
    let normal = |blocks: &[Block], symmetry: Symmetry| {
        let mut all: Vec<_> = blocks
            .iter()
            .map(|b| {
                let turn = |i: usize| symmetry.point([b.plan[i][0], b.plan[i][1], 0], [900_000; 3]);
                let mut corners: Vec<_> = (0..b.plan.len()).map(|i| (turn(i), b.bottom[i], b.top[i])).collect();
                corners.sort();
                (b.component, corners)
            })
            .collect();
        all.sort();
        all
    };
    for key in keys(&[Label::Base, Label::Floor, Label::Opening, Label::Window]) {
        let blocks = built(key, &style, &shells);
        for symmetry in Symmetry::all() {
            let placed = built(key.placed(symmetry), &style, &shells);
            assert_eq!(first_fault(&placed), None, "{key} {symmetry:?}");
            if !symmetry.mirror {
                assert_eq!(normal(&blocks, symmetry), normal(&placed, Symmetry::IDENTITY), "{key} {symmetry:?}");
            } else if key.labels().iter().all(|l| *l != Label::Opening) {
                assert_eq!(volume(&blocks), volume(&placed), "{key} {symmetry:?}");
            }
        }
    }
}

/// Every door has one pull outside and one inside, on the right-hand side seen from outside.
#[test]
fn a_door_has_one_pull_on_each_side() {
    let (style, shells) = (SolidStyle::default(), shells());
    let [e, d, b] = [Label::Empty, Label::Opening, Label::Base];
    let pulls =
        |key| built(key, &style, &shells).into_iter().filter(|b| b.component == Component::Handle).collect::<Vec<_>>();
    // Facing east, the right hand is north: the door's northern border, with wall in column 2.
    let right = pulls(CubeKey::of_labels([d, e, b, e, d, e, b, e]));
    assert_eq!(right.len(), 2, "one outside, one inside, without fixings where the door goes on");
    assert!(pulls(CubeKey::of_labels([b, e, d, e, b, e, d, e])).is_empty());
    assert!(pulls(CubeKey::of_labels([d, e, d, e, d, e, d, e])).is_empty());
}
