//! One member checked on its own: input in an engineer's units, every clause with its numbers out.
//!
//! The checks are those of [`checks`](super::checks), the same that houses go through.

mod actions;
mod deflection;
mod error;
mod input;
mod report;
mod resolve;
mod schema;
mod shapes;
mod steel;
mod timber;

pub use error::MemberError;
pub use input::{Duration, FormingWord, Input, LoadAt, LtbMethod};
pub use report::{ClauseLine, MemberReport, Quantity};
pub use schema::{MEMBER_SCHEMA, member_schema};

use super::Catalogue;
use resolve::Case;

/// Checks a member.
///
/// # Errors
/// [`MemberError`]: something is missing, out of range, contradictory, or a material or section that is not known or not assessed.
pub fn check_member(input: &Input, catalogue: &Catalogue) -> Result<MemberReport, MemberError> {
    let case = Case::new(input, catalogue)?;
    match (case.material.steel, case.material.timber) {
        (Some(steel), _) => steel::check(&case, steel),
        (None, Some(grade)) => timber::check(&case, grade, catalogue),
        (None, None) => Err(MemberError::UnknownMaterial { id: case.material.id.clone(), known: String::new() }),
    }
}
