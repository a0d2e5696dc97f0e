//! The JSON Schema of scenarios, made from the structs that hold them: for editors, the page and the structure check.

use super::schema::Scenario;
use serde_json::{Value, json};
use std::sync::LazyLock;

/// The JSON Schema (draft 2020-12) of a scenario.
pub fn json_schema() -> &'static Value {
    static SCHEMA: LazyLock<Value> = LazyLock::new(|| {
        let mut schema = schemars::schema_for!(Scenario).to_value();
        forget_null(&mut schema);
        if let Value::Object(keys) = &mut schema {
            keys.insert("$id".into(), json!("urn:carom:scenario:1"));
            keys.insert("title".into(), json!("Carom scenario"));
            // A gas stands in place of a table and balls, and balls may be left out where there is a rack; the check of
            // the whole says so in words.
            let balls = json!({ "required": ["balls"] });
            let table = json!({ "required": ["table"], "if": unless("rack"), "then": balls });
            keys.insert("if".into(), unless("gas"));
            keys.insert("then".into(), table);
        }
        schema
    });
    &SCHEMA
}

/// What holds where a key is absent.
fn unless(key: &str) -> Value {
    json!({ "not": { "required": [key] } })
}

/// Takes out the alternative `null`: in a file, what is absent is left out.
fn forget_null(schema: &mut Value) {
    match schema {
        Value::Array(items) => items.iter_mut().for_each(forget_null),
        Value::Object(keys) => {
            if let Some(Value::Array(types)) = keys.get("type")
                && let [only, Value::String(null)] = types.as_slice()
                && null == "null"
            {
                let only = only.clone();
                keys.insert("type".into(), only);
            }
            if let Some(Value::Array(alternatives)) = keys.get("anyOf")
                && let [only, null] = alternatives.as_slice()
                && *null == json!({ "type": "null" })
                && let Some(reference) = only.get("$ref").cloned()
            {
                keys.shift_remove("anyOf");
                keys.insert("$ref".into(), reference);
            }
            keys.values_mut().for_each(forget_null);
        }
        _ => {}
    }
}
