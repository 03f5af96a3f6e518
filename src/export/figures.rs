//! Numbers and words as tables and pages print them.

use super::tables::quote;
pub use crate::price::{grouped, plain};

/// Text as a cell of a CSV.
pub fn quoted(text: &str) -> String {
    let mut out = String::new();
    quote(text, &mut out);
    out
}
