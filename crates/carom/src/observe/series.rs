//! What changes in the course of time, on at most so many points.

use super::results::{Column, Curve};
use serde::{Deserialize, Serialize};

/// Values over time: when there are too many points, each two neighbours become one, their mean.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub(super) struct Series {
    /// How many points there may be.
    most: usize,
    /// How many samples a point is the mean of.
    samples: u64,
    points: Vec<Point>,
    /// The sum over the samples of the point to come, and their number.
    coming: (Point, u64),
}

/// A time and what there was then.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub(super) struct Point {
    pub time: f64,
    pub value: f64,
    /// The standard error of the value, which does not shrink where points become one: neighbours are not independent.
    pub error: f64,
    /// What theory expects.
    pub expected: f64,
}

impl Series {
    /// Refuses a number of points that cannot be halved.
    pub fn check(most: usize) -> Result<(), String> {
        let is_fit = most >= 2 && most.is_multiple_of(2);
        if is_fit { Ok(()) } else { Err("points must be an even number, 2 at least".to_owned()) }
    }

    /// An empty series.
    pub fn new(most: usize) -> Self {
        Self { most, samples: 1, points: Vec::new(), coming: Default::default() }
    }

    /// Takes in the next sample.
    pub fn push(&mut self, point: Point) {
        if self.points.len() == self.most {
            self.points = self.points.chunks(2).map(|pair| pair[0].plus(&pair[1]).over(2.0)).collect();
            self.samples *= 2;
        }
        self.coming = (self.coming.0.plus(&point), self.coming.1 + 1);
        if self.coming.1 == self.samples {
            self.points.push(self.coming.0.over(self.samples as f64));
            self.coming = Default::default();
        }
    }

    /// The points, with a last one of the samples that are not yet enough for a whole one.
    fn all(&self) -> Vec<Point> {
        let (sum, count) = self.coming;
        let last = (count > 0).then(|| sum.over(count as f64));
        self.points.iter().copied().chain(last).collect()
    }

    /// The curve: time, the value, its error, and what is expected where that has a name.
    pub fn curve(
        &self,
        value: [&'static str; 3],
        error: [&'static str; 3],
        expected: Option<[&'static str; 3]>,
    ) -> Curve {
        let points = self.all();
        let column = |of: fn(&Point) -> f64| points.iter().map(of).collect();
        let time = ["time", "time", "mean time of the samples of the point"];
        let mut columns = vec![
            Column::new(time, column(|point| point.time)),
            Column::new(value, column(|point| point.value)),
            Column::new(error, column(|point| point.error)),
        ];
        columns.extend(expected.map(|expected| Column::new(expected, column(|point| point.expected))));
        Curve { name: "over_time", columns }
    }
}

impl Point {
    fn plus(&self, other: &Self) -> Self {
        Self {
            time: self.time + other.time,
            value: self.value + other.value,
            error: self.error + other.error,
            expected: self.expected + other.expected,
        }
    }

    fn over(&self, count: f64) -> Self {
        Self {
            time: self.time / count,
            value: self.value / count,
            error: self.error / count,
            expected: self.expected / count,
        }
    }
}
