//! The house as single tiles: a node for each cube, in which equal tiles share their mesh, turned where they stand turned.

use std::collections::BTreeMap;

use rustc_hash::FxHashMap;
use serde_json::{Value, json};

use super::dossier::of_utilisation;
use super::fabric_scene::layer_material;
use super::glb::{Assembly, Instance, SharedMesh};
use super::layered_scene::with_totals;
use super::ledger::{Ledger, Place};
use super::palette::Palette;
use super::scene::Part;
use super::views::{HOUSE_VIEWS, HouseLooks, Steps, Traits};
use super::{DistinctTiles, TurnedTile};
use crate::cubes::{Category, CornerOrder, Mask, ThesisId, cube_labels, topogenesis_id};
use crate::envelope::{Fabric, MergeError, Solid};
use crate::voxels::{House, Label};

/// The tiles of a house, and its stairs, in all of [`HOUSE_VIEWS`]; carbon and price are those of the tile's layers.
///
/// # Errors
/// When blocks of a stair overlap.
pub fn tile_scene(
    fabric: &Fabric,
    tiles: &DistinctTiles,
    house: &House,
    ledger: &Ledger,
    palette: &Palette,
    extras: Value,
) -> Result<Assembly, MergeError> {
    let own = fabric.layers.iter().map(|layer| layer_material(layer, palette)).collect();
    let amounts = || ledger.cubes.iter().filter(|(c, _)| tiles.of_cube.contains_key(*c)).map(|(_, p)| p.layers);
    let (carbon, price) = (Steps::of(amounts().map(|a| a.gwp_kgco2e)), Steps::of(amounts().map(|a| a.price)));
    let mut nodes = Nodes {
        fabric,
        house,
        priced: !ledger.rows.is_empty(),
        looks: HouseLooks::new(own, carbon, price),
        known: FxHashMap::default(),
        assembly: Assembly::default(),
    };
    let half = fabric.cube_um.map(|c| c / 2);
    for tile in &tiles.tiles {
        let parts = tile.pieces.iter().map(|p| local_part(fabric, p.layer, &p.solid, half, [1.0; 3])).collect();
        nodes.assembly.geometries.push(parts);
    }
    for (&cube, &turned) in &tiles.of_cube {
        let nothing = Place::default();
        nodes.add_cube(tiles, cube, turned, ledger.cubes.get(&cube).unwrap_or(&nothing));
    }
    for (number, (&tile, place)) in fabric.standing.iter().zip(&ledger.standing).enumerate() {
        nodes.add_standing(number, tile, place)?;
    }
    let Nodes { looks, mut assembly, .. } = nodes;
    assembly.extras = with_totals(extras, ledger, looks.legends("tile", "of all layers"));
    assembly.extras["tiles"] = json!({ "distinct": tiles.tiles.len(), "cubes": tiles.of_cube.len() });
    assembly.views = HOUSE_VIEWS.map(str::to_owned).to_vec();
    assembly.materials = looks.looks;
    Ok(assembly)
}

struct Nodes<'a> {
    fabric: &'a Fabric,
    house: &'a House,
    priced: bool,
    looks: HouseLooks,
    /// Meshes by geometry and colours.
    known: FxHashMap<(usize, Vec<Vec<usize>>), usize>,
    assembly: Assembly,
}

