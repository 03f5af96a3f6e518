//! Groups of things by their distances: k-medoids.
//!
//! k-medoids (Kaufman and Rousseeuw 1990, chapter 2: BUILD, then SWAP while it helps) rather than a linkage: the middle of each group is
//! one of its own things, which can be shown; any distance will do; and with ties going to the smaller index it has no chance in it. The
//! number of groups is that of the largest mean silhouette width (Rousseeuw 1987) among three and more, if what that says of the structure
//! is the same word as for two: two groups of a front say little.

/// Groups at most: people compare about four things.
pub const MOST: usize = 6;

/// Mean silhouette width up to which there is no structure to speak of (Kaufman and Rousseeuw 1990, table 4): everything is one group.
pub const NO_STRUCTURE: f64 = 0.25;

/// Things that are grouped at most; of more, evenly many are, and the rest joins the nearest medoid.
const GROUPED: usize = 400;

/// Groups of things.
#[derive(Clone, Debug, PartialEq)]
pub struct Clusters {
    /// The thing in the middle of each group, ascending.
    pub medoids: Vec<usize>,
    /// The group of each thing.
    pub of: Vec<usize>,
    /// Mean silhouette width of the things that were grouped, -1 to 1; 0 where all are one group.
    pub silhouette: f64,
}

impl Clusters {
    /// The things of a group, its medoid first.
    pub fn members(&self, group: usize) -> Vec<usize> {
        let medoid = self.medoids[group];
        let others = (0..self.of.len()).filter(|&i| self.of[i] == group && i != medoid);
        std::iter::once(medoid).chain(others).collect()
    }

    /// What its silhouette width says of how real the groups are (Kaufman and Rousseeuw 1990, table 4).
    pub fn structure(&self) -> &'static str {
        structure(self.silhouette)
    }
}

fn structure(silhouette: f64) -> &'static str {
    match silhouette {
        s if s > 0.70 => "strong",
        s if s > 0.50 => "reasonable",
        s if s > NO_STRUCTURE => "weak",
        _ => "none",
    }
}

/// Groups `count` things by their distances (symmetric, 0 to itself).
pub fn clusters(count: usize, between: &dyn Fn(usize, usize) -> f64) -> Clusters {
    let step = count.div_ceil(GROUPED).max(1);
    let sample: Vec<usize> = (0..count).step_by(step).collect();
    let table = Table::new(sample.len(), &|a, b| between(sample[a], sample[b]));
    let most = MOST.min(sample.len().saturating_sub(1));
    let mut tried: Vec<(f64, Vec<usize>)> = Vec::new();
    for k in 2..=most {
        let medoids = table.medoids(k);
        tried.push((table.silhouette(&medoids), medoids));
    }
    let widest = |from: usize| {
        let rest = tried.iter().skip(from);
        rest.fold(None, |best: Option<&(f64, Vec<usize>)>, one| match best {
            Some(b) if one.0 <= b.0 + 1e-9 => best,
            _ => Some(one),
        })
    };
    let several = widest(1).filter(|s| widest(0).is_some_and(|all| structure(all.0) == structure(s.0)));
    let best = several.or(widest(0)).filter(|b| b.0 > NO_STRUCTURE).cloned();
    let best = best.unwrap_or_else(|| (0.0, table.medoids(1)));
    let mut medoids: Vec<usize> = best.1.into_iter().map(|m| sample[m]).collect();
    medoids.sort_unstable();
    let nearest =
        |i: usize| (0..medoids.len()).min_by(|&a, &b| between(i, medoids[a]).total_cmp(&between(i, medoids[b])));
    // A medoid whose twin is another medoid stays in its own group.
    let group = |i: usize| medoids.iter().position(|m| *m == i).or_else(|| nearest(i)).unwrap_or(0);
    let of = (0..count).map(group).collect();
    Clusters { silhouette: best.0, medoids, of }
}

/// Distances of all pairs.
struct Table {
    count: usize,
    cells: Vec<f64>,
}

