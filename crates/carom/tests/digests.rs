//! Golden digests: every ready-made scenario ends in the same bits, in debug and release builds and on every platform.
//!
//! The same file is read by the tests of the Python package. To mint it anew after a change that moves trajectories,
//! raise `PHYSICS_VERSION`, and run
//!
//! ```text
//! CAROM_MINT="why they moved" cargo test -p carom --test digests
//! ```

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

mod kit;

use carom::run::{Digest, PHYSICS_VERSION};
use carom::scenario::Scenario;
use carom::simulate::simulate;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use std::path::PathBuf;

/// The committed digests, and why they were last minted.
#[derive(Serialize, Deserialize)]
struct Golden {
    physics_version: u32,
    reasons: Vec<String>,
    digests: BTreeMap<String, Digest>,
}

fn path() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("tests/golden/digests.json")
}

fn digest_of(name: &str, text: &str) -> Digest {
    let scenario = Scenario::from_toml(text).unwrap_or_else(|error| panic!("{name}: {error}"));
    let run = simulate(&scenario).unwrap_or_else(|error| panic!("{name}: {error}"));
    run.digest().unwrap_or_else(|| panic!("{name}: the end holds a NaN"))
}

fn mint(reason: String, digests: BTreeMap<String, Digest>) {
    let known =
        std::fs::read_to_string(path()).ok().map(|text| serde_json::from_str::<Golden>(&text).unwrap());
    let mut reasons = known.map_or_else(Vec::new, |golden| golden.reasons);
    reasons.push(format!("physics {PHYSICS_VERSION}: {reason}"));
    let golden = Golden { physics_version: PHYSICS_VERSION, reasons, digests };
    std::fs::write(path(), serde_json::to_string_pretty(&golden).unwrap() + "\n").unwrap();
}

#[test]
fn every_scenario_ends_in_its_golden_bits() {
    let digests: BTreeMap<String, Digest> = kit::scenario_files()
        .into_iter()
        .map(|(name, text)| (name.clone(), digest_of(&name, &text)))
        .collect();
    if let Ok(reason) = std::env::var("CAROM_MINT") {
        return mint(reason, digests);
    }
    let golden: Golden = serde_json::from_str(&std::fs::read_to_string(path()).unwrap()).unwrap();
    assert_eq!(
        golden.physics_version, PHYSICS_VERSION,
        "the digests belong to another version of the physics"
    );
    let names = |map: &BTreeMap<String, Digest>| map.keys().cloned().collect::<Vec<_>>();
    assert_eq!(names(&golden.digests), names(&digests), "scenarios were added or removed");
    for (name, digest) in &digests {
        let expected = &golden.digests[name];
        assert_eq!(digest.events, expected.events, "{name}: the number of events moved, so logic did");
        assert_eq!(
            digest.end_time, expected.end_time,
            "{name}: the end time moved, so arithmetic or logic did"
        );
        assert_eq!(digest.state, expected.state, "{name}: the final state moved, so arithmetic did");
    }
}
