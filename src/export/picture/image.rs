//! Pixels, and PNG.

use glam::Vec3;

use crate::export::colour::linear_to_srgb;

/// An 8-bit sRGB picture, rows from the top.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Image {
    /// Pixels across and down.
    pub size: [usize; 2],
    /// Three bytes a pixel.
    pub rgb: Vec<u8>,
    /// sRGB of linear light in steps of 1/4095.
    curve: Vec<u8>,
}

/// PNG could not be encoded.
#[derive(Debug, thiserror::Error)]
#[error("PNG of {width} x {height} pixels: {source}")]
pub struct ImageError {
    width: usize,
    height: usize,
    source: png::EncodingError,
}

impl ImageError {
    /// What the encoder said of a picture of this size.
    pub(super) fn new([width, height]: [usize; 2], source: png::EncodingError) -> ImageError {
        ImageError { width, height, source }
    }
}

impl Image {
    /// A black image.
    pub fn new(size: [usize; 2]) -> Self {
        let curve = (0..4096).map(|i| (linear_to_srgb(f64::from(i) / 4095.0) * 255.0).round() as u8).collect();
        Image { size, rgb: vec![0; size[0] * size[1] * 3], curve }
    }

    /// Sets a pixel from linear light, held to 0..1.
    pub(super) fn set(&mut self, [x, y]: [usize; 2], linear: Vec3) {
        let at = (x + self.size[0] * y) * 3;
        let bytes = linear.to_array().map(|c| self.curve[(c.clamp(0.0, 1.0) * 4095.0 + 0.5) as usize]);
        self.rgb[at..at + 3].copy_from_slice(&bytes);
    }

    /// The three bytes of a pixel inside the image.
    pub fn get(&self, [x, y]: [usize; 2]) -> [u8; 3] {
        let at = (x + self.size[0] * y) * 3;
        [self.rgb[at], self.rgb[at + 1], self.rgb[at + 2]]
    }

    /// The bytes of a PNG file.
    ///
    /// # Errors
    /// When the encoder refuses the size.
    pub fn to_png(&self) -> Result<Vec<u8>, ImageError> {
        encode(self.size, &self.rgb, png::ColorType::Rgb)
    }
}

/// Encodes 8-bit pixels as PNG.
pub(crate) fn encode(size: [usize; 2], pixels: &[u8], colour: png::ColorType) -> Result<Vec<u8>, ImageError> {
    let mut bytes = Vec::new();
    let write = |bytes: &mut Vec<u8>| {
        let mut encoder = png::Encoder::new(bytes, size[0] as u32, size[1] as u32);
        encoder.set_color(colour);
        encoder.set_depth(png::BitDepth::Eight);
        encoder.set_compression(png::Compression::Balanced);
        encoder.write_header()?.write_image_data(pixels)
    };
    write(&mut bytes).map_err(|source| ImageError::new(size, source))?;
    Ok(bytes)
}
