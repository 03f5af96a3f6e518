//! The sun: its direction and a map of what it reaches.

use glam::Vec3;

use super::camera::Projected;
use super::raster::Buffer;

/// A parallel light with a depth map of `SIDE` x `SIDE` texels over the scene.
pub struct Sun {
    /// Unit vector towards the sun.
    pub towards: Vec3,
    axes: [Vec3; 2],
    corner: [f32; 2],
    per_m: f32,
    map: Buffer,
}

/// Texels along a side of the depth map.
const SIDE: usize = 1280;

/// Height added to keep depths positive, m.
const LIFT: f32 = 1e4;

impl Sun {
    /// Renders the depth map of `faces` (three corners each) seen from the direction `towards`.
    pub fn shine(towards: Vec3, faces: &[[Vec3; 3]]) -> Sun {
        let towards = towards.normalize();
        let right = Vec3::Z.cross(towards).normalize_or(Vec3::X);
        let axes = [right, towards.cross(right)];
        let bounds = axes.map(|a| {
            let along = || faces.iter().flatten().map(|p| a.dot(*p));
            [along().fold(f32::MAX, f32::min), along().fold(f32::MIN, f32::max)]
        });
        let extent = (bounds[0][1] - bounds[0][0]).max(bounds[1][1] - bounds[1][0]).max(1e-3);
        let per_m = (SIDE as f32 - 8.0) / extent;
        let corner = [bounds[0][0] - 4.0 / per_m, bounds[1][0] - 4.0 / per_m];
        let mut sun = Sun { towards, axes, corner, per_m, map: Buffer::new([SIDE, SIDE]) };
        for (i, face) in faces.iter().enumerate() {
            let corners = face.map(|p| sun.project(p));
            sun.map.draw(i as u32, corners, true);
        }
        sun
    }

    fn project(&self, p: Vec3) -> Projected {
        let at = [0, 1].map(|i| (self.axes[i].dot(p) - self.corner[i]) * self.per_m);
        Projected { at, depth: self.towards.dot(p) + LIFT }
    }

    /// Share of the sun that reaches a point with the normal `normal`, 0 to 1: nine soft taps about 5 cm apart, four where they agree.
    pub fn reaches(&self, p: Vec3, normal: Vec3) -> f32 {
        let here = self.project(p + normal * 0.03 + self.towards * 0.02);
        let step = (0.05 * self.per_m).max(1.0);
        let (x, y, z) = (here.at[0], here.at[1], here.depth);
        let corners =
            [(-step, -step), (step, -step), (-step, step), (step, step)].map(|(u, v)| self.tap(x + u, y + v, z));
        if corners.iter().all(|c| *c == corners[0]) {
            return corners[0];
        }
        let mut lit = 0.0;
        for dy in [-step, 0.0, step] {
            for dx in [-step, 0.0, step] {
                lit += self.tap(x + dx, y + dy, z);
            }
        }
        lit / 9.0
    }

    fn tap(&self, x: f32, y: f32, depth: f32) -> f32 {
        let inside = x >= 0.0 && y >= 0.0 && x < SIDE as f32 && y < SIDE as f32;
        let hidden = inside && self.map.depth[x as usize + SIDE * y as usize] > depth;
        if hidden { 0.0 } else { 1.0 }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_roof_throws_a_shadow_beside_itself() {
        let [a, b, c] = [[0.0, 0.0, 2.0], [4.0, 0.0, 2.0], [0.0, 4.0, 2.0]].map(Vec3::from);
        let sun = Sun::shine(Vec3::new(-1.0, 0.0, 1.0), &[[a, b, c]]);
        assert!(sun.reaches(Vec3::new(3.0, 1.0, 0.0), Vec3::Z) < 0.01, "2 m east of the roof's middle");
        assert!(sun.reaches(Vec3::new(0.5, 1.0, 0.0), Vec3::Z) > 0.99, "under its western edge the sun comes in");
        assert!(sun.reaches(Vec3::new(1.0, 1.0, 2.0), Vec3::Z) > 0.99, "the roof itself is lit");
    }
}
