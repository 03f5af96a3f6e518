//! Clear lengths of sticks between their supports.

use super::types::{HouseFrame, Role, Span};

/// How a role ranks as a support: a stick is held by sticks of a lower rank.
fn rank(role: Role) -> u8 {
    match role {
        Role::Stud | Role::CornerPost | Role::Jamb | Role::BeamPost => 0,
        Role::Plate | Role::Beam | Role::Lintel => 1,
        Role::Hip | Role::Valley | Role::Ridge => 2,
        Role::Joist | Role::Rafter => 3,
        Role::Trimmer | Role::Sill => 4,
    }
}

/// Fills [`HouseFrame::spans`]. A node holds a level stick when a vertical stands under it or a stiffer stick passes that is itself
/// carried by verticals; verticals are held by plates and beams. Sticks end on something unless they project.
pub(super) fn fill(frame: &mut HouseFrame) {
    let (carried, best) = node_supports(frame);
    for (m, member) in frame.members.iter().enumerate() {
        let [a, b] = member.chain;
        if a == b {
            continue;
        }
        let chain = &frame.chains[a as usize..b as usize];
        let own = rank(member.role);
        let holds = |n: u32| {
            let n = n as usize;
            if member.role == Role::BeamPost {
                best[n][1] || best[n][4]
            } else if own == 0 {
                best[n][1]
            } else {
                carried[n] || (2..=4).any(|r| r <= own && best[n][r as usize])
            }
        };
        let last = chain.len() - 1;
        let sound = |i: usize| own != 3 || holds(chain[i]) || best[chain[i] as usize][0];
        let mut from = 0;
        for (i, &node) in chain.iter().enumerate().skip(1) {
            if i == last || holds(node) {
                let held = [from != 0 || sound(0), i != last || sound(last)];
                let elements = [member.first_element + from as u32, member.first_element + i as u32 - 1];
                frame.spans.push(Span { member: m as u32, elements, held });
                from = i;
            }
        }
    }
}

/// Per node: whether a vertical carries it, and `best[r]` whether a stick that holds ranks >= r passes (0: trimmer, 1: any plate or beam,
/// 2: carried plate, beam or lintel, 3: hips and ridges, 4: joists).
fn node_supports(frame: &HouseFrame) -> (Vec<bool>, Vec<[bool; 5]>) {
    let mut carried = vec![false; frame.nodes.len()];
    for &s in &frame.supports {
        carried[s as usize] = true;
    }
    let chain = |c: [u32; 2]| &frame.chains[c[0] as usize..c[1] as usize];
    for m in frame.members.iter().filter(|m| m.role.is_vertical()) {
        chain(m.chain).iter().skip(1).for_each(|&n| carried[n as usize] = true);
    }
    let mut best = vec![[false; 5]; frame.nodes.len()];
    for m in &frame.members {
        let nodes = chain(m.chain);
        let rank = rank(m.role);
        let firm = nodes.iter().filter(|&&n| carried[n as usize]).count() > 1;
        for &n in nodes {
            match rank {
                1 => {
                    best[n as usize][1] = true;
                    best[n as usize][2] |= firm;
                }
                2 => best[n as usize][3] = true,
                3 if m.role == Role::Joist => best[n as usize][4] = true,
                4 if m.role == Role::Trimmer => best[n as usize][0] = true,
                _ => {}
            }
        }
    }
    (carried, best)
}
