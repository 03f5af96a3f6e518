//! Strata of build-ups: which layers are drawn as one, and how thick they are.

use super::buildup::{BuildUp, BuildUps, Layer, Part};
use super::{CarbonBook, PriceBook, PriceError, Resolved};

/// What one unit of a build-up holds of one stratum, without members of the frame.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct StratumMass<'a> {
    /// Name of the stratum as written; empty where no layer of the build-up names one.
    pub name: &'a str,
    /// Sum of its layers in mm.
    pub thickness_mm: f64,
    /// kg per unit of the build-up; the strata of a build-up sum to its mass.
    pub mass_kg: f64,
    /// Its materials and their kg per unit, in the order of the file; air and what is counted elsewhere left out.
    pub materials: Vec<(&'a str, f64)>,
}

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

    /// The strata of a build-up with their masses, in the order of the file. A layer that names no stratum, such as reinforcement or a
    /// film, lies within the layer before it; layers that are wholly counted elsewhere are left out.
    ///
    /// # Errors
    /// A material without density where no mass is written.
    pub fn stratum_masses<'a>(&'a self, buildup: &'a BuildUp) -> Result<Vec<StratumMass<'a>>, PriceError> {
        let mut strata: Vec<StratumMass> = Vec::new();
        for (name, layer) in layers_of_strata(buildup) {
            let at = strata.iter().position(|s| s.name == name).unwrap_or_else(|| {
                strata.push(StratumMass { name, ..StratumMass::default() });
                strata.len() - 1
            });
            let stratum = &mut strata[at];
            stratum.thickness_mm += layer.thickness_mm;
            for part in layer.parts.iter().filter(|part| part.elsewhere.is_none()) {
                let key = format!("buildup {}, layer \"{}\"", buildup.id, layer.label);
                let kg = self.part_kg(&key, layer, part)?;
                stratum.mass_kg += kg;
                match stratum.materials.iter_mut().find(|(material, _)| *material == part.material) {
                    Some((_, sum)) => *sum += kg,
                    None if kg > 0.0 => stratum.materials.push((&part.material, kg)),
                    None => {}
                }
            }
        }
        Ok(strata)
    }

    /// The same strata with what their materials cost, weigh and emit in one unit of the build-up: they sum to the rates of the build-up.
    /// A part whose price is contained in that of another costs nothing here.
    ///
    /// # Errors
    /// A price or factor that is not in its book, or a quantity in another unit than its rate.
    pub fn stratum_rates<'a>(
        &'a self,
        buildup: &'a BuildUp,
        prices: &PriceBook,
        carbon: &CarbonBook,
    ) -> Result<Vec<(&'a str, Resolved)>, PriceError> {
        let mut strata: Vec<(&str, Resolved)> = Vec::new();
        for (name, layer) in layers_of_strata(buildup) {
            let at = strata.iter().position(|s| s.0 == name).unwrap_or_else(|| {
                strata.push((name, Resolved::default()));
                strata.len() - 1
            });
            for part in layer.parts.iter().filter(|part| part.elsewhere.is_none()) {
                let key = format!("buildup {}, layer \"{}\"", buildup.id, layer.label);
                self.add_prices(&key, part, prices, &mut strata[at].1)?;
                self.add_carbon(&key, layer, part, carbon, &mut strata[at].1)?;
            }
        }
        Ok(strata)
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

/// The layers that are not wholly counted elsewhere, each with its stratum: that of the layer before it where it names none.
fn layers_of_strata(buildup: &BuildUp) -> impl Iterator<Item = (&str, &Layer)> {
    let first = buildup.layers.iter().find_map(|layer| layer.stratum.as_deref()).unwrap_or_default();
    let counted = buildup.layers.iter().filter(|l| l.parts.iter().any(|part| part.elsewhere.is_none()));
    counted.scan(first, |name, layer| {
        *name = layer.stratum.as_deref().unwrap_or(*name);
        Some((*name, layer))
    })
}
