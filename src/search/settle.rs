//! Normalising: after any change of a genome, everything that hangs on the massing is put right, or a cause is returned.
//!
//! Deterministic and idempotent, so that equal genomes stay equal. The order is fixed: plan rules first (they only
//! judge), then roof, stairs, doors and windows (which are moved to the nearest seat that fits, or dropped), entrances,
//! glazing, and choices last.

use super::cells::Cells;
use super::kept::Kept;
use super::massing::{Design, Infill, Massing, Opening, Roof, StoreyMass};
use super::openings::{Facades, glass_m2};
use super::plot::{Programme, Space};
use super::shape::{self, Cause};
use super::stairs::StairWell;
use crate::voxels::{Choice, Choices, Direction, Stair};

/// Doors per storey at most (HOUSE.md 2.4).
pub(super) const MOST_DOORS: usize = 3;
/// Share of the glazing range kept free at either end, against rounding.
const GLAZING_MARGIN: f64 = 0.001;
/// Cells of a flight with less than 1.5 m of headroom under it: they are no floor area.
const LOW_FLIGHT: usize = 3;

/// Puts a design right, or says which rule it cannot keep.
///
/// # Errors
/// The first [`Cause`] in the order of [`Cause::ALL`].
pub fn settle(design: &mut Design, space: &Space) -> Result<(), Cause> {
    check_massing(&design.massing, space)?;
    settle_roof(&mut design.massing, space)?;
    settle_stairs(&mut design.massing, space.plot.kept.as_ref())?;
    check_area(&design.massing, space)?;
    let count = design.massing.storeys.len();
    for s in 0..count {
        settle_openings(&mut design.massing, s, space)?;
    }
    if !has_two_orientations(&design.massing) {
        return Err(Cause::Glazing);
    }
    if space.plot.kept.as_ref().is_some_and(|kept| !kept.is_kept(&design.massing, &space.plot)) {
        return Err(Cause::Given);
    }
    design.choices = settle_choices(design.choices, space, count);
    Ok(())
}

/// The plan rules, storey by storey and pair by pair.
pub fn check_massing(massing: &Massing, space: &Space) -> Result<(), Cause> {
    let storeys = &massing.storeys;
    if storeys.is_empty() || storeys.len() < space.least_storeys() || storeys.len() > space.most_storeys() {
        return Err(Cause::Storeys);
    }
    for (s, storey) in storeys.iter().enumerate() {
        if !space.plot.allowed(s).contains(&storey.footprint) {
            return Err(Cause::Plot);
        }
        if space.plot.must_fill(s).is_some_and(|given| !storey.footprint.contains(given)) {
            return Err(Cause::Given);
        }
    }
    let mut standing = storeys[0].footprint.clone();
    for (s, storey) in storeys.iter().enumerate() {
        if s == 0 || storeys[s - 1].footprint != storey.footprint {
            shape::check_plan(&storey.footprint)?;
        }
        if s > 0 {
            shape::check_pair(&storeys[s - 1].footprint, &storey.footprint, &standing)?;
            standing = standing.and(&storey.footprint);
        }
    }
    Ok(())
}

pub(super) fn settle_roof(massing: &mut Massing, space: &Space) -> Result<(), Cause> {
    let count = massing.storeys.len();
    let layers = space.plot.modules[2].saturating_sub(count * crate::voxels::STOREY_MODULES + 1);
    let keep_free = space.plot.given.as_ref().and_then(|g| g.empty.get(count));
    let (Some(base), Some(top)) = (massing.storeys.first(), massing.storeys.last()) else {
        return Err(Cause::Storeys);
    };
    let [least, most] = space.programme.roof_rise;
    let least = least.max(space.plot.kept.as_ref().map_or(0, Kept::roof_rise));
    let wanted = Roof::of_rise(massing.roof.rise().clamp(least, most.max(least)));
    let mut roof = shape::fit_roof(&top.footprint, wanted, layers, keep_free);
    while !shape::is_stable_width(&base.footprint, count, roof) {
        roof = match roof {
            Roof::Flat => return Err(Cause::Slender),
            Roof::Hip(1) => Roof::Flat,
            Roof::Hip(rise) => Roof::Hip(rise - 1),
        };
    }
    if roof == Roof::Flat && least > 0 {
        return Err(Cause::Roof);
    }
    massing.roof = roof;
    Ok(())
}

