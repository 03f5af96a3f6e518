//! Everything that is written about one house: models, tables, quote, structure, plans and a picture, as bytes by file name.

mod frame_drawing;
mod frame_scene;
mod meshes;
mod plans;
mod sizing;
mod structure;
mod structure_page;

use serde_json::{Value, json};

pub use frame_scene::{add_loads, deformation_scale, frame_scene};
pub use meshes::{MISSING_FILE, MeshesReport};
pub use plans::storey_plans;
pub use sizing::sizing_json;
pub use structure::{
    BasisReport, CheckReport, CriticalReport, DeflectionReport, DeformedReport, FIRST_ORDER, FoundationReport,
    GoverningReport, GroupReport, LooseNode, MemberReport, ModeReport, RackingReport, SolutionReport, StabilityReport,
    StoreyReport, StructureReport, ThesisReport, VibrationReport, check_name,
};
pub use structure_page::{Drawings, structure_html};

use super::carbon::{carbon_html, carbon_json};
use super::ifc::{IfcError, house_ifc};
use super::parts::{parts_csv, parts_json};
use super::picture::{Image, ImageError, Picture, PictureError, render};
use super::plots::{PlotError, with_legend};
use super::tables::{bom_csv, layers_csv};
use super::takeoff::{takeoff_csv, takeoff_json};
use super::{
    Exploded, GlbError, Palette, Scene, SceneError, Showing, Storeys, from_envelope, from_fabric, from_parts, to_glb,
    to_mtl, to_obj,
};
use crate::brief::Objective;
use crate::envelope::{EnvelopeError, Fabric, MergeError, Mesh, Surface};
use crate::parts;
use crate::price::{CarbonAccount, PriceError, QuoteHead, bill, quote, quote_html};
use crate::score::{Details, Evaluator, floor_area_m2, walked_deck, window_area_by_direction};
use crate::structure::{Assessment, critical_loads, review};
use crate::voxels::{Choice, Choices, House, json as voxel_json, lattice};

