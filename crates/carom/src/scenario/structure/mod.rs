//! The structure of a scenario: whether its keys, types and single numbers are those of the JSON Schema.
//!
//! The schema is the one definition; this walk knows the part of JSON Schema that the scenario's schema uses. All
//! problems are collected. What is not usable is left out of the value that comes back, so that the checks of the
//! whole can go on with the rest.

mod choice;
mod words;

use super::json_schema::json_schema;
use super::nearest::suggestion;
use super::path::{Place, Step, step_into};
use super::problem::Findings;
use choice::{alternatives, choose};
use serde_json::{Map, Value};
use words::{describe, has_type, range_problem, short};

/// Notes everything in `value` that departs from the schema; the part of the value that is usable.
///
/// Unknown keys and nulls are taken out; what has the wrong type becomes null, or is left out where it has a key; whole
/// numbers written as 5.0 become 5 where the schema wants them whole.
pub(crate) fn check_structure(value: &Value, findings: &mut Findings) -> Value {
    check_value(value, json_schema(), &Place::Root, findings)
}

/// The keys that the schema knows at the place that `steps` lead to inside `value`.
pub(crate) fn known_keys(value: &Value, steps: &[Step]) -> Vec<&'static str> {
    schema_at(value, steps).map_or_else(Vec::new, keys_of)
}

/// The least and the largest number that the schema allows at the place that `steps` lead to inside `value`; `None` where
/// there is no number, or one that must be larger than the least.
pub(crate) fn bounds(value: &Value, steps: &[Step]) -> Option<[f64; 2]> {
    let schema = schema_at(value, steps)
        .filter(|schema| has_type(schema, "number") && schema.get("exclusiveMinimum").is_none())?;
    let bound = |key, otherwise| schema.get(key).and_then(Value::as_f64).unwrap_or(otherwise);
    Some([bound("minimum", f64::NEG_INFINITY), bound("maximum", f64::INFINITY)])
}

/// The schema of the place that `steps` lead to inside `value`.
fn schema_at(value: &Value, steps: &[Step]) -> Option<&'static Value> {
    let mut schema = resolve(json_schema());
    let mut value = value;
    for step in steps {
        let chosen = narrow(value, schema).ok()?;
        let (step, inner) = step_into(value, step)?;
        let next = match step {
            Step::Key(key) => property(chosen, &key),
            Step::Index(_) => chosen.get("items"),
        }?;
        (schema, value) = (resolve(next), inner);
    }
    narrow(value, schema).ok()
}

fn check_value(value: &Value, schema: &Value, place: &Place<'_>, findings: &mut Findings) -> Value {
    let schema = match narrow(value, resolve(schema)) {
        Ok(schema) => schema,
        Err(mismatch) => {
            match mismatch.key {
                Some(key) => findings.add(Place::Key(place, key), mismatch.message),
                None => findings.add(place, mismatch.message),
            }
            return Value::Null;
        }
    };
    match value {
        Value::Object(keys) if has_type(schema, "object") => check_keys(keys, schema, place, findings),
        Value::Array(items) if has_type(schema, "array") => check_items(items, schema, place, findings),
        Value::String(text) if has_type(schema, "string") => {
            if text.is_empty() && schema.get("minLength").is_some() {
                findings.add(place, "must not be empty");
            }
            value.clone()
        }
        Value::Bool(_) if has_type(schema, "boolean") => value.clone(),
        _ => check_number(value, schema, place, findings),
    }
}

