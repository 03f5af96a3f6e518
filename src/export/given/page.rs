//! The page as one self-contained HTML file.

use std::fmt::Write;

use super::{Cell, Fate, Reading, centre};
use crate::brief::{Brief, Keep};
use crate::export::colour::viridis;
use crate::price::escape;
use crate::score::out_of;
use crate::voxels::lattice::Lattice;
use crate::voxels::{Given, House, Label, STOREY_MODULES, read_storeys};

/// Cells listed by their coordinates at most, for each house and fate.
const LISTED: usize = 400;
/// Side of a module in a plan, px.
const SIDE: usize = 13;

const STYLE: &str = "body{font:10pt/1.45 system-ui,sans-serif;margin:2em auto;max-width:70em;padding:0 1em;color:#222}h1{margin:0}\
h2{margin:1.6em 0 .2em;border-top:2px solid #222;padding-top:.5em}table{border-collapse:collapse;margin:.6em 0}\
td,th{padding:.2em .7em;border-bottom:1px solid #ddd;text-align:left;vertical-align:top}.n{text-align:right;font-variant-numeric:tabular-nums}\
.m{color:#555}.no{color:#a11;font-weight:600}.plans{display:flex;flex-wrap:wrap;gap:1.4em;align-items:flex-start}figure{margin:0}\
figcaption{font-size:9pt;color:#555}i.k{display:inline-block;width:1em;height:1em;margin:0 .3em 0 1em;vertical-align:-.15em;border:1px solid #888}\
details{margin:.4em 0}code{font-size:9pt}@media print{figure{break-inside:avoid}@page{size:A4;margin:14mm}}";

/// What the page is made of.
pub struct Page<'a> {
    /// The brief.
    pub brief: &'a Brief,
    /// The lattice as it was read.
    pub lattice: &'a Lattice,
    /// The same in modules.
    pub given: &'a Given,
    /// Houses with id and name.
    pub houses: Vec<(u64, String, &'a House)>,
}

impl Page<'_> {
    /// Whether the lattice gives labels in place of zones.
    fn labels(&self) -> bool {
        self.brief.given.as_ref().is_some_and(|given| given.keep == Keep::Labels)
    }

    /// What the lattice's values are.
    fn word(&self) -> &'static str {
        if self.labels() { "label" } else { "zone" }
    }
}

/// The page.
pub fn given_html(page: &Page) -> String {
    let name = escape(&page.brief.name);
    let mut out = format!(
        "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>{name}: given cells</title><style>{STYLE}</style></head><body>\n\
         <svg width=\"0\" height=\"0\" style=\"position:absolute\"><defs><pattern id=\"gone\" width=\"6\" height=\"6\" patternUnits=\"userSpaceOnUse\" patternTransform=\"rotate(45)\"><rect width=\"6\" height=\"6\" fill=\"#fff\"/><path d=\"M0 0V6\" stroke=\"#a11\" stroke-width=\"2.4\"/></pattern></defs></svg>\n\
         <h1>{name}: given cells</h1>\n"
    );
    transform(&mut out, page);
    for (id, name, house) in &page.houses {
        house_part(&mut out, page, *id, name, house);
    }
    out + "</body></html>\n"
}

fn transform(out: &mut String, page: &Page) {
    let (lattice, r, map) = (page.lattice, &page.given.report, &page.given.map);
    let asked = page.brief.given.as_ref();
    let file = asked.map_or("", |g| &g.lattice);
    let rule = asked.map_or("", |g| &g.occupied);
    let _ = writeln!(
        out,
        "<p>Lattice <code>{}</code>: {} × {} × {} cells; occupied where the value is <code>{}</code>: {} cells taken.</p>",
        escape(file),
        lattice.shape[0],
        lattice.shape[1],
        lattice.shape[2],
        escape(rule),
        r.cells
    );
    *out += "<table><tr><th></th><th class=\"n\">x</th><th class=\"n\">y</th><th class=\"n\">z</th></tr>\n";
    let mut row = |title: &str, value: &dyn Fn(usize) -> String| {
        let cells: String = (0..3).map(|a| format!("<td class=\"n\">{}</td>", value(a))).collect();
        let _ = writeln!(out, "<tr><td>{title}</td>{cells}</tr>");
    };
    row("centre of the lattice's cell (0, 0, 0), m", &|a| plain(lattice.minbound[a]));
    row("cell in the lattice, m", &|a| plain(lattice.unit[a]));
    row("module of the house, m", &|a| plain(page.brief.plot.module_m[a]));
    row("modules per cell", &|a| r.cell_modules[a].to_string());
    row("modules per cell that come nearest to its size", &|a| r.default_cell_modules[a].to_string());
    row("scale (1 = true to size)", &|a| format!("{:.4}", r.scale[a]));
    row("rounding error of a cell (in modules less in the lattice), m", &|a| format!("{:+.3}", r.error_m[a]));
    row("the same over all cells taken, m", &|a| format!("{:+.3}", r.error_m[a] * (map.past[a] - map.first[a]) as f64));
    row("first cell taken", &|a| map.first[a].to_string());
    row("last cell taken", &|a| (map.past[a] - 1).to_string());
    row("module at which the first one starts", &|a| map.offset[a].to_string());
    *out += "</table>\n<p class=\"m\">Cell i covers the modules from offset + (i − first) × modules per cell on; its centre in the lattice's coordinates is that of cell 0 plus i × cell. Below, cells are named by their indices and centres in the lattice.</p>\n";
}