/// Why the files of a house could not be made.
#[derive(Debug, thiserror::Error)]
pub enum DossierError {
    /// The envelope.
    #[error(transparent)]
    Envelope(#[from] EnvelopeError),
    /// Solids that overlap.
    #[error(transparent)]
    Merge(#[from] MergeError),
    /// A scene.
    #[error(transparent)]
    Scene(#[from] SceneError),
    /// A GLB.
    #[error(transparent)]
    Glb(#[from] GlbError),
    /// A picture.
    #[error(transparent)]
    Picture(#[from] PictureError),
    /// A PNG.
    #[error(transparent)]
    Image(#[from] ImageError),
    /// A legend.
    #[error(transparent)]
    Plot(#[from] PlotError),
    /// The quote.
    #[error(transparent)]
    Price(#[from] PriceError),
    /// IFC.
    #[error(transparent)]
    Ifc(#[from] IfcError),
    /// JSON that could not be written.
    #[error(transparent)]
    Json(#[from] serde_json::Error),
}

/// A house with all its files.
pub struct Dossier {
    /// File name and bytes, in the order in which they should be written.
    pub files: Vec<(String, Vec<u8>)>,
    /// The picture, for contact sheets.
    pub picture: Image,
    /// What `structure.json` and `structure.html` say.
    pub structure: StructureReport,
}

/// How much is written about a house.
#[derive(Clone, Debug, PartialEq)]
pub enum Extent {
    /// What a search leaves of every house of its front.
    Front,
    /// The same with `house.ifc`, and `takeoff.json` and `takeoff.csv` beside it, whose rows its quantities sum to.
    FrontIfc,
    /// `house.ifc`, `takeoff.json` and `takeoff.csv`, `house.obj`, `house.mtl`, `frame.png`, `frame-forces.png`, the parts moved apart as `parts.glb` and `parts.png`, loads in
    /// `frame.glb`, and the first buckling loads; `sizing` says how the sections were chosen.
    Full {
        /// In a sentence; `None` where they were given.
        sizing: Option<String>,
    },
}

/// Makes the files of a house called `name`.
///
/// # Errors
/// [`DossierError`]; an inadmissible cube is the one a user can cause.
pub fn dossier(
    name: &str,
    house: &House,
    choices: &Choices,
    details: &Details,
    evaluator: &Evaluator,
    extent: Extent,
) -> Result<Dossier, DossierError> {
    let (full, ifc, sizing) = match extent {
        Extent::Front => (false, false, None),
        Extent::FrontIfc => (false, true, None),
        Extent::Full { sizing } => (true, true, sizing),
    };
    let fabric = evaluator.tiling.fabric(house, &details.reading);
    let scene = house_scene(name, house, details, evaluator, fabric.as_ref())?;
    let picture = render(&scene, &Picture::of_house([480, 360]))?;
    let mut files: Vec<(String, Vec<u8>)> = Vec::new();
    let mut add = |file: &str, bytes: Vec<u8>| files.push((file.to_owned(), bytes));
    add("voxels.csv", lattice::write_lattice(&lattice::Lattice::from_voxels(&house.voxels)));
    add("voxels.json", voxel_json::write(house).into_bytes());
    add("choices.json", serde_json::to_vec_pretty(&choices_json(choices, evaluator, details.reading.plates.len()))?);
    add("house.glb", to_glb(&scene)?);
    if full {
        add("house.obj", to_obj(&scene, "house.mtl")?.into_bytes());
        add("house.mtl", to_mtl(&scene.materials).into_bytes());
    }
    if let Some(report) = MeshesReport::new(house, &details.reading, &evaluator.tiling) {
        add("meshes.json", serde_json::to_vec_pretty(&report.with_layers(&scene, fabric.as_ref()))?);
        if report.cubes_without_tile > 0 {
            add(MISSING_FILE, meshes::missing_csv(&evaluator.tiling.missing(&house.voxels)).into_bytes());
        }
    }
    let sections = evaluator.sections(choices);
    let reviewed = details.frame.as_ref().and_then(|f| review(f, &evaluator.catalogue, &sections, &evaluator.loads));
    let critical = details.frame.as_ref().filter(|_| full);
    let critical = critical.and_then(|f| critical_loads(f, &evaluator.catalogue, &sections, &evaluator.loads));
    if let Some(frame) = &details.frame {
        let mut frame_view = frame_scene(frame, details, evaluator, &sections, reviewed.as_ref());
        if full {
            let large = Picture { size: [1200, 900], ground_m: -0.17, ..Picture::default() };
            add("frame.png", frame_png(&frame_view, 0, &large)?);
            if let Some(reviewed) = &reviewed {
                add("frame-forces.png", frame_png(&frame_view, 1, &large)?);
                add_loads(&mut frame_view, frame, reviewed);
            }
        }
        add("frame.glb", to_glb(&frame_view)?);
        add("frame.json", frame_file(frame, evaluator, &sections)?);
    }
    let mut taken_off = Vec::new();
    if let Some(takeoff) = &details.evaluation.takeoff {
        let section_name = |number: u16| evaluator.catalogue.section_id(number);
        let lines = bill(takeoff, &evaluator.books, &section_name)?;
        add("bom.csv", bom_csv(&lines).into_bytes());
        if let Some(rows) = evaluator.origins(house, choices, details).filter(|_| full || ifc) {
            add("takeoff.json", serde_json::to_vec(&takeoff_json(name, &rows))?);
            add("takeoff.csv", takeoff_csv(&rows).into_bytes());
            taken_off = rows;
        }
        if let Some(rows) = evaluator.layers(house, details).transpose()? {
            add("layers.csv", layers_csv(&rows, &evaluator.books.buildups.version).into_bytes());
        }
        let floor_m2 = floor_area_m2(&details.reading);
        let account = CarbonAccount::new(takeoff, &evaluator.books, &section_name, floor_m2)?;
        let heat = evaluator.heat_loss(house, details);
        add("carbon.json", serde_json::to_vec_pretty(&carbon_json(name, &account, heat.as_ref()))?);
        add("carbon.html", carbon_html(name, &account, heat.as_ref()).into_bytes());
        let head = QuoteHead { name: name.to_owned(), floor_area_m2: floor_m2, issued: None };
        let quote = quote(&head, takeoff, &evaluator.books, &section_name)?;
        add("quote.json", serde_json::to_vec_pretty(&quote)?);
        add("quote.html", quote_html(&quote).into_bytes());
        // A house too high to be cut has no parts; its other files are none the worse for it.
        let settings = evaluator.part_settings();
        if let Ok(cut) = parts::cut(house, &details.reading, choices, settings) {
            let members = details.frame.as_ref().zip(details.evaluation.assessment.as_ref().map(kg_per_m));
            let (marks, masses) = (parts::marks(&cut), parts::masses(&cut, takeoff, &evaluator.rates, members));
            let over = parts::overloads(&cut, &masses, settings);
            let stock = details.frame.as_ref().map(|frame| parts::stock(frame, parts::STOCK_LENGTH_M));
            add("parts.csv", parts_csv(&cut, &marks, &masses).into_bytes());
            add("parts.json", serde_json::to_vec_pretty(&parts_json(&cut, &marks, &masses, &over, stock.as_ref()))?);
            if let Some(fabric) = fabric.as_ref().filter(|_| full) {
                let exploded = exploded_scene(fabric, &cut, &marks, &Palette::of_looks(evaluator.tiling.looks()))?;
                add("parts.glb", to_glb(&exploded)?);
                add("parts.png", render(&exploded, &Picture::of_house([1200, 900]))?.to_png()?);
            }
        }
    }
    if ifc {
        add("house.ifc", house_ifc(name, house, choices, details, evaluator, fabric.as_ref(), &taken_off)?);
    }
    let report = StructureReport::new(details, evaluator, choices, reviewed.as_ref(), critical.as_ref(), sizing);
    let drawings = details.frame.as_ref().map(|f| Drawings::new(f, details, evaluator, &sections, reviewed.as_ref()));
    add("structure.json", serde_json::to_vec_pretty(&report)?);
    add("structure.html", structure_html(name, &report, drawings.as_ref()).into_bytes());
    for (index, svg) in storey_plans(house, &details.reading).into_iter().enumerate() {
        add(&format!("plan-{index}.svg"), svg.into_bytes());
    }
    add("thumb.png", picture.to_png()?);
    Ok(Dossier { files, picture, structure: report })
}

/// Mass of a metre of one ply by wall, floor, beam, roof; 0 for a group without members.
fn kg_per_m(assessment: &Assessment) -> [f64; 4] {
    std::array::from_fn(|g| match assessment.group_length_m[g] {
        length if length > 0.0 => assessment.group_mass_kg[g] / length,
        _ => 0.0,
    })
}

/// The choices by name, as `--choices` reads them: sections, and for each plate above ground the letter of its joists' axis.
fn choices_json(choices: &Choices, evaluator: &Evaluator, plates: usize) -> Value {
    let names = [Choice::Wall, Choice::Floor, Choice::Beam, Choice::Roof].iter().zip(evaluator.sections(choices));
    let mut map: serde_json::Map<String, Value> =
        names.map(|(c, option)| (c.name().to_owned(), json!(evaluator.catalogue.option_name(option)))).collect();
    let axes: String =
        (0..plates.saturating_sub(1)).map(|p| if choices.joists_along_y(p) { 'y' } else { 'x' }).collect();
    map.insert(Choice::Joists.name().to_owned(), json!(axes));
    map.insert(Choice::Boards.name().to_owned(), json!(evaluator.boards(choices)));
    Value::Object(map)
}

/// A view of the frame with what its colours mean.
fn frame_png(scene: &Scene, view: usize, picture: &Picture) -> Result<Vec<u8>, DossierError> {
    let image = if view == 0 { render(scene, picture)? } else { render(&scene.in_view(view), picture)? };
    Ok(match frame_scene::legend(view) {
        Some(legend) => with_legend(&image, &legend)?,
        None => image.to_png()?,
    })
}

fn frame_file(
    frame: &crate::frame::HouseFrame,
    evaluator: &Evaluator,
    sections: &[crate::structure::SectionOption; 4],
) -> Result<Vec<u8>, DossierError> {
    let model = crate::structure::analysis_model(frame, &evaluator.catalogue, sections);
    let mut cases = Vec::new();
    crate::structure::load_cases(frame, &evaluator.loads, &mut cases);
    let depths = sections.map(|s| evaluator.catalogue.section(s).h);
    Ok(serde_json::to_vec(&crate::structure::frame_json(&model, &cases, frame, depths))?)
}

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

/// The parts moved apart, a node for each part and component, named by piece mark.
fn exploded_scene(
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
