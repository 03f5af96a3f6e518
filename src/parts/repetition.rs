//! How often parts repeat: what set-up, practice and lifting are paid by.

use super::types::{PartKind, Parts};
use crate::quantities::{REPEATS, Works};

impl Parts {
    /// Parts, distinct parts, lifts, and the area of panels and cassettes by how often their type occurs. Connections of members are not
    /// known here: `node_types` stays 0.
    pub fn works(&self) -> Works {
        let mut order: Vec<u32> = (0..self.parts.len() as u32).collect();
        let key = |n: u32| self.key_of(&self.parts[n as usize]);
        order.sort_unstable_by(|&a, &b| key(a).cmp(key(b)));
        let mut works = Works { parts: self.parts.len() as u32, ..Works::default() };
        for alike in order.chunk_by(|&a, &b| key(a) == key(b)) {
            works.part_types += 1;
            for &n in alike {
                let part = &self.parts[n as usize];
                works.lifts += u32::from(part.kind.is_flat() || part.kind == PartKind::Stair);
                if part.kind.is_flat() {
                    works.repeated_m2[alike.len().min(REPEATS) - 1] += part.area_m2;
                }
            }
        }
        works
    }
}
