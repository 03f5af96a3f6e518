//! From grid steps to sticks, nodes and elements.

use super::grid::{Grid, NONE, STEPS, Z, sub};
use super::types::{Element, FrameMember, HouseFrame, Role};
use crate::voxels::{Choice, VoxelArray};

/// A run of grid steps with one role.
#[derive(Clone, Copy, Debug)]
pub(super) struct Stick {
    pub role: Role,
    pub from: [i32; 3],
    pub step: usize,
    pub length: i32,
}

impl Stick {
    pub fn at(&self, n: i32) -> [i32; 3] {
        [0, 1, 2].map(|a| self.from[a] + n * STEPS[self.step][a])
    }

    /// Whether it rises along one axis: a rafter on a slope.
    pub fn is_sloped(&self) -> bool {
        (Z + 1..Z + 5).contains(&self.step)
    }

    /// Soles lie on the foundation: priced, not analysed.
    pub fn is_sole(&self) -> bool {
        self.from[2] == 0 && self.step != Z
    }
}

/// Collects the sticks in scan order (z, then y, then x, then step).
pub(super) fn collect(grid: &mut Grid, out: &mut Vec<Stick>) {
    out.clear();
    grid.each_step(|grid, from, step| start_stick(grid, from, step, out));
}

fn start_stick(grid: &Grid, from: [i32; 3], step: usize, out: &mut Vec<Stick>) {
    let Some(role) = grid.role(from, step) else { return };
    if grid.role(sub(from, STEPS[step]), step) == Some(role) {
        return;
    }
    let mut stick = Stick { role, from, step, length: 1 };
    while grid.role(stick.at(stick.length), step) == Some(role) {
        stick.length += 1;
    }
    out.push(stick);
}

/// Counts how often sticks pass a grid point, ends twice.
fn count_meets(grid: &mut Grid, sticks: &[Stick]) {
    for stick in sticks.iter().filter(|s| !s.is_sole()) {
        for n in 0..=stick.length {
            let p = grid.point(stick.at(n));
            grid.meets[p] = grid.meets[p].saturating_add(1 + u8::from(n == 0 || n == stick.length));
        }
    }
}

/// Counts the meetings of sticks, and drops uprights that hang with nothing at their foot, and roof members and beams that end in the
/// air: short stubs where a roof meets a higher wall or a plateau is ragged. They carry nothing and would swing freely. What such a
/// stub alone held goes with it.
pub(super) fn drop_hanging(grid: &mut Grid, sticks: &mut Vec<Stick>) {
    for _ in 0..4 {
        grid.meets.fill(0);
        count_meets(grid, sticks);
        let before = sticks.len();
        sticks.retain(|s| {
            let met = |p: [i32; 3]| p[2] == 0 || grid.meets[grid.point(p)] > 2;
            let ends = match s.role {
                Role::Hip | Role::Valley | Role::Rafter | Role::Beam => [true, true],
                Role::Stud | Role::CornerPost | Role::Jamb | Role::BeamPost => [true, false],
                Role::Plate | Role::Lintel | Role::Sill | Role::Joist | Role::Trimmer | Role::Ridge => [false, false],
            };
            s.is_sole() || (!ends[0] || met(s.from)) && (!ends[1] || met(s.at(s.length)))
        });
        if sticks.len() == before {
            break;
        }
    }
}

/// Numbers the nodes: grid points where sticks meet or end, as [`drop_hanging`] has counted them.
pub(super) fn number_nodes(grid: &mut Grid, v: &VoxelArray, frame: &mut HouseFrame) {
    let [sx, sy, _] = grid.size();
    for p in 0..grid.meets.len() {
        if grid.meets[p] > 1 {
            grid.node[p] = frame.nodes.len() as u32;
            let (x, y, z) = (p as i32 % sx, p as i32 / sx % sy, p as i32 / (sx * sy));
            frame.nodes.push(position(v, [x, y, z]));
            if z == 0 {
                frame.supports.push(grid.node[p]);
            }
        }
    }
}

/// Metres of a grid point.
pub(super) fn position(v: &VoxelArray, p: [i32; 3]) -> [f64; 3] {
    let half = v.module.size_m.map(|s| 0.5 * s);
    [
        v.origin_m[0] + f64::from(p[0] - 1) * half[0],
        v.origin_m[1] + f64::from(p[1] - 1) * half[1],
        v.origin_m[2] + f64::from(p[2]) * half[2],
    ]
}

/// Makes members and elements of the sticks.
pub(super) fn make_members(grid: &mut Grid, sticks: &[Stick], v: &VoxelArray, frame: &mut HouseFrame) {
    for stick in sticks {
        let member = frame.members.len() as u32;
        let first_chain = frame.chains.len() as u32;
        let first_element = frame.elements.len() as u32;
        if !stick.is_sole() {
            cut(grid, stick, member, frame);
        }
        let ends = [position(v, stick.from), position(v, stick.at(stick.length))];
        let length_m = super::types::distance(ends[0], ends[1]);
        frame.members.push(FrameMember {
            role: stick.role,
            group: group(stick),
            chain: [first_chain, frame.chains.len() as u32],
            first_element,
            length_m,
            plies: plies(stick),
            reference: depth_direction(stick, v),
            facades: facades(stick, v),
            ends,
        });
    }
    double_trimmer_joists(frame);
    free_one_end(frame);
}

