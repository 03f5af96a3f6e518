//! A whole front in several systems: price against carbon, a point for each house and system.

use super::canvas::{Align, Canvas, GRID, LINE, PlotError, QUIET, TEXT, svg, width};
use super::{range, short, ticks};

/// A house in one system.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SystemPoint {
    /// Price: low, default, high.
    pub price: [f64; 3],
    /// Carbon: low, default, high.
    pub carbon: [f64; 3],
    /// Whether it stands; drawn hollow otherwise.
    pub stands: bool,
}

/// A house in all systems.
#[derive(Clone, Debug, PartialEq)]
pub struct SystemHouse {
    /// As printed.
    pub name: String,
    /// In the order of the systems; none where it was not assessed.
    pub points: Vec<Option<SystemPoint>>,
}

/// Colours that differ in lightness as well (Okabe and Ito 2008), each with a shape of its own.
pub(super) const COLOURS: [u32; 6] = [0x0072B2, 0xD55E00, 0x009E73, 0xCC79A7, 0x56B4E9, 0x4D4D4D];
/// Houses of which every one is named and has its ranges drawn.
const FEW: usize = 10;
/// Sheet in pixels, and the axes' left, top, right and bottom.
const SIZE: [u32; 2] = [1080, 720];
const AT: [f64; 4] = [92.0, 100.0, 900.0, 640.0];

/// Price in EUR, carbon in kgCO2e: the points of a house are joined, those of a system share colour and shape and are named beside
/// themselves. Ranges are drawn of every house of a short front, else of the house in the middle of each system's prices.
///
/// # Errors
/// When drawing fails.
pub fn systems_front(title: &str, systems: &[String], houses: &[SystemHouse]) -> Result<String, PlotError> {
    let ranged: Vec<(usize, usize)> = match houses.len() {
        n if n <= FEW => (0..n).flat_map(|h| (0..systems.len()).map(move |s| (h, s))).collect(),
        _ => (0..systems.len()).filter_map(|s| Some((middle(houses, s)?, s))).collect(),
    };
    let at = |(h, s): (usize, usize)| houses[h].points.get(s).copied().flatten();
    let all = || houses.iter().flat_map(|h| h.points.iter().flatten());
    let wide = || ranged.iter().filter_map(|&p| at(p));
    let x = range(all().map(|p| p.price[1]).chain(wide().flat_map(|p| p.price)));
    let y = range(all().map(|p| p.carbon[1]).chain(wide().flat_map(|p| p.carbon)));
    let [l, t, r, b] = AT;
    let place = |price: f64, carbon: f64| {
        [l + (price - x[0]) / (x[1] - x[0]) * (r - l), b + (carbon - y[0]) / (y[1] - y[0]) * (t - b)]
    };
    let default = |p: &SystemPoint| place(p.price[1], p.carbon[1]);
    svg(SIZE, |c| {
        c.text(title, [l, 30.0], 20.0, TEXT, Align::Left)?;
        let told = if houses.len() <= FEW { "every house" } else { "the house in the middle of each system's prices" };
        let notes = [
            "a line joins the same house in each system; hollow: does not stand".to_owned(),
            format!("bars: from low to high of all rates and factors at once, of {told}"),
        ];
        for (n, note) in notes.iter().enumerate() {
            c.text(note, [l, 54.0 + 18.0 * n as f64], 13.0, QUIET, Align::Left)?;
        }
        axes(c, x, y)?;
        for house in houses {
            let line: Vec<[f64; 2]> = house.points.iter().flatten().map(default).collect();
            c.line(&line, 0xAEB4BA, 0.55, 1.0)?;
        }
        for &(h, s) in &ranged {
            let Some(p) = at((h, s)) else { continue };
            let alpha = if houses.len() <= FEW { 0.35 } else { 0.9 };
            bars(c, &p, COLOURS[s % COLOURS.len()], alpha, &place)?;
        }
        for house in houses {
            for (s, p) in house.points.iter().enumerate().filter_map(|(s, p)| Some((s, p.as_ref()?))) {
                mark(c, default(p), s, p.stands)?;
            }
        }
        name_houses(c, houses, &default)?;
        name_systems(c, systems, houses, &default)
    })
}

/// The house whose price in a system is the middle one of those that stand.
fn middle(houses: &[SystemHouse], system: usize) -> Option<usize> {
    let price = |h: usize| houses[h].points.get(system).copied().flatten().filter(|p| p.stands).map(|p| p.price[1]);
    let mut standing: Vec<(usize, f64)> = (0..houses.len()).filter_map(|h| Some((h, price(h)?))).collect();
    standing.sort_by(|a, b| a.1.total_cmp(&b.1).then(a.0.cmp(&b.0)));
    standing.get(standing.len() / 2).map(|(h, _)| *h)
}

fn axes(c: &mut Canvas, x: [f64; 2], y: [f64; 2]) -> Result<(), PlotError> {
    let [l, t, r, b] = AT;
    let (values, step) = ticks(x, 7);
    for v in values {
        let u = l + (v - x[0]) / (x[1] - x[0]) * (r - l);
        c.line(&[[u, t], [u, b]], GRID, 1.0, 0.75)?;
        c.text(&short(v, step), [u, b + 15.0], 13.0, QUIET, Align::Middle)?;
    }
    let (values, step) = ticks(y, 6);
    for v in values {
        let u = b + (v - y[0]) / (y[1] - y[0]) * (t - b);
        c.line(&[[l, u], [r, u]], GRID, 1.0, 0.75)?;
        c.text(&short(v, step), [l - 7.0, u], 13.0, QUIET, Align::Right)?;
    }
    c.line(&[[l, t], [l, b], [r, b]], LINE, 1.0, 1.0)?;
    c.text("Price in place, net of VAT [EUR]", [(l + r) / 2.0, b + 44.0], 15.0, TEXT, Align::Middle)?;
    c.upwards("Fossil carbon A1-A3 [kgCO2e]", [l - 66.0, (t + b) / 2.0], 15.0, TEXT)?;
    c.arrow([r, b + 44.0], [-1.0, 0.0], 34.0, QUIET)?;
    c.text("better", [r - 42.0, b + 44.0], 12.0, QUIET, Align::Right)?;
    c.arrow([l - 66.0, b - 34.0], [0.0, 1.0], 34.0, QUIET)?;
    c.upwards("better", [l - 66.0, b - 62.0], 12.0, QUIET)
}

