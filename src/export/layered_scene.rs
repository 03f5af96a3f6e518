//! The house as a GLB shows it: a node for each layer, cut where a view changes colour, with what the layer weighs, costs and emits.

use std::collections::BTreeMap;

use rustc_hash::FxHashMap;
use serde_json::{Value, json};

use super::dossier::of_utilisation;
use super::fabric_scene::layer_material;
use super::ledger::{Amounts, Ledger};
use super::palette::Palette;
use super::scene::{Part, Scene};
use super::views::{HOUSE_VIEWS, HouseLooks, Steps, Traits};
use crate::cubes::{Mask, canonical, cube_mask};
use crate::envelope::{Fabric, FabricLayer, MergeError, PlacedBlock};
use crate::score::LayerRow;
use crate::tiles::Component;
use crate::voxels::{House, Label};

/// The fabric of a house as parts by layer, those of a layer side by side, in all of [`HOUSE_VIEWS`].
///
/// # Errors
/// When blocks of a component overlap.
pub fn layered_scene(
    fabric: &Fabric,
    house: &House,
    ledger: &Ledger,
    palette: &Palette,
    extras: Value,
) -> Result<Scene, MergeError> {
    let own = fabric.layers.iter().map(|layer| layer_material(layer, palette)).collect();
    let (carbon, price) = steps(ledger);
    let looks = HouseLooks::new(own, carbon, price);
    let keys = keys(fabric, house, ledger, &looks);
    let mut distinct = keys.clone();
    distinct.sort_unstable();
    distinct.dedup();
    let tags: Vec<u32> = keys.iter().map(|key| distinct.binary_search(key).unwrap_or(0) as u32).collect();
    let stretch: f64 = fabric.scale.iter().product();
    let mut parts = Vec::new();
    for (layer, gathered) in fabric.gather_tagged(&tags)? {
        let FabricLayer { name, component, .. } = &fabric.layers[layer as usize];
        let row = ledger.layer(*component);
        let mut extras = json!({ "component": component.name(), "volume_m3": gathered.solid.volume_m3() * stretch });
        if let Some(row) = row {
            add_amounts(&mut extras, row);
        }
        if let Some(overlap) = &gathered.apart {
            extras["not_merged"] = json!(overlap.to_string());
        }
        let mut triangles: BTreeMap<u32, Vec<[u32; 3]>> = BTreeMap::new();
        for face in &gathered.solid.faces {
            triangles.entry(face.tag).or_default().extend(&face.triangles);
        }
        let vertices: Vec<[f64; 3]> = gathered.solid.vertices.iter().map(|v| fabric.metres(*v)).collect();
        for (tag, triangles) in triangles {
            let key = &distinct[tag as usize];
            let traits = Traits {
                label: key.label,
                mask: key.class,
                utilisation: key.utilisation,
                carbon: row.map(|row| row.gwp_kgco2e),
                price: row.map(|row| row.price),
            };
            let mut part = Part::new(name, layer as usize);
            (part.vertices, part.triangles) = used(&vertices, &triangles);
            part.views = looks.of(layer as usize, &traits);
            part.extras = extras.clone();
            parts.push(part);
        }
    }
    let extras = with_totals(extras, ledger, looks.legends("layer", "of the layers seen from outside"));
    let views = HOUSE_VIEWS.map(str::to_owned).to_vec();
    Ok(Scene { materials: looks.looks, parts, extras, views, shape: None })
}

/// What parts of a layer are told apart by.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
struct Key {
    layer: u32,
    label: Option<Label>,
    class: Option<Mask>,
    utilisation: Option<usize>,
}

/// Whether a layer is seen from outside. Only these are cut by class and utilisation: inside it would double the file for nothing.
fn is_outer(component: Component) -> bool {
    use Component as C;
    match component {
        C::Cladding | C::Band | C::RoofCovering | C::FlatMembrane | C::DeckBoards | C::Paving | C::SoffitBoards => true,
        C::PlinthRender | C::Fascia | C::Gutter | C::Coping | C::WindowFrame | C::DoorFrame | C::DoorLeaf => true,
        C::Reveal | C::Sill | C::RailingRail => true,
        C::WallInsulation | C::WallLining | C::RoofInsulation | C::RoofLining | C::FlatInsulation => false,
        C::FloorBoards | C::FloorStructure | C::Ceiling | C::SoffitInsulation | C::GroundSlab => false,
        C::GroundInsulation | C::PerimeterBeam | C::PlinthInsulation | C::Glass | C::Handle => false,
        C::RailingGlass | C::StairTread | C::StairString => false,
    }
}