/// Every storey but the top one gets its stair back, at the nearest place where it fits; a given one stays where it is.
fn settle_stairs(massing: &mut Massing, kept: Option<&Kept>) -> Result<(), Cause> {
    let mut below: Option<Stair> = None;
    for s in 0..massing.storeys.len() {
        let Some(upper) = massing.storeys.get(s + 1) else {
            massing.storeys[s].stair = None;
            break;
        };
        let well = StairWell::new(&massing.storeys[s].footprint, &upper.footprint, below);
        let well = well.below_slab(kept.and_then(|kept| kept.slab(s)));
        let old = massing.storeys[s].stair.unwrap_or_else(|| central_stair(&massing.storeys[s], s));
        below = Some(match kept.and_then(|kept| kept.stair(s)) {
            Some(given) if well.fits(&given) => given,
            Some(_) => return Err(Cause::Given),
            None => well.nearest(&Stair { storey: s, ..old }).ok_or(Cause::Stair)?,
        });
        massing.storeys[s].stair = below;
    }
    Ok(())
}

/// Where a stair starts looking for its place when there was none: the middle of the storey.
fn central_stair(storey: &StoreyMass, s: usize) -> Stair {
    let ([x, y], [w, h]) = storey.footprint.bounds().unwrap_or_default();
    let run = if w >= h { Direction::East } else { Direction::North };
    Stair { storey: s, start: [x + w / 2, y + h / 2], run, kind: crate::voxels::StairKind::UTurn }
}

/// The facades of one storey as its doors and windows see them.
pub fn facades(massing: &Massing, s: usize) -> Facades {
    let storey = &massing.storeys[s];
    let below = s.checked_sub(1).map(|i| &massing.storeys[i]);
    let deck = below.map(|b| b.footprint.minus(&storey.footprint));
    let voids = below.and_then(|b| b.stair).map(|stair| stair.void_cells()).unwrap_or_default();
    Facades::new(&storey.footprint, deck.as_ref(), storey.stair.as_ref(), &voids)
}

fn settle_openings(massing: &mut Massing, s: usize, space: &Space) -> Result<(), Cause> {
    let mut facades = facades(massing, s);
    let net = net_area_m2(massing, s);
    let mut old = std::mem::take(&mut massing.storeys[s].openings);
    old.sort_unstable();
    let mut seated = Vec::with_capacity(old.len() + 4);
    if let Some(kept) = &space.plot.kept {
        seat_given(kept, s, &massing.storeys[s].footprint, &mut facades, &mut seated)?;
        old.retain(|o| {
            !seated.iter().any(|g: &Opening| g.facing == o.facing && g.cells().any(|c| o.cells().any(|d| c == d)))
        });
    }
    let given = seated.len();
    for opening in &old {
        let room = opening.infill == Infill::Window || doors(&seated) < MOST_DOORS;
        if let Some(seat) = facades.reseat(&canonical(*opening)).filter(|_| room) {
            facades.take(&seat);
            seated.push(seat);
        }
    }
    if s == 0 {
        add_entrances(&mut seated, given, &mut facades, space.programme.entrances_min)?;
    }
    settle_glazing(&mut seated, given, &mut facades, net, &space.programme)?;
    seated.sort_unstable();
    massing.storeys[s].openings = seated;
    Ok(())
}

