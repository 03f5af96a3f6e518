//! A whole front compared: one chart of all houses in all systems, and a page around it.

use std::fmt::Write;

use super::plots::{PlotError, SystemHouse, SystemPoint, systems_front};
use crate::price::{Stage, escape};
use crate::score::{Account, Comparison, Variant};

const STYLE: &str = "body{font:10pt/1.45 system-ui,sans-serif;margin:2em auto;max-width:70em;color:#222}h1{margin:0}\
table{border-collapse:collapse;margin:.6em 0}td,th{padding:.2em .8em .2em 0;border-bottom:1px solid #ddd;text-align:left}\
.n{text-align:right;white-space:nowrap;font-variant-numeric:tabular-nums}.m{color:#666;font-size:9pt}svg{max-width:100%;height:auto}\
@media print{body{margin:0;max-width:none}@page{size:A4 landscape;margin:12mm}}";

/// A front in several systems.
pub struct ComparedFront<'a> {
    /// Its name.
    pub name: &'a str,
    /// Names of the systems.
    pub systems: &'a [String],
    /// Names of the houses, and each in the systems.
    pub houses: Vec<(&'a str, &'a Comparison)>,
}

impl ComparedFront<'_> {
    fn variant<'c>(comparison: &'c Comparison, system: &str) -> Option<&'c Variant> {
        comparison.variants.iter().find(|v| v.system == system)
    }

    /// Price against carbon of all houses as SVG.
    ///
    /// # Errors
    /// When drawing fails.
    pub fn chart(&self) -> Result<String, PlotError> {
        let point = |v: &Variant| SystemPoint { price: v.price(), carbon: v.carbon(), stands: v.is_ok() };
        let house = |(name, comparison): &(&str, &Comparison)| SystemHouse {
            name: (*name).to_owned(),
            points: self.systems.iter().map(|s| Self::variant(comparison, s).map(point)).collect(),
        };
        let houses: Vec<SystemHouse> = self.houses.iter().map(house).collect();
        systems_front(&format!("{}: {} houses in each system", self.name, houses.len()), self.systems, &houses)
    }

    /// What becomes of the order by fossil carbon over the front, in a sentence for each account.
    pub fn order_sentences(&self) -> Vec<String> {
        let orders = |account: Account| self.houses.iter().map(move |(_, c)| c.ranks(account));
        let first: Vec<_> = orders(Account::Fossil).collect();
        let standing = |ranks: &[Option<usize>]| ranks.iter().flatten().count() > 1;
        let asked = first.iter().filter(|r| standing(r)).count();
        let same = |account: Account| orders(account).zip(&first).filter(|(r, f)| standing(f) && r == *f).count();
        let mut told = vec![format!(
            "The order by fossil carbon A1-A3 is the same in every account in {} of {asked} houses that stand in two systems or more",
            self.houses.iter().filter(|(_, c)| c.order_is_kept() == Some(true)).count()
        )];
        told.extend(Account::ALL[1..].iter().map(|a| format!("{}: it stays in {} of {asked}", a.words(), same(*a))));
        told
    }

    /// The page around the chart.
    ///
    /// # Errors
    /// When drawing fails.
    pub fn html(&self) -> Result<String, PlotError> {
        let mut page = format!(
            "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>{name}: a front in several materials</title><style>{STYLE}</style></head><body>\n<h1>{name}: the front in {systems}</h1>\n{chart}",
            name = escape(self.name),
            systems = escape(&self.systems.join(", ")),
            chart = self.chart()?
        );
        page += "<table><tr><th>System</th><th class=\"n\">stands in</th><th class=\"n\">cheapest</th><th class=\"n\">least A1-A3</th><th class=\"n\">mean price, EUR</th><th class=\"n\">mean A1-A3, t</th><th class=\"n\">A4</th><th class=\"n\">A5</th><th class=\"n\">C3-C4</th><th class=\"n\">stored</th><th class=\"n\">D, beyond</th></tr>\n";
        for system in self.systems {
            let all = self.houses.iter().filter_map(|(_, c)| Self::variant(c, system).filter(|v| v.is_ok()));
            let standing: Vec<&Variant> = all.collect();
            let best = |value: fn(&Variant) -> f64| {
                let of = |c: &Comparison| {
                    let ok = c.variants.iter().filter(|v| v.is_ok());
                    ok.min_by(|a, b| value(a).total_cmp(&value(b))).is_some_and(|v| v.system == *system)
                };
                self.houses.iter().filter(|(_, c)| of(c)).count()
            };
            let count = standing.len().max(1) as f64;
            let mean = |value: &dyn Fn(&Variant) -> f64| standing.iter().map(|v| value(v)).sum::<f64>() / count;
            let tonnes = |value: &dyn Fn(&Variant) -> f64| format!("<td class=\"n\">{:.2}</td>", mean(value) / 1e3);
            let _ = writeln!(
                page,
                "<tr><td>{}</td><td class=\"n\">{} of {}</td><td class=\"n\">{}</td><td class=\"n\">{}</td><td class=\"n\">{:.0}</td>{}{}{}{}{}{}</tr>",
                escape(system),
                standing.len(),
                self.houses.len(),
                best(|v| v.price()[1]),
                best(|v| v.carbon()[1]),
                mean(&|v| v.price()[1]),
                tonnes(&|v| v.carbon()[1]),
                tonnes(&|v| v.stages.stage(Stage::A4).known[1]),
                tonnes(&|v| v.stages.stage(Stage::A5).known[1]),
                tonnes(&|v| v.stages.stage(Stage::C3C4).known[1]),
                tonnes(&|v| v.stages.storage),
                tonnes(&|v| v.stages.stage(Stage::D).known[1]),
            );
        }
        page += "</table>\n<p class=\"m\">Means over the houses that stand, t CO2e as far as factors are known; fossil, stored and D are never netted.</p>\n<ul>";
        self.order_sentences().iter().for_each(|s| page += &format!("<li>{}.</li>", escape(s)));
        page += "</ul>\n<p class=\"m\">Houses: ";
        let link = |(name, _): &(&str, &Comparison)| {
            let name = escape(name);
            format!("<a href=\"{name}/compare.html\">{name}</a>")
        };
        page += &self.houses.iter().map(link).collect::<Vec<_>>().join(" ");
        Ok(page + "</p>\n</body></html>\n")
    }
}
