//! Moves: small changes of a genome that keep the rules.
//!
//! A move draws a change, applies it and lets [`settle`](super::settle) put right what hangs on it; draws that would
//! break a rule are thrown away inside the move, so that nearly every child it returns is rule-respecting.

mod facade;
mod inside;
mod plan;

use super::massing::Design;
use super::plot::Space;
use super::settle::settle;
use crate::voxels::Choice;
use rand::{Rng, RngExt};

/// Draws per move before it counts as not applicable.
const DRAWS: usize = 12;

/// A change of a genome.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Move {
    /// Pushes a piece of facade outwards by one to three modules.
    GrowBay,
    /// Pulls a piece of facade inwards by one to three modules.
    ShrinkBay,
    /// Adds a rectangle of three to six modules at a facade.
    AddWing,
    /// Cuts off everything beyond a line.
    RemoveWing,
    /// Slides everything beyond a line along it by one to three modules.
    ShiftWing,
    /// Puts a storey on top, a copy of the one below or part of it.
    AddStorey,
    /// Takes the top storey off.
    RemoveStorey,
    /// One more layer of hipped roof.
    RaiseRoof,
    /// One layer of hipped roof less.
    LowerRoof,
    /// From flat to hipped and back.
    SwitchRoof,
    /// A new window.
    AddWindow,
    /// One window less.
    RemoveWindow,
    /// A window to another place, on the same facade or another.
    MoveWindow,
    /// A window wider, narrower, down to the slab or up to a parapet.
    ResizeWindow,
    /// A new door, onto ground or a deck.
    AddDoor,
    /// One door less.
    RemoveDoor,
    /// A door to another place.
    MoveDoor,
    /// A stair to another place.
    MoveStair,
    /// A stair in another direction, or straight instead of U and back.
    TurnStair,
    /// Another section of studs and plates.
    WallSection,
    /// Another section of joists.
    FloorSection,
    /// Another section of bearing beams.
    BeamSection,
    /// Another section of rafters.
    RoofSection,
    /// The joists of one plate the other way.
    TurnJoists,
    /// Boards on both sides of the walls, or on one again.
    BoardWalls,
}

impl Move {
    /// All moves.
    pub const ALL: [Move; 25] = [
        Move::GrowBay,
        Move::ShrinkBay,
        Move::AddWing,
        Move::RemoveWing,
        Move::ShiftWing,
        Move::AddStorey,
        Move::RemoveStorey,
        Move::RaiseRoof,
        Move::LowerRoof,
        Move::SwitchRoof,
        Move::AddWindow,
        Move::RemoveWindow,
        Move::MoveWindow,
        Move::ResizeWindow,
        Move::AddDoor,
        Move::RemoveDoor,
        Move::MoveDoor,
        Move::MoveStair,
        Move::TurnStair,
        Move::WallSection,
        Move::FloorSection,
        Move::BeamSection,
        Move::RoofSection,
        Move::TurnJoists,
        Move::BoardWalls,
    ];

