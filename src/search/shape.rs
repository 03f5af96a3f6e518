//! Plan rules: what a footprint, and a footprint on another, must be (HOUSE.md section 2, points 1, 2, 6 and 7).

use super::cells::Cells;
use super::massing::Roof;
use crate::voxels::{Direction, LINING_M, STOREY_MODULES};

/// Why a massing would break a rule, or cannot be completed to a house.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Cause {
    /// Room outside the buildable cells, or in cells that must stay empty.
    Plot,
    /// A given cell is not filled.
    Given,
    /// More or fewer storeys than plot and programme allow.
    Storeys,
    /// Not a union of 3 x 3 blocks, or less than 60 % of it in 4 x 4 blocks.
    Blocks,
    /// Cells touch at a corner only, so that a cube would be inadmissible.
    Diagonal,
    /// The rooms of a storey do not hang together by a passage of one clear module.
    Passage,
    /// A gap narrower than three modules, or a court smaller than 4 x 4.
    Gap,
    /// A cantilever over two modules, or without twice its length behind it.
    Cantilever,
    /// A deck that cannot drain over a free edge.
    Drain,
    /// Higher than three times the least width.
    Slender,
    /// The programme asks for a pitched roof and none fits.
    Roof,
    /// No place for a stair.
    Stair,
    /// No place for the doors that the programme asks for.
    Entrance,
    /// The glazing ratio cannot be met in some storey, or windows look one way only.
    Glazing,
    /// Net floor area out of the programme's range.
    Area,
}

impl Cause {
    /// All causes, in the order in which they are checked.
    pub const ALL: [Cause; 15] = [
        Cause::Storeys,
        Cause::Plot,
        Cause::Given,
        Cause::Blocks,
        Cause::Diagonal,
        Cause::Passage,
        Cause::Gap,
        Cause::Cantilever,
        Cause::Drain,
        Cause::Slender,
        Cause::Roof,
        Cause::Stair,
        Cause::Entrance,
        Cause::Glazing,
        Cause::Area,
    ];

    /// Short name for tables.
    pub fn name(self) -> &'static str {
        match self {
            Cause::Plot => "plot",
            Cause::Given => "given",
            Cause::Storeys => "storeys",
            Cause::Blocks => "blocks",
            Cause::Diagonal => "diagonal",
            Cause::Passage => "passage",
            Cause::Gap => "gap",
            Cause::Cantilever => "cantilever",
            Cause::Drain => "drain",
            Cause::Slender => "slender",
            Cause::Roof => "roof",
            Cause::Stair => "stair",
            Cause::Entrance => "entrance",
            Cause::Glazing => "glazing",
            Cause::Area => "area",
        }
    }
}

/// Share of a footprint that must lie in 4 x 4 blocks, as a fraction 3/5.
const WIDE_SHARE: (usize, usize) = (3, 5);
/// Narrowest gap between two parts of a storey, modules: also the free view that a window needs.
pub const LEAST_GAP: usize = 3;
/// Least court, modules.
const LEAST_COURT: usize = 4;
/// Longest cantilever, modules.
const LONGEST_CANTILEVER: isize = 2;

/// Checks one footprint by itself.
pub fn check_plan(plan: &Cells) -> Result<(), Cause> {
    if plan.is_empty() || plan.blocks(3) != *plan || plan.blocks(4).count() * WIDE_SHARE.1 < plan.count() * WIDE_SHARE.0
    {
        return Err(Cause::Blocks);
    }
    if plan.touches_diagonally() {
        return Err(Cause::Diagonal);
    }
    if !plan.inner().is_connected() {
        return Err(Cause::Passage);
    }
    check_gaps(plan)
}

/// Empty cells form gaps of three modules or more; those that do not reach the open are courts of 4 x 4 or more.
fn check_gaps(plan: &Cells) -> Result<(), Cause> {
    let outside = plan.outside();
    if outside.blocks(LEAST_GAP) != outside {
        return Err(Cause::Gap);
    }
    let courts = outside.minus(&outside.component([0, 0]));
    if !courts.is_empty() && courts.blocks(LEAST_COURT) != courts {
        return Err(Cause::Gap);
    }
    Ok(())
}

/// Checks a footprint on the one underneath; `standing` are the cells filled in every storey below, which alone carry a
/// cantilever.
pub fn check_pair(lower: &Cells, upper: &Cells, standing: &Cells) -> Result<(), Cause> {
    if lower.or(upper).touches_diagonally() {
        return Err(Cause::Diagonal);
    }
    let hanging = upper.minus(lower);
    if hanging.iter().any(|cell| !is_carried(cell, upper, lower, standing)) {
        return Err(Cause::Cantilever);
    }
    let deck = lower.minus(upper);
    if deck_is_enclosed(&deck, &lower.or(upper)) {
        return Err(Cause::Drain);
    }
    Ok(())
}

