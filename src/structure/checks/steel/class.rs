//! Classification of cross-sections, 5.5 and Table 5.2.

use super::super::{Forces, Section, Shape};
use super::Steel;

/// Class of a cross-section.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Class {
    /// A plastic hinge can turn.
    One = 1,
    /// The plastic moment is reached.
    Two = 2,
    /// The elastic moment is reached.
    Three = 3,
    /// Local buckling comes first: EN 1993-1-5 and 1-3, not assessed here.
    Four = 4,
}

fn within(slenderness: f64, limits: [f64; 3]) -> Class {
    match limits.map(|l| slenderness <= l) {
        [true, ..] => Class::One,
        [_, true, _] => Class::Two,
        [_, _, true] => Class::Three,
        _ => Class::Four,
    }
}

/// Internal part of slenderness c/t. `plastic`: share of c in compression when it yields (alpha); `elastic`: stress at the far end
/// over the largest compression (psi).
fn internal(c_over_t: f64, e: f64, plastic: f64, elastic: f64) -> Class {
    if plastic <= 0.0 {
        return Class::One;
    }
    let [one, two] = if plastic > 0.5 {
        [396.0, 456.0].map(|k| k * e / (13.0 * plastic - 1.0))
    } else {
        [36.0, 41.5].map(|k| k * e / plastic)
    };
    let three = if elastic > -1.0 {
        42.0 * e / (0.67 + 0.33 * elastic)
    } else {
        62.0 * e * (1.0 - elastic) * (-elastic).sqrt()
    };
    within(c_over_t, [one, two, three])
}

fn compressed(c_over_t: f64, e: f64) -> Class {
    within(c_over_t, [33.0 * e, 38.0 * e, 42.0 * e])
}

/// Straight parts (c, t) of a section: along the depth, then along the width (the outstand of an I).
fn parts(shape: &Shape) -> [(f64, f64); 2] {
    match *shape {
        // c = b - 3 t of Table 5.2, on the safe side of the true corner radii of cold formed sections.
        Shape::Box { b, h, t, .. } => [(h - 3.0 * t, t), (b - 3.0 * t, t)],
        Shape::I { b, h, tw, tf, r } => [(h - 2.0 * tf - 2.0 * r, tw), (0.5 * (b - tw) - r, tf)],
        Shape::Tube { d, t, .. } => [(d, t); 2],
        Shape::Rectangle { .. } => [(0.0, 1.0); 2],
    }
}

/// Class when the whole section is in uniform compression: never lower than the class under any other forces.
pub fn class_in_compression(steel: &Steel, section: &Section) -> Class {
    class_of(steel, section, &Forces { n: -f64::INFINITY, my: 1.0, mz: 1.0, ..Forces::default() })
}

/// Class under given forces. Flanges count as uniformly compressed as soon as anything compresses them; a web under axial force and
/// bending in its plane is taken with the stresses of Table 5.2 (alpha, psi).
pub fn class_of(steel: &Steel, section: &Section, f: &Forces) -> Class {
    let e = steel.epsilon();
    let compression = -f.n;
    if compression <= 0.0 && f.my == 0.0 && f.mz == 0.0 {
        return Class::One;
    }
    let [depth, width] = parts(&section.shape);
    let slender = |(c, t): (f64, f64)| c / t;
    // A part that bends in its own plane under the axial force; `webs` of them side by side.
    let web = |part: (f64, f64), webs: f64| {
        let squash = compression / (steel.fy / steel.gamma_m0);
        let plastic = (0.5 * (1.0 + squash / (webs * part.0 * part.1))).clamp(0.0, 1.0);
        let elastic = (2.0 * squash / section.a - 1.0).min(1.0);
        internal(slender(part), e, plastic, elastic)
    };
    match section.shape {
        Shape::Rectangle { .. } => Class::One,
        Shape::Tube { .. } => within(slender(depth), [50.0, 70.0, 90.0].map(|k| k * e * e)),
        Shape::I { .. } => {
            let outstand = within(slender(width), [9.0, 10.0, 14.0].map(|k| k * e));
            match f.my == 0.0 {
                true if compression <= 0.0 => outstand,
                true => outstand.max(compressed(slender(depth), e)),
                false => outstand.max(web(depth, 1.0)),
            }
        }
        Shape::Box { .. } => {
            let side = |part: (f64, f64), in_plane: f64, across: f64| match (in_plane != 0.0, across != 0.0) {
                (_, true) => compressed(slender(part), e),
                (true, false) => web(part, 2.0),
                (false, false) => compressed(slender(part), e),
            };
            side(depth, f.my, f.mz).max(side(width, f.mz, f.my))
        }
    }
}