fn house_part(out: &mut String, page: &Page, id: u64, name: &str, house: &House) {
    let reading = Reading::new(page.given, page.labels(), house);
    let word = page.word();
    let title = if name.is_empty() { format!("House {id}") } else { format!("House {id}: {}", escape(name)) };
    let _ = writeln!(
        out,
        "<h2 id=\"house-{id}\">{title}</h2>\n<p>{} cells kept, {} removed, {} added; {} modules of rooms lie beyond the lattice.</p>",
        reading.count(Fate::Kept),
        reading.count(Fate::Removed),
        reading.count(Fate::Added),
        reading.beyond
    );
    let _ = writeln!(
        out,
        "<table><tr><th>{word}</th><th class=\"n\">cells given</th><th class=\"n\">kept</th><th class=\"n\">removed</th><th class=\"n\">gross area, m²</th><th>asked, m²</th></tr>"
    );
    let asked = &page.brief.programme.zones;
    let others = asked.iter().map(|z| z.zone).filter(|z| !reading.zones.contains_key(z));
    let mut ids: Vec<i32> = reading.zones.keys().copied().chain(others).collect();
    ids.sort_unstable();
    for zone in ids {
        let counts = reading.zones.get(&zone).copied().unwrap_or_default();
        let wanted = asked.iter().find(|z| z.zone == zone);
        let code = u8::try_from(zone).ok().filter(|_| page.labels()).and_then(Label::from_code);
        let label = wanted.map(|z| escape(&z.name)).or(code.map(|label| label.name().to_owned()));
        let label = label.map_or(String::new(), |name| format!(" {name}"));
        let area = if page.labels() { "–".to_owned() } else { format!("{:.1}", counts.area_m2) };
        let range = wanted.map_or_else(String::new, |z| {
            let miss = out_of(z.area_m2, counts.area_m2);
            let [least, most] = z.area_m2;
            match miss > 0.0 {
                true => format!("{least:.1} to {most:.1} <span class=\"no\">missed by {:.1} %</span>", 100.0 * miss),
                false => format!("{least:.1} to {most:.1}"),
            }
        });
        let _ = writeln!(
            out,
            "<tr><td><i class=\"k\" style=\"background:{};margin-left:0\"></i>{zone}{label}</td><td class=\"n\">{}</td><td class=\"n\">{}</td><td class=\"n\">{}</td><td class=\"n\">{area}</td><td>{range}</td></tr>",
            colour(page.given, zone),
            counts.given,
            counts.kept,
            counts.removed
        );
    }
    let _ = write!(
        out,
        "</table>\n<p><i class=\"k\" style=\"background:#567;margin-left:0\"></i>kept, in its {word}'s colour<i class=\"k\" style=\"background:repeating-linear-gradient(45deg,#a11 0 2px,#fff 2px 5px)\"></i>removed<i class=\"k\" style=\"background:#d5d2ca\"></i>added</p>\n<div class=\"plans\">\n"
    );
    let map = &page.given.map;
    let storeys = read_storeys(house).storeys.len();
    for z in map.first[2]..map.past[2] {
        if reading.cells.iter().any(|c| c.cell[2] == z) {
            plan(out, page, &reading, house, z, storeys);
        }
    }
    *out += "</div>\n";
    for (fate, what) in [(Fate::Removed, "removed"), (Fate::Added, "added"), (Fate::Kept, "kept")] {
        list(out, page, &reading, fate, what);
    }
}

fn list(out: &mut String, page: &Page, reading: &Reading, fate: Fate, what: &str) {
    let cells: Vec<&Cell> = reading.cells.iter().filter(|c| c.fate == fate).collect();
    if cells.is_empty() {
        return;
    }
    let _ = writeln!(out, "<details><summary>{} cells {what}</summary><p><code>", cells.len());
    for one in cells.iter().take(LISTED) {
        let [i, j, k] = one.cell;
        let [x, y, z] = centre(page.lattice, one.cell).map(plain);
        let zone = one.zone.map_or(String::new(), |z| format!(" {} {z}", page.word()));
        let share = if one.filled < 1.0 { format!(" {:.0} % filled", 100.0 * one.filled) } else { String::new() };
        let _ = write!(out, "[{i}, {j}, {k}] at ({x}, {y}, {z}){zone}{share}<br>");
    }
    if cells.len() > LISTED {
        let _ = write!(out, "and {} more", cells.len() - LISTED);
    }
    *out += "</code></p></details>\n";
}

