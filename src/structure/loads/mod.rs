//! Load settings: the site model on the numbers of `configs/loads.json`, and the thesis preset.

pub(super) mod pressure;
mod settings;
mod site;
mod table;

pub use pressure::{PressureTables, ZONE_NAMES, ZONES};
pub use settings::{Expression, LoadSettings, SnowDrift, Vibration};
pub use site::{Annex, FREE_FALL_M_S2, LoadError, Site, SurfaceWeights};
pub use table::LoadTable;
