//! Pictures without a GPU or a display: a z-buffer, sun and sky, thin ink lines, and a person for scale.
//!
//! Equal scenes and settings give equal bytes; one picture is drawn on one thread, so many can be drawn at once.

mod camera;
mod image;
mod ink;
mod occlusion;
mod person;
mod raster;
mod shade;
mod sun;
mod turntable;

pub use camera::View;
pub(crate) use image::encode;
pub use image::{Image, ImageError};
pub use turntable::{MOST_FRAMES, animated, sprites, turntable};

use glam::{DVec3, FloatExt, Vec3};

use super::scene::{Scene, SceneError};
use camera::Camera;
use ink::Face;
use raster::{Buffer, NOTHING};
use shade::{Light, Paint};
use sun::Sun;

/// What the picture of a scene should be.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Picture {
    /// Pixels across and down, each 1 to 4096.
    pub size: [usize; 2],
    /// Samples a pixel in each direction, 1 to 4.
    pub samples: usize,
    /// Where it is taken from.
    pub view: View,
    /// Height of the ground in m; what lies below is not seen.
    pub ground_m: f64,
    /// Whether a person stands beside the house.
    pub person: bool,
    /// A box in m that the camera fits instead of the scene, so that several pictures share a scale.
    pub fit: Option<[[f64; 3]; 2]>,
    /// Whether scale and person stay the same from whatever direction it is taken, as in a turntable.
    pub is_steady: bool,
}

impl Picture {
    /// The picture of a house: the terrain lies a step below the slab's top, which is height 0, so that its plinth is seen.
    pub fn of_house(size: [usize; 2]) -> Picture {
        Picture { size, samples: 3, ground_m: -0.15, ..Picture::default() }
    }
}

impl Default for Picture {
    /// A thumbnail: 480 x 360, four samples a pixel, three-quarter view, ground at 0, with a person.
    fn default() -> Self {
        Picture {
            size: [480, 360],
            samples: 2,
            view: View::default(),
            ground_m: 0.0,
            person: true,
            fit: None,
            is_steady: false,
        }
    }
}

/// Why a picture could not be drawn.
#[derive(Debug, thiserror::Error)]
pub enum PictureError {
    /// The scene refers to what it does not hold.
    #[error(transparent)]
    Scene(#[from] SceneError),
    /// A size or sample count out of range.
    #[error(
        "picture of {width} x {height} pixels with {samples} samples: expected 1 to 4096 pixels and 1 to 4 samples"
    )]
    Size {
        /// Pixels across.
        width: usize,
        /// Pixels down.
        height: usize,
        /// Samples a pixel in each direction.
        samples: usize,
    },
}

const INK: Vec3 = Vec3::new(0.035, 0.037, 0.042);
const SUN_TOWARDS: Vec3 = Vec3::new(-0.48, -0.66, 0.78);

/// Draws a scene.
///
/// # Errors
/// When [`Scene::check`] fails or the settings are out of range.
pub fn render(scene: &Scene, picture: &Picture) -> Result<Image, PictureError> {
    scene.check()?;
    let [width, height] = picture.size;
    let good = |n: usize, most: usize| (1..=most).contains(&n);
    if !(good(width, 4096) && good(height, 4096) && good(picture.samples, 4)) {
        return Err(PictureError::Size { width, height, samples: picture.samples });
    }
    Ok(Stage::set(scene, picture).develop(picture))
}

/// Everything known before colours are: faces, what each sample sees, and where.
struct Stage {
    paints: Vec<Paint>,
    faces: Vec<Face>,
    sun: Sun,
    camera: Camera,
    buffer: Buffer,
    /// The nearest pane of glass at each sample; a buffer of its own, because what stands behind is seen too.
    panes: Buffer,
    centre: Vec3,
    radius: f32,
}

