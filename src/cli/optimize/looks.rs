//! The front in groups of houses that look alike.

use houscaper::export::dossier::Dossier;
use houscaper::export::plots::{self, Card, Group};
use houscaper::export::tables::{Cell, csv};
use houscaper::run::RunFolder;
use houscaper::search::clusters::{Clusters, clusters};
use houscaper::search::knee::{knees, normalised, trade_offs};
use houscaper::search::look::{Distances, Look, shared};
use houscaper::search::select::Named;
use serde_json::json;

use super::Job;
use super::results::{FrontHouse, caption};
use crate::cli::failure::{Blame, Failure};

/// Pictures of a group at most.
const SHOWN: usize = 10;

/// Pictures in a row.
const COLUMNS: usize = 5;

/// The groups of a front.
pub struct Looks {
    /// The look of each house.
    looks: Vec<Look>,
    /// Their groups.
    pub clusters: Clusters,
}

impl Looks {
    /// Groups a front.
    pub fn of(job: &Job, front: &[FrontHouse]) -> Looks {
        let look = |h: &FrontHouse| {
            let [wall, ..] = job.evaluator.sections(&h.design.choices);
            Look::of(&h.design, &job.space.plot.module, job.evaluator.catalogue.material(wall).id.clone())
        };
        let looks: Vec<Look> = front.iter().map(look).collect();
        let distances = Distances::new(&looks);
        let clusters = clusters(looks.len(), &|a, b| distances.between(a, b));
        Looks { clusters, looks }
    }

    /// What the houses of a group share.
    pub fn shared(&self, group: usize) -> String {
        let members: Vec<&Look> = self.clusters.members(group).into_iter().map(|i| &self.looks[i]).collect();
        shared(&members)
    }

    /// A line for people for each group: how many, what they share, and the one in the middle.
    pub fn words(&self, front: &[FrontHouse]) -> Vec<String> {
        let one = |group: usize| {
            let members = self.clusters.members(group);
            let houses = if members.len() == 1 { "house" } else { "houses" };
            format!("{} {houses}: {} (in the middle: {})", members.len(), self.shared(group), front[members[0]].id)
        };
        (0..self.clusters.medoids.len()).map(one).collect()
    }

    /// For `--json`.
    pub fn report(&self, front: &[FrontHouse]) -> serde_json::Value {
        let group = |g: usize| {
            let ids: Vec<u64> = self.clusters.members(g).into_iter().map(|i| front[i].id).collect();
            json!({"medoid": ids[0], "houses": ids, "shared": self.shared(g)})
        };
        let groups: Vec<serde_json::Value> = (0..self.clusters.medoids.len()).map(group).collect();
        json!({"silhouette": self.clusters.silhouette, "structure": self.clusters.structure(), "groups": groups})
    }
}

/// Writes `clusters.csv`: each house of the front with its group, what is seen of it, and how sharp a knee it is.
pub fn write(looks: &Looks, front: &[FrontHouse], folder: &RunFolder) -> Result<(), Failure> {
    let header = [
        "id",
        "cluster",
        "is_medoid",
        "storeys",
        "footprint_m2",
        "corners",
        "aspect",
        "setback",
        "overhang",
        "roof_rise",
        "glass_east_m2",
        "glass_north_m2",
        "glass_west_m2",
        "glass_south_m2",
        "wall_material",
        "trade_off",
        "is_knee",
        "shared",
    ];
    let points: Vec<&[f64]> = front.iter().map(|h| h.objectives.as_slice()).collect();
    let (trade_offs, knees) = (trade_offs(&normalised(&points)), knees(&points));
    let row = |i: usize| {
        let (look, group) = (&looks.looks[i], looks.clusters.of[i]);
        let is_medoid = looks.clusters.medoids.contains(&i);
        let mut cells = vec![
            Cell::Count(front[i].id as i64),
            Cell::Count(group as i64 + 1),
            Cell::Flag(is_medoid),
            Cell::Count(look.storeys as i64),
            Cell::Number(look.footprint_m2),
            Cell::Count(look.corners as i64),
            Cell::Number(look.aspect),
            Cell::Number(look.setback),
            Cell::Number(look.overhang),
            Cell::Count(look.roof_rise as i64),
        ];
        cells.extend(look.glass_m2.map(Cell::Number));
        cells.extend([
            Cell::Text(look.material.clone()),
            Cell::Number(trade_offs[i]),
            Cell::Flag(knees.iter().any(|k| k.index == i)),
            if is_medoid { Cell::Text(looks.shared(group)) } else { Cell::Empty },
        ]);
        cells
    };
    folder.write("clusters.csv", csv(&header, (0..front.len()).map(row)).as_bytes()).run()
}

/// Writes the contact sheet by group: the house in the middle first, then the others evenly, the named ones always.
pub fn write_sheet(
    job: &Job,
    looks: &Looks,
    front: &[FrontHouse],
    named: &[Named],
    dossiers: &[Dossier],
    folder: &RunFolder,
) -> Result<(), Failure> {
    let name_of = |index: usize| named.iter().find(|n| n.index == index).map(|n| n.name.as_str());
    let group = |g: usize| {
        let members = looks.clusters.members(g);
        let shown = shown(&members, &|i| name_of(i).is_some());
        let count = match members.len() {
            1 => "1 house".to_owned(),
            all if shown.len() < all => format!("{} of {all} houses", shown.len()),
            all => format!("{all} houses"),
        };
        let heading = format!("{}. {count}: {}", g + 1, looks.shared(g));
        let card = |&index: &usize| {
            let mut title = front[index].id.to_string();
            if index == members[0] {
                title += " · in the middle";
            }
            if let Some(name) = name_of(index) {
                title = format!("{title} · {name}");
            }
            Card { title, caption: caption(&front[index].evaluation), image: dossiers[index].picture.clone() }
        };
        Group { heading, cards: shown.iter().map(card).collect() }
    };
    let groups: Vec<Group> = (0..looks.clusters.medoids.len()).map(group).collect();
    let title = format!("{}: the {} houses of the front by look", job.evaluator.brief.name, front.len());
    folder.write("plots/clusters.png", &plots::grouped_sheet(&title, COLUMNS, &groups).run()?).run()
}

/// The medoid, the named ones, and evenly many of the rest in their order.
fn shown(members: &[usize], is_named: &dyn Fn(usize) -> bool) -> Vec<usize> {
    let Some((&medoid, others)) = members.split_first() else { return Vec::new() };
    let (mut kept, rest): (Vec<usize>, Vec<usize>) = others.iter().partition(|&&i| is_named(i));
    let room = SHOWN.saturating_sub(1 + kept.len()).min(rest.len());
    kept.extend((0..room).map(|n| rest[n * rest.len() / room]));
    kept.sort_unstable();
    kept.insert(0, medoid);
    kept
}
