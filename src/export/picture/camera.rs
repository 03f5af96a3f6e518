//! A camera that looks from a fixed direction and stands just far enough away.

use glam::Vec3;

/// Where the picture is taken from, relative to the house.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct View {
    /// Direction from the house to the camera in plan, degrees counter-clockwise from +x (east).
    pub azimuth_deg: f32,
    /// Height of the camera over the horizon in degrees, within 50 (perspective) or 80 (parallel) of level.
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
///
/// In perspective the view axis stays level and the picture is shifted instead, as architectural photographers do, so
/// that uprights stay upright; parallel projections look along the true direction.
#[derive(Clone, Copy, Debug)]
pub struct Camera {
    axes: [Vec3; 3],
    /// Middle of the picture in camera coordinates.
    centre: [f32; 2],
    /// Eye along the view axis (perspective), unused for parallel projection.
    eye_z: f32,
    /// Half extents: tangents in perspective, metres in parallel projection.
    half: [f32; 2],
    /// Slope of the ray through the middle of the picture (perspective).
    shift: f32,
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
        let tan = view.field_deg.map(|f| (f.clamp(5.0, 90.0).to_radians() * 0.5).tan());
        let shift = if tan.is_some() { -elevation(view).tan() } else { 0.0 };
        let mut camera =
            Camera { axes, centre: [0.0; 2], eye_z: 0.0, half: [1.0; 2], shift, perspective: tan.is_some(), size };
        let local: Vec<[f32; 3]> = points.iter().map(|p| axes.map(|a| a.dot(*p))).collect();
        if !local.is_empty() {
            camera.stand(&local, tan.unwrap_or(0.0), 1.0 - margin.clamp(0.0, 0.8));
        }
        camera
    }

    /// Places the camera: with the eye at distance D on the axis, every point must keep
    /// `m - t <= (p - centre) / (D - z) <= m + t` for both directions of the picture, m being the slope of its middle and
    /// t the half extent; the larger D of the two decides, and the centre shares the slack.
    fn stand(&mut self, points: &[[f32; 3]], tan_y: f32, inner: f32) {
        let aspect = self.size[0] / self.size[1];
        let tans = [tan_y * aspect * inner, tan_y * inner];
        let middle = [0.0, self.shift];
        let furthest = |f: &dyn Fn(&[f32; 3]) -> f32| points.iter().map(f).fold(f32::MIN, f32::max);
        let reach = [0, 1].map(|a| {
            let (m, t) = (middle[a], tans[a]);
            [furthest(&|p| p[a] + p[2] * (m + t)), furthest(&|p| -p[a] - p[2] * (m - t))]
        });
        let spread = reach.map(|[high, low]| 0.5 * (high + low));
        if self.perspective {
            let closest = furthest(&|p| p[2]) + 0.1;
            self.eye_z = (spread[0] / tans[0]).max(spread[1] / tans[1]).max(closest);
            self.half = [tan_y * aspect, tan_y];
        } else {
            let y = (spread[0] / aspect).max(spread[1]).max(1e-3) / inner;
            self.half = [y * aspect, y];
        }
        self.centre = [0, 1].map(|a| 0.5 * (reach[a][0] - reach[a][1]) - self.eye_z * middle[a]);
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
        let ndc = [dx * scale / self.half[0], (dy * scale - self.shift) / self.half[1]];
        Projected { at: [(ndc[0] + 1.0) * 0.5 * self.size[0], (1.0 - ndc[1]) * 0.5 * self.size[1]], depth }
    }

    /// The ray through a pixel position: origin and direction (not normalised).
    pub fn ray(&self, x: f32, y: f32) -> (Vec3, Vec3) {
        let u = (2.0 * x / self.size[0] - 1.0) * self.half[0];
        let v = (1.0 - 2.0 * y / self.size[1]) * self.half[1];
        let [right, up, back] = self.axes;
        let centre = right * self.centre[0] + up * self.centre[1];
        if self.perspective {
            (centre + back * self.eye_z, right * u + up * (v + self.shift) - back)
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

    /// The point seen at sample (x, y) of a buffer as large as the picture, at a depth above zero.
    pub fn point(&self, [x, y]: [usize; 2], depth: f32) -> Vec3 {
        let (eye, ray) = self.ray(x as f32 + 0.5, y as f32 + 0.5);
        eye + ray * self.reach(depth)
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

fn elevation(view: View) -> f32 {
    let limit = if view.field_deg.is_some() { 50.0 } else { 80.0 };
    view.elevation_deg.clamp(-limit, limit).to_radians()
}

fn axes(view: View) -> [Vec3; 3] {
    let (a, e) = (view.azimuth_deg.to_radians(), if view.field_deg.is_some() { 0.0 } else { elevation(view) });
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
            let slack = |a: usize, size: f32| seen.iter().map(|p| (p[a] / size - 0.5).abs() * 2.0).fold(0.0, f32::max);
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
