//! Every footprint of a plot, and every stack of them.

use super::TooLarge;
use crate::search::cells::Cells;
use crate::search::plot::Space;
use crate::search::shape::{check_pair, check_plan};
use crate::search::symmetry::Symmetry;
use rustc_hash::FxHashSet;

/// Every footprint that keeps the plan rules, in order. A footprint is a union of 3 x 3 blocks, so unions of blocks are all there is to
/// look at.
///
/// # Errors
/// More than `most` unions.
pub fn footprints(space: &Space, most: usize) -> Result<Vec<Cells>, TooLarge> {
    let size = space.plot.size();
    let storeys = space.most_storeys();
    let mut buildable = Cells::new(size);
    (0..storeys).for_each(|s| buildable = buildable.or(&space.plot.allowed(s)));
    let mut unions: FxHashSet<Cells> = FxHashSet::default();
    unions.insert(Cells::new(size));
    for y in 0..(size[1] + 1).saturating_sub(3) {
        for x in 0..(size[0] + 1).saturating_sub(3) {
            let block = Cells::rect(size, [x as isize, y as isize], [3, 3]);
            if !buildable.contains(&block) {
                continue;
            }
            let grown: Vec<Cells> = unions.iter().map(|u| u.or(&block)).collect();
            unions.extend(grown);
            if unions.len() > most {
                return Err(TooLarge { what: "unions of 3 x 3 blocks of the plot", most });
            }
        }
    }
    let mut plans: Vec<Cells> = unions.into_iter().filter(|plan| check_plan(plan).is_ok()).collect();
    plans.sort_unstable();
    Ok(plans)
}

/// Every stack of footprints that a house may have, from the ground up.
///
/// # Errors
/// More than `most`.
pub fn stacks(space: &Space, plans: &[Cells], most: usize) -> Result<Vec<Vec<Cells>>, TooLarge> {
    let fits = |s: usize, plan: &Cells| {
        space.plot.allowed(s).contains(plan) && space.plot.must_fill(s).is_none_or(|given| plan.contains(given))
    };
    let mut whole = Vec::new();
    let mut open: Vec<Vec<Cells>> = plans.iter().filter(|p| fits(0, p)).map(|p| vec![p.clone()]).collect();
    for count in 1..=space.most_storeys() {
        if count >= space.least_storeys() {
            whole.extend(open.iter().cloned());
        }
        let mut higher = Vec::new();
        if count < space.most_storeys() {
            for stack in &open {
                let standing = stack.iter().skip(1).fold(stack[0].clone(), |all, plan| all.and(plan));
                for plan in plans.iter().filter(|p| fits(count, p)) {
                    if check_pair(&stack[count - 1], plan, &standing).is_ok() {
                        higher.push(stack.iter().chain([plan]).cloned().collect());
                    }
                }
            }
        }
        open = higher;
        if whole.len().max(open.len()) > most {
            return Err(TooLarge { what: "stacks of footprints", most });
        }
    }
    Ok(whole)
}

/// Of stacks that are the same but for their place on the plot, the first; of single storeys also of those that are images of each other.
/// Higher stacks keep their images: stairs have a hand, and a mirrored one may not exist.
pub fn distinct(stacks: Vec<Vec<Cells>>, symmetries: &[Symmetry]) -> Vec<Vec<Cells>> {
    let mut seen: FxHashSet<Vec<Cells>> = FxHashSet::default();
    let known = |stack: &Vec<Cells>| {
        let images = if stack.len() == 1 { symmetries } else { &[Symmetry::IDENTITY] };
        images.iter().map(|s| cornered(stack.iter().map(|plan| s.cells(plan)).collect())).min().unwrap_or_default()
    };
    stacks.into_iter().filter(|stack| seen.insert(known(stack))).collect()
}

/// A stack moved to the smallest corner of the plot.
fn cornered(stack: Vec<Cells>) -> Vec<Cells> {
    let Some(first) = stack.first() else { return stack };
    let all = stack.iter().fold(first.clone(), |all, plan| all.or(plan));
    let ([x, y], _) = all.bounds().unwrap_or_default();
    stack.iter().map(|plan| plan.shifted([-(x as isize), -(y as isize)])).collect()
}
