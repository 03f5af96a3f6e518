//! Values with their ranges as bars.

use super::canvas::{Align, GRID, PlotError, QUIET, TEXT, svg, width};
use super::{short, ticks};

/// A value with its range.
#[derive(Clone, Debug, PartialEq)]
pub struct RangeBar {
    /// What it is of.
    pub name: String,
    /// Low, default, high.
    pub range: [f64; 3],
    /// Drawn pale: a house that does not stand.
    pub is_pale: bool,
}

/// Horizontal bars up to the default, in the order given, with a whisker from low to high and the default beside it.
///
/// # Errors
/// When drawing fails.
pub fn ranges(title: &str, axis: &str, bars: &[RangeBar]) -> Result<String, PlotError> {
    let most = bars.iter().map(|b| b.range[2]).filter(|v| v.is_finite()).fold(1e-9, f64::max);
    let left = bars.iter().map(|b| width(&b.name, 15.0)).fold(80.0, f64::max).min(380.0) + 36.0;
    let (right, top, row) = (860.0, 64.0, 44.0);
    let bottom = top + row * bars.len().max(1) as f64;
    svg([960, bottom as u32 + 60], |c| {
        c.text(title, [24.0, 30.0], 20.0, TEXT, Align::Left)?;
        let (values, step) = ticks([0.0, most], 6);
        let x = |value: f64| left + (right - left) * value / most;
        for v in values {
            c.line(&[[x(v), top], [x(v), bottom]], GRID, 1.0, 0.75)?;
            c.text(&short(v, step), [x(v), bottom + 14.0], 13.0, QUIET, Align::Middle)?;
        }
        c.text(axis, [(left + right) / 2.0, bottom + 40.0], 15.0, TEXT, Align::Middle)?;
        for (n, bar) in bars.iter().enumerate().filter(|(_, b)| b.range.iter().all(|v| v.is_finite())) {
            let (y, [low, default, high]) = (top + row * n as f64, bar.range);
            let middle = y + row / 2.0;
            c.rect([left, y + 8.0], [x(default), y + row - 8.0], 0x3B6E8F, if bar.is_pale { 0.35 } else { 1.0 })?;
            c.line(&[[x(low), middle], [x(high), middle]], TEXT, 1.0, 1.5)?;
            for end in [low, high] {
                c.line(&[[x(end), middle - 6.0], [x(end), middle + 6.0]], TEXT, 1.0, 1.5)?;
            }
            c.text(&bar.name, [left - 8.0, middle], 15.0, TEXT, Align::Right)?;
            c.text(&short(default, default / 100.0), [x(high) + 8.0, middle], 14.0, QUIET, Align::Left)?;
        }
        Ok(())
    })
}