/// Whether a hanging cell is carried along some direction: at most two modules out, with twice that on the storey below.
fn is_carried([x, y]: [usize; 2], upper: &Cells, lower: &Cells, standing: &Cells) -> bool {
    Direction::ALL.iter().any(|d| {
        let [dx, dy] = d.step();
        let at = |n: isize| [x as isize + n * dx, y as isize + n * dy];
        let hangs = |n: isize| upper.has(at(n)) && !lower.has(at(n));
        let inwards = (1..=LONGEST_CANTILEVER).find(|&n| !hangs(n)).unwrap_or(LONGEST_CANTILEVER + 1);
        let outwards = (1..=LONGEST_CANTILEVER).take_while(|&n| hangs(-n)).count() as isize;
        let length = inwards + outwards;
        length <= LONGEST_CANTILEVER && (inwards..inwards + 2 * length).all(|n| upper.has(at(n)) && standing.has(at(n)))
    })
}

/// Whether some part of a deck touches no free edge: all around it the storey above rises.
fn deck_is_enclosed(deck: &Cells, filled: &Cells) -> bool {
    let mut rest = deck.clone();
    while let Some(seed) = rest.first() {
        let part = rest.component(seed);
        let free = part.iter().any(|[x, y]| {
            Direction::ALL.iter().any(|d| {
                let [dx, dy] = d.step();
                !filled.has([x as isize + dx, y as isize + dy])
            })
        });
        if !free {
            return true;
        }
        rest = rest.minus(&part);
    }
    false
}

/// The steepest roof at most `roof` that the top storey can carry: no step touches itself at a corner, no step is empty,
/// no cell that must stay empty is roofed over, and the roof stays under `layers` free layers.
pub fn fit_roof(top: &Cells, roof: Roof, layers: usize, keep_free: Option<&Cells>) -> Roof {
    let Roof::Hip(rise) = roof else { return Roof::Flat };
    let blocked = keep_free.is_some_and(|free| free.meets(top));
    let mut layer = top.clone();
    let mut fits = 0;
    for _ in 0..rise.min(Roof::STEEPEST).min(layers.min(u8::MAX as usize) as u8) {
        if blocked || layer.is_empty() || layer.touches_diagonally() {
            break;
        }
        fits += 1;
        layer = layer.inner();
    }
    if fits == 0 { Roof::Flat } else { Roof::Hip(fits) }
}

/// Whether the least width of the base, times three, reaches the top of the house.
pub fn is_stable_width(base: &Cells, storeys: usize, roof: Roof) -> bool {
    let height_m = ((storeys * STOREY_MODULES + roof.rise()) as f64 + 0.5) * 0.54;
    least_width(base) as f64 * 0.9 * 3.0 >= height_m
}

/// Shortest run of cells along x or y.
fn least_width(plan: &Cells) -> usize {
    let fits = |k: usize| {
        let [nx, ny] = plan.size();
        (0..ny).all(|y| runs((0..nx).map(|x| plan.has([x as isize, y as isize]))).all(|r| r >= k))
            && (0..nx).all(|x| runs((0..ny).map(|y| plan.has([x as isize, y as isize]))).all(|r| r >= k))
    };
    (1..=plan.size()[0].max(plan.size()[1])).take_while(|&k| fits(k)).last().unwrap_or(0)
}

fn runs(line: impl Iterator<Item = bool>) -> impl Iterator<Item = usize> {
    let mut line = line.chain([false]);
    std::iter::from_fn(move || {
        let mut length = 0;
        for filled in line.by_ref() {
            match (filled, length) {
                (true, _) => length += 1,
                (false, 0) => {}
                (false, _) => return Some(length),
            }
        }
        None
    })
}

/// Net floor area of a footprint in m2, inside the lining: A - t P + 4 t^2 for a right-angled outline of perimeter P, and
/// `lost` cells less for stairs and their openings.
pub fn net_area_m2(plan: &Cells, lost: usize) -> f64 {
    let (cells, edges) = (plan.count() as f64, plan.perimeter() as f64);
    (cells - lost as f64) * 0.81 - edges * 0.9 * LINING_M + 4.0 * LINING_M * LINING_M
}

#[cfg(test)]
mod tests {
    use super::*;

    const SIZE: [usize; 2] = [12, 12];

    fn rect(x: isize, y: isize, w: usize, h: usize) -> Cells {
        Cells::rect(SIZE, [x, y], [w, h])
    }

    fn on(lower: &Cells, upper: &Cells) -> Result<(), Cause> {
        check_pair(lower, upper, lower)
    }

