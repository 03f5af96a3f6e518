//! From a carcass to an evaluation: sections, price and carbon first, then the solve.
//!
//! Only the verdict, the ratios of the checks and the violation wait for the solve. So a search may ask first whether a house can still
//! matter ([`Evaluator::is_beaten`]), and the solve of one that cannot is spared.

use std::sync::Arc;

use super::carcass::Carcass;
use super::evaluation::{limit_violation, structural_violation};
use super::evaluator::Workspace;
use super::programme::{floor_area_m2, shortfall};
use super::{Evaluation, Evaluator, Values};
use crate::brief::Objective;
use crate::price::{Cost, cost};
use crate::quantities::{FrameGroup, FrameMaterial, FrameQuantity, Takeoff, TakeoffError};
use crate::structure::{self, Assessment, SectionOption, Verdict};
use crate::voxels::{Choice, Choices, House, Reading};

impl Evaluator {
    /// Whether `beaten` holds for bounds on the objectives of a house, found without a solve: an objective that rests on the solve is
    /// minus infinity, each other one is exactly what [`Evaluator::evaluate`] would say, in the brief's order and minimised. False for a
    /// house that breaks rules. What is known of a house that is not beaten is kept for an evaluation that follows.
    pub fn is_beaten(&self, house: &House, choices: &Choices, beaten: &dyn Fn(&[f64]) -> bool) -> bool {
        let is_beaten_as = |carcass: &Carcass| {
            let priced = self.priced(carcass, house, choices);
            priced.cost.is_some() && beaten(&self.without_a_solve(&priced.values))
        };
        if let Some(known) = self.carcasses.get(house, choices) {
            return is_beaten_as(&known);
        }
        let mut workspace = self.take();
        let mut carcass = self.bare_carcass(house, choices, &mut workspace, false);
        let is_beaten = is_beaten_as(&carcass);
        if !is_beaten || self.carcasses.glimpse(house, choices) {
            self.complete(house, &mut carcass, &mut workspace);
            self.carcasses.put(house, choices, &Arc::new(carcass));
        }
        self.give(workspace);
        is_beaten
    }

    /// The brief's objectives, minimised; minus infinity for those that rest on a solve.
    fn without_a_solve(&self, values: &Values) -> Vec<f64> {
        let bound = |goal: &crate::brief::Goal| match goal.objective.is_structural() {
            true => f64::NEG_INFINITY,
            false => goal.minimised(values.get(goal.objective)),
        };
        self.brief.objectives.iter().map(bound).collect()
    }

    /// Everything but the solve.
    pub(super) fn priced(&self, carcass: &Carcass, house: &House, choices: &Choices) -> Evaluation {
        let sections = self.sections(choices);
        let clear = self.clear_height_m(&carcass.reading, &sections);
        let shortfall = shortfall(&self.brief.programme, house, &carcass.reading, clear, carcass.glazing);
        let mut evaluation = Evaluation::broken(carcass.rules, shortfall);
        let masses =
            carcass.frame.as_ref().map(|f| structure::masses(f, &self.catalogue, &sections)).unwrap_or_default();
        let takeoff = carcass.layers.and_then(|layers| self.with_frame(layers, choices, &masses).ok());
        if let Some(mut takeoff) = takeoff {
            takeoff.set_works(carcass.works.unwrap_or_default());
            let cost = cost(&takeoff, &self.rates);
            evaluation.values = values(carcass, &cost, masses.frame_mass_kg);
            evaluation.cost = Some(cost);
            evaluation.takeoff = Some(takeoff);
        }
        evaluation
    }