/// Seats the given doors and windows of a storey where they are, and closes the given walls to others.
fn seat_given(
    kept: &Kept,
    s: usize,
    footprint: &Cells,
    facades: &mut Facades,
    seated: &mut Vec<Opening>,
) -> Result<(), Cause> {
    for opening in kept.openings(footprint, s) {
        if !facades.is_free(&opening) {
            return Err(Cause::Given);
        }
        facades.take(&opening);
        seated.push(opening);
    }
    if let Some(walls) = kept.walls(s) {
        facades.close(walls);
    }
    Ok(())
}

/// Doors are one module wide and stand on the slab; windows keep to the sizes that have a tile.
fn canonical(opening: Opening) -> Opening {
    match opening.infill {
        Infill::Door => Opening { width: 1, sill: 1, ..opening },
        Infill::Window => {
            Opening { width: opening.width.clamp(1, Opening::WIDEST), sill: opening.sill.clamp(1, 2), ..opening }
        }
    }
}

fn doors(openings: &[Opening]) -> usize {
    openings.iter().filter(|o| o.infill == Infill::Door).count()
}

/// Adds doors until there are enough, dropping windows where they stand in the way; the first `given` stay.
fn add_entrances(seated: &mut Vec<Opening>, given: usize, facades: &mut Facades, least: usize) -> Result<(), Cause> {
    while doors(seated) < least.min(MOST_DOORS) {
        let place = [Direction::South, Direction::East, Direction::West, Direction::North]
            .into_iter()
            .find_map(|facing| middle(facades.places(Opening::door(facing, [0, 0])).collect()));
        match (place, seated.iter().skip(given).rposition(|o| o.infill == Infill::Window).map(|i| i + given)) {
            (Some(door), _) => {
                facades.take(&door);
                seated.push(door);
            }
            (None, Some(i)) => facades.release(&seated.remove(i)),
            (None, None) => return Err(Cause::Entrance),
        }
    }
    Ok(())
}

fn middle(places: Vec<Opening>) -> Option<Opening> {
    places.get(places.len() / 2).copied()
}

/// Adds or narrows windows until the storey's glass lies within the programme's range; the first `given` stay.
fn settle_glazing(
    seated: &mut Vec<Opening>,
    given: usize,
    facades: &mut Facades,
    net_m2: f64,
    programme: &Programme,
) -> Result<(), Cause> {
    let [low, high] = glazing_band(programme);
    let glass = |seated: &[Opening]| seated.iter().map(glass_m2).sum::<f64>() / net_m2.max(1e-9);
    while glass(seated) < low || facings(seated) < 2 {
        if !add_window(seated, facades) && !widen_window(&mut seated[given..], facades) {
            return Err(Cause::Glazing);
        }
    }
    while glass(seated) > high {
        if !narrow_window(seated, given, facades) {
            return Err(Cause::Glazing);
        }
    }
    if glass(seated) < low { Err(Cause::Glazing) } else { Ok(()) }
}

/// The glazing range that moves keep, a little inside the programme's.
pub(super) fn glazing_band(programme: &Programme) -> [f64; 2] {
    let [low, high] = programme.glazing;
    let (inner_low, inner_high) = (low * (1.0 + GLAZING_MARGIN), high * (1.0 - GLAZING_MARGIN));
    if inner_low <= inner_high { [inner_low, inner_high] } else { [low, high] }
}

fn facing_glass(seated: &[Opening], facing: Direction) -> f64 {
    seated.iter().filter(|o| o.facing == facing).map(glass_m2).sum()
}

/// Number of facades with a window.
fn facings(seated: &[Opening]) -> usize {
    Direction::ALL.iter().filter(|&&d| facing_glass(seated, d) > 0.0).count()
}

/// A window two wide (one, where two do not fit) in the middle of the free places of the facade with the least glass.
fn add_window(seated: &mut Vec<Opening>, facades: &mut Facades) -> bool {
    let mut order = Direction::ALL;
    order.sort_by(|a, b| facing_glass(seated, *a).total_cmp(&facing_glass(seated, *b)));
    let place = order.iter().find_map(|&facing| {
        [2, 1].iter().find_map(|&w| middle(facades.places(Opening::window(facing, [0, 0], w, 2)).collect()))
    });
    if let Some(window) = place {
        facades.take(&window);
        seated.push(window);
    }
    place.is_some()
}

