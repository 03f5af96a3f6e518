//! Primitives: arrays with a material, and the materials of the views.

use gltf_json::extensions::mesh as extensions;
use gltf_json::mesh;
use gltf_json::validation::Checked::Valid;

use super::Materials;
use super::writer::Geometry;

/// Material of a primitive and those of the views.
pub(super) type Look<'a> = (usize, &'a [usize]);

/// The primitives of a geometry, with the deformed shape where it is wanted.
pub(super) fn primitives(
    geometry: &Geometry,
    looks: &[Look],
    materials: &Materials,
    with_shape: bool,
) -> impl Iterator<Item = mesh::Primitive> {
    let attributes =
        [(Valid(mesh::Semantic::Positions), geometry.positions), (Valid(mesh::Semantic::Normals), geometry.normals)];
    let target = |moves| vec![mesh::MorphTarget { positions: Some(moves), normals: None, tangents: None }];
    let targets = geometry.moves.filter(|_| with_shape).map(target);
    geometry.indices.iter().zip(looks).map(move |(&indices, (material, views))| mesh::Primitive {
        attributes: attributes.iter().cloned().collect(),
        extensions: view_materials(views, materials),
        extras: None,
        indices: Some(indices),
        material: materials[*material],
        mode: Valid(mesh::Mode::Triangles),
        targets: targets.clone(),
    })
}

/// Which material shows in which view; views of one material share a mapping.
fn view_materials(views: &[usize], materials: &Materials) -> Option<extensions::Primitive> {
    let mut mappings: Vec<extensions::Mapping> = Vec::new();
    for (view, &look) in views.iter().enumerate() {
        let material = materials[look]?.value() as u32;
        match mappings.iter_mut().find(|m| m.material == material) {
            Some(mapping) => mapping.variants.push(view as u32),
            None => mappings.push(extensions::Mapping { material, variants: vec![view as u32] }),
        }
    }
    let variants = (!mappings.is_empty()).then_some(extensions::KhrMaterialsVariants { mappings });
    variants.map(|v| extensions::Primitive { khr_materials_variants: Some(v) })
}
