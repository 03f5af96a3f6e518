//! Starts: diverse rule-respecting designs for a programme on a plot, around given cells.

use super::cells::Cells;
use super::fields;
use super::massing::{Design, Massing, Opening, Roof, StoreyMass};
use super::moves::Move;
use super::plot::Space;
use super::settle::{floor_area_m2, settle};
use super::shape::{Cause, check_plan};
use crate::voxels::{Choice, Choices, Direction, Stair, StairKind};
use rand::{Rng, RngExt};

/// Drawn massings before a start is given up.
const DRAWS: usize = 400;
/// Places drawn for an opening that follows a field, of which the field chooses one.
const WISHES: usize = 6;
/// Rounds in which given cells are completed to a footprint.
const ROUNDS: usize = 64;

/// No start could be found.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[error(
    "no house of {} to {} m2 on {} to {} storeys fits the plot of {} x {} x {} modules in {DRAWS} draws; most often: {} ({count} times). Enlarge plot.modules, or relax programme.{}",
    area_m2[0], area_m2[1], storeys[0], storeys[1], modules[0], modules[1], modules[2], cause.name(), advice(*cause)
)]
pub struct NoStart {
    /// The cause met most often.
    pub cause: Cause,
    /// How often.
    pub count: usize,
    /// The programme's floor area.
    pub area_m2: [f64; 2],
    /// Storeys possible.
    pub storeys: [usize; 2],
    /// The plot.
    pub modules: [usize; 3],
}

fn advice(cause: Cause) -> &'static str {
    match cause {
        Cause::Glazing => "glazing_ratio_min",
        Cause::Entrance => "entrances_min",
        Cause::Roof => "roof_rise",
        Cause::Storeys | Cause::Stair | Cause::Slender => "storeys",
        Cause::Area
        | Cause::Plot
        | Cause::Given
        | Cause::Blocks
        | Cause::Diagonal
        | Cause::Passage
        | Cause::Gap
        | Cause::Cantilever
        | Cause::Drain => "floor_area_m2",
    }
}

/// Draws a start: footprints first, then roof, stairs, openings and choices, all settled.
///
/// # Errors
/// When none of some hundred draws keeps the rules and the programme: says what stood in the way most often.
pub fn start(space: &Space, rng: &mut impl Rng) -> Result<Design, NoStart> {
    let mut causes = [0usize; Cause::ALL.len()];
    for _ in 0..DRAWS {
        match draw(space, rng) {
            Ok(design) => return Ok(varied(design, space, rng)),
            Err(cause) => causes[Cause::ALL.iter().position(|c| *c == cause).unwrap_or(0)] += 1,
        }
    }
    let (worst, &count) = causes.iter().enumerate().max_by_key(|&(i, n)| (*n, std::cmp::Reverse(i))).unwrap_or((0, &0));
    Err(NoStart {
        cause: Cause::ALL[worst],
        count,
        area_m2: space.programme.floor_area_m2,
        storeys: [space.least_storeys(), space.most_storeys()],
        modules: space.plot.modules,
    })
}

/// A few moves, so that starts of the same massing differ; the floor area stays in the programme's range.
fn varied(design: Design, space: &Space, rng: &mut impl Rng) -> Design {
    let mut out = design;
    for _ in 0..rng.random_range(0..4) {
        if let Some(next) = Move::draw(rng).apply(&out, space, rng).filter(|d| in_range(d, space)) {
            out = next;
        }
    }
    out
}

fn in_range(design: &Design, space: &Space) -> bool {
    let [least, most] = space.programme.floor_area_m2;
    (least..=most).contains(&floor_area_m2(&design.massing))
}

