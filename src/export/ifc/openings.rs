//! Openings: what windows and doors fill and walls are voided by.
//!
//! A wall panel's solids have their openings already. IFC4 provides for that: an `IfcOpeningElement` whose shape is a *Reference*
//! representation is not subtracted from its wall but stands for the hole that is there (IFC4 ADD2 TC1, `IfcOpeningElement`). So walls
//! relate to openings, and openings to what fills them, and no program has to cut anything. Some cut all the same (IfcOpenShell 0.9 does):
//! the box of an opening holds nothing of its wall, reveals and sills being part of the window, so that changes nothing.
//!
//! So it is where a style draws the house. A wall drawn as a surface has no thickness to be voided, and nobody says what a set of
//! meshes leaves open: there windows and doors, where they are drawn, fill nothing.

use std::collections::BTreeMap;

use super::Facts;
use super::model::{Model, Quantity, nano};
use super::pieces::Key;
use super::products::Written;
use super::record::{Id, Record};
use super::role::{Role, nth};
use super::spatial::element;
use crate::parts::{PanelOpening, Part, PartKind};
use crate::voxels::{FacadeOpening, Label};

/// Writes the openings of every wall panel that a style draws.
pub(super) fn write(model: &mut Model, facts: &Facts, written: &BTreeMap<Key, Written>) {
    if facts.evaluator.tiling.style.is_none() {
        return;
    }
    for (n, part) in facts.cut.parts.iter().enumerate().filter(|(_, p)| p.kind == PartKind::Wall) {
        let key = (Some(n as u32), Role::Wall, part.level);
        let Some(wall) = written.get(&key) else { continue };
        for panel in facts.cut.openings_of(part) {
            if let Some(opening) = facts.details.reading.openings.get(usize::from(panel.index)) {
                write_one(model, facts, written, wall, part, panel, opening);
            }
        }
    }
}

fn write_one(
    model: &mut Model,
    facts: &Facts,
    written: &BTreeMap<Key, Written>,
    wall: &Written,
    part: &Part,
    panel: &PanelOpening,
    opening: &FacadeOpening,
) {
    let number = nth(facts.cut, &[PartKind::Window, PartKind::Door], usize::from(panel.index));
    let role = if opening.label == Label::Opening { Role::Door } else { Role::Window };
    let filling = written.get(&(number, role, part.level));
    let mark = number.and_then(|n| facts.marks.piece.get(n as usize)).cloned();
    let mark = mark.unwrap_or_else(|| format!("{}.{}", wall.name, panel.index));
    let (name, from_slab) = (format!("{mark}.opening"), facts.evaluator.part_settings().from_slab);
    let boxes = boxes(facts, opening, from_slab);
    let placement = model.placement(Some(wall.placement), [0.0; 3], None);
    let items: Vec<Id> = boxes.iter().map(|b| cuboid(model, *b, wall.at)).collect();
    let shape = model.shape(model.reference, ["Reference", "SweptSolid"], &items);
    let about = [Some(name.as_str()), Some("void that the body of its wall already has"), None, Some(mark.as_str())];
    let record = element(model, "IFCOPENINGELEMENT", "opening", about, [placement, shape]).word("OPENING");
    let id = model.step.add(record);
    let along = opening.along();
    let width = opening.width as f64 * facts.cut.module_m[along];
    let height = panel.height_modules() * facts.cut.module_m[2];
    let depth = facts.cut.wall_mm / 1e3;
    let list = [
        Quantity::new("LENGTH", "Width", nano(width)),
        Quantity::new("LENGTH", "Height", nano(height)),
        Quantity::new("LENGTH", "Depth", nano(depth)),
        Quantity::new("AREA", "Area", nano(width * height)),
        Quantity::new("VOLUME", "Volume", nano(width * height * depth)),
    ];
    model.quantities("Qto_OpeningElementBaseQuantities", &name, id, &list);
    let voids = model.root("IFCRELVOIDSELEMENT", ["voids", &name], None, None);
    model.step.add(voids.id(wall.id).id(id));
    if let Some(filling) = filling {
        let fills = model.root("IFCRELFILLSELEMENT", ["fills", &name], None, None);
        model.step.add(fills.id(id).id(filling.id));
    }
}

/// Low and high corners in m, one box for each run of columns that begin at one height.
fn boxes(facts: &Facts, opening: &FacadeOpening, from_slab: bool) -> Vec<[[f64; 3]; 2]> {
    let voxels = &facts.house.voxels;
    let (size, origin) = (voxels.module.size_m, voxels.origin_m);
    let (along, out) = (opening.along(), opening.facing.step());
    let lower = |n: usize| if from_slab && opening.reaches_slab(voxels, n) { 1.0 } else { 0.5 };
    let mut boxes = Vec::new();
    let mut first = 0;
    while first < opening.width {
        let run = (first..opening.width).take_while(|&n| lower(n) == lower(first)).count();
        let (mut low, mut high) = ([0.0; 3], [0.0; 3]);
        let start = (opening.cell[along] + first) as f64 - 0.5;
        (low[along], high[along]) = (start, start + run as f64);
        let across = 1 - along;
        let side = out[across] as f64;
        let face = opening.cell[across] as f64 + 0.5 * side;
        let inner = face - side * facts.cut.wall_mm / 1e3 / size[across];
        (low[across], high[across]) = (face.min(inner), face.max(inner));
        low[2] = opening.k as f64 - lower(first);
        high[2] = (opening.k + opening.height) as f64 - 0.5;
        boxes.push([low, high].map(|at| [0, 1, 2].map(|a| origin[a] + at[a] * size[a])));
        first += run;
    }
    boxes
}

/// A box as an upright extrusion, seen from `at`.
fn cuboid(model: &mut Model, [low, high]: [[f64; 3]; 2], at: [f64; 3]) -> Id {
    let size = [0, 1, 2].map(|a| nano(high[a] - low[a]));
    let foot = [0.5 * (low[0] + high[0]) - at[0], 0.5 * (low[1] + high[1]) - at[1], low[2] - at[2]];
    let profile = Record::new("IFCRECTANGLEPROFILEDEF").word("AREA").nones(2).real(size[0]).real(size[1]);
    let profile = model.step.share(profile);
    let (position, up) = (model.axes(foot, None), model.direction([0.0, 0.0, 1.0]));
    let solid = Record::new("IFCEXTRUDEDAREASOLID").id(profile).id(position).id(up).real(size[2]);
    model.step.add(solid)
}
