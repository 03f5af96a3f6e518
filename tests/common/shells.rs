//! The shells that the shipped build-ups give.

use houscaper::price::Books;
use houscaper::tiles::Shells;

/// Shells of `configs/buildups.json`.
pub fn shells() -> Shells {
    let books = Books::load(&std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("configs")).expect("shipped books");
    houscaper::score::shells(&books).expect("shipped strata")
}
