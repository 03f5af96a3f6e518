//! The carbon of a comparison: stages by system, and whether the order of the systems survives.

use serde_json::{Map, Value, json};

use super::compare::Compared;
use crate::price::{CarbonFigures, Stage};
use crate::score::{Account, Survival};

impl Compared<'_> {
    /// What becomes of the order by fossil carbon, pair by pair.
    pub fn survivals(&self) -> Vec<Survival> {
        self.evaluators.first().map_or_else(Vec::new, |e| self.comparison.survivals(&e.books.carbon))
    }

    /// The figures of a variant's materials.
    fn figures(&self, n: usize) -> CarbonFigures {
        CarbonFigures::of(&self.comparison.variants[n].materials, &self.evaluators[n].books.carbon)
    }

    /// The stages of a variant with what is unknown in each.
    pub(super) fn stages_json(&self, n: usize) -> Value {
        let (variant, figures) = (&self.comparison.variants[n], self.figures(n));
        let of = |stage: Stage| {
            let unknown = &figures.stage(stage).unknown;
            let items: Vec<&str> = variant.stages.stage(stage).unknown_items().map(|item| item.id()).collect();
            let sums =
                json!({"known_kgco2e": variant.stages.stage(stage).known, "unknown": unknown, "unknown_in": items});
            (stage.key().to_owned(), sums)
        };
        let mut stages: Map<String, Value> = Stage::ALL.into_iter().map(of).collect();
        stages.insert("biogenic_storage_kgco2".into(), json!(variant.stages.storage));
        stages.insert("biogenic_release_c3_kgco2".into(), json!(variant.stages.release));
        Value::Object(stages)
    }

    /// Rows of text for the table: places by each account, whether the order is kept, and what is unknown.
    pub(super) fn order_rows(&self) -> Vec<(String, Vec<String>)> {
        let count = self.comparison.variants.len();
        let mut rows = Vec::new();
        for account in Account::ALL {
            let title = match account {
                Account::Fossil => "place by fossil carbon A1-A3, 1 is least".to_owned(),
                other => format!("place {}", other.words()),
            };
            let place = |rank: Option<usize>| rank.map_or_else(|| "-".to_owned(), |place| place.to_string());
            rows.push((title, self.comparison.ranks(account).into_iter().map(place).collect()));
        }
        let kept = match self.comparison.order_is_kept() {
            Some(true) => "yes",
            Some(false) => "no",
            None => "-",
        };
        rows.push(("carbon order kept in all of these".to_owned(), vec![kept.to_owned(); count]));
        for stage in Stage::ALL {
            let unknown = |n: usize| self.figures(n).stage(stage).unknown.join("; ").replace('_', " ");
            rows.push((format!("unknown in {}", stage.title()), (0..count).map(unknown).collect()));
        }
        rows
    }
}
