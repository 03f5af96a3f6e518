//! A comparison of materials as tables, JSON and a page.

use std::fmt::Write;

use serde_json::{Value, json};

use super::dossier::check_name;
use super::figures::{grouped, plain, quoted};
use super::plots::{PlotError, RangeBar, ranges};
use crate::brief::Objective;
use crate::price::{Stage, escape};
use crate::score::{Comparison, Evaluator, Tie, Variant};
use crate::voxels::Choice;

/// Ties told at most, for each pair and for price and carbon each.
const TIES: usize = 3;

const STYLE: &str = "body{font:10pt/1.45 system-ui,sans-serif;margin:2em auto;max-width:64em;color:#222}h1{margin:0}\
table{border-collapse:collapse;width:100%;margin:.6em 0}td,th{padding:.2em .5em;border-bottom:1px solid #ddd;vertical-align:top;text-align:left}\
.n{text-align:right;white-space:nowrap;font-variant-numeric:tabular-nums}.m{color:#666;font-size:9pt}.w{text-align:right;max-width:16em}.f{min-width:17em}.no{color:#a33}svg{max-width:100%;height:auto}\
@media print{body{margin:0;max-width:none;font-size:8.5pt}tr,svg{break-inside:avoid}@page{size:A4;margin:14mm}}";

/// Rows of the table of variants: title, unit, digits, value.
type Row = (&'static str, &'static str, usize, fn(&Variant) -> f64);

const ROWS: [Row; 24] = [
    ("price in place, net of VAT, low", "EUR", 0, |v| v.price()[0]),
    ("price in place, net of VAT, default", "EUR", 0, |v| v.price()[1]),
    ("price in place, net of VAT, high", "EUR", 0, |v| v.price()[2]),
    ("price that 10 % of draws stay below", "EUR", 0, |v| v.price_tenths()[0]),
    ("price that 90 % of draws stay below", "EUR", 0, |v| v.price_tenths()[2]),
    ("fossil carbon A1-A3, low", "kgCO2e", 0, |v| v.carbon()[0]),
    ("fossil carbon A1-A3, default", "kgCO2e", 0, |v| v.carbon()[1]),
    ("fossil carbon A1-A3, high", "kgCO2e", 0, |v| v.carbon()[2]),
    ("A4 transport, as far as known", "kgCO2e", 0, |v| v.stages.stage(Stage::A4).known[1]),
    ("A5 waste on site, as far as known", "kgCO2e", 0, |v| v.stages.stage(Stage::A5).known[1]),
    ("C3-C4 end of life, as far as known, low", "kgCO2e", 0, |v| v.stages.stage(Stage::C3C4).known[0]),
    ("C3-C4 end of life, as far as known, default", "kgCO2e", 0, |v| v.stages.stage(Stage::C3C4).known[1]),
    ("C3-C4 end of life, as far as known, high", "kgCO2e", 0, |v| v.stages.stage(Stage::C3C4).known[2]),
    ("biogenic storage, not netted", "kgCO2", 0, |v| v.stages.storage),
    ("biogenic release in C3, not netted", "kgCO2", 0, |v| v.stages.release),
    ("D beyond the boundary, as far as known, low", "kgCO2e", 0, |v| v.stages.stage(Stage::D).known[0]),
    ("D beyond the boundary, as far as known, default", "kgCO2e", 0, |v| v.stages.stage(Stage::D).known[1]),
    ("D beyond the boundary, as far as known, high", "kgCO2e", 0, |v| v.stages.stage(Stage::D).known[2]),
    ("frame mass", "kg", 0, |v| v.value(Objective::FrameMassKg)),
    ("mass", "kg", 0, |v| v.value(Objective::MassKg)),
    ("utilisation", "-", 2, |v| v.value(Objective::Utilisation)),
    ("sway ratio", "-", 2, |v| v.value(Objective::SwayRatio)),
    ("deflection ratio", "-", 2, |v| v.value(Objective::DeflectionRatio)),
    ("least clear height", "m", 2, |v| v.clear_height_m),
];

