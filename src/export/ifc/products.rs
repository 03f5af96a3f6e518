//! Products made of solids: walls, slabs, roofs, coverings, windows, doors, stairs, railings, foundation.

use std::collections::BTreeMap;

use super::common::{base_quantities, common};
use super::looks::Looks;
use super::materials::Materials;
use super::model::{Model, Property, nano};
use super::pieces::{Key, Shape, Shapes, name_of};
use super::record::{Id, Record, Value};
use super::role::{Role, nth};
use super::shares::Shares;
use super::spatial::{Spatial, element};
use super::{Facts, IfcError, figures};
use crate::parts::{Part, PartKind};
use crate::quantities::Item;
use crate::voxels::{Label, StairKind};

/// A product as written, for what refers to it.
pub(super) struct Written {
    pub id: Id,
    pub placement: Id,
    /// Where its axes begin, m.
    pub at: [f64; 3],
    pub name: String,
}

/// A product with everything that is known of it.
pub(super) struct Product<'a> {
    pub key: Key,
    pub name: &'a str,
    pub part: Option<&'a Part>,
    pub shape: &'a Shape,
    /// Shares of the rows of the take-off.
    pub shares: &'a [(usize, f64)],
    /// The item whose build-up it has: that of its largest share.
    pub item: Item,
    /// Its build-up's mass without members of the frame, kg.
    pub mass_kg: Option<f64>,
}

/// Writes all products.
///
/// # Errors
/// An item without build-up.
pub(super) fn write(
    model: &mut Model,
    looks: &mut Looks,
    facts: &Facts,
    spatial: &Spatial,
    shapes: &Shapes,
    shares: &Shares,
) -> Result<BTreeMap<Key, Written>, IfcError> {
    let mut written = BTreeMap::new();
    let mut types = BTreeMap::new();
    let mut materials = Materials::default();
    for (&key, shape) in &shapes.products {
        let Some(storey) = spatial.storey(key.2) else { continue };
        let name = name_of(facts.cut, facts.marks, key);
        let part = key.0.and_then(|n| facts.cut.parts.get(n as usize));
        let shares: Vec<(usize, f64)> =
            shares.products.get(&key).into_iter().flatten().map(|(row, q)| (*row, *q)).collect();
        let at = lowest(shape);
        let placement = model.placement(Some(storey.placement), [0, 1, 2].map(|i| at[i] - storey.at[i]), None);
        let body = tessellated(model, looks, shape, at);
        let id = record(model, facts, &mut types, [placement, body], key, &name);
        model.contain(id, storey.id, &storey.name);
        let item = largest(facts, &shares).unwrap_or_else(|| key.1.item());
        let palette = &facts.palette;
        let (set, buildup) = materials.of_item(model, looks, &facts.evaluator.books, palette, item)?;
        model.made_of(id, set, &buildup);
        figures::takeoff(model, facts, &name, id, &shares);
        let mass_kg = figures::priced(model, facts, id, &shares);
        let product = Product { key, name: &name, part, shape, shares: &shares, item, mass_kg };
        common(model, facts, id, &product);
        base_quantities(model, facts, id, &product);
        about(model, facts, id, &product);
        written.insert(key, Written { id, placement, at, name });
    }
    cover(model, &written);
    Ok(written)
}

/// Smallest coordinates, m.
fn lowest(shape: &Shape) -> [f64; 3] {
    let all = shape.bodies.iter().flat_map(|body| &body.vertices);
    let low = all.fold([f64::INFINITY; 3], |low, v| [0, 1, 2].map(|i| low[i].min(v[i])));
    low.map(nano)
}

/// A set of triangles for each body, in its colour.
fn tessellated(model: &mut Model, looks: &mut Looks, shape: &Shape, at: [f64; 3]) -> Id {
    let mut items = Vec::new();
    for body in &shape.bodies {
        let points: Vec<[f64; 3]> = body.vertices.iter().map(|v| [0, 1, 2].map(|i| nano(v[i] - at[i]))).collect();
        let points = model.step.add(Record::new("IFCCARTESIANPOINTLIST3D").points(&points));
        let faces = Record::new("IFCTRIANGULATEDFACESET").id(points).none().flag(body.closed);
        let faces = model.step.add(faces.triangles(&body.triangles).none());
        looks.on_item(model, faces, &body.look);
        items.push(faces);
    }
    model.shape(model.body, ["Body", "Tessellation"], &items)
}

/// The item of the largest share that has a build-up of its own.
fn largest(facts: &Facts, shares: &[(usize, f64)]) -> Option<Item> {
    let surfaces = shares.iter().filter(|(row, q)| !facts.rows[*row].item.is_frame() && *q > 0.0);
    surfaces.max_by(|a, b| a.1.total_cmp(&b.1).then(b.0.cmp(&a.0))).map(|(row, _)| facts.rows[*row].item)
}