impl Stage {
    fn set(scene: &Scene, picture: &Picture) -> Stage {
        let mut paints: Vec<Paint> = scene.materials.iter().map(Paint::new).collect();
        let (mut corners, mut faces, mut keep) = collect(scene);
        let ground = picture.ground_m as f32;
        let mut points: Vec<Vec3> = match picture.fit {
            Some([low, high]) => box_corners(low, high),
            None => corners.iter().flatten().map(|p| Vec3::new(p.x, p.y, p.z.max(ground))).collect(),
        };
        let (low, high) = points.iter().fold((Vec3::MAX, Vec3::MIN), |(l, h), p| (l.min(*p), h.max(*p)));
        let (centre, radius) =
            if points.is_empty() { (Vec3::ZERO, 1.0) } else { (0.5 * (low + high), 0.5 * low.distance(high)) };
        if picture.person && !points.is_empty() {
            let right = Camera::fit(picture.view, &[], picture.size, 0.0).axes()[0];
            let from = if picture.is_steady { View::default() } else { picture.view };
            let foot = beside(low, high, ground, from);
            let figure = person::figure(foot, right);
            points.extend(figure.iter().flatten());
            let material = paints.len() as u16;
            paints.push(Paint::new(&super::scene::MaterialLook::matt("person", 0x45484C, 1.0)));
            let normal = right.cross(Vec3::Z);
            faces.extend(figure.iter().map(|_| Face { normal, material, lined: false }));
            keep.resize(faces.len(), true);
            corners.extend(figure);
        }
        if picture.is_steady {
            points = ring(&points, centre, picture.view);
        }
        let size = picture.size.map(|s| s * picture.samples);
        let camera = Camera::fit(picture.view, &points, size, 0.10);
        let clear = |face: &Face| paints[usize::from(face.material)].opacity < 1.0;
        let (mut buffer, mut panes) = (Buffer::new(size), Buffer::new(size));
        for (i, face) in corners.iter().enumerate() {
            let pane = clear(&faces[i]);
            let into = if pane { &mut panes } else { &mut buffer };
            into.draw(i as u32, face.map(|p| camera.project(p)), keep[i] || pane);
        }
        let above: Vec<bool> = corners.iter().map(|face| face.iter().all(|p| p.z >= ground)).collect();
        lay_ground(&mut buffer, &camera, ground, &above);
        // Solids are closed: what turns its back to the sun has something nearer to it.
        let shades = |n: &usize| !clear(&faces[*n]) && (keep[*n] || faces[*n].normal.dot(SUN_TOWARDS) > 0.0);
        let solid: Vec<[Vec3; 3]> = (0..corners.len()).filter(shades).map(|n| corners[n]).collect();
        let sun = Sun::shine(SUN_TOWARDS, &solid);
        Stage { paints, faces, sun, camera, buffer, panes, centre, radius }
    }

    fn develop(&self, picture: &Picture) -> Image {
        let n = picture.samples;
        let ink = ink::ink(&self.buffer, &self.faces, &self.camera);
        let open = occlusion::openness(&self.buffer, &self.camera, &self.faces, n);
        let [w, h] = picture.size;
        let mut image = Image::new([w, h]);
        for y in 0..h {
            for x in 0..w {
                image.set([x, y], self.pixel([x, y], n, &ink, open[x + w * y]));
            }
        }
        image
    }

    /// Mean colour of the samples of a pixel. Where all see one even face and no line crosses, one stands for all: the
    /// shadow's rim is soft enough for that.
    fn pixel(&self, [x, y]: [usize; 2], n: usize, ink: &[u8], open: f32) -> Vec3 {
        let width = self.buffer.size[0];
        let sample = |s: usize| (y * n + s / n) * width + x * n + s % n;
        let first = sample(0);
        let face = self.buffer.face[first];
        let even = self.faces.get(face as usize).is_none_or(|f| self.paints[usize::from(f.material)].is_even());
        let alike =
            |i: usize| self.buffer.face[i] == face && self.panes.face[i] == self.panes.face[first] && ink[i] == 0;
        if even && (0..n * n).map(sample).all(alike) {
            return self.colour(sample(n / 2 * (n + 1)), open, 0.0);
        }
        let sum: Vec3 = (0..n * n).map(sample).map(|i| self.colour(i, open, f32::from(ink[i]) * (0.85 / 255.0))).sum();
        sum / (n * n) as f32
    }

    /// Colour of a sample: what stands there with its ink, through the pane in front of it if there is one.
    fn colour(&self, i: usize, open: f32, ink: f32) -> Vec3 {
        let [w, _] = self.buffer.size;
        let (eye, ray) = self.camera.ray((i % w) as f32 + 0.5, (i / w) as f32 + 0.5);
        let behind = self.solid(i, eye, ray, open).lerp(INK, ink);
        let (pane, depth) = (self.panes.face[i], self.panes.depth[i]);
        match self.faces.get(pane as usize) {
            Some(face) if depth > self.buffer.depth[i] => {
                let normal = if face.normal.dot(ray) > 0.0 { -face.normal } else { face.normal };
                let p = eye + ray * self.camera.reach(depth);
                let sun = self.sun.reaches(p, normal);
                self.paints[usize::from(face.material)].glaze(behind, normal, ray.normalize(), sun)
            }
            _ => behind,
        }
    }

    /// Colour of the nearest thing that is not glass.
    fn solid(&self, i: usize, eye: Vec3, ray: Vec3, open: f32) -> Vec3 {
        if self.buffer.depth[i] <= 0.0 {
            return shade::sky(ray.normalize() * 0.8);
        }
        let p = eye + ray * self.camera.reach(self.buffer.depth[i]);
        let Some(face) = self.faces.get(self.buffer.face[i] as usize) else { return self.ground(p, open) };
        let normal =
            if face.normal.dot(ray) > 0.0 && face.normal.dot(p - eye) > 0.0 { -face.normal } else { face.normal };
        let sun = if normal.dot(self.sun.towards) > 0.0 { self.sun.reaches(p, normal) } else { 0.0 };
        let light = Light { sun, sky: open, towards: self.sun.towards };
        let pixel = self.camera.pixel_m(self.buffer.depth[i]) / normal.dot(ray.normalize()).abs().max(0.1);
        self.paints[usize::from(face.material)].shade(p, normal, ray, pixel, light)
    }

