//! What can be counted: items and their groups, and the materials of the frame.

use serde::{Deserialize, Serialize};

use super::Unit;
use crate::envelope::Surface;

/// Section of a bill.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Group {
    /// Members of the frame.
    Frame,
    /// Walls, roofs, decks, soffits.
    Envelope,
    /// Windows and doors.
    Openings,
    /// Inner floors.
    Floors,
    /// Stairs and railings.
    Stairs,
    /// Slab, perimeter beam and edge insulation.
    Foundation,
    /// Work in the factory: waste, labour, set-up, and what repetition saves.
    Manufacture,
    /// Transport, crane, assembly and work on site.
    Site,
}

impl Group {
    /// All groups in the order of a bill.
    pub const ALL: [Group; 8] = [
        Group::Frame,
        Group::Envelope,
        Group::Openings,
        Group::Floors,
        Group::Stairs,
        Group::Foundation,
        Group::Manufacture,
        Group::Site,
    ];

    /// Name in files.
    pub fn name(self) -> &'static str {
        match self {
            Group::Frame => "frame",
            Group::Envelope => "envelope",
            Group::Openings => "openings",
            Group::Floors => "floors",
            Group::Stairs => "stairs",
            Group::Foundation => "foundation",
            Group::Manufacture => "manufacture",
            Group::Site => "site",
        }
    }
}

/// Role group of a frame member: the four groups that choose a section.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, PartialOrd, Ord)]
#[repr(u8)]
pub enum FrameGroup {
    /// Studs, posts, plates, lintels, sills.
    #[default]
    Wall = 0,
    /// Joists and trimmers.
    Floor = 1,
    /// Bearing beams and their posts.
    Beam = 2,
    /// Rafters, hips, ridges, valleys.
    Roof = 3,
}

impl FrameGroup {
    /// All groups in storage order.
    pub const ALL: [FrameGroup; 4] = [FrameGroup::Wall, FrameGroup::Floor, FrameGroup::Beam, FrameGroup::Roof];

    /// The group with index 0..4.
    pub fn from_index(index: usize) -> Option<FrameGroup> {
        Self::ALL.get(index).copied()
    }

    /// Name in files.
    pub fn name(self) -> &'static str {
        match self {
            FrameGroup::Wall => "wall frame",
            FrameGroup::Floor => "floor frame",
            FrameGroup::Beam => "beams",
            FrameGroup::Roof => "roof frame",
        }
    }
}

/// Material of a frame member, as far as it decides price and carbon.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord, Serialize, Deserialize)]
#[repr(u8)]
pub enum FrameMaterial {
    /// Hollow sections of S235.
    S235 = 0,
    /// Hollow sections of S355.
    S355 = 1,
    /// Sawn softwood C24.
    C24 = 2,
    /// Glued laminated timber GL24h.
    GL24h = 3,
    /// Glued laminated timber GL28h.
    GL28h = 4,
}

impl FrameMaterial {
    /// All materials in storage order.
    pub const ALL: [FrameMaterial; 5] =
        [FrameMaterial::S235, FrameMaterial::S355, FrameMaterial::C24, FrameMaterial::GL24h, FrameMaterial::GL28h];

    /// The material of a catalogue id; the hot-finished grades S235H and S355H are billed as S235 and S355.
    pub fn from_id(id: &str) -> Option<FrameMaterial> {
        match id {
            "S235" | "S235H" => Some(FrameMaterial::S235),
            "S355" | "S355H" => Some(FrameMaterial::S355),
            "C24" => Some(FrameMaterial::C24),
            "GL24h" => Some(FrameMaterial::GL24h),
            "GL28h" => Some(FrameMaterial::GL28h),
            _ => None,
        }
    }

    /// Catalogue id.
    pub fn id(self) -> &'static str {
        match self {
            FrameMaterial::S235 => "S235",
            FrameMaterial::S355 => "S355",
            FrameMaterial::C24 => "C24",
            FrameMaterial::GL24h => "GL24h",
            FrameMaterial::GL28h => "GL28h",
        }
    }

    /// What it is billed as: one item per material.
    pub fn item(self) -> Item {
        Item::ALL[Item::FrameS235 as usize + self as usize]
    }
}

