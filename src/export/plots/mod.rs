//! Plots as SVG, readable in print and without colour vision, and their PNG.
//!
//! plotters draws the SVG at four units a pixel (its coordinates are integers); resvg turns it into pixels with the font
//! that the crate epaint_default_fonts carries.

mod bars;
mod breakdown;
mod canvas;
mod chances;
mod legend;
mod lines;
mod map;
mod materials;
mod parallel;
mod ranges;
mod scatter;
mod sheet;
mod stacked;
mod systems;
mod tornado;

pub use bars::{Bar, bars};
pub use breakdown::{Parts, breakdown};
pub use canvas::{PlotError, svg_to_png};
pub use chances::chances;
pub use legend::{Legend, with_legend};
pub use lines::{Series, hypervolume, reached};
pub use map::{DiversityMap, Heading, MapCell, diversity_map};
pub use materials::{Framed, by_material};
pub use parallel::parallel_coordinates;
pub use ranges::{RangeBar, ranges};
pub use scatter::{Cloud, Named, pareto, scatter_matrix};
pub use sheet::{Card, Group, contact_sheet, grouped_sheet};
pub use stacked::{Stack, stacked};
pub use systems::{SystemHouse, SystemPoint, systems_front};
pub use tornado::{Effect, tornado};

/// An objective as an axis.
#[derive(Clone, Debug, PartialEq)]
pub struct Axis {
    /// In words, e.g. `Price`.
    pub title: String,
    /// Unit, e.g. `EUR`; empty for a plain number.
    pub unit: String,
    /// Whether more is better.
    pub maximise: bool,
}

impl Axis {
    fn label(&self) -> String {
        if self.unit.is_empty() { self.title.clone() } else { format!("{} [{}]", self.title, self.unit) }
    }
}

/// A number for people: thousands as `12k`, no needless decimals.
fn short(value: f64, step: f64) -> String {
    let (value, step, suffix) = match value.abs().max(step.abs()) {
        m if m >= 1e7 => (value / 1e6, step / 1e6, "M"),
        m if m >= 1e4 => (value / 1e3, step / 1e3, "k"),
        _ => (value, step, ""),
    };
    let digits = if step >= 0.999 || step <= 0.0 { 0 } else { (-step.log10()).ceil().clamp(0.0, 6.0) as usize };
    let digits = if step > 0.0 && (step * 10f64.powi(digits as i32)).fract() > 1e-6 { digits + 1 } else { digits };
    let text = format!("{value:.digits$}");
    let text = if text.trim_start_matches('-').chars().all(|c| c == '0' || c == '.') { "0".to_owned() } else { text };
    if text == "0" { text } else { text + suffix }
}

/// Round ticks inside a range, about `count` of them.
fn ticks([low, high]: [f64; 2], count: usize) -> (Vec<f64>, f64) {
    let raw = (high - low) / count.max(1) as f64;
    if !(raw.is_finite() && raw > 0.0) {
        return (vec![low], 1.0);
    }
    let power = 10f64.powf(raw.log10().floor());
    let step = [1.0, 2.0, 2.5, 5.0, 10.0].map(|m| m * power).into_iter().find(|s| *s >= raw * 0.999).unwrap_or(power);
    let first = (low / step - 1e-9).ceil() as i64;
    let last = (high / step + 1e-9).floor() as i64;
    ((first..=last).map(|i| i as f64 * step).collect(), step)
}

/// The range of finite values, widened by a twentieth on both sides; never empty.
fn range(values: impl Iterator<Item = f64>) -> [f64; 2] {
    let [low, high] =
        values.filter(|v| v.is_finite()).fold([f64::INFINITY, f64::NEG_INFINITY], |[l, h], v| [l.min(v), h.max(v)]);
    if low > high {
        return [0.0, 1.0];
    }
    let pad = ((high - low) * 0.05).max(high.abs() * 1e-3).max(1e-9);
    [low - pad, high + pad]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ticks_are_round_and_inside() {
        let (values, step) = ticks([96_300.0, 183_000.0], 5);
        assert_eq!(step, 20_000.0);
        assert_eq!(values, [100_000.0, 120_000.0, 140_000.0, 160_000.0, 180_000.0]);
        assert_eq!(ticks([1.0, 1.0], 5).0.len(), 1);
    }

    #[test]
    fn numbers_are_short() {
        assert_eq!(short(120_000.0, 20_000.0), "120k");
        assert_eq!(short(12_500.0, 2_500.0), "12.5k");
        assert_eq!(short(0.25, 0.05), "0.25");
        assert_eq!(short(42.0, 10.0), "42");
        assert_eq!(short(-0.0, 0.5), "0");
    }
}
