//! The numbers in the rules.

use serde::{Deserialize, Serialize};

/// Limits of the rules; a brief may override each. Lengths in metres or in modules, as the names say.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct RuleSettings {
    /// Least height between inner surfaces, m: 2.4, or 2.6 with the Dutch annex.
    pub clear_height_min_m: f64,
    /// Greatest clear height as a multiple of the least.
    pub clear_height_max_factor: f64,
    /// Least side of a court, modules.
    pub court_min_modules: usize,
    /// Least height of the space under a body, modules.
    pub undercut_min_modules: usize,
    /// Side of the blocks that a storey's plan is made of, modules.
    pub block_modules: usize,
    /// Side of the larger blocks that hold most of the plan, modules.
    pub room_modules: usize,
    /// Share of the plan in larger blocks, 0 to 1.
    pub room_share: f64,
    /// Greatest height over the least width of the base.
    pub slenderness_max: f64,
    /// Farthest cantilever, modules.
    pub cantilever_max_modules: usize,
    /// Modules standing behind a cantilever for each module out.
    pub cantilever_back_factor: usize,
    /// Least clear width of a stair, m.
    pub stair_width_min_m: f64,
    /// Least headroom over a stair, m.
    pub stair_headroom_min_m: f64,
    /// Floor area under which a loft may have a ladder, m2.
    pub loft_max_m2: f64,
    /// Least number of entrances.
    pub entrances_min: usize,
    /// Least clear width of an entrance, m.
    pub door_width_min_m: f64,
    /// Least clear height of an entrance, m.
    pub door_height_min_m: f64,
    /// Width of a door frame on each side, m.
    pub door_frame_m: f64,
    /// Most exterior doors in one storey.
    pub doors_per_storey_max: usize,
    /// Least glass over net floor area, per storey.
    pub glazing_ratio_min: f64,
    /// Most glass over net floor area, per storey.
    pub glazing_ratio_max: f64,
    /// Least number of orientations with glass, per storey.
    pub glazing_orientations_min: usize,
    /// Free view that glass needs outside to count, m.
    pub view_m: f64,
    /// Side of the least plan on which a roof may stand up, modules.
    pub bump_min_modules: usize,
    /// Ids of rules that are not applied.
    pub off: Vec<String>,
}

impl Default for RuleSettings {
    fn default() -> Self {
        RuleSettings {
            clear_height_min_m: 2.4,
            clear_height_max_factor: 1.5,
            court_min_modules: 4,
            undercut_min_modules: 4,
            block_modules: 3,
            room_modules: 4,
            room_share: 0.6,
            slenderness_max: 3.0,
            cantilever_max_modules: 2,
            cantilever_back_factor: 2,
            stair_width_min_m: 0.8,
            stair_headroom_min_m: 2.0,
            loft_max_m2: 10.0,
            entrances_min: 1,
            door_width_min_m: 0.85,
            door_height_min_m: 2.1,
            door_frame_m: 0.025,
            doors_per_storey_max: 3,
            glazing_ratio_min: 0.10,
            glazing_ratio_max: 0.35,
            glazing_orientations_min: 2,
            view_m: 2.7,
            bump_min_modules: 3,
            off: Vec::new(),
        }
    }
}

/// A setting that cannot be meant.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum SettingsError {
    /// A number that is negative or not finite.
    #[error("rules.{key}: {found} is not a length or ratio; give a finite number of at least 0")]
    Number {
        /// Name of the setting.
        key: &'static str,
        /// The number.
        found: f64,
    },
    /// Least glazing above most glazing.
    #[error("rules.glazing_ratio_min: {min} is above glazing_ratio_max = {max}; lower it or raise the other")]
    Glazing {
        /// Least ratio.
        min: f64,
        /// Most ratio.
        max: f64,
    },
    /// An id in `off` that no rule has.
    #[error("rules.off: no rule is called `{found}`; `houscaper check` lists the ids, e.g. `{example}`", example = super::RULES[0].id)]
    UnknownRule {
        /// The id.
        found: String,
    },
}

impl RuleSettings {
    /// Checks ranges and names.
    ///
    /// # Errors
    /// Negative or non-finite numbers, glazing limits that exclude each other, unknown ids in `off`.
    pub fn validate(&self) -> Result<(), SettingsError> {
        let numbers = [
            ("clear_height_min_m", self.clear_height_min_m),
            ("clear_height_max_factor", self.clear_height_max_factor),
            ("room_share", self.room_share),
            ("slenderness_max", self.slenderness_max),
            ("stair_width_min_m", self.stair_width_min_m),
            ("stair_headroom_min_m", self.stair_headroom_min_m),
            ("loft_max_m2", self.loft_max_m2),
            ("door_width_min_m", self.door_width_min_m),
            ("door_height_min_m", self.door_height_min_m),
            ("door_frame_m", self.door_frame_m),
            ("glazing_ratio_min", self.glazing_ratio_min),
            ("glazing_ratio_max", self.glazing_ratio_max),
            ("view_m", self.view_m),
        ];
        if let Some(&(key, found)) = numbers.iter().find(|(_, n)| !(n.is_finite() && *n >= 0.0)) {
            return Err(SettingsError::Number { key, found });
        }
        if self.glazing_ratio_min > self.glazing_ratio_max {
            return Err(SettingsError::Glazing { min: self.glazing_ratio_min, max: self.glazing_ratio_max });
        }
        match self.off.iter().find(|id| super::RULES.iter().all(|r| r.id != id.as_str())) {
            Some(found) => Err(SettingsError::UnknownRule { found: found.clone() }),
            None => Ok(()),
        }
    }
}
