//! Stiffness of one member: four uncoupled parts in local axes, end releases by static condensation.
//!
//! Local order of the twelve: ux uy uz rx ry rz at i, then at j. The parts and their places in it:
//! axial (0, 6), torsion (3, 9), bending in the x-y plane (1, 5, 7, 11), bending in the x-z plane (2, 4, 8, 10).

use super::axes::Axes3;
use super::model::{Material, Member, Section};

/// Places of the parts among the twelve.
pub(super) const AXIAL: [usize; 2] = [0, 6];
pub(super) const TORSION: [usize; 2] = [3, 9];
pub(super) const BEND_Z: [usize; 4] = [1, 5, 7, 11];
pub(super) const BEND_Y: [usize; 4] = [2, 4, 8, 10];

/// Stiffness of one part and the operator that carries fixed-end forces over to it.
///
/// A part is a sum of springs on combinations of its displacements, `sum k v v^T`: one for a bar, two for bending. A release
/// takes a combination out in closed form, without the differences of nearly equal numbers that elimination makes of short
/// members with shear (their stiffness loses ten digits there).
#[derive(Clone, Copy, Debug)]
pub(super) struct Part<const N: usize> {
    /// Condensed stiffness; rows and columns of released ends are zero.
    pub k: [[f64; N]; N],
    /// Condensed fixed-end forces = `carry` times those of the member without releases.
    pub carry: [[f64; N]; N],
    /// Released ends without any stiffness: a load reaching one cannot be carried.
    pub loose: [bool; N],
}

/// A spring on the combination `v . u` of displacements.
#[derive(Clone, Copy)]
struct Spring<const N: usize> {
    k: f64,
    v: [f64; N],
}

impl<const N: usize> Part<N> {
    fn condensed(mut springs: [Spring<N>; 2], released: [bool; N]) -> Self {
        let mut carry = [[0.0; N]; N];
        for (r, row) in carry.iter_mut().enumerate() {
            row[r] = 1.0;
        }
        let mut part = Part { k: [[0.0; N]; N], carry, loose: [false; N] };
        for r in (0..N).filter(|&r| released[r]) {
            part.release(r, &mut springs);
        }
        for s in springs.iter().filter(|s| s.k != 0.0) {
            for i in 0..N {
                (0..N).for_each(|j| part.k[i][j] += s.k * s.v[i] * s.v[j]);
            }
        }
        part
    }

    /// Lets displacement `r` take the place of least energy: of springs `a` and `b` stays one of stiffness
    /// `ka kb / (ka ar^2 + kb br^2)` on `ar b - br a`, on which `r` has no part.
    fn release(&mut self, r: usize, springs: &mut [Spring<N>; 2]) {
        let [a, b] = *springs;
        let pivot = a.k * a.v[r] * a.v[r] + b.k * b.v[r] * b.v[r];
        let carried = self.carry[r];
        if pivot > 0.0 {
            for i in (0..N).filter(|&i| i != r) {
                let f = (a.k * a.v[i] * a.v[r] + b.k * b.v[i] * b.v[r]) / pivot;
                (0..N).for_each(|j| self.carry[i][j] -= f * carried[j]);
            }
            let rest = Spring { k: a.k * b.k / pivot, v: std::array::from_fn(|i| a.v[r] * b.v[i] - b.v[r] * a.v[i]) };
            *springs = [rest, Spring { k: 0.0, v: [0.0; N] }];
            self.carry[r] = [0.0; N];
        } else {
            self.loose[r] = true;
        }
    }

    /// Condensed forces, and whether a load reaches a loose end.
    fn condense(&self, f: [f64; N]) -> ([f64; N], bool) {
        let mut out: [f64; N] = std::array::from_fn(|i| (0..N).map(|j| self.carry[i][j] * f[j]).sum());
        let scale = f.iter().fold(0.0f64, |m, v| m.max(v.abs()));
        let mut stray = false;
        for i in (0..N).filter(|&i| self.loose[i]) {
            stray |= out[i].abs() > 1e-9 * scale;
            out[i] = 0.0;
        }
        (out, stray)
    }

    /// Adds the forces of the displacements `u` at `places` of the twelve.
    #[inline(always)]
    fn push<const W: usize>(&self, places: [usize; N], u: &[[f64; W]; 12], f: &mut [[f64; W]; 12]) {
        for i in 0..N {
            for j in 0..N {
                let k = self.k[i][j];
                for lane in 0..W {
                    f[places[i]][lane] += k * u[places[j]][lane];
                }
            }
        }
    }
}

/// Cases that are recovered side by side.
pub(super) const LANES: usize = 4;

/// Six components of a node in [`LANES`] cases side by side.
pub(super) type Side = [[f64; LANES]; 6];

