//! What a viewer shows: named parts with one material each, in metres, z up. Every file format and the picture read this.

use serde::{Deserialize, Serialize};
use serde_json::Value;

use super::colour::{linear, linear_to_srgb};

/// How a material looks in close view; files without textures ignore it, the picture draws it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Grain {
    /// Even colour.
    #[default]
    Plain,
    /// Level courses, as of roof tiles.
    Courses,
    /// Boards along x.
    Boards,
    /// Upright boards on a wall.
    Cladding,
    /// Reflects the sky.
    Glass,
}

/// A material as viewers understand it: metallic-roughness, base colour in *linear* light as in glTF.
#[derive(Clone, Debug, PartialEq)]
pub struct MaterialLook {
    /// Name in files, unique in its scene.
    pub name: String,
    /// Base colour and opacity, linear, 0 to 1.
    pub rgba: [f64; 4],
    /// 0 dielectric to 1 metal.
    pub metallic: f64,
    /// 0 mirror to 1 chalk.
    pub roughness: f64,
    /// Whether the back of a face is shown.
    pub double_sided: bool,
    /// Pattern drawn in pictures.
    pub grain: Grain,
}

impl MaterialLook {
    /// An opaque, matt, plain material from an sRGB colour 0xRRGGBB.
    pub fn matt(name: &str, srgb: u32, roughness: f64) -> Self {
        let [r, g, b] = linear(srgb);
        MaterialLook {
            name: name.to_owned(),
            rgba: [r, g, b, 1.0],
            metallic: 0.0,
            roughness,
            double_sided: false,
            grain: Grain::Plain,
        }
    }

    /// The base colour in sRGB, 0 to 255.
    pub fn srgb(&self) -> [u8; 3] {
        [0, 1, 2].map(|c| (linear_to_srgb(self.rgba[c].clamp(0.0, 1.0)) * 255.0).round() as u8)
    }

    /// The same with a pattern.
    pub fn with_grain(mut self, grain: Grain) -> Self {
        self.grain = grain;
        self
    }
}

/// A piece of the scene with one material.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Part {
    /// Name in files: glTF node, OBJ object. Neighbouring parts of one name are one node of as many primitives; the first of them says
    /// what stands in its extras.
    pub name: String,
    /// Index into [`Scene::materials`].
    pub material: usize,
    /// Positions in metres, z up.
    pub vertices: Vec<[f64; 3]>,
    /// Three vertex indices each, counter-clockwise seen from outside.
    pub triangles: Vec<[u32; 3]>,
    /// Anything a viewer should be able to show about the part; `Null` for nothing.
    pub extras: Value,
    /// Its material in each of [`Scene::views`]; empty where all show [`Part::material`].
    pub views: Vec<usize>,
    /// Where the deformed shape moves each vertex, m, parallel to `vertices`; empty for what stays.
    pub moves: Vec<[f64; 3]>,
    /// Not seen at first: pictures and OBJ leave it out, a GLB shows it in a scene of its own beside what is seen.
    pub is_apart: bool,
}

impl Part {
    /// A part without geometry.
    pub fn new(name: &str, material: usize) -> Self {
        Part { name: name.to_owned(), material, ..Part::default() }
    }

    /// Adds a convex planar polygon, counter-clockwise seen from outside, as a fan.
    pub fn polygon(&mut self, corners: &[[f64; 3]]) {
        let first = self.vertices.len() as u32;
        self.vertices.extend_from_slice(corners);
        self.triangles.extend((2..corners.len() as u32).map(|i| [first, first + i - 1, first + i]));
    }

    /// Adds everything of another part's geometry.
    pub fn append(&mut self, other: &Part) {
        let first = self.vertices.len() as u32;
        self.vertices.extend_from_slice(&other.vertices);
        self.triangles.extend(other.triangles.iter().map(|t| t.map(|v| v + first)));
    }

    /// The corner positions of a triangle; `None` when an index is out of range.
    pub fn corners(&self, triangle: [u32; 3]) -> Option<[[f64; 3]; 3]> {
        let at = |i: u32| self.vertices.get(i as usize).copied();
        Some([at(triangle[0])?, at(triangle[1])?, at(triangle[2])?])
    }
}

/// Everything one file or picture shows.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Scene {
    /// Materials, referred to by index.
    pub materials: Vec<MaterialLook>,
    /// Parts in the order they are written.
    pub parts: Vec<Part>,
    /// About the whole: id, price, carbon, unit; `Null` for nothing.
    pub extras: Value,
    /// Names of further views that colour the parts otherwise.
    pub views: Vec<String>,
    /// Name of the deformed shape that [`Part::moves`] belong to.
    pub shape: Option<String>,
}

/// A scene that cannot be written.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum SceneError {
    /// A part refers to a material that is not there.
    #[error("part '{part}' has material {material}, but the scene has {count} materials; add the material first")]
    NoSuchMaterial {
        /// Its name.
        part: String,
        /// The index found.
        material: usize,
        /// Materials in the scene.
        count: usize,
    },
    /// A triangle refers to a vertex that is not there.
    #[error("part '{part}', triangle {triangle}: vertex index out of range (the part has {count} vertices)")]
    NoSuchVertex {
        /// Its name.
        part: String,
        /// Position of the triangle.
        triangle: usize,
        /// Vertices in the part.
        count: usize,
    },
    /// A coordinate is infinite or not a number.
    #[error("part '{part}', vertex {vertex}: coordinate is not finite; check the geometry it came from")]
    NotFinite {
        /// Its name.
        part: String,
        /// Position of the vertex.
        vertex: usize,
    },
}

impl Scene {
    /// Checks indices and coordinates, so that writers and the renderer need not.
    ///
    /// # Errors
    /// Names the first part with a missing material, a missing vertex or a coordinate that is not finite.
    pub fn check(&self) -> Result<(), SceneError> {
        for part in &self.parts {
            check_part(part, self.materials.len())?;
        }
        Ok(())
    }

    /// The parts that are seen at first.
    pub fn seen(&self) -> impl Iterator<Item = &Part> {
        self.parts.iter().filter(|p| !p.is_apart)
    }

    /// The same parts in the materials of a view, by its number.
    pub fn in_view(&self, view: usize) -> Scene {
        let mut scene = self.clone();
        scene.parts.iter_mut().for_each(|p| p.material = p.views.get(view).copied().unwrap_or(p.material));
        scene
    }

    /// Smallest and largest coordinates of what is seen at first, in metres; `None` without vertices.
    pub fn bounds(&self) -> Option<[[f64; 3]; 2]> {
        let mut all = self.seen().flat_map(|p| &p.vertices);
        let first = *all.next()?;
        Some(all.fold([first, first], |[low, high], v| {
            [[0, 1, 2].map(|a| low[a].min(v[a])), [0, 1, 2].map(|a| high[a].max(v[a]))]
        }))
    }
}

fn check_part(part: &Part, materials: usize) -> Result<(), SceneError> {
    let name = || part.name.clone();
    if let Some(&material) = std::iter::once(&part.material).chain(&part.views).find(|m| **m >= materials) {
        return Err(SceneError::NoSuchMaterial { part: name(), material, count: materials });
    }
    let count = part.vertices.len();
    if let Some(triangle) = part.triangles.iter().position(|t| t.iter().any(|&v| v as usize >= count)) {
        return Err(SceneError::NoSuchVertex { part: name(), triangle, count });
    }
    match part.vertices.iter().chain(&part.moves).position(|v| v.iter().any(|c| !c.is_finite())) {
        Some(vertex) => Err(SceneError::NotFinite { part: name(), vertex }),
        None => Ok(()),
    }
}
