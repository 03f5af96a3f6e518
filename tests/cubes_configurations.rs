//! The admissible configurations and their classes: the thesis's numbers, derived.

use houscaper::cubes::*;
use houscaper::voxels::{Label, VoxelArray};
use std::collections::BTreeSet;

/// Connectivity by the definition, not by bit tricks.
fn connected_by_search(corners: &[[u8; 3]]) -> bool {
    let Some(&first) = corners.first() else { return true };
    let mut reached = vec![first];
    let mut n = 0;
    while n < reached.len() {
        for &c in corners {
            let steps: i32 = (0..3).map(|a| (i32::from(c[a]) - i32::from(reached[n][a])).abs()).sum();
            if steps == 1 && !reached.contains(&c) {
                reached.push(c);
            }
        }
        n += 1;
    }
    reached.len() == corners.len()
}

#[test]
fn admissibility_of_all_256_masks_equals_a_plain_search() {
    for mask in Mask::all() {
        let corners = |filled: bool| -> Vec<[u8; 3]> {
            Corner::all().filter(|&c| mask.has(c) == filled).map(Corner::xyz).collect()
        };
        let expected = connected_by_search(&corners(true)) && connected_by_search(&corners(false));
        assert_eq!(mask.is_allowed(), expected, "{mask}");
    }
}

#[test]
fn there_are_126_masks_in_33_turn_classes_and_26_classes() {
    assert_eq!(admissible_masks().count(), 126);
    assert_eq!(admissible_masks().map(turn_class).collect::<BTreeSet<_>>().len(), 33);
    assert_eq!(canonical_masks().len(), 26);
    assert_eq!(categories(), [11, 11, 3, 1], "roof, floor, wall, extra");
}

#[test]
fn the_admissible_set_is_closed_under_complement_and_symmetry() {
    for mask in admissible_masks() {
        assert!(mask.complement().is_admissible());
        for s in Symmetry::all() {
            assert!(s.mask(mask).is_admissible());
        }
        let (smallest, symmetry) = canonical(mask);
        assert_eq!(symmetry.mask(smallest), mask);
    }
}

#[test]
fn symmetries_are_eight_different_bijections_that_agree_with_points() {
    let images: BTreeSet<Vec<u8>> =
        Symmetry::all().map(|s| Corner::all().map(|c| s.corner(c).number()).collect()).collect();
    assert_eq!(images.len(), 8);
    for s in Symmetry::all() {
        for c in Corner::all() {
            let [x, y, z] = c.xyz().map(i32::from);
            let moved = s.point([900 * x, 900 * y, 540 * z], [900, 900, 540]);
            let [u, v, w] = s.corner(c).xyz().map(i32::from);
            assert_eq!(moved, [900 * u, 900 * v, 540 * w]);
        }
    }
}

#[test]
fn a_face_lists_its_corners_in_order() {
    for mask in Mask::all() {
        for axis in Axis::ALL {
            for high in [false, true] {
                let bits = Corner::all()
                    .filter(|c| (c.xyz()[axis as usize] == 1) == high)
                    .enumerate()
                    .fold(0u8, |b, (n, c)| b | u8::from(mask.has(c)) << n);
                assert_eq!(mask.face(axis, high), bits, "{mask} {axis:?} {high}");
            }
        }
    }
}

#[test]
fn thesis_ids_round_trip_exhaustively_in_both_orders() {
    for id in 0..ThesisId::COUNT {
        let id = ThesisId(id);
        for order in [CornerOrder::FOrder, CornerOrder::BoxCorners] {
            let labels = id.labels(order).expect("below 6^8");
            assert_eq!(ThesisId::new(&labels, order), id);
        }
        let boxed = id.reorder(CornerOrder::FOrder, CornerOrder::BoxCorners).expect("below 6^8");
        assert_eq!(boxed.reorder(CornerOrder::BoxCorners, CornerOrder::FOrder), Some(id));
        assert_eq!(boxed.mask(CornerOrder::BoxCorners), id.mask(CornerOrder::FOrder));
    }
    assert_eq!(ThesisId(ThesisId::COUNT).labels(CornerOrder::FOrder), None);
}

