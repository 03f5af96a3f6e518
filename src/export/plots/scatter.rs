//! Designs as points: two objectives against each other, and all pairs.

use super::canvas::{Align, Canvas, GRID, LINE, PlotError, QUIET, TEXT, svg, width};
use super::{Axis, range, short, ticks};
use crate::export::viridis;

/// Designs by their objective values, each as long as the axes and in their order and sense.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Cloud {
    /// Feasible designs that were evaluated.
    pub feasible: Vec<Vec<f64>>,
    /// Infeasible designs; may be left empty.
    pub infeasible: Vec<Vec<f64>>,
    /// The front.
    pub front: Vec<Vec<f64>>,
}

/// A house with a name in a plot.
#[derive(Clone, Debug, PartialEq)]
pub struct Named {
    /// As printed.
    pub name: String,
    /// Its objectives.
    pub values: Vec<f64>,
}

/// Where values lie on the sheet.
pub(super) struct Frame {
    /// Left, top, right, bottom in pixels.
    pub at: [f64; 4],
    /// Lowest and highest value to the right.
    pub x: [f64; 2],
    /// Lowest and highest value upwards.
    pub y: [f64; 2],
}

impl Frame {
    /// Where a pair of values lies; `None` outside.
    pub fn place(&self, x: f64, y: f64) -> Option<[f64; 2]> {
        let [l, t, r, b] = self.at;
        let (u, v) = ((x - self.x[0]) / (self.x[1] - self.x[0]), (y - self.y[0]) / (self.y[1] - self.y[0]));
        let inside = (-0.001..=1.001).contains(&u) && (-0.001..=1.001).contains(&v);
        inside.then_some([l + u * (r - l), b + v * (t - b)])
    }

    /// Lines at round values, with them along the axes that `labels` picks.
    pub fn grid(&self, c: &mut Canvas, count: [usize; 2], size: f64, labels: [bool; 2]) -> Result<(), PlotError> {
        let [l, t, r, b] = self.at;
        let (xs, step) = ticks(self.x, count[0]);
        for x in xs {
            let Some([u, _]) = self.place(x, self.y[0]) else { continue };
            c.line(&[[u, t], [u, b]], GRID, 1.0, 0.75)?;
            if labels[0] {
                c.text(&short(x, step), [u, b + size], size, QUIET, Align::Middle)?;
            }
        }
        let (ys, step) = ticks(self.y, count[1]);
        for y in ys {
            let Some([_, v]) = self.place(self.x[0], y) else { continue };
            c.line(&[[l, v], [r, v]], GRID, 1.0, 0.75)?;
            if labels[1] {
                c.text(&short(y, step), [l - 6.0, v], size, QUIET, Align::Right)?;
            }
        }
        c.line(&[[l, t], [l, b], [r, b]], LINE, 1.0, 1.0)
    }

    fn dots(
        &self,
        c: &mut Canvas,
        rows: &[Vec<f64>],
        [i, j]: [usize; 2],
        look: (f64, u32, f64),
    ) -> Result<(), PlotError> {
        for row in rows {
            let at = row.get(i).zip(row.get(j)).and_then(|(x, y)| self.place(*x, *y));
            if let Some(at) = at {
                c.dot(at, look.0, look.1, look.2)?;
            }
        }
        Ok(())
    }
}

const SIZE: [u32; 2] = [960, 680];

