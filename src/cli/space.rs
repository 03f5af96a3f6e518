//! The space of a brief's houses, for commands that change houses.

use std::path::Path;

use houscaper::score::Evaluator;
use houscaper::search::from_brief;
use houscaper::search::plot::Space;

use super::failure::{Blame, Failure};
use super::optimize;

/// Plot, programme, given cells and choices of a loaded brief whose file lies in `folder`.
pub fn of(evaluator: &Evaluator, folder: &Path) -> Result<Space, Failure> {
    let given = optimize::given(&evaluator.brief, folder)?;
    let options = [0, 1, 2, 3].map(|g| evaluator.options[g].len());
    from_brief::space(&evaluator.brief, given.as_ref(), &evaluator.rules, options).input()
}
