//! Which part a solid belongs to.

use super::types::{Part, PartId, PartKind, Parts};
use crate::envelope::Fabric;
use crate::tiles::Component;
use crate::voxels::{Direction, STOREY_MODULES};

/// Where a component goes.
enum Home {
    Wall,
    Floor,
    Roof,
    Opening,
    Railing,
    Stair,
    Site,
}

fn home(component: Component) -> Home {
    match component {
        Component::Cladding | Component::Band | Component::WallInsulation | Component::WallLining => Home::Wall,
        Component::Reveal | Component::Sill => Home::Wall,
        Component::FloorBoards | Component::FloorStructure | Component::Ceiling => Home::Floor,
        Component::SoffitInsulation | Component::SoffitBoards => Home::Floor,
        Component::RoofCovering | Component::RoofInsulation | Component::RoofLining => Home::Roof,
        Component::FlatMembrane | Component::FlatInsulation | Component::DeckBoards => Home::Roof,
        Component::Fascia | Component::Gutter | Component::Coping => Home::Roof,
        Component::RailingRail | Component::RailingGlass => Home::Railing,
        Component::WindowFrame | Component::Glass => Home::Opening,
        Component::DoorFrame | Component::DoorLeaf | Component::Handle => Home::Opening,
        Component::StairTread | Component::StairString => Home::Stair,
        Component::Paving | Component::GroundSlab | Component::GroundInsulation => Home::Site,
        Component::PerimeterBeam | Component::PlinthInsulation | Component::PlinthRender => Home::Site,
    }
}

impl Parts {
    /// The part a solid belongs to: `voxel` is the voxel of its octant, `centre_m` its centre in house coordinates. Walls: the panel of the
    /// facade nearest to the centre; in the square of an outer or inner corner the panel that runs through there. Floors, decks and slabs' undersides: the cassette of the cell; roofs: the cassette of the plane over the
    /// quarter; railings: the deck below, else the stair. `None` for site work (foundation, plinth, paving) and where the house has no such part, as below the lowest slab top.
    pub fn of(&self, voxel: [usize; 3], component: Component, centre_m: [f64; 3]) -> Option<PartId> {
        let found = match home(component) {
            Home::Wall => {
                let wall = self.wall_of(voxel, centre_m).or_else(|| self.roof_of(voxel, centre_m));
                // The inner corner of a parapet stands on its deck.
                wall.or_else(|| self.slab_of(voxel))
            }
            // Level roofs lie on a floor's structure.
            Home::Floor => self.slab_of(voxel).or_else(|| self.roof_of(voxel, centre_m)),
            Home::Roof => self.roof_of(voxel, centre_m).or_else(|| self.slab_of(voxel)),
            Home::Opening => self.opening_of(voxel, centre_m),
            Home::Railing => {
                let deck = self.roof_of(voxel, centre_m).or_else(|| self.slab_of(voxel));
                deck.or_else(|| self.stair_below(voxel)).or_else(|| self.stair_of(voxel))
            }
            Home::Stair => self.stair_of(voxel),
            Home::Site => None,
        };
        found.map(|n| PartId(n as u32))
    }

    /// The part of each block of a fabric, as [`Parts::of`] finds it, in the order of [`Fabric::placed`].
    pub fn of_fabric(&self, fabric: &Fabric) -> Vec<Option<PartId>> {
        let part = |placed: &crate::envelope::PlacedBlock| {
            let [Some(x), Some(y), Some(z)] = placed.voxel.map(|c| usize::try_from(c).ok()) else { return None };
            self.of([x, y, z], placed.component, fabric.centre_m(placed))
        };
        fabric.placed.iter().map(part).collect()
    }

    /// Position in modules within a voxel, 0 to 1 for what lies inside it.
    fn inside(&self, voxel: [usize; 3], centre_m: [f64; 3]) -> [f64; 3] {
        [0, 1, 2].map(|a| (centre_m[a] - self.origin_m[a]) / self.module_m[a] - voxel[a] as f64 + 0.5)
    }

    /// Level and half module of a voxel's lower or upper half; `None` below the ground's slab top.
    fn half([_, _, k]: [usize; 3], upper: bool) -> Option<(usize, usize)> {
        let half = (2 * k + usize::from(upper)).checked_sub(1)?;
        Some((half / (2 * STOREY_MODULES), half % (2 * STOREY_MODULES)))
    }

    /// The panel of a cell and direction at a level that has the half module, or that has the cell at all.
    fn panel(&self, cell: [isize; 2], d: Direction, level: usize, half: usize) -> Option<usize> {
        let holds = |p: &Part, exact: bool| {
            p.kind == PartKind::Wall
                && p.facing == Some(d)
                && usize::from(p.level) == level
                && self
                    .cells_of(p)
                    .iter()
                    .any(|c| c.cell.map(|v| v as isize) == cell && (!exact || c.code >> half & 1 == 1))
        };
        let find = |exact| self.parts.iter().position(|p| holds(p, exact));
        find(true).or_else(|| find(false))
    }

