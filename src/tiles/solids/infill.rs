//! Windows and doors: frames, glass, leaves, reveals and sills in the strip that the wall leaves out.
//!
//! A wall shows a quarter patch in each half of a column; infill patches of one label read as one opening. Voxel borders are the
//! cube's middle planes, so bars stand there and never on a cube face, except at the foot of an opening on a slab: whatever reaches
//! a cube face goes on in the neighbour, because both read it from the labels of that face.

use super::super::{Block, Component, depth_um};
use super::border::{Border, HALF_UM};
use super::edges;
use super::{Columns, Half, Post, SolidStyle};
use crate::voxels::{Label, MULLION_M};

/// Half of a mullion between two window voxels, µm: what the rules count as glass and what is drawn is one number.
const MULLION_UM: i32 = (MULLION_M * 500_000.0) as i32;
/// Width of the frame bars of doors: a module then leaves 850 mm clear, as entrances need (`RuleSettings::door_frame_m`).
pub const DOOR_BAR_UM: i32 = 25_000;
/// Depth of frame bars.
const FRAME_UM: i32 = 70_000;
/// Thickness of a pane, in the middle of the frame's depth.
const GLASS_UM: i32 = 12_000;
/// Depth of a door leaf, in the middle of the frame's depth.
const LEAF_UM: i32 = 50_000;
/// Thickness of reveal boards.
const BOARD_UM: i32 = 15_000;
/// Thickness of sills and of the threshold of a door.
const SILL_UM: i32 = 20_000;
/// How far a sill projects before the facade.
const SILL_NOSE_UM: i32 = 45_000;
/// Side of the square section of a door pull, and the gap between it and the leaf.
const PULL_UM: [i32; 2] = [25_000, 45_000];
/// From the edge of the leaf to its pull; from the foot and from the head of the leaf to the pull's ends.
const PULL_AT_UM: [i32; 3] = [65_000, 200_000, 90_000];
/// Heights of the two halves of a cube.
const HALVES_UM: [[i32; 2]; 2] = [[0, 270_000], [270_000, 540_000]];

/// What an infill patch meets at one of its borders.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Meets {
    /// The same opening: it goes on.
    Same,
    /// A window at a door or the other way round.
    Other,
    /// Wall, or the slab the opening stands on.
    Wall,
}

impl Meets {
    fn of(label: Label, beyond: Option<Label>) -> Meets {
        match beyond {
            Some(other) if other == label => Meets::Same,
            Some(_) => Meets::Other,
            None => Meets::Wall,
        }
    }
}

/// A rectangle of one opening in one column: one half of the cube or both.
struct Patch<'a> {
    style: &'a SolidStyle,
    border: Border,
    octant: usize,
    label: Label,
    z: [i32; 2],
    beside: Meets,
    foot: Meets,
    head: Meets,
    /// Depth of the wall and of the frame's outer face.
    wall: i32,
    reveal: i32,
    /// From which distance to the middle plane the sill may project, at the facade and at its nose.
    nose_from: [i32; 2],
}

/// Adds the windows and doors of a cube: disjoint blocks within the wall's depth, but for sills and pulls, which project.
pub fn build(columns: &Columns, style: &SolidStyle, blocks: &mut Vec<Block>) {
    let wall = depth_um(&columns.shells.wall);
    let reveal = style.reveal_um.min(wall - FRAME_UM).max(0);
    for (q, axis) in (0..4).flat_map(|q| [(q, 0), (q, 1)]) {
        let border = Border { q, axis };
        let own = [Half::Lower, Half::Upper].map(|half| columns.infill(q, axis, half));
        let beside = [Half::Lower, Half::Upper].map(|half| columns.infill(border.beside(), axis, half));
        let patch = |halves: [usize; 2], label: Label| Patch {
            style,
            border,
            // On a slab the lower half takes the label above, too.
            octant: if halves[1] == 1 || columns.below(q).is_slab() { q + 4 } else { q },
            label,
            z: [HALVES_UM[halves[0]][0], HALVES_UM[halves[1]][1]],
            beside: Meets::of(label, beside[halves[0]]),
            foot: match halves[0] {
                0 if columns.below(q).is_slab() => Meets::Wall,
                0 => Meets::Same,
                _ => Meets::of(label, own[0]),
            },
            head: if halves[1] == 1 { Meets::Same } else { Meets::of(label, own[1]) },
            wall,
            reveal,
            nose_from: nose_from_um(columns, border, style, halves[0]),
        };
        match own {
            [Some(lower), Some(upper)]
                if lower == upper && Meets::of(lower, beside[0]) == Meets::of(upper, beside[1]) =>
            {
                patch([0, 1], upper).emit(blocks);
            }
            _ => {
                for (half, label) in own.into_iter().enumerate() {
                    if let Some(label) = label {
                        patch([half, half], label).emit(blocks);
                    }
                }
            }
        }
    }
}

