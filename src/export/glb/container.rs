//! The container of a GLB: a head and two chunks.

use std::borrow::Cow;

use super::GlbError;

/// Header, JSON chunk padded with spaces, binary chunk (already a multiple of four) when there is one.
pub(super) fn container(json: &[u8], bin: &[u8]) -> Result<Vec<u8>, GlbError> {
    let json: Cow<[u8]> = match json.len() % 4 {
        0 => Cow::Borrowed(json),
        rest => Cow::Owned([json, &b"   "[..4 - rest]].concat()),
    };
    let total = 12 + 8 + json.len() + if bin.is_empty() { 0 } else { 8 + bin.len() };
    let word = |n: usize| u32::try_from(n).map(u32::to_le_bytes).map_err(|_| GlbError::TooLarge { bytes: total });
    let mut glb = Vec::with_capacity(total);
    glb.extend_from_slice(b"glTF");
    glb.extend(2u32.to_le_bytes());
    glb.extend(word(total)?);
    glb.extend(word(json.len())?);
    glb.extend_from_slice(b"JSON");
    glb.extend_from_slice(&json);
    if !bin.is_empty() {
        glb.extend(word(bin.len())?);
        glb.extend_from_slice(b"BIN\0");
        glb.extend_from_slice(bin);
    }
    Ok(glb)
}
