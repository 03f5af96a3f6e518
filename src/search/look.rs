//! What an architect sees of a house from outside, and how far two houses look apart.

use super::cells::Cells;
use super::massing::{Design, Infill};
use super::openings::glass_m2;
use crate::voxels::{Direction, Module};

/// What is seen of a house.
#[derive(Clone, Debug, PartialEq)]
pub struct Look {
    /// Storeys.
    pub storeys: usize,
    /// Plan of the lowest storey, m2.
    pub footprint_m2: f64,
    /// Corners of that plan, courts included; 4 for a rectangle, 6 for an L.
    pub corners: usize,
    /// Longer over shorter side of the rectangle around that plan.
    pub aspect: f64,
    /// Share of that plan that has no room in the top storey above.
    pub setback: f64,
    /// Plan of storeys beyond the storey underneath, as a share of the lowest one's.
    pub overhang: f64,
    /// Layers of hipped roof; 0 = flat.
    pub roof_rise: usize,
    /// Glass by the side it faces, in the order of [`Direction::ALL`], m2.
    pub glass_m2: [f64; 4],
    /// What the walls are framed with.
    pub material: String,
}

impl Look {
    /// The look of a design with modules of `module` whose walls are framed with `material`.
    pub fn of(design: &Design, module: &Module, material: String) -> Look {
        let massing = &design.massing;
        let none = Cells::new([1, 1]);
        let ground = massing.storeys.first().map_or(&none, |s| &s.footprint);
        let top = massing.top().unwrap_or(&none);
        let cells = ground.count().max(1) as f64;
        let sides = ground.bounds().map_or([1.0, 1.0], |(_, [w, h])| [w as f64, h as f64]);
        let sides = [sides[0] * module.size_m[0], sides[1] * module.size_m[1]];
        let beyond = massing.storeys.windows(2).map(|s| s[1].footprint.minus(&s[0].footprint).count());
        let mut glass = [0.0; 4];
        let windows = massing.storeys.iter().flat_map(|s| &s.openings).filter(|o| o.infill == Infill::Window);
        windows.for_each(|o| glass[o.facing as usize] += glass_m2(o));
        Look {
            storeys: massing.storeys.len(),
            footprint_m2: ground.count() as f64 * module.size_m[0] * module.size_m[1],
            corners: corners(ground),
            aspect: sides[0].max(sides[1]) / sides[0].min(sides[1]),
            setback: ground.minus(top).count() as f64 / cells,
            overhang: beyond.sum::<usize>() as f64 / cells,
            roof_rise: massing.roof.rise(),
            glass_m2: glass,
            material,
        }
    }

    /// All glass, m2.
    pub fn glass(&self) -> f64 {
        self.glass_m2.iter().sum()
    }

    /// The plan in a word.
    pub fn plan(&self) -> &'static str {
        match self.corners {
            0..=4 => "rectangular",
            5 | 6 => "L-shaped",
            7 | 8 => "T-, U- or Z-shaped",
            _ => "many-cornered",
        }
    }

    /// Features that are numbers.
    fn numbers(&self) -> [f64; 8] {
        let counts = [self.storeys, self.corners, self.roof_rise].map(|n| n as f64);
        let glazing = self.glass() / (self.footprint_m2 * self.storeys as f64).max(1e-9);
        [counts[0], counts[1], counts[2], self.footprint_m2, self.aspect, self.setback, self.overhang, glazing]
    }

    /// Glass by side as shares.
    fn shares(&self) -> [f64; 4] {
        let all = self.glass();
        self.glass_m2.map(|g| if all > 0.0 { g / all } else { 0.25 })
    }
}

/// Corners of a plan: places where one or three of the four cells around are filled, and twice where two lie across.
fn corners(plan: &Cells) -> usize {
    let [nx, ny] = plan.size().map(|n| n as isize);
    let at = |x: isize, y: isize| {
        let around = [[x, y], [x - 1, y], [x, y - 1], [x - 1, y - 1]].map(|c| plan.has(c));
        match around.iter().filter(|c| **c).count() {
            1 | 3 => 1,
            2 if around[0] == around[3] => 2,
            _ => 0,
        }
    };
    (0..=ny).flat_map(|y| (0..=nx).map(move |x| at(x, y))).sum()
}

/// Distances between looks after Gower (1971): the mean over all features, each between 0 and 1 and all counting the same: numbers by
/// their difference over the range in the set, glass by side by the share that faces another way, the material by being another.
pub struct Distances<'a> {
    looks: &'a [Look],
    ranges: [f64; 8],
}

