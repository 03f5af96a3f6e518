//! `Pset_*Common` and `Qto_*BaseQuantities` of the products made of solids.

use super::model::{Model, Property, Quantity, nano};
use super::products::Product;
use super::record::{Id, Value};
use super::role::Role;
use super::{Facts, figures};
use crate::parts::Part;
use crate::quantities::Item;

/// What the model knows of a product in the properties that IFC4 names; what it does not know, as fire ratings, stays out.
pub(super) fn common(model: &mut Model, facts: &Facts, id: Id, product: &Product) {
    let role = product.key.1;
    let (set, loads) = match role {
        Role::Wall => ("Pset_WallCommon", true),
        Role::Parapet => ("Pset_WallCommon", false),
        Role::Floor | Role::Deck | Role::Ground => ("Pset_SlabCommon", true),
        Role::Footing => ("Pset_FootingCommon", true),
        Role::Roof => ("Pset_RoofCommon", false),
        Role::Window => ("Pset_WindowCommon", false),
        Role::Door => ("Pset_DoorCommon", false),
        Role::Stair => ("Pset_StairCommon", false),
        Role::Railing => ("Pset_RailingCommon", false),
        Role::Soffit | Role::Plinth | Role::Paving | Role::Coping => ("Pset_CoveringCommon", false),
        Role::Gutter => return,
    };
    let mark = product.key.0.and_then(|n| facts.marks.of_type.get(n as usize));
    let reference = mark.filter(|_| product.part.is_some_and(|p| role.is_part(p.kind)));
    let reference = reference.map_or(product.name, String::as_str);
    let mut list = vec![Property::new("Reference", Value::Text("IFCIDENTIFIER", reference.into()))];
    if role == Role::Stair {
        // A module of the grid is three steps.
        let [run, _, rise] = facts.house.voxels.module.size_m;
        let steps = Value::Count("IFCCOUNTMEASURE", 3 * crate::voxels::STOREY_MODULES as i64);
        list.push(Property::new("NumberOfRiser", steps.clone()));
        list.push(Property::new("NumberOfTreads", steps));
        list.push(Property::new("RiserHeight", Value::Real("IFCPOSITIVELENGTHMEASURE", nano(rise / 3.0))));
        list.push(Property::new("TreadLength", Value::Real("IFCPOSITIVELENGTHMEASURE", nano(run / 3.0))));
    }
    if role != Role::Footing {
        let inside = matches!(role, Role::Floor | Role::Stair)
            || role == Role::Railing && product.part.is_some_and(|p| p.kind == crate::parts::PartKind::Stair);
        list.push(Property::new("IsExternal", Value::Flag(!inside)));
    }
    let u = facts.evaluator.rates.rows[product.item as usize].u_w_m2k;
    if u > 0.0 && !matches!(role, Role::Stair | Role::Railing | Role::Footing) {
        let u = Property::new("ThermalTransmittance", Value::Real("IFCTHERMALTRANSMITTANCEMEASURE", u));
        list.push(u.note(&format!("of the build-up, with its frame: {}", facts.evaluator.books.buildups.version)));
    }
    if loads || role == Role::Parapet {
        list.push(Property::new("LoadBearing", Value::Flag(loads)));
    }
    model.properties(set, id, list);
}

/// The quantities that IFC4 names. Those that come from the take-off are sums of the product's shares, so that over all products they sum
/// to its rows.
pub(super) fn base_quantities(model: &mut Model, facts: &Facts, id: Id, product: &Product) {
    let sum = |items: &[Item]| figures::sum(facts, product.shares, |item| items.contains(&item));
    let volume = product.shape.volume_m3.map(|m3| Quantity::new("VOLUME", "NetVolume", m3));
    let area = |name: &str, m2: f64| (m2 != 0.0).then(|| Quantity::new("AREA", name, m2));
    let length = |name: &str, m: f64| (m > 0.0).then(|| Quantity::new("LENGTH", name, nano(m)));
    let sized =
        |of: fn(&Part) -> f64| product.part.filter(|p| product.key.1.is_part(p.kind)).map_or(0.0, |p| of(p) / 1e3);
    let facade = [Item::Wall, Item::WallBothSides, Item::Band, Item::Parapet];
    let (set, list): (&str, Vec<Option<Quantity>>) = match product.key.1 {
        Role::Wall | Role::Parapet => {
            let net = sum(&facade);
            let openings: f64 = openings_m2(facts, product);
            let list = vec![
                length("Length", sized(|p| p.length_mm)),
                length("Width", sized(|p| p.width_mm)),
                length("Height", sized(|p| p.height_mm)),
                area("GrossSideArea", net + openings),
                area("NetSideArea", net),
                volume,
            ];
            ("Qto_WallBaseQuantities", list)
        }
        Role::Floor | Role::Deck | Role::Ground => {
            let net = sum(&[Item::InnerFloor, Item::Deck, Item::FlatRoof, Item::Ground]);
            ("Qto_SlabBaseQuantities", vec![area("NetArea", net), volume])
        }
        Role::Roof => {
            let list = [Item::PitchedRoof, Item::FlatRoof, Item::Deck, Item::InnerFloor, Item::Overhang];
            ("Qto_RoofBaseQuantities", vec![area("NetArea", sum(&list))])
        }
        Role::Soffit | Role::Plinth | Role::Paving | Role::Coping => {
            let net = sum(&[Item::Soffit, Item::Plinth, Item::Deck]);
            ("Qto_CoveringBaseQuantities", vec![area("NetArea", net)])
        }
        Role::Footing => {
            let beam = Quantity::new("LENGTH", "Length", sum(&[Item::PerimeterBeam]));
            ("Qto_FootingBaseQuantities", vec![Some(beam).filter(|b| b.value > 0.0), volume])
        }
        Role::Window | Role::Door => {
            let [wide, high] = [sized(|p| p.length_mm), sized(|p| p.height_mm)];
            let own = match product.key.1 {
                Role::Window => sum(&[Item::Window]),
                _ => wide * high,
            };
            let list = vec![length("Width", wide), length("Height", high), area("Area", own)];
            (if product.key.1 == Role::Window { "Qto_WindowBaseQuantities" } else { "Qto_DoorBaseQuantities" }, list)
        }
        Role::Railing | Role::Gutter => {
            let own = Quantity::new("LENGTH", "Length", sum(&[Item::Railing, Item::Gutter]));
            let railing = product.key.1 == Role::Railing;
            let set = if railing { "Qto_RailingBaseQuantities" } else { "Qto_PipeSegmentBaseQuantities" };
            (set, vec![Some(own).filter(|q| q.value > 0.0)])
        }
        // IFC4 has quantities of flights only.
        Role::Stair => return,
    };
    let list: Vec<Quantity> = list.into_iter().flatten().collect();
    model.quantities(set, product.name, id, &list);
}

/// The openings in a wall panel, m2, as built.
fn openings_m2(facts: &Facts, product: &Product) -> f64 {
    let Some(part) = product.part.filter(|p| product.key.1.is_part(p.kind)) else { return 0.0 };
    let [along, up] = [facts.cut.module_m[usize::from(part.axis)], facts.cut.module_m[2]];
    facts.cut.openings_of(part).iter().map(|o| f64::from(o.width) * along * o.height_modules() * up).sum()
}
