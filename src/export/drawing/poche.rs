//! Cut areas on a sheet: each material's fill, strong lines around what bears and encloses, fine ones around windows and rails.

use super::collinear::{Segment, cancel};
use super::cut::{Cut, Loop};
use super::hatch;
use super::model::Kind;
use super::pens::{CUT, EDGE_PEN, FINE, Pen};
use super::sheet::Sheet;
use super::skin_plan;
use super::subject::Subject;

/// Whether a cut piece is drawn with fine lines.
fn is_small(kind: Kind) -> bool {
    matches!(kind, Kind::Detail | Kind::Glass | Kind::Leaf | Kind::Rail | Kind::RailGlass | Kind::Stair)
}

/// Draws what a plane cuts; the skin of a set of surfaces as thick as the convention says.
pub fn draw(sheet: &mut Sheet, subject: &Subject, cut: &Cut) {
    let mut edges: [Vec<Segment>; 2] = [Vec::new(), Vec::new()];
    for (n, loops) in &cut.areas {
        let piece = &subject.model.pieces[*n];
        match piece.kind {
            Kind::Skin => skin_plan::section(sheet, subject, loops),
            kind => sheet.fill(&piece.name, loops, hatch::poche(kind)),
        }
        let sides = |l: &Loop| (0..l.len()).map(|i| [l[i], l[(i + 1) % l.len()]]).collect::<Vec<_>>();
        edges[usize::from(is_small(piece.kind))].extend(loops.iter().flat_map(sides));
    }
    let [large, small] = edges.map(|lines| cancel(&lines));
    // At 1:100 and less the lines of a wall must leave room for its strata.
    let strong = if sheet.format.scale > 75.0 { Pen { width: 0.32, ..CUT } } else { CUT };
    sheet.lines(FINE, &large[1]);
    sheet.lines(FINE, &small[1]);
    sheet.lines(EDGE_PEN, &small[0]);
    sheet.lines(strong, &large[0]);
}