/// The entity with its type, where it is a part that has a type mark.
fn record(
    model: &mut Model,
    facts: &Facts,
    types: &mut BTreeMap<String, Id>,
    shape: [Id; 2],
    key: Key,
    name: &str,
) -> Id {
    let part = key.0.and_then(|n| facts.cut.parts.get(n as usize));
    let class = key.1.class(part.map(|p| p.kind));
    let own = part.filter(|p| key.1.is_part(p.kind));
    let object = class.object.or(own.map(|p| p.kind.name()));
    let note = note(facts, key, own);
    let record = element(model, class.entity, "product", [Some(name), note.as_deref(), object, Some(name)], shape);
    let [length, height] = own.map_or([None; 2], |p| [p.length_mm, p.height_mm].map(|mm| Some(nano(mm / 1e3))));
    let predefined = match key.1 {
        Role::Stair => stair(facts, key.0),
        _ => class.predefined,
    };
    let record = match key.1 {
        Role::Window | Role::Door => {
            let record = record.maybe_real(height).maybe_real(length).word(predefined);
            record.word("NOTDEFINED").none()
        }
        _ => record.word(predefined),
    };
    let id = model.step.add(record);
    if let (Some(_), Some(mark)) = (own, key.0.and_then(|n| facts.marks.of_type.get(n as usize))) {
        // Both hands are of one type.
        let mark = mark.trim_end_matches('m');
        let named = format!("{} {mark}", class.entity);
        let kind = *types.entry(named.clone()).or_insert_with(|| {
            let record = model.root(&format!("{}TYPE", class.entity), ["type", &named], Some(mark), None);
            let record = record.nones(3).text(mark).maybe_text(object).word(predefined);
            let record = match key.1 {
                Role::Window | Role::Door => record.word("NOTDEFINED").nones(2),
                _ => record,
            };
            model.step.add(record)
        });
        model.of_type(id, kind, &named);
    }
    id
}

/// What a reader is told in words.
fn note(facts: &Facts, key: Key, own: Option<&Part>) -> Option<String> {
    match (own, key.0) {
        (Some(p), Some(n)) => {
            let mark = facts.marks.of_type.get(n as usize)?;
            Some(format!("{} of type {mark}", p.kind.name().replace('_', " ")))
        }
        (None, Some(n)) => {
            Some(format!("{} of part {}", key.1.name().replace('_', " "), facts.marks.piece.get(n as usize)?))
        }
        _ => Some(format!("{}, built on site", key.1.name().replace('_', " "))),
    }
}

/// Predefined type of a stair.
fn stair(facts: &Facts, part: Option<u32>) -> &'static str {
    let stairs = facts.house.stairs.iter().enumerate();
    let own = stairs.filter(|(n, _)| part.is_some() && nth(facts.cut, &[PartKind::Stair], *n) == part);
    match own.map(|(_, s)| s.kind).next() {
        Some(StairKind::Straight) => "STRAIGHT_RUN_STAIR",
        Some(StairKind::UTurn) => "HALF_TURN_STAIR",
        None => "NOTDEFINED",
    }
}

/// What only Houscaper says of a part: marks, volume, mass.
fn about(model: &mut Model, facts: &Facts, id: Id, product: &Product) {
    let mut list = Vec::new();
    let text = |name: &str, text: &str| Property::new(name, Value::Text("IFCIDENTIFIER", text.into()));
    if let (Some(part), Some(n)) = (product.part, product.key.0.map(|n| n as usize)) {
        list.extend(facts.marks.piece.get(n).map(|mark| text("PieceMark", mark)));
        list.extend(facts.marks.of_type.get(n).map(|mark| text("TypeMark", mark)));
        list.push(Property::label("PartKind", part.kind.name()));
    }
    if let Some(volume) = product.shape.volume_m3 {
        let volume = Property::new("SolidVolume", Value::Real("IFCVOLUMEMEASURE", volume));
        list.push(volume.note("of the solids drawn; layers that hold members of the frame are drawn through"));
    }
    if let Some(kg) = product.mass_kg {
        list.push(Property::new("MassWithoutFrame", Value::Real("IFCMASSMEASURE", kg)).note("by the build-up"));
    }
    if let (Role::Window | Role::Door, Some(n)) = (product.key.1, product.key.0) {
        let kinds = [PartKind::Window, PartKind::Door];
        let openings = facts.details.reading.openings.iter().enumerate();
        let opening = openings.filter(|(at, _)| nth(facts.cut, &kinds, *at) == Some(n)).map(|(at, o)| (at, *o)).next();
        if let Some((at, opening)) = opening {
            let number = Property::new("Opening", Value::Count("IFCINTEGER", at as i64));
            list.push(number.note("number in the house's list of openings, as in takeoff.json"));
            if opening.label == Label::Window {
                let glass = opening.glass_area_m2(&facts.house.voxels.module);
                list.push(Property::new("GlassArea", Value::Real("IFCAREAMEASURE", nano(glass))));
            }
        }
    }
    model.properties("Houscaper_Part", id, list);
}

/// Soffits, copings and plinths cover what they are fixed to.
fn cover(model: &mut Model, written: &BTreeMap<Key, Written>) {
    for (key, covering) in written {
        let hosts: &[Role] = match key.1 {
            Role::Soffit => &[Role::Floor],
            Role::Coping => &[Role::Parapet, Role::Wall, Role::Roof, Role::Deck],
            Role::Plinth => &[Role::Footing, Role::Ground],
            Role::Paving => &[Role::Ground],
            _ => continue,
        };
        let host = hosts.iter().find_map(|role| written.get(&(key.0, *role, key.2)));
        let Some(host) = host else { continue };
        let relation = model.root("IFCRELCOVERSBLDGELEMENTS", ["covers", &covering.name], None, None);
        model.step.add(relation.id(host.id).ids(&[covering.id]));
    }
}
