//! Mirror images and quarter turns of a plot, and of the designs on it (HOUSE.md section 1, identity).

use super::cells::Cells;
use super::massing::{Design, Massing, Opening, StoreyMass};
use super::plot::{Plot, Space};
use crate::voxels::{Choice, Direction, Stair};

/// A map of the plot onto itself: x and y exchanged (or not), then mirrored along either.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Symmetry {
    /// Whether x and y are exchanged.
    pub swap: bool,
    /// Whether x, after that, runs the other way.
    pub flip_x: bool,
    /// Whether y does.
    pub flip_y: bool,
}

impl Symmetry {
    /// Everything stays where it is.
    pub const IDENTITY: Symmetry = Symmetry { swap: false, flip_x: false, flip_y: false };

    /// The symmetries of a plot, the identity first: those that leave buildable and given cells where they are.
    ///
    /// Wind blows from all sides alike (one basic velocity for the site) and no objective asks where the sun stands: but for the plot
    /// nothing tells mirror images apart. An objective or a site that does so has to be asked here.
    ///
    /// The analysis is not quite even-handed: sway ratios of images were seen to differ by 0.7 %, deflections under hips of two modules by
    /// 0.3 %, violations of failing houses by 2e-5. Price, carbon, areas and heat loss agreed to rounding, and so did the objectives of
    /// the briefs of `configs/exact` (60 designs of each).
    pub fn of(plot: &Plot) -> Vec<Symmetry> {
        let all = (0..8).map(|n| Symmetry { swap: n & 4 > 0, flip_x: n & 2 > 0, flip_y: n & 1 > 0 });
        all.filter(|s| s.keeps(plot)).collect()
    }

    fn keeps(&self, plot: &Plot) -> bool {
        let [nx, ny] = plot.size();
        if self.swap && nx != ny {
            return false;
        }
        // Zones and labels of given voxels have their place: a plot that has them is kept as it stands.
        if plot.kept.is_some() || plot.given.as_ref().is_some_and(|g| !g.zones.is_empty()) {
            return *self == Symmetry::IDENTITY;
        }
        let same = |cells: &Cells| self.cells(cells) == *cells;
        same(&plot.buildable) && plot.given.as_ref().is_none_or(|g| g.fill.iter().chain(&g.empty).all(same))
    }

    /// The image of a cell of a plan of `size`.
    fn cell(&self, [x, y]: [isize; 2], [nx, ny]: [usize; 2]) -> [isize; 2] {
        let ([x, y], [nx, ny]) = if self.swap { ([y, x], [ny, nx]) } else { ([x, y], [nx, ny]) };
        let mirror = |flip: bool, v: isize, n: usize| if flip { n as isize - 1 - v } else { v };
        [mirror(self.flip_x, x, nx), mirror(self.flip_y, y, ny)]
    }

    fn direction(&self, direction: Direction) -> Direction {
        let [dx, dy] = direction.step();
        let [dx, dy] = if self.swap { [dy, dx] } else { [dx, dy] };
        let turned = [if self.flip_x { -dx } else { dx }, if self.flip_y { -dy } else { dy }];
        Direction::ALL.into_iter().find(|d| d.step() == turned).unwrap_or(direction)
    }

    /// The image of a set of cells.
    pub fn cells(&self, cells: &Cells) -> Cells {
        let size = cells.size();
        let mut out = Cells::new(if self.swap { [size[1], size[0]] } else { size });
        for [x, y] in cells.iter() {
            let [x, y] = self.cell([x as isize, y as isize], size);
            out.set([x as usize, y as usize], true);
        }
        out
    }

    fn opening(&self, opening: &Opening, size: [usize; 2]) -> Opening {
        let cell = opening.cells().map(|c| self.cell(c, size)).min().unwrap_or(opening.cell);
        Opening { facing: self.direction(opening.facing), cell, ..*opening }
    }

    /// `None` for a U-stair in a mirror: its second flight would lie to the right, and there is no such stair.
    fn stair(&self, stair: &Stair, size: [usize; 2]) -> Option<Stair> {
        let start = self.cell(stair.start.map(|v| v as isize), size).map(|v| v as usize);
        let image = Stair { start, run: self.direction(stair.run), ..*stair };
        (image.flight_cells() == stair.flight_cells().map(|c| self.cell(c, size))).then_some(image)
    }

    /// The image of a design; `None` where the search has no such design.
    pub fn design(&self, design: &Design, space: &Space) -> Option<Design> {
        let size = space.plot.size();
        let storey = |s: &StoreyMass| -> Option<StoreyMass> {
            let mut openings: Vec<Opening> = s.openings.iter().map(|o| self.opening(o, size)).collect();
            openings.sort_unstable();
            let stair = match &s.stair {
                Some(stair) => Some(self.stair(stair, size)?),
                None => None,
            };
            Some(StoreyMass { footprint: self.cells(&s.footprint), openings, stair })
        };
        let storeys = design.massing.storeys.iter().map(storey).collect::<Option<Vec<_>>>()?;
        let mut choices = design.choices;
        if self.swap {
            let plates = (1u32 << storeys.len().min(16)) - 1;
            choices.0[Choice::Joists as usize] ^= plates as u16;
        }
        let kept = choices.0[Choice::Joists as usize] < space.choices.count(Choice::Joists);
        kept.then_some(Design { massing: Massing { storeys, roof: design.massing.roof }, choices })
    }
}
