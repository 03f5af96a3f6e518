//! Fixed-end forces: what the ends of a member held on both sides feel from its loads.

use super::element::{BEND_Y, BEND_Z};

/// A load on part of a member in its local axes; the uniform share is kept apart.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum SpanLoad {
    /// Force `p` at `x` from end i.
    Point {
        /// The force.
        p: [f64; 3],
        /// Its place.
        x: f64,
    },
    /// Force per length from `q1` at `x1` to `q2` at `x2`.
    Linear {
        /// Force per length at x1.
        q1: [f64; 3],
        /// Force per length at x2.
        q2: [f64; 3],
        /// Start.
        x1: f64,
        /// End.
        x2: f64,
    },
}

/// Fixed-end forces (condensed, local) of the members that a case loads: a house has many members and most cases load few of them.
#[derive(Default)]
pub(super) struct FixedEnds {
    cases: usize,
    /// Place among `forces` by member, then case; [`UNLOADED`] without loads.
    slot: Vec<u32>,
    forces: Vec<[f64; 12]>,
}

const UNLOADED: u32 = u32::MAX;

impl FixedEnds {
    /// Nothing is loaded.
    pub fn reset(&mut self, members: usize, cases: usize) {
        self.cases = cases;
        self.slot.clear();
        self.slot.resize(members * cases, UNLOADED);
        self.forces.clear();
    }

    /// Forces of a member in a case, `None` without loads.
    #[inline]
    pub fn get(&self, member: usize, case: usize) -> Option<&[f64; 12]> {
        // No place is as far out as UNLOADED.
        self.forces.get(self.slot[member * self.cases + case] as usize)
    }

    /// Forces of a member in a case, zero at first.
    pub fn entry(&mut self, member: usize, case: usize) -> &mut [f64; 12] {
        let slot = &mut self.slot[member * self.cases + case];
        if *slot == UNLOADED {
            *slot = self.forces.len() as u32;
            self.forces.push([0.0; 12]);
        }
        &mut self.forces[*slot as usize]
    }

    /// As [`FixedEnds::entry`], `None` without loads.
    pub fn get_mut(&mut self, member: usize, case: usize) -> Option<&mut [f64; 12]> {
        self.forces.get_mut(self.slot[member * self.cases + case] as usize)
    }
}

/// Forces on the member at its held ends (local) under a uniform load: half of it and q L^2 / 12 each.
pub(super) fn uniform(q: [f64; 3], l: f64) -> [f64; 12] {
    let (h, m) = (0.5 * l, l * l / 12.0);
    let [x, y, z] = [-q[0] * h, -q[1] * h, -q[2] * h];
    [x, y, z, 0.0, q[2] * m, -q[1] * m, x, y, z, 0.0, -q[2] * m, q[1] * m]
}

/// Adds the forces on the member at its held ends under `load`; `phi`: shear parameters of the x-y and x-z planes.
///
/// Minus the shape functions times the load. Those are cubic, so three Gauss points are exact for a linear load.
pub(super) fn add_span(f: &mut [f64; 12], load: &SpanLoad, l: f64, phi: [f64; 2]) {
    match *load {
        SpanLoad::Point { p, x } => add_point(f, p, x / l, l, phi),
        SpanLoad::Linear { q1, q2, x1, x2 } => {
            for (t, w) in [(0.5 - 0.15f64.sqrt(), 5.0 / 18.0), (0.5, 8.0 / 18.0), (0.5 + 0.15f64.sqrt(), 5.0 / 18.0)] {
                let force = std::array::from_fn(|c| (q1[c] + t * (q2[c] - q1[c])) * w * (x2 - x1));
                add_point(f, force, (x1 + t * (x2 - x1)) / l, l, phi);
            }
        }
    }
}

fn add_point(f: &mut [f64; 12], p: [f64; 3], t: f64, l: f64, phi: [f64; 2]) {
    f[0] -= p[0] * (1.0 - t);
    f[6] -= p[0] * t;
    let n = shape(t, l, phi[0]);
    (0..4).for_each(|k| f[BEND_Z[k]] -= p[1] * n[k]);
    let n = shape(t, l, phi[1]);
    (0..4).for_each(|k| f[BEND_Y[k]] -= p[2] * n[k] * if k % 2 == 1 { -1.0 } else { 1.0 });
}

/// Transverse displacement at t = x/L for unit (v, slope) at i and j; Timoshenko with `phi`, Hermite cubics at 0.
fn shape(t: f64, l: f64, phi: f64) -> [f64; 4] {
    let (c, t2, t3) = (1.0 / (1.0 + phi), t * t, t * t * t);
    [
        c * (1.0 - 3.0 * t2 + 2.0 * t3 + phi * (1.0 - t)),
        c * l * (t - 2.0 * t2 + t3 + 0.5 * phi * (t - t2)),
        c * (3.0 * t2 - 2.0 * t3 + phi * t),
        c * l * (t3 - t2 - 0.5 * phi * (t - t2)),
    ]
}
