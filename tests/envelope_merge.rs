//! Merging blocks: the surface closes, encloses exactly what the blocks hold, and does not depend on their order.

use houscaper::envelope::{Merge, MergeError, Solid};
use houscaper::tiles::{Block, Component};
use proptest::prelude::*;

const C: Component = Component::Cladding;

fn cube(at: [i32; 3], size: i32) -> Block {
    Block::cuboid(C, 0, at.map(|c| c * size), at.map(|c| (c + 1) * size))
}

fn merged<'a>(blocks: impl IntoIterator<Item = &'a Block>) -> Result<Solid, MergeError> {
    let mut merge = Merge::new();
    blocks.into_iter().for_each(|b| merge.add_block(b, [0; 3]));
    merge.finish()
}

fn sound(blocks: &[Block]) -> Solid {
    let solid = merged(blocks).expect("disjoint blocks");
    let report = solid.report();
    assert_eq!((report.open_edges, report.degenerate_triangles), (0, 0));
    assert_eq!(solid.six_volumes(), blocks.iter().map(Block::six_volumes).sum::<i128>(), "volume");
    assert_eq!(merged(blocks.iter().rev()).expect("disjoint"), solid, "order");
    let mut again = Merge::new();
    again.add_solid(&solid);
    assert_eq!(again.finish().expect("a solid"), solid, "idempotence");
    solid
}

#[test]
fn a_wall_of_cubes_is_a_box() {
    let blocks: Vec<Block> = (0..60).map(|i| cube([i % 5, i / 5 % 4, i / 20], 90_000)).collect();
    let solid = sound(&blocks);
    assert_eq!((solid.vertices.len(), solid.faces.len(), solid.triangle_count()), (8, 6, 12));
}

#[test]
fn a_frame_has_a_hole_on_two_sides() {
    let blocks: Vec<Block> = (0..9).filter(|&i| i != 4).map(|i| cube([i % 3, i / 3, 0], 1000)).collect();
    let solid = sound(&blocks);
    assert_eq!((solid.vertices.len(), solid.faces.len()), (16, 10));
    assert_eq!(solid.faces.iter().filter(|f| f.holes.len() == 1).count(), 2);
    assert_eq!(solid.triangle_count(), 2 * 8 + 8 * 2);
}

#[test]
fn blocks_that_touch_along_an_edge_or_in_a_point_stay_sound() {
    let edge = sound(&[cube([0, 0, 0], 10), cube([1, 1, 0], 10)]);
    assert_eq!(edge.report().crowded_edges, 1);
    let point = sound(&[cube([0, 0, 0], 10), cube([1, 1, 1], 10)]);
    assert_eq!((point.report().crowded_edges, point.vertices.len()), (0, 15));
    // Edges of faces that look up and down cross where the two touch.
    let slabs = [Block::cuboid(C, 0, [0, 0, 0], [20, 20, 10]), Block::cuboid(C, 0, [10, 10, 10], [30, 30, 20])];
    sound(&slabs);
    let board: Vec<Block> = (0..64)
        .map(|i| [i % 4, i / 4 % 4, i / 16])
        .filter(|c| c.iter().sum::<i32>() % 2 == 0)
        .map(|c| cube(c, 7))
        .collect();
    assert!(sound(&board).report().crowded_edges > 0);
}

#[test]
fn a_missing_face_and_an_overlap_are_caught() {
    let blocks = [cube([0, 0, 0], 10), cube([1, 0, 0], 10), cube([1, 1, 0], 10)];
    let faces: Vec<Vec<[i64; 3]>> =
        blocks.iter().flat_map(Block::faces).map(|f| f.iter().map(|p| p.map(i64::from)).collect()).collect();
    let without = |left_out: Option<usize>| {
        let mut merge = Merge::new();
        faces.iter().enumerate().filter(|(n, _)| Some(*n) != left_out).for_each(|(_, f)| merge.add_face(f));
        merge.finish()
    };
    assert_eq!(without(None).expect("whole").six_volumes(), 18_000);
    for n in 0..faces.len() {
        // In its own plane the rest may well be a region, so it is the closing of the surface that tells.
        assert!(without(Some(n)).is_ok_and(|s| s.report().open_edges > 0) || without(Some(n)).is_err(), "face {n}");
    }
    assert!(merged(&[cube([0, 0, 0], 10), Block::cuboid(C, 0, [0; 3], [10, 10, 20])]).is_err());
}

/// Roof pieces over the unit squares of a grid: heights are linear on 3 : 5, so all roofs of one slope lie in common planes.
fn ridge(n: i32, m: i32) -> Vec<Block> {
    let piece = |x: i32, y: i32| {
        let (at, top) = (x * 500, |x: i32| 3 * x.min(2 * n - x) * 100 + 50);
        let plan = vec![[at, y * 500], [at + 500, y * 500], [at + 500, y * 500 + 500], [at, y * 500 + 500]];
        let top = vec![top(x), top(x + 1), top(x + 1), top(x)];
        Block { component: C, octant: 0, plan, bottom: top.iter().map(|t| t - 50).collect(), top }
    };
    (0..2 * n).flat_map(|x| (0..m).map(move |y| (x, y))).map(|(x, y)| piece(x, y)).collect()
}

#[test]
fn a_saddle_roof_has_eight_faces() {
    let solid = sound(&ridge(5, 7));
    assert_eq!(solid.faces.len(), 8, "two planes above, two below, two eaves, two verges");
    assert_eq!(solid.vertices.len(), 12);
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(200))]

    #[test]
    fn unions_of_cubes(cells in prop::collection::vec(any::<bool>(), 125)) {
        let blocks: Vec<Block> = cells.iter().enumerate().filter(|c| *c.1)
            .map(|(i, _)| cube([i as i32 % 5, i as i32 / 5 % 5, i as i32 / 25], 450_000)).collect();
        sound(&blocks);
    }

    /// Cells cut along either diagonal into triangular prisms with bottoms and tops that slope differently from cell to cell.
    #[test]
    fn unions_of_prisms(cells in prop::collection::vec((0..4u8, 0..4i32, 1..4i32, -1..2i32), 16)) {
        let mut blocks = Vec::new();
        for (i, &(kind, low, rise, slope)) in cells.iter().enumerate() {
            let (x, y) = (i as i32 % 4 * 50, i as i32 / 4 * 50);
            let square = [[x, y], [x + 50, y], [x + 50, y + 50], [x, y + 50]];
            let plan: Vec<[i32; 2]> = match kind {
                0 => continue,
                1 => square.to_vec(),
                2 => vec![square[0], square[1], square[2]],
                _ => vec![square[1], square[2], square[3]],
            };
            let top = plan.iter().map(|p| (low + rise) * 30 + slope * (p[0] - x) * 3 / 5).collect();
            let bottom = vec![low * 30 - 30; plan.len()];
            blocks.push(Block { component: C, octant: 0, plan, bottom, top });
        }
        sound(&blocks);
    }
}
