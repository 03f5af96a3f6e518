//! A GLB read back with the crate `gltf`: nodes with their triangles where they stand, z up again.
#![allow(dead_code)]

use serde_json::Value;

/// A node of the first scene.
pub struct GlbNode {
    /// Its name.
    pub name: String,
    /// Its extras.
    pub extras: Value,
    /// Corners of its triangles in m, z up.
    pub triangles: Vec<[[f64; 3]; 3]>,
}

/// A file.
pub struct Model {
    /// Extras of the first scene.
    pub about: Value,
    /// Its nodes.
    pub nodes: Vec<GlbNode>,
    /// Names of the variants of materials.
    pub variants: Vec<String>,
    json: Value,
}

fn extras(extras: &gltf::json::Extras) -> Value {
    extras.as_ref().map_or(Value::Null, |e| serde_json::from_str(e.get()).expect("JSON"))
}

impl Model {
    pub fn read(bytes: &[u8]) -> Model {
        let gltf = gltf::Gltf::from_slice(bytes).expect("a GLB");
        let blob = gltf.blob.clone().unwrap_or_default();
        let scene = gltf.default_scene().expect("a scene");
        let nodes = scene.nodes().map(|node| read_node(&node, &blob)).collect();
        // The crate keeps extensions that it knows no names for only in the text.
        let length = u32::from_le_bytes(bytes[12..16].try_into().expect("four bytes")) as usize;
        let json: Value = serde_json::from_slice(&bytes[20..20 + length]).expect("JSON");
        let names = json["extensions"]["KHR_materials_variants"]["variants"].as_array().cloned().unwrap_or_default();
        let variants = names.iter().map(|v| v["name"].as_str().expect("a name").to_owned()).collect();
        Model { about: extras(scene.extras()), nodes, variants, json }
    }

    /// Names of the materials that are seen in a view, each once.
    pub fn shown_in(&self, view: usize) -> Vec<String> {
        let list = |value: &Value| value.as_array().cloned().unwrap_or_default();
        let primitives = list(&self.json["meshes"]).into_iter().flat_map(|m| list(&m["primitives"]));
        let material = |p: Value| {
            let mappings = list(&p["extensions"]["KHR_materials_variants"]["mappings"]);
            let of_view = mappings.into_iter().find(|m| list(&m["variants"]).iter().any(|v| *v == view));
            of_view.map_or(p["material"].clone(), |m| m["material"].clone()).as_u64().expect("a material")
        };
        let mut shown: Vec<u64> = primitives.map(material).collect();
        shown.sort_unstable();
        shown.dedup();
        shown.iter().map(|m| self.json["materials"][*m as usize]["name"].as_str().expect("a name").to_owned()).collect()
    }
}

fn read_node(node: &gltf::Node, blob: &[u8]) -> GlbNode {
    let matrix = node.transform().matrix().map(|column| column.map(f64::from));
    let place = |p: [f32; 3]| {
        let p = p.map(f64::from);
        let at = [0, 1, 2].map(|r| (0..3).map(|c| matrix[c][r] * p[c]).sum::<f64>() + matrix[3][r]);
        [at[0], -at[2], at[1]]
    };
    let mut triangles = Vec::new();
    for primitive in node.mesh().expect("a mesh").primitives() {
        let reader = primitive.reader(|_| Some(blob));
        let positions: Vec<[f64; 3]> = reader.read_positions().expect("positions").map(place).collect();
        let indices: Vec<u32> = reader.read_indices().expect("indices").into_u32().collect();
        triangles.extend(indices.chunks(3).map(|t| [0, 1, 2].map(|n| positions[t[n] as usize])));
    }
    GlbNode { name: node.name().unwrap_or_default().to_owned(), extras: extras(node.extras()), triangles }
}

impl GlbNode {
    /// Signed volume between its triangles and the origin of the first, m3: that of the solids when they close and face outwards.
    pub fn volume(&self) -> f64 {
        let Some([origin, ..]) = self.triangles.first() else { return 0.0 };
        let sub = |p: [f64; 3]| [0, 1, 2].map(|a| p[a] - origin[a]);
        let six = |t: &[[f64; 3]; 3]| {
            let [a, b, c] = t.map(sub);
            a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) + a[2] * (b[0] * c[1] - b[1] * c[0])
        };
        self.triangles.iter().map(six).sum::<f64>() / 6.0
    }

    /// Lowest and highest coordinates.
    pub fn bounds(&self) -> [[f64; 3]; 2] {
        let all = self.triangles.iter().flatten();
        all.fold([[f64::MAX; 3], [f64::MIN; 3]], |[low, high], p| {
            [[0, 1, 2].map(|a| low[a].min(p[a])), [0, 1, 2].map(|a| high[a].max(p[a]))]
        })
    }
}
