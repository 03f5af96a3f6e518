//! The document and the buffer of a GLB while they grow.

use gltf_json::accessor::{ComponentType, GenericComponentType, Type};
use gltf_json::buffer::{Stride, Target, View};
use gltf_json::extensions::{root, scene::khr_materials_variants::Variant};
use gltf_json::validation::Checked::Valid;
use gltf_json::validation::USize64;
use gltf_json::{Accessor, Extras, Index, Mesh, Node, Root, Value};
use rustc_hash::FxHashMap;
use serde_json::json;
use serde_json::value::RawValue;

use super::super::flat::{FlatPart, normal_key};
use super::super::scene::MaterialLook;
use super::container::container;
use super::primitive::{Look, primitives};
use super::{GlbError, Materials, gltf_material};

/// The extension that carries the views.
const VARIANTS: &str = "KHR_materials_variants";

/// Buffer sections: vertex attributes with a stride of 12 bytes, then indices of either width.
#[derive(Default)]
pub(super) struct Writer {
    root: Root,
    sections: [Vec<u8>; 4],
    /// Accessors by section and bytes, so that equal arrays are written once.
    known: FxHashMap<(usize, Vec<u8>), Index<Accessor>>,
}

const POSITIONS: usize = 0;
const NORMALS: usize = 1;
const SHORT: usize = 2;
const LONG: usize = 3;

/// Vertices of some primitives and the indices of each.
pub(super) struct Geometry {
    pub positions: Index<Accessor>,
    pub normals: Index<Accessor>,
    pub moves: Option<Index<Accessor>>,
    pub indices: Vec<Index<Accessor>>,
}

/// Where a node stands, already with y up.
pub(super) struct Pose {
    pub translation: [f32; 3],
    pub rotation: Option<[f32; 4]>,
    pub scale: Option<[f32; 3]>,
}

impl Writer {
    pub fn new() -> Writer {
        let mut writer = Writer::default();
        writer.root.asset.generator = Some(format!("houscaper {}", env!("CARGO_PKG_VERSION")));
        writer
    }

    /// Writes the materials that are used; the answer maps scene indices to file indices.
    pub fn materials(
        &mut self,
        looks: &[MaterialLook],
        is_used: impl Fn(usize) -> bool,
    ) -> Vec<Option<Index<gltf_json::Material>>> {
        let mut map = vec![None; looks.len()];
        for (i, look) in looks.iter().enumerate().filter(|(i, _)| is_used(*i)) {
            map[i] = Some(self.root.push(gltf_material(look)));
        }
        map
    }

    /// Declares the views as variants of materials.
    pub fn views(&mut self, names: &[String]) {
        if names.is_empty() {
            return;
        }
        let variants = names.iter().map(|name| Variant { name: name.clone() }).collect();
        let extension = root::KhrMaterialsVariants { variants };
        self.root.extensions_used.push(VARIANTS.to_owned());
        self.root.extensions = Some(root::Root { khr_materials_variants: Some(extension) });
    }

    /// Writes the vertices of some primitives as one array, with the moves of a deformed shape parallel to it, and their indices.
    pub fn geometry(&mut self, flats: &[&FlatPart], moves: Option<&[[f32; 3]]>) -> Geometry {
        let (mut positions, mut normals): (Vec<[f32; 3]>, Vec<[f32; 3]>) = (Vec::new(), Vec::new());
        // Primitives that meet in a plane share the vertices between them; those that move in their own ways do not.
        let mut known: FxHashMap<([u32; 3], [i32; 3]), u32> = FxHashMap::default();
        let mut triangles: Vec<Vec<u32>> = Vec::with_capacity(flats.len());
        for flat in flats {
            let mut place = |(position, normal): (&[f32; 3], &[f32; 3])| {
                let next = positions.len() as u32;
                let key = (position.map(f32::to_bits), normal_key(*normal));
                let vertex = if moves.is_some() { next } else { *known.entry(key).or_insert(next) };
                if vertex == next {
                    positions.push(*position);
                    normals.push(*normal);
                }
                vertex
            };
            let places: Vec<u32> = flat.positions.iter().zip(&flat.normals).map(&mut place).collect();
            triangles.push(flat.triangles.iter().flatten().map(|v| places[*v as usize]).collect());
        }
        let indices = triangles.iter().map(|t| self.indices(t, positions.len())).collect();
        Geometry {
            positions: self.vectors(POSITIONS, &positions, true),
            normals: self.vectors(NORMALS, &normals, false),
            moves: moves.map(|moves| self.vectors(POSITIONS, moves, true)),
            indices,
        }
    }

    /// A mesh of a geometry, each primitive with its material and those of the views; `shape` names a deformed shape.
    pub fn mesh(
        &mut self,
        name: &str,
        geometry: &Geometry,
        looks: &[Look],
        materials: &Materials,
        shape: Option<&str>,
    ) -> Result<Index<Mesh>, GlbError> {
        let primitives = primitives(geometry, looks, materials, true).collect();
        let mesh = Mesh {
            extensions: None,
            extras: extras(&shape.map_or(serde_json::Value::Null, |name| json!({ "targetNames": [name] })))?,
            name: Some(name.to_owned()),
            weights: geometry.moves.map(|_| vec![0.0]),
            primitives,
        };
        Ok(self.root.push(mesh))
    }

