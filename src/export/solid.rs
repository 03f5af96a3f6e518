//! Solids made of boxes: frame members as their bounding sections, window frames.

use glam::DVec3;

use super::Part;

/// The eight corners as six outward quads; corner order x + 2y + 4z.
const QUADS: [[usize; 4]; 6] = [[0, 4, 6, 2], [1, 3, 7, 5], [0, 1, 5, 4], [2, 6, 7, 3], [0, 2, 3, 1], [4, 5, 7, 6]];

/// Geometry of a straight member of rectangular outline between two points.
///
/// - `a`, `b`: centres of the end faces in m;
/// - `up`: the direction in which `depth` is measured (made perpendicular to the axis; where it runs along the axis,
///   global x serves);
/// - `width`, `depth` in m.
///
/// A member shorter than 1e-9 m has no geometry. The part has no name and material 0: the caller says what it is.
///
/// ```
/// let joist = houscaper::export::beam_solid([0.0; 3], [3.0, 0.0, 0.0], [0.0, 0.0, 1.0], 0.045, 0.22);
/// assert_eq!((joist.vertices.len(), joist.triangles.len()), (8, 12));
/// ```
pub fn beam_solid(a: [f64; 3], b: [f64; 3], up: [f64; 3], width: f64, depth: f64) -> Part {
    let (a, b, up) = (DVec3::from(a), DVec3::from(b), DVec3::from(up));
    let mut part = Part::default();
    let Some(axis) = (b - a).try_normalize().filter(|_| (b - a).length() > 1e-9) else { return part };
    let across = |u: DVec3| (u - axis * u.dot(axis)).try_normalize().filter(|_| u.cross(axis).length() > 1e-6);
    let Some(z) = across(up).or_else(|| across(DVec3::X)).or_else(|| across(DVec3::Y)) else { return part };
    let y = z.cross(axis);
    part.vertices = (0..8)
        .map(|c: u32| {
            let end = if c & 1 == 0 { a } else { b };
            let side = |bit: u32| if c & bit == 0 { -0.5 } else { 0.5 };
            (end + y * (width * side(2)) + z * (depth * side(4))).to_array()
        })
        .collect();
    part.triangles =
        QUADS.iter().flat_map(|q| [[q[0], q[1], q[2]], [q[0], q[2], q[3]]]).map(|t| t.map(|v| v as u32)).collect();
    part
}

#[cfg(test)]
mod tests {
    use super::*;

    fn volume(part: &Part) -> f64 {
        let corners = part.triangles.iter().filter_map(|&t| part.corners(t));
        corners.map(|[a, b, c]| DVec3::from(a).dot(DVec3::from(b).cross(DVec3::from(c))) / 6.0).sum()
    }

    #[test]
    fn solids_are_outward_whatever_their_direction() {
        for b in [[3.0, 0.0, 0.0], [0.0, 2.0, 0.0], [0.0, 0.0, 4.0], [1.0, -2.0, 0.5], [0.0, 0.0, -3.0]] {
            let part = beam_solid([0.0; 3], b, [0.0, 0.0, 1.0], 0.1, 0.2);
            let expected = 0.02 * DVec3::from(b).length();
            assert!((volume(&part) - expected).abs() < 1e-12, "{b:?}");
        }
    }

    #[test]
    fn depth_is_measured_along_up() {
        let part = beam_solid([0.0; 3], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0], 0.1, 0.3);
        let top = part.vertices.iter().map(|v| v[2]).fold(f64::MIN, f64::max);
        let side = part.vertices.iter().map(|v| v[1]).fold(f64::MIN, f64::max);
        assert!((top - 0.15).abs() < 1e-12 && (side - 0.05).abs() < 1e-12);
    }

    #[test]
    fn a_point_has_no_solid() {
        assert!(beam_solid([1.0; 3], [1.0; 3], [0.0, 0.0, 1.0], 0.1, 0.1).vertices.is_empty());
    }
}
