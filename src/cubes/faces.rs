//! Face numbers: how a roof ends at the vertical faces of its cubes, read from the voxels around it (rule B).
//!
//! Heights are in half modules, 1 at the centre of every roof voxel. What a face says is decided from the 3 x 3 columns around the
//! roof voxel on four levels, so one voxel has a say in 4 x 4 x 4 cubes at most. Any number keeps seams closed, because both cubes
//! at a face read the same one; the rule below is chosen for good roofs:
//!
//! * a step of one voxel is a slope of 540 in 900 that goes on in the next cube ([`FaceNumber::StepUp`], [`FaceNumber::StepDown`]);
//! * at an edge the roof goes straight on: 2 less the height on the other side;
//! * before a chimney that the roof passes on both sides it goes on as it does there;
//! * between a wall and a free edge it is a lean-to (2 at the wall, 0 at the edge), unless the roof runs past on *both* sides with a
//!   slope of its own: then the wall is a chimney or a dormer's cheek, and the roof in front of it keeps their slope;
//! * at a free edge nothing stands higher than the roofs left and right of it, which keeps the corners of hips down. A lean-to
//!   beside a roof that runs straight along the edge does not pull that one down;
//! * a free edge that ends at a valley falls, so that bays are hipped where their roof draws back on all sides.
//!
//! What the fixed height of voxel centres rules out: the top of a single-sided roof is level between two voxels of the same
//! height, so such a roof rises to its edge only where its uppermost row is one voxel wide.

use super::{CubeKey, FaceNumber, corner_voxel, cube_labels};
use crate::cubes::Corner;
use crate::voxels::{Direction, VoxelArray};

/// What a tile is looked up by.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Rule {
    /// The eight labels alone, the thesis's method: roofs fall to every free edge and rise to every wall.
    A,
    /// The labels and a number on each vertical face at which a roof ends: straight gables, level and single-sided roofs.
    #[default]
    B,
}

/// A voxel position, also outside the array.
type Voxel = [isize; 3];

fn beside([x, y, z]: Voxel, d: Direction) -> Voxel {
    let [dx, dy] = d.step();
    [x + dx, y + dy, z]
}

fn above([x, y, z]: Voxel, levels: isize) -> Voxel {
    [x, y, z + levels]
}

fn filled(voxels: &VoxelArray, v: Voxel) -> bool {
    voxels.at(v).is_filled()
}

/// Filled without a slab, nothing above.
fn is_roof(voxels: &VoxelArray, v: Voxel) -> bool {
    let label = voxels.at(v);
    label.is_filled() && !label.is_slab() && !filled(voxels, above(v, 1))
}

fn is_full(voxels: &VoxelArray, v: Voxel) -> bool {
    filled(voxels, v) && filled(voxels, above(v, 1))
}

/// The height towards `d` where the roof of voxel v goes on there: level, one voxel up, or one down.
fn direct(voxels: &VoxelArray, v: Voxel, d: Direction) -> Option<i32> {
    let n = beside(v, d);
    match (filled(voxels, n), filled(voxels, above(n, 1))) {
        (true, true) => is_roof(voxels, above(n, 1)).then_some(2),
        (true, false) => (!voxels.at(n).is_slab()).then_some(1),
        (false, false) => is_roof(voxels, above(n, -1)).then_some(0),
        (false, true) => None,
    }
}

/// The height towards `d` that follows from where the roof goes on along that axis.
fn slope(voxels: &VoxelArray, v: Voxel, d: Direction) -> Option<i32> {
    direct(voxels, v, d).or_else(|| direct(voxels, v, d.back()).map(|h| 2 - h))
}

/// The height towards `d` of a roof that goes on to neither side: a lean-to between wall and edge, else level.
fn lean_to(voxels: &VoxelArray, v: Voxel, d: Direction) -> i32 {
    match [d, d.back()].map(|side| is_full(voxels, beside(v, side))) {
        [true, false] => 2,
        [false, true] => 0,
        [true, true] | [false, false] => 1,
    }
}

/// How the roof on voxel `roof` ends on its face towards `towards`: [`FaceNumber::None`] when the voxel carries no roof (it is empty
/// or a slab, or something stands on it) or the neighbour carries one at the same level.
pub fn face_number(voxels: &VoxelArray, roof: [isize; 3], towards: Direction) -> FaceNumber {
    if !is_roof(voxels, roof) {
        return FaceNumber::None;
    }
    match direct(voxels, roof, towards) {
        Some(0) => FaceNumber::StepDown,
        Some(1) => FaceNumber::None,
        Some(_) => FaceNumber::StepUp,
        None => FaceNumber::end(end_height(voxels, roof, towards)),
    }
}

