//! The frame: each stick as beam, column or member with its true section, extruded along its axis.

use std::collections::BTreeMap;

use super::looks::{self, Looks};
use super::model::{Model, Property, Quantity, nano};
use super::record::{Id, Record, Value};
use super::shares::Shares;
use super::spatial::{Spatial, element};
use super::{Facts, figures};
use crate::export::bar_solid;
use crate::frame::{FrameMember, HouseFrame, Role, axis_offsets, member_offsets};
use crate::structure::checks::{Forming, Shape};
use crate::structure::{CrossSection, SectionOption, StructuralMaterial};
use crate::voxels::{Direction, STOREY_MODULES};

/// Class and predefined type of a role.
fn class(role: Role) -> [&'static str; 2] {
    match role {
        Role::Stud => ["IFCMEMBER", "STUD"],
        Role::CornerPost | Role::Jamb => ["IFCMEMBER", "POST"],
        Role::Plate => ["IFCMEMBER", "PLATE"],
        Role::Lintel => ["IFCBEAM", "LINTEL"],
        Role::Sill => ["IFCMEMBER", "MEMBER"],
        Role::Joist => ["IFCBEAM", "JOIST"],
        Role::Trimmer | Role::Beam | Role::Ridge => ["IFCBEAM", "BEAM"],
        Role::BeamPost => ["IFCCOLUMN", "COLUMN"],
        Role::Rafter | Role::Hip | Role::Valley => ["IFCMEMBER", "RAFTER"],
    }
}

/// What members of one section share.
struct Made {
    profile: Id,
    material: Id,
}

/// Writes the frame, if there is one. A member keeps its number as Tag, and the name it has in `frame.glb`.
pub(super) fn write(model: &mut Model, looks: &mut Looks, facts: &Facts, spatial: &Spatial, shares: &Shares) {
    let Some(frame) = &facts.details.frame else { return };
    let sections = facts.evaluator.sections(facts.choices);
    let offsets = member_offsets(frame, sections.map(|s| facts.evaluator.catalogue.section(s).h));
    let mut made: BTreeMap<(usize, usize), Made> = BTreeMap::new();
    let mut types: BTreeMap<(&str, &str, usize, usize), Id> = BTreeMap::new();
    for (number, member) in frame.members.iter().enumerate() {
        let option = sections[member.group as usize];
        let (section, material) =
            (facts.evaluator.catalogue.section(option), facts.evaluator.catalogue.material(option));
        let name = facts.evaluator.catalogue.option_name(option);
        let up = up(member);
        // The axes of the section as every drawing of the frame has them.
        let bar = bar_solid(&member.ends, up, 1.0, 1.0);
        let [a, b, c] = match bar.vertices.as_slice() {
            [a, b, c, ..] => [*a, *b, *c],
            _ => continue,
        };
        let Some(storey) = spatial.storey(level(facts, member)) else { continue };
        let across = [0, 1, 2].map(|i| b[i] - a[i]);
        let along = {
            let deep = [0, 1, 2].map(|i| c[i] - b[i]);
            cross(across, deep)
        };
        let own = made
            .entry((option.material, option.section))
            .or_insert_with(|| make(model, looks, material, section, &name));
        let beside = beside(frame, member, section, offsets[number]);
        let start = [0, 1, 2].map(|i| member.ends[0][i] + beside[i] - storey.at[i]);
        let placement = model.placement(Some(storey.placement), start, Some([along, across]));
        let items = extrude(model, own.profile, member, section.b);
        for item in &items {
            looks.on_item(model, *item, &looks::of_member(&material.id, material.kind));
        }
        let shape = model.shape(model.body, ["Body", "SweptSolid"], &items);
        let [entity, predefined] = class(member.role);
        let (title, tag) = (format!("{} {number}", member.role.name()), number.to_string());
        let about = [Some(title.as_str()), Some(name.as_str()), Some(member.role.name()), Some(tag.as_str())];
        let record = element(model, entity, "member", about, [placement, shape]).word(predefined);
        let id = model.step.add(record);
        let key = (entity, predefined, option.material, option.section);
        let kind = *types.entry(key).or_insert_with(|| member_type(model, entity, predefined, &name));
        model.of_type(id, kind, &format!("{entity} {predefined} {name}"));
        model.made_of(id, own.material, &name);
        model.contain(id, storey.id, &storey.name);
        describe(model, facts, Described { id, title: &title, number, entity, member, option }, shares);
    }
}

struct Described<'a> {
    id: Id,
    title: &'a str,
    number: usize,
    entity: &'static str,
    member: &'a FrameMember,
    option: SectionOption,
}

