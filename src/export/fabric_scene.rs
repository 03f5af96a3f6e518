//! The fabric of a house as a scene: a part for each layer (the components of a style, or the layers of a set of meshes), or a node for
//! each factory part pulled out of its place.

use std::collections::BTreeMap;

use serde_json::{Value, json};

use super::colour::linear;
use super::palette::Palette;
use super::scene::{Grain, MaterialLook, Part, Scene};
use crate::envelope::{Fabric, FabricLayer, MergeError, PlacedBlock, Solid};
use crate::voxels::{Direction, STOREY_MODULES};

/// Whether layers are one part each, or one for each storey.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Storeys {
    /// One part a layer.
    #[default]
    Together,
    /// One part a layer and storey, named `cladding_0`, `cladding_1`, ...
    Apart,
}

/// How far parts are moved from their places, m.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Exploded {
    /// Upwards for each storey.
    pub storey_m: f64,
    /// Outwards in plan, away from the middle of the house along the axis in which the part lies farther out.
    pub outward_m: f64,
}

impl Default for Exploded {
    /// 2 m a storey, 1.5 m outwards.
    fn default() -> Self {
        Exploded { storey_m: 2.0, outward_m: 1.5 }
    }
}

/// The storey of a block: that of its voxel, roofs with the plate they stand on.
fn storey(block: &PlacedBlock) -> i32 {
    block.voxel[2].max(0) / STOREY_MODULES as i32
}

/// The scene of a house: parts named like layers with the volume they hold in their extras, in the order of layers. A layer whose
/// meshes overlap is shown piece by piece and says so.
///
/// # Errors
/// When blocks of a component overlap.
pub fn from_fabric(fabric: &Fabric, palette: &Palette, storeys: Storeys, extras: Value) -> Result<Scene, MergeError> {
    let group = |b: &PlacedBlock| match storeys {
        Storeys::Together => (b.layer, 0),
        Storeys::Apart => (b.layer, storey(b)),
    };
    let solids = fabric.gather_groups(group)?;
    let stretch: f64 = fabric.scale.iter().product();
    let parts = solids
        .iter()
        .map(|((layer, storey), gathered)| {
            let FabricLayer { name: own, component, .. } = &fabric.layers[*layer as usize];
            let name = match storeys {
                Storeys::Together => own.clone(),
                Storeys::Apart => format!("{own}_{storey}"),
            };
            let mut part = part(fabric, &gathered.solid, &name, *layer, [0.0; 3]);
            part.extras = json!({ "component": component.name(), "volume_m3": gathered.solid.volume_m3() * stretch });
            if let Some(overlap) = &gathered.apart {
                part.extras["not_merged"] = json!(overlap.to_string());
            }
            part
        })
        .collect();
    Ok(Scene { materials: materials(fabric, palette), parts, extras, ..Scene::default() })
}

/// A scene with nodes for each factory part, moved apart: `part_of[i]` names the part of block i of the fabric; blocks without one
/// are built on site and stay, as `site.<layer>`. A part that faces somewhere moves there, so that windows stay in their walls. A part of several layers has a node for each, named `<part>.<layer>` and moved alike.
///
/// # Errors
/// When blocks of a part and component overlap.
pub fn from_parts(
    fabric: &Fabric,
    part_of: &[Option<u32>],
    names: impl Fn(u32) -> String,
    facing: impl Fn(u32) -> Option<Direction>,
    palette: &Palette,
    exploded: Exploded,
) -> Result<Scene, MergeError> {
    let mut groups: BTreeMap<(Option<u32>, u32), Vec<&PlacedBlock>> = BTreeMap::new();
    for (block, part) in fabric.placed.iter().zip(part_of) {
        groups.entry((*part, block.layer)).or_default().push(block);
    }
    let shifts = shifts(fabric, part_of, facing, exploded);
    let mut parts = Vec::with_capacity(groups.len());
    for ((number, layer), blocks) in groups {
        let solid = fabric.merge(blocks)?;
        let FabricLayer { name: own, component, .. } = &fabric.layers[layer as usize];
        let owner = number.map_or_else(|| "site".to_owned(), &names);
        let name = format!("{owner}.{own}");
        let shift = number.and_then(|n| shifts.get(&n).copied()).unwrap_or_default();
        let mut node = part(fabric, &solid, &name, layer, shift);
        node.extras = json!({ "part": owner, "component": component.name(), "moved_m": shift });
        parts.push(node);
    }
    Ok(Scene { materials: materials(fabric, palette), parts, ..Scene::default() })
}

