//! Triangles into a buffer of nearest faces.

use glam::DVec3;

use super::camera::Projected;

/// Nothing drawn at a sample.
pub const NOTHING: u32 = u32::MAX;

/// For every sample the nearest face and its depth (larger is nearer).
pub struct Buffer {
    /// Samples across and down.
    pub size: [usize; 2],
    /// Index of the nearest face, [`NOTHING`] where there is none.
    pub face: Vec<u32>,
    /// Its depth; 0 where there is none.
    pub depth: Vec<f32>,
}

impl Buffer {
    /// An empty buffer.
    pub fn new(size: [usize; 2]) -> Self {
        let n = size[0] * size[1];
        Buffer { size, face: vec![NOTHING; n], depth: vec![0.0; n] }
    }

    /// Draws a face given by its projected corners; `keep_back` draws it also when it turns its back.
    pub fn draw(&mut self, index: u32, corners: [Projected; 3], keep_back: bool) {
        // In double precision: over a roof's long triangles single precision drifts by centimetres, seen as streaks of shadow.
        let [a, b, c] = corners.map(|p| DVec3::new(f64::from(p.at[0]), f64::from(p.at[1]), f64::from(p.depth)));
        let area = (b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y);
        if a.z <= 0.0 || b.z <= 0.0 || c.z <= 0.0 || area.abs() < 1e-9 || (area > 0.0 && !keep_back) {
            return;
        }
        let gradient = |ab: f64, ac: f64| {
            [(ab * (c.y - a.y) - ac * (b.y - a.y)) / area, (ac * (b.x - a.x) - ab * (c.x - a.x)) / area]
        };
        let slope = gradient(b.z - a.z, c.z - a.z);
        let limits = |low: f64, high: f64, size: usize| {
            ((low - 0.5).ceil().max(0.0) as usize, ((high - 0.5).floor() + 1.0).clamp(0.0, size as f64) as usize)
        };
        let (y0, y1) = limits(a.y.min(b.y).min(c.y), a.y.max(b.y).max(c.y), self.size[1]);
        for y in y0..y1 {
            let py = y as f64 + 0.5;
            let Some((left, right)) = span([a, b, c], py) else { continue };
            let (x0, x1) = limits(left, right, self.size[0]);
            let row = y * self.size[0];
            let mut depth = a.z + slope[0] * (x0 as f64 + 0.5 - a.x) + slope[1] * (py - a.y);
            for i in row + x0..row + x1.max(x0) {
                if depth as f32 > self.depth[i] {
                    self.depth[i] = depth as f32;
                    self.face[i] = index;
                }
                depth += slope[0];
            }
        }
    }
}

/// Where a horizontal line enters and leaves a triangle.
fn span(corners: [DVec3; 3], y: f64) -> Option<(f64, f64)> {
    let (mut left, mut right) = (f64::MAX, f64::MIN);
    for (p, q) in [(0, 1), (1, 2), (2, 0)] {
        // Always the same order of the ends, so that neighbours compute the same crossing and leave no gap.
        let (p, q) = if corners[p].y <= corners[q].y { (corners[p], corners[q]) } else { (corners[q], corners[p]) };
        if p.y <= y && y < q.y {
            let x = p.x + (q.x - p.x) * (y - p.y) / (q.y - p.y);
            left = left.min(x);
            right = right.max(x);
        }
    }
    (left < right).then_some((left, right))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn at(x: f32, y: f32, depth: f32) -> Projected {
        Projected { at: [x, y], depth }
    }

    #[test]
    fn two_triangles_cover_a_square_once() {
        let mut buffer = Buffer::new([10, 10]);
        let (a, b, c, d) = (at(1.3, 1.3, 1.0), at(1.3, 8.7, 1.0), at(8.7, 8.7, 1.0), at(8.7, 1.3, 1.0));
        buffer.draw(0, [a, b, c], false);
        let first = buffer.face.iter().filter(|f| **f == 0).count();
        buffer.draw(1, [a, c, d], false);
        let all = buffer.face.iter().filter(|f| **f != NOTHING).count();
        assert_eq!(all, 64, "eight samples a side, 1.5 to 8.5, lie between 1.3 and 8.7");
        assert!(first > 20 && first < all);
    }

    #[test]
    fn the_nearer_face_wins_in_either_order() {
        for order in [[0, 1], [1, 0]] {
            let mut buffer = Buffer::new([4, 4]);
            for i in order {
                let z = 1.0 + i as f32;
                buffer.draw(i, [at(0.0, 0.0, z), at(0.0, 9.0, z), at(9.0, 0.0, z)], false);
            }
            assert_eq!(buffer.face[0], 1);
        }
    }

    #[test]
    fn backs_are_hidden_unless_wanted() {
        let back = [at(0.0, 0.0, 1.0), at(9.0, 0.0, 1.0), at(0.0, 9.0, 1.0)];
        let mut buffer = Buffer::new([4, 4]);
        buffer.draw(0, back, false);
        assert_eq!(buffer.face[0], NOTHING);
        buffer.draw(0, back, true);
        assert_eq!(buffer.face[0], 0);
    }
}
