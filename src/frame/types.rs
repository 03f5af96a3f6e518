//! What a frame consists of.

use super::sheathing::Panel;
use crate::voxels::{Boards, Choice, Direction};

/// What a stick is in the house.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
#[repr(u8)]
pub enum Role {
    /// Wall stud on a voxel centre line, foundation (or lintel) to eave.
    Stud = 0,
    /// Stud pair at a wall corner.
    CornerPost = 1,
    /// Stud pair beside an opening, plate to plate.
    Jamb = 2,
    /// Wall plate, rim or sole.
    Plate = 3,
    /// Beam over an opening.
    Lintel = 4,
    /// Rail under a window.
    Sill = 5,
    /// Floor joist.
    Joist = 6,
    /// Edge of a stair void.
    Trimmer = 7,
    /// Bearing line under long joists, or sill of an upper wall that stands on a floor.
    Beam = 8,
    /// Post under a beam.
    BeamPost = 9,
    /// Rafter, sloped or level on a plateau.
    Rafter = 10,
    /// Hip rafter.
    Hip = 11,
    /// Valley rafter.
    Valley = 12,
    /// Ridge, or edge of a roof's plateau.
    Ridge = 13,
}

impl Role {
    /// All roles in the order of their codes.
    pub const ALL: [Role; 14] = [
        Role::Stud,
        Role::CornerPost,
        Role::Jamb,
        Role::Plate,
        Role::Lintel,
        Role::Sill,
        Role::Joist,
        Role::Trimmer,
        Role::Beam,
        Role::BeamPost,
        Role::Rafter,
        Role::Hip,
        Role::Valley,
        Role::Ridge,
    ];

    /// Name in files and messages.
    pub fn name(self) -> &'static str {
        const NAMES: [&str; 14] = [
            "stud",
            "corner post",
            "jamb",
            "plate",
            "lintel",
            "sill",
            "joist",
            "trimmer",
            "beam",
            "beam post",
            "rafter",
            "hip",
            "valley",
            "ridge",
        ];
        NAMES[self as usize]
    }

    /// Stud, corner post, jamb or beam post.
    #[inline]
    pub fn is_vertical(self) -> bool {
        matches!(self, Role::Stud | Role::CornerPost | Role::Jamb | Role::BeamPost)
    }

    /// Whether boards on the member hold its weak direction, so that it buckles and tips in its strong plane only.
    #[inline]
    pub fn is_sheathed(self) -> bool {
        self != Role::BeamPost
    }
}

/// One stick: a straight run of elements with one role and section.
#[derive(Clone, Debug, PartialEq)]
pub struct FrameMember {
    /// What it is.
    pub role: Role,
    /// Which choice of the house sets its section. Lintels wider than one module take the beam's section.
    pub group: Choice,
    /// Nodes along the stick: a range of [`HouseFrame::chains`]. Empty for soles, which lie on the foundation.
    pub chain: [u32; 2],
    /// First element; a stick of n nodes has n - 1 elements.
    pub first_element: u32,
    /// Length between its end points, m (one ply).
    pub length_m: f64,
    /// Parallel sections side by side.
    pub plies: u8,
    /// Direction of the section's depth; `None` for the solver's default (global Z, or X for verticals).
    pub reference: Option<[f64; 3]>,
    /// Facades whose plane the stick stands in: bit `Direction as u8`.
    pub facades: u8,
    /// End points, m.
    pub ends: [[f64; 3]; 2],
}

impl FrameMember {
    /// Number of elements.
    pub fn element_count(&self) -> usize {
        (self.chain[1] - self.chain[0]).saturating_sub(1) as usize
    }

    /// Its elements in [`HouseFrame::elements`].
    pub fn elements(&self) -> std::ops::Range<usize> {
        let first = self.first_element as usize;
        first..first + self.element_count()
    }
}

/// A piece of a stick between two nodes: what the solver calls a member.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Element {
    /// End nodes.
    pub nodes: [u32; 2],
    /// The stick.
    pub member: u32,
    /// Whether bending is released at each end.
    pub hinged: [bool; 2],
}

/// Longest stock, m: finger-jointed solid construction timber (KVH) leaves the works in lengths of 13 m (trade lexicon of
/// mdh-content.de, entry "KVH", read 2026-11); glulam is sold longer, but a trailer's bed is 13.6 m. Solid sawn timber without finger
/// joints ends at about 6 m: ask for that with [`super::FrameOptions::stock_m`].
pub const STOCK_LENGTH_M: f64 = 13.0;

