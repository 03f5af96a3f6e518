//! Parts as a table and as JSON, and what a reader wants to know first.

use serde_json::{Value, json};

use super::tables::{Cell, csv};
use crate::parts::{Marks, Masses, Overload, Part, PartKind, Parts, Stock};
use crate::voxels::{Direction, Label};

/// The columns of `parts.csv`. `mass_kg` is the whole part, `frame_kg` the members of the frame in it; `type_count` the number of parts
/// of its type in the house, both hands.
pub const PARTS_COLUMNS: [&str; 16] = [
    "mark",
    "type",
    "kind",
    "storey",
    "direction",
    "x",
    "y",
    "length_mm",
    "width_mm",
    "height_mm",
    "area_m2",
    "mass_kg",
    "frame_kg",
    "openings",
    "opening_sizes",
    "type_count",
];

fn direction(direction: Direction) -> &'static str {
    match direction {
        Direction::East => "east",
        Direction::North => "north",
        Direction::West => "west",
        Direction::South => "south",
    }
}

/// A length in whole tenths of a millimetre; sums of modules carry rounding noise in their last bits.
fn tenth(mm: f64) -> f64 {
    (mm * 10.0).round() / 10.0
}

fn grain(value: f64, per_unit: f64) -> f64 {
    (value * per_unit).round() / per_unit
}

fn opening_sizes(parts: &Parts, part: &Part) -> String {
    let [along, up] = [parts.module_m[usize::from(part.axis)], parts.module_m[2]];
    let size = |o: &crate::parts::PanelOpening| {
        let what = if o.label == Label::Opening { "door" } else { "window" };
        format!("{what} {:.0} x {:.0} mm", f64::from(o.width) * along * 1000.0, o.height_modules() * up * 1000.0)
    };
    parts.openings_of(part).iter().map(size).collect::<Vec<_>>().join("; ")
}

/// Text of `parts.csv`: one row a part. `storey` is the plate that the part stands on or lies in, 0 = foundation.
pub fn parts_csv(parts: &Parts, marks: &Marks, masses: &Masses) -> String {
    csv(
        &PARTS_COLUMNS,
        parts.parts.iter().enumerate().map(|(n, p)| {
            let text = |t: &str| Cell::Text(t.to_owned());
            vec![
                text(&marks.piece[n]),
                text(&marks.of_type[n]),
                text(p.kind.name()),
                Cell::Count(i64::from(p.level)),
                p.facing.map_or(Cell::Empty, |d| text(direction(d))),
                Cell::Count(i64::from(p.first[0])),
                Cell::Count(i64::from(p.first[1])),
                Cell::Number(tenth(p.length_mm)),
                Cell::Number(tenth(p.width_mm)),
                Cell::Number(tenth(p.height_mm)),
                Cell::Number(grain(p.area_m2, 1e4)),
                Cell::Number(grain(masses.part_kg[n], 1e2)),
                Cell::Number(grain(masses.frame_kg[n], 1e2)),
                Cell::Count(parts.openings_of(p).len() as i64),
                text(&opening_sizes(parts, p)),
                Cell::Count(i64::from(marks.count[n])),
            ]
        }),
    )
}

/// What a reader wants to know first: pieces and distinct ones, the heaviest and the longest part.
#[derive(Clone, Debug, PartialEq)]
pub struct PartsSummary {
    /// Parts in all.
    pub parts: usize,
    /// Distinct ones up to congruence and mirror.
    pub distinct: usize,
    /// Parts by kind, in the order of [`PartKind::ALL`].
    pub by_kind: [usize; PartKind::ALL.len()],
    /// Mark and kg of the heaviest part.
    pub heaviest: Option<(String, f64)>,
    /// Mark and mm of the longest panel or cassette.
    pub longest: Option<(String, f64)>,
}

/// Sums up the parts of a house.
pub fn parts_summary(parts: &Parts, marks: &Marks, masses: &Masses) -> PartsSummary {
    let heaviest = masses.part_kg.iter().enumerate().max_by(|a, b| a.1.total_cmp(b.1).then(b.0.cmp(&a.0)));
    let flat = parts.parts.iter().enumerate().filter(|(_, p)| p.kind.is_flat());
    let longest = flat.max_by(|a, b| a.1.length_mm.total_cmp(&b.1.length_mm).then(b.0.cmp(&a.0)));
    PartsSummary {
        parts: parts.parts.len(),
        distinct: parts.distinct(),
        by_kind: PartKind::ALL.map(|kind| parts.count(kind)),
        heaviest: heaviest.map(|(n, kg)| (marks.piece[n].clone(), *kg)),
        longest: longest.map(|(n, p)| (marks.piece[n].clone(), p.length_mm)),
    }
}

