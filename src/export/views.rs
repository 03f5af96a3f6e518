//! Views of a house: the same parts coloured by label, tile class, utilisation, carbon or price, each with a legend.

use serde_json::{Value, json};

use super::colour::hex;
use super::dossier::UTILISATION;
use super::scene::MaterialLook;
use crate::cubes::{Category, Mask, canonical, canonical_masks};
use crate::voxels::Label;
use crate::voxels::vox::LABEL_COLOURS;

/// Names of the views, in the order of the variants in a GLB.
pub const HOUSE_VIEWS: [&str; 6] = ["as built", "label", "tile class", "utilisation", "carbon", "price"];

/// What has no value in a view.
const NOTHING: u32 = 0xCFCFCB;

/// A hue for each category, light and dark end: roofs terracotta, floors blue, walls sand, the extra one violet.
const CATEGORIES: [(Category, [u32; 2]); 4] = [
    (Category::Roof, [0xE9C2AE, 0x8A3A22]),
    (Category::Floor, [0xC3D6E6, 0x234F7D]),
    (Category::Wall, [0xE8DDC4, 0x9A7B3F]),
    (Category::Extra, [0x7F5F9C, 0x7F5F9C]),
];

/// Little to much carbon; steps of even lightness in one hue, so that they read in grey too.
const CARBON: [u32; 7] = [0xEFE3D2, 0xE3CDAF, 0xD6B387, 0xC4935F, 0xA96F3F, 0x86492A, 0x5A2D18];

/// The same for money.
const PRICE: [u32; 7] = [0xE3EAF0, 0xC9D8E5, 0xA6C1D8, 0x7CA4C6, 0x5585B2, 0x346596, 0x1A4270];

/// Widths of classes, times powers of ten.
const ROUND: [f64; 10] = [1.0, 1.5, 2.0, 2.5, 3.0, 4.0, 5.0, 6.0, 8.0, 10.0];

/// Classes of an amount: equal steps from 0, the last one open.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Steps {
    /// Width of a class: a round number.
    pub step: f64,
    /// Least and greatest value found.
    pub range: [f64; 2],
}

impl Steps {
    /// Steps whose seven classes hold all but the largest twentieth of the values.
    pub fn of(values: impl IntoIterator<Item = f64>) -> Steps {
        let mut values: Vec<f64> = values.into_iter().filter(|v| v.is_finite()).collect();
        values.sort_by(f64::total_cmp);
        let at = |share: f64| values.get(((values.len() as f64 * share) as usize).min(values.len().saturating_sub(1)));
        let most = at(0.95).copied().unwrap_or(0.0) / CARBON.len() as f64;
        let exponent = if most > 0.0 { most.log10().floor() } else { 0.0 };
        // Through its decimal, so that it is the number that it reads as.
        let step = ROUND.map(|s| format!("{s}e{exponent}").parse().unwrap_or(1.0));
        let step = step.into_iter().find(|s| *s >= most * 0.999).unwrap_or(step[ROUND.len() - 1]);
        Steps { step, range: [at(0.0), at(1.0)].map(|v| v.copied().unwrap_or(0.0)) }
    }

    /// The class of a value, 0 to 6.
    pub fn class(&self, value: f64) -> usize {
        // The cast holds what is below 0 or beyond the last class.
        ((value / self.step) as usize).min(CARBON.len() - 1)
    }

    fn name(&self, class: usize) -> String {
        let edge = |n: usize| {
            let text = format!("{:.6}", n as f64 * self.step);
            text.trim_end_matches('0').trim_end_matches('.').to_owned()
        };
        if class + 1 < CARBON.len() {
            format!("{}-{}", edge(class), edge(class + 1))
        } else {
            format!("over {}", edge(class))
        }
    }
}

/// What decides the colours of a part.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Traits {
    /// Label of its voxel; `None` for what belongs to none.
    pub label: Option<Label>,
    /// Filled corners of its cube; `None` for what belongs to none.
    pub mask: Option<Mask>,
    /// Class of the largest utilisation of the members there, 0 to 5.
    pub utilisation: Option<usize>,
    /// kgCO2e.
    pub carbon: Option<f64>,
    /// EUR.
    pub price: Option<f64>,
}

/// The materials of all views.
pub struct HouseLooks {
    /// As many as were there before, then those of the views.
    pub looks: Vec<MaterialLook>,
    carbon: Steps,
    price: Steps,
    /// Where the labels, classes, classes of utilisation, of carbon and of price begin.
    first: [usize; 5],
    nothing: usize,
    masks: Vec<Mask>,
}

impl HouseLooks {
    /// Adds the materials of the views to those of the house as built.
    pub fn new(own: Vec<MaterialLook>, carbon: Steps, price: Steps) -> HouseLooks {
        let mut looks = own;
        let masks = canonical_masks();
        let mut first = [0; 5];
        let mut add = |of: usize, entries: Vec<(String, u32)>| {
            first[of] = looks.len();
            looks.extend(entries.iter().map(|(name, colour)| MaterialLook::matt(name, *colour, 0.9)));
        };
        add(0, LABEL_COLOURS.iter().map(|(l, c)| (format!("label {}", l.name()), hex(*c))).collect());
        add(1, masks.iter().map(|m| (class_name(&masks, *m), class_colour(&masks, *m))).collect());
        add(2, UTILISATION.iter().map(|c| (c.name.to_owned(), c.colour)).collect());
        let steps = |unit: &str, s: Steps, colours: [u32; 7]| {
            colours.iter().enumerate().map(|(n, c)| (format!("{unit} {}", s.name(n)), *c)).collect::<Vec<_>>()
        };
        add(3, steps("kgCO2e", carbon, CARBON));
        add(4, steps("EUR", price, PRICE));
        let nothing = looks.len();
        looks.push(MaterialLook::matt("no value", NOTHING, 0.9));
        HouseLooks { looks, carbon, price, first, nothing, masks }
    }

