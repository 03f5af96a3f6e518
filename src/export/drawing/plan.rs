//! Storey plans: cut 1.2 m above the floor and seen from above.

use super::cut::{Loop, bounds, cut};
use super::dims::{self, Side};
use super::elevation::{draw_lines, ends};
use super::fit::{Fit, Room, fit, words};
use super::free::Free;
use super::lines::visible;
use super::model::{Kind, Piece};
use super::pens::{CUT, FINE, HIDDEN, OUTLINE, Pen};
use super::raster::{NOTHING, Raster, Window};
use super::section::Section;
use super::sheet::{Hold, QUIET, Sheet, TEXT};
use super::subject::{CUT_M, Subject};
use super::title::{self, Title};
use super::view::View;
use super::{doors, furniture, regions, skin_plan, stairs};
use crate::cubes::contours;
use crate::voxels::{Direction, FacadeOpening, Storey};

/// The name of a storey.
pub fn storey_name(index: usize) -> String {
    match index {
        0 => "Ground storey".into(),
        n => format!("Storey {n}"),
    }
}

/// What stands in the way of the plane: stairs and leaves have symbols of their own.
fn poche(piece: &Piece) -> bool {
    !matches!(piece.kind, Kind::Stair | Kind::Leaf | Kind::Rail | Kind::RailGlass | Kind::Skin)
}

/// What is seen from above: without stairs and leaves, and without the inside of a skin.
fn seen(piece: &Piece) -> bool {
    !matches!(piece.kind, Kind::Stair | Kind::Leaf | Kind::RailGlass)
}

/// The plan of a storey.
pub fn plan(subject: &Subject, storey: &Storey, section: &Section) -> String {
    let view = View::plan();
    let near = subject.floor(storey.plate_k) + CUT_M;
    let [low, high] = subject.extent(&view);
    let mut sheet =
        Sheet::new(subject.format, low, high, &format!("{}, plan of {}", subject.name, storey_name(storey.index)));
    let window = Window { low: low.map(|c| c - 0.05), high: high.map(|c| c + 0.05), near };
    let raster = Raster::new(&subject.model, &view, &window, seen);
    below(&mut sheet, subject, &raster);
    for (side, axis) in [(Side::Above, 0), (Side::Right, 1)] {
        dims::grid(&mut sheet, side, &subject.grid(axis, 1.0), [low[1 - axis], high[1 - axis]], 12.0);
    }
    let floor = subject.floor(storey.plate_k);
    let lines = visible(&subject.model, &view, &window, &raster, floor - 0.4, |p| seen(p) && p.kind != Kind::Skin);
    draw_lines(&mut sheet, &lines, [FINE, FINE, FINE]);
    let (areas, outer) = walls(&mut sheet, subject, storey, &view, near);
    voids(&mut sheet, subject, storey);
    stairs::draw(&mut sheet, subject, storey);
    doors::draw(&mut sheet, subject, storey, near);
    let free = Free::new(subject, storey, &areas);
    let fits = fit(&free, if storey.index == 0 { Room::Living } else { Room::Bedroom });
    fits.iter().for_each(|f| furniture::draw(&mut sheet, f));
    room_label(&mut sheet, subject, storey, &free, &fits);
    dimensions(&mut sheet, subject, storey, [low, high], outer);
    section_mark(&mut sheet, section, [low, high]);
    let level = dims::level(subject.level(floor));
    let mut notes = vec![
        words(&free, &fits),
        format!(
            "Cut {CUT_M:.1} m above the floor; dashed: above the cut. Grid: the module, {} × {} mm.",
            dims::millimetres(subject.module[0]),
            dims::millimetres(subject.module[1])
        ),
        format!(
            "Net floor area {:.1} m², gross {:.1} m², clear height {} mm.",
            storey.floor_area_m2,
            storey.gross_area_m2,
            dims::millimetres(storey.clear_height_m)
        ),
    ];
    if subject.is_skin() {
        notes.push(skin_plan::NOTE.to_owned());
    }
    let words = Title {
        house: subject.name.to_owned(),
        drawing: format!("Plan, {}", storey_name(storey.index).to_lowercase()),
        level: format!("finished floor {level}"),
        notes,
        north: true,
    };
    title::draw(&mut sheet, &words);
    sheet.finish()
}

