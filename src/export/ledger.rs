//! What stands where: mass, price, carbon and utilisation by cube and by voxel.
//!
//! The take-off knows layers and members. A layer's amounts are shared out by the volume that is drawn of it, a member's by length, so
//! that the parts sum to the lines of the bill for materials; waste and work have no place and are not shared out.

use std::collections::{BTreeMap, BTreeSet};
use std::ops::AddAssign;

use super::ledger_members::{Piece, pieces};
use crate::envelope::{Fabric, PlacedBlock};
use crate::price::PriceError;
use crate::quantities::Item;
use crate::score::{Details, Evaluator, LayerRow, MemberCost};
use crate::tiles::Component;
use crate::voxels::{Choices, House};

/// Mass, price and carbon of something.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Amounts {
    /// kg.
    pub mass_kg: f64,
    /// Materials without waste and work, in the books' currency.
    pub price: f64,
    /// Fossil kgCO2e, A1-A3.
    pub gwp_kgco2e: f64,
}

impl Amounts {
    /// This many times it.
    pub fn times(self, factor: f64) -> Amounts {
        let Amounts { mass_kg, price, gwp_kgco2e } = self;
        Amounts { mass_kg: mass_kg * factor, price: price * factor, gwp_kgco2e: gwp_kgco2e * factor }
    }
}

impl AddAssign for Amounts {
    fn add_assign(&mut self, other: Amounts) {
        self.mass_kg += other.mass_kg;
        self.price += other.price;
        self.gwp_kgco2e += other.gwp_kgco2e;
    }
}

impl std::iter::Sum for Amounts {
    fn sum<I: Iterator<Item = Amounts>>(all: I) -> Amounts {
        all.fold(Amounts::default(), |mut sum, a| {
            sum += a;
            sum
        })
    }
}

impl From<&LayerRow> for Amounts {
    fn from(row: &LayerRow) -> Amounts {
        Amounts { mass_kg: row.takeoff_kg, price: row.price, gwp_kgco2e: row.gwp_kgco2e }
    }
}

impl From<&MemberCost> for Amounts {
    fn from(cost: &MemberCost) -> Amounts {
        Amounts { mass_kg: cost.mass_kg, price: cost.price, gwp_kgco2e: cost.gwp_kgco2e }
    }
}

/// What stands at a place.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Place {
    /// Layers.
    pub layers: Amounts,
    /// Members of the frame, by the length that lies there.
    pub frame: Amounts,
    /// Members that pass there.
    pub members: BTreeSet<u32>,
    /// Largest utilisation of those; `None` without any or where the frame was not checked.
    pub utilisation: Option<f64>,
    /// Items of the bill that the layers belong to.
    pub items: BTreeSet<Item>,
}

impl Place {
    /// Layers and frame.
    pub fn sum(&self) -> Amounts {
        [self.layers, self.frame].into_iter().sum()
    }
}

/// What stands where in a house.
#[derive(Clone, Debug, Default)]
pub struct Ledger {
    /// Layers; empty where no solids are drawn or nothing was taken off.
    pub rows: Vec<LayerRow>,
    /// Members in the order of the frame; empty without a take-off.
    pub members: Vec<MemberCost>,
    /// By cube of the padded array; pieces that belong to no cube are not in it.
    pub cubes: BTreeMap<[u32; 3], Place>,
    /// By voxel, everything.
    pub voxels: BTreeMap<[i32; 3], Place>,
    /// By number among [`Fabric::standing`].
    pub standing: Vec<Place>,
}

impl Ledger {
    /// Shares out the take-off of a house.
    ///
    /// # Errors
    /// What the books lack.
    pub fn new(
        house: &House,
        choices: &Choices,
        details: &Details,
        evaluator: &Evaluator,
        fabric: Option<&Fabric>,
    ) -> Result<Ledger, PriceError> {
        let rows = evaluator.layers(house, details).transpose()?.unwrap_or_default();
        let members = evaluator.member_costs(choices, details)?;
        let mut ledger = Ledger { rows, members, ..Ledger::default() };
        if let Some(fabric) = fabric {
            ledger.add_fabric(fabric);
        }
        ledger.add_frame(house, details);
        Ok(ledger)
    }

    /// What a layer weighs, costs and emits; `None` for what no item is priced for.
    pub fn layer(&self, component: Component) -> Option<&LayerRow> {
        self.rows.iter().find(|row| row.component == component)
    }

    /// Sum of the layers that are drawn.
    pub fn drawn(&self) -> Amounts {
        self.rows.iter().filter(|row| row.volume_m3 > 0.0).map(Amounts::from).sum()
    }

    /// Sum of the layers that are priced but not drawn.
    pub fn not_drawn(&self) -> Amounts {
        self.rows.iter().filter(|row| row.volume_m3 <= 0.0).map(Amounts::from).sum()
    }

    /// Sum of the members.
    pub fn frame(&self) -> Amounts {
        self.members.iter().map(Amounts::from).sum()
    }

    fn add_fabric(&mut self, fabric: &Fabric) {
        let stretch: f64 = fabric.scale.iter().product();
        let mut of_component: Vec<Option<(Amounts, Vec<Item>)>> = vec![None; Component::COUNT];
        for row in self.rows.iter().filter(|row| row.volume_m3 > 0.0) {
            let per_six = stretch / 6e18 / row.volume_m3;
            of_component[row.component as usize] = Some((Amounts::from(row).times(per_six), row.items.clone()));
        }
        self.standing = vec![Place::default(); fabric.standing.len()];
        for placed in &fabric.placed {
            // Places are there even for what costs nothing.
            let own = &of_component[placed.component as usize];
            let amounts = own.as_ref().map(|(a, _)| a.times(fabric.six_volumes_of(placed) as f64)).unwrap_or_default();
            let items = own.as_ref().map_or(&[][..], |(_, items)| items);
            for place in self.places_of(fabric, placed) {
                place.layers += amounts;
                place.items.extend(items);
            }
        }
    }

    /// The cube, or what stands in none, and the voxel of a piece.
    fn places_of(&mut self, fabric: &Fabric, placed: &PlacedBlock) -> [&mut Place; 2] {
        let own = match fabric.standing.iter().position(|t| *t == placed.tile) {
            Some(n) => &mut self.standing[n],
            None => self.cubes.entry(placed.cube).or_default(),
        };
        [own, self.voxels.entry(placed.voxel).or_default()]
    }

    fn add_frame(&mut self, house: &House, details: &Details) {
        let Some(frame) = &details.frame else { return };
        let checked = details.evaluation.assessment.as_ref().map_or(&[][..], |a| &a.members);
        let drawn: BTreeSet<[u32; 3]> = self.cubes.keys().copied().collect();
        for (id, member) in frame.members.iter().enumerate() {
            let utilisation = checked.get(id).map(|r| r.utilisation);
            let amounts = self.members.get(id).map(Amounts::from).unwrap_or_default();
            for Piece { cube, voxel, share } in pieces(member.ends, &house.voxels, &drawn) {
                let (cube, voxel) = (self.cubes.entry(cube).or_default(), self.voxels.entry(voxel).or_default());
                for place in [cube, voxel] {
                    place.frame += amounts.times(share);
                    place.members.insert(id as u32);
                    place.utilisation = match (place.utilisation, utilisation) {
                        (Some(a), Some(b)) => Some(a.max(b)),
                        (a, b) => a.or(b),
                    };
                }
            }
        }
    }
}
