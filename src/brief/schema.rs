//! The brief file: `houscaper.brief/1`.

use std::collections::BTreeMap;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::Goal;
use crate::voxels::Boards;

/// What the house is for, where it stands, what it may be made of, and what makes it good.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Brief {
    /// Always `houscaper.brief/1`.
    pub schema: String,
    /// Name of the run folder.
    pub name: String,
    /// Plot.
    pub plot: Plot,
    /// Programme.
    pub programme: Programme,
    /// Given voxels from a lattice.
    #[serde(default)]
    pub given: Option<Given>,
    /// Tileset: a folder under `tilesets/` (a style such as `architectural` or `larch`, or a set of surfaces), or a path.
    #[serde(default = "default_tileset")]
    pub tileset: String,
    /// Linear tileset.
    #[serde(default = "default_linear")]
    pub linear: String,
    /// Materials the frame may take, e.g. `C24`, `GL24h`, `S355`.
    pub materials: Vec<String>,
    /// `"auto"`: every catalogue section that fits its layer; or a list of section ids.
    #[serde(default)]
    pub sections: Sections,
    /// Which sides of the outer walls may carry boards (OSB): one entry fixes it, of more each house takes the one it needs.
    #[serde(default = "every_board")]
    pub wall_boards: Vec<Boards>,
    /// Site model, or `{"preset": "thesis"}`.
    pub site: Site,
    /// Price book, path relative to the brief.
    pub prices: String,
    /// Carbon factors, path relative to the brief.
    pub carbon: String,
    /// Build-ups of walls, roofs and floors, path relative to the brief.
    #[serde(default = "default_buildups")]
    pub buildups: String,
    /// A voxel file to compare with.
    #[serde(default)]
    pub reference: Option<String>,
    /// At least one objective.
    pub objectives: Vec<Goal>,
    /// `<objective>_max`, `<objective>_min`, `budget_eur`.
    #[serde(default)]
    pub constraints: BTreeMap<String, f64>,
    /// Changes of single rule settings (see `houscaper check --rules`).
    #[serde(default)]
    pub rules: Option<serde_json::Map<String, serde_json::Value>>,
    /// Search settings.
    #[serde(default)]
    pub search: Search,
}

fn default_tileset() -> String {
    "architectural".into()
}
fn default_linear() -> String {
    "linear".into()
}
fn default_buildups() -> String {
    "buildups.json".into()
}

/// The plot in modules.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Plot {
    /// Modules along x, y and z (z counts the foundation layer).
    pub modules: [usize; 3],
    /// Size of a module in metres.
    #[serde(default = "default_module")]
    pub module_m: [f64; 3],
    /// Buildable mask: rows of `#` (buildable) and `.` from north to south; everything when absent.
    #[serde(default)]
    pub mask: Option<Vec<String>>,
    /// A closed mesh that no room may leave.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub envelope: Option<Envelope>,
}

/// A closed mesh around what may be built: voxels above the ground whose centre lies outside are not buildable. A storey takes a plan cell
/// only if all its layers and the plate over it are inside; a hipped roof rises only where the whole storey above would be.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Envelope {
    /// OBJ file, z up, path relative to the brief.
    pub file: String,
    /// Metres of the house for a unit of the file along x, y and z; by default the scale at which `given` puts its lattice on modules, else 1.
    #[serde(default)]
    pub scale: Option<[f64; 3]>,
    /// Point of the file that comes to the plot's low corner at ground level; by default where `given` has it in plan, else the low corner of
    /// the mesh's box; its lowest level in height.
    #[serde(default)]
    pub origin: Option<[f64; 3]>,
}

fn default_module() -> [f64; 3] {
    [0.9, 0.9, 0.54]
}

/// What the house must offer.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Programme {
    /// Least and most net floor area, m2.
    pub floor_area_m2: [f64; 2],
    /// Least and most storeys.
    pub storeys: [usize; 2],
    /// Least clear height, m.
    #[serde(default = "default_clear_height")]
    pub clear_height_m: f64,
    /// Least glazing ratio of every storey.
    #[serde(default = "default_glazing")]
    pub glazing_ratio_min: f64,
    /// Least number of entrances onto the ground.
    #[serde(default = "one")]
    pub entrances_min: usize,
    /// Least and most rise of the roof in modules of 0.54 m: 0 = flat, at most 4. A top storey too narrow for the least rise
    /// takes the steepest hip it can carry.
    #[serde(default = "any_roof")]
    pub roof_rise: [usize; 2],
    /// Whether every storey must be reached by a stair.
    #[serde(default = "yes")]
    pub reachable: bool,
    /// Area that zones of the given lattice must have; what lacks or exceeds counts as violation, relative to what is asked.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub zones: Vec<ZoneArea>,
}

/// What a zone of the programme table must have.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ZoneArea {
    /// Its id in the given lattice.
    pub zone: i32,
    /// Its name, for people.
    #[serde(default)]
    pub name: String,
    /// Least and most gross plan area over all storeys, m2: filled cells of the zone, walls included.
    pub area_m2: [f64; 2],
}

fn default_clear_height() -> f64 {
    2.4
}
fn default_glazing() -> f64 {
    0.10
}
fn one() -> usize {
    1
}
fn any_roof() -> [usize; 2] {
    [0, 4]
}
fn yes() -> bool {
    true
}