fn describe(model: &mut Model, facts: &Facts, own: Described, shares: &Shares) {
    let Described { id, title, number, entity, member, option } = own;
    let (section, material) = (facts.evaluator.catalogue.section(option), facts.evaluator.catalogue.material(option));
    let short = match entity {
        "IFCBEAM" => "Beam",
        "IFCCOLUMN" => "Column",
        _ => "Member",
    };
    let [a, b] = member.ends;
    let plan = (b[0] - a[0]).hypot(b[1] - a[1]);
    let slope = (b[2] - a[2]).abs().atan2(plan);
    let common = vec![
        Property::new("Reference", Value::Text("IFCIDENTIFIER", facts.evaluator.catalogue.option_name(option))),
        Property::new("Slope", Value::Real("IFCPLANEANGLEMEASURE", nano(slope))),
        Property::new("IsExternal", Value::Flag(false)),
        Property::new("LoadBearing", Value::Flag(true)),
    ];
    model.properties(&format!("Pset_{short}Common"), id, common);
    let plies = f64::from(member.plies);
    let volume = member.length_m * plies * section.a;
    let list = [
        Quantity::new("LENGTH", "Length", member.length_m),
        Quantity::new("AREA", "CrossSectionArea", plies * section.a),
        Quantity::new("VOLUME", "NetVolume", volume),
        Quantity::new("WEIGHT", "NetWeight", material.rho * volume),
    ];
    model.quantities(&format!("Qto_{short}BaseQuantities"), title, id, &list);
    let results = facts.details.evaluation.assessment.as_ref().map_or(&[][..], |a| &a.members);
    let mut about = vec![
        Property::new("Member", Value::Count("IFCINTEGER", number as i64))
            .note("number of the stick, as in structure.json"),
        Property::label("Role", member.role.name()),
        Property::label("Material", &material.id),
        Property::label("Section", &section.id),
        Property::new("Plies", Value::Count("IFCINTEGER", i64::from(member.plies))),
    ];
    if let Some(result) = results.get(number).filter(|r| r.utilisation.is_finite()) {
        let used = Property::new("Utilisation", Value::Real("IFCREAL", result.utilisation));
        about.push(used.note("largest ratio of the member's checks over all ultimate combinations; 1 is the limit"));
    }
    model.properties("Houscaper_Member", id, about);
    let shares: Vec<(usize, f64)> = shares.members.get(&number).copied().into_iter().collect();
    figures::takeoff(model, facts, title, id, &shares);
    figures::priced(model, facts, id, &shares);
}

/// Direction of a section's depth. Soles, which no element of the analysis stands for, lie flat.
fn up(member: &FrameMember) -> [f64; 3] {
    let flat = member.chain[0] == member.chain[1];
    let along_x = (member.ends[1][0] - member.ends[0][0]).abs() > 1e-6;
    match member.reference {
        Some(up) => up,
        None if flat && along_x => [0.0, 1.0, 0.0],
        None if flat => [1.0, 0.0, 0.0],
        None => [0.0, 0.0, 1.0],
    }
}

/// From the axis of a stick to the centre line of its timber. Plates, and rafters of a gable, lie in the studs' layer: inwards by what lies
/// outside the studs and half of their own width; plates under the deck or, soles, on the foundation.
fn beside(frame: &HouseFrame, member: &FrameMember, section: &CrossSection, offset: [f64; 3]) -> [f64; 3] {
    let of = |role: Role| axis_offsets().into_iter().find(|o| o.role == role).map_or(0.0, |o| o.layers_m);
    let inward = |wide: f64| inwards(frame, member).map(|d| d * (of(Role::Stud) + 0.5 * wide));
    match member.role {
        Role::Plate => {}
        Role::Rafter => {
            let inward = inward(section.b * f64::from(member.plies));
            return [offset[0] + inward[0], offset[1] + inward[1], offset[2]];
        }
        _ => return offset,
    }
    let sole = member.chain[0] == member.chain[1];
    let flat = up(member)[2].abs() < 0.5;
    let (wide, high) = if flat { (section.h, section.b) } else { (section.b, section.h) };
    let inward = inward(wide);
    let up = if sole { 0.5 * high } else { -(of(Role::Plate) + 0.5 * high) };
    [inward[0], inward[1], up]
}

