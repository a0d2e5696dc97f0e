//! Which of several alternatives a value is meant for.
//!
//! The scenario's schema has three kinds: one of some words; sets of keys told apart by the word under one key (a tag),
//! or by which key they have, or by both; and values of different types.

use super::words::{describe, has_type, short};
use super::{keys_of, property, resolve};
use crate::scenario::nearest::{nearest, suggestion};
use serde_json::Value;

/// Why a value fits none of the alternatives.
pub(super) struct Mismatch<'a> {
    /// The key inside the value at which this shows, if it is not the value itself.
    pub key: Option<&'a str>,
    /// What is wrong.
    pub message: String,
}

impl Mismatch<'_> {
    fn here(message: String) -> Self {
        Mismatch { key: None, message }
    }
}

/// The alternatives of a schema that has some.
pub(super) fn alternatives(schema: &Value) -> Option<&Vec<Value>> {
    schema.get("oneOf").or_else(|| schema.get("anyOf"))?.as_array()
}

/// The alternative that a value is meant for.
pub(super) fn choose<'a>(value: &Value, schema: &Value, all: &'a [Value]) -> Result<&'a Value, Mismatch<'a>> {
    let of_type: Vec<&Value> = all.iter().map(resolve).filter(|schema| is_of_type(value, schema)).collect();
    match of_type.as_slice() {
        [] => Err(Mismatch::here(format!("expected {}, got {}", describe(schema), short(value)))),
        [only] => Ok(*only),
        [first, ..] if first.get("const").is_some() => choose_word(value, &of_type),
        [first, ..] => match tag_of(first) {
            Some(tag) => choose_tagged_or_keyed(value, &of_type, tag),
            None => choose_by_key(value, &of_type),
        },
    }
}

fn is_of_type(value: &Value, schema: &Value) -> bool {
    match value {
        Value::Object(_) => has_type(schema, "object"),
        Value::Array(_) => has_type(schema, "array"),
        Value::String(_) => has_type(schema, "string"),
        Value::Number(_) => has_type(schema, "number") || has_type(schema, "integer"),
        Value::Bool(_) => has_type(schema, "boolean"),
        Value::Null => false,
    }
}

/// The key whose word tells alternatives apart.
pub(super) fn tag_of(schema: &Value) -> Option<&str> {
    keys_of(schema)
        .into_iter()
        .find(|key| property(schema, key).is_some_and(|inner| inner.get("const").is_some()))
}

/// Among alternatives with a tag and such as have a key of their own in its place, as a table has a shape or a preset.
fn choose_tagged_or_keyed<'a>(
    value: &Value,
    all: &[&'a Value],
    tag: &'a str,
) -> Result<&'a Value, Mismatch<'a>> {
    let tagged: Vec<&Value> = all.iter().copied().filter(|schema| property(schema, tag).is_some()).collect();
    for (schema, key) in all.iter().filter_map(|schema| Some((*schema, key_of(schema, tag)?))) {
        match (value.get(key).is_some(), value.get(tag).is_some()) {
            (true, true) => {
                let message = format!("is given beside {tag}: give only one of them");
                return Err(Mismatch { key: Some(key), message });
            }
            (true, false) => return Ok(schema),
            (false, true) => {}
            (false, false) => {
                return choose_tagged(value, &tagged, tag).map_err(|mismatch| Mismatch {
                    message: format!("{}; or give {key}", mismatch.message),
                    ..mismatch
                });
            }
        }
    }
    choose_tagged(value, &tagged, tag)
}

/// The key that an alternative without the tag has in its place.
pub(super) fn key_of<'a>(schema: &'a Value, tag: &str) -> Option<&'a str> {
    property(schema, tag).is_none().then(|| schema.get("required")?.get(0)?.as_str()).flatten()
}

fn choose_tagged<'a>(value: &Value, all: &[&'a Value], tag: &'a str) -> Result<&'a Value, Mismatch<'a>> {
    let words: Vec<&str> = all.iter().filter_map(|schema| word_of(property(schema, tag)?)).collect();
    let Some(word) = value.get(tag) else {
        let message = format!("missing: expected one of {}", words.join(", "));
        return Err(Mismatch { key: Some(tag), message });
    };
    let chosen = words.iter().position(|known| word == known).and_then(|index| all.get(index));
    chosen.copied().ok_or_else(|| Mismatch { key: Some(tag), message: not_a_word(word, tag, &words) })
}

fn choose_word<'a>(value: &Value, all: &[&'a Value]) -> Result<&'a Value, Mismatch<'a>> {
    let words: Vec<&str> = all.iter().filter_map(|schema| word_of(schema)).collect();
    let chosen = words.iter().position(|known| value == known).and_then(|index| all.get(index));
    chosen.copied().ok_or_else(|| Mismatch::here(not_a_word(value, "value", &words)))
}

fn word_of(schema: &Value) -> Option<&str> {
    schema.get("const")?.as_str()
}

fn not_a_word(value: &Value, what: &str, words: &[&str]) -> String {
    match value {
        Value::String(word) => format!("unknown {what} {}{}", short(value), suggestion(word, words)),
        _ => format!("expected one of {}, got {}", words.join(", "), short(value)),
    }
}

/// The alternative whose first required key the value has.
fn choose_by_key<'a>(value: &Value, all: &[&'a Value]) -> Result<&'a Value, Mismatch<'a>> {
    let key_of = |schema: &'a Value| schema.get("required")?.get(0)?.as_str();
    let known: Vec<(&str, &Value)> =
        all.iter().filter_map(|schema| Some((key_of(schema)?, *schema))).collect();
    let present: Vec<_> = known.iter().filter(|(key, _)| value.get(key).is_some()).collect();
    let names = |some: &[&(&'a str, &Value)]| some.iter().map(|(key, _)| *key).collect::<Vec<_>>();
    match present.as_slice() {
        [(_, only)] => Ok(only),
        [] => Err(Mismatch::here(needs_one_of(value, &names(&known.iter().collect::<Vec<_>>())))),
        several => {
            Err(Mismatch::here(format!("has {}: give only one of them", names(several).join(" and "))))
        }
    }
}

fn needs_one_of(value: &Value, known: &[&str]) -> String {
    let mut message = format!("needs one of the keys {}", known.join(", "));
    let given = value.as_object().into_iter().flat_map(|keys| keys.keys());
    if let Some((given, near)) = given.filter_map(|given| Some((given, nearest(given, known)?))).next() {
        message += &format!("; did you mean {near} instead of {given}?");
    }
    message
}
