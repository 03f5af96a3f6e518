//! Drawings of a house to scale: storey plans, four elevations and a section, cut from the solids that `house.glb` shows.
//!
//! A plane cuts the solids exactly ([`cut()`]): its areas are the poche. What lies beyond is found with a z-buffer of face numbers; edges
//! of faces are drawn exactly where one of their faces is seen beside them, so seams between tiles, which lie inside a face, are no
//! lines. Everything is one page in millimetres ([`Format`]), without a date, so that equal houses give equal bytes.

mod collinear;
mod cut;
mod dims;
mod doors;
mod elevation;
mod fit;
mod free;
mod furniture;
mod hatch;
mod lines;
mod model;
mod pens;
mod plan;
mod poche;
mod raster;
mod regions;
mod section;
mod shadow;
mod sheet;
mod skin_plan;
mod stairs;
mod subject;
mod title;
mod view;

pub use collinear::Segment;
pub use cut::{Cut, Loop, area, cut};
pub use dims::{level, millimetres};
pub use elevation::seen_edges;
pub use fit::{Fit, Room, fit};
pub use free::Free;
pub use lines::Weight;
pub use model::{Kind, Model, Piece};
pub use section::Section;
pub use sheet::{A3, A4, Format, Paper};
pub use subject::{CUT_M, GROUND_M, Subject};
pub use view::{Axis, View};

use crate::export::Scene;
use crate::voxels::{Direction, House, Reading};

/// All drawings of a house by file name: `plan-N.svg` for each storey, lowest first, `elevation-{north,east,south,west}.svg`,
/// `section-a.svg`. `scene` is that of `house.glb`. None for a scene without geometry.
pub fn house_drawings(name: &str, house: &House, reading: &Reading, scene: &Scene) -> Vec<(String, String)> {
    let Some(subject) = Subject::new(name, house, reading, scene) else { return Vec::new() };
    let section = Section::choose(&subject);
    let mut files = Vec::new();
    for storey in &reading.storeys {
        files.push((format!("plan-{}.svg", storey.index), plan::plan(&subject, storey, &section)));
    }
    for side in [Direction::North, Direction::East, Direction::South, Direction::West] {
        files.push((format!("elevation-{}.svg", subject::side_name(side)), elevation::elevation(&subject, side)));
    }
    files.push(("section-a.svg".to_owned(), section.draw(&subject)));
    files
}
