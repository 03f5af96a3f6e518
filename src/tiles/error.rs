//! What can be wrong with a tileset on disk.

use std::path::PathBuf;

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
    #[error("{}: tiles {first} and {second} both cover configuration {mask}; remove one or restrict its symmetry", path.display())]
    Duplicate {
        /// The manifest.
        path: PathBuf,
        /// The configuration.
        mask: u8,
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
}
