//! Cutting a sheet of cells (a floor, a deck, a roof plane) into cassettes.
//!
//! A sheet lies in the part's own frame: columns run along the cassettes, rows across. It is cut in the one of its mirror images whose
//! picture comes first, so that a mirrored sheet is cut in mirror image.

use crate::voxels::Direction;

/// One cell of a sheet: 0 = nothing. Cells of different planes never share a cassette.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct Spot {
    pub code: u16,
    pub plane: i32,
}

/// The frame of a sheet: columns run against `fall`, rows to the left of it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Frame {
    pub fall: Direction,
    pub size: [usize; 2],
}

impl Frame {
    /// Axis along the cassettes.
    pub fn axis(self) -> usize {
        usize::from(self.fall.step()[0] == 0)
    }

    /// Rows and columns.
    pub fn extent(self) -> [usize; 2] {
        [self.size[1 - self.axis()], self.size[self.axis()]]
    }

    /// Row and column of a plan cell, and back.
    pub fn place(self, [x, y]: [usize; 2]) -> [usize; 2] {
        let [nx, ny] = self.size;
        match self.fall {
            Direction::South => [x, y],
            Direction::East => [y, nx - 1 - x],
            Direction::North => [nx - 1 - x, ny - 1 - y],
            Direction::West => [ny - 1 - y, x],
        }
    }

    /// The plan cell of a row and column.
    pub fn cell(self, [row, column]: [usize; 2]) -> [usize; 2] {
        let [nx, ny] = self.size;
        match self.fall {
            Direction::South => [row, column],
            Direction::East => [nx - 1 - column, row],
            Direction::North => [nx - 1 - row, ny - 1 - column],
            Direction::West => [column, ny - 1 - row],
        }
    }

    /// Number (along + 2 across) of a quarter (x + 2y) of a cell.
    pub fn quarter(self, q: usize) -> usize {
        let (x, y) = (q & 1, q >> 1);
        let (along, across) = match self.fall {
            Direction::South => (y, x),
            Direction::East => (1 - x, y),
            Direction::North => (1 - y, 1 - x),
            Direction::West => (x, 1 - y),
        };
        along + 2 * across
    }
}

/// What a sheet is cut by.
#[derive(Clone, Copy)]
pub(super) struct Cutting {
    /// Most modules across and along.
    pub most: [usize; 2],
    /// Whether cassettes must be rectangles; slopes may be triangles and trapezia.
    pub rectangles: bool,
    /// Whether codes are quarters.
    pub quarters: bool,
    /// Whether the far end is like the near end; not on a slope.
    pub ends_alike: bool,
}

/// A code seen in mirror image across or along.
pub(super) fn flipped(code: u16, [across, along]: [bool; 2]) -> u16 {
    let code = if along { (code & 0x33) << 2 | (code >> 2 & 0x33) } else { code };
    if across { (code & 0x0f) << 4 | code >> 4 & 0x0f } else { code }
}

pub(super) struct Sheet {
    pub frame: Frame,
    spots: Vec<Spot>,
}

impl Sheet {
    pub fn new(frame: Frame) -> Sheet {
        Sheet { frame, spots: vec![Spot::default(); frame.size[0] * frame.size[1]] }
    }

    pub fn set(&mut self, cell: [usize; 2], spot: Spot) {
        let [row, column] = self.frame.place(cell);
        let columns = self.frame.extent()[1];
        self.spots[row * columns + column] = spot;
    }

    pub fn at(&self, [row, column]: [usize; 2]) -> Spot {
        self.spots[row * self.frame.extent()[1] + column]
    }

    /// The box of the cells that are there: first and last + 1 row and column; `None` when empty.
    pub fn bounds(&self) -> Option<[[usize; 2]; 2]> {
        let columns = self.frame.extent()[1].max(1);
        let mut bounds: Option<[[usize; 2]; 2]> = None;
        for (n, _) in self.spots.iter().enumerate().filter(|(_, s)| s.code != 0) {
            let at = [n / columns, n % columns];
            bounds = Some(match bounds {
                None => [at, [at[0] + 1, at[1] + 1]],
                Some([a, b]) => [[a[0].min(at[0]), a[1].min(at[1])], [b[0].max(at[0] + 1), b[1].max(at[1] + 1)]],
            });
        }
        bounds
    }
}

