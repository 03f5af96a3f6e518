//! Everything that is written about one house: models, tables, quote, structure, plans and a picture, as bytes by file name.

mod frame_drawing;
mod frame_scene;
mod meshes;
mod scenes;
mod sizing;
mod structure;
mod structure_page;

use serde_json::{Value, json};

pub(super) use frame_scene::views::{UTILISATION, of_utilisation};
pub use frame_scene::{add_costs, add_loads, deformation_scale, frame_scene};
pub use meshes::{MISSING_FILE, MeshesReport};
use scenes::exploded_scene;
pub(super) use scenes::show_unwalked_as_roof;
pub use scenes::{house_scene, tiles_glb, zone_areas};
pub use sizing::sizing_json;
pub use structure::{
    BasisReport, CheckReport, CriticalReport, DeflectionReport, DeformedReport, FIRST_ORDER, FoundationReport,
    GoverningReport, GroupReport, LooseNode, MemberReport, ModeReport, RackingReport, SolutionReport, StabilityReport,
    StoreyReport, StructureReport, ThesisReport, VibrationReport, check_name,
};
pub use structure_page::{Drawings, structure_html};

use super::carbon::{carbon_html, carbon_json};
use super::drawing::house_drawings;
use super::ifc::{IfcError, house_ifc};
use super::lattices::{FOLDER as LATTICES, lattice_files};
use super::parts::{parts_csv, parts_json};
use super::picture::{Image, ImageError, Picture, PictureError, render};
use super::plots::{PlotError, with_legend};
use super::tables::{bom_csv, layers_csv};
use super::takeoff::{takeoff_csv, takeoff_json};
use super::{DistinctTiles, GlbError, Ledger, Palette, Scene, SceneError, layered_scene, to_glb, to_mtl, to_obj};
use crate::envelope::{EnvelopeError, MergeError};
use crate::parts;
use crate::price::{CarbonAccount, PriceError, QuoteHead, bill, quote, quote_html};
use crate::score::{Details, Evaluator, floor_area_m2};
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
    /// `house.ifc`, `takeoff.json` and `takeoff.csv`, `house.obj`, `house.mtl`, what is known cell by cell as `lattices/*.csv`, `frame.png`, `frame-forces.png`, the parts moved apart as `parts.glb` and `parts.png`, loads in
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
    let ledger = Ledger::new(house, choices, details, evaluator, fabric.as_ref())?;
    let picture = render(&scene, &Picture::of_house([480, 360]))?;
    let mut files: Vec<(String, Vec<u8>)> = Vec::new();
    let mut add = |file: &str, bytes: Vec<u8>| files.push((file.to_owned(), bytes));
    add("voxels.csv", lattice::write_lattice(&lattice::Lattice::from_voxels(&house.voxels)));
    add("voxels.json", voxel_json::write(house).into_bytes());
    add("choices.json", serde_json::to_vec_pretty(&choices_json(choices, evaluator, details.reading.plates.len()))?);
    let palette = Palette::of_looks(evaluator.tiling.looks());
    add(
        "house.glb",
        match &fabric {
            Some(fabric) => to_glb(&layered_scene(fabric, house, &ledger, &palette, scene.extras.clone())?)?,
            None => to_glb(&scene)?,
        },
    );
    if full {
        let tiles = fabric.as_ref().map(|f| DistinctTiles::new(f, house)).transpose()?;
        for (file, bytes) in lattice_files(house, details, &ledger, tiles.as_ref(), evaluator.rules.view_m) {
            add(&format!("{LATTICES}/{file}"), bytes);
        }
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
        add_costs(&mut frame_view, &ledger.members);
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
                let exploded = exploded_scene(fabric, &cut, &marks, &palette)?;
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
    for (file, svg) in house_drawings(name, house, &details.reading, &scene) {
        add(&file, svg.into_bytes());
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
