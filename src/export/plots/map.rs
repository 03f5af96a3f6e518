//! The map of a quality-diversity search: a picture of the best house in the cell of each kind.

use super::canvas::{Align, Canvas, FINE, GRID, LINE, PlotError, QUIET, TEXT, draw_svg, pixmap, svg, to_png};
use super::sheet::paste;
use crate::export::picture::Image;
use crate::export::viridis;

/// A row or a column.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Heading {
    /// What neighbours of the same group share, e.g. `2 storeys`; written once.
    pub group: String,
    /// Its own class, e.g. `L`.
    pub name: String,
}

/// A cell in which a house was found.
#[derive(Clone, Debug, PartialEq)]
pub struct MapCell {
    /// Row and column.
    pub at: [usize; 2],
    /// Two short lines below the picture.
    pub caption: [String; 2],
    /// How good it is among all cells, 0 = worst, 1 = best: the colour of the bar below the picture.
    pub worth: f64,
    /// Its picture, of [`DiversityMap::PICTURE`] pixels.
    pub image: Image,
}

/// A map of elites.
#[derive(Clone, Debug, PartialEq)]
pub struct DiversityMap {
    /// Title.
    pub title: String,
    /// A line below it: what makes a house the best of its cell.
    pub note: String,
    /// Rows from the top.
    pub rows: Vec<Heading>,
    /// Columns from the left.
    pub columns: Vec<Heading>,
    /// The cells that hold a house.
    pub cells: Vec<MapCell>,
}

impl DiversityMap {
    /// Pixels of a picture.
    pub const PICTURE: [usize; 2] = [176, 132];
}

const GAP: usize = 12;
const CAPTION: usize = 42;
const BAR: f64 = 4.0;
const TOP: usize = 132;
const LEFT: usize = 150;

/// The SVG of a map, its pictures inside, and the bytes of the same as PNG.
///
/// # Errors
/// When the map would be larger than 16384 pixels, or a picture cannot be encoded.
pub fn diversity_map(map: &DiversityMap) -> Result<(String, Vec<u8>), PlotError> {
    let [wide, high] = DiversityMap::PICTURE;
    let pitch = [wide + GAP, high + CAPTION + GAP];
    let size = [LEFT + map.columns.len() * pitch[0] + GAP, TOP + map.rows.len() * pitch[1] + GAP].map(|s| s as u32);
    let corner = |[row, column]: [usize; 2]| [LEFT + column * pitch[0], TOP + row * pitch[1]];
    let words = svg(size, |c| {
        c.text(&map.title, [GAP as f64, 26.0], 20.0, TEXT, Align::Left)?;
        c.text(&map.note, [GAP as f64, 50.0], 14.0, QUIET, Align::Left)?;
        headings(c, map, pitch, size)?;
        for place in (0..map.rows.len()).flat_map(|r| (0..map.columns.len()).map(move |c| [r, c])) {
            let [x, y] = corner(place).map(|v| v as f64);
            let cell = map.cells.iter().find(|cell| cell.at == place);
            let Some(cell) = cell else {
                c.rect([x, y], [x + wide as f64, y + high as f64], GRID, 0.45)?;
                continue;
            };
            let below = y + high as f64;
            let [r, g, b] = viridis(cell.worth);
            let rgb = u32::from(r) << 16 | u32::from(g) << 8 | u32::from(b);
            c.rect([x, below], [x + wide as f64, below + BAR], rgb, 1.0)?;
            c.text(&cell.caption[0], [x, below + 15.0], 13.0, TEXT, Align::Left)?;
            c.text(&cell.caption[1], [x, below + 32.0], 12.0, QUIET, Align::Left)?;
        }
        Ok(())
    })?;
    let mut sheet = pixmap(size)?;
    draw_svg(&words, 1.0, &mut sheet)?;
    let mut pictures = String::new();
    for cell in &map.cells {
        let [x, y] = corner(cell.at);
        paste(&mut sheet, &cell.image, [x, y]);
        pictures += &format!(
            "<image x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" href=\"data:image/png;base64,{}\"/>\n",
            x as f64 * FINE,
            y as f64 * FINE,
            cell.image.size[0] as f64 * FINE,
            cell.image.size[1] as f64 * FINE,
            base64(&cell.image.to_png()?)
        );
    }
    let text = words.replacen("</svg>", &format!("{pictures}</svg>"), 1);
    Ok((text, to_png(&sheet)?))
}

/// Groups and classes of columns above, of rows at the left, with a line where a group begins.
fn headings(c: &mut Canvas, map: &DiversityMap, pitch: [usize; 2], size: [u32; 2]) -> Result<(), PlotError> {
    let begins = |all: &[Heading], n: usize| n == 0 || all[n - 1].group != all[n].group;
    for (n, heading) in map.columns.iter().enumerate() {
        let x = (LEFT + n * pitch[0]) as f64;
        if begins(&map.columns, n) {
            let edge = x - GAP as f64 / 2.0;
            c.line(&[[edge, TOP as f64 - 54.0], [edge, f64::from(size[1])]], LINE, 0.8, 1.0)?;
            c.text(&heading.group, [x, TOP as f64 - 42.0], 16.0, TEXT, Align::Left)?;
        }
        c.text(&heading.name, [x, TOP as f64 - 18.0], 13.0, QUIET, Align::Left)?;
    }
    for (n, heading) in map.rows.iter().enumerate() {
        let y = (TOP + n * pitch[1]) as f64;
        if begins(&map.rows, n) {
            let edge = y - GAP as f64 / 2.0;
            c.line(&[[GAP as f64, edge], [f64::from(size[0]), edge]], LINE, 0.8, 1.0)?;
            c.text(&heading.group, [GAP as f64, y + 12.0], 16.0, TEXT, Align::Left)?;
        }
        c.text(&heading.name, [GAP as f64, y + 36.0], 13.0, QUIET, Align::Left)?;
    }
    Ok(())
}

/// Base64 (RFC 4648 section 4), as data URLs want it.
fn base64(bytes: &[u8]) -> String {
    const LETTERS: &[u8; 64] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    let mut out = String::with_capacity(bytes.len().div_ceil(3) * 4);
    for chunk in bytes.chunks(3) {
        let word = (0..3).fold(0u32, |word, i| word << 8 | u32::from(chunk.get(i).copied().unwrap_or(0)));
        for i in 0..4 {
            let letter = LETTERS[(word >> (18 - 6 * i) & 63) as usize] as char;
            out.push(if i <= chunk.len() { letter } else { '=' });
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::base64;

    /// The test vectors of RFC 4648 section 10.
    #[test]
    fn base64_of_the_standard() {
        let pairs =
            [("", ""), ("f", "Zg=="), ("fo", "Zm8="), ("foo", "Zm9v"), ("foob", "Zm9vYg=="), ("foobar", "Zm9vYmFy")];
        pairs.iter().for_each(|(plain, coded)| assert_eq!(base64(plain.as_bytes()), *coded));
    }
}
