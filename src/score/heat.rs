//! Transmission heat loss by element, and openings by the direction they face.

use serde::Serialize;

use super::{Details, Evaluator};
use crate::envelope::{EnvelopeSurvey, KeyCache};
use crate::price::RateTable;
use crate::quantities::{Item, Takeoff};
use crate::voxels::{Direction, House};

/// An element of the envelope.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct HeatElement {
    /// Item of the take-off whose build-up it has.
    pub item: String,
    /// m2.
    pub area_m2: f64,
    /// U in W/m2K.
    pub u_w_m2k: f64,
    /// U A in W/K.
    pub w_per_k: f64,
}

/// The openings of one direction.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct FacingOpenings {
    /// `north` (+y), `east` (+x), `south` or `west`.
    pub facing: &'static str,
    /// Windows, m2 of opening in the facade.
    pub windows_m2: f64,
    /// Doors, m2.
    pub doors_m2: f64,
    /// Sum of U A in W/K.
    pub w_per_k: f64,
}

/// Transmission heat loss of a house: sum of U A, the ground without the resistance of the soil, no thermal bridges of junctions.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct HeatLoss {
    /// Elements that the house has, in the order of the surfaces.
    pub elements: Vec<HeatElement>,
    /// Openings by direction: north, east, south, west.
    pub openings: Vec<FacingOpenings>,
    /// Envelope in m2.
    pub area_m2: f64,
    /// The whole in W/K.
    pub w_per_k: f64,
    /// Mean U in W/m2K.
    pub mean_u_w_m2k: f64,
}

/// Compass order; the index is that of [`Direction::ALL`].
const COMPASS: [(&str, Direction); 4] =
    [("north", Direction::North), ("east", Direction::East), ("south", Direction::South), ("west", Direction::West)];

/// Name of a direction on the compass.
pub(super) fn compass(direction: Direction) -> &'static str {
    COMPASS.iter().find(|(_, d)| *d == direction).map_or("", |(name, _)| name)
}

impl HeatLoss {
    /// The loss of a take-off whose openings `survey` has measured.
    pub fn new(takeoff: &Takeoff, rates: &RateTable, survey: &EnvelopeSurvey) -> HeatLoss {
        let u = |item: Item| rates.rows[item as usize].u_w_m2k;
        let element = |(item, area_m2): (Item, f64)| {
            let u_w_m2k = u(item);
            HeatElement { item: item.id().to_owned(), area_m2, u_w_m2k, w_per_k: u_w_m2k * area_m2 }
        };
        let elements: Vec<HeatElement> = takeoff.surfaces().filter(|(_, m2)| *m2 > 0.0).map(element).collect();
        let facing = |(facing, direction): (&'static str, Direction)| {
            let [windows_m2, doors_m2] = [survey.windows_m2, survey.doors_m2].map(|areas| areas[direction as usize]);
            FacingOpenings {
                facing,
                windows_m2,
                doors_m2,
                w_per_k: windows_m2 * u(Item::Window) + doors_m2 * u(Item::Door),
            }
        };
        let (area_m2, w_per_k) = elements.iter().fold((0.0, 0.0), |(m2, sum), e| (m2 + e.area_m2, sum + e.w_per_k));
        HeatLoss {
            openings: COMPASS.map(facing).into(),
            area_m2,
            w_per_k,
            mean_u_w_m2k: if area_m2 > 0.0 { w_per_k / area_m2 } else { 0.0 },
            elements,
        }
    }
}

impl Evaluator {
    /// The heat loss of a house with its details; `None` where nothing was taken off.
    pub fn heat_loss(&self, house: &House, details: &Details) -> Option<HeatLoss> {
        let takeoff = details.evaluation.takeoff.as_ref()?;
        let survey = self.tiling.survey(house, &details.reading, &mut KeyCache::default()).ok()?;
        Some(HeatLoss::new(takeoff, &self.rates, &survey))
    }
}
