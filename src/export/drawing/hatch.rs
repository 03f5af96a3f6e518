//! Fills of cut materials and patterns of surfaces.

use super::model::{Kind, Piece};
use crate::export::Grain;

/// Patterns in mm on paper.
pub const PATTERNS: &str = "<defs>\n\
<pattern id=\"insulation\" width=\"1.1\" height=\"1.1\" patternUnits=\"userSpaceOnUse\"><rect width=\"1.1\" height=\"1.1\" fill=\"#eceae4\"/>\
<path d=\"M0 1.1L1.1 0M0 0L1.1 1.1\" stroke=\"#9a958a\" stroke-width=\"0.07\"/></pattern>\n\
<pattern id=\"concrete\" width=\"2.4\" height=\"2.4\" patternUnits=\"userSpaceOnUse\"><rect width=\"2.4\" height=\"2.4\" fill=\"#9a9da0\"/>\
<path d=\"M0 2.4L2.4 0M-0.4 0.4L0.4 -0.4M2 2.8L2.8 2\" stroke=\"#5f6468\" stroke-width=\"0.12\"/></pattern>\n\
<pattern id=\"joists\" width=\"1.6\" height=\"1.6\" patternUnits=\"userSpaceOnUse\"><rect width=\"1.6\" height=\"1.6\" fill=\"#d9cdb6\"/>\
<path d=\"M0 1.6L1.6 0\" stroke=\"#8b7a5a\" stroke-width=\"0.08\"/></pattern>\n\
<pattern id=\"earth\" width=\"2\" height=\"2\" patternUnits=\"userSpaceOnUse\"><path d=\"M0 2L2 0M-0.3 0.3L0.3 -0.3M1.7 2.3L2.3 1.7\" stroke=\"#8a8f93\" stroke-width=\"0.12\"/></pattern>\n\
</defs>\n";

/// How a cut material is filled.
pub fn poche(kind: Kind) -> &'static str {
    match kind {
        Kind::Shell => "#5d6368",
        Kind::Insulation => "url(#insulation)",
        Kind::Lining => "#a7a095",
        Kind::Joists => "url(#joists)",
        Kind::Concrete => "url(#concrete)",
        Kind::Detail | Kind::Rail | Kind::Leaf | Kind::Skin => "#43484d",
        Kind::Glass | Kind::RailGlass => "#cfe0e6",
        Kind::Stair => "#8d7f6a",
    }
}

/// The tone of a piece's surface on paper, `shade` in shadow: its colour, much lighter, so that lines stay legible on it.
pub fn tone(piece: &Piece, shade: bool) -> [u8; 3] {
    // Panes are as dark as windows look from outside; everything else keeps its hue only.
    let white = match piece.kind {
        Kind::Glass => 0.42,
        Kind::Detail | Kind::Rail => 0.55,
        _ => 0.62,
    };
    let dark = if shade { 0.80 } else { 1.0 };
    piece.rgb.map(|c| {
        let srgb = if c <= 0.003_130_8 { 12.92 * c } else { 1.055 * c.max(0.0).powf(1.0 / 2.4) - 0.055 };
        ((srgb.clamp(0.0, 1.0) * (1.0 - white) + white) * dark * 255.0).round() as u8
    })
}

/// Distance of the lines of a grain on the house, m, and whether they stand upright.
pub fn grain(grain: Grain) -> Option<(f64, bool)> {
    match grain {
        Grain::Courses => Some((0.16, false)),
        Grain::Cladding => Some((0.15, true)),
        Grain::Plain | Grain::Boards | Grain::Glass => None,
    }
}
