//! A tree of mutually non-dominated points (ND-tree: Jaszkiewicz, Lust 2018, "ND-Tree-based update: a fast algorithm for the dynamic
//! nondominance problem"): whether a point is covered, and which points it dominates, without looking at all of them.
//!
//! A node knows a lower and an upper corner of its points. Corners are not drawn in when points leave: they stay valid bounds.

use super::dominates;

/// Points in a leaf before it is split.
const LEAF: usize = 20;

/// The tree over points kept by slot: `points(slot)` are the objectives of that slot, all of one length.
#[derive(Clone, Debug, Default)]
pub(super) struct NdTree {
    root: Option<Node>,
}

#[derive(Clone, Debug)]
struct Node {
    low: Vec<f64>,
    high: Vec<f64>,
    inside: Inside,
}

#[derive(Clone, Debug)]
enum Inside {
    Leaf(Vec<usize>),
    Children(Vec<Node>),
}

/// Whether `a` is nowhere worse than `b`.
pub(super) fn covers(a: &[f64], b: &[f64]) -> bool {
    a.iter().zip(b).all(|(x, y)| x <= y)
}

impl NdTree {
    /// Whether some point is nowhere worse than `new`.
    pub fn covers<'p>(&self, new: &[f64], points: &impl Fn(usize) -> &'p [f64]) -> bool {
        self.root.as_ref().is_some_and(|root| root.covers(new, points))
    }

    /// Takes out the points that `new` dominates; their slots go to `out`.
    pub fn remove_dominated<'p>(&mut self, new: &[f64], points: &impl Fn(usize) -> &'p [f64], out: &mut Vec<usize>) {
        if self.root.as_mut().is_some_and(|root| root.remove_dominated(new, points, out)) {
            self.root = None;
        }
    }

    /// Puts a slot in.
    pub fn insert<'p>(&mut self, slot: usize, points: &impl Fn(usize) -> &'p [f64]) {
        match &mut self.root {
            Some(root) => root.insert(slot, points),
            None => self.root = Some(Node::leaf(vec![slot], points)),
        }
    }
}

impl Node {
    fn leaf<'p>(slots: Vec<usize>, points: &impl Fn(usize) -> &'p [f64]) -> Node {
        let (mut low, mut high) = (Vec::new(), Vec::new());
        for &slot in &slots {
            widen(&mut low, &mut high, points(slot));
        }
        Node { low, high, inside: Inside::Leaf(slots) }
    }

    fn covers<'p>(&self, new: &[f64], points: &impl Fn(usize) -> &'p [f64]) -> bool {
        if !covers(&self.low, new) {
            return false;
        }
        match &self.inside {
            Inside::Leaf(slots) => slots.iter().any(|&s| covers(points(s), new)),
            Inside::Children(children) => children.iter().any(|c| c.covers(new, points)),
        }
    }

    /// Returns whether nothing is left.
    fn remove_dominated<'p>(
        &mut self,
        new: &[f64],
        points: &impl Fn(usize) -> &'p [f64],
        out: &mut Vec<usize>,
    ) -> bool {
        if !covers(new, &self.high) {
            return false;
        }
        match &mut self.inside {
            Inside::Leaf(slots) => {
                slots.retain(|&s| {
                    let gone = dominates(new, points(s));
                    if gone {
                        out.push(s);
                    }
                    !gone
                });
                slots.is_empty()
            }
            Inside::Children(children) => {
                children.retain_mut(|c| !c.remove_dominated(new, points, out));
                children.is_empty()
            }
        }
    }

    fn insert<'p>(&mut self, slot: usize, points: &impl Fn(usize) -> &'p [f64]) {
        widen(&mut self.low, &mut self.high, points(slot));
        match &mut self.inside {
            Inside::Leaf(slots) => {
                slots.push(slot);
                if slots.len() > LEAF {
                    self.split(points);
                }
            }
            Inside::Children(children) => {
                let scale = scale(&self.low, &self.high);
                let distance = |c: &Node| -> f64 {
                    let middle = c.low.iter().zip(&c.high).map(|(l, h)| 0.5 * (l + h));
                    apart(points(slot).iter().copied(), middle, &scale)
                };
                let nearest = (0..children.len())
                    .min_by(|&a, &b| distance(&children[a]).total_cmp(&distance(&children[b])))
                    .unwrap_or(0);
                children[nearest].insert(slot, points);
            }
        }
    }

    /// One child more than there are objectives, around points far from each other.
    fn split<'p>(&mut self, points: &impl Fn(usize) -> &'p [f64]) {
        let Inside::Leaf(slots) = &mut self.inside else { return };
        let mut left = std::mem::take(slots);
        let scale = scale(&self.low, &self.high);
        let between = |a: usize, b: usize| apart(points(a).iter().copied(), points(b).iter().copied(), &scale);
        let total = |s: usize, all: &[usize]| all.iter().map(|&o| between(s, o)).sum::<f64>();
        let mut groups: Vec<Vec<usize>> = Vec::new();
        while groups.len() <= self.low.len() && !left.is_empty() {
            let seeds: Vec<usize> = groups.iter().map(|g| g[0]).collect();
            let from = if seeds.is_empty() { &left } else { &seeds };
            let far = (0..left.len()).max_by(|&a, &b| total(left[a], from).total_cmp(&total(left[b], from)));
            groups.push(vec![left.swap_remove(far.unwrap_or(0))]);
        }
        for slot in left {
            let nearest = (0..groups.len())
                .min_by(|&a, &b| between(groups[a][0], slot).total_cmp(&between(groups[b][0], slot)))
                .unwrap_or(0);
            groups[nearest].push(slot);
        }
        self.inside = Inside::Children(groups.into_iter().map(|g| Node::leaf(g, points)).collect());
    }
}

fn widen(low: &mut Vec<f64>, high: &mut Vec<f64>, point: &[f64]) {
    if low.is_empty() {
        low.extend_from_slice(point);
        high.extend_from_slice(point);
    }
    for (i, &v) in point.iter().enumerate() {
        low[i] = low[i].min(v);
        high[i] = high[i].max(v);
    }
}

/// One over the side of a box, so that objectives of any unit count the same.
fn scale(low: &[f64], high: &[f64]) -> Vec<f64> {
    low.iter().zip(high).map(|(l, h)| if h > l { 1.0 / (h - l) } else { 0.0 }).collect()
}

fn apart(a: impl Iterator<Item = f64>, b: impl Iterator<Item = f64>, scale: &[f64]) -> f64 {
    a.zip(b).zip(scale).map(|((x, y), s)| ((x - y) * s).powi(2)).sum()
}
