//! Furniture of the test fits.

use super::fit::{Fit, Room};
use super::pens::{FIT, FURNITURE};
use super::sheet::{Hold, Sheet, width};

/// Side at which the head of a bed or the back of a sofa stands, and whether the room is mirrored: a turn of the room.
#[derive(Clone, Copy)]
struct Turn {
    /// 0 = south, 1 = east, 2 = north, 3 = west at the room's own lower side.
    quarter: usize,
    mirror: bool,
}

impl Turn {
    /// A place in the room's own coordinates (0 to `side`) on the plan.
    fn at(self, fit: &Fit, [x, y]: [f64; 2]) -> [f64; 2] {
        let side = fit.room.side_m();
        let x = if self.mirror { side - x } else { x };
        let [u, v] = match self.quarter {
            0 => [x, y],
            1 => [side - y, x],
            2 => [side - x, side - y],
            _ => [y, side - x],
        };
        [fit.low[0] + u, fit.low[1] + v]
    }

    /// Sides as `Fit` counts them (east, north, west, south) that the room's own lower and left sides lie on.
    fn sides(self) -> [usize; 2] {
        let back = [3, 0, 1, 2][self.quarter];
        let left = (back + 3) % 4;
        [back, if self.mirror { (left + 2) % 4 } else { left }]
    }
}

/// Head and wardrobe against walls without windows where that can be.
fn turn(fit: &Fit) -> Turn {
    let all = (0..4).flat_map(|quarter| [false, true].map(|mirror| Turn { quarter, mirror }));
    let worth = |t: &Turn| {
        let [back, left] = t.sides();
        let one = |side: usize, lit: i32| 3 * i32::from(fit.against[side]) - lit * i32::from(fit.lit[side]);
        one(back, 2) + if fit.room == Room::Bedroom { one(left, 3) } else { 0 }
    };
    // The first of the best.
    all.rev().max_by_key(worth).unwrap_or(Turn { quarter: 0, mirror: false })
}

/// Draws the outline of a test fit, its furniture and its name.
pub fn draw(sheet: &mut Sheet, fit: &Fit) {
    let t = turn(fit);
    let side = fit.room.side_m();
    sheet.open(match fit.room {
        Room::Bedroom => "fit bedroom",
        Room::Living => "fit living",
    });
    let corners = [[0.0, 0.0], [side, 0.0], [side, side], [0.0, side]].map(|p| t.at(fit, p));
    sheet.shape(FIT, &corners, true, "none");
    let name_at = match fit.room {
        Room::Bedroom => {
            bedroom(sheet, fit, t);
            [1.9, 2.6]
        }
        Room::Living => {
            living(sheet, fit, t);
            [2.0, 1.98]
        }
    };
    let (words, half) = (fit.room.words(), 0.5 * sheet.format.scale * 1e-3 * width(fit.room.words(), 2.0));
    let mut p = t.at(fit, name_at);
    // The name stays inside its room whatever the turn.
    p[0] = p[0].clamp(fit.low[0] + half.min(0.5 * side), fit.low[0] + side - half.min(0.5 * side));
    let at = sheet.at(p);
    sheet.label(words, [at[0], at[1] + 0.7], 2.0, Hold::Middle, "#8a5f2c");
    sheet.close();
}

fn piece(sheet: &mut Sheet, fit: &Fit, t: Turn, low: [f64; 2], size: [f64; 2]) {
    let high = [low[0] + size[0], low[1] + size[1]];
    let corners = [low, [high[0], low[1]], high, [low[0], high[1]]].map(|p| t.at(fit, p));
    sheet.shape(FURNITURE, &corners, true, "#fff");
}

/// A wardrobe of 600 x 2,400 mm along the left side, a double bed of 1,600 x 2,000 mm with its head at the back, bedside tables.
fn bedroom(sheet: &mut Sheet, fit: &Fit, t: Turn) {
    piece(sheet, fit, t, [0.0, 0.3], [0.6, 2.4]);
    let wardrobe: Vec<_> = [1.1, 1.9].iter().map(|&y| [t.at(fit, [0.0, y]), t.at(fit, [0.6, y])]).collect();
    sheet.lines(FURNITURE, &wardrobe);
    sheet.lines(FURNITURE, &[[t.at(fit, [0.3, 0.36]), t.at(fit, [0.3, 2.64])]]);
    piece(sheet, fit, t, [1.1, 0.0], [1.6, 2.05]);
    for x in [1.2, 1.95] {
        piece(sheet, fit, t, [x, 0.12], [0.65, 0.4]);
    }
    sheet.lines(
        FURNITURE,
        &[[t.at(fit, [1.1, 0.7]), t.at(fit, [2.7, 0.7])], [t.at(fit, [1.1, 0.95]), t.at(fit, [1.6, 0.7])]],
    );
    piece(sheet, fit, t, [2.7, 0.0], [0.3, 0.4]);
}

/// A sofa of 2,200 x 900 mm at the back with a low table, a table of 1,600 x 800 mm with six chairs in front.
fn living(sheet: &mut Sheet, fit: &Fit, t: Turn) {
    piece(sheet, fit, t, [0.25, 0.0], [2.2, 0.9]);
    piece(sheet, fit, t, [0.45, 0.25], [0.9, 0.65]);
    piece(sheet, fit, t, [1.35, 0.25], [0.9, 0.65]);
    piece(sheet, fit, t, [0.8, 1.25], [1.1, 0.5]);
    piece(sheet, fit, t, [2.95, 0.35], [0.8, 0.8]);
    piece(sheet, fit, t, [3.1, 0.35], [0.5, 0.65]);
    for x in [1.1, 1.6, 2.1] {
        piece(sheet, fit, t, [x, 2.25], [0.42, 0.42]);
        piece(sheet, fit, t, [x, 3.53], [0.42, 0.42]);
    }
    piece(sheet, fit, t, [1.0, 2.7], [1.6, 0.8]);
}
