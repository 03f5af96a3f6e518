//! Windows and doors as they are seen: set back behind the facade, with reveals, frames and mullions.

use std::collections::BTreeMap;

use glam::DVec3;

use super::scene::Part;
use super::solid::beam_solid;

/// How far and with what bars an opening is set back.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Setting {
    /// Distance behind the facade in m.
    pub depth_m: f64,
    /// Width of the frame's bars in m.
    pub bar_m: f64,
    /// Mullions on the lines of this grid (a line's x and y, the spacings), or none.
    pub grid: Option<[[f64; 2]; 2]>,
}

/// A directed edge of an opening's outline with the outward normal of its facade.
#[derive(Clone, Copy, Debug)]
struct Edge {
    from: DVec3,
    to: DVec3,
    normal: DVec3,
}

/// Moves the vertical faces of `part` back by the setting's depth; adds the reveals around each opening to `reveals`
/// and bars along its outline and on the mullion grid to `frame`. Faces that are not vertical stay where they are.
pub fn set_back(part: &mut Part, setting: Setting, reveals: &mut Part, frame: &mut Part) {
    let faces: Vec<([u32; 3], DVec3)> =
        part.triangles.iter().filter_map(|&t| Some((t, upright_normal(part.corners(t)?)?))).collect();
    let outline = outline(part, &faces);
    for edge in &outline {
        reveals.polygon(&reveal(*edge, setting.depth_m));
    }
    for run in join_collinear(outline) {
        frame.append(&bar(run, setting, run.normal.cross(run.to - run.from).normalize_or_zero() * 0.5));
    }
    if let Some(grid) = setting.grid {
        mullions(part, &faces, setting, grid, frame);
    }
    move_back(part, &faces, setting.depth_m);
}

fn upright_normal([a, b, c]: [[f64; 3]; 3]) -> Option<DVec3> {
    let (a, b, c) = (DVec3::from(a), DVec3::from(b), DVec3::from(c));
    (b - a).cross(c - a).try_normalize().filter(|n| n.z.abs() < 1e-6)
}

/// Facades are told apart by normal to the nearest thousandth.
fn key(normal: DVec3) -> [i32; 2] {
    [(normal.x * 1e3).round() as i32, (normal.y * 1e3).round() as i32]
}

/// Edges that only one face of its facade has.
fn outline(part: &Part, faces: &[([u32; 3], DVec3)]) -> Vec<Edge> {
    let mut edges: BTreeMap<([i32; 2], u32, u32), DVec3> = BTreeMap::new();
    for (t, normal) in faces {
        for (a, b) in [(t[0], t[1]), (t[1], t[2]), (t[2], t[0])] {
            edges.insert((key(*normal), a, b), *normal);
        }
    }
    let at = |v: u32| DVec3::from(part.vertices[v as usize]);
    edges
        .iter()
        .filter(|((facade, a, b), _)| !edges.contains_key(&(*facade, *b, *a)))
        .map(|((_, a, b), normal)| Edge { from: at(*a), to: at(*b), normal: *normal })
        .collect()
}

/// The quad between an edge of the hole in the facade and the same edge of the glass, facing into the opening.
fn reveal(edge: Edge, depth: f64) -> [[f64; 3]; 4] {
    let back = -edge.normal * depth;
    [edge.from, edge.to, edge.to + back, edge.from + back].map(|p| p.to_array())
}

/// Joins edges that continue each other in a straight line.
fn join_collinear(mut edges: Vec<Edge>) -> Vec<Edge> {
    let mut runs: Vec<Edge> = Vec::new();
    while let Some(mut run) = edges.pop() {
        while let Some(i) = edges.iter().position(|e| continues(run, *e) || continues(*e, run)) {
            let next = edges.swap_remove(i);
            if continues(run, next) {
                run.to = next.to;
            } else {
                run.from = next.from;
            }
        }
        runs.push(run);
    }
    runs
}

fn continues(a: Edge, b: Edge) -> bool {
    let (u, v) = ((a.to - a.from).normalize_or_zero(), (b.to - b.from).normalize_or_zero());
    a.to.distance(b.from) < 1e-9 && u.dot(v) > 1.0 - 1e-9 && a.normal.dot(b.normal) > 1.0 - 1e-9
}

/// A bar along a run, just in front of the set-back plane; `shift` moves it by so many bar widths.
fn bar(run: Edge, setting: Setting, shift: DVec3) -> Part {
    let depth = 0.04;
    let place = run.normal * (0.5 * depth - setting.depth_m) + shift * setting.bar_m;
    beam_solid((run.from + place).to_array(), (run.to + place).to_array(), run.normal.to_array(), setting.bar_m, depth)
}

/// Faces of one facade plane, told apart by normal and distance from the origin in tenths of a millimetre.
type Facades = BTreeMap<([i32; 2], i64), Vec<[DVec3; 3]>>;

/// Upright bars where grid lines cross the inside of an opening.
fn mullions(part: &Part, faces: &[([u32; 3], DVec3)], setting: Setting, grid: [[f64; 2]; 2], frame: &mut Part) {
    let mut facades = Facades::new();
    for (t, normal) in faces {
        let corners = t.map(|v| DVec3::from(part.vertices[v as usize]));
        facades.entry((key(*normal), (corners[0].dot(*normal) * 1e4).round() as i64)).or_default().push(corners);
    }
    for ((facade, _), corners) in facades {
        let normal = DVec3::new(f64::from(facade[0]), f64::from(facade[1]), 0.0) * 1e-3;
        for edge in facade_mullions(&corners, normal, grid) {
            frame.append(&bar(edge, setting, DVec3::ZERO));
        }
    }
}

