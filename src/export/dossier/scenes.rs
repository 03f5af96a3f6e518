//! The scenes of a house: as built, as single tiles, and its factory parts moved apart.

use serde_json::{Value, json};

use super::{DossierError, MeshesReport};
use crate::brief::Objective;
use crate::envelope::{Fabric, Mesh, Surface};
use crate::export::{
    DistinctTiles, Exploded, Ledger, Palette, Scene, Showing, Storeys, assembly_to_glb, from_envelope, from_fabric,
    from_parts, tile_scene,
};
use crate::parts;
use crate::score::{Details, Evaluator, walked_deck, window_area_by_direction};
use crate::voxels::{Choices, House};

/// The house as a scene with its figures in its `extras`: the solids of a style or a set of meshes, or the welded surface of other sets.
///
/// # Errors
/// [`DossierError`]: an inadmissible cube, or solids that overlap.
pub fn house_scene(
    name: &str,
    house: &House,
    details: &Details,
    evaluator: &Evaluator,
    fabric: Option<&Fabric>,
) -> Result<Scene, DossierError> {
    let extras = house_extras(name, house, details, evaluator)?;
    if let Some(fabric) = fabric {
        return Ok(from_fabric(fabric, &Palette::of_looks(evaluator.tiling.looks()), Storeys::Together, extras)?);
    }
    let mut mesh = evaluator.tiling.skin.mesh(&house.voxels)?;
    show_unwalked_as_roof(&mut mesh, house, details);
    let [sx, sy, _] = house.voxels.module.size_m;
    let [ox, oy, _] = house.voxels.origin_m;
    let showing = Showing { mullions: [[ox - 0.5 * sx, oy - 0.5 * sy], [sx, sy]], ..Showing::default() };
    let rates = &evaluator.rates.rows;
    let surface_extras = |surface: Surface| {
        let area = details.areas.as_ref().map(|a| a.area_m2[surface as usize]);
        json!({
            "surface": surface.name(),
            "area_m2": area,
            "price_line": surface.name(),
            "gwp_kgco2e_per_unit": rates[surface as usize].gwp[1],
        })
    };
    Ok(from_envelope(&mesh, showing, extras, surface_extras))
}

/// What the files say of a house: objectives, storeys, zones, windows, what a set of meshes lacks.
fn house_extras(
    name: &str,
    house: &House,
    details: &Details,
    evaluator: &Evaluator,
) -> Result<Value, serde_json::Error> {
    let figures: serde_json::Map<String, Value> = Objective::ALL
        .iter()
        .map(|&o| (o.name().to_owned(), json!(details.evaluation.values.get(o))))
        .filter(|(_, v)| !v.is_null())
        .collect();
    let mut extras = json!({
        "name": name,
        "schema": "houscaper.house/1",
        "module_size_m": house.voxels.module.size_m,
        "storeys": details.reading.storeys.len(),
        "figures": figures,
        "zones_m2": zone_areas(house),
        "windows_m2_east_north_west_south": window_area_by_direction(&details.reading, &house.voxels.module),
    });
    if let Some(report) = MeshesReport::new(house, &details.reading, &evaluator.tiling) {
        extras["tileset"] = serde_json::to_value(report)?;
    }
    Ok(extras)
}

/// The bytes of a GLB with a node for each tile and stair, equal tiles sharing their mesh; `None` for a set of surfaces alone.
///
/// # Errors
/// [`DossierError`]: an inadmissible cube, or solids that overlap.
pub fn tiles_glb(
    name: &str,
    house: &House,
    choices: &Choices,
    details: &Details,
    evaluator: &Evaluator,
) -> Result<Option<Vec<u8>>, DossierError> {
    let Some(fabric) = evaluator.tiling.fabric(house, &details.reading) else { return Ok(None) };
    let ledger = Ledger::new(house, choices, details, evaluator, Some(&fabric))?;
    let tiles = DistinctTiles::new(&fabric, house)?;
    let palette = Palette::of_looks(evaluator.tiling.looks());
    let extras = house_extras(name, house, details, evaluator)?;
    Ok(Some(assembly_to_glb(&tile_scene(&fabric, &tiles, house, &ledger, &palette, extras)?)?))
}

/// The parts moved apart, a node for each part and component, named by piece mark.
pub(super) fn exploded_scene(
    fabric: &Fabric,
    cut: &parts::Parts,
    marks: &parts::Marks,
    palette: &Palette,
) -> Result<Scene, DossierError> {
    let part_of: Vec<Option<u32>> = cut.of_fabric(fabric).into_iter().map(|part| part.map(|id| id.0)).collect();
    let name = |n: u32| marks.piece.get(n as usize).cloned().unwrap_or_default();
    // A stair faces where it runs to, which is inside.
    let outer = |part: &&parts::Part| part.kind != parts::PartKind::Stair;
    let facing = |n: u32| cut.parts.get(n as usize).filter(outer).and_then(|part| part.facing);
    Ok(from_parts(fabric, &part_of, name, facing, palette, Exploded::default())?)
}

/// Decks that nobody steps out on are built and priced as flat roofs: shows them as such.
pub(in crate::export) fn show_unwalked_as_roof(mesh: &mut Mesh, house: &House, details: &Details) {
    let walked: Vec<_> =
        details.reading.plates.iter().skip(1).map(|p| (p.k, walked_deck(house, &details.reading, p))).collect();
    let (origin, size) = (house.voxels.origin_m, house.voxels.module.size_m);
    for (triangle, surface) in mesh.triangles.iter().zip(&mut mesh.surfaces) {
        if *surface != Surface::Deck {
            continue;
        }
        let centre = |axis: usize| {
            let sum: f64 = triangle.iter().map(|&v| mesh.vertices[v as usize][axis]).sum();
            (sum / 3.0 - origin[axis]) / size[axis]
        };
        let cell = [centre(0).round() as isize, centre(1).round() as isize];
        let on_deck = |k: usize| (centre(2) - k as f64).abs() < 1.0;
        if !walked.iter().any(|(k, plan)| on_deck(*k) && plan.has(cell)) {
            *surface = Surface::FlatRoof;
        }
    }
}

/// Gross plan area of each zone over its storeys, m2, by zone id.
pub fn zone_areas(house: &House) -> std::collections::BTreeMap<String, f64> {
    let mut areas = std::collections::BTreeMap::new();
    let [nx, ny, _] = house.voxels.shape();
    let [sx, sy, _] = house.voxels.module.size_m;
    for (index, &zone) in house.zones.iter().enumerate() {
        let k = index / (nx * ny).max(1);
        // The first room layer of each storey stands for the storey.
        if zone >= 0 && k % crate::voxels::STOREY_MODULES == 1 {
            *areas.entry(zone.to_string()).or_insert(0.0) += sx * sy;
        }
    }
    areas
}
