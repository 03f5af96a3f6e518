//! Local axes of a member.

use super::model::Member;

/// Rows: the unit vectors x, y, z of the member in global components.
pub type Axes3 = [[f64; 3]; 3];

/// A member counts as vertical when the horizontal part of its unit vector is below this.
const VERTICAL: f64 = 1e-9;

pub(super) fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

pub(super) fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

pub(super) fn norm(a: [f64; 3]) -> f64 {
    dot(a, a).sqrt()
}

fn scaled(a: [f64; 3], s: f64) -> [f64; 3] {
    [a[0] * s, a[1] * s, a[2] * s]
}

/// `axes * v`: global components to local ones.
pub(super) fn to_local(axes: &Axes3, v: [f64; 3]) -> [f64; 3] {
    [dot(axes[0], v), dot(axes[1], v), dot(axes[2], v)]
}

/// Local axes and length of `member` from `from` to `to`.
///
/// x from i to j; v = `reference`, else global Z, else for a member within 1e-9 of vertical global -X pointing up and +X
/// pointing down; y = v x x, z = x x y; `roll` (radians) turns y and z about +x. `None` for a member of no length or a
/// reference vector along it.
///
/// ```
/// use houscaper::analysis::{Member, local_axes};
/// let m = Member { nodes: [0, 1], material: 0, section: 0, reference: None, roll: 0.0, releases: [[false; 6]; 2] };
/// let (axes, length) = local_axes(&m, [0.0; 3], [2.0, 0.0, 0.0]).unwrap();
/// assert_eq!((axes[1], axes[2], length), ([0.0, 1.0, 0.0], [0.0, 0.0, 1.0], 2.0));
/// ```
pub fn local_axes(member: &Member, from: [f64; 3], to: [f64; 3]) -> Option<(Axes3, f64)> {
    let along = [to[0] - from[0], to[1] - from[1], to[2] - from[2]];
    let length = norm(along);
    if !(length.is_finite() && length > 0.0) {
        return None;
    }
    let x = scaled(along, 1.0 / length);
    let v = member.reference.unwrap_or_else(|| default_reference(x));
    let y = cross(v, x);
    let size = norm(y);
    // Below 1e-9 of |v| the direction of y is noise.
    if !(size.is_finite() && size > 1e-9 * norm(v)) {
        return None;
    }
    let y = scaled(y, 1.0 / size);
    let z = cross(x, y);
    Some((rolled([x, y, z], member.roll), length))
}

fn default_reference(x: [f64; 3]) -> [f64; 3] {
    if x[0].hypot(x[1]) > VERTICAL {
        [0.0, 0.0, 1.0]
    } else if x[2] > 0.0 {
        [-1.0, 0.0, 0.0]
    } else {
        [1.0, 0.0, 0.0]
    }
}

fn rolled([x, y, z]: Axes3, roll: f64) -> Axes3 {
    if roll == 0.0 {
        return [x, y, z];
    }
    let (s, c) = roll.sin_cos();
    [x, std::array::from_fn(|k| c * y[k] + s * z[k]), std::array::from_fn(|k| c * z[k] - s * y[k])]
}
