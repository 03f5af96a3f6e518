//! `log.json`: a block for each batch with its time and the feasible objective vectors found in it, minimised.

use houscaper::run::{FolderError, Frames, RunFolder, Table};
use serde_json::json;

use super::checkpoint::{Batch, FILE};

/// Writes the log of a run from its checkpoint, or from those of several, one after the other.
pub fn write(runs: &[&RunFolder], folder: &RunFolder) -> Result<(), FolderError> {
    let head = format!("{{\"program\":\"houscaper\",\"version\":\"{}\",\"log\":[", env!("CARGO_PKG_VERSION"));
    // Block by block to the disk: the log of a long run is larger than all that the run keeps in memory.
    let mut table = Table::begin(folder, "log.json", &head)?;
    let (mut evals, mut separator) = (0, "");
    for run in runs {
        let Some(mut frames) = Frames::read(run, FILE)? else { continue };
        while let Some(batch) = frames.next_frame()?.as_deref().and_then(Batch::read) {
            evals += batch.scores.len();
            let feasible: Vec<&Vec<f64>> =
                batch.scores.iter().filter(|s| s.1.is_feasible()).map(|s| &s.1.objectives).collect();
            let infeasible = batch.scores.len() - feasible.len();
            let t = batch.elapsed.as_secs_f64();
            let block = json!({"evals": evals, "t": t, "f": feasible, "infeasible": infeasible});
            table.append(&format!("{separator}{block}"))?;
            separator = ",";
        }
    }
    table.append("]}")?;
    table.finish()
}
