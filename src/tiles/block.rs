//! Blocks: the convex pieces that solids are made of.

use super::Component;

/// A convex solid: a vertical prism over a convex polygon in plan, closed by a plane below and a plane above.
///
/// Lengths are whole micrometres in the cube's own axes (x, y from 0 to 900 000, z from 0 to 540 000; pieces that poke out of the
/// cube say so by their coordinates). Everything derived from blocks (faces, volumes, sections) is exact.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Block {
    /// What it is.
    pub component: Component,
    /// The corner of the cube (0..8) whose voxel it belongs to.
    pub octant: u8,
    /// Corners in plan, counter-clockwise seen from above, at least three, no three on a line.
    pub plan: Vec<[i32; 2]>,
    /// Height of the lower face over each corner of the plan; all on one plane.
    pub bottom: Vec<i32>,
    /// Height of the upper face over each corner; all on one plane, nowhere below the lower face and somewhere above it.
    pub top: Vec<i32>,
}

impl Block {
    /// An axis-parallel box from `low` to `high`.
    pub fn cuboid(component: Component, octant: u8, low: [i32; 3], high: [i32; 3]) -> Block {
        Block {
            component,
            octant,
            plan: vec![[low[0], low[1]], [high[0], low[1]], [high[0], high[1]], [low[0], high[1]]],
            bottom: vec![low[2]; 4],
            top: vec![high[2]; 4],
        }
    }

    /// Its faces as polygons, counter-clockwise seen from outside; faces without area are left out, repeated corners dropped.
    pub fn faces(&self) -> Vec<Vec<[i32; 3]>> {
        let n = self.plan.len();
        let at = |i: usize, z: i32| [self.plan[i % n][0], self.plan[i % n][1], z];
        let mut faces = Vec::with_capacity(n + 2);
        faces.push((0..n).rev().map(|i| at(i, self.bottom[i])).collect());
        faces.push((0..n).map(|i| at(i, self.top[i])).collect());
        for i in 0..n {
            let j = (i + 1) % n;
            let mut face = vec![at(i, self.bottom[i]), at(j, self.bottom[j]), at(j, self.top[j]), at(i, self.top[i])];
            face.dedup();
            if face.first() == face.last() {
                face.pop();
            }
            if face.len() >= 3 {
                faces.push(face);
            }
        }
        faces
    }

    /// Six times its volume in µm3, exact.
    pub fn six_volumes(&self) -> i128 {
        let height = |i: usize| i128::from(self.top[i]) - i128::from(self.bottom[i]);
        (1..self.plan.len() - 1)
            .map(|i| {
                let [a, b, c] = [0, i, i + 1].map(|i| self.plan[i].map(i128::from));
                let doubled = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
                doubled * (height(0) + height(i) + height(i + 1))
            })
            .sum()
    }

    /// Area of its upper face in m2, measured in the face's own plane.
    pub fn top_area_m2(&self) -> f64 {
        let at = |i: usize| [self.plan[i][0], self.plan[i][1], self.top[i]].map(f64::from);
        let mut sum = [0.0; 3];
        for i in 1..self.plan.len() - 1 {
            let [a, b, c] = [at(0), at(i), at(i + 1)];
            let (u, v) = ([0, 1, 2].map(|k| b[k] - a[k]), [0, 1, 2].map(|k| c[k] - a[k]));
            sum[0] += u[1] * v[2] - u[2] * v[1];
            sum[1] += u[2] * v[0] - u[0] * v[2];
            sum[2] += u[0] * v[1] - u[1] * v[0];
        }
        0.5e-12 * sum[0].hypot(sum[1]).hypot(sum[2])
    }

    /// Its volume in m3.
    pub fn volume_m3(&self) -> f64 {
        self.six_volumes() as f64 / 6e18
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_box_and_a_wedge() {
        let cube = Block::cuboid(Component::Cladding, 0, [0; 3], [900_000, 450_000, 270_000]);
        assert_eq!(cube.faces().len(), 6);
        assert!((cube.volume_m3() - 0.9 * 0.45 * 0.27).abs() < 1e-15);
        let wedge = Block { top: vec![0, 0, 270_000, 270_000], ..cube };
        assert_eq!(wedge.faces().len(), 5, "the front has no height");
        assert!((wedge.volume_m3() - 0.5 * 0.9 * 0.45 * 0.27).abs() < 1e-15);
    }
}
