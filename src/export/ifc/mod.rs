//! IFC4: a house as a building model that other programs open.
//!
//! `house.ifc` is a STEP file of schema IFC4 (ADD2 TC1): project, site, building and a storey for each floor plate; the house's solids by
//! factory part; the frame with its true sections; materials, properties, quantities.
//!
//! # Products
//! | of the house | entity | geometry |
//! |---|---|---|
//! | wall panel, gable, knee wall; parapet | `IfcWall` (ELEMENTEDWALL, PARAPET) | a closed set of triangles for each component, in its colour |
//! | floor cassette; foundation slab; deck | `IfcSlab` (FLOOR, BASESLAB, DECK) | the same |
//! | roof cassette, flat roof | `IfcRoof` (ROOF_CASSETTE, FLAT_ROOF), one for each part, so that each has a body | the same |
//! | soffit, plinth, paving, coping | `IfcCovering` of what it is fixed to | the same |
//! | window, door | `IfcWindow`, `IfcDoor`, filling an `IfcOpeningElement` that voids its panel (see `openings`) | the same |
//! | stair; railing; gutter; perimeter beam | `IfcStair`, `IfcRailing`, `IfcPipeSegment`, `IfcFooting` | the same |
//! | stick of the frame | `IfcBeam`, `IfcColumn`, `IfcMember` | its profile extruded along its axis, each ply |
//!
//! A surface tileset has no solids: its products are open sets of triangles of the welded surface; inner floors are drawn in the depth
//! of their build-up, stairs as a style draws them. Members are drawn where their timber lies, beside the axes on which they are analysed
//! ([`crate::frame::member_offsets`]), in layers whose solids are drawn through, and as long as they are counted: axis to axis, so that
//! joists reach the outer face of their wall.
//!
//! # Names
//! A part is called by its piece mark (`W0-S01`, as in `parts.json`), what is on a part `<mark>.<role>`, site work `site.<role>`, a member
//! as in `frame.glb` with its number as Tag. A GlobalId follows from the house's name and that of the thing alone, so the same house has
//! the same file, and what keeps its mark keeps its id. Nothing of the file depends on clock or chance: the time in its header is the day of
//! the newer of the two books that it prices with.
//!
//! # Quantities
//! Each origin of each row of the take-off is shared out over the products that hold it. `Houscaper_TakeOff` on a product names its shares
//! by item, with the line of the bill; over all products, with what the building itself holds because no product shows it, they sum to
//! `takeoff.json`. The same shares make up `Qto_*BaseQuantities`:
//!
//! | quantity | sum of items |
//! |---|---|
//! | `Qto_WallBaseQuantities.NetSideArea` | `wall`, `wall_both_sides`, `floor_band`, `parapet` |
//! | `Qto_SlabBaseQuantities.NetArea` | `inner_floor`, `deck`, `flat_roof`, `ground` |
//! | `Qto_RoofBaseQuantities.NetArea` | `pitched_roof`, `flat_roof`, `deck`, `inner_floor`, `overhang` |
//! | `Qto_CoveringBaseQuantities.NetArea` | `soffit`, `plinth`, `deck` |
//! | `Qto_WindowBaseQuantities.Area` | `window` |
//! | `Qto_RailingBaseQuantities.Length`, `Qto_PipeSegmentBaseQuantities.Length`, `Qto_FootingBaseQuantities.Length` | `railing`, `gutter`, `perimeter_beam` |
//! | `NetVolume`, `NetWeight` of members | timber, steel by grade |
//!
//! Doors and stairs are counted; copings have a length in `Houscaper_TakeOff` only. `NetVolume` of solids is that of what is drawn.
//!
//! # Price and carbon
//! `Houscaper_Price`: materials in the currency of the price book (low, default, high), with the book's version and date; the building has
//! totals and what belongs to no product. `Houscaper_Carbon`: fossil A1-A3 in kgCO2e, stored biogenic carbon, energy, with version and date
//! of the factor list; the later stages on the building.

mod common;
mod figures;
mod guid;
mod looks;
mod materials;
mod members;
mod model;
mod openings;
mod pieces;
mod products;
mod record;
mod role;
mod shares;
mod sheets;
mod spatial;
mod step;

pub use guid::global_id;

use super::Palette;
use crate::envelope::{EnvelopeError, Fabric, MergeError, Skin};
use crate::parts::{Marks, Parts, cut, marks};
use crate::price::{BillLine, PriceError, bill};
use crate::quantities::OriginRow;
use crate::score::{Details, Evaluator};
use crate::voxels::{Choices, House};
use looks::Looks;
use model::Model;
use pieces::Shapes;
use shares::Shares;
use spatial::Spatial;
use step::Header;

