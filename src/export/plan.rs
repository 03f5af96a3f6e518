//! Storey plans as SVG: walls in poche, windows, doors with their swing, stairs, grid and scale bar. North (+y) is up.

use std::fmt::Write as _;

/// What is set into a wall.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PlanOpeningKind {
    /// Glass between two lines.
    Window,
    /// A leaf that swings inwards.
    Door,
}

/// An opening along a facade, from end to end in m, with the outside on the right of `from` to `to`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PlanOpening {
    /// Window or door.
    pub kind: PlanOpeningKind,
    /// One end on the facade line.
    pub from: [f64; 2],
    /// The other end.
    pub to: [f64; 2],
}

/// A flight of a stair as seen in plan: its centre line, climbing.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PlanFlight {
    /// Foot of the flight in m.
    pub from: [f64; 2],
    /// Head of the flight in m.
    pub to: [f64; 2],
    /// Clear width in m.
    pub width_m: f64,
    /// Number of treads.
    pub treads: usize,
}

/// One storey.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct StoreyPlan {
    /// Printed below, e.g. `Ground storey, 52.4 m²`.
    pub title: String,
    /// Closed facade lines in m, the house on the left of each (outer loops counter-clockwise, courts clockwise),
    /// first point not repeated.
    pub loops: Vec<Vec<[f64; 2]>>,
    /// Windows and doors.
    pub openings: Vec<PlanOpening>,
    /// Stair flights.
    pub flights: Vec<PlanFlight>,
    /// Closed outlines of landings between flights, m.
    pub landings: Vec<Vec<[f64; 2]>>,
    /// Closed outlines of stair voids in this storey's floor, m: dashed.
    pub voids: Vec<Vec<[f64; 2]>>,
    /// Distance of grid lines in m; none when not positive.
    pub grid_m: f64,
}

/// Thickness of the wall band, measured inwards from the facade, m.
pub const WALL_M: f64 = 0.3;

/// Margin around the house, m.
const MARGIN: f64 = 1.2;

/// The SVG text at 1:100 (a metre is 10 mm), so that it prints to scale. Values that are not finite are left out.
pub fn plan_svg(plan: &StoreyPlan) -> String {
    let finite = |l: &&Vec<[f64; 2]>| l.len() > 2 && l.iter().flatten().all(|v| v.is_finite());
    let loops: Vec<&Vec<[f64; 2]>> = plan.loops.iter().filter(finite).collect();
    let points = || loops.iter().flat_map(|l| l.iter());
    let [low, high] = points().fold([[f64::MAX; 2], [f64::MIN; 2]], |[l, h], p| {
        [[l[0].min(p[0]), l[1].min(p[1])], [h[0].max(p[0]), h[1].max(p[1])]]
    });
    let [low, high] = if loops.is_empty() { [[0.0; 2], [4.0; 2]] } else { [low, high] };
    let (w, h) = (high[0] - low[0] + 2.0 * MARGIN, high[1] - low[1] + 2.0 * MARGIN + 1.0);
    let mut svg = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{}mm\" height=\"{}mm\" viewBox=\"0 0 {} {}\" \
         font-family=\"Ubuntu, Arial, sans-serif\" stroke-linecap=\"butt\">\n<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n",
        tidy(w * 10.0),
        tidy(h * 10.0),
        tidy(w),
        tidy(h)
    );
    let sheet = Sheet { low, high };
    sheet.grid(&mut svg, plan.grid_m);
    sheet.walls(&mut svg, &loops);
    for opening in &plan.openings {
        sheet.opening(&mut svg, opening);
    }
    for flight in &plan.flights {
        sheet.flight(&mut svg, flight);
    }
    for landing in plan.landings.iter().filter(finite) {
        sheet.outline(&mut svg, landing, "0.02", "none");
    }
    for void in plan.voids.iter().filter(finite) {
        sheet.outline(&mut svg, void, "0.025", "0.12 0.08");
    }
    sheet.scale_bar(&mut svg, &plan.title, h);
    svg + "</svg>\n"
}

