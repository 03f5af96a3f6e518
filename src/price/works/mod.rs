//! What a factory-made house takes besides its materials: hours, set-up, practice, trucks, crane, assembly.
//!
//! The rates of the price book are of work in place, whose place here is the factory for what is made there and the plot for the rest; the
//! transport and lifting inside them bring materials to that place. What comes on top is what a factory adds: parts and connections are
//! set up once each, repeated parts go faster, and finished parts are carried to the plot and put up by crane and crew.
//!
//! Learning follows the straight line of Wright: the n-th piece takes n^b of the first, b = log2(rate), so that N pieces take on average
//! `(1 + 2^b + ... + N^b) / N` each. It acts on factory labour and on set-up, never on materials.

mod line;
mod settings;

pub use line::WorksLine;
pub use settings::{WorksRates, WorksSettings};

use super::{Range, RateTable};
use crate::envelope::Surface;
use crate::quantities::{Item, Takeoff};

/// What one house takes besides its materials.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct WorksQuantities {
    /// Hours in the factory before practice.
    pub factory_h: f64,
    /// Hours on the plot.
    pub site_h: f64,
    /// Distinct parts.
    pub part_types: f64,
    /// Distinct connections.
    pub node_types: f64,
    /// What practice leaves of factory labour: a share, at the three learning rates.
    pub learned_labour: Range,
    /// The same of the set-up of parts.
    pub learned_parts: Range,
    /// The same of the set-up of connections.
    pub learned_nodes: Range,
    /// Carried to the plot, kg: everything but the foundation.
    pub carried_kg: f64,
    /// Carried to the plot, m3: panels and cassettes by area and thickness, with their openings.
    pub carried_m3: f64,
    /// Trips of a truck.
    pub trips: f64,
    /// Kilometres, out and back.
    pub km: f64,
    /// Days of the crane, in halves.
    pub crane_days: f64,
    /// Hours of the crew at the crane.
    pub assembly_h: f64,
}

impl WorksQuantities {
    /// What a house takes, from its take-off. `measured` and `billed` are the take-off's own.
    pub(in crate::price) fn new(
        takeoff: &Takeoff,
        measured: &[f64; Item::COUNT],
        billed: &[f64; Item::COUNT],
        rates: &RateTable,
    ) -> WorksQuantities {
        let (works, settings) = (takeoff.works(), &rates.works.settings);
        let mut out = WorksQuantities {
            part_types: f64::from(works.part_types),
            node_types: f64::from(works.node_types),
            learned_labour: [1.0; 3],
            learned_parts: rates.works.average(works.part_types as usize),
            learned_nodes: rates.works.average(works.node_types as usize),
            ..WorksQuantities::default()
        };
        for (n, row) in rates.rows.iter().enumerate() {
            out.factory_h += billed[n] * row.factory_h;
            out.site_h += billed[n] * row.site_h;
            if row.carried {
                out.carried_kg += measured[n] * row.mass_kg;
                out.carried_m3 += measured[n] * row.thickness_m;
            }
        }
        let openings = takeoff.area_m2()[Surface::Window as usize] + takeoff.area_m2()[Surface::Door as usize];
        out.carried_m3 += openings * rates.rows[Item::Wall as usize].thickness_m;
        let area = works.area_m2();
        if area > 0.0 {
            for k in 0..3 {
                let practised = works.repeated_m2.iter().enumerate();
                out.learned_labour[k] = practised.map(|(n, m2)| m2 * rates.works.average(n + 1)[k]).sum::<f64>() / area;
            }
        }
        if works.lifts > 0 {
            let loads =
                (out.carried_kg / settings.payload_kg).max(out.carried_m3 / (settings.load_m3 * settings.load_fill));
            // A load that is full to the last bit needs no further truck.
            out.trips = (loads - 1e-9).ceil().max(1.0);
            out.km = 2.0 * settings.distance_km * out.trips;
            out.crane_days = (2.0 * f64::from(works.lifts) / settings.lifts_per_day - 1e-9).ceil() / 2.0;
            out.assembly_h = out.crane_days * settings.hours_per_day * settings.crew;
        }
        out
    }

    /// Units of each line at the default learning rate, in the order of [`WorksLine::ALL`]; what practice saves is negative.
    pub fn units(&self) -> [f64; WorksLine::ALL.len()] {
        let saved = |quantity: f64, share: Range| quantity * (share[1] - 1.0);
        [
            self.factory_h,
            saved(self.factory_h, self.learned_labour),
            self.part_types,
            saved(self.part_types, self.learned_parts),
            self.node_types,
            saved(self.node_types, self.learned_nodes),
            self.site_h,
            self.km,
            self.trips,
            self.crane_days,
            self.assembly_h,
        ]
    }

    /// Amounts net of overhead, in the order of [`WorksLine::ALL`]: low, default, high. What practice saves is negative.
    pub fn amounts(&self, rates: &WorksRates) -> [Range; WorksLine::ALL.len()] {
        let each = |quantity: f64, rate: Range| rate.map(|rate| quantity * rate);
        let labour = each(self.factory_h, rates.labour);
        let [parts, nodes] = [each(self.part_types, rates.setup_part), each(self.node_types, rates.setup_node)];
        let saved = |base: Range, share: Range| [0, 1, 2].map(|k| base[k] * (share[k] - 1.0));
        [
            labour,
            saved(labour, self.learned_labour),
            parts,
            saved(parts, self.learned_parts),
            nodes,
            saved(nodes, self.learned_nodes),
            each(self.site_h, rates.labour),
            each(self.km, rates.truck_km),
            each(self.trips, rates.truck_trip),
            each(self.crane_days, rates.crane_day),
            each(self.assembly_h, rates.labour),
        ]
    }
}