/// Why a house has no IFC file.
#[derive(Debug, thiserror::Error)]
pub enum IfcError {
    /// The surface of a house of a surface tileset.
    #[error(transparent)]
    Envelope(#[from] EnvelopeError),
    /// Solids that overlap.
    #[error(transparent)]
    Merge(#[from] MergeError),
    /// Bill or build-ups.
    #[error(transparent)]
    Price(#[from] PriceError),
    /// A number that STEP has no text for.
    #[error(
        "house.ifc: {entity}... holds a number that is infinite or none; check the geometry or the book it came from"
    )]
    NotFinite {
        /// The beginning of the entity.
        entity: String,
    },
}

/// What the file says, gathered once.
struct Facts<'a> {
    name: &'a str,
    house: &'a House,
    choices: &'a Choices,
    details: &'a Details,
    evaluator: &'a Evaluator,
    palette: Palette,
    cut: &'a Parts,
    marks: &'a Marks,
    /// Rows of the take-off; none where nothing was taken off.
    rows: &'a [OriginRow],
    /// The bill; its first lines are those of the rows.
    bill: Vec<BillLine>,
}

/// Writes a house called `name` as IFC4. `fabric` are its solids, `rows` its take-off with origins, as [`Evaluator::origins`] makes them;
/// without them the model has no quantities of the take-off.
///
/// # Errors
/// [`IfcError`]; an inadmissible cube is the one a user can cause.
pub fn house_ifc(
    name: &str,
    house: &House,
    choices: &Choices,
    details: &Details,
    evaluator: &Evaluator,
    fabric: Option<&Fabric>,
    rows: &[OriginRow],
) -> Result<Vec<u8>, IfcError> {
    // A house too high to be cut has no parts: all of it is then one product for each role and level.
    let cut = cut(house, &details.reading, choices, evaluator.part_settings()).unwrap_or_default();
    let marks = marks(&cut);
    let section = |number: u16| evaluator.catalogue.section_id(number);
    let bill = match &details.evaluation.takeoff {
        Some(takeoff) if !rows.is_empty() => bill(takeoff, &evaluator.books, &section)?,
        _ => Vec::new(),
    };
    let palette = Palette::of_looks(evaluator.tiling.looks());
    let (cut, marks) = (&cut, &marks);
    let facts = Facts { name, house, choices, details, evaluator, palette, cut, marks, rows, bill };
    let shapes = shapes(&facts, fabric)?;
    let shares = Shares::new(rows, &shapes, cut);
    let books = &evaluator.books;
    let mut model = Model::new(name, &books.prices.currency);
    let spatial = Spatial::new(&mut model, &facts);
    let mut looks = Looks::default();
    let written = products::write(&mut model, &mut looks, &facts, &spatial, &shapes, &shares)?;
    openings::write(&mut model, &facts, &written);
    members::write(&mut model, &mut looks, &facts, &spatial, &shares);
    let rest: Vec<(usize, f64)> = shares.building.iter().map(|(row, q)| (*row, *q)).collect();
    figures::takeoff(&mut model, &facts, "building", spatial.building, &rest);
    model.relate();
    let day = books.prices.date.as_str().max(books.carbon.date.as_str());
    let header = Header {
        name: "house.ifc",
        time: &format!("{day}T00:00:00"),
        description: "ViewDefinition [notYetAssigned]",
        program: concat!("houscaper ", env!("CARGO_PKG_VERSION")),
        schema: "IFC4",
    };
    model.step.finish(&header).map_err(|entity| IfcError::NotFinite { entity })
}

/// The products made of solids, or of surface.
fn shapes(facts: &Facts, fabric: Option<&Fabric>) -> Result<Shapes, IfcError> {
    let (house, reading) = (facts.house, &facts.details.reading);
    let mut shapes = Shapes::default();
    match fabric {
        Some(fabric) => shapes.add_fabric(fabric, facts.cut, &facts.palette)?,
        None => {
            let mut mesh = facts.evaluator.tiling.skin.mesh(&house.voxels)?;
            super::dossier::show_unwalked_as_roof(&mut mesh, house, facts.details);
            shapes.add_surface(&mesh, house, facts.cut);
            let floors = sheets::floors(house, facts.cut, &facts.evaluator.tiling.shells);
            shapes.add_fabric(&floors, facts.cut, &facts.palette)?;
        }
    }
    // Only a style draws the stairs itself.
    if facts.evaluator.tiling.style.is_none() || matches!(facts.evaluator.tiling.skin, Skin::Tiles(_)) {
        shapes.add_fabric(&sheets::stairs(house, reading), facts.cut, &facts.palette)?;
    }
    shapes.products.retain(|_, shape| shape.bodies.iter().any(|body| !body.triangles.is_empty()));
    shapes.products.values_mut().filter(|shape| shape.surface).for_each(|shape| shape.volume_m3 = None);
    let products = &shapes.products;
    shapes.by_cube.values_mut().for_each(|pieces| pieces.retain(|p| products.contains_key(&p.key)));
    Ok(shapes)
}
