//! The arrows of import point one way, and `ARCHITECTURE.md` names what exists.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use std::path::{Path, PathBuf};

/// Rooms in order; rooms of one row do not know each other.
const ROWS: [&[&str]; 12] = [
    &["scalar"],
    &["geometry"],
    &["roots"],
    &["model"],
    &["flight"],
    &["detect", "law"],
    &["gas"],
    &["scenario"],
    &["aim", "run"],
    &["engine", "observe", "stepped"],
    &["simulate"],
    &["ensemble"],
];

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

fn rust_files(folder: &Path) -> Vec<PathBuf> {
    let mut files = Vec::new();
    for entry in folder.read_dir().unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            files.extend(rust_files(&path));
        } else if path.extension().is_some_and(|extension| extension == "rs") {
            files.push(path);
        }
    }
    files
}

fn row_of(room: &str) -> Option<usize> {
    ROWS.iter().position(|row| row.contains(&room))
}

/// The code of a file without its tests and comments.
fn code_of(path: &Path) -> String {
    let text = std::fs::read_to_string(path).unwrap();
    let code = text.split("#[cfg(test)]").next().unwrap();
    code.lines().filter(|line| !line.trim_start().starts_with("//")).collect::<Vec<_>>().join("\n")
}

#[test]
fn rooms_import_only_from_rooms_below_them() {
    for (row, rooms) in ROWS.iter().enumerate() {
        for room in *rooms {
            for path in rust_files(&root().join("crates/carom/src").join(room)) {
                for (at, _) in code_of(&path).match_indices("crate::") {
                    let rest = &code_of(&path)[at + 7..];
                    let target: String =
                        rest.chars().take_while(|c| c.is_alphanumeric() || *c == '_').collect();
                    let Some(below) = row_of(&target) else { continue };
                    let is_allowed = below < row || target == *room;
                    assert!(is_allowed, "{} imports {target}", path.display());
                }
            }
        }
    }
}

#[test]
fn every_room_of_the_engine_has_its_row() {
    for entry in root().join("crates/carom/src").read_dir().unwrap() {
        let path = entry.unwrap().path();
        let name = path.file_name().unwrap().to_str().unwrap().to_owned();
        assert!(!path.is_dir() || row_of(&name).is_some(), "{name} has no place in the order of imports");
    }
}

#[test]
fn architecture_names_only_what_exists() {
    let text = std::fs::read_to_string(root().join("ARCHITECTURE.md")).unwrap();
    let starts = ["crates/", "python/", "scenarios", "tests/", "CHANGELOG"];
    let is_path_character = |c: char| c.is_alphanumeric() || "/._-".contains(c);
    let words =
        text.split(|c: char| !is_path_character(c)).filter(|word| starts.iter().any(|s| word.starts_with(s)));
    let mut seen = 0;
    for word in words {
        let path = word.trim_end_matches('.');
        assert!(root().join(path).exists(), "ARCHITECTURE.md names {path}, which does not exist");
        seen += 1;
    }
    assert!(seen > 20);
    assert!(text.lines().count() <= 90, "ARCHITECTURE.md is more than a page");
}
