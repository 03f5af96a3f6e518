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

/// First row and column of some places, and one past the last.
pub(super) fn bounds(places: &[[usize; 2]]) -> [[usize; 2]; 2] {
    places.iter().fold([[usize::MAX; 2], [0; 2]], |[low, high], p| {
        [[0, 1].map(|a| low[a].min(p[a])), [0, 1].map(|a| high[a].max(p[a] + 1))]
    })
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
    /// First and last + 1 row and column of what is there.
    bounds: [[usize; 2]; 2],
}

impl Sheet {
    pub fn new(frame: Frame) -> Sheet {
        Sheet { frame, spots: Vec::new(), bounds: [[usize::MAX; 2], [0; 2]] }
    }

    /// Lays something (a code that is not 0) on a cell.
    pub fn set(&mut self, cell: [usize; 2], spot: Spot) {
        let at = self.frame.place(cell);
        let [rows, columns] = self.frame.extent();
        if self.spots.is_empty() {
            // Most sheets stay empty: a house has few slopes, plates and decks.
            self.spots.resize(rows * columns, Spot::default());
        }
        self.spots[at[0] * columns + at[1]] = spot;
        let [low, high] = self.bounds;
        self.bounds = [[low[0].min(at[0]), low[1].min(at[1])], [high[0].max(at[0] + 1), high[1].max(at[1] + 1)]];
    }

    pub fn at(&self, [row, column]: [usize; 2]) -> Spot {
        self.spots[row * self.frame.extent()[1] + column]
    }
}

/// A sheet within its bounds, seen in one of its mirror images.
pub(super) struct View {
    bounds: [[usize; 2]; 2],
    extent: [usize; 2],
    flips: [bool; 2],
    /// Row by row.
    codes: Vec<u16>,
    planes: Vec<i32>,
}

/// The codes of a sheet seen with flips across and along, row by row.
fn picture(codes: &[u16], columns: usize, flips: [bool; 2], quarters: bool, out: &mut Vec<u16>) {
    out.clear();
    let turned = |code: u16| if quarters { flipped(code, flips) } else { code };
    let mut take = |row: &[u16]| {
        if flips[1] {
            out.extend(row.iter().rev().map(|&code| turned(code)));
        } else {
            out.extend(row.iter().map(|&code| turned(code)));
        }
    };
    let rows = codes.chunks_exact(columns);
    if flips[0] { rows.rev().for_each(&mut take) } else { rows.for_each(&mut take) }
}

impl View {
    /// The mirror image whose picture comes first; `None` of an empty sheet.
    pub fn canonical(sheet: &Sheet, cutting: Cutting) -> Option<View> {
        if sheet.spots.is_empty() {
            return None;
        }
        let bounds @ [low, high] = sheet.bounds;
        let extent @ [rows, columns] = [high[0] - low[0], high[1] - low[1]];
        let width = sheet.frame.extent()[1];
        let row = |r: usize| &sheet.spots[(low[0] + r) * width + low[1]..][..columns];
        let seen: Vec<u16> = (0..rows).flat_map(row).map(|spot| spot.code).collect();
        let mut view = View { bounds, extent, flips: [false; 2], codes: seen.clone(), planes: Vec::new() };
        let mut other = Vec::with_capacity(seen.len());
        let others = [[true, false], [false, true], [true, true]];
        for flips in others.into_iter().filter(|f| cutting.ends_alike || !f[1]) {
            picture(&seen, columns, flips, cutting.quarters, &mut other);
            if other < view.codes {
                view.flips = flips;
                std::mem::swap(&mut view.codes, &mut other);
            }
        }
        view.planes.reserve(seen.len());
        for r in 0..rows {
            let row = row(if view.flips[0] { rows - 1 - r } else { r }).iter().map(|spot| spot.plane);
            if view.flips[1] { view.planes.extend(row.rev()) } else { view.planes.extend(row) }
        }
        Some(view)
    }

    pub fn comes_before(&self, other: &View) -> bool {
        (self.extent, &self.codes) < (other.extent, &other.codes)
    }

    fn place(&self, at: [usize; 2]) -> [usize; 2] {
        [0, 1].map(|a| if self.flips[a] { self.bounds[1][a] - 1 - at[a] } else { self.bounds[0][a] + at[a] })
    }

    /// Cuts the sheet; `emit` gets the cells of each cassette as places (row, column) of the sheet.
    pub fn cut(&self, cutting: Cutting, mut emit: impl FnMut(&[[usize; 2]])) {
        let [rows, columns] = self.extent;
        let mut used: Vec<bool> = self.codes.iter().map(|&code| code == 0).collect();
        let mut piece: Vec<[usize; 2]> = Vec::new();
        for row in 0..rows {
            let mut column = 0;
            while column < columns {
                let plane = self.planes[row * columns + column];
                let free = |used: &[bool], r: usize, c: usize| {
                    let at = r * columns + c;
                    !used[at] && self.planes[at] == plane
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
        let [rows, columns] = self.extent;
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
