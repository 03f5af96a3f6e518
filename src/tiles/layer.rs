//! The layers of a set of meshes: what groups of polygons are.

use super::Component;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Whether a layer is part of the boundary or a body of its own.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum LayerKind {
    /// Groups named `<kind>_o<octant>`; free edges on the cube's faces.
    Surface,
    /// Bodies, each closed in itself.
    Solid,
}

/// A layer of the tiles.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Layer {
    /// Name; also the group or material it is drawn in, alone or followed by `_o<octant>`.
    pub name: String,
    /// Surface or solid.
    pub kind: LayerKind,
    /// How far its vertices may lie outside the cube, in the manifest's unit (mm for `cube`).
    #[serde(default)]
    pub overhang: f64,
    /// What the bodies are in the building; needed in sets of kind `solids`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(schema_with = "component_schema")]
    pub component: Option<Component>,
    /// Groups or materials it is drawn in instead of its name; a final `*` stands for any ending.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub groups: Vec<String>,
}

/// The names of components, for schemas.
pub(super) fn component_schema(_: &mut schemars::SchemaGenerator) -> schemars::Schema {
    let names: Vec<&str> = Component::ALL.iter().map(|c| c.name()).collect();
    schemars::json_schema!({"type": "string", "enum": names})
}
