//! Loads, sections and checks: from a frame to a verdict.
//!
//! First order, linear elastic. Not assessed: connections, fire, seismic, local wind zones, crushing across the grain, the foundation
//! itself. Members are checked by the clauses in [`checks`].

mod actions;
mod assess;
mod catalogue;
mod check;
pub mod checks;
mod combine;
mod loads;
pub mod member;
mod model;
mod serviceability;
mod strength;
mod thesis;
mod verdict;

pub use assess::{Workspace, assess};
pub use catalogue::{
    Catalogue, CatalogueError, CrossSection, DurationFactors, MaterialKind, SectionOption, ServiceClasses,
    StructuralMaterial, Timber,
};
pub use loads::{Annex, LoadError, LoadSettings, LoadTable, Site, SurfaceWeights};
pub use model::{Case, analysis_model, frame_json, load_cases};
pub use verdict::{Assessment, Check, Governing, MemberResult, Mend, ThesisResult, Verdict};
