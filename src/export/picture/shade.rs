//! Colour of a face under sun and sky, in linear light.

use glam::{FloatExt, Vec3};

use crate::export::scene::{Grain, MaterialLook};

/// What decides the light at a place.
#[derive(Clone, Copy, Debug)]
pub struct Light {
    /// Share of the sun, 0 to 1.
    pub sun: f32,
    /// Share of the sky, 0 to 1.
    pub sky: f32,
    /// Unit vector towards the sun.
    pub towards: Vec3,
}

const SUN: Vec3 = Vec3::new(0.86, 0.80, 0.70);
const SKY: Vec3 = Vec3::new(0.46, 0.51, 0.58);
const BOUNCE: Vec3 = Vec3::new(0.34, 0.32, 0.30);

/// Light that falls on a surface with this normal.
pub fn irradiance(normal: Vec3, light: Light) -> Vec3 {
    let ambient = BOUNCE.lerp(SKY, 0.5 + 0.5 * normal.z);
    SUN * (normal.dot(light.towards).max(0.0) * light.sun) + ambient * light.sky
}

/// The sky seen in a direction: white at the horizon, a quiet blue above.
pub fn sky(direction: Vec3) -> Vec3 {
    let t = direction.z.clamp(0.0, 1.0).sqrt();
    Vec3::new(0.93, 0.94, 0.95).lerp(Vec3::new(0.46, 0.60, 0.76), t)
}

/// Base colours in single precision.
pub struct Paint {
    colour: Vec3,
    /// 0 clear to 1 opaque.
    pub opacity: f32,
    grain: Grain,
}

impl Paint {
    /// From a material.
    pub fn new(look: &MaterialLook) -> Self {
        let [red, green, blue, opacity] = look.rgba.map(|c| c as f32);
        Paint { colour: Vec3::new(red, green, blue), opacity, grain: look.grain }
    }

    /// Whether the colour does not change over a face.
    pub fn is_even(&self) -> bool {
        matches!(self.grain, Grain::Plain | Grain::Glass)
    }

    /// Colour of a face at a place, seen along `ray`; `pixel_m` fades patterns that are finer than the picture.
    pub fn shade(&self, p: Vec3, normal: Vec3, ray: Vec3, pixel_m: f32, light: Light) -> Vec3 {
        let lit = irradiance(normal, light);
        match self.grain {
            Grain::Plain => self.colour * lit,
            Grain::Courses => self.colour * lit * stripes(p.z / 0.16, pixel_m / 0.16, 0.25),
            Grain::Boards => self.colour * lit * stripes(p.y / 0.15, pixel_m / 0.15, 0.3),
            // On a wall that follows the grid one of x and y is constant, so their sum runs along it.
            Grain::Cladding => self.colour * lit * stripes((p.x + p.y) / 0.15, pixel_m / 0.15, 0.16),
            Grain::Glass => self.glass(normal, ray.normalize(), lit, light.sky),
        }
    }

    /// A pane in front of `behind`: it lets its share through, tinted, and mirrors the sky, more at grazing angles. A pane out of
    /// the sun mirrors what shades it, which is darker than the sky.
    pub fn glaze(&self, behind: Vec3, normal: Vec3, ray: Vec3, sun: f32) -> Vec3 {
        let cos = (-normal.dot(ray)).clamp(0.0, 1.0);
        let mirrored = ray + normal * (2.0 * cos);
        let world = if mirrored.z > 0.0 { sky(mirrored) } else { Vec3::new(0.50, 0.50, 0.48) };
        let share = (0.5 * self.opacity).lerp(1.0, (1.0 - cos).powi(5)) * 0.55.lerp(1.0, sun);
        let tint = Vec3::ONE.lerp(self.colour / self.colour.max_element().max(1e-3), self.opacity);
        (behind * tint * (1.0 - self.opacity)).lerp(world, share)
    }

    /// Dark room behind, sky and ground reflected more at grazing angles (Schlick 1994).
    fn glass(&self, normal: Vec3, ray: Vec3, lit: Vec3, open: f32) -> Vec3 {
        let cos = (-normal.dot(ray)).clamp(0.0, 1.0);
        let mirrored = ray + normal * (2.0 * cos);
        let world = if mirrored.z > 0.0 { sky(mirrored) } else { Vec3::new(0.62, 0.61, 0.58) };
        let share = 0.22.lerp(1.0, (1.0 - cos).powi(5));
        self.colour * lit * 0.75 + world * (share * open)
    }
}

/// Thin dark joints every unit of `s`; fades to their mean when a pixel covers more than a third of a unit.
fn stripes(s: f32, pixel: f32, depth: f32) -> f32 {
    let joint = if s - s.floor() < 0.16 { 1.0 - depth } else { 1.0 };
    let mean = 1.0 - 0.16 * depth;
    let fade = ((pixel - 0.15) / 0.35).clamp(0.0, 1.0);
    joint.lerp(mean, fade)
}
