//! What a house is made up of in money or carbon: a bar each, divided by section of the bill.

use super::canvas::{Align, GRID, LINE, PlotError, QUIET, TEXT, svg, width};
use super::{short, ticks};

/// A house as parts of one quantity.
#[derive(Clone, Debug, PartialEq)]
pub struct Parts {
    /// As printed.
    pub name: String,
    /// The quantity of each section, in the order of the sections; parts below 0 count as none.
    pub parts: Vec<f64>,
}

/// Colours that are told apart without colour vision by lightness and order (after Okabe and Ito 2008), and whether ink on them is white.
const COLOURS: [(u32, bool); 8] = [
    (0x0B4F7D, true),
    (0x56A8DC, false),
    (0x00795A, true),
    (0xF0C36A, false),
    (0xD55E00, true),
    (0xE8B7CF, false),
    (0x4D4D4D, true),
    (0xC4C9CE, false),
];

const ROW: f64 = 36.0;

/// Horizontal bars from 0 to each house's total in the order given, divided by `sections`; shares of at least a twentieth are written
/// in their part in percent, the total at the end. Less is better.
///
/// # Errors
/// When drawing fails.
pub fn breakdown(
    title: &str,
    note: &str,
    axis: &str,
    sections: &[&str],
    houses: &[Parts],
) -> Result<String, PlotError> {
    let total = |h: &Parts| h.parts.iter().map(|v| v.max(0.0)).sum::<f64>();
    let most = houses.iter().map(total).filter(|t| t.is_finite()).fold(1e-9, f64::max);
    let left = houses.iter().map(|h| width(&h.name, 14.0)).fold(90.0, f64::max).min(320.0) + 40.0;
    let right = 860.0;
    // The key takes as many lines as it needs.
    let mut places: Vec<[f64; 2]> = Vec::new();
    let mut at = [24.0, 80.0];
    for section in sections {
        let wide = 40.0 + width(section, 13.0);
        if at[0] + wide > 930.0 {
            at = [24.0, at[1] + 22.0];
        }
        places.push(at);
        at[0] += wide;
    }
    let top = at[1] + 26.0;
    let bottom = top + ROW * houses.len().max(1) as f64;
    let place = |v: f64| left + (right - left) * v / most;
    // Totals to a hundredth of the largest.
    let round = 10f64.powf((0.01 * most).log10().floor());
    svg([960, bottom as u32 + 64], |c| {
        c.text(title, [24.0, 30.0], 20.0, TEXT, Align::Left)?;
        c.text(note, [24.0, 54.0], 13.0, QUIET, Align::Left)?;
        for ((section, [x, y]), (colour, _)) in sections.iter().zip(&places).zip(COLOURS.iter().cycle()) {
            c.rect([*x, y - 7.0], [x + 14.0, y + 7.0], *colour, 1.0)?;
            c.text(section, [x + 20.0, *y], 13.0, TEXT, Align::Left)?;
        }
        let (values, step) = ticks([0.0, most], 6);
        for v in values {
            c.line(&[[place(v), top], [place(v), bottom]], GRID, 1.0, 0.75)?;
            c.text(&short(v, step), [place(v), bottom + 14.0], 13.0, QUIET, Align::Middle)?;
        }
        c.text(axis, [(left + right) / 2.0, bottom + 42.0], 15.0, TEXT, Align::Middle)?;
        c.arrow([right, bottom + 42.0], [-1.0, 0.0], 34.0, QUIET)?;
        c.text("better", [right - 42.0, bottom + 42.0], 12.0, QUIET, Align::Right)?;
        for (n, house) in houses.iter().enumerate() {
            let y = top + ROW * n as f64;
            let (middle, all) = (y + ROW / 2.0, total(house));
            c.text(&house.name, [left - 10.0, middle], 14.0, TEXT, Align::Right)?;
            let mut sum = 0.0;
            for (&part, (colour, white)) in house.parts.iter().zip(COLOURS.iter().cycle()) {
                let [from, to] = [place(sum), place(sum + part.max(0.0))];
                sum += part.max(0.0);
                if to - from < 0.3 {
                    continue;
                }
                c.rect([from, y + 5.0], [to, y + ROW - 5.0], *colour, 1.0)?;
                c.line(&[[to, y + 5.0], [to, y + ROW - 5.0]], 0xFFFFFF, 1.0, 0.75)?;
                if to - from > 22.0 && part >= 0.05 * all {
                    let ink = if *white { 0xFFFFFF } else { TEXT };
                    let share = format!("{:.0}", 100.0 * part / all);
                    c.text(&share, [(from + to) / 2.0, middle], 12.0, ink, Align::Middle)?;
                }
            }
            c.text(&short(all, round), [place(all) + 8.0, middle], 13.0, TEXT, Align::Left)?;
        }
        c.line(&[[left, top], [left, bottom]], LINE, 1.0, 1.0)
    })
}
