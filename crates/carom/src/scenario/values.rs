//! Single values of a scenario, got and set by their paths.

use super::LARGEST;
use super::nearest::suggestion;
use super::path::{Step, parse, path_of, step_into};
use super::problem::{Findings, Problem, ScenarioError};
use super::schema::{Method, Record, Scenario};
use super::structure::known_keys;
use crate::scalar::angle_deg;
use serde::Deserialize;
use serde_json::{Value, json};
use std::borrow::Cow;

impl Scenario {
    /// This scenario with some of its values changed, checked again; null takes a value out.
    ///
    /// A known key that is absent may be set. The speed or the direction of a ball may be set where its velocity is given in
    /// components: the other one then follows from these. A path that leads into a law of the preset or to a ball of the rack first writes
    /// that law out, or an entry for that ball, so that the rest of it stays. All problems are reported: those of the paths, or else those of the
    /// changed scenario.
    ///
    /// ```
    /// # use carom::scenario::Scenario;
    /// # let midterm = include_str!("../../../../scenarios/midterm.toml");
    /// let scenario = Scenario::from_toml(midterm)?;
    /// let faster = scenario.with_values(&[("balls.red.velocity[0]", 3.5.into()), ("duration", 10.into())])?;
    /// assert_eq!(faster.balls[0].velocity, Some([3.5, 4.0].into()));
    /// # Ok::<(), carom::scenario::ScenarioError>(())
    /// ```
    pub fn with_values<P: AsRef<str>>(&self, values: &[(P, Value)]) -> Result<Self, ScenarioError> {
        if let Some(changed) = self.with_ends(values) {
            return Ok(changed);
        }
        Self::from_value(&with_changes(self.to_value()?, values)?)
    }

    /// The same where the values say nothing but when to end and what to keep, and that plainly: no ball need be looked at
    /// again. What is not as it should be is left to the whole check, which says why.
    fn with_ends<P: AsRef<str>>(&self, values: &[(P, Value)]) -> Option<Self> {
        let mut changed = Cow::Borrowed(self);
        for (path, value) in values {
            let (path, changed) = (path.as_ref(), changed.to_mut());
            let number = value.as_u64().filter(|number| (1..=i64::MAX as u64).contains(number));
            match path {
                "record" => changed.record = Some(Record::deserialize(value).ok()?),
                "duration" => {
                    changed.duration = Some(value.as_f64().filter(|time| (0.0..=LARGEST).contains(time))?)
                }
                "collisions" => changed.collisions = Some(number?),
                "max_events" => changed.max_events = Some(number?),
                _ => return None,
            }
        }
        // How long a stepped run may be depends on its step.
        (values.is_empty() || self.method == Method::Exact).then(|| changed.into_owned().with_plain_record())
    }

    /// The value at a path: what is written there, or else what the preset or the rack gives.
    pub fn value(&self, path: &str) -> Result<Value, ScenarioError> {
        Ok(self.resolve(path)?.1)
    }

    /// A path in the form that problems and numbers use, with places in lists in place of ids: `balls.red.radius`
    /// becomes `balls[0].radius`. An error where the scenario has no value there.
    pub fn place(&self, path: &str) -> Result<String, ScenarioError> {
        Ok(path_of(&self.resolve(path)?.0))
    }

    fn resolve(&self, path: &str) -> Result<(Vec<Step>, Value), ScenarioError> {
        let steps = parse(path)?;
        match self.expanded() {
            Cow::Borrowed(scenario) => scenario.resolve_written(path, &steps),
            Cow::Owned(expanded) => {
                let written = self.resolve_written(path, &steps);
                written.or_else(|problem| expanded.resolve_written(path, &steps).map_err(|_| problem))
            }
        }
    }

    fn resolve_written(&self, path: &str, steps: &[Step]) -> Result<(Vec<Step>, Value), ScenarioError> {
        let whole = self.to_value()?;
        let mut value = &whole;
        let mut taken = Vec::new();
        for step in steps {
            let Some((step, inner)) = step_into(value, step) else {
                let message = why_not(value, step, &known_keys(&whole, &taken));
                return Err(Problem::new(path, message).into());
            };
            taken.push(step);
            value = inner;
        }
        Ok((taken, value.clone()))
    }
}

