//! Section and joist choices on the command line.

use anyhow::Context;
use houscaper::score::Evaluator;
use houscaper::structure::Verdict;
use houscaper::voxels::{Choice, Choices, House};
use serde_json::{Map, Value};

use super::failure::{Blame, Failure, bad_input};
use super::input;

/// The choices of a flag: JSON text, or the path of a file that holds it (`choices.json` of a house in a front).
pub fn from_flag(flag: &str, evaluator: &Evaluator) -> Result<Choices, Failure> {
    let (text, name) = match flag.trim_start().starts_with('{') {
        true => (flag.as_bytes().to_vec(), "--choices".to_owned()),
        false => (input::bytes(flag.as_ref())?, flag.to_owned()),
    };
    let map: Map<String, Value> = serde_json::from_slice(&text).with_context(|| name.clone()).input()?;
    read(&map, evaluator).map_err(|error| bad_input(format!("{name}: {error}")))
}

/// Joint steps from the lightest to the heaviest sections that [`light`] tries.
const STEPS: usize = 12;

/// Light sections that pass: the first of twelve joint steps from light to heavy whose verdict is ok, joists along x or y, then each
/// group in turn lightened as far as the verdict stays ok. Where boards fail whatever the sections are, light ones whose members hold; the
/// heaviest when not even those are found.
pub fn light(house: &House, evaluator: &Evaluator) -> Choices {
    let assess = |choices: &Choices| evaluator.details(house, choices).evaluation.assessment;
    let stands = |choices: &Choices| assess(choices).is_some_and(|a| a.verdict == Verdict::Ok);
    // Steel posts relieve boards a little: no reason to fill a house with them when that does not make it stand either.
    let holds = |choices: &Choices| {
        assess(choices).is_some_and(|a| {
            a.vibration_ratio() <= 1.0 && a.members.iter().all(|m| m.utilisation <= 1.0 && m.deflection_ratio <= 1.0)
        })
    };
    let step = |step: usize, joists: u16| {
        let mut choices = Choices::default();
        for (group, options) in evaluator.options.iter().enumerate() {
            choices.0[group] = (step * (options.len() - 1) / (STEPS - 1)) as u16;
        }
        choices.0[Choice::Joists as usize] = joists;
        choices
    };
    let steps = || (0..STEPS).flat_map(|n| [0, u16::MAX].map(|joists| step(n, joists)));
    let (first, passes): (_, &dyn Fn(&Choices) -> bool) = match steps().find(stands) {
        Some(first) => (Some(first), &stands),
        None => (steps().find(holds), &holds),
    };
    let Some(mut choices) = first else { return step(STEPS - 1, 0) };
    for group in 0..evaluator.options.len() {
        let lighter = (0..choices.0[group]).map(|option| {
            let mut lighter = choices;
            lighter.0[group] = option;
            lighter
        });
        choices = lighter.into_iter().find(passes).unwrap_or(choices);
    }
    choices
}

/// Choices by name; what is not named takes the first option.
pub fn read(map: &Map<String, Value>, evaluator: &Evaluator) -> Result<Choices, String> {
    let mut choices = Choices::default();
    for (key, value) in map {
        let Some(choice) = Choice::ALL.into_iter().find(|c| c.name() == key) else {
            let names = Choice::ALL.map(Choice::name).join(", ");
            return Err(format!("choices.{key}: unknown; expected one of {names}"));
        };
        choices.0[choice as usize] = match choice {
            Choice::Joists => bits(value)?,
            Choice::Wall | Choice::Floor | Choice::Beam | Choice::Roof => option(choice, value, evaluator)?,
        };
    }
    Ok(choices)
}

fn bits(value: &Value) -> Result<u16, String> {
    let letters = |text: &str| {
        let known = text.len() <= 16 && text.bytes().all(|b| b == b'x' || b == b'y');
        known.then(|| text.bytes().enumerate().fold(0, |bits, (p, b)| bits | u16::from(b == b'y') << p))
    };
    let bits = match value {
        Value::String(text) => letters(text),
        _ => value.as_u64().and_then(|b| u16::try_from(b).ok()),
    };
    bits.ok_or_else(|| {
        format!("choices.joist_axes is {value}, expected a letter for each plate, e.g. \"xy\", or bits from 0 to 65535")
    })
}

/// The index of an option given by its name or by its index.
fn option(choice: Choice, value: &Value, evaluator: &Evaluator) -> Result<u16, String> {
    let options = &evaluator.options[choice as usize];
    let names = || options.iter().map(|o| evaluator.catalogue.option_name(*o));
    let index = match value {
        Value::String(name) => names().position(|n| n == *name),
        _ => value.as_u64().and_then(|n| usize::try_from(n).ok()).filter(|n| *n < options.len()),
    };
    index.and_then(|n| u16::try_from(n).ok()).ok_or_else(|| {
        let names: Vec<String> = names().collect();
        format!(
            "choices.{} is {value}, expected an index below {} or one of {}",
            choice.name(),
            names.len(),
            names.join(", ")
        )
    })
}
