//! Reads a house as a building: plates, storeys with their clear heights and areas, openings.

use super::openings::read_openings;
use super::{House, Label, Module, Plan, Plate, Reading, STOREY_MODULES, Stair, Storey, VoxelArray};

/// Thickness of the wall lining inwards from the voxel face, m.
pub const LINING_M: f64 = 0.300;
/// Slab zone below a slab's top, which is its voxel's centre plane, m. A deeper joist deepens it in the frame's own check.
pub const SLAB_ZONE_M: f64 = 0.180;
/// Vertical build-up of the roof below the voxel face, m.
pub const ROOF_ZONE_M: f64 = 0.291;
/// Least clear height that makes a storey out of a space, m.
pub const STANDING_HEIGHT_M: f64 = 2.4;
/// Least headroom under a flight that still counts as floor, m.
pub const FLOOR_HEADROOM_M: f64 = 1.5;

/// What stands on a plate in one plan cell: the filled layers up to the next slab or the roof.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Room {
    /// Filled layers between the plate and what closes the room.
    pub layers: usize,
    /// Closed by a slab rather than by the roof.
    pub under_slab: bool,
}

impl Room {
    /// Height between inner surfaces, m; 0 where nothing stands on the plate.
    pub fn clear_height_m(self, module: &Module) -> f64 {
        let dz = module.size_m[2];
        match (self.under_slab, self.layers) {
            (_, 0) => 0.0,
            (true, n) => (n + 1) as f64 * dz - SLAB_ZONE_M,
            (false, n) => (n as f64 + 0.5) * dz - ROOF_ZONE_M,
        }
    }
}

/// The room over the plate in layer `k` at a plan cell.
pub(super) fn room_over(voxels: &VoxelArray, [x, y]: [usize; 2], k: usize) -> Room {
    let [nx, ny, nz] = voxels.shape();
    let column = &voxels.labels()[x + nx * y..];
    let mut layers = 0;
    for z in k + 1..nz {
        match column[nx * ny * z] {
            Label::Empty => break,
            label if label.is_slab() => return Room { layers, under_slab: true },
            _ => layers += 1,
        }
    }
    Room { layers, under_slab: false }
}

/// Reads plates, storeys and openings from a house.
///
/// A plate is any layer k = 0, 6, 12 ... with a filled voxel. A storey stands on a plate where a slab cell has at least
/// 2.4 m between inner surfaces; a roof space lower than that is none. Its plan holds the cells of that height, stair
/// voids of its own plate included. Clear height: slab to slab 6 x 0.54 - 0.18 = 3.06 m, under a roof of n layers
/// (n + 0.5) x 0.54 - 0.291 m. Net floor area: see [`net_floor_area_m2`].
///
/// ```
/// use houscaper::voxels::{read_storeys, samples};
/// let reading = read_storeys(&samples::box_house());
/// assert_eq!(reading.storeys.len(), 1);
/// assert!((reading.storeys[0].clear_height_m - 3.06).abs() < 1e-12);
/// assert!((reading.storeys[0].floor_area_m2 - 5.7 * 4.8).abs() < 1e-9); // 7 x 6 modules less 300 mm all round
/// ```
pub fn read_storeys(house: &House) -> Reading {
    let voxels = &house.voxels;
    let plates: Vec<Plate> =
        (0..voxels.shape()[2]).step_by(STOREY_MODULES).filter_map(|k| read_plate(voxels, k)).collect();
    let mut storeys: Vec<Storey> = Vec::with_capacity(plates.len());
    for (p, plate) in plates.iter().enumerate() {
        if let Some(storey) = read_storey(house, plate, plates.get(p + 1), storeys.len()) {
            storeys.push(storey);
        }
    }
    let openings = read_openings(voxels, &storeys);
    Reading { plates, storeys, openings }
}

