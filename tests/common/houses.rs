//! Small houses made by hand, for tests of what comes out of the program.
#![allow(dead_code)]

use houscaper::envelope::{Mesh, Surface};

/// Adds a convex planar polygon, counter-clockwise from outside.
pub fn polygon(mesh: &mut Mesh, surface: Surface, corners: &[[f64; 3]]) {
    let index: Vec<u32> = corners
        .iter()
        .map(|c| match mesh.vertices.iter().position(|v| (0..3).all(|a| (v[a] - c[a]).abs() < 1e-9)) {
            Some(i) => i as u32,
            None => {
                mesh.vertices.push(*c);
                mesh.vertices.len() as u32 - 1
            }
        })
        .collect();
    for i in 2..index.len() {
        mesh.triangles.push([index[0], index[i - 1], index[i]]);
        mesh.surfaces.push(surface);
    }
}

/// What a facade module at plan step `u` (0 = first) and layer `k` of the side `side` (0 = -y, 1 = +x, 2 = +y, 3 = -x) is.
pub type Facade = dyn Fn(usize, usize, usize) -> Surface;

/// A block of nx x ny modules over layers k0..k1 with facades by module, on the grid whose first voxel centre is 0.
pub fn block(mesh: &mut Mesh, [x0, y0]: [usize; 2], [nx, ny]: [usize; 2], [k0, k1]: [usize; 2], facade: &Facade) {
    let at = |i: usize, j: usize, k: usize| [i as f64 * 0.9 - 0.45, j as f64 * 0.9 - 0.45, k as f64 * 0.54 - 0.27];
    let (x1, y1) = (x0 + nx, y0 + ny);
    for k in k0..k1 {
        for u in 0..nx {
            let (a, b) = (x0 + u, x0 + u + 1);
            polygon(mesh, facade(0, u, k), &[at(a, y0, k), at(b, y0, k), at(b, y0, k + 1), at(a, y0, k + 1)]);
            polygon(mesh, facade(2, u, k), &[at(b, y1, k), at(a, y1, k), at(a, y1, k + 1), at(b, y1, k + 1)]);
        }
        for u in 0..ny {
            let (a, b) = (y0 + u, y0 + u + 1);
            polygon(mesh, facade(1, u, k), &[at(x1, a, k), at(x1, b, k), at(x1, b, k + 1), at(x1, a, k + 1)]);
            polygon(mesh, facade(3, u, k), &[at(x0, b, k), at(x0, a, k), at(x0, a, k + 1), at(x0, b, k + 1)]);
        }
    }
}

/// A hipped roof over a block, `rise` layers high with a run of one module a layer, on top of layer `k`.
pub fn hip(mesh: &mut Mesh, [x0, y0]: [usize; 2], [nx, ny]: [usize; 2], k: usize, rise: usize) {
    let z = |k: f64| k * 0.54 - 0.27;
    let x = |i: f64| i * 0.9 - 0.45;
    let d = (rise as f64).min(nx.min(ny) as f64 / 2.0);
    let (a, b) = (x0 as f64, y0 as f64);
    let (c, e) = (a + nx as f64, b + ny as f64);
    let low = [[x(a), x(b)], [x(c), x(b)], [x(c), x(e)], [x(a), x(e)]].map(|[u, v]| [u, v, z(k as f64)]);
    let high = [[x(a + d), x(b + d)], [x(c - d), x(b + d)], [x(c - d), x(e - d)], [x(a + d), x(e - d)]]
        .map(|[u, v]| [u, v, z(k as f64 + d)]);
    for s in 0..4 {
        let t = (s + 1) % 4;
        polygon(mesh, Surface::PitchedRoof, &[low[s], low[t], high[t], high[s]]);
    }
    polygon(mesh, Surface::FlatRoof, &high);
}

fn cap(mesh: &mut Mesh, surface: Surface, [x0, y0]: [usize; 2], [nx, ny]: [usize; 2], k: usize, up: bool) {
    let x = |i: usize| i as f64 * 0.9 - 0.45;
    let z = k as f64 * 0.54 - 0.27;
    let mut corners = [[x(x0), x(y0), z], [x(x0 + nx), x(y0), z], [x(x0 + nx), x(y0 + ny), z], [x(x0), x(y0 + ny), z]];
    if !up {
        corners.reverse();
    }
    polygon(mesh, surface, &corners);
}

/// Label by layer with the given windows and a door, as our facades are: slab bands, sills, windows three modules high.
fn storey_facade(windows: &'static [(usize, usize, std::ops::Range<usize>)], door: (usize, usize)) -> Box<Facade> {
    Box::new(move |side, u, k| {
        let row = k % 6;
        let storey = k / 6;
        if k == 0 {
            Surface::Plinth
        } else if row == 0 {
            Surface::Band
        } else if storey == 0 && (side, u) == door && (1..5).contains(&row) {
            Surface::Door
        } else if (2..5).contains(&row) && windows.iter().any(|(s, l, r)| *s == side && *l == storey && r.contains(&u))
        {
            Surface::Window
        } else {
            Surface::Wall
        }
    })
}

/// Two storeys of 8 x 6 modules with a hipped roof and a one-storey wing with a deck on it.
pub fn villa() -> Mesh {
    let mut mesh = Mesh::default();
    let main = storey_facade(
        &[(0, 0, 1..4), (0, 1, 1..3), (0, 1, 5..7), (1, 1, 1..5), (2, 0, 2..4), (2, 1, 2..4), (3, 1, 2..4)],
        (0, 5),
    );
    let wing = storey_facade(&[(0, 0, 1..3), (1, 0, 1..3), (2, 0, 1..3)], (9, 9));
    block(&mut mesh, [0, 0], [8, 6], [0, 13], &*main);
    hip(&mut mesh, [0, 0], [8, 6], 13, 3);
    cap(&mut mesh, Surface::Ground, [0, 0], [8, 6], 0, false);
    block(&mut mesh, [8, 1], [4, 4], [0, 7], &*wing);
    cap(&mut mesh, Surface::Deck, [8, 1], [4, 4], 7, true);
    cap(&mut mesh, Surface::Ground, [8, 1], [4, 4], 0, false);
    mesh
}

/// One storey of 7 x 5 modules with a flat roof.
pub fn bungalow() -> Mesh {
    let mut mesh = Mesh::default();
    let facade = storey_facade(&[(0, 0, 1..5), (1, 0, 1..3), (2, 0, 2..4), (3, 0, 1..3)], (1, 4));
    block(&mut mesh, [0, 0], [7, 5], [0, 7], &*facade);
    cap(&mut mesh, Surface::FlatRoof, [0, 0], [7, 5], 7, true);
    cap(&mut mesh, Surface::Ground, [0, 0], [7, 5], 0, false);
    mesh
}
