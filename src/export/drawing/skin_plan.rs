//! Walls of houses that a set of surfaces draws: their skin has no thickness, so walls, roofs and plates are drawn as thick as the
//! module convention says.

use super::collinear::Segment;
use super::cut::{Loop, area, cut};
use super::doors;
use super::pens::{CUT, FINE};
use super::sheet::Sheet;
use super::subject::Subject;
use crate::cubes::contours;
use crate::voxels::{FacadeOpening, LINING_M, Label, SLAB_ZONE_M, Storey};

/// What the title block says about it.
pub const NOTE: &str =
    "The tileset is a surface: walls 300 mm and plates 180 mm inwards of it are drawn by the module's convention.";

/// The fill of such walls.
const FILL: &str = "#5d6368";

/// The outline of a storey's rooms on its outer faces, m.
pub fn outlines(subject: &Subject, storey: &Storey) -> Vec<Loop> {
    let half = |[x, y]: [i32; 2]| subject.place([0.5 + f64::from(x) / 2.0, 0.5 + f64::from(y) / 2.0]);
    contours(&storey.plan).into_iter().map(|l| l.into_iter().map(half).collect()).collect()
}

/// The walls of a storey with windows in them; doors are gaps.
pub fn walls(sheet: &mut Sheet, subject: &Subject, storey: &Storey) {
    let outer = outlines(subject, storey);
    let loops: Vec<Loop> = outer.iter().cloned().chain(outer.iter().filter_map(inwards)).collect();
    sheet.fill("wall", &loops, FILL);
    for l in &loops {
        sheet.shape(CUT, l, true, "none");
    }
    for o in subject.reading.openings.iter().filter(|o| o.storey == storey.index) {
        opening(sheet, subject, o);
    }
}

/// A gap in a wall with its jambs, and panes where it is a window.
fn opening(sheet: &mut Sheet, subject: &Subject, o: &FacadeOpening) {
    let place = doors::Place::new(subject, o);
    let w = place.width;
    let corner = |a: f64, i: f64| place.at(a, i);
    sheet.fill(
        "gap",
        &[vec![corner(0.0, -0.02), corner(w, -0.02), corner(w, LINING_M + 0.02), corner(0.0, LINING_M + 0.02)]],
        "#fff",
    );
    sheet.lines(CUT, &[[corner(0.0, 0.0), corner(0.0, LINING_M)], [corner(w, 0.0), corner(w, LINING_M)]]);
    let depths: &[f64] = if o.label == Label::Window { &[0.0, 0.10, 0.17, LINING_M] } else { &[0.0, LINING_M] };
    let lines: Vec<_> = depths.iter().map(|&i| [corner(0.0, i), corner(w, i)]).collect();
    sheet.lines(FINE, &lines);
    if o.label == Label::Window {
        sheet.shape(
            FINE,
            &[corner(0.0, 0.125), corner(w, 0.125), corner(w, 0.145), corner(0.0, 0.145)],
            true,
            "#cfe0e6",
        );
    }
}

/// The skin where a section cuts it, thickened inwards, with the plates inside.
pub fn section(sheet: &mut Sheet, subject: &Subject, loops: &[Loop]) {
    let (loops, niches): (Vec<Loop>, Vec<Vec<Segment>>) = loops.iter().map(without_niches).unzip();
    let all: Vec<Loop> = loops.iter().cloned().chain(loops.iter().filter_map(inwards)).collect();
    sheet.fill("wall", &all, FILL);
    let loops = &loops;
    for plate in &subject.reading.plates {
        let top = subject.floor(plate.k);
        let band: Vec<Loop> = loops.iter().filter_map(|l| level_band(l, [top - SLAB_ZONE_M, top])).flatten().collect();
        sheet.fill("plate", &band, FILL);
    }
    for [p, q] in niches.into_iter().flatten() {
        // Outwards is on the right of a loop that runs counter-clockwise.
        let (d, length) = ([q[0] - p[0], q[1] - p[1]], (q[0] - p[0]).hypot(q[1] - p[1]));
        let inward = [-d[1] / length, d[0] / length];
        let at = |t: [f64; 2], i: f64| [t[0] + i * inward[0], t[1] + i * inward[1]];
        sheet.fill("gap", &[vec![at(p, -0.02), at(q, -0.02), at(q, LINING_M + 0.02), at(p, LINING_M + 0.02)]], "#fff");
        sheet.lines(CUT, &[[at(p, 0.0), at(p, LINING_M)], [at(q, 0.0), at(q, LINING_M)]]);
        let depths = [0.0, 0.125, 0.145, LINING_M];
        sheet.lines(FINE, &depths.map(|i| [at(p, i), at(q, i)]));
    }
}

