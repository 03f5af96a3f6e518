//! The looks that OBJ files give their layers by `mtllib` and `usemtl`: the material library's subset that says how a surface looks.

use super::bodies::layer_of;
use super::{Grain, Layer, Look};
use std::collections::BTreeMap;

/// Libraries read so far, and how many polygons of each layer have which material.
#[derive(Debug, Default)]
pub(super) struct Materials {
    libraries: BTreeMap<String, BTreeMap<String, Look>>,
    /// By layer, library and material.
    uses: BTreeMap<(usize, String, String), usize>,
}

impl Materials {
    /// Counts the materials of one OBJ text; `read` gives the text of a library beside it, once for each name.
    pub fn tally(&mut self, text: &str, layers: &[Layer], read: impl Fn(&str) -> Option<String>) {
        let (mut own, mut group, mut material) = (Vec::new(), String::new(), String::new());
        // The layer and the library that polygons go to, until the next group or material.
        let mut counted: Option<Option<(usize, String)>> = None;
        for line in text.lines() {
            let line = line.split('#').next().unwrap_or("").trim();
            let (keyword, rest) = line.split_once(char::is_whitespace).unwrap_or((line, ""));
            match keyword {
                "mtllib" => {
                    let name = rest.trim();
                    if !self.libraries.contains_key(name) {
                        self.libraries.insert(name.into(), read(name).as_deref().map(library).unwrap_or_default());
                    }
                    own.push(name.to_owned());
                }
                "g" | "o" => (group, counted) = (rest.split_whitespace().collect::<Vec<_>>().join(" "), None),
                "usemtl" => (material, counted) = (rest.split_whitespace().collect::<Vec<_>>().join(" "), None),
                "f" => {
                    let target = counted.get_or_insert_with(|| {
                        let layer = layer_of(&group, layers).or_else(|| layer_of(&material, layers))?;
                        let known = |l: &&String| self.libraries.get(*l).is_some_and(|m| m.contains_key(&material));
                        Some((layer, own.iter().find(known)?.clone()))
                    });
                    if let Some((layer, library)) = target {
                        *self.uses.entry((*layer, library.clone(), material.clone())).or_default() += 1;
                    }
                }
                _ => {}
            }
        }
    }

    /// The look of each layer: that of the material most of its polygons have.
    pub fn looks(&self, layers: usize) -> Vec<Option<Look>> {
        let look = |layer: usize| {
            let own = self.uses.iter().filter(|((l, ..), _)| *l == layer);
            let ((_, library, material), _) = own.max_by_key(|(names, n)| (**n, std::cmp::Reverse(*names)))?;
            self.libraries.get(library)?.get(material).cloned()
        };
        (0..layers).map(look).collect()
    }
}

/// The materials of a library: `Kd` as sRGB, `d` or `Tr`, `Pr` or the roughness that `Ns` amounts to, `Pm`.
fn library(text: &str) -> BTreeMap<String, Look> {
    let mut materials: BTreeMap<String, Look> = BTreeMap::new();
    let mut name = None;
    for line in text.lines() {
        let mut words = line.split('#').next().unwrap_or("").split_whitespace();
        let Some(keyword) = words.next() else { continue };
        let rest: Vec<&str> = words.collect();
        if keyword == "newmtl" {
            let plain =
                Look { srgb: "#cccccc".into(), roughness: 0.8, metallic: 0.0, opacity: 1.0, grain: Grain::None };
            let new = rest.join(" ");
            materials.insert(new.clone(), plain);
            name = Some(new);
            continue;
        }
        let numbers: Option<Vec<f64>> = rest.iter().map(|w| w.parse::<f64>().ok().filter(|v| v.is_finite())).collect();
        let Some(look) = name.as_ref().and_then(|n| materials.get_mut(n)) else { continue };
        match (keyword, numbers.as_deref()) {
            ("Kd", Some(&[r, g, b])) => {
                let byte = |v: f64| (v.clamp(0.0, 1.0) * 255.0).round() as u8;
                look.srgb = format!("#{:02x}{:02x}{:02x}", byte(r), byte(g), byte(b));
            }
            ("d", Some(&[opacity])) => look.opacity = opacity.clamp(0.0, 1.0),
            ("Tr", Some(&[clear])) => look.opacity = 1.0 - clear.clamp(0.0, 1.0),
            ("Pr", Some(&[roughness])) => look.roughness = roughness.clamp(0.0, 1.0),
            ("Pm", Some(&[metallic])) => look.metallic = metallic.clamp(0.0, 1.0),
            // Blinn-Phong's exponent as the roughness of a microfacet surface with as wide a highlight.
            ("Ns", Some(&[exponent])) => look.roughness = (2.0 / (exponent.max(0.0) + 2.0)).sqrt().sqrt(),
            _ => {}
        }
    }
    materials
}

#[cfg(test)]
mod tests {
    use super::super::{Component, LayerKind};
    use super::*;

    fn layer(name: &str) -> Layer {
        let component = Some(Component::Cladding);
        Layer { name: name.into(), kind: LayerKind::Solid, overhang: 0.0, component, groups: Vec::new() }
    }

    #[test]
    fn a_layer_looks_as_most_of_its_polygons() {
        let layers = [layer("brick"), layer("glass"), layer("plain")];
        let text = "mtllib a b.mtl\ng brick_o3\nusemtl red clay\nf 1 2 3\nf 1 2 3\nusemtl odd\nf 1 2 3\ng glass\nusemtl pane\nf 1 2 3\n\
                    g plain\nusemtl nowhere\nf 1 2 3\n";
        let mtl = "newmtl red clay\nKd 1 0.5 0 # warm\nPr 0.7\nnewmtl odd\nKd 0 0 0\nnewmtl pane\nKd 0 0 1\nTr 0.75\nNs 98\nPm 2\n";
        let mut materials = Materials::default();
        materials.tally(text, &layers, |name| (name == "a b.mtl").then(|| mtl.to_owned()));
        let looks = materials.looks(3);
        let brick = looks[0].as_ref().map(|l| (l.srgb.as_str(), l.roughness, l.opacity));
        assert_eq!(brick, Some(("#ff8000", 0.7, 1.0)));
        let pane = looks[1].as_ref().map(|l| (l.opacity, l.metallic, (l.roughness * 100.0).round()));
        assert_eq!(pane, Some((0.25, 1.0, 38.0)));
        assert_eq!(looks[2], None, "no library has its material");
        // Without the library nothing is known of any layer.
        let mut none = Materials::default();
        none.tally(text, &layers, |_| None);
        assert_eq!(none.looks(3), [None, None, None]);
    }
}