impl Table {
    fn new(count: usize, between: &dyn Fn(usize, usize) -> f64) -> Table {
        Table { count, cells: (0..count * count).map(|c| between(c / count, c % count)).collect() }
    }

    fn at(&self, a: usize, b: usize) -> f64 {
        self.cells[a * self.count + b]
    }

    /// Sum of the distances of all things to their nearest medoid.
    fn cost(&self, medoids: &[usize]) -> f64 {
        (0..self.count).map(|i| medoids.iter().map(|&m| self.at(i, m)).fold(f64::INFINITY, f64::min)).sum()
    }

    fn medoids(&self, k: usize) -> Vec<usize> {
        let mut chosen: Vec<usize> = Vec::new();
        while chosen.len() < k.min(self.count) {
            let with = |i: usize| self.cost(&[&chosen[..], &[i]].concat());
            let free = (0..self.count).filter(|i| !chosen.contains(i)).map(|i| (with(i), i));
            chosen.extend(free.min_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1))).map(|f| f.1));
        }
        let mut cost = self.cost(&chosen);
        while let Some((less, place, thing)) = self.best_swap(&chosen).filter(|s| s.0 < cost - 1e-12) {
            cost = less;
            chosen[place] = thing;
        }
        chosen
    }

    /// The swap of a medoid for another thing that leaves the least cost: that cost, the medoid's place, and the thing.
    fn best_swap(&self, medoids: &[usize]) -> Option<(f64, usize, usize)> {
        let ranked: Vec<[f64; 2]> = (0..self.count).map(|i| self.two_nearest(i, medoids)).collect();
        let swap = |place: usize, thing: usize| -> f64 {
            let cost = |i: usize| {
                let [first, second] = ranked[i];
                let left = if self.at(i, medoids[place]) <= first { second } else { first };
                left.min(self.at(i, thing))
            };
            (0..self.count).map(cost).sum()
        };
        let things = (0..self.count).filter(|i| !medoids.contains(i));
        let swaps = things.flat_map(|thing| (0..medoids.len()).map(move |place| (place, thing)));
        let priced = swaps.map(|(place, thing)| (swap(place, thing), place, thing));
        priced.min_by(|a, b| a.0.total_cmp(&b.0).then((a.1, a.2).cmp(&(b.1, b.2))))
    }

    /// Distances to the nearest and the second nearest medoid.
    fn two_nearest(&self, i: usize, medoids: &[usize]) -> [f64; 2] {
        medoids.iter().map(|&m| self.at(i, m)).fold(
            [f64::INFINITY; 2],
            |[a, b], d| {
                if d < a { [d, a] } else { [a, b.min(d)] }
            },
        )
    }

    /// Mean silhouette width: of each thing (b - a) / max(a, b), where a is its mean distance to its own group and b that to the nearest
    /// other one; 0 for a thing alone in its group.
    fn silhouette(&self, medoids: &[usize]) -> f64 {
        let k = medoids.len();
        let group = |i: usize| {
            let own = medoids.iter().position(|m| *m == i);
            own.or_else(|| (0..k).min_by(|&a, &b| self.at(i, medoids[a]).total_cmp(&self.at(i, medoids[b]))))
                .unwrap_or(0)
        };
        let of: Vec<usize> = (0..self.count).map(group).collect();
        let mut sizes = vec![0usize; k];
        of.iter().for_each(|&g| sizes[g] += 1);
        let width = |i: usize| {
            if sizes[of[i]] < 2 {
                return 0.0;
            }
            let mut sums = vec![0.0; k];
            (0..self.count).for_each(|j| sums[of[j]] += self.at(i, j));
            let own = sums[of[i]] / (sizes[of[i]] - 1) as f64;
            let other =
                (0..k).filter(|g| *g != of[i]).map(|g| sums[g] / sizes[g].max(1) as f64).fold(f64::INFINITY, f64::min);
            let most = own.max(other);
            if most > 0.0 { (other - own) / most } else { 0.0 }
        };
        (0..self.count).map(width).sum::<f64>() / self.count.max(1) as f64
    }
}
