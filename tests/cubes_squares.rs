//! Boolean marching squares: the sixteen cases and the outlines of plans.

use houscaper::cubes::{SquareCase, contours};
use houscaper::voxels::Plan;

fn plan(rows: &[&str]) -> Plan {
    let mut plan = Plan::new([rows[0].len(), rows.len()]);
    for (y, row) in rows.iter().rev().enumerate() {
        for (x, _) in row.bytes().enumerate().filter(|(_, c)| *c == b'#') {
            plan.set([x, y], true);
        }
    }
    plan
}

fn doubled_area(points: &[[i32; 2]]) -> i32 {
    (0..points.len())
        .map(|i| {
            let (a, b) = (points[i], points[(i + 1) % points.len()]);
            a[0] * b[1] - a[1] * b[0]
        })
        .sum()
}

#[test]
fn the_sixteen_cases_have_one_path_per_run_of_filled_corners() {
    let paths: Vec<usize> = (0..16).map(|c| SquareCase(c).paths().count()).collect();
    assert_eq!(paths, [0, 1, 1, 1, 1, 1, 2, 1, 1, 2, 1, 1, 1, 1, 1, 0]);
    // Corner 0 alone: in through the bottom edge, out through the left one.
    assert_eq!(SquareCase(1).paths().collect::<Vec<_>>(), [[0, 3]]);
    // Filling the complement walks the same edges the other way, wherever the contour is not ambiguous.
    for case in (0..16).filter(|c| ![6, 9].contains(c)) {
        let there: Vec<_> = SquareCase(case).paths().collect();
        let back: Vec<_> = SquareCase(15 - case).paths().map(|[i, o]| [o, i]).collect();
        assert_eq!(there, back, "case {case}");
    }
}

#[test]
fn one_cell_is_a_counter_clockwise_square() {
    let loops = contours(&plan(&["#"]));
    assert_eq!(loops.len(), 1);
    assert_eq!(doubled_area(&loops[0]), 8);
    let mut corners = loops[0].clone();
    corners.sort();
    assert_eq!(corners, [[-1, -1], [-1, 1], [1, -1], [1, 1]]);
}

#[test]
fn a_court_is_a_clockwise_loop() {
    let loops = contours(&plan(&["####", "#..#", "####"]));
    let mut areas: Vec<i32> = loops.iter().map(|l| doubled_area(l) / 2).collect();
    areas.sort();
    assert_eq!(areas, [-8, 48]);
    assert!(loops.iter().all(|l| l.len() == 4), "only corners are listed");
}

#[test]
fn cells_that_touch_diagonally_stay_apart() {
    assert_eq!(contours(&plan(&[".#", "#."])).len(), 2);
}

#[test]
fn areas_and_turnings_of_all_4_by_4_plans_add_up() {
    for bits in 0u32..1 << 16 {
        let mut plan = Plan::new([4, 4]);
        for n in (0..16).filter(|n| bits >> n & 1 == 1) {
            plan.set([n % 4, n / 4], true);
        }
        let loops = contours(&plan);
        let area: i32 = loops.iter().map(|l| doubled_area(l)).sum();
        assert_eq!(area, 8 * plan.count() as i32);
        for l in &loops {
            for i in 0..l.len() {
                let (a, b) = (l[i], l[(i + 1) % l.len()]);
                assert!((a[0] == b[0]) != (a[1] == b[1]), "steps run along one axis and change it at every corner");
            }
        }
    }
}
