//! Railings along the free edges of decks that are walked on.

use super::super::super::{Block, Component};
use super::super::border::{Border, HALF_UM};
use super::super::{Railing, SolidStyle};
use super::deck::{Rim, put, ring};

/// Depth of the hand rail, of posts and base rail, and of panes, from the facade; all about an axis 60 mm inside it.
const RAIL_UM: [i32; 2] = [35_000, 85_000];
const POST_UM: [i32; 2] = [40_000, 80_000];
const PANE_UM: [i32; 2] = [54_000, 66_000];
/// Height of the hand rail's section; foot and head of the base rail above the deck.
const RAIL_HEIGHT_UM: i32 = 40_000;
const BASE_UM: [i32; 2] = [60_000, 90_000];
/// Half the width of a post: posts stand at voxel centres, which are cube faces, half in each cube.
const HALF_POST_UM: i32 = 20_000;
/// Bars: half a side, and the distance between two; the first stands half of it from the middle plane.
const HALF_BAR_UM: i32 = 6_000;
const BAR_STEP_UM: i32 = 112_500;

/// Adds the railing of deck column q, whose surface lies `surface` µm above z = 0.
pub(super) fn build(q: usize, rim: Rim, surface: i32, style: &SolidStyle, blocks: &mut Vec<Block>) {
    let head = surface + style.railing_um;
    let below = head - RAIL_HEIGHT_UM;
    let base = BASE_UM.map(|z| surface + z);
    put(q, rim, Component::RailingRail, RAIL_UM, [below, head], blocks);
    // What stands below the hand rail leaves room for posts: half a one at the cube face, a whole one at an outer corner.
    let mut along = |component: Component, depth: [i32; 2], z: [i32; 2]| {
        for (border, mut polygon) in ring(q, rim, depth) {
            match rim {
                Rim::Concave | Rim::None => {}
                Rim::Straight(_) | Rim::Convex => {
                    for p in &mut polygon {
                        if p[1] == HALF_UM {
                            p[1] -= HALF_POST_UM;
                        } else if rim == Rim::Convex {
                            p[1] = POST_UM[1];
                        }
                    }
                }
            }
            blocks.extend(border.prism(component, q, &polygon, |_| z));
        }
    };
    along(Component::RailingRail, POST_UM, base);
    if style.railing == Railing::Glass {
        along(Component::RailingGlass, PANE_UM, [base[1], below]);
    }
    let mut upright = |axis: usize, depth: [i32; 2], aside: [i32; 2], z: [i32; 2]| {
        blocks.extend(Border { q, axis }.cuboid(Component::RailingRail, q, depth, aside, z));
    };
    let bar = |middle: i32| [middle - HALF_BAR_UM, middle + HALF_BAR_UM];
    match rim {
        Rim::None => {}
        // One bar holds the inner corner.
        Rim::Concave => {
            if style.railing == Railing::Bars {
                upright(0, PANE_UM, PANE_UM, [base[1], below]);
            }
        }
        Rim::Straight(_) | Rim::Convex => {
            let axes = if let Rim::Straight(axis) = rim { axis..axis + 1 } else { 0..2 };
            for axis in axes {
                upright(axis, POST_UM, [HALF_UM - HALF_POST_UM, HALF_UM], [surface, below]);
                if style.railing == Railing::Bars {
                    for n in 0..4 {
                        let at = bar(BAR_STEP_UM / 2 + n * BAR_STEP_UM);
                        if rim != Rim::Convex || at[0] > POST_UM[1] {
                            upright(axis, PANE_UM, at, [base[1], below]);
                        }
                    }
                }
            }
            if rim == Rim::Convex {
                upright(0, POST_UM, POST_UM, [surface, below]);
            }
        }
    }
}
