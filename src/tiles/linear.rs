//! Linear tiles: the skeleton lines of a configuration, each with its role and the octants it depends on.

use crate::cubes::{Corner, Symmetry};

/// What a line of a linear tile becomes in the frame. Whether it becomes anything is decided by the labels of its octants.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
#[repr(u8)]
pub enum LineRole {
    /// Vertical face-curve segment in a wall plane, at a voxel centre line.
    Stud = 0,
    /// Vertical crease where two wall planes meet, convex or concave.
    Post = 1,
    /// Horizontal face curve on the cube's bottom face: the wall plate or rim at a slab level.
    Rail = 2,
    /// Slab grid line along x on the cube's bottom face, from a corner to the mid of its edge.
    JoistX = 3,
    /// The same along y.
    JoistY = 4,
    /// Line between two filled columns on the cube's bottom face (mid to centre): a trimmer where only one of them has slab.
    Edge = 5,
    /// Sloped face-curve segment of a roof.
    Rafter = 6,
    /// Level face-curve segment of a roof along a contour: purlin or ridge.
    Purlin = 7,
    /// Convex sloped crease of a roof.
    Hip = 8,
    /// Concave sloped crease of a roof.
    Valley = 9,
    /// Level crease of a roof inside the tile: ridge or fold.
    Ridge = 10,
}

impl LineRole {
    /// All roles in the order of their codes.
    pub const ALL: [LineRole; 11] = [
        LineRole::Stud,
        LineRole::Post,
        LineRole::Rail,
        LineRole::JoistX,
        LineRole::JoistY,
        LineRole::Edge,
        LineRole::Rafter,
        LineRole::Purlin,
        LineRole::Hip,
        LineRole::Valley,
        LineRole::Ridge,
    ];

    /// The role of a name in a file; `None` for any other.
    pub fn from_name(name: &str) -> Option<LineRole> {
        Self::ALL.into_iter().find(|r| r.name() == name)
    }

    /// The role after a turn: joists along x and y change places when the axes do.
    pub fn placed(self, symmetry: Symmetry) -> LineRole {
        match self {
            LineRole::JoistX if symmetry.swaps_axes() => LineRole::JoistY,
            LineRole::JoistY if symmetry.swaps_axes() => LineRole::JoistX,
            other => other,
        }
    }

    /// Group name in the tile's OBJ file.
    pub fn name(self) -> &'static str {
        match self {
            LineRole::Stud => "stud",
            LineRole::Post => "post",
            LineRole::Rail => "rail",
            LineRole::JoistX => "joist_x",
            LineRole::JoistY => "joist_y",
            LineRole::Edge => "edge",
            LineRole::Rafter => "rafter",
            LineRole::Purlin => "purlin",
            LineRole::Hip => "hip",
            LineRole::Valley => "valley",
            LineRole::Ridge => "ridge",
        }
    }
}

/// One straight line of a linear tile.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Line {
    /// What it becomes.
    pub role: LineRole,
    /// Start in cube-local integer millimetres.
    pub from: [i32; 3],
    /// End in cube-local integer millimetres.
    pub to: [i32; 3],
    /// The one or two octants (0..8) whose labels decide; equal when there is one.
    pub octants: [u8; 2],
}

impl Line {
    /// A line with its ends and octants in rising order, so that equal lines compare equal.
    pub fn new(role: LineRole, ends: [[i32; 3]; 2], octants: [u8; 2]) -> Line {
        let [from, to] = if ends[0] <= ends[1] { ends } else { [ends[1], ends[0]] };
        let octants = if octants[0] <= octants[1] { octants } else { [octants[1], octants[0]] };
        Line { role, from, to, octants }
    }

    /// The line of the tile placed with `symmetry` in a cube of `size` mm.
    pub fn placed(&self, symmetry: Symmetry, size: [i32; 3]) -> Line {
        let ends = [self.from, self.to].map(|p| symmetry.point(p, size));
        let octants = self.octants.map(|o| Corner::new(o).map_or(o, |c| symmetry.corner(c).number()));
        Line::new(self.role.placed(symmetry), ends, octants)
    }

    /// Length in mm.
    pub fn length_mm(&self) -> f64 {
        (0..3).map(|a| f64::from(self.to[a] - self.from[a]).powi(2)).sum::<f64>().sqrt()
    }
}
