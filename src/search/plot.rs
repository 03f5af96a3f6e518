//! Where a house may stand, what it must hold, and what may be chosen: everything a move has to know besides the genome.

use super::cells::{Cells, WIDEST};
use super::fields::Fields;
use super::kept::Kept;
use crate::voxels::{Choice, Module, Plan, STOREY_MODULES};

/// Plots, programmes and given cells that cannot be used.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum PlotError {
    /// The plan is wider than a row of bits.
    #[error("plot.modules: {0} modules along x; at most {WIDEST} are supported: turn the plot or split it")]
    TooWide(usize),
    /// No single storey with its roof plate fits.
    #[error(
        "plot.modules: {0} x {1} x {2} modules hold no house; a storey takes a plan of at least 4 x 4 and 7 layers (one more for a hipped roof)"
    )]
    TooSmall(usize, usize, usize),
    /// A plan has another size than the plot.
    #[error("{what}: plan of {} x {} cells, expected {} x {} as in plot.modules", found[0], found[1], expected[0], expected[1])]
    PlanSize {
        /// Which plan.
        what: &'static str,
        /// Its size.
        found: [usize; 2],
        /// Size of the plot.
        expected: [usize; 2],
    },
    /// Zone ids do not match the plot's voxels.
    #[error("given zones: {found} ids, expected {expected} (one per voxel of plot.modules)")]
    Zones {
        /// Number of ids.
        found: usize,
        /// Number of voxels.
        expected: usize,
    },
    /// A given cell must be filled, yet lies where nothing may be built.
    #[error("given: cell ({}, {}) of storey {storey} must be filled but lies outside the buildable mask or plot.envelope, or must also stay empty", cell[0], cell[1])]
    Contradiction {
        /// Storey, 0 = ground.
        storey: usize,
        /// Plan cell.
        cell: [usize; 2],
    },
    /// Given cells reach higher than the plot or the programme.
    #[error(
        "given: cells must be filled up to storey {found} (counted from 1), but plot and programme allow {most}: raise plot.modules[2] or programme.storeys"
    )]
    GivenTooHigh {
        /// Storeys needed.
        found: usize,
        /// Storeys possible.
        most: usize,
    },
    /// A range of the programme is empty or not a number.
    #[error("programme.{0}: empty or not a number: the first value must not exceed the second")]
    Range(&'static str),
}

/// Cells that a brief gives, storey by storey; storeys beyond the lists are free.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Given {
    /// Cells that must be filled, per storey from the ground.
    pub fill: Vec<Cells>,
    /// Cells that must stay empty, per storey. The plate that roofs the storey underneath does not count as filling them.
    pub empty: Vec<Cells>,
    /// Zone id of each voxel of the plot, x fastest, -1 = none; empty when there are no zones.
    pub zones: Vec<i32>,
}

/// The plot in modules.
#[derive(Clone, Debug, PartialEq)]
pub struct Plot {
    /// Modules along x, y and z: also the shape of every encoded array.
    pub modules: [usize; 3],
    /// Plan cells that may be built on.
    pub buildable: Cells,
    /// Given cells, if any.
    pub given: Option<Given>,
    /// Size of a voxel, carried into every house.
    pub module: Module,
    /// Centre of voxel (0, 0, 0) in metres, carried into every house.
    pub origin_m: [f64; 3],
    /// Where windows and doors are likelier drawn.
    pub fields: Fields,
    /// Given labels that every house keeps.
    pub kept: Option<Kept>,
}

impl Plot {
    /// A plot of `modules`, buildable on `mask` or everywhere.
    ///
    /// # Errors
    /// When the plot is too wide or too small, or the mask has another size.
    pub fn new(modules: [usize; 3], mask: Option<&Plan>) -> Result<Plot, PlotError> {
        let [nx, ny, nz] = modules;
        if nx > WIDEST {
            return Err(PlotError::TooWide(nx));
        }
        if nx < 4 || ny < 4 || nz <= STOREY_MODULES {
            return Err(PlotError::TooSmall(nx, ny, nz));
        }
        let buildable = match mask {
            None => Cells::full([nx, ny]),
            Some(plan) => same_size("plot.mask", Cells::from_plan(plan), plan.size(), [nx, ny])?,
        };
        Ok(Plot {
            modules,
            buildable,
            given: None,
            module: Module::default(),
            origin_m: [0.0; 3],
            fields: Fields::default(),
            kept: None,
        })
    }

