//! The admissible configurations, their classes under symmetry, and what they are in a house.

use super::{Mask, Symmetry};

/// What a configuration is in a house, by the number of its filled corners below and above.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Category {
    /// More filled corners below than above. 11 classes.
    Roof,
    /// More above than below. 11 classes.
    Floor,
    /// The same corners above and below. 3 classes.
    Wall,
    /// As many above as below but not the same ones. 1 class.
    Extra,
}

impl Category {
    /// The category of a mask.
    pub fn of(mask: Mask) -> Category {
        let (bottom, top) = (mask.bottom(), mask.top());
        match bottom.count_ones().cmp(&top.count_ones()) {
            std::cmp::Ordering::Greater => Category::Roof,
            std::cmp::Ordering::Less => Category::Floor,
            std::cmp::Ordering::Equal if bottom == top => Category::Wall,
            std::cmp::Ordering::Equal => Category::Extra,
        }
    }

    /// Lower-case English name, used in the names of tiles.
    pub fn name(self) -> &'static str {
        match self {
            Category::Roof => "roof",
            Category::Floor => "floor",
            Category::Wall => "wall",
            Category::Extra => "extra",
        }
    }
}

/// The 126 admissible masks in rising order.
pub fn admissible_masks() -> impl Iterator<Item = Mask> {
    Mask::all().filter(|m| m.is_admissible())
}

/// The smallest mask of the class of `mask` under quarter turns and mirror, and the first symmetry that carries it to `mask`.
pub fn canonical(mask: Mask) -> (Mask, Symmetry) {
    let smallest = Symmetry::all().map(|s| s.mask(mask)).min().unwrap_or(mask);
    let symmetry = Symmetry::all().find(|s| s.mask(smallest) == mask).unwrap_or(Symmetry::IDENTITY);
    (smallest, symmetry)
}

/// The smallest mask of each of the 26 classes under quarter turns and mirror, in rising order.
pub fn canonical_masks() -> Vec<Mask> {
    admissible_masks().filter(|&m| canonical(m).0 == m).collect()
}

/// The smallest mask of the class of `mask` under quarter turns alone; the admissible masks form 33 such classes.
pub fn turn_class(mask: Mask) -> Mask {
    (0..4).map(|turns| Symmetry { mirror: false, turns }.mask(mask)).min().unwrap_or(mask)
}

/// How many of the 26 classes are roof, floor, wall and extra.
pub fn categories() -> [usize; 4] {
    let mut count = [0; 4];
    for mask in canonical_masks() {
        count[Category::of(mask) as usize] += 1;
    }
    count
}