/// The height at an edge or wall.
fn end_height(voxels: &VoxelArray, v: Voxel, d: Direction) -> i32 {
    let straight = direct(voxels, v, d.back()).map(|h| 2 - h);
    let sides = [d.left(), d.left().back()].map(|side| Some(beside(v, side)).filter(|&l| is_roof(voxels, l)));
    let slopes = sides.map(|side| side.and_then(|l| slope(voxels, l, d)));
    let wall = is_full(voxels, beside(v, d));
    let past = sides.map(|side| side.filter(|_| wall).and_then(|l| direct(voxels, l, d)));
    let own = match (past, straight, slopes) {
        ([Some(a), Some(b)], _, _) => a.min(b),
        (_, Some(height), _) => height,
        (_, None, [Some(a), Some(b)]) => a.min(b),
        (_, None, _) => lean_to(voxels, v, d),
    };
    if wall {
        return own;
    }
    let mut height = own;
    for (n, side) in sides.into_iter().enumerate() {
        let Some(l) = side else { continue };
        if is_roof(voxels, beside(l, d)) {
            // Beside a valley the edge is that of a hipped bay.
            if direct(voxels, l, d.back()) == Some(2) {
                height = 0;
            }
            continue;
        }
        match slopes[n] {
            Some(h) => height = height.min(h),
            // A roof that runs straight past does not follow what leans on a wall beside it.
            None if straight.is_some() && slopes[1 - n].is_some() => {}
            None => height = height.min(lean_to(voxels, l, d)),
        }
    }
    height
}

/// The columns (x + 2y) on each face of a cube, in the order of [`Direction::ALL`], with the direction from the first to the second.
const FACE_COLUMNS: [([usize; 2], Direction); 4] =
    [([1, 3], Direction::North), ([2, 3], Direction::East), ([0, 2], Direction::North), ([0, 1], Direction::East)];

/// The number on the face of a cube that lies towards `side`.
fn cube_face(voxels: &VoxelArray, cube: [usize; 3], side: Direction) -> FaceNumber {
    let ([a, b], along) = FACE_COLUMNS[side as usize];
    let [a, b] = [a, b].map(|q| corner_voxel(cube, Corner::at([q as u8, q as u8 >> 1, 0])));
    match [a, b].map(|v| is_roof(voxels, v)) {
        [true, false] => face_number(voxels, a, along),
        [false, true] => face_number(voxels, b, along.back()),
        [true, true] | [false, false] => FaceNumber::None,
    }
}

/// The columns x + 2y of a cube that are decks walked on: slab below, nothing above, and `walked` says so of the slab's voxel.
pub(super) fn walked_columns(voxels: &VoxelArray, cube: [usize; 3], walked: &impl Fn([usize; 3]) -> bool) -> u8 {
    (0..4u8).fold(0, |columns, q| {
        let v = corner_voxel(cube, Corner::at([q, q >> 1, 0]));
        let deck = voxels.at(v).is_slab() && !filled(voxels, above(v, 1));
        // A filled voxel lies inside the array, so its position is not negative.
        columns | u8::from(deck && walked(v.map(|c| c as usize))) << q
    })
}

/// The key of one cube of the padded array. `walked` tells of a slab voxel with nothing above it whether people walk on it.
///
/// ```
/// use houscaper::cubes::{FaceNumber, Rule, cube_key};
/// use houscaper::voxels::{Direction, Label, VoxelArray};
/// let mut strip = VoxelArray::new([3, 1, 1]);
/// (0..3).for_each(|x| strip.set([x, 0, 0], Label::Base));
/// // The cube above the strip's first voxel: a level roof with a verge to the west.
/// let key = cube_key(&strip, [0, 0, 1], Rule::B, |_| false);
/// assert_eq!(key.face(Direction::North), FaceNumber::End1);
/// assert_eq!(cube_key(&strip, [0, 0, 1], Rule::A, |_| false).face(Direction::North), FaceNumber::None);
/// ```
pub fn cube_key(voxels: &VoxelArray, cube: [usize; 3], rule: Rule, walked: impl Fn([usize; 3]) -> bool) -> CubeKey {
    let faces = match rule {
        Rule::A => [FaceNumber::None; 4],
        Rule::B => Direction::ALL.map(|side| cube_face(voxels, cube, side)),
    };
    CubeKey::new(cube_labels(voxels, cube), faces, walked_columns(voxels, cube, &walked))
}
