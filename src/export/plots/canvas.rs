//! A sheet in pixels over plotters' SVG backend, and its way to PNG.

use std::sync::{Arc, OnceLock};

use plotters::backend::{DrawingBackend, SVGBackend};
use plotters::style::text_anchor::{HPos, Pos, VPos};
use plotters::style::{Color, FontTransform, IntoTextStyle, RGBAColor, ShapeStyle};
use resvg::{tiny_skia, usvg};

use crate::export::picture::ImageError;

/// Why a plot could not be drawn.
#[derive(Debug, thiserror::Error)]
pub enum PlotError {
    /// plotters refused.
    #[error("drawing the plot: {0}")]
    Drawing(String),
    /// The SVG could not be read back.
    #[error("reading the SVG of a plot: {0}")]
    Svg(#[from] usvg::Error),
    /// A size out of range.
    #[error("a picture of {width} x {height} pixels cannot be made; expected 1 to 16384 each")]
    Size {
        /// Pixels across.
        width: u32,
        /// Pixels down.
        height: u32,
    },
    /// PNG could not be encoded.
    #[error(transparent)]
    Png(#[from] ImageError),
}

/// Backend units a pixel.
pub const FINE: f64 = 4.0;

/// The font of our plots first, then what a browser has.
const FAMILY: &str = "Ubuntu, 'Segoe UI', 'Helvetica Neue', Arial, sans-serif";

/// Colours of the furniture, 0xRRGGBB.
pub const TEXT: u32 = 0x2B2F33;
pub const QUIET: u32 = 0x6A7076;
pub const GRID: u32 = 0xE3E5E8;
pub const LINE: u32 = 0x9AA0A6;

/// Horizontal alignment of text.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Align {
    /// Starts at the place.
    Left,
    /// Centred on it.
    Middle,
    /// Ends at it.
    Right,
}

/// Draws in pixels from the top left.
pub struct Canvas<'a> {
    backend: SVGBackend<'a>,
}

/// The SVG of what `draw` draws on a white sheet of `size` pixels.
pub fn svg(size: [u32; 2], draw: impl FnOnce(&mut Canvas) -> Result<(), PlotError>) -> Result<String, PlotError> {
    let mut text = String::new();
    let fine = size.map(|s| s * FINE as u32);
    {
        let mut canvas = Canvas { backend: SVGBackend::with_string(&mut text, (fine[0], fine[1])) };
        canvas.rect([0.0, 0.0], [f64::from(size[0]), f64::from(size[1])], 0xFFFFFF, 1.0)?;
        draw(&mut canvas)?;
        canvas.backend.present().map_err(refused)?;
    }
    let head = format!("width=\"{}\" height=\"{}\"", fine[0], fine[1]);
    let text = text.replacen(&head, &format!("width=\"{}\" height=\"{}\"", size[0], size[1]), 1);
    Ok(text.replace("font-family=\"sans-serif\"", &format!("font-family=\"{FAMILY}\"")))
}

fn refused<E: std::fmt::Display>(error: E) -> PlotError {
    PlotError::Drawing(error.to_string())
}

fn fine([x, y]: [f64; 2]) -> (i32, i32) {
    ((x * FINE).round() as i32, (y * FINE).round() as i32)
}

fn colour(rgb: u32, alpha: f64) -> RGBAColor {
    RGBAColor((rgb >> 16 & 255) as u8, (rgb >> 8 & 255) as u8, (rgb & 255) as u8, alpha)
}

fn flat(rgb: u32, alpha: f64) -> ShapeStyle {
    colour(rgb, alpha).filled()
}

impl Canvas<'_> {
    /// A filled rectangle.
    pub fn rect(&mut self, from: [f64; 2], to: [f64; 2], rgb: u32, alpha: f64) -> Result<(), PlotError> {
        self.backend.draw_rect(fine(from), fine(to), &flat(rgb, alpha), true).map_err(refused)
    }

    /// A line through points.
    pub fn line(&mut self, points: &[[f64; 2]], rgb: u32, alpha: f64, width: f64) -> Result<(), PlotError> {
        let style = colour(rgb, alpha).stroke_width((width * FINE).round().max(1.0) as u32);
        self.backend.draw_path(points.iter().map(|p| fine(*p)), &style).map_err(refused)
    }

    /// A filled polygon.
    pub fn polygon(&mut self, points: &[[f64; 2]], rgb: u32, alpha: f64) -> Result<(), PlotError> {
        self.backend.fill_polygon(points.iter().map(|p| fine(*p)), &flat(rgb, alpha)).map_err(refused)
    }

    /// A disc.
    pub fn dot(&mut self, at: [f64; 2], radius: f64, rgb: u32, alpha: f64) -> Result<(), PlotError> {
        self.backend.draw_circle(fine(at), (radius * FINE).round() as u32, &flat(rgb, alpha), true).map_err(refused)
    }

    /// A circle's outline.
    pub fn ring(&mut self, at: [f64; 2], radius: f64, rgb: u32, width: f64) -> Result<(), PlotError> {
        let style = colour(rgb, 1.0).stroke_width((width * FINE).round() as u32);
        self.backend.draw_circle(fine(at), (radius * FINE).round() as u32, &style, false).map_err(refused)
    }

    /// Text with its vertical middle at the place.
    pub fn text(&mut self, text: &str, at: [f64; 2], size: f64, rgb: u32, align: Align) -> Result<(), PlotError> {
        self.write(text, at, size, rgb, align, FontTransform::None)
    }

    /// Text that reads upwards, centred on the place.
    pub fn upwards(&mut self, text: &str, at: [f64; 2], size: f64, rgb: u32) -> Result<(), PlotError> {
        self.write(text, at, size, rgb, Align::Middle, FontTransform::Rotate270)
    }

    fn write(
        &mut self,
        text: &str,
        at: [f64; 2],
        size: f64,
        rgb: u32,
        align: Align,
        turn: FontTransform,
    ) -> Result<(), PlotError> {
        let h = match align {
            Align::Left => HPos::Left,
            Align::Middle => HPos::Center,
            Align::Right => HPos::Right,
        };
        // plotters writes size / 1.24; the vertical middle is set here because its own leans on `ex`.
        let ink = colour(rgb, 1.0);
        let style = ("sans-serif", size * FINE * 1.24).into_text_style(&(1u32, 1u32)).color(&ink);
        let mut style = style.pos(Pos::new(h, VPos::Center));
        style.font = style.font.transform(turn);
        self.backend.draw_text(text, &style, fine(at)).map_err(refused)
    }

    /// A small arrow from a place along a direction (unit steps), with a head.
    pub fn arrow(&mut self, from: [f64; 2], [dx, dy]: [f64; 2], length: f64, rgb: u32) -> Result<(), PlotError> {
        let tip = [from[0] + dx * length, from[1] + dy * length];
        self.line(&[from, [tip[0] - dx * 4.0, tip[1] - dy * 4.0]], rgb, 1.0, 1.25)?;
        let back = [tip[0] - dx * 7.0, tip[1] - dy * 7.0];
        self.polygon(
            &[tip, [back[0] - dy * 3.0, back[1] + dx * 3.0], [back[0] + dy * 3.0, back[1] - dx * 3.0]],
            rgb,
            1.0,
        )
    }
}

