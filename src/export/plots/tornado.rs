//! What each kind of change does to each objective, the largest effect on top.

use super::canvas::{Align, Canvas, GRID, LINE, PlotError, QUIET, TEXT, svg, width};
use super::{Axis, short, ticks};

/// A kind of change and what it does.
#[derive(Clone, Debug, PartialEq)]
pub struct Effect {
    /// The change, in words.
    pub name: String,
    /// Per objective the least and the greatest difference among changed designs that keep every constraint, %; `None` where none does.
    pub kept: Vec<Option<[f64; 2]>>,
    /// The same among all changed designs that could be assessed.
    pub all: Vec<Option<[f64; 2]>>,
}

/// Better and worse differ in lightness as well as in hue (Okabe and Ito 2008).
const BETTER: u32 = 0x0072B2;
const WORSE: u32 = 0xE69F00;

const TOP: f64 = 118.0;
const ROW: f64 = 26.0;
const GAP: f64 = 64.0;

/// A panel per objective with bars from the least to the greatest difference of each kind of change, in percent of the value in the middle,
/// and pale from the middle to the least where all of them go one way; a thin line shows where designs that break a constraint would reach. A bar that is much longer than most is cut off with a slash.
///
/// # Errors
/// When drawing fails.
pub fn tornado(
    title: &str,
    note: &str,
    axes: &[Axis],
    values: &[String],
    effects: &[Effect],
) -> Result<String, PlotError> {
    let left = effects.iter().map(|e| width(&e.name, 14.0)).fold(80.0, f64::max) + 40.0;
    let each = ((1240.0 - left) / axes.len().max(1) as f64 - GAP).clamp(140.0, 420.0);
    let bottom = TOP + ROW * effects.len().max(1) as f64;
    let right = left + axes.len() as f64 * (each + GAP);
    svg([(right as u32).max(640), bottom as u32 + 72], |c| {
        c.text(title, [24.0, 30.0], 20.0, TEXT, Align::Left)?;
        c.text(note, [24.0, 54.0], 13.0, QUIET, Align::Left)?;
        key(c, [24.0, bottom + 54.0])?;
        for (n, effect) in effects.iter().enumerate() {
            c.text(&effect.name, [left - 12.0, TOP + ROW * (n as f64 + 0.5)], 14.0, TEXT, Align::Right)?;
        }
        for (m, axis) in axes.iter().enumerate() {
            let x = left + m as f64 * (each + GAP) + GAP / 2.0;
            let value = values.get(m).map_or("", String::as_str);
            panel(c, [x, x + each], axis, value, effects, m)?;
        }
        Ok(())
    })
}

fn key(c: &mut Canvas, [x, y]: [f64; 2]) -> Result<(), PlotError> {
    let mut at = x;
    for (colour, word) in [(BETTER, "better"), (WORSE, "worse")] {
        c.rect([at, y - 6.0], [at + 18.0, y + 6.0], colour, 1.0)?;
        c.text(word, [at + 24.0, y], 13.0, TEXT, Align::Left)?;
        at += 44.0 + width(word, 13.0);
    }
    c.line(&[[at, y], [at + 18.0, y]], LINE, 1.0, 1.5)?;
    c.text("with designs that break a constraint", [at + 24.0, y], 13.0, TEXT, Align::Left)
}

