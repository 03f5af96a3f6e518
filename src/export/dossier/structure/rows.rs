//! Rows of the report that the review of a frame fills.

use serde::Serialize;

/// A member.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct MemberReport {
    /// Index.
    pub member: usize,
    /// Role.
    pub role: &'static str,
    /// Length, m.
    pub length_m: f64,
    /// Sections side by side.
    pub plies: u8,
    /// Material and section.
    pub section: String,
    /// Largest utilisation.
    pub utilisation: f64,
    /// Its check.
    pub check: String,
    /// Largest deflection over its limit.
    pub deflection_ratio: f64,
    /// The check in numbers; missing for what nothing loads.
    pub governing: Option<CheckReport>,
    /// Least and largest axial force over the ultimate combinations, tension positive, kN.
    pub axial_kn: Option<[f64; 2]>,
    /// The span nearest to a limit of deflection.
    pub deflection: Option<DeflectionReport>,
}

/// A check in numbers.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct CheckReport {
    /// Standard and number.
    pub clause: &'static str,
    /// What is asked, a symbol or the formula of a sum.
    pub demand_symbol: &'static str,
    /// In `unit`.
    pub demand: f64,
    /// What is there.
    pub resistance_symbol: &'static str,
    /// In `unit`.
    pub resistance: f64,
    /// kN, kNm, MPa, or empty for a sum of ratios.
    pub unit: &'static str,
    /// The terms of a sum of ratios, which add up to `demand`; missing for other clauses.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub terms: Vec<TermReport>,
    /// Number of the combination in `loads.combinations`, from 1.
    pub combination: usize,
    /// Distance from the member's start, m; missing where the clause is about the whole clear length.
    pub at_m: Option<f64>,
    /// Clear length, m: the buckling length about the strong axis.
    pub clear_m: f64,
    /// Duration of load and moisture; 1 for steel.
    pub k_mod: f64,
    /// N (tension positive), kN.
    pub n_kn: f64,
    /// V along y and z, kN.
    pub v_kn: [f64; 2],
    /// M about y and z, kNm.
    pub m_knm: [f64; 2],
}

/// A term of a sum of ratios.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct TermReport {
    /// Its formula.
    pub symbol: &'static str,
    /// Its value.
    pub value: f64,
}

/// A deflection in numbers.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct DeflectionReport {
    /// Total (with creep) or variable.
    pub check: String,
    /// Span, m.
    pub span_m: f64,
    /// Held at one end only.
    pub cantilever: bool,
    /// Deflection from the chord, mm.
    pub mm: f64,
    /// Its limit, mm.
    pub limit_mm: f64,
}

/// Reactions of a line of the foundation.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct FoundationReport {
    /// `wall along x at y = 0.45 m` and so on.
    pub line: String,
    /// From where to where, m.
    pub extent_m: [f64; 2],
    /// Length of the soles, m; 0 for a post.
    pub length_m: f64,
    /// Supports on it.
    pub supports: usize,
    /// Permanent, imposed and even snow, characteristic, kN.
    pub characteristic_kn: [f64; 3],
    /// Largest sum over the ultimate combinations, kN.
    pub design_kn: f64,
    /// Its combination, from 1.
    pub combination: usize,
    /// That sum a metre of sole, kN/m; missing for a post.
    pub design_kn_m: Option<f64>,
    /// Largest push on one support, kN, ultimate.
    pub push_kn: f64,
    /// Where, m.
    pub push_at_m: [f64; 2],
    /// Largest pull on one support under 0.9 G + 1.5 W, kN; 0 where nothing pulls.
    pub pull_kn: f64,
    /// Where, m.
    pub pull_at_m: [f64; 2],
    /// Largest horizontal force along the line over the ultimate combinations, kN.
    pub along_kn: f64,
}

/// A boarded wall, or the worst panel of a deck or roof.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct RackingReport {
    /// `wall`, `deck` or `roof`, and where.
    pub what: String,
    /// Force along it, kN; of a deck or roof panel along its diagonal.
    pub force_kn: f64,
    /// Design capacity, kN.
    pub capacity_kn: f64,
    /// Force over capacity.
    pub ratio: f64,
    /// The combination, from 1.
    pub combination: usize,
}

/// A storey's stiffness against swaying.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct StoreyReport {
    /// Foot and head, m.
    pub z_m: [f64; 2],
    /// The wind with the least factor: the side it comes from.
    pub wind_from: &'static str,
    /// H: horizontal load above the foot in that wind, characteristic, kN.
    pub horizontal_kn: f64,
    /// V: largest vertical design load above the foot, kN.
    pub vertical_kn: f64,
    /// Largest drift of a post in that wind, mm.
    pub drift_mm: f64,
    /// alpha_cr = H h / (V drift), EN 1993-1-1 (5.2).
    pub alpha_cr: f64,
}

/// First buckling loads.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct CriticalReport {
    /// Of the frame, sticks straight between their ends: what is set against the limit, with the factors of the storeys.
    pub frame: Option<ModeReport>,
    /// Of the first member over its clear length, held by boards: its Euler load, for comparison with its check.
    pub member: Option<ModeReport>,
    /// The lower of the frame's and the storeys' factors; missing where nothing is compressed.
    pub alpha_cr: Option<f64>,
    /// Least factor of the frame for first-order analysis.
    pub limit: f64,
    /// What follows.
    pub conclusion: String,
}

/// A buckling mode.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ModeReport {
    /// Critical load factor.
    pub factor: f64,
    /// Combination with the least factor, from 1.
    pub combination: usize,
    /// `sway`: floors or eaves move sideways; `local`: they do not.
    pub kind: &'static str,
    /// What moves most.
    pub what: String,
    /// Where, m.
    pub at_m: [f64; 3],
    /// In which direction.
    pub direction: [f64; 3],
}

/// The shape that is drawn.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct DeformedReport {
    /// Characteristic combination with the largest displacement.
    pub combination: String,
    /// That displacement, mm: elastic, without creep.
    pub largest_mm: f64,
    /// The member.
    pub member: usize,
    /// The place, m.
    pub at_m: [f64; 3],
    /// How many times it is drawn larger.
    pub scale: f64,
}

/// How well the equations hold.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct SolutionReport {
    /// Nodes.
    pub nodes: usize,
    /// Elements, and braces for boards.
    pub elements: [usize; 2],
    /// Free displacements and rotations.
    pub unknowns: usize,
    /// Largest unbalanced force at a node over the largest end force.
    pub residual: f64,
}
