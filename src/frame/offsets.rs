//! Where the timber lies beside its axis: data for drawings, connections and whoever wants to count the eccentricities.

use super::types::{FrameMember, HouseFrame, Role};
use crate::voxels::Direction;

/// The line that a role's axis is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum AxisLine {
    /// In the facade plane, the outer face of the wall; the timber lies inwards.
    Facade,
    /// In the top of the slab; the timber lies below.
    SlabTop,
    /// In the roof surface under the covering; the timber lies below, across the slope.
    Roof,
    /// The timber's own centre line.
    Centre,
}

impl AxisLine {
    /// Name in files.
    pub fn name(self) -> &'static str {
        match self {
            AxisLine::Facade => "outer face of the wall, timber inwards",
            AxisLine::SlabTop => "top of the slab, timber below",
            AxisLine::Roof => "roof surface under the covering, timber below across the slope",
            AxisLine::Centre => "centre line",
        }
    }
}

/// How far a role's centre line lies from the axis it is analysed on: `layers_m + depths x h`, h the depth of the section.
///
/// The analysis neglects these distances: sticks meet on their axes. What that leaves out are moments force x distance where the
/// distances of two sticks at a joint differ, for example of a joist's reaction on a stud (half the stud's depth) or of a rafter on its
/// plate; platform framing puts plates and sheathing there, which take them as force couples.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AxisOffset {
    /// The role.
    pub role: Role,
    /// What the axis is.
    pub axis: AxisLine,
    /// Layers between axis and timber, m: 30 mm of cladding on battens and 20 mm of boards outside the studs; 22 mm of deck on joists,
    /// 22 mm of boards on rafters (nominal; build-ups may differ).
    pub layers_m: f64,
    /// Depths of the section from there to the centre line: 0.5, or 0.
    pub depths: f64,
}

/// The offsets of all roles in the order of [`Role::ALL`].
pub fn axis_offsets() -> [AxisOffset; 14] {
    Role::ALL.map(|role| {
        let (axis, layers_m, depths) = match role {
            Role::Stud | Role::CornerPost | Role::Jamb | Role::Lintel | Role::Sill => (AxisLine::Facade, 0.05, 0.5),
            // Rims and joists hang under the deck; the eaves' plates lie flat on the studs.
            Role::Plate | Role::Joist | Role::Trimmer | Role::Beam => (AxisLine::SlabTop, 0.022, 0.5),
            Role::Rafter | Role::Hip | Role::Valley | Role::Ridge => (AxisLine::Roof, 0.022, 0.5),
            Role::BeamPost => (AxisLine::Centre, 0.0, 0.0),
        };
        AxisOffset { role, axis, layers_m, depths }
    })
}

/// For every member the vector from its analysed axis to the centre line of its timber, m, global axes: [`axis_offsets`] with the
/// `depths_m` of the sections of wall, floor, beam and roof. Posts and jambs at a corner go inwards from both facades; zero where
/// the axis is the centre line, or where a stick stands in no facade.
pub fn member_offsets(frame: &HouseFrame, depths_m: [f64; 4]) -> Vec<[f64; 3]> {
    let offsets = axis_offsets();
    let mut facades = vec![0u8; frame.nodes.len()];
    for (n, m) in frame.members.iter().enumerate().filter(|(_, m)| m.role.is_vertical()) {
        frame.chain(n).iter().for_each(|&node| facades[node as usize] |= m.facades);
    }
    let of = |(n, m): (usize, &FrameMember)| {
        let o = offsets[m.role as usize];
        let distance = o.layers_m + o.depths * depths_m[m.group as usize];
        let along = unit([0, 1, 2].map(|a| m.ends[1][a] - m.ends[0][a]));
        let towards = match o.axis {
            AxisLine::Centre => [0.0; 3],
            AxisLine::SlabTop => [0.0, 0.0, -1.0],
            AxisLine::Roof => unit([along[2] * along[0], along[2] * along[1], along[2] * along[2] - 1.0]),
            AxisLine::Facade if m.role.is_vertical() => inwards(m.facades, along),
            AxisLine::Facade => inwards(frame.chain(n).iter().fold(0, |bits, &n| bits | facades[n as usize]), along),
        };
        towards.map(|t| t * distance)
    };
    frame.members.iter().enumerate().map(of).collect()
}

/// Inwards from facades that a stick does not run across: the sum of their directions.
fn inwards(facades: u8, along: [f64; 3]) -> [f64; 3] {
    let mut sum = [0.0; 3];
    for d in Direction::ALL.into_iter().filter(|&d| facades & (1 << d as u8) != 0) {
        let [x, y] = d.step().map(|s| s as f64);
        if (x * along[0] + y * along[1]).abs() < 0.5 {
            sum = [sum[0] - x, sum[1] - y, 0.0];
        }
    }
    sum
}

fn unit(v: [f64; 3]) -> [f64; 3] {
    let length = v.iter().map(|c| c * c).sum::<f64>().sqrt();
    if length > 1e-9 { v.map(|c| c / length) } else { [0.0; 3] }
}
