//! What a check hands back: a sum for the search, a list with words for people.

/// One broken rule with the place, the size of the breach and the way to mend it.
#[derive(Clone, Debug, PartialEq)]
pub struct Violation {
    /// Id of the rule.
    pub rule: &'static str,
    /// Voxels concerned.
    pub voxels: Vec<[usize; 3]>,
    /// The cube of the padded array, for rules about cubes.
    pub cube: Option<[usize; 3]>,
    /// What is wrong, in one sentence.
    pub message: String,
    /// What to change.
    pub fix: String,
    /// Size of the breach, above 0: offending cells, missing metres or square metres, or a count, as the message says.
    pub amount: f64,
}

/// What a check says about one breach besides its amount.
pub(super) struct Finding {
    pub voxels: Vec<[usize; 3]>,
    pub cube: Option<[usize; 3]>,
    pub message: String,
    pub fix: String,
}

impl Finding {
    pub fn new(voxels: Vec<[usize; 3]>, message: String, fix: &str) -> Self {
        Finding { voxels, cube: None, message, fix: fix.to_string() }
    }
}

/// Adds up amounts; builds findings only when somebody wants the list.
pub(super) struct Report<'r> {
    pub rule: &'static str,
    pub total: f64,
    list: Option<&'r mut Vec<Violation>>,
}

impl<'r> Report<'r> {
    pub fn new(list: Option<&'r mut Vec<Violation>>) -> Self {
        Report { rule: "", total: 0.0, list }
    }

    /// Reports a breach of `amount`; nothing happens at 0.
    pub fn add(&mut self, amount: f64, finding: impl FnOnce() -> Finding) {
        if amount <= 0.0 {
            return;
        }
        self.total += amount;
        if let Some(list) = self.list.as_deref_mut() {
            let Finding { voxels, cube, message, fix } = finding();
            list.push(Violation { rule: self.rule, voxels, cube, message, fix, amount });
        }
    }

    /// Reports offending voxels in one violation whose amount is their number.
    pub fn voxels(&mut self, voxels: impl Iterator<Item = [usize; 3]>, message: &str, fix: &str) {
        if self.list.is_some() {
            let voxels: Vec<_> = voxels.collect();
            let text = format!("{} voxel{} {message}", voxels.len(), if voxels.len() == 1 { "" } else { "s" });
            self.add(voxels.len() as f64, || Finding::new(voxels, text, fix));
        } else {
            self.total += voxels.count() as f64;
        }
    }
}
