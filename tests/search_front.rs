//! Hypervolume against inclusion-exclusion and known values; sorting, crowding and the named houses.

use houscaper::search::Score;
use houscaper::search::contribution::{contributions, exclusive, spread_subset, without_least};
use houscaper::search::hypervolume::{hypervolume, reference_point};
use houscaper::search::nsga3::{Niches, das_dennis};
use houscaper::search::select::{Reason, named_houses, shape_distance};
use houscaper::search::sorting::{crowding, sort_fronts};
use houscaper::voxels::{Label, VoxelArray};
use proptest::prelude::*;

/// Inclusion-exclusion over all subsets of boxes.
fn by_inclusion_exclusion(points: &[Vec<f64>], reference: &[f64]) -> f64 {
    (1..1usize << points.len())
        .map(|subset| {
            let chosen: Vec<&Vec<f64>> =
                (0..points.len()).filter(|i| subset >> i & 1 == 1).map(|i| &points[i]).collect();
            let volume: f64 = (0..reference.len())
                .map(|m| (reference[m] - chosen.iter().map(|p| p[m]).fold(f64::MIN, f64::max)).max(0.0))
                .product();
            if chosen.len() % 2 == 1 { volume } else { -volume }
        })
        .sum()
}

proptest! {
    #[test]
    fn hypervolume_equals_inclusion_exclusion(
        (dimensions, points) in (1usize..=5).prop_flat_map(|d| {
            (Just(d), prop::collection::vec(prop::collection::vec(0u8..12, d), 1..8))
        })
    ) {
        let points: Vec<Vec<f64>> = points.iter().map(|p| p.iter().map(|&v| f64::from(v)).collect()).collect();
        let reference = vec![10.0; dimensions];
        let slices: Vec<&[f64]> = points.iter().map(Vec::as_slice).collect();
        let exact = by_inclusion_exclusion(&points, &reference);
        prop_assert!((hypervolume(&slices, &reference) - exact).abs() < 1e-9 * exact.max(1.0));
    }
}

#[test]
fn known_values() {
    // A staircase of n points (i, n-1-i) up to (n, n) covers 1 + 2 + ... + n unit squares.
    for n in 1..50 {
        let points: Vec<[f64; 2]> = (0..n).map(|i| [f64::from(i), f64::from(n - 1 - i)]).collect();
        let slices: Vec<&[f64]> = points.iter().map(|p| &p[..]).collect();
        assert_eq!(hypervolume(&slices, &[f64::from(n); 2]), f64::from(n * (n + 1) / 2));
    }
    // LOTZ (Laumanns et al. 2004) with n bits, minimised: front (-i, -(n-i)), reference (0, 0): n (n - 1) / 2.
    for n in 2..20 {
        let points: Vec<[f64; 2]> = (0..=n).map(|i| [-f64::from(i), -f64::from(n - i)]).collect();
        let slices: Vec<&[f64]> = points.iter().map(|p| &p[..]).collect();
        assert_eq!(hypervolume(&slices, &[0.0; 2]), f64::from(n * (n - 1) / 2));
    }
    assert_eq!(hypervolume(&[], &[1.0; 3]), 0.0);
    assert_eq!(hypervolume(&[&[2.0, 0.0, 0.0]], &[1.0; 3]), 0.0);
}

fn cloud(dimensions: usize, count: usize, seed: u64) -> Vec<Vec<f64>> {
    let mut state = seed;
    let mut next = || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 40) as f64 / (1u64 << 24) as f64
    };
    (0..count).map(|_| (0..dimensions).map(|_| next()).collect()).collect()
}

/// What a point adds is the volume with it less the volume without it, whatever the others.
#[test]
fn exclusive_volume_equals_the_difference_of_volumes() {
    for dimensions in 2..=5 {
        for seed in 0..20 {
            let points = cloud(dimensions, 12, 100 * dimensions as u64 + seed);
            let slices: Vec<&[f64]> = points.iter().map(Vec::as_slice).collect();
            let reference = vec![0.9; dimensions];
            let whole = hypervolume(&slices, &reference);
            for (i, adds) in contributions(&slices, &reference).into_iter().enumerate() {
                let others: Vec<&[f64]> = (0..slices.len()).filter(|j| *j != i).map(|j| slices[j]).collect();
                let expected = whole - hypervolume(&others, &reference);
                assert!((adds - expected).abs() < 1e-12, "{dimensions} objectives: {adds} against {expected}");
            }
            assert_eq!(exclusive(&vec![0.95; dimensions], slices.iter().copied(), &reference), 0.0);
        }
    }
}

/// Both lazy selections against the plain ones that compute every value anew.
#[test]
fn lazy_selections_equal_the_plain_ones() {
    for (dimensions, seed) in [(2, 1), (3, 2), (3, 3), (4, 4)] {
        let points = cloud(dimensions, 40, seed);
        let slices: Vec<&[f64]> = points.iter().map(Vec::as_slice).collect();
        let reference = vec![1.1; dimensions];
        let mut chosen: Vec<usize> = Vec::new();
        for _ in 0..8 {
            let adds = |i: &usize| exclusive(slices[*i], chosen.iter().map(|&j| slices[j]), &reference);
            let best = (0..slices.len()).max_by(|a, b| adds(a).total_cmp(&adds(b)).then(b.cmp(a))).expect("points");
            // Of a small front the greedy choice ends where nothing adds any more.
            if adds(&best) > 0.0 {
                chosen.push(best);
            }
        }
        assert!(chosen.len() > 3);
        assert_eq!(spread_subset(&slices, &reference, 8), chosen);
        let mut left: Vec<usize> = (0..slices.len()).collect();
        while left.len() > 10 {
            let adds =
                |i: &usize| exclusive(slices[*i], left.iter().filter(|j| *j != i).map(|&j| slices[j]), &reference);
            let least = *left.iter().min_by(|a, b| adds(a).total_cmp(&adds(b)).then(b.cmp(a))).expect("points");
            left.retain(|i| *i != least);
        }
        let kept: Vec<usize> = without_least(&slices, &reference, 10).into_iter().map(|k| k.0).collect();
        assert_eq!(kept, left);
    }
    // No more than add something, and an empty front has no subset.
    assert_eq!(spread_subset(&[&[0.0, 0.0], &[1.0, 1.0]], &[2.0, 2.0], 5), [0]);
    assert!(spread_subset(&[], &[1.0], 3).is_empty());
}

