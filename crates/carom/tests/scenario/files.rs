//! The scenarios that come with carom are right, and keep their meaning when they are written and read again.

use carom::scenario::Scenario;
use std::path::PathBuf;

/// The name and text of every file in `scenarios/`.
fn scenario_files() -> Vec<(String, String)> {
    let folder = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../../scenarios");
    let mut files: Vec<PathBuf> = folder.read_dir().unwrap().map(|entry| entry.unwrap().path()).collect();
    files.sort();
    let stem = |path: &PathBuf| path.file_stem().unwrap().to_str().unwrap().to_owned();
    files.iter().map(|path| (stem(path), std::fs::read_to_string(path).unwrap())).collect()
}

#[test]
fn every_scenario_file_passes_its_check() {
    let files = scenario_files();
    assert!(files.len() >= 13, "only {} scenarios found", files.len());
    for (name, text) in files {
        let scenario = Scenario::from_toml(&text).unwrap_or_else(|error| panic!("{name}:\n{error}"));
        scenario.check().unwrap_or_else(|error| panic!("{name}:\n{error}"));
        assert!(
            scenario.title.is_some_and(|title| title.len() < 60),
            "{name} must have a title of less than 60 bytes"
        );
        assert!(
            scenario.description.is_some_and(|text| text.len() > 80),
            "{name} must say what to look at, in a description of more than 80 bytes"
        );
        assert!(
            !text.contains("  \n") && text.ends_with('\n') && !text.contains('\t'),
            "{name} must have no tabs, no spaces at ends of lines, and a line end at its end"
        );
    }
}

#[test]
fn every_scenario_survives_json_and_toml_bit_for_bit() {
    for (name, text) in scenario_files() {
        let scenario = Scenario::from_toml(&text).unwrap();
        let (json, toml) = (scenario.to_json().unwrap(), scenario.to_toml().unwrap());
        assert_eq!(Scenario::from_json(&json).as_ref(), Ok(&scenario), "{name} as JSON");
        assert_eq!(Scenario::from_toml(&toml).as_ref(), Ok(&scenario), "{name} as TOML");
        assert_eq!(
            Scenario::from_json(&json).unwrap().to_json().unwrap(),
            json,
            "{name}: one text for one scenario"
        );
    }
}
