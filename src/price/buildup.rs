//! Build-ups: what a square metre of wall, roof or floor consists of, without the members of the frame.

use std::path::Path;

use serde::{Deserialize, Serialize};

use super::book::{check_range, check_unit};
use super::error::{expect_head, expect_text, expect_unique, read};
use super::resolved::{Resolved, ResolvedBuildUp, note_source};
use super::thermal::{ThermalLayer, u_value};
use super::{CarbonBook, CarbonItem, PriceBook, PriceError};
use crate::quantities::Unit;

/// A material of the layers.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Material {
    pub(super) id: String,
    conductivity_w_mk: Option<f64>,
    pub(super) density_kg_m3: Option<f64>,
    carbon: Option<String>,
    source: String,
}

/// What a build-up is for: decides the U-value limit.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum BuildUpKind {
    /// Outer wall.
    Wall,
    /// Roof or deck.
    Roof,
    /// Floor to the outside or the ground.
    Floor,
    /// Window or door.
    Opening,
    /// Not part of the thermal envelope.
    Inner,
}

impl BuildUpKind {
    /// Default U-value limit in W/m2K; `None` inside the envelope.
    pub fn u_limit(self) -> Option<f64> {
        match self {
            BuildUpKind::Wall => Some(0.22),
            BuildUpKind::Roof => Some(0.17),
            BuildUpKind::Floor => Some(0.28),
            BuildUpKind::Opening => Some(1.6),
            BuildUpKind::Inner => None,
        }
    }
}

/// A quantity of a price item in one unit of a build-up.
#[derive(Clone, Debug, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct PartPrice {
    /// Item of the price book.
    pub item: String,
    /// Unit of the quantity; must be the unit of the rate.
    pub unit: Unit,
    /// Quantity per unit of the build-up.
    pub per_unit: f64,
}

/// A material within a layer.
#[derive(Clone, Debug, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Part {
    /// Material of the build-up file.
    pub material: String,
    /// Share of the area of the layer.
    pub fraction: f64,
    /// Mass in kg per unit of the build-up where thickness x density does not say it.
    pub kg: Option<f64>,
    /// Where this part is counted instead, such as the frame: then it conducts heat here, but has no mass, price or carbon.
    pub elsewhere: Option<String>,
    /// What it costs.
    #[serde(default)]
    pub price: Vec<PartPrice>,
    /// The part whose price contains this one; without it and without a price, a part that has mass is an error.
    pub price_in: Option<String>,
}

/// A layer, from inside to outside.
#[derive(Clone, Debug, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Layer {
    /// What it is.
    pub label: String,
    /// Thickness in mm; 0 for what lies within another layer.
    pub thickness_mm: f64,
    /// The part of a drawn solid that this layer belongs to, by its component's name; none for what is not drawn as a stratum.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub stratum: Option<String>,
    /// Whether outside air moves through it: it and all layers beyond it then do not insulate.
    #[serde(default)]
    pub ventilated: bool,
    /// Materials beside each other.
    pub parts: Vec<Part>,
}

/// A build-up as written in the file.
#[derive(Clone, Debug, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct BuildUp {
    /// Id, unique in the file.
    pub id: String,
    /// What it is.
    pub description: String,
    /// Unit: m2, m or piece.
    pub unit: Unit,
    /// What it is for.
    pub kind: BuildUpKind,
    /// Inner surface resistance in m2K/W.
    pub rsi: Option<f64>,
    /// Outer surface resistance in m2K/W.
    pub rse: Option<f64>,
    /// U-value of a bought product in W/m2K instead of one from layers.
    pub u_declared: Option<f64>,
    /// Source of the declared U-value.
    pub u_source: Option<String>,
    /// Remark for the reader.
    pub note: Option<String>,
    /// Layers from inside to outside.
    pub layers: Vec<Layer>,
}

#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct FrameUse {
    pub material: crate::quantities::FrameMaterial,
    pub price: String,
    pub carbon: String,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct BuildUpFile {
    schema: String,
    version: String,
    date: String,
    method: String,
    materials: Vec<Material>,
    buildups: Vec<BuildUp>,
    uses: std::collections::BTreeMap<String, String>,
    frame: Vec<FrameUse>,
}

/// The build-up file (`houscaper.buildups/1`): materials with conductivities, build-ups, and which item of the take-off uses which.
#[derive(Debug)]
pub struct BuildUps {
    /// Path it was read from, for messages.
    pub file: String,
    /// Version of the file.
    pub version: String,
    /// Date of the file.
    pub date: String,
    /// How U-values are worked out, in words.
    pub method: String,
    pub(super) materials: Vec<Material>,
    buildups: Vec<BuildUp>,
    uses: std::collections::BTreeMap<String, String>,
    frame: Vec<FrameUse>,
}