/// A comparison with what is needed to name it.
pub struct Compared<'a> {
    /// Name of the house.
    pub name: &'a str,
    /// The variants.
    pub comparison: &'a Comparison,
    /// An evaluator for each variant, in their order.
    pub evaluators: Vec<&'a Evaluator>,
    /// Systems in which nothing could be assessed.
    pub left_out: &'a [String],
    /// Draws, and their seed.
    pub draws: (usize, u64),
}

impl Compared<'_> {
    /// The materials' names in order.
    fn names(&self) -> Vec<&str> {
        self.comparison.variants.iter().map(|v| v.system.as_str()).collect()
    }

    /// Ties of a pair that are worth telling.
    fn ties(&self, a: usize, b: usize) -> Vec<Tie> {
        let all = self.comparison.ties(a, b, self.evaluators[a]);
        ["price", "carbon"].iter().flat_map(|of| all.iter().filter(|t| t.of == *of).take(TIES).cloned()).collect()
    }

    /// Sections, joists and boards of a variant by name.
    fn choices(&self, n: usize) -> Vec<(&'static str, String)> {
        let (variant, evaluator) = (&self.comparison.variants[n], self.evaluators[n]);
        let names = [Choice::Wall, Choice::Floor, Choice::Beam, Choice::Roof].map(Choice::name);
        let sections = evaluator.sections(&variant.choices).map(|option| evaluator.catalogue.option_name(option));
        let mut all: Vec<_> = names.into_iter().zip(sections).collect();
        let joists = if variant.choices.joists_along_y(0) { "y" } else { "x" };
        all.push((Choice::Joists.name(), joists.to_owned()));
        all.push((Choice::Boards.name(), evaluator.boards(&variant.choices).name().to_owned()));
        all
    }

    /// Verdict of a variant, with what governs where it fails.
    pub fn verdict(&self, n: usize) -> String {
        let variant = &self.comparison.variants[n];
        match variant.evaluation.assessment.as_ref().and_then(|a| a.governing) {
            _ if variant.is_ok() => "ok".to_owned(),
            Some(g) => format!("not ok: {} at {:.2}", check_name(g.check), g.utilisation),
            None => "not assessed".to_owned(),
        }
    }

    /// `compare.csv`: a row for each figure, then for each choice, a column for each system.
    pub fn table_csv(&self) -> String {
        let mut text = format!("figure,unit,{}\n", self.names().join(","));
        let count = self.comparison.variants.len();
        let mut row = |title: &str, unit: &str, cells: Vec<String>| {
            let _ = writeln!(text, "{},{unit},{}", quoted(title), cells.join(","));
        };
        row("verdict", "", (0..count).map(|n| quoted(&self.verdict(n))).collect());
        for (title, unit, digits, value) in ROWS {
            row(title, unit, self.comparison.variants.iter().map(|v| plain(value(v), digits)).collect());
        }
        let cheapest = self.comparison.chance_cheapest();
        row(
            "share of draws in which it is the cheapest that stands",
            "-",
            cheapest.iter().map(|c| plain(*c, 4)).collect(),
        );
        self.order_rows().into_iter().for_each(|(title, cells)| {
            row(&title, "", cells.iter().map(|c| quoted(c)).collect());
        });
        let choices: Vec<_> = (0..count).map(|n| self.choices(n)).collect();
        for (k, (title, _)) in choices.first().into_iter().flatten().enumerate() {
            row(title, "", choices.iter().map(|c| c[k].1.clone()).collect());
        }
        text
    }

    /// `lines.csv`: amounts line by line, net of overhead and VAT, with the difference of each system from the first.
    pub fn lines_csv(&self) -> String {
        let names = self.names();
        let columns = |what: &str| names.iter().map(|n| format!("{what} {n}")).collect::<Vec<_>>().join(",");
        let mut text = format!(
            "group,item,{},{},{},{}\n",
            columns("amount"),
            columns("difference"),
            columns("gwp_kgco2e"),
            columns("mass_kg")
        );
        for r in self.comparison.rows() {
            let all =
                |values: &[f64], from: f64| values.iter().map(|v| plain(v - from, 2)).collect::<Vec<_>>().join(",");
            let _ = writeln!(
                text,
                "{},{},{},{},{},{}",
                r.group,
                quoted(&r.item),
                all(&r.amount, 0.0),
                all(&r.amount, r.amount[0]),
                all(&r.gwp_kgco2e, 0.0),
                all(&r.mass_kg, 0.0)
            );
        }
        text
    }

    /// `compare.json`: everything, with unrounded numbers.
    pub fn json(&self) -> Value {
        let variants: Vec<Value> = (0..self.comparison.variants.len())
            .map(|n| {
                let v = &self.comparison.variants[n];
                json!({
                    "system": v.system,
                    "verdict": self.verdict(n),
                    "choices": self.choices(n).into_iter().collect::<std::collections::BTreeMap<_, _>>(),
                    "price_eur": v.price(),
                    "price_tenths_eur": v.price_tenths(),
                    "gwp_kgco2e": v.carbon(),
                    "biogenic_kgco2": v.evaluation.cost.map(|c| c.biogenic),
                    "stages": self.stages_json(n),
                    "energy_mj": v.evaluation.cost.and_then(|c| c.energy_mj),
                    "frame_mass_kg": number(v.value(Objective::FrameMassKg)),
                    "mass_kg": number(v.value(Objective::MassKg)),
                    "utilisation": number(v.value(Objective::Utilisation)),
                    "sway_ratio": number(v.value(Objective::SwayRatio)),
                    "deflection_ratio": number(v.value(Objective::DeflectionRatio)),
                    "clear_height_m": v.clear_height_m,
                    "lines": v.lines,
                })
            })
            .collect();
        let pairs: Vec<Value> = self
            .comparison
            .neighbours()
            .into_iter()
            .map(|(a, b)| {
                json!({
                    "systems": [self.names()[a], self.names()[b]],
                    "sentence": self.comparison.sentence(a, b),
                    "ties": self.comparison.ties(a, b, self.evaluators[a]),
                })
            })
            .collect();
        let count = self.comparison.variants.len();
        let row = |a: usize| (0..count).map(|b| self.comparison.chance(a, b)).collect::<Vec<f64>>();
        let matrix: Vec<Vec<f64>> = (0..count).map(row).collect();
        json!({
            "schema": "houscaper.compare/1",
            "name": self.name,
            "variants": variants,
            "left_out": self.left_out,
            "chance_cheapest": self.comparison.chance_cheapest(),
            "chance_row_is_cheaper_than_column": matrix,
            "draws": {"count": self.draws.0, "seed": self.draws.1, "distribution": "triangular from low over default to high, one draw an item shared by all systems"},
            "pairs": pairs,
            "carbon_order": self.survivals(),
            "carbon_order_is_kept": self.comparison.order_is_kept(),
            "rows": self.comparison.rows(),
            "same_for_all": SAME,
        })
    }

    /// Price and carbon with their ranges as SVG.
    ///
    /// # Errors
    /// When drawing fails.
    pub fn charts(&self) -> Result<[(&'static str, String); 2], PlotError> {
        let bars = |value: fn(&Variant) -> [f64; 3]| -> Vec<RangeBar> {
            let bar = |v: &Variant| RangeBar { name: v.system.clone(), range: value(v), is_pale: !v.is_ok() };
            self.comparison.variants.iter().map(bar).collect()
        };
        let title = |what: &str| format!("{}: {what}", self.name);
        Ok([
            (
                "price",
                ranges(&title("price in place, net of VAT"), "EUR, low - default - high", &bars(Variant::price))?,
            ),
            ("carbon", ranges(&title("fossil carbon A1-A3"), "kgCO2e, low - default - high", &bars(Variant::carbon))?),
        ])
    }

    /// The page: one self-contained file that prints.
    ///
    /// # Errors
    /// When drawing fails.
    pub fn html(&self) -> Result<String, PlotError> {
        let count = self.comparison.variants.len();
        let mut page = format!(
            "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>{name}: materials compared</title><style>{STYLE}</style></head><body>\n<h1>{name}: materials compared</h1>\n<p>{SAME}</p>\n",
            name = escape(self.name)
        );
        for (a, b) in self.comparison.neighbours() {
            let _ = writeln!(page, "<p><strong>{}.</strong></p>", escape(&self.comparison.sentence(a, b)));
        }
        for survival in self.survivals() {
            let _ = writeln!(page, "<p>{}.</p>", escape(&survival.sentence()));
        }
        if !self.left_out.is_empty() {
            let _ = writeln!(page, "<p class=\"no\">Not assessed: {}.</p>", escape(&self.left_out.join(", ")));
        }
        self.charts()?.iter().for_each(|(_, svg)| page += svg);
        let head: String = self.names().iter().map(|n| format!("<th class=\"n\">{}</th>", escape(n))).collect();
        let _ = writeln!(page, "<h2>Figures</h2>\n<table><tr><th></th><th></th>{head}</tr>");
        let mut row = |title: &str, unit: &str, cells: Vec<String>| {
            // Words may wrap, numbers may not.
            let class = |c: &str| if c.len() > 20 { "w m" } else { "n" };
            let cells: String =
                cells.iter().map(|c| format!("<td class=\"{}\">{}</td>", class(c), escape(c))).collect();
            let _ = writeln!(page, "<tr><td class=\"f\">{}</td><td class=\"m\">{unit}</td>{cells}</tr>", escape(title));
        };
        row("verdict", "", (0..count).map(|n| self.verdict(n)).collect());
        for (title, unit, digits, value) in ROWS {
            row(title, unit, self.comparison.variants.iter().map(|v| grouped(value(v), digits)).collect());
        }
        let cheapest = self.comparison.chance_cheapest();
        row("cheapest that stands, of the draws", "%", cheapest.iter().map(|c| grouped(100.0 * c, 0)).collect());
        self.order_rows().into_iter().for_each(|(title, cells)| row(&title, "", cells));
        let choices: Vec<_> = (0..count).map(|n| self.choices(n)).collect();
        for (k, (title, _)) in choices.first().into_iter().flatten().enumerate() {
            row(&title.replace('_', " "), "", choices.iter().map(|c| c[k].1.clone()).collect());
        }
        page += "</table>\n";
        self.put_lines(&mut page, &head);
        self.put_ties(&mut page);
        Ok(page + "</body></html>\n")
    }

    fn put_lines(&self, page: &mut String, head: &str) {
        let _ = writeln!(
            page,
            "<h2>Lines that differ</h2>\n<p class=\"m\">Amounts at default rates, net of overhead and VAT.</p>\n<table><tr><th></th><th></th>{head}</tr>"
        );
        let differs = |values: &[f64]| values.iter().any(|v| (v - values[0]).abs() > 0.005);
        for r in self.comparison.rows().iter().filter(|r| differs(&r.amount)) {
            let cells: String = r.amount.iter().map(|a| format!("<td class=\"n\">{}</td>", grouped(*a, 2))).collect();
            let _ = writeln!(page, "<tr><td>{}</td><td>{}</td>{cells}</tr>", escape(&r.group), escape(&r.item));
        }
        page.push_str("</table>\n");
    }

    fn put_ties(&self, page: &mut String) {
        page.push_str("<h2>What would turn the order round</h2>\n<table><tr><th>Of</th><th>Rate</th><th class=\"n\">now</th><th class=\"n\">both equal at</th><th class=\"n\">low - high</th><th></th></tr>\n");
        for tie in self.comparison.neighbours().into_iter().flat_map(|(a, b)| self.ties(a, b)) {
            let reach = if tie.is_within_range() { "within its range" } else { "beyond its range" };
            let _ = writeln!(
                page,
                "<tr><td>{} below {} ({})</td><td>{} [{}]</td><td class=\"n\">{:.2}</td><td class=\"n\">{:.2}</td><td class=\"n m\">{:.2} - {:.2}</td><td class=\"m\">{reach}</td></tr>",
                escape(&tie.more),
                escape(&tie.less),
                tie.of,
                escape(&tie.item),
                escape(&tie.unit),
                tie.rate,
                tie.tie,
                tie.range[0],
                tie.range[1]
            );
        }
        page.push_str("</table>\n");
    }
}

const SAME: &str = "The frame alone changes: cladding, insulation, openings, floors, foundation, loads and the rules of sizing are the same for all. Boards on the second side of the walls come where a frame needs them and are priced with it. Steel studs bridge the insulation; the U-value of the wall is stated for timber, so that of a steel frame is better here than it would be. Fire protection of steel, special connections and the time on site are in none of the prices.";

fn number(value: f64) -> Value {
    if value.is_finite() { json!(value) } else { Value::Null }
}
