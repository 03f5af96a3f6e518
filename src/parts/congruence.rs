//! Congruence: parts that one drawing makes, up to turning and mirroring.

use super::cassettes::flipped;
use super::types::Parts;

/// The cells of a cassette as a picture: rows across, columns along.
pub(super) struct Picture {
    pub rows: usize,
    pub columns: usize,
    pub codes: Vec<u16>,
    pub quarters: bool,
}

impl Picture {
    /// Whether it is its own mirror image both ways because all its cells are alike: so with most cassettes.
    pub fn is_even(&self) -> bool {
        let Some(&first) = self.codes.first() else { return true };
        let alike = |flips| !self.quarters || flipped(first, flips) == first;
        self.codes.iter().all(|&code| code == first) && alike([true, false]) && alike([false, true])
    }

    /// Writes head and codes as seen with flips across and along.
    pub fn tokens(&self, [across, along]: [bool; 2], head: &[u64], out: &mut Vec<u64>) {
        out.clear();
        out.extend(head);
        out.extend([self.rows as u64, self.columns as u64]);
        for r in 0..self.rows {
            let row = if across { self.rows - 1 - r } else { r };
            for c in 0..self.columns {
                let column = if along { self.columns - 1 - c } else { c };
                let code = self.codes[row * self.columns + column];
                out.push(u64::from(if self.quarters { flipped(code, [across, along]) } else { code }));
            }
        }
    }
}

impl Parts {
    /// Number of distinct parts up to congruence and mirror image: panels by outline, openings and ends (joint, outer or inner corner,
    /// running through or butting), cassettes by size and outline, windows and doors by size, stairs by kind. Members of the frame are cut
    /// from stock and counted by [`super::stock`].
    pub fn distinct(&self) -> usize {
        let mut order: Vec<u32> = (0..self.parts.len() as u32).collect();
        let key = |n: &u32| self.key_of(&self.parts[*n as usize]);
        order.sort_unstable_by(|a, b| key(a).cmp(key(b)));
        order.dedup_by(|a, b| key(a) == key(b));
        order.len()
    }

    /// Type of each part: parts of equal type are congruent or mirror images. Types are numbered from 0 in the order of their keys: by kind,
    /// then small before large.
    pub fn types(&self) -> Vec<u32> {
        let mut order: Vec<usize> = (0..self.parts.len()).collect();
        order.sort_by(|&a, &b| self.key_of(&self.parts[a]).cmp(self.key_of(&self.parts[b])));
        let mut types = vec![0; self.parts.len()];
        let mut next = 0;
        for pair in 0..order.len() {
            if pair > 0 && self.key_of(&self.parts[order[pair]]) != self.key_of(&self.parts[order[pair - 1]]) {
                next += 1;
            }
            types[order[pair]] = next;
        }
        types
    }
}
