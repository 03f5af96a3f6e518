//! The choices of a house besides its shape: which section each role group takes, and which way the joists run.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// A choice that a house makes besides its voxels.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
#[repr(usize)]
pub enum Choice {
    /// Section of studs, corner posts, plates, lintels and sills.
    Wall = 0,
    /// Section of joists and trimmers.
    Floor = 1,
    /// Section of bearing beams and their posts.
    Beam = 2,
    /// Section of rafters, hips, ridges and valleys.
    Roof = 3,
    /// Direction of the joists: bit p is set when the joists of plate p (0 = first plate above ground) run along y.
    Joists = 4,
    /// Which sides of the outer walls carry boards: an index into the brief's list of [`Boards`].
    Boards = 5,
}

impl Choice {
    /// All choices in storage order.
    pub const ALL: [Choice; 6] =
        [Choice::Wall, Choice::Floor, Choice::Beam, Choice::Roof, Choice::Joists, Choice::Boards];

    /// Name of the choice as a design variable in tables.
    pub fn name(self) -> &'static str {
        match self {
            Choice::Wall => "wall_section",
            Choice::Floor => "floor_section",
            Choice::Beam => "beam_section",
            Choice::Roof => "roof_section",
            Choice::Joists => "joist_axes",
            Choice::Boards => "wall_boards",
        }
    }
}

/// Which sides of the outer walls carry racking boards.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, PartialOrd, Ord, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Boards {
    /// Outside only.
    #[default]
    OneSide,
    /// The same boards and nails on both sides: the racking resistances of both add up (EN 1995-1-1 9.2.4.2(6)), and so do the
    /// stiffnesses. Boards of two kinds would count 75 % or 50 % of the weaker side (9.2.4.2(7)); that is not offered.
    BothSides,
}

impl Boards {
    /// All, the cheaper first.
    pub const ALL: [Boards; 2] = [Boards::OneSide, Boards::BothSides];

    /// Name in briefs, choices and tables.
    pub fn name(self) -> &'static str {
        match self {
            Boards::OneSide => "one_side",
            Boards::BothSides => "both_sides",
        }
    }

    /// Boarded sides.
    pub fn sides(self) -> f64 {
        match self {
            Boards::OneSide => 1.0,
            Boards::BothSides => 2.0,
        }
    }
}

/// One value per [`Choice`]: an index into the option list of the brief, or the joist bits.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Choices(pub [u16; 6]);

impl Choices {
    /// The value of one choice.
    #[inline]
    pub fn get(&self, choice: Choice) -> usize {
        self.0[choice as usize] as usize
    }

    /// Whether the joists of plate `plate` run along y.
    #[inline]
    pub fn joists_along_y(&self, plate: usize) -> bool {
        self.0[Choice::Joists as usize] >> plate & 1 == 1
    }
}
