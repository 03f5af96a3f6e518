//! Tables that other programs read: RFC 4180 CSV with `\n` line ends, numbers in their shortest exact form.

use serde_json::{Value, json};

use crate::price::{BillLine, chance_below, tenths};
use crate::score::{LayerRow, Weighed};

/// A cell of a table.
#[derive(Clone, Debug, PartialEq)]
pub enum Cell {
    /// Text, quoted where needed.
    Text(String),
    /// A number; not finite is written as an empty cell, as no reader agrees on anything else.
    Number(f64),
    /// A count.
    Count(i64),
    /// `true` or `false`.
    Flag(bool),
    /// Nothing.
    Empty,
}

impl From<f64> for Cell {
    fn from(value: f64) -> Self {
        Cell::Number(value)
    }
}

impl From<&str> for Cell {
    fn from(value: &str) -> Self {
        Cell::Text(value.to_owned())
    }
}

impl Cell {
    fn write(&self, out: &mut String) {
        match self {
            Cell::Text(text) => quote(text, out),
            Cell::Number(value) => *out += &number(*value),
            Cell::Count(value) => *out += &value.to_string(),
            Cell::Flag(value) => *out += if *value { "true" } else { "false" },
            Cell::Empty => {}
        }
    }
}

/// The shortest decimal that reads back as the same number; empty when not finite; no negative zero.
pub fn number(value: f64) -> String {
    match value {
        v if !v.is_finite() => String::new(),
        0.0 => "0".to_owned(),
        // Rust prints tiny and huge numbers without exponent; beyond these the digits would be mostly zeros.
        v if v.abs() < 1e-6 || v.abs() >= 1e16 => format!("{v:e}"),
        v => format!("{v}"),
    }
}

/// Appends text as a cell, in quotes where it needs them.
pub fn quote(text: &str, out: &mut String) {
    if text.contains(['"', ',', '\n', '\r']) || text.starts_with(' ') || text.ends_with(' ') {
        *out += "\"";
        *out += &text.replace('"', "\"\"");
        *out += "\"";
    } else {
        *out += text;
    }
}

/// One CSV line with its end.
pub fn csv_line(cells: &[Cell]) -> String {
    let mut line = String::new();
    for (i, cell) in cells.iter().enumerate() {
        if i > 0 {
            line.push(',');
        }
        cell.write(&mut line);
    }
    line.push('\n');
    line
}

/// Header and rows. Rows of another length than the header are filled or cut, so that columns never shift.
pub fn csv(header: &[&str], rows: impl IntoIterator<Item = Vec<Cell>>) -> String {
    let names: Vec<Cell> = header.iter().map(|h| Cell::from(*h)).collect();
    let mut text = csv_line(&names);
    for mut row in rows {
        row.resize(header.len(), Cell::Empty);
        text += &csv_line(&row);
    }
    text
}

/// An evaluated design as the tables show it.
#[derive(Clone, Debug, PartialEq)]
pub struct DesignRow {
    /// Its id, unique in the run.
    pub id: u64,
    /// Generation it was made in.
    pub generation: u64,
    /// Whether every constraint holds.
    pub feasible: bool,
    /// Sum of constraint violations, 0 when feasible.
    pub violation: f64,
    /// Objectives in the columns' order and the brief's own sense; empty when they could not be computed.
    pub objectives: Vec<f64>,
    /// Design variables in the columns' order.
    pub variables: Vec<Cell>,
}

/// Text of `evaluations.csv` and `front.csv`: `id,generation,feasible,violation`, a column per objective, one per variable.
pub fn designs_csv(objectives: &[&str], variables: &[&str], rows: &[DesignRow]) -> String {
    let header = [&["id", "generation", "feasible", "violation"], objectives, variables].concat();
    csv(&header, rows.iter().map(|r| design_cells(r, objectives.len())))
}

/// One line of `evaluations.csv`, for writers that append as results arrive.
pub fn design_line(row: &DesignRow, objectives: usize) -> String {
    csv_line(&design_cells(row, objectives))
}

