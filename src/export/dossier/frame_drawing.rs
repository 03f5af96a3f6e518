//! The frame as a drawing in lines: an axonometry as SVG, small and sharp on paper.

use std::fmt::Write;

use crate::frame::HouseFrame;
use crate::structure::Deformed;

/// Width of a drawing, its height at most, and its margin, in units of the SVG.
const SIZE: [f64; 3] = [720.0, 560.0, 14.0];

/// Direction from the house to the eye: degrees counter-clockwise from +x in plan, and over the horizon.
const VIEW_DEG: [f64; 2] = [-57.0, 24.0];

/// A parallel projection that fits a frame on the sheet.
struct Sheet {
    right: [f64; 3],
    up: [f64; 3],
    towards: [f64; 3],
    scale: f64,
    low: [f64; 2],
    size: [f64; 2],
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

impl Sheet {
    fn fit<'p>(points: impl Iterator<Item = &'p [f64; 3]>) -> Sheet {
        let [az, el] = VIEW_DEG.map(f64::to_radians);
        let right = [-az.sin(), az.cos(), 0.0];
        let up = [-az.cos() * el.sin(), -az.sin() * el.sin(), el.cos()];
        let towards = [az.cos() * el.cos(), az.sin() * el.cos(), el.sin()];
        let (mut low, mut high) = ([f64::INFINITY; 2], [f64::NEG_INFINITY; 2]);
        for p in points {
            for (a, v) in [dot(*p, right), dot(*p, up)].into_iter().enumerate() {
                (low[a], high[a]) = (low[a].min(v), high[a].max(v));
            }
        }
        if low[0] > high[0] {
            (low, high) = ([0.0; 2], [1.0; 2]);
        }
        let span = [0, 1].map(|a| (high[a] - low[a]).max(1e-6));
        let [width, height, margin] = SIZE;
        let scale = ((width - 2.0 * margin) / span[0]).min((height - 2.0 * margin) / span[1]);
        let size = [width, span[1] * scale + 2.0 * margin];
        // In the middle of the width.
        low[0] -= 0.5 * ((width - 2.0 * margin) / scale - span[0]);
        Sheet { right, up, towards, scale, low, size }
    }

    fn at(&self, p: [f64; 3]) -> [f64; 2] {
        let margin = SIZE[2];
        [
            margin + (dot(p, self.right) - self.low[0]) * self.scale,
            self.size[1] - margin - (dot(p, self.up) - self.low[1]) * self.scale,
        ]
    }

    fn open(&self, title: &str) -> String {
        format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {:.0} {:.0}\" role=\"img\" aria-label=\"{title}\">\n",
            self.size[0], self.size[1]
        )
    }

    fn supports(&self, svg: &mut String, frame: &HouseFrame) {
        svg.push_str("<path fill=\"#3C4247\" d=\"");
        for &n in &frame.supports {
            let [x, y] = self.at(frame.nodes[n as usize]);
            let _ = write!(svg, "M{x:.1} {y:.1}l3.4 6h-6.8z");
        }
        svg.push_str("\"/>\n");
    }
}

/// Every member in its colour, from back to front, `width_m` wide; the numbers of `labelled` members stand beside them.
pub fn coloured(
    frame: &HouseFrame,
    title: &str,
    width_m: impl Fn(usize) -> f64,
    colour: impl Fn(usize) -> u32,
    labelled: &[usize],
) -> String {
    let sheet = Sheet::fit(frame.nodes.iter().chain(frame.members.iter().flat_map(|m| &m.ends)));
    let mut order: Vec<usize> = (0..frame.members.len()).collect();
    let depth = |m: usize| {
        let [a, b] = frame.members[m].ends;
        dot(a, sheet.towards) + dot(b, sheet.towards)
    };
    order.sort_by(|&a, &b| depth(a).total_cmp(&depth(b)).then(a.cmp(&b)));
    let mut svg = sheet.open(title);
    sheet.supports(&mut svg, frame);
    svg.push_str("<g stroke=\"#fff\" stroke-width=\".7\">\n");
    for m in order {
        let [a, b] = frame.members[m].ends.map(|p| sheet.at(p));
        let (dx, dy) = (b[0] - a[0], b[1] - a[1]);
        let length = dx.hypot(dy);
        let half = 0.5 * (width_m(m) * sheet.scale).max(2.2);
        let (nx, ny) = if length > 0.5 { (-dy / length * half, dx / length * half) } else { (half, 0.0) };
        let _ = writeln!(
            svg,
            "<path fill=\"#{:06X}\" d=\"M{:.1} {:.1}L{:.1} {:.1} {:.1} {:.1} {:.1} {:.1}z\"/>",
            colour(m),
            a[0] + nx,
            a[1] + ny,
            b[0] + nx,
            b[1] + ny,
            b[0] - nx,
            b[1] - ny,
            a[0] - nx,
            a[1] - ny
        );
    }
    svg.push_str("</g>\n<g font-size=\"17\" font-weight=\"600\" text-anchor=\"middle\" fill=\"#111\" stroke=\"#fff\" stroke-width=\"4\" paint-order=\"stroke\">\n");
    for &m in labelled {
        let [a, b] = frame.members[m].ends.map(|p| sheet.at(p));
        let _ =
            writeln!(svg, "<text x=\"{:.1}\" y=\"{:.1}\">{m}</text>", 0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1]) + 6.0);
    }
    svg + "</g>\n</svg>\n"
}

/// The undeformed frame in grey and the deformed one over it, `scale` times; a ring marks the largest displacement.
pub fn bent(frame: &HouseFrame, title: &str, deformed: &Deformed, scale: f64) -> String {
    let moved = |p: &crate::structure::Place| [0, 1, 2].map(|a| p.at_m[a] + scale * p.moves_m[a]);
    let all: Vec<[f64; 3]> = deformed.members.iter().flatten().map(moved).collect();
    let sheet = Sheet::fit(frame.nodes.iter().chain(&all));
    let mut svg = sheet.open(title);
    sheet.supports(&mut svg, frame);
    let line = |svg: &mut String, points: &mut dyn Iterator<Item = [f64; 3]>| {
        for (n, p) in points.enumerate() {
            let [x, y] = sheet.at(p);
            let _ = write!(svg, "{}{x:.1} {y:.1}", if n == 0 { "M" } else { "L" });
        }
    };
    svg.push_str("<path fill=\"none\" stroke=\"#B4B9BD\" stroke-width=\"1.2\" d=\"");
    frame.members.iter().for_each(|m| line(&mut svg, &mut m.ends.into_iter()));
    svg.push_str("\"/>\n<path fill=\"none\" stroke=\"#1F4E8C\" stroke-width=\"1.2\" stroke-linejoin=\"round\" d=\"");
    deformed.members.iter().for_each(|places| line(&mut svg, &mut places.iter().map(moved)));
    svg.push_str("\"/>\n");
    let farthest =
        deformed.members.get(deformed.member).and_then(|places| places.iter().find(|p| p.at_m == deformed.at_m));
    if let Some(p) = farthest {
        let [x, y] = sheet.at(moved(p));
        let _ = writeln!(
            svg,
            "<circle cx=\"{x:.1}\" cy=\"{y:.1}\" r=\"7\" fill=\"none\" stroke=\"#9E2A1F\" stroke-width=\"2\"/>"
        );
    }
    svg + "</svg>\n"
}
