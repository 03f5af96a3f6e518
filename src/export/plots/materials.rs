//! Carbon against price, houses told apart by the materials of their frames.

use super::canvas::{Align, PlotError, QUIET, TEXT, svg};
use super::scatter::Frame;
use super::systems::{COLOURS, mark};
use super::{Axis, range};

/// A house with the materials of its frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Framed {
    /// Which of the materials, by place in their list.
    pub material: usize,
    /// Value on the level axis, such as the price.
    pub x: f64,
    /// Value on the upright axis, such as the carbon.
    pub y: f64,
}

/// A point for each house, a colour and shape for each of `materials`, with how many houses there are of each.
///
/// # Errors
/// When drawing fails.
pub fn by_material(
    title: &str,
    axes: [&Axis; 2],
    materials: &[String],
    houses: &[Framed],
) -> Result<String, PlotError> {
    let frame = Frame {
        at: [92.0, 64.0, 720.0, 600.0],
        x: range(houses.iter().map(|h| h.x)),
        y: range(houses.iter().map(|h| h.y)),
    };
    svg([960, 680], |c| {
        c.text(title, [92.0, 30.0], 20.0, TEXT, Align::Left)?;
        frame.grid(c, [6, 6], 13.0, [true, true])?;
        super::scatter::axis_titles(c, &frame, axes[0], axes[1])?;
        for house in houses {
            if let Some(at) = frame.place(house.x, house.y) {
                mark(c, at, house.material, true)?;
            }
        }
        c.text("frame of", [746.0, 78.0], 12.0, QUIET, Align::Left)?;
        for (n, material) in materials.iter().enumerate() {
            let y = 102.0 + 24.0 * n as f64;
            let count = houses.iter().filter(|h| h.material == n).count();
            mark(c, [754.0, y], n, true)?;
            let rgb = COLOURS[n % COLOURS.len()];
            c.text(&format!("{material} ({count})"), [768.0, y], 13.0, rgb, Align::Left)?;
        }
        Ok(())
    })
}
