//! Connections: where sticks meet, and how many of them one drawing makes.

use rustc_hash::FxHashSet;

use super::{HouseFrame, Role};

/// A stick at a node as a number: role, group, plies, whether it is hinged there, and the direction it leaves in.
type Arm = (u32, [i8; 3]);

/// Buffers of [`distinct_joints`].
#[derive(Clone, Debug, Default)]
pub struct JointScratch {
    first: Vec<u32>,
    arms: Vec<Arm>,
    sticks: Vec<u32>,
    held: Vec<bool>,
    turned: Vec<Arm>,
    least: Vec<Arm>,
    seen: FxHashSet<Vec<Arm>>,
    kinds: FxHashSet<Vec<Arm>>,
}

/// Number of distinct connections of a frame: nodes where sticks meet or stand on the foundation, told apart by the sticks that meet there
/// (role, the choice that sets their section, plies, hinge) and the directions they leave in to a hundredth, up to quarter turns and mirror
/// images in plan. A node that only divides a stick is none. The same for a house turned or mirrored.
pub fn distinct_joints(frame: &HouseFrame, scratch: &mut JointScratch) -> usize {
    sort_by_node(frame, scratch);
    let JointScratch { first, arms, sticks, held, turned, least, seen, kinds } = scratch;
    seen.clear();
    kinds.clear();
    held.clear();
    held.resize(frame.nodes.len(), false);
    frame.supports.iter().for_each(|&n| held[n as usize] = true);
    for node in 0..frame.nodes.len() {
        let range = first[node] as usize..first[node + 1] as usize;
        // A node that only divides a stick is no connection.
        if range.is_empty() || (!held[node] && sticks[range.clone()].iter().all(|&m| m == sticks[range.start])) {
            continue;
        }
        let here = &mut arms[range];
        here.sort_unstable();
        if seen.contains(&*here) {
            continue;
        }
        seen.insert(here.to_vec());
        least.clear();
        for symmetry in 0..8u8 {
            turned.clear();
            turned.extend(here.iter().map(|&(kind, direction)| (kind, image(direction, symmetry))));
            turned.sort_unstable();
            if symmetry == 0 || *turned < *least {
                std::mem::swap(turned, least);
            }
        }
        if !kinds.contains(&*least) {
            kinds.insert(least.clone());
        }
    }
    kinds.len()
}

/// Lays out the arms of all elements node by node: those of node n are `arms[first[n]..first[n + 1]]`.
fn sort_by_node(frame: &HouseFrame, scratch: &mut JointScratch) {
    let JointScratch { first, arms, sticks, .. } = scratch;
    first.clear();
    first.resize(frame.nodes.len() + 2, 0);
    let ends = || frame.elements.iter().flat_map(|e| [(e, 0), (e, 1)]);
    ends().for_each(|(e, end)| first[e.nodes[end] as usize + 2] += 1);
    (2..first.len()).for_each(|n| first[n] += first[n - 1]);
    arms.clear();
    arms.resize(2 * frame.elements.len(), (0, [0; 3]));
    sticks.clear();
    sticks.resize(2 * frame.elements.len(), 0);
    for (element, end) in ends() {
        let [from, to] = [element.nodes[end], element.nodes[1 - end]].map(|n| frame.nodes[n as usize]);
        let length = super::types::distance(from, to);
        let direction = [0, 1, 2].map(|k| (100.0 * (to[k] - from[k]) / length).round() as i8);
        let member = &frame.members[element.member as usize];
        let kind = kind_code(member.role, member.group as u32, member.plies, element.hinged[end]);
        let place = &mut first[element.nodes[end] as usize + 1];
        arms[*place as usize] = (kind, direction);
        sticks[*place as usize] = element.member;
        *place += 1;
    }
}

fn kind_code(role: Role, group: u32, plies: u8, hinged: bool) -> u32 {
    (role as u32) << 16 | group << 12 | u32::from(plies) << 4 | u32::from(hinged)
}

