//! Binary glTF 2.0: a mesh, a material and a node for each part; views as variants of materials, a deformed shape as a morph target,
//! parts that are not seen at first in scenes of their own.
//!
//! Metres; axes are turned from z up to glTF's y up: (x, y, z) becomes (x, z, -y). Equal scenes give equal bytes.

use std::borrow::Cow;

use gltf_json::accessor::{ComponentType, GenericComponentType, Type};
use gltf_json::buffer::{Stride, Target, View};
use gltf_json::extensions::{mesh as extensions, root, scene::khr_materials_variants::Variant};
use gltf_json::validation::Checked::Valid;
use gltf_json::validation::USize64;
use gltf_json::{Accessor, Extras, Index, Material, Mesh, Node, Root, Value, material, mesh};
use serde_json::json;
use serde_json::value::RawValue;

use super::flat::{FlatPart, flatten};
use super::scene::{MaterialLook, Part, Scene, SceneError};

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

/// The bytes of a `.glb` file.
///
/// Parts whose triangles all vanish in single precision are left out; `extras` stand on the nodes and the scene.
///
/// # Errors
/// When [`Scene::check`] fails, or the file would exceed the format's 4 GiB.
pub fn to_glb(scene: &Scene) -> Result<Vec<u8>, GlbError> {
    scene.check()?;
    let mut writer = Writer::default();
    writer.root.asset.generator = Some(format!("houscaper {}", env!("CARGO_PKG_VERSION")));
    let used: Vec<(&Part, FlatPart)> =
        scene.parts.iter().map(|p| (p, flatten(p))).filter(|(_, f)| !f.triangles.is_empty()).collect();
    let materials = writer.materials(&scene.materials, &used);
    writer.views(&scene.views);
    for (part, flat) in &used {
        writer.part(scene, part, flat, &materials)?;
    }
    let apart: Vec<bool> = used.iter().map(|(p, _)| p.is_apart).collect();
    writer.finish(&scene.extras, &apart)
}

/// The extension that carries the views.
const VARIANTS: &str = "KHR_materials_variants";

/// Buffer sections: vertex attributes with a stride of 12 bytes, then indices of either width.
#[derive(Default)]
struct Writer {
    root: Root,
    sections: [Vec<u8>; 4],
}

const POSITIONS: usize = 0;
const NORMALS: usize = 1;
const SHORT: usize = 2;
const LONG: usize = 3;

impl Writer {
    /// Writes the materials that are used; the answer maps scene indices to file indices.
    fn materials(&mut self, looks: &[MaterialLook], used: &[(&Part, FlatPart)]) -> Vec<Option<Index<Material>>> {
        let mut map = vec![None; looks.len()];
        let is_used = |i: usize| used.iter().any(|(p, _)| p.material == i || p.views.contains(&i));
        for (i, look) in looks.iter().enumerate().filter(|(i, _)| is_used(*i)) {
            map[i] = Some(self.root.push(gltf_material(look)));
        }
        map
    }

    /// Declares the views as variants of materials.
    fn views(&mut self, names: &[String]) {
        if names.is_empty() {
            return;
        }
        let variants = names.iter().map(|name| Variant { name: name.clone() }).collect();
        let extension = root::KhrMaterialsVariants { variants };
        self.root.extensions_used.push(VARIANTS.to_owned());
        self.root.extensions = Some(root::Root { khr_materials_variants: Some(extension) });
    }

    fn part(
        &mut self,
        scene: &Scene,
        part: &Part,
        flat: &FlatPart,
        materials: &[Option<Index<Material>>],
    ) -> Result<(), GlbError> {
        let attributes = [
            (Valid(mesh::Semantic::Positions), self.vectors(POSITIONS, &flat.positions, true)),
            (Valid(mesh::Semantic::Normals), self.vectors(NORMALS, &flat.normals, false)),
        ];
        let primitive = mesh::Primitive {
            attributes: attributes.into_iter().collect(),
            extensions: view_materials(part, materials),
            extras: None,
            indices: Some(self.indices(flat)),
            material: materials[part.material],
            mode: Valid(mesh::Mode::Triangles),
            targets: self.shape(part, flat),
        };
        // Viewers name a shape by this.
        let names = scene.shape.as_ref().filter(|_| primitive.targets.is_some());
        let mesh = self.root.push(Mesh {
            extensions: None,
            extras: extras(&names.map_or(serde_json::Value::Null, |name| json!({ "targetNames": [name] })))?,
            name: Some(part.name.clone()),
            weights: primitive.targets.is_some().then(|| vec![0.0]),
            primitives: vec![primitive],
        });
        let extras = extras(&part.extras)?;
        self.root.push(Node { mesh: Some(mesh), name: Some(part.name.clone()), extras, ..Node::default() });
        Ok(())
    }