fn panel(
    c: &mut Canvas,
    [l, r]: [f64; 2],
    axis: &Axis,
    value: &str,
    effects: &[Effect],
    m: usize,
) -> Result<(), PlotError> {
    let bottom = TOP + ROW * effects.len().max(1) as f64;
    let of = |ranges: &[Option<[f64; 2]>]| ranges.get(m).copied().flatten().filter(|r| r.iter().all(|v| v.is_finite()));
    let ends = effects.iter().filter_map(|e| of(&e.kept)).flatten();
    let [low, high] = ends.fold([0.0f64, 0.0f64], |[a, b], v| [a.min(v), b.max(v)]);
    let most = cut(effects.iter().filter_map(|e| of(&e.kept)));
    let [low, high] = [low.max(-most), high.min(most)];
    // Room for the numbers beside the bars.
    let pad = (0.22 * (high - low)).max(0.5);
    let [low, high] = [low - pad, high + pad];
    let x = |v: f64| l + (r - l) * (v.clamp(low, high) - low) / (high - low);
    let end = |v: f64| x(v.clamp(-most, most));
    c.text(&axis.title, [(l + r) / 2.0, TOP - 40.0], 15.0, TEXT, Align::Middle)?;
    c.text(value, [(l + r) / 2.0, TOP - 20.0], 13.0, QUIET, Align::Middle)?;
    let (marks, step) = ticks([low, high], 4);
    for v in marks {
        c.line(&[[x(v), TOP], [x(v), bottom]], GRID, 1.0, 0.75)?;
        c.text(&short(v, step), [x(v), bottom + 14.0], 12.0, QUIET, Align::Middle)?;
    }
    c.text("change [%]", [(l + r) / 2.0, bottom + 32.0], 13.0, TEXT, Align::Middle)?;
    for (n, effect) in effects.iter().enumerate() {
        let y = TOP + ROW * (n as f64 + 0.5);
        if let Some([from, to]) = of(&effect.all) {
            c.line(&[[x(from), y], [x(to), y]], LINE, 1.0, 1.5)?;
        }
        let Some([from, to]) = of(&effect.kept) else { continue };
        for [near, far] in
            [[to.min(0.0), from.min(0.0)], [from.max(0.0), to.max(0.0)]].into_iter().filter(|r| r[1] != 0.0)
        {
            let colour = if (far > 0.0) == axis.maximise { BETTER } else { WORSE };
            // Pale as far as every one of these changes goes, and full over their range, at least two pixels.
            let reach = if far > 0.0 { 2.0 } else { -2.0 };
            let start = end(near);
            let tip = if (end(far) - start).abs() < 2.0 { start + reach } else { end(far) };
            if near != 0.0 {
                c.rect([x(0.0).min(start), y - 8.0], [x(0.0).max(start), y + 8.0], colour, 0.35)?;
            }
            c.rect([start.min(tip), y - 8.0], [start.max(tip), y + 8.0], colour, 1.0)?;
            if far.abs() > most {
                // A white slash: the bar is longer than the panel.
                let tip = end(far) - 4.0 * reach;
                c.line(&[[tip - 3.0, y + 9.0], [tip + 3.0, y - 9.0]], 0xFFFFFF, 1.0, 3.0)?;
            }
        }
        for (value, side) in [(from.min(0.0), -1.0), (to.max(0.0), 1.0)].into_iter().filter(|(v, _)| v.abs() >= 0.05) {
            let (at, text) = (end(value) + side * 5.0, percent(value));
            // White behind the number, where the thin line goes on.
            let beyond = at + side * width(&text, 11.0);
            c.rect([at.min(beyond) - 1.0, y - 6.0], [at.max(beyond) + 1.0, y + 6.0], 0xFFFFFF, 1.0)?;
            c.text(&text, [at, y], 11.0, TEXT, if side > 0.0 { Align::Left } else { Align::Right })?;
        }
    }
    c.line(&[[x(0.0), TOP - 4.0], [x(0.0), bottom]], TEXT, 1.0, 1.0)
}

/// Where bars are cut off: where one or two reach more than twice as far as the third, all others could not be read.
fn cut(ranges: impl Iterator<Item = [f64; 2]>) -> f64 {
    let mut reaches: Vec<f64> = ranges.map(|[a, b]| a.abs().max(b.abs())).filter(|r| *r >= 0.05).collect();
    reaches.sort_by(|a, b| b.total_cmp(a));
    match reaches[..] {
        [first, _, third, _, _, _, ..] if first > 2.0 * third => 1.25 * third,
        _ => f64::INFINITY,
    }
}

fn percent(value: f64) -> String {
    let digits = if value.abs() < 9.95 { 1 } else { 0 };
    format!("{value:+.digits$}").replace('-', "\u{2212}")
}
