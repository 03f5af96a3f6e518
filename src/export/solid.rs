//! Frame members as bars of their bounding section.

use glam::DVec3;

use super::Part;

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
    bar_solid(&[a, b], up, width, depth)
}

/// As [`beam_solid`] through places on one line, at least two, with four vertices at each, so that a viewer can bend it.
pub fn bar_solid(stations: &[[f64; 3]], up: [f64; 3], width: f64, depth: f64) -> Part {
    let mut part = Part::default();
    let [Some(&a), Some(&b)] = [stations.first(), stations.last()] else { return part };
    let (a, b, up) = (DVec3::from(a), DVec3::from(b), DVec3::from(up));
    let Some(axis) = (b - a).try_normalize().filter(|_| (b - a).length() > 1e-9) else { return part };
    let across = |u: DVec3| (u - axis * u.dot(axis)).try_normalize().filter(|_| u.cross(axis).length() > 1e-6);
    let Some(z) = across(up).or_else(|| across(DVec3::X)).or_else(|| across(DVec3::Y)) else { return part };
    let y = z.cross(axis);
    // Around the section, counter-clockwise seen from the far end.
    let corners = [[-0.5, -0.5], [0.5, -0.5], [0.5, 0.5], [-0.5, 0.5]].map(|[u, v]| y * (width * u) + z * (depth * v));
    for &at in stations {
        part.vertices.extend(corners.map(|c| (DVec3::from(at) + c).to_array()));
    }
    let mut quad = |q: [u32; 4]| part.triangles.extend([[q[0], q[1], q[2]], [q[0], q[2], q[3]]]);
    let last = 4 * (stations.len() as u32 - 1);
    quad([3, 2, 1, 0]);
    quad([last, last + 1, last + 2, last + 3]);
    for n in (0..last).step_by(4) {
        for c in 0..4 {
            let d = (c + 1) % 4;
            quad([n + c, n + d, n + 4 + d, n + 4 + c]);
        }
    }
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
