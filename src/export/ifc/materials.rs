//! What products are made of: layer sets from the build-ups that are priced and weighed, constituents of bought products.

use std::collections::BTreeMap;

use super::looks::Looks;
use super::model::Model;
use super::record::{Id, Record};
use crate::export::Palette;
use crate::price::{Books, BuildUp, Layer, PriceError};
use crate::quantities::Item;
use crate::tiles::Component;

/// Materials and their sets, each once.
#[derive(Default)]
pub(super) struct Materials {
    plain: BTreeMap<String, Id>,
    sets: BTreeMap<String, Id>,
}

impl Materials {
    /// What an item of the take-off is made of, by its build-up: material set and the build-up's id.
    ///
    /// # Errors
    /// The item has no build-up.
    pub fn of_item(
        &mut self,
        model: &mut Model,
        looks: &mut Looks,
        books: &Books,
        palette: &Palette,
        item: Item,
    ) -> Result<(Id, String), PriceError> {
        let buildup = books.buildups.of_item(item.id())?;
        if let Some(id) = self.sets.get(&buildup.id) {
            return Ok((*id, buildup.id.clone()));
        }
        let layered = buildup.layers.iter().any(|layer| layer.thickness_mm > 0.0);
        let set = if layered {
            self.layers(model, looks, palette, buildup)
        } else {
            self.constituents(model, looks, palette, buildup)
        };
        self.sets.insert(buildup.id.clone(), set);
        Ok((set, buildup.id.clone()))
    }

    fn layers(&mut self, model: &mut Model, looks: &mut Looks, palette: &Palette, buildup: &BuildUp) -> Id {
        let mut ids = Vec::new();
        // Beyond a ventilated layer nothing insulates; IFC asks of each layer whether it is one.
        for layer in buildup.layers.iter().filter(|layer| layer.thickness_mm > 0.0) {
            let material = self.largest(model, looks, palette, layer);
            let thickness = (layer.thickness_mm * 1e3).round() / 1e6;
            let record = Record::new("IFCMATERIALLAYER").maybe_id(material).real(thickness).flag(layer.ventilated);
            let record = record.text(&layer.label).text(&parts_in_words(layer)).maybe_text(layer.stratum.as_deref());
            ids.push(model.step.add(record.none()));
        }
        let note = format!("{}; layers from inside to outside", buildup.description);
        model.step.add(Record::new("IFCMATERIALLAYERSET").ids(&ids).text(&buildup.id).text(&note))
    }

    fn constituents(&mut self, model: &mut Model, looks: &mut Looks, palette: &Palette, buildup: &BuildUp) -> Id {
        let mut ids = Vec::new();
        for layer in &buildup.layers {
            let Some(material) = self.largest(model, looks, palette, layer) else { continue };
            let record = Record::new("IFCMATERIALCONSTITUENT").text(&layer.label).text(&parts_in_words(layer));
            ids.push(model.step.add(record.id(material).none().maybe_text(layer.stratum.as_deref())));
        }
        let set = Record::new("IFCMATERIALCONSTITUENTSET").text(&buildup.id).text(&buildup.description);
        model.step.add(if ids.is_empty() { set.none() } else { set.ids(&ids) })
    }

    /// The material that takes the largest share of a layer; the others stand in the layer's description.
    fn largest(&mut self, model: &mut Model, looks: &mut Looks, palette: &Palette, layer: &Layer) -> Option<Id> {
        let most = layer.parts.iter().fold(None, |most: Option<&crate::price::Part>, part| match most {
            Some(most) if most.fraction >= part.fraction => Some(most),
            _ => Some(part),
        })?;
        if let Some(id) = self.plain.get(&most.material) {
            return Some(*id);
        }
        let id = model.step.add(Record::new("IFCMATERIAL").text(&most.material).nones(2));
        let component = Component::ALL.iter().find(|c| layer.stratum.as_deref() == Some(c.name()));
        if let Some(component) = component {
            looks.on_material(model, id, &palette.material(*component));
        }
        self.plain.insert(most.material.clone(), id);
        Some(id)
    }
}

/// The parts of a layer with their shares of its area.
fn parts_in_words(layer: &Layer) -> String {
    let words = |part: &crate::price::Part| {
        let share = format!("{} {} %", part.material, (part.fraction * 1e4).round() / 1e2);
        match &part.elsewhere {
            Some(place) => format!("{share} (counted with {place})"),
            None => share,
        }
    };
    layer.parts.iter().map(words).collect::<Vec<_>>().join(", ")
}
