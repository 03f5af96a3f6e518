//! `--house`: a house out of a massing.

use std::path::Path;

use houscaper::search::dress::dress;
use houscaper::voxels::rules::{self, RuleSettings};
use houscaper::voxels::{House, Module, read_storeys};

use super::super::check::plural;
use super::super::failure::{Blame, Failure, bad_input};

/// The dressed massing; what was changed for it and what could not be kept goes to stderr.
pub fn dressed(massing: House, path: &Path) -> Result<House, Failure> {
    let name = path.display().to_string();
    if massing.voxels.module != Module::default() {
        return Err(bad_input(format!(
            "{name}: modules of {:?} m make no house of ours; `houscaper convert --occupied RULE --cell-modules X,Y,Z --house` sets the size",
            massing.voxels.module.size_m
        )));
    }
    let dressed = dress(&massing.voxels, &massing.zones).map_err(|error| anyhow::anyhow!("{name}: {error}")).input()?;
    let storeys = read_storeys(&dressed.house).storeys.len();
    eprintln!(
        "house: {storeys} storey{}; below the roof {} voxel{} filled and {} emptied",
        plural(storeys),
        dressed.filled,
        plural(dressed.filled),
        dressed.emptied
    );
    for note in &dressed.notes {
        eprintln!("  {note}");
    }
    let violations = rules::check(&dressed.house, &RuleSettings::default());
    match violations.len() {
        0 => eprintln!("  every rule is kept"),
        n => eprintln!("  {n} rule{} broken:", plural(n)),
    }
    for violation in &violations {
        eprintln!("  {}: {}", violation.rule, violation.message);
    }
    Ok(dressed.house)
}