    /// Several geometries as one mesh, without deformed shapes.
    pub fn joined(
        &mut self,
        name: &str,
        all: &[(Geometry, Vec<Look>)],
        materials: &Materials,
    ) -> Result<Index<Mesh>, GlbError> {
        let primitives = all.iter().flat_map(|(g, looks)| primitives(g, looks, materials, false)).collect();
        let mesh = Mesh { extensions: None, extras: None, name: Some(name.to_owned()), weights: None, primitives };
        Ok(self.root.push(mesh))
    }

    pub fn node(
        &mut self,
        mesh: Index<Mesh>,
        name: &str,
        about: &serde_json::Value,
        pose: Option<Pose>,
    ) -> Result<Index<Node>, GlbError> {
        let mut node =
            Node { mesh: Some(mesh), name: Some(name.to_owned()), extras: extras(about)?, ..Node::default() };
        if let Some(Pose { translation, rotation, scale }) = pose {
            node.translation = Some(translation);
            node.rotation = rotation.map(gltf_json::scene::UnitQuaternion);
            node.scale = scale;
        }
        Ok(self.root.push(node))
    }

    fn vectors(&mut self, section: usize, vectors: &[[f32; 3]], bounds: bool) -> Index<Accessor> {
        let turned: Vec<[f32; 3]> = vectors.iter().map(|&v| y_up(v)).collect();
        let bytes: Vec<u8> = turned.iter().flatten().flat_map(|c| c.to_le_bytes()).collect();
        let pick = |f: fn(f32, f32) -> f32| {
            let start = turned.first().copied().unwrap_or_default();
            let all = turned.iter().fold(start, |m, v| [f(m[0], v[0]), f(m[1], v[1]), f(m[2], v[2])]);
            bounds.then(|| Value::from(all.map(short).to_vec()))
        };
        let (min, max) = (pick(f32::min), pick(f32::max));
        self.accessor(section, bytes, turned.len(), ComponentType::F32, Type::Vec3, [min, max])
    }

    /// `count` is the number of vertices that they may name.
    fn indices(&mut self, all: &[u32], count: usize) -> Index<Accessor> {
        let is_short = count <= usize::from(u16::MAX);
        let (section, component, bytes): (_, _, Vec<u8>) = if is_short {
            (SHORT, ComponentType::U16, all.iter().flat_map(|v| (*v as u16).to_le_bytes()).collect())
        } else {
            (LONG, ComponentType::U32, all.iter().flat_map(|v| v.to_le_bytes()).collect())
        };
        self.accessor(section, bytes, all.len(), component, Type::Scalar, [None, None])
    }

    /// An accessor of some bytes, or the one that has them already. The view is named by section here and renumbered once the sections in
    /// use are known.
    fn accessor(
        &mut self,
        section: usize,
        bytes: Vec<u8>,
        count: usize,
        component: ComponentType,
        type_: Type,
        [min, max]: [Option<Value>; 2],
    ) -> Index<Accessor> {
        let key = (section, bytes);
        if let Some(known) = self.known.get(&key) {
            return *known;
        }
        let buffer = &mut self.sections[section];
        let offset = buffer.len();
        buffer.extend(&key.1);
        buffer.resize(buffer.len().next_multiple_of(4), 0);
        let index = self.root.push(Accessor {
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
        });
        self.known.insert(key, index);
        index
    }

    /// `seen` are the nodes of the first scene, `scenes` the names and nodes of the others.
    pub fn finish(
        mut self,
        about: &serde_json::Value,
        seen: Vec<Index<Node>>,
        scenes: &[(&str, Vec<Index<Node>>)],
    ) -> Result<Vec<u8>, GlbError> {
        let bin = self.buffer();
        // Some readers want every scene to have nodes; a file without a scene is valid too.
        if !self.root.nodes.is_empty() {
            let first = gltf_json::Scene { extensions: None, extras: extras(about)?, name: None, nodes: seen };
            self.root.scene = Some(self.root.push(first));
            for (name, nodes) in scenes {
                let (name, nodes) = (Some((*name).to_owned()), nodes.clone());
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

/// From z up to y up, without negative zero.
pub(super) fn y_up([x, y, z]: [f32; 3]) -> [f32; 3] {
    [x, z, 0.0 - y]
}

/// The shortest decimal that reads back as the same number in single precision, as which accessors are read.
fn short(value: f32) -> f64 {
    value.to_string().parse().unwrap_or(f64::from(value))
}

fn extras(value: &serde_json::Value) -> Result<Extras, serde_json::Error> {
    Ok(if value.is_null() { None } else { Some(RawValue::from_string(serde_json::to_string(value)?)?) })
}
