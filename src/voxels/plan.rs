//! A set of plan cells.

/// A set of cells of a plan, x fastest. Cells outside the plan are not in the set.
#[derive(Clone, Debug, Default, PartialEq, Eq, Hash)]
pub struct Plan {
    size: [usize; 2],
    cells: Vec<bool>,
}

impl Plan {
    /// The empty set on nx x ny cells.
    pub fn new(size: [usize; 2]) -> Self {
        Plan { size, cells: vec![false; size[0] * size[1]] }
    }

    /// The set of the cells marked in `cells`, nx ny of them, x fastest.
    pub(super) fn from_cells(size: [usize; 2], cells: Vec<bool>) -> Self {
        debug_assert_eq!(cells.len(), size[0] * size[1]);
        Plan { size, cells }
    }

    /// Cells along x and y.
    #[inline]
    pub fn size(&self) -> [usize; 2] {
        self.size
    }

    /// Whether a cell is in the set; false outside the plan.
    #[inline]
    pub fn has(&self, [x, y]: [isize; 2]) -> bool {
        x >= 0
            && y >= 0
            && (x as usize) < self.size[0]
            && (y as usize) < self.size[1]
            && self.cells[x as usize + self.size[0] * y as usize]
    }

    /// Puts a cell of the plan in the set or takes it out.
    #[inline]
    pub fn set(&mut self, [x, y]: [usize; 2], value: bool) {
        self.cells[x + self.size[0] * y] = value;
    }

    /// Number of cells in the set.
    pub fn count(&self) -> usize {
        self.cells.iter().filter(|&&c| c).count()
    }

    /// Whether no cell is in the set.
    pub fn is_empty(&self) -> bool {
        !self.cells.contains(&true)
    }

    /// The cells in the set, x fastest.
    pub fn iter(&self) -> impl Iterator<Item = [usize; 2]> + '_ {
        let nx = self.size[0].max(1);
        self.cells.iter().enumerate().filter(|(_, c)| **c).map(move |(i, _)| [i % nx, i / nx])
    }

    /// Whether a cell and its four neighbours are in the set: it then lies inside the wall lining.
    #[inline]
    pub fn interior(&self, [x, y]: [isize; 2]) -> bool {
        self.has([x, y]) && self.has([x - 1, y]) && self.has([x + 1, y]) && self.has([x, y - 1]) && self.has([x, y + 1])
    }
}
