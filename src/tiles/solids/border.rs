//! Coordinates along the border between two columns, so that windows, railings and eaves are written once for all eight places.

use super::super::{Block, Component};

/// From a cube's middle plane to its face, µm.
pub(super) const HALF_UM: i32 = 450_000;

/// The border of column `q` towards its neighbour along `axis` (0 = x, 1 = y).
///
/// A point is given as [depth, aside]: `depth` from the border's plane into the column (negative: out of it), `aside` from the cube's
/// other middle plane (0) to the cube face on the column's side (450 mm; negative: beyond the middle, beside the lateral neighbour).
#[derive(Clone, Copy, Debug)]
pub(super) struct Border {
    pub q: usize,
    pub axis: usize,
}

impl Border {
    /// The column across the border.
    pub fn across(self) -> usize {
        self.q ^ (1 << self.axis)
    }

    /// The column beside this one, along the border.
    pub fn beside(self) -> usize {
        self.q ^ (2 >> self.axis)
    }

    /// Plan position in the cube of a point of the border, µm.
    fn plan(self, [depth, aside]: [i32; 2]) -> [i32; 2] {
        let sign = |axis: usize| if self.q >> axis & 1 == 0 { -1 } else { 1 };
        let mut xy = [HALF_UM; 2];
        xy[self.axis] += sign(self.axis) * depth;
        xy[1 - self.axis] += sign(1 - self.axis) * aside;
        xy
    }

    /// A prism over a convex polygon of [depth, aside] between `z(point)[0]` and `z(point)[1]`; `None` without volume.
    pub fn prism(
        self,
        component: Component,
        octant: usize,
        polygon: &[[i32; 2]],
        z: impl Fn([i32; 2]) -> [i32; 2],
    ) -> Option<Block> {
        let mut points: Vec<[i32; 2]> = Vec::with_capacity(polygon.len());
        for p in polygon {
            if points.last() != Some(p) && points.first() != Some(p) {
                points.push(*p);
            }
        }
        if points.len() < 3 {
            return None;
        }
        let (plan, heights): (Vec<_>, Vec<_>) = points.iter().map(|&p| (self.plan(p), z(p))).unzip();
        let cross = |i: usize| {
            let n = plan.len();
            let [a, b, c]: [[i32; 2]; 3] = [plan[i], plan[(i + 1) % n], plan[(i + 2) % n]];
            i64::from(b[0] - a[0]) * i64::from(c[1] - b[1]) - i64::from(b[1] - a[1]) * i64::from(c[0] - b[0])
        };
        let turn: i64 = (0..plan.len()).map(cross).sum();
        if turn == 0 || heights.iter().all(|[low, high]| high <= low) {
            return None;
        }
        let mut block = Block {
            component,
            octant: octant as u8,
            plan,
            bottom: heights.iter().map(|h| h[0]).collect(),
            top: heights.iter().map(|h| h[1]).collect(),
        };
        if turn < 0 {
            block.plan.reverse();
            block.bottom.reverse();
            block.top.reverse();
        }
        Some(block)
    }

    /// A box; `None` without volume.
    pub fn cuboid(
        self,
        component: Component,
        octant: usize,
        depth: [i32; 2],
        aside: [i32; 2],
        z: [i32; 2],
    ) -> Option<Block> {
        if depth[0] >= depth[1] || aside[0] >= aside[1] {
            return None;
        }
        let corners = [[depth[0], aside[0]], [depth[1], aside[0]], [depth[1], aside[1]], [depth[0], aside[1]]];
        self.prism(component, octant, &corners, |_| z)
    }
}
