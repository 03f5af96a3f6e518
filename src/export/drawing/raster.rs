//! Which face is nearest at each point of a sheet: a z-buffer of face numbers seen along an axis.

use super::model::{Model, Piece};
use super::view::View;

/// No face.
pub const NOTHING: u32 = u32::MAX;

/// Edge of a raster cell on the house, m. What hides a line ends it within a cell: 0.075 mm on a sheet at 1:100.
pub const CELL_M: f64 = 0.0075;

/// Cells at most; a larger house gets larger cells.
const MOST: f64 = 8e6;

/// Part of a view that is drawn: right and up, and how near.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Window {
    /// Lowest right and up, m.
    pub low: [f64; 2],
    /// Highest right and up, m.
    pub high: [f64; 2],
    /// What is nearer to the reader is cut away, m.
    pub near: f64,
}

/// The nearest face at each cell.
pub struct Raster {
    /// Cells right and down.
    pub size: [usize; 2],
    /// Edge of a cell, m.
    pub cell: f64,
    /// Right of the left edge and up of the upper one, m.
    pub corner: [f64; 2],
    /// Number of the face, [`NOTHING`] where there is none.
    pub face: Vec<u32>,
    /// How near it is, m.
    pub depth: Vec<f32>,
}

impl Raster {
    /// Draws all pieces that `which` picks.
    pub fn new(model: &Model, view: &View, window: &Window, which: impl Fn(&Piece) -> bool) -> Raster {
        let span = [0, 1].map(|a| (window.high[a] - window.low[a]).max(0.01));
        let cell = CELL_M.max((span[0] * span[1] / MOST).sqrt());
        let size = span.map(|s| (s / cell).ceil() as usize + 1);
        let cells = size[0] * size[1];
        let mut raster = Raster {
            size,
            cell,
            corner: [window.low[0], window.high[1]],
            face: vec![NOTHING; cells],
            depth: vec![f32::NEG_INFINITY; cells],
        };
        for piece in model.pieces.iter().filter(|p| which(p)) {
            let seen: Vec<[f64; 3]> = piece.vertices.iter().map(|v| view.see(*v)).collect();
            for (triangle, &face) in piece.triangles.iter().zip(&piece.face) {
                let normal = view.see(model.faces[face as usize].1);
                if normal[2] > 1e-6 {
                    raster.draw(face, &clip(&triangle.map(|v| seen[v as usize]), window.near), normal);
                }
            }
        }
        raster
    }

    /// Place on the raster in cells, right and down.
    pub fn place(&self, [u, v]: [f64; 2]) -> [f64; 2] {
        [(u - self.corner[0]) / self.cell, (self.corner[1] - v) / self.cell]
    }

    /// Right and up of a place on the raster, m.
    pub fn metres(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        [self.corner[0] + x * self.cell, self.corner[1] - y * self.cell]
    }

    /// Number of the cell a place lies in.
    pub fn at(&self, [x, y]: [f64; 2]) -> Option<usize> {
        let inside = x >= 0.0 && y >= 0.0 && x < self.size[0] as f64 && y < self.size[1] as f64;
        inside.then(|| x as usize + self.size[0] * y as usize)
    }

    /// Fills a convex polygon that lies in a plane with this normal.
    fn draw(&mut self, face: u32, polygon: &[[f64; 3]], normal: [f64; 3]) {
        let Some(first) = polygon.first() else { return };
        let points: Vec<[f64; 2]> = polygon.iter().map(|p| self.place([p[0], p[1]])).collect();
        let low = points.iter().map(|p| p[1]).fold(f64::MAX, f64::min);
        let high = points.iter().map(|p| p[1]).fold(f64::MIN, f64::max);
        let rows =
            ((low - 0.5).ceil().max(0.0) as usize)..((high - 0.5).ceil().clamp(0.0, self.size[1] as f64) as usize);
        let slope = [-normal[0] / normal[2] * self.cell, normal[1] / normal[2] * self.cell];
        let origin = self.place([first[0], first[1]]);
        for y in rows {
            let middle = y as f64 + 0.5;
            let Some([left, right]) = span(&points, middle) else { continue };
            let from = (left - 0.5).ceil().max(0.0) as usize;
            let to = (right - 0.5).ceil().clamp(0.0, self.size[0] as f64) as usize;
            let row = y * self.size[0];
            let start = first[2] + slope[0] * (0.5 - origin[0]) + slope[1] * (middle - origin[1]);
            for x in from..to.max(from) {
                let depth = (start + slope[0] * x as f64) as f32;
                if depth > self.depth[row + x] {
                    self.depth[row + x] = depth;
                    self.face[row + x] = face;
                }
            }
        }
    }
}

/// Where a row enters and leaves a convex polygon.
pub fn span(points: &[[f64; 2]], y: f64) -> Option<[f64; 2]> {
    let (mut left, mut right) = (f64::MAX, f64::MIN);
    for i in 0..points.len() {
        let (p, q) = (points[i], points[(i + 1) % points.len()]);
        let (p, q) = if p[1] <= q[1] { (p, q) } else { (q, p) };
        if p[1] <= y && y < q[1] {
            let x = p[0] + (q[0] - p[0]) * (y - p[1]) / (q[1] - p[1]);
            left = left.min(x);
            right = right.max(x);
        }
    }
    (left < right).then_some([left, right])
}

/// The part of a triangle that is not nearer than `near`.
fn clip(triangle: &[[f64; 3]; 3], near: f64) -> Vec<[f64; 3]> {
    if triangle.iter().all(|p| p[2] <= near) {
        return triangle.to_vec();
    }
    let mut kept = Vec::with_capacity(4);
    for i in 0..3 {
        let (p, q) = (triangle[i], triangle[(i + 1) % 3]);
        if p[2] <= near {
            kept.push(p);
        }
        if (p[2] <= near) != (q[2] <= near) {
            let t = (near - p[2]) / (q[2] - p[2]);
            kept.push([0, 1, 2].map(|a| p[a] + t * (q[a] - p[a])));
        }
    }
    kept
}
