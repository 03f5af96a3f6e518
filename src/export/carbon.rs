//! `carbon.json` and `carbon.html`: carbon by stage and heat loss of a house, by line, by section, by material and per m2.

use std::fmt::Write;

use serde_json::{Value, json};

use super::figures::grouped;
use crate::price::{CarbonAccount, CarbonFigures, CarbonRow, Range, Stage, StageFigure, escape};
use crate::score::HeatLoss;

/// How the numbers are to be read.
pub const RULES: [&str; 5] = [
    "Fossil carbon, biogenic carbon and D are numbers beside each other: none is netted with another, and no total holds two of them.",
    "Stored biogenic carbon is released at the end of life (C3), whatever the way: the release equals the storage (EN 16485).",
    "A sum with \"+ ?\" is of the materials that have a factor; those without are named and are not zero.",
    "Use, repair and replacement (B), demolition (C1) and its transport (C2) are unknown.",
    "Low and high are the ends of the factors read, taken together: no probability is meant.",
];

const HEAT: &str = "Sum of U A from the layers of the build-ups (ISO 6946), the ground without the resistance of the soil, no thermal bridges of junctions. Openings are m2 in the facade; north is +y.";

const STYLE: &str = "body{font:10pt/1.45 system-ui,sans-serif;margin:2em auto;max-width:68em;color:#222}h1{margin:0}h2{margin:1.4em 0 .2em}\
table{border-collapse:collapse;width:100%;margin:.6em 0}td,th{padding:.2em .5em;border-bottom:1px solid #ddd;vertical-align:top;text-align:left}\
.n{text-align:right;white-space:nowrap;font-variant-numeric:tabular-nums}.m{color:#666;font-size:9pt}.t td{font-weight:600;border-top:2px solid #222}\
.b{border-left:2px solid #222}small{color:#666;display:block}\
@media print{body{margin:0;max-width:none;font-size:8pt}tr{break-inside:avoid}@page{size:A4 landscape;margin:12mm}}";

/// Text of `carbon.json`.
pub fn carbon_json(name: &str, account: &CarbonAccount, heat: Option<&HeatLoss>) -> Value {
    json!({
        "schema": "houscaper.carbon-account/1",
        "name": name,
        "unit": "kgCO2e",
        "ranges": "low, default, high",
        "rules": RULES,
        "account": account,
        "heat_loss": heat,
        "heat_loss_basis": HEAT,
    })
}

/// Text of `carbon.html`: the same record.
pub fn carbon_html(name: &str, account: &CarbonAccount, heat: Option<&HeatLoss>) -> String {
    let mut page = format!(
        "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>Carbon: {name}</title><style>{STYLE}</style></head><body>\n<h1>{name}: carbon, energy and heat loss</h1>\n<p>{}</p>\n",
        lead(account, heat),
        name = escape(name),
    );
    let mut whole: Vec<CarbonRow> = account.groups.clone();
    let row = |name: &str, figures: &CarbonFigures| CarbonRow {
        line: None,
        name: name.to_owned(),
        description: name.to_owned(),
        quantity: None,
        figures: figures.clone(),
    };
    whole.push(row("whole house", &account.total));
    put(&mut page, "By section", "kgCO2e, default with low - high below; energy in GJ", &whole, (0, 1e3), true);
    if let Some(per_m2) = &account.per_m2 {
        let note = format!("kgCO2e per m2 of net floor area ({:.1} m2); energy in MJ", account.floor_area_m2);
        put(&mut page, "Per m2", &note, &[row("a square metre of floor", per_m2)], (1, 1.0), false);
    }
    page += "<ul class=\"m\">";
    RULES.iter().for_each(|rule| page += &format!("<li>{}</li>", escape(rule)));
    page += "</ul>\n";
    put_unknown(&mut page, account);
    if let Some(heat) = heat {
        put_heat(&mut page, heat);
    }
    put(&mut page, "By line of the bill", "kgCO2e; energy in GJ", &account.lines, (0, 1e3), false);
    put(&mut page, "By material", "kgCO2e; energy in GJ", &account.materials, (0, 1e3), false);
    put_sources(&mut page, account);
    page + "</body></html>\n"
}

/// The house in two sentences.
fn lead(account: &CarbonAccount, heat: Option<&HeatLoss>) -> String {
    let total = &account.total;
    let [low, default, high] = total.a1_a3.map(|v| v / 1e3);
    let mut text = format!(
        "<strong>Making its materials emits {default:.1} t CO2e of fossil carbon (A1-A3), between {low:.1} and {high:.1} t.</strong> "
    );
    let _ = write!(
        text,
        "Its wood keeps {:.1} t CO2 out of the air until its end of life. ",
        -total.biogenic_storage / 1e3
    );
    if let Some(heat) = heat {
        let _ = write!(
            text,
            "Through walls, roof, ground and openings it loses {:.0} W for each degree that it is colder outside.",
            heat.w_per_k
        );
    }
    text
}