impl<'a> Distances<'a> {
    /// Distances within a set.
    pub fn new(looks: &'a [Look]) -> Self {
        let numbers: Vec<[f64; 8]> = looks.iter().map(Look::numbers).collect();
        let of = |f: usize| numbers.iter().map(move |n| n[f]);
        let range = |f: usize| of(f).fold(f64::NEG_INFINITY, f64::max) - of(f).fold(f64::INFINITY, f64::min);
        Distances { looks, ranges: std::array::from_fn(range) }
    }

    /// Distance of two of them, 0 to 1.
    pub fn between(&self, a: usize, b: usize) -> f64 {
        let (a, b) = (&self.looks[a], &self.looks[b]);
        let apart = a.numbers().into_iter().zip(b.numbers()).zip(self.ranges);
        let numbers: f64 = apart.map(|((x, y), range)| if range > 0.0 { (x - y).abs() / range } else { 0.0 }).sum();
        let turned: f64 = a.shares().into_iter().zip(b.shares()).map(|(x, y)| (x - y).abs()).sum::<f64>() / 2.0;
        let material = f64::from(u8::from(a.material != b.material));
        (numbers + turned + material) / 10.0
    }
}

/// Words, and which houses they fit.
type Trait<'a> = (&'a str, &'a dyn Fn(&Look) -> bool);

/// Share from which on it is said of most of it.
const MOSTLY: f64 = 2.0 / 3.0;

/// What the houses of a group share, in words: what all of them have, and "mostly" what two in three have.
pub fn shared(group: &[&Look]) -> String {
    let Some(first) = group.first() else { return "no house".into() };
    let share = |has: &dyn Fn(&Look) -> bool| group.iter().filter(|l| has(l)).count() as f64 / group.len() as f64;
    let extent = |of: &dyn Fn(&Look) -> f64| {
        group.iter().map(|l| of(l)).fold([f64::INFINITY, f64::NEG_INFINITY], |[l, h], v| [l.min(v), h.max(v)])
    };
    let often = |traits: &[Trait]| -> Option<String> {
        let word = |(word, is): &Trait| match share(is) {
            1.0 => Some((*word).to_owned()),
            s if s >= MOSTLY => Some(format!("mostly {word}")),
            _ => None,
        };
        traits.iter().find_map(word)
    };
    let storeys: [Trait; 3] =
        [("one storey", &|l| l.storeys == 1), ("2 storeys", &|l| l.storeys == 2), ("3 storeys", &|l| l.storeys == 3)];
    let [low, high] = extent(&|l| l.storeys as f64);
    let mut said = vec![often(&storeys).unwrap_or_else(|| match low == high {
        true => format!("{low:.0} storeys"),
        false => format!("{low:.0} to {high:.0} storeys"),
    })];
    let [low, high] = extent(&|l| l.footprint_m2);
    let size = if high - low < 1.0 { format!("{high:.0} m²") } else { format!("{low:.0} to {high:.0} m²") };
    let plans = ["rectangular", "L-shaped", "T-, U- or Z-shaped", "many-cornered"];
    let plan = plans.iter().find_map(|&name| often(&[(name, &|l| l.plan() == name)]));
    said.push(format!("{} plan of {size}", plan.unwrap_or_else(|| "mixed".into())));
    if share(&|l| l.storeys > 1) >= MOSTLY {
        let kinds: [Trait; 3] = [
            ("set back above", &|l| l.setback > 0.0 && l.overhang == 0.0),
            ("overhanging above", &|l| l.overhang > 0.0),
            ("straight up", &|l| l.setback == 0.0 && l.overhang == 0.0),
        ];
        said.extend(often(&kinds));
    }
    let roofs: [Trait; 2] = [("flat roof", &|l| l.roof_rise == 0), ("hipped roof", &|l| l.roof_rise > 0)];
    said.extend(often(&roofs));
    said.push(glass_words(group));
    if share(&|l| l.material == first.material) == 1.0 && !first.material.is_empty() {
        said.push(format!("walls of {}", first.material));
    }
    said.join(", ")
}

/// Where the glass of a group faces.
fn glass_words(group: &[&Look]) -> String {
    let mean = |d: usize| group.iter().map(|l| l.shares()[d]).sum::<f64>() / group.len().max(1) as f64;
    let means: [f64; 4] = std::array::from_fn(mean);
    let largest = (0..4).max_by(|&a, &b| means[a].total_cmp(&means[b]).then(b.cmp(&a))).unwrap_or(0);
    let side = match Direction::ALL[largest] {
        Direction::East => "east",
        Direction::North => "north",
        Direction::West => "west",
        Direction::South => "south",
    };
    match means[largest] {
        m if m >= 0.4 => format!("{:.0} % of the glass to the {side}", 100.0 * m),
        _ => "glass to several sides".to_owned(),
    }
}
