//! `log.json`: a block for each batch with its time and the feasible objective vectors found in it, minimised.

use houscaper::run::{FolderError, Frames, RunFolder};
use serde_json::json;

use super::checkpoint::{Batch, FILE};

/// Writes the log of a run from its checkpoint, or from those of several, one after the other.
pub fn write(runs: &[&RunFolder], folder: &RunFolder) -> Result<(), FolderError> {
    let mut text = format!("{{\"program\":\"houscaper\",\"version\":\"{}\",\"log\":[", env!("CARGO_PKG_VERSION"));
    let (mut evals, mut first) = (0, true);
    for run in runs {
        let Some(mut frames) = Frames::read(run, FILE)? else { continue };
        while let Some(batch) = frames.next_frame()?.as_deref().and_then(Batch::read) {
            evals += batch.scores.len();
            let feasible: Vec<&Vec<f64>> =
                batch.scores.iter().filter(|s| s.1.is_feasible()).map(|s| &s.1.objectives).collect();
            let infeasible = batch.scores.len() - feasible.len();
            let block =
                json!({"evals": evals, "t": batch.elapsed.as_secs_f64(), "f": feasible, "infeasible": infeasible});
            text += if first { "" } else { "," };
            text += &block.to_string();
            first = false;
        }
    }
    text += "]}";
    folder.write("log.json", text.as_bytes())
}
