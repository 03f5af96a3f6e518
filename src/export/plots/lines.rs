//! Hypervolume against evaluations.

use super::canvas::{Align, GRID, LINE, PlotError, QUIET, TEXT, svg};
use super::{range, short, ticks};

/// A line of the plot.
#[derive(Clone, Debug, PartialEq)]
pub struct Series {
    /// As printed at its end.
    pub name: String,
    /// Evaluations and hypervolume, by rising evaluations.
    pub points: Vec<[f64; 2]>,
}

/// Colours that differ in lightness as well (Okabe and Ito 2008), darkest first.
const COLOURS: [u32; 6] = [0x0072B2, 0xD55E00, 0x009E73, 0xCC79A7, 0x56B4E9, 0x7A7A7A];

/// The evaluations after which a series first has `value`; `None` when it never has.
pub fn reached(series: &Series, value: f64) -> Option<f64> {
    series.points.iter().find(|p| p[1] >= value).map(|p| p[0])
}

/// Hypervolume (more is better) against evaluations, a stepped line per series, names at the line ends, `note` under the title.
///
/// # Errors
/// When drawing fails.
pub fn hypervolume(title: &str, note: &str, series: &[Series]) -> Result<String, PlotError> {
    let all = || series.iter().flat_map(|s| &s.points);
    let most = all().map(|p| p[0]).filter(|x| x.is_finite()).fold(1.0, f64::max);
    let [_, top] = range(all().map(|p| p[1]));
    let top = if top > 0.0 { top } else { 1.0 };
    let [l, t, r, b] = [92.0, 64.0, 790.0, 500.0];
    let place = |[x, y]: [f64; 2]| [l + x / most * (r - l), b + (y / top).clamp(0.0, 1.0) * (t - b)];
    svg([960, 570], |c| {
        c.text(title, [l, 30.0], 20.0, TEXT, Align::Left)?;
        c.text(note, [l, 52.0], 13.0, QUIET, Align::Left)?;
        let (ys, step) = ticks([0.0, top], 5);
        for y in ys {
            let [_, v] = place([0.0, y]);
            c.line(&[[l, v], [r, v]], GRID, 1.0, 0.75)?;
            c.text(&short(y, step), [l - 6.0, v], 13.0, QUIET, Align::Right)?;
        }
        let (xs, step) = ticks([0.0, most], 6);
        for x in xs {
            let [u, _] = place([x, 0.0]);
            c.line(&[[u, b], [u, b + 4.0]], LINE, 1.0, 1.0)?;
            c.text(&short(x, step), [u, b + 15.0], 13.0, QUIET, Align::Middle)?;
        }
        c.line(&[[l, t], [l, b], [r, b]], LINE, 1.0, 1.0)?;
        c.text("Evaluations", [(l + r) / 2.0, b + 44.0], 15.0, TEXT, Align::Middle)?;
        c.upwards("Hypervolume / box of the first sample", [l - 66.0, (t + b) / 2.0], 15.0, TEXT)?;
        c.arrow([l - 66.0, t + 34.0], [0.0, -1.0], 34.0, QUIET)?;
        c.upwards("better", [l - 66.0, t + 62.0], 12.0, QUIET)?;
        for (s, colour) in series.iter().zip(COLOURS.iter().cycle()) {
            c.line(&steps(&s.points, most).into_iter().map(place).collect::<Vec<_>>(), *colour, 1.0, 2.0)?;
        }
        let ends: Vec<f64> = series.iter().map(|s| s.points.last().map_or(b, |p| place(*p)[1])).collect();
        for ((s, y), colour) in series.iter().zip(apart(&ends, 17.0)).zip(COLOURS.iter().cycle()) {
            c.text(&s.name, [r + 10.0, y], 13.0, *colour, Align::Left)?;
        }
        Ok(())
    })
}

/// A value holds until the next one, and to the end.
fn steps(points: &[[f64; 2]], most: f64) -> Vec<[f64; 2]> {
    let mut line: Vec<[f64; 2]> = Vec::new();
    for p in points.iter().filter(|p| p.iter().all(|v| v.is_finite())) {
        if let Some(last) = line.last().copied() {
            line.push([p[0], last[1]]);
        }
        line.push(*p);
    }
    line.extend(line.last().map(|p| [most, p[1]]));
    line
}

/// Moves places apart to at least `gap`, keeping their order and staying near.
pub(super) fn apart(places: &[f64], gap: f64) -> Vec<f64> {
    let mut order: Vec<usize> = (0..places.len()).collect();
    order.sort_by(|a, b| places[*a].total_cmp(&places[*b]));
    let mut moved = places.to_vec();
    for pair in order.windows(2) {
        moved[pair[1]] = moved[pair[1]].max(moved[pair[0]] + gap);
    }
    moved
}
