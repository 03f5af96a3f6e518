//! Lines of the bill besides materials and their waste.

use crate::quantities::Group;

/// A line of the bill besides materials and their waste.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(usize)]
pub enum WorksLine {
    /// Labour in the factory.
    FactoryLabour = 0,
    /// What practice saves of it.
    LearningLabour = 1,
    /// Set-up of distinct parts.
    SetupParts = 2,
    /// What practice saves of it.
    LearningParts = 3,
    /// Set-up of distinct connections.
    SetupNodes = 4,
    /// What practice saves of it.
    LearningNodes = 5,
    /// Labour on the plot.
    SiteLabour = 6,
    /// Kilometres of trucks.
    TruckKm = 7,
    /// Trips of trucks.
    TruckTrips = 8,
    /// The crane.
    Crane = 9,
    /// The crew at the crane.
    Assembly = 10,
}

impl WorksLine {
    /// All lines in the order of a bill.
    pub const ALL: [WorksLine; 11] = [
        WorksLine::FactoryLabour,
        WorksLine::LearningLabour,
        WorksLine::SetupParts,
        WorksLine::LearningParts,
        WorksLine::SetupNodes,
        WorksLine::LearningNodes,
        WorksLine::SiteLabour,
        WorksLine::TruckKm,
        WorksLine::TruckTrips,
        WorksLine::Crane,
        WorksLine::Assembly,
    ];

    /// Name in files.
    pub fn id(self) -> &'static str {
        const IDS: [&str; WorksLine::ALL.len()] = [
            "factory_labour",
            "learning_labour",
            "setup_parts",
            "learning_parts",
            "setup_nodes",
            "learning_nodes",
            "site_labour",
            "truck_km",
            "truck_trips",
            "crane",
            "assembly",
        ];
        IDS[self as usize]
    }

    /// Section of the bill.
    pub fn group(self) -> Group {
        if (self as usize) < WorksLine::SiteLabour as usize { Group::Manufacture } else { Group::Site }
    }

    /// Item of the price book that its rate comes from.
    pub fn price_item(self) -> &'static str {
        match self {
            WorksLine::FactoryLabour | WorksLine::LearningLabour => "labour_hour",
            WorksLine::SiteLabour | WorksLine::Assembly => "labour_hour",
            WorksLine::SetupParts | WorksLine::LearningParts => "setup_part",
            WorksLine::SetupNodes | WorksLine::LearningNodes => "setup_node",
            WorksLine::TruckKm => "truck_km",
            WorksLine::TruckTrips => "truck_trip",
            WorksLine::Crane => "crane_day",
        }
    }
}
