//! Keys, checks of blocks and exact geometry for tests of solids.
#![allow(dead_code)]

use houscaper::cubes::{CubeKey, FaceNumber, Mask, admissible_masks};
use houscaper::tiles::Block;
use houscaper::tiles::solids::{Columns, Post};
use houscaper::voxels::{Direction, Label};
use rand::{Rng, RngExt};

/// Why a block is none: fewer than three corners, not strictly convex and counter-clockwise, a face that is not planar, a top below
/// its bottom, no volume.
pub fn flaw(block: &Block) -> Option<&'static str> {
    let n = block.plan.len();
    if n < 3 || block.bottom.len() != n || block.top.len() != n {
        return Some("corners");
    }
    let p = |i: usize| block.plan[i % n].map(i128::from);
    let turn = |i: usize| {
        let [a, b, c] = [p(i), p(i + 1), p(i + 2)];
        (b[0] - a[0]) * (c[1] - b[1]) - (b[1] - a[1]) * (c[0] - b[0])
    };
    if (0..n).any(|i| turn(i) <= 0) {
        return Some("convexity");
    }
    for z in [&block.bottom, &block.top] {
        let edge = |k: usize| {
            let [dx, dy] = [0, 1].map(|a| p(k)[a] - p(0)[a]);
            [dx, dy, i128::from(z[k]) - i128::from(z[0])]
        };
        for k in 3..n {
            let [u, v, w] = [edge(1), edge(2), edge(k)];
            let det = u[0] * (v[1] * w[2] - v[2] * w[1]) - u[1] * (v[0] * w[2] - v[2] * w[0])
                + u[2] * (v[0] * w[1] - v[1] * w[0]);
            if det != 0 {
                return Some("planarity");
            }
        }
    }
    if (0..n).any(|i| block.top[i] < block.bottom[i]) {
        return Some("order");
    }
    (block.six_volumes() <= 0).then_some("volume")
}

/// Height planes of a block as z = c + gx x + gy y.
fn plane(block: &Block, z: &[i32]) -> [f64; 3] {
    let p = |k: usize| [f64::from(block.plan[k][0]), f64::from(block.plan[k][1]), f64::from(z[k])];
    let (a, b, c) = (p(0), p(1), p(2));
    let (u, v) = ([b[0] - a[0], b[1] - a[1], b[2] - a[2]], [c[0] - a[0], c[1] - a[1], c[2] - a[2]]);
    let det = u[0] * v[1] - u[1] * v[0];
    let gx = (u[2] * v[1] - u[1] * v[2]) / det;
    let gy = (u[0] * v[2] - u[2] * v[0]) / det;
    [a[2] - gx * a[0] - gy * a[1], gx, gy]
}

fn clip(polygon: &[[f64; 2]], keep: impl Fn([f64; 2]) -> f64) -> Vec<[f64; 2]> {
    let mut out = Vec::new();
    for i in 0..polygon.len() {
        let (p, q) = (polygon[i], polygon[(i + 1) % polygon.len()]);
        let (d, e) = (keep(p), keep(q));
        if d >= 0.0 {
            out.push(p);
        }
        if (d > 0.0 && e < 0.0) || (d < 0.0 && e > 0.0) {
            let t = d / (d - e);
            out.push([p[0] + t * (q[0] - p[0]), p[1] + t * (q[1] - p[1])]);
        }
    }
    out
}

fn area(polygon: &[[f64; 2]]) -> f64 {
    let n = polygon.len();
    (0..n).map(|i| polygon[i][0] * polygon[(i + 1) % n][1] - polygon[i][1] * polygon[(i + 1) % n][0]).sum::<f64>() / 2.0
}

/// Whether two blocks share space: plan of the place where one lies more than 1 µm inside the other, larger than 100 µm2. `lift`
/// raises the second.
pub fn overlap(first: &Block, second: &Block, lift: i32) -> bool {
    for axis in 0..2 {
        let range = |b: &Block| {
            let at = b.plan.iter().map(|p| p[axis]);
            (at.clone().min().unwrap_or(0), at.max().unwrap_or(0))
        };
        let (a, b) = (range(first), range(second));
        if a.1 <= b.0 || b.1 <= a.0 {
            return false;
        }
    }
    let top = |b: &Block| b.top.iter().copied().max().unwrap_or(0);
    let bottom = |b: &Block| b.bottom.iter().copied().min().unwrap_or(0);
    if top(first) <= bottom(second) + lift || top(second) + lift <= bottom(first) {
        return false;
    }
    let mut shared: Vec<[f64; 2]> = first.plan.iter().map(|p| p.map(f64::from)).collect();
    let n = second.plan.len();
    for i in 0..n {
        let [a, b] = [i, i + 1].map(|i| second.plan[i % n].map(f64::from));
        shared = clip(&shared, |p| (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]));
    }
    let height = |g: [f64; 3], p: [f64; 2]| g[0] + g[1] * p[0] + g[2] * p[1];
    let lift = f64::from(lift);
    let [low, high] = [plane(first, &first.bottom), plane(first, &first.top)];
    let [low2, high2] = [plane(second, &second.bottom), plane(second, &second.top)];
    shared = clip(&shared, |p| height(high, p) - height(low2, p) - lift - 1.0);
    shared = clip(&shared, |p| height(high2, p) + lift - height(low, p) - 1.0);
    area(&shared) > 100.0
}