#[test]
fn the_first_corner_is_the_most_significant_digit_and_box_corners_swap_two_pairs() {
    let mut labels = [Label::Empty; 8];
    labels[0] = Label::Window;
    assert_eq!(ThesisId::new(&labels, CornerOrder::FOrder).0, 5 * 6u32.pow(7));
    labels = [Label::Empty; 8];
    labels[2] = Label::Floor;
    assert_eq!(ThesisId::new(&labels, CornerOrder::FOrder).0, 2 * 6u32.pow(5));
    assert_eq!(ThesisId::new(&labels, CornerOrder::BoxCorners).0, 2 * 6u32.pow(4));
}

#[test]
fn binary_ids_round_trip_through_the_thesis_scheme() {
    for mask in Mask::all() {
        for order in [CornerOrder::FOrder, CornerOrder::BoxCorners] {
            for label in Label::ALL.into_iter().filter(|l| l.is_filled()) {
                assert_eq!(ThesisId::of_mask(mask, label, order).mask(order), Some(mask));
            }
        }
        assert_eq!(topogenesis_id(mask, CornerOrder::FOrder), mask.0);
        let swapped = Mask(topogenesis_id(mask, CornerOrder::BoxCorners));
        assert_eq!(topogenesis_id(swapped, CornerOrder::BoxCorners), mask.0, "the swap is its own inverse");
    }
}

fn scattered(shape: [usize; 3], mut state: u64) -> VoxelArray {
    let mut voxels = VoxelArray::new(shape);
    for n in 0..shape.iter().product::<usize>() {
        state = state.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        let at = [n % shape[0], n / shape[0] % shape[1], n / (shape[0] * shape[1])];
        voxels.set(at, Label::from_code((state >> 33) as u8 % 6).expect("below 6"));
    }
    voxels
}

#[test]
fn the_fast_scan_visits_exactly_the_cubes_that_are_neither_empty_nor_full() {
    for (n, shape) in [[1, 1, 1], [3, 1, 2], [4, 5, 3], [2, 6, 6], [62, 2, 1], [63, 2, 2], [64, 1, 1], [130, 2, 2]]
        .into_iter()
        .enumerate()
    {
        let voxels = scattered(shape, n as u64);
        let mut fast = Vec::new();
        scan_masks(&voxels, |cube, mask| fast.push((cube, mask)));
        let ids = cube_ids(&voxels, IdScheme::TopoGenesis, CornerOrder::FOrder);
        assert_eq!(ids.shape, shape.map(|n| n + 1));
        let [nx, ny, _] = ids.shape;
        let slow: Vec<_> = ids
            .ids
            .iter()
            .enumerate()
            .filter(|(_, id)| **id != 0 && **id != 255)
            .map(|(n, id)| ([n % nx, n / nx % ny, n / (nx * ny)], Mask(*id as u8)))
            .collect();
        assert_eq!(fast, slow);
        for (cube, mask) in fast {
            assert_eq!(cube_mask(&voxels, cube), mask);
        }
    }
    scan_masks(&VoxelArray::new([0, 3, 2]), |cube, _| panic!("nothing to visit, but {cube:?}"));
}

#[test]
fn a_cube_id_keeps_the_labels() {
    let voxels = scattered([3, 4, 2], 7);
    let ids = cube_ids(&voxels, IdScheme::Thesis, CornerOrder::BoxCorners);
    let at = |c: [usize; 3]| ids.ids[c[0] + 4 * (c[1] + 5 * c[2])];
    for cube in [[0, 0, 0], [1, 2, 1], [3, 4, 2]] {
        assert_eq!(ThesisId(at(cube)).labels(CornerOrder::BoxCorners), Some(cube_labels(&voxels, cube)));
    }
}
