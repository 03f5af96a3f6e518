//! The chunks of a file, walked before they are parsed: the parser drops what it cannot read, and follows chunks inside
//! chunks as deep as a bad file says.

use super::VoxError;

/// Bytes before the children of MAIN: `VOX `, the version, and the head of MAIN.
const HEAD: usize = 8 + CHUNK_HEAD;
/// Bytes of a chunk's id, content size and children's size.
const CHUNK_HEAD: usize = 12;

/// How many chunks of the kinds that must not be lost a file has.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Chunks {
    /// `XYZI`: models.
    pub models: usize,
    /// `nTRN`, `nGRP`, `nSHP`: nodes of the scene.
    pub nodes: usize,
    /// Place of the first `RGBA`, where there is a palette.
    pub palette_at: Option<usize>,
}

/// Walks the chunks of a file.
///
/// # Errors
/// [`VoxError::Chunk`]: another kind of file, cut short, chunks that overrun their parent, children inside a child, scene
/// nodes out of order, a model without a size before it, a palette of another length.
pub fn walk(bytes: &[u8], file: &str) -> Result<Chunks, VoxError> {
    let fault = |at: usize, found: String, expected: &str| VoxError::Chunk {
        file: file.to_owned(),
        at,
        found,
        expected: expected.to_owned(),
    };
    if bytes.len() < HEAD {
        return Err(fault(bytes.len(), "the file ends".into(), "a MagicaVoxel file"));
    }
    if &bytes[..4] != b"VOX " {
        return Err(fault(0, format!("`{}`", printable(&bytes[..4])), "`VOX `: this is no MagicaVoxel file"));
    }
    if &bytes[8..12] != b"MAIN" {
        return Err(fault(8, format!("chunk `{}`", printable(&bytes[8..12])), "chunk `MAIN`"));
    }
    if number(bytes, 12) != 0 {
        return Err(fault(12, format!("{} bytes in MAIN itself", number(bytes, 12)), "none"));
    }
    let end = HEAD + number(bytes, 16);
    if end != bytes.len() {
        let found = format!("MAIN of {} bytes in a file with {} after its head", end - HEAD, bytes.len() - HEAD);
        return Err(fault(16, found, "chunks up to the end of the file"));
    }
    let (mut chunks, mut at, mut sized) = (Chunks::default(), HEAD, false);
    while at < end {
        if end - at < CHUNK_HEAD {
            return Err(fault(at, format!("{} loose bytes", end - at), "a chunk or the end"));
        }
        let (id, size, children) = (&bytes[at..at + 4], number(bytes, at + 4), number(bytes, at + 8));
        let name = printable(id);
        if children != 0 {
            return Err(fault(at + 8, format!("chunks inside chunk `{name}`"), "chunks inside MAIN only"));
        }
        if size > end - at - CHUNK_HEAD {
            return Err(fault(at + 4, format!("chunk `{name}` of {size} bytes"), "one that ends inside MAIN"));
        }
        let content = &bytes[at + CHUNK_HEAD..at + CHUNK_HEAD + size];
        match id {
            b"SIZE" if size == 12 => sized = true,
            b"SIZE" => return Err(fault(at + 4, format!("SIZE of {size} bytes"), "12 bytes")),
            b"XYZI" => {
                let counted = (size >= 4).then(|| 4 + 4 * number(content, 0));
                if counted != Some(size) || !sized {
                    return Err(fault(at, format!("XYZI of {size} bytes"), "a SIZE before it and 4 bytes a voxel"));
                }
                chunks.models += 1;
                sized = false;
            }
            b"RGBA" if size != 1024 => return Err(fault(at + 4, format!("RGBA of {size} bytes"), "256 colours")),
            b"RGBA" => chunks.palette_at = chunks.palette_at.or(Some(at)),
            b"nTRN" | b"nGRP" | b"nSHP" => {
                if size < 4 || number(content, 0) != chunks.nodes {
                    let found = format!("chunk `{name}` out of order");
                    return Err(fault(at, found, &format!("scene node {}", chunks.nodes)));
                }
                chunks.nodes += 1;
            }
            _ if id.is_ascii() => {}
            _ => return Err(fault(at, format!("chunk `{name}`"), "the four letters of a chunk")),
        }
        at += CHUNK_HEAD + size;
    }
    Ok(chunks)
}

/// The little-endian number at a place of which four bytes are there.
fn number(bytes: &[u8], at: usize) -> usize {
    (0..4).fold(0, |n, i| n | usize::from(bytes[at + i]) << (8 * i))
}

fn printable(id: &[u8]) -> String {
    id.iter().map(|&b| if b.is_ascii_graphic() || b == b' ' { b as char } else { '?' }).collect()
}
