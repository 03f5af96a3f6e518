//! Doors with leaf and swing, and openings that a plan's plane misses.

use super::collinear::Segment;
use super::pens::{FINE, HIDDEN, SWING, SYMBOL};
use super::sheet::Sheet;
use super::subject::Subject;
use crate::voxels::{Direction, FRAME_M, FacadeOpening, Label, Storey};

/// Distance of a leaf's inner face behind the facade, m.
const LEAF_M: f64 = 0.165;
/// Thickness of a leaf, m.
const THICK_M: f64 = 0.05;
/// Wider clear openings have two leaves, m.
const WIDEST_LEAF_M: f64 = 1.3;
/// Inside of the facade line that is kept free for entering, m.
const LANDING_M: f64 = 1.2;

/// Coordinates of an opening: along the facade with the outside on the right, and inwards.
#[derive(Clone, Copy, Debug)]
pub struct Place {
    from: [f64; 2],
    along: [f64; 2],
    /// Between the module lines, m.
    pub width: f64,
}

impl Place {
    /// Of an opening.
    pub fn new(subject: &Subject, o: &FacadeOpening) -> Place {
        let [x, y] = o.cell.map(|c| c as f64);
        let w = o.width as f64;
        let (from, along) = match o.facing {
            Direction::South => ([x, y], [1.0, 0.0]),
            Direction::East => ([x + 1.0, y], [0.0, 1.0]),
            Direction::North => ([x + w, y + 1.0], [-1.0, 0.0]),
            Direction::West => ([x, y + w], [0.0, -1.0]),
        };
        Place { from: subject.place(from), along, width: w * subject.module[o.along()] }
    }

    /// A place `a` m along the facade and `i` m inwards of it.
    pub fn at(&self, a: f64, i: f64) -> [f64; 2] {
        let [x, y] = self.along;
        [self.from[0] + x * a - y * i, self.from[1] + y * a + x * i]
    }

    /// Lowest and highest corner of what a door needs free inside, from the facade on, m.
    pub fn landing(&self) -> [[f64; 2]; 2] {
        let (p, q) = (self.at(0.0, 0.0), self.at(self.width, LANDING_M.max(LEAF_M + self.leaf())));
        [[p[0].min(q[0]), p[1].min(q[1])], [p[0].max(q[0]), p[1].max(q[1])]]
    }

    fn clear(&self) -> f64 {
        self.width - 2.0 * FRAME_M
    }

    /// Width of a leaf, m.
    fn leaf(&self) -> f64 {
        if self.clear() > WIDEST_LEAF_M { 0.5 * self.clear() } else { self.clear() }
    }
}

/// Leaves and swings of the doors of a storey, and dashed outlines of windows above or below the plane at `height` m.
pub fn draw(sheet: &mut Sheet, subject: &Subject, storey: &Storey, height: f64) {
    for o in subject.reading.openings.iter().filter(|o| o.storey == storey.index) {
        let place = Place::new(subject, o);
        let [sill, head] = super::elevation::heights(subject, o);
        if o.label == Label::Opening {
            door(sheet, &place, hinge_at_start(storey, o));
        } else if !(sill..head).contains(&height) {
            let depths = [0.0, 0.3].map(|i| [place.at(0.0, i), place.at(place.width, i)]);
            let ends = [0.0, place.width].map(|a| [place.at(a, 0.0), place.at(a, 0.3)]);
            let lines: Vec<Segment> = depths.into_iter().chain(ends).collect();
            sheet.open("window");
            sheet.lines(HIDDEN, &lines);
            sheet.close();
        } else {
            // Cut by the plane: its panes are in the poche; a hair line on the inside closes the niche.
            sheet.open("window");
            sheet.lines(FINE, &[[place.at(0.0, 0.3), place.at(place.width, 0.3)]]);
            sheet.close();
        }
    }
}

/// Whether the hinges are at the start of the facade's run: at the side where a wall returns nearer, so that the leaf opens against it.
fn hinge_at_start(storey: &Storey, o: &FacadeOpening) -> bool {
    let reach = |n: isize, step: isize| (1..40).find(|k| !storey.plan.has(o.column(n + step * k, -1))).unwrap_or(40);
    let [low, high] = [reach(0, -1), reach(o.width as isize - 1, 1)];
    // `Place` runs against the grid on north and west sides.
    match o.facing {
        Direction::South | Direction::East => low <= high,
        Direction::North | Direction::West => high <= low,
    }
}

fn door(sheet: &mut Sheet, place: &Place, at_start: bool) {
    let leaf = place.leaf();
    let (start, end) = (FRAME_M, place.width - FRAME_M);
    sheet.open("door");
    if place.clear() > WIDEST_LEAF_M {
        wing(sheet, place, start, 1.0, leaf);
        wing(sheet, place, end, -1.0, leaf);
    } else if at_start {
        wing(sheet, place, start, 1.0, leaf);
    } else {
        wing(sheet, place, end, -1.0, leaf);
    }
    sheet.close();
}

/// A leaf that stands open, hinged at `a`, and its way there; it shuts towards `sign`.
fn wing(sheet: &mut Sheet, place: &Place, a: f64, sign: f64, leaf: f64) {
    let corners =
        [[0.0, 0.0], [THICK_M, 0.0], [THICK_M, leaf], [0.0, leaf]].map(|[x, i]| place.at(a + sign * x, LEAF_M + i));
    sheet.shape(SYMBOL, &corners, true, "#fff");
    let (open, shut) = (place.at(a, LEAF_M + leaf), place.at(a + sign * leaf, LEAF_M));
    sheet.arc(SWING, open, shut, leaf, sign < 0.0);
}
