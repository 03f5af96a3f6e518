//! Shares by kind as stacked bars.

use super::canvas::{Align, GRID, LINE, PlotError, QUIET, TEXT, svg, width};

/// A bar of shares.
#[derive(Clone, Debug, PartialEq)]
pub struct Stack {
    /// What it is of.
    pub name: String,
    /// Counts by kind.
    pub counts: Vec<u64>,
}

/// Colours that differ in lightness as well (after Okabe and Ito 2008), darkest first.
const COLOURS: [u32; 6] = [0x0B4F7D, 0x56A8DC, 0xD55E00, 0xF0C36A, 0xB9BEC4, 0x7A7A7A];

const ROW: f64 = 25.0;

/// Horizontal bars of 100 % each, in the order given, divided by `kinds`, with the number of all at the end.
///
/// # Errors
/// When drawing fails.
pub fn stacked(title: &str, axis: &str, kinds: &[&str], stacks: &[Stack]) -> Result<String, PlotError> {
    let left = stacks.iter().map(|s| width(&s.name, 14.0)).fold(80.0, f64::max) + 40.0;
    let (right, top) = (860.0, 92.0);
    let bottom = top + ROW * stacks.len().max(1) as f64;
    svg([960, bottom as u32 + 60], |c| {
        c.text(title, [24.0, 30.0], 20.0, TEXT, Align::Left)?;
        let mut at = left;
        for (kind, colour) in kinds.iter().zip(COLOURS.iter().cycle()) {
            c.rect([at, 56.0], [at + 14.0, 70.0], *colour, 1.0)?;
            c.text(kind, [at + 20.0, 63.0], 13.0, TEXT, Align::Left)?;
            at += 36.0 + width(kind, 13.0);
        }
        c.text("draws", [right + 10.0, top - 12.0], 12.0, QUIET, Align::Left)?;
        for n in 0..=4 {
            let x = left + (right - left) * f64::from(n) / 4.0;
            c.line(&[[x, top], [x, bottom]], GRID, 1.0, 0.75)?;
            c.text(&format!("{}", 25 * n), [x, bottom + 14.0], 13.0, QUIET, Align::Middle)?;
        }
        c.text(axis, [(left + right) / 2.0, bottom + 40.0], 15.0, TEXT, Align::Middle)?;
        for (n, stack) in stacks.iter().enumerate() {
            let y = top + ROW * n as f64;
            c.text(&stack.name, [left - 10.0, y + ROW / 2.0], 14.0, TEXT, Align::Right)?;
            let all: u64 = stack.counts.iter().sum();
            c.text(&all.to_string(), [right + 10.0, y + ROW / 2.0], 13.0, QUIET, Align::Left)?;
            let mut from = left;
            for (k, (&count, colour)) in stack.counts.iter().zip(COLOURS.iter().cycle()).enumerate() {
                let share = count as f64 / all.max(1) as f64;
                let to = from + (right - left) * share;
                if count > 0 {
                    c.rect([from, y + 3.0], [to, y + ROW - 3.0], *colour, 1.0)?;
                }
                // White on the dark colours, ink on the others.
                if to - from > 34.0 {
                    let ink = if k == 0 || k == 2 { 0xFFFFFF } else { TEXT };
                    let place = [(from + to) / 2.0, y + ROW / 2.0];
                    c.text(&format!("{:.0}", 100.0 * share), place, 12.0, ink, Align::Middle)?;
                }
                from = to;
            }
        }
        c.line(&[[left, top], [left, bottom]], LINE, 1.0, 1.0)
    })
}
