//! How much of the sky a place sees, from the depth buffer alone.

use glam::Vec3;

use super::camera::Camera;
use super::ink::Face;
use super::raster::Buffer;

/// Directions probed around a place.
const PROBES: usize = 8;
/// How far they reach, m.
const REACH: f32 = 1.3;

/// Share of open sky for each pixel (`n` samples a pixel in each direction), 0.25 to 1, smoothed over 4 x 4 pixels.
///
/// Probes are points of the hemisphere over the place; one is blocked when the buffer holds something up to two reaches
/// in front of it. Each pixel of a 4 x 4 tile turns the same set by another angle, which the smoothing then averages.
pub fn openness(buffer: &Buffer, camera: &Camera, faces: &[Face], n: usize) -> Vec<f32> {
    let [w, h] = [buffer.size[0] / n, buffer.size[1] / n];
    let probes: Vec<[Vec3; PROBES]> = (0..16).map(probes).collect();
    let mut open = vec![1.0; w * h];
    for y in 0..h {
        for x in 0..w {
            let at = [x * n + n / 2, y * n + n / 2];
            let i = at[1] * buffer.size[0] + at[0];
            if buffer.depth[i] > 0.0 {
                let place = camera.point(at, buffer.depth[i]);
                let normal = faces.get(buffer.face[i] as usize).map_or(Vec3::Z, |f| f.normal);
                open[x + w * y] = look_up(buffer, camera, place, normal, &probes[x % 4 + 4 * (y % 4)]);
            }
        }
    }
    smooth(&open, [w, h], |i| {
        let sample = (i / w * n + n / 2) * buffer.size[0] + i % w * n + n / 2;
        faces.get(buffer.face[sample] as usize).map_or(Vec3::Z, |f| f.normal)
    })
}

fn look_up(buffer: &Buffer, camera: &Camera, place: Vec3, normal: Vec3, probes: &[Vec3; PROBES]) -> f32 {
    let [w, h] = buffer.size;
    let from = place + normal * 0.02;
    let mut blocked = 0.0;
    for probe in probes {
        let probe = if probe.dot(normal) < 0.0 { -*probe } else { *probe };
        let seen = camera.project(from + probe);
        let (x, y) = (seen.at[0], seen.at[1]);
        if x < 0.0 || y < 0.0 || x >= w as f32 || y >= h as f32 || seen.depth <= 0.0 {
            continue;
        }
        let there = buffer.depth[x as usize + w * y as usize];
        if there > seen.depth && there > 0.0 {
            let in_front = camera.reach(seen.depth) - camera.reach(there);
            if in_front > 0.02 {
                blocked += (2.0 - in_front / REACH).clamp(0.0, 1.0);
            }
        }
    }
    (1.0 - 0.85 * blocked / PROBES as f32).max(0.25)
}

/// Points spread over the sphere by the golden angle, nearer ones more often, turned by `turn` sixteenths.
fn probes(turn: usize) -> [Vec3; PROBES] {
    std::array::from_fn(|i| {
        let z = 1.0 - (2.0 * i as f32 + 1.0) / PROBES as f32;
        let angle = i as f32 * 2.399_963 + turn as f32 * std::f32::consts::TAU / 16.0;
        let r = (1.0 - z * z).sqrt();
        let length = REACH * (0.12 + 0.88 * ((i * 7 % PROBES) as f32 + turn as f32 / 16.0) / PROBES as f32);
        Vec3::new(r * angle.cos(), r * angle.sin(), z) * length
    })
}

/// Mean over 4 x 4 pixels of the same orientation.
fn smooth(open: &[f32], [w, h]: [usize; 2], normal: impl Fn(usize) -> Vec3) -> Vec<f32> {
    let normals: Vec<Vec3> = (0..w * h).map(normal).collect();
    let mut out = Vec::with_capacity(w * h);
    for y in 0..h {
        for x in 0..w {
            let here = normals[x + w * y];
            let (mut sum, mut count) = (0.0, 0.0);
            for v in y.saturating_sub(1)..(y + 3).min(h) {
                for u in x.saturating_sub(1)..(x + 3).min(w) {
                    if normals[u + w * v].dot(here) > 0.9 {
                        sum += open[u + w * v];
                        count += 1.0;
                    }
                }
            }
            out.push(if count > 0.0 { sum / count } else { 1.0 });
        }
    }
    out
}