    /// The deformed shape as a morph target.
    fn shape(&mut self, part: &Part, flat: &FlatPart) -> Option<Vec<mesh::MorphTarget>> {
        if part.moves.is_empty() {
            return None;
        }
        let moved = |n: &u32| part.moves.get(*n as usize).copied().unwrap_or_default().map(|c| c as f32 + 0.0);
        let moves: Vec<[f32; 3]> = flat.sources.iter().map(moved).collect();
        let positions = Some(self.vectors(POSITIONS, &moves, true));
        Some(vec![mesh::MorphTarget { positions, normals: None, tangents: None }])
    }

    fn vectors(&mut self, section: usize, vectors: &[[f32; 3]], bounds: bool) -> Index<Accessor> {
        let turned: Vec<[f32; 3]> = vectors.iter().map(|&[x, y, z]| [x, z, 0.0 - y]).collect();
        let offset = self.sections[section].len();
        self.sections[section].extend(turned.iter().flatten().flat_map(|c| c.to_le_bytes()));
        let pick = |f: fn(f32, f32) -> f32| {
            let start = turned.first().copied().unwrap_or_default();
            let all = turned.iter().fold(start, |m, v| [f(m[0], v[0]), f(m[1], v[1]), f(m[2], v[2])]);
            bounds.then(|| Value::from(all.map(f64::from).to_vec()))
        };
        let (min, max) = (pick(f32::min), pick(f32::max));
        self.accessor(section, offset, turned.len(), ComponentType::F32, Type::Vec3, [min, max])
    }

    fn indices(&mut self, flat: &FlatPart) -> Index<Accessor> {
        let short = flat.positions.len() <= usize::from(u16::MAX);
        let section = if short { SHORT } else { LONG };
        let bytes = &mut self.sections[section];
        let offset = bytes.len();
        for &v in flat.triangles.iter().flatten() {
            if short {
                bytes.extend((v as u16).to_le_bytes());
            } else {
                bytes.extend(v.to_le_bytes());
            }
        }
        bytes.resize(bytes.len().next_multiple_of(4), 0);
        let component = if short { ComponentType::U16 } else { ComponentType::U32 };
        self.accessor(section, offset, flat.triangles.len() * 3, component, Type::Scalar, [None, None])
    }

    /// The view is named by section here and renumbered once the sections in use are known.
    fn accessor(
        &mut self,
        section: usize,
        offset: usize,
        count: usize,
        component: ComponentType,
        type_: Type,
        [min, max]: [Option<Value>; 2],
    ) -> Index<Accessor> {
        self.root.push(Accessor {
            buffer_view: Some(Index::new(section as u32)),
            byte_offset: (offset > 0).then(|| USize64::from(offset)),
            count: USize64::from(count),
            component_type: Valid(GenericComponentType(component)),
            extensions: None,
            extras: None,
            type_: Valid(type_),
            min,
            max,
            name: None,
            normalized: false,
            sparse: None,
        })
    }

    /// `apart`: by node, whether it has a scene of its own.
    fn finish(mut self, scene_extras: &serde_json::Value, apart: &[bool]) -> Result<Vec<u8>, GlbError> {
        let bin = self.buffer();
        let (own, seen): (Vec<u32>, Vec<u32>) = (0..apart.len() as u32).partition(|&n| apart[n as usize]);
        let nodes: Vec<Index<Node>> = seen.into_iter().map(Index::new).collect();
        // Some readers want every scene to have nodes; a file without a scene is valid too.
        if !self.root.nodes.is_empty() {
            let scene =
                gltf_json::Scene { extensions: None, extras: extras(scene_extras)?, name: None, nodes: nodes.clone() };
            self.root.scene = Some(self.root.push(scene));
            for node in own {
                let name = self.root.nodes[node as usize].name.clone();
                let nodes = nodes.iter().copied().chain([Index::new(node)]).collect();
                self.root.push(gltf_json::Scene { extensions: None, extras: None, name, nodes });
            }
        }
        let json = serde_json::to_vec(&self.root)?;
        container(&json, &bin)
    }

