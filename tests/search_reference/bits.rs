//! Bit strings with exactly known fronts.

use std::hash::{Hash, Hasher};

use houscaper::search::Score;
use houscaper::search::domain::{Arm, Domain, Operator};
use houscaper::search::evolution::{self, Evolution};
use houscaper::search::hypervolume::hypervolume;
use houscaper::search::run::Searcher;
use houscaper::search::steady::{self, Steady};
use rand::RngExt;
use rand_chacha::ChaCha8Rng;
use serde_json::Value;

use super::{explore, folder, numbers, read, rows};

/// Bit strings of one length: one flip, an exchange of two bits, a flip of each with chance 1/n, uniform crossover.
struct Bits {
    length: usize,
    arms: Vec<Arm>,
}

impl Bits {
    fn new(length: usize) -> Self {
        let arm = |name, parents, weight| Arm { operator: Operator(name), parents, weight };
        Bits {
            length,
            arms: vec![arm("flip", 1, 2.0), arm("exchange", 1, 2.0), arm("some", 1, 1.0), arm("uniform", 2, 1.0)],
        }
    }
}

impl Domain for Bits {
    type Genome = Vec<bool>;
    type Form = ();

    fn arms(&self) -> &[Arm] {
        &self.arms
    }

    fn start(&self, rng: &mut ChaCha8Rng) -> Option<Vec<bool>> {
        let share: f64 = rng.random();
        Some((0..self.length).map(|_| rng.random_bool(share)).collect())
    }

    fn vary(&self, arm: usize, parents: [&Vec<bool>; 2], rng: &mut ChaCha8Rng) -> Option<Vec<bool>> {
        let mut child = parents[0].clone();
        match arm {
            0 => {
                let at = rng.random_range(0..self.length);
                child[at] = !child[at];
            }
            1 => {
                let (a, b) = (rng.random_range(0..self.length), rng.random_range(0..self.length));
                child.swap(a, b);
            }
            2 => child.iter_mut().for_each(|b| *b ^= rng.random_bool(1.0 / self.length as f64)),
            _ => child.iter_mut().zip(parents[1]).for_each(|(b, o)| *b = if rng.random_bool(0.5) { *o } else { *b }),
        }
        (child != *parents[0]).then_some(child)
    }

    fn express(&self, _: &Vec<bool>) {}

    fn key(&self, genome: &Vec<bool>, (): &()) -> u128 {
        let mut hasher = rustc_hash::FxHasher::default();
        genome.hash(&mut hasher);
        u128::from(hasher.finish()) << 64
    }
}

/// A problem file as a function of bits; objectives minimised.
fn problem(file: &Value) -> impl Fn(&Vec<bool>) -> Score + Sync + use<> {
    let kind = file["kind"].as_str().expect("a kind").to_owned();
    let table = |key: &str| file.get(key).map(rows).unwrap_or_default();
    let list = |key: &str| file.get(key).map(numbers).unwrap_or_default();
    let (values, weights, capacity) = (table("values"), list("weights"), file["capacity"].as_f64().unwrap_or(0.0));
    let matrices: Vec<Vec<Vec<f64>>> =
        file.get("Q").map(|q| q.as_array().expect("matrices").iter().map(rows).collect()).unwrap_or_default();
    let links: Vec<Vec<usize>> = table("links").iter().map(|r| r.iter().map(|v| *v as usize).collect()).collect();
    let tables: Vec<Vec<Vec<f64>>> =
        file.get("tables").map(|t| t.as_array().expect("tables").iter().map(rows).collect()).unwrap_or_default();
    move |bits: &Vec<bool>| {
        let bit = |i: usize| f64::from(u8::from(bits[i]));
        let sum = |list: &Vec<f64>| list.iter().enumerate().map(|(i, v)| v * bit(i)).sum::<f64>();
        match kind.as_str() {
            "lotz_max" => {
                let leading = bits.iter().take_while(|b| **b).count() as f64;
                let trailing = bits.iter().rev().take_while(|b| !**b).count() as f64;
                Score { objectives: vec![-leading, -trailing], violation: 0.0 }
            }
            "knapsack_max" => {
                let objectives = values.iter().map(|v| -sum(v)).collect();
                Score { objectives, violation: ((sum(&weights) - capacity) / capacity).max(0.0) }
            }
            "mubqp_max" => {
                let quadratic = |q: &Vec<Vec<f64>>| q.iter().enumerate().map(|(i, row)| bit(i) * sum(row)).sum::<f64>();
                Score { objectives: matrices.iter().map(|q| -quadratic(q)).collect(), violation: 0.0 }
            }
            "rmnk_max_sum" => {
                let mut objectives = vec![0.0; tables[0][0].len()];
                for (loci, table) in links.iter().zip(&tables) {
                    let key = loci.iter().enumerate().fold(0, |key, (place, &l)| key | usize::from(bits[l]) << place);
                    objectives.iter_mut().zip(&table[key]).for_each(|(o, v)| *o -= v);
                }
                Score { objectives, violation: 0.0 }
            }
            other => panic!("no problem {other}"),
        }
    }
}

