//! Ctrl-C: the first ends the search with a full report, the second ends the program at once.

use std::sync::atomic::{AtomicU32, Ordering};

static ASKED: AtomicU32 = AtomicU32::new(0);

/// Watches for Ctrl-C (and for a terminate signal). Where that is not possible the program ends at once, as any does; what it has found is
/// in its checkpoint.
pub fn watch() {
    let _ = ctrlc::set_handler(|| {
        if ASKED.fetch_add(1, Ordering::SeqCst) > 0 {
            std::process::exit(130);
        }
        eprintln!(
            "stopping after this batch and writing what was found; once more to stop at once (`houscaper resume` carries on)"
        );
    });
}

/// Whether to stop.
pub fn asked() -> bool {
    ASKED.load(Ordering::SeqCst) > 0
}