/// A loop without the niches of windows and doors, which stand back behind the facade, and where those were.
fn without_niches(l: &Loop) -> (Loop, Vec<Segment>) {
    let n = l.len();
    let (mut kept, mut niches) = (Vec::new(), Vec::new());
    let step = |i: usize| {
        let (p, q) = (l[i % n], l[(i + 1) % n]);
        [q[0] - p[0], q[1] - p[1]]
    };
    // In, along the pane, out again: in and out cancel and are as deep as reveals.
    let niche = |i: usize| {
        let (a, b, c) = (step(i), step(i + 1), step(i + 2));
        let deep = a[0].hypot(a[1]);
        (a[0] + c[0]).hypot(a[1] + c[1]) < 1e-3
            && (0.05..0.2).contains(&deep)
            && (a[0] * b[0] + a[1] * b[1]).abs() < 1e-3
            && a[0] * -b[1] + a[1] * b[0] > 0.0
    };
    let starts: Vec<usize> = (0..n).filter(|&i| n > 5 && niche(i)).collect();
    for i in 0..n {
        if let Some(start) = starts.iter().find(|&&s| (i + n - s) % n < 4) {
            if i == *start {
                niches.push([l[i], l[(i + 3) % n]]);
            }
            continue;
        }
        kept.push(l[i]);
    }
    if kept.len() > 2 { (kept, niches) } else { (l.clone(), Vec::new()) }
}

/// The strips of a loop between two heights, where it is upright there.
fn level_band(l: &Loop, [low, high]: [f64; 2]) -> Option<Vec<Loop>> {
    let middle = 0.5 * (low + high);
    let n = l.len();
    let mut hits: Vec<f64> = (0..n)
        .map(|i| (l[i], l[(i + 1) % n]))
        .filter(|(p, q)| (p[1] > middle) != (q[1] > middle))
        .map(|(p, q)| p[0] + (middle - p[1]) / (q[1] - p[1]) * (q[0] - p[0]))
        .collect();
    hits.sort_by(f64::total_cmp);
    let strips = hits.chunks_exact(2).map(|h| vec![[h[0], low], [h[1], low], [h[1], high], [h[0], high]]).collect();
    (!hits.is_empty()).then_some(strips)
}

/// A loop moved to its left by the thickness of a wall, mitred; `None` where it is too narrow for that.
fn inwards(outer: &Loop) -> Option<Loop> {
    let n = outer.len();
    let unit = |p: [f64; 2], q: [f64; 2]| {
        let d = [q[0] - p[0], q[1] - p[1]];
        let length = d[0].hypot(d[1]).max(1e-9);
        d.map(|c| c / length)
    };
    let inner: Loop = (0..n)
        .map(|i| {
            let (before, here, after) = (outer[(i + n - 1) % n], outer[i], outer[(i + 1) % n]);
            let (u, v) = (unit(before, here), unit(here, after));
            let mitre = (1.0 + u[0] * v[0] + u[1] * v[1]).max(0.1);
            [here[0] - LINING_M * (u[1] + v[1]) / mitre, here[1] + LINING_M * (u[0] + v[0]) / mitre]
        })
        .collect();
    let keeps = (0..n).all(|i| {
        let (u, v) = (unit(outer[i], outer[(i + 1) % n]), unit(inner[i], inner[(i + 1) % n]));
        u[0] * v[0] + u[1] * v[1] > 0.0
    });
    (keeps && area(&inner) * area(outer) > 0.0).then_some(inner)
}

/// The lines in which the plane of a plan cuts the skin.
pub fn outline(subject: &Subject, view: &super::view::View, near: f64) -> Vec<Segment> {
    cut(&subject.model, view, near, |p| p.kind == super::model::Kind::Skin || p.kind == super::model::Kind::Glass)
        .outline
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_wall_band_is_300_mm_inside_and_a_thin_wall_has_none() {
        let square = vec![[0.0, 0.0], [4.0, 0.0], [4.0, 3.0], [0.0, 3.0]];
        let inner = inwards(&square).expect("wide enough");
        for (p, q) in inner.iter().zip([[0.3, 0.3], [3.7, 0.3], [3.7, 2.7], [0.3, 2.7]]) {
            assert!((p[0] - q[0]).abs() < 1e-12 && (p[1] - q[1]).abs() < 1e-12, "{p:?} {q:?}");
        }
        assert_eq!(inwards(&vec![[0.0, 0.0], [4.0, 0.0], [4.0, 0.5], [0.0, 0.5]]), None);
    }
}