/// One layer of the lattice: given cells as frames, filled room modules, north up.
fn plan(out: &mut String, page: &Page, reading: &Reading, house: &House, z: usize, storeys: usize) {
    let map = &page.given.map;
    let [nx, ny, _] = house.voxels.shape();
    let (width, height) = (nx * SIDE + 2, ny * SIDE + 2);
    let low = map.module([map.first[0], map.first[1], z]).map_or(0, |m| m[2]);
    // The first room layer of the cells: a plate says nothing of a room.
    let k = if low.is_multiple_of(STOREY_MODULES) && map.size[2] > 1 { low + 1 } else { low };
    let centre_z = plain(centre(page.lattice, [0, 0, z])[2]);
    let _ = writeln!(
        out,
        "<figure><svg width=\"{width}\" height=\"{height}\" viewBox=\"-1 -1 {width} {height}\" role=\"img\" aria-label=\"layer {z}\"><rect width=\"{}\" height=\"{}\" fill=\"#faf9f6\" stroke=\"#bbb\"/>",
        nx * SIDE,
        ny * SIDE
    );
    let rect = |x: usize, y: usize, w: usize, h: usize, style: &str| {
        let top = (ny - y - h) * SIDE;
        format!("<rect x=\"{}\" y=\"{top}\" width=\"{}\" height=\"{}\" {style}/>", x * SIDE, w * SIDE, h * SIDE)
    };
    let inside = |at: [usize; 3]| at[0] + map.size[0] <= nx && at[1] + map.size[1] <= ny;
    let layer: Vec<(&Cell, [usize; 3])> = reading
        .cells
        .iter()
        .filter(|c| c.cell[2] == z)
        .filter_map(|c| Some((c, map.module(c.cell)?)))
        .filter(|(_, at)| inside(*at))
        .collect();
    for (_, at) in layer.iter().filter(|(c, _)| c.fate == Fate::Removed) {
        *out += &rect(at[0], at[1], map.size[0], map.size[1], "fill=\"url(#gone)\"");
    }
    for (x, y) in (0..ny).flat_map(|y| (0..nx).map(move |x| (x, y))) {
        let room = k < storeys * STOREY_MODULES && house.voxels.at([x, y, k].map(|v| v as isize)).is_filled();
        if room {
            let given = layer.iter().find(|(c, _)| map.cell([x, y, low]) == Some(c.cell)).and_then(|(c, _)| c.zone);
            let fill = given.map_or_else(|| "#d5d2ca".to_owned(), |zone| colour(page.given, zone));
            *out += &rect(x, y, 1, 1, &format!("fill=\"{fill}\" stroke=\"#fff\" stroke-width=\".5\""));
        }
    }
    for (one, at) in layer.iter().filter(|(c, _)| c.zone.is_some()) {
        let stroke = if one.fate == Fate::Removed { "#a11" } else { "#222" };
        let tip = format!("fill=\"none\" stroke=\"{stroke}\" stroke-width=\"1.2\"");
        *out += &rect(at[0], at[1], map.size[0], map.size[1], &tip);
        let (x, y) = (at[0] * SIDE + 3, (ny - at[1] - map.size[1]) * SIDE + 9);
        let _ = write!(
            out,
            "<text x=\"{x}\" y=\"{y}\" font-size=\"7\" fill=\"#222\" paint-order=\"stroke\" stroke=\"#fff\" stroke-width=\"1.6\">{},{}</text>",
            one.cell[0], one.cell[1]
        );
    }
    let _ = writeln!(
        out,
        "</svg><figcaption>layer {z} of the lattice, centre at {centre_z} m; north up, cells as i, j</figcaption></figure>"
    );
}

/// Colour of a zone: even steps of a ramp that is told apart by lightness too, its darkest and lightest ends left out.
fn colour(given: &Given, zone: i32) -> String {
    let most = given.mask.iter().copied().max().unwrap_or(0).max(1);
    let [r, g, b] = viridis(0.25 + 0.7 * f64::from(zone) / f64::from(most));
    format!("#{r:02x}{g:02x}{b:02x}")
}

/// A number as short as it is.
fn plain(value: f64) -> String {
    let text = format!("{value:.3}");
    let text = text.trim_end_matches('0').trim_end_matches('.');
    if text == "-0" { "0".into() } else { text.to_owned() }
}
