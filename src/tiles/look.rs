//! How components look: the palette of a style.

use super::Component;
use super::layer::component_schema;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// How a component looks.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Look {
    /// Colour as sRGB, `#rrggbb`.
    #[schemars(regex(pattern = "^#[0-9a-fA-F]{6}$"))]
    pub srgb: String,
    /// 0 mirror to 1 matt.
    #[schemars(range(min = 0.0, max = 1.0))]
    pub roughness: f64,
    /// 0 no metal to 1 metal.
    #[serde(default)]
    #[schemars(range(min = 0.0, max = 1.0))]
    pub metallic: f64,
    /// 0 clear to 1 opaque.
    #[serde(default = "opaque")]
    #[schemars(range(min = 0.0, max = 1.0))]
    pub opacity: f64,
    /// Direction of boards or courses.
    #[serde(default)]
    pub grain: Grain,
}

fn opaque() -> f64 {
    1.0
}

/// Direction in which a material shows boards or courses.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Grain {
    /// None to be seen.
    #[default]
    None,
    /// Level.
    Horizontal,
    /// Upright, or up the slope.
    Vertical,
}

/// The look of each component by its name.
pub(super) fn palette_schema(generator: &mut schemars::SchemaGenerator) -> schemars::Schema {
    let look = generator.subschema_for::<Look>();
    let names = component_schema(generator);
    schemars::json_schema!({"type": "object", "propertyNames": names, "additionalProperties": look})
}

/// The component of a name.
pub(super) fn component(name: &str) -> Option<Component> {
    Component::ALL.iter().copied().find(|c| c.name() == name)
}
