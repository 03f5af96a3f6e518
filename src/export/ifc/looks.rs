//! Colours of surfaces and materials.

use std::collections::{BTreeMap, BTreeSet};

use super::model::Model;
use super::record::{Id, Record};
use crate::export::MaterialLook;
use crate::export::colour::linear_to_srgb;
use crate::structure::MaterialKind;

/// Surface styles by name.
#[derive(Default)]
pub(super) struct Looks {
    styles: BTreeMap<String, Id>,
    coloured: BTreeSet<Id>,
}

impl Looks {
    /// The surface style of a look.
    pub fn style(&mut self, model: &mut Model, look: &MaterialLook) -> Id {
        if let Some(id) = self.styles.get(&look.name) {
            return *id;
        }
        // 8 bits a channel are what anybody chose; more digits are noise of the way to linear light and back.
        let byte = |c: f64| (linear_to_srgb(c) * 255.0).round() / 255.0;
        let rgb = [look.rgba[0], look.rgba[1], look.rgba[2]].map(byte).map(|c| (c * 1e4).round() / 1e4);
        let colour = Record::new("IFCCOLOURRGB").none().real(rgb[0]).real(rgb[1]).real(rgb[2]);
        let colour = model.step.share(colour);
        let clear = ((1.0 - look.rgba[3]) * 1e4).round() / 1e4;
        let shading = Record::new("IFCSURFACESTYLERENDERING").id(colour).real(clear).nones(6).word("NOTDEFINED");
        let shading = model.step.add(shading);
        let style = Record::new("IFCSURFACESTYLE").text(&look.name).word("BOTH").ids(&[shading]);
        let style = model.step.add(style);
        self.styles.insert(look.name.clone(), style);
        style
    }

    /// Gives an item of a shape its look.
    pub fn on_item(&mut self, model: &mut Model, item: Id, look: &MaterialLook) {
        let style = self.style(model, look);
        model.step.add(Record::new("IFCSTYLEDITEM").id(item).ids(&[style]).text(&look.name));
    }

    /// Gives a material its look, once.
    pub fn on_material(&mut self, model: &mut Model, material: Id, look: &MaterialLook) {
        if !self.coloured.insert(material) {
            return;
        }
        let style = self.style(model, look);
        let item = model.step.add(Record::new("IFCSTYLEDITEM").none().ids(&[style]).text(&look.name));
        let styled = Record::new("IFCSTYLEDREPRESENTATION").id(model.context).text("Style").text("Material");
        let styled = model.step.add(styled.ids(&[item]));
        let shown = Record::new("IFCMATERIALDEFINITIONREPRESENTATION").nones(2).ids(&[styled]).id(material);
        model.step.add(shown);
    }
}

/// The look of a member of the frame.
pub(super) fn of_member(name: &str, kind: MaterialKind) -> MaterialLook {
    match kind {
        MaterialKind::Steel => MaterialLook { metallic: 0.8, ..MaterialLook::matt(name, 0x6F777D, 0.45) },
        MaterialKind::Sawn => MaterialLook::matt(name, 0xD2B27E, 0.85),
        MaterialKind::Glulam => MaterialLook::matt(name, 0xC49A5E, 0.8),
    }
}