fn design_cells(row: &DesignRow, objectives: usize) -> Vec<Cell> {
    let mut cells = vec![
        Cell::Count(row.id as i64),
        Cell::Count(row.generation as i64),
        Cell::Flag(row.feasible),
        row.violation.into(),
    ];
    cells.extend((0..objectives).map(|i| row.objectives.get(i).map_or(Cell::Empty, |v| Cell::Number(*v))));
    cells.extend(row.variables.iter().cloned());
    cells
}

/// The columns of `bom.csv`.
pub const BOM_COLUMNS: [&str; 15] = [
    "line",
    "group",
    "item",
    "description",
    "quantity",
    "unit",
    "rate",
    "amount",
    "amount_low",
    "amount_high",
    "mass_kg",
    "gwp_kgco2e",
    "biogenic_kgco2e",
    "energy_mj",
    "source",
];

/// Text of `bom.csv`; energy that no book knows is `unknown`.
pub fn bom_csv(lines: &[BillLine]) -> String {
    csv(&BOM_COLUMNS, lines.iter().map(bom_cells))
}

fn bom_cells(line: &BillLine) -> Vec<Cell> {
    let text = |t: &str| Cell::Text(t.to_owned());
    let mut cells = vec![Cell::Count(line.line as i64), text(&line.group), text(&line.item), text(&line.description)];
    cells.extend([line.quantity.into(), text(line.unit.name()), line.rate.into()]);
    cells.extend([line.amount, line.amount_low, line.amount_high].map(Cell::Number));
    cells.extend([line.mass_kg, line.gwp_kgco2e, line.biogenic_kgco2e].map(Cell::Number));
    cells.extend([line.energy_mj.map_or(text("unknown"), Cell::Number), text(&line.source)]);
    cells
}

/// The columns of `layers.csv`, the take-off by component: one row for each component that is drawn or priced.
///
/// | column | holds |
/// |---|---|
/// | `component` | name of the component, as in glTF nodes and OBJ groups |
/// | `volume_m3` | volume of its solids, exact to the last digit; stairs included |
/// | `items` | items of `bom.csv` that hold it |
/// | `quantity`, `unit` | sum of the items' quantities: m2 without openings, m or pieces; empty where units differ |
/// | `thickness_mm` | thickness from the build-up as drawn (whole mm a build-up), mean over the items |
/// | `takeoff_m3` | quantity times thickness, to compare with `volume_m3`; 0 for products |
/// | `density_kg_m3` | kg of its materials in a cubic metre as drawn, without members of the frame |
/// | `materials` | materials of the build-ups with their shares of its mass |
/// | `weighed` | `by volume`, `by item`, `within` another component, or `not` |
/// | `mass_kg` | mass of what is drawn |
/// | `takeoff_kg` | mass of what is priced; sums to the mass of `bom.csv` without the frame |
/// | `price` | materials without waste and work, default rates; sums to the material lines of `bom.csv` without the frame |
/// | `gwp_kgco2e` | fossil A1-A3, default factors; sums to `bom.csv` without the frame |
/// | `source` | build-ups and the version of their file |
pub const LAYERS_COLUMNS: [&str; 15] = [
    "component",
    "volume_m3",
    "items",
    "quantity",
    "unit",
    "thickness_mm",
    "takeoff_m3",
    "density_kg_m3",
    "materials",
    "weighed",
    "mass_kg",
    "takeoff_kg",
    "price",
    "gwp_kgco2e",
    "source",
];

/// Text of `layers.csv`; `version` is that of the build-ups.
pub fn layers_csv(rows: &[LayerRow], version: &str) -> String {
    csv(&LAYERS_COLUMNS, rows.iter().map(|row| layer_cells(row, version)))
}