/// Price-against-carbon and the like: objectives `pair` as x and y, the front coloured by objective `colour`.
///
/// # Errors
/// When drawing fails.
pub fn pareto(
    title: &str,
    axes: &[Axis],
    pair: [usize; 2],
    colour: Option<usize>,
    cloud: &Cloud,
    named: &[Named],
) -> Result<String, PlotError> {
    let of = |k: usize| move |row: &Vec<f64>| row.get(k).copied().unwrap_or(f64::NAN);
    let [i, j] = pair;
    let ranges = pair.map(|k| near(cloud, named, k));
    let frame = Frame { at: [92.0, 64.0, 820.0, 600.0], x: ranges[0], y: ranges[1] };
    let (Some(x_axis), Some(y_axis)) = (axes.get(i), axes.get(j)) else {
        return Err(PlotError::Drawing(format!("objectives {i} and {j} of {}", axes.len())));
    };
    svg(SIZE, |c| {
        c.text(title, [92.0, 30.0], 20.0, TEXT, Align::Left)?;
        frame.grid(c, [7, 6], 13.0, [true, true])?;
        axis_titles(c, &frame, x_axis, y_axis)?;
        frame.dots(c, &cloud.infeasible, pair, (2.0, 0xC9B8AA, 0.45))?;
        frame.dots(c, &cloud.feasible, pair, (2.5, 0x9BA3AA, 0.6))?;
        let third = colour.and_then(|k| Some((k, axes.get(k)?)));
        let ramp = third.map_or([0.0, 1.0], |(k, _)| extent(cloud.front.iter().map(of(k))));
        for row in &cloud.front {
            let Some(at) = frame.place(of(i)(row), of(j)(row)) else { continue };
            let rgb = third.map_or(0x3B528B, |(k, _)| ramp_colour(of(k)(row), ramp));
            c.dot(at, 5.5, 0xFFFFFF, 1.0)?;
            c.dot(at, 4.75, rgb, 1.0)?;
        }
        if let Some((_, axis)) = third {
            ramp_key(c, axis, ramp)?;
        }
        let beyond = cloud.feasible.iter().filter(|row| frame.place(of(i)(row), of(j)(row)).is_none()).count();
        key(c, beyond, !cloud.infeasible.is_empty())?;
        name_houses(c, &frame, pair, cloud, named)
    })
}

fn extent(values: impl Iterator<Item = f64>) -> [f64; 2] {
    let [l, h] = values.filter(|v| v.is_finite()).fold([f64::MAX, f64::MIN], |[l, h], v| [l.min(v), h.max(v)]);
    if l < h { [l, h] } else { [l - 0.5, l + 0.5] }
}

fn ramp_colour(value: f64, [low, high]: [f64; 2]) -> u32 {
    // The last tenth of viridis is too pale for white paper.
    let [r, g, b] = viridis((value - low) / (high - low) * 0.92).map(u32::from);
    r << 16 | g << 8 | b
}

/// What the axes are, with arrows to the better end.
pub(super) fn axis_titles(c: &mut Canvas, frame: &Frame, x: &Axis, y: &Axis) -> Result<(), PlotError> {
    let [l, t, r, b] = frame.at;
    c.text(&x.label(), [(l + r) / 2.0, b + 42.0], 15.0, TEXT, Align::Middle)?;
    c.upwards(&y.label(), [l - 66.0, (t + b) / 2.0], 15.0, TEXT)?;
    let (dx, start) = if x.maximise { (1.0, r - 34.0) } else { (-1.0, r) };
    c.arrow([start, b + 42.0], [dx, 0.0], 34.0, QUIET)?;
    c.text("better", [r - 42.0, b + 42.0], 12.0, QUIET, Align::Right)?;
    let (dy, start) = if y.maximise { (-1.0, t + 34.0) } else { (1.0, t) };
    c.arrow([l - 66.0, start], [0.0, dy], 34.0, QUIET)?;
    c.upwards("better", [l - 66.0, t + 62.0], 12.0, QUIET)
}