/// A direction under one of the eight symmetries of a square in plan.
fn image([x, y, z]: [i8; 3], symmetry: u8) -> [i8; 3] {
    let [x, y] = if symmetry & 4 == 0 { [x, y] } else { [y, x] };
    [if symmetry & 1 == 0 { x } else { -x }, if symmetry & 2 == 0 { y } else { -y }, z]
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use super::*;
    use crate::frame::{Element, FrameMember, FrameWorkspace, build};
    use crate::voxels::{Choice, Choices, read_storeys, samples};

    fn frame(nodes: &[[f64; 3]], sticks: &[(Role, &[u32])], supports: &[u32]) -> HouseFrame {
        let mut frame = HouseFrame { nodes: nodes.to_vec(), supports: supports.to_vec(), ..HouseFrame::default() };
        for (n, (role, chain)) in sticks.iter().enumerate() {
            for pair in chain.windows(2) {
                frame.elements.push(Element { nodes: [pair[0], pair[1]], member: n as u32, hinged: [false; 2] });
            }
            frame.members.push(FrameMember {
                role: *role,
                group: Choice::Wall,
                chain: [0; 2],
                first_element: 0,
                length_m: 1.0,
                plies: 1,
                reference: None,
                facades: 0,
                ends: [[0.0; 3]; 2],
            });
        }
        frame
    }

    /// A portal of two posts and a beam in two pieces: feet alike, corners mirror images, the node in the beam's middle none. A post under
    /// the middle makes a third kind; one on the left alone would make a foot of the same kind and another corner.
    #[test]
    fn a_portal_has_two_kinds_of_joints() {
        let nodes =
            [[0.0, 0.0, 0.0], [4.0, 0.0, 0.0], [0.0, 0.0, 3.0], [4.0, 0.0, 3.0], [2.0, 0.0, 3.0], [2.0, 0.0, 0.0]];
        let posts: [(Role, &[u32]); 2] = [(Role::BeamPost, &[0, 2]), (Role::BeamPost, &[1, 3])];
        let beam: (Role, &[u32]) = (Role::Beam, &[2, 4, 3]);
        let count = |sticks: &[(Role, &[u32])], supports: &[u32]| {
            distinct_joints(&frame(&nodes, sticks, supports), &mut JointScratch::default())
        };
        assert_eq!(count(&[posts[0], posts[1], beam], &[0, 1]), 2);
        assert_eq!(count(&[posts[0], posts[1], beam, (Role::BeamPost, &[5, 4])], &[0, 1, 5]), 3);
        assert_eq!(
            count(&[posts[0], (Role::Stud, &[1, 3]), beam], &[0, 1]),
            4,
            "another role, another foot and corner"
        );
        assert_eq!(count(&[beam], &[]), 0);
    }

    /// Counted slowly, and on all eight images of the house.
    #[test]
    fn houses_turned_and_mirrored_have_the_same_joints() {
        let mut workspace = FrameWorkspace::default();
        let mut scratch = JointScratch::default();
        let tiles = crate::tiles::LinearTileset::load(
            &std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("tilesets/linear"),
        )
        .expect("the shipped tileset");
        for (name, house) in samples::all() {
            let lines = |mask: u8| tiles.lines(crate::cubes::Mask(mask));
            let frame = build(&house, &read_storeys(&house), &Choices::default(), lines, &mut workspace).expect(name);
            let found = distinct_joints(&frame, &mut scratch);
            assert_eq!(found, slowly(&frame), "{name}");
            assert!(found > 5 && found < frame.nodes.len() / 2, "{name}: {found} of {} nodes", frame.nodes.len());
            for symmetry in 1..8u8 {
                let mut image = frame.clone();
                for [x, y, _] in &mut image.nodes {
                    if symmetry & 4 != 0 {
                        std::mem::swap(x, y);
                    }
                    *x *= if symmetry & 1 != 0 { -1.0 } else { 1.0 };
                    *y *= if symmetry & 2 != 0 { -1.0 } else { 1.0 };
                }
                assert_eq!(distinct_joints(&image, &mut scratch), found, "{name} {symmetry}");
            }
        }
    }

    fn slowly(frame: &HouseFrame) -> usize {
        let mut kinds = BTreeSet::new();
        for node in 0..frame.nodes.len() as u32 {
            let here: Vec<&Element> = frame.elements.iter().filter(|e| e.nodes.contains(&node)).collect();
            let sticks: BTreeSet<u32> = here.iter().map(|e| e.member).collect();
            if here.is_empty() || (sticks.len() == 1 && !frame.supports.contains(&node)) {
                continue;
            }
            let images = (0..8u8).map(|symmetry| {
                let mut arms: Vec<String> = here
                    .iter()
                    .map(|e| {
                        let end = usize::from(e.nodes[1] == node);
                        let [a, b] = [e.nodes[end], e.nodes[1 - end]].map(|n| frame.nodes[n as usize]);
                        let length = (0..3).map(|k| (b[k] - a[k]).powi(2)).sum::<f64>().sqrt();
                        let mut d = [0, 1, 2].map(|k| (100.0 * (b[k] - a[k]) / length).round() as i64);
                        if symmetry & 1 != 0 {
                            d[0] = -d[0];
                        }
                        if symmetry & 2 != 0 {
                            d[1] = -d[1];
                        }
                        if symmetry & 4 != 0 {
                            d.swap(0, 1);
                        }
                        let m = &frame.members[e.member as usize];
                        format!("{:?} {:?} {} {} {d:?}", m.role, m.group, m.plies, e.hinged[end])
                    })
                    .collect();
                arms.sort();
                arms.join(";")
            });
            kinds.insert(images.min());
        }
        kinds.len()
    }
}
