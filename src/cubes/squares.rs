//! Boolean marching squares: the two-dimensional case, which draws storey plans.

use crate::voxels::Plan;

/// The filled corners of a square between four pixel centres: bit x + 2y. One of 16 cases.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct SquareCase(pub u8);

/// Corners of a square counter-clockwise; edge e runs from the e-th to the next.
const AROUND: [u8; 4] = [0, 1, 3, 2];

/// Mid-points of those edges in half modules from the square's first corner.
const EDGE_MID: [[i32; 2]; 4] = [[1, 0], [2, 1], [1, 2], [0, 1]];

impl SquareCase {
    /// The contour through the square: pairs of edges (in, out), each path going through the square's centre, filled corners on
    /// its left. Corners that touch diagonally only are kept apart, as in the admissible cubes.
    ///
    /// Each run of filled corners around the square is walked from the edge behind it to the edge before it.
    pub fn paths(self) -> impl Iterator<Item = [usize; 2]> {
        let filled = move |n: usize| self.0 >> AROUND[n % 4] & 1 == 1;
        (0..4).filter(move |&e| filled(e) && !filled(e + 1)).map(move |into| {
            let mut out = into + 3;
            while filled(out) {
                out += 3;
            }
            [into, out % 4]
        })
    }
}

/// The outlines of a set of plan cells as closed loops in half modules: cell (i, j) is the square 2i-1..2i+1 x 2j-1..2j+1.
///
/// Loops have the cells on their left: outer ones run counter-clockwise, holes clockwise. Only corners are listed, the first is
/// not repeated. The shoelace areas add up to four per cell.
pub fn contours(plan: &Plan) -> Vec<Vec<[i32; 2]>> {
    let [nx, ny] = plan.size();
    let width = 2 * nx + 3;
    // The step that starts at a mid-point: the centre it goes through and the mid-point it reaches. One per mid-point.
    let mut steps: Vec<Option<[[i32; 2]; 2]>> = vec![None; width * (2 * ny + 3)];
    let slot = |p: [i32; 2]| (p[0] + 2) as usize + width * (p[1] + 2) as usize;
    for j in 0..=ny as i32 {
        for i in 0..=nx as i32 {
            let first = [2 * i - 2, 2 * j - 2];
            for [into, out] in square_case(plan, [i as isize - 1, j as isize - 1]).paths() {
                let at = |p: [i32; 2]| [first[0] + p[0], first[1] + p[1]];
                steps[slot(at(EDGE_MID[into]))] = Some([at([1, 1]), at(EDGE_MID[out])]);
            }
        }
    }
    let mut loops = Vec::new();
    for start in 0..steps.len() {
        let mut corners = Vec::new();
        let mut next = start;
        while let Some([centre, reached]) = steps[next].take() {
            corners.push(centre);
            next = slot(reached);
        }
        if !corners.is_empty() {
            loops.push(without_collinear(&corners));
        }
    }
    loops
}

fn square_case(plan: &Plan, [x, y]: [isize; 2]) -> SquareCase {
    SquareCase((0..4).fold(0, |bits, c| bits | u8::from(plan.has([x + (c & 1), y + (c >> 1)])) << c))
}

fn without_collinear(points: &[[i32; 2]]) -> Vec<[i32; 2]> {
    let n = points.len();
    let turns = |i: usize| {
        let (a, b, c) = (points[(i + n - 1) % n], points[i], points[(i + 1) % n]);
        (b[0] - a[0]) * (c[1] - b[1]) != (b[1] - a[1]) * (c[0] - b[0])
    };
    (0..n).filter(|&i| turns(i)).map(|i| points[i]).collect()
}