/// Roofs and decks below in a light tone.
fn below(sheet: &mut Sheet, subject: &Subject, raster: &Raster) {
    let tone = |piece: &Piece| match piece.name.as_str() {
        "roof_covering" | "pitched_roof" => 1,
        "flat_membrane" | "flat_roof" | "coping" => 2,
        "deck_boards" | "deck" => 3,
        "paving" => 4,
        _ => 0,
    };
    let by_piece: Vec<u8> = subject.model.pieces.iter().map(tone).collect();
    let tones: Vec<u8> = raster
        .face
        .iter()
        .map(|&f| if f == NOTHING { 0 } else { by_piece[subject.model.faces[f as usize].0 as usize] })
        .collect();
    sheet.open("below");
    for (tone, loops) in regions::regions(raster, &tones) {
        sheet.fill("tone", &loops, ["#fff", "#f3ebe7", "#f0f1f2", "#f4efe6", "#f1f1ee"][usize::from(tone)]);
    }
    sheet.close();
}

/// The poche, and all cut areas as loops with the bounds of the outer walls.
fn walls(sheet: &mut Sheet, subject: &Subject, storey: &Storey, view: &View, near: f64) -> (Vec<Loop>, [[f64; 2]; 2]) {
    let cut = cut(&subject.model, view, near, poche);
    sheet.open("poche");
    super::poche::draw(sheet, subject, &cut);
    let areas: Vec<Loop> = cut.areas.into_iter().flat_map(|(_, loops)| loops).collect();
    let mut corners: Vec<[f64; 2]> = areas.iter().flatten().copied().collect();
    if subject.is_skin() {
        sheet.lines(OUTLINE, &skin_plan::outline(subject, view, near));
        skin_plan::walls(sheet, subject, storey);
        corners = skin_plan::outlines(subject, storey).into_iter().flatten().collect();
    }
    sheet.close();
    let outer = bounds(corners.iter()).unwrap_or(subject.extent(view));
    (areas, outer)
}

/// Openings in this floor, and dashed those in the floor above.
fn voids(sheet: &mut Sheet, subject: &Subject, storey: &Storey) {
    let half = |[x, y]: [i32; 2]| subject.place([0.5 + f64::from(x) / 2.0, 0.5 + f64::from(y) / 2.0]);
    let above = subject.reading.storeys.get(storey.index + 1).map(|s| s.plate_k);
    for plate in &subject.reading.plates {
        let pen = match plate.k {
            k if k == storey.plate_k => FINE,
            k if Some(k) == above => HIDDEN,
            _ => continue,
        };
        sheet.open("void");
        for l in contours(&plate.void) {
            let points: Vec<[f64; 2]> = l.into_iter().map(half).collect();
            sheet.shape(pen, &points, true, "none");
        }
        sheet.close();
    }
}

/// Name, area and level where the rooms leave most space.
fn room_label(sheet: &mut Sheet, subject: &Subject, storey: &Storey, free: &Free, fits: &[Fit]) {
    let mm = subject.format.scale * 1e-3;
    let [low, high] = subject.extent(&View::plan());
    // With its level where there is room for that, else without.
    let found = [[24.0, 14.0], [18.0, 9.0]].map(|size| clear_place(free, fits, [low, high], size.map(|s| s * mm)));
    let (c, size) = match found {
        [Some(c), _] => (c, 3.0),
        [None, Some(c)] => (c, 2.4),
        [None, None] => (free.largest_square().1, 2.4),
    };
    let [x, y] = sheet.at(c);
    sheet.open("room");
    sheet.label(&storey_name(storey.index), [x, y - 1.6], size, Hold::Middle, TEXT);
    sheet.label(&format!("{:.1} m²", storey.floor_area_m2), [x, y + 2.2], size, Hold::Middle, TEXT);
    if found[0].is_none() {
        return sheet.close();
    }
    let level = dims::level(subject.level(subject.floor(storey.plate_k)));
    sheet.label(&level, [x + 1.5, y + 5.6], 2.3, Hold::Middle, QUIET);
    let left = x + 1.5 - 0.5 * super::sheet::width(&level, 2.3) - 2.2;
    sheet.paths(FINE, &[vec![[left, y + 5.6], [left - 1.1, y + 4.0], [left + 1.1, y + 4.0]]], true, "#2a2d30");
    sheet.close();
}

