//! The fast side against the clauses walked in full.

use super::*;
use crate::structure::Catalogue;

fn catalogue() -> Catalogue {
    Catalogue::load(std::path::Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/configs"))).expect("our catalogue")
}

const FREE: Restraint = Restraint { sideways: false, edges: [false; 2] };
const HELD: Restraint = Restraint { sideways: true, edges: [true; 2] };
const JOIST: Restraint = Restraint { sideways: true, edges: [true, false] };

/// Numbers from -1 to 1.
fn random(seed: u64) -> impl FnMut() -> f64 {
    let mut state = seed;
    move || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 11) as f64 / (1u64 << 52) as f64 - 1.0
    }
}

/// Every material with a section that goes with it, small and large.
fn pairs(c: &Catalogue) -> Vec<(&StructuralMaterial, &CrossSection)> {
    let named = |id: &str| c.sections.iter().find(|s| s.id == id).expect("in the catalogue");
    let mut all = Vec::new();
    for m in &c.materials {
        let ids: &[&str] = match m.steel {
            Some(_) => &[
                "SHS80x80x4",
                "HF-RHS200x100x8",
                "RHS150x100x5",
                "CHS114.3x5",
                "IPE200",
                "IPE240",
                "HEA160",
                "SHS180x180x6",
            ],
            None => &["T_45x145", "T_60x240", "GL_140x140", "GL_90x360"],
        };
        all.extend(ids.iter().map(|id| (m, named(id))));
    }
    all
}

/// What the bound rules out cannot govern: for many forces it is never under the ratio, at a point and along a member.
#[test]
fn the_bound_is_never_too_low() {
    let c = catalogue();
    let mut next = random(1);
    for (m, s) in pairs(&c) {
        let steel = m.steel.map_or(1.0, |_| 8.0);
        for (clear, held) in [(0.9, HELD), (2.7, FREE), (5.4, JOIST)] {
            let r = Resistance::new(m, s, 1, clear, held);
            let mut ruled = 0;
            for _ in 0..4_000 {
                let k = steel * next().abs();
                let f = Forces {
                    n: k * next() * 4e4,
                    vy: k * next() * 4e3,
                    vz: k * next() * 1e4,
                    my: k * next() * 3e3,
                    mz: k * next() * 5e2,
                };
                let mut p = Peaks::default();
                p.add(&f);
                p.add(&Forces { my: k * next() * 3e3, ..f });
                for k_mod in [0.6, 0.8, 0.9] {
                    let (bound, ratio) = (r.bound(&f, k_mod), r.ratio(&f, k_mod).0);
                    assert!(ratio <= bound, "{} {} {f:?}: {ratio} {bound}", m.id, s.id);
                    let (bound, stability) = (r.bound_of_peaks(&p, k_mod), r.stability(&p, k_mod).0);
                    assert!(stability <= bound, "{} {} {p:?}: {stability} {bound}", m.id, s.id);
                    let [normal, shear] = r.shares(&Reach([f.n, f.vy, f.vz, p.my[0].max(p.my[1]), f.mz].map(f64::abs)));
                    let both = r.at_most(normal.max(shear), k_mod);
                    assert!(ratio.max(stability) <= both, "{} {} {p:?}: {ratio} {stability} {both}", m.id, s.id);
                    ruled += u32::from(bound < 0.5);
                }
            }
            assert!(ruled > 1000, "{} {}: the bound rules out nothing", m.id, s.id);
        }
    }
}

/// A sagging beam: what the solver calls My is negative and compresses the upper edge. q down, simply supported, 8 kN/m over 5 m.
#[test]
fn sagging_compresses_the_upper_edge() {
    let (q, l) = (8e3, 5.0);
    let p: Piece = [0.0, 0.0, q * l / 2.0, 0.0, 0.0, 0.0, 0.0, -q];
    let (xs, n) = stations(&p, l);
    let middle = xs[..n].iter().map(|&x| design_forces(&p, x).my).fold(0.0, f64::max);
    assert!((middle - q * l * l / 8.0).abs() < 1e-6, "{middle}");
}

/// A lower edge that is free costs bending strength only when it is compressed.
#[test]
fn a_free_lower_edge_counts_in_hogging_only() {
    let c = catalogue();
    for (m, s) in [("C24", "T_45x245"), ("S235", "IPE240")] {
        let m = c.materials.iter().find(|x| x.id == m).expect("in the catalogue");
        let s = c.sections.iter().find(|x| x.id == s).expect("in the catalogue");
        let ratio = |held: Restraint, my: f64| {
            let f = Forces { my, ..Forces::default() };
            let (r, mut p) = (Resistance::new(m, s, 1, 5.0, held), Peaks::default());
            p.add(&f);
            r.ratio(&f, 0.9).0.max(r.stability(&p, 0.9).0)
        };
        assert_eq!(ratio(JOIST, 4e3), ratio(HELD, 4e3));
        assert!(ratio(JOIST, -4e3) > 1.2 * ratio(JOIST, 4e3), "{}: {} {}", m.id, ratio(JOIST, -4e3), ratio(JOIST, 4e3));
    }
}

/// Over a support of a continuous joist only the ends compress the lower edge: half the length counts, and less of it is lost.
#[test]
fn a_moment_that_changes_sign_costs_less() {
    let c = catalogue();
    for (m, s) in [("C24", "T_45x245"), ("S235", "IPE240")] {
        let m = c.materials.iter().find(|x| x.id == m).expect("in the catalogue");
        let s = c.sections.iter().find(|x| x.id == s).expect("in the catalogue");
        let r = Resistance::new(m, s, 1, 5.0, JOIST);
        let ratio = |sagging: f64| r.stability(&Peaks { my: [sagging, 4e3], ..Peaks::default() }, 0.9).0;
        assert_eq!(ratio(0.0), ratio(0.39e3));
        assert!(ratio(0.41e3) < 0.8 * ratio(0.0), "{}: {} {}", m.id, ratio(0.41e3), ratio(0.0));
        // With both edges free nothing is gained.
        let free = Resistance::new(m, s, 1, 5.0, FREE);
        let both = |sagging: f64| free.stability(&Peaks { my: [sagging, 4e3], ..Peaks::default() }, 0.9).0;
        assert_eq!(both(0.0), both(2e3));
    }
}

/// Class 4 has no resistance here.
#[test]
fn class_4_is_refused() {
    let c = catalogue();
    let m = c.materials.iter().find(|x| x.id == "S355").expect("S355");
    let mut s = c.sections.iter().find(|x| x.id == "SHS200x200x8").expect("SHS").clone();
    s.properties = crate::structure::checks::Shape::Box {
        b: 0.2,
        h: 0.2,
        t: 0.004,
        forming: crate::structure::checks::Forming::Cold,
    }
    .properties();
    let r = Resistance::new(m, &s, 1, 3.0, HELD);
    assert!(r.ratio(&Forces { n: -1.0, ..Forces::default() }, 0.9).0 > 1e9);
}