/// The key of each block. Clear layers stay whole, because cuts through glass would be seen.
fn keys(fabric: &Fabric, house: &House, ledger: &Ledger, looks: &HouseLooks) -> Vec<Key> {
    let mut of_cube: FxHashMap<[u32; 3], (Option<Mask>, Option<usize>)> = FxHashMap::default();
    let mut key = |p: &PlacedBlock| {
        let whole = Key { layer: p.layer, label: None, class: None, utilisation: None };
        if looks.looks[p.layer as usize].rgba[3] < 1.0 {
            let label = (p.component == Component::Glass).then_some(Label::Window);
            return Key { label, ..whole };
        }
        if fabric.standing.contains(&p.tile) {
            return whole;
        }
        let label = Some(house.voxels.at(p.voxel.map(|v| v as isize))).filter(|label| label.is_filled());
        if !is_outer(p.component) {
            return Key { label, ..whole };
        }
        let (class, utilisation) = *of_cube.entry(p.cube).or_insert_with(|| {
            let mask = cube_mask(&house.voxels, p.cube.map(|c| c as usize));
            let utilisation = ledger.cubes.get(&p.cube).and_then(|place| place.utilisation);
            (mask.is_admissible().then(|| canonical(mask).0), utilisation.map(of_utilisation))
        });
        Key { label, class, utilisation, ..whole }
    };
    fabric.placed.iter().map(&mut key).collect()
}

/// The vertices that some triangles use, in order of first use, and the triangles by their numbers.
fn used(vertices: &[[f64; 3]], triangles: &[[u32; 3]]) -> (Vec<[f64; 3]>, Vec<[u32; 3]>) {
    let mut number: FxHashMap<u32, u32> = FxHashMap::default();
    let mut own = Vec::new();
    let mut place = |v: u32| {
        *number.entry(v).or_insert_with(|| {
            own.push(vertices[v as usize]);
            own.len() as u32 - 1
        })
    };
    let triangles = triangles.iter().map(|t| t.map(&mut place)).collect();
    (own, triangles)
}

/// Steps that hold the layers.
fn steps(ledger: &Ledger) -> (Steps, Steps) {
    let amounts = |value: fn(&LayerRow) -> f64| Steps::of(ledger.rows.iter().filter(|r| r.volume_m3 > 0.0).map(value));
    (amounts(|r| r.gwp_kgco2e), amounts(|r| r.price))
}

/// Adds what the take-off says of a layer.
fn add_amounts(extras: &mut Value, row: &LayerRow) {
    extras["mass_kg"] = json!(row.takeoff_kg);
    extras["price_eur"] = json!(row.price);
    extras["gwp_kgco2e"] = json!(row.gwp_kgco2e);
    extras["price_lines"] = json!(row.items.iter().map(|item| item.id()).collect::<Vec<_>>());
    if let Some((quantity, unit)) = row.quantity {
        extras["quantity"] = json!(quantity);
        extras["unit"] = json!(unit);
    }
}

/// Adds the sums of the take-off and the legends of the views to what a scene says of itself.
pub(super) fn with_totals(mut extras: Value, ledger: &Ledger, legends: Value) -> Value {
    let entry = |a: Amounts| json!({ "mass_kg": a.mass_kg, "price_eur": a.price, "gwp_kgco2e": a.gwp_kgco2e });
    extras["views"] = legends;
    if !ledger.rows.is_empty() {
        let all: Amounts = [ledger.drawn(), ledger.not_drawn(), ledger.frame()].into_iter().sum();
        extras["materials"] = json!({
            "means": "lines of bom.csv for materials, default rates, without waste, work, transport",
            "layers": entry(ledger.drawn()),
            "layers_not_drawn": entry(ledger.not_drawn()),
            "frame": entry(ledger.frame()),
            "sum": entry(all),
        });
    }
    extras
}
