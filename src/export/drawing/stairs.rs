//! Stairs in plan: treads, walking line with its arrow upwards, the cut line, what lies above it dashed.

use super::collinear::Segment;
use super::pens::{FINE, HIDDEN, SYMBOL};
use super::sheet::{Hold, Sheet, TEXT};
use super::subject::{CUT_M, Subject};
use crate::voxels::{STOREY_MODULES, Stair, StairKind, Storey};

/// Steps in a module of run.
const STEPS: usize = 3;

/// A flight as cells in climbing order, in modules from the corner of cell (0, 0).
struct Flight {
    cells: Vec<[isize; 2]>,
    run: [f64; 2],
    /// Risers climbed before it.
    before: usize,
}

impl Flight {
    /// A place `a` modules along the flight from its foot and `l` modules to the left of its middle.
    fn at(&self, subject: &Subject, a: f64, l: f64) -> [f64; 2] {
        let first = self.cells[0].map(|c| c as f64 + 0.5);
        let left = [-self.run[1], self.run[0]];
        subject.place([0, 1].map(|i| first[i] + (a - 0.5) * self.run[i] + l * left[i]))
    }
}

fn flights(stair: &Stair) -> Vec<Flight> {
    let cells = stair.flight_cells();
    let run = stair.run.step().map(|s| s as f64);
    match stair.kind {
        StairKind::Straight => vec![Flight { cells: cells.to_vec(), run, before: 0 }],
        StairKind::UTurn => vec![
            Flight { cells: cells[..3].to_vec(), run, before: 0 },
            Flight { cells: cells[3..].to_vec(), run: run.map(|c| -c), before: 3 * STEPS },
        ],
    }
}

/// The stairs of a storey: those that leave it and those that arrive.
pub fn draw(sheet: &mut Sheet, subject: &Subject, storey: &Storey) {
    let stairs = &subject.house.stairs;
    let arriving: Vec<&Stair> = stairs.iter().filter(|s| s.storey + 1 == storey.index).collect();
    for stair in &arriving {
        arrive(sheet, subject, stair);
    }
    for stair in stairs.iter().filter(|s| s.storey == storey.index) {
        let below: Vec<[isize; 2]> = arriving.iter().flat_map(|s| s.void_cells()).collect();
        leave(sheet, subject, stair, &below);
    }
}

/// The lines of a flight's treads from riser `from` to riser `to`, both counted on the flight, with its strings.
fn treads(subject: &Subject, flight: &Flight, from: f64, to: f64) -> Vec<Segment> {
    let steps = STEPS as f64;
    let mut lines: Vec<Segment> = (0..=flight.cells.len() * STEPS)
        .map(|n| n as f64)
        .filter(|n| (from - 1e-9..=to + 1e-9).contains(n))
        .map(|n| [flight.at(subject, n / steps, -0.5), flight.at(subject, n / steps, 0.5)])
        .collect();
    for side in [-0.5, 0.5] {
        lines.push([flight.at(subject, from / steps, side), flight.at(subject, to / steps, side)]);
    }
    lines
}

/// A stair that climbs from this storey: full below the plane of the plan, dashed above.
fn leave(sheet: &mut Sheet, subject: &Subject, stair: &Stair, below: &[[isize; 2]]) {
    let riser = subject.module[2] / STEPS as f64;
    let cut = (CUT_M / riser).floor();
    sheet.open("stair");
    for flight in flights(stair) {
        let all = (flight.cells.len() * STEPS) as f64;
        let seen = (cut - flight.before as f64).clamp(0.0, all);
        if seen > 0.0 {
            sheet.lines(SYMBOL, &treads(subject, &flight, 0.0, seen));
        }
        if seen < all {
            if seen > 0.0 {
                break_line(sheet, subject, &flight, (seen + 0.5) / STEPS as f64);
            }
            // Over a flight that arrives from below, that one is seen instead.
            if !flight.cells.iter().any(|c| below.contains(c)) {
                sheet.lines(HIDDEN, &treads(subject, &flight, seen + f64::from(u8::from(seen > 0.0)), all));
            }
        }
    }
    let is_over = stair.middle_landing().iter().any(|c| below.contains(c));
    if let Some([low, high]) = landing(subject, stair).filter(|_| !is_over) {
        sheet.shape(HIDDEN, &[low, [high[0], low[1]], high, [low[0], high[1]]], true, "none");
    }
    walking_line(sheet, subject, stair);
    let count = STEPS * STOREY_MODULES;
    let going = 1e3 * subject.module[usize::from(stair.run.step()[0] == 0)] / STEPS as f64;
    let words = format!("up {count} × {:.0}/{going:.0}", riser * 1e3);
    let first = &flights(stair)[0];
    let at = sheet.at(first.at(subject, 0.55, 0.0));
    let size = 2.0;
    // Beside the foot, outside the flight.
    let beside = sheet.at(first.at(subject, -0.28, 0.0));
    let upright = stair.run.step()[0] == 0;
    let at = if upright { [at[0], beside[1]] } else { [beside[0], at[1]] };
    let turn = format!(" transform=\"rotate(-90 {:.2} {:.2})\"", at[0], at[1]);
    sheet.write(
        &words,
        [at[0] + if upright { 0.0 } else { 0.7 }, at[1] + if upright { 0.7 } else { 0.0 }],
        size,
        Hold::Middle,
        TEXT,
        if upright { "" } else { &turn },
    );
    sheet.close();
}

