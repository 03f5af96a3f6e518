//! The archive: every feasible entry that no other dominates, without a limit on their number.

use super::Score;

/// One entry of an [`Archive`].
#[derive(Clone, Debug, PartialEq)]
pub struct Entry<T> {
    /// Index of the evaluation.
    pub id: u64,
    /// Objectives, minimised.
    pub objectives: Vec<f64>,
    /// What was evaluated.
    pub item: T,
}

/// Mutually non-dominated feasible entries in the order of their ids.
///
/// Of equal objective vectors the first is kept, so the archive of a sequence does not depend on how it was cut in batches.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Archive<T> {
    entries: Vec<Entry<T>>,
}

impl<T> Archive<T> {
    /// An empty archive.
    pub fn new() -> Self {
        Archive { entries: Vec::new() }
    }

    /// Offers an evaluation; `item` is made only when it enters. Returns whether it entered.
    pub fn offer(&mut self, id: u64, score: &Score, item: impl FnOnce() -> T) -> bool {
        let new = &score.objectives;
        let covered = |old: &[f64]| old.iter().zip(new).all(|(o, n)| o <= n);
        if !score.is_feasible() || self.entries.iter().any(|e| covered(&e.objectives)) {
            return false;
        }
        self.entries.retain(|e| !super::dominates(new, &e.objectives));
        let at = self.entries.partition_point(|e| e.id < id);
        self.entries.insert(at, Entry { id, objectives: new.clone(), item: item() });
        true
    }

    /// The entries, lowest id first.
    pub fn entries(&self) -> &[Entry<T>] {
        &self.entries
    }

    /// Number of entries.
    pub fn len(&self) -> usize {
        self.entries.len()
    }

    /// Whether nothing feasible has been offered yet.
    pub fn is_empty(&self) -> bool {
        self.entries.is_empty()
    }

    /// The objective vectors of all entries.
    pub fn points(&self) -> Vec<&[f64]> {
        self.entries.iter().map(|e| e.objectives.as_slice()).collect()
    }
}
