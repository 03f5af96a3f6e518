//! Every set of doors and windows of a storey.

use super::TooLarge;
use crate::search::massing::{Infill, Massing, Opening};
use crate::search::openings::{Facades, glass_m2};
use crate::search::plot::Space;
use crate::search::settle::{MOST_DOORS, facades, glazing_band, net_area_m2};
use crate::voxels::Direction;

/// Rounding of sums of glass: what lies as close to a limit is left to [`settle`](crate::search::settle) to judge.
const ROUNDING: f64 = 1e-9;

/// What one facade may hold.
struct Row {
    openings: Vec<Opening>,
    glass_m2: f64,
    doors: usize,
}

/// Every set of openings of storey `s` that is free to be seated and keeps doors, glazing and orientations; each set in the order of
/// [`Opening`].
///
/// # Errors
/// More than `most` sets.
pub fn sets(massing: &Massing, s: usize, space: &Space, most: usize) -> Result<Vec<Vec<Opening>>, TooLarge> {
    let rows = Direction::ALL.map(|facing| rows(facades(massing, s), facing));
    let net_m2 = net_area_m2(massing, s).max(1e-9);
    let band = glazing_band(&space.programme).map(|ratio| ratio * net_m2);
    let entrances = if s == 0 { space.programme.entrances_min.min(MOST_DOORS) } else { 0 };
    let limits = Limits { band, entrances, most };
    let mut out = Vec::new();
    limits.product(&rows, &mut Vec::new(), &mut out)?;
    out.iter_mut().for_each(|set| set.sort_unstable());
    Ok(out)
}

struct Limits {
    band: [f64; 2],
    entrances: usize,
    most: usize,
}

impl Limits {
    fn product<'r>(
        &self,
        rows: &'r [Vec<Row>; 4],
        taken: &mut Vec<&'r Row>,
        out: &mut Vec<Vec<Opening>>,
    ) -> Result<(), TooLarge> {
        let glass: f64 = taken.iter().map(|r| r.glass_m2).sum();
        let doors: usize = taken.iter().map(|r| r.doors).sum();
        if glass > self.band[1] + ROUNDING || doors > MOST_DOORS {
            return Ok(());
        }
        let Some(next) = rows.get(taken.len()) else {
            let looks = taken.iter().filter(|r| r.glass_m2 > 0.0).count();
            if glass >= self.band[0] - ROUNDING && doors >= self.entrances && looks >= 2 {
                out.push(taken.iter().flat_map(|r| r.openings.iter().copied()).collect());
            }
            return if out.len() > self.most {
                Err(TooLarge { what: "sets of windows and doors of one storey", most: self.most })
            } else {
                Ok(())
            };
        };
        for row in next {
            taken.push(row);
            self.product(rows, taken, out)?;
            taken.pop();
        }
        Ok(())
    }
}

/// Every set of openings of the facades of one facing, the empty one first.
fn rows(mut free: Facades, facing: Direction) -> Vec<Row> {
    let mut like = vec![Opening::door(facing, [0, 0])];
    like.extend((1..=Opening::WIDEST).flat_map(|w| [1, 2].map(|sill| Opening::window(facing, [0, 0], w, sill))));
    let mut all: Vec<Opening> = like.into_iter().flat_map(|one| free.places(one).collect::<Vec<_>>()).collect();
    all.sort_unstable_by_key(|o| (o.cell, *o));
    let mut out = Vec::new();
    grow(&all, &mut free, &mut Vec::new(), &mut out);
    out
}

fn grow(rest: &[Opening], free: &mut Facades, taken: &mut Vec<Opening>, out: &mut Vec<Row>) {
    let doors = taken.iter().filter(|o| o.infill == Infill::Door).count();
    out.push(Row { openings: taken.clone(), glass_m2: taken.iter().map(glass_m2).sum(), doors });
    for (i, opening) in rest.iter().enumerate() {
        if free.is_free(opening) {
            free.take(opening);
            taken.push(*opening);
            grow(&rest[i + 1..], free, taken, out);
            taken.pop();
            free.release(opening);
        }
    }
}
