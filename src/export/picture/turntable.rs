//! A house from all around: equal steps of the camera about an upright axis, at one scale.

use rayon::prelude::*;

use super::image::ImageError;
use super::{Image, Picture, PictureError, View, render};
use crate::export::scene::Scene;

/// Pictures of a turn at most.
pub const MOST_FRAMES: usize = 360;

/// Time a frame is shown so that a turn takes six seconds, in thousandths of a second, at least two hundredths.
fn delay_ms(frames: usize) -> u16 {
    (6000 / frames.max(1)).clamp(20, 6000) as u16
}

/// `frames` pictures from the direction of `picture` on, counter-clockwise seen from above; drawn in parallel, the same whatever the
/// number of threads.
///
/// # Errors
/// As [`render`].
pub fn turntable(scene: &Scene, picture: &Picture, frames: usize) -> Result<Vec<Image>, PictureError> {
    let frames = frames.clamp(1, MOST_FRAMES);
    (0..frames)
        .into_par_iter()
        .map(|n| {
            let azimuth_deg = picture.view.azimuth_deg + 360.0 * n as f32 / frames as f32;
            render(scene, &Picture { view: View { azimuth_deg, ..picture.view }, is_steady: true, ..*picture })
        })
        .collect()
}

/// The frames as an animated PNG that runs for ever; a viewer that knows no animation shows the first.
///
/// # Errors
/// When there is no frame or the encoder refuses.
pub fn animated(frames: &[Image]) -> Result<Vec<u8>, ImageError> {
    let size = frames.first().map_or([0, 0], |f| f.size);
    let mut bytes = Vec::new();
    let write = |bytes: &mut Vec<u8>| -> Result<(), png::EncodingError> {
        let mut encoder = png::Encoder::new(bytes, size[0] as u32, size[1] as u32);
        encoder.set_color(png::ColorType::Rgb);
        encoder.set_depth(png::BitDepth::Eight);
        encoder.set_compression(png::Compression::Balanced);
        encoder.set_animated(frames.len() as u32, 0)?;
        encoder.set_frame_delay(delay_ms(frames.len()), 1000)?;
        let mut writer = encoder.write_header()?;
        frames.iter().try_for_each(|frame| writer.write_image_data(&frame.rgb))?;
        writer.finish()
    };
    write(&mut bytes).map_err(|source| ImageError::new(size, source))?;
    Ok(bytes)
}

/// The frames side by side in rows of `columns`, for a viewer that shows one cell after the other.
pub fn sprites(frames: &[Image], columns: usize) -> Image {
    let cell = frames.first().map_or([1, 1], |f| f.size);
    let columns = columns.clamp(1, frames.len().max(1));
    let rows = frames.len().div_ceil(columns).max(1);
    let mut sheet = Image::new([cell[0] * columns, cell[1] * rows]);
    sheet.rgb.fill(255);
    let stride = sheet.size[0] * 3;
    for (n, frame) in frames.iter().enumerate() {
        let start = n % columns * cell[0] * 3 + n / columns * cell[1] * stride;
        for (y, row) in frame.rgb.chunks_exact(cell[0] * 3).enumerate() {
            let at = start + y * stride;
            sheet.rgb[at..at + row.len()].copy_from_slice(row);
        }
    }
    sheet
}