/// Joists that carry a header are pairs.
fn double_trimmer_joists(frame: &mut HouseFrame) {
    let mut headed = vec![false; frame.nodes.len()];
    for m in frame.members.iter().filter(|m| m.role == Role::Trimmer) {
        let [a, b] = m.chain.map(|c| c as usize);
        for n in [frame.chains[a], frame.chains[b - 1]] {
            headed[n as usize] = true;
        }
    }
    for m in frame.members.iter_mut().filter(|m| m.role == Role::Joist) {
        let inner = frame.chains[m.chain[0] as usize..m.chain[1] as usize].iter().skip(1).rev().skip(1);
        if inner.into_iter().any(|&n| headed[n as usize]) {
            m.plies = 2;
        }
    }
}

fn cut(grid: &mut Grid, stick: &Stick, member: u32, frame: &mut HouseFrame) {
    let mut last: Option<(u32, bool)> = None;
    let mut element = NONE;
    for n in 0..=stick.length {
        let p = stick.at(n);
        let node = grid.node[grid.point(p)];
        if node != NONE {
            frame.chains.push(node);
            let hinged = n == 0 || n == stick.length || hinged_at(grid, stick, p);
            if let Some((from, from_hinged)) = last {
                frame.elements.push(Element { nodes: [from, node], member, hinged: [from_hinged, hinged] });
            }
            last = Some((node, hinged));
            element = frame.elements.len() as u32;
        }
        if n < stick.length {
            let slot = grid.slot(p, stick.step);
            grid.owner[slot] = element;
        }
    }
}

/// Inside its length a stick is hinged where a wall vertical passes through it; a beam post at every crossing.
fn hinged_at(grid: &Grid, stick: &Stick, p: [i32; 3]) -> bool {
    if stick.step == Z {
        return stick.role == Role::BeamPost;
    }
    let (below, above) = (grid.role(sub(p, STEPS[Z]), Z), grid.role(p, Z));
    below.is_some() && below == above && below != Some(Role::BeamPost)
}

/// Where every stick end at a free node is hinged, the first keeps its rotation so that the node is held; no moment arises.
fn free_one_end(frame: &mut HouseFrame) {
    let mut held = vec![false; frame.nodes.len()];
    for &s in &frame.supports {
        held[s as usize] = true;
    }
    for e in &frame.elements {
        for end in 0..2 {
            held[e.nodes[end] as usize] |= !e.hinged[end];
        }
    }
    for e in &mut frame.elements {
        for end in 0..2 {
            let node = e.nodes[end] as usize;
            if !held[node] {
                held[node] = true;
                e.hinged[end] = false;
            }
        }
    }
}

fn group(stick: &Stick) -> Choice {
    match stick.role {
        Role::Stud | Role::CornerPost | Role::Jamb | Role::Plate | Role::Sill => Choice::Wall,
        Role::Lintel => {
            if stick.length > 2 {
                Choice::Beam
            } else {
                Choice::Wall
            }
        }
        Role::Trimmer if stick.length > 4 => Choice::Beam,
        Role::Joist | Role::Trimmer => Choice::Floor,
        Role::Beam | Role::BeamPost => Choice::Beam,
        Role::Rafter | Role::Hip | Role::Valley | Role::Ridge => Choice::Roof,
    }
}

/// Half modules of a lintel from which two beam sections carry it: 3.6 m.
const WIDE_LINTEL: i32 = 8;

/// Corner posts, jambs, trimmers, hips, valleys and ridges are pairs, as carpenters make them; lintels by span: two of the wall's section
/// over one module, one of the beam's over two and three, two of the beam's beyond.
fn plies(stick: &Stick) -> u8 {
    match stick.role {
        Role::Trimmer => {
            if stick.length > 4 {
                1
            } else {
                2
            }
        }
        Role::CornerPost | Role::Jamb | Role::Hip | Role::Valley | Role::Ridge => 2,
        Role::Lintel if stick.length <= 2 || stick.length >= WIDE_LINTEL => 2,
        _ => 1,
    }
}

/// Whether a vertical step or a level step on a face plane stands in a facade: the bits of its outward directions.
fn facades(stick: &Stick, v: &VoxelArray) -> u8 {
    if stick.step != Z {
        return 0;
    }
    // At half height: a stick that starts or ends on a plate has house on both sides there.
    let k = super::place::layer(stick.at(stick.length / 2)[2]).max(1);
    let filled = |x: i32, y: i32| super::grid::label(v, x, y, k).is_filled();
    let [x, y] = [stick.from[0], stick.from[1]];
    let (west, east) = ((x - 1).div_euclid(2), x / 2);
    let (south, north) = ((y - 1).div_euclid(2), y / 2);
    let mut bits = 0;
    for j in [south, north] {
        bits |= u8::from(filled(west, j) && !filled(east, j)) | (u8::from(filled(east, j) && !filled(west, j)) << 2);
    }
    for i in [west, east] {
        bits |= (u8::from(filled(i, south) && !filled(i, north)) << 1)
            | (u8::from(filled(i, north) && !filled(i, south)) << 3);
    }
    bits
}

/// Depth of verticals across their wall, of eave plates level; others stand upright.
fn depth_direction(stick: &Stick, v: &VoxelArray) -> Option<[f64; 3]> {
    if stick.step == Z {
        let bits = facades(stick, v);
        return (bits & 0b0101 == 0 && bits & 0b1010 != 0).then_some([0.0, 1.0, 0.0]);
    }
    let eave = stick.role == Role::Plate && stick.from[2] % super::grid::STOREY != 0;
    eave.then_some(if stick.step == super::grid::X { [0.0, 1.0, 0.0] } else { [1.0, 0.0, 0.0] })
}