fn draw(space: &Space, rng: &mut impl Rng) -> Result<Design, Cause> {
    let count = rng.random_range(space.least_storeys()..=space.most_storeys());
    let plans = if space.plot.given_storeys() > 0 { around_given(space, count, rng) } else { free(space, count, rng) }?;
    let storeys = plans.into_iter().enumerate().map(|(s, plan)| dressed(plan, s, space, rng)).collect();
    let [flat, steepest] = space.programme.roof_rise;
    let roof =
        if flat == 0 && rng.random_bool(0.3) { 0 } else { rng.random_range(flat.max(1)..=steepest.max(flat).max(1)) };
    let roof = Roof::of_rise(roof);
    let mut choices = Choices::default();
    for choice in Choice::ALL {
        choices.0[choice as usize] = rng.random_range(0..space.choices.count(choice));
    }
    let mut design = Design { massing: Massing { storeys, roof }, choices };
    settle(&mut design, space)?;
    if in_range(&design, space) || space.plot.given_storeys() > 0 { Ok(design) } else { Err(Cause::Area) }
}

/// A storey with windows and a stair wished for at random places: settling moves them to seats.
fn dressed(footprint: Cells, s: usize, space: &Space, rng: &mut impl Rng) -> StoreyMass {
    let ([x, y], [w, h]) = footprint.bounds().unwrap_or(([0, 0], [1, 1]));
    let facing = |rng: &mut dyn FnMut(usize) -> usize| Direction::ALL[rng(4)];
    let mut below = |n: usize| rng.random_range(0..n.max(1));
    let mut openings = Vec::new();
    for _ in 0..2 + below(4) {
        let d = facing(&mut below);
        let cell = edge_cell(d, [x, y], [w, h], &mut below);
        openings.push(Opening::window(d, cell, 1 + below(3), 1 + below(3).min(1)));
    }
    let d = facing(&mut below);
    openings.push(Opening::door(d, edge_cell(d, [x, y], [w, h], &mut below)));
    let kind = if below(3) == 0 { StairKind::Straight } else { StairKind::UTurn };
    let run = facing(&mut below);
    let stair = Some(Stair { storey: 0, start: [x + below(w), y + below(h)], run, kind });
    for opening in &mut openings {
        let Some(field) = space.plot.fields.of(opening.infill) else { continue };
        let wish = |_| {
            let facing = Direction::ALL[rng.random_range(0..4usize)];
            let cell = edge_cell(facing, [x, y], [w, h], &mut |n| rng.random_range(0..n.max(1)));
            Opening { facing, cell, ..*opening }
        };
        let wishes: Vec<Opening> = (0..WISHES).map(wish).collect();
        *opening = fields::draw(&wishes, Some(field), s, rng).unwrap_or(*opening);
    }
    StoreyMass { footprint, openings, stair }
}

fn edge_cell(
    d: Direction,
    [x, y]: [usize; 2],
    [w, h]: [usize; 2],
    below: &mut dyn FnMut(usize) -> usize,
) -> [isize; 2] {
    let cell = match d {
        Direction::East => [x + w - 1, y + below(h)],
        Direction::West => [x, y + below(h)],
        Direction::North => [x + below(w), y + h - 1],
        Direction::South => [x + below(w), y],
    };
    cell.map(|v| v as isize)
}

/// Footprints on a free plot: one to three rectangles at the ground, then each storey a part of the one below.
fn free(space: &Space, count: usize, rng: &mut impl Rng) -> Result<Vec<Cells>, Cause> {
    let size = space.plot.size();
    let [least, most] = space.programme.floor_area_m2;
    let highest = most.min(size[0] as f64 * size[1] as f64 * 0.81 * count as f64);
    let target = least + (highest - least).max(0.0) * rng.random::<f64>();
    // Gross cells of the ground storey: the lining takes a good quarter of a small house.
    let wanted = (target / count as f64 / 0.81 * 1.35) as usize;
    let mut ground = rectangle(size, wanted, rng);
    for _ in 0..rng.random_range(0..3) {
        let ([x, y], [w, h]) = ground.bounds().unwrap_or_default();
        let wing = [rng.random_range(3..=6usize), rng.random_range(3..=6usize)];
        let corner = [x as isize, y as isize].map(|v| v - 3);
        let at = [corner[0] + rng.random_range(0..w + 4) as isize, corner[1] + rng.random_range(0..h + 4) as isize];
        let grown = ground.or(&Cells::rect(size, at, wing));
        if check_plan(&grown).is_ok() {
            ground = grown;
        }
    }
    let mut plans = vec![ground.and(&space.plot.allowed(0))];
    for s in 1..count {
        plans.push(part_of(&plans[s - 1], rng).and(&space.plot.allowed(s)));
    }
    Ok(plans)
}

