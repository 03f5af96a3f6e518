//! Strata of build-ups: which layers are drawn as one, and how thick they are.

use super::PriceError;
use super::buildup::{BuildUp, BuildUps, Part};

/// Neighbouring layers of one stratum, in the order of the file.
#[derive(Clone, Debug, PartialEq)]
pub struct BuildUpStratum<'a> {
    /// Name of the stratum as written.
    pub name: &'a str,
    /// Label of its first layer, for messages.
    pub layer: &'a str,
    /// Sum of the layers in mm.
    pub thickness_mm: f64,
}

impl BuildUp {
    /// The strata that solids are drawn with, in the order of the file; neighbouring layers of one name are one stratum.
    ///
    /// # Errors
    /// The label of a layer that has thickness and names no stratum.
    pub fn strata(&self) -> Result<Vec<BuildUpStratum<'_>>, &str> {
        let mut strata: Vec<BuildUpStratum> = Vec::new();
        for layer in self.layers.iter().filter(|layer| layer.thickness_mm > 0.0) {
            let name = layer.stratum.as_deref().ok_or(layer.label.as_str())?;
            match strata.last_mut() {
                Some(last) if last.name == name => last.thickness_mm += layer.thickness_mm,
                _ => strata.push(BuildUpStratum { name, layer: &layer.label, thickness_mm: layer.thickness_mm }),
            }
        }
        Ok(strata)
    }
}

impl BuildUps {
    /// The build-up of an id.
    ///
    /// # Errors
    /// The file has none of that id.
    pub fn named(&self, id: &str) -> Result<&BuildUp, PriceError> {
        self.buildups().iter().find(|b| b.id == id).ok_or_else(|| self.missing(id, "the drawn solids"))
    }

    /// Volume in m3 per unit of a build-up of the layers of one stratum that are given as mass, by the densities of their materials.
    pub fn solid_m3(&self, buildup: &BuildUp, stratum: &str) -> f64 {
        let layers = buildup.layers.iter().filter(|layer| layer.stratum.as_deref() == Some(stratum));
        let volume = |part: &Part| {
            let material = self.materials.iter().find(|m| m.id == part.material)?;
            Some(part.kg? / material.density_kg_m3.filter(|d| *d > 0.0)?)
        };
        layers.flat_map(|layer| &layer.parts).filter_map(volume).sum()
    }
}
