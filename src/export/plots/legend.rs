//! A picture with the meaning of its colours below.

use super::canvas::{Align, LINE, PlotError, TEXT, draw_svg, pixmap, svg, to_png};
use super::sheet::paste;
use crate::export::picture::Image;

/// What the colours of a picture stand for.
#[derive(Clone, Debug, PartialEq)]
pub struct Legend {
    /// What is shown, with its unit.
    pub title: String,
    /// Colours as 0xRRGGBB with their words, from left to right.
    pub classes: Vec<(u32, String)>,
}

/// Height of the legend under a picture of a width of 1200 pixels; sizes go with the width, so that words stay as large beside it.
const HEIGHT: f64 = 140.0;

/// The bytes of a PNG: the picture, and below it a bar of the colours with their words.
///
/// # Errors
/// When the picture is empty or larger than 16384 pixels with its legend.
pub fn with_legend(image: &Image, legend: &Legend) -> Result<Vec<u8>, PlotError> {
    let [width, height] = image.size;
    let unit = width as f64 / 1200.0;
    let (w, h, strip) = (width as f64, height as f64, (HEIGHT * unit).ceil());
    let size = [width as u32, height as u32 + strip as u32];
    let mut sheet = pixmap(size)?;
    let words = svg(size, |c| {
        let [left, right] = [40.0 * unit, w - 40.0 * unit];
        let [top, bottom] = [h + 54.0 * unit, h + 88.0 * unit];
        c.text(&legend.title, [left, h + 28.0 * unit], 31.0 * unit, TEXT, Align::Left)?;
        let each = (right - left) / legend.classes.len().max(1) as f64;
        for (n, (colour, word)) in legend.classes.iter().enumerate() {
            let x = left + n as f64 * each;
            c.rect([x, top], [x + each, bottom], *colour, 1.0)?;
            c.text(word, [x + 0.5 * each, h + 112.0 * unit], 27.0 * unit, TEXT, Align::Middle)?;
        }
        let corners = [[left, top], [right, top], [right, bottom], [left, bottom], [left, top]];
        c.line(&corners, LINE, 1.0, unit)
    })?;
    draw_svg(&words, 1.0, &mut sheet)?;
    paste(&mut sheet, image, [0, 0]);
    to_png(&sheet)
}