    /// Pale ground that catches the shadow and runs out into white.
    fn ground(&self, p: Vec3, open: f32) -> Vec3 {
        let away = (p.truncate().distance(self.centre.truncate()) / self.radius.max(1.0) - 1.0).max(0.0);
        let fade = (away / 2.2).clamp(0.0, 1.0);
        let fade = fade * fade * (3.0 - 2.0 * fade);
        let sun = if fade < 1.0 { self.sun.reaches(p, Vec3::Z) } else { 1.0 };
        let light = Light { sun, sky: open, towards: self.sun.towards };
        let lit = Vec3::new(0.70, 0.69, 0.66) * shade::irradiance(Vec3::Z, light);
        lit.lerp(shade::sky(Vec3::ZERO), 0.25.lerp(1.0, fade))
    }
}

/// Corners, shading and whether the back is kept, for every triangle of the scene that has an area.
fn collect(scene: &Scene) -> (Vec<[Vec3; 3]>, Vec<Face>, Vec<bool>) {
    let (mut corners, mut faces, mut keep) = (Vec::new(), Vec::new(), Vec::new());
    for part in scene.seen() {
        let look = &scene.materials[part.material];
        for face in part.triangles.iter().filter_map(|&t| part.corners(t)) {
            let [a, b, c] = face.map(DVec3::from);
            let Some(normal) = (b - a).cross(c - a).try_normalize() else { continue };
            corners.push([a, b, c].map(|p| p.as_vec3()));
            faces.push(Face { normal: normal.as_vec3(), material: part.material as u16, lined: look.name != "frame" });
            keep.push(look.double_sided);
        }
    }
    (corners, faces, keep)
}

/// A place on the ground at the left of the house as the camera sees it, a step towards the camera.
fn beside(low: Vec3, high: Vec3, ground: f32, view: View) -> Vec3 {
    let a = view.azimuth_deg.to_radians();
    let (towards, left) = (Vec3::new(a.cos(), a.sin(), 0.0), Vec3::new(a.sin(), -a.cos(), 0.0));
    let corners = [low, high, Vec3::new(low.x, high.y, 0.0), Vec3::new(high.x, low.y, 0.0)];
    let leftmost = corners.into_iter().max_by(|p, q| p.dot(left).total_cmp(&q.dot(left))).unwrap_or_default();
    (leftmost + towards * 1.6 - left * 0.2).with_z(ground)
}

/// The cylinder about the middle that holds all points, as points that turn with the view: what the camera fits is the same all around.
fn ring(points: &[Vec3], centre: Vec3, view: View) -> Vec<Vec3> {
    let radius = points.iter().map(|p| p.truncate().distance(centre.truncate())).fold(0.0, f32::max);
    let (low, high) = points.iter().fold((f32::MAX, f32::MIN), |(l, h), p| (l.min(p.z), h.max(p.z)));
    let corner = |n: usize| {
        let angle = view.azimuth_deg.to_radians() + n as f32 * std::f32::consts::TAU / 64.0;
        centre.truncate() + radius * glam::Vec2::new(angle.cos(), angle.sin())
    };
    if points.is_empty() {
        Vec::new()
    } else {
        (0..64).flat_map(|n| [corner(n).extend(low), corner(n).extend(high)]).collect()
    }
}

fn box_corners(low: [f64; 3], high: [f64; 3]) -> Vec<Vec3> {
    let pick = |i: usize, a: usize| if i >> a & 1 == 0 { low[a] as f32 } else { high[a] as f32 };
    (0..8).map(|i| Vec3::new(pick(i, 0), pick(i, 1), pick(i, 2))).collect()
}

/// Puts the ground in front of what lies below it: no face, but a depth; the sky has none. `above` tells the faces that do not reach
/// below the ground and so hide it.
fn lay_ground(buffer: &mut Buffer, camera: &Camera, ground: f32, above: &[bool]) {
    let [w, h] = buffer.size;
    for y in 0..h {
        for x in 0..w {
            let i = x + w * y;
            if above.get(buffer.face[i] as usize).is_some_and(|a| *a) {
                continue;
            }
            let (eye, ray) = camera.ray(x as f32 + 0.5, y as f32 + 0.5);
            let t = (ground - eye.z) / ray.z;
            let depth = if ray.z < 0.0 && t > 0.0 { camera.depth_at(t) } else { 0.0 };
            if buffer.face[i] == NOTHING || buffer.depth[i] < depth {
                buffer.face[i] = NOTHING;
                buffer.depth[i] = depth;
            }
        }
    }
}
