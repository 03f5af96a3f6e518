//! The quote as one self-contained HTML page that prints on two sheets.

use std::fmt::Write;

use super::{Quote, QuoteSurcharge};
use crate::price::{Range, grouped};
use crate::quantities::{Group, Unit};

const STYLE: &str = "body{font:10pt/1.4 system-ui,sans-serif;margin:2em auto;padding:0 1em;max-width:60em;color:#222}h1{margin:0;font-size:1.7em}\
h2{font-size:1.05em;margin:.9em 0 .2em}p{margin:.3em 0}table{border-collapse:collapse;width:100%;margin:.5em 0}\
td,th{padding:.12em .4em;border-bottom:1px solid #e2dfd8;vertical-align:top;text-align:left}td.d::first-letter{text-transform:uppercase}\
.n{text-align:right;white-space:nowrap;font-variant-numeric:tabular-nums}.m{color:#5a5a5a}.g td{font-weight:600;background:#f3f1ec}\
.t td{font-weight:600;border-top:1.5px solid #222}.b{display:flex;gap:1.6em;margin:.7em 0}.b div{flex:1;border-top:3px solid #7a5c3a;padding-top:.3em}\
.b strong{display:block;font-size:1.45em;font-variant-numeric:tabular-nums}.s{font-size:.86em}.c{columns:2;column-gap:2em}.c section{break-inside:avoid}\
ul{margin:.1em 0 .4em;padding-left:1.2em}.k{display:flex;height:12px;margin:.5em 0 .2em}.k span{display:block}.l span{margin-right:1em;white-space:nowrap}\
.l i{display:inline-block;width:.8em;height:.8em;margin-right:.3em}\
@media print{body{margin:0;padding:0;max-width:none;font-size:7.4pt;line-height:1.28;print-color-adjust:exact;-webkit-print-color-adjust:exact}\
td,th{padding:.04em .35em}tr,.b,.k{break-inside:avoid}thead{display:table-header-group}.s{font-size:6.3pt}@page{size:A4;margin:11mm 13mm}}";

/// Colours of the sections, told apart by lightness too.
const COLOURS: [&str; Group::ALL.len()] =
    ["#5b3f22", "#a9825a", "#3f6d8e", "#d9c29a", "#8a8f98", "#55585e", "#c46f3b", "#8fb6a0"];

/// The quote as an HTML page; the same record as the JSON.
pub fn quote_html(quote: &Quote) -> String {
    let mut page = head(quote);
    summary(&mut page, quote);
    page += "<table>\n<thead><tr><th>No.</th><th>Description</th><th class=\"n\">Quantity</th><th>Unit</th><th class=\"n\">Rate</th><th class=\"n\">Amount</th><th class=\"n\">Low to high</th></tr></thead>\n";
    for group in Group::ALL {
        group_rows(&mut page, quote, group);
    }
    total_row(&mut page, "Subtotal, net of overhead and VAT", quote.subtotal);
    quote.surcharges.iter().for_each(|s| surcharge_row(&mut page, s));
    total_row(&mut page, "Envelope and frame in place, net of VAT", quote.price_eur);
    quote.further.iter().for_each(|s| surcharge_row(&mut page, s));
    total_row(&mut page, "Envelope and frame with design and VAT", quote.total);
    page += "</table>\n<h2>Completion allowance</h2>\n<p class=\"m\">What else a house needs before somebody moves in; shown apart, not part of the price of envelope and frame. With overhead, net of VAT, without design.</p>\n<table>\n";
    for part in &quote.completion {
        let cells = [amount(part.quantity), "m2".into(), amount(part.rate), amount(part.amount)];
        row(&mut page, "", &part.description, &cells, [part.amount_low, part.amount_high]);
    }
    total_row(&mut page, "Complete house, net of VAT, without design", quote.complete_house);
    if let Some(per_m2) = quote.complete_house_per_m2 {
        total_row(&mut page, "Complete house per m2 of floor area", per_m2);
    }
    page += "</table>\n<div class=\"c\">\n";
    list(&mut page, "Assumed", &quote.assumptions);
    list(&mut page, "Included", &quote.included);
    list(&mut page, "Not included", &quote.exclusions);
    let books: Vec<String> = quote.books.iter().map(|(book, version)| format!("{book}: {version}")).collect();
    list(&mut page, "Books", &books);
    page += "</div>\n<h2>Sources of the rates</h2>\n<ul class=\"c m s\">\n";
    for (rate, source) in quote.sources.iter().filter_map(|(rate, source)| Some((rate.strip_prefix("price ")?, source)))
    {
        let _ = writeln!(page, "<li>{}: {}</li>", escape(&rate.replace('_', " ")), escape(source));
    }
    page + "</ul>\n<p class=\"m s\">Factors of carbon and their sources are in quote.json.</p>\n</body></html>\n"
}

fn head(quote: &Quote) -> String {
    format!(
        "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>Quote {reference}: {name}</title><style>{STYLE}</style></head><body>\n\
         <h1>Quote for {name}</h1>\n<p class=\"m\">Reference {reference} \u{b7} issued {issued} \u{b7} valid until {until} \u{b7} price book {book}</p>\n\
         <p><strong>{notice}</strong> {basis} {rounding} Amounts in {currency}. Floor area {area:.1} m2, {definition}.</p>\n",
        reference = escape(&quote.reference),
        issued = escape(&quote.issued),
        until = escape(&quote.valid_until),
        book = escape(quote.books.get("prices").map_or("", String::as_str)),
        definition = escape(&quote.floor_area_definition),
        name = escape(&quote.name),
        notice = escape(&quote.notice),
        basis = escape(&quote.basis),
        rounding = escape(&quote.rounding),
        currency = escape(&quote.currency),
        area = quote.floor_area_m2,
    )
}

