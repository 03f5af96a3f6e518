//! Areas and volume of a keyed surface: cubes are counted by key, and each key's terms are taken once.

use super::keyed::{DOORS, KeyCache, KeyedSurface, SLOTS, WINDOWS};
use super::measure::module_scale;
use super::{EnvelopeError, EnvelopeSurvey};
use crate::cubes::{CubeKey, scan_keys};
use crate::tiles::CUBE_MM;
use crate::voxels::VoxelArray;

/// Areas, volume and openings of a house whose surface is constructed from keys.
///
/// One pass counts the cubes of each key and adds up their levels; a key's areas are then multiplied by its count, and the volume,
/// the integral of z n_z, is summed in integers. The same array gives the same bits whatever `cache` has seen before. With all its
/// keys known a survey allocates nothing. Errs with the first cube that has no tile.
pub fn survey_keys(
    voxels: &VoxelArray,
    surface: &KeyedSurface,
    cache: &mut KeyCache,
) -> Result<EnvelopeSurvey, EnvelopeError> {
    let scale = module_scale(voxels, CUBE_MM);
    cache.prepare(surface, scale);
    let mut last = (CubeKey::default(), None);
    let mut inadmissible = None;
    // Which decks are walked on changes no surface.
    scan_keys(
        voxels,
        surface.rule,
        |_| false,
        |cube, key| {
            let n = match last {
                (known, Some(n)) if known == key => n,
                _ => cache.entry(key),
            };
            last = (key, Some(n));
            let entry = &mut cache.entries[n as usize];
            if entry.count == 0 {
                cache.met.push(n);
                if !entry.allowed && inadmissible.is_none() {
                    inadmissible = Some((cube, key.mask()));
                }
            }
            entry.count += 1;
            entry.levels += cube[2] as u64;
        },
    );
    match inadmissible {
        Some((cube, mask)) => Err(EnvelopeError::inadmissible(voxels, cube, mask)),
        None => Ok(sum(cache, scale)),
    }
}

fn sum(cache: &KeyCache, scale: [f64; 3]) -> EnvelopeSurvey {
    let mut areas = [0.0; SLOTS];
    let mut moment = 0i64;
    for &n in &cache.met {
        let entry = &cache.entries[n as usize];
        for &(slot, area) in &cache.terms[entry.terms[0] as usize..entry.terms[1] as usize] {
            areas[usize::from(slot)] += area * f64::from(entry.count);
        }
        let raised = 3 * entry.volume.doubled_plan_mm2 * i64::from(CUBE_MM[2]) * entry.levels as i64;
        moment += raised + entry.volume.moment_mm3 * i64::from(entry.count);
    }
    let mut survey = EnvelopeSurvey::default();
    survey.areas.area_m2.copy_from_slice(&areas[..WINDOWS]);
    survey.windows_m2.copy_from_slice(&areas[WINDOWS..DOORS]);
    survey.doors_m2.copy_from_slice(&areas[DOORS..]);
    survey.areas.volume_m3 = moment as f64 / 6e9 * scale.iter().product::<f64>();
    survey
}