/// From which distance to the middle plane a sill may project, at the facade and at its nose: not where eaves, gutters or the edge of
/// a deck arrive from the side. In a re-entrant corner two sills of equal height meet in a mitre.
fn nose_from_um(columns: &Columns, border: Border, style: &SolidStyle, half: usize) -> [i32; 2] {
    let (front, diagonal) = (border.across(), border.q ^ 3);
    let infill = |half| columns.infill(diagonal, 1 - border.axis, half).is_some();
    let stands = match half {
        0 => infill(Half::Lower) && columns.below(diagonal).is_slab(),
        _ => infill(Half::Upper) && !infill(Half::Lower),
    };
    match (columns.post(front), columns.post(diagonal)) {
        (Post::Empty | Post::Deck, Post::Full) if stands => [0, SILL_NOSE_UM],
        (Post::Empty, Post::Empty | Post::Full | Post::Floor) => [0; 2],
        (Post::Deck, _) if edges::deck_depth_um(columns, front) > HALVES_UM[1][0] => [HALF_UM; 2],
        (Post::Deck, Post::Deck | Post::Full) => [0; 2],
        (Post::Empty | Post::Deck | Post::Full | Post::Roof | Post::Floor, _) => {
            [edges::side_reach_um(style).min(HALF_UM); 2]
        }
    }
}