/// What a loaded area is. The area goes to elements as a width: area / element length.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Area {
    /// Floor of a storey.
    Floor,
    /// Floor of a roof space without standing room.
    Attic,
    /// Deck in front of a storey.
    Deck,
    /// Flat roof.
    FlatRoof,
    /// Underside of a projecting floor.
    Soffit,
    /// Stair: plan area of half the flights, on the trimmer at its head.
    Stair,
    /// Wall, facing out.
    Wall(Direction),
    /// Edge of a floor plate or the foundation's plinth, facing out.
    Band(Direction),
    /// Window, facing out.
    Window(Direction),
    /// Door, facing out.
    Door(Direction),
    /// Roof slope, *plan* area, facing the direction it falls to.
    Slope(Direction),
    /// Level part of a pitched roof.
    Plateau,
}

impl Area {
    /// Number of kinds.
    pub const KINDS: usize = 12;

    /// Which kind it is, whatever it faces.
    pub fn kind(self) -> usize {
        match self {
            Area::Floor => 0,
            Area::Attic => 1,
            Area::Deck => 2,
            Area::FlatRoof => 3,
            Area::Soffit => 4,
            Area::Stair => 5,
            Area::Wall(_) => 6,
            Area::Band(_) => 7,
            Area::Window(_) => 8,
            Area::Door(_) => 9,
            Area::Slope(_) => 10,
            Area::Plateau => 11,
        }
    }
}

/// Part of a loaded area carried by an element.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ElementArea {
    /// The element.
    pub element: u32,
    /// What the area is.
    pub area: Area,
    /// m2 (plan area for slopes).
    pub area_m2: f64,
}

/// A clear length of a stick between two of its supports: buckling length and chord of the deflection.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Span {
    /// The stick.
    pub member: u32,
    /// First and last element, both included.
    pub elements: [u32; 2],
    /// Whether the start and the end are held; one of them is false for a cantilever.
    pub held: [bool; 2],
}

/// A floor level or the eave, for storey drift.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Level {
    /// Height above the foundation, m.
    pub z_m: f64,
    /// Nodes of verticals at this level.
    pub nodes: Vec<u32>,
}

/// A house's frame.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct HouseFrame {
    /// Coordinates, m.
    pub nodes: Vec<[f64; 3]>,
    /// Sticks, soles included.
    pub members: Vec<FrameMember>,
    /// Node numbers along the sticks, see [`FrameMember::chain`].
    pub chains: Vec<u32>,
    /// Pieces between nodes.
    pub elements: Vec<Element>,
    /// Sheathing.
    pub panels: Vec<Panel>,
    /// Nodes on the foundation. Held in all directions; the members end there with hinges.
    pub supports: Vec<u32>,
    /// Areas carried.
    pub areas: Vec<ElementArea>,
    /// Weight of the layers that areas carry, N a m2 of area by [`Area::kind`], as the house's own take-off has them; `None` for those
    /// of a square metre of each build-up.
    pub layers_n_m2: Option<[f64; Area::KINDS]>,
    /// Clear lengths.
    pub spans: Vec<Span>,
    /// Foundation, floor levels and eave, lowest first.
    pub levels: Vec<Level>,
    /// Which sides of the walls carry boards.
    pub boards: Boards,
    /// Outer size of the house along x and y and its height to the top of the frame, m.
    pub size_m: [f64; 3],
    /// Roof pitch in degrees; 0 when there is no slope.
    pub pitch_deg: f64,
    /// Module along x, y, z, m.
    pub module_m: [f64; 3],
}

impl HouseFrame {
    /// Nodes along a stick.
    pub fn chain(&self, member: usize) -> &[u32] {
        let [a, b] = self.members[member].chain;
        &self.chains[a as usize..b as usize]
    }

    /// Length of an element, m.
    pub fn element_length_m(&self, element: usize) -> f64 {
        let [a, b] = self.elements[element].nodes;
        distance(self.nodes[a as usize], self.nodes[b as usize])
    }

    /// Metres of stick by [`Choice`] (wall, floor, beam, roof), every ply counted.
    pub fn length_by_group_m(&self) -> [f64; 4] {
        let mut sum = [0.0; 4];
        for m in &self.members {
            sum[m.group as usize] += m.length_m * f64::from(m.plies);
        }
        sum
    }
}

/// Distance of two points.
pub(crate) fn distance(a: [f64; 3], b: [f64; 3]) -> f64 {
    ((a[0] - b[0]).powi(2) + (a[1] - b[1]).powi(2) + (a[2] - b[2]).powi(2)).sqrt()
}
