//! What making and putting up a house depends on besides its materials: parts and how often they repeat, connections, lifts.

/// Numbers of pieces told apart: what repeats more often counts as this many.
pub const REPEATS: usize = 24;

/// Parts, connections and lifts of a house.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Works {
    /// Parts: panels, cassettes, windows, doors, stairs.
    pub parts: u32,
    /// Distinct parts, up to congruence and mirror image.
    pub part_types: u32,
    /// Distinct connections of members, up to quarter turns and mirror images in plan.
    pub node_types: u32,
    /// Parts that a crane lifts: panels, cassettes and stairs (windows and doors come in their panels).
    pub lifts: u32,
    /// m2 of panels and cassettes whose type occurs once, twice, ... in the house; the last place also holds what occurs more often.
    pub repeated_m2: [f64; REPEATS],
}

impl Works {
    /// m2 of all panels and cassettes.
    pub fn area_m2(&self) -> f64 {
        self.repeated_m2.iter().sum()
    }
}