impl Patch<'_> {
    fn put(&self, blocks: &mut Vec<Block>, component: Component, depth: [i32; 2], aside: [i32; 2], z: [i32; 2]) {
        blocks.extend(self.border.cuboid(component, self.octant, depth, aside, z));
    }

    fn emit(&self, blocks: &mut Vec<Block>) {
        let inner = self.frame(blocks);
        self.lining(blocks);
        match self.label {
            Label::Window => {
                let middle = self.reveal + FRAME_UM / 2;
                let depth = [middle - GLASS_UM / 2, middle + GLASS_UM / 2];
                self.put(blocks, Component::Glass, depth, [inner[0], HALF_UM], [inner[1], inner[2]]);
            }
            Label::Opening => self.leaf(blocks, inner),
            // `Columns::infill` names no other label.
            Label::Empty | Label::Base | Label::Floor | Label::Foundation => {}
        }
    }

    /// Bars; returns what they leave: distance to the middle plane, foot and head.
    fn frame(&self, blocks: &mut Vec<Block>) -> [i32; 3] {
        let door = self.label == Label::Opening;
        let bar = if door { DOOR_BAR_UM } else { self.style.bar_um };
        let depth = [self.reveal, self.reveal + FRAME_UM];
        let component = if door { Component::DoorFrame } else { Component::WindowFrame };
        let foot = match self.foot {
            Meets::Same => 0,
            // A door has no bar to step over, only a threshold that covers the wall's or the slab's edge.
            Meets::Wall if door => SILL_UM,
            Meets::Wall | Meets::Other => bar,
        };
        let head = if self.head == Meets::Same { 0 } else { bar };
        let inner = [
            match self.beside {
                Meets::Same if door => 0,
                Meets::Same => MULLION_UM,
                Meets::Other | Meets::Wall => bar,
            },
            self.z[0] + foot,
            self.z[1] - head,
        ];
        // At the border of the opening the upright runs through; a mullion stands between the bars.
        let through = self.beside != Meets::Same;
        let upright = if through { self.z } else { [inner[1], inner[2]] };
        let from = if through { inner[0] } else { 0 };
        self.put(blocks, component, depth, [0, inner[0]], upright);
        let plate = if door && self.foot == Meets::Wall { Component::Sill } else { component };
        self.put(blocks, plate, depth, [from, HALF_UM], [self.z[0], inner[1]]);
        self.put(blocks, component, depth, [from, HALF_UM], [inner[2], self.z[1]]);
        inner
    }

    /// Reveal boards outside and inside of the frame, and the sill: together with the frame they close the wall's cut.
    fn lining(&self, blocks: &mut Vec<Block>) {
        let [out, room] = [[0, self.reveal], [self.reveal + FRAME_UM, self.wall]];
        let foot = self.foot == Meets::Wall;
        for (depth, sill) in [(out, SILL_UM), (room, BOARD_UM)] {
            let [z0, z1] = self.z;
            let raised = if foot { z0 + sill } else { z0 };
            let side = if self.beside == Meets::Wall { BOARD_UM } else { 0 };
            let below = if self.head == Meets::Wall { z1 - BOARD_UM } else { z1 };
            self.put(blocks, Component::Reveal, depth, [0, side], [raised, z1]);
            self.put(blocks, Component::Reveal, depth, [side, HALF_UM], [below, z1]);
            let component = if sill == SILL_UM { Component::Sill } else { Component::Reveal };
            self.put(blocks, component, depth, [0, HALF_UM], [z0, raised]);
        }
        if foot {
            let z = [self.z[0], self.z[0] + SILL_UM];
            let [facade, nose] = self.nose_from;
            let plan = [[0, facade], [0, HALF_UM], [-SILL_NOSE_UM, HALF_UM], [-SILL_NOSE_UM, nose]];
            if nose < HALF_UM {
                blocks.extend(self.border.prism(Component::Sill, self.octant, &plan, |_| z));
            }
        }
    }

    /// The leaf, and an upright pull outside and inside.
    ///
    /// Pulls stand at the right-hand border of a door as seen from outside. Which border opens must follow from one cube's labels, and
    /// there the left leaf of a wide door looks like a single leaf: a pull where two voxels meet would give single doors none or wide
    /// ones three. So a door of any width is one leaf with one pull.
    fn leaf(&self, blocks: &mut Vec<Block>, [aside, foot, head]: [i32; 3]) {
        let outer = self.reveal + (FRAME_UM - LEAF_UM) / 2;
        self.put(blocks, Component::DoorLeaf, [outer, outer + LEAF_UM], [aside, HALF_UM], [foot, head]);
        // Outwards along x the right hand is +y, outwards along +y it is -x.
        let low = |axis: usize| self.border.q >> axis & 1 == 0;
        let right = if self.border.axis == 0 { low(0) == low(1) } else { low(0) != low(1) };
        if !right || self.beside == Meets::Same {
            return;
        }
        let from = if self.foot == Meets::Same { foot } else { foot + PULL_AT_UM[1] };
        let to = if self.head == Meets::Same { head } else { head - PULL_AT_UM[2] };
        let across = [aside + PULL_AT_UM[0], aside + PULL_AT_UM[0] + PULL_UM[0]];
        let [near, far] = [PULL_UM[1], PULL_UM[1] + PULL_UM[0]];
        for (face, out) in [(outer, -1), (outer + LEAF_UM, 1)] {
            let span = |a: i32, b: i32| [(face + out * a).min(face + out * b), (face + out * a).max(face + out * b)];
            self.put(blocks, Component::Handle, span(near, far), across, [from, to]);
            // Fixings stand where the pull ends in this cube.
            let fixing = |z: i32| [z, z + PULL_UM[0]];
            if self.foot != Meets::Same && from < to {
                self.put(blocks, Component::Handle, span(0, near), across, fixing(from));
            }
            if self.head != Meets::Same && to - from >= 2 * PULL_UM[0] {
                self.put(blocks, Component::Handle, span(0, near), across, fixing(to - PULL_UM[0]));
            }
        }
    }
}
