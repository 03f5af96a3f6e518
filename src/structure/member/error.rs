//! What can be wrong with the input of one member.

use thiserror::Error;

/// Why a member cannot be checked.
#[derive(Debug, Error, PartialEq)]
pub enum MemberError {
    /// Something needed is not there.
    #[error("`{key}` is missing: {hint}")]
    Missing {
        /// The key.
        key: &'static str,
        /// What to give.
        hint: &'static str,
    },
    /// A number out of range.
    #[error("`{key}` is {found}: expected {expected}")]
    Range {
        /// The key.
        key: &'static str,
        /// As given.
        found: f64,
        /// What would do.
        expected: &'static str,
    },
    /// Two inputs for one thing.
    #[error("`{first}` and `{second}` say the same thing twice: give one of them")]
    Twice {
        /// One key.
        first: &'static str,
        /// The other.
        second: &'static str,
    },
    /// Not in the catalogue.
    #[error(
        "material `{id}` is not in the catalogue; known: {known}. A steel of another grade can be given with its fy_MPa"
    )]
    UnknownMaterial {
        /// As given.
        id: String,
        /// Ids in the catalogue.
        known: String,
    },
    /// Cross-laminated timber.
    #[error(
        "material `{id}` is cross-laminated timber, a panel: not assessed, because EN 1995-1-1:2004 has no rules for it and there is no panel check here; give sawn timber or glulam"
    )]
    Panel {
        /// As given.
        id: String,
    },
    /// Cold-formed sheet.
    #[error(
        "material `{id}` is light-gauge sheet: not assessed (EN 1993-1-3, class 4); give a hot-rolled or hollow section"
    )]
    LightGauge {
        /// As given.
        id: String,
    },
    /// No such section.
    #[error(
        "section `{id}` is not in the catalogue and not a size: expected e.g. IPE200, SHS100x100x5, HF-RHS200x100x8, CHS114.3x5, T_60x200 or 60x200 (width x depth in mm)"
    )]
    UnknownSection {
        /// As given.
        id: String,
    },
    /// Hot finished or cold formed?
    #[error(
        "section `{id}`: say whether it is hot finished or cold formed (`forming`: hot or cold), the buckling curve depends on it"
    )]
    Forming {
        /// As given.
        id: String,
    },
    /// Timber section of steel or the other way round.
    #[error("section `{section}` does not go with material `{material}`: {expected}")]
    Mismatch {
        /// The section.
        section: String,
        /// The material.
        material: String,
        /// What would go.
        expected: &'static str,
    },
}