    /// Joins the sections into one buffer and makes their views.
    fn buffer(&mut self) -> Vec<u8> {
        let sections = std::mem::take(&mut self.sections);
        let length: usize = sections.iter().map(Vec::len).sum();
        if length == 0 {
            return Vec::new();
        }
        let buffer = self.root.push(gltf_json::Buffer {
            byte_length: USize64::from(length),
            name: None,
            uri: None,
            extensions: None,
            extras: None,
        });
        let mut view_of = [0; 4];
        let mut bin = Vec::with_capacity(length);
        for (s, bytes) in sections.iter().enumerate().filter(|(_, b)| !b.is_empty()) {
            let vertices = s < SHORT;
            let view = View {
                buffer,
                byte_length: USize64::from(bytes.len()),
                byte_offset: Some(USize64::from(bin.len())),
                byte_stride: vertices.then_some(Stride(12)),
                name: None,
                target: Some(Valid(if vertices { Target::ArrayBuffer } else { Target::ElementArrayBuffer })),
                extensions: None,
                extras: None,
            };
            view_of[s] = self.root.push(view).value() as u32;
            bin.extend_from_slice(bytes);
        }
        for accessor in &mut self.root.accessors {
            accessor.buffer_view = accessor.buffer_view.map(|section| Index::new(view_of[section.value()]));
        }
        bin
    }
}

/// Which material shows in which view; views of one material share a mapping.
fn view_materials(part: &Part, materials: &[Option<Index<Material>>]) -> Option<extensions::Primitive> {
    let mut mappings: Vec<extensions::Mapping> = Vec::new();
    for (view, &look) in part.views.iter().enumerate() {
        let material = materials[look]?.value() as u32;
        match mappings.iter_mut().find(|m| m.material == material) {
            Some(mapping) => mapping.variants.push(view as u32),
            None => mappings.push(extensions::Mapping { material, variants: vec![view as u32] }),
        }
    }
    let variants = (!mappings.is_empty()).then_some(extensions::KhrMaterialsVariants { mappings });
    variants.map(|v| extensions::Primitive { khr_materials_variants: Some(v) })
}

fn gltf_material(look: &MaterialLook) -> Material {
    let alpha = if look.rgba[3] < 1.0 { material::AlphaMode::Blend } else { material::AlphaMode::Opaque };
    Material {
        name: Some(look.name.clone()),
        alpha_mode: Valid(alpha),
        double_sided: look.double_sided,
        pbr_metallic_roughness: material::PbrMetallicRoughness {
            base_color_factor: material::PbrBaseColorFactor(look.rgba.map(|c| c.clamp(0.0, 1.0) as f32)),
            metallic_factor: material::StrengthFactor(look.metallic.clamp(0.0, 1.0) as f32),
            roughness_factor: material::StrengthFactor(look.roughness.clamp(0.0, 1.0) as f32),
            ..Default::default()
        },
        ..Default::default()
    }
}

fn extras(value: &serde_json::Value) -> Result<Extras, serde_json::Error> {
    Ok(if value.is_null() { None } else { Some(RawValue::from_string(serde_json::to_string(value)?)?) })
}

/// Header, JSON chunk padded with spaces, binary chunk (already a multiple of four) when there is one.
fn container(json: &[u8], bin: &[u8]) -> Result<Vec<u8>, GlbError> {
    let json: Cow<[u8]> = match json.len() % 4 {
        0 => Cow::Borrowed(json),
        rest => Cow::Owned([json, &b"   "[..4 - rest]].concat()),
    };
    let total = 12 + 8 + json.len() + if bin.is_empty() { 0 } else { 8 + bin.len() };
    let word = |n: usize| u32::try_from(n).map(u32::to_le_bytes).map_err(|_| GlbError::TooLarge { bytes: total });
    let mut glb = Vec::with_capacity(total);
    glb.extend_from_slice(b"glTF");
    glb.extend(2u32.to_le_bytes());
    glb.extend(word(total)?);
    glb.extend(word(json.len())?);
    glb.extend_from_slice(b"JSON");
    glb.extend_from_slice(&json);
    if !bin.is_empty() {
        glb.extend(word(bin.len())?);
        glb.extend_from_slice(b"BIN\0");
        glb.extend_from_slice(bin);
    }
    Ok(glb)
}
