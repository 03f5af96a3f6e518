//! The JSON Schema of member files: what it lets pass is what `houscaper member` reads.

use std::path::Path;

use houscaper::structure::member::{Input, member_schema};
use serde_json::{Map, Value, json};

use super::shared;

/// Whether a value keeps a schema, for the words that ours uses; a word that is not known here fails.
fn keeps(schema: &Value, root: &Value, value: &Value) -> bool {
    let any = |list: &Value| list.as_array().is_some_and(|l| l.iter().any(|s| keeps(s, root, value)));
    let object = value.as_object();
    schema.as_object().expect("a schema").iter().all(|(word, rule)| match word.as_str() {
        "$ref" => {
            let name = rule.as_str().and_then(|r| r.strip_prefix("#/$defs/")).expect("a local reference");
            keeps(&root["$defs"][name], root, value)
        }
        "anyOf" | "oneOf" => any(rule),
        "not" => !keeps(rule, root, value),
        "const" => value == rule,
        "enum" => rule.as_array().expect("a list").contains(value),
        "type" => {
            let is = |word: &str| match word {
                "object" => value.is_object(),
                "array" => value.is_array(),
                "string" => value.is_string(),
                "number" => value.is_number(),
                "integer" => value.is_u64() || value.is_i64(),
                "boolean" => value.is_boolean(),
                "null" => value.is_null(),
                _ => panic!("type {word}"),
            };
            rule.as_str()
                .map_or_else(|| rule.as_array().expect("types").iter().any(|t| is(t.as_str().expect("a word"))), is)
        }
        "properties" => object.is_none_or(|o| {
            let rules = rule.as_object().expect("properties");
            o.iter().all(|(key, v)| rules.get(key).is_none_or(|r| keeps(r, root, v)))
        }),
        "additionalProperties" => object.is_none_or(|o| {
            let known = |key: &str| schema["properties"].get(key).is_some();
            o.iter().filter(|(key, _)| !known(key)).all(|(_, v)| rule.as_bool().unwrap_or_else(|| keeps(rule, root, v)))
        }),
        "required" => object
            .is_none_or(|o| rule.as_array().expect("keys").iter().all(|k| o.contains_key(k.as_str().expect("a key")))),
        "items" => value.as_array().is_none_or(|l| l.iter().all(|v| keeps(rule, root, v))),
        "minimum" => value.as_f64().is_none_or(|v| v >= rule.as_f64().expect("a number")),
        "maximum" => value.as_f64().is_none_or(|v| v <= rule.as_f64().expect("a number")),
        "$schema" | "$defs" | "title" | "description" | "default" | "format" => true,
        _ => panic!("word {word}"),
    })
}

fn passes(value: &Value) -> bool {
    let schema = member_schema();
    keeps(&schema, &schema, value)
}

#[test]
fn the_shipped_schema_is_the_schema() {
    let path = Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/configs/member.schema.json"));
    let shipped: Value = serde_json::from_slice(&std::fs::read(path).expect("a file")).expect("JSON");
    assert_eq!(shipped, member_schema(), "run `houscaper schema member > configs/member.schema.json`");
}

/// The reference examples that are members pass, and so do their inputs alone and in a list; with a key or a type that is wrong they do
/// not. What is no member (snow, wind, the thesis rule) does not pass.
#[test]
fn reference_examples_keep_the_schema() {
    let Some(folder) = shared("reference/eurocode") else { return };
    let (mut members, mut others) = (0, 0);
    let mut files: Vec<_> = std::fs::read_dir(folder).expect("a folder").map(|f| f.expect("a file").path()).collect();
    files.sort();
    for file in files.iter().filter(|f| f.extension().is_some_and(|e| e == "json")) {
        let example: Value = serde_json::from_slice(&std::fs::read(file).expect("a file")).expect("JSON");
        let input = &example["input"];
        let is_read = serde_json::from_value::<Input>(input.clone()).is_ok();
        assert_eq!(passes(&example), is_read, "{}", file.display());
        if !is_read {
            others += 1;
            continue;
        }
        members += 1;
        assert!(passes(input) && passes(&json!({"schema": "houscaper.member/1", "members": [input, input]})));
        let changed = |key: &str, value: Value| {
            let mut changed: Map<String, Value> = input.as_object().expect("an object").clone();
            changed.insert(key.into(), value);
            Value::Object(changed)
        };
        for wrong in [changed("L_m", json!(3)), changed("h_mm", json!("200")), changed("duration", json!("brief"))] {
            assert!(
                !passes(&wrong) && !passes(&json!({"members": [input, wrong]})) && !passes(&json!({"input": wrong}))
            );
            assert!(serde_json::from_value::<Input>(wrong).is_err());
        }
        assert!(!passes(&json!({"members": [input], "note": 1})) && passes(&json!({"input": input, "note": 1})));
        assert!(passes(&changed("schema", json!("houscaper.member/1"))) && !passes(&changed("schema", json!("x"))));
        assert!(!passes(&json!({"input": input, "expected": {"chi_y": 1.0}})));
    }
    assert!(members >= 4 && others >= 3, "{members} and {others}");
}

/// Every key of the schema is read by the program: none is a leftover, and enumerated words are the program's.
#[test]
fn every_key_is_read() {
    let schema = member_schema();
    let keys = schema["$defs"]["Member"]["properties"].as_object().expect("properties");
    assert!(keys.len() > 60, "{}", keys.len());
    for key in keys.keys() {
        let read = |value: Value| serde_json::from_value::<Input>(json!({key.as_str(): value})).is_ok();
        let values = [json!(1), json!("C24"), json!("top"), json!("hot"), json!("short"), json!("rolled"), json!(true)];
        assert!(values.into_iter().any(read), "{key}");
    }
}