fn read_plate(voxels: &VoxelArray, k: usize) -> Option<Plate> {
    let [nx, ny, _] = voxels.shape();
    let layer = &voxels.labels()[nx * ny * k..nx * ny * (k + 1)];
    if layer.iter().all(|l| !l.is_filled()) {
        return None;
    }
    let plan = |keep: fn(Label) -> bool| Plan::from_cells([nx, ny], layer.iter().map(|&l| keep(l)).collect());
    Some(Plate {
        k,
        cells: plan(Label::is_filled),
        slab: plan(Label::is_slab),
        void: plan(|l| l.is_filled() && !l.is_slab()),
    })
}

fn read_storey(house: &House, plate: &Plate, above: Option<&Plate>, index: usize) -> Option<Storey> {
    let module = &house.voxels.module;
    let mut plan = Plan::new(plate.cells.size());
    let mut lowest = f64::INFINITY;
    let mut lowest_anywhere = f64::INFINITY;
    let mut on_slab = false;
    let next = above.filter(|a| a.k == plate.k + STOREY_MODULES);
    for cell in plate.cells.iter() {
        let height = room_over(&house.voxels, cell, plate.k).clear_height_m(module);
        if height < STANDING_HEIGHT_M {
            continue;
        }
        plan.set(cell, true);
        let at = cell.map(|c| c as isize);
        on_slab |= plate.slab.has(at);
        lowest_anywhere = lowest_anywhere.min(height);
        if !next.is_some_and(|a| a.void.has(at)) {
            lowest = lowest.min(height);
        }
    }
    if !on_slab {
        return None;
    }
    let gross_area_m2 = plan.count() as f64 * module.size_m[0] * module.size_m[1];
    let floor_area_m2 = net_floor_area_m2(&plan, &plate.void, &house.stairs, index, module);
    let clear_height_m = if lowest.is_finite() { lowest } else { lowest_anywhere };
    Some(Storey { index, plate_k: plate.k, plan, clear_height_m, gross_area_m2, floor_area_m2 })
}

/// Net floor area of a storey, m2: its plan inside the 300 mm lining, without the cells of `void` (stair openings in its
/// own plate) and without the cells under a flight starting here where the headroom falls below 1.5 m.
///
/// Without voids and stairs this is A - 0.3 P + 0.09 (convex - concave corners) for every rectilinear plan.
pub fn net_floor_area_m2(plan: &Plan, void: &Plan, stairs: &[Stair], storey: usize, module: &Module) -> f64 {
    let has_void = !void.is_empty();
    let mut area = 0.0;
    for cell in plan.iter() {
        let at = cell.map(|c| c as isize);
        if !(has_void && void.has(at)) {
            area += cell_net_m2(plan, at, module);
        }
    }
    for stair in stairs.iter().filter(|s| s.storey == storey) {
        for (n, at) in stair.flight_cells().into_iter().enumerate() {
            let low = n as f64 * module.size_m[2] < FLOOR_HEADROOM_M;
            if low && plan.has(at) && !void.has(at) {
                area -= cell_net_m2(plan, at, module);
            }
        }
    }
    area
}

/// The part of one plan cell inside the lining, m2.
fn cell_net_m2(plan: &Plan, [x, y]: [isize; 2], module: &Module) -> f64 {
    let out = |dx: isize, dy: isize| !plan.has([x + dx, y + dy]);
    let (w, e, s, n) = (out(-1, 0), out(1, 0), out(0, -1), out(0, 1));
    let side = |a: bool, b: bool, size: f64| (size - LINING_M * (a as u8 + b as u8) as f64).max(0.0);
    let area = side(w, e, module.size_m[0]) * side(s, n, module.size_m[1]);
    let concave = [(w, s, -1, -1), (e, s, 1, -1), (w, n, -1, 1), (e, n, 1, 1)]
        .into_iter()
        .filter(|&(a, b, dx, dy)| !a && !b && out(dx, dy))
        .count();
    (area - concave as f64 * LINING_M * LINING_M).max(0.0)
}
