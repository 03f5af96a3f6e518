//! The archive: every feasible entry that no other dominates, without a limit on their number.

use super::Score;
use super::nd_tree::NdTree;

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
/// Of equal objective vectors the first is kept, so the archive of a sequence does not depend on how it was cut in batches. Ids are
/// offered in ascending order.
#[derive(Clone, Debug)]
pub struct Archive<T> {
    /// Entries in the order in which they came; those that were dominated since are `None` until they outnumber the others.
    slots: Vec<Option<Entry<T>>>,
    live: usize,
    tree: NdTree,
}

impl<T> Default for Archive<T> {
    fn default() -> Self {
        Archive { slots: Vec::new(), live: 0, tree: NdTree::default() }
    }
}

impl<T: PartialEq> PartialEq for Archive<T> {
    fn eq(&self, other: &Self) -> bool {
        self.iter().eq(other.iter())
    }
}

impl<T> Archive<T> {
    /// An empty archive.
    pub fn new() -> Self {
        Archive::default()
    }

    /// Offers an evaluation; `item` is made only when it enters. Returns whether it entered.
    pub fn offer(&mut self, id: u64, score: &Score, item: impl FnOnce() -> T) -> bool {
        let new = &score.objectives;
        if !score.is_feasible() || self.covers(new) {
            return false;
        }
        let mut gone = Vec::new();
        let slots = &self.slots;
        self.tree.remove_dominated(new, &|s| point(slots, s), &mut gone);
        for slot in &gone {
            self.slots[*slot] = None;
        }
        self.live -= gone.len();
        self.slots.push(Some(Entry { id, objectives: new.clone(), item: item() }));
        self.live += 1;
        let slots = &self.slots;
        self.tree.insert(slots.len() - 1, &|s| point(slots, s));
        if self.slots.len() > 2 * self.live + 64 {
            self.compact();
        }
        true
    }

    /// Whether an entry is nowhere worse than `objectives`.
    pub fn covers(&self, objectives: &[f64]) -> bool {
        self.tree.covers(objectives, &|s| point(&self.slots, s))
    }

    fn compact(&mut self) {
        self.slots.retain(Option::is_some);
        self.tree = NdTree::default();
        let slots = &self.slots;
        (0..slots.len()).for_each(|s| self.tree.insert(s, &|s| point(slots, s)));
    }

    /// The entries, lowest id first.
    pub fn iter(&self) -> impl DoubleEndedIterator<Item = &Entry<T>> {
        self.slots.iter().flatten()
    }

    /// The entries, lowest id first.
    pub fn entries(&self) -> Vec<&Entry<T>> {
        self.iter().collect()
    }

    /// Number of entries.
    pub fn len(&self) -> usize {
        self.live
    }

    /// Whether nothing feasible has been offered yet.
    pub fn is_empty(&self) -> bool {
        self.live == 0
    }

    /// The objective vectors of all entries.
    pub fn points(&self) -> Vec<&[f64]> {
        self.iter().map(|e| e.objectives.as_slice()).collect()
    }
}

/// The objectives of a slot; an empty slot is in no tree and has none.
fn point<T>(slots: &[Option<Entry<T>>], slot: usize) -> &[f64] {
    slots[slot].as_ref().map_or(&[], |e| &e.objectives)
}
