//! Colours of labels.

use std::str::FromStr;

use dot_vox::Color;

use super::ColourError;
use crate::voxels::Label;

/// The colours our own files use, red, green, blue: one per label but empty, in the order of the codes 1 to 5.
pub const LABEL_COLOURS: [(Label, [u8; 3]); 5] = [
    (Label::Base, [233, 226, 211]),
    (Label::Floor, [181, 134, 84]),
    (Label::Foundation, [122, 124, 127]),
    (Label::Opening, [148, 63, 43]),
    (Label::Window, [112, 171, 214]),
];

/// What a colour is recognised by.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Key {
    /// Place in the palette as MagicaVoxel shows it, 1 to 255.
    Index(u8),
    /// Red, green, blue.
    Rgb([u8; 3]),
}

/// Which colour means which label.
///
/// First what was asked for, in its order, then the five colours of our own files; every other colour means nothing here.
///
/// ```
/// use houscaper::voxels::vox::ColourMap;
/// assert!("157=window,#663300=opening,246=empty".parse::<ColourMap>().is_ok());
/// assert!("glass=window".parse::<ColourMap>().is_err());
/// ```
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct ColourMap {
    asked: Vec<(Key, Label)>,
}

impl ColourMap {
    /// The label of a voxel with palette index `index` (1 to 255) and colour `rgb`; `None` when the colour has no meaning.
    pub fn label(&self, index: u8, rgb: [u8; 3]) -> Option<Label> {
        let asked = self.asked.iter().find(|(key, _)| match key {
            Key::Index(i) => *i == index,
            Key::Rgb(c) => *c == rgb,
        });
        let own = LABEL_COLOURS.iter().find(|(_, c)| *c == rgb).map(|(label, _)| *label);
        asked.map(|(_, label)| *label).or(own)
    }

    /// The label of each place of a palette as `dot_vox` numbers them, from 0.
    pub(super) fn labels(&self, palette: &[Color]) -> [Option<Label>; 256] {
        std::array::from_fn(|i| {
            let colour = palette.get(i)?;
            self.label((i + 1).min(255) as u8, [colour.r, colour.g, colour.b])
        })
    }
}

impl FromStr for ColourMap {
    type Err = ColourError;

    fn from_str(text: &str) -> Result<Self, ColourError> {
        let asked = text.split(',').map(entry).collect::<Result<_, _>>()?;
        Ok(ColourMap { asked })
    }
}

fn entry(text: &str) -> Result<(Key, Label), ColourError> {
    let fault = || ColourError { found: text.to_owned() };
    let (key, label) = text.split_once('=').ok_or_else(fault)?;
    let label = Label::ALL.into_iter().find(|l| l.name() == label.trim()).ok_or_else(fault)?;
    let key = match key.trim().strip_prefix('#') {
        Some(hex) if hex.len() == 6 && hex.bytes().all(|b| b.is_ascii_hexdigit()) => {
            let rgb = u32::from_str_radix(hex, 16).map_err(|_| fault())?;
            Key::Rgb([(rgb >> 16) as u8, (rgb >> 8) as u8, rgb as u8])
        }
        Some(_) => return Err(fault()),
        None => Key::Index(key.trim().parse().ok().filter(|i| *i > 0).ok_or_else(fault)?),
    };
    Ok((key, label))
}
