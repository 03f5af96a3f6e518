//! The five labels of a voxel, and empty.

/// What a voxel is made for. The codes are the thesis's and stand in every file we write.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, PartialOrd, Ord)]
#[repr(u8)]
pub enum Label {
    /// 0: outside.
    #[default]
    Empty = 0,
    /// 1: room and the wall around it.
    Base = 1,
    /// 2: floor plate at a storey level.
    Floor = 2,
    /// 3: foundation, the ground layer.
    Foundation = 3,
    /// 4: door opening in a facade.
    Opening = 4,
    /// 5: window in a facade.
    Window = 5,
}

impl Label {
    /// All labels in the order of their codes.
    pub const ALL: [Label; 6] =
        [Label::Empty, Label::Base, Label::Floor, Label::Foundation, Label::Opening, Label::Window];

    /// The label of a code, `None` above 5.
    #[inline]
    pub fn from_code(code: u8) -> Option<Label> {
        Self::ALL.get(code as usize).copied()
    }

    /// The code, 0 to 5.
    #[inline]
    pub fn code(self) -> u8 {
        self as u8
    }

    /// The lower-case English name, as in files and messages.
    pub fn name(self) -> &'static str {
        match self {
            Label::Empty => "empty",
            Label::Base => "base",
            Label::Floor => "floor",
            Label::Foundation => "foundation",
            Label::Opening => "opening",
            Label::Window => "window",
        }
    }

    /// Everything but empty.
    #[inline]
    pub fn is_filled(self) -> bool {
        self != Label::Empty
    }

    /// Floor or foundation: the labels that carry a slab.
    #[inline]
    pub fn is_slab(self) -> bool {
        matches!(self, Label::Floor | Label::Foundation)
    }

    /// Window or opening: the labels that replace the wall.
    #[inline]
    pub fn is_infill(self) -> bool {
        matches!(self, Label::Opening | Label::Window)
    }
}
