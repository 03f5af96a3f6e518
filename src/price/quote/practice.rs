//! What a quote says of making, carrying and putting up.

use serde::Serialize;

use crate::price::works::WorksQuantities;
use crate::price::{Range, RateTable};
use crate::quantities::Takeoff;

/// How repetition was counted; enough to work the lines of practice out again.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct QuotePractice {
    /// Learning rates: what a doubling of the pieces makes of the time of the last one; low, default, high price.
    pub learning_rates: Range,
    /// m2 of panels and cassettes whose type occurs once, twice, ...; the last place also holds what occurs more often.
    pub repeated_m2: Vec<f64>,
    /// Distinct parts.
    pub part_types: f64,
    /// Distinct connections of members.
    pub node_types: f64,
    /// What practice leaves of factory labour, of setting up parts, of setting up connections: shares at the three rates.
    pub left: [Range; 3],
}

/// How repetition was counted, and what was assumed.
pub(super) fn works(takeoff: &Takeoff, rates: &RateTable) -> (QuotePractice, Vec<String>) {
    let (measured, billed) = (takeoff.measured(), takeoff.billed(rates.window_min_m2));
    let works = WorksQuantities::new(takeoff, &measured, &billed, rates);
    let settings = &rates.works.settings;
    let practice = QuotePractice {
        learning_rates: settings.learning(),
        repeated_m2: takeoff.works().repeated_m2.to_vec(),
        part_types: works.part_types,
        node_types: works.node_types,
        left: [works.learned_labour, works.learned_parts, works.learned_nodes],
    };
    let [low, default, high] = settings.learning().map(|rate| 100.0 * rate);
    let assumptions = vec![
        "Rates are of work in place: in the factory for panels, cassettes and frame, on the plot for foundation, tiles, membranes and metalwork."
            .to_owned(),
        format!(
            "Practice: the time of a piece falls to {default:.0} % ({low:.0} to {high:.0} %) with every doubling; it acts on factory labour and set-up, never on materials."
        ),
        format!(
            "Transport: {:.0} km from factory to plot and back empty, {:.0} t or {:.0} m3 a truck, {:.0} % of its space filled.",
            settings.distance_km,
            settings.payload_kg / 1e3,
            settings.load_m3,
            100.0 * settings.load_fill
        ),
        format!(
            "Assembly: {:.0} parts lifted a day, half days counted, a crew of {:.0}.",
            settings.lifts_per_day, settings.crew
        ),
    ];
    (practice, assumptions)
}
