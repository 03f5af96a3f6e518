//! From a house to its frame.

use thiserror::Error;

use super::grid::{Grid, STOREY, X, Y};
use super::plateaus::Plateaus;
use super::roof::{LevelLine, RoofCube};
use super::sticks::{self, Stick};
use super::types::{HouseFrame, Role, STOCK_LENGTH_M};
use crate::tiles::Line;
use crate::voxels::{Boards, Choices, House, Reading};

/// Buffers of [`build`], to be kept between houses.
#[derive(Clone, Debug, Default)]
pub struct FrameWorkspace {
    /// What is asked of the frame.
    pub options: FrameOptions,
    grid: Grid,
    sticks: Vec<Stick>,
    roofs: Vec<RoofCube>,
    levels: Vec<LevelLine>,
    plateaus: Plateaus,
    /// Height of the highest plate in half layers.
    top: i32,
}

/// What can be asked of a frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FrameOptions {
    /// Which sides of the walls carry racking boards.
    pub boards: Boards,
    /// Longest stick in one piece, m; a longer one is spliced over a support.
    pub stock_m: f64,
    /// Longest clear joist without a bearing line, m. Whole half modules of it count.
    pub bay_m: f64,
    /// Largest distance of posts under a beam, m. Whole half modules of it count.
    pub post_distance_m: f64,
}

impl Default for FrameOptions {
    /// Boards on one side, stock of [`STOCK_LENGTH_M`], bays of 5.4 m and posts at 3.6 m: six and four modules of 0.9 m.
    fn default() -> Self {
        FrameOptions { boards: Boards::OneSide, stock_m: STOCK_LENGTH_M, bay_m: 5.4, post_distance_m: 3.6 }
    }
}

/// Why no frame can be made.
#[derive(Debug, Error, PartialEq, Eq)]
pub enum FrameError {
    /// Nothing stands on a foundation.
    #[error("the house has no wall on its foundation layer (k = 0): label the ground layer 3 and build on it")]
    NoWalls,
}

/// The frame of a house from its linear tiles.
///
/// `lines(mask)` are the lines of a cube's configuration (`LinearTileset::lines`). Read the module's page for the joints.
///
/// # Errors
/// [`FrameError::NoWalls`] when no stud starts on the foundation.
pub fn build<'t>(
    house: &House,
    reading: &Reading,
    choices: &Choices,
    lines: impl Fn(u8) -> &'t [Line],
    workspace: &mut FrameWorkspace,
) -> Result<HouseFrame, FrameError> {
    let mut frame = build_members(house, reading, choices, lines, workspace)?;
    complete(house, workspace, &mut frame);
    Ok(frame)
}

/// The first half of [`build`]: nodes, members, supports and levels, which are all that masses, prices and joints ask for.
///
/// # Errors
/// As [`build`].
pub fn build_members<'t>(
    house: &House,
    reading: &Reading,
    choices: &Choices,
    lines: impl Fn(u8) -> &'t [Line],
    workspace: &mut FrameWorkspace,
) -> Result<HouseFrame, FrameError> {
    let FrameWorkspace { options, grid, sticks, roofs, levels, plateaus, top } = workspace;
    let v = &house.voxels;
    grid.reset(v.shape());
    super::place::place(grid, v, &lines, |plate| choices.joists_along_y(plate), roofs);
    super::roof::place(grid, v, roofs, levels, plateaus);
    super::place::walls_on_floors(grid, v);
    for opening in &reading.openings {
        super::openings::frame_opening(grid, opening);
    }
    *top = STOREY * (reading.plates.len() as i32 - 1).max(0);
    for plate in 1..=*top / STOREY {
        let joists = if choices.joists_along_y(plate as usize - 1) { Y } else { X };
        super::floors::complete(grid, house, plate * STOREY, joists, options);
    }
    sticks::collect(grid, sticks);
    super::splice::splice(grid, sticks, v.module.size_m, options.stock_m);
    sticks::drop_hanging(grid, sticks);
    let mut frame = HouseFrame { boards: options.boards, ..HouseFrame::default() };
    sticks::number_nodes(grid, v, &mut frame);
    if frame.supports.is_empty() {
        return Err(FrameError::NoWalls);
    }
    sticks::make_members(grid, sticks, v, &mut frame);
    super::supports::fill(grid, sticks, 0.5 * v.module.size_m[2], &mut frame);
    measure(sticks, v.module.size_m, &mut frame);
    Ok(frame)
}

/// The second half of [`build`], what an analysis asks for besides: sheathing, areas carried and clear lengths. `workspace` is as
/// [`build_members`] has left it for this house.
pub fn complete(house: &House, workspace: &mut FrameWorkspace, frame: &mut HouseFrame) {
    let FrameWorkspace { grid, sticks, roofs, top, .. } = workspace;
    let v = &house.voxels;
    let levels: Vec<i32> = frame.levels.iter().map(|l| (2.0 * l.z_m / v.module.size_m[2]).round() as i32).collect();
    super::panels::fill(grid, v, sticks, &levels, frame);
    super::areas::fill(grid, house, roofs, *top, frame);
    super::spans::fill(frame);
}

/// Outer size and pitch.
fn measure(sticks: &[Stick], module_m: [f64; 3], frame: &mut HouseFrame) {
    let fold = |axis: usize| {
        let (low, high) =
            frame.nodes.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), n| (a.min(n[axis]), b.max(n[axis])));
        high - low
    };
    frame.size_m = [fold(0), fold(1), fold(2)];
    frame.module_m = module_m;
    if sticks.iter().any(|s| s.role == Role::Rafter && s.is_sloped()) {
        frame.pitch_deg = (module_m[2] / module_m[0]).atan().to_degrees();
    }
}
