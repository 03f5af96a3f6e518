//! From the polygons of an OBJ file to the closed bodies of a tile, with one clear mistake for each thing that can be wrong.

use super::layer::Layer;
use super::manifest::Manifest;
use super::mesh::{crossings, doubled_area, out_of_plane, six_volumes, triangulate};
use super::obj::Element;
use super::polygon::insert_points;
use super::{Component, TilesetError};
use crate::cubes::{Corner, Mask, Symmetry};
use std::collections::BTreeMap;
use std::path::Path;

/// Largest distance of a vertex from its polygon's plane, µm.
const PLANE_TOLERANCE_UM: f64 = 100.0;

/// Farthest a vertex may lie from the cube's first corner for exact arithmetic, µm: 100 m.
const FAR_UM: i32 = 100_000_000;

/// A closed body of a tile.
#[derive(Clone, Debug, PartialEq)]
pub struct Body {
    /// What it is in the building.
    pub component: Component,
    /// Which of the set's layers it is drawn in.
    pub layer: usize,
    /// The octant (0..8) whose voxel it belongs to.
    pub octant: u8,
    /// Its polygons, counter-clockwise from outside, cube-local whole µm, each exactly plane.
    pub polygons: Vec<Vec<[i32; 3]>>,
}

impl Body {
    /// Six times its volume in µm3, exact.
    pub fn six_volumes(&self) -> i128 {
        six_volumes(&self.polygons)
    }

    /// Volume in m3.
    pub fn volume_m3(&self) -> f64 {
        self.six_volumes() as f64 / 6e18
    }

    /// Its surface in triangles, counter-clockwise from outside.
    pub fn triangles(&self) -> impl Iterator<Item = [[i32; 3]; 3]> + '_ {
        self.polygons.iter().flat_map(|polygon| triangulate(polygon))
    }

    /// Lowest and highest coordinates, µm.
    pub fn bounds_um(&self) -> [[i32; 3]; 2] {
        let points = || self.polygons.iter().flatten();
        [
            [0, 1, 2].map(|a| points().map(|p| p[a]).min().unwrap_or(0)),
            [0, 1, 2].map(|a| points().map(|p| p[a]).max().unwrap_or(0)),
        ]
    }

    /// The body of the tile placed with a symmetry in a cube of `size` µm.
    pub(super) fn placed(&self, symmetry: Symmetry, size: [i32; 3]) -> Body {
        let (octant, polygons) = turned(self.octant, &self.polygons, symmetry, size);
        Body { component: self.component, layer: self.layer, octant, polygons }
    }
}

/// Octant and polygons placed with a symmetry in a cube of `size`; a mirror image turns the polygons round, so that they keep facing out.
pub(super) fn turned(
    octant: u8,
    polygons: &[Vec<[i32; 3]>],
    symmetry: Symmetry,
    size: [i32; 3],
) -> (u8, Vec<Vec<[i32; 3]>>) {
    let turned = |polygon: &Vec<[i32; 3]>| {
        let mut points: Vec<_> = polygon.iter().map(|&p| symmetry.point(p, size)).collect();
        if symmetry.mirror {
            points.reverse();
        }
        points
    };
    let octant = Corner::new(octant).map_or(octant, |c| symmetry.corner(c).number());
    (octant, polygons.iter().map(turned).collect())
}

