//! Where the points of a member go.

use super::line::Line;
use super::solution::Solution;

/// Displacement of the point at share `t` (0 at i, 1 at j) of `member` under the sum of `factors[case]` times each case, global axes.
///
/// `ends`: displacements of its two nodes under the same sum. Between them the chord runs straight and the member bends by its own
/// end moments and loads ([`Line::deflection`]): exact across the member. What loads along it stretch it between its nodes is left
/// out: micrometres in a house.
///
/// ```
/// use houscaper::analysis::*;
/// // A beam of 2 m on two supports under q = 1 kN/m: 5 q L^4 / (384 E I) in the middle.
/// let pin = [false, false, false, false, true, true];
/// let model = Model {
///     nodes: vec![[0.0; 3], [2.0, 0.0, 0.0]],
///     materials: vec![Material { e: 210e9, g: 81e9, rho: 0.0 }],
///     sections: vec![Section { a: 1e-3, iy: 1e-6, iz: 1e-6, j: 2e-6, asy: None, asz: None }],
///     members: vec![Member { nodes: [0, 1], material: 0, section: 0, reference: None, roll: 0.0, releases: [pin; 2] }],
///     supports: vec![Support { node: 0, fix: [true; 6] }, Support { node: 1, fix: [true; 6] }],
///     shear: false,
/// };
/// let q = Distribution::Uniform { q: [0.0, 0.0, -1e3] };
/// let case = LoadCase { members: vec![MemberLoad { member: 0, axes: Axes::Global, distribution: q }], ..Default::default() };
/// let solution = solve(&model, &[case]).unwrap();
/// let moved = displacement_along(&solution, &[1.0], 0, [[0.0; 3]; 2], 0.5);
/// let sag = 5.0 * 1e3 * 16.0 / (384.0 * 210e9 * 1e-6);
/// assert!((moved[2] + sag).abs() < 1e-12 * sag.max(1.0) && moved[0] == 0.0);
/// ```
pub fn displacement_along(
    solution: &Solution,
    factors: &[f64],
    member: usize,
    ends: [[f64; 3]; 2],
    t: f64,
) -> [f64; 3] {
    let line = Line::new(solution, factors, member);
    let [v, w] = line.deflection(t * line.length());
    let [_, y, z] = solution.axes(member);
    let [a, b] = ends;
    std::array::from_fn(|n| a[n] + t * (b[n] - a[n]) + v * y[n] + w * z[n])
}