/// The place nearest to the middle of the drawing around which a label of `size` m covers no wall, stair, door or furniture.
fn clear_place(free: &Free, fits: &[Fit], [low, high]: [[f64; 2]; 2], size: [f64; 2]) -> Option<[f64; 2]> {
    let taken = |p: [f64; 2]| {
        fits.iter().any(|f| (0..2).all(|a| p[a] > f.low[a] - 0.02 && p[a] < f.low[a] + f.room.side_m() + 0.02))
    };
    let clear = |c: [f64; 2]| {
        let samples = (0..=6).flat_map(|i| (0..=4).map(move |j| [f64::from(i) / 6.0 - 0.5, f64::from(j) / 4.0 - 0.5]));
        samples.map(|s| [0, 1].map(|a| c[a] + s[a] * size[a])).all(|p| free.has(p) && !taken(p))
    };
    let middle = [0, 1].map(|a| 0.5 * (low[a] + high[a]));
    let steps = [0, 1].map(|a| ((high[a] - low[a]) / 0.15) as usize);
    let mut best: Option<(f64, [f64; 2])> = None;
    for j in 0..=steps[1] {
        for i in 0..=steps[0] {
            let c = [low[0] + 0.15 * i as f64, low[1] + 0.15 * j as f64];
            let off = (c[0] - middle[0]).hypot(c[1] - middle[1]);
            if best.is_none_or(|(known, _)| off < known) && clear(c) {
                best = Some((off, c));
            }
        }
    }
    best.map(|(_, c)| c)
}

/// Openings and overall lengths on all sides.
fn dimensions(sheet: &mut Sheet, subject: &Subject, storey: &Storey, [low, high]: [[f64; 2]; 2], outer: [[f64; 2]; 2]) {
    let view = View::plan();
    for (facing, side, edge) in [
        (Direction::South, Side::Below, low[1]),
        (Direction::North, Side::Above, high[1]),
        (Direction::West, Side::Left, low[0]),
        (Direction::East, Side::Right, high[0]),
    ] {
        let axis = usize::from(!side.is_level());
        let ends_of = |o: &FacadeOpening| match axis {
            0 => ends(subject, &view, o),
            _ => {
                let at = |n: usize| subject.origin[1] + n as f64 * subject.module[1];
                [at(o.cell[1]), at(o.cell[1] + o.width)]
            }
        };
        let overall = [outer[0][axis], outer[1][axis]];
        let mut marks = overall.to_vec();
        marks.extend(
            subject
                .reading
                .openings
                .iter()
                .filter(|o| o.storey == storey.index && o.facing == facing)
                .flat_map(ends_of),
        );
        if marks.len() > 2 {
            dims::chain(sheet, side, edge, 8.5, &marks);
        }
        if matches!(side, Side::Below | Side::Left) {
            dims::chain(sheet, side, edge, 14.5, &overall);
        }
    }
}

/// Where the section cuts: its ends with arrows the way it looks.
fn section_mark(sheet: &mut Sheet, section: &Section, [low, high]: [[f64; 2]; 2]) {
    let across = section.across();
    let looking = section.from.back().step().map(|s| s as f64);
    sheet.open("section-mark");
    for end in [low, high] {
        let out = if end == low { -1.0 } else { 1.0 };
        let mut p = end;
        p[across] = section.at_m;
        let [x, y] = sheet.at(p);
        // On paper: outwards along the line, and the way it looks.
        let along = if across == 1 { [out, 0.0] } else { [0.0, -out] };
        let look = [looking[0], -looking[1]];
        let at = |a: f64, l: f64| [x + a * along[0] + l * look[0], y + a * along[1] + l * look[1]];
        let pen = Pen { name: "section-line", width: 0.5, ..CUT };
        sheet.paths(pen, &[vec![at(-1.0, 0.0), at(4.0, 0.0)]], false, "none");
        sheet.paths(FINE, &[vec![at(1.6, 0.2), at(4.0, 0.2), at(2.8, 2.6)]], true, "#16181a");
        let [tx, ty] = at(2.8, -2.4);
        sheet.write("A", [tx, ty + 1.0], 2.8, Hold::Middle, TEXT, " font-weight=\"600\"");
    }
    sheet.close();
}
