//! What can be wrong with a tileset on disk.

use std::path::{Path, PathBuf};

/// A tileset that cannot be used: where, what was found, what was expected, what to do.
#[derive(Debug, thiserror::Error)]
pub enum TilesetError {
    /// A file of the tileset cannot be read.
    #[error("{}: cannot be read ({source}); a tileset is a folder with tileset.json and the OBJ files it names", path.display())]
    Read {
        /// The file.
        path: PathBuf,
        /// What the system said.
        source: std::io::Error,
    },
    /// The manifest is not JSON, or has a missing or unknown key.
    #[error("{}: {source}; see an existing tileset.json for the keys", path.display())]
    Manifest {
        /// The manifest.
        path: PathBuf,
        /// Parser's message with line and column.
        source: serde_json::Error,
    },
    /// A value of the manifest is not one we can use.
    #[error("{}: {key} is {found}, expected {expected}", path.display())]
    Value {
        /// The manifest.
        path: PathBuf,
        /// Key, with the tile's name where it belongs to one.
        key: String,
        /// The value.
        found: String,
        /// What it may be and what to do.
        expected: String,
    },
    /// No tile covers an admissible configuration.
    #[error(
        "{}: no tile for configuration {mask} (corners {pattern}, first corner first); add a tile with this pattern, or allow \
         mirror and quarter turns on one that is carried to it",
        path.display()
    )]
    MissingTile {
        /// The manifest.
        path: PathBuf,
        /// The configuration.
        mask: u8,
        /// Its corners as digits.
        pattern: String,
    },
    /// Two tiles cover the same configuration.
    #[error(
        "{}: tiles {first} and {second} both cover configuration {configuration}; remove one, restrict its symmetry, or give one a \
         higher priority",
        path.display()
    )]
    Duplicate {
        /// The manifest.
        path: PathBuf,
        /// The configuration.
        configuration: String,
        /// The tile named earlier.
        first: String,
        /// The tile named later.
        second: String,
    },
    /// A line of an OBJ file cannot be understood.
    #[error("{}:{line}: found {found}, expected {expected}", path.display())]
    Obj {
        /// The OBJ file.
        path: PathBuf,
        /// Line, from 1.
        line: usize,
        /// What stands there.
        found: String,
        /// What should.
        expected: String,
    },
    /// A polygon is not planar, crosses itself or has no area.
    #[error("{}:{line}: this polygon {what}; cut it into planar polygons without crossing edges", path.display())]
    Polygon {
        /// The OBJ file.
        path: PathBuf,
        /// Line, from 1.
        line: usize,
        /// What is wrong with it.
        what: String,
    },
    /// The surface has an edge inside the cube where it simply stops.
    #[error(
        "{}:{line}: the surface ends inside the cube at the edge {from:?} - {to:?} mm; every free edge must lie on a face of the \
         cube (weld the neighbouring polygons, also at points inside an edge)",
        path.display()
    )]
    EndsInside {
        /// The OBJ file.
        path: PathBuf,
        /// Line of the polygon with that edge, from 1.
        line: usize,
        /// Start of the edge.
        from: [i32; 3],
        /// End of the edge.
        to: [i32; 3],
    },
    /// Two polygons run along an edge in the same direction.
    #[error(
        "{}:{line}: the edge {from:?} - {to:?} mm is used twice in the same direction; turn one polygon over (outside is where it \
         runs counter-clockwise) or remove the double",
        path.display()
    )]
    EdgeTwice {
        /// The OBJ file.
        path: PathBuf,
        /// Line of the second polygon, from 1.
        line: usize,
        /// Start of the edge.
        from: [i32; 3],
        /// End of the edge.
        to: [i32; 3],
    },
    /// A solid of a solid layer is not closed.
    #[error("{}:{line}: the solid {group} is open at the edge {from:?} - {to:?} mm; close it", path.display())]
    OpenSolid {
        /// The OBJ file.
        path: PathBuf,
        /// Line of the polygon with that edge, from 1.
        line: usize,
        /// OBJ group of the solid.
        group: String,
        /// Start of the edge.
        from: [i32; 3],
        /// End of the edge.
        to: [i32; 3],
    },
    /// A vertex lies further outside the cube than its layer declares.
    #[error(
        "{}:{line}: the vertex {vertex:?} mm lies {beyond} mm outside the cube, but layer {layer} declares an overhang of \
         {overhang} mm; move it or declare a larger overhang in tileset.json",
        path.display()
    )]
    LeavesCube {
        /// The OBJ file.
        path: PathBuf,
        /// Line of the vertex, from 1.
        line: usize,
        /// Position in mm.
        vertex: [i32; 3],
        /// Distance outside, mm.
        beyond: i32,
        /// The layer.
        layer: String,
        /// What it declares, mm.
        overhang: i32,
    },
    /// A solid encloses no volume or a negative one: its faces look inwards.
    #[error(
        "{}:{line}: the solid {group} is inside out (its volume is {volume_m3:.6} m3); turn its faces over: outside is where they run \
         counter-clockwise",
        path.display()
    )]
    InsideOut {
        /// The OBJ file.
        path: PathBuf,
        /// Line of its first polygon, from 1.
        line: usize,
        /// OBJ group of the solid.
        group: String,
        /// Signed volume, m3.
        volume_m3: f64,
    },
    /// An edge of a solid runs through a face of it or of another solid.
    #[error(
        "{}:{line}: an edge of this polygon ({group}) runs through the polygon in line {other_line} ({other_group}); solids may touch \
         but not cut each other",
        path.display()
    )]
    Crossing {
        /// The OBJ file.
        path: PathBuf,
        /// Line of the polygon with the edge, from 1.
        line: usize,
        /// Its group.
        group: String,
        /// Line of the polygon it runs through, from 1.
        other_line: usize,
        /// Its group.
        other_group: String,
    },
    /// A manifest of another program's schema lacks something or says something we cannot use.
    #[error("{}: {key}: {problem}", path.display())]
    Foreign {
        /// The manifest.
        path: PathBuf,
        /// Key, with the tile's name where it belongs to one.
        key: String,
        /// What is wrong, and what is done about it.
        problem: String,
    },
}