    /// Analyses what was priced, unless it broke rules and was made no further.
    pub(super) fn judged(
        &self,
        mut evaluation: Evaluation,
        carcass: &Carcass,
        choices: &Choices,
        workspace: &mut Workspace,
    ) -> Evaluation {
        if carcass.areas.is_none() && carcass.frame.is_none() && carcass.rules > 0.0 {
            return evaluation;
        }
        let sections = self.sections(choices);
        let assessment = match &carcass.frame {
            Some(frame) => structure::assess(frame, &self.catalogue, &sections, &self.loads, &mut workspace.structure),
            None => Assessment {
                verdict: Verdict::NotAssessed { reason: "no wall stands on the foundation" },
                ..Assessment::default()
            },
        };
        if evaluation.cost.is_some() && !self.loads.preset_only {
            evaluation.values.set(Objective::Utilisation, assessment.utilisation);
            evaluation.values.set(Objective::SwayRatio, assessment.sway_ratio);
            evaluation.values.set(Objective::DeflectionRatio, assessment.deflection_ratio);
        }
        if evaluation.rules <= 0.0 {
            evaluation.violation = structural_violation(&assessment, self.loads.preset_only)
                + evaluation.shortfall.total()
                + limit_violation(&self.limits, &evaluation.values);
        }
        evaluation.assessment = Some(assessment);
        evaluation
    }

    /// Smallest clear height of a storey when joists deeper than the standard slab zone take from it, m.
    pub(super) fn clear_height_m(&self, reading: &Reading, sections: &[SectionOption; 4]) -> f64 {
        let deeper =
            (self.catalogue.slab_zone_m(sections[Choice::Floor as usize]) - crate::voxels::SLAB_ZONE_M).max(0.0);
        let least = reading.storeys.iter().map(|s| s.clear_height_m).fold(f64::INFINITY, f64::min);
        if least.is_finite() { least - deeper } else { 0.0 }
    }

    /// A take-off with the members of the frame.
    fn with_frame(
        &self,
        mut takeoff: Takeoff,
        choices: &Choices,
        assessment: &Assessment,
    ) -> Result<Takeoff, TakeoffError> {
        for (g, &option) in self.sections(choices).iter().enumerate() {
            let length_m = assessment.group_length_m[g];
            let (Some(group), Some(material)) =
                (FrameGroup::from_index(g), FrameMaterial::from_id(&self.catalogue.material(option).id))
            else {
                continue;
            };
            let row = FrameQuantity {
                group,
                material,
                section: option.section as u16,
                length_m,
                volume_m3: length_m * self.catalogue.section(option).a,
                mass_kg: assessment.group_mass_kg[g],
            };
            if length_m > 0.0 {
                takeoff.add_frame(&[row])?;
            }
        }
        Ok(takeoff)
    }
}

/// The objectives that need no solve.
fn values(carcass: &Carcass, cost: &Cost, frame_mass_kg: f64) -> Values {
    let floor = floor_area_m2(&carcass.reading);
    let per_floor = |value: f64| if floor > 0.0 { value / floor } else { f64::NAN };
    let envelope_m2 = carcass.areas.map_or(f64::NAN, |areas| areas.area_m2.iter().sum());
    let mut values = Values::default();
    for (objective, value) in [
        (Objective::PriceEur, cost.price_eur[1]),
        (Objective::PricePerM2Eur, per_floor(cost.price_eur[1])),
        (Objective::FrameMassKg, frame_mass_kg),
        (Objective::MassKg, cost.mass_kg),
        (Objective::GwpKgco2e, cost.gwp_fossil[1]),
        (Objective::EnergyMj, cost.energy_mj.unwrap_or(f64::NAN)),
        (Objective::FloorAreaM2, floor),
        (Objective::GlazingRatio, carcass.glazing),
        (Objective::EnvelopeRatio, per_floor(envelope_m2)),
        (Objective::HeatLossWPerK, cost.heat_loss_w_per_k),
        (Objective::DistinctTiles, carcass.tiles),
        (Objective::DistinctParts, carcass.works.map_or(f64::NAN, |works| f64::from(works.part_types))),
    ] {
        values.set(objective, value);
    }
    values
}
