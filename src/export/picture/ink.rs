//! Thin lines where faces, materials or depths change.

use glam::Vec3;

use super::camera::Camera;
use super::raster::{Buffer, NOTHING};

/// What the lines are decided by, per face.
pub struct Face {
    /// Unit normal.
    pub normal: Vec3,
    /// Material.
    pub material: u16,
    /// Whether lines between this face and others are drawn.
    pub lined: bool,
}

/// Strength of the ink at each sample, 0 to 255.
pub fn ink(buffer: &Buffer, faces: &[Face], camera: &Camera) -> Vec<u8> {
    let [w, h] = buffer.size;
    let mut ink = vec![0u8; w * h];
    for y in 0..h.saturating_sub(1) {
        for x in 0..w.saturating_sub(1) {
            let i = x + w * y;
            for (j, at) in [(i + 1, [x + 1, y]), (i + w, [x, y + 1])] {
                let (f, g) = (buffer.face[i], buffer.face[j]);
                if f != g {
                    let place = || [camera.point([x, y], buffer.depth[i]), camera.point(at, buffer.depth[j])];
                    let strength = between(faces, [f, g], place);
                    // The line lies on the nearer side, so that it follows the object and not the background.
                    let on = if buffer.depth[i] >= buffer.depth[j] { i } else { j };
                    ink[on] = ink[on].max((strength * 255.0) as u8);
                }
            }
        }
    }
    ink
}

fn between(faces: &[Face], [f, g]: [u32; 2], place: impl Fn() -> [Vec3; 2]) -> f32 {
    if f == NOTHING || g == NOTHING {
        let face = &faces[if f == NOTHING { g } else { f } as usize];
        return if face.lined { 0.75 } else { 0.2 };
    }
    let (a, b) = (&faces[f as usize], &faces[g as usize]);
    let [p, q] = place();
    let step = (q - p).dot(a.normal).abs().min((q - p).dot(b.normal).abs());
    let lines = a.lined && b.lined;
    if step > 0.15 {
        if lines { 0.7 } else { 0.25 }
    } else if !lines {
        0.0
    } else if a.normal.dot(b.normal) < 0.97 {
        0.45
    } else if a.material != b.material {
        0.3
    } else {
        0.0
    }
}
