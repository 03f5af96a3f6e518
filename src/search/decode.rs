//! Reading a genome back from voxels: the inverse of [`encode`], so that a house can be a parent wherever it comes from.

use super::cells::Cells;
use super::dress::layer;
use super::massing::{Infill, Massing, Opening, Roof, StoreyMass, along, encode};
use super::openings::exposed;
use super::plot::Plot;
use crate::voxels::{Direction, House, Label, STOREY_MODULES, VoxelArray};

/// The massing whose encoding on `plot` is exactly this house, labels and stairs alike (zones are not looked at); `None` for a
/// house that no massing stands for, such as one with a saddle roof or a hole in a wall.
///
/// ```
/// use houscaper::search::{decode::decode, massing::encode, plot::{ChoiceSpace, Plot, Programme, Space}, start::start};
/// use rand::SeedableRng;
/// let plot = Plot::new([10, 8, 17], None)?;
/// let space = Space::new(plot, Programme::default(), ChoiceSpace::default())?;
/// let design = start(&space, &mut rand_chacha::ChaCha8Rng::seed_from_u64(1)).expect("the plot is large enough");
/// assert_eq!(decode(&encode(&design.massing, &space.plot), &space.plot), Some(design.massing));
/// # Ok::<(), houscaper::search::plot::PlotError>(())
/// ```
pub fn decode(house: &House, plot: &Plot) -> Option<Massing> {
    if house.voxels.shape() != plot.modules {
        return None;
    }
    let massing = guess(house);
    let again = encode(&massing, plot);
    (again.voxels.labels() == house.voxels.labels() && again.stairs == house.stairs).then_some(massing)
}

/// The massing that a house would have if it were one of the search's.
fn guess(house: &House) -> Massing {
    let [nx, ny, nz] = house.voxels.shape();
    let plan = |k: usize| if k < nz { layer(&house.voxels, k) } else { Cells::new([nx, ny]) };
    // No roof reaches the layer under the next plate, every storey does.
    let count = (0..).take_while(|s| !plan(s * STOREY_MODULES + STOREY_MODULES - 1).is_empty()).count();
    let top = count * STOREY_MODULES;
    let rise = (1..=Roof::STEEPEST as usize).take_while(|i| !plan(top + i).is_empty()).count();
    let storey = |s: usize| {
        let footprint = plan(s * STOREY_MODULES + 1);
        let openings = openings(&house.voxels, &footprint, s);
        StoreyMass { footprint, openings, stair: house.stairs.iter().copied().find(|stair| stair.storey == s) }
    };
    Massing { storeys: (0..count).map(storey).collect(), roof: Roof::of_rise(rise) }
}

/// Doors and windows that stand in the facades of a storey with this footprint, in their order. Infill elsewhere is left out;
/// what is wider or higher than an opening can be is cut.
pub fn openings(voxels: &VoxelArray, footprint: &Cells, s: usize) -> Vec<Opening> {
    let mut out: Vec<Opening> = Vec::new();
    for facing in Direction::ALL {
        let facade = exposed(footprint, facing);
        let step = along(facing);
        for [x, y] in facade.iter() {
            let cell = [x as isize, y as isize];
            let Some((infill, sill)) = infill(voxels, cell, s) else { continue };
            let most = if infill == Infill::Window { Opening::WIDEST } else { 1 };
            // Cells come row by row, so an opening along y is met again after those beside it.
            let grown = out.iter_mut().find(|o| {
                let next = [o.cell[0] + step[0] * o.width as isize, o.cell[1] + step[1] * o.width as isize];
                o.facing == facing && o.infill == infill && o.sill == sill && o.width < most && next == cell
            });
            match grown {
                Some(opening) => opening.width += 1,
                None => out.push(Opening { infill, facing, cell, width: 1, sill }),
            }
        }
    }
    out.sort_unstable();
    out
}

/// What fills the facade at a cell of a storey, and how many layers above the plate it begins (1 or 2).
fn infill(voxels: &VoxelArray, [x, y]: [isize; 2], s: usize) -> Option<(Infill, usize)> {
    let at = |i: usize| voxels.at([x, y, (s * STOREY_MODULES + i) as isize]);
    let (sill, label) = (1..STOREY_MODULES - 1).map(|i| (i, at(i))).find(|(_, label)| label.is_infill())?;
    let infill = if label == Label::Window { Infill::Window } else { Infill::Door };
    Some((infill, sill.min(2)))
}