    fn wall_of(&self, voxel: [usize; 3], centre_m: [f64; 3]) -> Option<usize> {
        let at = self.inside(voxel, centre_m);
        let (level, half) = Self::half(voxel, at[2] >= 0.5)?;
        let cell = [voxel[0] as isize, voxel[1] as isize];
        let depth = |d: Direction| {
            let [dx, dy] = d.step();
            let (a, up) = if dx != 0 { (0, dx > 0) } else { (1, dy > 0) };
            (if up { 1.0 - at[a] } else { at[a] }) * self.module_m[a] * 1000.0
        };
        let beside = |d: Direction| [cell[0] + d.step()[0], cell[1] + d.step()[1]];
        let own: Vec<(Direction, usize)> =
            Direction::ALL.into_iter().filter_map(|d| Some((d, self.panel(cell, d, level, half)?))).collect();
        let within = |d: Direction| depth(d) < self.wall_mm;
        let runs_through = |d: Direction| usize::from(d.left().step()[0] == 0) == usize::from(self.through_axis);
        let nearest = own.iter().min_by(|a, b| depth(a.0).total_cmp(&depth(b.0)));
        // The square of an outer corner.
        if let Some((_, part)) = own.iter().find(|(d, _)| within(*d) && runs_through(*d)) {
            return Some(*part);
        }
        if let Some((_, part)) = nearest.filter(|(d, _)| within(*d)) {
            return Some(*part);
        }
        // Inner corner: nothing beside the cell is open, only the diagonal; the panel that runs through reaches into it. A wall that
        // goes on in the layer above or below its facade belongs to the panel there.
        Direction::ALL
            .into_iter()
            .filter(|d| within(*d) && runs_through(*d))
            .flat_map(|d| [d.left(), d.left().back()].map(|side| (d, side)))
            .filter(|(_, side)| within(*side))
            .find_map(|(d, side)| self.panel(beside(side), d, level, half))
            .or(nearest.map(|(_, part)| *part))
            .or_else(|| self.beside_level(cell, level, half))
    }

    /// The panel of a cell in the level above or below, for what hangs over a joint.
    fn beside_level(&self, cell: [isize; 2], level: usize, half: usize) -> Option<usize> {
        let levels = [level.checked_sub(1), Some(level + 1)];
        levels.into_iter().flatten().find_map(|l| Direction::ALL.into_iter().find_map(|d| self.panel(cell, d, l, half)))
    }

    fn slab_of(&self, [x, y, k]: [usize; 3]) -> Option<usize> {
        let holds = |p: &Part| {
            matches!(p.kind, PartKind::Floor | PartKind::Deck)
                && self.cells_of(p).iter().any(|c| c.cell.map(usize::from) == [x, y] && usize::from(c.k) == k)
        };
        self.parts.iter().position(holds)
    }

    /// The roof cassette over the quarter (and triangle) of a voxel that a centre lies in.
    fn roof_of(&self, voxel: [usize; 3], centre_m: [f64; 3]) -> Option<usize> {
        let [x, y, k] = voxel;
        let at = self.inside(voxel, centre_m);
        let out = [at[0] - 0.5, at[1] - 0.5];
        let q = usize::from(out[0] >= 0.0) + 2 * usize::from(out[1] >= 0.0);
        let has = |p: &Part, exact: bool| {
            let axis = usize::from(p.axis);
            self.cells_of(p).iter().any(|c| {
                if c.cell.map(usize::from) != [x, y] || usize::from(c.k) != k {
                    return false;
                }
                let beside = || out[axis].abs() >= out[1 - axis].abs();
                match (self.code_at(p, c.code, q), exact) {
                    (_, false) | (1, true) => true,
                    (2, true) => beside(),
                    (3, true) => !beside(),
                    _ => false,
                }
            })
        };
        let roofs =
            || self.parts.iter().enumerate().filter(|(_, p)| matches!(p.kind, PartKind::Slope | PartKind::Level));
        let find = |exact: bool| roofs().find(|(_, p)| has(p, exact)).map(|(n, _)| n);
        find(true).or_else(|| find(false))
    }

    /// The two bits of a quarter (x + 2y) of a roof cell.
    pub(super) fn code_at(&self, part: &Part, code: u16, q: usize) -> u16 {
        let fall = match (part.facing, part.axis) {
            (Some(fall), _) => fall,
            (None, 0) => Direction::West,
            (None, _) => Direction::South,
        };
        let frame = super::cassettes::Frame { fall, size: [0, 0] };
        code >> (2 * frame.quarter(q)) & 3
    }

    fn opening_of(&self, voxel: [usize; 3], centre_m: [f64; 3]) -> Option<usize> {
        let at = self.inside(voxel, centre_m);
        // The sill of a French window lies in the plate's own voxel.
        let level = voxel[2].checked_sub(usize::from(at[2] < 0.5 || !voxel[2].is_multiple_of(STOREY_MODULES)))?
            / STOREY_MODULES;
        let holds = |p: &Part| {
            let axis = usize::from(p.axis);
            let first = p.first.map(usize::from);
            matches!(p.kind, PartKind::Window | PartKind::Door)
                && usize::from(p.level) == level
                && first[1 - axis] == voxel[1 - axis]
                && (first[axis]..first[axis] + usize::from(p.modules[0])).contains(&voxel[axis])
        };
        self.parts.iter().position(holds)
    }

    /// The stair that comes up to a floor, for the railing that stands a railing's height over it.
    fn stair_below(&self, [_, _, k]: [usize; 3]) -> Option<usize> {
        let rises = k % STOREY_MODULES < STOREY_MODULES / 2;
        let level = (k / STOREY_MODULES).checked_sub(usize::from(rises))?;
        self.stair_on(level)
    }

    fn stair_of(&self, [_, _, k]: [usize; 3]) -> Option<usize> {
        self.stair_on(k.saturating_sub(1) / STOREY_MODULES)
    }

    fn stair_on(&self, level: usize) -> Option<usize> {
        self.parts.iter().position(|p| p.kind == PartKind::Stair && usize::from(p.level) == level)
    }
}