impl TilesetError {
    /// The file.
    pub fn path(&self) -> &Path {
        match self {
            TilesetError::Read { path, .. }
            | TilesetError::Manifest { path, .. }
            | TilesetError::Value { path, .. }
            | TilesetError::MissingTile { path, .. }
            | TilesetError::Duplicate { path, .. }
            | TilesetError::Obj { path, .. }
            | TilesetError::Polygon { path, .. }
            | TilesetError::EndsInside { path, .. }
            | TilesetError::EdgeTwice { path, .. }
            | TilesetError::OpenSolid { path, .. }
            | TilesetError::LeavesCube { path, .. }
            | TilesetError::InsideOut { path, .. }
            | TilesetError::Crossing { path, .. }
            | TilesetError::Foreign { path, .. } => path,
        }
    }

    /// The line in it, from 1, where one is known.
    pub fn line(&self) -> Option<usize> {
        match self {
            TilesetError::Manifest { source, .. } => Some(source.line()).filter(|l| *l > 0),
            TilesetError::Obj { line, .. }
            | TilesetError::Polygon { line, .. }
            | TilesetError::EndsInside { line, .. }
            | TilesetError::EdgeTwice { line, .. }
            | TilesetError::OpenSolid { line, .. }
            | TilesetError::LeavesCube { line, .. }
            | TilesetError::InsideOut { line, .. }
            | TilesetError::Crossing { line, .. } => Some(*line),
            TilesetError::Read { .. }
            | TilesetError::Value { .. }
            | TilesetError::MissingTile { .. }
            | TilesetError::Duplicate { .. }
            | TilesetError::Foreign { .. } => None,
        }
    }
}
