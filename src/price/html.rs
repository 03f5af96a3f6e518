//! The quote as one self-contained HTML page that prints on two sheets.

use std::fmt::Write;

use super::{Quote, QuoteSurcharge, Range};
use crate::quantities::Group;

const STYLE: &str = "body{font:10pt/1.4 system-ui,sans-serif;margin:2em auto;max-width:52em;color:#222}h1{margin:0}\
table{border-collapse:collapse;width:100%;margin:.6em 0}td,th{padding:.15em .4em;border-bottom:1px solid #ddd;vertical-align:top;text-align:left}\
.n{text-align:right;white-space:nowrap;font-variant-numeric:tabular-nums}.g td{font-weight:600;background:#f3f1ec}\
.t td{font-weight:600;border-top:2px solid #222}.m{color:#666;font-size:9pt}\
@media print{body{margin:0;max-width:none;font-size:8.5pt}tr{break-inside:avoid}@page{size:A4;margin:14mm}}";

/// The quote as an HTML page; the same record as the JSON.
pub fn quote_html(quote: &Quote) -> String {
    let mut page = format!(
        "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>Quote: {name}</title><style>{STYLE}</style></head><body>\n\
         <h1>{name}</h1>\n<p><strong>{notice}</strong> {basis} {rounding} Amounts in {currency}.</p>\n\
         <p>Net floor area {area:.1} m2 (inside the wall lining, headroom at least 1.5 m, without voids, stairs and decks).</p>\n",
        name = escape(&quote.name),
        notice = escape(&quote.notice),
        basis = escape(&quote.basis),
        rounding = escape(&quote.rounding),
        currency = escape(&quote.currency),
        area = quote.floor_area_m2,
    );
    page += "<table>\n<tr><th>No.</th><th>Description</th><th class=\"n\">Quantity</th><th>Unit</th><th class=\"n\">Rate</th><th class=\"n\">Amount</th><th class=\"n\">Low - high</th></tr>\n";
    for group in Group::ALL {
        group_rows(&mut page, quote, group.name());
    }
    total_row(&mut page, "Subtotal, net of overhead and VAT", quote.subtotal);
    quote.surcharges.iter().for_each(|s| surcharge_row(&mut page, s));
    total_row(&mut page, "Envelope and frame in place, net of VAT", quote.price_eur);
    quote.further.iter().for_each(|s| surcharge_row(&mut page, s));
    total_row(&mut page, "Envelope and frame with design and VAT", quote.total);
    page += "</table>\n<h2>Completion allowance</h2>\n<p class=\"m\">Shown apart, not part of the price of envelope and frame; with overhead, net of VAT.</p>\n<table>\n";
    for part in &quote.completion {
        let cells = [amount(part.quantity), "m2".into(), amount(part.rate), amount(part.amount)];
        row(&mut page, "", &part.description, &cells, [part.amount_low, part.amount_high]);
    }
    total_row(&mut page, "Complete house, net of VAT, without design", quote.complete_house);
    if let Some(per_m2) = quote.complete_house_per_m2 {
        total_row(&mut page, "Complete house per m2 of net floor area", per_m2);
    }
    page += "</table>\n";
    list(&mut page, "Included", &quote.included);
    list(&mut page, "Not included", &quote.exclusions);
    let books: Vec<String> = quote.books.iter().map(|(book, version)| format!("{book}: {version}")).collect();
    list(&mut page, "Books", &books);
    let sources: Vec<String> = quote.sources.iter().map(|(rate, source)| format!("{rate}: {source}")).collect();
    list(&mut page, "Sources of the rates", &sources);
    page + "</body></html>\n"
}

fn group_rows(page: &mut String, quote: &Quote, group: &str) {
    let lines: Vec<_> = quote.lines.iter().filter(|line| line.group == group).collect();
    if lines.is_empty() {
        return;
    }
    let sum: f64 = lines.iter().map(|line| line.amount).sum();
    let title = format!("{}{}", group[..1].to_uppercase(), &group[1..]);
    let _ = writeln!(
        page,
        "<tr class=\"g\"><td></td><td colspan=\"4\">{title}</td><td class=\"n\">{}</td><td></td></tr>",
        amount(sum)
    );
    for line in lines {
        let cells = [amount(line.quantity), line.unit.to_string(), amount(line.rate), amount(line.amount)];
        row(page, &line.line.to_string(), &line.description, &cells, [line.amount_low, line.amount_high]);
    }
}

fn row(page: &mut String, number: &str, text: &str, [quantity, unit, rate, sum]: &[String; 4], [low, high]: [f64; 2]) {
    let _ = writeln!(
        page,
        "<tr><td>{number}</td><td>{}</td><td class=\"n\">{quantity}</td><td>{unit}</td><td class=\"n\">{rate}</td><td class=\"n\">{sum}</td><td class=\"n m\">{} - {}</td></tr>",
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
        "<tr class=\"t\"><td></td><td colspan=\"4\">{}</td><td class=\"n\">{default}</td><td class=\"n m\">{low} - {high}</td></tr>",
        escape(text)
    );
}

fn list(page: &mut String, title: &str, entries: &[String]) {
    let _ = writeln!(page, "<h2>{title}</h2>\n<ul class=\"m\">");
    for entry in entries {
        let _ = writeln!(page, "<li>{}</li>", escape(entry));
    }
    page.push_str("</ul>\n");
}

/// Two decimals with thin thousands groups: `12 345.60`.
fn amount(value: f64) -> String {
    let text = format!("{:.2}", value.abs());
    let (whole, rest) = text.split_at(text.len() - 3);
    let mut grouped = String::new();
    for (index, digit) in whole.chars().enumerate() {
        if index > 0 && (whole.len() - index).is_multiple_of(3) {
            grouped.push('\u{202f}');
        }
        grouped.push(digit);
    }
    format!("{}{grouped}{rest}", if value < 0.0 { "-" } else { "" })
}

/// Text as it may stand in HTML.
pub fn escape(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}