impl BuildUps {
    /// Reads the build-ups and checks what can be checked without the books.
    ///
    /// # Errors
    /// Unknown or missing keys, repeated ids, negative numbers, fractions that do not sum to 1, materials that are not in the file.
    pub fn load(path: &Path) -> Result<BuildUps, PriceError> {
        let raw: BuildUpFile = read(path)?;
        let file = path.display().to_string();
        expect_head(&file, "schema", &raw.schema, "houscaper.buildups/1")?;
        expect_unique(&file, raw.materials.iter().map(|m| m.id.as_str()))?;
        expect_unique(&file, raw.buildups.iter().map(|b| b.id.as_str()))?;
        for material in &raw.materials {
            expect_text(&file, &format!("material {}.source", material.id), &material.source)?;
            if material.conductivity_w_mk.is_some_and(|l| !(l.is_finite() && l > 0.0)) {
                let found = format!("{:?}", material.conductivity_w_mk);
                let (key, expected) = (format!("material {}", material.id), "expected a conductivity above 0 or null");
                return Err(PriceError::Value { file, key, found, expected });
            }
            check_range(&file, &format!("material {}", material.id), [material.density_kg_m3.unwrap_or(0.0); 3])?;
        }
        let BuildUpFile { version, date, method, materials, buildups, uses, frame, .. } = raw;
        let this = BuildUps { file, version, date, method, materials, buildups, uses, frame };
        this.buildups.iter().try_for_each(|buildup| this.check(buildup))?;
        Ok(this)
    }

    /// The build-ups in file order.
    pub fn buildups(&self) -> &[BuildUp] {
        &self.buildups
    }

    /// The build-up that an item of the take-off uses.
    ///
    /// # Errors
    /// The item has no use, or its use is not in the file.
    pub fn of_item(&self, item: &str) -> Result<&BuildUp, PriceError> {
        let id = self.uses.get(item).ok_or_else(|| self.missing(&format!("uses.{item}"), "the take-off"))?;
        self.buildups.iter().find(|b| b.id == *id).ok_or_else(|| self.missing(id, &format!("uses.{item}")))
    }

    pub(super) fn of_frame(&self, material: crate::quantities::FrameMaterial) -> Result<&FrameUse, PriceError> {
        let missing = || self.missing(&format!("frame.{}", material.id()), "the take-off");
        self.frame.iter().find(|f| f.material == material).ok_or_else(missing)
    }

    /// Names under `uses`, to check that each is an item.
    pub(super) fn uses(&self) -> impl Iterator<Item = &str> {
        self.uses.keys().map(String::as_str)
    }

    /// Works out one build-up from the books.
    ///
    /// # Errors
    /// A price or factor that is not in its book, or a quantity in another unit than its rate.
    pub fn resolve(
        &self,
        buildup: &BuildUp,
        prices: &PriceBook,
        carbon: &CarbonBook,
    ) -> Result<ResolvedBuildUp, PriceError> {
        let mut rates = Resolved { energy_mj: Some(0.0), ..Resolved::default() };
        for layer in &buildup.layers {
            for part in layer.parts.iter().filter(|part| part.elsewhere.is_none()) {
                let key = format!("buildup {}, layer \"{}\"", buildup.id, layer.label);
                self.add_prices(&key, part, prices, &mut rates)?;
                self.add_carbon(&key, layer, part, carbon, &mut rates)?;
            }
        }
        Ok(ResolvedBuildUp {
            id: buildup.id.clone(),
            description: buildup.description.clone(),
            unit: buildup.unit,
            kind: buildup.kind,
            thickness_mm: buildup.layers.iter().map(|layer| layer.thickness_mm).sum(),
            u_w_m2k: self.u_value(buildup),
            rates,
        })
    }

    pub(super) fn add_prices(
        &self,
        key: &str,
        part: &Part,
        book: &PriceBook,
        rates: &mut Resolved,
    ) -> Result<(), PriceError> {
        for price in &part.price {
            let item = book.item(&price.item, key)?;
            check_unit(&self.file, key, &item.id, price.unit, item.unit)?;
            rates.buy(item, price.per_unit);
        }
        Ok(())
    }

    pub(super) fn add_carbon(
        &self,
        key: &str,
        layer: &Layer,
        part: &Part,
        book: &CarbonBook,
        rates: &mut Resolved,
    ) -> Result<(), PriceError> {
        let mass_kg = self.part_kg(key, layer, part)?;
        if mass_kg > 0.0 && part.price.is_empty() && part.price_in.is_none() {
            return Err(self.missing(&format!("price or price_in of {}", part.material), key));
        }
        rates.mass_kg += mass_kg;
        let Some((item, quantity)) = self.carbon_quantity(key, layer, part, book)? else { return Ok(()) };
        note_source(rates, &item.id);
        for (sum, factor) in rates.gwp.iter_mut().zip(item.range()) {
            *sum += factor * quantity;
        }
        rates.biogenic += item.biogenic * quantity;
        rates.energy_known_mj += item.energy_mj.unwrap_or(0.0) * quantity;
        rates.energy_mj = rates.energy_mj.zip(item.energy_mj).map(|(sum, energy)| sum + energy * quantity);
        Ok(())
    }

