//! Parallel coordinates of a front.

use super::canvas::{Align, LINE, PlotError, QUIET, TEXT, svg};
use super::{Axis, Cloud, Named, range, short, ticks};
use crate::export::viridis;

/// A line per design over one upright axis per objective; better is up on every axis. Front in colour by its first
/// objective, other feasible designs faintly behind (every n-th, at most 600), named houses on top with their names.
///
/// # Errors
/// When drawing fails.
pub fn parallel_coordinates(title: &str, axes: &[Axis], cloud: &Cloud, named: &[Named]) -> Result<String, PlotError> {
    let step = 170.0;
    let [left, top, bottom] = [80.0, 104.0, 480.0];
    let span = step * axes.len().saturating_sub(1) as f64;
    let of = |k: usize| move |row: &Vec<f64>| row.get(k).copied().unwrap_or(f64::NAN);
    let ranges: Vec<[f64; 2]> =
        (0..axes.len()).map(|k| range(cloud.front.iter().chain(named.iter().map(|n| &n.values)).map(of(k)))).collect();
    let place = |k: usize, v: f64| {
        let u = (v - ranges[k][0]) / (ranges[k][1] - ranges[k][0]);
        let up = if axes[k].maximise { u } else { 1.0 - u };
        [left + step * k as f64, bottom + up * (top - bottom)]
    };
    let path = |row: &Vec<f64>| -> Option<Vec<[f64; 2]>> {
        let inside = |k: usize| row.get(k).is_some_and(|v| (ranges[k][0]..=ranges[k][1]).contains(v));
        (0..axes.len()).all(inside).then(|| (0..axes.len()).map(|k| place(k, row[k])).collect())
    };
    svg([(left + span + 230.0) as u32, 540], |c| {
        c.text(title, [left - 40.0, 30.0], 20.0, TEXT, Align::Left)?;
        for row in cloud.feasible.iter().step_by(cloud.feasible.len() / 600 + 1) {
            if let Some(line) = path(row) {
                c.line(&line, 0xB9BEC3, 0.25, 0.75)?;
            }
        }
        let first = ranges.first().copied().unwrap_or([0.0, 1.0]);
        for row in &cloud.front {
            if let Some(line) = path(row) {
                let [r, g, b] = viridis((row[0] - first[0]) / (first[1] - first[0]) * 0.92).map(u32::from);
                c.line(&line, r << 16 | g << 8 | b, 0.75, 1.25)?;
            }
        }
        let lines: Vec<(&Named, Vec<[f64; 2]>)> = named.iter().filter_map(|n| Some((n, path(&n.values)?))).collect();
        for (_, line) in &lines {
            c.line(line, 0xFFFFFF, 1.0, 4.0)?;
            c.line(line, TEXT, 1.0, 2.0)?;
        }
        for (k, axis) in axes.iter().enumerate() {
            let x = left + step * k as f64;
            c.line(&[[x, top], [x, bottom]], LINE, 1.0, 1.25)?;
            c.text(&axis.title, [x, top - 40.0], 14.0, TEXT, Align::Middle)?;
            c.text(&axis.unit, [x, top - 22.0], 12.0, QUIET, Align::Middle)?;
            let (values, tick) = ticks(ranges[k], 5);
            for v in values {
                let at = place(k, v);
                c.line(&[at, [x - 4.0, at[1]]], LINE, 1.0, 1.0)?;
                let text = short(v, tick);
                let w = super::canvas::width(&text, 12.0);
                c.rect([x - 9.0 - w, at[1] - 7.0], [x - 5.0, at[1] + 7.0], 0xFFFFFF, 0.94)?;
                c.text(&text, [x - 7.0, at[1]], 12.0, QUIET, Align::Right)?;
            }
        }
        c.text(
            "up is better on every axis; colour by the first; grey: evaluated",
            [left - 40.0, 516.0],
            12.0,
            QUIET,
            Align::Left,
        )?;
        c.arrow([left - 56.0, bottom], [0.0, -1.0], 40.0, QUIET)?;
        c.upwards("better", [left - 56.0, bottom - 66.0], 12.0, QUIET)?;
        let ends: Vec<f64> = lines.iter().filter_map(|(_, l)| l.last().map(|p| p[1])).collect();
        for ((house, line), y) in lines.iter().zip(super::lines::apart(&ends, 17.0)) {
            let Some(end) = line.last() else { continue };
            c.line(&[*end, [end[0] + 14.0, y]], LINE, 1.0, 0.75)?;
            c.text(&house.name, [end[0] + 18.0, y], 13.0, TEXT, Align::Left)?;
        }
        Ok(())
    })
}
