//! Storeys, areas, openings and stairs as read from voxels.

use houscaper::voxels::{Direction, FacadeOpening, House, Label, Module, infer_stairs, read_storeys, samples};
use proptest::prelude::*;

#[test]
fn box_house_has_one_storey_with_the_area_inside_its_lining() {
    let reading = read_storeys(&samples::box_house());
    assert_eq!(reading.plates.iter().map(|p| p.k).collect::<Vec<_>>(), [0, 6]);
    let [storey] = &reading.storeys[..] else { panic!("one storey expected") };
    assert_eq!(storey.plan.count(), 42);
    assert!((storey.gross_area_m2 - 42.0 * 0.81).abs() < 1e-9);
    assert!((storey.floor_area_m2 - 5.7 * 4.8).abs() < 1e-9);
    assert!((storey.clear_height_m - 3.06).abs() < 1e-9);
}

#[test]
fn l_plan_follows_the_corner_formula() {
    let reading = read_storeys(&samples::l_house());
    let storey = &reading.storeys[0];
    // A = 56 cells, P = 36 modules, five convex corners and one re-entrant one.
    let expected = 56.0 * 0.81 - 0.3 * 36.0 * 0.9 + 0.09 * (5.0 - 1.0);
    assert!((storey.floor_area_m2 - expected).abs() < 1e-9, "{} {expected}", storey.floor_area_m2);
}

#[test]
fn hip_house_loses_the_void_above_and_the_low_flight_below() {
    let reading = read_storeys(&samples::hip_house());
    assert_eq!(reading.storeys.len(), 2, "a roof space of three layers is no storey");
    let full = (7.2 - 0.6) * (6.3 - 0.6);
    // Runs 0, 1 and 2 begin 0, 0.54 and 1.08 m above the floor; run 3 begins at 1.62 m.
    assert!((reading.storeys[0].floor_area_m2 - (full - 3.0 * 0.81)).abs() < 1e-9);
    assert!((reading.storeys[1].floor_area_m2 - (full - 8.0 * 0.81)).abs() < 1e-9);
    assert_eq!(reading.plates[1].void.count(), 8);
}

#[test]
fn a_roof_space_becomes_a_storey_with_standing_room() {
    let with_rise = |rise| read_storeys(&samples::massing([14, 14, 16], &[&[[1, 1, 12, 12]]], rise)).storeys.len();
    // n layers under the roof leave (n + 0.5) 0.54 - 0.291 m: 2.139 m for 4, 2.679 m for 5.
    assert_eq!(with_rise(4), 1);
    assert_eq!(with_rise(5), 2);
}

#[test]
fn openings_are_rectangles_with_the_direction_they_face() {
    let reading = read_storeys(&samples::box_house());
    let opening =
        |label, facing, cell, width, k, height| FacadeOpening { label, storey: 0, facing, cell, width, k, height };
    assert_eq!(
        reading.openings,
        [
            opening(Label::Opening, Direction::South, [2, 1], 1, 1, 4),
            opening(Label::Window, Direction::South, [4, 1], 3, 2, 3),
            opening(Label::Window, Direction::East, [7, 3], 2, 2, 3),
        ]
    );
    let glass = reading.openings.iter().map(|o| o.glass_area_m2(&Module::default())).collect::<Vec<_>>();
    assert_eq!(glass[0], 0.0);
    assert!((glass[1] - (2.7 - 0.12 - 0.044) * 1.5).abs() < 1e-12);
}

#[test]
fn stairs_are_found_again_from_their_voids() {
    for (name, house) in samples::all() {
        assert_eq!(infer_stairs(&house.voxels), house.stairs, "{name}");
    }
}

#[test]
fn empty_and_flat_arrays_read_as_nothing() {
    for shape in [[0, 0, 0], [3, 0, 2], [1, 1, 1], [4, 4, 12]] {
        let reading = read_storeys(&House::new(houscaper::voxels::VoxelArray::new(shape)));
        assert!(reading.plates.is_empty() && reading.storeys.is_empty() && reading.openings.is_empty());
    }
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

    /// Net area by cells equals A - 0.3 P + 0.09 (convex - concave) counted at the vertices, for unions of 3 x 3 blocks.
    #[test]
    fn net_area_equals_the_corner_formula(blocks in prop::collection::vec((1usize..9, 1usize..9), 1..6)) {
        let rects: Vec<[usize; 4]> = blocks.iter().map(|&(x, y)| [x, y, 3, 3]).collect();
        let house = samples::massing([13, 13, 7], &[&rects], 0);
        let reading = read_storeys(&house);
        let storey = &reading.storeys[0];
        let has = |x: isize, y: isize| storey.plan.has([x, y]);
        let (mut edges, mut turns) = (0, 0);
        for y in 0..13 {
            for x in 0..13 {
                edges += (has(x, y) != has(x - 1, y)) as i32 + (has(x, y) != has(x, y - 1)) as i32;
                let corner = [has(x, y), has(x - 1, y), has(x, y - 1), has(x - 1, y - 1)].iter().filter(|h| **h).count();
                let diagonal = has(x, y) == has(x - 1, y - 1) && has(x, y) != has(x - 1, y);
                turns += match corner { 1 => 1, 3 => -1, 2 if diagonal => 2, _ => 0 };
            }
        }
        let area = storey.plan.count() as f64 * 0.81 - 0.27 * edges as f64 + 0.09 * turns as f64;
        prop_assert!((storey.floor_area_m2 - area).abs() < 1e-9, "{} {}", storey.floor_area_m2, area);
    }

    /// Garbage never panics, and the fast sum equals the sum of the list.
    #[test]
    fn any_labels_are_read_and_checked(cells in prop::collection::vec(0u8..6, 5 * 4 * 14)) {
        use houscaper::voxels::{VoxelArray, rules};
        let labels = cells.iter().map(|&c| Label::from_code(c).unwrap_or_default()).collect();
        let house = House::new(VoxelArray::from_labels([5, 4, 14], labels).expect("5 x 4 x 14 labels"));
        let settings = rules::RuleSettings::default();
        let fast = rules::violation(&house, &read_storeys(&house), &settings, &mut rules::Scratch::default());
        let sum: f64 = rules::check(&house, &settings).iter().map(|v| v.amount).sum();
        prop_assert_eq!(fast, sum);
        infer_stairs(&house.voxels);
    }
}
