//! Exact integer geometry of small planar polygons.

fn sub(a: [i32; 3], b: [i32; 3]) -> [i64; 3] {
    [0, 1, 2].map(|i| i64::from(a[i]) - i64::from(b[i]))
}

fn cross(a: [i64; 3], b: [i64; 3]) -> [i64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

fn dot(a: [i64; 3], b: [i64; 3]) -> i64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// Twice the vector area: along the normal, right-handed to the order of the points (Newell's formula). Squared units.
pub fn doubled_area(polygon: &[[i32; 3]]) -> [i64; 3] {
    let mut sum = [0; 3];
    for i in 1..polygon.len().saturating_sub(1) {
        let c = cross(sub(polygon[i], polygon[0]), sub(polygon[i + 1], polygon[0]));
        (0..3).for_each(|a| sum[a] += c[a]);
    }
    sum
}

/// Whether `p` lies strictly between `a` and `b`.
fn between(p: [i32; 3], a: [i32; 3], b: [i32; 3]) -> bool {
    let (ap, ab) = (sub(p, a), sub(b, a));
    let along = dot(ap, ab);
    cross(ap, ab) == [0; 3] && along > 0 && along < dot(ab, ab)
}

/// Puts those of `points` that lie on an edge of the polygon into that edge, so that no T-junction remains.
pub fn insert_points(polygon: &mut Vec<[i32; 3]>, points: &[[i32; 3]]) {
    let mut i = 0;
    while i < polygon.len() {
        let (a, b) = (polygon[i], polygon[(i + 1) % polygon.len()]);
        match points.iter().copied().find(|&p| between(p, a, b)) {
            Some(p) => polygon.insert(i + 1, p),
            None => i += 1,
        }
    }
}

/// Largest distance of a point from the plane through the first point with the polygon's normal, in the unit of the points.
pub fn out_of_plane(polygon: &[[i32; 3]]) -> f64 {
    let n = doubled_area(polygon);
    let length = n.iter().map(|&c| (c as f64).powi(2)).sum::<f64>().sqrt();
    polygon.iter().map(|&p| (dot(sub(p, polygon[0]), n) as f64 / length).abs()).fold(0.0, f64::max)
}

/// Cuts a simple planar polygon into triangles (indices into it), none of them degenerate: ear clipping that never takes an ear
/// whose tip lies on a straight edge or whose closed triangle holds another point. `None` when no such cut exists.
pub fn triangulate(polygon: &[[i32; 3]]) -> Option<Vec<[u8; 3]>> {
    let normal = doubled_area(polygon);
    let mut rest: Vec<usize> = (0..polygon.len()).collect();
    let mut triangles = Vec::with_capacity(polygon.len().saturating_sub(2));
    // Positive when c lies to the left of a -> b, seen against the normal.
    let side =
        |a: usize, b: usize, c: usize| dot(cross(sub(polygon[b], polygon[a]), sub(polygon[c], polygon[a])), normal);
    while rest.len() > 3 {
        let n = rest.len();
        let ear = (0..n).find(|&i| {
            let [a, b, c] = [rest[(i + n - 1) % n], rest[i], rest[(i + 1) % n]];
            let clear =
                |&p: &usize| p == a || p == b || p == c || side(a, b, p) < 0 || side(b, c, p) < 0 || side(c, a, p) < 0;
            side(a, b, c) > 0 && rest.iter().all(clear)
        })?;
        triangles.push([rest[(ear + n - 1) % n], rest[ear], rest[(ear + 1) % n]]);
        rest.remove(ear);
    }
    triangles.push([*rest.first()?, *rest.get(1)?, *rest.get(2)?]);
    let sound = triangles.iter().all(|&[a, b, c]| side(a, b, c) > 0);
    sound.then(|| triangles.into_iter().map(|t| t.map(|i| i as u8)).collect())
}
