//! The conventional shadow of elevations: light from above left over the reader's shoulder, at 45 degrees in plan and elevation, so that
//! a shadow's width is the depth of what throws it.

use super::model::{Kind, Model};
use super::raster::{NOTHING, Raster, span};
use super::view::View;

/// Edge of a cell of the light's own raster, m.
const CELL_M: f64 = 0.02;

/// How far a surface must lie behind what shades it, m.
const CLEAR_M: f64 = 0.04;

/// Cells of a row that are looked at together.
const STEP: usize = 5;

/// Which cells of an elevation lie in shadow.
pub fn shadow(model: &Model, view: &View, raster: &Raster) -> Vec<bool> {
    let light = Light::new(model, view);
    let dark: Vec<bool> = model
        .faces
        .iter()
        .map(|(_, normal)| {
            let [u, v, d] = view.see(*normal);
            -u + v + d <= 1e-6
        })
        .collect();
    let [w, h] = raster.size;
    let is_shaded = |i: usize| {
        let face = raster.face[i];
        let [u, v] = raster.metres([(i % w) as f64 + 0.5, (i / w) as f64 + 0.5]);
        dark[face as usize] || light.blocked(u, v, f64::from(raster.depth[i]))
    };
    let mut shaded = vec![false; w * h];
    for row in 0..h {
        for start in (0..w).step_by(STEP) {
            let (first, last) = (row * w + start, row * w + (start + STEP).min(w) - 1);
            let face = raster.face[first];
            let is_even = raster.face[first..=last].iter().all(|f| *f == face);
            if is_even && face == NOTHING {
                continue;
            }
            // Inside a face, light at both ends is light all the way.
            let ends = is_even.then(|| [is_shaded(first), is_shaded(last)]);
            for (i, shade) in (first..).zip(&mut shaded[first..=last]) {
                *shade = match ends {
                    Some([a, b]) if a == b => a,
                    _ => raster.face[i] != NOTHING && is_shaded(i),
                };
            }
        }
    }
    shaded
}

/// How near the nearest surface is along each ray. Rays run by (1, -1, -1) in right, up and towards the reader: right plus depth and up
/// less depth are the same all along one.
struct Light {
    corner: [f64; 2],
    size: [usize; 2],
    depth: Vec<f32>,
}

impl Light {
    fn new(model: &Model, view: &View) -> Light {
        let shear = |p: [f64; 3]| {
            let [u, v, d] = view.see(p);
            [u + d, v - d, d]
        };
        // Panes are seen through, by light too.
        let solid = || model.pieces.iter().filter(|p| p.kind != Kind::RailGlass);
        let all = || solid().flat_map(|p| &p.vertices).map(|p| shear(*p));
        let low = all().fold([f64::MAX; 2], |l, p| [l[0].min(p[0]), l[1].min(p[1])]);
        let high = all().fold([f64::MIN; 2], |l, p| [l[0].max(p[0]), l[1].max(p[1])]);
        let size = [0, 1].map(|a| (((high[a] - low[a]) / CELL_M).clamp(0.0, 6000.0)) as usize + 2);
        let mut light = Light { corner: low, size, depth: vec![f32::NEG_INFINITY; size[0] * size[1]] };
        for piece in solid() {
            let seen: Vec<[f64; 3]> = piece.vertices.iter().map(|v| shear(*v)).collect();
            for (triangle, &face) in piece.triangles.iter().zip(&piece.face) {
                let [u, v, d] = view.see(model.faces[face as usize].1);
                if -u + v + d > 1e-6 {
                    light.draw(triangle.map(|v| seen[v as usize]));
                }
            }
        }
        light
    }

    /// Row by row, with the depth at the middle of each cell.
    fn draw(&mut self, triangle: [[f64; 3]; 3]) {
        let [a, b, c] = triangle.map(|p| [(p[0] - self.corner[0]) / CELL_M, (p[1] - self.corner[1]) / CELL_M, p[2]]);
        let area = (b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1]);
        if area.abs() < 1e-9 {
            return;
        }
        let (ab, ac) = (b[2] - a[2], c[2] - a[2]);
        let slope =
            [(ab * (c[1] - a[1]) - ac * (b[1] - a[1])) / area, (ac * (b[0] - a[0]) - ab * (c[0] - a[0])) / area];
        let points = [a, b, c].map(|p| [p[0], p[1]]);
        let low = points.iter().map(|p| p[1]).fold(f64::MAX, f64::min);
        let high = points.iter().map(|p| p[1]).fold(f64::MIN, f64::max);
        let limit = |value: f64, most: usize| ((value - 0.5).ceil().max(0.0) as usize).min(most);
        for y in limit(low, self.size[1])..limit(high, self.size[1]) {
            let middle = y as f64 + 0.5;
            let Some([left, right]) = span(&points, middle) else { continue };
            let start = a[2] + slope[0] * (0.5 - a[0]) + slope[1] * (middle - a[1]);
            let row = y * self.size[0];
            for x in limit(left, self.size[0])..limit(right, self.size[0]) {
                let at = &mut self.depth[row + x];
                *at = at.max((start + slope[0] * x as f64) as f32);
            }
        }
    }

    /// Whether something nearer to the light stands on the ray through a point. The four cells around it vote by their nearness, so
    /// that the border of a slanting shadow has no steps.
    fn blocked(&self, u: f64, v: f64, d: f64) -> bool {
        let at = [u + d, v - d];
        let [x, y] = [0, 1].map(|a| (at[a] - self.corner[a]) / CELL_M - 0.5);
        let inside = x >= 0.0 && y >= 0.0 && x + 1.0 < self.size[0] as f64 && y + 1.0 < self.size[1] as f64;
        if !inside {
            return false;
        }
        let (i, j) = (x as usize, y as usize);
        let (s, t) = (x - i as f64, y - j as f64);
        let hides = |di: usize, dj: usize| {
            f64::from(u8::from(f64::from(self.depth[i + di + self.size[0] * (j + dj)]) > d + CLEAR_M))
        };
        let votes = hides(0, 0) * (1.0 - s) * (1.0 - t)
            + hides(1, 0) * s * (1.0 - t)
            + hides(0, 1) * (1.0 - s) * t
            + hides(1, 1) * s * t;
        votes > 0.5
    }
}
