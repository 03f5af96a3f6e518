//! Loads, sections and checks: from a frame to a verdict.
//!
//! First order, linear elastic. Not assessed: connections, fire, seismic, local wind peaks (cpe,1), crushing across the grain, the
//! foundation itself. Members are checked by the clauses in [`checks`].

mod actions;
mod assess;
mod cases;
mod catalogue;
mod check;
pub mod checks;
mod combine;
mod loads;
pub mod member;
mod model;
mod plan;
mod report;
mod review;
mod screen;
mod serviceability;
mod sizing;
mod snow;
mod stability;
mod strength;
mod thesis;
mod trial;
mod verdict;
mod vibration;
mod wind;
mod zones;

pub use assess::{Workspace, assess, masses};
pub use cases::{Case, load_cases};
pub use catalogue::{
    Catalogue, CatalogueError, CrossSection, DurationFactors, MaterialKind, SectionOption, ServiceClasses,
    StructuralMaterial,
};
pub use loads::{
    Annex, Expression, FREE_FALL_M_S2, LoadError, LoadSettings, LoadTable, PressureTables, Site, SnowDrift,
    SurfaceWeights, Vibration, ZONE_NAMES, ZONES,
};
pub use model::{analysis_model, frame_json};
pub use report::{ActionReport, CombinationReport, LoadReport, SnowReport, SumReport, WindReport, ZoneReport};
pub use review::{
    BucklingMode, Critical, Deformed, DrawnLoads, FoundationLine, GoverningCheck, LineKind, MAX_PIECE_M, MemberReview,
    ModeKind, Peak, Place, RackingReview, Review, SpanDeflection, StoreyReview, critical_loads, review,
};
pub use sizing::{Bid, Sizing, SizingStep, size};
pub use stability::Stability;
pub use verdict::{Assessment, Check, Governing, MemberResult, Mend, ThesisResult, Verdict};
pub use vibration::{FloorVibration, JoistFloor};
