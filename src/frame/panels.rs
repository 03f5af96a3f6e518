//! Sheathing: one brace per bay of wall, deck and roof, leaning towards the middle so that a symmetric house stays symmetric.

use super::grid::{Grid, NONE, STEPS, STOREY, X, Y, Z, label};
use super::sheathing::{Panel, PanelKind, SHEATHING};
use super::sticks::{Stick, position};
use super::types::{HouseFrame, Role, distance};
use crate::voxels::VoxelArray;

/// Narrowest wall panel that counts, half modules: 0.9 m, about a quarter of the storey (EN 1995-1-1 9.2.4.2(2)).
const NARROWEST: i32 = 2;

/// Fills [`HouseFrame::panels`]. `tops` are the half levels between which wall panels stand.
pub(super) fn fill(grid: &Grid, v: &VoxelArray, sticks: &[Stick], levels: &[i32], frame: &mut HouseFrame) {
    for normal in [X, Y] {
        for plane in (0..grid.size()[normal]).step_by(2) {
            for pair in levels.windows(2) {
                wall(grid, v, normal, plane, [pair[0], pair[1]], frame);
            }
        }
    }
    for panel in &mut frame.panels {
        panel.ea_n *= frame.boards.sides();
        panel.capacity_n *= frame.boards.sides();
    }
    let (decks, roofs): (Vec<&Stick>, Vec<&Stick>) = (
        sticks.iter().filter(|s| s.step < Z && s.from[2] > 0 && s.from[2] % STOREY == 0).collect(),
        sticks.iter().filter(|s| matches!(s.role, Role::Rafter | Role::Ridge)).collect(),
    );
    bays(grid, v, &decks, PanelKind::Deck, frame);
    for stick in &decks {
        super::deck_strips::hold_by_deck(grid, v, stick, frame);
    }
    bays(grid, v, &roofs, PanelKind::Roof, frame);
}

/// A sheathed bay.
struct Bay {
    kind: PanelKind,
    /// Its two sides, m.
    sides: [f64; 2],
    /// Part of the capacity that counts.
    strength: f64,
    /// See [`Panel::line`].
    line: u32,
}

/// Adds a brace between two grid points that are nodes; `share` is the part of the bay it stands for.
fn brace(grid: &Grid, v: &VoxelArray, frame: &mut HouseFrame, bay: &Bay, [p, q]: [[i32; 3]; 2], share: f64) {
    let nodes = [p, q].map(|p| grid.node[grid.point(p)]);
    if nodes.contains(&NONE) || nodes[0] == nodes[1] {
        return;
    }
    let d = distance(position(v, p), position(v, q));
    let board = SHEATHING[bay.kind as usize];
    frame.panels.push(Panel {
        kind: bay.kind,
        nodes,
        ea_n: share * board.shear_n_per_m * d.powi(3) / (bay.sides[0] * bay.sides[1]),
        capacity_n: share * bay.strength * board.capacity_n_per_m * d,
        line: bay.line,
    });
}

/// Wall panels of one facade plane between two levels.
fn wall(grid: &Grid, v: &VoxelArray, normal: usize, plane: i32, [low, high]: [i32; 2], frame: &mut HouseFrame) {
    let along = 1 - normal;
    let at = |s: i32, z: i32| {
        let mut p = [0, 0, z];
        p[normal] = plane;
        p[along] = s;
        p
    };
    let full = |s: i32| (low..high).all(|z| grid.role(at(s, z), Z).is_some_and(|r| r != Role::BeamPost));
    // A wall inside the house has a stud at every module's centre.
    let inside = |s: i32, z: i32| grid.role(at(s | 1, z), Z) == Some(Role::Stud);
    let closed = |s: i32| (low..high).all(|z| is_wall(v, normal, plane, s, z) || inside(s, z));
    let line = frame.panels.len() as u32;
    let mut s = 0;
    while s < grid.size()[along] {
        if !full(s) {
            s += 1;
            continue;
        }
        let mut posts = vec![s];
        let mut end = s;
        while end + 1 < grid.size()[along] && closed(end) {
            end += 1;
            if full(end) {
                posts.push(end);
            }
        }
        pier(grid, v, &at, &posts, [low, high], line, frame);
        s = posts.last().copied().unwrap_or(s) + 1;
    }
}

/// Whether the half step from `s` at half level z is wall without an opening.
fn is_wall(v: &VoxelArray, normal: usize, plane: i32, s: i32, z: i32) -> bool {
    let k = super::place::layer(z);
    let sides =
        [plane / 2 - 1, plane / 2].map(|c| if normal == X { label(v, c, s / 2, k) } else { label(v, s / 2, c, k) });
    let wall = |l: crate::voxels::Label| l.is_filled() && !l.is_infill();
    (wall(sides[0]) && !sides[1].is_filled()) || (wall(sides[1]) && !sides[0].is_filled())
        // Above a deck or under one the plate's own voxel is filled on both sides.
        || (wall(sides[0]) && wall(sides[1]) && (sides[0].is_slab() || sides[1].is_slab()))
}

