//! A page in millimetres: lines with pens, fills, texts; what is drawn in metres comes out at the stated scale.

use std::fmt::Write as _;

use super::collinear::Segment;
use super::cut::Loop;
use super::pens::Pen;

/// A format of paper, mm, lying.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Paper {
    /// ISO 216 name.
    pub name: &'static str,
    /// Width and height, mm.
    pub size: [f64; 2],
}

/// The two formats that offices print.
pub const A4: Paper = Paper { name: "A4", size: [297.0, 210.0] };
/// See [`A4`].
pub const A3: Paper = Paper { name: "A3", size: [420.0, 297.0] };

/// Paper and scale of the drawings of a house, one for all of them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Format {
    /// The page.
    pub paper: Paper,
    /// Metres on the house that are a metre on paper: 100 for 1:100.
    pub scale: f64,
}

/// Distance of the frame from the edge of the page, mm.
pub const EDGE: f64 = 8.0;
/// Height of the title block, mm.
pub const TITLE: f64 = 25.0;
/// Room for dimensions, grid and levels around a drawing: left, above, right, below, mm.
pub const MARGINS: [f64; 4] = [31.0, 22.0, 31.0, 24.0];

impl Format {
    /// The first of these that holds drawings of `extent` m: A3 at 1:50, A4 at 1:100, A3 at 1:100, then A3 ever smaller.
    pub fn fit(extent: [f64; 2]) -> Format {
        let mut formats = vec![(A3, 50.0), (A4, 100.0), (A3, 100.0), (A3, 200.0), (A3, 500.0)];
        formats.extend([1e3, 2e3, 5e3, 1e4].map(|s| (A3, s)));
        let formats = formats.into_iter().map(|(paper, scale)| Format { paper, scale });
        let fits = |f: &Format| (0..2).all(|a| extent[a] * 1e3 / f.scale <= f.room()[a]);
        let last = Format { paper: A3, scale: 1e4 };
        formats.into_iter().find(fits).unwrap_or(last)
    }

    /// What is left for a drawing without its margins, mm.
    fn room(&self) -> [f64; 2] {
        let [l, t, r, b] = MARGINS;
        [self.paper.size[0] - 2.0 * EDGE - l - r, self.paper.size[1] - 2.0 * EDGE - TITLE - t - b]
    }
}

/// Where a text is held.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Hold {
    /// At its start.
    Start,
    /// At its middle.
    Middle,
    /// At its end.
    End,
}

/// Colour of text.
pub const TEXT: &str = "#1d2022";
/// Colour of lesser text.
pub const QUIET: &str = "#5a6066";

/// A page being drawn.
pub struct Sheet {
    /// Paper and scale.
    pub format: Format,
    svg: String,
    /// Where the origin of the view lies, mm.
    origin: [f64; 2],
}

