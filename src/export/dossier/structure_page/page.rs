//! HTML in small pieces: headings, tables, lists.

use std::fmt::Write;

pub use crate::price::escape;

const STYLE: &str = "body{font:9.5pt/1.4 system-ui,'Segoe UI',Helvetica,Arial,sans-serif;margin:2em auto;padding:0 1em;max-width:60em;color:#222}\
h1{margin:0 0 .3em;font-size:1.6em}h2{margin:1.5em 0 .3em;font-size:1.15em;border-bottom:2px solid #222;break-after:avoid}\
table{border-collapse:collapse;width:100%;margin:.4em 0}td,th{padding:.14em .9em .14em 0;border-bottom:1px solid #ddd;vertical-align:top;text-align:left}\
th{font-weight:600;border-bottom:1px solid #888}thead{display:table-header-group}.n{text-align:right;font-variant-numeric:tabular-nums}.n,.w{white-space:nowrap}td:last-child,th:last-child{padding-right:0}\
.m{color:#555;font-size:.92em}.verdict{padding:.5em .8em;border-left:6px solid}.good{border-color:#3F7A4B;background:#EEF5EF}.bad{border-color:#9E2A1F;background:#F8ECEA}\
.open{border-color:#8A6D1D;background:#F8F4E6}.over td{background:#F8ECEA}figure{margin:.8em 0;break-inside:avoid}figure svg{display:block;width:100%;height:auto}\
figcaption{margin-top:.2em}.key{display:inline-block;margin-right:1em;white-space:nowrap}.key i{display:inline-block;width:.9em;height:.9em;margin-right:.35em;vertical-align:-.1em;border:1px solid #999}\
.small table{font-size:.9em}.small td,.small th{padding-right:.6em}.pair{display:grid;grid-template-columns:1fr 1fr;gap:0 1.5em}ul{margin:.3em 0;padding-left:1.3em}\
@media print{body{margin:0;padding:0;max-width:none;font-size:8pt}tr{break-inside:avoid}.verdict,.key i,.over td{print-color-adjust:exact;-webkit-print-color-adjust:exact}@page{size:A4;margin:14mm 12mm}}";

/// A page in the making.
pub struct Page {
    text: String,
}

impl Page {
    /// An empty page.
    pub fn new(title: &str) -> Page {
        Page {
            text: format!(
                "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><meta name=\"viewport\" content=\"width=device-width\"><title>{}</title><style>{STYLE}</style></head><body>\n",
                escape(title)
            ),
        }
    }

    /// HTML as it is.
    pub fn raw(&mut self, html: &str) {
        self.text.push_str(html);
    }

    /// A heading.
    pub fn heading(&mut self, title: &str) {
        let _ = writeln!(self.text, "<h2>{}</h2>", escape(title));
    }

    /// A paragraph in small print.
    pub fn note(&mut self, text: &str) {
        let _ = writeln!(self.text, "<p class=\"m\">{}</p>", escape(text));
    }

    /// Entries with dots.
    pub fn list(&mut self, entries: &[impl AsRef<str>]) {
        self.text.push_str("<ul class=\"m\">\n");
        for entry in entries {
            let _ = writeln!(self.text, "<li>{}</li>", escape(entry.as_ref()));
        }
        self.text.push_str("</ul>\n");
    }

    /// A table. A title that begins with `#` heads a column of numbers, one with `=` words that are not broken.
    pub fn table<const N: usize>(&mut self, titles: &[&str; N], rows: &[[String; N]]) {
        self.marked_table(titles, rows.iter().map(|r| (r, false)));
    }

    /// As [`Page::table`]; marked rows stand out.
    pub fn marked_table<'r, const N: usize>(
        &mut self,
        titles: &[&str; N],
        rows: impl Iterator<Item = (&'r [String; N], bool)>,
    ) {
        let class = |n: usize| match titles[n].as_bytes().first() {
            Some(b'#') => " class=\"n\"",
            Some(b'=') => " class=\"w\"",
            _ => "",
        };
        self.text.push_str("<table>");
        if titles.iter().any(|t| !t.trim_start_matches(['#', '=']).is_empty()) {
            self.text.push_str("<thead><tr>");
            for (n, title) in titles.iter().enumerate() {
                let _ = write!(self.text, "<th{}>{}</th>", class(n), escape(title.trim_start_matches(['#', '='])));
            }
            self.text.push_str("</tr></thead>");
        }
        self.text.push_str("\n<tbody>\n");
        for (row, marked) in rows {
            self.text.push_str(if marked { "<tr class=\"over\">" } else { "<tr>" });
            for (n, cell) in row.iter().enumerate() {
                let _ = write!(self.text, "<td{}>{}</td>", class(n), escape(cell));
            }
            self.text.push_str("</tr>\n");
        }
        self.text.push_str("</tbody></table>\n");
    }

    /// A drawing with its caption and a key of colours.
    pub fn figure(&mut self, svg: &str, caption: &str, key: &[(u32, &str)]) {
        let _ = write!(self.text, "<figure>{svg}<figcaption class=\"m\">{}<br>", escape(caption));
        for (colour, name) in key {
            let _ = write!(
                self.text,
                "<span class=\"key\"><i style=\"background:#{colour:06X}\"></i>{}</span> ",
                escape(name)
            );
        }
        self.text.push_str("</figcaption></figure>\n");
    }

    /// The whole page.
    pub fn finish(mut self) -> String {
        self.text.push_str("</body></html>\n");
        self.text
    }
}

/// A number with fixed decimals; no negative zero.
pub fn fixed(value: f64, decimals: usize) -> String {
    let text = format!("{value:.decimals$}");
    if text.starts_with('-') && text.bytes().all(|b| matches!(b, b'-' | b'0' | b'.')) {
        text[1..].to_owned()
    } else {
        text
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_have_no_negative_zero() {
        assert_eq!([fixed(-0.001, 2), fixed(-0.01, 2), fixed(12.345, 1)], ["0.00", "-0.01", "12.3"]);
    }

    #[test]
    fn text_cannot_become_markup() {
        let mut page = Page::new("a < b");
        page.table(&["<i>"], &[["\"&\"".to_owned()]]);
        let text = page.finish();
        assert!(
            text.contains("a &lt; b")
                && text.contains("<th>&lt;i&gt;</th>")
                && text.contains("<td>&quot;&amp;&quot;</td>")
        );
    }
}
