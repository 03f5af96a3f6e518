//! Members of the frame cut from stock lengths.

use crate::frame::{HouseFrame, Role};
use crate::voxels::Choice;

/// Longest stock, m: solid construction timber and glulam are finger-jointed and sold up to 13 m, glulam to 18 m; a trailer's bed is
/// 13.6 m long. Assumption: 13.5 m.
pub const STOCK_LENGTH_M: f64 = 13.5;

/// A kind of piece cut from stock.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StockPiece {
    /// What it is in the frame.
    pub role: Role,
    /// Which choice sets its section.
    pub group: Choice,
    /// Length, mm.
    pub length_mm: u32,
    /// Pieces, every ply counted.
    pub count: u32,
}

/// What is sawn for a frame.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Stock {
    /// Kinds of pieces by role, group and length.
    pub pieces: Vec<StockPiece>,
    /// Stock bars opened by [`Choice`] (wall, floor, beam, roof), each of the longest length.
    pub bars: [u32; 4],
    /// Saw cuts, one a piece that leaves part of its bar over.
    pub cuts: u32,
    /// Metres of all pieces, equal to the frame's.
    pub length_m: f64,
}

/// One straight line of a frame's sticks, to be joined.
struct Line {
    role: Role,
    group: Choice,
    plies: u8,
    ends: [[f64; 3]; 2],
}

/// Joins sticks that lie on one line, touch end to end and agree in role, group and plies, cuts what is longer than `stock_m` into the fewest
/// equal pieces, and lays the pieces into bars, longest first into the first bar that has room.
pub fn stock(frame: &HouseFrame, stock_m: f64) -> Stock {
    let mut lines: Vec<Line> = Vec::new();
    for m in &frame.members {
        let mut own = Line { role: m.role, group: m.group, plies: m.plies, ends: m.ends };
        // A stick may close the gap between two lines.
        while let Some(n) = lines.iter().position(|l| continues(l, &own)) {
            join(&mut own, &lines.swap_remove(n));
        }
        lines.push(own);
    }
    let mut out = Stock::default();
    let mut pieces: Vec<(Role, Choice, u32)> = Vec::new();
    for line in &lines {
        let length = distance(line.ends);
        out.length_m += length * f64::from(line.plies);
        let parts = (length / stock_m - 1e-9).ceil().max(1.0);
        for _ in 0..parts as u32 * u32::from(line.plies) {
            pieces.push((line.role, line.group, (1000.0 * length / parts).round() as u32));
        }
    }
    pieces.sort_by_key(|&(role, group, length)| (group as usize, std::cmp::Reverse(length), role));
    let stock_mm = (stock_m * 1000.0).round() as u32;
    let mut bars: [Vec<u32>; 4] = Default::default();
    for &(_, group, length) in &pieces {
        let open = &mut bars[group as usize & 3];
        let bar = open.iter().position(|left| *left >= length).unwrap_or_else(|| {
            open.push(stock_mm.max(length));
            open.len() - 1
        });
        open[bar] -= length;
        out.cuts += u32::from(open[bar] > 0);
    }
    out.bars = bars.map(|b| b.len() as u32);
    pieces.sort_by_key(|&(role, group, length)| (role, group as usize, length));
    for (role, group, length_mm) in pieces {
        match out.pieces.last_mut() {
            Some(p) if (p.role, p.group, p.length_mm) == (role, group, length_mm) => p.count += 1,
            _ => out.pieces.push(StockPiece { role, group, length_mm, count: 1 }),
        }
    }
    out
}

fn distance([a, b]: [[f64; 3]; 2]) -> f64 {
    (0..3).map(|i| (b[i] - a[i]).powi(2)).sum::<f64>().sqrt()
}

fn near(a: [f64; 3], b: [f64; 3]) -> bool {
    (0..3).all(|i| (a[i] - b[i]).abs() < 1e-6)
}

/// Whether two lines touch end to end and run the same way.
fn continues(a: &Line, b: &Line) -> bool {
    if (a.role, a.group, a.plies) != (b.role, b.group, b.plies) {
        return false;
    }
    let direction = |l: &Line| {
        let length = distance(l.ends);
        [0, 1, 2].map(|i| (l.ends[1][i] - l.ends[0][i]) / length)
    };
    let (u, v) = (direction(a), direction(b));
    let parallel = (0..3).map(|i| u[i] * v[i]).sum::<f64>().abs() > 1.0 - 1e-9;
    let touch = a.ends.iter().any(|p| b.ends.iter().any(|q| near(*p, *q)));
    parallel && touch
}

fn join(line: &mut Line, other: &Line) {
    let points = [line.ends[0], line.ends[1], other.ends[0], other.ends[1]];
    let pairs = (0..4).flat_map(|i| (i + 1..4).map(move |j| [points[i], points[j]]));
    let longest = pairs.max_by(|a, b| distance(*a).total_cmp(&distance(*b)));
    line.ends = longest.unwrap_or(line.ends);
}
