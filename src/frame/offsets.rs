//! Where the timber lies beside its axis: data for drawings, connections and whoever wants to count the eccentricities.

use super::types::Role;

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
