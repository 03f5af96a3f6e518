//! A member cut at the planes between cubes and between voxels.

use std::collections::BTreeSet;

use crate::voxels::{Label, VoxelArray};

/// A part of a member that lies in one cube and one voxel.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Piece {
    /// Cube of the padded array.
    pub cube: [u32; 3],
    /// Voxel.
    pub voxel: [i32; 3],
    /// Part of the member's length; the pieces of a member sum to 1.
    pub share: f64,
}

/// Half a module further than this from a plane, in modules, is beside it.
const ON_PLANE: f64 = 1e-6;

/// The pieces of a member from end to end. Axes lie in the planes of the facades, which are those between voxels: a piece in such a plane
/// belongs to the filled voxel of the two (the lower where both or none are), one between cubes to that of them which is in `drawn`.
pub fn pieces(ends: [[f64; 3]; 2], voxels: &VoxelArray, drawn: &BTreeSet<[u32; 3]>) -> Vec<Piece> {
    // Voxel centres have whole numbers.
    let grid = ends.map(|p| [0, 1, 2].map(|a| (p[a] - voxels.origin_m[a]) / voxels.module.size_m[a]));
    let at = |t: f64| [0, 1, 2].map(|a| grid[0][a] + t * (grid[1][a] - grid[0][a]));
    let mut cuts = vec![0.0, 1.0];
    for (from, to) in grid[0].into_iter().zip(grid[1]) {
        if (to - from).abs() < ON_PLANE {
            continue;
        }
        let [low, high] = [from.min(to), from.max(to)].map(|u| 2.0 * u);
        let planes = (low.ceil() as i64)..=(high.floor() as i64);
        cuts.extend(planes.map(|n| ((n as f64 / 2.0 - from) / (to - from)).clamp(0.0, 1.0)));
    }
    cuts.sort_by(f64::total_cmp);
    let mut found: Vec<Piece> = Vec::new();
    for pair in cuts.windows(2).filter(|pair| pair[1] - pair[0] > 1e-9) {
        let middle = at(0.5 * (pair[0] + pair[1]));
        let cube = first(middle, |c| drawn.contains(&c.map(|i| (i + 1).max(0) as u32)));
        let is_filled = |v: [i32; 3]| voxels.at(v.map(|i| i as isize)) != Label::Empty;
        let voxel = first(middle.map(|u| u + 0.5), is_filled);
        let piece = Piece { cube: cube.map(|i| (i + 1).max(0) as u32), voxel, share: pair[1] - pair[0] };
        match found.last_mut().filter(|last| last.cube == piece.cube && last.voxel == piece.voxel) {
            Some(last) => last.share += piece.share,
            None => found.push(piece),
        }
    }
    // What was too short to be a piece belongs to the others.
    let whole: f64 = found.iter().map(|p| p.share).sum();
    found.iter_mut().for_each(|p| p.share /= whole);
    found
}

/// The cell of a point; on planes between cells the first that holds, and without one the lowest.
fn first(at: [f64; 3], holds: impl Fn([i32; 3]) -> bool) -> [i32; 3] {
    let sides = at.map(|u| {
        let low = u.floor() as i32;
        let near = u.round();
        if (u - near).abs() < ON_PLANE { (near as i32 - 1, near as i32) } else { (low, low) }
    });
    let cell = |n: usize| [0, 1, 2].map(|a| if n >> a & 1 == 0 { sides[a].0 } else { sides[a].1 });
    (0..8).map(cell).find(|c| holds(*c)).unwrap_or_else(|| cell(0))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A beam through three voxels of which the middle is filled, in the plane of their facade.
    #[test]
    fn members_are_cut_at_cubes_and_voxels() {
        let mut voxels = VoxelArray::new([3, 2, 1]);
        voxels.set([1, 0, 0], Label::Base);
        let [sx, sy, _] = voxels.module.size_m;
        let ends = [[0.0, 0.5 * sy, 0.0], [2.0 * sx, 0.5 * sy, 0.0]];
        let found = pieces(ends, &voxels, &BTreeSet::from([[2, 1, 1]]));
        let total: f64 = found.iter().map(|p| p.share).sum();
        assert!((total - 1.0).abs() < 1e-12, "{found:?}");
        let share = |keep: &dyn Fn(&Piece) -> bool| found.iter().filter(|p| keep(p)).map(|p| p.share).sum::<f64>();
        // Half of its length lies in voxel (1, 0, 0): from 0.5 to 1.5 modules.
        assert!((share(&|p| p.voxel == [1, 0, 0]) - 0.5).abs() < 1e-12, "{found:?}");
        // From the first voxel's centre to the second's is one cube.
        assert!((share(&|p| p.cube[0] == 1) - 0.5).abs() < 1e-12, "{found:?}");
        assert!(found.iter().filter(|p| p.cube[0] == 2).all(|p| p.cube == [2, 1, 1]), "the drawn one: {found:?}");
    }

    #[test]
    fn a_sloping_member_is_whole() {
        let voxels = VoxelArray::new([4, 4, 4]);
        let found = pieces([[0.1, 0.2, 0.3], [2.9, 1.7, 1.4]], &voxels, &BTreeSet::new());
        assert!((found.iter().map(|p| p.share).sum::<f64>() - 1.0).abs() < 1e-12);
        assert!(found.len() > 5);
    }
}
