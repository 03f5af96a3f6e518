//! The cubes that a house can contain: counts, a twin by brute force, and every cube of two thousand houses.

use std::collections::{BTreeMap, BTreeSet};

use houscaper::cubes::{
    Category, Corner, CubeKey, FaceNumber, Grouping, Level, Mask, Rule, Symmetry, keys_of, reachable_keys,
    reachable_labels, scan_keys,
};
use houscaper::search::massing::{Design, encode};
use houscaper::search::moves::Move;
use houscaper::search::plot::{ChoiceSpace, Plot, Programme, Space};
use houscaper::search::start::start;
use houscaper::voxels::rules::{RuleSettings, Scratch, violation};
use houscaper::voxels::{House, Label, read_storeys, samples};
use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;
use rayon::prelude::*;

const HOUSES: u64 = 2_000;

fn labels(digits: &str) -> [Label; 8] {
    let codes: Vec<Label> = digits.bytes().map(|d| Label::from_code(d - b'0').expect("a label")).collect();
    codes.try_into().expect("eight")
}

#[test]
fn the_set_is_counted_by_what_its_cubes_are() {
    let (configurations, keys) = (reachable_labels(), reachable_keys());
    let mut count: BTreeMap<&str, [usize; 2]> = BTreeMap::new();
    let name = |mask: Mask| if mask == Mask::FULL { "full" } else { Category::of(mask).name() };
    configurations.iter().for_each(|l| count.entry(name(Mask::of(l))).or_default()[0] += 1);
    keys.iter().for_each(|k| count.entry(name(k.mask())).or_default()[1] += 1);
    let classes = Grouping::TurnsAndMirror.classes(&configurations);
    println!("{} configurations ({classes} classes), {} keys: {count:?}", configurations.len(), keys.len());
    let masks: BTreeSet<Mask> = configurations.iter().map(Mask::of).collect();
    assert_eq!(masks.len(), 127, "every admissible mask is met, and the full cube");
    assert_eq!([configurations.len(), keys.len()], [2376, 12773]);
    assert!(keys.is_sorted() && keys.windows(2).all(|w| w[0] != w[1]));
    assert_eq!(keys.iter().map(|k| k.labels()).collect::<BTreeSet<_>>(), configurations.into_iter().collect());
}

#[test]
fn the_set_is_closed_under_turns_and_mirror() {
    let keys = reachable_keys();
    let wrong = keys.iter().find(|k| Symmetry::all().any(|s| keys.binary_search(&k.placed(s)).is_err()));
    assert_eq!(wrong, None);
}

/// The same rules told voxel by voxel and case by case, for one labelling at one level.
fn slow(l: &[Label; 8], level: Level) -> bool {
    use Label::{Base, Empty, Floor, Foundation, Opening, Window};
    let at = |x: usize, y: usize, z: usize| l[x + 2 * y + 4 * z];
    let filled = |set: &dyn Fn(usize) -> bool| {
        // Connected along edges: grow from the first member.
        let members: Vec<usize> = (0..8).filter(|&c| set(c)).collect();
        let mut reached: BTreeSet<usize> = members.iter().copied().take(1).collect();
        for _ in 0..8 {
            let more: Vec<usize> =
                reached.iter().flat_map(|c| [c ^ 1, c ^ 2, c ^ 4]).filter(|c| members.contains(c)).collect();
            reached.extend(more);
        }
        reached.len() == members.len()
    };
    if !filled(&|c| l[c] != Empty) || !filled(&|c| l[c] == Empty) {
        return false;
    }
    let is_plate = |z: usize| matches!((level, z), (Level::UnderPlate, 1) | (Level::OverPlate, 0));
    let is_ground = |z: usize| matches!((level, z), (Level::Ground, 1) | (Level::Foundation, 0));
    for c in Corner::all() {
        let [x, y, z] = c.xyz().map(usize::from);
        let own = at(x, y, z);
        if level == Level::Ground && z == 0 && own != Empty {
            return false;
        }
        let [ex, ey, up] = [at(1 - x, y, z), at(x, 1 - y, z), at(x, y, 1 - z)];
        let good = match own {
            Empty => true,
            Foundation => is_ground(z),
            Floor => is_plate(z),
            Base if is_ground(z) => false,
            Base if is_plate(z) => {
                // A stair's void: room above and below, the neighbours filled through.
                let lower_diagonal = level == Level::OverPlate || at(1 - x, 1 - y, 0) != Empty;
                up == Base
                    && [ex, ey, at(1 - x, y, 1 - z), at(x, 1 - y, 1 - z)].iter().all(|n| *n != Empty)
                    && lower_diagonal
            }
            Base => !(level == Level::Foundation && up == Empty),
            Opening | Window => {
                let beside = match (ex, ey) {
                    (Empty, Empty) => false,
                    (Empty, n) | (n, Empty) => n == Base || n == own,
                    pair => [(Base, Base), (Base, own), (own, Base)].contains(&pair),
                };
                let above_below = match z {
                    0 => up == Base || up == own,
                    _ => up == own || up.is_slab() || (up == Base && own == Window),
                };
                let deck = |n: Label, front: Label| {
                    !(own == Opening && z == 1 && level == Level::OverPlate && n == Empty) || front == Floor
                };
                // Neighbours of the same opening show the same sides to the outside.
                let pair_x = ex != own || (ey == Empty) == (at(1 - x, 1 - y, z) == Empty);
                let pair_y = ey != own || (ex == Empty) == (at(1 - x, 1 - y, z) == Empty);
                let pair_z = up != own
                    || ((ex == Empty) == (at(1 - x, y, 1 - z) == Empty)
                        && (ey == Empty) == (at(x, 1 - y, 1 - z) == Empty)
                        && (ex == own) == (at(1 - x, y, 1 - z) == own)
                        && (ey == own) == (at(x, 1 - y, 1 - z) == own));
                !is_plate(z)
                    && !is_ground(z)
                    && beside
                    && above_below
                    && deck(ex, at(1 - x, y, 0))
                    && deck(ey, at(x, 1 - y, 0))
                    && pair_x
                    && pair_y
                    && pair_z
            }
        };
        if !good {
            return false;
        }
    }
    true
}

