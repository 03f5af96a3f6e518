//! Fields over the plot that say where windows and doors are wanted: sun and entrance access, as GO-Design lattices have them.
//!
//! A place is drawn with a probability in proportion to its field plus [`FLOOR`], so that no place is lost; without a field all places of a
//! facade are alike, as ever. Fields steer starts and moves only: they forbid nothing and no score knows them.

use rand::{Rng, RngExt};

use super::massing::{Infill, Opening};
use super::moves::pick;
use crate::voxels::{Given, STOREY_MODULES};

/// What a place without any sun or access still weighs, where the best place of the lattice weighs 1 more.
pub const FLOOR: f64 = 0.05;

/// Room layer of a storey whose value stands for it.
const LAYER: usize = 3;

/// One value from 0 to 1 for each plan cell of each storey.
#[derive(Clone, Debug, PartialEq)]
pub struct Field {
    size: [usize; 2],
    /// Storey by storey, x fastest.
    values: Vec<f64>,
}

impl Field {
    /// From a value for each module of a given lattice ([`crate::voxels::field`]).
    pub fn new(given: &Given, values: &[f64]) -> Field {
        let [nx, ny, nz] = given.shape;
        let storeys = nz.div_ceil(STOREY_MODULES);
        let layer = |s: usize| (s * STOREY_MODULES + LAYER).min(nz.saturating_sub(1)) * nx * ny;
        let values = (0..storeys).flat_map(|s| values.iter().skip(layer(s)).take(nx * ny).copied()).collect();
        Field { size: [nx, ny], values }
    }

    /// The value of a plan cell of a storey; 0 where the lattice does not reach.
    pub fn at(&self, storey: usize, [x, y]: [isize; 2]) -> f64 {
        let [nx, ny] = self.size;
        match (usize::try_from(x), usize::try_from(y)) {
            (Ok(x), Ok(y)) if x < nx && y < ny => {
                self.values.get(x + nx * (y + ny * storey)).copied().unwrap_or_default()
            }
            _ => 0.0,
        }
    }

    /// Mean over the cells of an opening.
    pub fn mean(&self, storey: usize, opening: &Opening) -> f64 {
        opening.cells().map(|cell| self.at(storey, cell)).sum::<f64>() / opening.width.max(1) as f64
    }
}

/// The fields of a plot.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Fields {
    /// For windows.
    pub sun: Option<Field>,
    /// For doors.
    pub entrances: Option<Field>,
}

impl Fields {
    /// The field that an infill follows.
    pub fn of(&self, infill: Infill) -> Option<&Field> {
        match infill {
            Infill::Window => self.sun.as_ref(),
            Infill::Door => self.entrances.as_ref(),
        }
    }
}

/// One of some places, by its field where there is one, else each as likely.
pub fn draw(places: &[Opening], field: Option<&Field>, storey: usize, rng: &mut impl Rng) -> Option<Opening> {
    let Some(field) = field else { return pick(places, rng) };
    let weights: Vec<f64> = places.iter().map(|place| FLOOR + field.mean(storey, place)).collect();
    let mut at = weights.iter().sum::<f64>() * rng.random::<f64>();
    let drawn = weights.iter().position(|weight| {
        at -= weight;
        at < 0.0
    });
    // Rounding may leave a trace after the last one.
    drawn.or(places.len().checked_sub(1)).map(|n| places[n])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::voxels::{CellMap, Direction, ScaleReport};
    use rand::SeedableRng;

    fn given() -> Given {
        let report = ScaleReport {
            cell_modules: [1; 3],
            default_cell_modules: [1; 3],
            error_m: [0.0; 3],
            scale: [1.0; 3],
            cells: 0,
        };
        let map = CellMap { first: [0; 3], past: [4, 2, 12], size: [1; 3], offset: [0; 3] };
        Given { map, shape: [4, 2, 12], mask: vec![-1; 96], report }
    }

    #[test]
    fn places_are_drawn_in_proportion_to_their_field() {
        let values: Vec<f64> = (0..96).map(|at| if at / 8 == 9 { (at % 4) as f64 / 3.0 } else { 0.0 }).collect();
        let field = Field::new(&given(), &values);
        assert_eq!(
            [field.at(1, [3, 1]), field.at(0, [3, 1]), field.at(1, [4, 0]), field.at(1, [-1, 0])],
            [1.0, 0.0, 0.0, 0.0]
        );
        let places: Vec<Opening> = (0..4).map(|x| Opening::window(Direction::South, [x, 0], 1, 2)).collect();
        let mut rng = rand_chacha::ChaCha8Rng::seed_from_u64(7);
        let mut counts = [0_u32; 4];
        const DRAWS: u32 = 40_000;
        for _ in 0..DRAWS {
            let place = draw(&places, Some(&field), 1, &mut rng).expect("a place");
            counts[place.cell[0] as usize] += 1;
        }
        let total = 4.0 * FLOOR + 2.0;
        for (n, count) in counts.iter().enumerate() {
            let share = (FLOOR + n as f64 / 3.0) / total;
            // Five standard deviations of a binomial: by chance once in 1.7 million.
            let spread = 5.0 * (share * (1.0 - share) / f64::from(DRAWS)).sqrt();
            assert!((f64::from(*count) / f64::from(DRAWS) - share).abs() < spread, "{counts:?}");
        }
        assert_eq!(draw(&[], Some(&field), 1, &mut rng), None);
        assert!(draw(&places, None, 1, &mut rng).is_some());
    }
}
