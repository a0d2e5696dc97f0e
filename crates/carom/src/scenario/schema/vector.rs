//! Vectors as they are written: two numbers in the plane of the table, or three in space.

use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::{Deserialize, Serialize};
use std::borrow::Cow;

/// A vector: [x, y] in the plane of the table, or [x, y, z] with z up from it.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(try_from = "Vec<f64>", into = "Vec<f64>")]
pub struct Vector {
    /// The components x and y.
    pub plan: [f64; 2],
    /// The component z, where it is given.
    pub up: Option<f64>,
}

impl Vector {
    /// A vector in space.
    pub fn in_space([x, y, z]: [f64; 3]) -> Self {
        Self { plan: [x, y], up: Some(z) }
    }

    /// The components that are given, in order.
    pub fn components(&self) -> impl Iterator<Item = f64> {
        self.plan.into_iter().chain(self.up)
    }
}

impl From<[f64; 2]> for Vector {
    fn from(plan: [f64; 2]) -> Self {
        Self { plan, up: None }
    }
}

impl From<Vector> for Vec<f64> {
    fn from(vector: Vector) -> Self {
        vector.components().collect()
    }
}

impl TryFrom<Vec<f64>> for Vector {
    type Error = String;

    fn try_from(numbers: Vec<f64>) -> Result<Self, String> {
        match numbers[..] {
            [x, y] => Ok([x, y].into()),
            [x, y, z] => Ok(Self::in_space([x, y, z])),
            _ => Err(format!("expected a list of 2 or 3 numbers, got {} of them", numbers.len())),
        }
    }
}

impl JsonSchema for Vector {
    fn inline_schema() -> bool {
        true
    }

    fn schema_name() -> Cow<'static, str> {
        "Vector".into()
    }

    fn json_schema(_: &mut SchemaGenerator) -> Schema {
        json_schema!({ "type": "array", "items": { "type": "number" }, "minItems": 2, "maxItems": 3 })
    }
}