    /// The materials of a part in each of [`HOUSE_VIEWS`]; `own` is that of the part as built.
    pub fn of(&self, own: usize, traits: &Traits) -> Vec<usize> {
        let place = |of: usize, n: Option<usize>| n.map_or(self.nothing, |n| self.first[of] + n);
        let label = traits.label.and_then(|l| LABEL_COLOURS.iter().position(|(known, _)| *known == l));
        let class = traits.mask.and_then(|m| self.class(m)).map(|n| n - 1);
        vec![
            own,
            place(0, label),
            place(1, class),
            place(2, traits.utilisation),
            place(3, traits.carbon.map(|v| self.carbon.class(v))),
            place(4, traits.price.map(|v| self.price.class(v))),
        ]
    }

    /// The number of a cube's class among the 26, from 1; `None` for an inadmissible cube.
    pub fn class(&self, mask: Mask) -> Option<usize> {
        self.masks.iter().position(|m| *m == canonical(mask).0).map(|n| n + 1)
    }

    /// What the colours of the views mean. `of` is what has one amount: a layer or a tile; `classed` what has classes and utilisations.
    pub fn legends(&self, of: &str, classed: &str) -> Value {
        let entries = |first: usize, count: usize| -> Vec<Value> {
            let srgb = |n: usize| format!("#{:06X}", hex(self.looks[n].srgb()));
            (first..first + count).map(|n| json!({ "material": self.looks[n].name, "srgb": srgb(n) })).collect()
        };
        let amount = |n: usize, what: &str, unit: &str, steps: &Steps| {
            json!({
                "means": format!("{what} of the whole {of}, default rates; without the frame, waste and work"),
                "unit": unit, "min": steps.range[0], "max": steps.range[1], "step": steps.step,
                "classes": entries(self.first[n], CARBON.len()),
            })
        };
        json!({
            "as built": { "means": "materials of the layers" },
            "label": { "means": "label of the voxel", "classes": entries(self.first[0], LABEL_COLOURS.len()) },
            "tile class": {
                "means": format!("class of the cube's filled corners under turns and mirror, {classed}; hue roof, floor, wall, extra"),
                "classes": entries(self.first[1], self.masks.len()),
            },
            "utilisation": {
                "means": format!("largest utilisation of the frame's members in the cube, {classed}"), "unit": "1", "limit": 1.0,
                "min": 0.0, "max": 1.0, "classes": entries(self.first[2], UTILISATION.len()),
            },
            "carbon": amount(3, "fossil carbon A1-A3", "kgCO2e", &self.carbon),
            "price": amount(4, "price of materials", "EUR", &self.price),
        })
    }
}

fn class_name(masks: &[Mask], mask: Mask) -> String {
    let number = masks.iter().position(|m| *m == mask).map_or(0, |n| n + 1);
    format!("class {number} {}", Category::of(mask).name())
}

/// The hue of its category, lighter to darker by its place there.
fn class_colour(masks: &[Mask], mask: Mask) -> u32 {
    let category = Category::of(mask);
    let mates: Vec<&Mask> = masks.iter().filter(|m| Category::of(**m) == category).collect();
    let place = mates.iter().position(|m| **m == mask).unwrap_or(0) as f64 / (mates.len().max(2) - 1) as f64;
    let [light, dark] = CATEGORIES.iter().find(|(c, _)| *c == category).map_or([NOTHING; 2], |(_, ends)| *ends);
    let channel = |shift: u32| {
        let [a, b] = [light, dark].map(|c| f64::from(c >> shift & 255));
        ((a + (b - a) * place).round() as u32) << shift
    };
    channel(16) | channel(8) | channel(0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::export::dossier::of_utilisation;

    #[test]
    fn steps_are_round_and_hold_nearly_all() {
        let steps = Steps::of((0..=100).map(f64::from));
        assert_eq!((steps.step, steps.range), (15.0, [0.0, 100.0]));
        assert_eq!([0.0, 14.9, 15.0, 104.0, 1e9].map(|v| steps.class(v)), [0, 0, 1, 6, 6]);
        assert_eq!((steps.name(0), steps.name(6)), ("0-15".to_owned(), "over 90".to_owned()));
        assert_eq!(Steps::of([]).class(0.0), 0);
        assert_eq!(Steps::of([0.004]).step, 0.0006);
        assert_eq!(Steps::of([0.004]).name(1), "0.0006-0.0012");
    }

    #[test]
    fn each_class_has_a_colour_of_its_own() {
        let masks = canonical_masks();
        let mut colours: Vec<u32> = masks.iter().map(|m| class_colour(&masks, *m)).collect();
        colours.sort_unstable();
        colours.dedup();
        assert_eq!((masks.len(), colours.len()), (26, 26));
    }

    #[test]
    fn what_has_no_value_is_grey_and_names_are_unique() {
        let looks = HouseLooks::new(Vec::new(), Steps::of([1.0]), Steps::of([1.0]));
        let all = looks.of(0, &Traits::default());
        assert!(all[1..].iter().all(|m| looks.looks[*m].name == "no value"), "{all:?}");
        let mut names: Vec<&str> = looks.looks.iter().map(|l| l.name.as_str()).collect();
        names.sort_unstable();
        names.dedup();
        assert_eq!(names.len(), looks.looks.len());
        let seen = looks
            .of(0, &Traits { label: Some(Label::Window), utilisation: Some(of_utilisation(1.2)), ..Traits::default() });
        assert_eq!(looks.looks[seen[1]].name, "label window");
        assert_eq!(looks.looks[seen[3]].name, "utilisation over 1.0");
    }
}
