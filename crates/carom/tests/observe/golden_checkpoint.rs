//! The committed checkpoint is opened, has the layout of today, and goes on to the end that it had when it was written.
//!
//! `make checkpoint REASON="..."` writes it anew, with that end. It refuses to, while `FORMAT` of
//! `simulate/observed/checkpoint.rs` stays though the layout is another, and while `PHYSICS_VERSION` stays though the end
//! is.

use carom::observe::{NAMES, Observables, Request, Results};
use carom::run::{Digest, Kind, PHYSICS_VERSION};
use carom::scenario::Scenario;
use carom::simulate::{Checkpoint, ObservedRun, Pause, Plan, Sampling, Snapshots, Window};
use serde::{Deserialize, Serialize};
use sha2::{Digest as _, Sha256};
use std::collections::BTreeMap;
use std::path::PathBuf;

const ANEW: &str = "where that is meant, make checkpoint REASON=\"...\" writes it anew";
/// Bytes of a checkpoint before its body.
const HEADER: usize = 80;

/// Where the run ends that goes on from the committed checkpoint.
#[derive(Debug, PartialEq, Serialize, Deserialize)]
struct End {
    digest: Digest,
    /// Snapshots and events that were handed out in all.
    handed_out: (u64, u64),
    /// SHA-256 of what each observable found, as text.
    observables: BTreeMap<String, String>,
}

#[derive(Serialize, Deserialize)]
struct Golden {
    format: u32,
    physics_version: u32,
    reason: String,
    end: End,
}

fn file(kind: &str) -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../../reference").join(format!("checkpoint.{kind}"))
}

/// Discs of two sizes between walls, of which everything is kept and everything is observed that can be.
fn begun() -> ObservedRun {
    let scenario = r#"
        collisions = 600
        record = "all"
        [gas]
        n = 24
        packing_fraction = 0.3
        periodic = ["x"]
        start = "square"
        seed = 8
        sizes = { species = [{ fraction = 0.5, diameter = 1.0 }, { fraction = 0.5, diameter = 0.8 }] }
    "#;
    let scenario = Scenario::from_toml(scenario).unwrap();
    let few = |name: &&str| match *name {
        "speeds" => Request::new(name).with("bins", 8),
        "h_function" | "kinetic_energy" => Request::new(name).with("points", 8),
        "temperature_profile" => Request::new(name).with("bins", 4),
        "radial_distribution" => Request::new(name).with("range", 2.0).with("bin_width", 0.2),
        "diffusion" => Request::new(name).with("longest", 8),
        name => Request::new(name),
    };
    let observables = Observables::new(&NAMES.iter().map(few).collect::<Vec<_>>()).unwrap();
    let plan = Plan {
        sampling: Sampling { equilibrate: 1.0, interval: Some(0.4) },
        snapshots: Snapshots::EveryCollisions(100),
        window: Some(Window { from: 1.5, to: 1e3 }),
    };
    ObservedRun::new(&scenario, Some(Kind::BallPocket), observables, plan).unwrap()
}

/// The same on its way, at a snapshot after 100 collisions.
fn checkpoint() -> Vec<u8> {
    let mut run = begun();
    while run.progress().collisions < 100 {
        run.advance().unwrap();
    }
    run.checkpoint("a note").unwrap()
}

fn end(mut run: ObservedRun) -> End {
    while run.advance().unwrap() != Pause::Ended {}
    let handed_out = run.handed_out();
    let (run, observables) = run.finish().unwrap();
    let sum = |results: Results| {
        let sum = Sha256::digest(format!("{results:?}"));
        (results.name.to_owned(), sum.iter().map(|byte| format!("{byte:02x}")).collect())
    };
    End {
        digest: run.digest().unwrap(),
        handed_out,
        observables: observables.results().into_iter().map(sum).collect(),
    }
}

/// The body of a checkpoint, without how many predictions were made: who goes on makes some anew.
fn body(bytes: &[u8]) -> Vec<u8> {
    const KEY: &[u8] = b"\"predictions\":";
    let mut body = bytes[HEADER..].to_vec();
    let at = body.windows(KEY.len()).position(|window| window == KEY).unwrap() + KEY.len();
    body[at..].iter_mut().take_while(|byte| byte.is_ascii_digit()).for_each(|byte| *byte = b'0');
    body
}

/// The run of a checkpoint, if that has the layout of today.
fn opened(bytes: &[u8]) -> Result<ObservedRun, String> {
    let checkpoint = Checkpoint::from_bytes(bytes).map_err(|error| format!("{error}; {ANEW}"))?;
    assert_eq!(checkpoint.note(), "a note");
    let run = ObservedRun::resume(checkpoint, &[]).map_err(|error| error.to_string())?;
    // Postcard reads past what a layout has more at its end, and a field may be read as another of its kind.
    let again = run.checkpoint("a note").map_err(|error| error.to_string())?;
    if body(&again) == body(bytes) {
        Ok(run)
    } else {
        Err(format!("its layout is not that of FORMAT any more: raise FORMAT; {ANEW}"))
    }
}

#[test]
fn the_committed_checkpoint_goes_on_to_its_end() {
    let (bytes, golden) = (std::fs::read(file("carom")), std::fs::read_to_string(file("json")));
    let committed = bytes.ok().zip(golden.ok()).map(|(bytes, golden)| {
        let golden: Golden = serde_json::from_str(&golden).unwrap();
        (bytes, golden)
    });
    if let Ok(reason) = std::env::var("CAROM_MINT_CHECKPOINT") {
        return mint(reason, committed);
    }
    let (bytes, golden) = committed.expect("the checkpoint is committed");
    let run = opened(&bytes).unwrap_or_else(|problem| panic!("reference/checkpoint.carom: {problem}"));
    assert_eq!(end(run), golden.end, "another end; {ANEW}");
    assert_eq!(end(begun()), golden.end, "another end without a checkpoint on the way; {ANEW}");
}

fn mint(reason: String, committed: Option<(Vec<u8>, Golden)>) {
    assert!(!reason.trim().is_empty(), "say why: make checkpoint REASON=\"...\"");
    let bytes = checkpoint();
    let format = u32::from_le_bytes(bytes[8..12].try_into().unwrap());
    if let Some((old, golden)) = committed
        && (golden.format, golden.physics_version) == (format, PHYSICS_VERSION)
    {
        let run = opened(&old).unwrap_or_else(|problem| panic!("first of all: {problem}"));
        assert_eq!(end(run).digest, golden.end.digest, "raise PHYSICS_VERSION first");
    }
    let run = opened(&bytes).unwrap();
    let golden = Golden { format, physics_version: PHYSICS_VERSION, reason, end: end(run) };
    std::fs::write(file("json"), serde_json::to_string_pretty(&golden).unwrap() + "\n").unwrap();
    std::fs::write(file("carom"), bytes).unwrap();
}
