//! The one path grammar: `balls.red.velocity[0]`, `balls[0].radius`, `balls."8".radius`, `table.pieces[2].arc.radius`.
//!
//! A path is a chain of keys joined by dots and of places in a list, counted from 0, in square brackets. In a list whose
//! members have an `id`, the id may stand in place of the number, as a key. A key that is not a word (a letter or `_`,
//! then letters, digits, `_` and `-`) is written in double quotes.

use super::Problem;
use core::fmt;
use serde_json::Value;

/// A place in a scenario, while its value is walked through.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Place<'a> {
    /// The whole scenario.
    Root,
    /// A key of a set of keys.
    Key(&'a Place<'a>, &'a str),
    /// A member of a list.
    Index(&'a Place<'a>, usize),
}

/// A key as it is written in a path: in quotes where it is not a word.
#[derive(Clone, Copy, Debug)]
pub struct Key<'a>(pub &'a str);

/// One step of a path.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Step {
    /// Into a set of keys, or to the member of a list with this id.
    Key(String),
    /// To the member of a list at this place.
    Index(usize),
}

impl fmt::Display for Place<'_> {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Place::Root => write!(out, "scenario"),
            Place::Key(Place::Root, key) => write!(out, "{}", Key(key)),
            Place::Key(parent, key) => write!(out, "{parent}.{}", Key(key)),
            Place::Index(parent, index) => write!(out, "{parent}[{index}]"),
        }
    }
}

impl fmt::Display for Key<'_> {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        if is_word(self.0) { write!(out, "{}", self.0) } else { write!(out, "\"{}\"", self.0) }
    }
}

/// Steps as a path is written.
pub(crate) fn path_of(steps: &[Step]) -> String {
    let mut path = String::new();
    for step in steps {
        match step {
            Step::Key(key) if path.is_empty() => path += &Key(key).to_string(),
            Step::Key(key) => path += &format!(".{}", Key(key)),
            Step::Index(index) => path += &format!("[{index}]"),
        }
    }
    path
}

fn is_word(key: &str) -> bool {
    let starts_well = key.starts_with(|first: char| first.is_alphabetic() || first == '_');
    starts_well && key.chars().all(is_word_character)
}

fn is_word_character(character: char) -> bool {
    character.is_alphanumeric() || character == '_' || character == '-'
}

/// Reads a path.
pub(crate) fn parse(path: &str) -> Result<Vec<Step>, Problem> {
    let mut steps = Vec::new();
    let mut rest = path;
    while !rest.is_empty() || steps.is_empty() {
        let (step, after) = if let Some(inside) = rest.strip_prefix('[') {
            parse_index(inside)
        } else {
            let dot = rest.strip_prefix('.').filter(|_| !steps.is_empty());
            match dot {
                None if !steps.is_empty() => Err(format!("expected . or [ before {rest}")),
                _ => parse_key(dot.unwrap_or(rest)),
            }
        }
        .map_err(|message| Problem::new(path, message))?;
        steps.push(step);
        rest = after;
    }
    Ok(steps)
}

fn parse_index(inside: &str) -> Result<(Step, &str), String> {
    let (digits, after) = inside.split_once(']').ok_or("a [ is not closed")?;
    let index = digits.parse().map_err(|_| format!("expected a number counted from 0 in [{digits}]"))?;
    Ok((Step::Index(index), after))
}

fn parse_key(text: &str) -> Result<(Step, &str), String> {
    if let Some(inside) = text.strip_prefix('"') {
        let (key, after) = inside.split_once('"').ok_or("a \" is not closed")?;
        return Ok((Step::Key(key.into()), after));
    }
    let end = text.find(|character| !is_word_character(character)).unwrap_or(text.len());
    let (key, after) = text.split_at(end);
    if is_word(key) {
        Ok((Step::Key(key.into()), after))
    } else if key.is_empty() {
        Err(format!("expected a key before {}", if text.is_empty() { "the end" } else { text }))
    } else {
        Err(format!("{key} is not a word: write [{key}] for a place in a list or \"{key}\" for an id or key"))
    }
}

/// Follows one step, into a set of keys or a list; the step taken, with an id turned into its place in the list.
pub(crate) fn step_into<'a>(value: &'a Value, step: &Step) -> Option<(Step, &'a Value)> {
    match (value, step) {
        (Value::Object(keys), Step::Key(key)) => Some((step.clone(), keys.get(key)?)),
        (Value::Array(items), Step::Index(index)) => Some((step.clone(), items.get(*index)?)),
        (Value::Array(items), Step::Key(id)) => {
            let index = items.iter().position(|item| item.get("id").and_then(Value::as_str) == Some(id))?;
            Some((Step::Index(index), &items[index]))
        }
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;

    #[test]
    fn paths_are_read_and_written_alike() {
        for path in
            ["balls.red.velocity[0]", "balls[0].radius", "balls.\"8\".radius", "duration", "a.\"\".b[3][4]"]
        {
            assert_eq!(path_of(&parse(path).unwrap()), path);
        }
        assert_eq!(parse("a[1]").unwrap(), [Step::Key("a".into()), Step::Index(1)]);
    }

    #[test]
    fn a_wrong_path_says_what_is_wrong_with_it() {
        let message = |path| parse(path).unwrap_err().message;
        assert_eq!(message(""), "expected a key before the end");
        assert_eq!(message("balls."), "expected a key before the end");
        assert_eq!(message(".balls"), "expected a key before .balls");
        assert_eq!(message("balls[x]"), "expected a number counted from 0 in [x]");
        assert_eq!(message("balls[-1]"), "expected a number counted from 0 in [-1]");
        assert_eq!(message("balls[1"), "a [ is not closed");
        assert_eq!(message("balls.\"8.radius"), "a \" is not closed");
        assert_eq!(message("balls[1]radius"), "expected . or [ before radius");
        assert!(message("balls.8.radius").starts_with("8 is not a word: write [8]"));
    }
}
