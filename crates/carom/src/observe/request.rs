//! Names and options of what is to be observed, as they are written in a file or given from Python.

use super::error::ObserveError;
use crate::scenario::suggestion;
use serde::de::DeserializeOwned;
use serde::{Deserialize, Serialize};
use serde_json::{Map, Value};

/// An observable that is asked for: its name, and those of its options that are not to have their defaults.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Request {
    /// One of [`super::NAMES`].
    pub name: String,
    /// The options by their names.
    #[serde(flatten)]
    pub options: Map<String, Value>,
}

impl Request {
    /// An observable with its defaults.
    pub fn new(name: &str) -> Self {
        Self { name: name.to_owned(), options: Map::new() }
    }

    /// The request with an option more.
    #[must_use]
    pub fn with(mut self, option: &str, value: impl Into<Value>) -> Self {
        self.options.insert(option.to_owned(), value.into());
        self
    }
}

/// The options of an observable, all of which have defaults.
pub(super) trait Options: Default + Serialize + DeserializeOwned {
    /// Refuses values out of range, in words.
    fn check(&self) -> Result<(), String>;

    /// The options of a request.
    fn read(observable: &'static str, given: &Map<String, Value>) -> Result<Self, ObserveError> {
        let bad = |problem: String| ObserveError::BadOption { observable, problem };
        let defaults = serde_json::to_value(Self::default()).map_err(|error| bad(error.to_string()))?;
        let Value::Object(mut options) = defaults else { return Ok(Self::default()) };
        for (option, value) in given {
            let Some(place) = options.get_mut(option) else {
                let known: Vec<&str> = options.keys().map(String::as_str).collect();
                let hint = hint(option, &known);
                return Err(ObserveError::UnknownOption { observable, option: option.clone(), hint });
            };
            *place = value.clone();
        }
        let read = |error: serde_path_to_error::Error<serde_json::Error>| {
            bad(format!("{}: {}", error.path(), error.inner()))
        };
        let options: Self = serde_path_to_error::deserialize(Value::Object(options)).map_err(read)?;
        options.check().map_err(bad)?;
        Ok(options)
    }
}

/// What has no options.
#[derive(Default, Serialize, Deserialize)]
pub(super) struct NoOptions {}

impl Options for NoOptions {
    fn check(&self) -> Result<(), String> {
        Ok(())
    }
}

/// "; did you mean this?" where a near word is known, and all known ones.
pub(super) fn hint(word: &str, known: &[&str]) -> String {
    if known.is_empty() { "; it has none".to_owned() } else { suggestion(word, known) }
}