#[test]
fn brute_force_over_all_labellings_gives_the_same_set() {
    let twin: BTreeSet<[Label; 8]> = (1..6u32.pow(8))
        .into_par_iter()
        .map(|n| std::array::from_fn(|c| Label::ALL[(n / 6u32.pow(c as u32) % 6) as usize]))
        .filter(|l| Level::ALL.iter().any(|&level| slow(l, level)))
        .collect();
    let fast: BTreeSet<_> = reachable_labels().into_iter().collect();
    let show =
        |set: Vec<&[Label; 8]>| set.iter().take(8).map(|l| CubeKey::of_labels(**l).to_string()).collect::<Vec<_>>();
    assert_eq!(show(twin.difference(&fast).collect()), show(fast.difference(&twin).collect()));
}

#[test]
fn examples_on_both_sides_of_each_rule() {
    let found: BTreeSet<_> = reachable_labels().into_iter().collect();
    for (in_set, out, why) in [
        ("33331111", "31331111", "foundation-layer"),
        ("11112212", "11102212", "plates-complete: a void lies inside"),
        ("33331100", "33001111", "undercut"),
        ("11111212", "00111212", "stair-inside: filled beside a void"),
        ("55115511", "55115500", "opening-facade: an opening looks one way"),
        ("11551155", "55551111", "opening-facade: one deep"),
        ("51005100", "50005000", "opening-corner"),
        ("51115111", "51112111", "opening-surround: no slab above"),
        ("22224411", "11114411", "opening-surround: a door stands on slab"),
        ("11115511", "11115411", "opening-surround: window beside door"),
        ("22220044", "00220044", "decks"),
    ] {
        assert!(found.contains(&labels(in_set)), "{in_set}: {why}");
        assert!(!found.contains(&labels(out)), "{out}: {why}");
    }
}

#[test]
fn a_roof_goes_on_only_where_its_neighbour_lets_it() {
    let numbers = |digits: &str| {
        let keys = keys_of(&labels(digits));
        keys.iter().flat_map(|k| k.faces()).filter(|f| *f != FaceNumber::None).collect::<BTreeSet<_>>()
    };
    use FaceNumber::{End0, End1, End2, StepDown, StepUp};
    assert_eq!(numbers("11110101"), [StepUp, End0, End1, End2].into(), "beside base");
    assert_eq!(numbers("11110202"), [End0, End1, End2].into(), "beside a plate");
    assert_eq!(numbers("01010000"), [StepDown, End0, End1, End2].into(), "beside nothing");
    assert_eq!(numbers("22220000"), [].into(), "a deck is no roof");
    let walked: BTreeSet<u8> = keys_of(&labels("22220101")).iter().map(|k| k.walked_columns()).collect();
    assert_eq!(walked, [0, 0b0101].into(), "side by side all or none");
}

fn space() -> Space {
    let plot = Plot::new([14, 11, 20], None).expect("a plot");
    let programme = Programme { floor_area_m2: [40.0, 160.0], storeys: [1, 2], ..Programme::default() };
    Space::new(plot, programme, ChoiceSpace::default()).expect("a space")
}

fn draw(space: &Space, seed: u64) -> House {
    let mut rng = ChaCha8Rng::seed_from_u64(seed);
    let mut design: Design = start(space, &mut rng).expect("a start");
    for _ in 0..seed % 6 {
        if let Some(next) = Move::draw(&mut rng).apply(&design, space, &mut rng) {
            design = next;
        }
    }
    encode(&design.massing, &space.plot)
}

/// The keys of a house's cubes in which something stands, with all decks walked on or none.
fn met(house: &House) -> BTreeSet<CubeKey> {
    let mut keys = BTreeSet::new();
    for walked in [false, true] {
        // A foundation is paved ground: only floors are decks.
        let is_walked = |v: [usize; 3]| walked && house.voxels.get(v) == Label::Floor;
        scan_keys(&house.voxels, Rule::B, is_walked, |_, key| {
            keys.insert(key);
        });
    }
    keys
}

#[test]
fn every_cube_of_two_thousand_houses_is_in_the_set() {
    let (space, settings) = (space(), RuleSettings::default());
    let drawn = (0..HOUSES).into_par_iter().map(|seed| {
        let house = draw(&space, seed);
        assert_eq!(violation(&house, &read_storeys(&house), &settings, &mut Scratch::default()), 0.0, "seed {seed}");
        met(&house)
    });
    let shipped: Vec<_> = samples::all().iter().map(|(_, house)| met(house)).collect();
    let found = drawn.chain(shipped).reduce(BTreeSet::new, |mut a, b| {
        a.extend(b);
        a
    });
    let keys = reachable_keys();
    let outside: Vec<_> = found.iter().filter(|k| keys.binary_search(k).is_err()).collect();
    let labels: BTreeSet<_> = found.iter().map(|k| k.labels()).collect();
    println!("{HOUSES} houses show {} keys of {} labellings", found.len(), labels.len());
    assert!(outside.is_empty(), "{} keys: {:?}", outside.len(), &outside[..outside.len().min(20)]);
    assert!(labels.len() > 300, "the houses show few cubes");
}
