//! Every ready-made scenario ends on its golden digest, in every build and on every machine.
//!
//! `make digests REASON="..."` mints the digests anew. It refuses to change one while `PHYSICS_VERSION` stays: a
//! trajectory that moves raises it.
#![allow(clippy::expect_used, clippy::unwrap_used, clippy::panic)]

use carom::run::{Digest, PHYSICS_VERSION};
use carom::scenario::Scenario;
use carom::simulate::AnyRun;
use carom::with_any;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use std::path::PathBuf;

/// The committed digests, and why they were last minted.
#[derive(Serialize, Deserialize)]
struct Golden {
    physics_version: u32,
    reason: String,
    digests: BTreeMap<String, Digest>,
}

fn root() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../..")
}

fn golden_file() -> PathBuf {
    root().join("reference/digests.json")
}

fn golden() -> Option<Golden> {
    let text = std::fs::read_to_string(golden_file()).ok()?;
    Some(serde_json::from_str(&text).expect("the file of digests is right"))
}

/// The digest of each ready-made scenario, by name.
fn digests() -> BTreeMap<String, Digest> {
    let files = root().join("scenarios").read_dir().expect("there are scenarios");
    let digest = |path: PathBuf| {
        let name = path.file_stem().unwrap().to_str().unwrap().to_owned();
        let text = std::fs::read_to_string(&path).unwrap();
        let scenario = Scenario::from_toml(&text).unwrap_or_else(|error| panic!("{name}:\n{error}"));
        let run = AnyRun::simulate(&scenario, None, &mut || false)
            .unwrap_or_else(|error| panic!("{name}: {error}"));
        (name, with_any!(run, run => run.digest()).expect("no number is NaN"))
    };
    files.map(|entry| digest(entry.unwrap().path())).collect()
}

/// What differs between two digests, and what that says.
fn difference(name: &str, golden: Option<&Digest>, now: &Digest) -> Option<String> {
    match golden {
        None => Some(format!("{name}: has no golden digest")),
        Some(golden) if golden == now => None,
        Some(golden) if golden.events != now.events => {
            Some(format!("{name}: {} events for {}: the logic moved", now.events, golden.events))
        }
        Some(_) => Some(format!("{name}: other bits after as many events: the arithmetic moved")),
    }
}

#[test]
fn ready_made_scenarios_end_on_their_golden_digests() {
    let now = digests();
    if let Ok(reason) = std::env::var("CAROM_MINT_DIGESTS") {
        return mint(reason, now);
    }
    let golden = golden().expect("the digests are committed");
    let differences: Vec<_> =
        now.iter().filter_map(|(name, now)| difference(name, golden.digests.get(name), now)).collect();
    assert!(differences.is_empty(), "{}", differences.join("\n"));
    assert_eq!(golden.physics_version, PHYSICS_VERSION, "minted with another version of the physics");
    let gone: Vec<_> = golden.digests.keys().filter(|name| !now.contains_key(*name)).collect();
    assert!(gone.is_empty(), "digests without a scenario: {gone:?}");
}

fn mint(reason: String, digests: BTreeMap<String, Digest>) {
    assert!(!reason.trim().is_empty(), "say why: make digests REASON=\"...\"");
    if let Some(old) = golden().filter(|old| old.physics_version == PHYSICS_VERSION) {
        let moved: Vec<_> = digests
            .iter()
            .filter(|(name, _)| old.digests.contains_key(*name))
            .filter_map(|(name, now)| difference(name, old.digests.get(name), now))
            .collect();
        assert!(moved.is_empty(), "raise PHYSICS_VERSION first:\n{}", moved.join("\n"));
    }
    let golden = Golden { physics_version: PHYSICS_VERSION, reason, digests };
    let text = serde_json::to_string_pretty(&golden).unwrap();
    std::fs::write(golden_file(), text + "\n").unwrap();
}