/// The four vectors of a member's ends times a 3 x 3 matrix.
#[inline(always)]
fn turned<const W: usize>(v: &[[f64; W]; 12], matrix: impl Fn(usize, usize) -> f64) -> [[f64; W]; 12] {
    let mut out = [[0.0; W]; 12];
    for part in (0..12).step_by(3) {
        for r in 0..3 {
            let (a, b, c) = (matrix(r, 0), matrix(r, 1), matrix(r, 2));
            for lane in 0..W {
                out[part + r][lane] = a * v[part][lane] + b * v[part + 1][lane] + c * v[part + 2][lane];
            }
        }
    }
    out
}

/// A member ready for assembly and recovery.
#[derive(Clone, Debug)]
pub(super) struct Beam {
    pub axes: Axes3,
    pub length: f64,
    pub axial: Part<2>,
    pub torsion: Part<2>,
    /// Bending in the local x-y plane (uses Iz).
    pub bend_z: Part<4>,
    /// Bending in the local x-z plane (uses Iy); rotations carry the sign of ry = -dw/dx.
    pub bend_y: Part<4>,
    /// Shear parameters 12 E I / (G As L^2) of the x-y and the x-z plane; 0 for Euler-Bernoulli.
    pub phi: [f64; 2],
    pub released: bool,
    /// Whether any bending stiffness is left; braces have none.
    bends: bool,
}

/// Springs of bending on (v, rotation) at both ends: `E I / L` on the difference of the rotations and `3 E I / (L (1 + phi))` on
/// their sum less twice the turn of the chord; together the stiffness of Przemieniecki, Theory of Matrix Structural Analysis,
/// 1968, eq. 5.116. `sign` is -1 in the x-z plane, where a positive rotation is a falling slope.
fn bending(ei: f64, l: f64, phi: f64, sign: f64) -> [Spring<4>; 2] {
    let c = 2.0 * sign / l;
    [Spring { k: ei / l, v: [0.0, 1.0, 0.0, -1.0] }, Spring { k: 3.0 * ei / (l * (1.0 + phi)), v: [c, 1.0, -c, 1.0] }]
}

/// The spring of a bar.
fn bar(k: f64) -> [Spring<2>; 2] {
    [Spring { k, v: [1.0, -1.0] }, Spring { k: 0.0, v: [0.0; 2] }]
}

fn shear_parameter(ei: f64, g: f64, area: Option<f64>, l: f64) -> f64 {
    area.map_or(0.0, |a| 12.0 * ei / (g * a * l * l))
}

pub(super) fn pick<const N: usize, T: Copy>(all: &[T; 12], places: [usize; N]) -> [T; N] {
    places.map(|p| all[p])
}

fn put<const N: usize>(all: &mut [f64; 12], places: [usize; N], values: [f64; N]) {
    (0..N).for_each(|n| all[places[n]] = values[n]);
}

impl Beam {
    pub fn new(member: &Member, material: &Material, section: &Section, shear: bool, axes: Axes3, length: f64) -> Self {
        let l = length;
        let (ea, gj) = (material.e * section.a / l, material.g * section.j / l);
        let (eiz, eiy) = (material.e * section.iz, material.e * section.iy);
        let phi = if shear {
            [shear_parameter(eiz, material.g, section.asy, l), shear_parameter(eiy, material.g, section.asz, l)]
        } else {
            [0.0; 2]
        };
        let free: [bool; 12] = std::array::from_fn(|d| member.releases[d / 6][d % 6]);
        let bend_z = Part::condensed(bending(eiz, l, phi[0], 1.0), pick(&free, BEND_Z));
        let bend_y = Part::condensed(bending(eiy, l, phi[1], -1.0), pick(&free, BEND_Y));
        let bends = [bend_z.k, bend_y.k].iter().flatten().flatten().any(|&k| k != 0.0);
        Beam {
            axes,
            length,
            axial: Part::condensed(bar(ea), pick(&free, AXIAL)),
            torsion: Part::condensed(bar(gj), pick(&free, TORSION)),
            bend_z,
            bend_y,
            phi,
            released: free.contains(&true),
            bends,
        }
    }

    /// Whether end `e` (0, 1) resists all three rotations of its node.
    pub fn holds_rotations(&self, e: usize) -> bool {
        let r = 2 * e + 1;
        self.torsion.k[e][e] > 0.0 && self.bend_z.k[r][r] > 0.0 && self.bend_y.k[r][r] > 0.0
    }

    /// Condenses fixed-end forces (local); true when a load reaches an end without stiffness.
    pub fn condense(&self, f: &mut [f64; 12]) -> bool {
        if !self.released {
            return false;
        }
        let (a, s0) = self.axial.condense(pick(f, AXIAL));
        let (t, s1) = self.torsion.condense(pick(f, TORSION));
        let (z, s2) = self.bend_z.condense(pick(f, BEND_Z));
        let (y, s3) = self.bend_y.condense(pick(f, BEND_Y));
        put(f, AXIAL, a);
        put(f, TORSION, t);
        put(f, BEND_Z, z);
        put(f, BEND_Y, y);
        s0 | s1 | s2 | s3
    }

    /// End forces (local) of end displacements (global).
    pub fn forces(&self, ui: &[f64; 6], uj: &[f64; 6]) -> [f64; 12] {
        self.forces_of(&std::array::from_fn(|d| [if d < 6 { ui[d] } else { uj[d - 6] }])).map(|[f]| f)
    }

