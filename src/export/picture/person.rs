//! A person of 1.8 m for scale, as a flat figure that faces the camera.

use glam::Vec3;

/// Half the outline from the crown down one side, metres across and up, of a standing figure 1.80 m tall.
const HALF: [[f32; 2]; 19] = [
    [0.0, 1.80],
    [0.055, 1.785],
    [0.085, 1.74],
    [0.09, 1.68],
    [0.07, 1.61],
    [0.045, 1.575],
    [0.05, 1.53],
    [0.17, 1.48],
    [0.215, 1.42],
    [0.235, 1.25],
    [0.25, 1.05],
    [0.255, 0.85],
    [0.215, 0.82],
    [0.20, 1.02],
    [0.18, 0.90],
    [0.17, 0.50],
    [0.13, 0.08],
    [0.15, 0.0],
    [0.03, 0.0],
];

/// The figure's triangles: strips between the outline and the middle line, standing at `foot`, across `right`.
pub fn figure(foot: Vec3, right: Vec3) -> Vec<[Vec3; 3]> {
    let right = Vec3::new(right.x, right.y, 0.0).normalize_or(Vec3::X);
    let at = |[x, z]: [f32; 2]| foot + right * x + Vec3::Z * z;
    let mut faces = Vec::new();
    for side in [1.0, -1.0] {
        for pair in HALF.windows(2) {
            let [p, q] = [pair[0], pair[1]];
            // Legs part below the crotch: the inner line leaves the middle.
            let inner = |z: f32| if z < 0.80 { 0.03 * (1.0 - z / 0.80) + 0.004 } else { 0.0 };
            let (a, b) = ([p[0] * side, p[1]], [q[0] * side, q[1]]);
            let (c, d) = ([inner(q[1]) * side, q[1]], [inner(p[1]) * side, p[1]]);
            faces.push([at(a), at(b), at(c)]);
            faces.push([at(a), at(c), at(d)]);
        }
    }
    faces
}
