//! Arrangements of snow on the roofs of a plan (EN 1991-1-3 5.3): what a half module of roof carries besides the even load.
//!
//! Exceptional falls and drifts (annex B) are accidental and left out.

use super::loads::LoadSettings;
use super::plan::{LEVEL, Plan, Step, face};
use crate::frame::Area;
use crate::voxels::Direction;

/// Sides of a body whose snow is halved in the first and second one-sided arrangement: the main pair of its slopes (that with
/// more cells), first towards +x or +y, second towards -x or -y. `None` where only one side slopes (monopitch).
pub(super) fn main_pair(slopes: [u32; 4]) -> Option<[Direction; 2]> {
    let pair = |a: usize| slopes[a] + slopes[a + 2];
    let axis = usize::from(pair(1) > pair(0));
    let both = slopes[axis] > 0 && slopes[axis + 2] > 0;
    both.then(|| [Direction::ALL[axis], Direction::ALL[axis + 2]])
}

/// Share of an area whose snow each of the two one-sided arrangements halves.
pub(super) fn halved(plan: &Plan, area: Area, step: &Step) -> [f64; 2] {
    let Area::Slope(d) = area else { return [0.0; 2] };
    let cell = plan.cell(step.cell);
    let Some(pair) = main_pair(plan.body(cell).slopes) else { return [0.0; 2] };
    let slopes = plan.slopes_of(cell, d);
    pair.map(|p| f64::from(u32::from(slopes >> (p as u8) & 1)) / f64::from(slopes.count_ones().max(1)))
}

/// Snow that drifts onto a half module of roof beyond what lies there evenly (`even`, N/m2): in valleys (5.3.4) and at taller
/// parts of the house (5.3.6), the larger of both, N/m2 of plan.
pub(super) fn drifted(plan: &Plan, loads: &LoadSettings, pitch: f64, area: Area, step: &Step, even: f64) -> f64 {
    let cell = plan.cell(step.cell);
    if step.z < cell.top - 1.3 {
        return 0.0;
    }
    let mut most = even;
    if let Area::Slope(d) = area {
        most = most.max(valley(plan, loads, pitch, d, step));
    }
    for d in Direction::ALL {
        most = most.max(at_wall(plan, loads, pitch, area, d, step));
    }
    most - even
}

/// Load on a slope that falls into a valley: mu1 at its upper end, mu2 in the valley.
fn valley(plan: &Plan, loads: &LoadSettings, pitch: f64, d: Direction, step: &Step) -> f64 {
    let bit = 1 << d as u8;
    let (foot, head) = (plan.end_of(step.cell, d, bit), plan.end_of(step.cell, d.back(), bit));
    let s = d.step().map(|s| s as i32);
    let beyond = plan.cell([foot[0] + s[0], foot[1] + s[1]]);
    // Down-slope of the foot the same body rises again, or its own cell carries the slope across the valley.
    let rises = |faces: u8| faces & 0xf & !bit != 0;
    let (here, axis) = (plan.cell(foot), d as usize % 2);
    let joined = plan.joined(here, beyond) && rises(beyond.faces);
    if !joined {
        return 0.0;
    }
    let length = f64::from((foot[axis] - head[axis]).abs()) + 0.5;
    let middle = 0.5 * (step.rect[axis][0] + step.rect[axis][1]) / plan.module[axis];
    let t = ((middle - (f64::from(head[axis]) + 0.5)) * f64::from(s[axis]) / length).clamp(0.0, 1.0);
    let (mu1, mu2) = (loads.mu1(pitch), loads.mu2(pitch));
    loads.sk * (mu1 + t * (mu2 - mu1))
}

/// Load on a roof that abuts a taller part of the house in direction `d`: triangular over the drift length.
fn at_wall(plan: &Plan, loads: &LoadSettings, pitch: f64, area: Area, d: Direction, step: &Step) -> f64 {
    let cell = plan.cell(step.cell);
    let (axis, up) = (d as usize % 2, (d as usize) < 2);
    let edges = plan.edges(cell, axis);
    let wall = if up { edges[1] } else { edges[0] };
    let s = d.step().map(|s| s as i32);
    let mut beyond = step.cell;
    beyond[axis] = (wall / plan.module[axis]).round() as i32 - i32::from(!up);
    let taller = plan.cell(beyond);
    let mut foot = beyond;
    foot[axis] -= s[axis];
    let above = taller.top - plan.cell(foot).top;
    if !taller.top.is_finite() || above < 1.3 {
        return 0.0;
    }
    let upper = plan.edges(taller, axis);
    // Plan length of the upper slope that falls towards this roof.
    let bit = 1u8 << d.back() as u8;
    let slope = if taller.faces & bit != 0 {
        let head = plan.end_of(beyond, d, bit);
        (f64::from(((head[axis] - beyond[axis]) * s[axis]).abs()) + 0.5) * plan.module[axis]
    } else {
        0.0
    };
    let [b1, b2] = [upper[1] - upper[0], edges[1] - edges[0]];
    let [peak, length] = loads.drift(above, b1, b2, slope, pitch);
    let middle = 0.5 * (step.rect[axis][0] + step.rect[axis][1]);
    let x = (wall - middle).abs();
    if x >= length {
        return 0.0;
    }
    let level = face(area) == Some(LEVEL) || area == Area::Plateau;
    let even = loads.snow(if level { 0.0 } else { pitch });
    peak + (even - peak) * x / length
}