fn bars(
    c: &mut Canvas,
    p: &SystemPoint,
    rgb: u32,
    alpha: f64,
    place: &dyn Fn(f64, f64) -> [f64; 2],
) -> Result<(), PlotError> {
    let across = [place(p.price[0], p.carbon[1]), place(p.price[2], p.carbon[1])];
    let upright = [place(p.price[1], p.carbon[0]), place(p.price[1], p.carbon[2])];
    c.line(&across, rgb, alpha, 1.5)?;
    c.line(&upright, rgb, alpha, 1.5)?;
    for [u, v] in across {
        c.line(&[[u, v - 4.0], [u, v + 4.0]], rgb, alpha, 1.5)?;
    }
    for [u, v] in upright {
        c.line(&[[u - 4.0, v], [u + 4.0, v]], rgb, alpha, 1.5)?;
    }
    Ok(())
}

/// The shape of a system around a place, as far as `size`.
fn shape(system: usize, [u, v]: [f64; 2], size: f64) -> Vec<[f64; 2]> {
    let corner = |n: usize, of: usize, turn: f64| {
        let angle = std::f64::consts::TAU * (n as f64 + turn) / of as f64;
        [u + size * angle.sin(), v - size * angle.cos()]
    };
    match system % COLOURS.len() {
        0 => (0..24).map(|n| corner(n, 24, 0.0)).collect(),
        1 => (0..4).map(|n| corner(n, 4, 0.5)).collect(),
        2 => (0..3).map(|n| corner(n, 3, 0.0)).collect(),
        3 => (0..4).map(|n| corner(n, 4, 0.0)).collect(),
        4 => (0..3).map(|n| corner(n, 3, 0.5)).collect(),
        _ => (0..6).map(|n| corner(n, 6, 0.0)).collect(),
    }
}

/// The mark of a system at a place.
pub(super) fn mark(c: &mut Canvas, at: [f64; 2], system: usize, stands: bool) -> Result<(), PlotError> {
    c.polygon(&shape(system, at, 7.5), 0xFFFFFF, 1.0)?;
    c.polygon(&shape(system, at, 6.0), COLOURS[system % COLOURS.len()], 1.0)?;
    if !stands {
        c.polygon(&shape(system, at, 4.0), 0xFFFFFF, 1.0)?;
    }
    Ok(())
}

/// Every house of a short front, else the cheapest and the dearest, at its leftmost point.
fn name_houses(
    c: &mut Canvas,
    houses: &[SystemHouse],
    default: &dyn Fn(&SystemPoint) -> [f64; 2],
) -> Result<(), PlotError> {
    let ends: Vec<(usize, [f64; 2])> = houses
        .iter()
        .enumerate()
        .filter_map(|(h, house)| {
            Some((h, house.points.iter().flatten().map(default).min_by(|a, b| a[0].total_cmp(&b[0]))?))
        })
        .collect();
    let side = |a: &&(usize, [f64; 2]), b: &&(usize, [f64; 2])| a.1[0].total_cmp(&b.1[0]);
    let mut shown: Vec<(usize, [f64; 2])> = match houses.len() {
        n if n <= FEW => ends,
        _ => [ends.iter().min_by(side), ends.iter().max_by(side)].into_iter().flatten().copied().collect(),
    };
    shown.dedup_by_key(|(h, _)| *h);
    for (h, [u, v]) in shown {
        let text = format!("house {}", houses[h].name);
        let w = width(&text, 12.0);
        c.rect([u - 12.0 - w, v - 21.0], [u - 4.0, v - 5.0], 0xFFFFFF, 0.8)?;
        c.text(&text, [u - 8.0, v - 13.0], 12.0, TEXT, Align::Right)?;
    }
    Ok(())
}

/// Each system at the right of the sheet, level with its rightmost point.
fn name_systems(
    c: &mut Canvas,
    systems: &[String],
    houses: &[SystemHouse],
    default: &dyn Fn(&SystemPoint) -> [f64; 2],
) -> Result<(), PlotError> {
    let rightmost = |s: usize| {
        let own = houses.iter().filter_map(|h| h.points.get(s).copied().flatten());
        own.map(|p| default(&p)).max_by(|a, b| a[0].total_cmp(&b[0]))
    };
    let ends: Vec<(usize, [f64; 2])> = (0..systems.len()).filter_map(|s| Some((s, rightmost(s)?))).collect();
    let heights: Vec<f64> = ends.iter().map(|(_, p)| p[1]).collect();
    for ((s, end), v) in ends.iter().zip(super::lines::apart(&heights, 24.0)) {
        let rgb = COLOURS[s % COLOURS.len()];
        c.line(&[[end[0] + 8.0, end[1]], [AT[2] + 10.0, v]], rgb, 0.5, 1.0)?;
        mark(c, [AT[2] + 20.0, v], *s, true)?;
        c.text(&systems[*s], [AT[2] + 32.0, v], 15.0, rgb, Align::Left)?;
    }
    Ok(())
}
