//! The take-off shared out: each origin of each row goes to the products that hold it, so that products sum to the rows.

use std::collections::BTreeMap;

use super::pieces::{Key, Shapes};
use super::role::{Role, homes, nth};
use crate::parts::{PartKind, Parts};
use crate::quantities::{Item, Origin, OriginKind, OriginRow};
use crate::tiles::Component;
use crate::voxels::STOREY_MODULES;

/// Part of a row of the take-off; index of the row, quantity in its unit.
pub(super) type Share = (usize, f64);

/// Who holds what.
#[derive(Default)]
pub(super) struct Shares {
    /// By product of solids.
    pub products: BTreeMap<Key, BTreeMap<usize, f64>>,
    /// By member of the frame: rows are those of its material.
    pub members: BTreeMap<usize, Share>,
    /// What no product of the model holds.
    pub building: BTreeMap<usize, f64>,
}

impl Shares {
    /// Shares out all rows.
    ///
    /// What was measured in a cube goes to the pieces that stand there, by the volume (or area) of the component that shows the item: of two
    /// wall panels that meet in a cube each gets its own. What was measured on a plate goes to its level, openings and stairs to their
    /// parts, members to themselves. What a drawing lacks is the building's.
    pub fn new(rows: &[OriginRow], shapes: &Shapes, cut: &Parts) -> Shares {
        let mut shares = Shares::default();
        for (row, origins) in rows.iter().enumerate() {
            for origin in &origins.origins {
                shares.add(row, origins.item, origin, shapes, cut);
            }
        }
        shares
    }

    fn add(&mut self, row: usize, item: Item, origin: &Origin, shapes: &Shapes, cut: &Parts) {
        let number = origin.id.split([' ', ',']).next().and_then(|n| n.parse::<usize>().ok());
        let (roles, components) = homes(item);
        let found = match (origin.kind, number) {
            (OriginKind::Member, Some(member)) => {
                self.members.insert(member, (row, origin.quantity));
                return;
            }
            (OriginKind::Opening, Some(n)) => of_part(shapes, roles, nth(cut, &[PartKind::Window, PartKind::Door], n)),
            (OriginKind::Stair, Some(n)) => of_part(shapes, roles, nth(cut, &[PartKind::Stair], n)),
            (OriginKind::Tile | OriginKind::TileEdge, _) => in_cube(shapes, roles, components, &origin.id),
            (OriginKind::Plate, Some(k)) => {
                let level = (k / STOREY_MODULES) as u16;
                anywhere(shapes, roles, components, |key| key.2 == level)
            }
            _ => Vec::new(),
        };
        let found = if found.is_empty() { anywhere(shapes, roles, components, |_| true) } else { found };
        let whole: f64 = found.iter().map(|(_, weight)| weight).sum();
        if found.is_empty() || whole <= 0.0 {
            *self.building.entry(row).or_default() += origin.quantity;
        }
        for (key, weight) in found {
            *self.products.entry(key).or_default().entry(row).or_default() += origin.quantity * weight / whole;
        }
    }
}

/// The products of a part in the first role that has any; alike.
fn of_part(shapes: &Shapes, roles: &[Role], part: Option<u32>) -> Vec<(Key, f64)> {
    let Some(part) = part else { return Vec::new() };
    let own = |role: &Role| {
        let keys = shapes.products.keys().filter(|key| key.0 == Some(part) && key.1 == *role);
        keys.map(|key| (*key, 1.0)).collect::<Vec<_>>()
    };
    roles.iter().map(own).find(|found| !found.is_empty()).unwrap_or_default()
}

/// What stands in a cube of the first component and role that are there.
fn in_cube(shapes: &Shapes, roles: &[Role], components: &[Component], id: &str) -> Vec<(Key, f64)> {
    let mut cube = [0; 3];
    for (to, from) in cube.iter_mut().zip(id.split(',')) {
        let Ok(n) = from.parse() else { return Vec::new() };
        *to = n;
    }
    let Some(pieces) = shapes.by_cube.get(&cube) else { return Vec::new() };
    for component in components {
        for role in roles {
            let here = pieces.iter().filter(|p| p.component == *component && p.key.1 == *role && p.weight > 0.0);
            let mut sums: BTreeMap<Key, f64> = BTreeMap::new();
            here.for_each(|p| *sums.entry(p.key).or_default() += p.weight);
            if !sums.is_empty() {
                return sums.into_iter().collect();
            }
        }
    }
    Vec::new()
}

/// All products of the first role that has any where `fits` holds, by how much they hold of the first component that any of them has.
fn anywhere(shapes: &Shapes, roles: &[Role], components: &[Component], fits: impl Fn(&Key) -> bool) -> Vec<(Key, f64)> {
    for role in roles {
        let own: Vec<_> = shapes.products.iter().filter(|(key, _)| key.1 == *role && fits(key)).collect();
        let lead = components.iter().find(|c| own.iter().any(|(_, shape)| shape.holds.contains_key(c)));
        match lead {
            Some(lead) => {
                let held = own.iter().filter_map(|(key, shape)| Some((**key, *shape.holds.get(lead)?)));
                return held.collect();
            }
            None if !own.is_empty() => return own.iter().map(|(key, _)| (**key, 1.0)).collect(),
            None => {}
        }
    }
    Vec::new()
}