/// What a buyer wants to know first: two sums with their ranges, and what the money goes to.
fn summary(page: &mut String, quote: &Quote) {
    let number = |page: &mut String, text: &str, [low, default, high]: Range| {
        let [low, default, high] = [low, default, high].map(|sum| grouped(sum, 0));
        let currency = escape(&quote.currency);
        let _ = writeln!(
            page,
            "<div>{text}<strong>{currency} {default}</strong><span class=\"m\">{low} to {high}</span></div>"
        );
    };
    page.push_str("<div class=\"b\">\n");
    number(page, "Envelope and frame, net of VAT", quote.price_eur);
    number(page, "The same with design and VAT", quote.total);
    number(page, "Complete house, net of VAT", quote.complete_house);
    if let Some(per_m2) = quote.complete_house_per_m2 {
        number(page, "Complete house, each m2", per_m2);
    }
    page.push_str("</div>\n");
    let sums: Vec<(Group, f64)> =
        Group::ALL.into_iter().map(|group| (group, group_sum(quote, group))).filter(|(_, sum)| *sum > 0.0).collect();
    let whole: f64 = sums.iter().map(|(_, sum)| sum).sum();
    let (mut bar, mut legend) = (String::new(), String::new());
    for (group, sum) in &sums {
        let (share, colour) = (100.0 * sum / whole, COLOURS[*group as usize]);
        let _ = write!(bar, "<span style=\"width:{share:.2}%;background:{colour}\"></span>");
        let _ = write!(legend, "<span><i style=\"background:{colour}\"></i>{} {share:.0} %</span>", title(*group));
    }
    let _ = writeln!(page, "<div class=\"k\">{bar}</div>\n<div class=\"l m s\">{legend}</div>");
}

fn title(group: Group) -> &'static str {
    match group {
        Group::Frame => "Frame",
        Group::Envelope => "Envelope",
        Group::Openings => "Openings",
        Group::Floors => "Floors",
        Group::Stairs => "Stairs",
        Group::Foundation => "Foundation",
        Group::Manufacture => "Waste, factory labour, set-up",
        Group::Site => "Transport, assembly, labour on the plot",
    }
}

fn group_sum(quote: &Quote, group: Group) -> f64 {
    quote.lines.iter().filter(|line| line.group == group.name()).map(|line| line.amount).sum()
}

fn group_rows(page: &mut String, quote: &Quote, group: Group) {
    let lines: Vec<_> = quote.lines.iter().filter(|line| line.group == group.name()).collect();
    if lines.is_empty() {
        return;
    }
    let what = if (group as usize) < Group::Manufacture as usize { ", materials" } else { "" };
    let _ = writeln!(
        page,
        "<tr class=\"g\"><td></td><td colspan=\"4\">{}{what}</td><td class=\"n\">{}</td><td></td></tr>",
        title(group),
        amount(group_sum(quote, group))
    );
    for line in lines {
        let [quantity, unit] = match line.unit {
            Unit::Share => [format!("{:.1} %", 100.0 * line.quantity), "of".to_owned()],
            unit => [amount(line.quantity), unit.to_string()],
        };
        let cells = [quantity, unit, amount(line.rate), amount(line.amount)];
        row(page, &line.line.to_string(), &line.description, &cells, [line.amount_low, line.amount_high]);
    }
}

fn row(page: &mut String, number: &str, text: &str, [quantity, unit, rate, sum]: &[String; 4], [low, high]: [f64; 2]) {
    let _ = writeln!(
        page,
        "<tr><td>{number}</td><td class=\"d\">{}</td><td class=\"n\">{quantity}</td><td>{unit}</td><td class=\"n\">{rate}</td><td class=\"n\">{sum}</td><td class=\"n m\">{} to {}</td></tr>",
        escape(text),
        amount(low),
        amount(high)
    );
}

fn surcharge_row(page: &mut String, s: &QuoteSurcharge) {
    let cells = [format!("{:.1} %", s.percentage), String::new(), amount(s.base), amount(s.amount)];
    row(page, "", &s.description, &cells, [s.amount_low, s.amount_high]);
}

fn total_row(page: &mut String, text: &str, [low, default, high]: Range) {
    let (default, low, high) = (amount(default), amount(low), amount(high));
    let _ = writeln!(
        page,
        "<tr class=\"t\"><td></td><td colspan=\"4\">{}</td><td class=\"n\">{default}</td><td class=\"n m\">{low} to {high}</td></tr>",
        escape(text)
    );
}

fn list(page: &mut String, title: &str, entries: &[String]) {
    let _ = writeln!(page, "<section><h2>{title}</h2>\n<ul class=\"m\">");
    for entry in entries {
        let _ = writeln!(page, "<li>{}</li>", escape(entry));
    }
    page.push_str("</ul></section>\n");
}

/// Two decimals with thin thousands groups: `12 345.60`.
fn amount(value: f64) -> String {
    grouped(value, 2)
}

/// Text as it may stand in HTML.
pub fn escape(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}