/// Inwards from the facade that a plate or rafter lies in: from that of the uprights that pass it or end on it; none for one inside.
fn inwards(frame: &HouseFrame, member: &FrameMember) -> [f64; 2] {
    let [a, b] = member.ends;
    let axis = usize::from((b[1] - a[1]).abs() > (b[0] - a[0]).abs());
    let (low, high) = (a[axis].min(b[axis]) - 1e-6, a[axis].max(b[axis]) + 1e-6);
    let meets = |m: &&FrameMember| {
        let [foot, head] = m.ends;
        let (bottom, top) = (foot[2].min(head[2]) - 1e-6, foot[2].max(head[2]) + 1e-6);
        let z = a[2] + (foot[axis] - a[axis]) / (b[axis] - a[axis]) * (b[2] - a[2]);
        m.role.is_vertical()
            && (foot[1 - axis] - a[1 - axis]).abs() < 1e-6
            && (low..=high).contains(&foot[axis])
            && (bottom..=top).contains(&z)
    };
    let bits = frame.members.iter().filter(meets).fold(member.facades, |bits, m| bits | m.facades);
    let across = Direction::ALL.into_iter().filter(|d| bits & (1 << *d as u8) != 0 && d.step()[1 - axis] != 0);
    across.fold([0.0; 2], |sum, d| [sum[0] - d.step()[0] as f64, sum[1] - d.step()[1] as f64])
}

/// Storey level of a stick: floors belong to the slab that they carry, all else to the slab below its lower end.
fn level(facts: &Facts, member: &FrameMember) -> u16 {
    let storey = STOREY_MODULES as f64 * facts.house.voxels.module.size_m[2];
    let low = member.ends[0][2].min(member.ends[1][2]) - facts.house.voxels.origin_m[2];
    let level = match member.role {
        Role::Joist | Role::Trimmer | Role::Beam => (low / storey).round(),
        // Plates lie a little above or below the slab top.
        _ => (low / storey + 0.1).floor(),
    };
    level.max(0.0) as u16
}

/// Profile, material and profile set of a section.
fn make(
    model: &mut Model,
    looks: &mut Looks,
    material: &StructuralMaterial,
    section: &CrossSection,
    name: &str,
) -> Made {
    let base = |entity: &str| Record::new(entity).word("AREA").text(&section.id).none();
    let record = match section.properties.shape {
        Shape::Rectangle { b, h } => base("IFCRECTANGLEPROFILEDEF").real(nano(b)).real(nano(h)),
        Shape::Box { b, h, t, forming } => {
            let [outer, inner] = radii(t, forming);
            let record = base("IFCRECTANGLEHOLLOWPROFILEDEF").real(nano(b)).real(nano(h)).real(nano(t));
            record.real(nano(inner)).real(nano(outer))
        }
        Shape::Tube { d, t, .. } => base("IFCCIRCLEHOLLOWPROFILEDEF").real(nano(0.5 * d)).real(nano(t)),
        Shape::I { b, h, tw, tf, r } => {
            let record = base("IFCISHAPEPROFILEDEF").real(nano(b)).real(nano(h)).real(nano(tw)).real(nano(tf));
            record.real(nano(r)).nones(2)
        }
    };
    let profile = model.step.share(record);
    let stuff = model.step.share(Record::new("IFCMATERIAL").text(&material.id).none().text("frame"));
    looks.on_material(model, stuff, &looks::of_member(&material.id, material.kind));
    let own = Record::new("IFCMATERIALPROFILE").text(name).none().id(stuff).id(profile).nones(2);
    let own = model.step.add(own);
    let set = Record::new("IFCMATERIALPROFILESET").text(name).none().ids(&[own]).none();
    Made { profile, material: model.step.add(set) }
}

/// Outer and inner corner radii of a hollow section: EN 10210-2 Annex A (hot), EN 10219-2 Annex B (cold), as its properties are computed.
fn radii(t: f64, forming: Forming) -> [f64; 2] {
    match forming {
        Forming::Hot => [1.5 * t, t],
        Forming::Cold if t < 6.001e-3 => [2.0 * t, t],
        Forming::Cold if t < 10.001e-3 => [2.5 * t, 1.5 * t],
        Forming::Cold => [3.0 * t, 2.0 * t],
    }
}

/// The plies of a stick side by side, from its first end to its last.
fn extrude(model: &mut Model, profile: Id, member: &FrameMember, width: f64) -> Vec<Id> {
    let up = model.direction([0.0, 0.0, 1.0]);
    let plies = u32::from(member.plies.max(1));
    let solid = |ply: u32| {
        let x = (f64::from(ply) - 0.5 * f64::from(plies - 1)) * width;
        let position = model.axes([x, 0.0, 0.0], None);
        let solid = Record::new("IFCEXTRUDEDAREASOLID").id(profile).id(position).id(up).real(nano(member.length_m));
        model.step.add(solid)
    };
    (0..plies).map(solid).collect()
}

fn member_type(model: &mut Model, entity: &str, predefined: &str, name: &str) -> Id {
    let record =
        model.root(&format!("{entity}TYPE"), ["type", &format!("{entity} {predefined} {name}")], Some(name), None);
    model.step.add(record.nones(5).word(predefined))
}

fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}
