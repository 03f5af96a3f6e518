//! Windows and doors: infill voxels grouped into rectangles, with the direction they face.

use super::{Direction, FacadeOpening, Label, STOREY_MODULES, Storey, VoxelArray};

/// The direction in which a voxel has nothing beside it: the first of +x, +y, -x, -y; `None` inside the body.
///
/// A voxel with two such faces is a corner; a rule reports it.
pub fn facing(voxels: &VoxelArray, [x, y, z]: [usize; 3]) -> Option<Direction> {
    Direction::ALL.into_iter().find(|d| {
        let [dx, dy] = d.step();
        voxels.at([x as isize + dx, y as isize + dy, z as isize]) == Label::Empty
    })
}

/// Groups the infill voxels of each facade into rectangles, lowest first, then in plan order.
///
/// Infill inside the body faces nothing and is left out (a rule reports it). An opening belongs to the storey whose five
/// room layers it stands in, or to the highest storey below where there is none.
pub(super) fn read_openings(voxels: &VoxelArray, storeys: &[Storey]) -> Vec<FacadeOpening> {
    let mut openings = Vec::new();
    let mut taken = Vec::new();
    let [nx, ny, _] = voxels.shape();
    for (i, &label) in voxels.labels().iter().enumerate() {
        if !label.is_infill() {
            continue;
        }
        if taken.is_empty() {
            taken = vec![false; voxels.labels().len()];
        }
        let voxel = [i % nx, i / nx % ny, i / (nx * ny)];
        let (false, Some(facing)) = (taken[i], facing(voxels, voxel)) else { continue };
        let opening = grow(voxels, storeys, voxel, facing, &taken);
        for v in opening.voxels() {
            taken[voxels.index(v)] = true;
        }
        openings.push(opening);
    }
    openings
}

/// The largest rectangle that starts at `voxel`, first along the facade, then upwards inside the storey.
fn grow(
    voxels: &VoxelArray,
    storeys: &[Storey],
    voxel: [usize; 3],
    facing_out: Direction,
    taken: &[bool],
) -> FacadeOpening {
    let label = voxels.get(voxel);
    let [x, y, k] = voxel;
    let mut opening = FacadeOpening {
        label,
        storey: storey_of(storeys, k),
        facing: facing_out,
        cell: [x, y],
        width: 1,
        k,
        height: 1,
    };
    let along = opening.along();
    let belongs = |n: usize, z: usize| {
        let mut v = [x, y, z];
        v[along] += n;
        v[along] < voxels.shape()[along]
            && z < voxels.shape()[2]
            && voxels.get(v) == label
            && !taken[voxels.index(v)]
            && facing(voxels, v) == Some(facing_out)
    };
    while belongs(opening.width, k) {
        opening.width += 1;
    }
    while !(k + opening.height).is_multiple_of(STOREY_MODULES)
        && !k.is_multiple_of(STOREY_MODULES)
        && (0..opening.width).all(|n| belongs(n, k + opening.height))
    {
        opening.height += 1;
    }
    opening
}

fn storey_of(storeys: &[Storey], k: usize) -> usize {
    storeys.iter().rposition(|s| s.plate_k < k.max(1)).unwrap_or(0)
}
