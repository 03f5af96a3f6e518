//! Nodes that share meshes: the same geometry at many places, turned and in other colours.

use serde_json::Value;

use super::super::flat::{FlatPart, flatten};
use super::super::scene::{MaterialLook, Part, Scene};
use super::GlbError;
use super::writer::{Pose, Writer, y_up};

/// A geometry with materials for each of its parts.
#[derive(Clone, Debug, PartialEq)]
pub struct SharedMesh {
    /// Name in files.
    pub name: String,
    /// Index into [`Assembly::geometries`].
    pub geometry: usize,
    /// For each part of the geometry its material in each of [`Assembly::views`]; the first is shown at first.
    pub looks: Vec<Vec<usize>>,
}

/// A mesh at a place.
#[derive(Clone, Debug, PartialEq)]
pub struct Instance {
    /// Name in files.
    pub name: String,
    /// Index into [`Assembly::meshes`].
    pub mesh: usize,
    /// Where its origin stands, m, z up.
    pub at_m: [f64; 3],
    /// Quarter turns about z, counter-clockwise seen from above.
    pub turns: u8,
    /// Stretch along x, y, z after turning.
    pub scale: [f64; 3],
    /// What a viewer should be able to show about it.
    pub extras: Value,
}

/// A scene of shared meshes.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Assembly {
    /// Materials, referred to by index.
    pub materials: Vec<MaterialLook>,
    /// Geometries as parts with their own axes; their materials, views and extras are not read.
    pub geometries: Vec<Vec<Part>>,
    /// Geometries in their colours.
    pub meshes: Vec<SharedMesh>,
    /// What stands where.
    pub nodes: Vec<Instance>,
    /// Names of the views.
    pub views: Vec<String>,
    /// About the whole.
    pub extras: Value,
}

/// The bytes of a `.glb` file in which equal geometry stands once.
///
/// # Errors
/// Indices or coordinates as in [`Scene::check`], or more than 4 GiB.
pub fn assembly_to_glb(assembly: &Assembly) -> Result<Vec<u8>, GlbError> {
    let mut writer = Writer::new();
    let mut used = vec![false; assembly.materials.len()];
    assembly.meshes.iter().flat_map(|m| m.looks.iter().flatten()).for_each(|m| used[*m] = true);
    let materials = writer.materials(&assembly.materials, |m| used[m]);
    writer.views(&assembly.views);
    let mut geometries = Vec::with_capacity(assembly.geometries.len());
    for parts in &assembly.geometries {
        // The check of a scene is that of its parts.
        let own = parts.iter().map(|p| Part { material: 0, views: Vec::new(), ..p.clone() }).collect();
        Scene { materials: vec![MaterialLook::matt("any", 0, 1.0)], parts: own, ..Scene::default() }.check()?;
        let flats: Vec<FlatPart> = parts.iter().map(flatten).collect();
        let drawn: Vec<usize> = (0..flats.len()).filter(|&n| !flats[n].triangles.is_empty()).collect();
        let geometry = writer.geometry(&drawn.iter().map(|&n| &flats[n]).collect::<Vec<_>>(), None);
        geometries.push((geometry, drawn));
    }
    let mut meshes = Vec::with_capacity(assembly.meshes.len());
    for SharedMesh { name, geometry, looks } in &assembly.meshes {
        let (geometry, drawn) = &geometries[*geometry];
        let looks: Vec<(usize, &[usize])> = drawn.iter().map(|&n| (looks[n][0], looks[n].as_slice())).collect();
        meshes.push(writer.mesh(name, geometry, &looks, &materials, None)?);
    }
    let mut nodes = Vec::with_capacity(assembly.nodes.len());
    for Instance { name, mesh, at_m, turns, scale, extras } in &assembly.nodes {
        let half = std::f64::consts::FRAC_PI_4 * f64::from(turns % 4);
        // glTF scales before it turns, so that a turn by a quarter exchanges the axes of the plan.
        let [sx, sy, sz] = if turns % 2 == 1 { [scale[1], scale[0], scale[2]] } else { *scale };
        let pose = Pose {
            translation: y_up(at_m.map(|c| c as f32)),
            rotation: (turns % 4 != 0).then(|| [0.0, half.sin() as f32, 0.0, half.cos() as f32]),
            scale: (*scale != [1.0; 3]).then(|| [sx, sz, sy].map(|s| s as f32)),
        };
        nodes.push(writer.node(meshes[*mesh], name, extras, Some(pose))?);
    }
    writer.finish(&assembly.extras, nodes, &[])
}