/// A stair that arrives on this storey, as far as the opening in the floor shows it.
fn arrive(sheet: &mut Sheet, subject: &Subject, stair: &Stair) {
    let void = stair.void_cells();
    sheet.open("stair");
    for flight in flights(stair) {
        let open: Vec<usize> = (0..flight.cells.len()).filter(|&n| void.contains(&flight.cells[n])).collect();
        if let (Some(first), Some(last)) = (open.first(), open.last()) {
            sheet.lines(SYMBOL, &treads(subject, &flight, (first * STEPS) as f64, ((last + 1) * STEPS) as f64));
        }
    }
    if let Some([low, high]) = landing(subject, stair) {
        sheet.shape(SYMBOL, &[low, [high[0], low[1]], high, [low[0], high[1]]], true, "none");
    }
    walking_line(sheet, subject, stair);
    sheet.close();
}

/// The middle landing, m.
fn landing(subject: &Subject, stair: &Stair) -> Option<[[f64; 2]; 2]> {
    let cells = stair.middle_landing();
    let first = *cells.first()?;
    let (low, high) = cells.iter().fold((first, first), |(l, h), c| {
        ([0, 1].map(|a: usize| l[a].min(c[a])), [0, 1].map(|a: usize| h[a].max(c[a])))
    });
    Some([subject.place(low.map(|c| c as f64)), subject.place(high.map(|c| c as f64 + 1.0))])
}

/// From the first step to the last, an arrow upwards and a dot where it starts.
fn walking_line(sheet: &mut Sheet, subject: &Subject, stair: &Stair) {
    let flights = flights(stair);
    let mut points = Vec::new();
    for flight in &flights {
        points.push(flight.at(subject, 0.0, 0.0));
        points.push(flight.at(subject, flight.cells.len() as f64, 0.0));
    }
    if flights.len() == 2 {
        // Round the landing in its middle.
        let (a, b) = (&flights[0], &flights[1]);
        points[1] = a.at(subject, 3.5, 0.0);
        points[2] = b.at(subject, -0.5, 0.0);
    }
    points[0] = flights[0].at(subject, 1.0 / 6.0, 0.0);
    let last = &flights[flights.len() - 1];
    let end = last.cells.len() as f64 - 1.0 / 6.0;
    let n = points.len();
    points[n - 1] = last.at(subject, end, 0.0);
    sheet.shape(FINE, &points, false, "none");
    sheet.circle(FINE, sheet.at(points[0]), 0.55, "#fff");
    let head = [[end, 0.0], [end - 0.22, 0.09], [end - 0.22, -0.09]].map(|[a, l]| last.at(subject, a, l));
    sheet.shape(FINE, &head, true, "#2a2d30");
}

/// The zigzag across a flight where the plane cuts it.
fn break_line(sheet: &mut Sheet, subject: &Subject, flight: &Flight, a: f64) {
    for shift in [0.0, 0.09] {
        let points = [[-0.14, -0.56], [-0.02, -0.1], [0.07, -0.06], [-0.07, 0.06], [0.02, 0.1], [0.14, 0.56]];
        let points: Vec<[f64; 2]> = points.iter().map(|[x, l]| flight.at(subject, a + x + shift, *l)).collect();
        sheet.shape(SYMBOL, &points, false, "none");
    }
}
