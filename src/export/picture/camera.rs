//! A camera that looks from a fixed direction and stands just far enough away.

use glam::Vec3;

/// Where the picture is taken from, relative to the house.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct View {
    /// Direction from the house to the camera in plan, degrees counter-clockwise from +x (east).
    pub azimuth_deg: f32,
    /// Height of the camera over the horizon in degrees, -80 to 80.
    pub elevation_deg: f32,
    /// Vertical field of view in degrees; `None` for an axonometric (parallel) projection.
    pub field_deg: Option<f32>,
}

impl Default for View {
    /// Three-quarter view from the south-east, a little above the eaves, with a long lens.
    fn default() -> Self {
        View { azimuth_deg: -57.0, elevation_deg: 19.0, field_deg: Some(24.0) }
    }
}

/// A camera placed for one picture; `z` of camera coordinates points from the house to the eye.
#[derive(Clone, Copy, Debug)]
pub struct Camera {
    axes: [Vec3; 3],
    /// Middle of the picture in camera coordinates.
    centre: [f32; 2],
    /// Eye along the view axis (perspective), unused for parallel projection.
    eye_z: f32,
    /// Half extents: tangents in perspective, metres in parallel projection.
    half: [f32; 2],
    perspective: bool,
    size: [f32; 2],
}

/// A point in the picture: pixels from the top left, and a depth that grows linearly in the picture towards the eye.
#[derive(Clone, Copy, Debug)]
pub struct Projected {
    /// Pixels, x right, y down.
    pub at: [f32; 2],
    /// 1 / distance in perspective; height along the view axis in parallel projection.
    pub depth: f32,
}

impl Camera {
    /// Fits `points` into a picture of `size` pixels with a margin, a fraction of the half size.
    pub fn fit(view: View, points: &[Vec3], size: [usize; 2], margin: f32) -> Camera {
        let axes = axes(view);
        let size = size.map(|s| s.max(1) as f32);
        let aspect = size[0] / size[1];
        let local: Vec<[f32; 3]> = points.iter().map(|p| axes.map(|a| a.dot(*p))).collect();
        let furthest = |f: &dyn Fn(&[f32; 3]) -> f32| local.iter().map(f).fold(f32::MIN, f32::max);
        let tan_y = view.field_deg.map(|f| (f.clamp(5.0, 90.0).to_radians() * 0.5).tan());
        let mut camera =
            Camera { axes, centre: [0.0; 2], eye_z: 0.0, half: [1.0; 2], perspective: tan_y.is_some(), size };
        if local.is_empty() {
            return camera;
        }
        let tans = tan_y.map_or([0.0; 2], |t| [t * aspect, t]);
        let inner = 1.0 - margin.clamp(0.0, 0.8);
        // Each side of the frame is a plane through the eye: D tan >= +-(p - centre) + z tan bounds the distance D.
        let mut reach = [0.0f32; 2];
        for a in 0..2 {
            let t = tans[a] * inner;
            let (high, low) = (furthest(&|p| p[a] + p[2] * t), furthest(&|p| -p[a] + p[2] * t));
            camera.centre[a] = 0.5 * (high - low);
            reach[a] = 0.5 * (high + low);
        }
        if camera.perspective {
            camera.eye_z = (reach[0] / (tans[0] * inner)).max(reach[1] / (tans[1] * inner)).max(furthest(&|p| p[2]) + 0.1);
            camera.half = tans;
        } else {
            let y = (reach[0] / aspect).max(reach[1]).max(1e-3) / inner;
            camera.half = [y * aspect, y];
        }
        camera
    }

