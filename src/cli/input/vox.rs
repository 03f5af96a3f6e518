//! MagicaVoxel files on the command line.

use houscaper::voxels::vox::{VoxScene, read, rescale};
use houscaper::voxels::{House, Module};

use super::super::args::Import;
use super::super::check::plural;
use super::super::failure::{Blame, Failure};
use super::labelled;

/// Colours named in a note.
const MOST_COLOURS: usize = 4;

/// The labels of a file; colours that are no label count as base, and that is said.
pub fn house(bytes: &[u8], name: &str, import: &Import) -> Result<House, Failure> {
    let scene = read(bytes, name, &import.colours.clone().unwrap_or_default()).input()?;
    report(&scene, import);
    let voxels = match import.voxel_m {
        Some(size) => rescale(&scene.voxels, size, Module::default()).input()?,
        None => scene.voxels,
    };
    // Stairs are read from the voids of labelled plates; a massing has none.
    Ok(if scene.foreign == 0 && import.voxel_m.is_none() { labelled(voxels) } else { House::new(voxels) })
}

fn report(scene: &VoxScene, import: &Import) {
    if scene.hidden > 0 {
        eprintln!("note: {} hidden part{} of the scene left out", scene.hidden, plural(scene.hidden));
    }
    if scene.foreign == 0 || import.house {
        return;
    }
    let most: Vec<String> =
        scene.foreign_colours.iter().take(MOST_COLOURS).map(|(index, count)| format!("{index} ({count})")).collect();
    eprintln!(
        "note: {} voxel{} of {} colour{} that {} no label count as base; most often palette index {}{}; --colours names labels, --house makes a house of the massing",
        scene.foreign,
        plural(scene.foreign),
        scene.foreign_colours.len(),
        plural(scene.foreign_colours.len()),
        if scene.foreign_colours.len() == 1 { "is" } else { "are" },
        most.join(", "),
        if scene.palette { "" } else { " of MagicaVoxel's default palette" },
    );
}