fn put(page: &mut String, title: &str, note: &str, rows: &[CarbonRow], (digits, per): (usize, f64), sum: bool) {
    let _ = write!(page, "<h2>{title}</h2>\n<p class=\"m\">{}</p>\n<table><tr><th></th>", escape(note));
    if rows.iter().any(|r| r.quantity.is_some()) {
        page.push_str("<th class=\"n\">Quantity</th>");
    }
    page.push_str("<th class=\"n\">A1-A3</th>");
    Stage::INSIDE.iter().for_each(|s| *page += &format!("<th class=\"n\">{}</th>", s.title()));
    page.push_str("<th class=\"n b\">stored</th><th class=\"n\">released (C3)</th><th class=\"n b\">D, beyond</th><th class=\"n b\">energy</th></tr>\n");
    for (n, r) in rows.iter().enumerate() {
        let class = if sum && n + 1 == rows.len() { " class=\"t\"" } else { "" };
        let text = if r.line.is_some() || r.description == r.name {
            escape(&r.description)
        } else {
            format!("{} <small>{}</small>", escape(&r.name), escape(&r.description))
        };
        let _ = write!(page, "<tr{class}><td>{text}</td>");
        if let Some((quantity, unit)) = r.quantity {
            let _ = write!(page, "<td class=\"n m\">{quantity:.1} {unit}</td>");
        }
        let f = &r.figures;
        let _ = write!(page, "<td class=\"n\">{}</td>", range(f.a1_a3, digits));
        Stage::INSIDE.iter().for_each(|s| *page += &format!("<td class=\"n\">{}</td>", stage(f.stage(*s), digits)));
        let [stored, released] = [f.biogenic_storage, f.biogenic_release_c3].map(|v| number(v, digits));
        let _ = write!(page, "<td class=\"n b\">{stored}</td><td class=\"n\">{released}</td>");
        let energy = number(f.energy_known_mj / per, 1) + if f.energy_unknown.is_empty() { "" } else { " + ?" };
        let _ = writeln!(page, "<td class=\"n b\">{}</td><td class=\"n b\">{energy}</td></tr>", stage(&f.d, digits));
    }
    page.push_str("</table>\n");
}

fn put_unknown(page: &mut String, account: &CarbonAccount) {
    page.push_str("<h2>What is unknown</h2>\n<ul>");
    for stage in Stage::ALL {
        let unknown = &account.total.stage(stage).unknown;
        let text = if unknown.is_empty() { "nothing".to_owned() } else { unknown.join(", ").replace('_', " ") };
        let _ = write!(page, "<li><strong>{}</strong>: {}", stage.title(), escape(&text));
        if let Some(scope) = account.scope.get(&stage) {
            let _ = write!(page, " <span class=\"m\">({})</span>", escape(scope));
        }
        page.push_str("</li>");
    }
    page.push_str("</ul>\n");
}

fn put_heat(page: &mut String, heat: &HeatLoss) {
    let _ = writeln!(
        page,
        "<h2>Heat loss by transmission</h2>\n<p class=\"m\">{HEAT}</p>\n<table><tr><th>Element</th><th class=\"n\">m2</th><th class=\"n\">U, W/m2K</th><th class=\"n\">W/K</th></tr>"
    );
    for e in &heat.elements {
        let _ = writeln!(
            page,
            "<tr><td>{}</td><td class=\"n\">{:.1}</td><td class=\"n\">{:.3}</td><td class=\"n\">{:.1}</td></tr>",
            escape(&e.item.replace('_', " ")),
            e.area_m2,
            e.u_w_m2k,
            e.w_per_k
        );
    }
    let _ = writeln!(
        page,
        "<tr class=\"t\"><td>whole envelope, mean U</td><td class=\"n\">{:.1}</td><td class=\"n\">{:.3}</td><td class=\"n\">{:.1}</td></tr></table>\n<table><tr><th>Openings facing</th><th class=\"n\">windows, m2</th><th class=\"n\">doors, m2</th><th class=\"n\">W/K</th></tr>",
        heat.area_m2, heat.mean_u_w_m2k, heat.w_per_k
    );
    for o in &heat.openings {
        let _ = writeln!(
            page,
            "<tr><td>{}</td><td class=\"n\">{:.1}</td><td class=\"n\">{:.1}</td><td class=\"n\">{:.1}</td></tr>",
            o.facing, o.windows_m2, o.doors_m2, o.w_per_k
        );
    }
    page.push_str("</table>\n");
}

fn put_sources(page: &mut String, account: &CarbonAccount) {
    let _ = writeln!(
        page,
        "<h2>Sources</h2>\n<p class=\"m\">Factor list {}.</p>\n<ul class=\"m\">",
        escape(&account.version)
    );
    for (material, sources) in &account.sources {
        let all: Vec<String> = sources.iter().map(|(stage, source)| format!("{stage}: {source}")).collect();
        let _ = writeln!(page, "<li><strong>{}</strong>: {}</li>", escape(material), escape(&all.join("; ")));
    }
    page.push_str("</ul>\n");
}

/// Default, with low and high below it where they differ.
fn range(r: Range, digits: usize) -> String {
    let [low, default, high] = r.map(|v| number(v, digits));
    if low == default && default == high { default } else { format!("{default}<small>{low} to {high}</small>") }
}

fn stage(figure: &StageFigure, digits: usize) -> String {
    match (figure.unknown.is_empty(), figure.known == [0.0; 3]) {
        (true, _) => range(figure.known, digits),
        (false, true) => "unknown".to_owned(),
        (false, false) => {
            range(figure.known, digits).replacen("<small>", " + ?<small>", 1)
                + if range(figure.known, digits).contains("<small>") { "" } else { " + ?" }
        }
    }
}

/// With thin thousands groups and a minus sign; no negative zero.
fn number(value: f64, digits: usize) -> String {
    grouped(value, digits).replace('-', "\u{2212}")
}