/// Splits a pier into panels of at least [`NARROWEST`], narrow bays joined to their neighbours.
///
/// The pier is boarded in one piece (upright boards up to 2.8 m wide, joints on studs), so its whole width counts for c of EN 1995-1-1
/// 9.2.4.2(4): a pier narrower than half its height has its capacity lowered in proportion.
fn pier(
    grid: &Grid,
    v: &VoxelArray,
    at: &impl Fn(i32, i32) -> [i32; 3],
    posts: &[i32],
    [low, high]: [i32; 2],
    line: u32,
    frame: &mut HouseFrame,
) {
    let (Some(&first), Some(&last)) = (posts.first(), posts.last()) else { return };
    if last - first < NARROWEST {
        return;
    }
    let mut cuts = vec![first];
    let middle = first + last;
    for &p in &posts[1..posts.len() - 1] {
        let from = cuts[cuts.len() - 1];
        if p - from >= NARROWEST && last - p >= NARROWEST {
            cuts.push(p);
        }
    }
    cuts.push(last);
    let half = v.module.size_m.map(|s| 0.5 * s);
    let step = if at(1, 0)[0] == at(0, 0)[0] { half[1] } else { half[0] };
    let height = f64::from(high - low) * half[2];
    let strength = (f64::from(last - first) * step / (0.5 * height)).min(1.0);
    for c in cuts.windows(2) {
        let bay = Bay { kind: PanelKind::Wall, sides: [f64::from(c[1] - c[0]) * step, height], strength, line };
        let rising = [at(c[0], low), at(c[1], high)];
        let falling = [at(c[1], low), at(c[0], high)];
        leaning(grid, v, frame, &bay, [rising, falling], (c[0] + c[1]).cmp(&middle));
    }
}

/// One brace leaning to the middle, or two of half stiffness in the middle bay.
fn leaning(
    grid: &Grid,
    v: &VoxelArray,
    frame: &mut HouseFrame,
    bay: &Bay,
    [rising, falling]: [[[i32; 3]; 2]; 2],
    side: std::cmp::Ordering,
) {
    match side {
        std::cmp::Ordering::Less => brace(grid, v, frame, bay, rising, 1.0),
        std::cmp::Ordering::Greater => brace(grid, v, frame, bay, falling, 1.0),
        std::cmp::Ordering::Equal => {
            brace(grid, v, frame, bay, rising, 0.5);
            brace(grid, v, frame, bay, falling, 0.5);
        }
    }
}

/// Bays between neighbouring parallel sticks of a deck or a roof plane.
fn bays(grid: &Grid, v: &VoxelArray, sticks: &[&Stick], kind: PanelKind, frame: &mut HouseFrame) {
    for a in sticks {
        let axis = if STEPS[a.step][0] != 0 { X } else { Y };
        let across = 1 - axis;
        for b in sticks {
            let gap = b.from[across] - a.from[across];
            let rise = STEPS[a.step][2] * STEPS[a.step][axis];
            let plane = |s: &Stick| s.from[2] - rise * s.from[axis];
            let tile = b.step == a.step && plane(b) == plane(a) && (gap == 2 || gap == 1);
            if !tile || between(sticks, a, b, axis) {
                continue;
            }
            bay(grid, v, a, b, axis, kind, frame);
        }
    }
}

/// Whether another stick lies halfway between two sticks two half modules apart, over most of their common length.
fn between(sticks: &[&Stick], a: &Stick, b: &Stick, axis: usize) -> bool {
    let across = 1 - axis;
    if b.from[across] - a.from[across] != 2 {
        return false;
    }
    let [from, to] = overlap(a, b, axis);
    sticks.iter().any(|c| {
        let rise = STEPS[a.step][2] * STEPS[a.step][axis];
        let plane = |s: &Stick| s.from[2] - rise * s.from[axis];
        let here = c.step == a.step && plane(c) == plane(a) && c.from[across] == a.from[across] + 1;
        let end = c.at(c.length)[axis];
        here && c.from[axis].min(end) <= from + 1 && c.from[axis].max(end) >= to - 1
    })
}

/// Common range of two parallel sticks along `axis`.
fn overlap(a: &Stick, b: &Stick, axis: usize) -> [i32; 2] {
    let range = |s: &Stick| {
        let end = s.at(s.length)[axis];
        [s.from[axis].min(end), s.from[axis].max(end)]
    };
    let (ra, rb) = (range(a), range(b));
    [ra[0].max(rb[0]), ra[1].min(rb[1])]
}

fn bay(grid: &Grid, v: &VoxelArray, a: &Stick, b: &Stick, axis: usize, kind: PanelKind, frame: &mut HouseFrame) {
    let [from, to] = overlap(a, b, axis);
    let nodes = |s: &Stick| {
        let mut range: Vec<[i32; 3]> = (0..=s.length)
            .map(|n| s.at(n))
            .filter(|p| (from..=to).contains(&p[axis]) && grid.node[grid.point(*p)] != NONE)
            .collect();
        range.sort_unstable_by_key(|p| p[axis]);
        range
    };
    let (na, nb) = (nodes(a), nodes(b));
    let (Some(&a0), Some(&a1), Some(&b0), Some(&b1)) = (na.first(), na.last(), nb.first(), nb.last()) else { return };
    let (rising, falling) = ([a0, b1], [b0, a1]);
    let length = |[p, q]: [[i32; 3]; 2]| (q[axis] - p[axis]).abs();
    let reach = length(rising).max(length(falling));
    if reach < 1 {
        return;
    }
    let across = 1 - axis;
    let half = v.module.size_m.map(|s| 0.5 * s);
    let rise = STEPS[a.step][2].abs();
    let unit = (half[axis].powi(2) + (f64::from(rise) * half[2]).powi(2)).sqrt();
    let sides = [f64::from(reach) * unit, f64::from((b.from[across] - a.from[across]).abs()) * half[across]];
    let whole = Bay { kind, sides, strength: 1.0, line: frame.panels.len() as u32 };
    if length(rising) == length(falling) {
        let middle = grid.size()[across] - 1;
        let side = (a.from[across] + b.from[across]).cmp(&middle);
        leaning(grid, v, frame, &whole, [rising, falling], side);
    } else {
        let longer = if length(rising) > length(falling) { rising } else { falling };
        brace(grid, v, frame, &whole, longer, 1.0);
    }
}
