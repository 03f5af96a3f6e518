//! GlobalIds: 128 bits from a name, in the 22 characters of IFC.

use sha2::{Digest, Sha256};

/// The digits of IFC's base 64.
const DIGITS: &[u8; 64] = b"0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz_$";

/// The GlobalId of a name made of `parts`: the first 128 bits of their SHA-256, marked as a UUID of version 8 (RFC 9562: the value is
/// the maker's own), written as buildingSMART asks: 2 bits in the first digit, 6 in each of the other 21.
///
/// ```
/// let id = houscaper::export::ifc::global_id(&["villa", "part", "W0-S01"]);
/// assert_eq!(id.len(), 22);
/// assert_eq!(id, houscaper::export::ifc::global_id(&["villa", "part", "W0-S01"]));
/// ```
pub fn global_id(parts: &[&str]) -> String {
    let mut hash = Sha256::new();
    hash.update("houscaper.ifc/1");
    for part in parts {
        // No text holds this separator, so that ("a", "bc") is not ("ab", "c").
        hash.update([0x1f]);
        hash.update(part.as_bytes());
    }
    let mut bytes = [0u8; 16];
    bytes.iter_mut().zip(hash.finalize().iter()).for_each(|(to, from)| *to = *from);
    bytes[6] = bytes[6] & 0x0f | 0x80;
    bytes[8] = bytes[8] & 0x3f | 0x80;
    let value = u128::from_be_bytes(bytes);
    (0..22).rev().map(|digit| char::from(DIGITS[(value >> (6 * digit) & 63) as usize])).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ids_read_back_as_uuids_of_version_8() {
        let id = global_id(&["villa", "wall"]);
        let digit = |c: u8| DIGITS.iter().position(|d| *d == c).expect("a digit of ours") as u128;
        let value = id.bytes().fold(0u128, |v, c| v << 6 | digit(c));
        assert!(id.as_bytes()[0] < b'4', "128 bits leave two for the first digit: {id}");
        assert_eq!((value >> 76 & 15, value >> 62 & 3), (8, 2));
        assert_ne!(global_id(&["a", "bc"]), global_id(&["ab", "c"]));
    }
}
