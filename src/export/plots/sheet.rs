//! Contact sheet: the pictures of a front side by side.

use super::canvas::{Align, Canvas, LINE, PlotError, QUIET, TEXT, draw_svg, pixmap, svg, to_png};
use crate::export::picture::Image;

/// A house on the sheet.
#[derive(Clone, Debug, PartialEq)]
pub struct Card {
    /// First line under the picture, e.g. `12 cheapest`.
    pub title: String,
    /// Second line, e.g. `EUR 128k · 14.2 t CO2e · 86 m²`.
    pub caption: String,
    /// Its picture; all of one sheet should have the same size.
    pub image: Image,
}

impl Card {
    /// Writes both lines below a picture whose lower left corner is given.
    fn words(&self, c: &mut Canvas, below: [usize; 2]) -> Result<(), PlotError> {
        let [x, y] = below.map(|v| v as f64);
        c.text(&self.title, [x, y + 15.0], 17.0, TEXT, Align::Left)?;
        c.text(&self.caption, [x, y + 35.0], 15.0, QUIET, Align::Left)
    }
}

/// Space around pictures, and height of a caption, in pixels.
const GAP: usize = 18;
const CAPTION: usize = 46;
const HEAD: usize = 56;

/// Most pixels that a sheet is high; beyond, rows get longer.
const HIGHEST: usize = 16_000;

/// The bytes of a PNG with the cards in rows of `columns`, captions below; in longer rows where the sheet would become too high.
///
/// # Errors
/// When there are no cards or the sheet would be larger than 16384 pixels.
pub fn contact_sheet(title: &str, columns: usize, cards: &[Card]) -> Result<Vec<u8>, PlotError> {
    let cell = [0, 1].map(|a| cards.iter().map(|c| c.image.size[a]).max().unwrap_or(0));
    let most_rows = ((HIGHEST - HEAD) / (cell[1] + CAPTION + GAP)).max(1);
    let columns = columns.max(cards.len().div_ceil(most_rows)).clamp(1, cards.len().max(1));
    let rows = cards.len().div_ceil(columns);
    let size = [GAP + columns * (cell[0] + GAP), HEAD + rows * (cell[1] + CAPTION + GAP)].map(|s| s as u32);
    let mut sheet = pixmap(size)?;
    let corner = |n: usize| [GAP + n % columns * (cell[0] + GAP), HEAD + n / columns * (cell[1] + CAPTION + GAP)];
    let words = svg(size, |c| {
        c.text(title, [GAP as f64, 30.0], 22.0, TEXT, Align::Left)?;
        for (n, card) in cards.iter().enumerate() {
            let [x, y] = corner(n);
            card.words(c, [x, y + cell[1]])?;
        }
        Ok(())
    })?;
    draw_svg(&words, 1.0, &mut sheet)?;
    for (n, card) in cards.iter().enumerate() {
        paste(&mut sheet, &card.image, corner(n));
    }
    to_png(&sheet)
}

/// Houses that are shown together.
#[derive(Clone, Debug, PartialEq)]
pub struct Group {
    /// What they have in common, in words.
    pub heading: String,
    /// The houses.
    pub cards: Vec<Card>,
}

/// Height of a group's heading in pixels.
const HEADING: usize = 44;

/// The bytes of a PNG with the groups under each other, each in rows of `columns` below its heading.
///
/// # Errors
/// When the sheet would be larger than 16384 pixels.
pub fn grouped_sheet(title: &str, columns: usize, groups: &[Group]) -> Result<Vec<u8>, PlotError> {
    let columns = columns.max(1);
    let all = || groups.iter().flat_map(|g| &g.cards);
    let cell = [0, 1].map(|a| all().map(|c| c.image.size[a]).max().unwrap_or(0));
    let row = cell[1] + CAPTION + GAP;
    let mut tops = vec![HEAD];
    for group in groups {
        let top = tops.last().copied().unwrap_or(HEAD);
        tops.push(top + HEADING + group.cards.len().div_ceil(columns) * row);
    }
    let height = tops.last().copied().unwrap_or(HEAD) + GAP;
    let size = [GAP + columns * (cell[0] + GAP), height].map(|s| s as u32);
    let place =
        |group: usize, n: usize| [GAP + n % columns * (cell[0] + GAP), tops[group] + HEADING + n / columns * row];
    let mut sheet = pixmap(size)?;
    let words = svg(size, |c| {
        c.text(title, [GAP as f64, 30.0], 22.0, TEXT, Align::Left)?;
        for (g, group) in groups.iter().enumerate() {
            let top = tops[g] as f64;
            let right = f64::from(size[0]) - GAP as f64;
            c.line(&[[GAP as f64, top + 2.0], [right, top + 2.0]], LINE, 1.0, 1.0)?;
            c.text(&group.heading, [GAP as f64, top + 24.0], 19.0, TEXT, Align::Left)?;
            for (n, card) in group.cards.iter().enumerate() {
                let [x, y] = place(g, n);
                card.words(c, [x, y + cell[1]])?;
            }
        }
        Ok(())
    })?;
    draw_svg(&words, 1.0, &mut sheet)?;
    for (g, group) in groups.iter().enumerate() {
        for (n, card) in group.cards.iter().enumerate() {
            paste(&mut sheet, &card.image, place(g, n));
        }
    }
    to_png(&sheet)
}

/// Copies a picture into a sheet that it fits into.
pub(super) fn paste(sheet: &mut resvg::tiny_skia::Pixmap, image: &Image, [left, top]: [usize; 2]) {
    let stride = sheet.width() as usize * 4;
    let data = sheet.data_mut();
    for y in 0..image.size[1] {
        let start = (top + y) * stride + left * 4;
        let row = &mut data[start..start + image.size[0] * 4];
        for (x, pixel) in row.chunks_exact_mut(4).enumerate() {
            let [r, g, b] = image.get([x, y]);
            pixel.copy_from_slice(&[r, g, b, 255]);
        }
    }
}
