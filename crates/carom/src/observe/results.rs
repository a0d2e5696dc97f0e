//! What observing gives: numbers and curves, with units and errors.

use super::blocks::Blocks;
use serde::Serialize;

/// What one observable found.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Results {
    /// The observable's name.
    pub name: &'static str,
    /// The numbers.
    pub quantities: Vec<Quantity>,
    /// The curves.
    pub curves: Vec<Curve>,
}

/// A number with its standard error.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Quantity {
    /// What it is called.
    pub name: &'static str,
    /// Its dimension in words, such as "energy/length^2"; "1" for a pure number.
    pub unit: &'static str,
    /// What it is, and what is expected of it.
    pub description: &'static str,
    /// The number; `None` where too little was seen.
    pub value: Option<f64>,
    /// Its standard error from block averages; `None` where too little was seen, or for a number that is not measured.
    pub error: Option<f64>,
    /// What theory expects, where the description says so.
    pub expected: Option<f64>,
}

/// Columns of one length.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Curve {
    /// What it is called.
    pub name: &'static str,
    /// Its columns, what it is drawn over first.
    pub columns: Vec<Column>,
}

/// The numbers of a column; NaN where there is none.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Column {
    /// What it is called.
    pub name: &'static str,
    /// Its dimension in words.
    pub unit: &'static str,
    /// What it is.
    pub description: &'static str,
    /// Its numbers.
    pub values: Vec<f64>,
}

impl Quantity {
    /// A measured number.
    pub(super) fn measured(
        [name, unit, description]: [&'static str; 3],
        blocks: &Blocks,
        expected: Option<f64>,
    ) -> Self {
        Self { name, unit, description, value: blocks.value(), error: blocks.error(), expected }
    }

    /// A number that is known without a measurement.
    pub(super) fn known([name, unit, description]: [&'static str; 3], value: f64) -> Self {
        Self { name, unit, description, value: Some(value), error: None, expected: None }
    }

    /// The quantity that is larger by a known number.
    pub(super) fn plus(mut self, shift: f64) -> Self {
        self.value = self.value.map(|value| value + shift);
        self
    }

    /// The quantity times a known number.
    pub(super) fn times(mut self, factor: f64) -> Self {
        self.value = self.value.map(|value| value * factor);
        self.error = self.error.map(|error| error * factor.abs());
        self
    }
}

impl Column {
    /// A column.
    pub(super) fn new([name, unit, description]: [&'static str; 3], values: Vec<f64>) -> Self {
        Self { name, unit, description, values }
    }

    /// A measured column and that of its errors.
    pub(super) fn measured(
        value: [&'static str; 3],
        error_name: &'static str,
        blocks: &[Blocks],
    ) -> [Self; 2] {
        let values = blocks.iter().map(|blocks| blocks.value().unwrap_or(f64::NAN)).collect();
        let errors = blocks.iter().map(|blocks| blocks.error().unwrap_or(f64::NAN)).collect();
        [
            Self::new(value, values),
            Self::new([error_name, value[1], "standard error, from block averages"], errors),
        ]
    }
}

impl Results {
    /// The number of that name.
    pub fn quantity(&self, name: &str) -> Option<&Quantity> {
        self.quantities.iter().find(|quantity| quantity.name == name)
    }

    /// A column of a curve, by their names.
    pub fn column(&self, curve: &str, column: &str) -> Option<&[f64]> {
        let curve = self.curves.iter().find(|candidate| candidate.name == curve)?;
        let column = curve.columns.iter().find(|candidate| candidate.name == column)?;
        Some(&column.values)
    }
}