    /// Name in tables.
    pub fn name(self) -> &'static str {
        match self {
            Move::GrowBay => "grow_bay",
            Move::ShrinkBay => "shrink_bay",
            Move::AddWing => "add_wing",
            Move::RemoveWing => "remove_wing",
            Move::ShiftWing => "shift_wing",
            Move::AddStorey => "add_storey",
            Move::RemoveStorey => "remove_storey",
            Move::RaiseRoof => "raise_roof",
            Move::LowerRoof => "lower_roof",
            Move::SwitchRoof => "switch_roof",
            Move::AddWindow => "add_window",
            Move::RemoveWindow => "remove_window",
            Move::MoveWindow => "move_window",
            Move::ResizeWindow => "resize_window",
            Move::AddDoor => "add_door",
            Move::RemoveDoor => "remove_door",
            Move::MoveDoor => "move_door",
            Move::MoveStair => "move_stair",
            Move::TurnStair => "turn_stair",
            Move::WallSection => "wall_section",
            Move::FloorSection => "floor_section",
            Move::BeamSection => "beam_section",
            Move::RoofSection => "roof_section",
            Move::TurnJoists => "turn_joists",
            Move::BoardWalls => "board_walls",
        }
    }

    /// How often the move is drawn, relative to the others: shape first, then what the price depends on.
    pub fn weight(self) -> u32 {
        match self {
            Move::GrowBay | Move::ShrinkBay => 6,
            Move::AddWing | Move::RemoveWing | Move::ShiftWing | Move::AddStorey | Move::RemoveStorey => 2,
            Move::RaiseRoof | Move::LowerRoof | Move::SwitchRoof => 2,
            Move::AddWindow | Move::RemoveWindow | Move::MoveWindow | Move::ResizeWindow => 3,
            Move::AddDoor | Move::RemoveDoor | Move::MoveDoor => 1,
            Move::MoveStair | Move::TurnStair => 2,
            Move::WallSection | Move::FloorSection | Move::BeamSection | Move::RoofSection => 4,
            Move::TurnJoists => 3,
            Move::BoardWalls => 2,
        }
    }

    /// The choice that the move changes; `None` for a move of the shape.
    pub fn choice(self) -> Option<Choice> {
        match self {
            Move::WallSection => Some(Choice::Wall),
            Move::FloorSection => Some(Choice::Floor),
            Move::BeamSection => Some(Choice::Beam),
            Move::RoofSection => Some(Choice::Roof),
            Move::TurnJoists => Some(Choice::Joists),
            Move::BoardWalls => Some(Choice::Boards),
            Move::GrowBay | Move::ShrinkBay | Move::AddWing | Move::RemoveWing | Move::ShiftWing => None,
            Move::AddStorey | Move::RemoveStorey => None,
            Move::RaiseRoof | Move::LowerRoof | Move::SwitchRoof => None,
            Move::AddWindow | Move::RemoveWindow | Move::MoveWindow | Move::ResizeWindow => None,
            Move::AddDoor | Move::RemoveDoor | Move::MoveDoor => None,
            Move::MoveStair | Move::TurnStair => None,
        }
    }

    /// Draws a move by weight.
    pub fn draw(rng: &mut impl Rng) -> Move {
        let total: u32 = Move::ALL.iter().map(|m| m.weight()).sum();
        let mut at = rng.random_range(0..total);
        for candidate in Move::ALL {
            if at < candidate.weight() {
                return candidate;
            }
            at -= candidate.weight();
        }
        Move::GrowBay
    }

    /// A settled child that differs from its parent, or `None` when the move cannot apply (or no draw kept the rules).
    pub fn apply(self, parent: &Design, space: &Space, rng: &mut impl Rng) -> Option<Design> {
        if parent.massing.storeys.is_empty() {
            return None;
        }
        for _ in 0..DRAWS {
            let Some(mut child) = self.edit(parent, space, rng) else { continue };
            if settle(&mut child, space).is_ok() && child != *parent {
                return Some(child);
            }
        }
        None
    }

    /// One draw, not yet settled.
    fn edit(self, parent: &Design, space: &Space, rng: &mut impl Rng) -> Option<Design> {
        let mut child = parent.clone();
        let m = &mut child.massing;
        match self {
            Move::GrowBay => plan::push_bay(m, space, rng, true),
            Move::ShrinkBay => plan::push_bay(m, space, rng, false),
            Move::AddWing => plan::add_wing(m, rng),
            Move::RemoveWing => plan::remove_wing(m, rng),
            Move::ShiftWing => plan::shift_wing(m, rng),
            Move::AddStorey => plan::add_storey(m, space, rng),
            Move::RemoveStorey => plan::remove_storey(m, space),
            Move::RaiseRoof => inside::step_roof(m, 1),
            Move::LowerRoof => inside::step_roof(m, -1),
            Move::SwitchRoof => inside::switch_roof(m, rng),
            Move::AddWindow => facade::add_window(m, space, rng),
            Move::RemoveWindow => facade::remove_window(m, rng),
            Move::MoveWindow => facade::move_window(m, space, rng),
            Move::ResizeWindow => facade::resize_window(m, rng),
            Move::AddDoor => facade::add_door(m, space, rng),
            Move::RemoveDoor => facade::remove_door(m, rng),
            Move::MoveDoor => facade::move_door(m, space, rng),
            Move::MoveStair => inside::move_stair(m, rng, false),
            Move::TurnStair => inside::move_stair(m, rng, true),
            Move::WallSection => inside::change(&mut child.choices, Choice::Wall, space, rng),
            Move::FloorSection => inside::change(&mut child.choices, Choice::Floor, space, rng),
            Move::BeamSection => inside::change(&mut child.choices, Choice::Beam, space, rng),
            Move::RoofSection => inside::change(&mut child.choices, Choice::Roof, space, rng),
            Move::TurnJoists => inside::turn_joists(&mut child, space, rng),
            Move::BoardWalls => inside::change(&mut child.choices, Choice::Boards, space, rng),
        }?;
        Some(child)
    }
}

/// A uniformly drawn element.
pub(super) fn pick<T: Copy>(items: &[T], rng: &mut impl Rng) -> Option<T> {
    if items.is_empty() { None } else { Some(items[rng.random_range(0..items.len())]) }
}