/// A scenario's value with some values changed.
pub(super) fn with_changes<P: AsRef<str>>(
    mut changed: Value,
    values: &[(P, Value)],
) -> Result<Value, ScenarioError> {
    let mut findings = Findings::default();
    for (path, value) in values {
        let path = path.as_ref();
        let set = parse(path).and_then(|steps| {
            if !value.is_null() {
                write_as_speed(&mut changed, &steps);
            }
            // What is written already need not be looked for in the preset or the rack.
            let under = if is_there(&changed, &steps) { None } else { expanded(&changed) };
            set(&mut changed, under.as_ref(), &steps, value).map_err(|message| Problem::new(path, message))
        });
        if let Err(problem) = set {
            findings.add(problem.place, problem.message);
        }
    }
    findings.into_result()?;
    Ok(changed)
}

fn is_there(value: &Value, steps: &[Step]) -> bool {
    let step_on = |value, step| step_into(value, step).map(|(_, inner)| inner);
    steps.iter().try_fold(value, step_on).is_some()
}

/// A scenario's value with its preset and its rack turned into plain keys, where it has one and can be read.
fn expanded(value: &Value) -> Option<Value> {
    let has_any = value.get("table").and_then(|table| table.get("preset")).or(value.get("rack")).is_some();
    let scenario = if has_any { Scenario::deserialize(value).ok()? } else { return None };
    scenario.expanded().to_value().ok()
}

/// Puts a value at the end of a path; sets of keys on the way are made where they are absent, laws and balls as they stand
/// in the expanded scenario, which is `under`.
fn set(target: &mut Value, under: Option<&Value>, steps: &[Step], value: &Value) -> Result<(), String> {
    let Some((step, rest)) = steps.split_first() else {
        *target = value.clone();
        return Ok(());
    };
    let inside = under.and_then(|under| step_into(under, step)).map(|(_, inside)| inside);
    if let (Value::Object(keys), Step::Key(key)) = (&mut *target, step) {
        if let Some(Step::Index(_)) = rest.first()
            && !keys.contains_key(key)
        {
            return Err(format!("{key} is not set: give the whole list"));
        }
        let inner = keys.entry(key.clone()).or_insert_with(|| beginning(inside));
        return set(inner, inside, rest, value);
    }
    if let (Value::Array(items), Step::Key(id), Some(_)) = (&mut *target, step, inside)
        && items.iter().all(|item| item.get("id").and_then(Value::as_str) != Some(id))
    {
        items.push(json!({ "id": id }));
    }
    let Some((Step::Index(index), _)) = step_into(target, step) else {
        return Err(why_not(target, step, &[]));
    };
    set(&mut target[index], inside, rest, value)
}

/// Where a path leads to the speed or the direction of a ball whose velocity is given in components: writes it as speed and
/// direction.
fn write_as_speed(scenario: &mut Value, steps: &[Step]) {
    let [list @ Step::Key(balls), ball, Step::Key(key)] = steps else { return };
    if balls != "balls" || !["speed", "direction_deg"].contains(&key.as_str()) {
        return;
    }
    let found = step_into(scenario, list).and_then(|(_, balls)| step_into(balls, ball));
    let Some((Step::Index(index), ball)) = found else { return };
    let plan: Option<[f64; 2]> =
        ball.get("velocity").and_then(|velocity| Deserialize::deserialize(velocity).ok());
    if let (Some([x, y]), None) = (plan, ball.get("speed"))
        && let Some(keys) = scenario["balls"][index].as_object_mut()
    {
        keys.shift_remove("velocity");
        keys.insert("speed".into(), (x * x + y * y).sqrt().into());
        keys.insert("direction_deg".into(), angle_deg(x, y).into());
    }
}

/// What an absent key begins with, on the way to a value inside it.
fn beginning(under: Option<&Value>) -> Value {
    match under {
        Some(law) if law.get("law").is_some() => law.clone(),
        Some(Value::Array(_)) => json!([]),
        _ => json!({}),
    }
}

/// Why a step leads nowhere.
fn why_not(value: &Value, step: &Step, known: &[&str]) -> String {
    match (value, step) {
        (Value::Object(_), Step::Key(key)) if known.contains(&key.as_str()) => format!("{key} is not set"),
        (Value::Object(_), Step::Key(key)) => format!("unknown key {key}{}", suggestion(key, known)),
        (Value::Object(_), Step::Index(index)) => format!("[{index}] is for lists, and here are keys"),
        (Value::Array(items), Step::Index(index)) => {
            format!("there is no [{index}]: the list has {} members, counted from 0", items.len())
        }
        (Value::Array(items), Step::Key(id)) => {
            let ids: Vec<&str> = items.iter().filter_map(|item| item.get("id")?.as_str()).collect();
            format!("no member of the list has the id {id:?}{}", suggestion(id, &ids))
        }
        (other, _) => format!("{other} has no parts"),
    }
}