    /// The same plot with given cells: plans per storey that must be filled and that must stay empty, and zone ids.
    ///
    /// # Errors
    /// When sizes differ, a cell is given twice in opposite senses, or given cells reach out of the plot.
    pub fn with_given(mut self, fill: &[Plan], empty: &[Plan], zones: Vec<i32>) -> Result<Plot, PlotError> {
        let size = self.size();
        let read = |what, plans: &[Plan]| -> Result<Vec<Cells>, PlotError> {
            plans.iter().map(|p| same_size(what, Cells::from_plan(p), p.size(), size)).collect()
        };
        let mut given = Given { fill: read("given fill", fill)?, empty: read("given empty", empty)?, zones };
        let voxels = self.modules.iter().product();
        if !given.zones.is_empty() && given.zones.len() != voxels {
            return Err(PlotError::Zones { found: given.zones.len(), expected: voxels });
        }
        while given.fill.last().is_some_and(Cells::is_empty) {
            given.fill.pop();
        }
        if given.fill.len() > self.most_storeys() {
            return Err(PlotError::GivenTooHigh { found: given.fill.len(), most: self.most_storeys() });
        }
        for (storey, fill) in given.fill.iter().enumerate() {
            let mut allowed = self.buildable.clone();
            if let Some(empty) = given.empty.get(storey) {
                allowed = allowed.minus(empty);
            }
            if let Some(cell) = fill.minus(&allowed).iter().next() {
                return Err(PlotError::Contradiction { storey, cell });
            }
        }
        self.given = Some(given);
        Ok(self)
    }

    /// The same plot without the voxels that `barred` names (one for each of the plot's, x fastest), as those outside an envelope: a storey
    /// takes a plan cell only if none of its layers above the ground nor the plate over it is barred.
    ///
    /// # Errors
    /// When a given cell must be filled that is barred, or there is not one answer for each voxel.
    pub fn with_barred(self, barred: &[bool]) -> Result<Plot, PlotError> {
        let [nx, ny, nz] = self.modules;
        if barred.len() != nx * ny * nz {
            return Err(PlotError::Zones { found: barred.len(), expected: nx * ny * nz });
        }
        let given = self.given.clone().unwrap_or_default();
        let empty: Vec<Plan> = (0..=self.most_storeys().max(given.empty.len()))
            .map(|s| {
                let mut plan = given.empty.get(s).map_or_else(|| Plan::new([nx, ny]), Cells::to_plan);
                let layers = (s * STOREY_MODULES).max(1)..((s + 1) * STOREY_MODULES + 1).min(nz);
                for at in layers.flat_map(|k| (0..nx * ny).filter(move |at| barred[k * nx * ny + at])) {
                    plan.set([at % nx, at / nx], true);
                }
                plan
            })
            .collect();
        let fill: Vec<Plan> = given.fill.iter().map(Cells::to_plan).collect();
        self.with_given(&fill, &empty, given.zones)
    }

    /// Plan cells along x and y.
    pub fn size(&self) -> [usize; 2] {
        [self.modules[0], self.modules[1]]
    }

    /// Storeys that fit under the top of the plot, with the roof plate.
    pub fn most_storeys(&self) -> usize {
        (self.modules[2] - 1) / STOREY_MODULES
    }

    /// Cells in which storey `storey` may have room.
    pub fn allowed(&self, storey: usize) -> Cells {
        match self.given.as_ref().and_then(|g| g.empty.get(storey)) {
            Some(empty) => self.buildable.minus(empty),
            None => self.buildable.clone(),
        }
    }

    /// Cells that storey `storey` must fill, `None` when it is free.
    pub fn must_fill(&self, storey: usize) -> Option<&Cells> {
        self.given.as_ref().and_then(|g| g.fill.get(storey))
    }

