//! Which part the members of the frame are built into.

use super::types::{Part, PartKind, Parts};
use crate::frame::{HouseFrame, Role};
use crate::voxels::{Direction, STOREY_MODULES};

/// Members further from every part than this are built in on site, modules: inner posts under beams.
const REACH_MODULES: f64 = 1.0;

/// Masses of the frame's members in kg by part, and of those that are in none.
pub(super) struct FrameMasses {
    pub part_kg: Vec<f64>,
    pub loose_kg: f64,
}

/// What a role is built into.
fn kinds(role: Role) -> &'static [PartKind] {
    match role {
        Role::Stud | Role::CornerPost | Role::Jamb | Role::Plate | Role::Lintel | Role::Sill => &[PartKind::Wall],
        Role::Joist | Role::Trimmer | Role::Beam => &[PartKind::Floor, PartKind::Deck],
        Role::Rafter | Role::Hip | Role::Valley | Role::Ridge => &[PartKind::Slope, PartKind::Level, PartKind::Deck],
        Role::BeamPost => &[],
    }
}

/// A flat box that stands for a cell of a part, in modules.
struct Patch {
    part: usize,
    kind: PartKind,
    low: [f64; 3],
    high: [f64; 3],
}

impl Patch {
    fn distance(&self, p: [f64; 3]) -> f64 {
        (0..3).map(|a| (self.low[a] - p[a]).max(p[a] - self.high[a]).max(0.0).powi(2)).sum::<f64>().sqrt()
    }
}

fn patches(parts: &Parts) -> Vec<Patch> {
    let mut out = Vec::with_capacity(parts.cells.len());
    for (n, part) in parts.parts.iter().enumerate().filter(|(_, p)| p.kind.is_flat()) {
        out.extend(parts.cells_of(part).iter().map(|c| {
            let [x, y, k] = [f64::from(c.cell[0]), f64::from(c.cell[1]), f64::from(c.k)];
            let (mut low, mut high) = ([x - 0.5, y - 0.5, k], [x + 0.5, y + 0.5, k]);
            if let (PartKind::Wall, Some(facing)) = (part.kind, part.facing) {
                stand(&mut low, &mut high, facing, part, c.code);
            }
            Patch { part: n, kind: part.kind, low, high }
        }));
    }
    out
}

/// Turns the square of a cell into its facade.
fn stand(low: &mut [f64; 3], high: &mut [f64; 3], facing: Direction, part: &Part, code: u16) {
    let step = facing.step();
    let axis = usize::from(step[0] == 0);
    if step[axis] > 0 {
        low[axis] = high[axis]
    } else {
        high[axis] = low[axis]
    }
    let base = (usize::from(part.level) * STOREY_MODULES) as f64;
    low[2] = base + 0.5 * f64::from(code.trailing_zeros().min(12));
    high[2] = base + 0.5 * f64::from(16 - code.leading_zeros());
}

/// Shares the frame's mass out: every member in steps of at most half a module, each to the nearest part of the kinds that its role is
/// built into. `kg_per_m` is the mass of one ply by wall, floor, beam, roof.
pub(super) fn frame_masses(parts: &Parts, frame: &HouseFrame, kg_per_m: [f64; 4]) -> FrameMasses {
    let patches = patches(parts);
    let mut out = FrameMasses { part_kg: vec![0.0; parts.parts.len()], loose_kg: 0.0 };
    let modules = |p: [f64; 3]| [0, 1, 2].map(|a| (p[a] - parts.origin_m[a]) / parts.module_m[a]);
    for member in &frame.members {
        let kinds = kinds(member.role);
        let [a, b] = member.ends.map(modules);
        let span = (0..3).map(|n| (b[n] - a[n]).abs()).fold(0.0, f64::max);
        let pieces = (2.0 * span).ceil().max(1.0);
        let kg = member.length_m * f64::from(member.plies) * kg_per_m[member.group as usize] / pieces;
        for n in 0..pieces as usize {
            let t = (n as f64 + 0.5) / pieces;
            let p = [0, 1, 2].map(|i| a[i] + t * (b[i] - a[i]));
            let near = patches.iter().filter(|patch| kinds.contains(&patch.kind)).map(|q| (q.distance(p), q.part));
            // Whole millionths of a module, so that of parts equally near the first is taken whatever the last bits say.
            let nearest = near.min_by_key(|(distance, part)| ((distance * 1e6).round() as u64, *part));
            match nearest.filter(|(distance, _)| *distance <= REACH_MODULES) {
                Some((_, part)) => out.part_kg[part] += kg,
                None => out.loose_kg += kg,
            }
        }
    }
    out
}
