//! Patterns: which labels a tile allows at each corner.

use crate::cubes::{Corner, CornerOrder, CubeKey, Mask, Symmetry};
use crate::voxels::Label;
use std::collections::BTreeMap;
use std::fmt;

/// The labels allowed at one corner: bit n for label code n.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Choice(u8);

impl Choice {
    /// Any label, empty too: `.`.
    pub const ANY: Choice = Choice(0b11_1111);
    /// Any filled label: `*`.
    pub const FILLED: Choice = Choice(0b11_1110);
    /// Empty only: `0`.
    pub const EMPTY: Choice = Choice(1);

    /// One label.
    pub fn of(label: Label) -> Choice {
        Choice(1 << label.code())
    }

    /// Whether a label is allowed.
    #[inline]
    pub fn allows(self, label: Label) -> bool {
        self.0 >> label.code() & 1 == 1
    }

    /// Whether an empty corner is allowed, and whether a filled one is.
    fn occupancy(self) -> [bool; 2] {
        [self.0 & 1 != 0, self.0 & Choice::FILLED.0 != 0]
    }
}

/// Allowed labels at the eight corners, in corner order x + 2y + 4z.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Pattern(pub [Choice; 8]);

/// What the digits of a pattern stand for.
#[derive(Clone, Copy, Debug)]
pub(super) enum Digits<'a> {
    /// 0 empty, 1 filled: sets that do not look at labels.
    Occupancy,
    /// Codes of the manifest's own label table.
    Labels(&'a BTreeMap<String, String>),
}

impl Digits<'_> {
    fn choice(self, digit: char) -> Option<Choice> {
        match self {
            Digits::Occupancy => match digit {
                '0' => Some(Choice::EMPTY),
                '1' => Some(Choice::FILLED),
                _ => None,
            },
            Digits::Labels(table) => {
                let name = table.get(digit.encode_utf8(&mut [0; 4]) as &str)?;
                Label::ALL.into_iter().find(|l| l.name() == name).map(Choice::of)
            }
        }
    }
}

impl Pattern {
    /// The pattern of eight labels in corner order.
    pub fn of_labels(labels: [Label; 8]) -> Pattern {
        Pattern(labels.map(Choice::of))
    }

    /// Reads eight entries in the given corner order: a digit, a set of digits in brackets, `*` (any filled) or `.` (any). `None` when
    /// there are not eight of them, or a digit means nothing.
    pub(super) fn parse(text: &str, order: CornerOrder, digits: Digits) -> Option<Pattern> {
        let mut entries = Vec::with_capacity(8);
        let mut rest = text.chars();
        while let Some(c) = rest.next() {
            entries.push(match c {
                '*' => Choice::FILLED,
                '.' => Choice::ANY,
                '[' => {
                    let mut set = Choice(0);
                    loop {
                        match rest.next()? {
                            ']' => break,
                            digit => set.0 |= digits.choice(digit)?.0,
                        }
                    }
                    if set.0 == 0 {
                        return None;
                    }
                    set
                }
                digit => digits.choice(digit)?,
            });
        }
        let read: [Choice; 8] = entries.try_into().ok()?;
        let mut corners = [Choice::ANY; 8];
        for (choice, corner) in read.into_iter().zip(order.corners()) {
            corners[corner] = choice;
        }
        Some(Pattern(corners))
    }

    /// Whether a cube of these labels may have the tile.
    #[inline]
    pub fn matches(&self, key: CubeKey) -> bool {
        (0..8).all(|n| self.0[n].allows(key.label(n)))
    }

    /// The pattern of the tile placed with a symmetry.
    pub fn placed(&self, symmetry: Symmetry) -> Pattern {
        let mut corners = self.0;
        for corner in Corner::all() {
            corners[symmetry.corner(corner).number() as usize] = self.0[corner.number() as usize];
        }
        Pattern(corners)
    }

    /// The masks that the pattern can have: one, unless a corner may be empty as well as filled.
    pub fn masks(&self) -> impl Iterator<Item = Mask> + '_ {
        Mask::all().filter(|m| Corner::all().all(|c| self.0[c.number() as usize].occupancy()[usize::from(m.has(c))]))
    }

    /// A labelling that both patterns allow.
    pub fn common(&self, other: &Pattern) -> Option<CubeKey> {
        let mut labels = [Label::Empty; 8];
        for (n, label) in labels.iter_mut().enumerate() {
            *label = Label::ALL.into_iter().find(|&l| self.0[n].allows(l) && other.0[n].allows(l))?;
        }
        Some(CubeKey::of_labels(labels))
    }
}

impl fmt::Display for Pattern {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for &choice in &self.0 {
            let codes: String =
                Label::ALL.into_iter().filter(|&l| choice.allows(l)).map(|l| l.code().to_string()).collect();
            match choice {
                Choice::ANY => write!(f, ".")?,
                Choice::FILLED => write!(f, "*")?,
                _ if codes.len() == 1 => write!(f, "{codes}")?,
                _ => write!(f, "[{codes}]")?,
            }
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn reads_sets_stars_and_permuted_labels() {
        let names = |swap: bool| {
            Label::ALL
                .into_iter()
                .map(|l| {
                    let code = match l.code() {
                        4 if swap => 5,
                        5 if swap => 4,
                        c => c,
                    };
                    (code.to_string(), l.name().to_string())
                })
                .collect::<BTreeMap<_, _>>()
        };
        let parse =
            |text: &str, table: &BTreeMap<_, _>| Pattern::parse(text, CornerOrder::FOrder, Digits::Labels(table));
        let plain = names(false);
        let pattern = parse("1[15]*.0000", &plain).expect("a pattern");
        assert_eq!(pattern.to_string(), "1[15]*.0000");
        assert_eq!(pattern.masks().count(), 2, "corner 3 may be empty or filled");
        let swapped = parse("1[14]*.0000", &names(true)).expect("a pattern");
        assert_eq!(swapped, pattern, "4 is the window where the table says so");
        for wrong in ["1111000", "111100000", "1111000[", "1111000[]", "11110006", "1111000x"] {
            assert_eq!(parse(wrong, &plain), None, "{wrong}");
        }
        let boxed = Pattern::parse("12340000", CornerOrder::BoxCorners, Digits::Labels(&plain)).expect("a pattern");
        assert_eq!(boxed.to_string(), "12430000");
        assert!(pattern.common(&parse("51110000", &plain).expect("a pattern")).is_none());
        assert_eq!(
            pattern.common(&parse("15330000", &plain).expect("a pattern")).map(|k| k.to_string()),
            Some("15330000".into())
        );
    }

    #[test]
    fn placing_turns_the_corners() {
        let turn = Symmetry { mirror: false, turns: 1 };
        let pattern = Pattern::parse("10000000", CornerOrder::FOrder, Digits::Occupancy).expect("a pattern");
        assert_eq!(pattern.placed(turn).to_string(), "0*000000");
        assert_eq!(pattern.masks().collect::<Vec<_>>(), [Mask(1)]);
    }
}