/// Width of a text in our font, in pixels, good to about five hundredths: enough to keep labels apart.
pub fn width(text: &str, size: f64) -> f64 {
    let em = |c: char| match c {
        'i' | 'j' | 'l' | '.' | ',' | ':' | ';' | '\'' | '|' | '!' | 'I' => 0.25,
        ' ' | 'f' | 't' | 'r' | '(' | ')' | '[' | ']' | '-' => 0.36,
        'm' | 'w' | 'M' | 'W' | '%' | '@' => 0.85,
        c if c.is_ascii_uppercase() => 0.65,
        _ => 0.56,
    };
    text.chars().map(em).sum::<f64>() * size
}

fn options() -> usvg::Options<'static> {
    static FONTS: OnceLock<Arc<usvg::fontdb::Database>> = OnceLock::new();
    let fonts = FONTS.get_or_init(|| {
        let mut fonts = usvg::fontdb::Database::new();
        fonts.load_font_data(epaint_default_fonts::UBUNTU_LIGHT.to_vec());
        fonts.set_sans_serif_family("Ubuntu");
        Arc::new(fonts)
    });
    usvg::Options { fontdb: fonts.clone(), font_family: "Ubuntu".to_owned(), ..usvg::Options::default() }
}

/// Draws an SVG of ours over a pixmap, `scale` pixels a unit. The font is a light cut, so letters get a hairline of
/// their own colour; text of other drawings, which plotters did not write and whose units differ, stays as it is.
pub fn draw_svg(svg: &str, scale: f32, pixmap: &mut tiny_skia::Pixmap) -> Result<(), PlotError> {
    let tree = usvg::Tree::from_str(&firm(svg), &options())?;
    resvg::render(&tree, tiny_skia::Transform::from_scale(scale, scale), &mut pixmap.as_mut());
    Ok(())
}

fn firm(svg: &str) -> String {
    let mut out = String::with_capacity(svg.len() + 4096);
    for line in svg.split_inclusive('\n') {
        let fill = (line.starts_with("<text x=") && line.contains("text-anchor"))
            .then(|| line.split_once("fill=\""))
            .flatten();
        match fill.and_then(|(_, rest)| rest.split_once('"')) {
            Some((colour, _)) => {
                out += &line.replacen("<text", &format!("<text stroke=\"{colour}\" stroke-width=\"1.6\""), 1);
            }
            None => out += line,
        }
    }
    out
}

/// The bytes of a PNG of an SVG drawn here, `scale` pixels for each of its pixels.
///
/// # Errors
/// When the text is no SVG or the size is out of range.
pub fn svg_to_png(svg: &str, scale: f32) -> Result<Vec<u8>, PlotError> {
    let size = usvg::Tree::from_str(svg, &options())?.size();
    let [width, height] = [size.width(), size.height()].map(|s| (s * scale).round() as u32);
    let mut pixmap = pixmap([width, height])?;
    draw_svg(svg, scale, &mut pixmap)?;
    to_png(&pixmap)
}

/// A white pixmap.
pub fn pixmap([width, height]: [u32; 2]) -> Result<tiny_skia::Pixmap, PlotError> {
    let fits = (1..=16384).contains(&width) && (1..=16384).contains(&height);
    let mut pixmap = tiny_skia::Pixmap::new(width, height).filter(|_| fits).ok_or(PlotError::Size { width, height })?;
    pixmap.fill(tiny_skia::Color::WHITE);
    Ok(pixmap)
}

/// PNG of an opaque pixmap, without its alpha.
pub fn to_png(pixmap: &tiny_skia::Pixmap) -> Result<Vec<u8>, PlotError> {
    let rgb: Vec<u8> = pixmap.data().chunks_exact(4).flat_map(|p| [p[0], p[1], p[2]]).collect();
    let size = [pixmap.width() as usize, pixmap.height() as usize];
    Ok(crate::export::picture::encode(size, &rgb, png::ColorType::Rgb)?)
}
