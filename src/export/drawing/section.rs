//! The section: a plane through stair and roof, the solids it cuts in poche, and what is seen beyond.

use super::cut::cut;
use super::dims::{self, Side};
use super::elevation::{draw_lines, ground_line, opaque};
use super::lines::visible;
use super::pens::{EDGE_PEN, FINE};
use super::raster::{Raster, Window};
use super::sheet::{Hold, QUIET, Sheet, TEXT};
use super::skin_plan;
use super::subject::{Subject, side_name};
use super::title::{self, Title};
use super::view::View;
use crate::voxels::{Direction, StairKind};

/// Beside the middle of its modules, so that it meets no joint between tiles, m.
const ASIDE_M: f64 = 0.11;

/// Farther beyond the plane, edges are drawn thinnest, m.
const BEYOND_M: f64 = 4.0;

/// Where the house is cut upright.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Section {
    /// The side from which it is looked at; the plane is parallel to that side.
    pub from: Direction,
    /// Place of the plane along the axis across it, m.
    pub at_m: f64,
}

impl Section {
    /// The plane that tells most: along a flight of a stair, across the slopes of the roof, through openings, where the house is large.
    pub fn choose(subject: &Subject) -> Section {
        let cells = subject.cells();
        let mut best = (i64::MIN, Section { from: Direction::South, at_m: subject.origin[1] });
        for (axis, from) in [(1, Direction::South), (0, Direction::East)] {
            let [first, last] = cells[axis];
            let inner = if last >= first + 2 { first + 1..last } else { first..last + 1 };
            for n in inner {
                let score = worth(subject, axis, n);
                if score > best.0 {
                    let at_m = subject.origin[axis] + (n as f64 + 0.5) * subject.module[axis] + ASIDE_M;
                    best = (score, Section { from, at_m });
                }
            }
        }
        best.1
    }

    /// The axis across the plane: 0 = x, 1 = y.
    pub fn across(&self) -> usize {
        View::facing(self.from).axes[2].of
    }

    /// Draws it.
    pub fn draw(&self, subject: &Subject) -> String {
        let view = View::facing(self.from);
        let near = view.axes[2].sign * self.at_m;
        let [mut low, high] = subject.extent(&view);
        low[1] = low[1].min(subject.ground());
        let mut sheet = Sheet::new(subject.format, low, high, &format!("{}, section A-A", subject.name));
        ground_line(&mut sheet, subject, [low[0], high[0]]);
        let window = Window { low: [low[0] - 0.05, subject.ground()], high: [high[0] + 0.05, high[1] + 0.05], near };
        let raster = Raster::new(&subject.model, &view, &window, opaque);
        let lines = visible(&subject.model, &view, &window, &raster, near - BEYOND_M, |_| true);
        draw_lines(&mut sheet, &lines, [EDGE_PEN, FINE, FINE]);
        let cut = cut(&subject.model, &view, near, |_| true);
        sheet.open("poche");
        super::poche::draw(&mut sheet, subject, &cut);
        sheet.close();
        self.rooms(&mut sheet, subject, &view);
        let ends = super::elevation::walls(subject, &view);
        dims::chain(&mut sheet, Side::Below, low[1], 6.0, &ends);
        let mut heights = vec![subject.ground()];
        heights.extend(subject.reading.storeys.iter().map(|s| subject.floor(s.plate_k)));
        heights.extend(subject.roof().iter().map(|r| r.0));
        dims::chain(&mut sheet, Side::Left, low[0], 7.0, &heights);
        let top = heights.iter().copied().fold(f64::MIN, f64::max);
        dims::chain(&mut sheet, Side::Left, low[0], 14.0, &[subject.ground(), top]);
        let axis = view.axes[0];
        dims::grid(&mut sheet, Side::Below, &subject.grid(axis.of, axis.sign), [low[1], low[1]], 9.5);
        dims::levels(&mut sheet, high[0], 8.5, &subject.levels());
        let looking = side_name(self.from.back());
        let mut notes = vec![format!("Seen towards the {looking}; where it cuts is marked A on the plans.")];
        if subject.is_skin() {
            notes.push(skin_plan::NOTE.to_owned());
        }
        let words = Title {
            house: subject.name.to_owned(),
            drawing: "Section A–A".into(),
            level: format!("looking {looking}"),
            notes,
            north: false,
        };
        title::draw(&mut sheet, &words);
        sheet.finish()
    }

    /// The clear height of each storey, written where the plane passes through its rooms.
    fn rooms(&self, sheet: &mut Sheet, subject: &Subject, view: &View) {
        let across = self.across();
        let n = ((self.at_m - subject.origin[across]) / subject.module[across]).floor() as isize;
        for storey in &subject.reading.storeys {
            let along = 1 - across;
            let inside: Vec<usize> = storey.plan.iter().filter(|c| c[across] as isize == n).map(|c| c[along]).collect();
            let (Some(first), Some(last)) = (inside.iter().min(), inside.iter().max()) else { continue };
            let middle = subject.origin[along] + 0.5 * ((first + last + 1) as f64) * subject.module[along];
            let mut p = [0.0; 3];
            p[along] = middle;
            p[2] = subject.floor(storey.plate_k) + 0.5 * storey.clear_height_m;
            let [u, v, _] = view.see(p);
            let at = sheet.at([u, v]);
            sheet.label(&super::plan::storey_name(storey.index), at, 2.8, Hold::Middle, TEXT);
            let words = format!("clear height {}", dims::millimetres(storey.clear_height_m));
            sheet.label(&words, [at[0], at[1] + 3.8], 2.2, Hold::Middle, QUIET);
        }
    }
}

/// How much a plane through the n-th modules across an axis shows.
fn worth(subject: &Subject, axis: usize, n: usize) -> i64 {
    let voxels = &subject.house.voxels;
    let shape = voxels.shape();
    let along = 1 - axis;
    let mut score = 0;
    let mut tops = Vec::new();
    for m in 0..shape[along] {
        let cell = |k: usize| if axis == 0 { [n, m, k] } else { [m, n, k] };
        let filled = (0..shape[2]).filter(|&k| voxels.get(cell(k)).is_filled());
        score += filled.clone().count() as i64;
        tops.push(filled.max().unwrap_or(0));
    }
    score += 14 * tops.windows(2).filter(|w| w[0].abs_diff(w[1]) == 1).count() as i64;
    for stair in &subject.house.stairs {
        let lengthwise = (stair.run.step()[0] != 0) == (axis == 1);
        let cells = stair.flight_cells();
        let lane = if stair.kind == StairKind::UTurn { &cells[3..] } else { &cells[..] };
        let hits = lane.iter().filter(|c| c[axis] == n as isize).count() as i64;
        score += if lengthwise { 8 * hits } else { 2 * hits };
    }
    for o in &subject.reading.openings {
        let crossed = o.along() == axis && (o.cell[axis]..o.cell[axis] + o.width).contains(&n);
        score += 5 * i64::from(crossed);
    }
    // Of equal planes the one nearer to the middle.
    let [first, last] = subject.cells()[axis];
    100 * score - (2 * n).abs_diff(first + last) as i64
}