/// Sorts the polygons of a tile into closed bodies. `drawn` are the corners its pattern fills.
pub(super) fn bodies(
    elements: &[Element],
    manifest: &Manifest,
    drawn: Mask,
    path: &Path,
) -> (Vec<Body>, Vec<TilesetError>) {
    let size = manifest.module_mm().map(|mm| mm * 1000);
    let mut mistakes = Vec::new();
    let mut groups: BTreeMap<(usize, &str), Vec<&Element>> = BTreeMap::new();
    let mut unknown: Vec<&str> = Vec::new();
    for element in elements {
        let name =
            if layer_of(&element.group, &manifest.layers).is_some() { &element.group } else { &element.material };
        match layer_of(name, &manifest.layers) {
            Some(layer) if element.is_polygon => {
                if let Some(mistake) = polygon_mistake(element, path) {
                    mistakes.push(mistake);
                } else {
                    groups.entry((layer, name)).or_default().push(element);
                }
            }
            _ if unknown.contains(&element.group.as_str()) => {}
            _ => {
                unknown.push(&element.group);
                mistakes.push(unknown_group(element, &manifest.layers, path));
            }
        }
    }
    let mut found = Vec::new();
    let mut drawn_faces = Vec::new();
    for (&(layer, name), elements) in &groups {
        let Layer { overhang, component, .. } = &manifest.layers[layer];
        let overhang = (overhang * manifest.to_mm() * 1000.0).round() as i32;
        mistakes.extend(leaves_cube(elements, size, overhang, name, path));
        for shell in shells(elements) {
            mistakes.extend(shell_mistake(&shell, name, path));
            // Polygons without area only close the joints of others; what they say goes into the edges of those.
            let solid = shell.iter().filter(|e| doubled_area(&e.points) != [0; 3]);
            let mut polygons: Vec<Vec<[i32; 3]>> = solid.clone().flat_map(|e| plane(&e.points)).collect();
            if polygons.is_empty() {
                continue;
            }
            if solid.count() < shell.len() {
                let mut points: Vec<[i32; 3]> = shell.iter().flat_map(|e| e.points.iter().copied()).collect();
                points.sort_unstable();
                points.dedup();
                polygons.iter_mut().for_each(|p| insert_points(p, &points));
            }
            let octant = octant_of(name, &polygons, size, drawn);
            found.push(Body { component: component.unwrap_or(Component::Cladding), layer, octant, polygons });
        }
        let faces = elements.iter().filter(|e| doubled_area(&e.points) != [0; 3]);
        drawn_faces.extend(faces.map(|e| (&e.points, e.line, name)));
    }
    mistakes.extend(crossings(&drawn_faces, path));
    (found, mistakes)
}

/// A polygon as it is when its corners lie exactly in a plane, else as triangles.
fn plane(polygon: &[[i32; 3]]) -> Vec<Vec<[i32; 3]>> {
    match out_of_plane(polygon) > 0.0 {
        true => triangulate(polygon).into_iter().map(Vec::from).collect(),
        false => vec![polygon.to_vec()],
    }
}

/// The layer of a group or material: its name or one of its groups, alone or followed by `_o<octant>`; a final `*` stands for
/// any ending. The layer that names it most precisely wins.
pub(super) fn layer_of(name: &str, layers: &[Layer]) -> Option<usize> {
    let plain = name.rsplit_once("_o").filter(|(_, o)| o.parse::<u8>().is_ok_and(|o| o < 8)).map_or(name, |(n, _)| n);
    let fits = |wanted: &str| match wanted.strip_suffix('*') {
        Some(start) => name.starts_with(start).then_some(start.len()),
        None => (name == wanted || plain == wanted).then_some(usize::MAX),
    };
    let own = |layer: &Layer| match layer.groups.is_empty() {
        true => fits(&layer.name),
        false => layer.groups.iter().filter_map(|g| fits(g)).max(),
    };
    let candidates = layers.iter().enumerate().filter_map(|(n, layer)| Some((own(layer)?, std::cmp::Reverse(n))));
    candidates.max().map(|(_, std::cmp::Reverse(n))| n)
}

fn unknown_group(element: &Element, layers: &[Layer], path: &Path) -> TilesetError {
    let names: Vec<&str> =
        layers.iter().flat_map(|l| std::iter::once(&l.name).chain(&l.groups)).map(String::as_str).collect();
    TilesetError::Obj {
        path: path.into(),
        line: element.line,
        found: match element.is_polygon {
            true => format!("the group '{}' with the material '{}'", element.group, element.material),
            false => "a line element".into(),
        },
        expected: format!(
            "polygons in a group or material of one of the layers ({}); rename it or declare a layer for it",
            names.join(", ")
        ),
    }
}

fn polygon_mistake(element: &Element, path: &Path) -> Option<TilesetError> {
    let what = if element.points.iter().flatten().any(|c| c.abs() > FAR_UM) {
        "lies more than 100 m from its cube".to_string()
    } else if (0..element.points.len()).any(|n| element.points[..n].contains(&element.points[n])) {
        "meets a vertex twice".to_string()
    } else {
        let off = out_of_plane(&element.points);
        if off <= PLANE_TOLERANCE_UM {
            return None;
        }
        format!("is {:.2} mm out of plane", off / 1000.0)
    };
    Some(TilesetError::Polygon { path: path.into(), line: element.line, what })
}

