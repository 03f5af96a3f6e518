//! The space of a brief's houses, for commands that change houses.

use std::path::Path;

use houscaper::score::Evaluator;
use houscaper::search::plot::Space;

use super::failure::Failure;
use super::input::site::Site;

/// Plot, programme, given cells and choices of a loaded brief whose file lies in `folder`.
pub fn of(evaluator: &Evaluator, folder: &Path) -> Result<Space, Failure> {
    Site::read(&evaluator.brief, folder, &|text| eprintln!("{text}"))?.space(evaluator)
}
