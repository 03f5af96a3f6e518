//! Project, site, building and storeys.

use std::collections::BTreeMap;

use super::model::{Model, Property, Quantity, nano};
use super::record::{Id, Record, Value};
use super::{Facts, figures};
use crate::brief::Objective;
use crate::voxels::STOREY_MODULES;

/// The spatial structure.
pub(super) struct Spatial {
    pub building: Id,
    /// Storeys by level: entity, its placement, its height above the ground in m, its name.
    storeys: BTreeMap<u16, Storey>,
}

/// A storey as written.
pub(super) struct Storey {
    pub id: Id,
    pub placement: Id,
    pub name: String,
    /// Where its axes begin, m.
    pub at: [f64; 3],
}

impl Spatial {
    /// Writes project, site, building and a storey for each floor plate. Heights count from the slab top of the ground floor, which is ground
    /// level. The site has no place on earth: nothing says where it is.
    pub fn new(model: &mut Model, facts: &Facts) -> Spatial {
        let project = model.root("IFCPROJECT", ["project", ""], Some(facts.name), Some(&facts.evaluator.brief.name));
        let project = project.nones(3).ids(&[model.context]).id(model.units);
        let project = model.step.add(project);
        let ground = model.placement(None, [0.0; 3], None);
        let site = model.root("IFCSITE", ["site", ""], Some("Site"), None).none().id(ground).nones(2);
        let site = model.step.add(site.word("ELEMENT").nones(5));
        let origin = facts.house.voxels.origin_m;
        let place = model.placement(Some(ground), origin, None);
        let building = model.root("IFCBUILDING", ["building", ""], Some(facts.name), None).none().id(place).nones(2);
        let building = model.step.add(building.word("ELEMENT").nones(3));
        let mut storeys = BTreeMap::new();
        for (level, name) in levels(facts) {
            let z = nano(level as f64 * STOREY_MODULES as f64 * facts.house.voxels.module.size_m[2]);
            let placement = model.placement(Some(place), [0.0, 0.0, z], None);
            let key = level.to_string();
            let storey = model.root("IFCBUILDINGSTOREY", ["storey", &key], Some(&name), None).none().id(placement);
            let id = model.step.add(storey.nones(2).word("ELEMENT").real(z));
            let at = [origin[0], origin[1], origin[2] + z];
            storeys.insert(level, Storey { id, placement, name, at });
        }
        let ids: Vec<Id> = storeys.values().map(|s| s.id).collect();
        for (key, whole, parts) in
            [("project", project, vec![site]), ("site", site, vec![building]), ("building", building, ids)]
        {
            let relation = model.root("IFCRELAGGREGATES", ["consists of", key], None, None);
            model.step.add(relation.id(whole).ids(&parts));
        }
        let spatial = Spatial { building, storeys };
        spatial.describe(model, facts);
        spatial
    }

    /// The storey of a level: its own, else the next below.
    pub fn storey(&self, level: u16) -> Option<&Storey> {
        self.storeys.range(..=level).next_back().or_else(|| self.storeys.iter().next()).map(|(_, s)| s)
    }

    /// Areas, heights and figures of building and storeys.
    fn describe(&self, model: &mut Model, facts: &Facts) {
        let reading = &facts.details.reading;
        let area = |name: &str, m2: f64| Quantity::new("AREA", name, m2);
        let [gross, net] =
            [reading.storeys.iter().map(|s| s.gross_area_m2).sum::<f64>(), crate::score::floor_area_m2(reading)];
        let list = [area("GrossFloorArea", gross), area("NetFloorArea", net)];
        model.quantities("Qto_BuildingBaseQuantities", "building", self.building, &list);
        let count = Value::Count("IFCINTEGER", reading.storeys.len() as i64);
        model.properties("Pset_BuildingCommon", self.building, vec![Property::new("NumberOfStoreys", count)]);
        for (level, storey) in &self.storeys {
            let above = Value::Text("IFCIDENTIFIER", format!("level {level}"));
            model.properties("Pset_BuildingStoreyCommon", storey.id, vec![Property::new("Reference", above)]);
            let Some(own) = reading.storeys.iter().find(|s| s.plate_k == usize::from(*level) * STOREY_MODULES) else {
                continue;
            };
            let gross_height = STOREY_MODULES as f64 * facts.house.voxels.module.size_m[2];
            let list = [
                Quantity::new("LENGTH", "GrossHeight", nano(gross_height)),
                area("GrossFloorArea", own.gross_area_m2),
                area("NetFloorArea", own.floor_area_m2),
            ];
            model.quantities("Qto_BuildingStoreyBaseQuantities", &storey.name, storey.id, &list);
        }
        let values = &facts.details.evaluation.values;
        let known = Objective::ALL.iter().filter(|o| values.get(**o).is_finite());
        let figures = known.map(|o| Property::new(o.name(), Value::Real("IFCREAL", values.get(*o))).note(o.title()));
        model.properties("Houscaper_House", self.building, figures.collect());
        figures::of_building(model, facts, self.building);
    }
}

/// Level and name of each storey: every plate, those without rooms above being roofs.
fn levels(facts: &Facts) -> BTreeMap<u16, String> {
    let reading = &facts.details.reading;
    let name = |k: usize| match reading.storeys.iter().find(|s| s.plate_k == k) {
        Some(storey) => format!("Storey {}", storey.index),
        None if k == 0 => "Ground".to_owned(),
        None => format!("Roof level {}", k / STOREY_MODULES),
    };
    let mut levels: BTreeMap<u16, String> =
        reading.plates.iter().map(|p| ((p.k / STOREY_MODULES) as u16, name(p.k))).collect();
    levels.entry(0).or_insert_with(|| name(0));
    levels
}

/// A record of an element: name, tag, object type, place and shape, up to its predefined type.
pub(super) fn element(model: &mut Model, entity: &str, kind: &str, about: [Option<&str>; 4], at: [Id; 2]) -> Record {
    let [name, note, object, tag] = about;
    let record = model.root(entity, [kind, name.unwrap_or_default()], name, note);
    record.maybe_text(object).id(at[0]).id(at[1]).maybe_text(tag)
}