fn check_keys(
    keys: &Map<String, Value>,
    schema: &Value,
    place: &Place<'_>,
    findings: &mut Findings,
) -> Value {
    let mut usable = Map::new();
    for (key, value) in keys {
        let inside = Place::Key(place, key);
        match property(schema, key) {
            Some(_) if value.is_null() => {}
            Some(schema) => {
                let value = check_value(value, schema, &inside, findings);
                if !value.is_null() {
                    usable.insert(key.clone(), value);
                }
            }
            None => findings.note(inside, format!("unknown key{}", suggestion(key, &keys_of(schema)))),
        }
    }
    for key in
        schema.get("required").and_then(Value::as_array).into_iter().flatten().filter_map(Value::as_str)
    {
        if keys.get(key).is_none_or(Value::is_null) {
            let wanted = property(schema, key).map_or_else(String::new, |inner| describe(resolve(inner)));
            findings.add(Place::Key(place, key), format!("missing: expected {wanted}"));
        }
    }
    Value::Object(usable)
}

fn check_items(items: &[Value], schema: &Value, place: &Place<'_>, findings: &mut Findings) -> Value {
    let bound = |key| schema.get(key).and_then(Value::as_u64);
    let count = items.len() as u64;
    let (least, most) = (bound("minItems"), bound("maxItems"));
    if most.is_some_and(|most| count > most || least.is_some_and(|least| count < least)) {
        findings.add(place, format!("expected {}, got {count} of them", describe(schema)));
        return Value::Null;
    }
    if least.is_some_and(|least| count < least) {
        findings.add(place, "must not be empty");
    }
    let Some(inner) = schema.get("items") else { return Value::Array(items.to_vec()) };
    let checked = items.iter().enumerate();
    checked.map(|(index, item)| check_value(item, inner, &Place::Index(place, index), findings)).collect()
}

fn check_number(value: &Value, schema: &Value, place: &Place<'_>, findings: &mut Findings) -> Value {
    let whole = has_type(schema, "integer");
    let problem = match value {
        Value::Number(_) if whole => match as_whole(value) {
            Some(number) => {
                if let Some(message) = range_problem(&number, schema) {
                    findings.add(place, message);
                }
                return number;
            }
            None => format!("expected a whole number, got {value}"),
        },
        Value::Number(_) if has_type(schema, "number") => {
            if let Some(message) = range_problem(value, schema) {
                findings.add(place, message);
            }
            return value.clone();
        }
        Value::String(text) if (whole || has_type(schema, "number")) && is_not_finite(text) => {
            format!("must be finite, got {text}")
        }
        _ => format!("expected {}, got {}", describe(schema), short(value)),
    };
    findings.add(place, problem);
    Value::Null
}

/// Whether a text stands for a number that JSON cannot write.
fn is_not_finite(text: &str) -> bool {
    ["nan", "inf", "-inf"].contains(&text)
}

/// A whole number as such, even if it is written 5.0.
fn as_whole(value: &Value) -> Option<Value> {
    match value.as_f64() {
        _ if value.is_u64() || value.is_i64() => Some(value.clone()),
        Some(number) if number.fract() == 0.0 && number.abs() < 9e15 => Some(Value::from(number as i64)),
        _ => None,
    }
}

/// The schema itself, or the one of its alternatives that the value is meant for.
fn narrow<'a>(value: &Value, schema: &'a Value) -> Result<&'a Value, choice::Mismatch<'a>> {
    match alternatives(schema) {
        Some(all) => choose(value, schema, all),
        None => Ok(schema),
    }
}

/// Follows a reference into the definitions.
fn resolve(schema: &Value) -> &Value {
    let name = schema.get("$ref").and_then(Value::as_str).and_then(|path| path.strip_prefix("#/$defs/"));
    name.and_then(|name| json_schema().get("$defs")?.get(name)).unwrap_or(schema)
}

/// The schema of a key, or of any key.
fn property<'a>(schema: &'a Value, key: &str) -> Option<&'a Value> {
    let named = schema.get("properties").and_then(|properties| properties.get(key));
    named.or_else(|| schema.get("additionalProperties").filter(|any| any.is_object()))
}

fn keys_of(schema: &Value) -> Vec<&str> {
    let properties = schema.get("properties").and_then(Value::as_object);
    properties.into_iter().flat_map(Map::keys).map(String::as_str).collect()
}