/// Das and Dennis: C(p + m - 1, m - 1) directions, each on the unit simplex; 91 for 3 objectives and 12 divisions, 210 for 5 and 6
/// (Deb, Jain 2014, table I).
#[test]
fn reference_directions_are_counted_as_published() {
    for (m, p, count) in [(2, 99, 100), (3, 12, 91), (5, 6, 210), (8, 3, 120)] {
        let directions = das_dennis(m, p);
        assert_eq!(directions.len(), count);
        assert!(directions.iter().all(|d| d.len() == m && (d.iter().sum::<f64>() - 1.0).abs() < 1e-12));
    }
    assert_eq!(Niches::new(3, 92).directions().len(), 91);
    assert_eq!(Niches::new(3, 90).directions().len(), 78);
    assert_eq!(Niches::new(2, 100).directions().len(), 100);
}

/// Of two tight clusters on one plane, niching takes from both; first fronts come whole, violated ones last and by violation.
#[test]
fn niches_take_from_every_direction() {
    let feasible = |objectives: &[f64]| Score { objectives: objectives.to_vec(), violation: 0.0 };
    let mut all: Vec<Score> = (0..6).map(|i| feasible(&[f64::from(i) * 0.01, 1.0 - f64::from(i) * 0.01])).collect();
    all.push(feasible(&[1.0, 0.0]));
    all.push(Score { objectives: vec![0.0, 0.0], violation: 0.5 });
    all.push(Score { objectives: vec![0.0, 0.0], violation: 0.1 });
    let scores: Vec<&Score> = all.iter().collect();
    let kept = Niches::new(2, 5).survivors(&scores, 3);
    assert!(kept.contains(&6) && kept.contains(&0), "{kept:?}");
    assert_eq!(Niches::new(2, 5).survivors(&scores, 9), [0, 1, 2, 3, 4, 5, 6, 8, 7]);
}

#[test]
fn the_reference_point_lies_a_tenth_of_the_range_beyond_the_worst() {
    let points = [vec![0.0, 5.0], vec![10.0, 5.0]];
    assert_eq!(reference_point(points.iter().map(Vec::as_slice)), Some(vec![11.0, 5.5]));
    assert_eq!(reference_point([]), None);
}

#[test]
fn fronts_put_feasible_before_violated() {
    let score = |objectives: &[f64], violation| Score { objectives: objectives.to_vec(), violation };
    let all = [
        score(&[1.0, 2.0], 0.0),
        score(&[2.0, 1.0], 0.0),
        score(&[2.0, 2.0], 0.0),
        score(&[0.0, 0.0], 0.3),
        score(&[], 0.2),
    ];
    let fronts = sort_fronts(&all.iter().collect::<Vec<_>>());
    assert_eq!(fronts, vec![vec![0, 1], vec![2], vec![4], vec![3]]);
}

#[test]
fn crowding_is_the_box_between_neighbours() {
    let scores: Vec<Score> =
        [[0.0, 4.0], [1.0, 2.0], [4.0, 0.0]].iter().map(|p| Score { objectives: p.to_vec(), violation: 0.0 }).collect();
    let distance = crowding(&scores.iter().collect::<Vec<_>>());
    assert_eq!(distance, [f64::INFINITY, 2.0, f64::INFINITY]);
}

#[test]
fn named_houses_are_distinct_and_say_why() {
    let shapes: Vec<VoxelArray> = (1..=6)
        .map(|n| {
            let mut v = VoxelArray::new([6, 2, 1]);
            (0..n).for_each(|x| v.set([x, 0, 0], Label::Base));
            v
        })
        .collect();
    let points: Vec<[f64; 2]> = (0..6).map(|i| [f64::from(i), f64::from((5 - i) * (5 - i))]).collect();
    let slices: Vec<&[f64]> = points.iter().map(|p| &p[..]).collect();
    let refs: Vec<&VoxelArray> = shapes.iter().collect();
    let named = named_houses(&slices, &refs, &["price_eur", "gwp_kgco2e"], Some(&shapes[4]));
    let picked: Vec<(usize, Reason)> = named.iter().map(|n| (n.index, n.reason)).collect();
    assert_eq!(picked[0], (0, Reason::Least(0)));
    assert_eq!(picked[1], (5, Reason::Least(1)));
    assert_eq!(picked[2], (2, Reason::BestBalance)); // (2, 9): sqrt((0.4^2 + 0.36^2) / 2) is the least
    assert_eq!(picked.len(), 5);
    assert_eq!(picked[4], (4, Reason::NearestReference));
    assert_eq!(named[0].name, "cheapest");
    assert!(named[4].sentence.contains("0 % of the voxels differ"), "{}", named[4].sentence);
    assert_eq!(shape_distance(&shapes[1], &shapes[3]), 0.5);
    assert!(named_houses(&[], &[], &["price_eur"], None).is_empty());
}
