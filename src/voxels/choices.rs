//! The choices of a house besides its shape: which section each role group takes, and which way the joists run.

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
}

impl Choice {
    /// All choices in storage order.
    pub const ALL: [Choice; 5] = [Choice::Wall, Choice::Floor, Choice::Beam, Choice::Roof, Choice::Joists];

    /// Name of the choice as a design variable in tables.
    pub fn name(self) -> &'static str {
        match self {
            Choice::Wall => "wall_section",
            Choice::Floor => "floor_section",
            Choice::Beam => "beam_section",
            Choice::Roof => "roof_section",
            Choice::Joists => "joist_axes",
        }
    }
}

/// One value per [`Choice`]: an index into the option list of the brief, or the joist bits.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Choices(pub [u16; 5]);

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
