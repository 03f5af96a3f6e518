//! Where the models of a file stand: transforms, groups and shapes.

use dot_vox::{DotVoxData, SceneNode};

use super::VoxError;

/// A model at its place: `R (p - pivot) + t` with the pivot at half its size, rounded down.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Placed {
    /// Number of the model.
    pub model: usize,
    /// Where its voxels go.
    pub pose: Pose,
}

/// A turn, mirrored or not, and a shift.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Pose {
    /// Rows of the signed permutation: from which axis each coordinate comes, and with which sign.
    rows: [(usize, i64); 3],
    /// Shift, voxels.
    shift: [i64; 3],
}

impl Pose {
    const HOME: Pose = Pose { rows: [(0, 1), (1, 1), (2, 1)], shift: [0; 3] };

    /// The pose `inner` seen from outside this one.
    fn then(&self, inner: &Pose) -> Pose {
        let rows = self.rows.map(|(axis, sign)| (inner.rows[axis].0, sign * inner.rows[axis].1));
        let turned = self.rows.map(|(axis, sign)| sign * inner.shift[axis]);
        Pose { rows, shift: [0, 1, 2].map(|a| turned[a] + self.shift[a]) }
    }

    /// The place of a voxel of a model of `size` voxels. Computed on voxel centres, in half voxels.
    pub fn place(&self, voxel: [i64; 3], size: [i64; 3]) -> [i64; 3] {
        let centred = [0, 1, 2].map(|a| 2 * (voxel[a] - size[a] / 2) + 1);
        let turned = self.rows.map(|(axis, sign)| sign * centred[axis]);
        [0, 1, 2].map(|a| (turned[a] - 1) / 2 + self.shift[a])
    }

    /// The lowest and highest voxel of a model of `size` voxels, which are at least 1.
    pub fn bounds(&self, size: [i64; 3]) -> [[i64; 3]; 2] {
        let ends = [self.place([0; 3], size), self.place(size.map(|s| s - 1), size)];
        [[0, 1, 2].map(|a| ends[0][a].min(ends[1][a])), [0, 1, 2].map(|a| ends[0][a].max(ends[1][a]))]
    }
}

/// What of a scene is shown.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Scene {
    /// Visible models, in the order of the scene.
    pub placed: Vec<Placed>,
    /// Nodes left out because they, or their layer, are hidden.
    pub hidden: usize,
}

/// Farthest shift, voxels: far beyond MagicaVoxel's world of 2000.
const FARTHEST: i64 = 100_000;

/// Follows the scene from its root. A file without a scene has one model, at home; of an animation the first frame is taken.
///
/// # Errors
/// [`VoxError::Scene`]: several models without a scene, a node or model that is not there, a node met twice, a rotation or
/// shift that does not read.
pub fn scene(data: &DotVoxData, file: &str) -> Result<Scene, VoxError> {
    let walk = Walk { data, file };
    if data.scenes.is_empty() {
        return match data.models.len() {
            0 | 1 => Ok(Scene {
                placed: (0..data.models.len()).map(|model| Placed { model, pose: Pose::HOME }).collect(),
                hidden: 0,
            }),
            n => {
                Err(walk.fault(format!("{n} models, but nothing says where they stand; save one model, or as a scene")))
            }
        };
    }
    let mut scene = Scene::default();
    let mut met = vec![false; data.scenes.len()];
    let mut open = vec![(0u32, Pose::HOME)];
    while let Some((id, pose)) = open.pop() {
        let Some(node) = data.scenes.get(id as usize) else {
            return Err(walk.fault(format!("node {id} is missing; the scene has {} nodes", data.scenes.len())));
        };
        if std::mem::replace(&mut met[id as usize], true) {
            return Err(walk.fault(format!("node {id} is met twice, expected a tree")));
        }
        match node {
            SceneNode::Transform { attributes, frames, child, layer_id } => {
                let layer = data.layers.get(*layer_id as usize);
                if attributes.get("_hidden").is_some_and(|h| h == "1") || layer.is_some_and(|l| l.hidden()) {
                    scene.hidden += 1;
                    continue;
                }
                let inner = match frames.first() {
                    Some(frame) => walk.pose(frame.attributes.get("_r"), frame.attributes.get("_t"))?,
                    None => Pose::HOME,
                };
                let outer = pose.then(&inner);
                if outer.shift.iter().any(|s| s.abs() > FARTHEST) {
                    return Err(
                        walk.fault(format!("node {id} is shifted by {:?}, farther than any scene", outer.shift))
                    );
                }
                open.push((*child, outer));
            }
            SceneNode::Group { children, .. } => open.extend(children.iter().rev().map(|child| (*child, pose))),
            SceneNode::Shape { models, .. } => {
                let Some(first) = models.first() else { continue };
                let model = first.model_id as usize;
                if model >= data.models.len() {
                    let text = format!("node {id} shows model {model}, but the file has {}", data.models.len());
                    return Err(walk.fault(text));
                }
                scene.placed.push(Placed { model, pose });
            }
        }
    }
    Ok(scene)
}

struct Walk<'a> {
    data: &'a DotVoxData,
    file: &'a str,
}

impl Walk<'_> {
    fn fault(&self, message: String) -> VoxError {
        VoxError::Scene { file: self.file.to_owned(), message }
    }

    /// The pose of a transform: `_r` a byte, `_t` three whole numbers; what is missing is at home.
    fn pose(&self, turn: Option<&String>, shift: Option<&String>) -> Result<Pose, VoxError> {
        let rows = match turn {
            None => Pose::HOME.rows,
            Some(text) => text.trim().parse().ok().and_then(rows).ok_or_else(|| {
                self.fault(format!("rotation `{text}` is no turn between axes (nodes: {})", self.data.scenes.len()))
            })?,
        };
        let shift = match shift {
            None => [0; 3],
            Some(text) => {
                let numbers: Option<Vec<i64>> =
                    text.split_whitespace().map(|n| n.parse().ok().filter(|n: &i64| n.abs() <= FARTHEST)).collect();
                numbers.and_then(|n| <[i64; 3]>::try_from(n).ok()).ok_or_else(|| {
                    self.fault(format!("translation `{text}` is not three whole numbers up to {FARTHEST}"))
                })?
            }
        };
        Ok(Pose { rows, shift })
    }
}

/// The rows of a rotation byte: bits 0-1 and 2-3 name the axes of the first two rows, bits 4 to 6 the signs (1 = negative).
fn rows(byte: u8) -> Option<[(usize, i64); 3]> {
    let (first, second) = (usize::from(byte & 3), usize::from(byte >> 2 & 3));
    if first == 3 || second == 3 || first == second || byte >> 7 != 0 {
        return None;
    }
    let sign = |bit: u8| if byte >> bit & 1 == 1 { -1 } else { 1 };
    Some([(first, sign(4)), (second, sign(5)), (3 - first - second, sign(6))])
}
