//! From the bytes of a file to labels.

use super::chunks::walk;
use super::scene::{Placed, scene};
use super::{ColourMap, MOST_ALONG, MOST_VOXELS, VoxError};
use crate::voxels::{Label, VoxelArray};

/// What a file holds.
#[derive(Clone, Debug, PartialEq)]
pub struct VoxScene {
    /// The labels; one voxel of the file is one module of the default size.
    pub voxels: VoxelArray,
    /// Voxels whose colour is no label's: they count as base.
    pub foreign: usize,
    /// The palette indices of those, as MagicaVoxel shows them, with their number of voxels; most frequent first.
    pub foreign_colours: Vec<(u8, usize)>,
    /// Models shown.
    pub models: usize,
    /// Scene nodes left out because they are hidden.
    pub hidden: usize,
    /// Whether the file brings a palette; else MagicaVoxel's default one holds.
    pub palette: bool,
}

/// Reads a MagicaVoxel file; `source` names it in errors.
///
/// The array is the box around all visible models (the whole size of each, not only its voxels), so that a file we wrote
/// gives the array back. Where models overlap the later one shows.
///
/// ```
/// use houscaper::voxels::{samples, vox};
/// let voxels = samples::hip_house().voxels;
/// let scene = vox::read(&vox::write(&voxels)?, "hip.vox", &Default::default())?;
/// assert_eq!((scene.voxels, scene.foreign), (voxels, 0));
/// # Ok::<(), vox::VoxError>(())
/// ```
///
/// # Errors
/// [`VoxError`]: no such file, models or scenes that do not add up, more voxels than can be held.
pub fn read(bytes: &[u8], source: &str, colours: &ColourMap) -> Result<VoxScene, VoxError> {
    let chunks = walk(bytes, source)?;
    let unread = |message: &str| VoxError::Scene { file: source.to_owned(), message: message.to_owned() };
    let data = dot_vox::load_bytes(bytes).map_err(unread)?;
    if data.models.len() != chunks.models || data.scenes.len() != chunks.nodes {
        return Err(unread("a chunk of the scene does not read; save it again from MagicaVoxel"));
    }
    let models: Vec<Model> =
        data.models.iter().enumerate().map(|(n, m)| Model::new(n, m, source)).collect::<Result<_, _>>()?;
    let scene = scene(&data, source)?;
    let Some([low, high]) = bounds(&scene.placed, &models) else {
        return Err(unread("no model is visible; unhide one"));
    };
    let shape = [0, 1, 2].map(|a| (high[a] - low[a] + 1) as usize);
    if shape.iter().try_fold(1usize, |n, s| n.checked_mul(*s)).is_none_or(|n| n > MOST_VOXELS) {
        let text = format!("the models span {shape:?} voxels, more than {MOST_VOXELS}; move them together");
        return Err(unread(&text));
    }
    let labels = colours.labels(&data.palette);
    let mut voxels = VoxelArray::new(shape);
    let mut counts = [0usize; 256];
    for &Placed { model, pose } in &scene.placed {
        let Model { size, voxels: filled } = &models[model];
        for voxel in filled.iter() {
            let place = pose.place([voxel.x, voxel.y, voxel.z].map(i64::from), *size);
            let label = labels[usize::from(voxel.i)];
            counts[usize::from(voxel.i)] += usize::from(label.is_none());
            voxels.set([0, 1, 2].map(|a| (place[a] - low[a]) as usize), label.unwrap_or(Label::Base));
        }
    }
    let mut foreign_colours: Vec<(u8, usize)> =
        (0..255u8).map(|i| (i + 1, counts[usize::from(i)])).filter(|(_, n)| *n > 0).collect();
    foreign_colours.sort_by_key(|(i, n)| (std::cmp::Reverse(*n), *i));
    Ok(VoxScene {
        voxels,
        foreign: counts.iter().sum(),
        foreign_colours,
        models: scene.placed.len(),
        hidden: scene.hidden,
        palette: chunks.palette_at.is_some(),
    })
}

/// A model whose voxels lie inside its size.
struct Model<'a> {
    size: [i64; 3],
    voxels: &'a [dot_vox::Voxel],
}

impl<'a> Model<'a> {
    fn new(number: usize, model: &'a dot_vox::Model, file: &str) -> Result<Self, VoxError> {
        let fault = |message: String| VoxError::Model { file: file.to_owned(), model: number, message };
        let size = [model.size.x, model.size.y, model.size.z];
        if size.iter().any(|&s| s == 0 || s as usize > MOST_ALONG) {
            return Err(fault(format!("size {size:?}, expected 1 to {MOST_ALONG} voxels along each axis")));
        }
        let outside = |v: &&dot_vox::Voxel| [v.x, v.y, v.z].iter().zip(size).any(|(c, s)| u32::from(*c) >= s);
        if let Some(v) = model.voxels.iter().find(outside) {
            return Err(fault(format!("voxel {:?} lies outside its size {size:?}", [v.x, v.y, v.z])));
        }
        Ok(Model { size: size.map(i64::from), voxels: &model.voxels })
    }
}

/// The box around all placed models; `None` when there is none.
fn bounds(placed: &[Placed], models: &[Model]) -> Option<[[i64; 3]; 2]> {
    placed
        .iter()
        .map(|p| p.pose.bounds(models[p.model].size))
        .reduce(|a, b| [[0, 1, 2].map(|i| a[0][i].min(b[0][i])), [0, 1, 2].map(|i| a[1][i].max(b[1][i]))])
}
