//! What tests of solids ask of blocks: whether they are valid and disjoint, and what they cut out of a plane.
#![allow(dead_code, reason = "each test file uses a part")]

use houscaper::tiles::{Block, Component, Shells, Stratum};

/// A stack of strata in µm.
pub fn stack(strata: &[(Component, i32)]) -> Vec<Stratum> {
    strata.iter().map(|&(component, thickness_um)| Stratum { component, thickness_um }).collect()
}

/// Strata like those of the build-ups: a wall of 300 mm, 240 mm on level roofs, 230 mm on decks.
pub fn shells() -> Shells {
    use Component as C;
    Shells {
        wall: stack(&[(C::Cladding, 47_000), (C::WallInsulation, 240_000), (C::WallLining, 13_000)]),
        roof_cover: stack(&[(C::RoofCovering, 70_000)]),
        roof: stack(&[(C::RoofInsulation, 235_000), (C::RoofLining, 15_000)]),
        flat: stack(&[(C::FlatMembrane, 10_000), (C::FlatInsulation, 230_000)]),
        deck: stack(&[(C::DeckBoards, 50_000), (C::FlatInsulation, 180_000)]),
        floor: stack(&[(C::FloorBoards, 22_000), (C::FloorStructure, 145_000), (C::Ceiling, 13_000)]),
        soffit: stack(&[(C::SoffitInsulation, 100_000), (C::SoffitBoards, 20_000)]),
        ground: stack(&[(C::GroundSlab, 150_000), (C::GroundInsulation, 150_000)]),
        plinth: stack(&[(C::PlinthRender, 10_000), (C::PlinthInsulation, 120_000)]),
        beam_um: [300_000, 600_000],
    }
}

fn cross(a: [i32; 2], b: [i32; 2], c: [i32; 2]) -> i64 {
    i64::from(b[0] - a[0]) * i64::from(c[1] - a[1]) - i64::from(b[1] - a[1]) * i64::from(c[0] - a[0])
}

/// What makes a block invalid, in words.
pub fn fault(block: &Block) -> Option<String> {
    let n = block.plan.len();
    if n < 3 || block.bottom.len() != n || block.top.len() != n {
        return Some("corners and heights do not agree".into());
    }
    if (0..n).any(|i| cross(block.plan[i], block.plan[(i + 1) % n], block.plan[(i + 2) % n]) <= 0) {
        return Some("plan not convex and counter-clockwise".into());
    }
    if block.six_volumes() <= 0 || block.bottom.iter().zip(&block.top).any(|(b, t)| b > t) {
        return Some("no volume, or upside down".into());
    }
    for heights in [&block.bottom, &block.top] {
        // z at every corner from the plane through the first three.
        let [a, b, c] = [0, 1, 2].map(|i| block.plan[i]);
        let area = cross(a, b, c) as i128;
        for i in 3..n {
            let p = block.plan[i];
            let (wb, wc) = (cross(a, p, c) as i128, cross(a, b, p) as i128);
            let z = |j: usize| heights[j] as i128;
            if (z(i) - z(0)) * area != (z(1) - z(0)) * wb + (z(2) - z(0)) * wc {
                return Some("a face is not plane".into());
            }
        }
    }
    None
}

/// Lower and upper height of a block at a point of its plan.
fn heights(block: &Block, p: [f64; 2]) -> [f64; 2] {
    let at = |i: usize| block.plan[i].map(f64::from);
    let [a, b, c] = [at(0), at(1), at(2)];
    let cross = |a: [f64; 2], b: [f64; 2], c: [f64; 2]| (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
    let area = cross(a, b, c);
    let (wb, wc) = (cross(a, p, c) / area, cross(a, b, p) / area);
    [&block.bottom, &block.top].map(|h| {
        let [h0, h1, h2] = [0, 1, 2].map(|i| f64::from(h[i]));
        h0 + wb * (h1 - h0) + wc * (h2 - h0)
    })
}

/// The common part of two plans.
fn clip(a: &Block, b: &Block) -> Vec<[f64; 2]> {
    let mut polygon: Vec<[f64; 2]> = a.plan.iter().map(|p| p.map(f64::from)).collect();
    let n = b.plan.len();
    for i in 0..n {
        let (p, q) = (b.plan[i].map(f64::from), b.plan[(i + 1) % n].map(f64::from));
        let side = |r: [f64; 2]| (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]);
        let mut kept = Vec::new();
        for j in 0..polygon.len() {
            let (r, s) = (polygon[j], polygon[(j + 1) % polygon.len()]);
            let (dr, ds) = (side(r), side(s));
            if dr >= 0.0 {
                kept.push(r);
            }
            if (dr > 0.0 && ds < 0.0) || (dr < 0.0 && ds > 0.0) {
                let t = dr / (dr - ds);
                kept.push([r[0] + t * (s[0] - r[0]), r[1] + t * (s[1] - r[1])]);
            }
        }
        polygon = kept;
    }
    polygon
}

