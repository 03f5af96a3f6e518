//! Fronts under constraint domination, and crowding within a front (Deb, Pratap, Agarwal, Meyarivan 2002).

use super::Score;

/// Fast non-dominated sort under constraint domination: indices front by front, ascending within a front.
pub fn sort_fronts(scores: &[&Score]) -> Vec<Vec<usize>> {
    let n = scores.len();
    let mut beaten_by = vec![0usize; n];
    let mut beats: Vec<Vec<usize>> = vec![Vec::new(); n];
    for i in 0..n {
        for j in 0..i {
            if scores[i].dominates(scores[j]) {
                beats[i].push(j);
                beaten_by[j] += 1;
            } else if scores[j].dominates(scores[i]) {
                beats[j].push(i);
                beaten_by[i] += 1;
            }
        }
    }
    let mut fronts = Vec::new();
    let mut front: Vec<usize> = (0..n).filter(|&i| beaten_by[i] == 0).collect();
    while !front.is_empty() {
        let mut next = Vec::new();
        for &i in &front {
            for &j in &beats[i] {
                beaten_by[j] -= 1;
                if beaten_by[j] == 0 {
                    next.push(j);
                }
            }
        }
        next.sort_unstable();
        fronts.push(std::mem::replace(&mut front, next));
    }
    fronts
}

/// Crowding distance within one front: the normalised side lengths of the box between neighbours, infinite at the ends.
/// Entries without objectives have none.
pub fn crowding(front: &[&Score]) -> Vec<f64> {
    let mut distance = vec![0.0; front.len()];
    let objectives = front.iter().map(|s| s.objectives.len()).min().unwrap_or(0);
    let mut order: Vec<usize> = (0..front.len()).collect();
    for m in 0..objectives {
        let value = |i: usize| front[i].objectives[m];
        order.sort_by(|&a, &b| value(a).total_cmp(&value(b)).then(a.cmp(&b)));
        let (first, last) = (order[0], order[order.len() - 1]);
        let range = value(last) - value(first);
        distance[first] = f64::INFINITY;
        distance[last] = f64::INFINITY;
        if range > 0.0 {
            order.windows(3).for_each(|w| distance[w[1]] += (value(w[2]) - value(w[0])) / range);
        }
    }
    distance
}
