//! The plan of a quadrant, cut into convex cells in each of which the same strata stand.

use super::column::{Half, Post};
use super::field::Field;
use super::heights::HALF_PLAN_UM;
use super::sides::{Metric, Sides, Spot};
use super::strata::{Reach, total};
use crate::voxels::Label;

/// A convex polygon in (a, b), counter-clockwise, multiples of 5 µm.
pub(super) type Polygon = Vec<[i32; 2]>;

/// The spot in the middle of a polygon.
pub(super) fn centre(polygon: &[[i32; 2]]) -> Spot {
    let sum = [0, 1].map(|axis| polygon.iter().map(|p| i64::from(p[axis])).sum());
    Spot { sum, count: polygon.len() as i64 }
}

/// The cells of column q: between lines at the strata's depths from its sides, and along the diagonal where walls mitre or a roof
/// folds.
pub(super) fn cells(field: &Field, q: usize, sides: &Sides) -> Vec<Polygon> {
    let cut = |metric: Metric| sides.metrics().any(|m| m == metric || m == Metric::Both);
    let [x, y] = [cut(Metric::X), cut(Metric::Y)];
    let folds = field.columns.post(q) == Post::Roof && field.heights.folds(q);
    let lines = if field.columns.post(q) == Post::Deck { vec![0, sides.edge, HALF_PLAN_UM] } else { depths(field, q) };
    let along = |cut: bool| if cut { lines.clone() } else { vec![0, HALF_PLAN_UM] };
    let mitres = x && y;
    let (xs, ys) = (along(x || (y && folds)), along(y || (x && folds)));
    let mut cells = Vec::with_capacity(2 * xs.len() * ys.len());
    for (j, b) in ys.windows(2).enumerate() {
        for (i, a) in xs.windows(2).enumerate() {
            let [low, east, high, north] = [[a[0], b[0]], [a[1], b[0]], [a[1], b[1]], [a[0], b[1]]];
            if i == j && (mitres || folds) {
                cells.push(vec![low, east, high]);
                cells.push(vec![low, high, north]);
            } else {
                cells.push(vec![low, east, high, north]);
            }
        }
    }
    cells
}

/// Depths at which strata of column q begin or end, with both ends of the quadrant.
fn depths(field: &Field, q: usize) -> Vec<i32> {
    let (columns, strata) = (field.columns, &field.strata);
    let labels = match columns.post(q) {
        Post::Full => [columns.wall_label(q, Half::Lower), columns.wall_label(q, Half::Upper)],
        Post::Floor => [columns.above(q); 2],
        Post::Roof | Post::Deck | Post::Empty => [columns.below(q); 2],
    };
    let mut depths = vec![0, HALF_PLAN_UM];
    let mut add = |stack: &[Reach]| depths.extend(stack.iter().map(|(_, depth)| *depth));
    if labels.contains(&Label::Foundation) {
        add(&strata.edge);
    }
    if labels.iter().any(|l| *l != Label::Foundation) {
        add(&strata.wall);
    }
    depths.push(total(&strata.wall));
    depths.retain(|d| (0..=HALF_PLAN_UM).contains(d));
    depths.sort_unstable();
    depths.dedup();
    depths
}