impl Nodes<'_> {
    fn add_cube(&mut self, tiles: &DistinctTiles, cube: [u32; 3], turned: TurnedTile, place: &Place) {
        let labels = cube_labels(&self.house.voxels, cube.map(|c| c as usize));
        let mask = Mask::of(&labels);
        let tile = &tiles.tiles[turned.tile];
        let traits = |label: Label| Traits {
            label: label.is_filled().then_some(label),
            mask: mask.is_admissible().then_some(mask),
            utilisation: place.utilisation.map(of_utilisation),
            carbon: self.priced.then_some(place.layers.gwp_kgco2e),
            price: self.priced.then_some(place.layers.price),
        };
        let looks = tile.pieces.iter().map(|p| self.looks.of(p.layer as usize, &traits(p.label))).collect();
        let mesh = self.mesh(turned.tile, &format!("tile {}", turned.tile + 1), looks);
        let category = Category::of(mask).name();
        let mut extras = json!({
            "cube": cube,
            "cube_id": ThesisId::new(&labels, CornerOrder::FOrder).0,
            "topogenesis_id": topogenesis_id(mask, CornerOrder::FOrder),
            "labels": labels.map(|l| char::from(b'0' + l.code())).iter().collect::<String>(),
            "tile": turned.tile + 1,
            "tile_key": tile.key.to_string(),
            "orientation_deg": 90 * u32::from(turned.turns),
            "class": self.looks.class(mask),
            "category": category,
        });
        if let Some(zone) = self.zone(cube) {
            extras["zone"] = json!(zone);
        }
        self.add_place(&mut extras, place);
        let centre = |a: usize| i64::from(cube[a]) * self.fabric.cube_um[a] - self.fabric.cube_um[a] / 2;
        let [i, j, k] = cube;
        self.assembly.nodes.push(Instance {
            name: format!("cube {i},{j},{k} {category}"),
            mesh,
            at_m: self.fabric.metres([0, 1, 2].map(centre)),
            turns: turned.turns,
            scale: self.fabric.scale,
            extras,
        });
    }

    /// A stair: where it stands, with axes of the house.
    fn add_standing(&mut self, number: usize, tile: u32, place: &Place) -> Result<(), MergeError> {
        let own = self.fabric.placed.iter().filter(|p| p.tile == tile);
        let mut layers: BTreeMap<u32, Vec<_>> = BTreeMap::new();
        own.for_each(|p| layers.entry(p.layer).or_default().push(p));
        let mut parts = Vec::with_capacity(layers.len());
        for (layer, blocks) in &layers {
            let solid = self.fabric.gather(blocks)?.solid;
            parts.push(local_part(self.fabric, *layer, &solid, [0; 3], self.fabric.scale));
        }
        if parts.is_empty() {
            return Ok(());
        }
        let traits = Traits {
            carbon: self.priced.then_some(place.layers.gwp_kgco2e),
            price: self.priced.then_some(place.layers.price),
            ..Traits::default()
        };
        let looks = layers.keys().map(|l| self.looks.of(*l as usize, &traits)).collect();
        self.assembly.geometries.push(parts);
        let name = format!("stair {number}");
        let mesh = self.mesh(self.assembly.geometries.len() - 1, &name, looks);
        let mut extras = json!({ "stair": number });
        self.add_place(&mut extras, place);
        let (at_m, scale) = (self.fabric.origin_m, [1.0; 3]);
        self.assembly.nodes.push(Instance { name, mesh, at_m, turns: 0, scale, extras });
        Ok(())
    }

    /// The mesh of a geometry in some colours; made when first asked for.
    fn mesh(&mut self, geometry: usize, name: &str, looks: Vec<Vec<usize>>) -> usize {
        let meshes = &mut self.assembly.meshes;
        *self.known.entry((geometry, looks)).or_insert_with_key(|(geometry, looks)| {
            meshes.push(SharedMesh { name: name.to_owned(), geometry: *geometry, looks: looks.clone() });
            meshes.len() - 1
        })
    }

    /// The zone of a cube: that of the first of its filled voxels, x fastest, which has one.
    fn zone(&self, cube: [u32; 3]) -> Option<i32> {
        let zones = &self.house.zones;
        if zones.len() != self.house.voxels.labels().len() {
            return None;
        }
        let shape = self.house.voxels.shape();
        let corner = |n: usize| [0, 1, 2].map(|a| (cube[a] as usize + (n >> a & 1)).wrapping_sub(1));
        let inside = (0..8).map(corner).filter(|v| (0..3).all(|a| v[a] < shape[a]));
        inside.map(|v| zones[self.house.voxels.index(v)]).find(|zone| *zone >= 0)
    }

    fn add_place(&self, extras: &mut Value, place: &Place) {
        // A millionth of a kilogram or euro: sums over a house keep nine digits.
        let tidy = |v: f64| (v * 1e6).round() / 1e6 + 0.0;
        if self.priced {
            extras["mass_kg"] = json!(tidy(place.layers.mass_kg));
            extras["price_eur"] = json!(tidy(place.layers.price));
            extras["gwp_kgco2e"] = json!(tidy(place.layers.gwp_kgco2e));
            extras["price_lines"] = json!(place.items.iter().map(|item| item.id()).collect::<Vec<_>>());
        }
        if !place.members.is_empty() {
            extras["frame"] = json!({
                "members": place.members,
                "mass_kg": tidy(place.frame.mass_kg),
                "price_eur": tidy(place.frame.price),
                "gwp_kgco2e": tidy(place.frame.gwp_kgco2e),
            });
        }
        if let Some(utilisation) = place.utilisation {
            extras["utilisation"] = json!(tidy(utilisation));
        }
    }
}

/// A piece about the point `middle` µm, in m.
fn local_part(fabric: &Fabric, layer: u32, solid: &Solid, middle: [i64; 3], scale: [f64; 3]) -> Part {
    let mut part = Part::new(&fabric.layers[layer as usize].name, 0);
    part.vertices =
        solid.vertices.iter().map(|v| [0, 1, 2].map(|a| (v[a] - middle[a]) as f64 * 1e-6 * scale[a])).collect();
    part.triangles = solid.triangles().collect();
    part
}
