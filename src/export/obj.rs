//! Wavefront OBJ with its material library: an object for each part, a group for each material, metres, z up.

use std::fmt::Write as _;

use super::colour::linear_to_srgb;
use super::flat::flatten;
use super::scene::{MaterialLook, Scene, SceneError};

/// The text of an OBJ file that refers to `mtl_name`. Vertices are rounded to a hundredth of a millimetre.
///
/// # Errors
/// When [`Scene::check`] fails.
pub fn to_obj(scene: &Scene, mtl_name: &str) -> Result<String, SceneError> {
    scene.check()?;
    let mut text = format!("# houscaper {}\n# unit: metre, up axis: z, right-handed\n", env!("CARGO_PKG_VERSION"));
    let _ = writeln!(text, "mtllib {}", token(mtl_name));
    let mut first = [1, 1];
    for part in scene.seen() {
        let flat = flatten(part);
        let material = token(&scene.materials[part.material].name);
        let _ = writeln!(text, "o {}\ng {material}\nusemtl {material}", token(&part.name));
        for p in &flat.positions {
            let [x, y, z] = p.map(|c| tidy(c, 5));
            let _ = writeln!(text, "v {x} {y} {z}");
        }
        let (normals, of_vertex) = distinct(&flat.normals);
        for n in &normals {
            let [x, y, z] = n.map(|c| tidy(c, 6));
            let _ = writeln!(text, "vn {x} {y} {z}");
        }
        for t in &flat.triangles {
            let [a, b, c] = t.map(|v| format!("{}//{}", v as usize + first[0], of_vertex[v as usize] + first[1]));
            let _ = writeln!(text, "f {a} {b} {c}");
        }
        first = [first[0] + flat.positions.len(), first[1] + normals.len()];
    }
    Ok(text)
}

/// The text of the MTL file. Colours are sRGB as readers expect; `Pr` and `Pm` carry roughness and metalness.
pub fn to_mtl(materials: &[MaterialLook]) -> String {
    let mut text = format!("# houscaper {}\n", env!("CARGO_PKG_VERSION"));
    for look in materials {
        let [r, g, b] = [0, 1, 2].map(|i| linear_to_srgb(look.rgba[i].clamp(0.0, 1.0)));
        let _ = writeln!(text, "newmtl {}\nKd {r:.4} {g:.4} {b:.4}\nKs 0 0 0\nd {}", token(&look.name), look.rgba[3]);
        let _ = writeln!(text, "Pr {}\nPm {}\nillum 2", look.roughness, look.metallic);
    }
    text
}

/// A name without white space, which ends a name in OBJ.
fn token(name: &str) -> String {
    name.split_whitespace().collect::<Vec<_>>().join("_")
}

/// A number at `digits` decimals without trailing zeros or a negative zero.
fn tidy(value: f32, digits: usize) -> String {
    let text = format!("{value:.digits$}");
    let text = text.trim_end_matches('0').trim_end_matches('.');
    if text == "-0" { "0".to_owned() } else { text.to_owned() }
}

/// Normals in order of first use, and for each vertex its place among them.
fn distinct(normals: &[[f32; 3]]) -> (Vec<[f32; 3]>, Vec<usize>) {
    let mut seen = rustc_hash::FxHashMap::default();
    let mut list = Vec::new();
    let of_vertex = normals
        .iter()
        .map(|n| {
            *seen.entry(n.map(f32::to_bits)).or_insert_with(|| {
                list.push(*n);
                list.len() - 1
            })
        })
        .collect();
    (list, of_vertex)
}
