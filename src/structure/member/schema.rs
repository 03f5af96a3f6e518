//! The JSON Schema of member files: `houscaper.member/1`.

use serde_json::{Map, Value, json};

use super::Input;

/// Name of the format.
pub const MEMBER_SCHEMA: &str = "houscaper.member/1";

/// What an editor or another program checks a member file by: one member, a list of them, or a reference example whose `input` is a
/// member and whose `expected` has values with relative tolerances. Keys and types only: what is missing or contradictory
/// says [`super::check_member`].
pub fn member_schema() -> Value {
    let mut member = serde_json::to_value(schemars::schema_for!(Input)).unwrap_or_default();
    let mut take = |key: &str| member.as_object_mut().and_then(|m| m.remove(key)).unwrap_or_default();
    let (dialect, words) = (take("$schema"), take("$defs"));
    take("title");
    // Other names of the material that files may use.
    let material = member["properties"]["material"].clone();
    for alias in ["steel", "grade"] {
        member["properties"][alias] = material.clone();
    }
    let name = json!({"const": MEMBER_SCHEMA});
    let mut alone = member.clone();
    alone["properties"]["schema"] = name.clone();
    // Any number of keys stands beside these two in an example; they tell the three forms apart.
    alone["not"] = json!({"anyOf": [{"required": ["members"]}, {"required": ["input"]}]});
    let mut defs = words.as_object().cloned().unwrap_or_else(Map::new);
    defs.insert("Member".into(), member);
    defs.insert("OneMember".into(), alone);
    defs.insert(
        "Members".into(),
        json!({
            "description": "Many members.",
            "type": "object",
            "properties": {"schema": name, "members": {"type": "array", "items": {"$ref": "#/$defs/Member"}}},
            "required": ["members"],
            "additionalProperties": false
        }),
    );
    let published = json!({
        "description": "A published value and how far ours may be from it.",
        "type": "object",
        "properties": {"value": {"type": "number"}, "rel_tol": {"type": "number"}},
        "required": ["value", "rel_tol"],
        "additionalProperties": false
    });
    defs.insert(
        "Example".into(),
        json!({
            "description": "A reference example; keys beside these are not read.",
            "type": "object",
            "properties": {
                "schema": name,
                "id": {"description": "Name of a member without one.", "type": "string"},
                "input": {"$ref": "#/$defs/Member"},
                "expected": {"description": "By key of a report.", "type": "object", "additionalProperties": published}
            },
            "required": ["input"]
        }),
    );
    json!({
        "$schema": dialect,
        "title": MEMBER_SCHEMA,
        "description": "Members checked one by one, `houscaper member FILE`.",
        "anyOf": [{"$ref": "#/$defs/OneMember"}, {"$ref": "#/$defs/Members"}, {"$ref": "#/$defs/Example"}],
        "$defs": defs
    })
}
