//! What each member of a frame weighs, costs and emits: its part of the line of the bill that it belongs to.

use super::{Details, Evaluator};
use crate::price::{PriceError, bill};
use crate::voxels::Choices;

/// A member of the frame as the bill has it.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct MemberCost {
    /// Line of the bill, from 1.
    pub line: usize,
    /// kg.
    pub mass_kg: f64,
    /// Its material in the books' currency, without waste and work.
    pub price: f64,
    /// Fossil kgCO2e, A1-A3.
    pub gwp_kgco2e: f64,
}

impl Evaluator {
    /// The members of a house in the order of its frame: over the members of a line they sum to that line. Empty without a frame or a
    /// take-off.
    ///
    /// # Errors
    /// What the books lack for the bill.
    pub fn member_costs(&self, choices: &Choices, details: &Details) -> Result<Vec<MemberCost>, PriceError> {
        let (Some(frame), Some(takeoff)) = (&details.frame, &details.evaluation.takeoff) else { return Ok(Vec::new()) };
        let sections = self.sections(choices);
        let lines = bill(takeoff, &self.books, &|number| number.to_string())?;
        let mut costs = vec![MemberCost::default(); frame.members.len()];
        let measured = takeoff.lines(&|number| number.to_string());
        // The bill begins with the lines of the take-off, in their order.
        for (row, billed) in measured.iter().zip(&lines).filter(|(row, _)| row.item.is_frame() && row.quantity > 0.0) {
            for origin in self.members(row, frame, takeoff, &sections) {
                let Some(cost) = costs.get_mut(origin.number().unwrap_or(usize::MAX)) else { continue };
                let share = origin.quantity / row.quantity;
                *cost = MemberCost {
                    line: billed.line,
                    mass_kg: share * billed.mass_kg,
                    price: share * billed.amount,
                    gwp_kgco2e: share * billed.gwp_kgco2e,
                };
            }
        }
        Ok(costs)
    }
}
