//! `tileset sheet`: every tile of a set in its cage, and a few neighbourhoods, on one picture.

use std::collections::BTreeMap;
use std::path::Path;

use houscaper::cubes::{Category, CubeKey, Mask, Rule, catalogue, scan_keys};
use houscaper::envelope::{CubeTile, FabricLayer, mesh};
use houscaper::export::plots::{Card, contact_sheet};
use houscaper::export::tile_sheet::{
    body_tile, neighbourhood, neighbourhood_image, solid_tile, surface_tile, tile_image,
};
use houscaper::export::{Scene, Showing, from_envelope};
use houscaper::score::walked_deck;
use houscaper::tiles::{LabelSet, PlacedTile, Tileset};
use houscaper::voxels::{House, read_storeys};
use serde_json::Value;

use super::Loaded;
use super::architectural::{self, Architectural};
use super::places::{Place, places};
use crate::cli::failure::{Blame, Failure, Outcome, bad_input};
use crate::cli::output;
use crate::cli::progress::WorkBar;

/// Pictures in a row.
const COLUMNS: usize = 6;

pub fn run(dir: &Path, root: Option<&Path>, out: &Path) -> Outcome {
    output::check_picture(out, dir)?;
    let (title, cards) = if architectural::is_style(dir) {
        let set = Architectural::load(dir)?;
        (format!("{}: tiles of the catalogue and neighbourhoods", set.name()), solids(&set)?)
    } else if super::is_solids(dir) {
        let set = LabelSet::load_from(dir, root).input()?;
        (format!("{}: tiles", set.name()), drawn(&set)?)
    } else {
        match super::load(dir)? {
            Loaded::Surface(set) => (format!("{}: tiles and neighbourhoods", set.name()), surfaces(&set)?),
            Loaded::Linear(set) => {
                let message =
                    format!("{}: a linear set has no surfaces to draw; name a surface or solids set", set.name());
                return Err(bad_input(message));
            }
        }
    };
    let png = contact_sheet(&title, COLUMNS, &cards).run()?;
    output::write(out, &png)?;
    eprintln!("{}: {} pictures", out.display(), cards.len());
    Ok(())
}

/// A card for each tile on the first configuration that it covers, in the order of configurations.
fn surfaces(set: &Tileset) -> Result<Vec<Card>, Failure> {
    let mut covered: BTreeMap<&str, Vec<Mask>> = BTreeMap::new();
    Mask::all()
        .filter(|&m| !set.tile_name(m).is_empty())
        .for_each(|m| covered.entry(set.tile_name(m)).or_default().push(m));
    let mut tiles: Vec<(&str, Vec<Mask>)> = covered.into_iter().collect();
    tiles.sort_by_key(|(_, masks)| masks[0]);
    let places = places();
    let bar = WorkBar::new(tiles.len() + places.len(), "pictures");
    let mut cards = Vec::new();
    for (name, masks) in tiles {
        let first = masks[0];
        let caption = format!("{} · serves {}", first.pattern(), masks.len());
        let below = Category::of(first) == Category::Floor;
        cards.push(card(name, &caption, &surface_tile(set, first), below)?);
        bar.step();
    }
    for place in places {
        let mesh = mesh(&place.house.voxels, set).run()?;
        let scene = from_envelope(&mesh, Showing::default(), Value::Null, |_| Value::Null);
        cards.push(place_card(&place, &scene)?);
        bar.step();
    }
    Ok(cards)
}

/// A card for each tile of the thesis's catalogue.
fn solids(set: &Architectural) -> Result<Vec<Card>, Failure> {
    let places = places();
    let (families, palette) = (catalogue(), set.palette());
    let bar = WorkBar::new(families.iter().map(|f| f.tiles).sum::<usize>() + places.len(), "pictures");
    let mut cards = Vec::new();
    for family in &families {
        for (n, labels) in family.representatives().iter().enumerate() {
            let key = CubeKey::of_labels(*labels);
            let tile = set.tile_at(key, [0; 3]);
            let scene = solid_tile(&tile, key.mask(), &palette);
            let below = Category::of(key.mask()) == Category::Floor;
            let title = format!("{} {} of {}", family.name, n + 1, family.tiles);
            let inside = if tile.is_empty() { " · inside a room, nothing stands here" } else { "" };
            cards.push(card(&title, &format!("{key}{inside}"), &scene, below)?);
            bar.step();
        }
    }
    for place in places {
        let scene = neighbourhood(cubes(&place.house, set), &palette);
        cards.push(place_card(&place, &scene)?);
        bar.step();
    }
    Ok(cards)
}

/// A card for each tile of a set of meshes, as it is first placed.
fn drawn(set: &LabelSet) -> Result<Vec<Card>, Failure> {
    let mut tiles: Vec<&PlacedTile> = Vec::new();
    for tile in set.placed_tiles().iter().filter(|t| t.variant == 0) {
        if tiles.last().is_none_or(|last| last.name != tile.name) {
            tiles.push(tile);
        }
    }
    let size = set.module_um().map(|um| f64::from(um) * 1e-6);
    let layers = FabricLayer::of_set(set);
    let bar = WorkBar::new(tiles.len(), "pictures");
    let mut cards = Vec::new();
    for tile in tiles {
        let octants = tile.bodies.iter().fold(Mask::EMPTY, |mask, body| Mask(mask.0 | 1 << body.octant));
        let scene = body_tile(&tile.bodies, size, octants, &layers);
        cards.push(card(&tile.name, &format!("{} bodies", tile.bodies.len()), &scene, false)?);
        bar.step();
    }
    Ok(cards)
}

/// What stands in every cube of a house with the cube's first corner in m.
fn cubes(house: &House, set: &Architectural) -> Vec<([f64; 3], CubeTile)> {
    let reading = read_storeys(house);
    let walked: BTreeMap<usize, _> =
        reading.plates.iter().skip(1).map(|p| (p.k, walked_deck(house, &reading, p))).collect();
    let is_walked = |[x, y, z]: [usize; 3]| walked.get(&z).is_some_and(|plan| plan.has([x as isize, y as isize]));
    let module = house.voxels.module.size_m;
    let mut found = Vec::new();
    scan_keys(&house.voxels, Rule::B, is_walked, |cube, key| {
        found.push(([0, 1, 2].map(|a| (cube[a] as f64 - 1.0) * module[a]), set.tile_at(key, cube)));
    });
    found
}

fn card(title: &str, caption: &str, scene: &Scene, from_below: bool) -> Result<Card, Failure> {
    let image = tile_image(scene, from_below).run()?;
    Ok(Card {
        title: title.into(),
        caption: format!("{caption}{}", if from_below { " · from below" } else { "" }),
        image,
    })
}

fn place_card(place: &Place, scene: &Scene) -> Result<Card, Failure> {
    let image = neighbourhood_image(scene, Some(place.fit), place.azimuth_deg, place.ground_m).run()?;
    Ok(Card { title: place.name.into(), caption: place.caption.into(), image })
}