    /// As [`Beam::forces`], for `W` cases side by side: the arithmetic is the same for all, so it runs in vector registers.
    #[inline(always)]
    pub fn forces_of<const W: usize>(&self, u: &[[f64; W]; 12]) -> [[f64; W]; 12] {
        let mut f = [[0.0; W]; 12];
        if !self.bends {
            // More than half of a house's members are braces and pinned sticks: only what lies along them matters.
            let [x, y, z] = self.axes[0];
            let along = |part: usize| -> [f64; W] {
                std::array::from_fn(|lane| x * u[part][lane] + y * u[part + 1][lane] + z * u[part + 2][lane])
            };
            for (k, [i, j]) in [(&self.axial.k, AXIAL), (&self.torsion.k, TORSION)] {
                let (a, b) = (along(i), along(j));
                for lane in 0..W {
                    f[i][lane] = 0.0 + k[0][0] * a[lane] + k[0][1] * b[lane];
                    f[j][lane] = 0.0 + k[1][0] * a[lane] + k[1][1] * b[lane];
                }
            }
            return f;
        }
        let u = self.turned_in(u);
        self.axial.push(AXIAL, &u, &mut f);
        self.torsion.push(TORSION, &u, &mut f);
        self.bend_z.push(BEND_Z, &u, &mut f);
        self.bend_y.push(BEND_Y, &u, &mut f);
        f
    }

    /// As [`Beam::turned_out`] for forces of [`Beam::forces_of`] alone: those of members without bending lie along them.
    #[inline(always)]
    pub fn turned_out_of<const W: usize>(&self, f: &[[f64; W]; 12]) -> [[f64; W]; 12] {
        if self.bends {
            return self.turned_out(f);
        }
        std::array::from_fn(|d| std::array::from_fn(|lane| self.axes[0][d % 3] * f[d - d % 3][lane]))
    }

    #[inline(always)]
    fn turned_in<const W: usize>(&self, u: &[[f64; W]; 12]) -> [[f64; W]; 12] {
        turned(u, |r, c| self.axes[r][c])
    }

    /// Twelve local components to global ones, for `W` cases side by side.
    #[inline(always)]
    pub fn turned_out<const W: usize>(&self, f: &[[f64; W]; 12]) -> [[f64; W]; 12] {
        turned(f, |r, c| self.axes[c][r])
    }

    /// Twelve local components to global ones.
    pub fn to_global(&self, f: &[f64; 12]) -> [f64; 12] {
        self.turned_out(&f.map(|v| [v])).map(|[v]| v)
    }

    /// Global 6 x 6 block of ends `a` (rows) and `b` (columns). Every 3 x 3 quarter is a sum of dyads of the axes, because the
    /// local quarters are diagonal or have only the entries (y, z) and (z, y).
    pub fn block(&self, a: usize, b: usize) -> [[f64; 6]; 6] {
        let [x, y, z] = &self.axes;
        let (ta, tb, ra, rb) = (2 * a, 2 * b, 2 * a + 1, 2 * b + 1);
        let (kz, ky) = (&self.bend_z.k, &self.bend_y.k);
        let mut k = [[0.0; 6]; 6];
        for r in 0..3 {
            let (ux, uy, uz) = (self.axial.k[a][b] * x[r], kz[ta][tb] * y[r], ky[ta][tb] * z[r]);
            let (vx, vy, vz) = (self.torsion.k[a][b] * x[r], ky[ra][rb] * y[r], kz[ra][rb] * z[r]);
            let (py, pz) = (kz[ta][rb] * y[r], ky[ta][rb] * z[r]);
            let (qz, qy) = (kz[ra][tb] * z[r], ky[ra][tb] * y[r]);
            for c in 0..3 {
                k[r][c] = ux * x[c] + uy * y[c] + uz * z[c];
                k[r][c + 3] = py * z[c] + pz * y[c];
                k[r + 3][c] = qz * y[c] + qy * z[c];
                k[r + 3][c + 3] = vx * x[c] + vy * y[c] + vz * z[c];
            }
        }
        k
    }
}

/// Global 12 x 12 stiffness of a member, releases condensed; rows and columns ux uy uz rx ry rz at i, then at j.
/// `None` when it has no length or its reference vector lies along it.
pub fn member_stiffness(
    member: &Member,
    ends: [[f64; 3]; 2],
    material: &Material,
    section: &Section,
    shear: bool,
) -> Option<[[f64; 12]; 12]> {
    let (axes, length) = super::axes::local_axes(member, ends[0], ends[1])?;
    let beam = Beam::new(member, material, section, shear, axes, length);
    let mut k = [[0.0; 12]; 12];
    for (a, b) in [(0, 0), (0, 1), (1, 0), (1, 1)] {
        let block = beam.block(a, b);
        (0..6).for_each(|r| k[6 * a + r][6 * b..6 * b + 6].copy_from_slice(&block[r]));
    }
    Some(k)
}