fn ramp_key(c: &mut Canvas, axis: &Axis, ramp: [f64; 2]) -> Result<(), PlotError> {
    let [x, top, bottom] = [850.0, 104.0, 304.0];
    for s in 0..50 {
        let y = bottom + (top - bottom) * f64::from(s) / 50.0;
        let rgb = ramp_colour(ramp[0] + (ramp[1] - ramp[0]) * (f64::from(s) + 0.5) / 50.0, ramp);
        c.rect([x, y - 4.25], [x + 14.0, y], rgb, 1.0)?;
    }
    let (values, step) = ticks(ramp, 4);
    for v in values {
        let y = bottom + (top - bottom) * (v - ramp[0]) / (ramp[1] - ramp[0]);
        c.text(&short(v, step), [x + 20.0, y], 12.0, QUIET, Align::Left)?;
    }
    c.text(&axis.title, [x, top - 34.0], 13.0, TEXT, Align::Left)?;
    c.text(&axis.unit, [x, top - 18.0], 12.0, QUIET, Align::Left)
}

/// The range of the front and of what lies within twice its extent of it, so that a few poor designs far away do not press the front
/// into a corner.
fn near(cloud: &Cloud, named: &[Named], k: usize) -> [f64; 2] {
    let of = |row: &Vec<f64>| row.get(k).copied().unwrap_or(f64::NAN);
    let shown = || cloud.front.iter().chain(named.iter().map(|n| &n.values)).map(of);
    if cloud.front.is_empty() {
        return range(cloud.feasible.iter().map(of));
    }
    let [low, high] = range(shown());
    let span = 2.0 * (high - low);
    range(shown().chain(cloud.feasible.iter().map(of).filter(|v| (low - span..=high + span).contains(v))))
}

fn key(c: &mut Canvas, beyond: usize, infeasible: bool) -> Result<(), PlotError> {
    let mut rows = vec![("front", 0x3B528B, 4.75, 1.0), ("evaluated", 0x9BA3AA, 2.5, 0.9)];
    if infeasible {
        rows.push(("infeasible", 0xC9B8AA, 2.0, 0.9));
    }
    for (n, (name, rgb, radius, alpha)) in rows.into_iter().enumerate() {
        let y = 348.0 + 20.0 * n as f64;
        c.dot([857.0, y], radius, rgb, alpha)?;
        c.text(name, [868.0, y], 12.0, QUIET, Align::Left)?;
    }
    if beyond > 0 {
        c.text(&format!("{beyond} evaluated"), [850.0, 420.0], 12.0, QUIET, Align::Left)?;
        c.text("beyond the axes", [850.0, 436.0], 12.0, QUIET, Align::Left)?;
    }
    Ok(())
}

/// Rings and names, each name at the nearest of several places where it covers no other name and least of the front.
fn name_houses(
    c: &mut Canvas,
    frame: &Frame,
    [i, j]: [usize; 2],
    cloud: &Cloud,
    named: &[Named],
) -> Result<(), PlotError> {
    let spot = |row: &Vec<f64>| frame.place(*row.get(i)?, *row.get(j)?);
    let dots: Vec<[f64; 2]> = cloud.front.iter().filter_map(spot).collect();
    let mut taken: Vec<[f64; 4]> = Vec::new();
    for house in named {
        let Some(at) = spot(&house.values) else { continue };
        let w = width(&house.name, 13.0) + 6.0;
        let boxes = offsets(w).map(|[dx, dy]| [at[0] + dx, at[1] + dy - 9.0, at[0] + dx + w, at[1] + dy + 9.0]);
        let [l, t, r, b] = frame.at;
        let cost = |p: &[f64; 4]| {
            let outside = p[0] < l || p[2] > r + 30.0 || p[1] < t - 14.0 || p[3] > b;
            let names = taken.iter().filter(|q| p[0] < q[2] && q[0] < p[2] && p[1] < q[3] && q[1] < p[3]).count();
            let hits = dots
                .iter()
                .filter(|d| p[0] - 5.0 < d[0] && d[0] < p[2] + 5.0 && p[1] - 5.0 < d[1] && d[1] < p[3] + 5.0);
            usize::from(outside) * 1000 + names * 200 + hits.count() * 3
        };
        let best = boxes.into_iter().enumerate().min_by_key(|(n, p)| cost(p) * 40 + n).map_or([0.0; 4], |(_, p)| p);
        let middle = [0.5 * (best[0] + best[2]), 0.5 * (best[1] + best[3])];
        let end = [at[0].clamp(best[0], best[2]), middle[1]];
        c.line(&[at, end], LINE, 1.0, 0.75)?;
        c.rect([best[0], best[1]], [best[2], best[3]], 0xFFFFFF, 0.85)?;
        c.ring(at, 8.0, TEXT, 1.5)?;
        c.text(&house.name, [best[0] + 3.0, middle[1]], 13.0, TEXT, Align::Left)?;
        taken.push(best);
    }
    Ok(())
}

