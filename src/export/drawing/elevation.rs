//! Elevations: what is seen of a side, toned and shaded lightly, with levels, dimensions and grid.

use super::collinear::Segment;
use super::dims::{self, Side};
use super::hatch;
use super::lines::{Weight, visible};
use super::model::{Kind, Model, Piece};
use super::pens::{BEYOND, EDGE_PEN, FINE, GROUND, OUTLINE, Pen};
use super::raster::{NOTHING, Raster, Window};
use super::regions::regions;
use super::shadow::shadow;
use super::sheet::Sheet;
use super::subject::{Subject, side_name};
use super::title::{self, Title};
use super::view::View;
use crate::export::Grain;
use crate::voxels::{Direction, FacadeOpening, Label};

/// How far the ground line runs on beyond the house, mm on paper: up to the dimensions and levels beside it.
const GROUND_BEYOND: f64 = 4.5;

/// The elevation of the side that faces `side`.
pub fn elevation(subject: &Subject, side: Direction) -> String {
    let view = View::facing(side);
    let [mut low, high] = subject.extent(&view);
    low[1] = subject.ground();
    let name = side_name(side);
    let mut sheet = Sheet::new(subject.format, low, high, &format!("{}, {name} elevation", subject.name));
    let grid = subject.grid(view.axes[0].of, view.axes[0].sign);
    let window = window(subject, &view);
    let raster = Raster::new(&subject.model, &view, &window, opaque);
    let shade = shadow(&subject.model, &view, &raster);
    surfaces(&mut sheet, &subject.model, &raster, &shade);
    let lines = visible(&subject.model, &view, &window, &raster, f64::MIN, |_| true);
    draw_lines(&mut sheet, &lines, [OUTLINE, EDGE_PEN, FINE]);
    ground_line(&mut sheet, subject, [low[0], high[0]]);
    let openings: Vec<&FacadeOpening> = subject.reading.openings.iter().filter(|o| o.facing == side).collect();
    dimensions(&mut sheet, subject, &view, low, &openings);
    dims::grid(&mut sheet, Side::Below, &grid, [low[1], low[1]], 13.5);
    dims::levels(&mut sheet, high[0], 8.5, &subject.levels());
    title::draw(
        &mut sheet,
        &Title {
            house: subject.name.to_owned(),
            drawing: format!("{}{} elevation", name[..1].to_uppercase(), &name[1..]),
            level: on_this_side(&openings),
            notes: vec![
                "Levels over the finished floor of the ground storey.".into(),
                "Shadow: light from above left at 45°, as wide as what throws it is deep.".into(),
            ],
            north: false,
        },
    );
    sheet.finish()
}

/// How many windows and doors there are.
fn on_this_side(openings: &[&FacadeOpening]) -> String {
    let count = |label: Label, word: &str| match openings.iter().filter(|o| o.label == label).count() {
        1 => format!("1 {word}"),
        n => format!("{n} {word}s"),
    };
    format!("{}, {} on this side", count(Label::Window, "window"), count(Label::Opening, "door"))
}

/// The edges that are seen of a side, as its elevation draws them: right and up in m (see [`View::facing`]), from the ground up.
pub fn seen_edges(subject: &Subject, side: Direction) -> Vec<(Weight, Segment)> {
    let view = View::facing(side);
    let window = window(subject, &view);
    let raster = Raster::new(&subject.model, &view, &window, opaque);
    visible(&subject.model, &view, &window, &raster, f64::MIN, |_| true)
}

/// All of a side above the ground.
fn window(subject: &Subject, view: &View) -> Window {
    let [low, high] = subject.extent(view);
    Window { low: [low[0] - 0.05, subject.ground()], high: high.map(|c| c + 0.05), near: f64::MAX }
}

/// What hides what stands behind it.
pub fn opaque(piece: &Piece) -> bool {
    piece.kind != Kind::RailGlass
}

/// Areas of one material and light, with its grain.
pub fn surfaces(sheet: &mut Sheet, model: &Model, raster: &Raster, shade: &[bool]) {
    // Two tones a piece, lit and shaded; 0 is nothing.
    let tones: Vec<u8> = raster
        .face
        .iter()
        .zip(shade)
        .map(|(&face, &dark)| match face {
            NOTHING => 0,
            face => (1 + 2 * model.faces[face as usize].0.min(126) + u32::from(dark)) as u8,
        })
        .collect();
    sheet.open("surfaces");
    let mut grains: Vec<(Grain, f64, Vec<super::cut::Loop>)> = Vec::new();
    for (tone, loops) in regions(raster, &tones) {
        let Some(piece) = model.pieces.get(usize::from((tone - 1) / 2)) else { continue };
        let [r, g, b] = hatch::tone(piece, tone % 2 == 0);
        sheet.fill("tone", &loops, &format!("#{r:02x}{g:02x}{b:02x}"));
        if let Some((step, _)) = hatch::grain(piece.grain) {
            match grains.iter_mut().find(|g| g.0 == piece.grain) {
                Some(found) => found.2.extend(loops),
                None => grains.push((piece.grain, step, loops)),
            }
        }
    }
    for (grain, step, loops) in grains {
        let lines = joints(grain, step.max(sheet.format.scale * 0.9e-3), &loops);
        sheet.lines(Pen { name: "grain", width: 0.06, ..BEYOND }, &lines);
    }
    sheet.close();
}

