//! Members of the frame cut from stock lengths.

use crate::frame::{HouseFrame, Role};
use crate::voxels::Choice;

pub use crate::frame::STOCK_LENGTH_M;

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

/// Takes the members of a frame, which run over modules and end at supports and splices, and lays them into bars, longest first into the
/// first bar that has room. A member longer than `stock_m` is cut into the fewest equal pieces; frames built for that stock have none.
pub fn stock(frame: &HouseFrame, stock_m: f64) -> Stock {
    let mut out = Stock::default();
    let mut pieces: Vec<(Role, Choice, u32)> = Vec::with_capacity(frame.members.len());
    for m in &frame.members {
        out.length_m += m.length_m * f64::from(m.plies);
        let parts = (m.length_m / stock_m - 1e-9).ceil().max(1.0);
        for _ in 0..parts as u32 * u32::from(m.plies) {
            pieces.push((m.role, m.group, (1000.0 * m.length_m / parts).round() as u32));
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
