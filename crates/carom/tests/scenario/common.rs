//! What the tests of scenarios share.

use carom::scenario::{Scenario, json_schema};

/// The scenario that the tests break in one place at a time.
pub const MIDTERM: &str = include_str!("../../../../scenarios/midterm.toml");

/// All problems of a TOML text, one a line as they are shown.
pub fn problems(text: &str) -> Vec<String> {
    match Scenario::from_toml(text) {
        Ok(_) => Vec::new(),
        Err(error) => error.to_string().lines().map(str::to_owned).collect(),
    }
}

/// All problems of the midterm scenario with one part of its text replaced.
pub fn broken(part: &str, by: &str) -> Vec<String> {
    assert!(MIDTERM.contains(part), "{part} is in the text");
    problems(&MIDTERM.replacen(part, by, 1))
}

/// All problems of a scenario with this `[table]` and one small ball.
pub fn on_table(table: &str) -> Vec<String> {
    problems(&format!(
        "duration = 1\n[table]\n{table}\n[[balls]]\nid = 'a'\nradius = 0.01\nposition = [0.5, 0.2]\n"
    ))
}

/// All problems of a unit square with these obstacles and a small ball at (0.5, 0.2).
pub fn with_obstacles(obstacles: &str) -> Vec<String> {
    on_table(&format!("shape = 'rectangle'\nwidth = 1\nlength = 1\nobstacles = [{obstacles}]"))
}

/// The words between which a scenario chooses, in the order of the schema: `elastic, restitution`.
pub fn choices(definition: &str, tag: &str) -> String {
    let word = |choice: &serde_json::Value| choice["properties"][tag]["const"].as_str().map(str::to_owned);
    let definition = &json_schema()["$defs"][definition];
    let choices = definition.get("oneOf").or(definition.get("anyOf")).unwrap().as_array().unwrap();
    choices.iter().filter_map(word).collect::<Vec<_>>().join(", ")
}