/// The sides on which a roof column meets one that is none: those have a number.
pub fn numbered_faces(labels: [Label; 8]) -> Vec<Direction> {
    let roof = |q: usize| labels[q].is_filled() && !labels[q].is_slab() && !labels[q + 4].is_filled();
    let faces = [[1, 3], [2, 3], [0, 2], [0, 1]];
    Direction::ALL
        .into_iter()
        .filter(|d| {
            let [a, b] = faces[*d as usize];
            roof(a) != roof(b)
        })
        .collect()
}

/// Every combination of numbers on those faces that the kinds of columns allow: a roof goes on upwards beside a full column and
/// downwards beside an empty one; and none at all, as rule A reads.
pub fn face_numbers(labels: [Label; 8], mut visit: impl FnMut([FaceNumber; 4])) {
    let sides = numbered_faces(labels);
    let filled = |q: usize| labels[q].is_filled() && labels[q + 4].is_filled();
    let empty = |q: usize| !labels[q].is_filled() && !labels[q + 4].is_filled();
    let columns = [[1, 3], [2, 3], [0, 2], [0, 1]];
    let options: Vec<Vec<FaceNumber>> = sides
        .iter()
        .map(|d| {
            let [a, b] = columns[*d as usize];
            let mut numbers = vec![FaceNumber::End0, FaceNumber::End1, FaceNumber::End2];
            if filled(a) || filled(b) {
                numbers.push(FaceNumber::StepUp);
            }
            if empty(a) || empty(b) {
                numbers.push(FaceNumber::StepDown);
            }
            numbers
        })
        .collect();
    visit([FaceNumber::None; 4]);
    if sides.is_empty() {
        return;
    }
    let total: usize = options.iter().map(Vec::len).product();
    for mut n in 0..total {
        let mut faces = [FaceNumber::None; 4];
        for (side, numbers) in sides.iter().zip(&options) {
            faces[*side as usize] = numbers[n % numbers.len()];
            n /= numbers.len();
        }
        visit(faces);
    }
}

/// Labels of every admissible mask with layers of one kind: base, plate, or foundation at the very bottom.
pub fn layered_labels() -> Vec<[Label; 8]> {
    let mut all = Vec::new();
    for mask in admissible_masks() {
        for bottom in [Label::Base, Label::Floor, Label::Foundation] {
            for top in [Label::Base, Label::Floor, Label::Foundation] {
                // The ground layer is foundation, and nothing else is.
                let grounded = top == Label::Foundation && mask.bottom() != 0;
                let hanging = bottom == Label::Foundation && mask.bottom() & mask.top() != mask.top();
                // A layer of nothing has one label only.
                let repeated = (mask.bottom() == 0 && bottom != Label::Base) || (mask.top() == 0 && top != Label::Base);
                if !(grounded || hanging || repeated) {
                    all.push(labels_of(mask, bottom, top));
                }
            }
        }
    }
    all
}

fn labels_of(mask: Mask, bottom: Label, top: Label) -> [Label; 8] {
    std::array::from_fn(|n| match (mask.0 >> n & 1 == 1, n < 4) {
        (false, _) => Label::Empty,
        (true, true) => bottom,
        (true, false) => top,
    })
}

/// Every key of layered labels: all face numbers, decks walked on and not; and the same with openings in base layers, drawn.
pub fn layered_keys(rng: &mut impl Rng) -> Vec<CubeKey> {
    let mut keys = Vec::new();
    for labels in layered_labels() {
        let decks = (0..4).any(|q| labels[q].is_slab() && !labels[q + 4].is_filled());
        face_numbers(labels, |faces| {
            for walked in if decks { vec![0, 15] } else { vec![0] } {
                keys.push(CubeKey::new(labels, faces, walked));
                let mut open = labels;
                for label in open.iter_mut().filter(|l| **l == Label::Base) {
                    *label = [Label::Base, Label::Window, Label::Opening][rng.random_range(0..3)];
                }
                keys.push(CubeKey::new(open, faces, walked));
            }
        });
    }
    keys
}

/// Any labels and any numbers on admissible masks.
pub fn random_keys(rng: &mut impl Rng, count: usize) -> Vec<CubeKey> {
    let masks: Vec<Mask> = admissible_masks().collect();
    let key = |_| {
        let mask = masks[rng.random_range(0..masks.len())];
        let mut labels = [Label::Empty; 8];
        for (n, label) in labels.iter_mut().enumerate() {
            if mask.0 >> n & 1 == 1 {
                *label = Label::ALL[rng.random_range(1..6)];
            }
        }
        let faces = std::array::from_fn(|_| FaceNumber::ALL[rng.random_range(0..6)]);
        CubeKey::new(labels, faces, rng.random_range(0..16))
    };
    (0..count).map(key).collect()
}

/// The kinds of a key's columns.
pub fn posts(columns: &Columns) -> [Post; 4] {
    [0, 1, 2, 3].map(|q| columns.post(q))
}
