//! The strata of drawn solids from the build-ups that are priced and weighed.

use thiserror::Error;

use crate::price::{Books, BuildUps, PriceError};
use crate::tiles::{Component, Shells, Stack, Stratum};

/// Why the build-ups give no strata.
#[derive(Debug, Error)]
pub enum ShellsError {
    /// A build-up is missing.
    #[error(transparent)]
    Price(#[from] PriceError),
    /// A layer that has thickness but no stratum.
    #[error("{file}: build-up \"{buildup}\", layer \"{layer}\" has no \"stratum\"; expected one of: {expected}")]
    NoStratum {
        /// Path of the build-ups.
        file: String,
        /// Id of the build-up.
        buildup: String,
        /// Label of the layer.
        layer: String,
        /// Names that fit there.
        expected: String,
    },
    /// A stratum that does not belong to this build-up, or is no component at all.
    #[error("{file}: build-up \"{buildup}\", layer \"{layer}\": stratum \"{found}\"; expected one of: {expected}")]
    WrongStratum {
        /// Path of the build-ups.
        file: String,
        /// Id of the build-up.
        buildup: String,
        /// Label of the layer.
        layer: String,
        /// Name found.
        found: String,
        /// Names that fit there.
        expected: String,
    },
    /// Strata in a thickness that the tiles cannot hold.
    #[error("{file}: build-up \"{buildup}\": {what} {found} mm, expected {expected}")]
    Thickness {
        /// Path of the build-ups.
        file: String,
        /// Id of the build-up.
        buildup: String,
        /// What is too thick or missing.
        what: &'static str,
        /// mm found.
        found: f64,
        /// What fits.
        expected: &'static str,
    },
}

use Component as C;
const WALL: &[C] = &[C::Cladding, C::WallInsulation, C::WallLining];
const ROOF: &[C] = &[C::RoofCovering, C::RoofInsulation, C::RoofLining];
const LEVEL: &[C] = &[C::FlatMembrane, C::FlatInsulation, C::DeckBoards, C::FloorBoards, C::FloorStructure, C::Ceiling];
const FLOOR: &[C] = &[C::FloorBoards, C::FloorStructure, C::Ceiling];
const SOFFIT: &[C] = &[C::SoffitInsulation, C::SoffitBoards];
const GROUND: &[C] = &[C::GroundSlab, C::GroundInsulation];
const PLINTH: &[C] = &[C::PlinthRender, C::PlinthInsulation, C::PerimeterBeam];

/// The strata of all surfaces, from the build-ups `wall`, `roof_pitched`, `roof_flat`, `deck`, `floor`, `soffit`, `ground_slab`,
/// `plinth` and `perimeter_beam`.
///
/// Layers of one stratum are added up, films with the stratum that names them; each stack is then rounded to whole millimetres, its
/// thickest stratum taking the rest. A flat roof and a deck contain the floor cassette's layers: those are told apart by their
/// strata and left to [`Shells::floor`].
///
/// # Errors
/// [`ShellsError`], naming file, build-up and layer.
///
/// ```no_run
/// # use houscaper::price::Books;
/// # fn f(books: &Books) -> Result<(), houscaper::score::ShellsError> {
/// let shells = houscaper::score::shells(books)?;
/// assert_eq!(houscaper::tiles::depth_um(&shells.wall), 300_000);
/// # Ok(()) }
/// ```
pub fn shells(books: &Books) -> Result<Shells, ShellsError> {
    let file = &books.buildups;
    let roof = listed(file, "roof_pitched", ROOF)?;
    let plinth = listed(file, "plinth", PLINTH)?;
    let beam_mm: f64 = plinth.iter().filter(|(c, _)| *c == C::PerimeterBeam).map(|(_, mm)| mm).sum();
    let section_m2 = file.solid_m3(file.named("perimeter_beam")?, C::PerimeterBeam.name());
    let beam_depth_mm = if beam_mm > 0.0 { section_m2 * 1e9 / (beam_mm * 1e3) } else { 0.0 };
    let shells = Shells {
        wall: stack(listed(file, "wall", WALL)?.into_iter().rev()),
        roof_cover: stack(roof.iter().rev().copied().filter(|(c, _)| *c == C::RoofCovering)),
        roof: stack(roof.iter().rev().copied().filter(|(c, _)| *c != C::RoofCovering)),
        flat: stack(listed(file, "roof_flat", LEVEL)?.into_iter().rev().filter(|(c, _)| !FLOOR.contains(c))),
        deck: stack(listed(file, "deck", LEVEL)?.into_iter().rev().filter(|(c, _)| !FLOOR.contains(c))),
        floor: stack(listed(file, "floor", FLOOR)?.into_iter()),
        soffit: stack(listed(file, "soffit", SOFFIT)?.into_iter()),
        ground: stack(listed(file, "ground_slab", GROUND)?.into_iter()),
        plinth: stack(plinth.iter().rev().copied().filter(|(c, _)| *c != C::PerimeterBeam)),
        beam_um: [whole_mm(beam_mm), whole_mm(beam_depth_mm)],
    };
    check(file, &shells)?;
    Ok(shells)
}

/// The strata of a build-up in the order of the file: component and mm.
fn listed(file: &BuildUps, id: &str, fitting: &[C]) -> Result<Vec<(C, f64)>, ShellsError> {
    let expected = || fitting.iter().map(|c| c.name()).collect::<Vec<_>>().join(", ");
    let strata = file.named(id)?.strata().map_err(|layer| ShellsError::NoStratum {
        file: file.file.clone(),
        buildup: id.into(),
        layer: layer.into(),
        expected: expected(),
    })?;
    let component = |s: &crate::price::BuildUpStratum| {
        let known = fitting.iter().copied().find(|c| c.name() == s.name);
        let component = known.ok_or_else(|| ShellsError::WrongStratum {
            file: file.file.clone(),
            buildup: id.into(),
            layer: s.layer.into(),
            found: s.name.into(),
            expected: expected(),
        })?;
        Ok((component, s.thickness_mm))
    };
    strata.iter().map(component).collect()
}

/// Whole multiples of 5 µm whose sum is whole millimetres; the thickest stratum takes the rest.
fn stack(strata: impl Iterator<Item = (C, f64)>) -> Stack {
    let mut stack: Stack =
        strata.map(|(component, mm)| Stratum { component, thickness_um: (mm * 200.0).round() as i32 * 5 }).collect();
    let sum: i32 = stack.iter().map(|s| s.thickness_um).sum();
    let rest = (sum + 500).div_euclid(1000) * 1000 - sum;
    if let Some(thickest) = stack.iter_mut().max_by_key(|s| s.thickness_um) {
        thickest.thickness_um += rest;
    }
    stack
}

fn whole_mm(mm: f64) -> i32 {
    mm.round() as i32 * 1000
}

/// A tile is half a module of 450 mm deep on each side of a wall and 540 mm high.
fn check(file: &BuildUps, shells: &Shells) -> Result<(), ShellsError> {
    let mm = |stack: &[Stratum]| f64::from(crate::tiles::depth_um(stack)) / 1000.0;
    let edge = mm(&shells.plinth) + f64::from(shells.beam_um[0]) / 1000.0;
    let limits = [
        ("wall", "thickness of the strata", mm(&shells.wall), 350.0, "above 0 and at most 350"),
        ("roof_pitched", "strata inside the roof plane", mm(&shells.roof), 400.0, "above 0 and at most 400"),
        ("roof_flat", "strata above the floor cassette", mm(&shells.flat), 500.0, "above 0 and at most 500"),
        ("deck", "strata above the floor cassette", mm(&shells.deck), 500.0, "above 0 and at most 500"),
        ("floor", "floor and soffit", mm(&shells.floor) + mm(&shells.soffit), 500.0, "above 0 and at most 500"),
        ("ground_slab", "slab and insulation", mm(&shells.ground), 500.0, "above 0 and at most 500"),
        ("plinth", "edge of the foundation with its beam", edge, 440.0, "above 0 and at most 440"),
        (
            "perimeter_beam",
            "depth of the beam",
            f64::from(shells.beam_um[1]) / 1000.0,
            540.0,
            "above 0 and at most 540",
        ),
    ];
    for (buildup, what, found, most, expected) in limits {
        if !(found > 0.0 && found <= most) {
            let file = file.file.clone();
            return Err(ShellsError::Thickness { file, buildup: buildup.into(), what, found, expected });
        }
    }
    Ok(())
}