/// Cells that the house must fill, leave empty or keep.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Given {
    /// Lattice CSV, path relative to the brief.
    pub lattice: String,
    /// What counts as occupied, e.g. `>= 0`, `== True`, `> 0.5`.
    pub occupied: String,
    /// Modules one lattice cell becomes; by default its unit divided by the module, rounded.
    #[serde(default)]
    pub cell_modules: Option<[usize; 3]>,
    /// Module at which lattice cell (0,0,0) starts.
    #[serde(default)]
    pub offset: [i64; 3],
    /// First and last lattice cell to take, both included.
    #[serde(default)]
    pub crop: Option<[[usize; 3]; 2]>,
    /// Whether the lowest filled layer is set on the ground.
    #[serde(default = "yes")]
    pub ground: bool,
    /// What is kept.
    #[serde(default)]
    pub keep: Keep,
    /// Lattice CSV of sun access on the same cells: the more, the likelier windows are drawn there. Path relative to the brief.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub sun: Option<String>,
    /// Lattice CSV of entrance access on the same cells: the more, the likelier doors are drawn there. Path relative to the brief.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub entrances: Option<String>,
}

/// What the search may not change of the given cells.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum Keep {
    /// Filled cells stay filled.
    #[default]
    Filled,
    /// Empty cells stay empty.
    Empty,
    /// Both.
    Both,
    /// Filled cells keep their labels (1 base, 2 floor, 3 foundation, 4 opening, 5 window): a lattice of a house or of parts of one. What lies
    /// above the highest storey that reaches its last layer is its roof.
    Labels,
}

fn every_board() -> Vec<Boards> {
    Boards::ALL.to_vec()
}

/// Which sections the frame may take.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(untagged, expecting = "expected \"auto\" or a list of section ids")]
pub enum Sections {
    /// Every section of the catalogue that fits its layer.
    #[default]
    #[serde(skip)]
    Auto,
    /// `"auto"`.
    Word(Auto),
    /// These ids.
    List(Vec<String>),
}

impl Sections {
    /// The listed ids, `None` for auto.
    pub fn list(&self) -> Option<&[String]> {
        match self {
            Sections::Auto | Sections::Word(Auto::Auto) => None,
            Sections::List(ids) => Some(ids),
        }
    }
}

/// The word `auto`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum Auto {
    /// `"auto"`.
    Auto,
}

/// Where the house stands: either `preset`, or the other keys.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Site {
    /// `thesis`: 1.5 x gravity and 1000 N/m of wind; the verdict then stays *not assessed*.
    #[serde(default)]
    pub preset: Option<String>,
    /// Basic wind velocity, m/s.
    #[serde(default)]
    pub vb0_m_s: Option<f64>,
    /// Terrain category `0`, `I`, `II`, `III`, `IV`.
    #[serde(default)]
    pub terrain: Option<String>,
    /// Characteristic ground snow load, kN/m2.
    #[serde(default)]
    pub sk_kn_m2: Option<f64>,
    /// National annex: `EN` (recommended values) or `NL`.
    #[serde(default)]
    pub annex: Option<String>,
}

/// How long and from which seed to search.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Search {
    /// How candidates are chosen.
    #[serde(default)]
    pub algorithm: Algorithm,
    /// Evaluations.
    #[serde(default = "default_evaluations")]
    pub evaluations: usize,
    /// Evaluations without a gain worth naming (a thousandth of the hypervolume) after which the search ends; never when absent.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub stagnation: Option<u64>,
    /// Seed; the same seed gives the same bytes for any number of threads.
    #[serde(default = "default_seed")]
    pub seed: u64,
    /// Parents kept: 50 when absent, or 100 for the generational algorithms, whose batch is as large; for MAP-Elites the starts (128).
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub population: Option<usize>,
    /// Share of children whose sections are sized (each check passes at least price, mass or carbon) instead of drawn; 0 for none.
    #[serde(default = "default_sizing")]
    pub sizing: f64,
    /// Whether a house is ruled out without a solve where its price, carbon, areas and masses show that it is beaten already. The algorithm
    /// `steady` asks; `false` evaluates every child, for comparisons, and where many workers behind a queue wait for one machine.
    #[serde(default = "yes")]
    pub screen: bool,
}

/// How a search chooses its candidates.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum Algorithm {
    /// A steady state around an archive, with moves chosen by their recent success.
    #[default]
    Steady,
    /// NSGA-II with constraint domination.
    Nsga2,
    /// NSGA-III.
    Nsga3,
    /// MAP-Elites: the best house of each kind (storeys, footprint shape, roof, glazing) by the first objective.
    #[serde(rename = "map-elites")]
    MapElites,
    /// Random starts and random moves: the baseline.
    Random,
    /// Hill climbers along weighted objectives.
    Hill,
}

fn default_evaluations() -> usize {
    6000
}
fn default_seed() -> u64 {
    1
}

fn default_sizing() -> f64 {
    0.05
}

impl Default for Search {
    fn default() -> Self {
        Search {
            algorithm: Algorithm::default(),
            evaluations: default_evaluations(),
            stagnation: None,
            seed: default_seed(),
            population: None,
            sizing: default_sizing(),
            screen: yes(),
        }
    }
}