/// An item of the take-off: what has a rate of its own.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
#[repr(usize)]
pub enum Item {
    /// Outer wall, m2 of outer face without openings.
    Wall = 0,
    /// Edge of a floor plate in the facade, m2.
    Band = 1,
    /// Edge of the foundation, m2 of its outer face; where solids are drawn, as deep as the perimeter beam.
    Plinth = 2,
    /// Windows, m2 of opening.
    Window = 3,
    /// Outer doors, pieces.
    Door = 4,
    /// Pitched roof, m2 along the slope.
    PitchedRoof = 5,
    /// Flat roof and decks that are not walked on, m2.
    FlatRoof = 6,
    /// Decks that are walked on, m2.
    Deck = 7,
    /// Undersides of projecting storeys, m2.
    Soffit = 8,
    /// Foundation slab, m2; where solids are drawn, inside the perimeter beam.
    Ground = 9,
    /// Inner floors, m2 net; where solids are drawn, with those of storeys that jut out, which soffits insulate from below.
    InnerFloor = 10,
    /// Stairs, pieces of one storey.
    Stair = 11,
    /// Railings, m.
    Railing = 12,
    /// Perimeter beam of the foundation, m; where solids are drawn, along its axis.
    PerimeterBeam = 13,
    /// Roof that reaches over eaves and verges, m2 of its plane.
    Overhang = 14,
    /// Gutters along eaves, m.
    Gutter = 15,
    /// Parapets of roofs that are not walked on, m2 of their outer face above the roof.
    Parapet = 16,
    /// Metal copings of parapets and flush roof edges, m.
    Coping = 17,
    /// Outer wall with boards on both sides of its studs, m2 of outer face without openings: instead of [`Item::Wall`].
    WallBothSides = 18,
    /// Frame of S235, kg.
    FrameS235 = 19,
    /// Frame of S355, kg.
    FrameS355 = 20,
    /// Frame of C24, m3.
    FrameC24 = 21,
    /// Frame of GL24h, m3.
    FrameGl24h = 22,
    /// Frame of GL28h, m3.
    FrameGl28h = 23,
}

impl Item {
    /// Number of items.
    pub const COUNT: usize = 24;

    /// All items in storage order; the first ten are the surfaces of the envelope in their order.
    pub const ALL: [Item; Item::COUNT] = [
        Item::Wall,
        Item::Band,
        Item::Plinth,
        Item::Window,
        Item::Door,
        Item::PitchedRoof,
        Item::FlatRoof,
        Item::Deck,
        Item::Soffit,
        Item::Ground,
        Item::InnerFloor,
        Item::Stair,
        Item::Railing,
        Item::PerimeterBeam,
        Item::Overhang,
        Item::Gutter,
        Item::Parapet,
        Item::Coping,
        Item::WallBothSides,
        Item::FrameS235,
        Item::FrameS355,
        Item::FrameC24,
        Item::FrameGl24h,
        Item::FrameGl28h,
    ];

    /// The item of a surface of the envelope.
    pub fn of_surface(surface: Surface) -> Item {
        Self::ALL[surface as usize]
    }

    /// The item with this name in files.
    pub fn from_id(id: &str) -> Option<Item> {
        Self::ALL.into_iter().find(|item| item.id() == id)
    }

    /// Name in files.
    pub fn id(self) -> &'static str {
        match self {
            Item::InnerFloor => "inner_floor",
            Item::Stair => "stair",
            Item::Railing => "railing",
            Item::PerimeterBeam => "perimeter_beam",
            Item::Overhang => "overhang",
            Item::Gutter => "gutter",
            Item::Parapet => "parapet",
            Item::Coping => "coping",
            Item::WallBothSides => "wall_both_sides",
            Item::FrameS235 => "frame_s235",
            Item::FrameS355 => "frame_s355",
            Item::FrameC24 => "frame_c24",
            Item::FrameGl24h => "frame_gl24h",
            Item::FrameGl28h => "frame_gl28h",
            surface => Surface::ALL[surface as usize].name(),
        }
    }

    /// Unit in which it is billed.
    pub fn unit(self) -> Unit {
        match self {
            Item::Wall | Item::Band | Item::Plinth | Item::Window | Item::PitchedRoof => Unit::SquareMetre,
            Item::FlatRoof | Item::Deck | Item::Soffit | Item::Ground | Item::InnerFloor => Unit::SquareMetre,
            Item::Overhang | Item::Parapet | Item::WallBothSides => Unit::SquareMetre,
            Item::Door | Item::Stair => Unit::Piece,
            Item::Railing | Item::PerimeterBeam | Item::Gutter | Item::Coping => Unit::Metre,
            Item::FrameS235 | Item::FrameS355 => Unit::Kilogram,
            Item::FrameC24 | Item::FrameGl24h | Item::FrameGl28h => Unit::CubicMetre,
        }
    }

    /// Section of the bill it belongs to.
    pub fn group(self) -> Group {
        match self {
            Item::Wall | Item::Band | Item::PitchedRoof | Item::FlatRoof | Item::Deck | Item::Soffit => Group::Envelope,
            Item::Overhang | Item::Gutter | Item::Parapet | Item::Coping | Item::WallBothSides => Group::Envelope,
            Item::Window | Item::Door => Group::Openings,
            Item::InnerFloor => Group::Floors,
            Item::Stair | Item::Railing => Group::Stairs,
            Item::Plinth | Item::Ground | Item::PerimeterBeam => Group::Foundation,
            Item::FrameS235 | Item::FrameS355 | Item::FrameC24 | Item::FrameGl24h | Item::FrameGl28h => Group::Frame,
        }
    }

    /// Whether it is a material of the frame.
    pub fn is_frame(self) -> bool {
        self as usize >= Item::FrameS235 as usize
    }
}
