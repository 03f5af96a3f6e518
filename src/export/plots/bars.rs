//! Counts by cause as bars.

use super::canvas::{Align, GRID, PlotError, QUIET, TEXT, svg, width};
use super::{short, ticks};

/// A bar.
#[derive(Clone, Debug, PartialEq)]
pub struct Bar {
    /// Cause, in words.
    pub name: String,
    /// How often.
    pub value: f64,
}

/// Horizontal bars, largest first, with the value and its share at the end of each.
///
/// # Errors
/// When drawing fails.
pub fn bars(title: &str, axis: &str, bars: &[Bar]) -> Result<String, PlotError> {
    let mut sorted: Vec<&Bar> = bars.iter().filter(|b| b.value.is_finite() && b.value >= 0.0).collect();
    sorted.sort_by(|a, b| b.value.total_cmp(&a.value).then_with(|| a.name.cmp(&b.name)));
    let total: f64 = sorted.iter().map(|b| b.value).sum();
    let most = sorted.first().map_or(1.0, |b| b.value).max(1e-9);
    let left = sorted.iter().map(|b| width(&b.name, 14.0)).fold(80.0, f64::max).min(380.0) + 36.0;
    let (right, top, row) = (840.0, 64.0, 30.0);
    let bottom = top + row * sorted.len().max(1) as f64;
    svg([960, bottom as u32 + 60], |c| {
        c.text(title, [24.0, 30.0], 20.0, TEXT, Align::Left)?;
        let (values, step) = ticks([0.0, most], 5);
        for v in values {
            let x = left + (right - left) * v / most;
            c.line(&[[x, top], [x, bottom]], GRID, 1.0, 0.75)?;
            c.text(&short(v, step), [x, bottom + 14.0], 13.0, QUIET, Align::Middle)?;
        }
        c.text(axis, [(left + right) / 2.0, bottom + 40.0], 15.0, TEXT, Align::Middle)?;
        if sorted.is_empty() {
            return c.text("none", [left + 10.0, top + row / 2.0], 14.0, QUIET, Align::Left);
        }
        for (n, bar) in sorted.iter().enumerate() {
            let y = top + row * n as f64;
            let x = left + (right - left) * bar.value / most;
            c.rect([left, y + 5.0], [x, y + row - 5.0], 0x3B6E8F, 1.0)?;
            c.text(&bar.name, [left - 8.0, y + row / 2.0], 14.0, TEXT, Align::Right)?;
            let share = if total > 0.0 { 100.0 * bar.value / total } else { 0.0 };
            let label = format!("{} · {share:.0} %", short(bar.value, 1.0));
            c.text(&label, [x + 6.0, y + row / 2.0], 13.0, QUIET, Align::Left)?;
        }
        Ok(())
    })
}