/// Turns plan metres (y north) into sheet metres (y down).
struct Sheet {
    low: [f64; 2],
    high: [f64; 2],
}

impl Sheet {
    fn at(&self, p: [f64; 2]) -> String {
        format!("{},{}", tidy(p[0] - self.low[0] + MARGIN), tidy(self.high[1] - p[1] + MARGIN))
    }

    fn line(&self, svg: &mut String, points: &[[f64; 2]], width: f64, colour: &str) {
        let path: Vec<String> = points.iter().map(|p| self.at(*p)).collect();
        let _ = writeln!(
            svg,
            "<polyline points=\"{}\" fill=\"none\" stroke=\"{colour}\" stroke-width=\"{width}\"/>",
            path.join(" ")
        );
    }

    fn polygon(&self, svg: &mut String, points: &[[f64; 2]], colour: &str) {
        let path: Vec<String> = points.iter().map(|p| self.at(*p)).collect();
        let _ = writeln!(svg, "<polygon points=\"{}\" fill=\"{colour}\"/>", path.join(" "));
    }

    fn grid(&self, svg: &mut String, step: f64) {
        if !(step.is_finite() && step > 0.05) {
            return;
        }
        for axis in 0..2 {
            let count = ((self.high[axis] - self.low[axis]) / step + 1e-6).floor() as usize;
            for i in 0..=count {
                let mut ends = [self.low, self.high];
                ends[0][axis] = self.low[axis] + i as f64 * step;
                ends[1][axis] = ends[0][axis];
                ends[0][1 - axis] -= 0.5;
                ends[1][1 - axis] += 0.5;
                self.line(svg, &ends, 0.01, "#c9cdd1");
            }
        }
    }

    /// The band between each facade line and the same line moved inwards.
    fn walls(&self, svg: &mut String, loops: &[&Vec<[f64; 2]>]) {
        let mut path = String::new();
        for outer in loops {
            for ring in [(*outer).clone(), inwards(outer)] {
                let points: Vec<String> = ring.iter().map(|p| self.at(*p)).collect();
                let _ = write!(path, "M{}Z", points.join("L"));
            }
        }
        let _ = writeln!(svg, "<path class=\"wall\" d=\"{path}\" fill=\"#3b3f43\" fill-rule=\"evenodd\"/>");
    }

    fn opening(&self, svg: &mut String, opening: &PlanOpening) {
        let Some((along, length)) = direction(opening.from, opening.to) else { return };
        let inside = [-along[1], along[0]];
        let point = |a: f64, i: f64| {
            [opening.from[0] + along[0] * a + inside[0] * i, opening.from[1] + along[1] * a + inside[1] * i]
        };
        self.polygon(
            svg,
            &[point(0.0, -0.01), point(length, -0.01), point(length, WALL_M + 0.01), point(0.0, WALL_M + 0.01)],
            "#fff",
        );
        match opening.kind {
            PlanOpeningKind::Window => {
                for depth in [0.0, 0.1, 0.15, WALL_M] {
                    self.line(svg, &[point(0.0, depth), point(length, depth)], 0.02, "#3b3f43");
                }
            }
            PlanOpeningKind::Door => {
                let leaf = length - 0.05;
                let (hinge, open, shut) = (point(0.025, 0.12), point(0.025, 0.12 + leaf), point(0.025 + leaf, 0.12));
                self.line(svg, &[hinge, open], 0.04, "#8a4b32");
                let sweep = 1;
                let _ = writeln!(
                    svg,
                    "<path class=\"swing\" d=\"M{} A{r},{r} 0 0,{sweep} {}\" fill=\"none\" stroke=\"#8a4b32\" stroke-width=\"0.015\"/>",
                    self.at(open),
                    self.at(shut),
                    r = tidy(leaf)
                );
            }
        }
    }

