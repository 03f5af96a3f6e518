//! Members from a JSON file: one, many, or a published example.

use std::path::Path;

use anyhow::anyhow;
use houscaper::structure::member::Input;
use serde_json::Value;

use super::expected::Expected;
use crate::cli::failure::{Blame, Failure, bad_input};
use crate::cli::input;

/// Members with the numbers they are expected to give, and whether the file is a list.
pub fn read(path: &Path) -> Result<(Vec<(Input, Expected)>, bool), Failure> {
    let name = path.display();
    let value: Value = serde_json::from_slice(&input::bytes(path)?).map_err(|e| anyhow!("{name}: {e}")).input()?;
    let Value::Object(mut object) = value else {
        return Err(bad_input(format!("{name}: expected an object with one member, `members`, or `input`")));
    };
    if let Some(schema) = object.remove("schema").filter(|s| s != "houscaper.member/1") {
        return Err(bad_input(format!("{name}: `schema` is {schema}: expected \"houscaper.member/1\" or nothing")));
    }
    if let Some(members) = object.remove("members") {
        let Value::Array(list) = members else { return Err(bad_input(format!("{name}: `members` must be a list"))) };
        if let Some(key) = object.keys().next() {
            return Err(bad_input(format!("{name}: unknown key `{key}` beside `members`")));
        }
        let members: Result<Vec<_>, Failure> = list
            .into_iter()
            .enumerate()
            .map(|(n, m)| one(m, &format!("{name}: members[{n}]")).map(|m| (m, Expected::default())))
            .collect();
        return Ok((members?, true));
    }
    if let Some(given) = object.remove("input") {
        let expected =
            Expected::read(object.remove("expected")).map_err(|e| anyhow!("{name}: expected: {e}")).input()?;
        let mut input = one(given, &format!("{name}: input"))?;
        input.name = input.name.or(object.get("id").and_then(Value::as_str).map(str::to_owned));
        return Ok((vec![(input, expected)], false));
    }
    Ok((vec![(one(Value::Object(object), &name.to_string())?, Expected::default())], false))
}

fn one(value: Value, place: &str) -> Result<Input, Failure> {
    serde_path_to_error::deserialize(value).map_err(|e| anyhow!("{place}: `{}`: {}", e.path(), e.inner())).input()
}
