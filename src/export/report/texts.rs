//! What a run assumes, in full: texts of quotes, structures and carbon accounts, with the factors and sources they name.

use std::collections::HashMap;

use serde::Serialize;
use serde_json::Value;

/// A list of texts under one heading.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct TextGroup {
    /// Where they come from.
    pub title: &'static str,
    /// The texts, in their order.
    pub items: Vec<TextItem>,
}

/// A text, where it comes from, and in how many houses it holds.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct TextItem {
    /// The text.
    pub text: String,
    /// Its source; empty where the text is its own.
    pub source: String,
    /// Houses that have it.
    pub houses: usize,
}

/// Headings in the order of the page.
const TITLES: [&str; 10] = [
    "Structure: assumptions",
    "Structure: not assessed",
    "Structure: basis",
    "Structure: loads and factors",
    "Structure: serviceability, and values that stand in",
    "Quote: assumed",
    "Quote: included",
    "Quote: not included",
    "Quote: rates and their sources",
    "Carbon: how the numbers are to be read",
];

/// A text and its source.
type Sourced = (String, String);

/// The texts of one house, a list for each of the headings.
pub type HouseTexts = [Vec<Sourced>; TITLES.len()];

/// The texts of a house out of `structure.json`, `quote.json` and `carbon.json`; null for a file that is not there.
pub fn of_house(structure: &Value, quote: &Value, carbon: &Value) -> HouseTexts {
    let loads = &structure["loads"];
    [
        lines(&structure["assumptions"]),
        lines(&structure["not_assessed"]),
        pairs(&structure["basis"]),
        actions(&loads["actions"]),
        [lines(&loads["serviceability"]), lines(&loads["stand_ins"])].concat(),
        lines(&quote["assumptions"]),
        lines(&quote["included"]),
        lines(&quote["exclusions"]),
        rates(&quote["sources"]),
        [lines(&carbon["rules"]), own(&carbon["heat_loss_basis"])].concat(),
    ]
}

/// Each text once, with the number of houses that have it; headings without texts are left out.
pub fn merged(houses: &[HouseTexts]) -> Vec<TextGroup> {
    let group = |(at, title): (usize, &'static str)| {
        let mut items: Vec<TextItem> = Vec::new();
        let mut places: HashMap<&Sourced, usize> = HashMap::new();
        for pair in houses.iter().flat_map(|house| &house[at]) {
            let place = *places.entry(pair).or_insert(items.len());
            match items.get_mut(place) {
                Some(item) => item.houses += 1,
                None => items.push(TextItem { text: pair.0.clone(), source: pair.1.clone(), houses: 1 }),
            }
        }
        TextGroup { title, items }
    };
    let groups = TITLES.into_iter().enumerate().map(group);
    groups.filter(|group| !group.items.is_empty()).collect()
}

fn own(value: &Value) -> Vec<Sourced> {
    value.as_str().map(|text| (text.to_owned(), String::new())).into_iter().collect()
}

fn lines(value: &Value) -> Vec<Sourced> {
    value.as_array().into_iter().flatten().map(|v| (plain(v), String::new())).collect()
}

fn pairs(value: &Value) -> Vec<Sourced> {
    let one = |(key, value): (&String, &Value)| (format!("{}: {}", key.replace('_', " "), plain(value)), String::new());
    value.as_object().into_iter().flatten().map(one).collect()
}

fn rates(value: &Value) -> Vec<Sourced> {
    let one = |(rate, source): (&String, &Value)| (rate.replace('_', " "), plain(source));
    value.as_object().into_iter().flatten().map(one).collect()
}

fn actions(value: &Value) -> Vec<Sourced> {
    let one = |row: &Value| {
        let unit = row["unit"].as_str().filter(|unit| *unit != "-").unwrap_or_default();
        let text = format!("{}: {} {unit}", plain(&row["action"]), plain(&row["value"]));
        (text.trim_end().to_owned(), row["source"].as_str().unwrap_or_default().to_owned())
    };
    value.as_array().into_iter().flatten().map(one).collect()
}

/// A value as a person writes it, numbers with four digits.
pub fn plain(value: &Value) -> String {
    match value {
        Value::Null => "none".into(),
        Value::String(text) => text.clone(),
        Value::Number(number) => number.as_f64().map_or_else(|| number.to_string(), digits),
        Value::Array(list) => list.iter().map(plain).collect::<Vec<_>>().join(", "),
        Value::Object(map) => {
            map.iter().map(|(k, v)| format!("{}: {}", k.replace('_', " "), plain(v))).collect::<Vec<_>>().join("; ")
        }
        Value::Bool(yes) => if *yes { "yes" } else { "no" }.into(),
    }
}

fn digits(value: f64) -> String {
    if value.fract() == 0.0 {
        return format!("{value:.0}");
    }
    let decimals = (3 - value.abs().max(1e-9).log10().floor() as i32).clamp(0, 9) as usize;
    let text = format!("{value:.decimals$}");
    if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.').to_owned() } else { text }
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    #[test]
    fn a_text_of_several_houses_is_there_once() {
        let house = |own: &str| of_house(&json!({"assumptions": ["pinned", own]}), &json!({}), &Value::Null);
        let groups = merged(&[house("a"), house("b")]);
        assert_eq!(groups.len(), 1);
        let told: Vec<(&str, usize)> = groups[0].items.iter().map(|i| (i.text.as_str(), i.houses)).collect();
        assert_eq!(told, [("pinned", 2), ("a", 1), ("b", 1)]);
    }

    #[test]
    fn a_load_has_its_unit_and_source() {
        let row = json!({"loads": {"actions": [{"action": "snow", "value": [0.70000001, 2], "unit": "kN/m2", "source": "EN"}]}});
        let texts = of_house(&row, &Value::Null, &Value::Null);
        assert_eq!(texts[3], [("snow: 0.7, 2 kN/m2".to_owned(), "EN".to_owned())]);
    }
}
