//! The exhaustive proof that tiles fit: every pair of configurations that may meet is compared on the face between them.

use super::{LineRole, LinearTileset, Tileset};
use crate::cubes::{Axis, Mask};
use std::collections::BTreeSet;
use std::fmt;

/// An ordered pair of cubes that may stand beside each other in a house.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Meeting {
    /// The second cube lies in the positive direction of this axis.
    pub axis: Axis,
    /// The first cube.
    pub low: Mask,
    /// The second cube.
    pub high: Mask,
}

/// Every ordered pair of admissible, empty and full cubes that may share a face along x, y or z: 3,684 pairs.
pub fn meetings() -> impl Iterator<Item = Meeting> {
    Axis::ALL.into_iter().flat_map(|axis| {
        Mask::all().filter(|m| m.is_allowed()).flat_map(move |low| {
            Mask::all()
                .filter(move |&high| high.is_allowed() && low.face(axis, true) == high.face(axis, false))
                .map(move |high| Meeting { axis, low, high })
        })
    })
}

/// Two tiles that do not fit.
#[derive(Clone, Debug, PartialEq)]
pub struct Finding {
    /// The cubes.
    pub meeting: Meeting,
    /// Names of the two tiles (empty or full cubes have none).
    pub tiles: [String; 2],
    /// What only the first one has on the face, cube-local mm of the first.
    pub only_low: Vec<String>,
    /// What only the second one has, in the same coordinates.
    pub only_high: Vec<String>,
}

impl fmt::Display for Finding {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Meeting { axis, low, high } = self.meeting;
        write!(
            f,
            "the {} face between configurations {low} (tile '{}') and {high} (tile '{}') differs: only the first has [{}], only \
             the second [{}]",
            axis.name(),
            self.tiles[0],
            self.tiles[1],
            self.only_low.join("; "),
            self.only_high.join("; ")
        )
    }
}

/// What is on one face of a tile, in coordinates and octants that both neighbours share.
type Curve<T> = BTreeSet<T>;

/// A directed edge on a face.
type Edge = [[i32; 3]; 2];

fn on_face(points: [[i32; 3]; 2], axis: Axis, at: i32) -> bool {
    points.iter().all(|p| p[axis as usize] == at)
}

fn flattened(mut point: [i32; 3], axis: Axis) -> [i32; 3] {
    point[axis as usize] = 0;
    point
}

/// The free edges of a tile's surface on one of its faces, as drawn, with the face's own coordinate set to 0.
pub fn face_curve(set: &Tileset, mask: Mask, axis: Axis, high: bool) -> BTreeSet<[[i32; 3]; 2]> {
    let edges: BTreeSet<Edge> = set
        .patches(mask)
        .iter()
        .flat_map(|p| (0..p.polygon.len()).map(|i| [p.polygon[i], p.polygon[(i + 1) % p.polygon.len()]]))
        .collect();
    let at = if high { set.module_mm()[axis as usize] } else { 0 };
    edges
        .iter()
        .filter(|[from, to]| !edges.contains(&[*to, *from]) && on_face([*from, *to], axis, at))
        .map(|e| e.map(|p| flattened(p, axis)))
        .collect()
}

/// Compares all tiles of a surface set on all faces where they may meet. Empty when every seam is closed: the edges of the first
/// tile are exactly those of the second, the other way round.
pub fn check_tileset(set: &Tileset) -> Vec<Finding> {
    let curve = |mask, axis, high| -> Curve<Edge> {
        let drawn = face_curve(set, mask, axis, high);
        if high { drawn } else { drawn.into_iter().map(|[from, to]| [to, from]).collect() }
    };
    let name = |mask| set.tile_name(mask).to_string();
    compare(curve, name, |[from, to]| format!("{from:?} - {to:?}"))
}

/// A line on a face: role, ends with the face's own coordinate 0, octants as corners of the face.
type FaceLine = (LineRole, [[i32; 3]; 2], [u8; 2]);

/// Compares all tiles of a linear set: lines on a shared vertical face must be the same in both. On horizontal faces the cube
/// above owns the lines, so the one below must have none in its top plane.
pub fn check_linear_tileset(set: &LinearTileset) -> Vec<Finding> {
    let curve = |mask, axis: Axis, high: bool| -> Curve<FaceLine> {
        if axis == Axis::Z && !high {
            return Curve::new();
        }
        let at = if high { set.module_mm()[axis as usize] } else { 0 };
        let octant_bit = 1u8 << axis as u8;
        set.lines(mask)
            .iter()
            .filter(|l| on_face([l.from, l.to], axis, at))
            .map(|l| {
                (
                    l.role,
                    [l.from, l.to].map(|p| flattened(p, axis)),
                    l.octants.map(|o| face_octant(o, octant_bit, high)),
                )
            })
            .collect()
    };
    let name = |mask| set.tile_name(mask).to_string();
    compare(curve, name, |(role, [from, to], octants)| format!("{} {from:?} - {to:?} of {octants:?}", role.name()))
}

/// The octant without its bit along the axis; 8 more when it lies on the far side of the cube, so that a line on a face which
/// hangs on an octant behind it never equals one of the neighbour.
fn face_octant(octant: u8, bit: u8, high: bool) -> u8 {
    let near = (octant & bit != 0) == high;
    octant & !bit | if near { 0 } else { 8 | u8::from(high) << 4 }
}

fn compare<T: Ord>(
    curve: impl Fn(Mask, Axis, bool) -> Curve<T>,
    name: impl Fn(Mask) -> String,
    show: impl Fn(&T) -> String,
) -> Vec<Finding> {
    let table: Vec<[[Curve<T>; 2]; 3]> =
        Mask::all().map(|m| Axis::ALL.map(|axis| [false, true].map(|high| curve(m, axis, high)))).collect();
    let mut findings = Vec::new();
    for meeting in meetings() {
        let axis = meeting.axis as usize;
        let (low, high) = (&table[meeting.low.0 as usize][axis][1], &table[meeting.high.0 as usize][axis][0]);
        if low != high {
            findings.push(Finding {
                meeting,
                tiles: [name(meeting.low), name(meeting.high)],
                only_low: low.difference(high).map(&show).collect(),
                only_high: high.difference(low).map(&show).collect(),
            });
        }
    }
    findings
}
