//! The skeleton of a configuration: which lines a frame may need in a cube, from the same columns as the surfaces.
//!
//! Frames take the lines of walls and floors from here. Roof lines are those of rule A, which sees the eight corners alone: they make
//! the set complete and its seams checkable, but frames take theirs from [`super::RoofShape`], which knows the numbers on the faces.
//!
//! Walls stand in the planes x = 450 and y = 450, undersides and slabs in the cube's bottom plane (a slab in the top plane belongs
//! to the cube above), roofs at the heights of the sloped surface tileset.

use super::construct::{Columns, construct, corner_xy, mid_xy};
use super::polygon::doubled_area;
use super::solids::Post;
use super::style::{HALF_PLAN_MM, HALF_RISE_MM, Style};
use super::{Facet, Line, LineRole, PatchKind};
use crate::cubes::Mask;

/// The four borders between columns: lower column, higher column, axis.
const BORDERS: [(usize, usize, usize); 4] = [(0, 1, 0), (2, 3, 0), (0, 2, 1), (1, 3, 1)];

/// All lines of a configuration in rising order. The full cube has lines too: the slab grid inside a house.
pub fn skeleton(mask: Mask) -> Vec<Line> {
    let columns = Columns::new(mask, 0, &Style::LINEAR);
    let mut lines = Vec::new();
    for border in BORDERS {
        studs(&columns, border, &mut lines);
        bottom_border(mask, border, &mut lines);
        roof_curve(&columns, border, &mut lines);
    }
    joists(mask, &mut lines);
    posts(&columns, &mut lines);
    roof_creases(&construct(mask, 0, &Style::LINEAR), &mut lines);
    lines.sort_unstable();
    lines.dedup();
    lines
}

fn at([x, y]: [i32; 2], z: i32) -> [i32; 3] {
    [x, y, z]
}

const CENTRE: [i32; 2] = [HALF_PLAN_MM, HALF_PLAN_MM];

/// Lower and upper half of the vertical at `xy`, each hanging on its own octants.
fn halves(xy: [i32; 2]) -> [[[i32; 3]; 2]; 2] {
    let z = [0, HALF_RISE_MM, 2 * HALF_RISE_MM];
    [[at(xy, z[0]), at(xy, z[1])], [at(xy, z[1]), at(xy, z[2])]]
}

/// On the vertical face of a border: the wall of a full column beside an empty one or an underside.
fn studs(columns: &Columns, (a, b, axis): (usize, usize, usize), lines: &mut Vec<Line>) {
    for (own, other) in [(a, b), (b, a)] {
        let open = matches!(columns.kind(other), Post::Empty | Post::Floor);
        if columns.kind(own) == Post::Full && open {
            for (n, ends) in halves(mid_xy(own, axis)).into_iter().enumerate() {
                lines.push(Line::new(LineRole::Stud, ends, [(own + 4 * n) as u8; 2]));
            }
        }
    }
}

/// On the bottom face, mid to centre: a rail between a filled and an empty voxel, an edge between two filled ones.
fn bottom_border(mask: Mask, (a, b, axis): (usize, usize, usize), lines: &mut Vec<Line>) {
    let filled = |q: usize| mask.bottom() >> q & 1 == 1;
    let ends = [at(mid_xy(a, axis), 0), at(CENTRE, 0)];
    match (filled(a), filled(b)) {
        (true, true) => lines.push(Line::new(LineRole::Edge, ends, [a as u8, b as u8])),
        (true, false) => lines.push(Line::new(LineRole::Rail, ends, [a as u8; 2])),
        (false, true) => lines.push(Line::new(LineRole::Rail, ends, [b as u8; 2])),
        (false, false) => {}
    }
}