impl Sheet {
    /// A page on which the window `low`..`high` m of a view lies in the middle of the room for it.
    pub fn new(format: Format, low: [f64; 2], high: [f64; 2], about: &str) -> Sheet {
        let [w, h] = format.paper.size;
        let mut svg = format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{w}mm\" height=\"{h}mm\" viewBox=\"0 0 {w} {h}\" \
             font-family=\"Ubuntu, 'Segoe UI', 'Helvetica Neue', Arial, sans-serif\" stroke-linecap=\"round\" stroke-linejoin=\"round\">\n\
             <title>{}</title>\n<rect class=\"paper\" width=\"{w}\" height=\"{h}\" fill=\"#fff\"/>\n",
            escape(about)
        );
        svg.push_str(super::hatch::PATTERNS);
        let [l, t, _, _] = MARGINS;
        let room = format.room();
        let mm = 1e3 / format.scale;
        let middle = [EDGE + l + 0.5 * room[0], EDGE + t + 0.5 * room[1]];
        let origin = [middle[0] - 0.5 * (low[0] + high[0]) * mm, middle[1] + 0.5 * (low[1] + high[1]) * mm];
        Sheet { format, svg, origin }
    }

    /// mm on paper of a length on the house.
    pub fn mm(&self, metres: f64) -> f64 {
        metres * 1e3 / self.format.scale
    }

    /// Place on paper of a place in the view, mm right and down.
    pub fn at(&self, [u, v]: [f64; 2]) -> [f64; 2] {
        [self.origin[0] + self.mm(u), self.origin[1] - self.mm(v)]
    }

    /// Lines given in the view, m.
    pub fn lines(&mut self, pen: Pen, lines: &[Segment]) {
        let placed: Vec<Vec<[f64; 2]>> = lines.iter().map(|l| l.map(|p| self.at(p)).to_vec()).collect();
        self.paths(pen, &placed, false, "none");
    }

    /// An open or closed line in the view, m, with its fill.
    pub fn shape(&mut self, pen: Pen, points: &[[f64; 2]], closed: bool, fill: &str) {
        let placed: Vec<[f64; 2]> = points.iter().map(|p| self.at(*p)).collect();
        self.paths(pen, &[placed], closed, fill);
    }

    /// Lines given in mm on paper.
    pub fn paths(&mut self, pen: Pen, lines: &[Vec<[f64; 2]>], closed: bool, fill: &str) {
        let d = path(lines, closed);
        if d.is_empty() {
            return;
        }
        let dashes = match pen.dashes {
            "" => String::new(),
            dashes => format!(" stroke-dasharray=\"{dashes}\" stroke-linecap=\"butt\""),
        };
        let _ = writeln!(
            self.svg,
            "<path class=\"{}\" d=\"{d}\" fill=\"{fill}\" stroke=\"{}\" stroke-width=\"{}\"{dashes}/>",
            pen.name, pen.ink, pen.width
        );
    }

    /// Areas in the view, m, even-odd.
    pub fn fill(&mut self, class: &str, loops: &[Loop], fill: &str) {
        let placed: Vec<Vec<[f64; 2]>> = loops.iter().map(|l| l.iter().map(|p| self.at(*p)).collect()).collect();
        let d = path(&placed, true);
        if !d.is_empty() {
            let _ = writeln!(self.svg, "<path class=\"{class}\" d=\"{d}\" fill=\"{fill}\" fill-rule=\"evenodd\"/>");
        }
    }

    /// A quarter of a circle in the view from one end to the other, m; `left` where it bends to the left on paper.
    pub fn arc(&mut self, pen: Pen, from: [f64; 2], to: [f64; 2], radius: f64, left: bool) {
        let (r, [a, b]) = (tidy(self.mm(radius)), [from, to].map(|p| self.at(p).map(tidy)));
        let _ = writeln!(
            self.svg,
            "<path class=\"{}\" d=\"M{} {}A{r} {r} 0 0 {} {} {}\" fill=\"none\" stroke=\"{}\" stroke-width=\"{}\"/>",
            pen.name,
            a[0],
            a[1],
            u8::from(!left),
            b[0],
            b[1],
            pen.ink,
            pen.width
        );
    }

    /// A circle in mm on paper.
    pub fn circle(&mut self, pen: Pen, [x, y]: [f64; 2], radius: f64, fill: &str) {
        let (x, y, radius) = (tidy(x), tidy(y), tidy(radius));
        let _ = writeln!(
            self.svg,
            "<circle class=\"{}\" cx=\"{x}\" cy=\"{y}\" r=\"{radius}\" fill=\"{fill}\" stroke=\"{}\" stroke-width=\"{}\"/>",
            pen.name, pen.ink, pen.width
        );
    }

    /// A text in mm on paper, its base line at the place.
    pub fn text(&mut self, words: &str, at: [f64; 2], size: f64, hold: Hold, ink: &str) {
        self.write(words, at, size, hold, ink, "");
    }

    /// A text with attributes of its own, such as a turn or a weight.
    pub fn write(&mut self, words: &str, [x, y]: [f64; 2], size: f64, hold: Hold, ink: &str, more: &str) {
        let anchor = match hold {
            Hold::Start => "start",
            Hold::Middle => "middle",
            Hold::End => "end",
        };
        let _ = writeln!(
            self.svg,
            "<text class=\"words\" x=\"{}\" y=\"{}\" font-size=\"{size}\" text-anchor=\"{anchor}\" fill=\"{ink}\"{more}>{}</text>",
            tidy(x),
            tidy(y),
            escape(words)
        );
    }

    /// Text on white, so that it stays legible over lines.
    pub fn label(&mut self, words: &str, [x, y]: [f64; 2], size: f64, hold: Hold, ink: &str) {
        let w = width(words, size) + 0.8;
        let left = match hold {
            Hold::Start => x - 0.4,
            Hold::Middle => x - 0.5 * w,
            Hold::End => x - w + 0.4,
        };
        let _ = writeln!(
            self.svg,
            "<rect class=\"ground-of-text\" x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" fill=\"#fff\" fill-opacity=\"0.85\"/>",
            tidy(left),
            tidy(y - 0.85 * size),
            tidy(w),
            tidy(1.15 * size)
        );
        self.text(words, [x, y], size, hold, ink);
    }

    /// Opens a group; close it with [`Sheet::close`].
    pub fn open(&mut self, class: &str) {
        let _ = writeln!(self.svg, "<g class=\"{class}\">");
    }

    /// Closes the last group.
    pub fn close(&mut self) {
        self.svg.push_str("</g>\n");
    }

    /// The SVG text.
    pub fn finish(mut self) -> String {
        self.svg.push_str("</svg>\n");
        self.svg
    }
}

/// Width of a text on paper, mm, as far as it need be known: digits and letters of the usual fonts are about 0.56 of their size wide.
pub fn width(words: &str, size: f64) -> f64 {
    words.chars().count() as f64 * 0.56 * size
}

fn path(lines: &[Vec<[f64; 2]>], closed: bool) -> String {
    let mut d = String::new();
    for line in lines {
        if line.len() < 2 || line.iter().flatten().any(|c| !c.is_finite()) {
            continue;
        }
        for (n, p) in line.iter().enumerate() {
            let _ = write!(d, "{}{} {}", if n == 0 { "M" } else { "L" }, tidy(p[0]), tidy(p[1]));
        }
        if closed {
            d.push('Z');
        }
    }
    d
}

/// Hundredths of a millimetre are enough on paper.
fn tidy(value: f64) -> f64 {
    (value * 100.0).round() / 100.0 + 0.0
}

fn escape(words: &str) -> String {
    words.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;")
}