/// Where each part goes, m.
fn shifts(
    fabric: &Fabric,
    part_of: &[Option<u32>],
    facing: impl Fn(u32) -> Option<Direction>,
    exploded: Exploded,
) -> BTreeMap<u32, [f64; 3]> {
    // Sums of voxel positions, their number, and the lowest storey.
    let mut sums: BTreeMap<u32, ([i64; 2], i64, i32)> = BTreeMap::new();
    for (block, part) in fabric.placed.iter().zip(part_of) {
        if let Some(part) = part {
            let sum = sums.entry(*part).or_insert(([0; 2], 0, i32::MAX));
            (0..2).for_each(|a| sum.0[a] += i64::from(block.voxel[a]));
            sum.1 += 1;
            sum.2 = sum.2.min(storey(block));
        }
    }
    let outward = |part: u32, (sum, count, storey): ([i64; 2], i64, i32)| {
        let lift = f64::from(storey) * exploded.storey_m;
        if let Some(d) = facing(part) {
            let [dx, dy] = d.step().map(|step| step as f64 * exploded.outward_m);
            return [dx, dy, lift];
        }
        let away = [0, 1].map(|a| sum[a] as f64 / count as f64 - (fabric.shape[a] as f64 - 1.0) / 2.0);
        // A part within a tenth of the half extent of the middle stays over its place: a floor or a roof ridge.
        let share = [0, 1].map(|a| away[a] / (fabric.shape[a] as f64 / 2.0).max(1.0));
        let axis = usize::from(share[1].abs() > share[0].abs());
        let mut shift = [0.0, 0.0, lift];
        if share[axis].abs() > 0.1 {
            shift[axis] = exploded.outward_m * share[axis].signum();
        }
        shift
    };
    sums.into_iter().map(|(part, sum)| (part, outward(part, sum))).collect()
}

/// One material for each layer, in their order.
fn materials(fabric: &Fabric, palette: &Palette) -> Vec<MaterialLook> {
    fabric.layers.iter().map(|layer| layer_material(layer, palette)).collect()
}

/// The material of a layer, named like it: as the set of meshes says, else as its component looks.
pub fn layer_material(layer: &FabricLayer, palette: &Palette) -> MaterialLook {
    let mut material = palette.material(layer.component);
    material.name.clone_from(&layer.name);
    if let Some(look) = &layer.look {
        let srgb = look.srgb.strip_prefix('#').and_then(|hex| u32::from_str_radix(hex, 16).ok());
        let [r, g, b] = srgb.map_or([material.rgba[0], material.rgba[1], material.rgba[2]], linear);
        material.rgba = [r, g, b, look.opacity];
        (material.roughness, material.metallic) = (look.roughness, look.metallic);
        if look.opacity < 1.0 {
            material.grain = Grain::Glass;
        }
    }
    material
}

/// The surface of a layer, moved by `shift` m.
fn part(fabric: &Fabric, solid: &Solid, name: &str, layer: u32, shift: [f64; 3]) -> Part {
    let mut part = Part::new(name, layer as usize);
    part.vertices = solid
        .vertices
        .iter()
        .map(|&v| {
            let at = fabric.metres(v);
            [0, 1, 2].map(|a| at[a] + shift[a])
        })
        .collect();
    part.triangles = solid.triangles().collect();
    part
}
