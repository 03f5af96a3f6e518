//! Hypervolume against inclusion-exclusion and known values; sorting, crowding and the named houses.

use houscaper::search::Score;
use houscaper::search::clusters::clusters;
use houscaper::search::contribution::{contributions, exclusive, spread_subset, without_least};
use houscaper::search::hypervolume::{hypervolume, reference_point};
use houscaper::search::knee::{knees, normalised, trade_offs};
use houscaper::search::look::{Distances, Look, shared};
use houscaper::search::nsga3::{Niches, das_dennis};
use houscaper::search::select::{Reason, knee_sentence, named_houses, plain, shape_distance};
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

fn near(found: f64, expected: f64) {
    assert!((found - expected).abs() < 1e-12, "{found}, by hand {expected}");
}

/// Price against area (negated): 100 to 140 EUR for 60 to 90 m2, cheap up to 80 m2 and dear beyond. Ranges are 40 EUR and 30 m2. At
/// (120, 80) the steps within a quarter of the range are those to (115, 75) and to (130, 83): back it gains 5/40 and loses 5/30, a ratio
/// of 4/3; onward it gains 3/30 and loses 10/40, 2.5. So its trade-off is 4/3, the largest; no other inner house is above 1.
#[test]
fn the_knee_of_a_known_front_is_where_area_turns_dear() {
    let front = [[100.0, -60.0], [109.0, -68.0], [115.0, -75.0], [120.0, -80.0], [130.0, -83.0], [140.0, -90.0]];
    let points: Vec<&[f64]> = front.iter().map(|p| &p[..]).collect();
    let ratios = trade_offs(&normalised(&points));
    near(ratios[3], 4.0 / 3.0);
    // (115, 75): back to (109, 68) it gains 6/40 and loses 7/30; on to (120, 80) it gains 5/30 and loses 5/40, the lesser: 3/4.
    near(ratios[2], 0.75);
    let found = knees(&points);
    assert_eq!(found.iter().map(|k| k.index).collect::<Vec<_>>(), [3]);
    near(found[0].trade_off, 4.0 / 3.0);
    // Forwards 3 of 80 m2 cost 10 of 120 EUR, backwards 5 of 80 m2 had cost 5 of 120 EUR.
    let exchange = found[0].exchange.expect("both sides are there");
    assert_eq!((exchange.gained, exchange.paid), (1, 0));
    near(exchange.onward, (10.0 / 120.0) / (3.0 / 80.0));
    near(exchange.before, (5.0 / 120.0) / (5.0 / 80.0));
    let words = knee_sentence(&found[0], points[3], &["price_eur", "floor_area_m2"]);
    let expected =
        "from here on 1 % more floor area costs at least 2.2 % more price, up to here at most 0.7 %; any step";
    assert!(words.starts_with(expected), "{words}");
    // A third objective that goes with the price changes nothing: both count once.
    let doubled: Vec<[f64; 3]> = front.iter().map(|p| [p[0], 7.0 * p[0] + 5.0, p[1]]).collect();
    let doubled: Vec<&[f64]> = doubled.iter().map(|p| &p[..]).collect();
    trade_offs(&normalised(&doubled)).iter().zip(&ratios).for_each(|(a, b)| near(*a, *b));
    // A straight front has none, nor has one house, nor none.
    let straight: Vec<[f64; 2]> = (0..9).map(|i| [f64::from(i), -f64::from(i)]).collect();
    assert!(knees(&straight.iter().map(|p| &p[..]).collect::<Vec<_>>()).is_empty());
    assert!(knees(&points[..1]).is_empty() && knees(&[]).is_empty());
    assert_eq!(plain("gwp_kgco2e"), "carbon");
}

/// A house that is the knee and something else too has both names; the most different gives way to the reference.
#[test]
fn the_knee_is_named_and_six_names_are_enough() {
    let shapes: Vec<VoxelArray> = (1..=8)
        .map(|n| {
            let mut v = VoxelArray::new([8, 1, 1]);
            (0..n).for_each(|x| v.set([x, 0, 0], Label::Base));
            v
        })
        .collect();
    let points = [
        [0.0, 10.0, 4.0],
        [10.0, 0.0, 4.0],
        [9.0, 9.0, 0.0],
        [2.0, 2.0, 3.0],
        [2.5, 1.9, 3.1],
        [4.0, 1.0, 3.5],
        [1.0, 4.0, 3.5],
        [3.0, 3.0, 2.9],
    ];
    let slices: Vec<&[f64]> = points.iter().map(|p| &p[..]).collect();
    let refs: Vec<&VoxelArray> = shapes.iter().collect();
    let names = ["price_eur", "gwp_kgco2e", "mass_kg"];
    let named = named_houses(&slices, &refs, &names, Some(&shapes[6]));
    let knee = named.iter().find(|n| n.name.contains("knee")).expect("a knee");
    assert_eq!((knee.index, knee.name.as_str()), (3, "best balance, knee"));
    assert!(named.len() <= 6);
    assert_eq!(named.last().expect("names").reason, Reason::NearestReference);
    let mut houses: Vec<usize> = named.iter().map(|n| n.index).collect();
    houses.sort_unstable();
    houses.dedup();
    assert_eq!(houses.len(), named.len(), "no house twice");
}

