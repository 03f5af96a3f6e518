//! Blocks as the OBJ text of a tile.

use std::collections::BTreeMap;
use std::fmt::Write;

use houscaper::tiles::Block;
use houscaper::tiles::solids::boundary;

/// Blocks as OBJ in mm, a closed solid for each component and octant.
pub fn obj(blocks: &[Block]) -> String {
    let mut parts: BTreeMap<_, Vec<Block>> = BTreeMap::new();
    blocks.iter().for_each(|b| parts.entry((b.component, b.octant)).or_default().push(b.clone()));
    let (mut text, mut used) = (String::new(), 0);
    for ((component, octant), blocks) in parts {
        writeln!(text, "g {}_o{octant}", component.name()).expect("text");
        for face in boundary(&blocks) {
            face.iter().for_each(|p| {
                let [x, y, z] = p.map(|um| f64::from(um) / 1000.0);
                writeln!(text, "v {x} {y} {z}").expect("text");
            });
            let corners: Vec<String> = (1..=face.len()).map(|n| (used + n).to_string()).collect();
            writeln!(text, "f {}", corners.join(" ")).expect("text");
            used += face.len();
        }
    }
    text
}