/// Makes the first window that has room for it one module wider, or opens it down to the slab.
fn widen_window(seated: &mut [Opening], facades: &mut Facades) -> bool {
    for window in seated.iter_mut().filter(|o| o.infill == Infill::Window) {
        facades.release(window);
        let [ax, ay] = window.along();
        let back = [window.cell[0] - ax, window.cell[1] - ay];
        let mut wider = [window.cell, back].map(|cell| Opening { cell, width: window.width + 1, ..*window }).to_vec();
        wider.retain(|o| o.width <= Opening::WIDEST);
        wider.extend((window.sill > 1).then_some(Opening { sill: 1, ..*window }));
        let better = wider.into_iter().find(|o| facades.is_free(o));
        *window = better.unwrap_or(*window);
        facades.take(window);
        if better.is_some() {
            return true;
        }
    }
    false
}

/// Narrows the widest window by a module, raises a sill, or drops a window that is not the last of two facades; the first `given` stay.
fn narrow_window(seated: &mut Vec<Opening>, given: usize, facades: &mut Facades) -> bool {
    let widest = (given..seated.len())
        .filter(|&i| seated[i].infill == Infill::Window)
        .max_by_key(|&i| (seated[i].width, seated[i].height(), i));
    let Some(i) = widest else { return false };
    facades.release(&seated[i]);
    if seated[i].width > 1 {
        seated[i].width -= 1;
    } else if seated[i].sill == 1 {
        seated[i].sill = 2;
    } else {
        let mut fewer = seated.clone();
        fewer.remove(i);
        if facings(&fewer) < 2 {
            facades.take(&seated[i]);
            return false;
        }
        *seated = fewer;
        return true;
    }
    facades.take(&seated[i]);
    true
}

/// Whether every storey has windows on two facades at least (HOUSE.md 2.5).
fn has_two_orientations(massing: &Massing) -> bool {
    massing.storeys.iter().all(|s| facings(&s.openings) >= 2)
}

/// Net floor area of a storey in m2: inside the lining, without the opening of the stair from below and without the low
/// cells under the stair that starts here.
pub fn net_area_m2(massing: &Massing, s: usize) -> f64 {
    let voids = s.checked_sub(1).and_then(|i| massing.storeys[i].stair).map_or(0, |stair| stair.void_cells().len());
    let low = if massing.storeys[s].stair.is_some() { LOW_FLIGHT } else { 0 };
    shape::net_area_m2(&massing.storeys[s].footprint, voids + low)
}

/// Net floor area of a house in m2, from its footprints and stairs.
pub fn floor_area_m2(massing: &Massing) -> f64 {
    (0..massing.storeys.len()).map(|s| net_area_m2(massing, s)).sum()
}

pub(super) fn check_area(massing: &Massing, space: &Space) -> Result<(), Cause> {
    let [least, most] = space.programme.floor_area_m2;
    let slack = Programme::AREA_SLACK;
    let area = floor_area_m2(massing);
    if area < least * (1.0 - slack) || area > most * (1.0 + slack) { Err(Cause::Area) } else { Ok(()) }
}

/// Choices within their options; joist bits of plates that the house does not have are cleared.
fn settle_choices(choices: Choices, space: &Space, storeys: usize) -> Choices {
    let mut out = choices;
    for choice in Choice::ALL {
        out.0[choice as usize] = choices.0[choice as usize].min(space.choices.count(choice) - 1);
    }
    let plates = if storeys >= 16 { u16::MAX } else { (1 << storeys) - 1 };
    let joists = choices.0[Choice::Joists as usize] & plates;
    out.0[Choice::Joists as usize] = if joists < space.choices.count(Choice::Joists) { joists } else { 0 };
    out
}
