//! Numbers a published example expects.

use std::collections::BTreeMap;

use houscaper::structure::member::MemberReport;
use serde::Deserialize;
use serde_json::Value;

/// Expected values by key.
#[derive(Clone, Debug, Default)]
pub struct Expected(BTreeMap<String, Published>);

#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct Published {
    value: f64,
    rel_tol: f64,
}

/// How far results agree with them.
pub struct Agreement {
    /// How many were compared.
    pub compared: usize,
    /// What is off or not among the results.
    pub off: Vec<String>,
}

impl Expected {
    /// From the `expected` object of a file; nothing when it is missing.
    pub fn read(value: Option<Value>) -> Result<Expected, serde_json::Error> {
        value.map_or(Ok(Expected::default()), |v| serde_json::from_value(v).map(Expected))
    }

    /// Whether nothing is expected.
    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// Against a report.
    pub fn compare(&self, report: &MemberReport) -> Agreement {
        let off = self.0.iter().filter_map(|(key, p)| match report.value(key) {
            None => Some(format!("{key} is not among the results")),
            Some(own) if (own - p.value).abs() <= p.rel_tol * p.value.abs() => None,
            Some(own) => Some(format!("{key}: {own:.5}, published {} within {} of it", p.value, p.rel_tol)),
        });
        Agreement { compared: self.0.len(), off: off.collect() }
    }
}
