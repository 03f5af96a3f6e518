//! What all drawings of a house share: its model, its grid, its levels, the paper they go on.

use super::model::{Kind, Model, Piece};
use super::sheet::Format;
use super::view::View;
use crate::export::Scene;
use crate::voxels::{Direction, House, Reading};

/// The terrain lies a step below the top of the slab, m.
pub const GROUND_M: f64 = -0.15;
/// How high above a floor a plan is cut, m.
pub const CUT_M: f64 = 1.2;

/// A house with what its drawings share.
pub struct Subject<'a> {
    /// For title blocks.
    pub name: &'a str,
    /// Voxels and stairs.
    pub house: &'a House,
    /// Storeys and openings.
    pub reading: &'a Reading,
    /// What `house.glb` shows.
    pub model: Model,
    /// One paper and scale for all.
    pub format: Format,
    /// Corner of cell (0, 0) in plan, and the centre of the lowest voxels, m.
    pub origin: [f64; 3],
    /// Edges of a module, m.
    pub module: [f64; 3],
    /// Lowest and highest corner of all that is seen, m.
    pub bounds: [[f64; 3]; 2],
}

impl<'a> Subject<'a> {
    /// `scene` is that of `house.glb`.
    pub fn new(name: &'a str, house: &'a House, reading: &'a Reading, scene: &Scene) -> Option<Subject<'a>> {
        let model = Model::new(scene);
        let bounds = model.bounds(|_| true)?;
        let (module, [x, y, z]) = (house.voxels.module.size_m, house.voxels.origin_m);
        let origin = [x - 0.5 * module[0], y - 0.5 * module[1], z];
        let [w, d, h] = [0, 1, 2].map(|a| bounds[1][a] - bounds[0][a]);
        let format = Format::fit([w.max(d).max(w), d.max(h + 0.6)]);
        Some(Subject { name, house, reading, model, format, origin, module, bounds })
    }

    /// Height of the ground, m.
    pub fn ground(&self) -> f64 {
        self.origin[2] + GROUND_M
    }

    /// Height of the top of a plate, m.
    pub fn floor(&self, plate_k: usize) -> f64 {
        self.origin[2] + plate_k as f64 * self.module[2]
    }

    /// A height as a level over the ground storey's floor, m.
    pub fn level(&self, z: f64) -> f64 {
        z - self.origin[2]
    }

    /// A place in plan given in modules from the corner of cell (0, 0), m.
    pub fn place(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        [self.origin[0] + x * self.module[0], self.origin[1] + y * self.module[1]]
    }

    /// Whether the house is drawn by a skin, which has no thickness to cut.
    pub fn is_skin(&self) -> bool {
        self.model.pieces.iter().any(|p| p.kind == Kind::Skin)
    }

    /// First and last cell of the plan with anything in it, by axis.
    pub fn cells(&self) -> [[usize; 2]; 2] {
        let mut cells = [[usize::MAX, 0]; 2];
        for ([x, y, _], label) in self.house.voxels.iter() {
            if label.is_filled() {
                for (c, v) in cells.iter_mut().zip([x, y]) {
                    *c = [c[0].min(v), c[1].max(v)];
                }
            }
        }
        cells.map(|[a, b]| [a.min(b), b])
    }

    /// Grid lines along a plan axis as the view has it: places to the right (m), named by numbers along x and letters along y.
    pub fn grid(&self, axis: usize, sign: f64) -> Vec<(f64, String)> {
        let [first, last] = self.cells()[axis];
        (first..=last + 1)
            .map(|n| {
                let name = if axis == 0 { (n - first + 1).to_string() } else { super::dims::letter(n - first) };
                (sign * (self.origin[axis] + n as f64 * self.module[axis]), name)
            })
            .collect()
    }

    /// Heights of the roof with what they are: eaves and ridge of coverings that slope, the edges of level roofs.
    pub fn roof(&self) -> Vec<(f64, String)> {
        let mut marks = Vec::new();
        let named = |names: &'static [&'static str]| move |p: &Piece| names.contains(&p.name.as_str());
        if let Some([low, high]) = self.model.bounds(named(&["roof_covering", "pitched_roof"])) {
            if high[2] - low[2] > 0.3 {
                marks.push((low[2], "eaves".to_owned()));
                marks.push((high[2], "ridge".to_owned()));
            } else {
                marks.push((high[2], "roof".to_owned()));
            }
        }
        if let Some([_, high]) = self.model.bounds(named(&["coping", "flat_membrane", "flat_roof"])) {
            marks.push((high[2], "roof edge".to_owned()));
        }
        if marks.is_empty() {
            marks.push((self.bounds[1][2], "top".to_owned()));
        }
        marks
    }

    /// All level marks of elevations and sections: ground, floors, roof.
    pub fn levels(&self) -> Vec<(f64, String)> {
        let mut marks = vec![(self.ground(), "ground".to_owned())];
        for storey in &self.reading.storeys {
            marks.push((self.floor(storey.plate_k), format!("floor {}", storey.index)));
        }
        marks.extend(self.roof());
        marks
    }

    /// Lowest and highest [right, up] of the house in a view, m.
    pub fn extent(&self, view: &View) -> [[f64; 2]; 2] {
        let corners = self.bounds.map(|b| view.see(b));
        [0, 1].map(|end| {
            [0, 1].map(|a| {
                let (p, q) = (corners[0][a], corners[1][a]);
                if end == 0 { p.min(q) } else { p.max(q) }
            })
        })
    }
}

/// The name of a side, for files and titles.
pub fn side_name(side: Direction) -> &'static str {
    match side {
        Direction::North => "north",
        Direction::East => "east",
        Direction::South => "south",
        Direction::West => "west",
    }
}