/// Parallel lines inside loops, even-odd, every `step` m.
fn joints(grain: Grain, step: f64, loops: &[super::cut::Loop]) -> Vec<Segment> {
    let across = usize::from(hatch::grain(grain).is_none_or(|(_, upright)| !upright));
    let mut lines = Vec::new();
    let Some([low, high]) = super::cut::bounds(loops.iter().flatten()) else { return lines };
    let (first, last) = ((low[across] / step).ceil() as i64, (high[across] / step).floor() as i64);
    for n in first..=last {
        let at = n as f64 * step + 1e-4;
        let mut hits: Vec<f64> = Vec::new();
        for l in loops {
            for i in 0..l.len() {
                let (p, q) = (l[i], l[(i + 1) % l.len()]);
                if (p[across] > at) != (q[across] > at) {
                    let t = (at - p[across]) / (q[across] - p[across]);
                    hits.push(p[1 - across] + t * (q[1 - across] - p[1 - across]));
                }
            }
        }
        hits.sort_by(f64::total_cmp);
        for pair in hits.chunks_exact(2).filter(|p| p[1] - p[0] > 0.04) {
            let point = |along: f64| if across == 1 { [along, at] } else { [at, along] };
            lines.push([point(pair[0]), point(pair[1])]);
        }
    }
    lines
}

/// Draws lines by weight, lightest first, so that heavier ones lie on top.
pub fn draw_lines(sheet: &mut Sheet, lines: &[(Weight, Segment)], pens: [Pen; 3]) {
    for (weight, pen) in
        [(Weight::Beyond, BEYOND), (Weight::Detail, pens[2]), (Weight::Edge, pens[1]), (Weight::Outline, pens[0])]
    {
        let own: Vec<Segment> = lines.iter().filter(|l| l.0 == weight).map(|l| l.1).collect();
        sheet.lines(pen, &own);
    }
}

/// The line of the terrain.
pub fn ground_line(sheet: &mut Sheet, subject: &Subject, [left, right]: [f64; 2]) {
    let z = subject.ground();
    let [a, b] = [sheet.at([left, z]), sheet.at([right, z])];
    sheet.paths(GROUND, &[vec![[a[0] - GROUND_BEYOND, a[1]], [b[0] + GROUND_BEYOND, b[1]]]], false, "none");
}

/// Chains of widths below and heights on the left.
fn dimensions(sheet: &mut Sheet, subject: &Subject, view: &View, low: [f64; 2], openings: &[&FacadeOpening]) {
    let wall = walls(subject, view);
    let mut across = wall.to_vec();
    let mut upwards = vec![subject.ground(), subject.origin[2]];
    for o in openings {
        across.extend(ends(subject, view, o));
        upwards.extend(heights(subject, o));
    }
    let roof = subject.roof();
    if across.len() > 2 {
        dims::chain(sheet, Side::Below, low[1], 5.0, &across);
    }
    dims::chain(sheet, Side::Below, low[1], 10.5, &wall);
    upwards.extend(roof.iter().map(|r| r.0));
    dims::chain(sheet, Side::Left, low[0], 7.0, &upwards);
    let top = roof.iter().map(|r| r.0).fold(f64::MIN, f64::max);
    dims::chain(sheet, Side::Left, low[0], 14.0, &[subject.ground(), top]);
}

/// Where the outer walls of the house begin and end to the right, m: eaves, gutters and railings left out.
pub fn walls(subject: &Subject, view: &View) -> [f64; 2] {
    let wall = |p: &Piece| {
        matches!(
            p.name.as_str(),
            "cladding" | "floor_band" | "wall" | "band" | "wall_insulation" | "plinth" | "plinth_render"
        )
    };
    let bounds = subject.model.bounds(wall).unwrap_or(subject.bounds);
    let [p, q] = bounds.map(|b| view.see(b)[0]);
    [p.min(q), p.max(q)]
}

/// Where an opening begins and ends to the right, m.
pub fn ends(subject: &Subject, view: &View, o: &FacadeOpening) -> [f64; 2] {
    let axis = o.along();
    let place = |n: usize| {
        let mut p = [0.0; 3];
        p[axis] = subject.origin[axis] + n as f64 * subject.module[axis];
        view.see(p)[0]
    };
    [place(o.cell[axis]), place(o.cell[axis] + o.width)]
}

/// Sill and head of an opening, m. One that stands on a slab begins at its top.
pub fn heights(subject: &Subject, o: &FacadeOpening) -> [f64; 2] {
    let z = |k: f64| subject.origin[2] + (k - 0.5) * subject.module[2];
    let sill = if o.reaches_slab(&subject.house.voxels, 0) { subject.floor(o.k - 1) } else { z(o.k as f64) };
    [sill, z((o.k + o.height) as f64)]
}
