//! From labels to the bytes of a file.

use dot_vox::{Color, DEFAULT_PALETTE, DotVoxData, Model, Size, Voxel};

use super::{LABEL_COLOURS, MOST_ALONG, VoxError};
use crate::voxels::VoxelArray;

/// Version of the format that files state.
const VERSION: u32 = 150;

/// An array as one model with our five colours in front of the palette. Voxels stand in storage order.
///
/// # Errors
/// [`VoxError::TooLarge`] for more than 256 voxels along an axis, or none.
pub fn write(voxels: &VoxelArray) -> Result<Vec<u8>, VoxError> {
    let shape = voxels.shape();
    if shape.iter().any(|&n| n == 0 || n > MOST_ALONG) {
        return Err(VoxError::TooLarge { found: shape });
    }
    let [x, y, z] = shape.map(|n| n as u32);
    let filled = voxels.iter().filter(|(_, label)| label.is_filled());
    let places = filled.map(|(v, label)| {
        let [x, y, z] = v.map(|c| c as u8);
        Voxel { x, y, z, i: label.code() - 1 }
    });
    let mut palette = DEFAULT_PALETTE.to_vec();
    for (label, [r, g, b]) in LABEL_COLOURS {
        palette[usize::from(label.code()) - 1] = Color { r, g, b, a: 255 };
    }
    let data = DotVoxData {
        version: VERSION,
        index_map: Vec::new(),
        models: vec![Model { size: Size { x, y, z }, voxels: places.collect() }],
        palette,
        materials: Vec::new(),
        scenes: Vec::new(),
        layers: Vec::new(),
    };
    let mut bytes = Vec::new();
    // Writing to a Vec fails only where memory does.
    data.write_vox(&mut bytes).map_err(|_| VoxError::TooLarge { found: shape })?;
    Ok(bytes)
}