/// A rectangle of about `wanted` cells, of any proportion the plot allows, anywhere.
fn rectangle([nx, ny]: [usize; 2], wanted: usize, rng: &mut impl Rng) -> Cells {
    let w = rng.random_range(4..=nx);
    let h = (wanted / w).clamp(4, ny);
    let at = [rng.random_range(0..=nx - w) as isize, rng.random_range(0..=ny - h) as isize];
    Cells::rect([nx, ny], at, [w, h])
}

/// The plan itself, or what is left of it when one side is set back.
fn part_of(plan: &Cells, rng: &mut impl Rng) -> Cells {
    let Some(([x, y], [w, h])) = plan.bounds() else { return plan.clone() };
    if rng.random_bool(0.5) {
        return plan.clone();
    }
    let set_back = rng.random_range(1..=4usize);
    let (x, y, w, h) = (x as isize, y as isize, w, h);
    let (at, extent) = match rng.random_range(0..4) {
        0 => ([x, y], [w.saturating_sub(set_back), h]),
        1 => ([x + set_back as isize, y], [w, h]),
        2 => ([x, y], [w, h.saturating_sub(set_back)]),
        _ => ([x, y + set_back as isize], [w, h]),
    };
    plan.and(&Cells::rect(plan.size(), at, extent))
}

/// Footprints around given cells: from the top down each storey holds its own cells and what carries the storey above.
fn around_given(space: &Space, count: usize, rng: &mut impl Rng) -> Result<Vec<Cells>, Cause> {
    let size = space.plot.size();
    let mut plans = vec![Cells::new(size); count];
    let extra = random_blocks(size, rng);
    for s in (0..count).rev() {
        let mut plan = space.plot.must_fill(s).cloned().unwrap_or_else(|| Cells::new(size));
        if let Some(above) = plans.get(s + 1) {
            plan = plan.or(above);
        }
        if s < space.plot.given_storeys() || plan.is_empty() {
            plan = plan.or(&extra);
        }
        plans[s] = complete(plan, &space.plot.allowed(s), rng)?;
    }
    Ok(plans)
}

/// None to two random blocks of 3 to 7 modules.
fn random_blocks(size: [usize; 2], rng: &mut impl Rng) -> Cells {
    let mut out = Cells::new(size);
    for _ in 0..rng.random_range(0..3) {
        let at = [rng.random_range(0..size[0]) as isize, rng.random_range(0..size[1]) as isize];
        out = out.or(&Cells::rect(size, at, [rng.random_range(3..=7), rng.random_range(3..=7)]));
    }
    out
}

/// Grows a set of cells until it is a footprint that keeps the plan rules.
///
/// # Errors
/// The rule that stands in the way when no growth within `allowed` helps.
pub fn complete(plan: Cells, allowed: &Cells, rng: &mut impl Rng) -> Result<Cells, Cause> {
    let mut plan = plan.and(allowed);
    let mut cause = Cause::Blocks;
    for _ in 0..ROUNDS {
        cause = match check_plan(&plan) {
            Ok(()) => return Ok(plan),
            Err(cause) => cause,
        };
        let grown = plan.or(&mend(&plan, cause, rng)).and(allowed);
        if grown == plan {
            let [nx, ny] = plan.size();
            let at = [rng.random_range(0..nx) as isize - 1, rng.random_range(0..ny) as isize - 1];
            let block = Cells::rect(plan.size(), at, [4, 4]).and(allowed);
            plan = if block.meets(&plan) || plan.is_empty() { plan.or(&block) } else { plan };
        } else {
            plan = grown;
        }
    }
    Err(cause)
}

