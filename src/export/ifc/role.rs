//! What a product of the model is: the IFC class that a piece of the house belongs to.

use crate::parts::{Part, PartCell, PartKind, Parts};
use crate::quantities::Item;
use crate::tiles::Component;

/// Kinds of products made of solids; members of the frame are apart.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub(super) enum Role {
    Ground,
    Footing,
    Plinth,
    Paving,
    Wall,
    Parapet,
    Floor,
    Soffit,
    Deck,
    Roof,
    Coping,
    Gutter,
    Window,
    Door,
    Stair,
    Railing,
}

/// How a role is written: class, predefined type, object type where that is user defined.
pub(super) struct Class {
    pub entity: &'static str,
    pub predefined: &'static str,
    pub object: Option<&'static str>,
}

const fn class(entity: &'static str, predefined: &'static str) -> Class {
    Class { entity, predefined, object: None }
}

/// A cell of a deck that people walk on, see [`PartCell::code`].
const WALKED: u16 = 4;

impl Role {
    /// The role of a component of a part, or of site work.
    pub fn of(component: Component, owner: Option<&Part>, cells: &[PartCell]) -> Role {
        use Component as C;
        let kind = owner.map(|p| p.kind);
        let covered = || match kind {
            Some(PartKind::Floor) => Role::Floor,
            Some(PartKind::Deck) if cells.iter().any(|c| c.code == WALKED) => Role::Deck,
            _ => Role::Roof,
        };
        match component {
            C::Reveal | C::Sill if kind == Some(PartKind::Window) => Role::Window,
            C::Reveal | C::Sill if kind == Some(PartKind::Door) => Role::Door,
            C::Cladding | C::Band | C::WallInsulation | C::WallLining | C::Reveal | C::Sill => match kind {
                Some(PartKind::Deck | PartKind::Floor) => Role::Parapet,
                _ => Role::Wall,
            },
            C::RoofCovering | C::RoofInsulation | C::RoofLining | C::Fascia => covered(),
            C::FlatMembrane | C::FlatInsulation => covered(),
            C::DeckBoards if kind.is_none() => Role::Deck,
            C::DeckBoards => covered(),
            C::FloorBoards | C::FloorStructure | C::Ceiling if kind.is_none() => Role::Floor,
            C::FloorBoards | C::FloorStructure | C::Ceiling => covered(),
            C::SoffitInsulation | C::SoffitBoards => Role::Soffit,
            C::GroundSlab | C::GroundInsulation => Role::Ground,
            C::PerimeterBeam => Role::Footing,
            C::PlinthInsulation | C::PlinthRender => Role::Plinth,
            C::Paving => Role::Paving,
            C::Gutter => Role::Gutter,
            C::Coping => Role::Coping,
            C::WindowFrame | C::Glass => Role::Window,
            C::DoorFrame | C::DoorLeaf | C::Handle => Role::Door,
            C::RailingRail | C::RailingGlass => Role::Railing,
            C::StairTread | C::StairString => Role::Stair,
        }
    }

    /// Whether a product of this role *is* the part it belongs to, and not something on it.
    pub fn is_part(self, kind: PartKind) -> bool {
        match kind {
            PartKind::Wall => self == Role::Wall,
            PartKind::Floor => self == Role::Floor,
            PartKind::Deck => matches!(self, Role::Deck | Role::Roof),
            PartKind::Slope | PartKind::Level => self == Role::Roof,
            PartKind::Window => self == Role::Window,
            PartKind::Door => self == Role::Door,
            PartKind::Stair => self == Role::Stair,
        }
    }