    /// Storeys up to the highest given cell.
    pub fn given_storeys(&self) -> usize {
        self.given.as_ref().map_or(0, |g| g.fill.len())
    }
}

fn same_size(what: &'static str, cells: Cells, found: [usize; 2], expected: [usize; 2]) -> Result<Cells, PlotError> {
    if found == expected { Ok(cells) } else { Err(PlotError::PlanSize { what, found, expected }) }
}

/// What the inhabitants ask for, as far as moves have to respect it.
#[derive(Clone, Debug, PartialEq)]
pub struct Programme {
    /// Least and most net floor area in m2. Starts keep it, moves may leave it by [`Programme::AREA_SLACK`]: the exact
    /// value is a constraint of the score.
    pub floor_area_m2: [f64; 2],
    /// Least and most storeys.
    pub storeys: [usize; 2],
    /// Doors onto the ground, at least.
    pub entrances_min: usize,
    /// Least and most glass area over net floor area in every storey.
    pub glazing: [f64; 2],
    /// Least and most rise of the roof in modules, 0 = flat. A top storey too narrow for the least rise takes the steepest
    /// hip it can carry.
    pub roof_rise: [usize; 2],
}

impl Programme {
    /// Share by which a move may leave the range of the floor area, so that a search can approach a limit from both sides.
    pub const AREA_SLACK: f64 = 0.1;
}

impl Default for Programme {
    /// Any area, one or two storeys, one entrance, glazing 10 to 35 %, any roof.
    fn default() -> Self {
        Programme {
            floor_area_m2: [0.0, f64::MAX],
            storeys: [1, 2],
            entrances_min: 1,
            glazing: [0.10, 0.35],
            roof_rise: [0, 4],
        }
    }
}

/// Number of options of each [`Choice`]; for [`Choice::Joists`] the number of bit patterns (1 = fixed along x).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ChoiceSpace {
    /// Options per choice in the order of [`Choice::ALL`]; 0 counts as 1.
    pub options: [u16; 6],
}

impl Default for ChoiceSpace {
    fn default() -> Self {
        ChoiceSpace { options: [1; 6] }
    }
}

impl ChoiceSpace {
    /// Options of one choice, at least 1.
    pub fn count(&self, choice: Choice) -> u16 {
        self.options[choice as usize].max(1)
    }
}

/// Everything the moves may range over.
#[derive(Clone, Debug, PartialEq)]
pub struct Space {
    /// The plot.
    pub plot: Plot,
    /// The programme.
    pub programme: Programme,
    /// The choices.
    pub choices: ChoiceSpace,
}

impl Space {
    /// Puts plot, programme and choices together.
    ///
    /// # Errors
    /// When a range of the programme is empty, or fewer storeys are possible than needed.
    pub fn new(plot: Plot, programme: Programme, choices: ChoiceSpace) -> Result<Space, PlotError> {
        let ordered = |[low, high]: [f64; 2]| low <= high;
        if !ordered(programme.floor_area_m2) {
            return Err(PlotError::Range("floor_area_m2"));
        }
        if !ordered(programme.glazing) {
            return Err(PlotError::Range("glazing"));
        }
        if programme.storeys[0] > programme.storeys[1] || programme.storeys[1] == 0 {
            return Err(PlotError::Range("storeys"));
        }
        let space = Space { plot, programme, choices };
        let (needed, most) = (space.plot.given_storeys().max(space.programme.storeys[0]), space.most_storeys());
        if needed > most {
            return Err(PlotError::GivenTooHigh { found: needed, most });
        }
        Ok(space)
    }

    /// Storeys a house may have.
    pub fn most_storeys(&self) -> usize {
        let kept = self.plot.kept.as_ref().map_or(usize::MAX, Kept::most_storeys);
        self.programme.storeys[1].min(self.plot.most_storeys()).min(kept)
    }

    /// Storeys a house must have.
    pub fn least_storeys(&self) -> usize {
        self.programme.storeys[0].max(self.plot.given_storeys()).max(1)
    }
}
