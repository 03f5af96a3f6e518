//! The labellings that a house can contain, as far as the labels of one cube tell.

use crate::cubes::{CubeKey, Mask};
use crate::voxels::Label;
use std::sync::OnceLock;

/// Every labelling of an admissible or full cube in which foundation stands exactly in the ground layer: beside foundation stands
/// only foundation, above it none, and below it nothing. Face numbers are left out, for meshes do not look at them.
pub fn reachable_keys() -> &'static [CubeKey] {
    static KEYS: OnceLock<Vec<CubeKey>> = OnceLock::new();
    KEYS.get_or_init(|| {
        let mut keys = Vec::new();
        let mut labels = [Label::Empty; 8];
        let mut codes = [0usize; 8];
        loop {
            if is_reachable(&labels) {
                keys.push(CubeKey::of_labels(labels));
            }
            // Counts up in base 6.
            let Some(place) = codes.iter().position(|&c| c < 5) else { return keys };
            (0..place).for_each(|n| (codes[n], labels[n]) = (0, Label::Empty));
            codes[place] += 1;
            labels[place] = Label::ALL[codes[place]];
        }
    })
}

fn is_reachable(labels: &[Label; 8]) -> bool {
    let mask = Mask::of(labels);
    let foundation = |half: &[Label]| half.contains(&Label::Foundation);
    let mixed = |half: &[Label]| foundation(half) && half.iter().any(|l| l.is_filled() && *l != Label::Foundation);
    let (below, above) = labels.split_at(4);
    mask != Mask::EMPTY
        && mask.is_allowed()
        && !mixed(below)
        && !mixed(above)
        && !(foundation(above) && below.iter().any(|l| l.is_filled()))
}