    /// Name in files.
    pub fn name(self) -> &'static str {
        match self {
            Role::Ground => "ground_slab",
            Role::Footing => "perimeter_beam",
            Role::Plinth => "plinth",
            Role::Paving => "paving",
            Role::Wall => "wall",
            Role::Parapet => "parapet",
            Role::Floor => "floor",
            Role::Soffit => "soffit",
            Role::Deck => "deck",
            Role::Roof => "roof",
            Role::Coping => "coping",
            Role::Gutter => "gutter",
            Role::Window => "window",
            Role::Door => "door",
            Role::Stair => "stair",
            Role::Railing => "railing",
        }
    }

    /// How it is written; `kind` is that of its part.
    pub fn class(self, kind: Option<PartKind>) -> Class {
        match self {
            Role::Ground => class("IFCSLAB", "BASESLAB"),
            Role::Footing => class("IFCFOOTING", "STRIP_FOOTING"),
            Role::Plinth | Role::Soffit => class("IFCCOVERING", "CLADDING"),
            Role::Paving => class("IFCCOVERING", "FLOORING"),
            Role::Wall => class("IFCWALL", "ELEMENTEDWALL"),
            Role::Parapet => class("IFCWALL", "PARAPET"),
            Role::Floor => class("IFCSLAB", "FLOOR"),
            Role::Deck => Class { object: Some("DECK"), ..class("IFCSLAB", "USERDEFINED") },
            Role::Roof if kind == Some(PartKind::Slope) => {
                Class { object: Some("ROOF_CASSETTE"), ..class("IFCROOF", "USERDEFINED") }
            }
            Role::Roof => class("IFCROOF", "FLAT_ROOF"),
            Role::Coping => Class { object: Some("COPING"), ..class("IFCCOVERING", "USERDEFINED") },
            Role::Gutter => class("IFCPIPESEGMENT", "GUTTER"),
            Role::Window => class("IFCWINDOW", "WINDOW"),
            Role::Door => class("IFCDOOR", "DOOR"),
            Role::Stair => class("IFCSTAIR", "NOTDEFINED"),
            Role::Railing => class("IFCRAILING", "GUARDRAIL"),
        }
    }

    /// The item of the take-off whose build-up it has, where that does not follow from its quantities.
    pub fn item(self) -> Item {
        match self {
            Role::Ground | Role::Paving => Item::Ground,
            Role::Footing => Item::PerimeterBeam,
            Role::Plinth => Item::Plinth,
            Role::Wall => Item::Wall,
            Role::Parapet => Item::Parapet,
            Role::Floor => Item::InnerFloor,
            Role::Soffit => Item::Soffit,
            Role::Deck => Item::Deck,
            Role::Roof => Item::FlatRoof,
            Role::Coping => Item::Coping,
            Role::Gutter => Item::Gutter,
            Role::Window => Item::Window,
            Role::Door => Item::Door,
            Role::Stair => Item::Stair,
            Role::Railing => Item::Railing,
        }
    }
}

/// The roles that may hold an item of the take-off, the likeliest first, and the components that show where it is.
pub(super) fn homes(item: Item) -> (&'static [Role], &'static [Component]) {
    use Component as C;
    match item {
        Item::Wall | Item::WallBothSides => {
            (&[Role::Wall, Role::Parapet], &[C::Cladding, C::WallInsulation, C::WallLining])
        }
        Item::Band => (&[Role::Wall, Role::Parapet], &[C::Band, C::Cladding, C::WallInsulation]),
        Item::Plinth => (
            &[Role::Plinth, Role::Footing, Role::Ground],
            &[C::PlinthRender, C::PlinthInsulation, C::PerimeterBeam, C::GroundSlab],
        ),
        Item::Window => (&[Role::Window], &[C::Glass, C::WindowFrame]),
        Item::Door => (&[Role::Door], &[C::DoorLeaf, C::DoorFrame]),
        Item::PitchedRoof => (&[Role::Roof], &[C::RoofCovering, C::RoofInsulation, C::RoofLining]),
        Item::FlatRoof => (
            &[Role::Roof, Role::Deck, Role::Floor],
            &[C::FlatMembrane, C::FlatInsulation, C::FloorBoards, C::FloorStructure],
        ),
        Item::Deck => (
            &[Role::Deck, Role::Roof, Role::Paving],
            &[C::DeckBoards, C::FlatMembrane, C::FlatInsulation, C::FloorStructure, C::Paving],
        ),
        Item::Soffit => (&[Role::Soffit, Role::Floor], &[C::SoffitBoards, C::SoffitInsulation, C::Ceiling]),
        Item::Ground => (&[Role::Ground, Role::Footing], &[C::GroundSlab, C::GroundInsulation]),
        Item::InnerFloor => (&[Role::Floor, Role::Roof, Role::Deck], &[C::FloorBoards, C::FloorStructure, C::Ceiling]),
        Item::Stair => (&[Role::Stair], &[C::StairTread, C::StairString]),
        Item::Railing => (&[Role::Railing], &[C::RailingRail, C::RailingGlass]),
        Item::PerimeterBeam => (&[Role::Footing, Role::Ground, Role::Plinth], &[C::PerimeterBeam, C::GroundSlab]),
        Item::Overhang => (&[Role::Roof, Role::Deck], &[C::Fascia, C::RoofCovering]),
        Item::Gutter => (&[Role::Gutter, Role::Roof, Role::Deck], &[C::Gutter, C::Fascia, C::RoofCovering]),
        Item::Parapet => (&[Role::Parapet, Role::Wall], &[C::Cladding, C::WallInsulation]),
        Item::Coping => {
            (&[Role::Coping, Role::Parapet, Role::Roof, Role::Deck], &[C::Coping, C::Cladding, C::FlatMembrane])
        }
        Item::FrameS235 | Item::FrameS355 | Item::FrameC24 | Item::FrameGl24h | Item::FrameGl28h => (&[], &[]),
    }
}

/// The part that the n-th opening of a reading, or the n-th stair of a house, became: parts keep their order.
pub(super) fn nth(cut: &Parts, kinds: &[PartKind], n: usize) -> Option<u32> {
    let of_kind = cut.parts.iter().enumerate().filter(|(_, p)| kinds.contains(&p.kind));
    of_kind.map(|(index, _)| index as u32).nth(n)
}
