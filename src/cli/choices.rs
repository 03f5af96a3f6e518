//! Section and joist choices on the command line.

use anyhow::Context;
use houscaper::score::Evaluator;
use houscaper::voxels::{Choice, Choices};
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
            Choice::Boards => boards(value, evaluator)?,
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

/// The index of wall boards given by their name or by their index in the brief.
fn boards(value: &Value, evaluator: &Evaluator) -> Result<u16, String> {
    let offered = &evaluator.brief.wall_boards;
    let index = match value {
        Value::String(name) => offered.iter().position(|b| b.name() == name),
        _ => value.as_u64().and_then(|n| usize::try_from(n).ok()).filter(|n| *n < offered.len()),
    };
    index.and_then(|n| u16::try_from(n).ok()).ok_or_else(|| {
        let names: Vec<&str> = offered.iter().map(|b| b.name()).collect();
        format!("choices.wall_boards is {value}, expected one of {} (`wall_boards` of the brief)", names.join(", "))
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
