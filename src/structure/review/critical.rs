//! First buckling loads of a house: of the frame as a whole, and of members between its joints.
//!
//! A bare frame of pinned sticks buckles one stud at a time about its weak axis, at one or two times its design load, and says
//! nothing of a house: boards hold that direction. So sticks are made stiff here ([`HELD`] times) where they are held, and two
//! questions are asked under every ultimate combination:
//! - *the frame*: every stick straight between its ends, about both axes, so that only joints move against each other: storeys that
//!   sway, decks that shear, roofs that push their eaves. This is what first-order analysis leaves out, and what is set against 10
//!   (EN 1993-1-1 5.2.1(3)). Braces for boards stay straight as well.
//! - *a member*: every member cut into four, stiff about the weak axis where boards hold it. What buckles first is a post or a stud
//!   over its clear length: the Euler load that the check of the member knows by its buckling length (k_c, chi). It is given for
//!   comparison and has no limit of its own.
//!
//! A stick that runs through a floor's plate carries its stiffness through, so that storeys share their drift in the first question:
//! [`super::StoreyReview`] has each storey's factor without that, and the lower of both counts. Leaving sticks as soft as they are
//! and letting compression turn over only their chords was tried: lintels with their short studs then slide along the wall between
//! jambs at 2 to 5 times the load, which boards prevent as well.

use super::Solved;
use crate::analysis::{BUCKLING_PIECES, Buckler, Buckling, BucklingAnswer, Model, Section};
use crate::frame::{HouseFrame, Role};
use crate::structure::{Catalogue, LoadSettings, SectionOption};

/// How many times stiffer a stick is made about an axis that is held. A hundred or ten thousand in its place leaves the factors of
/// members as they are (0.3 %). Those of frames are less settled: with a hundred, sticks that bow in spite of it come among the least
/// modes; ten thousand gives up to 1.6 times more, as sticks that run through tie storeys together. So the factors of the storeys
/// stand beside them.
const HELD: f64 = 1e3;

/// A mode is one of swaying where this share of a level's nodes moves sideways by this share of the largest displacement.
const SWAY_SHARE: f64 = 0.25;

/// What a mode is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ModeKind {
    /// Floors or eaves move sideways.
    Sway,
    /// No floor moves: a member bows, or joints of a roof or deck move.
    Local,
}

/// A first buckling load.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BucklingMode {
    /// The combination times this buckles the frame.
    pub factor: f64,
    /// The combination with the least factor, from 0, in the order of the load report.
    pub combination: usize,
    /// What moves.
    pub kind: ModeKind,
    /// The member that moves most; `None` for the brace of a panel.
    pub member: Option<usize>,
    /// Where it moves most, m.
    pub at_m: [f64; 3],
    /// In which direction, unit.
    pub direction: [f64; 3],
}

/// First buckling loads over all ultimate combinations.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Critical {
    /// False where an iteration did not settle: then nothing is known.
    pub is_known: bool,
    /// Of the frame, sticks straight between their ends; `None` where nothing is compressed.
    pub frame: Option<BucklingMode>,
    /// Of the first member over its clear length.
    pub member: Option<BucklingMode>,
}

/// First buckling loads, boards holding what they hold. Slow beside an assessment: an eigenvalue for every ultimate combination,
/// twice. `None` as [`super::review`].
pub fn critical_loads(
    frame: &HouseFrame,
    catalogue: &Catalogue,
    sections: &[SectionOption; 4],
    loads: &LoadSettings,
) -> Option<Critical> {
    let s = Solved::new(frame, catalogue, sections, loads)?;
    let straight = stiffened(&s, |_| [HELD, HELD]);
    let held = stiffened(&s, |role| [1.0, if role.is_sheathed() { HELD } else { 1.0 }]);
    let bowing: Vec<usize> =
        (0..held.members.len()).map(|m| if m < frame.elements.len() { BUCKLING_PIECES } else { 1 }).collect();
    let least = |model: &Model, pieces: &[usize]| -> Option<Option<BucklingMode>> {
        let mut buckler = Buckler::new(model, pieces).ok()?;
        let mut kept: Option<BucklingMode> = None;
        for (combination, c) in s.combinations.iter().enumerate() {
            match buckler.first(&s.solution, &s.of(c)) {
                BucklingAnswer::Buckles(found) if kept.is_none_or(|k| found.factor < k.factor) => {
                    kept = Some(mode(frame, &found, combination));
                }
                BucklingAnswer::Buckles(_) | BucklingAnswer::Never => {}
                BucklingAnswer::Unknown => return None,
            }
        }
        Some(kept)
    };
    let found = least(&straight, &[1]).zip(least(&held, &bowing));
    let (frame, member) = found.unwrap_or_default();
    Some(Critical { is_known: found.is_some(), frame, member })
}

/// The model with second moments about y and z times what `more` says of a member's role.
fn stiffened(s: &Solved, more: impl Fn(Role) -> [f64; 2]) -> Model {
    let mut model = s.model.clone();
    for (element, member) in s.frame.elements.iter().zip(&mut model.members) {
        let [y, z] = more(s.frame.members[element.member as usize].role);
        let own = s.model.sections[member.section];
        let stiff = Section { iy: y * own.iy, iz: z * own.iz, ..own };
        member.section = model.sections.iter().position(|k| *k == stiff).unwrap_or_else(|| {
            model.sections.push(stiff);
            model.sections.len() - 1
        });
    }
    model
}

fn mode(frame: &HouseFrame, found: &Buckling, combination: usize) -> BucklingMode {
    let moves = |n: &&u32| {
        let u = &found.nodes[**n as usize];
        u[0].hypot(u[1]) >= SWAY_SHARE
    };
    let share = |nodes: &[u32]| nodes.iter().filter(moves).count() as f64 / nodes.len().max(1) as f64;
    let sways = frame.levels.iter().skip(1).any(|l| share(&l.nodes) >= SWAY_SHARE);
    let (member, at_m) = match frame.elements.get(found.member) {
        Some(element) => {
            let [a, b] = element.nodes.map(|n| frame.nodes[n as usize]);
            let t = found.x / frame.element_length_m(found.member);
            (Some(element.member as usize), std::array::from_fn(|x| a[x] + t * (b[x] - a[x])))
        }
        None => {
            let panel = &frame.panels[found.member - frame.elements.len()];
            (None, frame.nodes[panel.nodes[usize::from(found.x > 0.0)] as usize])
        }
    };
    let length = found.direction.iter().map(|d| d * d).sum::<f64>().sqrt();
    let direction = if length > 0.0 { found.direction.map(|d| d / length) } else { found.direction };
    let kind = if sways { ModeKind::Sway } else { ModeKind::Local };
    BucklingMode { factor: found.factor, combination, kind, member, at_m, direction }
}
