//! Piece marks and type marks.

use super::types::{PartKind, Parts};
use crate::voxels::Direction;

/// The marks of a house's parts, in their order.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Marks {
    /// One mark a part, such as `W1-S03`: kind and level, direction it faces (cassettes without one: none), number.
    pub piece: Vec<String>,
    /// The mark of its type, such as `WP-04`, with `m` where the piece is the mirror image of the first of its type.
    pub of_type: Vec<String>,
    /// Pieces of the same type (both hands), by part.
    pub count: Vec<u32>,
}

/// Letters of a kind in piece marks and in type marks.
fn letters(kind: PartKind) -> [&'static str; 2] {
    match kind {
        PartKind::Wall => ["W", "WP"],
        PartKind::Floor => ["F", "FC"],
        PartKind::Deck => ["D", "DC"],
        PartKind::Slope => ["R", "RC"],
        PartKind::Level => ["L", "LC"],
        PartKind::Window => ["G", "WI"],
        PartKind::Door => ["E", "DO"],
        PartKind::Stair => ["T", "ST"],
    }
}

fn letter(direction: Direction) -> &'static str {
    match direction {
        Direction::East => "E",
        Direction::North => "N",
        Direction::West => "W",
        Direction::South => "S",
    }
}

/// Marks every part. Pieces are numbered by kind, level and direction in the order of the cut; types by kind in the order of
/// [`Parts::types`].
pub fn marks(parts: &Parts) -> Marks {
    let types = parts.types();
    let kinds = parts.parts.iter().map(|p| p.kind);
    // The first type of each kind: types are sorted by kind.
    let mut first = [u32::MAX; PartKind::ALL.len()];
    for (kind, &t) in kinds.zip(&types) {
        first[kind as usize] = first[kind as usize].min(t);
    }
    let mut count = vec![0; parts.parts.len()];
    let mut hands: Vec<Option<bool>> = vec![None; parts.parts.len()];
    let mut totals = vec![0u32; parts.parts.len()];
    for (part, &t) in parts.parts.iter().zip(&types) {
        totals[t as usize] += 1;
        hands[t as usize].get_or_insert(part.mirrored);
    }
    let mut numbers = std::collections::BTreeMap::new();
    let (mut piece, mut of_type) = (Vec::with_capacity(types.len()), Vec::with_capacity(types.len()));
    for (n, (part, &t)) in parts.parts.iter().zip(&types).enumerate() {
        let [one, two] = letters(part.kind);
        let number = numbers.entry((part.kind, part.level, part.facing)).or_insert(0u32);
        *number += 1;
        let facing = part.facing.map_or("", letter);
        piece.push(format!("{one}{}-{facing}{:02}", part.level, *number));
        let hand = if hands[t as usize] == Some(part.mirrored) { "" } else { "m" };
        of_type.push(format!("{two}-{:02}{hand}", t - first[part.kind as usize] + 1));
        count[n] = totals[t as usize];
    }
    Marks { piece, of_type, count }
}