    fn flight(&self, svg: &mut String, flight: &PlanFlight) {
        let Some((along, length)) = direction(flight.from, flight.to) else { return };
        let half = 0.5 * flight.width_m;
        let point = |a: f64, s: f64| {
            [flight.from[0] + along[0] * a - along[1] * s, flight.from[1] + along[1] * a + along[0] * s]
        };
        self.line(
            svg,
            &[point(0.0, -half), point(length, -half), point(length, half), point(0.0, half), point(0.0, -half)],
            0.02,
            "#3b3f43",
        );
        let treads = flight.treads.min(100);
        for i in 1..treads {
            let a = length * i as f64 / treads as f64;
            self.line(svg, &[point(a, -half), point(a, half)], 0.012, "#6a7076");
        }
        self.line(svg, &[point(0.15, 0.0), point(length - 0.15, 0.0)], 0.02, "#3b3f43");
        self.polygon(svg, &[point(length - 0.05, 0.0), point(length - 0.3, 0.1), point(length - 0.3, -0.1)], "#3b3f43");
    }

    fn outline(&self, svg: &mut String, corners: &[[f64; 2]], width: &str, dashes: &str) {
        let points: Vec<String> = corners.iter().map(|&p| self.at(p)).collect();
        let _ = writeln!(
            svg,
            "<polygon points=\"{}\" fill=\"none\" stroke=\"#3b3f43\" stroke-width=\"{width}\" stroke-dasharray=\"{dashes}\"/>",
            points.join(" ")
        );
    }

    fn scale_bar(&self, svg: &mut String, title: &str, height: f64) {
        let y = tidy(height - 0.75);
        for metre in 0..3 {
            let fill = if metre % 2 == 0 { "#3b3f43" } else { "#fff" };
            let x = tidy(MARGIN + f64::from(metre));
            let _ = writeln!(
                svg,
                "<rect x=\"{x}\" y=\"{y}\" width=\"1\" height=\"0.1\" fill=\"{fill}\" stroke=\"#3b3f43\" stroke-width=\"0.015\"/>"
            );
        }
        let words = title.replace('&', "&amp;").replace('<', "&lt;");
        let y = tidy(height - 0.3);
        let _ = writeln!(
            svg,
            "<text x=\"{MARGIN}\" y=\"{y}\" font-size=\"0.26\" fill=\"#2b2f33\">{words} · bar 3 m · 1:100</text>"
        );
    }
}

/// Unit direction and length; `None` for a point or values that are not finite.
fn direction(from: [f64; 2], to: [f64; 2]) -> Option<([f64; 2], f64)> {
    let [x, y] = [to[0] - from[0], to[1] - from[1]];
    let length = x.hypot(y);
    (length.is_finite() && length > 1e-6).then(|| ([x / length, y / length], length))
}

/// A closed line moved to its left by the wall's thickness; corners are mitred.
fn inwards(outer: &[[f64; 2]]) -> Vec<[f64; 2]> {
    let n = outer.len();
    let mut inner = Vec::with_capacity(n);
    for i in 0..n {
        let (before, here, after) = (outer[(i + n - 1) % n], outer[i], outer[(i + 1) % n]);
        let (Some((u, _)), Some((v, _))) = (direction(before, here), direction(here, after)) else { continue };
        let mitre = (1.0 + u[0] * v[0] + u[1] * v[1]).max(0.1);
        inner.push([0, 1].map(|a| {
            let left = |d: [f64; 2]| [-d[1], d[0]][a];
            here[a] + WALL_M * (left(u) + left(v)) / mitre
        }));
    }
    inner
}

/// Millimetres are enough.
fn tidy(value: f64) -> f64 {
    (value * 1e3).round() / 1e3 + 0.0
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_wall_band_is_300_mm_inside() {
        let square = [[0.0, 0.0], [4.0, 0.0], [4.0, 3.0], [0.0, 3.0]];
        let inner = inwards(&square);
        for (p, q) in inner.iter().zip([[0.3, 0.3], [3.7, 0.3], [3.7, 2.7], [0.3, 2.7]]) {
            assert!((p[0] - q[0]).abs() < 1e-12 && (p[1] - q[1]).abs() < 1e-12, "{p:?} {q:?}");
        }
    }
}