    /// The factors of a part and how many of their units one unit of its build-up holds; none for air.
    pub(super) fn carbon_quantity<'a>(
        &self,
        key: &str,
        layer: &Layer,
        part: &Part,
        book: &'a CarbonBook,
    ) -> Result<Option<(&'a CarbonItem, f64)>, PriceError> {
        let material = self.material(part, key)?;
        let mass_kg = self.part_kg(key, layer, part)?;
        let Some(id) = &material.carbon else {
            let missing = || self.missing(&format!("carbon of {}", material.id), key);
            return if mass_kg == 0.0 { Ok(None) } else { Err(missing()) };
        };
        let item = book.item(id, key)?;
        let volume = layer.thickness_mm / 1000.0 * part.fraction;
        let quantity = match item.unit {
            Unit::Kilogram => mass_kg,
            Unit::SquareMetre => part.fraction,
            Unit::CubicMetre => material.density_kg_m3.filter(|d| *d > 0.0).map_or(volume, |density| mass_kg / density),
            found => {
                let (file, item, expected) = (self.file.clone(), id.clone(), Unit::Kilogram);
                return Err(PriceError::UnitMismatch { file, key: key.into(), item, found, expected });
            }
        };
        Ok(Some((item, quantity)))
    }

    /// Mass in kg that a part has in one unit of its build-up, as written or by thickness, share and density.
    pub(super) fn part_kg(&self, key: &str, layer: &Layer, part: &Part) -> Result<f64, PriceError> {
        let material = self.material(part, key)?;
        let by_density = material.density_kg_m3.map(|density| layer.thickness_mm / 1000.0 * part.fraction * density);
        part.kg.or(by_density).ok_or_else(|| self.missing(&format!("density of {}", material.id), key))
    }

    /// U from the layers, or as declared; layers with a part of unknown conductivity count as no resistance, on the safe side.
    fn u_value(&self, buildup: &BuildUp) -> Option<f64> {
        let (Some(rsi), Some(rse)) = (buildup.rsi, buildup.rse) else { return buildup.u_declared };
        let insulating = buildup.layers.iter().take_while(|layer| !layer.ventilated);
        let layers: Vec<ThermalLayer> = insulating.filter_map(|layer| self.thermal(layer)).collect();
        Some(u_value(rsi, rse, &layers))
    }

    fn thermal(&self, layer: &Layer) -> Option<ThermalLayer> {
        let conductivity = |part: &Part| {
            let material = self.materials.iter().find(|m| m.id == part.material)?;
            Some((part.fraction, material.conductivity_w_mk?))
        };
        let parts = layer.parts.iter().map(conductivity).collect::<Option<Vec<_>>>()?;
        (layer.thickness_mm > 0.0).then_some(ThermalLayer { thickness_m: layer.thickness_mm / 1000.0, parts })
    }

    fn material(&self, part: &Part, key: &str) -> Result<&Material, PriceError> {
        let found = self.materials.iter().find(|m| m.id == part.material);
        found.ok_or_else(|| self.missing(&format!("material {}", part.material), key))
    }

    fn check(&self, buildup: &BuildUp) -> Result<(), PriceError> {
        let key = format!("buildup {}", buildup.id);
        let surfaces = [buildup.rsi, buildup.rse, buildup.u_declared];
        for value in surfaces.into_iter().flatten() {
            check_range(&self.file, &key, [value; 3])?;
        }
        if buildup.u_declared.is_some() {
            expect_text(&self.file, &format!("{key}.u_source"), buildup.u_source.as_deref().unwrap_or(""))?;
        }
        if buildup.kind != BuildUpKind::Inner && buildup.u_declared.is_none() && buildup.rsi.zip(buildup.rse).is_none()
        {
            return Err(self.missing("rsi and rse, or u_declared", &key));
        }
        buildup.layers.iter().try_for_each(|layer| self.check_layer(&key, layer))
    }

    fn check_layer(&self, buildup: &str, layer: &Layer) -> Result<(), PriceError> {
        let key = format!("{buildup}, layer \"{}\"", layer.label);
        check_range(&self.file, &key, [layer.thickness_mm; 3])?;
        for part in &layer.parts {
            self.material(part, &key)?;
            check_range(&self.file, &key, [part.fraction; 3])?;
            check_range(&self.file, &key, [part.kg.unwrap_or(0.0); 3])?;
            part.price.iter().try_for_each(|p| check_range(&self.file, &key, [p.per_unit; 3]))?;
        }
        let sum: f64 = layer.parts.iter().map(|part| part.fraction).sum();
        if layer.thickness_mm > 0.0 && (sum - 1.0).abs() > 1e-9 {
            let expected = "expected fractions of the parts that sum to 1";
            return Err(PriceError::Value { file: self.file.clone(), key, found: sum.to_string(), expected });
        }
        Ok(())
    }

    pub(super) fn missing(&self, item: &str, needed_by: &str) -> PriceError {
        PriceError::Missing { file: self.file.clone(), item: item.into(), needed_by: needed_by.into() }
    }
}