/// 0, 1, 2 and 10, 11, 12 on a line: two groups around 1 and 11. Silhouettes by hand: of 1 it is (10 - 1) / 10, of 0 (11 - 1.5) / 11,
/// of 2 (9 - 1.5) / 9, and the other group is its mirror image.
#[test]
fn two_heaps_on_a_line_are_two_groups_around_their_middles() {
    let line = |at: &'static [f64]| move |a: usize, b: usize| f64::abs(at[a] - at[b]);
    let found = clusters(6, &line(&[0.0, 11.0, 1.0, 12.0, 2.0, 10.0]));
    assert_eq!(found.medoids, [1, 2]);
    assert_eq!(found.of, [1, 0, 1, 0, 1, 0]);
    near(found.silhouette, (0.9 + 9.5 / 11.0 + 7.5 / 9.0) / 3.0);
    assert_eq!(found.structure(), "strong");
    assert_eq!(found.members(1), [2, 0, 4]);
    // Three heaps: two groups of them would be strong too, but three are wider.
    let three = clusters(6, &line(&[0.0, 20.0, 1.0, 41.0, 21.0, 40.0]));
    assert_eq!(three.of, [0, 1, 0, 2, 1, 2]);
    let one = clusters(1, &|_, _| 0.0);
    assert_eq!((one.medoids, one.of, one.silhouette), (vec![0], vec![0], 0.0));
    let same = clusters(5, &|_, _| 0.0);
    assert_eq!((same.medoids, same.of), (vec![0], vec![0; 5]));
    let equal = clusters(5, &|a, b| f64::from(u8::from(a != b)));
    assert_eq!(equal.of, [0; 5], "all as far from each other: no groups");
    assert!(clusters(0, &|_, _| 0.0).of.is_empty());
}

/// More things than are grouped at once: those left out join the nearest medoid.
#[test]
fn a_large_front_is_grouped_by_a_part_of_it() {
    let at = |i: usize| if i.is_multiple_of(7) { 100.0 + i as f64 * 1e-3 } else { i as f64 * 1e-3 };
    let found = clusters(1000, &|a, b| f64::abs(at(a) - at(b)));
    assert_eq!(found.medoids.len(), 2);
    let first = found.of[0];
    assert!((0..1000).all(|i| (found.of[i] == first) == i.is_multiple_of(7)));
}

fn look(storeys: usize, footprint_m2: f64, south: f64) -> Look {
    Look {
        storeys,
        footprint_m2,
        corners: 4,
        aspect: 1.5,
        setback: 0.0,
        overhang: 0.0,
        roof_rise: 3,
        glass_m2: [10.0 - south, 0.0, 0.0, south],
        material: "C24".into(),
    }
}

/// Gower by hand: of ten features that count the same, storeys differ by the whole range, the footprint by half of it, the glass per
/// floor area by what it comes to, and half of the glass faces another way.
#[test]
fn looks_are_as_far_apart_as_their_features() {
    let looks = [look(1, 50.0, 10.0), look(2, 60.0, 5.0), look(1, 70.0, 10.0)];
    let distances = Distances::new(&looks);
    let glazing = [10.0 / 50.0, 10.0 / 120.0, 10.0 / 70.0];
    let glass = (glazing[0] - glazing[1]) / (glazing[0] - glazing[1]);
    near(distances.between(0, 1), (1.0 + 0.5 + glass + 0.5) / 10.0);
    near(distances.between(0, 2), (1.0 + (glazing[0] - glazing[2]) / (glazing[0] - glazing[1])) / 10.0);
    assert_eq!(distances.between(1, 2), distances.between(2, 1));
    assert_eq!(distances.between(1, 1), 0.0);
    let words = shared(&[&looks[0], &looks[2]]);
    assert_eq!(
        words,
        "one storey, rectangular plan of 50 to 70 m², hipped roof, 100 % of the glass to the south, walls of C24"
    );
    assert!(shared(&[&looks[0], &looks[1]]).starts_with("1 to 2 storeys"));
}
