//! What an assessment says.

use super::checks::Clause;
use super::report::LoadReport;
use super::stability::Stability;
use super::vibration::FloorVibration;
use crate::frame::{PanelKind, Role};
use crate::voxels::Choice;

/// What was checked.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Check {
    /// A clause on the strength or stability of a member.
    Member(Clause),
    /// Deflection with creep.
    TotalDeflection,
    /// Deflection under variable actions.
    VariableDeflection,
    /// Drift of a storey.
    Sway,
    /// Vibration of a floor.
    Vibration,
    /// Shear of sheathing.
    Racking(PanelKind),
}

/// A change that would mend a failed check.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Mend {
    /// A deeper or stronger section for a group.
    Section(Choice),
    /// Boards on the second side of the walls, or more wall without openings.
    SecondSide,
    /// More wall without openings on the side concerned, or stronger boards.
    Boards(PanelKind),
}

impl std::fmt::Display for Mend {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Mend::Section(c) => write!(f, "take a deeper {}", c.name()),
            Mend::Boards(PanelKind::Wall) => {
                write!(f, "leave more wall without openings along the wind, or brace it by inner walls")
            }
            Mend::SecondSide => write!(
                f,
                "board the walls on both sides (wall_boards both_sides), or leave more wall without openings along the wind"
            ),
            Mend::Boards(PanelKind::Deck) => {
                write!(f, "bring a wall nearer the middle of the deck or board it thicker")
            }
            Mend::Boards(PanelKind::Roof) => write!(f, "board the roof thicker"),
        }
    }
}

/// The member and check that govern.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Governing {
    /// Member, or panel for [`Check::Racking`], or node for [`Check::Sway`].
    pub index: usize,
    /// Role of the member; `None` for panels and sway.
    pub role: Option<Role>,
    /// The check.
    pub check: Check,
    /// Its ratio.
    pub utilisation: f64,
}

/// The four verdicts.
#[derive(Clone, Debug, PartialEq)]
pub enum Verdict {
    /// Every check holds.
    Ok,
    /// A check fails.
    NotOk {
        /// The worst.
        governing: Governing,
        /// What would mend it.
        mend: Mend,
    },
    /// A mechanism.
    Unstable {
        /// Nodes that move and their unit directions ux uy uz rx ry rz.
        nodes: Vec<(usize, [f64; 6])>,
    },
    /// Nothing can be said.
    NotAssessed {
        /// Why.
        reason: &'static str,
    },
}

impl Default for Verdict {
    fn default() -> Self {
        Verdict::NotAssessed { reason: "not assessed yet" }
    }
}

/// The thesis rule.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ThesisResult {
    /// Largest stress with bending within the limits.
    pub passes: bool,
    /// Largest ratio of stress (N/A with bending) to its limit.
    pub ratio: f64,
    /// Largest tensile and compressive stress with bending, Pa.
    pub stress: [f64; 2],
    /// Largest N/A alone, Pa.
    pub axial_stress: f64,
    /// Limits in tension and compression of the governing member's material, Pa.
    pub limit: [f64; 2],
}

impl ThesisResult {
    /// `yes` or `no`.
    pub fn answer(&self) -> &'static str {
        if self.passes { "yes" } else { "no" }
    }
}

/// One member's result.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MemberResult {
    /// Largest stress ratio over combinations.
    pub utilisation: f64,
    /// Its check.
    pub check: Check,
    /// Largest deflection over its limit.
    pub deflection_ratio: f64,
}

/// Everything an assessment finds.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Assessment {
    /// The verdict.
    pub verdict: Verdict,
    /// Largest stress or racking ratio.
    pub utilisation: f64,
    /// Largest storey drift over its limit.
    pub sway_ratio: f64,
    /// Largest deflection over its limit.
    pub deflection_ratio: f64,
    /// Largest racking of sheathing over its capacity.
    pub racking_ratio: f64,
    /// The worst check, whatever the verdict.
    pub governing: Option<Governing>,
    /// kg by wall, floor, beam, roof.
    pub group_mass_kg: [f64; 4],
    /// Metres by wall, floor, beam, roof, plies counted.
    pub group_length_m: [f64; 4],
    /// kg of all sticks.
    pub frame_mass_kg: f64,
    /// The joist floor that vibrates worst; `None` without a floor of joists above ground.
    pub vibration: Option<FloorVibration>,
    /// The thesis rule; `None` when it was not asked for.
    pub thesis: Option<ThesisResult>,
    /// Anchors, overturning and sliding under 0.9 G + 1.5 W.
    pub stability: Stability,
    /// Vertical load of permanent + imposed + snow, and the reactions to it, N.
    pub vertical_n: [f64; 2],
    /// Results by member when asked for.
    pub members: Vec<MemberResult>,
    /// Every action, zone and combination with its clause, when a report is asked for.
    pub loads: Option<Box<LoadReport>>,
}

impl Assessment {
    /// Vibration of the worst floor over its limits; 0 without one.
    pub fn vibration_ratio(&self) -> f64 {
        self.vibration.map_or(0.0, |v| v.ratio)
    }
}
