//! What the programme asks, measured on a house.

use crate::brief::Programme;
use crate::voxels::rules::glass_in_view_m2;
use crate::voxels::{House, Label, Module, Plan, Reading, STOREY_MODULES};

/// Shortfalls against the programme, each relative to what was asked; all zero when it is met.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Shortfall {
    /// Net floor area below the least or above the most.
    pub floor_area: f64,
    /// Storeys too few or too many.
    pub storeys: f64,
    /// Clear height too low.
    pub clear_height: f64,
    /// Glazing ratio of the poorest storey too low.
    pub glazing: f64,
    /// Entrances too few.
    pub entrances: f64,
    /// Roof lower or higher than asked.
    pub roof: f64,
    /// Zones smaller or larger than asked, summed.
    pub zones: f64,
}

impl Shortfall {
    /// Names in the order of [`Shortfall::values`], for reports.
    pub const NAMES: [&'static str; 7] = [
        "programme.floor_area_m2",
        "programme.storeys",
        "programme.clear_height_m",
        "programme.glazing_ratio_min",
        "programme.entrances_min",
        "programme.roof_rise",
        "programme.zones",
    ];

    /// All shortfalls.
    pub fn values(&self) -> [f64; 7] {
        [self.floor_area, self.storeys, self.clear_height, self.glazing, self.entrances, self.roof, self.zones]
    }

    /// Their sum.
    pub fn total(&self) -> f64 {
        self.values().iter().sum()
    }
}

/// Net floor area of all storeys, m2.
pub fn floor_area_m2(reading: &Reading) -> f64 {
    reading.storeys.iter().map(|s| s.floor_area_m2).sum()
}

/// Smallest glass area over net floor area of a storey; 0 when a storey has no floor or there is none. Glass counts with
/// `view_m` of free view outside, as in the rules.
pub fn glazing_ratio(house: &House, reading: &Reading, view_m: f64) -> f64 {
    let ratio = |storey: usize, floor: f64| {
        let glass: f64 = reading
            .openings
            .iter()
            .filter(|o| o.storey == storey && o.label == Label::Window)
            .map(|o| glass_in_view_m2(&house.voxels, o, view_m))
            .sum();
        if floor > 0.0 { glass / floor } else { 0.0 }
    };
    let least = reading.storeys.iter().map(|s| ratio(s.index, s.floor_area_m2)).fold(f64::INFINITY, f64::min);
    if least.is_finite() { least } else { 0.0 }
}

/// Doors of the ground storey.
pub fn entrances(reading: &Reading) -> usize {
    reading.openings.iter().filter(|o| o.storey == 0 && o.label == Label::Opening).count()
}

/// Windows by orientation, m2 of opening, in the order of [`crate::voxels::Direction::ALL`].
pub fn window_area_by_direction(reading: &Reading, module: &Module) -> [f64; 4] {
    let mut area = [0.0; 4];
    for o in reading.openings.iter().filter(|o| o.label == Label::Window) {
        area[o.facing as usize] += o.width as f64 * module.size_m[o.along()] * o.height as f64 * module.size_m[2];
    }
    area
}

fn below(value: f64, least: f64) -> f64 {
    if value >= least || least <= 0.0 { 0.0 } else { (least - value) / least }
}

/// Measures a house against the programme. `clear_height_m` is the smallest clear height under the slab zone of the chosen joists,
/// `glazing_ratio` that of [`glazing_ratio`].
pub fn shortfall(
    programme: &Programme,
    house: &House,
    reading: &Reading,
    clear_height_m: f64,
    glazing_ratio: f64,
) -> Shortfall {
    let area = floor_area_m2(reading);
    let [least, most] = programme.floor_area_m2;
    let [low, high] = programme.storeys.map(|s| s as f64);
    let storeys = reading.storeys.len() as f64;
    Shortfall {
        floor_area: below(area, least) + if area > most { (area - most) / most.max(1.0) } else { 0.0 },
        storeys: (low - storeys).max(storeys - high).max(0.0),
        clear_height: below(clear_height_m, programme.clear_height_m),
        glazing: below(glazing_ratio, programme.glazing_ratio_min),
        entrances: (programme.entrances_min as f64 - entrances(reading) as f64).max(0.0),
        roof: roof_shortfall(programme.roof_rise, house, reading),
        zones: programme.zones.iter().map(|z| out_of(z.area_m2, zone_area_m2(house, z.zone))).sum(),
    }
}

/// Gross plan area of a zone over all storeys, m2: its filled cells in the first room layer of each, walls included.
pub fn zone_area_m2(house: &House, zone: i32) -> f64 {
    let [nx, ny, _] = house.voxels.shape();
    let layer = nx * ny;
    let rooms = house.zones.chunks(layer.max(1)).skip(1).step_by(STOREY_MODULES);
    let cells = rooms.flatten().filter(|z| **z == zone).count();
    cells as f64 * house.voxels.module.size_m[0] * house.voxels.module.size_m[1]
}

/// How far an area lies below or above a range, relative to the nearer end.
pub fn out_of([least, most]: [f64; 2], area: f64) -> f64 {
    below(area, least) + if area > most { (area - most) / most.max(1.0) } else { 0.0 }
}

/// Modules by which the roof over the highest plate is lower or higher than asked. A plan too narrow for the least rise need only
/// carry the steepest hip it can.
fn roof_shortfall([least, most]: [usize; 2], house: &House, reading: &Reading) -> f64 {
    let Some(plate) = reading.plates.last() else { return least as f64 };
    let rise = roof_rise(house, plate.k);
    let least = least.min(steepest_hip(&plate.cells, least));
    (least as f64 - rise as f64).max(rise as f64 - most as f64).max(0.0)
}

/// Layers of roof over the plate in layer `k`.
pub(super) fn roof_rise(house: &House, k: usize) -> usize {
    let [nx, ny, nz] = house.voxels.shape();
    let layer_filled = |k: usize| (0..ny).any(|y| (0..nx).any(|x| house.voxels.get([x, y, k]).is_filled()));
    (k + 1..nz).take_while(|&k| layer_filled(k)).count()
}

/// Steps of one module that a stepped pyramid over a plan can have, counted up to `enough`.
fn steepest_hip(plan: &Plan, enough: usize) -> usize {
    let mut layer = plan.clone();
    let mut steps = 0;
    while steps < enough && !layer.is_empty() && !touches_diagonally(&layer) {
        steps += 1;
        let mut inner = Plan::new(layer.size());
        for cell in layer.iter() {
            let [x, y] = cell.map(|c| c as isize);
            let around = (-1..=1).flat_map(|dy| (-1..=1).map(move |dx| [x + dx, y + dy]));
            inner.set(cell, around.into_iter().all(|c| layer.has(c)));
        }
        layer = inner;
    }
    steps
}

/// Whether two cells meet at a corner only, so that the cube there has no tile.
fn touches_diagonally(plan: &Plan) -> bool {
    plan.iter().any(|cell| {
        let [x, y] = cell.map(|c| c as isize);
        [-1, 1].into_iter().any(|dx| plan.has([x + dx, y + 1]) && !plan.has([x + dx, y]) && !plan.has([x, y + 1]))
    })
}