/// The grid lines of one facade plane, each over the heights where the opening reaches past it on both sides.
fn facade_mullions(faces: &[[DVec3; 3]], normal: DVec3, [line, spacing]: [[f64; 2]; 2]) -> Vec<Edge> {
    let side = DVec3::Z.cross(normal);
    let axis = usize::from(normal.x.abs() > normal.y.abs());
    let all = || faces.iter().flatten();
    let (low, high) = all().fold((f64::MAX, f64::MIN), |(l, h), p| (l.min(p[axis]), h.max(p[axis])));
    let mut levels: Vec<f64> = all().map(|p| p.z).collect();
    levels.sort_by(f64::total_cmp);
    levels.dedup_by(|a, b| (*a - *b).abs() < 1e-6);
    let covered = |p: DVec3| faces.iter().any(|f| holds(*f, normal, p));
    let mut edges: Vec<Edge> = Vec::new();
    for step in
        ((low - line[axis]) / spacing[axis]).ceil() as i64..=((high - line[axis]) / spacing[axis]).floor() as i64
    {
        let along = line[axis] + step as f64 * spacing[axis];
        let mut on_line = faces[0][0];
        on_line += side * ((along - on_line[axis]) / side[axis]);
        for pair in levels.windows(2) {
            let (from, to) = (on_line.with_z(pair[0]), on_line.with_z(pair[1]));
            let middle = 0.5 * (from + to);
            if !(covered(middle + side * 0.01) && covered(middle - side * 0.01)) {
                continue;
            }
            match edges.last_mut() {
                Some(last) if last.to.distance(from) < 1e-6 => last.to = to,
                _ => edges.push(Edge { from, to, normal }),
            }
        }
    }
    edges
}

fn holds(corners: [DVec3; 3], normal: DVec3, q: DVec3) -> bool {
    let [a, b, c] = corners;
    [(a, b), (b, c), (c, a)].iter().all(|(u, v)| (*v - *u).cross(q - *u).dot(normal) > -1e-9)
}

/// Gives every upright face vertices of its own facade, moved back.
fn move_back(part: &mut Part, faces: &[([u32; 3], DVec3)], depth: f64) {
    let mut moved: BTreeMap<([i32; 2], u32), u32> = BTreeMap::new();
    let normals: BTreeMap<[u32; 3], DVec3> = faces.iter().copied().collect();
    let mut vertices = Vec::new();
    let mut triangles = Vec::with_capacity(part.triangles.len());
    for t in &part.triangles {
        let normal = normals.get(t).copied();
        triangles.push(t.map(|v| {
            *moved.entry((normal.map_or([0, 0], key), v)).or_insert_with(|| {
                let back = normal.unwrap_or_default() * depth;
                vertices.push((DVec3::from(part.vertices[v as usize]) - back).to_array());
                vertices.len() as u32 - 1
            })
        }));
    }
    part.vertices = vertices;
    part.triangles = triangles;
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A window 1.8 m wide and 1.62 m high in the plane y = 0, facing -y, in four triangles that share no mullion edge.
    fn window() -> Part {
        let mut part = Part::new("window", 0);
        part.vertices = vec![
            [0.45, 0.0, 1.0],
            [2.25, 0.0, 1.0],
            [2.25, 0.0, 1.8],
            [2.25, 0.0, 2.62],
            [0.45, 0.0, 2.62],
            [0.45, 0.0, 1.8],
        ];
        part.triangles = vec![[0, 1, 2], [0, 2, 5], [5, 2, 3], [5, 3, 4]];
        part
    }

    #[test]
    fn an_opening_gets_reveals_a_frame_and_a_mullion_a_module() {
        let (mut part, mut reveals, mut frame) = (window(), Part::default(), Part::default());
        let setting = Setting { depth_m: 0.12, bar_m: 0.06, grid: Some([[-0.45, -0.45], [0.9, 0.9]]) };
        set_back(&mut part, setting, &mut reveals, &mut frame);
        assert!(part.vertices.iter().all(|v| (v[1] - 0.12).abs() < 1e-12), "glass stands 120 mm behind the facade");
        assert_eq!(reveals.triangles.len(), 2 * 6, "six edges of outline, two triangles each");
        assert_eq!(frame.triangles.len(), 12 * (4 + 1), "four joined bars and one mullion at x = 1.35");
        let inside = frame.vertices.iter().all(|v| v[0] > 0.449 && v[0] < 2.251 && v[2] > 0.999 && v[2] < 2.621);
        assert!(inside, "bars lie inside the opening");
    }

    #[test]
    fn faces_that_are_not_upright_stay() {
        let mut part = Part::new("rooflight", 0);
        part.polygon(&[[0.0; 3], [1.0, 0.0, 0.0], [1.0, 1.0, 0.6], [0.0, 1.0, 0.6]]);
        let before = part.clone();
        let (mut reveals, mut frame) = (Part::default(), Part::default());
        set_back(&mut part, Setting { depth_m: 0.1, bar_m: 0.05, grid: None }, &mut reveals, &mut frame);
        assert_eq!(part, before);
        assert!(reveals.triangles.is_empty() && frame.triangles.is_empty());
    }
}
