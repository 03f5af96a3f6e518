//! Turning the polygons of one OBJ file into facets and solids, with one clear error for each thing that can be wrong.

use super::layer::{Layer, LayerKind};
use super::manifest::Manifest;
use super::obj::Element;
use super::polygon::{doubled_area, out_of_plane};
use super::{Facet, Patch, PatchKind, TilesetError};
use std::collections::BTreeMap;
use std::path::Path;

/// Largest distance of a vertex from its polygon's plane, mm: vertices are whole millimetres, so half of one is unavoidable.
const PLANE_TOLERANCE_MM: f64 = 1.0;

type Edge = [[i32; 3]; 2];

/// The boundary and the bodies of one tile.
#[derive(Debug, Default)]
pub(super) struct Content {
    pub facets: Vec<Facet>,
    /// Line of each facet in the file.
    pub lines: Vec<usize>,
    pub solids: Vec<super::Solid>,
}

/// Checks the elements of a surface tile and sorts them into facets and solids; what is wrong is listed, and left out where it has
/// no shape.
pub(super) fn surface_content(elements: &[Element], manifest: &Manifest, path: &Path) -> (Content, Vec<TilesetError>) {
    let implied = [Layer {
        name: "envelope".into(),
        kind: LayerKind::Surface,
        overhang: 0.0,
        component: None,
        groups: Vec::new(),
    }];
    let layers: &[Layer] = if manifest.layers.is_empty() { &implied } else { &manifest.layers };
    let size = manifest.module_mm();
    let mut content = Content::default();
    let mut mistakes = Vec::new();
    if elements.is_empty() {
        let (found, expected) = ("no polygons".into(), "faces; a tile that holds nothing has no file".into());
        mistakes.push(TilesetError::Obj { path: path.into(), line: 1, found, expected });
    }
    let mut surface: Vec<&Element> = Vec::new();
    // Position in `content.solids` and polygons of each body.
    let mut bodies: BTreeMap<&str, (usize, Vec<&Element>)> = BTreeMap::new();
    for element in elements {
        let (layer, kind, octant) = match group(element, layers, path) {
            Ok(known) => known,
            Err(mistake) => {
                mistakes.push(mistake);
                continue;
            }
        };
        mistakes.extend(check_bounds(element, &layers[layer], size, manifest.to_mm(), path).err());
        if let Err(mistake) = check_polygon(element, path) {
            mistakes.push(mistake);
            continue;
        }
        match kind {
            Some(kind) => {
                let facet = Facet { kind, octant, polygon: element.points.clone() };
                if Patch::new(facet.clone()).is_none() {
                    let what = "crosses or touches itself".into();
                    mistakes.push(TilesetError::Polygon { path: path.into(), line: element.line, what });
                } else {
                    surface.push(element);
                    content.facets.push(facet);
                    content.lines.push(element.line);
                }
            }
            None => {
                let next = content.solids.len();
                let (_, body) = bodies.entry(&element.group).or_insert((next, Vec::new()));
                if body.is_empty() {
                    let layer = layers[layer].name.clone();
                    content.solids.push(super::Solid { layer, octant, polygons: Vec::new() });
                }
                body.push(element);
            }
        }
    }
    check_surface(&surface, size, path, &mut mistakes);
    for (name, (at, body)) in &bodies {
        check_solid(name, body, path, &mut mistakes);
        content.solids[*at].polygons = body.iter().map(|e| e.points.clone()).collect();
    }
    (content, mistakes)
}

/// Layer, kind (for a surface) and octant of a group name.
fn group(element: &Element, layers: &[Layer], path: &Path) -> Result<(usize, Option<PatchKind>, u8), TilesetError> {
    let known = element.group.rsplit_once("_o").and_then(|(name, octant)| {
        let octant = octant.parse::<u8>().ok().filter(|o| *o < 8)?;
        let solid = layers.iter().position(|l| l.kind == LayerKind::Solid && l.name == name);
        if let Some(layer) = solid {
            return Some((layer, None, octant));
        }
        let kind = PatchKind::ALL.into_iter().find(|k| k.name() == name)?;
        let layer = layers.iter().position(|l| l.kind == LayerKind::Surface)?;
        Some((layer, Some(kind), octant))
    });
    match known {
        Some(known) if element.is_polygon => Ok(known),
        _ => Err(TilesetError::Obj {
            path: path.into(),
            line: element.line,
            found: if element.is_polygon { format!("the group '{}'", element.group) } else { "a line element".into() },
            expected: "a polygon in a group roof, wall, soffit, deck or the name of a solid layer, followed by _o and the octant \
                       0 to 7, for example wall_o3"
                .into(),
        }),
    }
}

fn check_polygon(element: &Element, path: &Path) -> Result<(), TilesetError> {
    let what = if doubled_area(&element.points) == [0; 3] {
        "has no area".to_string()
    } else {
        let off = out_of_plane(&element.points);
        if off <= PLANE_TOLERANCE_MM {
            return Ok(());
        }
        format!("is {off:.1} mm out of plane")
    };
    Err(TilesetError::Polygon { path: path.into(), line: element.line, what })
}

fn check_bounds(element: &Element, layer: &Layer, size: [i32; 3], to_mm: f64, path: &Path) -> Result<(), TilesetError> {
    let overhang = (layer.overhang * to_mm).round() as i32;
    for (point, &line) in element.points.iter().zip(&element.point_lines) {
        let beyond = (0..3).map(|a| (-point[a]).max(point[a] - size[a])).max().unwrap_or(0);
        if beyond > overhang {
            return Err(TilesetError::LeavesCube {
                path: path.into(),
                line,
                vertex: *point,
                beyond,
                layer: layer.name.clone(),
                overhang,
            });
        }
    }
    Ok(())
}

/// Directed edges with the line of their polygon; an edge used twice in one direction is a mistake.
fn edges(elements: &[&Element], path: &Path, mistakes: &mut Vec<TilesetError>) -> BTreeMap<Edge, usize> {
    let mut edges = BTreeMap::new();
    for element in elements {
        for (n, &from) in element.points.iter().enumerate() {
            let to = element.points[(n + 1) % element.points.len()];
            if edges.insert([from, to], element.line).is_some() {
                mistakes.push(TilesetError::EdgeTwice { path: path.into(), line: element.line, from, to });
            }
        }
    }
    edges
}

fn check_surface(elements: &[&Element], size: [i32; 3], path: &Path, mistakes: &mut Vec<TilesetError>) {
    let edges = edges(elements, path, mistakes);
    for (&[from, to], &line) in &edges {
        let free = !edges.contains_key(&[to, from]);
        let on_face = (0..3).any(|a| from[a] == to[a] && (from[a] == 0 || from[a] == size[a]));
        if free && !on_face {
            mistakes.push(TilesetError::EndsInside { path: path.into(), line, from, to });
        }
    }
}

fn check_solid(name: &str, elements: &[&Element], path: &Path, mistakes: &mut Vec<TilesetError>) {
    let edges = edges(elements, path, mistakes);
    if let Some((&[from, to], &line)) = edges.iter().find(|([from, to], _)| !edges.contains_key(&[*to, *from])) {
        mistakes.push(TilesetError::OpenSolid { path: path.into(), line, group: name.into(), from, to });
    }
}