fn layer_cells(row: &LayerRow, version: &str) -> Vec<Cell> {
    let list = |names: &mut dyn Iterator<Item = String>| Cell::Text(names.collect::<Vec<_>>().join("; "));
    let some = |value: Option<f64>| value.map_or(Cell::Empty, Cell::Number);
    let share = |(name, share): &(String, f64)| format!("{name} {:.1} %", share * 100.0);
    let weighed = match row.weighed {
        Weighed::ByVolume => "by volume".to_owned(),
        Weighed::ByItem => "by item".to_owned(),
        Weighed::Within(component) => format!("within {}", component.name()),
        Weighed::Not => "not".to_owned(),
    };
    let source = match row.buildups.as_slice() {
        [] => Cell::Empty,
        ids => Cell::Text(format!("build-ups {version}: {}", ids.join(", "))),
    };
    vec![
        Cell::from(row.component.name()),
        row.volume_m3.into(),
        list(&mut row.items.iter().map(|item| item.id().to_owned())),
        some(row.quantity.map(|(quantity, _)| quantity)),
        row.quantity.map_or(Cell::Empty, |(_, unit)| Cell::from(unit.name())),
        some(row.thickness_mm),
        row.takeoff_m3.into(),
        some(row.density_kg_m3),
        list(&mut row.materials.iter().map(share)),
        Cell::Text(weighed),
        row.mass_kg.into(),
        row.takeoff_kg.into(),
        row.price.into(),
        row.gwp_kgco2e.into(),
        source,
    ]
}

/// A design as Design Explorer shows it.
#[derive(Clone, Debug, PartialEq)]
pub struct ExplorerRow {
    /// Unique id; becomes the column `in:id`, without which rows with equal inputs overwrite each other.
    pub id: u64,
    /// Inputs.
    pub inputs: Vec<Cell>,
    /// Outputs.
    pub outputs: Vec<f64>,
    /// Picture, relative to the file, e.g. `front/12/thumb.png`.
    pub image: String,
}

/// Text of Design Explorer's `data.csv`: `in:id`, the inputs, the outputs and one image column.
pub fn explorer_csv(inputs: &[&str], outputs: &[&str], rows: &[ExplorerRow]) -> String {
    let header: Vec<String> = std::iter::once("in:id".to_owned())
        .chain(inputs.iter().map(|n| format!("in:{n}")))
        .chain(outputs.iter().map(|n| format!("out:{n}")))
        .chain(std::iter::once("img".to_owned()))
        .collect();
    let names: Vec<&str> = header.iter().map(String::as_str).collect();
    csv(
        &names,
        rows.iter().map(|r| {
            let mut cells = vec![Cell::Count(r.id as i64)];
            cells.extend((0..inputs.len()).map(|i| r.inputs.get(i).cloned().unwrap_or(Cell::Empty)));
            cells.extend((0..outputs.len()).map(|i| r.outputs.get(i).map_or(Cell::Empty, |v| Cell::Number(*v))));
            cells.push(Cell::Text(r.image.clone()));
            cells
        }),
    )
}

/// Text of Design Explorer's `settings.json`: title, and for each output whether less is better.
pub fn explorer_settings(title: &str, outputs: &[(&str, bool)]) -> String {
    let dimensions: serde_json::Map<String, Value> = outputs
        .iter()
        .map(|(name, less)| (format!("out:{name}"), json!({ "better": if *less { "less" } else { "more" } })))
        .collect();
    let settings = json!({ "studyInfo": { "name": title, "date": "" }, "dimScales": {}, "dimTicks": {}, "dimMark": {}, "dimensions": dimensions });
    format!("{settings:#}\n")
}
/// `uncertainty.csv`: for each house the price that 10 %, 50 % and 90 % of the draws stay below, and the chance that it costs less than
/// each of the others; `prices` in the same draws for all.
pub fn uncertainty_csv(ids: &[u64], prices: &[Vec<f64>]) -> String {
    let mut out = "id,price_p10_eur,price_p50_eur,price_p90_eur".to_owned();
    ids.iter().for_each(|id| out += &format!(",cheaper_than_{id}"));
    for (id, own) in ids.iter().zip(prices) {
        out += &format!("\n{id}");
        tenths(own).iter().for_each(|p| out += &format!(",{p:.2}"));
        prices.iter().for_each(|other| out += &format!(",{:.4}", chance_below(own, other)));
    }
    out + "\n"
}
