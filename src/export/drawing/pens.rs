//! The pens of a drawing: what is cut heaviest, what is seen lighter, what lies beyond thinnest.

/// A pen: its name in the file, mm, colour, dashes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pen {
    /// Class of the group in the SVG.
    pub name: &'static str,
    /// Width, mm.
    pub width: f64,
    /// CSS colour.
    pub ink: &'static str,
    /// Dash pattern in mm; empty for a full line.
    pub dashes: &'static str,
}

const fn pen(name: &'static str, width: f64, ink: &'static str, dashes: &'static str) -> Pen {
    Pen { name, width, ink, dashes }
}

/// What the plane of a plan or section cuts.
pub const CUT: Pen = pen("cut", 0.5, "#16181a", "");
/// Ground line.
pub const GROUND: Pen = pen("ground", 0.7, "#16181a", "");
/// Silhouettes.
pub const OUTLINE: Pen = pen("outline", 0.35, "#16181a", "");
/// Edges seen.
pub const EDGE_PEN: Pen = pen("edge", 0.2, "#2a2d30", "");
/// Small parts, strata.
pub const FINE: Pen = pen("fine", 0.11, "#3c4043", "");
/// What lies below or beyond.
pub const BEYOND: Pen = pen("beyond", 0.11, "#8a9096", "");
/// Above the cut or hidden.
pub const HIDDEN: Pen = pen("hidden", 0.15, "#5a6066", "1.2 0.8");
/// Doors and stairs.
pub const SYMBOL: Pen = pen("symbol", 0.2, "#2a2d30", "");
/// Swing of a leaf.
pub const SWING: Pen = pen("swing", 0.12, "#4a4f54", "");
/// Furniture.
pub const FURNITURE: Pen = pen("furniture", 0.13, "#7d6a52", "");
/// Outline of a test fit.
pub const FIT: Pen = pen("fit", 0.15, "#a5763c", "2 0.7 0.4 0.7");
/// Dimensions.
pub const DIM: Pen = pen("dim", 0.12, "#2a2d30", "");
/// Module grid.
pub const GRID: Pen = pen("grid", 0.09, "#a4abb2", "4 1 0.6 1");
/// Frame of page and title block.
pub const FRAME: Pen = pen("frame", 0.25, "#2a2d30", "");