/// A sheet within its bounds, seen in one of its mirror images.
#[derive(Clone, Copy)]
pub(super) struct View<'a> {
    sheet: &'a Sheet,
    bounds: [[usize; 2]; 2],
    flips: [bool; 2],
    quarters: bool,
}

impl<'a> View<'a> {
    /// The mirror image whose picture comes first.
    pub fn canonical(sheet: &'a Sheet, cutting: Cutting) -> Option<View<'a>> {
        let bounds = sheet.bounds()?;
        let view = |flips| View { sheet, bounds, flips, quarters: cutting.quarters };
        let mut best = view([false, false]);
        let others = [[true, false], [false, true], [true, true]];
        for flips in others.into_iter().filter(|f| cutting.ends_alike || !f[1]) {
            if view(flips).comes_before(&best) {
                best = view(flips);
            }
        }
        Some(best)
    }

    pub fn comes_before(&self, other: &View) -> bool {
        self.extent().cmp(&other.extent()).then_with(|| self.picture().cmp(other.picture())).is_lt()
    }

    fn picture(&self) -> impl Iterator<Item = u16> + '_ {
        let [rows, columns] = self.extent();
        (0..rows).flat_map(move |r| (0..columns).map(move |c| self.at([r, c]).code))
    }

    fn extent(&self) -> [usize; 2] {
        [self.bounds[1][0] - self.bounds[0][0], self.bounds[1][1] - self.bounds[0][1]]
    }

    fn place(&self, at: [usize; 2]) -> [usize; 2] {
        [0, 1].map(|a| if self.flips[a] { self.bounds[1][a] - 1 - at[a] } else { self.bounds[0][a] + at[a] })
    }

    fn at(&self, at: [usize; 2]) -> Spot {
        let spot = self.sheet.at(self.place(at));
        if self.quarters { Spot { code: flipped(spot.code, self.flips), ..spot } } else { spot }
    }

    /// Cuts the sheet; `emit` gets the cells of each cassette as places (row, column) of the sheet.
    pub fn cut(&self, cutting: Cutting, mut emit: impl FnMut(&[[usize; 2]])) {
        let [rows, columns] = self.extent();
        let mut used = vec![false; rows * columns];
        let mut piece: Vec<[usize; 2]> = Vec::new();
        for row in 0..rows {
            let mut column = 0;
            while column < columns {
                let plane = self.at([row, column]).plane;
                let free = |used: &[bool], r: usize, c: usize| {
                    let spot = self.at([r, c]);
                    !used[r * columns + c] && spot.code != 0 && spot.plane == plane
                };
                if !free(&used, row, column) {
                    column += 1;
                    continue;
                }
                let spans = self.spans([row, column], cutting, |r, c| free(&used, r, c));
                let (low, high) = spans.iter().fold((usize::MAX, 0), |(l, h), s| (l.min(s[0]), h.max(s[1])));
                let pieces = (high - low).div_ceil(cutting.most[1]);
                for n in 0..pieces {
                    let part = [low + (high - low) * n / pieces, low + (high - low) * (n + 1) / pieces];
                    piece.clear();
                    for (r, span) in spans.iter().enumerate() {
                        for c in span[0].max(part[0])..span[1].min(part[1]) {
                            used[(row + r) * columns + c] = true;
                            piece.push(self.place([row + r, c]));
                        }
                    }
                    if !piece.is_empty() {
                        emit(&piece);
                    }
                }
            }
        }
    }

    /// The columns of each row of the strip that begins at a free place, the first row first.
    fn spans(
        &self,
        [row, column]: [usize; 2],
        cutting: Cutting,
        free: impl Fn(usize, usize) -> bool,
    ) -> Vec<[usize; 2]> {
        let [rows, columns] = self.extent();
        let run = |r: usize, from: usize| (from..columns).take_while(|&c| free(r, c)).count() + from;
        let last = (row + cutting.most[0]).min(rows);
        if cutting.rectangles {
            let depth = |c: usize| (row..last).take_while(|&r| free(r, c)).count();
            let deep = depth(column);
            let end = (column..run(row, column)).take_while(|&c| depth(c) == deep).count() + column;
            return vec![[column, end]; deep];
        }
        let mut spans = vec![[column, run(row, column)]];
        for r in row + 1..last {
            let [from, to] = spans[spans.len() - 1];
            let Some(meets) = (from..to).find(|&c| free(r, c)) else { break };
            let before = (0..meets).rev().take_while(|&c| free(r, c)).count();
            spans.push([meets - before, run(r, meets)]);
        }
        spans
    }
}