impl PartsSummary {
    /// The summary in sentences, one a line.
    pub fn lines(&self) -> Vec<String> {
        let kinds = PartKind::ALL.iter().zip(self.by_kind).filter(|(_, n)| *n > 0);
        let kinds: Vec<String> = kinds.map(|(kind, n)| format!("{n} {}", kind.name().replace('_', " "))).collect();
        let mut lines = vec![format!("{} parts, {} distinct: {}", self.parts, self.distinct, kinds.join(", "))];
        if let Some((mark, kg)) = &self.heaviest {
            lines.push(format!("heaviest part {mark}: {kg:.0} kg"));
        }
        if let Some((mark, mm)) = &self.longest {
            lines.push(format!("longest part {mark}: {:.2} m", mm / 1000.0));
        }
        lines
    }
}

/// `parts.json`: summary, parts with cells and openings, what is too large for a truck, and the stock of the frame.
pub fn parts_json(
    parts: &Parts,
    marks: &Marks,
    masses: &Masses,
    overloads: &[Overload],
    stock: Option<&Stock>,
) -> Value {
    let summary = parts_summary(parts, marks, masses);
    let rows: Vec<Value> = (0..parts.parts.len()).map(|n| part_json(parts, marks, masses, n)).collect();
    let over: Vec<Value> = overloads
        .iter()
        .map(|o| {
            json!({ "mark": marks.piece[o.part.0 as usize], "what": o.what, "found": grain(o.found, 1e4), "limit": o.limit })
        })
        .collect();
    json!({
        "schema": "houscaper.parts/1",
        "module_size_m": parts.module_m,
        "summary": {
            "parts": summary.parts,
            "distinct_parts": summary.distinct,
            "lines": summary.lines(),
        },
        "masses": "kg; mass_kg is the whole part, frame_kg the members of the frame in it; site_kg is foundation, plinth, railings and decks on the ground, loose_frame_kg posts that stand in no panel",
        "parts": rows,
        "site_kg": grain(masses.site_kg, 1e2),
        "loose_frame_kg": grain(masses.loose_frame_kg, 1e2),
        "total_kg": grain(masses.total_kg(), 1e2),
        "too_large": over,
        "stock": stock.map(stock_json),
    })
}

fn part_json(parts: &Parts, marks: &Marks, masses: &Masses, n: usize) -> Value {
    let p = &parts.parts[n];
    let openings: Vec<Value> = parts
        .openings_of(p)
        .iter()
        .map(|o| {
            json!({
                "label": o.label.name(), "from_module": o.from, "width_modules": o.width,
                "sill_half_modules": o.sill, "height_modules": o.height_modules(),
            })
        })
        .collect();
    let cells: Vec<[u16; 4]> = parts.cells_of(p).iter().map(|c| [c.cell[0], c.cell[1], c.k, c.code]).collect();
    json!({
        "mark": marks.piece[n],
        "type": marks.of_type[n],
        "kind": p.kind.name(),
        "storey": p.level,
        "direction": p.facing.map(direction),
        "axis": if p.axis == 0 { "x" } else { "y" },
        "first_cell": p.first,
        "modules": p.modules,
        "length_mm": tenth(p.length_mm),
        "width_mm": tenth(p.width_mm),
        "height_mm": tenth(p.height_mm),
        "area_m2": grain(p.area_m2, 1e4),
        "mass_kg": grain(masses.part_kg[n], 1e2),
        "frame_kg": grain(masses.frame_kg[n], 1e2),
        "openings": openings,
        "cells_x_y_k_code": cells,
    })
}

fn stock_json(stock: &Stock) -> Value {
    let pieces: Vec<Value> = stock
        .pieces
        .iter()
        .map(|p| json!({ "role": p.role.name(), "section_of": p.group.name(), "length_mm": p.length_mm, "count": p.count }))
        .collect();
    json!({
        "stock_length_m": crate::parts::STOCK_LENGTH_M,
        "bars_wall_floor_beam_roof": stock.bars,
        "cuts": stock.cuts,
        "length_m": grain(stock.length_m, 1e4),
        "pieces": pieces,
    })
}