/// Whether points of the stated front are reached by some bits is what makes the reading of a file right: here every point of the front
/// of a problem of 16 bits, by enumeration.
#[test]
fn the_files_are_read_as_meant() {
    let Some(folder) = folder("the_files_are_read_as_meant") else { return };
    for name in ["lotz_16", "knap_16_5", "rmnk_16_4_3_0.0"] {
        let file = read(&folder.join(format!("{name}.json")));
        let score = problem(&file);
        let mut archive = houscaper::search::archive::Archive::new();
        for n in 0u64..1 << 16 {
            let bits: Vec<bool> = (0..16).map(|i| n >> i & 1 == 1).collect();
            archive.offer(n, &score(&bits), || ());
        }
        let mut stated = rows(&file["front"]);
        let mut ours: Vec<Vec<f64>> = archive.points().into_iter().map(<[f64]>::to_vec).collect();
        let order = |a: &Vec<f64>, b: &Vec<f64>| a.partial_cmp(b).expect("numbers");
        stated.sort_by(order);
        ours.sort_by(order);
        assert_eq!(ours.len(), stated.len(), "{name}");
        let close = |(a, b): (&f64, &f64)| (a - b).abs() < 1e-6;
        assert!(ours.iter().zip(&stated).all(|(a, b)| a.iter().zip(b).all(close)), "{name}");
    }
}

/// Share of the exact front's hypervolume, for the steady state and for NSGA-II with the same operators and evaluations.
///
/// Not exact yet: rho-MNK, and the knapsack of 50 items, where NSGA-II comes 1 % further: a step along that front takes several items out
/// and in, while the steady state makes half of its children by single steps.
///
/// Evaluations: a twentieth (16 and 18 bits) of what enumeration takes, and for 50 bits as many as a published SEMO needs for LOTZ
/// (Laumanns, Thiele, Zitzler 2004: of the order of n^3).
#[test]
fn exact_fronts_are_found() {
    let Some(folder) = folder("exact_fronts_are_found") else { return };
    let (mut lost, mut behind) = (Vec::new(), Vec::new());
    println!(
        "problem            evaluations  steady            nsga2    (least and median share of the exact hypervolume, 5 seeds)"
    );
    for (name, evaluations, least) in [
        ("lotz_16", 3300, 1.0),
        ("knap_18_2", 13_000, 1.0),
        ("knap_16_5", 6500, 0.999),
        ("rmnk_16_4_3_0.0", 6500, 0.97),
        ("mubqp_18_2_0.0", 13_000, 0.999),
        ("lotz_50", 60_000, 1.0),
        ("vopt_2KP50-50", 60_000, 0.97),
    ] {
        let file = read(&folder.join(format!("{name}.json")));
        let (score, domain) = (problem(&file), Bits::new(file["n"].as_u64().expect("n") as usize));
        let (reference, exact) = (numbers(&file["ref"]), file["hv"].as_f64().expect("hv"));
        let share = |searcher: &mut dyn Searcher<Bits>| {
            let (archive, _) = explore(searcher, &score, evaluations);
            hypervolume(&archive.points(), &reference) / exact
        };
        let ours: Vec<f64> =
            (1..=5).map(|seed| share(&mut Steady::new(&domain, seed, steady::Settings::default()))).collect();
        let theirs: Vec<f64> =
            (1..=5).map(|seed| share(&mut Evolution::nsga2(&domain, seed, evolution::Settings::default()))).collect();
        let low = |v: &[f64]| v.iter().copied().fold(f64::INFINITY, f64::min);
        let (a, b) = (super::median(&ours), super::median(&theirs));
        println!("{name:18} {evaluations:11}  {:.5} {a:.5}   {:.5} {b:.5}", low(&ours), low(&theirs));
        assert!(ours.iter().chain(&theirs).all(|s| *s <= 1.0 + 1e-9), "{name}: more than the exact front");
        if low(&ours) < least - 1e-9 {
            lost.push(format!("{name} {}", low(&ours)));
        }
        if a < b - 1e-4 && name != "vopt_2KP50-50" {
            behind.push(format!("{name} {a} {b}"));
        }
    }
    assert!(lost.is_empty(), "not reached: {lost:?}");
    assert!(behind.is_empty(), "behind NSGA-II: {behind:?}");
}
