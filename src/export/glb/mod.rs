//! Binary glTF 2.0: a node and a mesh for each part; views as variants of materials, a deformed shape as a morph target, parts that are
//! not seen at first in scenes of their own. An [`Assembly`] is written as nodes with shared meshes.
//!
//! Metres; axes are turned from z up to glTF's y up: (x, y, z) becomes (x, z, -y). Equal scenes give equal bytes.
//!
//! Files are kept small with what every reader knows: the primitives of a mesh share their vertices, indices have 16 bits where they
//! can, equal arrays of positions, normals or indices are written once, and bounds are written in the digits of single precision.
//! Quantized attributes (`KHR_mesh_quantization`) would halve the vertices, but readers such as trimesh and the crate `gltf` refuse files
//! that require them.

mod assembly;
mod container;
mod primitive;
mod writer;

pub use assembly::{Assembly, Instance, SharedMesh, assembly_to_glb};

use gltf_json::material::{AlphaMode, PbrBaseColorFactor, PbrMetallicRoughness, StrengthFactor};
use gltf_json::validation::Checked::Valid;
use gltf_json::{Index, Material};
use serde_json::Value;

use super::flat::{FlatPart, flatten};
use super::scene::{MaterialLook, Part, Scene, SceneError};
use writer::Writer;

/// Why a scene could not be written as GLB.
#[derive(Debug, thiserror::Error)]
pub enum GlbError {
    /// The scene refers to what it does not hold.
    #[error(transparent)]
    Scene(#[from] SceneError),
    /// The JSON chunk could not be written.
    #[error("glTF document: {0}")]
    Json(#[from] serde_json::Error),
    /// More than 4 GiB.
    #[error("the scene needs {bytes} bytes, but a GLB holds at most 4294967295; write fewer parts")]
    TooLarge {
        /// Its size.
        bytes: usize,
    },
}

/// A part with its geometry in single precision.
type Flat<'a> = (&'a Part, FlatPart);

/// The bytes of a `.glb` file.
///
/// Parts whose triangles all vanish in single precision are left out; `extras` stand on the nodes and the scene.
///
/// # Errors
/// When [`Scene::check`] fails, or the file would exceed the format's 4 GiB.
pub fn to_glb(scene: &Scene) -> Result<Vec<u8>, GlbError> {
    scene.check()?;
    let mut writer = Writer::new();
    let used: Vec<Flat> =
        scene.parts.iter().map(|p| (p, flatten(p))).filter(|(_, f)| !f.triangles.is_empty()).collect();
    let is_used = |m: usize| used.iter().any(|(p, _)| p.material == m || p.views.contains(&m));
    let materials = writer.materials(&scene.materials, is_used);
    writer.views(&scene.views);
    let (mut seen, mut apart, mut drawn) = (Vec::new(), Vec::new(), Vec::new());
    for group in used.chunk_by(|(a, _), (b, _)| are_one_node(a, b)) {
        let (first, _) = &group[0];
        let flats: Vec<&FlatPart> = group.iter().map(|(_, flat)| flat).collect();
        let moves: Option<Vec<[f32; 3]>> = (!first.moves.is_empty())
            .then(|| group.iter().flat_map(|(part, flat)| flat.sources.iter().map(|n| moved(part, *n))).collect());
        let geometry = writer.geometry(&flats, moves.as_deref());
        let looks: Vec<(usize, &[usize])> = group.iter().map(|(p, _)| (p.material, p.views.as_slice())).collect();
        // Viewers name a shape by this.
        let shape = scene.shape.as_deref().filter(|_| moves.is_some());
        let mesh = writer.mesh(&first.name, &geometry, &looks, &materials, shape)?;
        let node = writer.node(mesh, &first.name, &first.extras, None)?;
        if first.is_apart {
            apart.push((first.name.as_str(), node));
        } else {
            seen.push(node);
            drawn.push((geometry, looks));
        }
    }
    // What is apart stands in a scene of its own beside what is seen. A node in two scenes would be valid, but three.js shows it in the
    // last one only: so each of these scenes has a node of its own, which shares a mesh of all that is seen.
    let mut scenes = Vec::with_capacity(apart.len());
    if !apart.is_empty() && !drawn.is_empty() {
        let beside = writer.joined("seen", &drawn, &materials)?;
        for (name, node) in apart {
            scenes.push((name, vec![writer.node(beside, "seen", &Value::Null, None)?, node]));
        }
    } else {
        scenes.extend(apart.into_iter().map(|(name, node)| (name, vec![node])));
    }
    writer.finish(&scene.extras, seen, &scenes)
}

fn are_one_node(a: &Part, b: &Part) -> bool {
    !a.name.is_empty() && a.name == b.name && a.is_apart == b.is_apart && a.moves.is_empty() == b.moves.is_empty()
}

/// Where the deformed shape moves a vertex, without negative zero.
fn moved(part: &Part, vertex: u32) -> [f32; 3] {
    part.moves.get(vertex as usize).copied().unwrap_or_default().map(|c| c as f32 + 0.0)
}

/// Where the materials of a scene are in the file; `None` for those that nothing shows.
type Materials = [Option<Index<Material>>];

fn gltf_material(look: &MaterialLook) -> Material {
    let alpha = if look.rgba[3] < 1.0 { AlphaMode::Blend } else { AlphaMode::Opaque };
    Material {
        name: Some(look.name.clone()),
        alpha_mode: Valid(alpha),
        double_sided: look.double_sided,
        pbr_metallic_roughness: PbrMetallicRoughness {
            base_color_factor: PbrBaseColorFactor(look.rgba.map(|c| c.clamp(0.0, 1.0) as f32)),
            metallic_factor: StrengthFactor(look.metallic.clamp(0.0, 1.0) as f32),
            roughness_factor: StrengthFactor(look.roughness.clamp(0.0, 1.0) as f32),
            ..Default::default()
        },
        ..Default::default()
    }
}