    #[test]
    fn blocks_and_passages() {
        assert_eq!(check_plan(&rect(2, 2, 4, 4)), Ok(()));
        assert_eq!(check_plan(&rect(2, 2, 3, 9)), Err(Cause::Blocks)); // nowhere four wide
        assert_eq!(check_plan(&rect(2, 2, 2, 9)), Err(Cause::Blocks));
        assert_eq!(check_plan(&rect(0, 0, 4, 4).or(&rect(4, 4, 4, 4))), Err(Cause::Diagonal));
        assert_eq!(check_plan(&rect(0, 0, 4, 4).or(&rect(4, 3, 4, 4))), Err(Cause::Passage));
        assert_eq!(check_plan(&rect(0, 0, 4, 4).or(&rect(4, 1, 4, 4))), Ok(()));
    }

    #[test]
    fn gaps_and_courts() {
        let u = |gap: usize| rect(0, 0, 8 + gap, 4).or(&rect(0, 0, 4, 10)).or(&rect(4 + gap as isize, 0, 4, 10));
        assert_eq!(check_plan(&u(2)), Err(Cause::Gap));
        assert_eq!(check_plan(&u(3)), Ok(()));
        let court = |k: usize| rect(0, 0, 6 + k, 6 + k).minus(&rect(3, 3, k, k)).or(&rect(0, 0, 4, 4));
        assert_eq!(check_plan(&court(3)), Err(Cause::Blocks));
        let court = |k: usize| rect(0, 0, 12, 12).minus(&rect(4, 4, k, k));
        assert_eq!(check_plan(&court(3)), Err(Cause::Gap));
        assert_eq!(check_plan(&court(4)), Ok(()));
    }

    #[test]
    fn cantilevers_need_twice_their_length_behind() {
        let base = rect(4, 0, 4, 4);
        assert_eq!(on(&base, &rect(2, 0, 6, 4)), Ok(()));
        assert_eq!(on(&base, &rect(1, 0, 7, 4)), Err(Cause::Cantilever)); // three out
        assert_eq!(on(&rect(4, 0, 3, 4), &rect(2, 0, 5, 4)), Err(Cause::Cantilever)); // three behind two
        assert_eq!(on(&rect(4, 0, 3, 4), &rect(3, 0, 4, 4)), Ok(()));
        let corner = rect(4, 4, 4, 4);
        assert_eq!(on(&corner, &rect(3, 3, 5, 5)), Err(Cause::Cantilever)); // the corner cell hangs on nothing
    }

    #[test]
    fn a_cantilever_rests_on_what_stands_on_the_ground() {
        let (ground, hanging) = (rect(4, 0, 4, 4), rect(2, 0, 6, 4));
        let top = rect(1, 0, 7, 4);
        assert_eq!(check_pair(&hanging, &top, &hanging), Ok(()));
        assert_eq!(check_pair(&hanging, &top, &hanging.and(&ground)), Err(Cause::Cantilever));
    }

    #[test]
    fn decks_drain() {
        let base = rect(0, 0, 12, 12);
        assert_eq!(on(&base, &base.minus(&rect(4, 4, 4, 4))), Err(Cause::Drain));
        assert_eq!(on(&base, &base.minus(&rect(4, 0, 4, 8))), Ok(()));
    }

    #[test]
    fn roofs_stop_where_they_run_out_of_width() {
        assert_eq!(fit_roof(&rect(0, 0, 4, 9), Roof::Hip(4), 9, None), Roof::Hip(2));
        assert_eq!(fit_roof(&rect(0, 0, 9, 9), Roof::Hip(4), 9, None), Roof::Hip(4));
        assert_eq!(fit_roof(&rect(0, 0, 9, 9), Roof::Hip(4), 3, None), Roof::Hip(3));
        assert_eq!(fit_roof(&rect(0, 0, 9, 9), Roof::Hip(4), 3, Some(&rect(8, 8, 1, 1))), Roof::Flat);
        let step = rect(0, 0, 4, 4).or(&rect(1, 1, 4, 4));
        assert_eq!(fit_roof(&step, Roof::Hip(4), 9, None), Roof::Hip(2));
    }

    #[test]
    fn net_area_of_rectangle_and_court_follow_the_offset() {
        // 4 x 4 modules: (3.6 - 0.6)^2 = 9 m2
        assert!((net_area_m2(&rect(0, 0, 4, 4), 0) - 9.0).abs() < 1e-12);
        assert_eq!(least_width(&rect(0, 0, 4, 9).or(&rect(0, 0, 9, 5))), 4);
        assert!(
            is_stable_width(&rect(0, 0, 4, 4), 3, Roof::Flat) && !is_stable_width(&rect(0, 0, 3, 4), 3, Roof::Flat)
        );
    }
}