    /// Where a point of the scene appears. Points behind the eye have a depth of zero.
    pub fn project(&self, p: Vec3) -> Projected {
        let [x, y, z] = self.axes.map(|a| a.dot(p));
        let (dx, dy) = (x - self.centre[0], y - self.centre[1]);
        let near = self.eye_z - z;
        let (scale, depth) = match (self.perspective, near > 0.05) {
            (true, true) => (1.0 / near, 1.0 / near),
            (true, false) => (0.0, 0.0),
            (false, _) => (1.0, z + 1e4),
        };
        let ndc = [dx * scale / self.half[0], dy * scale / self.half[1]];
        Projected { at: [(ndc[0] + 1.0) * 0.5 * self.size[0], (1.0 - ndc[1]) * 0.5 * self.size[1]], depth }
    }

    /// The ray through a pixel position: origin and direction (not normalised).
    pub fn ray(&self, x: f32, y: f32) -> (Vec3, Vec3) {
        let u = (2.0 * x / self.size[0] - 1.0) * self.half[0];
        let v = (1.0 - 2.0 * y / self.size[1]) * self.half[1];
        let [right, up, back] = self.axes;
        let centre = right * self.centre[0] + up * self.centre[1];
        if self.perspective {
            (centre + back * self.eye_z, right * u + up * v - back)
        } else {
            (centre + right * u + up * v + back * 1e4, -back)
        }
    }

    /// Depth value of the point a ray reaches after `t` times its direction; matches [`Camera::project`].
    pub fn depth_at(&self, t: f32) -> f32 {
        if self.perspective { 1.0 / t } else { 2e4 - t }
    }

    /// The inverse of [`Camera::depth_at`].
    pub fn reach(&self, depth: f32) -> f32 {
        if self.perspective { 1.0 / depth } else { 2e4 - depth }
    }

    /// Metres that one pixel covers at a depth.
    pub fn pixel_m(&self, depth: f32) -> f32 {
        let scale = if self.perspective { 1.0 / depth } else { 1.0 };
        2.0 * self.half[1] * scale / self.size[1]
    }

    /// Right, up and backwards of the camera in the scene.
    pub fn axes(&self) -> [Vec3; 3] {
        self.axes
    }
}

fn axes(view: View) -> [Vec3; 3] {
    let (a, e) = (view.azimuth_deg.to_radians(), view.elevation_deg.clamp(-80.0, 80.0).to_radians());
    let back = Vec3::new(e.cos() * a.cos(), e.cos() * a.sin(), e.sin());
    let right = Vec3::Z.cross(back).normalize();
    [right, back.cross(right), back]
}

#[cfg(test)]
mod tests {
    use super::*;

    fn cloud() -> Vec<Vec3> {
        (0..8).map(|i| Vec3::new((i & 1) as f32 * 9.0, (i >> 1 & 1) as f32 * 6.0, (i >> 2) as f32 * 5.0)).collect()
    }

    #[test]
    fn the_fit_touches_the_margin_and_cuts_nothing() {
        for field_deg in [Some(24.0), Some(60.0), None] {
            let camera = Camera::fit(View { field_deg, ..View::default() }, &cloud(), [480, 360], 0.1);
            let seen: Vec<[f32; 2]> = cloud().iter().map(|p| camera.project(*p).at).collect();
            let slack = |a: usize, size: f32| {
                seen.iter().map(|p| (p[a] / size - 0.5).abs() * 2.0).fold(0.0, f32::max)
            };
            let fullest = slack(0, 480.0).max(slack(1, 360.0));
            assert!((fullest - 0.9).abs() < 1e-3, "{field_deg:?}: {fullest}");
        }
    }

    #[test]
    fn rays_meet_the_points_they_came_from() {
        for field_deg in [Some(24.0), None] {
            let camera = Camera::fit(View { field_deg, ..View::default() }, &cloud(), [480, 360], 0.1);
            for p in cloud() {
                let seen = camera.project(p);
                let (origin, direction) = camera.ray(seen.at[0], seen.at[1]);
                let back = origin + direction * camera.reach(seen.depth);
                assert!(back.distance(p) < 0.02, "{p} {back}");
            }
        }
    }
}
