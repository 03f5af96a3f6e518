//! Which of the 256 corner patterns of a cube a tileset can close.

/// Whether the filled corners and the empty corners of a pattern are each connected through cube edges.
///
/// `mask` has bit o = x + 2y + 4z set when corner o is filled. All-empty and all-filled count as admissible; of the other
/// 254 patterns exactly 126 are.
///
/// ```
/// use houscaper::voxels::is_admissible;
/// assert!(is_admissible(0b0000_0011)); // two corners of one edge
/// assert!(!is_admissible(0b0000_1001)); // two corners across a face
/// assert_eq!((1..=254).filter(|&m| is_admissible(m)).count(), 126);
/// ```
#[inline]
pub const fn is_admissible(mask: u8) -> bool {
    ADMISSIBLE[(mask >> 5) as usize] >> (mask & 31) & 1 == 1
}

/// One bit per pattern, derived at compile time.
const ADMISSIBLE: [u32; 8] = {
    let mut table = [0u32; 8];
    let mut mask = 0usize;
    while mask < 256 {
        if connected(mask as u8) && connected(!(mask as u8)) {
            table[mask >> 5] |= 1 << (mask & 31);
        }
        mask += 1;
    }
    table
};

/// Whether the corners of a set form one group through cube edges; true for the empty set.
const fn connected(set: u8) -> bool {
    let mut reached = set & set.wrapping_neg();
    let mut round = 0;
    while round < 8 {
        // A step along x, y or z flips one bit of the corner number.
        let x = (reached & 0x55) << 1 | (reached & 0xaa) >> 1;
        let y = (reached & 0x33) << 2 | (reached & 0xcc) >> 2;
        let z = (reached & 0x0f) << 4 | (reached & 0xf0) >> 4;
        reached |= (x | y | z) & set;
        round += 1;
    }
    reached == set
}