fn offsets(w: f64) -> [[f64; 2]; 16] {
    let near = [[14.0, -14.0], [-14.0 - w, 14.0], [14.0, 14.0], [-14.0 - w, -14.0]];
    std::array::from_fn(|n| {
        let far = 1.0 + (n / 4) as f64;
        let [x, y] = near[n % 4];
        [if x > 0.0 { x + 8.0 * (far - 1.0) } else { x - 8.0 * (far - 1.0) }, y * (1.0 + 1.5 * (far - 1.0))]
    })
}

/// All pairs of objectives: evaluated designs in grey, the front in colour; names of the axes on the diagonal.
///
/// # Errors
/// When drawing fails.
pub fn scatter_matrix(title: &str, axes: &[Axis], cloud: &Cloud) -> Result<String, PlotError> {
    let n = axes.len().max(1);
    let cell = if n <= 4 { 200.0 } else { 150.0 };
    let side = (90.0 + cell * n as f64 + 24.0) as u32;
    let ranges: Vec<[f64; 2]> = (0..axes.len()).map(|k| near(cloud, &[], k)).collect();
    svg([side, side + 20], |c| {
        c.text(title, [72.0, 24.0], 18.0, TEXT, Align::Left)?;
        let keys = [("front", 0x3B528B, 4.0, 0.95), ("evaluated", 0x9BA3AA, 2.5, 0.9)];
        for (n, (name, rgb, radius, alpha)) in keys.into_iter().enumerate() {
            let x = 78.0 + 90.0 * n as f64;
            c.dot([x, 44.0], radius, rgb, alpha)?;
            c.text(name, [x + 9.0, 44.0], 12.0, QUIET, Align::Left)?;
        }
        for (row, y) in axes.iter().enumerate() {
            for col in 0..axes.len() {
                let (l, t) = (72.0 + cell * col as f64, 62.0 + cell * row as f64);
                let at = [l, t, l + cell - 14.0, t + cell - 14.0];
                if row == col {
                    diagonal(c, at, y)?;
                    continue;
                }
                let frame = Frame { at, x: ranges[col], y: ranges[row] };
                frame.grid(
                    c,
                    [3, 4],
                    11.0,
                    [
                        row + 1 == axes.len() || (row + 2 == axes.len() && col + 1 == axes.len()),
                        col == 0 || (row == 0 && col == 1),
                    ],
                )?;
                frame.dots(c, &cloud.feasible, [col, row], (1.5, 0x9BA3AA, 0.5))?;
                frame.dots(c, &cloud.front, [col, row], (2.75, 0x3B528B, 0.95))?;
            }
        }
        Ok(())
    })
}

fn diagonal(c: &mut Canvas, [l, t, r, b]: [f64; 4], axis: &Axis) -> Result<(), PlotError> {
    let (x, y) = ((l + r) / 2.0, (t + b) / 2.0);
    let size = (15.0 * (r - l - 8.0) / width(&axis.title, 15.0).max(1.0)).min(15.0);
    c.text(&axis.title, [x, y - 12.0], size, TEXT, Align::Middle)?;
    c.text(&axis.unit, [x, y + 6.0], 12.0, QUIET, Align::Middle)?;
    c.text(if axis.maximise { "more is better" } else { "less is better" }, [x, y + 24.0], 11.0, QUIET, Align::Middle)
}
