//! Components: what a solid of a tile is in the building. Names are those of glTF materials, OBJ groups and take-off lines.

use serde::{Deserialize, Serialize};

macro_rules! components {
    ($($variant:ident $name:literal $doc:literal,)*) => {
        /// What a solid is made for. The name decides look, price line and material in every file.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord, Serialize, Deserialize)]
        #[repr(u8)]
        pub enum Component {
            $(#[doc = $doc] #[serde(rename = $name)] $variant,)*
        }

        impl Component {
            /// All components in storage order.
            pub const ALL: &[Component] = &[$(Component::$variant),*];

            /// Number of components.
            pub const COUNT: usize = Component::ALL.len();

            /// Name in files.
            pub fn name(self) -> &'static str {
                match self { $(Component::$variant => $name,)* }
            }
        }
    };
}

components! {
    Cladding "cladding" "Outermost stratum of a wall with what ventilates it.",
    Band "floor_band" "The same at the edge of a floor plate: the string course.",
    WallInsulation "wall_insulation" "Insulated stratum of a wall: studs' zone, sheathing.",
    WallLining "wall_lining" "Innermost stratum of a wall.",
    RoofCovering "roof_covering" "Tiles or sheets with their battens, outside the insulated roof.",
    RoofInsulation "roof_insulation" "Insulated stratum of a pitched roof: rafters' zone, sheathing.",
    RoofLining "roof_lining" "Innermost stratum of a pitched roof.",
    FlatMembrane "flat_membrane" "Waterproofing of a level roof.",
    FlatInsulation "flat_insulation" "Insulation of a level roof or deck.",
    DeckBoards "deck_boards" "Boards of a deck that is walked on, with bearers.",
    Paving "paving" "What lies on a foundation that nothing stands on.",
    FloorBoards "floor_boards" "Uppermost stratum of a floor.",
    FloorStructure "floor_structure" "Joists' zone of a floor.",
    Ceiling "ceiling" "Lowest stratum of a floor.",
    SoffitInsulation "soffit_insulation" "Insulation hung below a floor over the outside.",
    SoffitBoards "soffit_boards" "Boards below it.",
    GroundSlab "ground_slab" "Concrete slab of the foundation.",
    GroundInsulation "ground_insulation" "Insulation below the slab.",
    PerimeterBeam "perimeter_beam" "Concrete beam under the outer walls.",
    PlinthInsulation "plinth_insulation" "Insulation outside the perimeter beam.",
    PlinthRender "plinth_render" "Render on it.",
    Fascia "fascia" "Boards that close eaves and verges, and the underside of an overhang.",
    Gutter "gutter" "Rain gutter along free eaves.",
    Coping "coping" "Metal cover of a parapet or roof edge.",
    WindowFrame "window_frame" "Frame bars and mullions of windows.",
    Glass "glass" "Panes of windows.",
    DoorFrame "door_frame" "Frame bars of doors.",
    DoorLeaf "door_leaf" "Leaf of a door.",
    Handle "handle" "Handle of a door leaf, on the side that opens.",
    Reveal "reveal" "Boards that line the sides of an opening.",
    Sill "sill" "Outer sill below a window.",
    RailingRail "railing_rail" "Posts and rails of a railing.",
    RailingGlass "railing_glass" "Infill of a railing.",
    StairTread "stair_tread" "Treads of a stair.",
    StairString "stair_string" "Strings and landings of a stair.",
}