/// The vertex of a group that lies farthest outside the cube, when that is more than declared.
fn leaves_cube(elements: &[&Element], size: [i32; 3], overhang: i32, name: &str, path: &Path) -> Option<TilesetError> {
    let points = elements.iter().flat_map(|e| e.points.iter().zip(&e.point_lines));
    let beyond = |p: &[i32; 3]| (0..3).map(|a| (-p[a]).max(p[a] - size[a])).max().unwrap_or(0);
    let (point, &line) = points.max_by_key(|(p, line)| (beyond(p), std::cmp::Reverse(**line)))?;
    (beyond(point) > overhang).then(|| TilesetError::LeavesCube {
        path: path.into(),
        line,
        vertex: point.map(|c| (f64::from(c) / 1000.0).round() as i32),
        // Rounded up, so that a micrometre too much does not read as the overhang itself.
        beyond: beyond(point).div_euclid(1000) + i32::from(beyond(point).rem_euclid(1000) > 0),
        layer: name.into(),
        overhang: overhang / 1000,
    })
}

/// The polygons of a group by what hangs together along edges.
fn shells<'a>(elements: &[&'a Element]) -> Vec<Vec<&'a Element>> {
    let mut parent: Vec<usize> = (0..elements.len()).collect();
    fn root(parent: &mut [usize], mut n: usize) -> usize {
        while parent[n] != n {
            parent[n] = parent[parent[n]];
            n = parent[n];
        }
        n
    }
    let mut owners: BTreeMap<[[i32; 3]; 2], usize> = BTreeMap::new();
    for (n, element) in elements.iter().enumerate() {
        for [from, to] in edges(element) {
            let edge = if from < to { [from, to] } else { [to, from] };
            let other = *owners.entry(edge).or_insert(n);
            let (a, b) = (root(&mut parent, n), root(&mut parent, other));
            parent[a.max(b)] = a.min(b);
        }
    }
    let mut shells: BTreeMap<usize, Vec<&Element>> = BTreeMap::new();
    for (n, &element) in elements.iter().enumerate() {
        shells.entry(root(&mut parent, n)).or_default().push(element);
    }
    shells.into_values().collect()
}

fn edges(element: &Element) -> impl Iterator<Item = [[i32; 3]; 2]> + '_ {
    let n = element.points.len();
    (0..n).map(move |i| [element.points[i], element.points[(i + 1) % n]])
}

/// What keeps a shell from being a body: an open edge, a face turned over, or all of them.
fn shell_mistake(shell: &[&Element], name: &str, path: &Path) -> Option<TilesetError> {
    let mut count: BTreeMap<[[i32; 3]; 2], (i32, usize)> = BTreeMap::new();
    for element in shell {
        for edge in edges(element) {
            let entry = count.entry(edge).or_insert((0, element.line));
            *entry = (entry.0 + 1, element.line);
        }
    }
    let mm = |p: [i32; 3]| p.map(|c| (f64::from(c) / 1000.0).round() as i32);
    let opposite = |[from, to]: [[i32; 3]; 2]| count.get(&[to, from]).map_or(0, |c| c.0);
    let uneven = count.iter().filter(|(edge, c)| c.0 > opposite(**edge));
    // A face turned over shows as an edge used twice in one direction; an open shell does not.
    if let Some((&[from, to], &(n, line))) = uneven.max_by_key(|(_, c)| c.0) {
        let (path, from, to) = (path.into(), mm(from), mm(to));
        return Some(match n {
            2.. => TilesetError::EdgeTwice { path, line, from, to },
            _ => TilesetError::OpenSolid { path, line, group: name.into(), from, to },
        });
    }
    let volume = six_volumes(shell.iter().map(|e| &e.points));
    (volume <= 0).then(|| TilesetError::InsideOut {
        path: path.into(),
        line: shell.first().map_or(1, |e| e.line),
        group: name.into(),
        volume_m3: volume as f64 / 6e18,
    })
}

/// The octant of the group's name, else the filled corner nearest to the middle of the body's bounds.
fn octant_of(name: &str, polygons: &[Vec<[i32; 3]>], size: [i32; 3], drawn: Mask) -> u8 {
    let named = name.rsplit_once("_o").and_then(|(_, o)| o.parse::<u8>().ok()).filter(|o| *o < 8);
    let points = || polygons.iter().flatten();
    let middle = [0, 1, 2].map(|a| {
        let range = points().map(|p| i64::from(p[a]));
        (range.clone().min().unwrap_or(0) + range.max().unwrap_or(0)) / 2
    });
    let distance = |c: Corner| -> i64 {
        let at = c.xyz();
        (0..3).map(|a| (middle[a] - i64::from(at[a]) * i64::from(size[a])).pow(2)).sum()
    };
    named.unwrap_or_else(|| {
        Corner::all().filter(|&c| drawn.has(c)).min_by_key(|&c| distance(c)).map_or(0, Corner::number)
    })
}