/// Cells whose filling may heal a broken rule.
fn mend(plan: &Cells, cause: Cause, rng: &mut impl Rng) -> Cells {
    let size = plan.size();
    match cause {
        Cause::Blocks => {
            let loose = plan.minus(&plan.blocks(3));
            let (side, seeds) = if loose.is_empty() { (4, plan.minus(&plan.blocks(4))) } else { (3, loose) };
            block_over(&seeds, size, side, rng)
        }
        Cause::Diagonal => block_over(&diagonal_cells(plan), size, 4, rng),
        Cause::Passage => bridge(plan, rng),
        Cause::Gap => gap_cells(plan),
        _ => Cells::new(size),
    }
}

fn block_over(seeds: &Cells, size: [usize; 2], side: usize, rng: &mut impl Rng) -> Cells {
    let cells: Vec<[usize; 2]> = seeds.iter().collect();
    let Some([x, y]) = super::moves::pick(&cells, rng) else { return Cells::new(size) };
    let mut slide = |v: usize, n: usize| {
        let back = rng.random_range(0..side);
        v.saturating_sub(back).min(n.saturating_sub(side)) as isize
    };
    Cells::rect(size, [slide(x, size[0]), slide(y, size[1])], [side, side])
}

/// Filled cells that touch another at a corner only.
fn diagonal_cells(plan: &Cells) -> Cells {
    let mut out = Cells::new(plan.size());
    for [x, y] in plan.iter() {
        let has = |dx: isize, dy: isize| plan.has([x as isize + dx, y as isize + dy]);
        let corners = [(1, 1), (1, -1), (-1, 1), (-1, -1)];
        if corners.iter().any(|&(dx, dy)| has(dx, dy) && !has(dx, 0) && !has(0, dy)) {
            out.set([x, y], true);
        }
    }
    out
}

/// A band four modules wide from the nearest cell of one part of the rooms to another part.
fn bridge(plan: &Cells, rng: &mut impl Rng) -> Cells {
    let inner = plan.inner();
    let Some(seed) = inner.first() else { return Cells::new(plan.size()) };
    let part = inner.component(seed);
    let (ours, theirs): (Vec<_>, Vec<_>) = (part.iter().collect(), inner.minus(&part).iter().collect());
    let pairs = ours.iter().flat_map(|a| theirs.iter().map(move |b| (a, b)));
    let nearest = pairs.min_by_key(|(a, b)| a[0].abs_diff(b[0]) + a[1].abs_diff(b[1]));
    let Some((a, b)) = nearest else { return Cells::new(plan.size()) };
    let low = [a[0].min(b[0]) as isize - 1, a[1].min(b[1]) as isize - 1];
    let wide = usize::from(rng.random_bool(0.5));
    Cells::rect(plan.size(), low, [a[0].abs_diff(b[0]) + 3 + wide, a[1].abs_diff(b[1]) + 3 + wide])
}

/// Empty cells of gaps and courts that are too small.
fn gap_cells(plan: &Cells) -> Cells {
    let outside = plan.outside();
    let mut narrow = outside.minus(&outside.blocks(super::shape::LEAST_GAP));
    if narrow.is_empty() {
        narrow = outside.minus(&outside.component([0, 0]));
    }
    let mut out = Cells::new(plan.size());
    let margin = Cells::MARGIN;
    narrow.iter().filter(|c| c.iter().all(|&v| v >= margin)).for_each(|[x, y]| out.set([x - margin, y - margin], true));
    out
}