/// On the bottom face, from each filled corner half-way to its neighbours.
fn joists(mask: Mask, lines: &mut Vec<Line>) {
    for q in (0..4).filter(|q| mask.bottom() >> q & 1 == 1) {
        for (axis, role) in [(0, LineRole::JoistX), (1, LineRole::JoistY)] {
            let ends = [at(corner_xy(q), 0), at(mid_xy(q, axis), 0)];
            lines.push(Line::new(role, ends, [q as u8, (q ^ (1 << axis)) as u8]));
        }
    }
}

/// On the vertical face of a border: the roof from a voxel centre half-way to its neighbour.
fn roof_curve(columns: &Columns, (a, b, axis): (usize, usize, usize), lines: &mut Vec<Line>) {
    for q in [a, b].into_iter().filter(|&q| columns.kind(q) == Post::Roof) {
        let height = columns.heights().mid(q, axis);
        let ends = [at(corner_xy(q), HALF_RISE_MM), at(mid_xy(q, axis), HALF_RISE_MM * height)];
        let role = if height == 1 { LineRole::Purlin } else { LineRole::Rafter };
        lines.push(Line::new(role, ends, [q as u8; 2]));
    }
}

/// At the centre: where the solid columns of a half make a corner, convex (one solid, two apart) or concave (three).
/// A convex post hangs on its column, a concave one on the two columns whose walls meet in it.
fn posts(columns: &Columns, lines: &mut Vec<Line>) {
    for (half, ends) in halves(CENTRE).into_iter().enumerate() {
        let solid = |q: usize| match columns.kind(q) {
            Post::Full => true,
            Post::Roof => columns.heights().centre() > half as i32,
            Post::Deck | Post::Floor | Post::Empty => false,
        };
        let octant = |q: usize| (q + 4 * half) as u8;
        for q in 0..4 {
            let beside = [q ^ 1, q ^ 2];
            let alone = solid(q) && !beside.iter().any(|&n| solid(n));
            let court = !solid(q) && beside.iter().all(|&n| solid(n)) && solid(q ^ 3);
            if alone {
                lines.push(Line::new(LineRole::Post, ends, [octant(q); 2]));
            } else if court {
                lines.push(Line::new(LineRole::Post, ends, beside.map(octant)));
            }
        }
    }
}

/// Creases between roof facets inside the cube.
fn roof_creases(facets: &[Facet], lines: &mut Vec<Line>) {
    let roofs: Vec<&Facet> = facets.iter().filter(|f| f.kind == PatchKind::Roof).collect();
    for (n, first) in roofs.iter().enumerate() {
        for second in &roofs[n + 1..] {
            for ends in shared_edges(&first.polygon, &second.polygon) {
                if let Some(role) = crease_role(first, second, ends) {
                    lines.push(Line::new(role, ends, [first.octant, second.octant]));
                }
            }
        }
    }
}

fn shared_edges<'a>(a: &'a [[i32; 3]], b: &'a [[i32; 3]]) -> impl Iterator<Item = [[i32; 3]; 2]> + 'a {
    (0..a.len()).map(|i| [a[i], a[(i + 1) % a.len()]]).filter(|[from, to]| {
        let n = b.len();
        (0..n).any(|j| b[j] == *to && b[(j + 1) % n] == *from)
    })
}

/// `None` when the two facets lie in one plane.
fn crease_role(first: &Facet, second: &Facet, [from, to]: [[i32; 3]; 2]) -> Option<LineRole> {
    let normal = doubled_area(&first.polygon);
    let height = |p: &[i32; 3]| (0..3).map(|a| normal[a] * i64::from(p[a] - from[a])).sum::<i64>();
    // Of all points of the second facet, the one farthest from the plane of the first says which way the roof folds.
    let off = second.polygon.iter().map(height).max_by_key(|h| h.abs()).unwrap_or(0);
    match off {
        0 => None,
        _ if from[2] == to[2] => Some(LineRole::Ridge),
        off if off < 0 => Some(LineRole::Hip),
        _ => Some(LineRole::Valley),
    }
}
