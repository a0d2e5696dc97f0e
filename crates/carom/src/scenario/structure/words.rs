//! How schemas, values and ranges are put into words.

use super::choice::{alternatives, key_of, tag_of};
use super::resolve;
use serde_json::Value;

/// Whether a schema is of a type, such as "number".
pub(super) fn has_type(schema: &Value, name: &str) -> bool {
    schema.get("type").and_then(Value::as_str) == Some(name)
}

/// What a schema wants, as in "expected a list of 2 numbers".
pub(super) fn describe(schema: &Value) -> String {
    if let Some(all) = alternatives(schema) {
        return describe_alternatives(all);
    }
    let bound = |key| schema.get(key).and_then(Value::as_u64);
    let count = bound("maxItems").map(|most| match bound("minItems") {
        Some(least) if least < most => format!("{least} or {most}"),
        _ => most.to_string(),
    });
    match (schema.get("type").and_then(Value::as_str).unwrap_or_default(), count) {
        ("number", _) => "a number".into(),
        ("integer", _) => "a whole number".into(),
        ("string", _) => "text".into(),
        ("boolean", _) => "true or false".into(),
        ("array", None) => "a list".into(),
        ("array", Some(count)) => match schema.get("items").map(resolve) {
            Some(item) if has_type(item, "number") => format!("a list of {count} numbers"),
            Some(item) if has_type(item, "array") => format!("a list of {count} points [x, y]"),
            _ => format!("a list of {count}"),
        },
        _ => "a set of keys".into(),
    }
}

fn describe_alternatives(all: &[Value]) -> String {
    let words: Vec<&str> = all.iter().filter_map(|schema| schema.get("const")?.as_str()).collect();
    if !words.is_empty() {
        return format!("one of {}", words.join(", "));
    }
    let mut kinds: Vec<String> = all.iter().map(|schema| describe(resolve(schema))).collect();
    kinds.dedup();
    match all.first().and_then(tag_of) {
        Some(tag) => {
            let keys = all.iter().map(resolve).filter_map(|schema| key_of(schema, tag));
            format!("a set of keys with {}", [tag].into_iter().chain(keys).collect::<Vec<_>>().join(" or "))
        }
        None => kinds.join(" or "),
    }
}

/// A value as it is quoted in a message.
pub(super) fn short(value: &Value) -> String {
    const LONGEST: usize = 40;
    let text = value.to_string();
    if text.chars().count() <= LONGEST {
        return text;
    }
    let start: String = text.chars().take(LONGEST - 3).collect();
    start + "..."
}

/// What is wrong with a number that is out of its range.
pub(super) fn range_problem(value: &Value, schema: &Value) -> Option<String> {
    let bound = |key| schema.get(key).and_then(Value::as_f64);
    let number = value.as_f64()?;
    let (least, above, most) = (bound("minimum"), bound("exclusiveMinimum"), bound("maximum"));
    let inside = least.is_none_or(|least| number >= least)
        && above.is_none_or(|above| number > above)
        && most.is_none_or(|most| number <= most);
    if inside {
        return None;
    }
    let real = has_type(schema, "number");
    let range = match (least, above, most) {
        (Some(least), _, Some(most)) if real => format!("between {least} and {most}"),
        (.., Some(most)) if number > most => format!("at most {most}"),
        (Some(0.0), ..) if real => "zero or positive and finite".into(),
        (Some(0.0), ..) => "zero or positive".into(),
        (Some(least), ..) => format!("at least {least}"),
        _ => "positive and finite".into(),
    };
    Some(format!("must be {range}, got {value}"))
}