/// Whether two blocks share volume: more than 1 µm of height somewhere over more than 1 mm2 of plan. Looks at corners, edge middles
/// and the middle of the common plan, which is exact where heights are level.
pub fn overlap(a: &Block, b: &Block) -> bool {
    let span = |z: &Block| (z.bottom.iter().min().copied().unwrap_or(0), z.top.iter().max().copied().unwrap_or(0));
    let ((a0, a1), (b0, b1)) = (span(a), span(b));
    if a0 >= b1 || b0 >= a1 {
        return false;
    }
    let common = clip(a, b);
    let n = common.len();
    let area: f64 =
        (0..n).map(|i| common[i][0] * common[(i + 1) % n][1] - common[(i + 1) % n][0] * common[i][1]).sum::<f64>()
            / 2.0;
    if n < 3 || area < 1e6 {
        return false;
    }
    let middle = [0, 1].map(|k| common.iter().map(|p| p[k]).sum::<f64>() / n as f64);
    let mut points = vec![middle];
    for i in 0..n {
        let (p, q) = (common[i], common[(i + 1) % n]);
        points.push([0, 1].map(|k| (p[k] + q[k]) / 2.0));
        points.push([0, 1].map(|k| p[k] * 0.99 + middle[k] * 0.01));
    }
    points.into_iter().any(|p| {
        let ([al, ah], [bl, bh]) = (heights(a, p), heights(b, p));
        ah.min(bh) - al.max(bl) > 1.0
    })
}

/// The first fault or overlap among blocks.
pub fn first_fault(blocks: &[Block]) -> Option<String> {
    for (n, block) in blocks.iter().enumerate() {
        if let Some(fault) = fault(block) {
            return Some(format!("{fault}: {block:?}"));
        }
        if let Some(other) = blocks[..n].iter().find(|other| overlap(block, other)) {
            return Some(format!("overlap:\n{block:?}\n{other:?}"));
        }
    }
    None
}

/// A rectangle of a section: component, the part of the line across, and of the height, µm.
pub type Piece = (Component, [i32; 2], Vec<i32>);

/// The outlines that blocks leave on the cube face across `axis` at `at` µm when they lie on its `side` (-1 below, +1 beyond):
/// component, interval along the face, heights at both ends. Sorted; pieces one above the other with equal intervals are merged.
pub fn section(blocks: &[Block], axis: usize, at: i32, side: i32) -> Vec<Piece> {
    let mut pieces: Vec<(Component, [i32; 2], [i32; 4])> = Vec::new();
    for block in blocks {
        let n = block.plan.len();
        let lies = block.plan.iter().any(|p| (p[axis] - at) * side > 0);
        for i in 0..n {
            let j = (i + 1) % n;
            if lies && block.plan[i][axis] == at && block.plan[j][axis] == at {
                let (lo, hi) = if block.plan[i][1 - axis] < block.plan[j][1 - axis] { (i, j) } else { (j, i) };
                pieces.push((
                    block.component,
                    [block.plan[lo][1 - axis], block.plan[hi][1 - axis]],
                    [block.bottom[lo], block.bottom[hi], block.top[lo], block.top[hi]],
                ));
            }
        }
    }
    // Pieces of a component that stand on each other become one.
    while let Some((i, j)) = (0..pieces.len()).flat_map(|i| (0..pieces.len()).map(move |j| (i, j))).find(|&(i, j)| {
        let (a, b) = (&pieces[i], &pieces[j]);
        i != j && a.0 == b.0 && a.1 == b.1 && a.2[2..] == b.2[..2]
    }) {
        pieces[i].2 = [pieces[i].2[0], pieces[i].2[1], pieces[j].2[2], pieces[j].2[3]];
        pieces.remove(j);
    }
    let mut pieces: Vec<Piece> = pieces.into_iter().map(|(c, l, z)| (c, l, z.to_vec())).collect();
    pieces.sort();
    pieces
}

/// The same on a horizontal cube face: component and plan of every block that stands on it (`top` false) or reaches up to it.
pub fn level_section(blocks: &[Block], at: i32, top: bool) -> Vec<(Component, Vec<[i32; 2]>)> {
    let touches = |b: &&Block| if top { b.top.iter().all(|&z| z == at) } else { b.bottom.iter().all(|&z| z == at) };
    let mut found: Vec<_> = blocks
        .iter()
        .filter(touches)
        .map(|b| {
            let mut plan = b.plan.clone();
            plan.sort();
            (b.component, plan)
        })
        .collect();
    found.sort();
    found
}
